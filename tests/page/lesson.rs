//! The mixer lesson: plays, scrubs, presets, assembly, mesh, fields; read-outs
//! against the engine run natively.

use assur::gears::Mesh;
use assur::mixer::Case;
use assur::{Assembly, FourBar, Pose};
use assur_tests::{angle_between, assert_near};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

/// The engine's own pose at an angle.
fn pose(lengths: [f64; 4], assembly: Assembly, degrees: f64) -> Pose<3> {
    let linkage = FourBar::new(lengths).unwrap();
    linkage.pose(assembly, degrees.to_radians()).unwrap()
}

/// All read-outs of the pose that the page shows, against the engine.
async fn check_readouts(page: &Page, lengths: [f64; 4], assembly: Assembly, ratio: f64) {
    let degrees = page.value("out-input").await;
    let pose = pose(lengths, assembly, degrees);
    for (name, angle, factor) in [
        ("coupler", pose.coupler, 1.0),
        ("rocker", pose.rocker, 1.0),
        ("wheel5", pose.rocker, ratio),
    ] {
        let shown = page.value(&format!("out-{name}.angle")).await.to_radians();
        let off = angle_between(shown, factor * angle.value());
        assert!(
            off < 1e-9,
            "{name} at {degrees}°: {shown} against {}",
            factor * angle.value()
        );
        for (order, stroke) in [(1, "′"), (2, "″")] {
            if name != "coupler" {
                let shown = page.value(&format!("out-{name}.angle{stroke}")).await;
                assert_near(shown, factor * angle.derivative(order), 1e-9, name);
            }
        }
    }
}

#[tokio::test]
async fn plays_pauses_and_turns_about() {
    let page = Page::playing().await;
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("true")
    );
    let start = page.value("out-input").await;
    let first = page.picture("mechanism").await;
    page.until("the crank to turn", async || {
        let turned = (page.value("out-input").await - start).rem_euclid(360.0);
        (20.0..300.0).contains(&turned)
    })
    .await;
    assert!(page.picture("mechanism").await.difference(&first) > 2000);

    page.click("play").await;
    let rest = page.value("out-input").await;
    let still = page.picture("mechanism").await;
    tokio::time::sleep(std::time::Duration::from_millis(300)).await;
    assert_eq!(page.value("out-input").await, rest);
    assert_eq!(page.picture("mechanism").await.difference(&still), 0);

    page.click("reverse").await;
    page.write("angle", "200").await;
    page.click("play").await;
    page.until("the crank to turn back", async || {
        (100.0..190.0).contains(&page.value("out-input").await)
    })
    .await;
    page.close().await;
}

#[tokio::test]
async fn scrubs_steps_and_takes_an_exact_angle() {
    let page = Page::open().await;
    let lengths = Case::A.dimensions().lengths;
    page.stop_at("123.456").await;
    assert_eq!(page.value("out-input").await, 123.456);
    check_readouts(&page, lengths, Assembly::First, -2.0).await;

    page.click("step-forward").await;
    assert_near(
        page.value("out-input").await,
        124.456,
        1e-12,
        "a step forward",
    );
    page.click("step-back").await;
    page.click("step-back").await;
    assert_near(
        page.value("out-input").await,
        122.456,
        1e-12,
        "two steps back",
    );
    check_readouts(&page, lengths, Assembly::First, -2.0).await;

    page.drag("scrubber", 0.34, 0.75).await;
    let dragged = page.value("out-input").await;
    assert!((dragged - 270.0).abs() < 8.0, "{dragged}");
    check_readouts(&page, lengths, Assembly::First, -2.0).await;

    page.press("scrubber", Key::Home).await;
    assert_eq!(page.value("out-input").await, 0.0);
    page.press("scrubber", Key::Right).await;
    assert_near(page.value("out-input").await, 1.0, 1e-12, "an arrow key");
    page.close().await;
}

#[tokio::test]
async fn presets_show_the_papers_conclusions() {
    let page = Page::open().await;
    page.stop_at("75").await;
    for (preset, case, rocker, wheel5, ratio) in [
        ("preset-b", Case::B, "53.452°", "106.903°", -2.0),
        ("preset-c", Case::C, "87.905°", "43.952°", -0.5),
        ("preset-a", Case::A, "87.905°", "175.809°", -2.0),
    ] {
        let before = page.picture("mechanism").await;
        page.click(preset).await;
        assert!(page.text("out-swing-rocker").await.contains(rocker));
        assert!(page.text("out-swing-wheel5").await.contains(wheel5));
        check_readouts(&page, case.dimensions().lengths, Assembly::First, ratio).await;
        assert!(
            page.picture("mechanism").await.difference(&before) > 1000,
            "{preset}"
        );
    }
    page.close().await;
}

#[tokio::test]
async fn assembly_and_mesh_change_what_they_say() {
    let page = Page::open().await;
    let lengths = Case::A.dimensions().lengths;
    page.stop_at("75").await;
    page.click("assembly-2").await;
    check_readouts(&page, lengths, Assembly::Second, -2.0).await;
    assert!(page.value("out-rocker.angle").await < 0.0);
    page.click("assembly-1").await;

    for (mesh, id, ratio) in [
        (Mesh::Internal, "mesh-internal", 2.0),
        (Mesh::AsPrinted, "mesh-as_printed", 2.0),
        (Mesh::External, "mesh-external", -2.0),
    ] {
        let before = page.picture("mechanism").await;
        page.click(id).await;
        assert_near(
            page.value("out-ratio").await,
            ratio,
            1e-15,
            &format!("{mesh:?}"),
        );
        check_readouts(&page, lengths, Assembly::First, ratio).await;
        assert!(
            page.picture("mechanism").await.difference(&before) > 500,
            "{mesh:?}"
        );
    }
    page.close().await;
}

#[tokio::test]
async fn fields_and_sliders_change_the_mechanism() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.write("field-l2", "0.9").await;
    page.write("field-l3", "0,6").await; // the decimal comma too
    page.write("field-z5", "24").await;
    check_readouts(&page, [0.37, 0.9, 0.6, 0.85], Assembly::First, -1.5).await;

    let before = page.value("out-rocker.angle").await;
    page.press("slider-l1", Key::Right).await;
    assert_ne!(page.value("out-rocker.angle").await, before);
    let l1: f64 = page.written("field-l1").await.parse().unwrap();
    assert!(l1 > 0.37);
    check_readouts(&page, [l1, 0.9, 0.6, 0.85], Assembly::First, -1.5).await;
    page.close().await;
}

/// A linkage whose crank cannot turn swings between its dead points.
#[tokio::test]
async fn partial_turn_swings_between_its_limits() {
    let page = Page::open().await;
    page.stop_at("75").await;
    // l₄ last: on the way there every step is a mechanism.
    for (field, length) in [
        ("field-l1", "0.8"),
        ("field-l2", "0.4"),
        ("field-l3", "0.55"),
    ] {
        page.write(field, length).await;
    }
    let linkage = FourBar::new([0.8, 0.4, 0.55, 0.85]).unwrap();
    let [low, high] = linkage.cycle().arcs()[0].map(f64::to_degrees);
    page.write("angle", &format!("{:.3}", high - 5.0)).await;
    page.choose("speed", "4").await;
    let reversed = async || page.attribute("reverse", "aria-pressed").await;
    let before = reversed().await;
    page.click("play").await;
    page.until("the crank to turn back", async || {
        page.value("out-input").await < high - 10.0
    })
    .await;
    page.click("play").await;
    // Of itself, whatever the reader has said.
    assert_eq!(reversed().await, before);
    let phi = page.value("out-input").await;
    assert!((low..=high).contains(&phi), "{phi} in {low}..{high}");
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

#[tokio::test]
async fn speaks_russian_and_writes_the_comma() {
    let page = Page::open_at(home(), "ru").await;
    assert_eq!(page.lang().await.as_deref(), Some("ru"));
    page.stop_at("75,5").await;
    assert_eq!(page.value("out-input").await, 75.5);
    assert!(page.text("out-swing-rocker").await.contains("87,905°"));
    assert!(page.text("out-grashof").await.contains("коромысл"));
    for lang in ["uk", "kk"] {
        page.choose("lang", lang).await;
        page.until("its words", async || {
            page.lang().await.as_deref() == Some(lang)
        })
        .await;
        assert!(
            page.text("out-swing-rocker").await.contains("87,905°"),
            "{lang}"
        );
    }
    page.choose("lang", "en").await;
    page.until("English", async || {
        page.lang().await.as_deref() == Some("en")
    })
    .await;
    assert!(page.text("out-swing-rocker").await.contains("87.905°"));
    assert!(page.text("out-grashof").await.contains("rocker"));
    page.close().await;
}
