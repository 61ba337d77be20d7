use std::f64::consts::{FRAC_PI_2, TAU};

use crate::Jet;
use crate::gears::Mate;
use crate::mechanism::{Cause, Pose, Quantity};
use crate::mixer::{Carrier, Case, Mixer, Tracer};
use crate::motion::{Column, Motion, PoseOrder, Row};

fn motion() -> Motion {
    let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
    mixer.motion().unwrap()
}

/// The motion of a mixer with wheels 5 to 7, and with points on the coupler and on wheel 7.
fn full() -> Motion {
    let mut dimensions = Case::A.dimensions();
    for teeth in [24.0, 12.0] {
        let centre_line = teeth;
        dimensions.wheels.push(Mate { teeth, centre_line });
    }
    dimensions.tracers = [
        (Carrier::Coupler, 0.425, 0.0),
        (Carrier::Wheel(2), 0.1, 0.0),
    ]
    .map(|(carrier, x, y)| Tracer { carrier, x, y })
    .to_vec();
    Mixer::new(&dimensions).unwrap().motion().unwrap()
}

fn jets<const N: usize>(motion: &Motion, names: &[&str], crank: f64) -> Vec<Jet<N>>
where
    Pose<N>: PoseOrder,
{
    let mechanism = motion.mechanism();
    let pose = motion.pose::<N>(crank).unwrap();
    let quantities = names.iter().map(|name| Quantity::named(mechanism, name));
    quantities
        .map(|quantity| quantity.unwrap().of(mechanism, &pose))
        .collect()
}

/// The table of a mixer with these lengths, with `steps` rows per turn.
fn rows(lengths: [f64; 4], steps: u32) -> (Vec<String>, Vec<Row>) {
    let mut dimensions = Case::A.dimensions();
    dimensions.lengths = lengths;
    let motion = Mixer::new(&dimensions).unwrap().motion().unwrap();
    let columns = Column::all(motion.mechanism());
    let names = columns.iter().map(|one| one.name(motion.mechanism()));
    let [start, end] = motion.cycle().axis();
    let turns = ((end - start) / TAU).round() as u32;
    let row = |step: u32| motion.row(&columns, TAU * f64::from(step) / f64::from(steps));
    (names.collect(), (0..=turns * steps).map(row).collect())
}

#[test]
fn wheels_and_traced_points_are_quantities() {
    let full = full();
    let mechanism = full.mechanism();
    let links: Vec<&str> = mechanism.links().collect();
    assert_eq!(links[3..], ["wheel4", "wheel5", "wheel6", "wheel7"]);
    let points: Vec<&str> = mechanism.points().collect();
    assert_eq!(points[points.len() - 2..], ["P1", "P2"]);
    assert_eq!(Quantity::named(mechanism, "P3.x"), None);
    let value = |names: &[&str]| jets::<4>(&full, names, 1.2);
    assert_eq!(value(&["P1.x", "P1.y"]), value(&["C2.x", "C2.y"]));
    let angles = ["rocker.angle", "wheel6.angle", "wheel7.angle"];
    let [rocker, wheel6, wheel7] = value(&angles)[..] else {
        panic!("three angles")
    };
    assert_eq!([wheel6, wheel7], [rocker * -1.5, rocker * -3.0]);
    // P₂ is 0.1 from the centre of wheel 7 and turns with this wheel.
    let [x, y] = value(&["P2.x", "P2.y"])[..] else {
        panic!("two coordinates")
    };
    let speed = x.derivative(1).hypot(y.derivative(1));
    assert!((speed - 0.1 * wheel7.derivative(1).abs()).abs() < 1e-14);
}

/// C₁, C₂ and C₃ are the midpoints of AB, BC and CD, in every derivative.
#[test]
fn centres_follow_their_links() {
    let motion = motion();
    let [l1, .., l4] = Case::A.dimensions().lengths;
    let names = [
        "B.x", "B.y", "C.x", "C.y", "C1.x", "C1.y", "C2.x", "C2.y", "C3.x", "C3.y",
    ];
    for crank in [-0.4, 0.0, 1.0, 3.0, 5.5_f64] {
        let jets = jets::<5>(&motion, &names, crank);
        let [bx, by, cx, cy, c1x, c1y, c2x, c2y, c3x, c3y] = jets[..] else {
            panic!("{jets:?}")
        };
        for order in 0..5 {
            let turned = crank + FRAC_PI_2 * f64::from(order);
            let order = order as usize;
            let still = if order == 0 { l4 } else { 0.0 };
            for (found, expected) in [
                (c1x, 0.5 * l1 * turned.cos()),
                (c1y, 0.5 * l1 * turned.sin()),
                (c2x, 0.5 * (bx + cx).derivative(order)),
                (c2y, 0.5 * (by + cy).derivative(order)),
                (c3x, 0.5 * (cx.derivative(order) + still)),
                (c3y, 0.5 * cy.derivative(order)),
            ] {
                let off = (found.derivative(order) - expected).abs();
                assert!(
                    off < 1e-13 * (1.0 + expected.abs()),
                    "{crank} {order}: {off:e}"
                );
            }
        }
    }
}

#[test]
fn multiples_are_multiples() {
    let motion = full();
    let mechanism = motion.mechanism();
    let pose = motion.pose::<5>(1.2).unwrap();
    for link in mechanism.link_ids() {
        let multiple = mechanism.multiple_of(link);
        assert_eq!(multiple.offset, 0.0);
        let [one, other] = [link, multiple.of].map(|link| mechanism.angle(&pose, link));
        assert_eq!(
            one,
            other * multiple.factor,
            "{}",
            mechanism.link_name(link)
        );
    }
}

#[test]
fn columns_have_the_names_of_tables() {
    let (names, _) = rows([0.37, 0.85, 0.55, 0.85], 1);
    let links = ["crank", "coupler", "rocker", "wheel4", "wheel5"];
    let links = links.map(|link| ["angle", "dangle", "ddangle"].map(|what| (link, what)));
    let points = ["A", "B", "C", "D", "C1", "C2", "C3", "E5"];
    let points = points.map(|point| ["x", "y", "dx", "dy", "ddx", "ddy"].map(|what| (point, what)));
    let expected = links.as_flattened().iter().chain(points.as_flattened());
    let expected: Vec<String> = expected.map(|(of, what)| format!("{of}.{what}")).collect();
    assert_eq!(names, expected);
}

#[test]
fn wheels_and_traced_points_are_in_the_table() {
    let mut dimensions = Case::A.dimensions();
    dimensions.wheels.push(Mate {
        teeth: 24.0,
        centre_line: 2.0,
    });
    dimensions.tracers.push(Tracer {
        carrier: Carrier::Coupler,
        x: 0.425,
        y: 0.0,
    });
    let motion = Mixer::new(&dimensions).unwrap().motion().unwrap();
    let columns = Column::all(motion.mechanism());
    let row = motion.row(&columns, TAU * 7.0 / 36.0);
    let value = |name: &str| {
        let mut columns = columns.iter();
        let column = columns.position(|column| column.name(motion.mechanism()) == name);
        row.values[column.unwrap()].unwrap()
    };
    // u = −36 / 24, and P₁ is the middle of the coupler.
    let off = value("wheel6.ddangle") + 1.5 * value("rocker.ddangle");
    assert!(off.abs() < 1e-14, "{off:e}");
    for what in ["x", "y", "dx", "dy", "ddx", "ddy"] {
        let [traced, middle] = ["P1", "C2"].map(|point| value(&format!("{point}.{what}")));
        assert!((traced - middle).abs() < 1e-14, "{what}");
    }
    // Three bars and three wheels; ten points: 4 joints, 3 centres of mass, 2 centres of wheels, P₁.
    assert_eq!(columns.len(), 3 * (6 + 2 * 10));
}

#[test]
fn a_full_turn_has_every_value() {
    for (lengths, turns) in [([0.37, 0.85, 0.55, 0.85], 1), ([1.0, 3.0, 2.0, 4.0], 2)] {
        let (names, rows) = rows(lengths, 720);
        assert_eq!(rows.len(), 720 * turns + 1);
        for (step, row) in rows.iter().enumerate() {
            let degrees = row.input.to_degrees();
            assert!((degrees - 0.5 * step as f64).abs() < 1e-12 * (1.0 + degrees));
            assert_eq!(row.values.len(), names.len());
            assert!(row.values.iter().all(Option::is_some), "{row:?}");
            assert_eq!(row.reason, None);
            assert_eq!(row.values[0], Some(row.input));
        }
        // The last row equals the first, up to whole turns of the angles.
        let [first, .., last] = &rows[..] else {
            panic!("rows")
        };
        let pairs = names.iter().zip(first.values.iter().zip(&last.values));
        for (name, (first, last)) in pairs {
            let (first, last) = (first.unwrap(), last.unwrap());
            let apart = if name.ends_with(".angle") {
                let turns = (last - first) / TAU;
                turns - turns.round()
            } else {
                last - first
            };
            assert!(apart.abs() < 1e-9, "{name}: {first} {last}");
        }
    }
}

/// At φ₁ = 90° BD is 5 = l₂ + l₃ long: a dead point.
#[test]
fn a_dead_point_has_places_without_derivatives() {
    let (names, rows) = rows([3.0, 2.0, 3.0, 4.0], 360);
    assert_eq!(rows.len(), 361);
    for (step, row) in rows.iter().enumerate() {
        let has = |order: usize| {
            let of = names.iter().zip(&row.values);
            let mut of = of.filter(|(name, _)| {
                let what = name.split_once('.').unwrap().1;
                what.chars().filter(|c| *c == 'd').count() == order
            });
            let some = of.clone().all(|(_, value)| value.is_some());
            assert!(some || of.all(|(_, value)| value.is_none()), "{row:?}");
            some
        };
        let expected = match step {
            90 | 270 => [true, false, false],
            91..270 => [false; 3],
            _ => [true; 3],
        };
        assert_eq!([0, 1, 2].map(has), expected, "{row:?}");
        match (step, row.reason.map(|unsolved| unsolved.cause)) {
            (90 | 270, Some(Cause::DeadPoint)) => {}
            (91..270, Some(Cause::Apart { by })) => assert!(by > 0.0),
            (_, None) if expected[2] => {}
            _ => panic!("{row:?}"),
        }
    }
    // C lies on the line from B = (0, 3) to D = (4, 0), at the distance 2 from B.
    let column = |name: &str| names.iter().position(|other| other == name).unwrap();
    let [x, y] = ["C.x", "C.y"].map(|name| rows[90].values[column(name)].unwrap());
    assert!((x - 1.6).abs() < 1e-7 && (y - 1.8).abs() < 1e-7, "{x} {y}");
}
