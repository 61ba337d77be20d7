//! Problems of textbooks drawn by events alone, in millimetres, with their numbers typed: what moves then is what the closed
//! forms of these problems give. (Whitworth, Stephenson III and Jansen are in `draw.rs`, the epicyclic train in `draw_wheels.rs`.)

use assur::motion::Motion;
use assur_file::{LengthUnit, LinkageDocument};
use thirtyfour::Key;

use crate::browser::Page;
use crate::draw::{Sheet, place};
use crate::draw_more::drawn;

/// An empty sheet in millimetres: of it a place `[x, y]` is 20 times that.
async fn in_millimetres<'a>(page: &'a Page) -> Sheet<'a> {
    let sheet = Sheet::new(page).await;
    page.choose("unit", "mm").await;
    page.click("zoom-fit").await;
    page.settle().await;
    sheet
}

/// The linkage that is drawn and its motion.
async fn motion(sheet: &Sheet<'_>) -> (LinkageDocument, Motion) {
    let document = drawn(sheet).await;
    assert_eq!(document.unit, Some(LengthUnit::Mm));
    let mechanism = document.mechanism();
    let mechanism = mechanism.unwrap_or_else(|problems| panic!("{problems:?}"));
    (document, Motion::new(mechanism))
}

/// Compares points at 72 inputs with closed forms of the input angle; in millimetres.
fn compare(motion: &Motion, names: &[&str], wanted: impl Fn(f64) -> Vec<[f64; 2]>) {
    for k in 0..72 {
        let input = motion.drawn_input() + f64::from(k) * 5_f64.to_radians();
        for (name, at) in names.iter().zip(wanted(input)) {
            let off = place(motion, input, name) - assur::Point::from(at);
            assert!(off.norm() < 1e-9 * 200.0, "{name} at {k}·5°: {off}");
        }
    }
}

/// A slider-crank of 50 and 200 mm whose guide is 20 mm below the pivot; the coupler carries a point 100 mm along and 40 mm
/// beside it.
#[tokio::test]
async fn an_offset_slider_crank_with_a_coupler_point() {
    let page = Page::open().await;
    let mut sheet = in_millimetres(&page).await;
    sheet.line(&[[0.0, 0.0], [1.2, 2.2], [5.0, -1.0]]).await;
    sheet.end().await;
    sheet.tool("slide").await;
    sheet.line(&[[5.0, -1.0], [3.0, -1.0]]).await;
    sheet.tool("tracer").await;
    sheet.press(3.1, 0.6).await;
    // The traced point stays selected while the crank is driven and all others are typed.
    sheet.tool("select").await;
    sheet.press(3.1, 0.6).await;
    sheet.mend().await;
    let tracer = drawn(&sheet).await.tracers[0].name.clone();
    assert_eq!(page.written("draw-name").await, tracer);
    let (r, l, e): (f64, f64, f64) = (50.0, 200.0, -20.0);
    let slider = |phi: f64| {
        let b = [r * phi.cos(), r * phi.sin()];
        [b, [b[0] + (l * l - (b[1] - e).powi(2)).sqrt(), e]]
    };
    let [b, c] = slider(60_f64.to_radians());
    let names: Vec<String> = drawn(&sheet).await.slides[0].line.to_vec();
    sheet.type_places(&[("A", [0.0, 0.0]), ("B", b)]).await;
    // As slowly as a person types: each digit is drawn before the next.
    for (axis, value) in ["x", "y"].iter().zip(c) {
        slowly(&page, &format!("draw-{axis}-C"), &value.to_string()).await;
    }
    for (name, x) in names.iter().zip([300.0, 100.0]) {
        sheet.type_places(&[(name, [x, e])]).await;
    }
    page.write("draw-along", "100").await;
    page.write("draw-across", "40").await;
    let (_, motion) = motion(&sheet).await;
    compare(&motion, &["B", "C", &tracer], |phi| {
        let [b, c] = slider(phi);
        let [cos, sin] = [(c[0] - b[0]) / l, (c[1] - b[1]) / l];
        let p = [
            b[0] + 100.0 * cos - 40.0 * sin,
            b[1] + 100.0 * sin + 40.0 * cos,
        ];
        vec![b, c, p]
    });
    page.close().await;
}

/// Types a text character by character, with a frame after each.
async fn slowly(page: &Page, id: &str, text: &str) {
    let field = page.element(id).await;
    field.click().await.unwrap();
    field.send_keys(Key::Control + "a").await.unwrap();
    for letter in text.chars() {
        field.send_keys(letter.to_string()).await.unwrap();
        page.settle().await;
    }
    field.send_keys(Key::Enter + "").await.unwrap();
    page.settle().await;
}

/// A five-bar of 40, 70, 70 and 40 mm on 60 mm whose second crank goes at −2 times the speed of the first.
#[tokio::test]
async fn a_five_bar_with_two_drivers() {
    let page = Page::open().await;
    let mut sheet = in_millimetres(&page).await;
    sheet
        .line(&[
            [0.0, 0.0],
            [1.0, 1.6],
            [1.6, 4.0],
            [3.6, 1.6],
            [3.0, 0.0],
            [3.0, 0.0],
        ])
        .await;
    sheet.tool("drive").await;
    sheet.line(&[[0.5, 0.8], [3.3, 0.8]]).await;
    page.keys(Key::Escape).await;
    let (b, d) = ([20.0, 34.64101615137754], [80.0, 34.64101615137754]);
    let joined = |b: [f64; 2], d: [f64; 2]| {
        let (dx, dy) = (d[0] - b[0], d[1] - b[1]);
        let half = dx.hypot(dy) / 2.0;
        let height = (70.0_f64 * 70.0 - half * half).sqrt() / (2.0 * half);
        [
            (b[0] + d[0]) / 2.0 - height * dy,
            (b[1] + d[1]) / 2.0 + height * dx,
        ]
    };
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("E", [60.0, 0.0]),
            ("B", b),
            ("D", d),
            ("C", joined(b, d)),
        ])
        .await;
    page.keys("d").await;
    page.write("field-rate-2", "-2").await;
    let (document, motion) = motion(&sheet).await;
    assert_eq!(document.drivers.len(), 2);
    let home = 60_f64.to_radians();
    compare(&motion, &["B", "D", "C"], |phi| {
        let psi = home - 2.0 * (phi - home);
        let b = [40.0 * phi.cos(), 40.0 * phi.sin()];
        let d = [60.0 + 40.0 * psi.cos(), 40.0 * psi.sin()];
        vec![b, d, joined(b, d)]
    });
    page.close().await;
}

/// A Class III platform, ten times as large as that of the catalogue.
#[tokio::test]
async fn a_platform_of_class_three() {
    let page = Page::open().await;
    let mut sheet = in_millimetres(&page).await;
    let at = |x: f64, y: f64| [x / 2.0 - 2.0, y / 2.0 - 1.5];
    sheet
        .line(&[
            at(0.0, 0.0),
            at(1.0, 0.4),
            at(1.0, 2.0),
            at(6.0, 3.2),
            at(6.0, 1.0),
            at(6.0, 1.0),
        ])
        .await;
    sheet.tool("plate").await;
    sheet.line(&[at(3.5, 2.6), at(2.8, 5.4)]).await;
    sheet.tool("bars").await;
    sheet
        .line(&[at(2.8, 5.4), at(1.0, 6.0), at(1.0, 6.0)])
        .await;
    sheet.tool("drive").await;
    sheet.press(at(0.5, 0.2)[0], at(0.5, 0.2)[1]).await;
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [6.0, 0.0]),
            ("C", [7.0, 19.0]),
            ("D", [57.0, 33.0]),
            ("E", [60.0, 11.0]),
            ("F", [28.0, 56.0]),
            ("G", [14.0, 59.0]),
        ])
        .await;
    let (_, motion) = motion(&sheet).await;
    let known = assur_file::from_catalogue("class3-platform")
        .unwrap()
        .unwrap();
    let known = Motion::new(known.mechanism().unwrap());
    assert_eq!(
        motion.mechanism().structure().class(),
        known.mechanism().structure().class()
    );
    for k in 0..72 {
        let by = f64::from(k) * 5_f64.to_radians();
        for (own, other) in [("C", "P"), ("D", "Q"), ("F", "R")] {
            let [at, wanted] = [
                place(&motion, motion.drawn_input() + by, own),
                place(&known, known.drawn_input() + by, other),
            ];
            let off = at.coords - 10.0 * wanted.coords;
            assert!(off.norm() < 1e-8, "{own} at {k}·5°: {off}");
        }
    }
    page.close().await;
}

/// A scotch yoke of 30 mm: the yoke is always below its pin.
#[tokio::test]
async fn a_scotch_yoke() {
    let page = Page::open().await;
    let mut sheet = in_millimetres(&page).await;
    sheet.line(&[[0.0, 0.0], [1.0, 1.0]]).await;
    sheet.end().await;
    // The yoke CD stands upright; its end is let go of the frame, and slides level.
    sheet.line(&[[1.0, -3.0], [1.0, 3.0]]).await;
    sheet.end().await;
    sheet.tool("fix").await;
    sheet.press(1.0, -3.0).await;
    sheet.tool("slide").await;
    sheet.line(&[[1.0, -2.0], [4.0, -3.0]]).await;
    // The pin slides along the yoke.
    sheet.line(&[[1.0, 1.0], [1.0, 2.0]]).await;
    sheet.tool("drive").await;
    sheet.press(0.5, 0.5).await;
    let (sine, cosine) = 60_f64.to_radians().sin_cos();
    let [x, y] = [30.0 * cosine, 30.0 * sine];
    let guide: Vec<String> = drawn(&sheet).await.slides[0].line.to_vec();
    sheet
        .type_places(&[
            ("A", [0.0, 0.0]),
            ("B", [x, y]),
            ("C", [x, -60.0]),
            ("D", [x, 60.0]),
        ])
        .await;
    for (name, at) in guide.iter().zip([-80.0, 80.0]) {
        sheet.type_places(&[(name, [at, -60.0])]).await;
    }
    let (_, motion) = motion(&sheet).await;
    compare(&motion, &["B", "C", "D"], |phi| {
        let [x, y] = [30.0 * phi.cos(), 30.0 * phi.sin()];
        vec![[x, y], [x, -60.0], [x, 60.0]]
    });
    page.close().await;
}
