//! Everything by keyboard alone: no pointer, and no script that moves the focus.

use assur_tests::assert_near;
use serde_json::json;
use thirtyfour::prelude::*;

use crate::browser::Page;

/// More presses of Tab than there are stops.
const STOPS: usize = 120;

/// The element with the focus: its id, or that of what it is in.
async fn focused(page: &Page) -> String {
    let script = "const { activeElement: at } = document;
        return at.id || (at.matches('summary') ? at.parentElement.id : '')";
    page.ask(script).await.as_str().unwrap().to_owned()
}

/// Presses Tab until an element has the focus.
pub(crate) async fn tab_to(page: &Page, id: &str) {
    tab_until(page, &format!("[id=\"{id}\"]")).await;
}

/// Presses Tab until an element of a selector has the focus, with Shift while that is back: beyond the last element Tab
/// leads out of the page. Returns the id of the element.
pub(crate) async fn tab_until(page: &Page, selector: &str) -> String {
    let before = format!(
        "return Boolean(document.activeElement.compareDocumentPosition(document.querySelector('{selector}')) & Node.DOCUMENT_POSITION_PRECEDING)"
    );
    let there = format!(
        "const at = document.activeElement;
        return (at.matches('summary') && !at.id ? at.parentElement : at).matches('{selector}')"
    );
    for _ in 0..STOPS {
        if page.ask(&there).await == json!(true) {
            return focused(page).await;
        }
        if page.ask(&before).await == json!(true) {
            page.chord(&[Key::Shift], Key::Tab).await;
        } else {
            page.keys(Key::Tab + "").await;
        }
    }
    panic!("no press of Tab leads to {selector}");
}

#[tokio::test]
async fn tab_reaches_every_control() {
    let page = Page::playing().await;
    page.keys(" ").await; // at rest
    page.keys("1").await; // a step to undo, so that its button is a stop
    page.keys("2").await;
    // Of radio buttons of one name the chosen one is the stop.
    let wanted = page
        .ask(
            "return [...document.querySelectorAll('button, select, input, summary, a[href], [tabindex]')]
            .filter((one) => one.checkVisibility() && !one.disabled && one.tabIndex >= 0)
            .filter((one) => one.type !== 'radio' || one.checked)
            .map((one) => one.id || one.parentElement.id)",
        )
        .await;
    let wanted: Vec<String> = serde_json::from_value(wanted).unwrap();
    assert!(wanted.len() > 30, "{wanted:?}");
    let mut reached = Vec::new();
    for _ in 0..STOPS {
        page.keys(Key::Tab + "").await;
        let at = focused(&page).await;
        // Beyond the last stop a browser begins anew, or goes on in its own controls.
        if !at.is_empty() && reached.contains(&at) {
            break;
        }
        reached.push(at);
    }
    // Also in this order: from the header over drawing and bar to the settings.
    let stops: Vec<&String> = reached.iter().filter(|id| wanted.contains(id)).collect();
    assert_eq!(stops, wanted.iter().collect::<Vec<_>>());
    page.close().await;
}

#[tokio::test]
async fn all_is_done_by_keys() {
    let page = Page::playing().await;
    page.keys(" ").await;
    page.keys(Key::Home + "").await;
    page.keys(Key::Right + "").await;
    assert_near(page.value("out-input").await, 1.0, 1e-12, "a step");
    tab_to(&page, "angle").await;
    page.keys("75,5").await; // what was there is selected
    page.keys(Key::Enter + "").await;
    assert_eq!(page.value("out-input").await, 75.5);
    tab_to(&page, "speed").await;
    page.keys(Key::Down + "").await;
    assert_eq!(page.written("speed").await, "2");

    // Each press of a key on a slider is a step.
    tab_to(&page, "slider-l1").await;
    for _ in 0..3 {
        page.keys(Key::Right + "").await;
    }
    assert_eq!(page.written("field-l1").await, "0.4");
    tab_to(&page, "slider-l2").await;
    page.keys(Key::Left + "").await;
    page.chord(&[Key::Control], 'z').await;
    assert_eq!(page.written("field-l2").await, "0.85");
    assert_eq!(page.written("field-l1").await, "0.4");
    for before in ["0.39", "0.38", "0.37"] {
        page.chord(&[Key::Control], 'z').await;
        assert_eq!(page.written("field-l1").await, before);
    }
    for after in ["0.38", "0.39", "0.4"] {
        page.chord(&[Key::Control], 'y').await;
        assert_eq!(page.written("field-l1").await, after);
    }

    tab_to(&page, "field-l2").await;
    page.keys("0.9").await;
    page.keys(Key::Enter + "").await;
    assert_near(
        page.written("field-l2").await.parse().unwrap(),
        0.9,
        1e-12,
        "l2",
    );
    tab_to(&page, "fold-structure").await;
    page.keys(Key::Enter + "").await;
    tab_to(&page, "mesh-external").await;
    page.keys(Key::Down + "").await;
    assert_near(page.value("out-ratio").await, 2.0, 1e-15, "mesh");
    tab_to(&page, "assembly-1").await;
    page.keys(Key::Right + "").await;
    assert!(page.value("out-rocker.angle").await < 0.0);
    tab_to(&page, "fold-show").await;
    page.keys(Key::Enter + "").await;
    for overlay in [
        "traces",
        "centres",
        "vectors",
        "loop_vectors",
        "transmission",
    ] {
        let before = page.picture("mechanism").await;
        tab_to(&page, overlay).await;
        page.keys(" ").await;
        assert!(
            page.picture("mechanism").await.difference(&before) > 150,
            "{overlay}"
        );
    }

    tab_to(&page, "undo").await;
    page.keys(Key::Enter + "").await;
    assert!(
        !page
            .element("transmission")
            .await
            .is_selected()
            .await
            .unwrap()
    );
    tab_to(&page, "zoom-in").await;
    page.keys(Key::Enter + "").await;
    page.keys(" ").await;
    let zoom = page.attribute("mechanism", "data-zoom").await.unwrap();
    assert_near(zoom.parse().unwrap(), 1.69, 1e-12, "zoom");
    tab_to(&page, "zoom-fit").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(
        page.attribute("mechanism", "data-zoom").await.as_deref(),
        Some("1")
    );

    // The menu: what is saved is there to be taken; the last entry resets.
    page.ask("document.getElementById('save-link').onclick = (event) => event.preventDefault()")
        .await;
    tab_to(&page, "menu").await;
    page.keys(Key::Enter + "").await;
    tab_to(&page, "save").await;
    page.keys(Key::Enter + "").await;
    let saved = page.attribute("save-link", "href").await.unwrap();
    assert!(saved.starts_with("blob:"), "{saved}");
    tab_to(&page, "menu").await;
    page.keys(" ").await;
    tab_to(&page, "copy").await;
    page.keys(Key::Escape + "").await;
    assert_eq!(focused(&page).await, "menu");
    page.keys(Key::Enter + "").await;
    tab_to(&page, "reset").await;
    page.keys(Key::Enter + "").await;
    assert_eq!(page.written("field-l1").await, "0.37");
    tab_to(&page, "preset-c").await;
    page.keys(Key::Enter + "").await;
    assert_near(page.value("out-ratio").await, -0.5, 1e-15, "case c");

    page.keys("?").await;
    page.until("help", async || page.count("#help[open]").await == 1)
        .await;
    page.keys(Key::Escape + "").await;
    assert_eq!(page.count("#help").await, 0);
    page.keys("p").await;
    page.keys("s").await;
    tab_to(&page, "slider-l1").await;
    page.keys(Key::Escape + "").await;
    assert!(!page.element("rail").await.is_displayed().await.unwrap());
    page.keys("p").await;
    tab_to(&page, "menu").await;
    page.keys(Key::Enter + "").await;
    tab_to(&page, "lang").await;
    page.keys(Key::Down + "").await;
    page.until("Russian", async || {
        page.lang().await.as_deref() == Some("ru")
    })
    .await;
    assert_eq!(page.ask("return scrollX").await, json!(0));
    page.close().await;
}
