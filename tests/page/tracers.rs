//! Traced points: put on a link by hand or by numbers, dragged on it, taken away.

use assur::Point;
use assur::mixer::{Carrier, Case, Dimensions, Mixer, Tracer};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::hands::View;

/// The first case with one traced point.
fn with_point(carrier: Carrier, x: f64, y: f64) -> Dimensions {
    Dimensions {
        tracers: vec![Tracer { carrier, x, y }],
        ..Case::A.dimensions()
    }
}

/// Where the joints are at 60°.
fn joints() -> [Point; 4] {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    let crank = 60.0_f64.to_radians();
    let pose = mixer.linkage.pose::<1>(mixer.assembly, crank).unwrap();
    mixer.linkage.joints(&pose).map(|joint| joint.place())
}

async fn number(page: &Page, field: &str) -> f64 {
    let written = page.written(field).await.replace('−', "-");
    written.parse().unwrap()
}

/// The point's read-outs and its place in the fields, against the engine.
async fn check(page: &Page, link: &str, carrier: Carrier, place: Point, slack: f64) {
    assert_eq!(page.written("link-P1").await, link);
    let [x, y] = [
        number(page, "field-P1-x").await,
        number(page, "field-P1-y").await,
    ];
    let mixer = Mixer::new(&with_point(carrier, x, y)).unwrap();
    let crank = page.value("out-input").await.to_radians();
    let pose = mixer.linkage.pose::<3>(mixer.assembly, crank).unwrap();
    let point = mixer.traced(&pose, &mixer.tracers()[0]);
    let off = (point.place() - place).norm();
    assert!(off < slack, "{link}: off by {off}");
    page.choose("plot", "P1").await;
    for (order, stroke) in ["", "′", "″"].into_iter().enumerate() {
        let expected = point.derivative(order);
        for (axis, expected) in [("x", expected.x), ("y", expected.y)] {
            let shown = page.value(&format!("out-P1.{axis}{stroke}")).await;
            // The fields show six digits.
            assert!(
                (shown - expected).abs() < 1e-5,
                "{axis}{stroke}: {shown} {expected}"
            );
        }
    }
    page.choose("plot", "angles").await;
}

#[tokio::test]
async fn a_point_is_put_dragged_and_undone() {
    let page = Page::open().await;
    page.stop_at("60").await;
    page.hover("mechanism", (9.0, 9.0)).await;
    let plain = page.picture("mechanism").await;
    let [_, b, c, _] = joints();
    let beside = b + (c - b) * 0.3 + assur::Vector::new(-0.05, 0.2);
    let view = View::showing(&page, &Case::A.dimensions()).await;
    page.click("trace").await;
    page.drag_along("mechanism", &[view.at(beside)]).await;
    let pressed = page.attribute("trace", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("false"));
    check(&page, "coupler", Carrier::Coupler, beside, 2.0 / view.scale).await;
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&plain) > 500);

    // On its link it can be dragged anywhere; the lengths stay.
    let [x, y] = [
        number(&page, "field-P1-x").await,
        number(&page, "field-P1-y").await,
    ];
    let view = View::showing(&page, &with_point(Carrier::Coupler, x, y)).await;
    let to = beside + assur::Vector::new(0.2, 0.1);
    let way = [beside, beside + (to - beside) * 0.5, to].map(|place| view.at(place));
    page.drag_along("mechanism", &way).await;
    check(&page, "coupler", Carrier::Coupler, to, 3.0 / view.scale).await;
    assert_eq!(page.written("field-l2").await, "0.85");
    page.click("undo").await;
    check(&page, "coupler", Carrier::Coupler, beside, 2.0 / view.scale).await;
    page.click("undo").await;
    assert_eq!(page.count("#tracers .card:not([hidden])").await, 0);
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&plain) < 20);
    page.close().await;
}

/// While a mixer is refused, what is drawn may be of another kind: nothing of that comes into the mixer.
#[tokio::test]
async fn a_drawing_left_behind_puts_nothing_into_another_kind() {
    let page = Page::open().await;
    page.stop_at("60").await;
    page.write("field-l1", "9").await;
    page.until("a refusal", async || !page.text("problem").await.is_empty())
        .await;
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-jansen").await == 1
    })
    .await;
    page.click("gallery-jansen").await;
    page.until("a linkage", async || page.text("problem").await.is_empty())
        .await;
    page.click("undo").await;
    page.until("the mixer", async || !page.text("problem").await.is_empty())
        .await;
    let problems = page.text("problem").await;
    let drawn = page.element("mechanism").await.rect().await.unwrap();
    page.click("trace").await;
    page.drag_along("mechanism", &[(0.5 * drawn.width, 0.5 * drawn.height)])
        .await;
    page.settle().await;
    assert_eq!(page.count("#tracers .card:not([hidden])").await, 0);
    assert_eq!(page.text("problem").await, problems);
    page.close().await;
}

#[tokio::test]
async fn a_point_by_touch() {
    let page = Page::open().await;
    page.stop_at("60").await;
    let [a, b, ..] = joints();
    let place = a + (b - a) * 0.5;
    let view = View::showing(&page, &Case::A.dimensions()).await;
    let tool = page.element("trace").await.rect().await.unwrap();
    page.fingers("trace", &[vec![(0.5 * tool.width, 0.5 * tool.height)]])
        .await;
    page.until("the tool", async || {
        page.attribute("trace", "aria-pressed").await.as_deref() == Some("true")
    })
    .await;
    page.fingers("mechanism", &[vec![view.at(place)]]).await;
    check(&page, "crank", Carrier::Crank, place, 2.0 / view.scale).await;
    page.close().await;
}

#[tokio::test]
async fn a_point_by_keyboard_alone() {
    let page = Page::playing().await;
    page.keys(" ").await;
    page.keys("t").await;
    let tracing = async || page.attribute("trace", "aria-pressed").await;
    assert_eq!(tracing().await.as_deref(), Some("true"));
    page.keys(Key::Escape + "").await;
    assert_eq!(tracing().await.as_deref(), Some("false"));

    page.focus("tracers-add").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(page.written("link-P1").await, "coupler");
    page.focus("link-P1").await;
    page.keys(Key::Down + "").await; // the rocker
    page.keys(Key::Down + "").await; // wheel 5
    for (field, text) in [("field-P1-x", "0.1"), ("field-P1-y", "-0,02")] {
        page.focus(field).await;
        page.keys(text.to_owned() + Key::Enter).await;
    }
    let mixer = Mixer::new(&with_point(Carrier::Wheel(0), 0.1, -0.02)).unwrap();
    let crank = page.value("out-input").await.to_radians();
    let pose = mixer.linkage.pose::<1>(mixer.assembly, crank).unwrap();
    let place = mixer.traced(&pose, &mixer.tracers()[0]).place();
    check(&page, "wheel5", Carrier::Wheel(0), place, 1e-12).await;

    // What is nowhere is named.
    page.focus("field-P1-x").await;
    page.keys("1e300").await;
    assert!(page.text("problem").await.contains("P₁"));
    page.chord(&[Key::Control], 'a').await;
    page.keys("0.1").await;
    assert_eq!(page.text("problem").await, "");

    page.focus("tracers-remove-1").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(page.count("#tracers .card:not([hidden])").await, 0);
    let focused = page.ask("return document.activeElement.id").await;
    assert_eq!(focused.as_str(), Some("tracers-add"));
    page.close().await;
}

/// A plotted point that is taken away leaves the plot to the angles; a point goes
/// with its wheel, or stays on it when another one goes.
#[tokio::test]
async fn points_go_with_what_carries_them() {
    let page = Page::open().await;
    page.stop_at("60").await;
    page.click("wheels-add").await;
    for _ in 0..6 {
        page.click("tracers-add").await;
    }
    assert!(!page.element("trace").await.is_enabled().await.unwrap());
    page.click("tracers-remove-6").await;
    page.click("undo").await;
    for _ in 0..4 {
        page.click("tracers-remove-1").await;
    }
    page.choose("link-P2", "wheel6").await;
    page.choose("plot", "P2").await;
    page.click("wheels-remove-5").await;
    assert_eq!(page.written("link-P2").await, "wheel5");
    assert_eq!(page.written("plot").await, "P2");
    page.click("undo").await;
    page.click("wheels-remove-6").await;
    assert_eq!(page.count("#tracers .card:not([hidden])").await, 1);
    assert_eq!(page.written("plot").await, "angles");
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

/// A traced point of a linkage is placed by numbers along and across its link; what is no number is kept and named.
#[tokio::test]
async fn a_point_of_a_linkage_has_its_place_in_numbers() {
    let url = format!("{}#jansen&v.playing=false", crate::host::home());
    let page = Page::open_at(&url, "en-US").await;
    let state = page
        .wait_for(
            "const done = arguments[0];
            window.eval(\"import('assur/pkg/assur_web.js')\").then(({ catalogue }) => {
                const { kind, document } = catalogue().find(({ id }) => id === 'crank-rocker');
                done({ format: 2, kind, document: { ...document, tracers: [{ name: 'P', link: 'rocker', at: [1, 0.5] }] } });
            })",
        )
        .await;
    crate::lecturers::open_file(&page, "traced.json", &state.to_string()).await;
    page.until("its place", async || {
        println!(
            "{} {}",
            page.text("notice-text").await,
            page.text("problem").await
        );
        page.count("#traced-along-0").await == 1
    })
    .await;
    page.stop_at("60").await;
    page.choose("plot", "P").await;
    assert_eq!(page.written("traced-across-0").await, "0.5");
    // The joint C is 4.5 along the rocker.
    page.write("traced-along-0", "4,5").await;
    page.write("traced-across-0", "0").await;
    for (name, place) in [
        ("out-P.x", 6.329_657_239_563_876),
        ("out-P.y", 4.487_908_878_799_026),
    ] {
        assert!((page.value(name).await - place).abs() < 1e-9, "{name}");
    }
    page.write("traced-along-0", "far").await;
    assert_eq!(
        page.attribute("traced-along-0", "aria-invalid")
            .await
            .as_deref(),
        Some("true")
    );
    page.press("traced-along-0", Key::Escape).await;
    assert_eq!(page.written("traced-along-0").await, "4.5");
    page.click("traced-remove-0").await;
    assert_eq!(page.count("[id^=traced-]").await, 0);
    page.close().await;
}
