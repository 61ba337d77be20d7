//! The lesson on assemblies on the page: its pictures and its room. Its answers are in `www/lesson/folder.test.js`.

use assur::mechanism::{Mechanism, Method};
use assur_file::{LinkageDocument, from_catalogue};
use assur_tests::files::preset;
use serde_json::json;

use crate::browser::{Page, setting};
use crate::device::languages;
use crate::layout::defects;

const STEPS: usize = 6;

async fn lesson(page: &Page) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-assemblies").await == 1
    })
    .await;
    page.click("gallery-lesson-assemblies").await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
}

/// What a preset of the lesson has, or of the catalogue.
fn document(name: &str) -> LinkageDocument {
    match preset("assemblies", name) {
        Some(own) => serde_json::from_value(own).unwrap(),
        None => from_catalogue(name).unwrap().unwrap(),
    }
}

fn mechanism(name: &str) -> Mechanism {
    document(name).mechanism().unwrap()
}

/// How many assemblies there are at the drawn input.
fn real(name: &str) -> String {
    let mechanism = mechanism(name);
    let found = mechanism.assemblies_at(mechanism.drawn_input(), Method::Usual);
    assert!(found.whole);
    found.poses.len().to_string()
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The section with a picture of each assembly stands in the step, and goes home with the lesson.
#[tokio::test]
async fn pictures_of_all_stand_in_the_step() {
    let page = Page::open().await;
    lesson(&page).await;
    page.click("lesson-on").await;
    page.click("lesson-on").await;
    for (show, name) in [("arc", "ten"), ("zero", "class4-dwell")] {
        page.click(&format!("lesson-show-{show}")).await;
        page.settle().await;
        let pictures = "#lesson #assembly-pictures button:not([hidden])";
        page.until("the pictures", async || {
            page.count(pictures).await.to_string() == real(name)
        })
        .await;
    }
    page.click("tab-settings").await;
    page.until("the section at home", async || {
        page.count("#rail #assemblies-shown").await == 1
    })
    .await;
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

/// The one-file page has it, too, with its own mechanisms.
#[tokio::test]
async fn it_opens_from_a_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    lesson(&page).await;
    for _ in 1..4 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert!(page.text("out-linkage-dead").await.contains("82.39"));
    page.close().await;
}
