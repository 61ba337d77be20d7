//! What the paper of a lesson prints: every item is seen in its step, in every language, with its numbers.

use std::collections::{BTreeMap, BTreeSet};

use assur::mixer::{Case, Mixer};
use assur_tests::files::source;
use serde_json::{Value, json};

use crate::browser::Page;
use crate::host::home;

/// The lessons that have a paper, with the preset that each opens on and the number of items.
const PAPERS: [(&str, &str, usize); 5] = [
    ("mixer", "mixer-a", 53),
    ("class4-dwell", "class4-dwell", 101),
    ("mobility", "mobility-1a", 48),
    ("synthesis", POSITIONS, 101),
    ("differential", "train-magnets", 57),
];

/// The positions of the paper on synthesis, as an address has them.
const POSITIONS: &str = "2&kind=synthesis&d.frame=10.4&d.positions=%5B%7B%22output_deg%22:240,%22input_deg%22:45%7D,%7B%22output_deg%22:253,%22input_deg%22:60%7D%5D";

/// The items that are seen, once what folds them is open.
const SEEN: &str = "const fold = document.querySelector('#lesson-paper');
    if (!fold.open && !fold.hidden) fold.querySelector('summary').click();
    return [...document.querySelectorAll('.lesson-body [data-item]')]
        .filter((one) => one.checkVisibility() && one.textContent.trim() !== '' && one.getBoundingClientRect().height > 5)
        .map((one) => one.dataset.item);";

/// The items whose formulas are wider than their column.
const CUT: &str = "return [...document.querySelectorAll('.lesson-body [data-item]')]
    .filter((one) => one.checkVisibility() && one.scrollWidth > one.clientWidth + 1).map((one) => one.dataset.item);";

/// The items of each step of a lesson.
fn items(lesson: &str) -> BTreeMap<String, BTreeSet<String>> {
    let items: Vec<Value> =
        serde_json::from_str(&source(&format!("www/lessons/{lesson}/paper.json"))).unwrap();
    let mut steps: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for one in items {
        let [step, item] = ["step", "item"].map(|key| one[key].as_str().unwrap().to_owned());
        steps.entry(step).or_default().insert(item);
    }
    steps
}

/// The ids of the steps of a lesson, and what closes it.
fn steps(lesson: &str) -> Vec<String> {
    let answers: BTreeMap<String, Vec<(String, Value)>> =
        serde_json::from_str(include_str!("../data/page/lesson_answers.json")).unwrap();
    let steps = answers[lesson].iter().map(|(id, _)| id.clone());
    steps.chain(["end".to_owned()]).collect()
}

async fn open(lesson: &str, preset: &str, lang: &'static str, step: usize) -> Page {
    let lesson = format!("v.lesson=%7B%22id%22%3A%22{lesson}%22%2C%22step%22%3A{step}%7D");
    let spoken = &lang[..2];
    let whole = format!("v.direction=1&v.speed=1&v.traces=true&v.lang={spoken}");
    let url = format!(
        "{}#{preset}&{whole}&v.playing=false&v.phi_deg=40&{lesson}",
        home()
    );
    let page = Page::open_at(&url, lang).await;
    page.until("the lesson", async || {
        page.count("#lesson-title").await == 1
    })
    .await;
    page.settle().await;
    page
}

async fn all_are_seen(lang: &'static str) {
    for (lesson, preset, all) in PAPERS {
        let items = items(lesson);
        let page = open(lesson, preset, lang, 1).await;
        let mut count = 0;
        for (number, step) in steps(lesson).iter().enumerate() {
            if number > 0 {
                page.click("lesson-on").await;
                page.settle().await;
            }
            let seen: BTreeSet<String> = serde_json::from_value(page.ask(SEEN).await).unwrap();
            let placed = items.get(step).cloned().unwrap_or_default();
            assert_eq!(seen, placed, "{lesson}, {step}");
            let cut = page.ask(CUT).await;
            assert_eq!(cut, Value::Array(Vec::new()), "{lesson}, {step}");
            count += seen.len();
        }
        assert_eq!(count, all, "{lesson}");
        page.close().await;
    }
}

#[tokio::test]
async fn all_items_are_seen_in_english() {
    all_are_seen("en-US").await;
}

#[tokio::test]
async fn all_items_are_seen_in_russian() {
    all_are_seen("ru").await;
}

#[tokio::test]
async fn all_items_are_seen_in_ukrainian() {
    all_are_seen("uk").await;
}

#[tokio::test]
async fn all_items_are_seen_in_kazakh() {
    all_are_seen("kk").await;
}

/// The numbers beside the formulas are those of the engine, and follow the crank; a misprint is seen with its difference.
#[tokio::test]
async fn numbers_follow_the_crank() {
    let page = open("mixer", "mixer-a", "en-US", 9).await;
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let numbers = "return [...document.querySelectorAll('#lesson-paper [data-item] .paper-numbers p')].map((one) => one.textContent);";
    page.ask("document.querySelector('#lesson-paper > summary').click()")
        .await;
    for degrees in [40.0_f64, 200.0] {
        page.write("angle", &degrees.to_string()).await;
        page.settle().await;
        let shown: Vec<String> = serde_json::from_value(page.ask(numbers).await).unwrap();
        let relations = mixer.relations(degrees.to_radians()).unwrap();
        let placed = &items("mixer")["centres"];
        let centres = relations.iter().filter(|one| placed.contains(one.item));
        let centres: Vec<_> = centres.collect();
        assert_eq!(shown.len(), centres.len());
        for (text, relation) in shown.iter().zip(centres) {
            let value = format!("{:.4}", relation.value).replace('-', "−");
            assert!(text.contains(&value), "{text}: {value}");
            let wrong = ["002.(16)y", "002.(24)y"].contains(&relation.item);
            assert_eq!(text.contains("as printed"), wrong, "{text}");
        }
    }
    page.close().await;
}

/// Before the answer only those numbers of a step are seen that do not give it away: those of the wheels, not their ratio.
#[tokio::test]
async fn numbers_before_the_answer() {
    let page = open("mixer", "mixer-a", "en-US", 2).await;
    page.ask("document.querySelector('#lesson-paper > summary').click()")
        .await;
    page.settle().await;
    let seen = "return [...document.querySelectorAll('#lesson-paper [data-item]')]
        .filter((one) => one.querySelector('.paper-numbers p')).map((one) => one.dataset.item);";
    assert_eq!(page.ask(seen).await, json!(["002.(25)", "002.(26)"]));
    page.click("lesson-reveal").await;
    page.settle().await;
    let all = json!(["002.(25)", "002.(26)", "002.u"]);
    assert_eq!(page.ask(seen).await, all);
    page.close().await;
}

/// On paper a step has its formulas with verdicts, the open one all items of its fold, and none a number that may be an answer.
#[tokio::test]
async fn formulas_are_printed() {
    let page = open("mixer", "mixer-a", "en-US", 9).await;
    let printed = "dispatchEvent(new Event('beforeprint'));
        return [...document.querySelectorAll('#worksheet > ol > li')].map((one) => [
            one.querySelectorAll('[data-item]').length, one.querySelectorAll('math').length, one.querySelectorAll('.paper-numbers p').length]);";
    let printed: Vec<[usize; 3]> = serde_json::from_value(page.ask(printed).await).unwrap();
    let all: Vec<Value> = serde_json::from_str(&source("www/lessons/mixer/paper.json")).unwrap();
    for ((step, id), [rows, formulas, numbers]) in steps("mixer").iter().enumerate().zip(printed) {
        let own = || all.iter().filter(|one| one["step"] == *id);
        let written = own().filter(|one| one["printed"].is_array()).count();
        assert_eq!(
            rows,
            if step == 8 { own().count() } else { written },
            "{id}"
        );
        assert!(formulas >= written, "{id}");
        assert_eq!(numbers, 0, "{id}");
    }
    page.close().await;
}
