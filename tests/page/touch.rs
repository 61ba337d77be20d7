//! Everything by touch, on a phone: taps, drags of joints, two fingers, slides over
//! sliders and plots; a swipe still scrolls the page.

use assur::mixer::Case;
use assur::{Assembly, Point, Vector};
use assur_tests::assert_near;
use serde_json::json;

use crate::browser::Page;
use crate::browser::setting::lacking;
use crate::hands::{View, column, joints, lengths};

/// The page on a phone, at rest at 60°.
async fn phone() -> Page {
    let page = Page::open().await;
    page.stop_at("60").await;
    page.touched().await;
    page.screen((390, 844), 2.0).await;
    page
}

/// Scrolls an element to the lower end of the screen, where nothing sticks: again if a part of the page that arrives late
/// has moved it.
async fn show(page: &Page, id: &str) {
    page.until("the middle in sight", async || {
        page.ask(&format!(
            "document.getElementById('{id}').scrollIntoView({{ block: 'end', behavior: 'instant' }})"
        ))
        .await;
        page.settle().await;
        let script = format!(
            "const {{ top, bottom }} = document.getElementById('{id}').getBoundingClientRect();
            const middle = (top + bottom) / 2;
            return middle > 0 && middle < innerHeight;"
        );
        page.ask(&script).await == json!(true)
    })
    .await;
}

/// A finger on the middle of an element.
pub(crate) async fn tap(page: &Page, id: &str) {
    page.element(id).await;
    show(page, id).await;
    let area = page.element(id).await.rect().await.unwrap();
    page.fingers(id, &[vec![(0.5 * area.width, 0.5 * area.height)]])
        .await;
    page.settle().await;
}

/// A finger over an element, from and to shares of its width.
async fn slide(page: &Page, id: &str, from: f64, to: f64) {
    show(page, id).await;
    let area = page.element(id).await.rect().await.unwrap();
    let at = |step: f64| {
        let share = from + step * (to - from);
        vec![(share * area.width, 0.5 * area.height)]
    };
    page.fingers(id, &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0].map(at))
        .await;
}

#[tokio::test]
async fn controls_are_tapped() {
    let page = phone().await;
    let playing = async || page.attribute("play", "data-playing").await;
    tap(&page, "play").await;
    assert_eq!(playing().await.as_deref(), Some("true"));
    tap(&page, "play").await;
    assert_eq!(playing().await.as_deref(), Some("false"));
    let before = page.value("out-input").await;
    tap(&page, "transport-more").await;
    tap(&page, "step-forward").await;
    assert_near(page.value("out-input").await, before + 1.0, 1e-9, "a step");

    for overlay in [
        "traces",
        "centres",
        "vectors",
        "loop_vectors",
        "transmission",
    ] {
        let before = page.element(overlay).await.is_selected().await.unwrap();
        tap(&page, overlay).await;
        let after = page.element(overlay).await.is_selected().await.unwrap();
        assert_ne!(after, before, "{overlay}");
    }
    tap(&page, "mesh-internal").await;
    assert_near(page.value("out-ratio").await, 2.0, 1e-15, "mesh");
    tap(&page, "assembly-2").await;
    assert!(page.value("out-rocker.angle").await < 0.0);
    tap(&page, "undo").await;
    assert!(page.value("out-rocker.angle").await > 0.0);
    tap(&page, "preset-b").await;
    let pressed = page.attribute("preset-b", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    tap(&page, "menu").await;
    tap(&page, "reset").await;
    tap(&page, "menu").await;
    tap(&page, "projector").await;
    let pressed = page.attribute("projector", "aria-pressed").await;
    assert_eq!(pressed.as_deref(), Some("true"));
    page.close().await;
}

#[tokio::test]
async fn sliders_and_plots_are_slid() {
    let page = phone().await;
    slide(&page, "scrubber", 0.2, 0.75).await;
    let phi = page.value("out-input").await;
    assert!((phi - 270.0).abs() < 12.0, "{phi}");
    slide(&page, "slider-l2", 0.55, 0.7).await;
    let l2 = lengths(&page).await[1];
    assert!((0.95..1.15).contains(&l2), "{l2}");
    // The slide was one step.
    tap(&page, "undo").await;
    assert_eq!(lengths(&page).await[1], 0.85);

    show(&page, "charts").await;
    let mut way = Vec::new();
    for degrees in [100.0, 150.0, 200.0, 250.0] {
        way.push(vec![(column(&page, degrees).await, 500.0)]);
    }
    page.fingers("charts", &way).await;
    let phi = page.value("out-input").await;
    assert!((phi - 250.0).abs() < 1.5, "{phi}");

    if lacking("fingers of a driver that scroll") {
        page.close().await;
        return;
    }
    // Up and down the finger scrolls the page and drives nothing.
    let scrolled = async || page.ask("return scrollY").await.as_f64().unwrap();
    let before = scrolled().await;
    let swipe = [520.0, 500.0, 470.0, 440.0, 410.0, 380.0].map(|y| vec![(way[0][0].0, y)]);
    page.fingers("charts", &swipe).await;
    page.until("the page to scroll", async || {
        scrolled().await > before + 50.0
    })
    .await;
    assert_eq!(page.value("out-input").await, phi);
    page.close().await;
}

#[tokio::test]
async fn joints_are_dragged_and_two_fingers_zoom() {
    let page = phone().await;
    let start = Case::A.dimensions().lengths;
    let view = View::of(&page).await;
    let drag = async |from: Point, to: Point| {
        let way = [0.0, 0.3, 0.6, 1.0].map(|share| vec![view.at(from + share * (to - from))]);
        page.fingers("mechanism", &way).await;
    };
    let [a, b, c, d] = joints(start, Assembly::First, 60.0);
    drag(b, a + Vector::new(-0.3, 0.3)).await;
    let phi = page.value("out-input").await;
    assert!((phi - 135.0).abs() < 1.0, "{phi}");
    assert_eq!(lengths(&page).await, start);
    page.write("angle", "60").await;

    let to = c + Vector::new(0.05, 0.1);
    drag(c, to).await;
    let now = lengths(&page).await;
    assert_near(now[1], (to - b).norm(), 2.0 / view.scale, "l2");
    assert_near(now[2], (to - d).norm(), 2.0 / view.scale, "l3");
    tap(&page, "preset-a").await;
    show(&page, "mechanism").await;
    drag(d, Point::new(0.75, 0.0)).await;
    assert_near(lengths(&page).await[3], 0.75, 2.0 / view.scale, "l4");
    tap(&page, "preset-a").await;
    page.ask("scrollTo(0, 0)").await;

    // A finger beside the joints scrolls; two zoom; then one moves the drawing.
    let zoom = async || -> f64 {
        let zoom = page.attribute("mechanism", "data-zoom").await.unwrap();
        zoom.parse().unwrap()
    };
    let pinch = [40.0, 55.0, 70.0, 80.0].map(|r| vec![(195.0 - r, 40.0), (195.0 + r, 40.0)]);
    page.fingers("mechanism", &pinch).await;
    assert_near(zoom().await, 2.0, 0.05, "two fingers");
    let before = page.picture("mechanism").await;
    page.fingers(
        "mechanism",
        &[(30.0, 40.0), (60.0, 60.0), (90.0, 80.0)].map(|place| vec![place]),
    )
    .await;
    assert!(page.picture("mechanism").await.difference(&before) > 2000);
    assert_eq!(page.ask("return scrollY").await, json!(0));
    tap(&page, "zoom-fit").await;
    assert_eq!(zoom().await, 1.0);
    page.close().await;
}
