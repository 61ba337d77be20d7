//! Synthesis from positions on the page: what is typed, dragged and chosen there, and what is said
//! where no linkage takes up the positions.

mod refused;

use std::collections::BTreeSet;

use assur::{Assembly, FourBar};
use assur_file::{Synthesis, SynthesisDocument};
use assur_tests::{assert_near, files};
use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::access::{AXE, check};
use crate::browser::Page;
use crate::device::languages;
use crate::host::home;
use crate::layout::defects;

/// A document of the lesson's own.
pub(crate) fn preset(name: &str) -> Value {
    files::preset("synthesis", name).unwrap()
}

pub(crate) fn document(name: &str) -> SynthesisDocument {
    serde_json::from_value(preset(name)).unwrap()
}

pub(crate) fn synthesis(name: &str) -> Synthesis {
    document(name).synthesis().unwrap()
}

/// The link to a document, at rest at an input of 50°.
fn link(document: &Value) -> String {
    let fields = document.as_object().unwrap().iter();
    let fields = fields.map(|(name, value)| {
        let value = value.to_string().replace('%', "%25").replace('"', "%22");
        let value = value.replace('{', "%7B").replace('}', "%7D");
        let value = value.replace('[', "%5B").replace(']', "%5D");
        format!("&d.{name}={value}")
    });
    let fields: String = fields.collect();
    let view = "&v.phi_deg=50&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";
    format!("{}#2&kind=synthesis{fields}{view}", home())
}

/// The page with a document, and all that is of its kind.
pub(crate) async fn open(document: &Value) -> Page {
    let page = Page::open_at(&link(document), "en-US").await;
    there(&page).await;
    assert_eq!(page.text("notice-text").await, "");
    page
}

pub(crate) async fn there(page: &Page) {
    // In a lesson it is there without being seen.
    let said = "return document.getElementById('synthesis-said')?.textContent ?? ''";
    page.until("what is of a synthesis", async || {
        page.ask(said).await != json!("")
    })
    .await;
    page.settle().await;
}

/// l₁, l₂, l₃ of the solutions in the list.
pub(crate) async fn listed(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('[data-field=solutions] label')].map((one) => one.textContent.trim())";
    let all = page.ask(script).await;
    let all = all.as_array().unwrap().iter();
    all.map(|one| one.as_str().unwrap().to_owned()).collect()
}

/// The number that stands behind a sign in a text.
fn after(text: &str, sign: &str) -> f64 {
    let (_, rest) = text.split_once(sign).unwrap();
    let number = rest.trim_start().split([';', ' ', '°']).next().unwrap();
    number.replace('−', "-").parse().unwrap()
}

/// A typed direction is what is solved for; the frame scales all lengths; a position more, and one less.
#[tokio::test]
async fn positions_are_typed_added_and_removed() {
    let page = open(&preset("family")).await;
    let before = page.picture("mechanism").await;
    page.write("field-output-2", "260").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.written("field-output-2").await, "260°");
    assert!(page.picture("mechanism").await.difference(&before) > 500);
    let mut wanted = document("family");
    wanted.positions[1].output_deg = 260.0;
    let solved = wanted.synthesis().unwrap();
    let [_, coupler, output, _] = solved.shown.proportions.lengths(wanted.frame);
    let shown = listed(&page).await;
    assert_near(after(&shown[0], "l₁ ="), coupler, 5e-3, "l₁");
    assert_near(after(&shown[0], "l₂ ="), output, 5e-3, "l₂");

    page.write("field-output-2", "253").await;
    page.click("positions-add").await;
    assert_eq!(page.count("#positions .card:not([hidden])").await, 3);
    // It is one that the linkage takes up, so there is a solution with it.
    assert_eq!(page.text("problem").await, "");
    assert_eq!(listed(&page).await.len(), 1);
    // One that the family's member takes up itself: the same linkage, alone.
    wanted = document("family");
    let member = wanted.synthesis().unwrap();
    let motion = wanted
        .synthesis()
        .unwrap()
        .drawn()
        .unwrap()
        .motion()
        .unwrap();
    let rocker = motion.mechanism().link("rocker").unwrap();
    let pose = motion.pose::<1>(80_f64.to_radians()).unwrap();
    let angle = motion.mechanism().angle(&pose, rocker).value().to_degrees();
    page.write("field-input-3", "80").await;
    page.write("field-output-3", &angle.rem_euclid(360.0).to_string())
        .await;
    assert_eq!(page.text("problem").await, "");
    let shown = listed(&page).await;
    let [_, coupler, ..] = member.shown.proportions.lengths(wanted.frame);
    assert_eq!(shown.len(), 1, "{shown:?}");
    assert_near(after(&shown[0], "l₁ ="), coupler, 5e-3, "l₁");
    page.click("positions-remove-3").await;
    assert_eq!(page.count("#positions .card:not([hidden])").await, 2);
    assert_eq!(page.count("#lesson-title").await, 0);
    page.close().await;
}

/// What the fields of the positions hold.
pub(crate) async fn directions(page: &Page) -> Vec<(String, String)> {
    let script = "return [...document.querySelectorAll('#positions .card:not([hidden]) input')]
        .filter((one) => /output|input/.test(one.id)).map((one) => [one.id, one.value])";
    let all = page.ask(script).await;
    serde_json::from_value(all).unwrap()
}

/// Each ring takes one direction with it, and nothing else; each direction has one.
#[tokio::test]
async fn rings_are_dragged() {
    let mut wanted = preset("family");
    wanted["positions"][1] = json!({ "output_deg": 290, "input_deg": 100 });
    let page = open(&wanted).await;
    assert_eq!(page.text("problem").await, "");
    let before = directions(&page).await;
    let mut moved = BTreeSet::new();
    for (x, y) in page.handles().await {
        page.drag_along(
            "mechanism",
            &[(x, y), (x + 9.0, y + 4.0), (x + 17.0, y + 9.0)],
        )
        .await;
        let after = directions(&page).await;
        let changed: Vec<&String> = before
            .iter()
            .zip(&after)
            .filter(|(one, other)| one != other)
            .map(|(one, _)| &one.0)
            .collect();
        assert!(changed.len() <= 1, "{x} {y}: {changed:?}");
        if let Some(field) = changed.first() {
            moved.insert((*field).clone());
            page.click("undo").await;
            assert_eq!(directions(&page).await, before);
        }
    }
    let all: BTreeSet<String> = before.into_iter().map(|(field, _)| field).collect();
    assert_eq!(moved, all);
    page.close().await;
}

/// A member of the family is chosen on the map and by the slider; out of range it is said, and
/// the drawing stays.
#[tokio::test]
async fn members_are_chosen() {
    let page = open(&preset("family")).await;
    let member = async || after(&listed(&page).await[0], "l₂ =");
    let first = member().await;
    // The curve is near the diagonal; a press takes the nearest member.
    let area = page.element("synthesis-map").await;
    area.scroll_into_view().await.unwrap();
    page.settle().await;
    let area = area.rect().await.unwrap();
    let places: Vec<(f64, f64)> = [0.3, 0.4, 0.45]
        .map(|part| (area.width * part, area.height * (1.0 - part)))
        .to_vec();
    page.drag_along("synthesis-map", &places).await;
    let chosen = member().await;
    assert!((chosen - first).abs() > 0.5, "{first} {chosen}");
    page.press("slider-output", Key::Right).await;
    let next = member().await;
    assert!(next > chosen && next < chosen + 0.1, "{chosen} {next}");
    page.write("field-output", "5").await;
    let shown = listed(&page).await;
    assert_near(after(&shown[0], "l₁ ="), 9.312, 1e-3, "l₁");
    assert_near(after(&shown[0], "l₃ ="), 5.113, 1e-3, "l₃");
    let label = page.attribute("synthesis-map", "aria-label").await.unwrap();
    assert!(label.contains("l₂ = 5"), "{label}");
    // It is what the address and undo have.
    page.click("undo").await;
    assert_eq!(member().await, next);
    page.click("redo").await;
    let shown = listed(&page).await;
    page.write("field-output", "-3").await;
    let said = page.text("problem").await;
    assert!(said.contains("l₂") && said.len() > 20, "{said}");
    assert_eq!(listed(&page).await, shown);
    page.close().await;
}

/// The number of the solution that is drawn, and of another one.
fn two_of_many() -> [usize; 2] {
    let drawn = synthesis("many").number.unwrap() + 1;
    [drawn, if drawn == 1 { 2 } else { 1 }]
}

/// Of several solutions another is chosen: it is drawn, and undone.
#[tokio::test]
async fn another_solution_is_chosen() {
    let page = open(&preset("many")).await;
    let solved = synthesis("many");
    let all = listed(&page).await;
    assert_eq!(all.len(), solved.options.solutions().len());
    let drawn = async || {
        page.ask("return document.querySelector('[name=solution]:checked').id")
            .await
    };
    let first = drawn().await;
    let [number, other] = two_of_many();
    assert_eq!(first, json!(format!("solution-{number}")));
    let picture = page.picture("mechanism").await;
    page.click(&format!("solution-{other}")).await;
    assert_eq!(drawn().await, json!(format!("solution-{other}")));
    assert!(page.picture("mechanism").await.difference(&picture) > 500);
    page.click("undo").await;
    assert_eq!(drawn().await, first);
    page.close().await;
}

/// A solution goes to the simulator at the same input angle; undo brings the synthesis back.
#[tokio::test]
async fn a_solution_is_sent_to_the_simulator() {
    let page = open(&preset("three")).await;
    let rocker = synthesis("three").linkage().unwrap().motion().unwrap();
    let mechanism = rocker.mechanism();
    let pose = rocker.pose::<1>(50_f64.to_radians()).unwrap();
    let angle = mechanism.angle(&pose, mechanism.link("rocker").unwrap());
    let kind = async || {
        page.ask("return document.documentElement.dataset.kind")
            .await
    };
    page.click("synthesis-send").await;
    page.until("the linkage", async || kind().await == json!("linkage"))
        .await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert_near(page.value("out-input").await, 50.0, 1e-9, "the input");
    let shown = page.value("out-rocker.angle").await - angle.value().to_degrees();
    assert_near((shown + 180.0).rem_euclid(360.0), 180.0, 1e-9, "the rocker");
    page.click("undo").await;
    there(&page).await;
    assert_eq!(kind().await, json!("synthesis"));
    assert_eq!(page.value("out-input").await, 50.0);
    page.close().await;
}

/// The file has a line for each solution, its numbers with all their digits.
#[tokio::test]
async fn solutions_are_saved_as_csv() {
    let page = open(&preset("many")).await;
    page.click("synthesis-csv").await;
    let text = String::from_utf8(page.saved("solutions.csv").await).unwrap();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let solved = synthesis("many");
    let solutions = solved.options.solutions();
    assert_eq!(lines.len(), 1 + solutions.len(), "{text}");
    assert_eq!(lines[0][..3], ["l1", "l2", "l3"]);
    for (line, number) in lines[1..].iter().zip(solved.options.order()) {
        let solution = solutions[number];
        assert_eq!(line.len(), lines[0].len(), "{line:?}");
        let [crank, coupler, output, _] = solution.proportions.lengths(solved.task.frame().length);
        for (cell, expected) in line.iter().zip([coupler, output, crank]) {
            assert_near(cell.parse().unwrap(), expected, 1e-9 * expected, cell);
        }
    }
    page.close().await;
}
