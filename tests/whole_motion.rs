//! Readings of a whole motion: as fine over many turns as over one, as exact for a small part as for a large one.

mod coincident_hinges;
mod extrema;
mod turns;

use std::f64::consts::{PI, TAU};
use std::fs;

use assur::mechanism::{Defect, Dimension, DriverSpec, LinkageSpec, Mechanism, Quantity};
use assur::motion::{Column, InputRate, Motion, OutputProfile, Refusal};
use assur::{Swing, Vector};
use assur_draw::chart::Settings;
use assur_draw::svg::Svg;
use assur_draw::{Figure, View};
use assur_file::from_text;
use assur_tests::files::root;

fn file(name: &str) -> Motion {
    let path = root().join(format!("tests/data/drawings/{name}.json"));
    let text = fs::read_to_string(path).unwrap();
    from_text(&text).unwrap().motion().unwrap()
}

fn moved(draft: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

fn quantity(motion: &Motion, name: &str) -> Quantity {
    Quantity::named(motion.mechanism(), name).unwrap()
}

/// The numbers behind a letter or an attribute of a text, one after the other.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|letter: char| !(letter.is_ascii_digit() || "-.e".contains(letter)));
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// Units of a plot's curves and dots in a pixel. The dots have a radius of three pixels.
const UNITS: f64 = 16.0;

/// The chart of a quantity as it is drawn: the points of each curve, and the places of the dots at its extrema.
fn drawn(motion: &Motion, name: &str) -> (Vec<Vec<[f64; 2]>>, Vec<[f64; 2]>) {
    let figure = Figure::new(motion, &View::default()).unwrap();
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let mut sheet = Svg::new(20_000.0);
    sheet.chart(
        2000.0,
        &figure.chart(&[quantity(motion, name)], settings),
        "φ",
    );
    let text = sheet.finish(name);
    let attribute = |line: &str, name: &str| {
        let (_, rest) = line.split_once(&format!("{name}=\""))?;
        Some(rest.split_once('"')?.0.to_owned())
    };
    let lines = text.lines().filter(|line| line.starts_with("<polyline"));
    let curves = lines
        .filter_map(|line| attribute(line, " points"))
        .map(|points| {
            let places = numbers(&points);
            let pixels = places
                .chunks_exact(2)
                .map(|at| [at[0], at[1]].map(|unit| unit / UNITS));
            pixels.collect()
        });
    // What has more than a few points is a curve, not a line of the grid.
    let curves = curves.filter(|curve: &Vec<[f64; 2]>| curve.len() > 9);
    let dots = text.lines().filter(|line| line.contains("<circle"));
    let dots = dots.filter(|line| attribute(line, " r").as_deref() == Some("48"));
    let dots = dots.map(|line| ["cx", "cy"].map(|name| attribute(line, name).unwrap()));
    let dots = dots.map(|at| at.map(|x| x.parse::<f64>().unwrap() / UNITS));
    (curves.collect(), dots.collect())
}

/// A motion of 31 turns is plotted with as many samples to a turn as one of a single turn: marked extrema lie on the curve.
#[test]
fn plots_of_many_turns_are_as_fine_as_of_one() {
    let motion = file("many-turns");
    let (curves, dots) = drawn(&motion, "C.x");
    let [value, rate, second] = &curves[..] else {
        panic!("{} curves", curves.len());
    };
    for curve in [value, rate, second] {
        assert!(curve.len() >= 31 * 720, "{}", curve.len());
    }
    // Two extrema to a turn, each order; zeros have dots of the same size.
    assert!(dots.len() > 3 * 2 * 31, "{}", dots.len());
    for [x, y] in dots {
        let lines = curves.iter().flat_map(|curve| curve.windows(2));
        let off = lines.map(|line| {
            let [a, b] = [line[0], line[1]].map(|at| Vector::new(at[0] - x, at[1] - y));
            let along = b - a;
            let share = (-a.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (a + share * along).norm()
        });
        let off = off.fold(f64::INFINITY, f64::min);
        assert!(off < 0.2, "{x} {y}: {off}");
    }
}

/// Of wheels that mesh anew only after 974 153 turns the plot shows whole turns, never a curve between far samples; what is
/// extreme is not marked.
#[test]
fn plots_of_very_many_turns_are_of_whole_ones() {
    let motion = file("hunting-wheels");
    let (curves, dots) = drawn(&motion, "T.x");
    assert!(dots.is_empty());
    assert!(curves.len() > 1000);
    for curve in curves {
        let xs = curve.iter().map(|at| at[0]);
        let [first, last] = xs.fold([f64::INFINITY, 0.0], |[a, b], x: f64| [a.min(x), b.max(x)]);
        // A turn is a hundredth of a pixel.
        assert!(last - first < 0.2, "{first} {last}");
    }
}

/// A five-bar with a second crank at another rate, and a slide that its joint C pushes to and fro along the axis.
fn pushed(rate: f64) -> Motion {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.6, 0.8)
        .point("C", 2.2, 3.1)
        .point("D", 3.9, 0.7)
        .point("E", 4.0, 0.0)
        .point("S", 7.0, 1.0)
        .point("G", 0.0, 1.0)
        .point("H", 9.0, 1.0)
        .fixed(&["A", "E", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("DC", &["D", "C"])
        .bar("second", &["E", "D"])
        .bar("rod", &["C", "S"])
        .bar("slider", &["S"])
        .slide("slider", "S", "frame", ["G", "H"])
        .crank("crank");
    draft.drivers.push(DriverSpec::Crank {
        link: "second".to_owned(),
        base: "frame".to_owned(),
        rate,
    });
    moved(&draft)
}

/// The way of a slide, from which it becomes the driver, is exact in a motion of 24 turns as in one of one.
#[test]
fn a_slides_range_is_exact_over_many_turns() {
    for (rate, turns) in [(1.0, 1.0), (25.0 / 24.0, 24.0)] {
        let motion = pushed(rate);
        assert_eq!(motion.cycle().period(), Some(turns * TAU));
        let driver = motion.driver("slider").unwrap().unwrap();
        let DriverSpec::Slide { range, .. } = driver else {
            panic!("{driver:?}");
        };
        let s = motion.mechanism().point("S").unwrap();
        let way = motion.telling(|pose: &assur::mechanism::Pose<1>| {
            motion.mechanism().place(pose, s).place().x
        });
        let count = 20_000.0 * turns;
        let inputs = (0..count as usize).map(|k| turns * TAU * k as f64 / count);
        let ways = inputs.map(|input| way(input).unwrap());
        let sampled = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
            [a.min(x), b.max(x)]
        });
        // Samples fall short by no more than the curve bends between two of them.
        assert!(
            range[0] <= sampled[0] && sampled[0] - range[0] < 1e-6,
            "{range:?} {sampled:?}"
        );
        assert!(
            range[1] >= sampled[1] && range[1] - sampled[1] < 1e-6,
            "{range:?} {sampled:?}"
        );
        assert!(range[1] - range[0] > 0.1, "{range:?}");
    }
}

/// A crank-rocker with a dyad on its rocker that is `size` as large as all else.
fn small_dyad(size: f64) -> Motion {
    let at = Vector::new(4.0, 0.0);
    let small = [[0.9, 0.3], [1.9, 1.4], [2.4, -0.2]].map(|[x, y]| at + size * Vector::new(x, y));
    let [q, e, f] = small;
    moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 3.2, 2.9)
            .point("D", 4.0, 0.0)
            .point("Q", q.x, q.y)
            .point("E", e.x, e.y)
            .point("F", f.x, f.y)
            .fixed(&["A", "D", "F"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C", "Q"])
            .bar("QE", &["Q", "E"])
            .bar("FE", &["F", "E"])
            .crank("crank"),
    )
}

/// The least transmission angle of a dyad does not depend on how large the drawing around it is.
#[test]
fn a_small_dyad_keeps_its_least_transmission_angle() {
    for size in [1.0, 1e-2, 3e-5, 1e-6] {
        let motion = small_dyad(size);
        let dyads = motion.mechanism().rrr_dyads();
        let name =
            |dyad: &&assur::mechanism::RrrDyad| motion.mechanism().point_name(dyad.inner) == "E";
        let dyad = dyads.iter().find(name).unwrap();
        let least = motion.least_transmission(dyad).unwrap().unwrap();
        let sampled = (0..36_000).map(|k| {
            let pose = motion.pose::<1>(TAU * f64::from(k) / 36_000.0).unwrap();
            motion.mechanism().transmission_angle(&pose, dyad)
        });
        let sampled = sampled.fold(f64::INFINITY, f64::min);
        assert!(sampled > 0.05, "{size}: {sampled}");
        let digits = 1e-6 + 1e-14 / size;
        assert!(
            (least.angle - sampled).abs() < digits,
            "{size}: {least:?} {sampled}"
        );
        assert!(
            least.angle <= sampled + 1e-14 / size,
            "{size}: {least:?} {sampled}"
        );
    }
}

/// The distance of two joints within a small part of a drawing has its extrema.
#[test]
fn a_small_distance_has_its_extrema() {
    for size in [1.0, 3e-5, 1e-8] {
        let motion = small_dyad(size);
        let distance = quantity(&motion, "Q-F.distance");
        let [value, ..] = motion
            .features(&[distance], InputRate::ANALOGUES)
            .unwrap()
            .swap_remove(0);
        assert_eq!((value.extrema.len(), value.level), (2, None), "{size}");
        let profile = OutputProfile::new(&motion, distance).unwrap();
        let stroke = profile.stroke().unwrap();
        assert!(stroke > 0.3 * size, "{size}: {stroke}");
        let [Swing::Between { min, max }] = profile.swings()[..] else {
            panic!("one arc");
        };
        assert!((max - min - stroke).abs() < 1e-9 * size + 1e-15);
    }
}

/// A point far from the origin moves as much as one near it.
#[test]
fn places_far_off_have_their_extrema() {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 3.2, 2.9)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    for point in &mut draft.points {
        point.at = (1e-3 * point.at.coords + Vector::new(1e7, 0.0)).into();
    }
    let motion = moved(&draft);
    let x = quantity(&motion, "C.x");
    let [value, ..] = motion
        .features(&[x], InputRate::ANALOGUES)
        .unwrap()
        .swap_remove(0);
    assert_eq!((value.extrema.len(), value.level), (2, None));
}

fn crank_rocker() -> Motion {
    moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 3.2, 2.9)
            .point("D", 4.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank"),
    )
}
