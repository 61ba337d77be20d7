//! A slide as the driver: transport, plots and read-outs are in lengths.

use serde_json::{Value, json};

use crate::browser::Page;

/// A ladder on two guides at a right angle, 2.5 long, driven by its foot from 0.5 to 2.
fn ladder() -> Value {
    let text = include_str!("../data/linkages/driven-slide.json");
    let mut ladder: Value = serde_json::from_str(text).unwrap();
    ladder["unit"] = json!("m");
    ladder
}

async fn open(page: &Page) {
    let script = format!(
        "const document = {};
        const said = (value) => encodeURIComponent(typeof value === 'string' ? value : JSON.stringify(value));
        const pairs = Object.entries(document).map(([key, value]) => `d.${{key}}=${{said(value)}}`);
        location.hash = ['2', 'kind=linkage', ...pairs, 'v.phi_deg=0', 'v.s=1.5', 'v.playing=false',
            'v.direction=1', 'v.speed=1', 'v.traces=true', 'v.plot=H', 'v.lang=en'].join('&');",
        json!(ladder())
    );
    page.ask(&script).await;
    page.until("the ladder", async || page.count("#out-H\\.y").await == 1)
        .await;
    page.settle().await;
}

/// y of the head, and its two derivatives by the foot's place.
fn head(s: f64) -> [f64; 3] {
    let y = (2.5f64.powi(2) - s * s).sqrt();
    [y, -s / y, -2.5f64.powi(2) / y.powi(3)]
}

async fn agrees(page: &Page, s: f64) {
    assert_eq!(page.value("out-input").await, s);
    for (stroke, expected) in ["", "′", "″"].into_iter().zip(head(s)) {
        let shown = page.value(&format!("out-H.y{stroke}")).await;
        assert!((shown - expected).abs() < 1e-9, "{stroke}: {shown}");
    }
}

#[tokio::test]
async fn transport_and_read_outs_are_in_lengths() {
    let page = Page::open().await;
    open(&page).await;
    agrees(&page, 1.5).await;
    assert_eq!(page.text("input-symbol").await, "s");
    page.click("transport-more").await;
    assert_eq!(page.text("step-forward").await, "+0.01");
    let status = page.text("status").await;
    assert!(status.contains("can be assembled for s"), "{status}");
    assert_eq!(page.written("driver").await, "foot");
    let name = page.attribute("angle", "aria-label").await;
    assert_eq!(name.as_deref(), Some("Input length, m"));

    page.click("step-forward").await;
    agrees(&page, 1.51).await;
    page.write("angle", "1,2").await;
    agrees(&page, 1.2).await;
    page.until("the address", async || {
        page.address().await.contains("v.s=1.2")
    })
    .await;
    page.reload().await;
    agrees(&page, 1.2).await;
    // The ends of its way hold it.
    page.write("angle", "7").await;
    agrees(&page, 2.0).await;
    page.keys(thirtyfour::Key::Home + "").await;
    page.click("play").await;
    let before = page.value("out-input").await;
    page.until("motion", async || page.value("out-input").await != before)
        .await;
    page.click("play").await;
    let s = page.value("out-input").await;
    assert!((0.5..=2.0).contains(&s), "{s}");
    page.close().await;
}

#[tokio::test]
async fn plots_and_tables_are_in_lengths() {
    let page = Page::open().await;
    open(&page).await;
    let texts = crate::plots::texts(&page).await;
    for text in ["0.5", "1", "1.5", "2"] {
        assert!(texts.iter().any(|one| one == text), "{text}: {texts:?}");
    }
    let unit = "velocity analogue, 1";
    assert!(texts.iter().any(|text| text.contains(unit)), "{texts:?}");
    assert!(texts.iter().all(|text| !text.contains('°')), "{texts:?}");
    // A click on the plots drives the slide.
    page.click("charts").await;
    page.settle().await;
    let s = page.value("out-input").await;
    assert!(s > 1.0 && s < 1.5, "{s}");
    agrees(&page, s).await;

    // By time: the velocity of the slide stands for ω₁.
    page.choose("axes", "physical").await;
    assert_eq!(page.text("omega-symbol").await, "v₁");
    page.write("omega", "2").await;
    page.write("epsilon", "3").await;
    let [_, first, second] = head(s);
    for (stroke, expected) in [("′", 2.0 * first), ("″", 4.0 * second + 3.0 * first)] {
        let shown = page.value(&format!("out-H.y{stroke}")).await;
        assert!((shown - expected).abs() < 1e-9, "{stroke}: {shown}");
    }

    crate::export::open_dialog(&page).await;
    let csv = crate::export::Csv::save(&page, "assur-linkage.csv").await;
    for (row, s) in [(0, 0.5), (csv.rows.len() - 1, 2.0)] {
        assert_eq!(csv.value(row, "s"), s);
        let y = csv.value(row, "H.y");
        assert!((y - head(s)[0]).abs() < 1e-9, "{y}");
    }
    page.close().await;
}
