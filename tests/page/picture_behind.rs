//! A picture behind the drawing: laid by two of its places, and what is none.

use std::fs;
use std::path::PathBuf;

use thirtyfour::Key;

use crate::access;
use crate::browser::Page;
use crate::draw::Sheet;

/// Colours that nothing else on the page has.
pub(crate) const FROM: [u8; 3] = [0xFF, 0x00, 0xFF];
pub(crate) const TO: [u8; 3] = [0x00, 0xFF, 0xFF];

/// A scan as a file: two coloured spots on white, and a script that must not run.
pub(crate) const SCAN: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400" onload="parent.hacked = true">
<script>parent.hacked = true</script><rect width="600" height="400" fill="#fff"/>
<rect x="190" y="240" width="20" height="20" fill="#f0f"/><rect x="370" y="120" width="20" height="20" fill="#0ff"/></svg>"##;

/// A file with a content.
pub(crate) fn file(name: &str, content: impl AsRef<[u8]>) -> PathBuf {
    let path = std::env::temp_dir().join(format!("{}-{name}", std::process::id()));
    fs::write(&path, content).unwrap();
    path
}

/// Once there is one behind the drawing.
pub(crate) async fn taken(page: &Page) {
    page.until("the picture", async || {
        let remove = page.element("draw-picture-remove").await;
        remove.is_displayed().await.unwrap()
    })
    .await;
}

#[tokio::test]
async fn a_picture_is_laid_by_two_of_its_places() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.tool("picture").await;
    assert_eq!(page.count("#draw-picture-options:not([hidden])").await, 1);
    let scan = file("scan.svg", SCAN);
    page.choose_file("draw-picture-file", &scan).await;
    taken(&page).await;
    page.press("draw-picture-opacity", Key::End).await;
    // Its two spots are pressed where they are seen.
    let before = page.picture("mechanism").await;
    for spot in [FROM, TO] {
        let seen = before.cloud(spot);
        assert!(seen.count > 100, "{seen:?}");
        page.drag_along("mechanism", &[(seen.x, seen.y)]).await;
    }
    for (part, value) in [
        ("length", "2.5"),
        ("angle", "-30"),
        ("x", "-1"),
        ("y", "1,5"),
    ] {
        page.write(&format!("draw-picture-{part}"), value).await;
    }
    let (sine, cosine) = (-30.0_f64).to_radians().sin_cos();
    let after = page.picture("mechanism").await;
    for (spot, place) in [
        (FROM, [-1.0, 1.5]),
        (TO, [-1.0 + 2.5 * cosine, 1.5 + 2.5 * sine]),
    ] {
        let seen = after.cloud(spot);
        let (x, y) = sheet.at(place);
        let off = (seen.x - x).hypot(seen.y - y);
        assert!(off < 3.0, "{off} pixels at {place:?}");
    }
    assert_eq!(
        page.ask("return window.hacked ?? null").await,
        serde_json::Value::Null
    );
    page.ask(access::AXE).await;
    access::check(&page, "a picture behind the drawing").await;

    // No length, and what is no picture: a sentence each, and the picture stays.
    page.write("draw-picture-length", "-2").await;
    assert_eq!(
        page.text("problem").await,
        "The distance must be greater than zero."
    );
    let none = file("none.png", "<img src=x onerror='parent.hacked = true'>");
    page.choose_file("draw-picture-file", &none).await;
    page.until("the sentence", async || {
        page.text("problem").await == "The browser cannot show this file as a picture."
    })
    .await;
    assert_eq!(
        page.ask("return window.hacked ?? null").await,
        serde_json::Value::Null
    );
    let still = page.picture("mechanism").await;
    assert!(still.cloud(FROM).count > 20);

    // Links are drawn over it; it is in no link.
    sheet.tool("bars").await;
    sheet.line(&[[-1.0, 1.5], [1.0, 0.0]]).await;
    sheet.end().await;
    assert_eq!(page.text("problem").await, "");
    assert!(page.count("#draw-points input").await == 4);
    sheet.tool("picture").await;
    page.click("draw-picture-remove").await;
    assert_eq!(page.picture("mechanism").await.places(FROM).count(), 0);
    page.close().await;
}

/// A photograph laid to a scale in millimetres stays in sight, and so does what is traced over it.
#[tokio::test]
async fn a_picture_in_millimetres_stays_in_sight() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.tool("picture").await;
    page.choose_file("draw-picture-file", &file("mm.svg", SCAN))
        .await;
    taken(&page).await;
    page.press("draw-picture-opacity", Key::End).await;
    let spots = async || {
        let seen = page.picture("mechanism").await;
        [FROM, TO].map(|spot| seen.cloud(spot))
    };
    for seen in spots().await {
        page.drag_along("mechanism", &[(seen.x, seen.y)]).await;
    }
    for (part, value) in [("length", "400"), ("angle", "0"), ("x", "0"), ("y", "0")] {
        page.write(&format!("draw-picture-{part}"), value).await;
    }
    for seen in spots().await {
        assert!(seen.count > 20, "{seen:?}");
    }
    // A link from spot to spot is 400 long, within a pixel.
    sheet.tool("bars").await;
    for seen in spots().await {
        page.drag_along("mechanism", &[(seen.x, seen.y)]).await;
    }
    sheet.end().await;
    let document = crate::draw_more::drawn(&sheet).await;
    let [a, b] = [0, 1].map(|k| assur::Point::from(document.points[k].at));
    assert!(((b - a).norm() - 400.0).abs() < 8.0, "{a} {b}");
    // The hinges, as large as ever, would cover the spots.
    while !crate::draw_more::drawn(&sheet).await.points.is_empty() {
        page.click("undo").await;
    }
    // Far out there is room for more.
    for _ in 0..30 {
        page.click("zoom-out").await;
    }
    page.click("zoom-fit").await;
    for seen in spots().await {
        assert!(seen.count > 20, "{seen:?}");
    }
    page.close().await;
}
