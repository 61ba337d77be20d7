//! What a differential is made of and what loads it: wheels, members, magnets, a run that slips, files of it.

use assur::dynamics::Body;
use assur_file::{CouplingDocument, GearTrainDocument};
use assur_tests::assert_near;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::gear_train::{agrees, document, open, stopped};

fn loaded() -> GearTrainDocument {
    GearTrainDocument {
        loaded: true,
        ..document("train-magnets")
    }
}

async fn shown(page: &Page, id: &str) -> bool {
    page.element(id).await.is_displayed().await.unwrap()
}

/// Unfolds all that is of the kind.
pub(crate) async fn unfold(page: &Page) {
    page.ask("for (const one of document.querySelectorAll('[data-of=gear-train] details')) one.open = true")
        .await;
    page.settle().await;
}

/// Forms and couplings change the wheels, the formulas and what can be built; all is undone.
#[tokio::test]
async fn wheels_are_changed() {
    let page = stopped().await;
    let before = page.picture("mechanism").await;
    let ratios = page.text("train-ratios").await;
    page.choose("field-form", "stepped").await;
    assert!(shown(&page, "field-z2_step").await);
    page.write("field-z2_step", "9").await;
    assert_ne!(page.text("train-ratios").await, ratios);
    assert!(page.text("train-ratios").await.contains("z₂′"));
    page.choose("field-form", "bevel").await;
    let said = page.text("problem").await;
    assert!(
        said.contains("z₁ = 20") && said.contains("2z₂"),
        "no cones: {said}"
    );
    page.write("field-z2", "16").await;
    assert_eq!(page.text("problem").await, "");
    assert!(!shown(&page, "field-axis_distance_mm").await);
    assert!(page.picture("mechanism").await.difference(&before) > 2000);
    for _ in 0..4 {
        page.click("undo").await;
    }
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.text("train-ratios").await, ratios);
    assert!(page.picture("mechanism").await.difference(&before) < 20);

    page.choose("field-coupling", "contact").await;
    assert!(!shown(&page, "field-magnets.poles").await && !shown(&page, "train-gaps").await);
    let holds = page.attribute("train-builds", "data-holds").await;
    assert_eq!(holds.as_deref(), Some("false"), "43 ≠ 20 + 2 · 10");
    let mut contact = document("train-magnets");
    contact.coupling = CouplingDocument::Contact;
    agrees(&page, &contact).await;
    page.close().await;
}

/// Magnets that touch are said with the mesh; equal gaps bring them apart. Numbers that are none are said with the wheel.
#[tokio::test]
async fn gaps_and_numbers_are_judged() {
    let page = stopped().await;
    let gaps = page.text("train-gaps").await;
    let picture = page.picture("mechanism").await;
    for (distance, named) in [("55", "sun"), ("68", "ring")] {
        page.write("field-axis_distance_mm", distance).await;
        let said = page.text("problem").await;
        assert!(said.contains(named) && said.contains("touch"), "{said}");
        assert_eq!(
            page.attribute("mechanism", "data-faded").await.as_deref(),
            Some("true")
        );
    }
    page.write("field-axis_distance_mm", "62").await;
    assert_eq!(page.text("problem").await, "");
    assert_ne!(page.text("train-gaps").await, gaps);
    page.click("train-equal-gaps").await;
    assert_eq!(page.text("train-gaps").await, gaps);
    assert!(page.picture("mechanism").await.difference(&picture) < 20);

    for (field, value, named) in [
        ("z1", "0", "z₁"),
        ("z1", "-5", "z₁"),
        ("z1", "7.5", "z₁"),
        ("z1", "50", "z₁"),
        ("z2", "0", "z₂"),
        ("z4", "20", "z₄"),
        ("satellites", "7", "k"),
        ("satellites", "0", "k"),
        ("module_mm", "0", "m"),
        ("z4", "", "z₄"),
    ] {
        let id = format!("field-{}", field.replace("z4", "z4_ring"));
        let good = page.written(&id).await;
        page.write(&id, value).await;
        let said = page.text("problem").await;
        assert!(
            said.contains(named) && !said.contains('{'),
            "{field} {value}: {said}"
        );
        page.write(&id, &good).await;
        assert_eq!(page.text("problem").await, "", "{field} {good}");
    }
    agrees(&page, &document("train-magnets")).await;
    page.close().await;
}

/// What cannot be built offers numbers near by; they are taken, and undone.
#[tokio::test]
async fn numbers_near_by_are_taken() {
    let page = stopped().await;
    page.write("field-z4_ring", "44").await;
    let holds = async || page.attribute("train-builds", "data-holds").await;
    assert_eq!(holds().await.as_deref(), Some("false"), "64 is no 3 n");
    let mut wanted = document("train-magnets");
    wanted.z4 = 44.0;
    let train = wanted.train().unwrap();
    let near = train.layout.suggestions(train.coupling, 5);
    assert_eq!(
        page.count("#train-suggestions li button").await,
        near.len(),
        "offered"
    );
    page.ask("document.querySelector('#train-suggestions button').click()")
        .await;
    page.settle().await;
    assert_eq!(holds().await.as_deref(), Some("true"));
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#train-suggestions button").await, 0);
    page.click("undo").await;
    assert_eq!(page.written("field-z4_ring").await, "44");
    page.close().await;
}

/// Under load: beyond the limit the magnets slip, as the engine says; back within it they hold.
#[tokio::test]
async fn the_load_slider_passes_the_limit() {
    let page = stopped().await;
    assert!(!shown(&page, "field-load").await);
    page.click("field-loaded").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.written("plot").await, "load");
    assert_eq!(page.value("out-input").await, 0.0);
    let train = document("train-magnets").train().unwrap();
    let limit = train.differential.unwrap().static_limit(Body::Carrier);
    let said = page.text("train-limit").await;
    assert!(
        said.contains(format!("{limit:.3}").trim_end_matches('0')),
        "{limit} {said}"
    );
    assert_eq!(page.text("out-train-slipped").await, "0, 0");
    let held = page.picture("charts").await;

    page.ask("document.getElementById('slider-load').scrollIntoView({ block: 'center', behavior: 'instant' })")
        .await;
    page.settle().await;
    page.drag("slider-load", 0.3, 0.98).await;
    let load: f64 = page.written("field-load").await.parse().unwrap();
    assert!(load > 1.2 * limit, "{load} {limit}");
    let slipped = page.text("out-train-slipped").await;
    let counts: Vec<i64> = slipped
        .split(", ")
        .map(|one| one.replace('−', "-").parse().unwrap())
        .collect();
    assert!(counts.iter().any(|count| count.abs() > 2), "{slipped}");
    assert!(page.text("train-meshes").await.contains("periods"));
    assert!(page.picture("charts").await.difference(&held) > 1000);
    // At its end it stays.
    page.focus("play").await;
    page.keys(Key::End + "").await;
    assert_near(page.value("out-input").await, 6.0, 1e-9, "the end");
    let last = page.value("out-sun.load_angle").await.abs() > 1.0
        || page.value("out-ring.load_angle").await.abs() > 1.0;
    assert!(last, "load angles");
    page.keys(Key::Right + "").await;
    assert_near(page.value("out-input").await, 6.0, 1e-9, "no further");

    page.write("field-load", "8").await;
    assert_eq!(page.text("out-train-slipped").await, "0, 0");
    assert!(!page.text("train-meshes").await.contains("period"));
    unfold(&page).await;
    assert_eq!(page.count("#train-energies tbody tr").await, 6);
    // What no shaft bears stops the run, and that is told.
    page.write("field-load", "1e9").await;
    let said = page.text("train-meshes").await;
    assert!(said.contains("The run stops at"), "{said}");
    page.write("field-load", "8").await;
    for bad in ["", "-1", "much"] {
        page.write("field-load", bad).await;
        let said = page.text("problem").await;
        assert!(
            said.contains("load") && !said.contains('{'),
            "{bad}: {said}"
        );
        assert_eq!(page.text("out-train-slipped").await, "0, 0");
    }
    page.write("field-load", "8").await;
    assert_eq!(page.text("problem").await, "");
    page.write("field-span_s", "2").await;
    assert!(page.value("out-input").await <= 2.0);
    page.write("field-span_s", "100").await;
    assert!(page.text("problem").await.contains("100"));
    page.write("field-span_s", "6").await;
    page.click("field-loaded").await;
    assert_eq!(page.written("plot").await, "angles");
    agrees(&page, &document("train-magnets")).await;
    page.close().await;
}

/// It plays through a run and comes back from its end.
#[tokio::test]
async fn a_run_is_played() {
    let page = open(&loaded(), 5.5).await;
    page.click("play").await;
    page.until("the end and back", async || {
        page.value("out-input").await < 5.5
    })
    .await;
    page.click("play").await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// What is no number of magnets, bodies and members is said with the number of the link.
#[tokio::test]
async fn magnets_bodies_and_members_are_changed() {
    let page = open(&loaded(), 3.5).await;
    unfold(&page).await;
    for (field, bad, named) in [
        ("magnets-peak-1", "-1", "1"),
        ("magnets-peak-4", "", "4"),
        ("magnets-damping-4", "-1", "4"),
        ("bodies-inertia-1", "0", "1"),
        ("bodies-inertia-2", "-1", "2"),
        ("bodies-inertia-3", "x", "3"),
        ("bodies-damping-4", "-2", "4"),
        ("bodies.mass", "-1", "satellite"),
        ("torque-satellite", "-1", "member 7"),
        ("torque-carrier", "-1", "member 8"),
    ] {
        let id = format!("field-{field}");
        page.focus(&id).await;
        let good = page.written(&id).await;
        page.write(&id, bad).await;
        let said = page.text("problem").await;
        assert!(
            said.contains(named) && said.len() > 20 && !said.contains('{'),
            "{field} {bad}: {said}"
        );
        page.write(&id, &good).await;
        assert_eq!(page.text("problem").await, "", "{field} {good}");
    }
    let angle = async || page.value("out-sun.load_angle").await;
    let before = angle().await;
    page.write("field-magnets-peak-1", "1.5").await;
    let weaker = angle().await;
    assert!(weaker > 1.2 * before, "{before} {weaker}");
    page.click("undo").await;
    assert_near(angle().await, before, 1e-9, "undo");
    let picture = page.picture("mechanism").await;
    for name in [
        "fan",
        "brush",
        "stirrer",
        "scraper",
        "blade",
        "propeller",
        "road_wheel",
    ] {
        page.choose("field-members\\.satellite", name).await;
        assert_eq!(page.text("problem").await, "", "{name}");
    }
    page.choose("field-members\\.satellite", "none").await;
    page.choose("field-members\\.carrier", "none").await;
    assert!(!shown(&page, "field-torque-carrier").await);
    assert!(page.picture("mechanism").await.difference(&picture) > 1000);
    page.close().await;
}
