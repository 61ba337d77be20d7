//! Mechanisms of the gallery on the page: opened by mouse and by keys, drawn,
//! plotted, driven, edited, undone, saved in the address; what is broken is said.

mod dragged;

use std::collections::BTreeMap;

use assur::mechanism::Quantity;
use assur::{Point, Vector};
use assur_draw::{Figure, View};
use assur_file::{LinkageDocument, from_catalogue, gallery};
use assur_tests::exhaustive;
use thirtyfour::prelude::*;

use crate::browser::Page;
use crate::host::home;

/// Of some the structural formula as they are driven.
const FORMULAS: [(&str, &str); 2] = [
    ("slider-crank", "I(frame,crank) → II₂(rod,slider)"),
    (
        "watt-1",
        "I(frame,crank) → II₂(coupler,rocker) → II₂(EG,FG)",
    ),
];

pub(crate) fn document(name: &str) -> LinkageDocument {
    from_catalogue(name).unwrap().unwrap()
}

/// What the page says in English.
fn word(key: &str) -> String {
    let tables = [
        include_str!("../../lang/en.json"),
        include_str!("../../www/app/later.en.json"),
    ];
    let tables = tables.map(serde_json::from_str::<BTreeMap<String, String>>);
    let mut found = tables.iter().flatten().filter_map(|table| table.get(key));
    found.next().unwrap().clone()
}

/// What the gallery calls a mechanism.
fn called(name: &str) -> String {
    word(&format!("gallery.{name}"))
}

/// Whether this mechanism of the gallery is on the page, its structure said.
pub(crate) async fn shows(page: &Page, name: &str) -> bool {
    page.text("mechanism-name").await == called(name)
        && page.count("#out-formula").await > 0
        && !page.text("out-formula").await.is_empty()
}

pub(crate) async fn open(page: &Page, name: &str) {
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count(&format!("#gallery-{name}")).await == 1
    })
    .await;
    page.click(&format!("gallery-{name}")).await;
    page.until("the mechanism to open", async || shows(page, name).await)
        .await;
    page.settle().await;
}

/// What the page reads out of a quantity is what the engine says, with both
/// derivatives.
pub(crate) async fn agrees(page: &Page, document: &LinkageDocument, name: &str) {
    let motion = document.motion().unwrap();
    let mechanism = motion.mechanism();
    let phi = page.value("out-input").await;
    let pose = motion.pose::<3>(phi.to_radians()).unwrap();
    let quantity = Quantity::named(mechanism, name).unwrap();
    let jet = quantity.of(mechanism, &pose);
    for (order, stroke) in ["", "′", "″"].iter().enumerate() {
        let unit = if quantity.is_angle() && order == 0 {
            1f64.to_degrees()
        } else {
            1.0
        };
        let shown = page.value(&format!("out-{name}{stroke}")).await;
        let expected = jet.derivative(order) * unit;
        let off = (shown - expected).abs();
        assert!(
            off <= 1e-9 * expected.abs().max(1.0),
            "{name} {order}: {shown} {expected}"
        );
    }
}

/// How many pixels of the drawing have some colour of a link.
async fn coloured(page: &Page) -> f64 {
    pixels(page, "Math.max(r, g, b) - Math.min(r, g, b) > 90").await
}

/// The colours of the arrows on light paper.
const VELOCITY: [u8; 3] = [0xc2, 0x38, 0x7f];
const ACCELERATION: [u8; 3] = [0x4b, 0x4f, 0xc4];

/// How many pixels of the drawing have just this colour.
async fn of_colour(page: &Page, [red, green, blue]: [u8; 3]) -> f64 {
    let near =
        format!("Math.max(Math.abs(r - {red}), Math.abs(g - {green}), Math.abs(b - {blue})) < 8");
    pixels(page, &near).await
}

/// How many pixels of the drawing there are of which something holds.
async fn pixels(page: &Page, holds: &str) -> f64 {
    let count = page
        .ask(&format!(
            "const canvas = document.getElementById('mechanism');
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {{ willReadFrequently: true }});
        copy.drawImage(canvas, 0, 0);
        const {{ data }} = copy.getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let i = 0; i < data.length; i += 4) {{
            const [r, g, b] = data.subarray(i, i + 3);
            if ({holds}) count += 1;
        }}
        return count;"
        ))
        .await;
    count.as_f64().unwrap()
}

#[tokio::test]
async fn mechanisms_of_the_gallery_open() {
    let page = Page::open().await;
    page.stop_at("40").await;
    let step = if exhaustive() { 1 } else { 6 };
    for name in gallery().step_by(step) {
        open(&page, name).await;
        let document = document(name);
        let motion = document.motion().unwrap();
        let mechanism = motion.mechanism();
        let said = mechanism.formula();
        // The words call links as textbooks do.
        let called = said.replace("planet", &word("link.planet"));
        assert_eq!(page.text("out-formula").await, called);
        if let Some((_, formula)) = FORMULAS.iter().find(|(one, _)| *one == name) {
            assert_eq!(said, *formula);
        }
        // As many freedoms as drivers, whatever passive satellites take in the count.
        let drivers = document.drivers.len().to_string();
        assert_eq!(page.text("out-linkage-w").await, drivers, "{name}");
        assert_eq!(page.text("problem").await, "", "{name}");
        for quantity in document.plotted(mechanism, "angles").unwrap() {
            agrees(&page, &document, &quantity.name(mechanism, 0)).await;
        }
        assert!(coloured(&page).await > 400.0, "{name}");
        // Any angle and any point is plotted.
        let link = mechanism.links().last().unwrap();
        page.choose("plot", &format!("{link}.angle")).await;
        page.settle().await;
        agrees(&page, &document, &format!("{link}.angle")).await;
        let point = mechanism.points().nth(1).unwrap().to_owned();
        page.choose("plot", &point).await;
        page.settle().await;
        agrees(&page, &document, &format!("{point}.x")).await;
        agrees(&page, &document, &format!("{point}.y")).await;
    }
    // What belongs to the mixer alone is away, and comes back with it.
    let shown = async |id: &str| page.element(id).await.is_displayed().await.unwrap();
    for id in ["presets", "tab-lesson", "mesh-external", "out-grashof"] {
        assert!(!shown(id).await, "{id}");
    }
    page.click("gallery").await;
    page.until("the gallery", async || {
        page.count("#gallery-mixer-a").await == 1
    })
    .await;
    page.click("gallery-mixer-a").await;
    page.settle().await;
    for id in ["presets", "tab-lesson", "mesh-external", "out-grashof"] {
        assert!(shown(id).await, "{id}");
    }
    assert!(!shown("driver").await && !shown("out-formula").await);
    page.close().await;
}

#[tokio::test]
async fn a_mechanism_opens_by_keys_and_is_undone() {
    let page = Page::open().await;
    page.stop_at("75").await;
    let rocker = page.value("out-rocker.angle").await;
    page.focus("gallery").await;
    page.keys(Key::Enter + "").await;
    page.until("the gallery with the focus in it", async || {
        let focused = page.focused().await.unwrap_or_default();
        focused.starts_with("gallery-lesson")
    })
    .await;
    // Past the three rows of lessons is the first mechanism.
    page.keys(Key::Down + "").await;
    page.keys(Key::Down + "").await;
    page.keys(Key::Down + "").await;
    page.keys(Key::Enter + "").await;
    page.until("the first mechanism", async || {
        shows(&page, "crank-rocker").await
    })
    .await;
    page.focus("step-forward").await;
    page.keys(Key::Enter + "").await;
    page.settle().await;
    assert_eq!(page.value("out-input").await, 76.0);
    agrees(&page, &document("crank-rocker"), "rocker.angle").await;
    page.chord(&[Key::Control], 'z').await;
    page.settle().await;
    assert_eq!(page.text("mechanism-name").await, called("mixer-a"));
    page.stop_at("75").await;
    assert_eq!(page.value("out-rocker.angle").await, rocker);
    page.click("redo").await;
    page.settle().await;
    assert!(shows(&page, "crank-rocker").await);
    page.close().await;
}

/// What a machine tool is chosen by stands below the drawing, and what it is good for at its name.
#[tokio::test]
async fn strokes_and_time_ratios_are_said() {
    let page = Page::open().await;
    page.stop_at("40").await;
    for (name, stroke, ratio) in [
        ("whitworth", "2 (F.x)", "2.000 (F.x)"),
        ("shaper", "4.375 (F.x)", "1.507 (F.x); 1.507 (lever)"),
    ] {
        open(&page, name).await;
        assert_eq!(page.text("out-linkage-stroke").await, stroke);
        assert_eq!(page.text("out-linkage-time-ratio").await, ratio);
        let good = page
            .ask("return document.getElementById('mechanism-name').title")
            .await;
        assert_eq!(good.as_str(), Some(word(&format!("about.{name}")).as_str()));
    }
    page.close().await;
}

#[tokio::test]
async fn another_driver_is_another_structure() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "watt-1").await;
    let before = page.text("out-formula").await;
    page.choose("driver", "rocker").await;
    page.settle().await;
    let after = page.text("out-formula").await;
    assert!(
        after.starts_with("I(frame,rocker)") && after != before,
        "{after}"
    );
    // Driven by the rocker it swings between dead points, whose kinds are said.
    assert!(page.text("out-linkage-dead").await.contains("folded"));
    assert!(page.text("out-linkage-range").await.contains('…'));
    page.click("undo").await;
    page.settle().await;
    assert_eq!(page.text("out-formula").await, before);
    page.close().await;
}

#[tokio::test]
async fn lengths_and_the_crank_are_taken_in_hand() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "slider-crank").await;
    page.write("field-length-1", "2.5").await;
    page.settle().await;
    let mut longer = document("slider-crank");
    longer.links[1].length = Some(2.5);
    agrees(&page, &longer, "C.x").await;
    // It stays drawn where the lengths make no mechanism, and the reason is said.
    page.write("field-length-1", "-1").await;
    assert!(page.text("problem").await.contains("greater than zero"));
    agrees(&page, &longer, "C.x").await;
    page.write("field-length-1", "2.5").await;
    assert_eq!(page.text("problem").await, "");
    let phi = page.value("out-input").await;
    page.drag("slider-length-0", 0.5, 0.4).await;
    page.settle().await;
    assert_eq!(page.value("out-input").await, phi);
    page.close().await;
}

#[tokio::test]
async fn a_linkage_is_in_its_link_and_a_damaged_one_is_said() {
    let page = Page::open().await;
    page.stop_at("40").await;
    open(&page, "whitworth").await;
    page.choose("plot", "lever.angle").await;
    page.stop_at("33").await;
    page.until("the address to follow", async || {
        let address = page.address().await;
        address.contains("#whitworth&") && address.contains("v.phi_deg=33&")
    })
    .await;
    let link = page.address().await;
    page.anew(&link).await;
    page.until("the linkage, by its name", async || {
        shows(&page, "whitworth").await
    })
    .await;
    page.settle().await;
    assert_eq!(page.value("out-input").await, 33.0);
    agrees(&page, &document("whitworth"), "lever.angle").await;

    // Of a changed one all is in the link.
    page.write("field-length-0", "2.1").await;
    page.until("the whole address", async || {
        page.address().await.contains("kind=linkage")
    })
    .await;
    let link = page.address().await;
    let broken = link.replace("%22crank%22", "%22crunk%22");
    assert_ne!(broken, link);
    page.anew(home()).await;
    page.anew(&broken).await;
    assert!(
        page.text("notice-text")
            .await
            .contains("could not be opened")
    );
    page.close().await;
}
