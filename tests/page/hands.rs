//! Hands on plots and drawing: what a mouse and fingers do there.

use assur::mixer::{Case, Dimensions, Mixer};
use assur::{Assembly, FourBar, Point};
use assur_draw::{Annotations, Figure, View as Drawing};
use assur_tests::assert_near;

use crate::browser::Page;

/// The chart's margins, pixels.
const LEFT: f64 = 44.0;
const RIGHT: f64 = 10.0;

/// Pixels on the edges of things that may differ between pictures of the same.
const SAME: usize = 20;

/// Where the plots have a crank angle.
pub(crate) async fn column(page: &Page, degrees: f64) -> f64 {
    let width = page.element("charts").await.rect().await.unwrap().width;
    LEFT + (width - LEFT - RIGHT) * degrees / 360.0
}

#[tokio::test]
async fn plots_drive_the_crank() {
    let page = Page::open().await;
    let places = [
        (column(&page, 90.0).await, 60.0),
        (column(&page, 200.0).await, 200.0),
        (column(&page, 300.0).await, 210.0),
    ];
    // It plays; a click stops it there.
    page.drag_along("charts", &places[..1]).await;
    assert_eq!(
        page.attribute("play", "data-playing").await.as_deref(),
        Some("false")
    );
    assert!((page.value("out-input").await - 90.0).abs() < 1.0);
    let before = page.picture("mechanism").await;
    page.drag_along("charts", &places).await;
    assert!((page.value("out-input").await - 300.0).abs() < 1.0);
    assert!(page.picture("mechanism").await.difference(&before) > 2000);
    // Beyond its end a drag stays at the end.
    page.drag_along("charts", &[places[2], (2.0, 200.0)]).await;
    assert_eq!(page.value("out-input").await, 0.0);
    page.close().await;
}

#[tokio::test]
async fn plots_show_values_under_the_pointer() {
    let page = Page::open().await;
    page.stop_at("90").await;
    let plain = page.picture("chart-cursor").await;
    page.hover("charts", (column(&page, 250.0).await, 150.0))
        .await;
    let hovered = page.picture("chart-cursor").await;
    assert!(hovered.difference(&plain) > 400);
    let under = page.attribute("charts", "data-hover").await.unwrap();
    assert!(
        (under.parse::<f64>().unwrap() - 250.0).abs() < 1.0,
        "{under}"
    );
    assert_eq!(page.value("out-input").await, 90.0);
    page.hover("mechanism", (9.0, 9.0)).await;
    assert_eq!(
        page.attribute("charts", "data-hover").await.as_deref(),
        Some("")
    );
    assert_eq!(page.picture("chart-cursor").await.difference(&plain), 0);
    page.close().await;
}

#[tokio::test]
async fn fingers_drive_the_crank() {
    let page = Page::open().await;
    page.stop_at("10").await;
    let mut slide = Vec::new();
    for degrees in [100.0, 150.0, 200.0, 250.0] {
        slide.push(vec![(column(&page, degrees).await, 90.0)]);
    }
    page.fingers("charts", &slide).await;
    assert!((page.value("out-input").await - 250.0).abs() < 1.0);
    page.fingers("charts", &slide[..1]).await; // a tap
    assert!((page.value("out-input").await - 100.0).abs() < 1.0);
    page.close().await;
}

/// The view of the drawing: pixels per metre and where A is, from the bounds of
/// the mechanism as the page fits them.
pub(crate) struct View {
    pub(crate) scale: f64,
    left: f64,
    top: f64,
}

impl View {
    pub(crate) async fn of(page: &Page) -> Self {
        Self::showing(page, &Case::A.dimensions()).await
    }

    pub(crate) async fn showing(page: &Page, dimensions: &Dimensions) -> Self {
        let area = page.element("mechanism").await.rect().await.unwrap();
        let mixer = Mixer::new(dimensions).unwrap();
        let [left, bottom, right, top] = bounds(&mixer);
        let scale =
            ((area.width - 88.0) / (right - left)).min((area.height - 88.0) / (top - bottom));
        Self {
            scale,
            left: 0.5 * area.width - 0.5 * scale * (left + right),
            top: 0.5 * area.height + 0.5 * scale * (top + bottom),
        }
    }

    pub(crate) fn at(&self, p: Point) -> (f64, f64) {
        (self.left + self.scale * p.x, self.top - self.scale * p.y)
    }
}

fn bounds(mixer: &Mixer) -> [f64; 4] {
    let view = Drawing {
        annotations: Annotations::from(mixer),
        ..Drawing::default()
    };
    let motion = mixer.motion().unwrap();
    let figure = Figure::new(&motion, &view);
    figure.unwrap().bounds()
}

pub(crate) fn joints(lengths: [f64; 4], assembly: Assembly, degrees: f64) -> [Point; 4] {
    let linkage = FourBar::new(lengths).unwrap();
    let pose = linkage.pose::<1>(assembly, degrees.to_radians()).unwrap();
    linkage.joints(&pose).map(|joint| joint.place())
}

pub(crate) async fn lengths(page: &Page) -> [f64; 4] {
    let mut lengths = [0.0; 4];
    for (length, field) in lengths.iter_mut().zip(["l1", "l2", "l3", "l4"]) {
        let written = page.written(&format!("field-{field}")).await;
        *length = written.parse().unwrap();
    }
    lengths
}

#[tokio::test]
async fn dragging_b_drives_the_crank() {
    let page = Page::open().await;
    page.stop_at("60").await;
    let view = View::of(&page).await;
    let start = Case::A.dimensions().lengths;
    let [a, b, ..] = joints(start, Assembly::First, 60.0);
    let to = a + assur::Vector::new(-0.3, 0.3);
    page.drag_along(
        "mechanism",
        &[view.at(b), (view.at(b).0 - 40.0, view.at(b).1), view.at(to)],
    )
    .await;
    assert!((page.value("out-input").await - 135.0).abs() < 0.6);
    assert_eq!(lengths(&page).await, start);
    page.close().await;
}

#[tokio::test]
async fn dragging_c_changes_coupler_and_rocker() {
    let page = Page::open().await;
    page.stop_at("60").await;
    let view = View::of(&page).await;
    let start = Case::A.dimensions().lengths;
    let [_, b, c, d] = joints(start, Assembly::First, 60.0);
    // Up, then from the start over the diagonal: the assembly follows.
    for (to, assembly, radio) in [
        (Point::new(1.1, 0.62), Assembly::First, "assembly-1"),
        (Point::new(0.55, -0.3), Assembly::Second, "assembly-2"),
    ] {
        page.click("preset-a").await;
        let before = page.picture("charts").await;
        let way = [c, c + (to - c) * 0.5, to].map(|place| view.at(place));
        page.drag_along("mechanism", &way).await;
        let now = lengths(&page).await;
        assert_eq!([now[0], now[3]], [start[0], start[3]]);
        assert_near(now[1], (to - b).norm(), 2.0 / view.scale, "l2");
        assert_near(now[2], (to - d).norm(), 2.0 / view.scale, "l3");
        let chosen = page.element(radio).await.is_selected().await.unwrap();
        assert!(chosen, "{radio}");
        let there = joints(now, assembly, 60.0)[2];
        assert!((there - to).norm() < 2.0 / view.scale, "{there} {to}");
        assert!(page.picture("charts").await.difference(&before) > 500);
    }
    page.close().await;
}

#[tokio::test]
async fn dragging_d_moves_along_the_frame() {
    let page = Page::open().await;
    page.stop_at("60").await;
    let view = View::of(&page).await;
    let start = Case::A.dimensions().lengths;
    let [.., c, d] = joints(start, Assembly::First, 60.0);
    let to = Point::new(0.7, 0.1);
    page.drag_along("mechanism", &[view.at(d), view.at(to)])
        .await;
    let now = lengths(&page).await;
    assert_eq!([now[0], now[1]], [start[0], start[1]]);
    assert_near(now[3], 0.7, 2.0 / view.scale, "l4");
    let there = joints(now, Assembly::First, 60.0)[2];
    assert!((there - c).norm() < 1e-5, "{there} {c}");
    page.click("preset-a").await;
    // To where no mechanism is: a sentence, and the last good one stays.
    page.drag_along("mechanism", &[view.at(d), view.at(Point::new(-0.5, 0.0))])
        .await;
    assert_ne!(page.text("problem").await, "");
    assert_eq!(
        page.attribute("mechanism", "data-faded").await.as_deref(),
        Some("true")
    );
    page.click("preset-a").await;
    assert_eq!(page.text("problem").await, "");
    page.close().await;
}

#[tokio::test]
async fn zooms_pans_and_fits() {
    let page = Page::open().await;
    page.stop_at("60").await;
    let fitted = page.picture("mechanism").await;
    let zoom = async || -> f64 {
        let zoom = page.attribute("mechanism", "data-zoom").await.unwrap();
        zoom.parse().unwrap()
    };
    page.click("zoom-in").await;
    assert_near(zoom().await, 1.3, 1e-12, "a press of +");
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&fitted) > 3000);
    // It stays while playing and editing.
    page.click("zoom-in").await;
    page.write("angle", "100").await;
    page.write("field-l2", "0.9").await;
    assert_near(zoom().await, 1.69, 1e-12, "a second press");
    page.click("preset-a").await;
    assert_eq!(zoom().await, 1.0);
    page.write("angle", "60").await;
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&fitted) < SAME);

    // The wheel leaves what is under it where it is: joint C can still be taken.
    let view = View::of(&page).await;
    let [_, _, c, d] = joints(Case::A.dimensions().lengths, Assembly::First, 60.0);
    page.wheel("mechanism", view.at(c), -400.0).await;
    assert!(zoom().await > 1.5, "{}", zoom().await);
    page.drag_along(
        "mechanism",
        &[view.at(c), (view.at(c).0, view.at(c).1 - 30.0)],
    )
    .await;
    let factor = zoom().await;
    let to = c + assur::Vector::new(0.0, 30.0 / (view.scale * factor));
    assert_near(
        lengths(&page).await[2],
        (to - d).norm(),
        1.5 / view.scale,
        "l3",
    );
    page.click("zoom-fit").await;
    page.click("preset-a").await;

    // Empty paper is panned; a double click fits again.
    page.click("zoom-in").await;
    let before = page.picture("mechanism").await;
    page.drag_along("mechanism", &[(30.0, 40.0), (60.0, 70.0), (90.0, 80.0)])
        .await;
    assert!(page.picture("mechanism").await.difference(&before) > 3000);
    page.double_click("mechanism", (30.0, 40.0)).await;
    assert_eq!(zoom().await, 1.0);
    page.hover("mechanism", (9.0, 9.0)).await;
    assert!(page.picture("mechanism").await.difference(&fitted) < SAME);

    // Two fingers, twice as far apart in the end.
    let pinch = [40.0, 55.0, 70.0, 80.0].map(|r| vec![(200.0 - r, 120.0), (200.0 + r, 120.0)]);
    page.fingers("mechanism", &pinch).await;
    assert_near(zoom().await, 2.0, 0.05, "two fingers");
    page.close().await;
}
