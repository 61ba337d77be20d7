//! The page built with one folder more: a lesson about what does not move is there by its
//! folder alone, `tests/data/page`, and works.

use crate::browser::Page;
use crate::host::more;

async fn visible(page: &Page, id: &str) -> bool {
    page.count(&format!("#{id}")).await > 0 && page.element(id).await.is_displayed().await.unwrap()
}

/// Answers the open step.
async fn answer(page: &Page, text: &str) -> Option<String> {
    page.write("lesson-answer", text).await;
    page.attribute("lesson-said", "data-verdict").await
}

#[tokio::test]
async fn a_lesson_without_motion() {
    let page = Page::open_at(more(), "en-US").await;
    page.stop_at("62").await;
    page.until("the address", async || {
        page.address().await.contains("v.playing=false")
    })
    .await;
    let lesson = "%7B%22id%22%3A%22still%22%2C%22step%22%3A1%7D";
    let address = page.address().await;
    page.anew(&format!("{address}&v.lesson={lesson}")).await;
    page.until("the lesson", async || {
        page.text("lesson-title").await == "Count"
    })
    .await;

    // Its step shows what does not move: a drawing, its structure, and nothing of a motion.
    page.click("lesson-show").await;
    page.until("the scheme", async || visible(&page, "out-scheme-w").await)
        .await;
    assert_eq!(page.text("out-scheme-w").await, "1");
    assert_eq!(page.text("out-scheme-q").await, "3");
    for id in [
        "play", "charts", "readouts", "overlays", "presets", "driver",
    ] {
        assert!(!visible(&page, id).await, "{id}");
    }
    let drawn = page.picture("mechanism").await;
    assert!(drawn.places([0x00, 0x72, 0xB2]).count() > 100);
    assert_eq!(answer(&page, "1").await.as_deref(), Some("right"));
    page.keys(" ").await;
    let told = async || page.address().await.contains("kind=scheme");
    page.until("the address of the scheme", told).await;
    // It has no assemblies: the keys for them are no step.
    page.focus("tab-lesson").await;
    page.keys("2").await;
    page.click("undo").await;
    page.until("the mixer", async || visible(&page, "play").await)
        .await;
    page.click("redo").await;
    page.until("the address of the scheme again", told).await;

    // It is kept, sent and opened again.
    page.reload().await;
    page.until("the scheme again", async || {
        visible(&page, "out-scheme-w").await
    })
    .await;
    assert_eq!(
        page.text("mechanism-name").await,
        "Chebyshev's straight line"
    );

    // The next step shows what moves, and undo brings back what does not.
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    page.until("the linkage", async || visible(&page, "out-formula").await)
        .await;
    for id in ["play", "charts", "readouts"] {
        assert!(visible(&page, id).await, "{id}");
    }
    assert!(!visible(&page, "out-scheme-w").await);
    assert_eq!(answer(&page, "5").await.as_deref(), Some("right"));
    page.click("undo").await;
    page.until("the scheme after undo", async || {
        visible(&page, "out-scheme-w").await
    })
    .await;
    assert!(!visible(&page, "play").await);
    page.close().await;
}
