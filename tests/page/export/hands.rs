//! By keys, by touch, from the one file.

use super::*;

/// By keys alone, in another language, of a mechanism of the reader's own.
#[tokio::test]
async fn exports_by_keys() {
    let page = Page::open().await;
    page.stop_at("75.5").await;
    page.write("field-l2", "0.9").await;
    page.choose("lang", "ru").await;
    page.until("Russian", async || {
        page.lang().await.as_deref() == Some("ru")
    })
    .await;
    let told = page.attribute("export", "aria-keyshortcuts").await;
    assert_eq!(told.as_deref(), Some("E"));
    page.focus("play").await;
    page.keys("e").await;
    wait_for_dialog(&page).await;
    // The table is at hand at once, with the decimal sign of the language.
    page.keys(Key::Enter + "").await;
    let csv = String::from_utf8(page.saved("assur-mixer.csv").await).unwrap();
    assert!(
        csv.contains("\n90;") && csv.contains(";0,37;"),
        "{csv:.200}"
    );
    assert_eq!(Csv::parse(&csv).value(90, "B.y"), 0.37);
    while page.focused().await.as_deref() != Some("export-drawing-svg") {
        page.keys(Key::Tab + "").await;
    }
    page.keys(Key::Enter + "").await;
    let svg = page.saved("assur-mixer-drawing.svg").await;
    let svg = String::from_utf8(svg).unwrap();
    let svg = Document::parse(&svg).unwrap();
    let labels = texts(&elements(&svg));
    assert!(labels.iter().any(|text| text == "φ₁ = 75,5°"), "{labels:?}");
    page.keys(Key::Escape + "").await;
    assert_eq!(page.count("#export-dialog").await, 0);
    assert_eq!(page.focused().await.as_deref(), Some("play"));
    page.close().await;
}

#[tokio::test]
async fn exports_by_touch() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.tap("menu").await;
    page.tap("export").await;
    wait_for_dialog(&page).await;
    page.tap("export-table-csv").await;
    let csv = page.saved("assur-mixer-a.csv").await;
    assert_eq!(Csv::parse(&String::from_utf8(csv).unwrap()).rows.len(), 361);
    page.tap("export-plots-png").await;
    let png = page.saved("assur-mixer-a-plots.png").await;
    assert!(Picture::decode(&png).cloud(WHEEL5).count > 6000);
    page.tap("export-close").await;
    assert_eq!(page.count("#export-dialog").await, 0);
    page.close().await;
}

#[tokio::test]
async fn the_one_file_page_exports() {
    let page = Page::open_at(&format!("file://{}", setting("ASSUR_BUNDLE")), "en-US").await;
    page.stop_at("75").await;
    open_dialog(&page).await;
    let svg = save_text(&page, "export-drawing-svg", "assur-mixer-a-drawing.svg").await;
    assert!(Document::parse(&svg).is_ok());
    let csv = Csv::save(&page, "assur-mixer-a.csv").await;
    assert_eq!(csv.value(90, "B.y"), 0.37);
    let png = save(&page, "export-plots-png", "assur-mixer-a-plots.png").await;
    assert!(Picture::decode(&png).cloud(ROCKER).count > 6000);
    page.close().await;
}
