//! The lesson on synthesis from positions: what its steps show, ask and lend, answered by what the
//! engine says.

use assur::mechanism::Quantity;
use assur::motion::OutputProfile;
use assur::synthesis::four_bar::Options;
use assur::synthesis::four_bar::theorems::{Angles, functional};
use assur_file::{LinkageDocument, SynthesisDocument};
use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::device::LANGUAGES;
use crate::layout::defects;
use crate::synthesis::{document, preset, synthesis, there};

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

/// By how much the contour of the printed lengths is open in a position at its printed coupler angle.
fn open_at_the_printed_angle(document: &SynthesisDocument, position: usize) -> f64 {
    let given = &document.positions[position];
    let angles = Angles {
        frame: document.phi0_deg.to_radians(),
        coupler: given.coupler_deg.unwrap().to_radians(),
        output: given.output_deg.to_radians(),
        input: given.input_deg.to_radians(),
    };
    let z = document
        .trial
        .unwrap()
        .map(|length| length / document.frame);
    functional(&angles, z).sqrt() * document.frame
}

/// What each step asks, answered wrongly and as the engine has it.
fn answers() -> [(&'static str, String); 8] {
    let number = |value: f64| format!("{value:.4}");
    let two = document("family").positions;
    let Options::Family(family) = synthesis("family").options else {
        panic!("no family");
    };
    let frame = document("family").frame;
    let changes = family.changes().into_iter();
    let outputs = changes.map(|change| change.proportions.output * frame);
    let open = open_at_the_printed_angle(&document("printed"), 1);
    let many = synthesis("many").options.solutions().len();
    let sent: LinkageDocument = serde_json::from_value(preset("sent")).unwrap();
    let motion = sent.motion().unwrap();
    let rocker = Quantity::named(motion.mechanism(), "rocker.angle").unwrap();
    let swing = OutputProfile::new(&motion, rocker);
    [
        ("12", number(two[1].output_deg - two[0].output_deg)),
        ("12.82", "11.757".to_owned()),
        ("39.35", number(outputs.fold(f64::INFINITY, f64::min))),
        ("0.051", number(open)),
        ("coupler", "input".to_owned()),
        ("0", many.to_string()),
        ("some", "none".to_owned()),
        ("40", number(swing.stroke().unwrap().to_degrees())),
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
            page.settle().await;
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

/// What a step asks for stands in it; the misprints of the paper open from it.
#[tokio::test]
async fn steps_have_their_tools_and_misprints() {
    let page = Page::open().await;
    lesson(&page).await;
    assert_eq!(page.count("#lesson #positions").await, 1);
    assert!(
        !page
            .element("lesson-errata")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    assert_eq!(page.count("#lesson #positions").await, 0);
    assert_eq!(
        page.count("#lesson #synthesis-conditions[open] table")
            .await,
        2
    );
    page.click("lesson-errata").await;
    page.until("the misprints", async || {
        page.count("#errata-dialog[open] tbody tr").await == 9
    })
    .await;
    page.click("errata-close").await;
    page.click("lesson-on").await;
    assert_eq!(page.count("#lesson #synthesis-map").await, 1);
    page.close().await;
}

/// Tables and maps of the steps have room on the narrowest screen, whatever the language.
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
    page.click("lesson-on").await;
    page.click("lesson-show").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#lesson #synthesis-conditions table").await, 2);
    page.click("lesson-errata").await;
    page.until("the misprints", async || {
        page.count("#errata-dialog[open] tbody tr").await == 9
    })
    .await;
    page.click("errata-close").await;
    page.close().await;
}
