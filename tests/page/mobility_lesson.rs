//! The lesson on mobility by sections on the page: its tools, its paper, its room. Its answers are in
//! `www/lesson/folder.test.js`.

use serde_json::json;

use crate::browser::{Page, setting};
use crate::device::languages;
use crate::host::home;
use crate::layout::defects;
use crate::mobility::{scheme, there};

async fn lesson(page: &Page) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-mobility").await == 1
    })
    .await;
    page.click("gallery-lesson-mobility").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    there(page).await;
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The numbers that stand beside the paper's formulas of a step.
const NUMBERS: &str = "return [...document.querySelectorAll('#lesson-paper [data-item] .paper-numbers p')].map((one) => one.textContent);";

/// What a step asks for stands in it; what tells its answer is withheld, also beside the formulas of the paper.
#[tokio::test]
async fn steps_have_their_tools_and_numbers() {
    let page = Page::open().await;
    lesson(&page).await;
    page.click("lesson-show-spherical").await;
    there(&page).await;
    assert_eq!(page.count("#lesson #pair-form-1").await, 1);
    assert!(page.text("out-scheme-w").await.starts_with('?'));
    assert_eq!(page.ask(NUMBERS).await, json!([]));
    page.click("lesson-reveal").await;
    let mobility = scheme("mobility-1a").counts().mobility().to_string();
    assert_eq!(page.text("out-scheme-w").await, mobility);
    page.settle().await;
    assert_eq!(
        page.ask(NUMBERS).await,
        json!(["Wот = 7; as printed 13, difference 6", "n = 3"])
    );
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    there(&page).await;
    assert_eq!(page.count("#lesson #method-said").await, 1);
    page.close().await;
}

/// The end of the lesson leads to its notes for teachers in the reader's language.
#[tokio::test]
async fn notes_for_teachers_open_from_the_end() {
    let lesson = "v.lesson=%7B%22id%22%3A%22mobility%22%2C%22step%22%3A13%7D";
    for (browser, lang) in [("en-US", "en"), ("kk", "kk")] {
        let page = Page::open_at(&format!("{}#mobility-1a&{lesson}", home()), browser).await;
        page.until("the end", async || page.count("#lesson-notes").await == 1)
            .await;
        let href = page.attribute("lesson-notes", "href").await;
        assert_eq!(href, Some(format!("docs/mobility.{lang}.html")));
        page.driver
            .goto(format!("{}{}", home(), href.unwrap()))
            .await
            .unwrap();
        let found = "return [document.documentElement.lang, document.querySelectorAll('h2').length, document.querySelectorAll('table tbody tr').length]";
        assert_eq!(page.ask(found).await, json!([lang, 6, 6]));
        page.close().await;
    }
}

/// Tables and formulas of the steps have room on the narrowest screen, whatever the language.
#[tokio::test]
async fn steps_have_room() {
    let page = Page::open().await;
    lesson(&page).await;
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in languages(2) {
        page.speak(lang).await;
        for step in 1..=12 {
            page.click(&shows(&page).await[0]).await;
            there(&page).await;
            found.push((format!("{lang} {step}"), defects(&page, 0).await));
            if step < 12 {
                page.click("lesson-on").await;
            }
        }
        for _ in 1..12 {
            page.click("lesson-back").await;
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// The one-file page has it, too: words, presets, the items of the paper, the views of the kind.
#[tokio::test]
async fn it_opens_from_a_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    lesson(&page).await;
    page.click("lesson-show-spherical").await;
    there(&page).await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#lesson #pair-form-1").await, 1);
    assert_eq!(page.count("#lesson-paper [data-item]").await, 10);
    page.close().await;
}
