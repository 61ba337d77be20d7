//! Masses and loads on the page: given in the settings, undone, refused with a sentence; reactions as arrows, table and plots.

use serde_json::json;

use crate::access::named_and_fits;
use crate::browser::Page;
use crate::gallery::open;
use crate::plots::texts;

/// Colours of reactions, weights and balancing torques, as the style sheet has them.
const REACTION: [u8; 3] = [0xC4, 0x16, 0x1C];
const WEIGHT: [u8; 3] = [0x6D, 0x5F, 0x00];
const TORQUE: [u8; 3] = [0x00, 0x73, 0x6B];

/// A linkage whose crank has a mass of 2 kg, under gravity, stopped at 40°.
async fn heavy() -> Page {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    page.stop_at("40").await;
    page.ask("document.querySelector('#fold-loads > summary').click()")
        .await;
    page.element("masses").await;
    page.until("fields", async || page.count("#gravity").await == 1)
        .await;
    page.choose("gravity", "down").await;
    page.write("field-masses-0-mass", "2").await;
    assert_eq!(page.text("problem").await, "");
    page
}

/// What a field shows.
async fn shown(page: &Page, id: &str) -> serde_json::Value {
    page.ask(&format!("return document.getElementById('{id}').value"))
        .await
}

#[tokio::test]
async fn masses_and_loads_are_given_undone_and_refused() {
    let page = heavy().await;
    // No body has a negative mass: the field and the notice say so, and the drawing stays.
    page.write("field-masses-0-mass", "-1").await;
    for id in ["problem", "mass-0-why"] {
        let said = page.text(id).await;
        assert!(said.contains("negative"), "{id}: {said}");
    }
    let invalid = page.attribute("field-masses-0-mass", "aria-invalid").await;
    assert_eq!(invalid.as_deref(), Some("true"));
    page.write("field-masses-0-mass", "2").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.text("mass-0-why").await, "");
    // A centre of mass is put on the link; the uniform bar takes it away.
    page.write("field-masses-0-along", "0.5").await;
    assert_eq!(shown(&page, "field-masses-0-along").await, json!("0.5"));
    page.click("mass-0-uniform").await;
    assert_ne!(shown(&page, "field-masses-0-along").await, json!("0.5"));
    page.click("load-add").await;
    assert_eq!(page.count("#load-0").await, 1);
    page.choose("load-0-kind", "torque").await;
    page.write("field-loads-0-value", "3.5").await;
    assert_eq!(page.text("problem").await, "");
    page.click("undo").await;
    page.click("undo").await;
    page.click("undo").await;
    assert_eq!(page.count("#load-0").await, 0);
    page.close().await;
}

#[tokio::test]
async fn reactions_are_arrows_a_table_and_plots() {
    let page = heavy().await;
    let plain = page.picture("mechanism").await;
    assert_eq!(plain.places(WEIGHT).count(), 0);
    page.click("forces").await;
    page.until("the table", async || {
        page.count("#reactions tbody").await == 4
    })
    .await;
    let drawn = page.picture("mechanism").await;
    for colour in [REACTION, WEIGHT, TORQUE] {
        let seen = drawn.places(colour).count();
        assert!(seen > 20, "{colour:?}: {seen}");
    }
    page.ask("document.querySelector('#legend summary').click()")
        .await;
    assert!(page.text("legend-entries").await.contains("reaction"));
    page.choose("plot", "crank.torque").await;
    page.settle().await;
    let said = texts(&page).await;
    assert!(said.iter().any(|text| text.contains("torque")), "{said:?}");
    page.choose("plot", "A.reaction_x|A.reaction_y").await;
    assert_eq!(page.text("problem").await, "");
    // The input of a greatest value is a press away.
    page.ask("document.querySelector('#drives .at').click()")
        .await;
    page.settle().await;
    assert_ne!(page.value("out-input").await, 40.0);
    named_and_fits(&page).await;
    page.close().await;
}

#[tokio::test]
async fn counterweights_are_added_once_and_undone() {
    let page = heavy().await;
    page.click("forces").await;
    page.choose("plot", "frame.shaking").await;
    assert_eq!(page.text("problem").await, "");
    page.click("balance").await;
    page.until("the counterweight of the crank", async || {
        page.count("#masses details").await == 4
    })
    .await;
    assert_eq!(page.text("balance-why").await, "");
    page.click("balance").await;
    page.until("the reason", async || {
        let said = page.text("balance-why").await;
        said.starts_with("Nothing to balance")
    })
    .await;
    page.click("undo").await;
    assert_eq!(page.count("#masses details").await, 3);
    assert_eq!(page.text("balance-why").await, "");
    page.screen((360, 740), 2.0).await;
    named_and_fits(&page).await;
    page.close().await;
}
