//! Motion under load on the page: a run in time by the engine's numbers, and the flywheel of a press, put on its crank.

use assur::forces::{Diagram, LagrangeRun, Loading, Motor, Run};
use assur::motion::Motion;
use assur_file::LinkageDocument;
use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};
use serde_json::{Value, json};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

/// A slider-crank with a resistance on its working stroke.
fn press() -> Value {
    json!({
        "unit": "mm",
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "B", "at": [100, 0]}, {"name": "C", "at": [450, 0]},
            {"name": "E", "at": [900, 0]}
        ],
        "frame": ["A", "E"],
        "links": [
            {"name": "crank", "points": ["A", "B"], "mass_kg": 2},
            {"name": "rod", "points": ["B", "C"], "mass_kg": 1.5},
            {"name": "slider", "points": ["C"], "mass_kg": 4}
        ],
        "slides": [{"link": "slider", "point": "C", "on": "frame", "line": ["A", "E"]}],
        "drivers": [{"crank": "crank"}],
        "loads": [{"link": "slider", "point": "C", "direction_deg": 0,
            "table": [[0, 0], [20, 300], [150, 300], [180, 0]]}],
        "initial_rate": 12
    })
}

fn engine(document: &Value) -> (Motion, Loading, Option<Motor>) {
    let document: LinkageDocument = serde_json::from_value(document.clone()).unwrap();
    let motion = document.motion().unwrap();
    let loading = document.loading(motion.mechanism()).unwrap();
    let motor = document.motor(motion.mechanism()).unwrap();
    (motion, loading, document.motor.map(|_| motor))
}

async fn open(document: &Value) -> Page {
    let parts = document.as_object().unwrap().iter();
    let written = |(key, value): (&String, &Value)| {
        let value = value.to_string();
        format!("&d.{key}={}", utf8_percent_encode(&value, NON_ALPHANUMERIC))
    };
    let parts: String = parts.map(written).collect();
    let view = "&v.phi_deg=0&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.under_load=true&v.lang=en";
    let url = format!("{}#2&kind=linkage{parts}{view}", home());
    let page = Page::open_at(&url, "en-US").await;
    page.until("the panel", async || {
        page.count("#under-load-shown h2").await == 1 && page.count("#run-go").await == 1
    })
    .await;
    page.settle().await;
    page
}

/// A press without a motor stops under its resistance and goes back; the page has the input that the engine computes.
#[tokio::test]
async fn a_run_is_that_of_the_engine() {
    let page = open(&press()).await;
    page.write("run-until", "0.4").await;
    page.click("run-go").await;
    page.until("the end", async || {
        page.text("run-status")
            .await
            .starts_with("The time is over")
    })
    .await;
    page.settle().await;
    let (motion, loading, _) = engine(&press());
    let mut run = Run::new(&motion, &loading, &Motor::NONE, [0.0, 12.0]).unwrap();
    run.advance(0.4).unwrap();
    let expected = run.reading().input.to_degrees().rem_euclid(360.0);
    let shown = page.value("out-input").await;
    assert!((shown - expected).abs() < 1e-3, "{shown}, {expected}");
    assert_eq!(page.count("#run-plots svg").await, 3);
    page.click("run-csv").await;
    let table = String::from_utf8(page.saved("run.csv").await).unwrap();
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("t,input,rate,acceleration,kinetic,potential,work,lost")
    );
    let last: Vec<f64> = lines
        .last()
        .unwrap()
        .split(',')
        .map(|one| one.parse().unwrap())
        .collect();
    assert!((last[0] - 0.4).abs() < 1e-9);
    assert!((last[1] - run.reading().input).abs() < 1e-6);
    // From the start: the input is where it was, and the plots are gone.
    page.click("run-rewind").await;
    page.settle().await;
    assert!(page.value("out-input").await.abs() < 1e-9);
    assert_eq!(page.count("#run-plots svg").await, 0);
}

/// The flywheel by Wittenbauer is put on the crank; undone, it is gone. A bad one is refused beside its field.
#[tokio::test]
async fn a_flywheel_is_put_on_the_crank() {
    let page = open(&press()).await;
    page.write("cycle-delta", "0.04").await;
    page.click("cycle-find").await;
    page.until("the flywheels", async || {
        page.count("#put-wittenbauer").await == 1
    })
    .await;
    let (motion, loading, motor) = engine(&press());
    let mut diagram = Diagram::new(&motion, &loading, motor.as_ref(), 12.0).unwrap();
    let expected = diagram.wittenbauer(0.04).unwrap().flywheel * 1e-6;
    let cell = |row: &str, column: usize| {
        format!(
            "return document.querySelector('#{row} td:nth-child({column})').dataset.value ?? ''"
        )
    };
    let number = async |row: &str, column: usize| -> f64 {
        let value = page.ask(&cell(row, column)).await;
        value.as_str().unwrap().parse().unwrap()
    };
    let shown = number("cycle-wittenbauer", 2).await;
    assert!((shown / expected - 1.0).abs() < 1e-9, "{shown}, {expected}");
    assert!((number("cycle-wittenbauer", 3).await - 0.04).abs() < 2e-4);
    assert!((number("cycle-mertsalov", 3).await - 0.04).abs() < 3e-4);
    assert_eq!(page.count("#wittenbauer path.dashed").await, 2);
    page.click("put-wittenbauer").await;
    page.until("its cycle", async || {
        page.count("#cycle-given td").await == 6
    })
    .await;
    assert!((number("cycle-given", 3).await - 0.04).abs() < 2e-4);
    let field = page.written("field-flywheel").await;
    assert!(
        (field.parse::<f64>().unwrap() / expected - 1.0).abs() < 1e-5,
        "{field}"
    );
    page.click("undo").await;
    page.until("no flywheel", async || {
        page.written("field-flywheel").await == "0"
    })
    .await;
    page.write("field-flywheel", "-1").await;
    page.until("the refusal", async || {
        page.text("under-load-shown")
            .await
            .contains("a number is not valid")
    })
    .await;
}

/// A motor is chosen and its numbers are written; the works balance where the engine says.
#[tokio::test]
async fn a_motor_drives_the_press() {
    let page = open(&press()).await;
    page.choose("motor-sort", "linear").await;
    page.write("field-motor.stall", "120").await;
    page.write("field-motor.no_load", "14").await;
    page.write("field-flywheel", "6").await;
    page.click("cycle-find").await;
    page.until("the cycle", async || {
        page.count("#cycle-given td").await == 6
    })
    .await;
    let mut document = press();
    document["motor"] = json!({"stall": 120, "no_load": 14});
    let (motion, loading, motor) = engine(&document);
    let diagram = Diagram::new(&motion, &loading, motor.as_ref(), 12.0).unwrap();
    let said = page.text("cycle-drive").await;
    let expected = format!("{:.2}", diagram.rate());
    assert!(said.contains(&expected[..4]), "{said}, {expected}");
    page.press("cycle-delta", Key::Tab).await;
}

/// Two cranks of a five-bar: a motor on the first, the second free.
fn five_bar() -> Value {
    json!({
        "unit": "mm",
        "points": [
            {"name": "A", "at": [0, 0]}, {"name": "B", "at": [-100, 150]}, {"name": "C", "at": [350, 700]},
            {"name": "D", "at": [820, 180]}, {"name": "E", "at": [600, 0]}
        ],
        "frame": ["A", "E"],
        "links": [
            {"name": "AB", "points": ["A", "B"], "mass_kg": 1},
            {"name": "BC", "points": ["B", "C"], "mass_kg": 1},
            {"name": "DC", "points": ["D", "C"], "mass_kg": 1},
            {"name": "ED", "points": ["E", "D"], "mass_kg": 1}
        ],
        "drivers": [{"crank": "AB"}, {"crank": "ED"}],
        "gravity": [0, -9.81],
        "motor": {"stall": 5, "no_load": 10}
    })
}

/// Each driver of a five-bar has fields of its own; the drawing shows the pose of the run, and a driver that keeps its rate
/// at zero stands still.
#[tokio::test]
async fn a_run_of_two_drivers() {
    let page = open(&five_bar()).await;
    page.until("fields of both drivers", async || {
        page.count("#motor-sort-1").await == 1
    })
    .await;
    assert_eq!(
        page.text("under-load-shown")
            .await
            .matches("Driver")
            .count(),
        2
    );
    let ends = |document: &Value| {
        let document: LinkageDocument = serde_json::from_value(document.clone()).unwrap();
        let motion = document.motion().unwrap();
        let loading = document.loading(motion.mechanism()).unwrap();
        let (actuators, rates) = document.actuators(0.0).unwrap();
        let mut run = LagrangeRun::new(&motion, &loading, &actuators, 0.0, &rates).unwrap();
        run.advance(0.2).unwrap();
        run.reading().coordinates
    };
    page.write("run-until", "0.2").await;
    page.click("run-go").await;
    let over = async || {
        page.text("run-status")
            .await
            .starts_with("The time is over")
    };
    page.until("the end", &over).await;
    page.settle().await;
    let first = page.value("out-input").await;
    let expected = ends(&five_bar())[0].to_degrees().rem_euclid(360.0);
    assert!((first - expected).abs() < 1e-3, "{first}, {expected}");
    assert_eq!(page.count("#run-rate .load-key").await, 2);
    // The second crank is held.
    page.choose("motor-sort-1", "kept").await;
    page.until("no run", async || page.count("#run-plots svg").await == 0)
        .await;
    page.click("run-go").await;
    page.until("the end", &over).await;
    page.settle().await;
    assert_eq!(page.count("#run-plots svg").await, 3);
    page.click("run-csv").await;
    let table = String::from_utf8(page.saved("run.csv").await).unwrap();
    let mut lines = table.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(columns[8..], ["ED.input", "ED.rate", "ED.acceleration"]);
    let rates: Vec<&str> = lines.map(|line| line.split(',').nth(9).unwrap()).collect();
    assert!(
        rates.len() > 1 && rates.iter().all(|rate| *rate == "0"),
        "{rates:?}"
    );
}
