//! What lecturers draw over a moving linkage: polygons of velocities and accelerations.

use serde_json::json;

use crate::browser::Page;
use crate::gallery::open;

async fn shown(page: &Page) {
    let ticked = "return document.getElementById('polygons').checked";
    if page.ask(ticked).await != json!(true) {
        page.click("polygons").await;
    }
    page.until("the polygons", async || {
        page.count("#polygon-equations li").await > 0
    })
    .await;
}

/// The size of a point's velocity or acceleration, order 1 or 2, as it is written beside its equation.
async fn of(page: &Page, point: &str, order: u32) -> f64 {
    let selector = format!("#polygon-equations [data-point='{point}'][data-order='{order}']");
    let script = format!("return Number(document.querySelector(\"{selector}\").dataset.value)");
    page.ask(&script).await.as_f64().unwrap()
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
    page.until("the address", async || {
        page.address().await.contains("v.polygons=true")
    })
    .await;
    let here = page.picture("polygon-velocity").await;
    page.stop_at("30").await;
    let there = page.picture("polygon-velocity").await;
    assert!(there.difference(&here) > 500);
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
    let all = page.picture("polygon-acceleration").await;
    page.click("polygons-next").await;
    page.settle().await;
    assert_eq!(page.text("polygon-step").await, "Step 1 of 7");
    let mut before = page.picture("polygon-acceleration").await;
    for step in 2..=steps {
        page.focus("polygons-next").await;
        page.keys(" ").await;
        page.settle().await;
        assert_eq!(page.text("polygon-step").await, format!("Step {step} of 7"));
        assert_eq!(page.count("#polygon-equations li").await, step);
        let now = page.picture("polygon-acceleration").await;
        let new = now.difference(&before);
        assert!(new > 50, "{new} at {step}");
        // Of the lever's point on the pin the first equation tells no size.
        let found = page.count("#polygon-equations [data-point='B3']").await;
        assert_eq!(found, if step >= 4 { 2 } else { 0 }, "{step}");
        before = now;
    }
    assert!(before.difference(&all) < 20);
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

/// Of a group that is no dyad it is said so; a dead point has none, and says why.
#[tokio::test]
async fn polygons_say_where_there_are_none() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("40").await;
    shown(&page).await;
    let said = page.text("polygon-equations").await;
    assert!(said.contains("no dyad"), "{said}");
    // Watt's chain driven by its rocker has a dead point at 90°.
    open(&page, "watt-1").await;
    shown(&page).await;
    page.choose("driver", "rocker").await;
    page.settle().await;
    page.stop_at("90").await;
    let none = "const none = document.getElementById('polygon-none'); return !none.hidden && none.textContent.includes('dead point')";
    page.until("the reason", async || page.ask(none).await == json!(true))
        .await;
    page.close().await;
}

/// On a phone both are within the page's width, and as wide as it.
#[tokio::test]
async fn polygons_on_a_phone() {
    let page = Page::open().await;
    page.screen((360, 740), 2.0).await;
    page.stop_at("75").await;
    shown(&page).await;
    page.settle().await;
    let wide = page
        .ask("return [document.documentElement.scrollWidth, document.getElementById('polygon-velocity').clientWidth]")
        .await;
    let [whole, sheet]: [f64; 2] = serde_json::from_value(wide).unwrap();
    assert!(whole <= 360.0 && sheet > 250.0, "{sheet} of {whole}");
    page.close().await;
}

/// Instant centres, centrodes and circles come and go; of which link they are is chosen where one of them is shown, and
/// is in the address.
#[tokio::test]
async fn lines_over_the_drawing() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("30").await;
    let hidden = "return document.getElementById('about-link').hidden";
    assert_eq!(page.ask(hidden).await, json!(true));
    let plain = page.picture("mechanism").await;
    for lines in ["instant_centres", "centrodes", "curvature"] {
        page.click(lines).await;
        page.settle().await;
        assert_eq!(page.ask(hidden).await, json!(false), "{lines}");
        let coupler = page.picture("mechanism").await;
        assert!(coupler.difference(&plain) > 200, "{lines}");
        page.choose("about", "foot").await;
        page.settle().await;
        page.until("the address", async || {
            page.address().await.contains("v.about=foot")
        })
        .await;
        let foot = page.picture("mechanism").await;
        assert!(foot.difference(&coupler) > 100, "{lines}");
        if lines == "instant_centres" {
            // Against another link two other lines give another centre.
            page.choose("relative_to", "crank").await;
            page.settle().await;
            let against = page.picture("mechanism").await;
            assert!(against.difference(&foot) > 100);
            page.choose("relative_to", "").await;
        }
        // They follow the crank.
        page.stop_at("50").await;
        let on = page.picture("mechanism").await;
        page.click(lines).await;
        page.settle().await;
        let off = page.picture("mechanism").await;
        assert!(off.difference(&on) > 200, "{lines}");
        page.choose_first_coupler().await;
        page.stop_at("30").await;
        assert!(page.picture("mechanism").await.difference(&plain) < 20);
    }
    page.close().await;
}

impl Page {
    /// Back to the usual link, though nothing shows it.
    async fn choose_first_coupler(&self) {
        let back = "const about = document.getElementById('about'); about.value = ''; about.dispatchEvent(new Event('change', { bubbles: true })); return true";
        self.ask(back).await;
        self.settle().await;
    }
}
