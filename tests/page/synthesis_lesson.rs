//! The lesson on synthesis from positions on the page: its tools, its room. Its answers are in
//! `www/lesson/folder.test.js`.

use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::device::languages;
use crate::layout::defects;
use crate::synthesis::there;

/// How many steps the lesson has.
const STEPS: usize = 13;

async fn go_on(page: &Page, steps: usize) {
    for _ in 0..steps {
        page.click("lesson-on").await;
    }
}

async fn lesson(page: &Page) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-lesson-synthesis").await == 1
    })
    .await;
    page.click("gallery-lesson-synthesis").await;
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

/// What a step asks for stands in it.
#[tokio::test]
async fn steps_have_their_tools() {
    let page = Page::open().await;
    lesson(&page).await;
    assert_eq!(page.count("#lesson #positions").await, 1);
    go_on(&page, 3).await;
    page.click("lesson-show").await;
    assert_eq!(page.count("#lesson #positions").await, 0);
    assert_eq!(
        page.count("#lesson #synthesis-conditions[open] table")
            .await,
        2
    );
    assert_eq!(page.count("#lesson #synthesis-conditions .cone").await, 2);
    go_on(&page, 4).await;
    assert_eq!(page.count("#lesson #synthesis-map").await, 1);
    assert_eq!(page.count("#lesson #positions").await, 1);
    page.close().await;
}

/// The main line of a step has a formula as it holds; the fold has both forms, and says which of them holds.
#[tokio::test]
async fn main_lines_have_what_holds() {
    let page = Page::open().await;
    lesson(&page).await;
    go_on(&page, 2).await;
    let formulas = async |place: &str, item: &str| {
        let script = format!(
            "return [...document.querySelectorAll('{place} [data-item=\"{item}\"] math')].map((one) => one.textContent.replaceAll(/\\s/g, ''))"
        );
        page.ask(&script).await
    };
    let main = ".lesson-body .printed:not(#lesson-paper *)";
    let [right, wrong] = ["z2=P2+Q2z1", "z2=P2−Q2z1"];
    assert_eq!(formulas(main, "000.(16)").await, json!([right]));
    assert_eq!(
        formulas("#lesson-paper", "000.(16)").await,
        json!([wrong, right])
    );
    let said = "return [...document.querySelectorAll('#lesson-paper [data-item] .paper-verdict')].map((one) => one.textContent)";
    let said = page.ask(said).await.to_string();
    assert!(said.contains("It should read:"), "{said}");
    // Theorem 5: what holds instead.
    go_on(&page, 4).await;
    let whole = formulas(main, "000.T5").await;
    assert_eq!(whole.as_array().map(Vec::len), Some(4), "{whole}");
    assert!(whole[2].as_str().unwrap().contains('¬'), "{whole}");
    let said = page
        .ask("return document.querySelector('#lesson-paper [data-item=\"000.T5\"] .paper-verdict').textContent")
        .await;
    assert_eq!(said, json!("It does not hold. What holds:"));
    page.close().await;
}

/// The paper's own way: coupler angles are typed until (14) and (25) hold, then lengths are tried.
#[tokio::test]
async fn coupler_angles_and_lengths_are_tried() {
    let page = Page::open().await;
    lesson(&page).await;
    go_on(&page, 4).await;
    page.click("lesson-show").await;
    there(&page).await;
    let holds = async |number: &str| {
        let script = format!(
            "return [...document.querySelectorAll('#synthesis-conditions tr')].filter((row) => row.querySelector('th')?.textContent.startsWith('({number})'))
                .map((row) => row.querySelector('[data-holds]').dataset.holds)"
        );
        page.ask(&script).await
    };
    assert_eq!(holds("14").await, json!(["false", "false"]));
    assert_eq!(page.written("field-coupler-1").await, "70°");
    page.write("field-coupler-1", "10").await;
    page.write("field-coupler-2", "9").await;
    assert_eq!(holds("14").await, json!(["true", "true"]));
    assert_eq!(holds("25").await, json!(["true", "true"]));
    page.click("trial").await;
    for (n, length) in ["10", "5", "4"].into_iter().enumerate() {
        page.write(&format!("field-trial-{}", n + 1), length).await;
    }
    // It stands in the settings, beside the solutions.
    let said = "return document.getElementById('synthesis-printed').textContent";
    let said = page.ask(said).await.to_string();
    assert!(
        said.contains("9.827") && said.contains("0.0003336"),
        "{said}"
    );
    assert_eq!(page.text("problem").await, "");
    page.write("field-trial-2", "-1").await;
    assert!(page.text("problem").await.contains("l₂"));
    page.write("field-trial-2", "5").await;
    page.press("slider-trial-1", Key::Right).await;
    assert_ne!(page.written("field-trial-1").await, "10");
    page.click("couplers").await;
    assert_eq!(page.count("#positions .coupler_deg:not([hidden])").await, 0);
    page.close().await;
}

/// Tables and maps of the steps have room on the narrowest screen, whatever the language.
#[tokio::test]
async fn steps_have_room() {
    let page = Page::open().await;
    lesson(&page).await;
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in languages(1) {
        page.speak(lang).await;
        for step in 1..=STEPS {
            page.click(&shows(&page).await[0]).await;
            there(&page).await;
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

/// The one-file page has it, too: words, presets, the views of the kind.
#[tokio::test]
async fn it_opens_from_a_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    lesson(&page).await;
    go_on(&page, 3).await;
    page.click("lesson-show").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#lesson #synthesis-conditions table").await, 2);
    page.close().await;
}
