//! A differential kept, saved and exported, and exchanged for what is of another kind.

use std::f64::consts::TAU;

use assur_file::{DriveDocument, ObserverDocument};
use assur_tests::assert_near;
use roxmltree::Document;
use serde_json::json;

use crate::browser::Page;
use crate::export::{Csv, open_dialog, save_text};
use crate::gear_train::{agrees, document, open, playing, there};

/// Opened again and from a file it is the same; what was changed is undone by reset.
#[tokio::test]
async fn it_is_kept_saved_and_reset() {
    let mut wanted = document("train-magnets");
    wanted.origin = Some("train-magnets".to_owned());
    let page = open(&wanted, 2.0).await;
    page.write("field-rpm-2", "-20").await;
    page.click("observer-ring").await;
    page.choose("field-members\\.carrier", "propeller").await;
    wanted.drives[1] = DriveDocument {
        rpm: -20.0,
        ..wanted.drives[1].clone()
    };
    wanted.observer = ObserverDocument::Ring;
    agrees(&page, &wanted).await;
    page.until("the address to follow", async || {
        page.address().await.contains("propeller")
    })
    .await;
    page.reload().await;
    there(&page).await;
    agrees(&page, &wanted).await;
    assert_eq!(page.value("out-input").await, 2.0);
    assert_eq!(page.written("field-members.carrier").await, "propeller");

    page.click("menu").await;
    page.click("save").await;
    let saved = page.downloads().join("train-magnets.assur.json");
    page.until("the file", async || saved.exists()).await;
    page.click("menu").await;
    page.click("reset").await;
    agrees(&page, &document("train-magnets")).await;
    page.choose_file("file", &saved).await;
    page.until("the file to be open", async || {
        page.written("field-members.carrier").await == "propeller"
    })
    .await;
    agrees(&page, &wanted).await;
    page.close().await;
}

/// From kind to kind while it plays: the transport counts in the unit of what moves, and real time is offered to cranks only.
#[tokio::test]
async fn kinds_change_while_it_plays() {
    let page = Page::open().await;
    for (name, symbol, real) in [
        ("train-magnets", "t", false),
        ("watt-1", "φ₁", true),
        ("train-bevel", "t", false),
        ("mobility-3", "", false),
        ("train-stepped", "t", false),
        ("mixer-b", "φ₁", true),
    ] {
        page.click("gallery").await;
        page.until("the gallery", async || {
            page.count(&format!("#gallery-{name}")).await == 1
        })
        .await;
        page.click(&format!("gallery-{name}")).await;
        page.until(name, async || {
            page.count("#gallery-dialog[open]").await == 0
        })
        .await;
        page.settle().await;
        if symbol.is_empty() {
            continue;
        }
        page.until(name, async || page.text("input-symbol").await == symbol)
            .await;
        let hidden = "return document.querySelector('#speed option[value=true_time]').hidden";
        assert_eq!(page.ask(hidden).await, json!(!real), "{name}");
        // A scheme does not move: it leaves the motion at rest.
        if !playing(&page).await {
            page.click("play").await;
        }
        assert_eq!(page.text("problem").await, "", "{name}");
        let from = page.value("out-input").await;
        page.until("it to move", async || page.value("out-input").await != from)
            .await;
    }
    page.close().await;
}

/// The table has the numbers of the engine at each time; drawing and plots are saved as pictures.
#[tokio::test]
async fn it_is_exported() {
    let page = open(&document("train-magnets"), 2.0).await;
    open_dialog(&page).await;
    let csv = Csv::save(&page, "assur-train-magnets.csv").await;
    let turning = document("train-magnets").train().unwrap().turning;
    assert!(csv.rows.len() > 60, "{}", csv.rows.len());
    for row in 0..csv.rows.len() {
        let time = csv.value(row, "t");
        let turned = turning.at(time);
        for (body, name) in ["sun", "satellite", "carrier", "ring"].iter().enumerate() {
            let angle = turned.angles[body];
            let angle = angle.turns() as f64 * TAU + angle.part();
            let what = format!("{name} at {time} s");
            assert_near(csv.value(row, &format!("{name}.angle")), angle, 1e-9, &what);
            let speed = csv.value(row, &format!("{name}.dangle"));
            assert_near(speed, turned.speeds[body], 1e-12, &what);
        }
    }
    for picture in ["drawing", "plots"] {
        let name = format!("assur-train-magnets-{picture}.svg");
        let svg = save_text(&page, &format!("export-{picture}-svg"), &name).await;
        let svg = Document::parse(&svg).unwrap();
        let texts: Vec<&str> = svg.descendants().filter_map(|one| one.text()).collect();
        assert!(texts.len() > 5, "{texts:?}");
        page.click(&format!("export-{picture}-png")).await;
        let png = page
            .saved(&format!("assur-train-magnets-{picture}.png"))
            .await;
        assert!(png.len() > 5000, "{picture}");
    }
    page.close().await;
}
