//! A path by nine points, and cognates.

use assur::synthesis::cognates::CouplerFourBar;
use assur::synthesis::path::{CURVES, POINTS};
use assur::{Assembly, FourBar, Point};
use assur_file::{PathDocument, TracingDocument};
use assur_tests::assert_near;
use assur_tests::files::preset;
use nalgebra::Complex;

use super::{LANGUAGES, LESSON};

/// The shown linkage of the step on cognates: A, D, B, C, P.
fn linkage() -> ([Point; 5], PathDocument) {
    let document: PathDocument =
        serde_json::from_value(preset("poses-paths", "cognates").unwrap()).unwrap();
    let Some(TracingDocument::FourBar {
        pivots: [a, d],
        joints: [b, c],
        point,
    }) = document.linkage
    else {
        panic!("a four-bar");
    };
    ([a, d, b, c, point].map(Point::from), document)
}

/// Each four-bar is counted twice, and each curve has three. The 21 real curves are counted in `tests/nine_points.rs`.
#[test]
fn numbers_of_four_bars_through_nine_points() {
    let dimensions = [2, 2, 3, 2];
    assert_eq!(dimensions.iter().sum::<usize>(), POINTS);
    let count = CURVES as f64;
    for lang in LANGUAGES {
        let expected = [1923.0, 1992.0, 6.0 * count, 3.0 * count, count];
        LESSON.tells(lang, "nine.text", &expected);
        LESSON.tells(lang, "nine.question", &[count]);
    }
}

/// In every pose the corners of the two triangles and P make a parallelogram with the same third pivot.
#[test]
fn the_third_pivot_stands_still() {
    let ([a, d, b, c, p], document) = linkage();
    let complex = |at: Point| Complex::new(at.x, at.y);
    let [a, d, b, c, p] = [a, d, b, c, p].map(complex);
    let w = (p - b) / (c - b);
    let pivot = a + w * (d - a);
    let lengths = [b - a, c - b, c - d, d - a].map(|side| side.norm());
    let bar = FourBar::new(lengths).unwrap();
    for (k, [x, y]) in (0..).zip(&document.path) {
        let pose = bar.pose::<1>(Assembly::First, f64::from(90 + 45 * k).to_radians());
        let pose = pose.unwrap();
        let b = a + Complex::from_polar(lengths[0], f64::from(90 + 45 * k).to_radians());
        let c = b + Complex::from_polar(lengths[1], pose.coupler.value());
        let p = b + w * (c - b);
        assert!((p - Complex::new(*x, *y)).norm() < 1e-9);
        // The triangles stand on A′P and D′P.
        let [left, right] = [a + p - b, d + p - c];
        let one = left + w * (p - left);
        let other = p + w * (right - p);
        assert!((one + other - p - pivot).norm() < 1e-12);
    }
    let sides = [d - a, pivot - d, a - pivot].map(|side| side.norm());
    let least = sides.into_iter().fold(f64::INFINITY, f64::min);
    assert_near(least, 20.0, 1e-12, "the shortest side");
    assert_near(
        least,
        (a - pivot).norm(),
        1e-12,
        "the side of A and the third pivot",
    );
    let back = |at: Complex<f64>| Point::new(at.re, at.im);
    let found = CouplerFourBar::new([back(a), back(d)], [back(b), back(c)], back(p)).unwrap();
    assert!((found.third_pivot() - back(pivot)).norm() < 1e-12);
    let notes = LESSON.file("notes.en.md");
    let [x, y] = [pivot.re, pivot.im].map(f64::round);
    let told = format!(
        "{least:.0} mm. C₀ is at ({x}; {y}), and the other sides are {:.0} and {:.1} mm",
        sides[0], sides[1]
    );
    assert!(notes.contains(&told), "{told}");
    for lang in LANGUAGES {
        let written = [1875.0, 1878.0, lengths[1], (p - b).norm(), lengths[3]];
        LESSON.tells(lang, "cognates.text", &written);
    }
}
