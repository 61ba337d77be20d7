//! By keys, by touch, on a phone.

use super::*;

#[tokio::test]
async fn by_keys_alone() {
    let page = Page::open().await;
    let focused = async || {
        let id = page.ask("return document.activeElement.id").await;
        id.as_str().unwrap().to_owned()
    };
    page.keys("l").await;
    loaded(&page).await;
    assert_eq!(focused().await, "lesson-title");
    let told = page.attribute("tab-lesson", "aria-keyshortcuts").await;
    assert_eq!(told.as_deref(), Some("L"));
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-show");
    page.keys(Key::Enter + "").await;
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-paper-name");
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-answer");
    // The field has its letters.
    page.keys("l").await;
    assert_eq!(page.written("lesson-answer").await, "l");
    assert!(visible(&page, "lesson").await);
    page.keys(Key::Backspace + "4").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(verdict(&page).await, "right");
    assert_eq!(
        page.attribute("lesson-said", "role").await.as_deref(),
        Some("status")
    );

    // Over the check to the button that goes on; at the end its twin has the focus.
    page.keys(Key::Tab + "").await;
    page.keys(Key::Tab + "").await;
    assert_eq!(focused().await, "lesson-on");
    for _ in 1..=STEPS {
        page.keys(" ").await;
    }
    assert!(
        page.text("lesson-progress")
            .await
            .contains("End of the lesson")
    );
    assert_eq!(focused().await, "lesson-back");
    for _ in 6..=STEPS {
        page.keys(" ").await;
    }
    assert!(page.text("lesson-progress").await.contains("Step 6"));
    // Opened anew it begins with its title. Tab: the two cases, the choices by arrows, the check.
    page.keys("l").await;
    page.keys("l").await;
    assert_eq!(focused().await, "lesson-title");
    for _ in 0..3 {
        page.keys(Key::Tab + "").await;
    }
    page.keys(" ").await;
    page.keys(Key::Down + "").await;
    assert_eq!(focused().await, "lesson-on_frame");
    page.keys(Key::Enter + "").await;
    assert_eq!(verdict(&page).await, "right");
    page.keys("l").await;
    assert!(!visible(&page, "lesson").await);
    assert_eq!(focused().await, "tab-lesson");
    page.close().await;
}

#[tokio::test]
async fn by_touch() {
    let page = Page::open().await;
    let tap = async |id: &str| {
        page.ask(&format!(
            "document.getElementById('{id}').scrollIntoView({{ block: 'center' }})"
        ))
        .await;
        page.fingers(id, &[vec![(12.0, 12.0)]]).await;
    };
    tap("tab-lesson").await;
    loaded(&page).await;
    tap("lesson-on").await;
    assert!(page.text("lesson-progress").await.contains("Step 2"));
    tap("lesson-show").await;
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("false")
    );
    tap("lesson-answer").await;
    page.keys("-2").await;
    tap("lesson-check").await;
    assert_eq!(verdict(&page).await, "right");
    tap("tab-settings").await;
    assert!(visible(&page, "rail").await);
    page.close().await;
}

/// On a phone the lesson lies far below: it opens where the eye is, and so is what is
/// said of an answer, not under the drawing that stays.
#[tokio::test]
async fn on_a_phone_it_is_seen() {
    let page = Page::open().await;
    page.screen((390, 844), 2.0).await;
    let seen = async |id: &str| {
        let script = format!(
            "const {{ left, right, top, bottom }} = document.getElementById('{id}').getBoundingClientRect();
             const at = (x, y) => document.elementFromPoint(x, y)?.closest('#{id}');
             return Boolean(at((left + right) / 2, top + 4) && at((left + right) / 2, bottom - 4));"
        );
        page.settle().await;
        page.ask(&script).await == json!(true)
    };
    page.keys("l").await;
    loaded(&page).await;
    assert!(seen("lesson-title").await);
    page.write("lesson-answer", "40").await;
    page.click("lesson-check").await;
    assert!(seen("lesson-said").await);
    assert_eq!(verdict(&page).await, "not_yet");
    // Another step begins where the eye is.
    page.click("lesson-on").await;
    assert!(seen("lesson-title").await);
    page.close().await;
}
