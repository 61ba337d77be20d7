//! Dimensions of a linkage on the page: what a change keeps is followed from the pose at
//! hand, what cannot be is refused at its row with the last value that works.

use assur::mechanism::{Dimension, Mechanism};
use assur::motion::Changed;
use assur_file::LinkageDocument;
use thirtyfour::prelude::*;

use crate::assemblies::{follow, followed};
use crate::browser::Page;
use crate::gallery::{agrees, document, open};

/// The linkage after a change of a dimension from an input, in degrees; an angle in radians.
fn changed(name: &str, of: impl Fn(&Mechanism) -> Dimension, value: f64, degrees: f64) -> Changed {
    let motion = document(name).motion().unwrap();
    let changed = motion.changed(of(motion.mechanism()), value, degrees.to_radians());
    changed.unwrap()
}

/// The length of a link.
fn length(link: &str) -> impl Fn(&Mechanism) -> Dimension {
    move |mechanism| Dimension::Length(mechanism.link(link).unwrap())
}

fn drawn(changed: &Changed) -> LinkageDocument {
    LinkageDocument::new(changed.motion.mechanism().spec())
}

/// Values far from the drawing, and one at which the crank has to give way.
#[tokio::test]
async fn a_slider_goes_all_its_way() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "slider-crank").await;
    page.stop_at("40").await;
    for (field, link, typed) in [(1, "rod", "4.5"), (1, "rod", "6"), (0, "crank", "3")] {
        page.write(&format!("field-length-{field}"), typed).await;
        page.settle().await;
        assert_eq!(page.text("problem").await, "");
        assert_eq!(page.value("out-input").await, 40.0);
        let value: f64 = typed.parse().unwrap();
        agrees(
            &page,
            &drawn(&changed("slider-crank", length(link), value, 40.0)),
            "C.x",
        )
        .await;
        page.click("undo").await;
        page.settle().await;
    }
    agrees(&page, &document("slider-crank"), "C.x").await;
    // The slider to both of its ends.
    page.press("slider-length-1", Key::End).await;
    page.settle().await;
    agrees(
        &page,
        &drawn(&changed("slider-crank", length("rod"), 6.0, 40.0)),
        "C.x",
    )
    .await;
    page.press("slider-length-1", Key::Home).await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    let given = page.value("out-input").await.to_radians().sin();
    assert!(given < 0.15 && given > 0.12, "{given}");
    page.close().await;
}

type Of = fn(&Mechanism) -> Dimension;

/// The distance of the coupler's third point from its first.
fn side(mechanism: &Mechanism) -> Dimension {
    Dimension::Side(mechanism.link("coupler").unwrap(), [0, 2])
}

/// The coupler's angle at its first point.
fn corner(mechanism: &Mechanism) -> Dimension {
    Dimension::Corner(mechanism.link("coupler").unwrap(), 2)
}

/// The offset of the first slide.
fn offset(mechanism: &Mechanism) -> Dimension {
    let mut dimensions = mechanism.dimensions().into_iter();
    let offset = dimensions.find(|one| matches!(one, Dimension::Offset(_)));
    offset.unwrap()
}

/// Fields of a side and an angle of a link with three points, and of the offset of a slide: the page shows the values of the engine.
#[tokio::test]
async fn sides_angles_and_offsets_are_typed() {
    let page = Page::open().await;
    page.stop_at("40").await;
    let all: [(_, _, _, _, f64, Of); 3] = [
        ("crank-rocker", "M", "side-1-0-2", "3", 3.0, side),
        (
            "crank-rocker",
            "M",
            "corner-1-2",
            "50",
            50_f64.to_radians(),
            corner,
        ),
        ("slider-crank-offset", "C", "offset-0", "0.4", 0.4, offset),
    ];
    for (name, point, field, typed, value, of) in all {
        open(&page, name).await;
        page.choose("plot", point).await;
        page.stop_at("40").await;
        page.write(&format!("field-{field}"), typed).await;
        page.settle().await;
        assert_eq!(page.text("problem").await, "", "{field}");
        assert_eq!(page.value("out-input").await, 40.0, "{field}");
        let drawn = drawn(&changed(name, of, value, 40.0));
        for axis in ["x", "y"] {
            agrees(&page, &drawn, &format!("{point}.{axis}")).await;
        }
    }
    // Crank and rod are not long enough for this one.
    page.write("field-offset-0", "9").await;
    page.settle().await;
    let said = page.text("problem").await;
    for part in ["Offset of link slider", "is too large by"] {
        assert!(said.contains(part), "{said}");
    }
    let invalid = page.attribute("field-offset-0", "aria-invalid").await;
    assert_eq!(invalid.as_deref(), Some("true"));
    page.close().await;
}

/// The last good drawing stays, the sentence says how far it went, and the row is marked
/// until it has a value that works.
#[tokio::test]
async fn what_cannot_be_is_refused_at_its_row() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "stephenson-1").await;
    page.choose("plot", "G").await;
    page.stop_at("40").await;
    let place = page.value("out-G.x").await;
    page.press("slider-length-3", Key::Home).await;
    page.settle().await;
    let said = page.text("problem").await;
    for part in [
        "Length of link EG is too short by",
        "can no longer be joined: EG, FG",
        "is 0.7",
    ] {
        assert!(said.contains(part), "{said}");
    }
    assert_eq!(page.written("field-length-3").await, "0.21");
    assert_eq!(
        page.attribute("field-length-3", "aria-invalid")
            .await
            .as_deref(),
        Some("true")
    );
    assert_eq!(page.value("out-G.x").await, place);
    // What it says works.
    let last = said.trim_end_matches('.').rsplit(' ').next().unwrap();
    page.write("field-length-3", last).await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.written("field-length-3").await, last);
    page.close().await;
}

/// Another driver begins with the pose at hand.
#[tokio::test]
async fn another_driver_keeps_the_pose() {
    let page = Page::open().await;
    page.stop_at("40").await;
    let four = [("75", "CD"), ("200", "HGL"), ("310", "CD")];
    let watt = [("75", "rocker"), ("200", "rocker"), ("310", "rocker")];
    for (name, point, crank, drivers) in [
        ("class4-dwell", "L", "AB", four),
        ("watt-1", "G", "crank", watt),
    ] {
        open(&page, name).await;
        page.choose("plot", point).await;
        let ids = ["x", "y"].map(|axis| format!("out-{point}.{axis}"));
        for (degrees, driver) in drivers {
            page.choose("driver", crank).await;
            page.stop_at(degrees).await;
            let places = [page.value(&ids[0]).await, page.value(&ids[1]).await];
            page.choose("driver", driver).await;
            page.settle().await;
            assert_eq!(page.text("problem").await, "");
            let formula = page.text("out-formula").await;
            assert!(formula.contains(&format!("I(frame,{driver})")), "{formula}");
            for (id, place) in ids.iter().zip(places) {
                let off = (page.value(id).await - place).abs();
                assert!(off < 1e-9, "{name} {degrees} {driver}: {off:e}");
            }
        }
    }
    page.close().await;
}

/// An assembly is saved as its drawing: the address opens it again, and names no number.
#[tokio::test]
async fn an_assembly_is_saved_as_it_is_drawn() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "watt-1").await;
    page.choose("plot", "G").await;
    page.stop_at("40").await;
    let first = page.value("out-G.y").await;
    page.until("the address", async || {
        let address = page.address().await;
        address.contains("v.phi_deg=40&") && address.contains("v.plot=G")
    })
    .await;
    follow(&page, 2).await;
    page.settle().await;
    assert_eq!(followed(&page).await, "2");
    let second = page.value("out-G.y").await;
    assert!((second - first).abs() > 0.1);
    page.until("another address", async || {
        page.address().await.contains("d.points")
    })
    .await;
    assert!(!page.address().await.contains("assembly"));
    page.reload().await;
    page.until("the mechanism", async || {
        page.count("#linkage-lengths").await == 1
    })
    .await;
    page.settle().await;
    assert_eq!(followed(&page).await, "2");
    assert!((page.value("out-G.y").await - second).abs() < 1e-12);

    // A key does what the list does, in one step; that of the drawn assembly is none.
    let before = page.address().await;
    page.keys("1").await;
    page.keys("1").await;
    assert_eq!(followed(&page).await, "1");
    assert!((page.value("out-G.y").await - first).abs() < 1e-9);
    page.until("the address of the first", async || {
        page.address().await != before
    })
    .await;
    assert!(!page.address().await.contains("assembly"));
    page.chord(&[Key::Control], 'z').await;
    assert_eq!(followed(&page).await, "2");
    page.close().await;
}

/// The colour of a length is that of its link, also when another link is driven.
#[tokio::test]
async fn colours_follow_the_driver() {
    let url = format!("{}#stephenson-3&v.playing=false", crate::host::home());
    let page = Page::open_at(&url, "en-US").await;
    let cranks = async || {
        let script = "return [...document.querySelectorAll('#linkage-lengths .row')]
            .filter(({ style }) => style.getPropertyValue('--accent').trim() === 'var(--role-crank)').map(({ dataset }) => dataset.field)";
        let found: Vec<String> = serde_json::from_value(page.ask(script).await).unwrap();
        found
    };
    page.until("the lengths", async || {
        page.count("#linkage-lengths .row").await > 0
    })
    .await;
    assert_eq!(cranks().await, ["links[0].length"]);
    page.choose("driver", "rocker").await;
    page.settle().await;
    let rocker = "return document.querySelector('#driver').selectedIndex";
    assert_ne!(page.ask(rocker).await, 0);
    let now = cranks().await;
    assert_eq!(now.len(), 1);
    assert_ne!(now, ["links[0].length"]);
    page.close().await;
}
