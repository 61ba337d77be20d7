//! The mechanisms of the catalogue. Each decomposes into the expected groups, moves and closes, and reproduces a number
//! that is published or follows exactly.

mod four_bars;
mod groups;
mod lines;
mod list;
mod machines;
mod numbers;
mod transmission;

use assur::JetPoint;
use assur::mechanism::{ConstraintKind, PointId, Quantity};
use assur::motion::{Motion, OutputProfile};
use assur_file::{catalogue, from_catalogue};
use list::GALLERY;

fn moved(name: &str) -> Motion {
    let document = from_catalogue(name).unwrap().unwrap();
    let mechanism = document
        .mechanism()
        .unwrap_or_else(|e| panic!("{name}: {e:?}"));
    Motion::new(mechanism)
}

fn quantity(motion: &Motion, name: &str) -> Quantity {
    Quantity::named(motion.mechanism(), name).unwrap_or_else(|| panic!("{name}"))
}

/// A quantity with three derivatives.
fn at(motion: &Motion, name: &str, degrees: f64) -> [f64; 4] {
    let pose = motion.pose::<4>(degrees.to_radians()).unwrap();
    let jet = quantity(motion, name).of(motion.mechanism(), &pose);
    [0, 1, 2, 3].map(|order| jet.derivative(order))
}

/// Inputs and values between which a quantity goes to and fro.
fn strokes(motion: &Motion, name: &str) -> Vec<[[f64; 2]; 2]> {
    OutputProfile::new(motion, quantity(motion, name))
        .unwrap()
        .strokes()
}

/// The whole stroke of a quantity.
fn stroke(motion: &Motion, name: &str) -> f64 {
    let [low, high] = range(motion, name);
    high - low
}

fn range(motion: &Motion, name: &str) -> [f64; 2] {
    let values = strokes(motion, name).into_iter().flatten();
    values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[low, high], [_, value]| [low.min(value), high.max(value)],
    )
}

/// By how much an angle has grown after a turn of the input.
fn full_turn(motion: &Motion, name: &str) -> f64 {
    let [start, end] = [0.0, 360.0].map(|degrees| at(motion, name, degrees)[0]);
    end - start
}

/// The slow stroke by the quick one, at constant speed.
fn time_ratio(motion: &Motion, name: &str) -> f64 {
    let [first, second] = strokes(motion, name)[..] else {
        panic!("{name} has not two strokes");
    };
    let [a, b] = [first, second].map(|[from, to]| to[0] - from[0]);
    (a / b).max(b / a)
}

/// The catalogue holds these, the mixers first, and each tells of itself.
#[test]
fn all_are_listed() {
    let names: Vec<&str> = catalogue()
        .filter(|name| !name.starts_with("mixer-"))
        .collect();
    assert_eq!(names, GALLERY.map(|(name, ..)| name));
    for name in names {
        let document = from_catalogue(name).unwrap().unwrap();
        assert!(
            document.title.is_some() && document.source.is_some(),
            "{name}"
        );
        assert!(
            !document.plots.is_empty() && !document.traces.is_empty(),
            "{name}"
        );
    }
}

#[test]
fn structures() {
    for (name, expected, _) in GALLERY {
        let motion = moved(name);
        let mechanism = motion.mechanism();
        let formula = mechanism.formula();
        assert_eq!(formula, expected, "{name}");
    }
}

/// Each moves over a whole turn, or else from dead point to dead point, is closed
/// to rounding everywhere, and its links are as long as they were drawn.
#[test]
fn all_move_and_close() {
    for (name, _, full) in GALLERY {
        let motion = moved(name);
        let mechanism = motion.mechanism();
        let size = mechanism.size();
        assert_eq!(
            motion.cycle().is_full(),
            full,
            "{name}: {:?}",
            motion.dead_points()
        );
        assert_eq!(motion.dead_points().is_empty(), full, "{name}");
        let drawn = motion.pose::<1>(motion.drawn_input()).unwrap();
        let [from, to] = motion.cycle().arcs()[0];
        // At a dead point Peaucellier's rhombus is folded flat: anything closes it.
        let ends = if full { 0..=720 } else { 1..=719 };
        for k in ends {
            let input = from + (to - from) * f64::from(k) / 720.0;
            let pose = motion
                .pose::<1>(input)
                .unwrap_or_else(|e| panic!("{name}: {e}"));
            for link in mechanism.link_ids() {
                for point in mechanism.points_of(link) {
                    let [here, there]: [JetPoint<1>; 2] = [
                        mechanism.carried(&pose, link, *point).unwrap(),
                        mechanism.place(&pose, *point),
                    ];
                    let off = (here.place() - there.place()).norm() / size;
                    assert!(off < 1e-12, "{name} at {input}: {off:e}");
                    let first = mechanism.points_of(link)[0];
                    let [now, then] = [&pose, &drawn].map(|pose| {
                        let [a, b] = [first, *point].map(|k| mechanism.place(pose, k).place());
                        (a - b).norm()
                    });
                    assert!((now - then).abs() < 1e-12 * size, "{name} at {input}");
                }
            }
        }
    }
}

/// The constraint equations of each hold with both derivatives, dead points aside;
/// of hinges alone there are as many as keep all points but for the mobility.
#[test]
fn all_fulfil_their_equations() {
    let mut kinds = [0; 4];
    for (name, _, full) in GALLERY {
        let motion = moved(name);
        let mechanism = motion.mechanism();
        let constraints = mechanism.constraints();
        let document = from_catalogue(name).unwrap().unwrap();
        if document.slides.is_empty() && document.gears.is_empty() {
            let fixed = |point: &PointId| {
                let name = mechanism.point_name(*point);
                document.frame.iter().any(|of| of == name)
            };
            let moving = mechanism.point_ids().filter(|point| !fixed(point));
            let joints = moving.filter(|point| {
                let links = mechanism.link_ids();
                let mut links = links.filter(|link| mechanism.points_of(*link).contains(point));
                links.nth(1).is_some()
            });
            // One for each redundant constraint more.
            let q = mechanism.mobility().q() as usize;
            assert_eq!(constraints.len(), 2 * joints.count() - 1 + q, "{name}");
        }
        for constraint in &constraints {
            kinds[match constraint.kind {
                ConstraintKind::Distance { .. } => 0,
                ConstraintKind::Offset { .. } => 1,
                ConstraintKind::Direction { .. } => 2,
                ConstraintKind::Mesh { .. } => 3,
            }] += 1;
        }
        let [from, to] = motion.cycle().arcs()[0];
        for k in if full { 0..=90 } else { 6..=84 } {
            let pose = motion
                .pose::<3>(from + (to - from) * f64::from(k) / 90.0)
                .unwrap();
            for constraint in &constraints {
                for (order, tolerance) in [1e-12, 1e-11, 1e-9].into_iter().enumerate() {
                    let sides = mechanism.sides(&pose, constraint, order);
                    let scale = sides.left.abs() + mechanism.size().powi(2).max(1.0);
                    assert!(
                        sides.residual().abs() <= tolerance * scale,
                        "{name} {constraint:?} {order}: {sides:?}"
                    );
                }
            }
        }
    }
    assert!(kinds.iter().all(|count| *count > 0), "{kinds:?}");
}

/// Every assembly that is counted is drawn as such: what an old link numbers opens.
#[test]
fn every_assembly_of_the_gallery_is_a_drawing() {
    let mut drawn = 0;
    for (name, ..) in GALLERY {
        let motion = moved(name);
        let mechanism = motion.mechanism();
        let all = mechanism.signed_assemblies();
        for number in 0..all.count() {
            let other = all.assembly(number);
            let other = other.unwrap_or_else(|| panic!("{name} {number}"));
            let others = other.signed_assemblies();
            let counted = [others.count(), others.drawn()];
            assert_eq!(counted, [all.count(), number], "{name}");
            assert_eq!(other.turns(), mechanism.turns());
            drawn += 1;
        }
    }
    assert!(drawn > GALLERY.len(), "{drawn}");
}
