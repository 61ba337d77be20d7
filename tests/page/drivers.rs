//! A linkage with two driven cranks on the page: the rate of the second is a field.

use assur::mechanism::{LinkageSpec, Mechanism};
use assur::motion::Motion;
use assur_file::{Document, LinkageDocument};
use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};
use serde_json::Value;

use crate::browser::Page;
use crate::host::home;

/// A five-bar with a crank at each end.
fn five_bar() -> LinkageSpec {
    LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.5, 0.3)
        .point("C", 1.6, 2.2)
        .point("D", 2.8, 0.5)
        .point("E", 3.0, 0.0)
        .fixed(&["A", "E"])
        .bar("AB", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("CD", &["C", "D"])
        .bar("ED", &["E", "D"])
        .crank("AB")
        .crank("ED")
        .at_rate(-1.0)
}

/// The document as an address has it.
fn address() -> String {
    let mut document = LinkageDocument::new(&five_bar());
    document.plots = vec!["BC.angle".to_owned()];
    let document = serde_json::to_value(Document::Linkage(document)).unwrap();
    let parts = document["document"].as_object().unwrap().iter();
    let written = |(key, value): (&String, &Value)| {
        let value = value.to_string();
        format!("&d.{key}={}", utf8_percent_encode(&value, NON_ALPHANUMERIC))
    };
    let parts: String = parts.map(written).collect();
    format!(
        "#2&kind=linkage{parts}&v.phi_deg=40&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en"
    )
}

#[tokio::test]
async fn a_second_crank_has_a_rate() {
    let page = Page::open_at(&format!("{}{}", home(), address()), "en-US").await;
    page.until("the five-bar", async || {
        page.count("#out-linkage-w").await > 0 && page.text("out-linkage-w").await == "2"
    })
    .await;
    // At an angle, as the engine has it; and over the whole cycle.
    let agrees = async |rate: f64| {
        let motion = Motion::new(Mechanism::new(&five_bar().at_rate(rate)).unwrap());
        let mechanism = motion.mechanism();
        let link = mechanism.link("BC").unwrap();
        let pose = motion.pose::<1>(40.0_f64.to_radians()).unwrap();
        let expected = mechanism.angle(&pose, link).value().to_degrees();
        let shown = page.value("out-BC.angle").await;
        let off = (shown - expected).rem_euclid(360.0);
        assert!(off.min(360.0 - off) < 0.01, "{rate}: {shown} {expected}");
    };
    // The way of the scrubber, in degrees.
    let turns = async || {
        let most = page.attribute("scrubber", "max").await.unwrap();
        most.parse::<f64>().unwrap() / 360.0
    };
    agrees(-1.0).await;
    page.stop_at("40").await;
    assert_eq!(turns().await, 1.0);

    // What would not repeat is refused at its row, and the drawing stays.
    let put =
        "const box = document.getElementById('field-rate-2'); box.focus(); box.value = '0.333';
        box.dispatchEvent(new Event('input', { bubbles: true }));";
    page.ask(put).await;
    page.settle().await;
    assert!(page.text("problem").await.contains("24 turns"));
    agrees(-1.0).await;
    page.press("field-rate-2", thirtyfour::prelude::Key::Escape)
        .await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");

    // Another rate goes on from the pose at hand, and the motion takes two turns.
    page.write("field-rate-2", "0.5").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    agrees(-1.0).await;
    assert_eq!(turns().await, 2.0);
    page.click("undo").await;
    page.settle().await;
    assert_eq!(turns().await, 1.0);
    page.close().await;
}
