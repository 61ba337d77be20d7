//! The lesson on assemblies: what its steps show and ask, answered by what the engine says.

use assur::mechanism::{Mechanism, Method};
use assur_file::{LinkageDocument, from_catalogue};
use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::browser::{Page, setting};
use crate::device::LANGUAGES;
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
    let presets: Value =
        serde_json::from_str(include_str!("../../www/lessons/assemblies/presets.json")).unwrap();
    match presets.get(name) {
        Some(own) => serde_json::from_value(own["document"].clone()).unwrap(),
        None => from_catalogue(name).unwrap().unwrap(),
    }
}

fn mechanism(name: &str) -> Mechanism {
    document(name).mechanism().unwrap()
}

/// How many assemblies there are at the drawn input.
fn real(name: &str) -> String {
    let mechanism = mechanism(name);
    let found = mechanism.assemblies_at(mechanism.home(), Method::Usual);
    assert!(found.whole);
    found.poses.len().to_string()
}

/// What each step asks, answered wrongly and as the engine has it.
fn answers() -> [(&'static str, String); STEPS] {
    let triad = mechanism("class3-platform");
    let triad = triad.assemblies_at(triad.home(), Method::Usual).complex;
    let [6] = triad[..] else {
        panic!("{triad:?}");
    };
    let short = document("short").motion().unwrap();
    let [from, to] = short.cycle().arcs()[0];
    [
        ("1", real("crank-rocker")),
        ("two", "six".to_owned()),
        ("14", real("ten")),
        ("4", format!("{:.3}", (to - from).to_degrees())),
        ("whole", "joined".to_owned()),
        ("some", "none".to_owned()),
    ]
}

/// The buttons of a step that show something.
async fn shows(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('#lesson button[id^=lesson-show]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

async fn answer(page: &Page, answer: &str) -> (Option<String>, String) {
    let choices = page
        .count("#lesson input[type=radio][name=lesson-choice]")
        .await;
    if choices > 0 {
        page.click(&format!("lesson-{answer}")).await;
    } else {
        page.write("lesson-answer", answer).await;
    }
    page.press("lesson-check", Key::Enter).await;
    let verdict = page.attribute("lesson-said", "data-verdict").await;
    (verdict, page.text("lesson-said").await)
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
        for (given, verdict) in [(*wrong, "not_yet"), (right.as_str(), "right")] {
            let (found, text) = answer(&page, given).await;
            assert_eq!(
                found.as_deref(),
                Some(verdict),
                "step {step}: {given} {text}"
            );
            assert!(text.len() > 10 && !text.contains(['{', '}']), "{text}");
        }
        if step < STEPS {
            page.click("lesson-on").await;
        }
    }
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains("6 right answers"), "{progress}");
    page.close().await;
}

/// What a step shows besides has an answer of its own.
#[tokio::test]
async fn whatever_a_step_shows_has_its_answer() {
    let page = Page::open().await;
    lesson(&page).await;
    for (step, show, right) in [
        (2, "dyad", "two".to_owned()),
        (3, "zero", real("class4-dwell")),
        (5, "crank", "whole".to_owned()),
        (5, "by_rocker", "pairs".to_owned()),
        (6, "near", "some".to_owned()),
    ] {
        while !page
            .text("lesson-progress")
            .await
            .contains(&format!("Step {step} "))
        {
            page.click("lesson-on").await;
        }
        page.click(&format!("lesson-show-{show}")).await;
        page.settle().await;
        let (verdict, text) = answer(&page, &right).await;
        assert_eq!(
            verdict.as_deref(),
            Some("right"),
            "step {step} {show}: {text}"
        );
    }
    page.close().await;
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
    for lang in LANGUAGES {
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
