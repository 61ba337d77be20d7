//! A differential by time on the page: how it plays, what drives it, from where it is seen, by what the engine says.

use std::f64::consts::TAU;

use assur::dynamics::Body;
use assur_file::{Document, GearTrainDocument, ObserverDocument, ShaftDocument};
use assur_tests::assert_near;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

/// Numbers of the page and of the engine are the same but for how they were written.
const SAME: f64 = 1e-9;

/// Where the panels of plots begin and end, pixels from the sides of their canvas.
const SIDES: [f64; 2] = [44.0, 10.0];

/// A document of the catalogue.
pub(crate) fn document(name: &str) -> GearTrainDocument {
    let Some(Ok(Document::GearTrain(document))) = assur_file::document(name) else {
        panic!("{name} is no train");
    };
    document
}

/// The link to a document at rest at a time.
pub(crate) fn link(document: &GearTrainDocument, time: f64) -> String {
    let document = serde_json::to_value(document).unwrap();
    let fields = document.as_object().unwrap().iter();
    let fields = fields.map(|(name, value)| {
        let value = value.to_string().replace('%', "%25").replace('"', "%22");
        let value = value.replace('{', "%7B").replace('}', "%7D");
        let value = value.replace('[', "%5B").replace(']', "%5D");
        format!("&d.{name}={}", value.replace(' ', "%20"))
    });
    let fields: String = fields.collect();
    let view = format!(
        "&v.phi_deg=0&v.t={time}&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en"
    );
    format!("{}#2&kind=gear-train{fields}{view}", home())
}

/// The page with a document, and all that is of its kind.
pub(crate) async fn open(document: &GearTrainDocument, time: f64) -> Page {
    let page = Page::open_at(&link(document, time), "en-US").await;
    there(&page).await;
    assert_eq!(page.text("notice-text").await, "");
    page
}

pub(crate) async fn there(page: &Page) {
    page.until("what is of a train", async || {
        page.count("#train-ratios tbody tr").await == 6
            && page.count("#out-ring\\.angle").await == 1
    })
    .await;
    page.settle().await;
}

/// The train of the gallery, at rest.
pub(crate) async fn stopped() -> Page {
    open(&document("train-magnets"), 0.0).await
}

/// What is read of the bodies: angles in degrees, speeds and accelerations in radians and seconds.
async fn read(page: &Page) -> [[f64; 4]; 3] {
    let mut all = [[0.0; 4]; 3];
    for (order, values) in all.iter_mut().enumerate() {
        for (body, value) in ["sun", "satellite", "carrier", "ring"].iter().zip(values) {
            let id = format!("out-{body}.angle{}", ["", "′", "″"][order]);
            *value = page.value(&id).await;
        }
    }
    all
}

/// What the page reads is what the engine says at the same time for the same observer.
pub(crate) async fn agrees(page: &Page, document: &GearTrainDocument) {
    let time = page.value("out-input").await;
    let turned = document.train().unwrap().turning.at(time);
    let observer = document.observer.shaft().map(|one| one.body().index());
    let seen = |values: [f64; 4]| values.map(|one| one - observer.map_or(0.0, |at| values[at]));
    let whole = turned.angles.map(|one| one.turns() as f64 * 360.0);
    let part = turned.angles.map(|one| one.part().to_degrees());
    let angles: Vec<f64> = whole.iter().zip(part).map(|(a, b)| a + b).collect();
    let expected = [
        seen(angles.try_into().unwrap()),
        seen(turned.speeds),
        seen(turned.accelerations),
    ];
    for (order, (shown, expected)) in read(page).await.iter().zip(expected).enumerate() {
        for body in 0..4 {
            let what = format!("body {}, order {order}, at {time} s", body + 1);
            let size = expected[body].abs().max(1.0);
            assert_near(shown[body], expected[body], SAME * size, &what);
        }
    }
}

pub(crate) async fn playing(page: &Page) -> bool {
    page.attribute("play", "data-playing").await.as_deref() == Some("true")
}

/// The ends of the scrubber.
async fn span(page: &Page) -> [f64; 2] {
    let mut ends = [0.0; 2];
    for (end, name) in ends.iter_mut().zip(["min", "max"]) {
        let text = page.attribute("scrubber", name).await.unwrap();
        *end = text.parse::<f64>().unwrap();
    }
    ends.map(|end| (end * 1e6).round() / 1e6)
}

/// Where plots have a part of their axis.
async fn column(page: &Page, part: f64) -> f64 {
    let width = page.element("charts").await.rect().await.unwrap().width;
    SIDES[0] + (width - SIDES[0] - SIDES[1]) * part
}

/// From the gallery it plays on and on; plots and scrubber have one span after the other, angles do not jump.
#[tokio::test]
async fn it_plays_on_and_on() {
    let page = Page::playing().await;
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-train-magnets").await == 1
    })
    .await;
    page.click("gallery-train-magnets").await;
    there(&page).await;
    assert!(playing(&page).await);
    assert_eq!(page.text("problem").await, "");
    assert_eq!(span(&page).await, [0.0, 6.0]);
    page.choose("speed", "4").await;
    // On a slow machine several spans pass between two looks.
    page.until("the next span", async || {
        let [start, end] = span(&page).await;
        start > 0.0 && start % 6.0 == 0.0 && end == start + 6.0
    })
    .await;
    let told = async || {
        let script = "return document.getElementById('charts-description').textContent";
        page.ask(script).await.as_str().unwrap().to_owned()
    };
    page.click("play").await;
    let [start, end] = span(&page).await;
    page.until("its plots", async || {
        told()
            .await
            .contains(&format!("{start:.1} s to {end:.1} s"))
    })
    .await;
    let time = page.value("out-input").await;
    assert!(time > 6.0, "{time}");
    agrees(&page, &document("train-magnets")).await;
    // Ten thousand turns later the wheels are still in mesh.
    page.write("angle", "10000").await;
    agrees(&page, &document("train-magnets")).await;
    let [start, end] = span(&page).await;
    assert!(start <= 10_000.0 && end > 10_000.0, "{start} {end}");
    page.close().await;
}

/// By hand: steps, keys, the field, the scrubber, the plots. Time stops at 0; no drag runs into other spans.
#[tokio::test]
async fn time_is_set_by_hand() {
    let page = stopped().await;
    let time = async || page.value("out-input").await;
    for (control, expected) in [
        ("step-forward", 0.1),
        ("step-back", 0.0),
        ("step-back", 0.0),
    ] {
        page.click(control).await;
        assert_near(time().await, expected, 1e-12, control);
    }
    page.focus("play").await;
    page.keys(Key::End + "").await;
    assert_near(time().await, 6.0, 1e-6, "End");
    assert_eq!(span(&page).await, [0.0, 6.0]);
    page.keys(Key::Right + "").await;
    assert_eq!(span(&page).await, [6.0, 12.0]);
    page.keys(Key::Home + "").await;
    assert_eq!(time().await, 6.0);
    page.keys(Key::Left + "").await;
    page.keys(Key::Home + "").await;
    assert_eq!(time().await, 0.0);
    page.keys(Key::Left + "").await;
    assert_eq!(time().await, 0.0);
    page.keys(" ").await;
    assert!(playing(&page).await);
    page.keys(" ").await;

    page.write("angle", "7,25").await;
    assert_eq!(time().await, 7.25);
    agrees(&page, &document("train-magnets")).await;
    page.write("angle", "-3").await;
    assert_eq!(time().await, 0.0);
    for bad in ["", "soon", "NaN"] {
        page.write("angle", bad).await;
        assert_eq!(time().await, 0.0);
        assert!(page.text("problem").await.len() > 10, "{bad}");
    }
    page.write("angle", "2.5").await;
    assert_eq!(page.text("problem").await, "");

    page.drag("scrubber", 0.4, 0.75).await;
    assert_near(time().await, 4.5, 0.1, "the scrubber");
    page.drag("scrubber", 0.75, 0.999).await;
    assert_near(time().await, 6.0, 0.05, "the end of the scrubber");
    assert_eq!(span(&page).await, [0.0, 6.0]);
    let [middle, end] = [column(&page, 0.5).await, column(&page, 1.0).await];
    page.drag_along("charts", &[(middle, 60.0)]).await;
    assert_near(time().await, 3.0, 0.05, "the plots");
    page.drag_along(
        "charts",
        &[
            (middle, 60.0),
            (end, 60.0),
            (end + 3.0, 62.0),
            (end + 5.0, 64.0),
        ],
    )
    .await;
    assert_near(time().await, 6.0, 1e-6, "the end of the plots");
    assert_eq!(span(&page).await, [0.0, 6.0]);
    agrees(&page, &document("train-magnets")).await;
    page.close().await;
}

/// A speed by slider and field, a held shaft, a tie: the third shaft follows; each is undone and done again.
#[tokio::test]
async fn shafts_are_driven_held_and_tied() {
    let page = open(&document("train-magnets"), 2.0).await;
    let carrier = async || page.value("out-train-carrier").await;
    let of = |sun: f64, ring: f64| (20.0 * sun + 43.0 * ring) / 63.0;
    let mut seen = vec![carrier().await];
    assert_near(seen[0], of(60.0, 12.0), SAME, "at first");
    page.write("field-rpm-1", "-31.5").await;
    seen.push(carrier().await);
    assert_near(seen[1], of(-31.5, 12.0), SAME, "a speed");
    page.click("train-hold-1").await;
    seen.push(carrier().await);
    assert_near(seen[2], of(0.0, 12.0), SAME, "held");
    let held = page.attribute("train-hold-1", "aria-pressed").await;
    assert_eq!(held.as_deref(), Some("true"));
    page.drag("slider-rpm-1", 0.5, 0.75).await;
    let speed: f64 = page.written("field-rpm-1").await.parse().unwrap();
    assert!((20.0..=120.0).contains(&speed), "{speed}");
    seen.push(carrier().await);
    assert_near(seen[3], of(speed, 12.0), SAME, "a slider");
    page.click("train-tie-2").await;
    seen.push(carrier().await);
    assert_near(seen[4], speed, SAME, "tied alike");
    assert!(
        !page
            .element("field-rpm-2")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    page.write("field-factor-2", "-0.5").await;
    seen.push(carrier().await);
    assert_near(seen[5], of(speed, -0.5 * speed), SAME, "tied by a factor");
    agrees(&page, &{
        let mut tied = document("train-magnets");
        tied.drives[0].rpm = speed;
        tied.drives[1].to = Some(ShaftDocument::Sun);
        tied.drives[1].factor = -0.5;
        tied
    })
    .await;
    for expected in seen.iter().rev().skip(1) {
        page.click("undo").await;
        assert_near(carrier().await, *expected, SAME, "undo");
    }
    for expected in &seen[1..] {
        page.click("redo").await;
        assert_near(carrier().await, *expected, SAME, "redo");
    }
    page.close().await;
}

/// Another shaft is left free: all speeds stay; a rise from rest is said, too.
#[tokio::test]
async fn another_shaft_is_free() {
    let page = open(&document("train-magnets"), 2.0).await;
    let before = read(&page).await;
    for shaft in ["sun", "ring", "carrier"] {
        page.choose("train-free", shaft).await;
        assert_eq!(page.text("problem").await, "", "{shaft}");
        let now = read(&page).await;
        for body in 0..4 {
            assert_near(now[1][body], before[1][body], SAME, shaft);
            let angle = before[0][body];
            assert_near(now[0][body], angle, SAME * angle.abs().max(1.0), shaft);
        }
    }
    // The sun is the second of the driven shafts by now.
    page.write("field-start_s-2", "4").await;
    let shown = read(&page).await;
    assert_near(shown[2][0], TAU / 4.0, SAME, "ε₁");
    assert_near(shown[0][0], 360.0 / 8.0 * 4.0, 1e-6, "φ₁ after 2 s");
    page.close().await;
}

/// What cannot be typed is said with its field; the last good motion stays, and the next good number is taken.
#[tokio::test]
async fn bad_speeds_are_said() {
    let page = open(&document("train-magnets"), 2.0).await;
    let before = read(&page).await;
    for (field, named) in [
        ("rpm-1", "Input shaft 1"),
        ("rpm-2", "Input shaft 2"),
        ("start_s-2", "run-up time from rest"),
    ] {
        let id = format!("field-{field}");
        let good = page.written(&id).await;
        for bad in ["", "fast", "NaN", "1e9", "1e999"] {
            page.write(&id, bad).await;
            let said = page.text("problem").await;
            assert!(said.contains(named) && !said.contains('{'), "{bad}: {said}");
            // What begins with a number was one for a moment.
            if !bad.starts_with(char::is_numeric) {
                assert_eq!(read(&page).await, before, "{field} {bad}");
            }
            assert_eq!(
                page.attribute(&id, "aria-invalid").await.as_deref(),
                Some("true")
            );
        }
        page.write(&id, &good).await;
        assert_eq!(page.text("problem").await, "");
    }
    // A shaft cannot be tied so that the motion is left open.
    page.choose("train-free", "ring").await;
    page.click("train-tie-2").await;
    page.write("field-factor-2", "1e9").await;
    let said = page.text("problem").await;
    assert!(
        said.contains("would turn at") && said.contains("ring"),
        "{said}"
    );
    page.write("field-factor-2", "1").await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// Where one stands is still, the rest turns by so much less; the ground turns in the drawing.
#[tokio::test]
async fn it_is_seen_by_an_observer() {
    let page = open(&document("train-magnets"), 2.0).await;
    let from_ground = page.picture("mechanism").await;
    let mut seen = document("train-magnets");
    for (name, observer, body) in [
        ("sun", ObserverDocument::Sun, Body::Sun),
        ("ring", ObserverDocument::Ring, Body::Ring),
        ("carrier", ObserverDocument::Carrier, Body::Carrier),
    ] {
        page.click(&format!("observer-{name}")).await;
        seen.observer = observer;
        for time in ["0", "0.31", "5.02", "400"] {
            page.write("angle", time).await;
            agrees(&page, &seen).await;
            for values in read(&page).await {
                assert_eq!(values[body.index()], 0.0, "{name} at {time} s");
            }
        }
    }
    page.write("angle", "2").await;
    assert!(page.picture("mechanism").await.difference(&from_ground) > 2000);
    page.click("undo").await;
    page.click("undo").await;
    page.click("undo").await;
    page.write("angle", "2").await;
    assert!(page.picture("mechanism").await.difference(&from_ground) < 20);
    page.close().await;
}
