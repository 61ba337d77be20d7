//! What is laid over the drawing: it appears, and stands where the engine says.

use serde_json::json;

use crate::browser::Page;
use crate::gallery::open;

/// Colours of the analogues, as the page's style sheet has them.
const VELOCITY: [u8; 3] = [0xC2, 0x38, 0x7F];
const ACCELERATION: [u8; 3] = [0x4B, 0x4F, 0xC4];

#[tokio::test]
async fn overlays_come_and_go() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let plain = page.picture("mechanism").await;
    let chart = page.picture("charts").await;
    for overlay in ["centres", "vectors", "loop_vectors", "transmission"] {
        page.click(overlay).await;
        let shown = page.picture("mechanism").await;
        let drawn = shown.difference(&plain);
        // The view makes room for vectors: then nothing stays where it was.
        let most = if overlay == "vectors" {
            usize::MAX
        } else {
            20_000
        };
        assert!((200..most).contains(&drawn), "{overlay}: {drawn}");
        for colour in [VELOCITY, ACCELERATION] {
            let seen = shown.places(colour).count();
            assert_eq!(seen > 100, overlay == "vectors", "{overlay}: {seen}");
        }
        page.click(overlay).await;
        assert!(page.picture("mechanism").await.difference(&plain) < 20);
    }
    assert!(page.picture("charts").await.difference(&chart) < 20);
    page.close().await;
}

/// A key names the lines of instant centres and circles; its button, or a key, brings them into view.
#[tokio::test]
async fn overlays_have_a_key_and_a_view_of_them_all() {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    page.stop_at("140").await;
    let hidden = async || {
        page.ask("return document.getElementById('legend').hidden")
            .await
    };
    assert_eq!(hidden().await, json!(true));
    page.click("instant_centres").await;
    page.click("curvature").await;
    page.ask("document.querySelector('#legend summary').click()")
        .await;
    let said = page.text("legend-entries").await;
    for name in ["instant centre", "line of three", "inflection circle"] {
        assert!(said.contains(name), "{name}: {said}");
    }
    page.click("zoom-all").await;
    assert_eq!(
        page.attribute("mechanism", "data-zoomed").await.unwrap(),
        "true"
    );
    page.click("zoom-fit").await;
    assert_eq!(
        page.attribute("mechanism", "data-zoomed").await.unwrap(),
        "false"
    );
    page.keys("f").await;
    assert_eq!(
        page.attribute("mechanism", "data-zoomed").await.unwrap(),
        "true"
    );
    // The rows of curvature do not push the last plot off the screen.
    let below = "const [plots, charts] = ['.plots', '.charts'].map((of) => document.querySelector(of).getBoundingClientRect().bottom);
        return charts <= plots";
    page.screen((1280, 800), 1.0).await;
    page.settle().await;
    assert_eq!(page.ask(below).await, json!(true));
    page.click("instant_centres").await;
    page.click("curvature").await;
    assert_eq!(hidden().await, json!(true));
    page.close().await;
}

/// There is room for the vectors: at no angle does one reach the canvas's edge.
#[tokio::test]
async fn vectors_stay_on_the_canvas() {
    let page = Page::open().await;
    page.click("vectors").await;
    for degrees in (0..360).step_by(30) {
        page.stop_at(&degrees.to_string()).await;
        page.hover("mechanism", (9.0, 9.0)).await;
        let picture = page.picture("mechanism").await;
        for colour in [VELOCITY, ACCELERATION] {
            let seen = picture.places(colour).count();
            assert!(seen > 100, "{degrees}°: {seen}");
            let off = |(x, y): &(usize, usize)| {
                *x < 5 || *y < 5 || *x + 5 > picture.width || *y + 5 > picture.height
            };
            assert_eq!(picture.places(colour).find(off), None, "{degrees}°");
        }
    }
    page.close().await;
}

/// They follow the crank, also in a mechanism with dead points.
#[tokio::test]
async fn overlays_follow_the_crank() {
    let page = Page::open().await;
    for overlay in ["centres", "vectors", "loop_vectors", "transmission"] {
        page.click(overlay).await;
    }
    page.stop_at("40").await;
    let before = page.picture("mechanism").await;
    page.write("angle", "220").await;
    assert!(page.picture("mechanism").await.difference(&before) > 4000);
    assert_eq!(page.text("problem").await, "");
    // Past a dead point: nothing is said on the console, the drawing stays.
    page.write("field-l1", "0.6").await;
    page.write("field-l3", "0.3").await;
    page.write("angle", "70").await;
    let faded = page.attribute("mechanism", "data-faded").await;
    assert_eq!(faded.as_deref(), Some("false"));
    page.close().await;
}
