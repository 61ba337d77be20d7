//! A differential for the ear, the finger and the small screen, in every language.

use std::collections::BTreeSet;

use assur_file::GearTrainDocument;
use serde_json::json;

use crate::access::{AXE, check};
use crate::browser::Page;
use crate::device::languages;
use crate::gear_train::{document, open};
use crate::gear_train_load::unfold;
use crate::layout::defects;

fn loaded() -> GearTrainDocument {
    GearTrainDocument {
        loaded: true,
        ..document("train-magnets")
    }
}

async fn said(page: &Page, id: &str) -> String {
    let script = format!("return document.getElementById('{id}').textContent");
    page.ask(&script).await.as_str().unwrap().to_owned()
}

/// At rest time, angles and speeds are told; under load what has slipped.
#[tokio::test]
async fn it_is_told() {
    let page = open(&document("train-magnets"), 2.0).await;
    page.until("a description", async || {
        said(&page, "mechanism-description").await.contains("2.0 s")
    })
    .await;
    let told = said(&page, "mechanism-description").await;
    assert!(told.contains("sun 720.0°"), "{told}");
    page.until("the speeds", async || {
        said(&page, "train-description").await.contains("27.24")
    })
    .await;
    let told = said(&page, "train-description").await;
    assert!(
        told.contains("Sun 60") && told.contains("ring 12"),
        "{told}"
    );
    let plots = said(&page, "charts-description").await;
    assert!(plots.contains("0.0 s to 6.0 s"), "{plots}");
    page.click("step-forward").await;
    page.until("the step", async || {
        said(&page, "announcement").await.contains("2.1 s")
    })
    .await;
    page.click("field-loaded").await;
    page.write("field-load", "15").await;
    page.until("the slips", async || {
        said(&page, "train-description")
            .await
            .contains("Slipped periods")
    })
    .await;
    for lang in languages(2) {
        page.speak(lang).await;
        page.settle().await;
        for id in [
            "mechanism-description",
            "train-description",
            "charts-description",
        ] {
            let told = said(&page, id).await;
            assert!(told.len() > 20 && !told.contains('{'), "{lang}: {told}");
        }
    }
    page.close().await;
}

/// Every control has a name of its own in every language, no key is shown raw, nothing is cut or covered on a phone.
#[tokio::test]
async fn in_every_language_on_a_phone() {
    let mut not_to_be_built = document("train-magnets");
    not_to_be_built.z4 = 44.0;
    for document in [loaded(), not_to_be_built] {
        read_on_a_phone(&document).await;
    }
}

async fn read_on_a_phone(document: &GearTrainDocument) {
    let page = open(document, 2.0).await;
    unfold(&page).await;
    page.touched().await;
    let mut texts = BTreeSet::new();
    let mut found = Vec::new();
    for lang in languages(3) {
        page.speak(lang).await;
        for size in [(360, 640), (1280, 800)] {
            page.screen(size, 1.0).await;
            found.push((format!("{lang} {size:?}"), defects(&page, 44).await));
        }
        let script = "return [...document.querySelectorAll('[data-of=gear-train]')].map((one) => one.innerText).join(' ')";
        let text = page.ask(script).await.as_str().unwrap().to_owned();
        let keys = [
            "drives.",
            "form.",
            "coupling.",
            "poles.",
            "member.",
            "observer.",
            "condition.",
            "energy.",
            "field.",
            "name.",
            "status.",
            "link.",
            "{",
        ];
        assert!(keys.iter().all(|key| !text.contains(key)), "{lang}: {text}");
        assert!(text.len() > 400 && texts.insert(text), "{lang}");
        let nameless = "return [...document.querySelectorAll('[data-of=gear-train] :is(input, select, button)')]
            .filter((one) => !(one.ariaLabel || one.innerText || one.labels?.[0]?.innerText)).map((one) => one.id)";
        assert_eq!(page.ask(nameless).await, json!([]), "{lang}");
        let twice =
            "const names = [...document.querySelectorAll('[data-of=gear-train] input[aria-label]')]
            .filter((one) => one.checkVisibility()).map((one) => one.ariaLabel);
            return names.filter((one, i) => names.indexOf(one) !== i || one.includes('{'))";
        assert_eq!(page.ask(twice).await, json!([]), "{lang}");
    }
    found.retain(|(_, defects)| *defects != json!([]));
    assert!(found.is_empty(), "{found:#?}");
    page.close().await;
}

/// What axe finds where all of it is unfolded: nothing, in light, in dark and on a phone.
#[tokio::test]
async fn axe_finds_nothing_in_trains() {
    let mut tied = document("train-magnets");
    tied.drives[1].to = Some(assur_file::ShaftDocument::Sun);
    tied.z4 = 44.0;
    for (name, document) in [("loaded", loaded()), ("tied", tied)] {
        let page = open(&document, 2.0).await;
        page.ask(AXE).await;
        unfold(&page).await;
        for scheme in ["light", "dark"] {
            page.prefer("prefers-color-scheme", scheme).await;
            check(&page, &format!("{name} {scheme}")).await;
        }
        page.screen((360, 640), 1.0).await;
        check(&page, &format!("{name} narrow")).await;
        page.close().await;
    }
}

/// By fingers: it is held, tied, seen from elsewhere, loaded; the scrubber is slid.
#[tokio::test]
async fn fingers_do_all() {
    let page = open(&document("train-magnets"), 2.0).await;
    page.touched().await;
    page.screen((390, 844), 2.0).await;
    let tap = async |id: &str| {
        page.ask(&format!(
            "document.getElementById('{id}').scrollIntoView({{ block: 'end', behavior: 'instant' }})"
        ))
        .await;
        page.settle().await;
        page.tap(id).await;
        page.settle().await;
    };
    tap("train-hold-2").await;
    assert_eq!(page.value("out-train-ring").await, 0.0);
    tap("train-tie-2").await;
    assert_eq!(page.value("out-train-ring").await, 60.0);
    tap("undo").await;
    tap("observer-carrier").await;
    assert_eq!(page.value("out-carrier.angle").await, 0.0);
    tap("field-loaded").await;
    assert_eq!(page.written("plot").await, "load");
    assert_eq!(page.text("problem").await, "");
    page.ask(
        "document.getElementById('scrubber').scrollIntoView({ block: 'end', behavior: 'instant' })",
    )
    .await;
    page.settle().await;
    let area = page.element("scrubber").await.rect().await.unwrap();
    let way: Vec<_> = [0.02, 0.2, 0.4, 0.5]
        .iter()
        .map(|part| vec![(part * area.width, area.height / 2.0)])
        .collect();
    page.fingers("scrubber", &way).await;
    let time = page.value("out-input").await;
    assert!((time - 3.0).abs() < 0.3, "{time}");
    page.close().await;
}
