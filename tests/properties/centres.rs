//! Properties of the instant centres of every linkage: Kennedy's lines and velocities agree, the centres of three links
//! are in line, and two links have the same velocity at their centre.

use assur::centres::{Centre, InstantCentre, Source};
use assur::gears::Mesh;
use assur::mechanism::{BodyId, GearSpec, LinkageSpec, Mechanism, Pose};
use assur::motion::Motion;
use assur::{JetPoint, Point, Vector};
use assur_tests::scaled;
use nalgebra::Vector3;

use super::following::{Random, inputs, rate, size_at};
use super::{dyads, groups};

/// A centre as a triple of length 1, so that one far away is next to one at infinity; none that is anywhere.
fn triple(mechanism: &Mechanism, centre: &Centre) -> Option<Vector3<f64>> {
    let middle = mechanism.spec().points[0].at;
    let triple = match centre {
        Centre::At(place) => {
            let at = (place - middle) / mechanism.size();
            Vector3::new(at.x, at.y, 1.0)
        }
        Centre::Infinity(way) => Vector3::new(way.x, way.y, 0.0),
        Centre::Anywhere => return None,
    };
    Some(triple.normalize())
}

/// How fast two bodies move against each other, of the largest velocities by the input.
fn apart(mechanism: &Mechanism, pose: &Pose<4>, bodies: [BodyId; 2]) -> f64 {
    let middle = mechanism.spec().points[0].at;
    let fast = |body: BodyId| {
        let velocity = mechanism.fixed_to(pose, body, middle).derivative(1);
        let spin = mechanism.body_angle(pose, body).derivative(1);
        Vector3::new(velocity.x, velocity.y, spin * mechanism.size())
    };
    let fastest = mechanism.bodies().map(|body| fast(body).norm());
    let fastest = fastest.fold(0.0, f64::max);
    let [one, other] = bodies.map(fast);
    (one - other).norm() / fastest
}

fn of(centres: &[InstantCentre], one: BodyId, other: BodyId) -> &InstantCentre {
    let bodies = [one.min(other), one.max(other)];
    let mut found = centres.iter();
    found.find(|centre| centre.bodies == bodies).unwrap()
}

/// Checks a pose; how many centres Kennedy's lines gave, and how many they did not.
fn agrees(seed: u64, input: f64, mechanism: &Mechanism, pose: &Pose<4>) -> [usize; 2] {
    let all = mechanism.instant_centres(pose);
    let count = mechanism.bodies().len();
    assert_eq!(all.len(), count * (count - 1) / 2, "{seed} at {input}");
    let by_velocities = mechanism.centres_by_velocities(pose);
    let mut counts = [0; 2];
    for (k, found) in all.iter().enumerate() {
        let [one, other] = found.bodies;
        if let Source::Kennedy([by, also]) = found.source {
            assert!(by != also && ![one, other].contains(&by) && ![one, other].contains(&also));
            // By ones before it.
            for (a, b) in [(one, by), (by, other), (one, also), (also, other)] {
                let before = all[..k].iter();
                let mut before = before.filter(|centre| centre.source != Source::Velocities);
                let bodies = [a.min(b), a.max(b)];
                assert!(
                    before.any(|centre| centre.bodies == bodies),
                    "{seed} at {input}"
                );
            }
        }
        counts[usize::from(found.source == Source::Velocities)] += 1;
        let (apart, there) = (
            apart(mechanism, pose, found.bodies),
            triple(mechanism, &found.centre),
        );
        let measured = of(&by_velocities, one, other);
        // What little they move against each other tells it with as much fewer digits.
        if let (Some(there), Some(measured)) = (there, triple(mechanism, &measured.centre)) {
            let off = there.cross(&measured).norm();
            assert!(
                off < 1e-9 + 1e-12 / apart,
                "{seed} at {input}: {found:?} is {off:e} off {measured:?}, {apart:e}"
            );
        }
        if let Centre::At(place) = found.centre {
            coincide(seed, input, mechanism, pose, found, place);
        }
    }
    in_line(seed, input, mechanism, &all);
    counts
}

/// The points of both bodies at their centre go with one velocity, relative to what turns about it.
fn coincide(
    seed: u64,
    input: f64,
    mechanism: &Mechanism,
    pose: &Pose<4>,
    found: &InstantCentre,
    place: Point,
) {
    let velocity = |body: BodyId| mechanism.fixed_to(pose, body, place).derivative(1);
    let [one, other] = found.bodies.map(velocity);
    let spins = mechanism.bodies().map(|body| {
        let spin = mechanism.body_angle(pose, body).derivative(1).abs();
        let still: JetPoint<4> = mechanism.fixed_to(pose, body, mechanism.spec().points[0].at);
        spin * mechanism.size() + still.derivative(1).norm()
    });
    let far = (place - mechanism.spec().points[0].at).norm() / mechanism.size();
    let scale = spins.fold(0.0, f64::max) * (1.0 + far);
    assert!(
        (one - other).norm() <= 1e-9 * scale,
        "{seed} at {input}: {found:?}: {one:?} {other:?}"
    );
}

/// The centres of any three bodies are on one line.
fn in_line(seed: u64, input: f64, mechanism: &Mechanism, all: &[InstantCentre]) {
    let bodies: Vec<BodyId> = mechanism.bodies().collect();
    for (i, first) in bodies.iter().enumerate() {
        for (j, second) in bodies.iter().enumerate().skip(i + 1) {
            for third in &bodies[j + 1..] {
                let three = [(first, second), (second, third), (first, third)];
                let three = three.map(|(a, b)| of(all, *a, *b));
                let places = three.map(|one| triple(mechanism, &one.centre));
                if let [Some(a), Some(b), Some(c)] = places {
                    let off = a.cross(&b).dot(&c).abs();
                    assert!(
                        off < 1e-9,
                        "{seed} at {input}: {three:?} are {off:e} off a line"
                    );
                }
            }
        }
    }
}

/// How many poses were checked, and how many centres Kennedy's lines gave and did not.
fn checked(seed: u64, motion: &Motion, inputs: &[f64]) -> (usize, [usize; 2]) {
    let mechanism = motion.mechanism();
    let (mut poses, mut counts) = (0, [0; 2]);
    for input in inputs {
        let Ok(pose) = motion.pose::<4>(*input) else {
            continue;
        };
        let at = motion.pose::<1>(*input).unwrap();
        // Next to a singular pose velocities have few digits left.
        if rate(mechanism, &pose) > 1e3 || size_at(mechanism, &at) > 1e3 * mechanism.size() {
            continue;
        }
        poses += 1;
        let found = agrees(seed, *input, mechanism, &pose);
        counts = [counts[0] + found[0], counts[1] + found[1]];
    }
    (poses, counts)
}

#[test]
fn both_ways_agree_on_chains_of_dyads() {
    let mut random = Random::new(171);
    let (mut poses, mut counts) = (0, [0; 2]);
    for seed in 0..scaled(150) {
        let Some((_, motion)) = dyads::moving(seed) else {
            continue;
        };
        let (found, by) = checked(seed, &motion, &inputs(&motion, &mut random));
        poses += found;
        counts = [counts[0] + by[0], counts[1] + by[1]];
    }
    assert!(poses > scaled(400), "{poses}");
    // Dyads are within Kennedy's reach, but for lines that are one on a drawing on a grid.
    assert!(counts[1] * 100 < counts[0], "{counts:?}");
}

#[test]
fn both_ways_agree_on_higher_groups() {
    let mut random = Random::new(172);
    for (kind, name) in groups::KINDS {
        let mut poses = 0;
        for seed in 0..scaled(6) {
            let (_, motion) = groups::moving(kind, seed);
            let (found, _) = checked(seed, &motion, &inputs(&motion, &mut random));
            poses += found;
        }
        assert!(poses > scaled(20), "{name}: {poses}");
    }
}

fn four_bar(frame: f64) -> LinkageSpec {
    LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", frame, 1.0)
        .point("D", frame, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["C", "D"])
        .crank("crank")
}

/// A parallelogram: of coupler and frame, and of crank and rocker, they are at infinity.
#[test]
fn of_a_parallelogram() {
    let motion = Motion::new(Mechanism::new(&four_bar(2.0)).unwrap());
    let pose = motion.pose::<2>(1.0).unwrap();
    let all = motion.mechanism().instant_centres(&pose);
    let body = |name: &str| motion.mechanism().body_of(motion.mechanism().link(name));
    let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(body);
    let along = |one, other, way: Vector| match of(&all, one, other).centre {
        Centre::Infinity(found) => assert!(found.perp(&way).abs() < 1e-12, "{found:?}"),
        other => panic!("{other:?}"),
    };
    along(
        BodyId::FRAME,
        coupler,
        Vector::new(1.0_f64.cos(), 1.0_f64.sin()),
    );
    along(crank, rocker, Vector::x());
    assert!(all.iter().all(|centre| centre.source != Source::Velocities));
}

/// At a dead point there are no velocities by the input, and Kennedy's lines answer.
#[test]
fn at_a_dead_point() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.2, 0.9)
        .point("C", 2.5, 0.8)
        .point("D", 2.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["C", "D"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let dead = motion.dead_points()[0];
    assert!(motion.pose::<2>(dead.input).is_err());
    let pose = motion.pose::<1>(dead.input).unwrap();
    let mechanism = motion.mechanism();
    let all = mechanism.kennedy(&pose);
    assert_eq!(all.len(), 6, "{all:?}");
    // Coupler and rocker are in line: against the frame the coupler turns about their line's crossing with the crank's,
    // and as that stands still, about B.
    let body = |name: &str| mechanism.body_of(mechanism.link(name));
    let b = mechanism
        .place(&pose, mechanism.point("B").unwrap())
        .place();
    match of(&all, BodyId::FRAME, body("coupler")).centre {
        Centre::At(place) => assert!((place - b).norm() < 1e-6, "{place:?} {b:?}"),
        other => panic!("{other:?}"),
    }
}

/// A rocker at the end of its swing stands still: the pair tells about what it turns all the same.
#[test]
fn of_what_stands_still() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0)
        .point("C", 3.0, 2.0)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["C", "D"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let rocker = mechanism.link("rocker").unwrap();
    // Crank and coupler stretched: the triangle of them with rocker and frame.
    let stretched = 1.0 + 8.0_f64.sqrt();
    let cosine = (stretched.powi(2) + 16.0 - 5.0) / (8.0 * stretched);
    let pose = motion.pose::<2>(cosine.acos()).unwrap();
    let all = mechanism.instant_centres(&pose);
    let found = of(&all, BodyId::FRAME, mechanism.body_of(Some(rocker)));
    assert_eq!(found.source, Source::Joint);
    assert_eq!(found.centre, Centre::At(Point::new(4.0, 0.0)));
    // Against the frame the coupler turns about the pin of the rocker.
    let coupler = mechanism.body_of(mechanism.link("coupler"));
    let c = mechanism
        .place(&pose, mechanism.point("C").unwrap())
        .place();
    match of(&all, BodyId::FRAME, coupler).centre {
        Centre::At(place) => assert!((place - c).norm() < 1e-6, "{place:?} {c:?}"),
        other => panic!("{other:?}"),
    }
}

/// Wheels in mesh turn about their pitch point against each other, whatever carries them and in whichever mesh.
#[test]
fn of_wheels_in_mesh() {
    let gear = |links: [&str; 2], teeth: [f64; 2], mesh: Mesh| GearSpec {
        links: links.map(str::to_owned),
        carrier: "arm".to_owned(),
        teeth,
        mesh,
    };
    // A satellite between a sun that stands still and a driven arm, with a wheel inside of it.
    let mut draft = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("P", 3.0, 0.0)
        .point("Q", 3.5, 0.0)
        .fixed(&["O"])
        .bar("arm", &["O", "P", "Q"])
        .bar("satellite", &["P"])
        .bar("inner", &["Q"])
        .crank("arm");
    draft.gears = vec![
        gear(["frame", "satellite"], [20.0, 10.0], Mesh::External),
        gear(["satellite", "inner"], [10.0, 5.0], Mesh::Internal),
    ];
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let pose = motion.pose::<4>(0.4).unwrap();
    // All axes are in line, so that lines through them do not cross: velocities tell the one of frame and inner wheel.
    assert_eq!(agrees(0, 0.4, mechanism, &pose), [5, 1]);
    let all = mechanism.instant_centres(&pose);
    let satellite = mechanism.body_of(mechanism.link("satellite"));
    match of(&all, BodyId::FRAME, satellite).centre {
        Centre::At(place) => {
            let pitch = Point::new(2.0 * 0.4_f64.cos(), 2.0 * 0.4_f64.sin());
            assert!((place - pitch).norm() < 1e-12, "{place:?}");
        }
        other => panic!("{other:?}"),
    }
}
