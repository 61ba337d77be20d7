//! Lengths and angles that are locked while points are dragged: put and taken away by buttons and by a key, kept by the link, undone.

use assur::Point;
use assur_file::LinkageDocument;
use thirtyfour::Key;

use crate::browser::Page;
use crate::draw::Sheet;
use crate::draw_more::{drawn, four_bar};

fn at(document: &LinkageDocument, name: &str) -> Point {
    let point = document.points.iter().find(|point| point.name == name);
    point.unwrap().at.into()
}

fn distance(document: &LinkageDocument, [a, b]: [&str; 2]) -> f64 {
    (at(document, b) - at(document, a)).norm()
}

/// Whether the button of a lock is pressed.
async fn pressed(page: &Page, what: &str) -> String {
    let button = format!("draw-act-lock_{what}");
    page.attribute(&button, "aria-pressed").await.unwrap()
}

/// Drags a point of the drawing to a place.
async fn drag(sheet: &Sheet<'_>, from: Point, to: [f64; 2]) {
    let between = [(from.x + to[0]) / 2.0, (from.y + to[1]) / 2.0];
    let way = [from.into(), between, to].map(|place| sheet.at(place));
    sheet.page.drag_along("mechanism", &way).await;
}

#[tokio::test]
async fn what_is_locked_holds_while_it_is_dragged() {
    let page = Page::open().await;
    let mut sheet = four_bar(&page).await;
    sheet.tool("select").await;
    let plain = page.picture("mechanism").await;
    // Three points in a frame: the angle at the second; then the lengths of two links.
    let frame = [[-3.6, -1.6], [-1.0, 1.0], [0.8, 2.3]].map(|place| sheet.at(place));
    page.drag_along("mechanism", &frame).await;
    assert_eq!(
        page.text("draw-act-lock_angle").await,
        "Lock the angle at B"
    );
    page.click("draw-act-lock_angle").await;
    for place in [[-3.0, -0.5], [-1.2, 0.9]] {
        sheet.press(place[0], place[1]).await;
        assert_eq!(pressed(&page, "length").await, "false");
        page.click("draw-act-lock_length").await;
        page.settle().await;
        assert_eq!(pressed(&page, "length").await, "true");
        assert_eq!(page.text("draw-act-lock_length").await, "Lock the length");
    }
    assert!(page.picture("mechanism").await.difference(&plain) > 60);
    let before = drawn(&sheet).await;
    assert_eq!(before.locks.len(), 3);
    assert!(before.frame.contains(&"A".to_owned()));

    // The three points turn about the fixed one, as far as they can be where the hand is.
    let to = [2.0, 0.5];
    drag(&sheet, at(&before, "C"), to).await;
    assert_eq!(
        page.text("problem").await,
        "The locks do not let it move any further."
    );
    let after = drawn(&sheet).await;
    for pair in [["A", "B"], ["B", "C"], ["A", "C"]] {
        let off = distance(&after, pair) - distance(&before, pair);
        assert!(off.abs() < 1e-9, "{pair:?}: {off:e}");
    }
    let way = Point::from(to) - at(&after, "A");
    let nearest = at(&after, "A") + way.normalize() * distance(&before, ["A", "C"]);
    let off = (at(&after, "C") - nearest).norm();
    assert!(
        off < 0.1 && (at(&after, "C") - at(&before, "C")).norm() > 0.5,
        "{off}"
    );
    assert_eq!(at(&after, "A"), at(&before, "A"));

    page.click("undo").await;
    page.settle().await;
    assert_eq!(drawn(&sheet).await.points, before.points);
    // Without the length of the coupler it goes where the hand is.
    sheet.press(-1.2, 0.9).await;
    page.chord(&[Key::Alt], 'l').await;
    page.settle().await;
    assert_eq!(pressed(&page, "length").await, "false");
    drag(&sheet, at(&before, "B"), [-2.4, 0.6]).await;
    let after = drawn(&sheet).await;
    let off = distance(&after, ["A", "B"]) - distance(&before, ["A", "B"]);
    assert!(off.abs() < 1e-9, "{off:e}");
    assert_eq!(after.locks.len(), 2);

    page.until("the address", async || {
        page.address().await.contains("d.locks=")
    })
    .await;
    page.reload().await;
    page.until("the tools", async || {
        page.count("#draw-tools:not([hidden])").await == 1
    })
    .await;
    assert_eq!(drawn(&sheet).await, after);
    page.close().await;
}
