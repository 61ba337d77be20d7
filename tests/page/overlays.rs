//! What is laid over the drawing: it appears, and stands where the engine says.

use crate::browser::Page;

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
