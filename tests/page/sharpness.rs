//! Sharpness of the canvases at every pixel ratio.

use serde_json::json;

use crate::browser::Page;

/// Every canvas has as many pixels as the screen under it, and thin lines along the
/// axes fill whole ones.
#[tokio::test]
async fn canvases_are_sharp_at_every_ratio() {
    let page = Page::open().await;
    page.stop_at("75").await;
    // The browser's tools give the page another ratio only together with another size.
    for (width, ratio) in [(1280, 1.0), (1284, 1.5), (1288, 2.0), (1292, 3.0)] {
        page.screen((width, 800), ratio).await;
        for projector in [false, true] {
            if projector {
                page.click("projector").await;
            }
            let fitted = format!(
                "return ['mechanism', 'charts', 'chart-cursor'].every((id) => {{
                    const {{ width, height, clientWidth, clientHeight }} = document.getElementById(id);
                    return width === Math.round(clientWidth * {ratio}) && height === Math.round(clientHeight * {ratio});
                }})"
            );
            page.until("canvases of the screen's pixels", async || {
                page.ask(&fitted).await == json!(true)
            })
            .await;
            page.settle().await;
            for id in ["mechanism", "charts"] {
                let blurs = blurred(&page, id).await;
                assert!(
                    blurs.iter().all(|blurred| *blurred == 0),
                    "{id} at {ratio}, projector {projector}: {blurs:?}"
                );
            }
            if projector {
                page.click("projector").await;
            }
        }
    }
    page.close().await;
}

/// Lines along the axes, across and down: how many pixels across each have neither
/// the line's full strength nor the ground's. What crosses them is passed over by
/// taking what is most often along them.
async fn blurred(page: &Page, id: &str) -> Vec<usize> {
    let rows = page
        .ask(&format!(
            "const canvas = document.getElementById('{id}');
            const {{ width, height }} = canvas;
            const copy = new OffscreenCanvas(width, height).getContext('2d');
            copy.fillStyle = '#fff';
            copy.fillRect(0, 0, width, height);
            copy.drawImage(canvas, 0, 0);
            const {{ data }} = copy.getImageData(0, 0, width, height);
            const usual = (count, at) => {{
                const times = new Array(256).fill(0);
                for (let i = 0; i < count; i++) times[data[4 * at(i) + 1]] += 1;
                return times.indexOf(Math.max(...times));
            }};
            return [
                Array.from({{ length: width }}, (_, x) => usual(height, (y) => y * width + x)),
                Array.from({{ length: height }}, (_, y) => usual(width, (x) => y * width + x)),
            ]"
        ))
        .await;
    let rows: [Vec<i64>; 2] = serde_json::from_value(rows).unwrap();
    let mut found = Vec::new();
    for row in rows {
        let ground = *row.iter().max().unwrap();
        let lines = row.split(|pixel| ground - pixel <= 2);
        let before = found.len();
        found.extend(lines.filter_map(|line| {
            let full = line.iter().min()?;
            Some(line.iter().filter(|pixel| **pixel - full > 2).count())
        }));
        assert!(found.len() - before >= 4, "{id}: too few lines, {found:?}");
    }
    found
}
