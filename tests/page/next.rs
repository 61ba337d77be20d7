//! Every lesson of ours walked through by *Next* alone, by mouse, by keys, by touch on a phone: right answers are
//! accepted, all others refused.

use std::collections::BTreeMap;

use assur_tests::exhaustive;
use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;
use crate::keyboard::{tab_to, tab_until};
use crate::touch::tap;

/// Right answers by lesson and step; by the name of the button where a step shows several mechanisms.
fn lessons() -> BTreeMap<String, Vec<(String, Value)>> {
    serde_json::from_str(include_str!("../data/page/lesson_answers.json")).unwrap()
}

/// What of a step is wider than the column has room for: tables, lists, formulas.
const CUT: &str = "return [...document.querySelectorAll('.lesson-body *')]
    .filter((one) => one.checkVisibility() && !one.matches('input, .unseen') && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== 'visible')
    .map(({ id, className, tagName }) => id || className || tagName);";

/// The typed answer, and the element that has the focus.
const GIVEN: &str =
    "return [document.getElementById('lesson-answer')?.value, document.activeElement?.id];";

/// Whether *Check* and *Next* stand in one row, and on a wide screen in sight together with the question.
const ONE_ROW: &str = "const [asked, check, on] = ['lesson-question', 'lesson-check', 'lesson-on'].map((id) => document.getElementById(id).getBoundingClientRect());
    return check.top === on.top && (innerWidth < 960 || asked.top > 0 && on.bottom < innerHeight);";

/// Whether the page itself scrolls: aside, or on a screen where only its parts do.
const SCROLLS: &str = "const all = document.documentElement; return all.scrollWidth > innerWidth || innerWidth >= 960 && all.scrollHeight > innerHeight;";

/// What a lesson is walked with.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Hands {
    Mouse,
    Keys,
    Fingers,
}

/// How a lesson is walked: the hands, the width and height of the screen, the language.
type Way = (Hands, Option<(u32, u32)>, &'static str);

const PHONE: Option<(u32, u32)> = Some((360, 740));

const WAYS: [Way; 4] = [
    (Hands::Mouse, None, "en-US"),
    (Hands::Keys, None, "ru"),
    (Hands::Fingers, PHONE, "uk"),
    (Hands::Fingers, PHONE, "kk"),
];

impl Hands {
    async fn press(self, page: &Page, id: &str) {
        match self {
            Self::Mouse => page.click(id).await,
            Self::Keys => {
                tab_to(page, id).await;
                page.keys(Key::Enter + "").await;
            }
            Self::Fingers => tap(page, id).await,
        }
    }

    async fn write(self, page: &Page, id: &str, text: &str) {
        match self {
            Self::Mouse => page.write(id, text).await,
            Self::Keys => {
                tab_to(page, id).await;
                page.chord(&[Key::Control], 'a').await;
                page.keys(text.to_owned() + Key::Enter).await;
            }
            Self::Fingers => {
                tap(page, id).await;
                page.chord(&[Key::Control], 'a').await;
                page.keys(text.to_owned()).await;
                tap(page, "lesson-check").await;
            }
        }
    }

    async fn choose(self, page: &Page, choice: &str) {
        let id = format!("lesson-{choice}");
        if self != Self::Keys {
            return self.press(page, &id).await;
        }
        // Which one of the list Tab leads to differs between browsers; arrows go on from there.
        let stop = tab_until(page, "[name=lesson-choice]").await;
        if stop == id {
            page.keys(" ").await;
        }
        while page.focused().await.as_deref() != Some(&id) {
            page.keys(Key::Down + "").await;
        }
    }
}

/// Types or chooses an answer, and has it checked.
async fn verdict_on(page: &Page, hands: Hands, answer: &Value) -> String {
    match answer {
        Value::String(choice) => {
            hands.choose(page, choice).await;
            hands.press(page, "lesson-check").await;
        }
        number => {
            hands
                .write(page, "lesson-answer", &number.to_string())
                .await;
        }
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

/// Walks a lesson: in every way with `--all`, else in one, which differs from lesson to lesson.
async fn walk(id: &str, turn: usize) {
    for (_, way) in WAYS
        .iter()
        .enumerate()
        .filter(|(at, _)| exhaustive() || *at == turn)
    {
        walk_by(id, *way).await;
    }
}

async fn walk_by(id: &str, (hands, screen, lang): Way) {
    let url = format!("{}#jansen&v.playing=false", home());
    let page = Page::open_at(&url, lang).await;
    if let Some(size) = screen {
        page.touched().await;
        page.screen(size, 2.0).await;
    }
    hands.press(&page, "gallery").await;
    let card = format!("gallery-lesson-{id}");
    page.until("the gallery", async || {
        page.count(&format!("#{card}")).await == 1
    })
    .await;
    hands.press(&page, &card).await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    // The lesson stays open over the mechanism that was there before.
    page.chord(&[Key::Control], 'z').await;

    let lessons = lessons();
    let steps = &lessons[id];
    let mut before = None;
    for (number, (step, answers)) in steps.iter().enumerate() {
        let progress = page.text("lesson-progress").await;
        for count in [number + 1, steps.len()] {
            let count = count.to_string();
            assert!(progress.contains(&count), "{id} {step}: {progress}");
        }
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
                let button = format!("lesson-show-{name}");
                hands.press(&page, &button).await;
                page.settle().await;
                right = other;
            }
        }
        // A person answers when all is there that is asked about.
        page.until("what is asked about", async || {
            page.count("[aria-busy=true]:not([hidden])").await == 0
        })
        .await;
        for answer in wrong(&page, right, before).await {
            let verdict = verdict_on(&page, hands, &answer).await;
            let given = page.ask(GIVEN).await;
            assert_eq!(
                verdict, "not_yet",
                "{id} {step}, {hands:?} {lang}: {answer} for {right}, read {given}"
            );
        }
        let verdict = verdict_on(&page, hands, right).await;
        assert_eq!(verdict, "right", "{id} {step}, {hands:?} {lang}: {right}");
        before = right.as_f64();
        assert_eq!(page.ask(ONE_ROW).await, json!(true), "{id} {step}");
        hands.press(&page, "lesson-on").await;
        assert_eq!(page.text("problem").await, "", "{id} after {step}");
        assert_eq!(page.ask(CUT).await, json!([]), "{id} after {step}");
        assert_eq!(page.ask(SCROLLS).await, json!(false), "{id} after {step}");
    }
    let progress = page.text("lesson-progress").await;
    assert!(progress.contains(&steps.len().to_string()), "{progress}");
    if lang == "en-US" {
        assert_eq!(page.text("lesson-title").await, "What you have learnt");
        assert!(progress.contains("right answers"), "{progress}");
    }
    assert!(
        page.element("lesson-further")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    assert_eq!(page.count("#lesson-on:disabled").await, 1);
    hands.press(&page, "lesson-again").await;
    let progress = page.text("lesson-progress").await;
    if lang == "en-US" {
        assert_eq!(progress, format!("Step 1 of {}", steps.len()));
    }
    page.close().await;
}

#[tokio::test]
async fn assemblies() {
    walk("assemblies", 0).await;
}

#[tokio::test]
async fn class4_dwell() {
    walk("class4-dwell", 0).await;
}

#[tokio::test]
async fn differential() {
    walk("differential", 1).await;
}

#[tokio::test]
async fn mixer() {
    walk("mixer", 2).await;
}

#[tokio::test]
async fn mixer_forces() {
    walk("mixer-forces", 1).await;
}

#[tokio::test]
async fn mobility() {
    walk("mobility", 3).await;
}

#[tokio::test]
async fn poses_paths() {
    walk("poses-paths", 0).await;
}

#[tokio::test]
async fn run_up() {
    walk("run-up", 0).await;
}

#[tokio::test]
async fn synthesis() {
    walk("synthesis", 0).await;
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
        "mixer-forces",
        "mobility",
        "poses-paths",
        "run-up",
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
