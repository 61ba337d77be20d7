//! Every lesson of ours walked through by *Next* alone: right answers are accepted, all others refused.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::browser::Page;
use crate::host::home;

/// Right answers by lesson and step; by the name of the button where a step shows several mechanisms.
fn lessons() -> BTreeMap<String, Vec<(String, Value)>> {
    serde_json::from_str(include_str!("../data/page/lesson_answers.json")).unwrap()
}

/// What of a step is wider than the column has room for: tables, lists, formulas.
const CUT: &str = "return [...document.querySelectorAll('.lesson-body *')]
    .filter((one) => one.checkVisibility() && !one.matches('input, .unseen') && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== 'visible')
    .map(({ id, className, tagName }) => id || className || tagName);";

/// Types or chooses an answer, and has it checked.
async fn verdict_on(page: &Page, answer: &Value) -> String {
    match answer {
        Value::String(choice) => {
            page.click(&format!("lesson-{choice}")).await;
            page.click("lesson-check").await;
        }
        number => page.write("lesson-answer", &number.to_string()).await,
    }
    page.attribute("lesson-said", "data-verdict").await.unwrap()
}

/// The choices of the open question that are not right, or three numbers, among them the answer of the step before.
async fn wrong(page: &Page, right: &Value, before: Option<f64>) -> Vec<Value> {
    let Some(number) = right.as_f64() else {
        let script = "return [...document.querySelectorAll('[name=lesson-choice]')].map(({ value }) => value)";
        let mut choices: Vec<Value> = serde_json::from_value(page.ask(script).await).unwrap();
        choices.retain(|choice| choice != right);
        return choices;
    };
    let before = before.filter(|before| (before - number).abs() > 1.0);
    [
        number - 3.0,
        number + 3.0,
        before.unwrap_or(2.0 * number + 5.0),
    ]
    .map(Value::from)
    .into()
}

async fn walk(id: &str) {
    let url = format!("{}#jansen&v.playing=false", home());
    let page = Page::open_at(&url, "en-US").await;
    page.click("gallery").await;
    let card = format!("gallery-lesson-{id}");
    page.until("the gallery", async || {
        page.count(&format!("#{card}")).await == 1
    })
    .await;
    page.click(&card).await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    // The lesson stays open over the mechanism that was there before.
    page.click("undo").await;
    page.settle().await;

    let lessons = lessons();
    let steps = &lessons[id];
    let mut before = None;
    for (number, (step, answers)) in steps.iter().enumerate() {
        let place = format!("Step {} of {}", number + 1, steps.len());
        let progress = page.text("lesson-progress").await;
        assert!(progress.contains(&place), "{id} {step}: {progress}");
        let mut right = answers;
        if let Value::Object(all) = answers {
            // *Next* has brought the first of several mechanisms.
            let first = page
                .ask("return document.querySelector('[id^=lesson-show-]').id")
                .await;
            right = &all[first.as_str().unwrap().trim_start_matches("lesson-show-")];
            if right.is_null() {
                // A train that cannot be built yet has no answer; the other one of the step has.
                let (name, other) = all.iter().find(|(_, right)| !right.is_null()).unwrap();
                page.click(&format!("lesson-show-{name}")).await;
                page.settle().await;
                right = other;
            }
        }
        for answer in wrong(&page, right, before).await {
            let verdict = verdict_on(&page, &answer).await;
            assert_eq!(verdict, "not_yet", "{id} {step}: {answer} for {right}");
        }
        let verdict = verdict_on(&page, right).await;
        assert_eq!(verdict, "right", "{id} {step}: {right}");
        before = right.as_f64();
        page.click("lesson-on").await;
        page.settle().await;
        assert_eq!(page.text("problem").await, "", "{id} after {step}");
        assert_eq!(page.ask(CUT).await, json!([]), "{id} after {step}");
    }
    assert_eq!(page.text("lesson-title").await, "What you have learnt");
    let progress = page.text("lesson-progress").await;
    assert!(
        progress.contains(&format!("{} right answers", steps.len())),
        "{progress}"
    );
    assert!(
        page.element("lesson-further")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    assert_eq!(page.count("#lesson-on:disabled").await, 1);
    page.close().await;
}

#[tokio::test]
async fn assemblies() {
    walk("assemblies").await;
}

#[tokio::test]
async fn class4_dwell() {
    walk("class4-dwell").await;
}

#[tokio::test]
async fn differential() {
    walk("differential").await;
}

#[tokio::test]
async fn mixer() {
    walk("mixer").await;
}

#[tokio::test]
async fn mobility() {
    walk("mobility").await;
}

#[tokio::test]
async fn synthesis() {
    walk("synthesis").await;
}

/// Each lesson has a test here.
#[test]
fn all_are_walked() {
    let ids: Vec<String> = lessons().keys().cloned().collect();
    let here = [
        "assemblies",
        "class4-dwell",
        "differential",
        "mixer",
        "mobility",
        "synthesis",
    ];
    assert_eq!(ids, here);
}

/// The end of a lesson leads to the next one, that of the last to the gallery.
#[tokio::test]
async fn what_comes_next() {
    let lesson = "v.lesson=%7B%22id%22%3A%22mixer%22%2C%22step%22%3A11%7D";
    let page = Page::open_at(
        &format!("{}#mixer-a&v.playing=false&{lesson}", home()),
        "en-US",
    )
    .await;
    page.until("the end", async || page.count("#lesson-further").await == 1)
        .await;
    assert!(
        page.text("lesson-progress")
            .await
            .contains("End of the lesson")
    );
    page.click("lesson-further").await;
    page.until("the next lesson", async || {
        page.text("lesson-progress").await.contains("Step 1 of 16")
    })
    .await;
    assert_eq!(page.text("out-linkage-w").await, "1");
    page.close().await;
}
