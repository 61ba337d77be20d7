//! What lecturers draw over a moving linkage: polygons of velocities and accelerations.

use serde_json::json;

use crate::browser::Page;
use crate::gallery::open;

async fn shown(page: &Page) {
    page.click("polygons").await;
    page.until("the polygons", async || {
        page.count("#polygon-equations li").await > 0
    })
    .await;
}

/// The size of a point's velocity or acceleration, order 1 or 2, as it is written beside its equation.
async fn of(page: &Page, point: &str, order: u32) -> f64 {
    let selector = format!("#polygon-equations [data-point='{point}'][data-order='{order}']");
    let script = format!("return [Number(document.querySelector(\"{selector}\").dataset.value)]");
    page.numbers(&script).await[0]
}

/// How many pixels of a polygon are not blank.
async fn painted(page: &Page, name: &str) -> u64 {
    let script = format!(
        "const canvas = document.getElementById('polygon-{name}');
        const {{ data }} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let at = 3; at < data.length; at += 4) if (data[at] > 0) count += 1;
        return count"
    );
    page.ask(&script).await.as_u64().unwrap()
}

/// Jansen's foot: its velocity and acceleration are those of the read-outs, as analogues and by time; they follow the
/// crank; the switch is in the address, and takes them away again.
#[tokio::test]
async fn polygons_agree_with_the_read_outs() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("30").await;
    shown(&page).await;
    for (axes, degrees) in [
        ("analogues", "30"),
        ("analogues", "200"),
        ("physical", "200"),
    ] {
        page.choose("axes", axes).await;
        page.stop_at(degrees).await;
        for (order, strokes) in [(1, "d"), (2, "dd")] {
            let [x, y] = ["x", "y"].map(|way| format!("out-{strokes}F.{way}"));
            let expected = page.value(&x).await.hypot(page.value(&y).await);
            let found = of(&page, "F", order).await;
            assert!(
                (found - expected).abs() <= 1e-9 * expected,
                "{axes} {degrees} {order}: {found} {expected}"
            );
        }
    }
    assert!(page.address().await.contains("v.polygons=true"));
    let here = painted(&page, "velocity").await;
    assert!(here > 500, "{here}");
    page.click("polygons").await;
    let hidden = "return document.getElementById('polygons-shown').hidden";
    assert_eq!(page.ask(hidden).await, json!(true));
    page.close().await;
}

/// Step by step: after each there is more, the first equation of a point leaves only a direction; by mouse and by key.
#[tokio::test]
async fn polygons_are_drawn_step_by_step() {
    let page = Page::open().await;
    open(&page, "whitworth").await;
    page.stop_at("75").await;
    shown(&page).await;
    let steps = page.count("#polygon-equations li").await;
    assert_eq!(steps, 7);
    assert_eq!(page.text("polygon-step").await, "Step 7 of 7");
    let all = painted(&page, "acceleration").await;
    page.click("polygons-next").await;
    page.settle().await;
    assert_eq!(page.text("polygon-step").await, "Step 1 of 7");
    let mut before = painted(&page, "acceleration").await;
    let first = before;
    for step in 2..=steps {
        page.focus("polygons-next").await;
        page.keys(" ").await;
        page.settle().await;
        assert_eq!(page.text("polygon-step").await, format!("Step {step} of 7"));
        assert_eq!(page.count("#polygon-equations li").await, step);
        let now = painted(&page, "acceleration").await;
        assert_ne!(now, before, "nothing new at {step}");
        // Of the lever's point on the pin the first equation tells no size.
        let found = page.count("#polygon-equations [data-point='B3']").await;
        assert_eq!(found, if step >= 4 { 2 } else { 0 }, "{step}");
        before = now;
    }
    assert_eq!(before, all);
    assert!(first < all);
    page.click("polygons-back").await;
    page.settle().await;
    assert_eq!(page.text("polygon-step").await, "Step 6 of 7");
    page.click("polygons-all").await;
    page.settle().await;
    assert_eq!(page.text("polygon-step").await, "Step 7 of 7");
    // Coriolis' acceleration is among what the point of the lever has more than the pin.
    let said = page.text("polygon-equations").await;
    assert!(said.contains("line of link 3"), "{said}");
    page.close().await;
}

/// Of a group that is no dyad it is said so; what does not move has no polygons; a dead point has none, and says why.
#[tokio::test]
async fn polygons_say_where_there_are_none() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("40").await;
    shown(&page).await;
    let said = page.text("polygon-equations").await;
    assert!(said.contains("no dyad"), "{said}");
    open(&page, "triple-rocker").await;
    page.stop_at("1000").await;
    let none = "const none = document.getElementById('polygon-none'); return !none.hidden && none.textContent.includes('dead point')";
    page.until("the reason", async || page.ask(none).await == json!(true))
        .await;
    page.close().await;
}

/// On a phone both are within the page's width, and as wide as it.
#[tokio::test]
async fn polygons_on_a_phone() {
    let page = Page::open().await;
    let phone = json!({ "width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": true });
    page.tool("Emulation.setDeviceMetricsOverride", phone).await;
    page.stop_at("75").await;
    shown(&page).await;
    page.settle().await;
    let wide = page
        .numbers("return [document.documentElement.scrollWidth, document.getElementById('polygon-velocity').clientWidth]")
        .await;
    assert!(wide[0] <= 360.0 && wide[1] > 250.0, "{wide:?}");
    assert!(painted(&page, "velocity").await > 500);
    page.close().await;
}
