//! What lecturers draw over a moving linkage: polygons of velocities and accelerations, lines and circles, and what is read of
//! them.

use assur_tests::assert_near;
use serde_json::json;
use thirtyfour::prelude::Key;

use crate::access::named_and_fits;
use crate::browser::Page;
use crate::export::{Csv, open_dialog};
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
        for (order, stroke) in [(1, "′"), (2, "″")] {
            let [x, y] = ["x", "y"].map(|way| format!("out-F.{way}{stroke}"));
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
    assert!(said.contains("not a dyad"), "{said}");
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

/// One scale for the whole motion where it is chosen, not that of the enlarged polygon; next to a dead point, where accelerations grow without bound, a smaller one, and it is
/// said.
#[tokio::test]
async fn polygons_keep_their_scale() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("0").await;
    shown(&page).await;
    page.click("polygons-scale").await;
    let pressed = page.attribute("polygons-scale", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    let scales = async || {
        let mut scales = Vec::new();
        for name in ["velocity", "acceleration"] {
            scales.push(page.text(&format!("polygon-{name}-scale")).await);
        }
        scales
    };
    let first = scales().await;
    for degrees in (30..360).step_by(30) {
        page.stop_at(&degrees.to_string()).await;
        assert_eq!(scales().await, first, "{degrees}");
    }
    // Watt's chain driven by its rocker comes to a dead point at 90°.
    open(&page, "watt-1").await;
    page.choose("driver", "rocker").await;
    page.settle().await;
    page.stop_at("105").await;
    let usual = scales().await;
    page.stop_at("115").await;
    assert_eq!(scales().await, usual);
    page.stop_at("90.1").await;
    let near = scales().await;
    assert!(near[1].contains("smaller scale here, 1 : "), "{near:?}");
    page.close().await;
}

/// The ellipse of a trammel has known radii and centres of curvature, and its rod an inflection circle as wide as it is long;
/// what has none says why. All of it is in the table, and goes with the switch.
#[tokio::test]
async fn curvature_is_read_out() {
    let page = Page::open().await;
    open(&page, "elliptic-trammel").await;
    page.click("curvature").await;
    page.until("the read-outs", async || {
        page.count("#curvature-readouts tr").await == 3
    })
    .await;
    // The half axes; the input is the angle of the ellipse, but for half a turn.
    let (a, b) = (4.0_f64, 2.0_f64);
    let radius = |t: f64| {
        let s = (a * t.sin()).powi(2) + (b * t.cos()).powi(2);
        let first = (a * a - b * b) * (2.0 * t).sin();
        let second = 2.0 * (a * a - b * b) * (2.0 * t).cos();
        [
            s.powf(1.5),
            1.5 * s.sqrt() * first,
            0.75 * first * first / s.sqrt() + 1.5 * s.sqrt() * second,
        ]
        .map(|value| value / (a * b))
    };
    for degrees in [20.0_f64, 75.0, 130.0] {
        page.stop_at(&degrees.to_string()).await;
        let t = degrees.to_radians();
        for (stroke, expected) in ["", "′", "″"].into_iter().zip(radius(t)) {
            let found = page.value(&format!("out-P.radius{stroke}")).await;
            assert_near(found, expected, 1e-8, &format!("{stroke} at {degrees}"));
        }
        let centre = [
            -(a * a - b * b) / a * t.cos().powi(3),
            -(b * b - a * a) / b * t.sin().powi(3),
        ];
        for (way, expected) in ["data-x", "data-y"].into_iter().zip(centre) {
            let found = page.attribute("out-P.centre", way).await.unwrap();
            assert_near(found.parse().unwrap(), expected, 1e-8, way);
        }
        assert_near(page.value("out-rod.inflection").await, 2.0, 1e-9, "D");
    }
    page.choose("about", "horizontal slider").await;
    page.choose("plot", "A").await;
    page.settle().await;
    let said = page.text("curvature-readouts").await;
    for reason in ["does not turn here", "The path of A is straight here"] {
        assert!(said.contains(reason), "{reason}: {said}");
    }
    named_and_fits(&page).await;
    page.choose("plot", "angles").await;
    open_dialog(&page).await;
    let csv = Csv::save(&page, "assur-elliptic-trammel.csv").await;
    let columns = [
        "P.radius_length",
        "P.dradius_length_per",
        "P.ddradius_length_per",
    ];
    for (column, expected) in columns.into_iter().zip(radius(1.0_f64.to_radians())) {
        assert_near(csv.value(1, column), expected, 1e-8, column);
    }
    page.keys(Key::Escape + "").await;
    page.click("curvature").await;
    page.until("nothing", async || {
        page.count("#curvature-readouts tr").await == 0
    })
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
