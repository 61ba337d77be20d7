//! Labels of the drawing: off each other, steady in motion, with the numbers of their frame.

use std::collections::BTreeSet;

use crate::browser::Page;
use crate::host::home;

/// A label as it was written: its text, its middle and its width.
type Written = (String, f64, f64, f64);

/// Of so many pixels is the height of a label.
const HEIGHT: f64 = 15.0;

/// Everything over the first mixer, and from now on its labels are kept, drawing by drawing.
async fn watched() -> Page {
    let all = "v.vectors=true&v.loop_vectors=true&v.transmission=true&v.playing=false";
    let page = Page::open_at(&format!("{}#mixer-a&{all}", home()), "en-US").await;
    page.settle().await;
    page.ask(
        "const kind = CanvasRenderingContext2D.prototype;
        const { fillText } = kind;
        window.shown = [];
        kind.fillText = function (text, x, y) {
            if (this.canvas.id === 'mechanism' && this.font.startsWith('600 ')) {
                if (text === 'A') window.shown.push([]);
                window.shown.at(-1).push([text, x, y, this.measureText(text).width]);
            }
            fillText.call(this, text, x, y);
        };",
    )
    .await;
    page
}

async fn shown(page: &Page) -> Vec<Vec<Written>> {
    let shown = page.ask("return window.shown.splice(0)").await;
    serde_json::from_value(shown).unwrap()
}

/// With the fonts of the browser none is over another, with everything shown; `www/stage/figure.test.js` turns it degree by degree.
#[tokio::test]
async fn labels_keep_off_each_other() {
    let page = watched().await;
    for step in 0..9 {
        // At once: typed, it would be drawn at 4° on its way to 40° or not, as the machine has time.
        let turned = format!(
            "const field = document.getElementById('angle');
            field.value = {};
            for (const kind of ['input', 'change']) field.dispatchEvent(new Event(kind, {{ bubbles: true }}));",
            40 * step
        );
        page.ask(&turned).await;
        page.settle().await;
        let labels = shown(&page).await.pop().unwrap();
        assert!(labels.len() > 12, "{labels:?}");
        for (i, one) in labels.iter().enumerate() {
            for other in &labels[..i] {
                let beside = (one.1 - other.1).abs() >= (one.3 + other.3) / 2.0 - 0.5;
                let under = (one.2 - other.2).abs() >= HEIGHT - 0.5;
                assert!(beside || under, "{step}: {one:?} {other:?}");
            }
        }
    }
    page.close().await;
}

/// While it plays φ₁ is written in whole degrees, anew with every frame; it stands still with a decimal.
#[tokio::test]
async fn numbers_in_motion_are_those_of_their_frame() {
    let page = watched().await;
    page.click("play").await;
    page.until("some frames", async || {
        page.ask("return window.shown.length > 40").await == true
    })
    .await;
    let angles = |drawings: &[Vec<Written>]| -> Vec<String> {
        let labels = drawings.iter().flatten();
        let angles = labels.filter_map(|label| label.0.strip_prefix("φ₁ = "));
        angles.map(str::to_owned).collect()
    };
    let playing = angles(&shown(&page).await[2..]);
    assert!(
        playing.iter().all(|angle| !angle.contains('.')),
        "{playing:?}"
    );
    // Far more often than five times a second, as the read-outs are.
    let different: BTreeSet<&String> = playing.iter().collect();
    assert!(3 * different.len() > playing.len(), "{playing:?}");
    page.stop_at("75").await;
    page.settle().await;
    let still = angles(&shown(&page).await);
    assert_eq!(still.last().map(String::as_str), Some("75.0°"));
    page.close().await;
}
