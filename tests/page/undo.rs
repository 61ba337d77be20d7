//! Undo and redo by buttons and by keys; what counts as one step; reset.

use crate::browser::Page;

/// Whether undo and redo can be pressed.
async fn offered(page: &Page) -> [bool; 2] {
    [
        page.element("undo").await.is_enabled().await.unwrap(),
        page.element("redo").await.is_enabled().await.unwrap(),
    ]
}

#[tokio::test]
async fn every_edit_is_undone_and_redone() {
    let page = Page::open().await;
    page.stop_at("75").await;
    assert_eq!(offered(&page).await, [false, false]);
    let start = page.value("out-rocker.angle").await;

    page.write("field-l2", "0.912").await; // five characters, one step
    page.click("mesh-internal").await;
    page.drag("slider-l1", 0.3, 0.2).await; // many values, one step
    page.click("traces").await;
    page.click("preset-b").await;
    let end = page.written("field-l1").await;
    assert_eq!(offered(&page).await, [true, false]);

    page.click("undo").await; // the preset
    page.click("undo").await; // the traces
    assert!(page.element("traces").await.is_selected().await.unwrap());
    assert_ne!(page.written("field-l1").await, "0.37");
    page.click("undo").await; // the drag
    assert_eq!(page.written("field-l1").await, "0.37");
    page.click("undo").await; // the mesh
    assert_eq!(page.value("out-ratio").await, -2.0);
    assert_eq!(page.written("field-l2").await, "0.912");
    page.click("undo").await; // the field
    assert_eq!(page.written("field-l2").await, "0.85");
    assert_eq!(page.value("out-rocker.angle").await, start);
    assert_eq!(offered(&page).await, [false, true]);

    for _ in 0..5 {
        page.click("redo").await;
    }
    assert_eq!(page.written("field-l1").await, end);
    assert_eq!(offered(&page).await, [true, false]);

    page.click("undo").await;
    page.click("mesh-external").await; // another future
    assert_eq!(offered(&page).await, [true, false]);
    page.close().await;
}
