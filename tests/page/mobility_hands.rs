//! Schemes by mouse, finger and keys, for the ear and as a file.

use std::collections::BTreeSet;

use assur::mobility::Scheme;
use roxmltree::Document;
use thirtyfour::prelude::*;

use crate::export::{open_dialog, save_text};
use crate::mobility::{cuts, document, open, scheme, with_cuts};

fn names(scheme: &Scheme) -> BTreeSet<String> {
    let pairs = scheme.pairs().iter();
    pairs.map(|pair| pair.name.clone()).collect()
}

/// A press cuts a pair in the drawing, each pair can be pressed; undo joins it again.
#[tokio::test]
async fn pairs_are_cut_in_the_drawing() {
    let page = open(&with_cuts("mobility-2c", &[])).await;
    page.prefer("prefers-reduced-motion", "reduce").await;
    let mut pressed = BTreeSet::new();
    for place in page.handles().await {
        page.drag_along("mechanism", &[place]).await;
        let cut = cuts(&page).await;
        // A control may lie over the drawing there.
        assert!(cut.len() <= 1, "{place:?} {cut:?}");
        if !cut.is_empty() {
            pressed.extend(cut);
            page.click("undo").await;
            assert!(cuts(&page).await.is_empty());
        }
    }
    assert_eq!(pressed, names(&scheme("mobility-2c")));
    page.close().await;
}

/// A finger cuts a pair, and joins it again where it then is.
#[tokio::test]
async fn a_finger_cuts_a_pair() {
    let page = open(&with_cuts("mobility-2a", &[])).await;
    page.prefer("prefers-reduced-motion", "reduce").await;
    page.touched().await;
    page.screen((390, 844), 2.0).await;
    page.ask("document.getElementById('mechanism').scrollIntoView({ block: 'end', behavior: 'instant' })")
        .await;
    page.settle().await;
    let all = page.handles().await;
    let mut found = BTreeSet::new();
    for place in all {
        page.fingers("mechanism", &[vec![place]]).await;
        page.settle().await;
        let cut = cuts(&page).await;
        assert!(cut.len() <= 1, "{place:?} {cut:?}");
        if !cut.is_empty() {
            found.extend(cut);
            page.click("cut-join").await;
            page.ask("document.getElementById('mechanism').scrollIntoView({ block: 'end', behavior: 'instant' })")
                .await;
            page.settle().await;
        }
    }
    assert_eq!(found, names(&scheme("mobility-2a")));
    page.close().await;
}

/// By keys a pair is cut in the table; what is drawn is told, and what is cut.
#[tokio::test]
async fn a_key_cuts_a_pair_and_it_is_told() {
    let page = open(&with_cuts("mobility-2a", &[])).await;
    let counts = scheme("mobility-2a").counts();
    let mobility = counts.mobility();
    let told = page.text("mechanism-description").await;
    let (links, q) = (counts.links, counts.redundant(mobility));
    let expected = format!("{links} moving links and 4 pairs; W = {mobility}, q = {q}.");
    assert!(told.contains(&expected), "{told}");
    page.press("cut-4", Key::Space).await;
    assert_eq!(cuts(&page).await, ["D"]);
    let told = page.text("mechanism-description").await;
    assert!(told.contains("Cut: D."), "{told}");
    page.close().await;
}

/// The drawing is saved, and nothing that a scheme has not.
#[tokio::test]
async fn the_drawing_is_exported() {
    let page = open(&document("mobility-2c")).await;
    open_dialog(&page).await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#export-plots-svg, #export-table-csv").await, 0);
    let svg = save_text(&page, "export-drawing-svg", "assur-mobility-2c-drawing.svg").await;
    let svg = Document::parse(&svg).unwrap();
    let texts: Vec<&str> = svg.descendants().filter_map(|one| one.text()).collect();
    for name in names(&scheme("mobility-2c")) {
        assert!(
            texts.iter().any(|text| text.starts_with(&name)),
            "{texts:?}"
        );
    }
    page.click("export-drawing-png").await;
    let png = page.saved("assur-mobility-2c-drawing.png").await;
    assert!(png.len() > 5000);
    page.close().await;
}

/// Keys that play and step have nothing to do where nothing moves; those of the page do what they do.
#[tokio::test]
async fn keys_of_what_does_not_move() {
    let page = open(&document("mobility-3")).await;
    let before = page.picture("mechanism").await;
    for key in [" ", "d", "a", "t"] {
        page.keys(key).await;
        page.settle().await;
    }
    page.keys(Key::Right + "").await;
    page.keys(Key::End + "").await;
    page.settle().await;
    assert_eq!(page.picture("mechanism").await.difference(&before), 0);
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}
