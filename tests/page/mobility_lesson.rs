//! The lesson on mobility by sections: what its steps show, ask and lend, answered by what the engine
//! says.

use assur::mobility::{Scheme, Space};
use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::device::LANGUAGES;
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

/// All pairs; a hinge of k links is k − 1 of them.
fn pairs(scheme: &Scheme) -> usize {
    scheme.pairs().iter().map(|pair| pair.count()).sum()
}

fn redundant(scheme: &Scheme) -> usize {
    let verdict = scheme.judged(Space::Whole).unwrap();
    verdict.redundancies.iter().map(|one| one.count).sum()
}

/// What each step asks, answered wrongly and as the engine has it.
fn answers() -> [(&'static str, String); 8] {
    let mobility = |name: &str| scheme(name).counts().mobility().to_string();
    let moving = scheme("moving");
    let parallelogram = scheme("parallelogram");
    let rank = parallelogram.judged(Space::Plane).unwrap().mobility;
    assert!(parallelogram.counts().mobility() < rank as isize);
    let mended = scheme("mobility-2a").replacements(1).unwrap();
    [
        ("6", mobility("mobility-1a")),
        ("3", mobility("mobility-2a")),
        ("5", redundant(&scheme("mobility-2a")).to_string()),
        ("1", (pairs(&moving) - moving.counts().links).to_string()),
        ("3", mobility("mobility-3")),
        ("right", "low".to_owned()),
        ("2", mended.list[0].changes.len().to_string()),
        ("6", pairs(&scheme("press")).to_string()),
    ]
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// From the gallery through all steps: each shows without a problem, and its answer is that of the engine.
#[tokio::test]
async fn its_lesson_is_answered() {
    let page = Page::open().await;
    lesson(&page).await;
    for (index, (wrong, right)) in answers().iter().enumerate() {
        let step = index + 1;
        // A step may have several things to show: the question is about the first.
        for show in shows(&page).await.iter().rev() {
            page.click(show).await;
            there(&page).await;
            assert_eq!(page.text("problem").await, "", "step {step}: {show}");
        }
        let choices = page
            .count("#lesson input[type=radio][name=lesson-choice]")
            .await
            > 0;
        for (answer, verdict) in [(*wrong, "not_yet"), (right.as_str(), "right")] {
            if choices {
                page.click(&format!("lesson-{answer}")).await;
            } else {
                page.write("lesson-answer", answer).await;
            }
            page.press("lesson-check", Key::Enter).await;
            let said = page.attribute("lesson-said", "data-verdict").await;
            let text = page.text("lesson-said").await;
            assert_eq!(
                said.as_deref(),
                Some(verdict),
                "step {step}: {answer} {text}"
            );
            assert!(text.len() > 10 && !text.contains(['{', '}']), "{text}");
        }
        if step < 8 {
            page.click("lesson-on").await;
        }
    }
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains("8 right answers"), "{progress}");
    page.close().await;
}

/// What a step asks for stands in it; what tells its answer is withheld; the misprints of the paper open from it.
#[tokio::test]
async fn steps_have_their_tools_and_misprints() {
    let page = Page::open().await;
    lesson(&page).await;
    page.click("lesson-show-spherical").await;
    there(&page).await;
    assert_eq!(page.count("#lesson #pair-form-1").await, 1);
    assert!(page.text("out-scheme-w").await.starts_with('?'));
    page.click("lesson-reveal").await;
    let mobility = scheme("mobility-1a").counts().mobility().to_string();
    assert_eq!(page.text("out-scheme-w").await, mobility);
    page.click("lesson-errata").await;
    page.until("the misprints", async || {
        page.count("#errata-dialog[open] tbody tr").await == 6
    })
    .await;
    page.click("errata-close").await;
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    there(&page).await;
    assert_eq!(page.count("#lesson #method-said").await, 1);
    assert!(
        !page
            .element("lesson-errata")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    page.close().await;
}

/// Tables and formulas of the steps have room on the narrowest screen, whatever the language.
#[tokio::test]
async fn steps_have_room() {
    let page = Page::open().await;
    lesson(&page).await;
    page.screen((360, 640), 1.0).await;
    let mut found = Vec::new();
    for lang in LANGUAGES {
        page.speak(lang).await;
        for step in 1..=8 {
            page.click(&shows(&page).await[0]).await;
            there(&page).await;
            found.push((format!("{lang} {step}"), defects(&page, 0).await));
            if step < 8 {
                page.click("lesson-on").await;
            }
        }
        for _ in 1..8 {
            page.click("lesson-back").await;
        }
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// The one-file page has it, too: words, presets, misprints, the views of the kind.
#[tokio::test]
async fn it_opens_from_a_file() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    lesson(&page).await;
    page.click("lesson-show-spherical").await;
    there(&page).await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#lesson #pair-form-1").await, 1);
    page.click("lesson-errata").await;
    page.until("the misprints", async || {
        page.count("#errata-dialog[open] tbody tr").await == 6
    })
    .await;
    page.click("errata-close").await;
    page.close().await;
}
