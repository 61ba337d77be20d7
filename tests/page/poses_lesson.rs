//! The lesson on poses of a body on the page: its tools, what it withholds, and its room. Its answers are in
//! `www/lesson/folder.test.js`.

use serde_json::json;

use crate::browser::Page;
use crate::device::languages;
use crate::layout::defects;

const STEPS: usize = 8;

async fn lesson(page: &Page) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-poses-paths").await == 1
    })
    .await;
    page.click("gallery-lesson-poses-paths").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    page.settle().await;
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The verdicts of the list, and the entries of the status line on passage and order.
async fn verdicts(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson .pairs small, #out-poses-passage, #out-poses-order')]
        .map((one) => one.textContent.replace(' hidden until you answer', ''))";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The question about the defect hides the verdicts, the filter and what marks the linkages without a defect.
#[tokio::test]
async fn verdicts_are_withheld_until_the_answer() {
    let page = Page::open().await;
    lesson(&page).await;
    for _ in 1..5 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show-second").await;
    page.settle().await;
    let hidden = verdicts(&page).await;
    assert_eq!(hidden, ["?"; 8], "six linkages and two entries");
    assert_eq!(page.count("#pairs-filter:not([hidden])").await, 0);
    assert_eq!(page.count(".pairs [data-sound]").await, 0);
    page.click("lesson-circuit").await;
    page.click("lesson-check").await;
    page.until("the verdicts", async || {
        verdicts(&page).await.iter().all(|one| one != "?")
    })
    .await;
    let told = verdicts(&page).await.join(" ");
    assert!(told.contains("circuit defect"), "{told}");
    assert_eq!(page.count("#pairs-filter:not([hidden])").await, 1);
    assert_eq!(page.count(".pairs [data-sound]").await, 6);
    page.close().await;
}

/// A linkage that the reader chooses is judged.
#[tokio::test]
async fn any_linkage_that_will_do_is_right() {
    let page = Page::open().await;
    lesson(&page).await;
    for _ in 1..6 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show-task").await;
    page.settle().await;
    let given = async |angle: &str| {
        page.write("lesson-answer", angle).await;
        page.attribute("lesson-said", "data-verdict").await
    };
    assert_eq!(given("45.2").await.as_deref(), Some("not_yet"));
    page.click("pair-135").await;
    page.settle().await;
    assert_eq!(given("45.2").await.as_deref(), Some("right"));
    page.close().await;
}

/// The steps have room on the narrowest screen, whatever the language.
#[tokio::test]
async fn steps_have_room() {
    let page = Page::open().await;
    lesson(&page).await;
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in languages(3) {
        page.speak(lang).await;
        for step in 1..=STEPS {
            page.click(&shows(&page).await[0]).await;
            page.settle().await;
            found.push((format!("{lang} {step}"), defects(&page, 0).await));
            if step < STEPS {
                page.click("lesson-on").await;
            }
        }
        for _ in 1..STEPS {
            page.click("lesson-back").await;
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}
