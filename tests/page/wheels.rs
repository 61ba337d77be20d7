//! Several peripheral wheels: put up, set, named when at fault, taken away.

use std::f64::consts::TAU;

use assur::Point;
use assur::gears::Mate;
use assur::mixer::{Case, Dimensions, Mixer};
use assur_tests::{Rocker, assert_near, scaled_swing};
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::hands::View;
use crate::host::home;

const WHEEL6: [u8; 3] = [0xB2, 0x6A, 0x00];

fn with_wheels(wheels: &[(f64, f64)]) -> Dimensions {
    let mate = |(teeth, degrees): &(f64, f64)| Mate {
        teeth: *teeth,
        centre_line: degrees.to_radians(),
    };
    Dimensions {
        wheels: wheels.iter().map(mate).collect(),
        ..Case::A.dimensions()
    }
}

/// What is shown of every wheel, against the engine.
async fn check(page: &Page, wheels: &[(f64, f64)]) {
    let mixer = Mixer::new(&with_wheels(wheels)).unwrap();
    let crank = page.value("out-input").await.to_radians();
    let pose = mixer.linkage.pose::<3>(mixer.assembly, crank).unwrap();
    let swing = mixer.linkage.swings(mixer.assembly)[0];
    let travel = mixer.linkage.travels(mixer.assembly)[0];
    let turns = page.text("out-turns").await;
    assert_eq!(turns.split("; ").count(), wheels.len(), "{turns}");
    for (index, pair) in mixer.gears.pairs().iter().enumerate() {
        let name = format!("wheel{}", index + 5);
        let driven = pair.driven(pose.rocker);
        for (order, stroke) in ["", "′", "″"].into_iter().enumerate() {
            let shown = page.value(&format!("out-{name}.angle{stroke}")).await;
            let expected = driven.derivative(order);
            let shown = if order == 0 {
                shown.to_radians()
            } else {
                shown
            };
            assert_near(shown, expected, 1e-9, &name);
        }
        let stroke = scaled_swing(swing, pair.ratio())
            .stroke()
            .unwrap()
            .to_degrees();
        let shown = page.value(&format!("out-swing-{name}")).await;
        assert_near(shown, stroke, 1e-9, &name);
        let turned = format!("{:.3}", travel * pair.ratio().abs() / TAU);
        assert_eq!(turns.split("; ").nth(index), Some(turned.as_str()));
    }
}

#[tokio::test]
async fn wheels_are_put_up_and_taken_away() {
    let page = Page::open().await;
    page.stop_at("75").await;
    check(&page, &[(18.0, -40.0)]).await;
    assert_eq!(page.count("#wheels-remove-5[hidden]").await, 1);
    assert_eq!(page.picture("mechanism").await.places(WHEEL6).count(), 0);

    // Opposite wheel 5 there is most room.
    page.click("wheels-add").await;
    page.hover("mechanism", (9.0, 9.0)).await;
    let wheels = [(18.0, -40.0), (18.0, 140.0)];
    assert_eq!(page.written("field-beta6").await, "140°");
    check(&page, &wheels).await;
    let dimensions = with_wheels(&wheels);
    let mixer = Mixer::new(&dimensions).unwrap();
    let centre = Point::new(0.85, 0.0) + mixer.gears.pairs()[1].driven_wheel().centre;
    let (x, y) = View::showing(&page, &dimensions).await.at(centre);
    // Where the coupler does not lie over it.
    page.stop_at("100").await;
    page.hover("mechanism", (9.0, 9.0)).await;
    let seen = page.picture("mechanism").await.cloud(WHEEL6);
    assert!(seen.count > 200, "{seen:?}");
    assert!((seen.x - x).hypot(seen.y - y) < 4.0, "{seen:?} {x} {y}");
    page.stop_at("75").await;

    page.write("field-z6", "24").await;
    page.write("field-beta6", "-10").await;
    check(&page, &[(18.0, -40.0), (24.0, -10.0)]).await;
    // Their teeth would pass through each other: that is said, and drawn.
    assert!(page.text("out-overlaps").await.contains("5 and 6"));
    assert_eq!(page.text("problem").await, "");
    page.write("field-beta6", "100,5").await;
    assert_eq!(page.text("out-overlaps").await, "");

    for _ in 0..4 {
        page.click("wheels-add").await;
    }
    assert!(!page.element("wheels-add").await.is_enabled().await.unwrap());
    assert_eq!(page.text("out-turns").await.split("; ").count(), 6);
    assert_eq!(page.text("problem").await, "");
    for _ in 0..4 {
        page.click("undo").await;
    }
    check(&page, &[(18.0, -40.0), (24.0, 100.5)]).await;

    page.click("wheels-remove-5").await;
    check(&page, &[(24.0, 100.5)]).await;
    page.click("undo").await;
    check(&page, &[(18.0, -40.0), (24.0, 100.5)]).await;
    page.click("preset-a").await;
    check(&page, &[(18.0, -40.0)]).await;
    let pressed = page.attribute("preset-a", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    page.close().await;
}

#[tokio::test]
async fn a_bad_wheel_is_named() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.click("wheels-add").await;
    page.click("wheels-add").await;
    let good = page.picture("mechanism").await;
    for (field, text, back) in [("field-z7", "1.5", "18"), ("field-beta7", "x", "50")] {
        let before = page.written(field).await;
        page.write(field, text).await;
        let sentence = page.text("problem").await;
        assert!(sentence.contains("Wheel 7"), "{sentence}");
        let invalid = page.attribute(field, "aria-invalid").await;
        assert_eq!(invalid.as_deref(), Some("true"));
        let back = if field == "field-z7" { back } else { &before };
        page.write(field, back).await;
        assert_eq!(page.text("problem").await, "");
    }
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&good) < 20);
    // A ring to one of them cannot be inside of another.
    page.click("mesh-internal").await;
    page.write("field-z6", "60").await;
    assert!(page.text("problem").await.contains("Wheel 6"));
    page.choose("lang", "ru").await;
    page.until("Russian", async || {
        page.text("problem").await.contains("Колесо 6")
    })
    .await;
    page.close().await;
}

#[tokio::test]
async fn wheels_by_keyboard_alone() {
    let page = Page::playing().await;
    page.keys(" ").await;
    page.focus("wheels-add").await;
    page.keys(Key::Enter + "").await;
    page.focus("slider-z6").await;
    page.keys(Key::Right + "").await;
    assert_eq!(page.written("field-z6").await, "19");
    page.focus("wheels-remove-6").await;
    page.keys(Key::Enter + "").await;
    // The button is gone; the focus is not.
    let focused = page.ask("return document.activeElement.id").await;
    assert_eq!(focused.as_str(), Some("wheels-add"));
    check(&page, &[(18.0, -40.0)]).await;
    page.close().await;
}

#[tokio::test]
async fn wheels_travel_by_link() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.click("wheels-add").await;
    page.write("field-z6", "12").await;
    page.until("the address to follow", async || {
        page.address().await.contains("%22z%22:12") || page.address().await.contains("%3A12")
    })
    .await;
    let link = page.address().await;
    assert!(!link.contains("d.z5"), "{link}");
    page.anew(&link).await;
    check(&page, &[(18.0, -40.0), (12.0, 140.0)]).await;
    // And what the first version wrote opens as one wheel.
    let older = "#1&lesson=mixer&d.l1=0.37&d.l2=0.85&d.l3=0.55&d.l4=0.85&d.z4=36&d.z5=24\
        &d.mesh=external&d.module=0.0165&d.centre_line_deg=10&d.assembly=1&v.phi_deg=75\
        &v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";
    page.anew(&format!("{}{older}", home())).await;
    assert_eq!(page.text("notice-text").await, "");
    check(&page, &[(24.0, 10.0)]).await;
    page.close().await;
}

/// Where the crank stands at an angle without a pose, a wheel is added all the same: the new
/// mechanism is drawn in a place of its own.
#[tokio::test]
async fn a_wheel_is_added_where_there_is_no_pose() {
    let page = Page::open().await;
    page.stop_at("170").await;
    page.write("field-l1", "1.3").await;
    assert_ne!(page.text("problem").await, "");
    page.click("wheels-add").await;
    page.settle().await;
    assert!(page.element("field-z6").await.is_displayed().await.unwrap());
    page.click("wheels-remove-6").await;
    page.settle().await;
    page.click("undo").await;
    page.settle().await;
    // Nothing has been said on the console.
    page.close().await;
}
