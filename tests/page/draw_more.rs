//! Edits of a drawing: dragged, joined, copied, undone; what cannot be done is said and loses nothing.

mod by_chance;

use assur_file::{Document, DraftDocument, LinkageDocument, State};
use assur_tests::scaled;
use serde_json::{Map, Value};
use thirtyfour::Key;

use crate::access;
use crate::browser::Page;
use crate::draw::Sheet;
use crate::host::home;
use crate::layout::defects;

/// The linkage that is drawn, whether it moves or not.
pub(crate) async fn drawn(sheet: &Sheet<'_>) -> LinkageDocument {
    match sheet.saved().await.document {
        Document::Draft(DraftDocument(document)) | Document::Linkage(document) => document,
        other => panic!("{other:?}"),
    }
}

/// A four-bar that does not move yet, with its last bar of it free of the frame.
pub(crate) async fn four_bar<'a>(page: &'a Page) -> Sheet<'a> {
    let mut sheet = Sheet::new(page).await;
    sheet
        .line(&[[-3.0, -1.0], [-3.0, 0.0], [0.6, 1.8], [1.0, -1.0]])
        .await;
    sheet.end().await;
    sheet
}

/// Along a straight way on the canvas.
fn way(sheet: &Sheet<'_>, from: [f64; 2], to: [f64; 2]) -> [(f64, f64); 3] {
    let between = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
    [from, between, to].map(|place| sheet.at(place))
}

#[tokio::test]
async fn what_does_not_move_yet_is_kept_shared_and_mended() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    // The chain hangs free: which links, and what would let it move.
    assert!(page.text("draw-reasons").await.contains("No driver"));
    // Driven it is still loose, in words and by name; the end on the frame lets it move.
    sheet.tool("drive").await;
    sheet.press(-3.0, -0.5).await;
    let before = drawn(&sheet).await;
    page.reload().await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    assert_eq!(drawn(&sheet).await, before);
    let address = page.address().await;
    page.goto(&address).await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    assert_eq!(drawn(&sheet).await, before);
    let said = page.text("draw-reasons").await;
    assert!(said.contains("stay free: BC, CD. "), "{said}");
    assert_eq!(page.count("#draw-reasons [data-code=underdriven]").await, 1);
    let mends = page.text("draw-mends").await;
    assert!(mends.contains("Fix D"), "{mends}");
    page.ask(access::AXE).await;
    access::check(&page, "a drawing that does not move").await;
    let fix = "const all = [...document.querySelectorAll('#draw-mends button')]; all.find((one) => one.textContent === 'Fix D to the frame').click()";
    page.ask(fix).await;
    page.settle().await;
    assert_eq!(
        page.text("draw-reasons").await,
        "It moves: there are as many drivers as degrees of freedom."
    );
    assert_eq!(
        page.attribute("charts", "id").await.as_deref(),
        Some("charts")
    );
    access::check(&page, "a drawing that moves").await;
    page.close().await;
}

#[tokio::test]
async fn points_are_dragged_joined_and_parted() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    sheet.line(&[[3.0, -1.0], [3.0, 1.0]]).await;
    sheet.end().await;
    sheet.tool("select").await;
    page.drag_along("mechanism", &way(&sheet, [-3.0, 0.0], [-2.0, 0.8]))
        .await;
    assert_eq!(drawn(&sheet).await.points[1].at, [-2.0, 0.8]);
    // The free end of the chain dropped onto the new bar's end is one hinge with it: one step.
    page.drag_along("mechanism", &way(&sheet, [1.0, -1.0], [3.0, 1.0]))
        .await;
    let joined = drawn(&sheet).await;
    assert_eq!(joined.points.len(), 5);
    assert_eq!(
        joined
            .links
            .iter()
            .map(|link| link.name.as_str())
            .collect::<Vec<_>>(),
        ["AB", "BC", "CF", "EF"]
    );
    page.chord(&[Key::Control], 'z').await;
    assert_eq!(drawn(&sheet).await.points.len(), 6);
    page.chord(&[Key::Control, Key::Shift], 'z').await;
    assert_eq!(drawn(&sheet).await, joined);
    // Selected by a press, and parted again.
    sheet.press(3.0, 1.0).await;
    page.click("draw-act-part").await;
    assert_eq!(drawn(&sheet).await.points.len(), 6);
    // Ends of one link cannot be one hinge: a sentence, nothing lost.
    let before = drawn(&sheet).await;
    page.drag_along("mechanism", &way(&sheet, [0.6, 1.8], [-2.0, 0.8]))
        .await;
    assert!(page.text("problem").await.contains("points of one link"));
    assert_eq!(drawn(&sheet).await.links, before.links);
    page.close().await;
}

#[tokio::test]
async fn the_keyboard_draws_alone() {
    let page = Page::open().await;
    page.stop_at("62").await;
    page.ask("document.activeElement.blur()").await;
    page.keys("n").await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    page.settle().await;
    // The first arrow shows where the pointer is; Enter presses there.
    let steps = |key: Key, count: usize| vec![key; count];
    let ways = [
        steps(Key::Up, 1),
        steps(Key::Up, 5),
        steps(Key::Right, 10),
        steps(Key::Down, 5),
    ];
    for way in ways {
        for key in way {
            page.keys(key).await;
        }
        page.keys(Key::Enter).await;
        page.settle().await;
    }
    page.keys(Key::Enter).await;
    page.settle().await;
    assert!(page.text("draw-reasons").await.starts_with("No driver"));
    page.element("draw-mends").await;
    page.ask("document.querySelector('#draw-mends button').focus()")
        .await;
    page.keys(Key::Enter).await;
    page.settle().await;
    assert_eq!(
        page.text("draw-reasons").await,
        "It moves: there are as many drivers as degrees of freedom."
    );
    // Typed numbers are those of the point that was drawn last.
    page.ask("document.activeElement.blur()").await;
    page.keys("7").await;
    assert_eq!(page.focused().await.as_deref(), Some("draw-x-D"));
    let named = page.attribute("draw-x-D", "aria-label").await;
    assert_eq!(named.as_deref(), Some("x of point D"));
    page.close().await;
}

#[tokio::test]
async fn a_hinge_is_not_dragged_onto_its_own_slide() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    sheet.tool("slide").await;
    sheet.line(&[[1.0, -1.0], [4.0, -1.0]]).await;
    let before = drawn(&sheet).await;
    assert_eq!(before.slides.len(), 1);
    sheet.tool("select").await;
    // The end of the guide is dragged onto the hinge of its block.
    page.drag_along(
        "mechanism",
        &[
            sheet.at([4.0, -1.0]),
            sheet.at([3.0, -0.6]),
            sheet.at([1.0, -1.0]),
        ],
    )
    .await;
    assert!(
        page.text("problem")
            .await
            .contains("cannot be joined with the line"),
        "{}",
        page.text("problem").await
    );
    let after = drawn(&sheet).await;
    assert_eq!(after.slides, before.slides);
    assert_eq!(after.points.len(), before.points.len());
    page.close().await;
}

#[tokio::test]
async fn what_cannot_be_drawn_is_said() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    let before = drawn(&sheet).await;
    sheet.tool("drive").await;
    sheet.press(4.0, 3.0).await;
    assert_eq!(
        page.text("problem").await,
        "Click a link here, not empty space."
    );
    assert_eq!(drawn(&sheet).await, before);
    // Two points in one place, by numbers.
    page.write("draw-x-B", "-3").await;
    page.write("draw-y-B", "-1").await;
    let said = page.text("draw-reasons").await;
    assert!(said.contains("coincide"), "{said}");
    page.write("draw-y-B", "1e12").await;
    assert!(
        page.text("problem").await.contains("B"),
        "{}",
        page.text("problem").await
    );
    page.write("draw-y-B", "0").await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(drawn(&sheet).await, before);
    // A bar of one point is none: what was begun is left.
    sheet.tool("bars").await;
    sheet.press(-3.0, 0.0).await;
    sheet.end().await;
    assert_eq!(drawn(&sheet).await, before);
    // A name that is taken.
    sheet.tool("select").await;
    sheet.press(-3.0, 0.0).await;
    page.write("draw-name", "C").await;
    page.press("draw-name", Key::Enter).await;
    page.settle().await;
    assert!(
        page.text("problem").await.contains("C"),
        "{}",
        page.text("problem").await
    );
    assert_eq!(drawn(&sheet).await, before);
    page.close().await;
}

#[tokio::test]
async fn parts_are_copied_and_pasted() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    // What is missing is told in turn: first the end on the frame, then a driver.
    assert!(page.text("draw-mends").await.contains("Fix D"));
    sheet.mend().await;
    sheet.mend().await;
    sheet.tool("select").await;
    page.chord(&[Key::Control], 'a').await;
    page.chord(&[Key::Control], 'd').await;
    let twice = drawn(&sheet).await;
    assert_eq!(
        twice
            .links
            .iter()
            .map(|link| link.name.as_str())
            .collect::<Vec<_>>(),
        ["AB", "BC", "DC", "EF", "FG", "HG"]
    );
    page.keys(Key::Delete).await;
    page.settle().await;
    assert_eq!(drawn(&sheet).await.links.len(), 3);
    page.close().await;
}

#[tokio::test]
async fn a_mechanism_of_the_catalogue_is_drawn_on() {
    let page = Page::open().await;
    let address = page.address().await;
    let base = address.split('#').next().unwrap();
    page.goto(&format!("{base}#crank-rocker&v.playing=false"))
        .await;
    page.click("draw").await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    page.until("that it moves", async || {
        page.text("draw-reasons").await
            == "It moves: there are as many drivers as degrees of freedom."
    })
    .await;
    page.chord(&[Key::Control], 'a').await;
    page.keys(Key::Delete).await;
    page.until("no points", async || {
        page.count("#draw-points input").await == 0
    })
    .await;
    page.click("undo").await;
    page.click("draw").await;
    page.until("no tools", async || {
        page.count("#draw-tools:not([hidden])").await == 0
    })
    .await;
    // The mixer becomes a linkage when it is drawn on.
    page.goto(&format!("{base}#mixer-a&v.playing=false")).await;
    page.click("draw").await;
    page.until("a linkage", async || {
        page.attribute("app", "id").await.is_some() && page.count("#draw-points input").await > 0
    })
    .await;
    page.close().await;
}
