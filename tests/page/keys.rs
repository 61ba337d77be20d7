//! The table of keys: what each does, where they are left to the element with the
//! focus, and that help and screen readers are told the same.

use assur_tests::assert_near;
use thirtyfour::prelude::*;

use crate::browser::Page;

async fn playing(page: &Page) -> bool {
    page.attribute("play", "data-playing").await.as_deref() == Some("true")
}

#[tokio::test]
async fn every_key_does_what_the_help_says() {
    let page = Page::playing().await;
    page.keys(" ").await;
    assert!(!playing(&page).await);
    page.keys(" ").await;
    assert!(playing(&page).await);

    page.keys(Key::Home + "").await;
    assert!(!playing(&page).await);
    assert_eq!(page.value("out-input").await, 0.0);
    page.keys(Key::Right + "").await;
    page.keys(Key::Right + "").await;
    page.keys(Key::Left + "").await;
    assert_near(page.value("out-input").await, 1.0, 1e-12, "arrows");
    page.chord(&[Key::Shift], Key::Right).await;
    page.chord(&[Key::Shift], Key::Right).await;
    page.chord(&[Key::Shift], Key::Left).await;
    assert_near(page.value("out-input").await, 11.0, 1e-12, "with Shift");
    page.keys(Key::End + "").await;
    assert_eq!(page.value("out-input").await, 360.0);

    page.keys("+").await;
    assert_eq!(page.written("speed").await, "2");
    page.keys("--").await;
    assert_eq!(page.written("speed").await, "0.5");
    page.keys("r").await;
    let pressed = page.attribute("reverse", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));

    let first = page.value("out-coupler.angle").await;
    page.keys("2").await;
    assert_ne!(page.value("out-coupler.angle").await, first);
    page.keys("1").await;
    page.chord(&[Key::Control], 'z').await;
    assert_ne!(page.value("out-coupler.angle").await, first);
    page.chord(&[Key::Control], 'z').await;
    assert_eq!(page.value("out-coupler.angle").await, first);
    page.chord(&[Key::Control, Key::Shift], 'z').await;
    assert_ne!(page.value("out-coupler.angle").await, first);
    page.chord(&[Key::Control], 'y').await;
    assert_eq!(page.value("out-coupler.angle").await, first);
    assert!(!page.element("redo").await.is_enabled().await.unwrap());

    page.keys("?").await;
    page.until("help", async || page.count("#help[open]").await == 1)
        .await;
    let help = page.text("help").await;
    for said in ["Ctrl", "Drag empty space", "Smelyagin", "Assur 0."] {
        assert!(help.contains(said), "{said}: {help}");
    }
    page.keys(Key::Escape + "").await;
    assert_eq!(page.count("#help").await, 0);
    let told = page.attribute("undo", "aria-keyshortcuts").await;
    assert_eq!(told.as_deref(), Some("Control+Z"));
    page.close().await;
}

#[tokio::test]
async fn keys_are_left_to_the_element_that_uses_them() {
    let page = Page::open().await;
    page.stop_at("75").await;

    // A text field has all of them, with its own undo.
    page.click("preset-b").await;
    page.focus("field-l2").await;
    page.keys(Key::End + "12").await;
    assert!(page.written("field-l2").await.ends_with("12"));
    page.chord(&[Key::Control], 'z').await;
    page.keys(Key::Home + " ").await;
    assert!(!playing(&page).await);
    let pressed = page.attribute("preset-a", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("false"));
    assert_eq!(page.value("out-input").await, 75.0);
    page.keys(Key::Escape + "").await;

    // A slider has its arrows, not Space nor undo.
    page.click("preset-a").await;
    page.focus("slider-l1").await;
    page.keys(Key::Right + "").await;
    assert_eq!(page.written("slider-l1").await, "0.38");
    assert_eq!(page.value("out-input").await, 75.0);
    page.chord(&[Key::Control], 'z').await;
    assert_eq!(page.written("slider-l1").await, "0.37");

    // A select has its letters and arrows.
    page.focus("speed").await;
    page.keys("r2").await;
    let turned = page.attribute("reverse", "aria-pressed").await;
    assert_eq!(turned.as_deref(), Some("false"));
    assert!(
        page.element("assembly-1")
            .await
            .is_selected()
            .await
            .unwrap()
    );

    // Space on a button presses that button.
    page.focus("step-forward").await;
    page.keys(" ").await;
    assert!(!playing(&page).await);
    assert_near(page.value("out-input").await, 76.0, 1e-12, "the button");

    // On the scrubber Shift makes it ten.
    page.focus("scrubber").await;
    page.chord(&[Key::Shift], Key::Up).await;
    assert_near(page.value("out-input").await, 86.0, 1e-12, "the scrubber");
    page.close().await;
}
