//! Positions on a function: the dialog, what it refuses, and how far the linkage is off.

use std::collections::BTreeSet;

use serde_json::json;
use thirtyfour::prelude::*;

use crate::access::{AXE, check};
use crate::browser::Page;
use crate::device::LANGUAGES;
use crate::layout::defects;
use crate::synthesis::{directions, listed, open, preset, there};

async fn ask(page: &Page) {
    page.click("function-open").await;
    page.until("the dialog", async || {
        page.count("#function-dialog[open]").await == 1
    })
    .await;
}

/// Writes into a field of the dialog, which Enter would send.
async fn fill(page: &Page, id: &str, text: &str) {
    let field = page.element(id).await;
    field.click().await.unwrap();
    field.send_keys(Key::Control + "a").await.unwrap();
    field.send_keys(Key::Backspace + text).await.unwrap();
}

/// Whether the rail says how far off the function the linkage is.
async fn compared(page: &Page) -> bool {
    page.count("#function:not([hidden])").await == 1
}

/// Positions are put on a function in one step of undo, and what comes of them is compared with it, also after a reload.
#[tokio::test]
async fn positions_come_from_a_function() {
    let page = open(&preset("family")).await;
    let before = directions(&page).await;
    assert!(!compared(&page).await);
    ask(&page).await;
    page.click("function-set").await;
    assert_eq!(page.count("#function-dialog").await, 0);
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#positions .card:not([hidden])").await, 3);
    // Worked out apart from the engine: z₁ = 1.65816, z₂ = 0.715657, z₃ = 0.713024.
    let shown = listed(&page).await;
    assert!(
        shown[0].contains("l₁ = 17.24; l₂ = 7.443; l₃ = 7.415"),
        "{shown:?}"
    );
    let said = page.text("function-said").await;
    let all = ["y = log₁₀ x", "−0.0005215", "x = 2", "without a break"];
    assert!(all.iter().all(|one| said.contains(one)), "{said}");
    let drawn = "return document.querySelector('.function-plot path:last-child').getAttribute('d').split('L').length";
    assert_eq!(page.ask(drawn).await, json!(101));
    let after = directions(&page).await;
    page.click("undo").await;
    assert_eq!(directions(&page).await, before);
    assert!(!compared(&page).await);
    page.click("redo").await;
    page.until("the address to follow", async || {
        page.address().await.contains("log10")
    })
    .await;
    page.reload().await;
    there(&page).await;
    assert_eq!(directions(&page).await, after);
    assert_eq!(page.text("function-said").await, said);

    // Positions by hand are compared with the same function; without it with none.
    page.write("field-output-3", "264").await;
    let other = page.text("function-said").await;
    assert!(other.contains("y = log₁₀ x") && other != said, "{other}");
    page.click("function-remove").await;
    assert!(!compared(&page).await);
    assert_eq!(page.written("field-output-3").await, "264°");
    page.close().await;
}

/// More positions of a power and of rows that are pasted; the dialog begins with what was last set.
#[tokio::test]
async fn powers_and_tables() {
    let page = open(&preset("family")).await;
    ask(&page).await;
    page.choose("function-of", "power").await;
    fill(&page, "function-power", "1.5").await;
    for (id, text) in [
        ("x-0", "1"),
        ("x-1", "4"),
        ("input_deg-0", "345"),
        ("input_deg-1", "405"),
        ("output_deg-0", "105"),
        ("output_deg-1", "195°"),
    ] {
        fill(&page, &format!("function-{id}"), text).await;
    }
    page.click("function-set").await;
    page.settle().await;
    let said = page.text("function-said").await;
    assert!(
        said.contains("x^1.5") && said.contains("0.006897"),
        "{said}"
    );

    ask(&page).await;
    assert_eq!(page.written("function-power").await, "1.5");
    assert_eq!(page.written("function-output_deg-1").await, "195°");
    page.choose("function-of", "table").await;
    fill(&page, "function-rows", "1 1\n2; 2,83\n3, 5.2\n4 8").await;
    page.choose("function-count", "7").await;
    page.choose("function-spacing", "even").await;
    page.click("function-set").await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(page.count("#positions .card:not([hidden])").await, 7);
    assert_eq!(page.written("field-input-1").await, "345°");
    // y = 2.83 is (2.83 − 1)/7 of the way.
    assert_eq!(page.written("field-output-3").await, "128.529°");
    assert!(page.text("function-said").await.starts_with("table"));
    page.close().await;
}

/// The dialog names the field at fault in every language and changes nothing; the dialog has room and names.
#[tokio::test]
async fn what_is_wrong_is_said_in_the_dialog() {
    let page = open(&preset("family")).await;
    page.ask(AXE).await;
    let before = directions(&page).await;
    let mut said = BTreeSet::new();
    for lang in LANGUAGES {
        page.speak(lang).await;
        ask(&page).await;
        page.screen((360, 640), 1.0).await;
        page.choose("function-of", "table").await;
        assert_eq!(defects(&page, 0).await, json!([]), "{lang}");
        if lang == "en" {
            check(&page, "the dialog").await;
        }
        fill(&page, "function-rows", "1 2\n1 3").await;
        fill(&page, "function-input_deg-0", "x").await;
        page.click("function-set").await;
        let text = page.text("function-problem").await;
        assert!(!text.contains('{') && !text.contains("problem."), "{text}");
        assert!(said.insert(text), "{lang}");
        let invalid = page.attribute("function-input_deg-0", "aria-invalid").await;
        assert_eq!(invalid.as_deref(), Some("true"));
        fill(&page, "function-input_deg-0", "90").await;
        page.click("function-set").await;
        let text = page.text("function-problem").await;
        assert!(text.contains('2') && said.insert(text), "{lang}");
        page.choose("function-of", "log10").await;
        fill(&page, "function-x-0", "-1").await;
        page.click("function-set").await;
        let text = page.text("function-problem").await;
        assert!(text.contains("x = −1") && said.insert(text), "{lang}");
        page.click("function-close").await;
        page.screen((1280, 800), 1.0).await;
        assert_eq!(page.count("#function-dialog").await, 0);
        assert_eq!(directions(&page).await, before);
    }
    page.close().await;
}
