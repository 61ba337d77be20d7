//! Reactions and balancing torques against a table computed in 40-digit arithmetic from all Newton–Euler equations at once.

use assur::forces::{AnchorSpec, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec, Reactions};
use assur::linkage::LinkageSpec;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::Table;

/// The six-bar Watt I of the public set `PMKS_Verification`: joints, and the links with their joints, masses and moments
/// of inertia. The centre of mass of a link is the mean of its joints.
const JOINTS: [(&str, f64, f64); 7] = [
    ("A", -3.74, -2.41),
    ("B", -2.72, 0.91),
    ("C", 1.58, 0.43),
    ("D", -0.24, 4.01),
    ("E", 5.08, 5.31),
    ("F", 8.14, 3.35),
    ("G", 7.32, -3.51),
];
const LINKS: [(&str, f64, f64); 5] = [
    ("AB", 5.0, 0.1),
    ("BCD", 10.0, 0.2),
    ("DE", 5.0, 0.1),
    ("EF", 10.0, 0.2),
    ("CFG", 5.0, 0.1),
];
/// On which link a column of the table has the reaction of a joint.
const OWNERS: [(&str, &str); 7] = [
    ("A", "AB"),
    ("B", "AB"),
    ("C", "BCD"),
    ("D", "BCD"),
    ("E", "DE"),
    ("F", "EF"),
    ("G", "CFG"),
];

fn watt() -> Motion {
    let mut spec = LinkageSpec::default();
    for (name, x, y) in JOINTS {
        spec = spec.point(name, x, y);
    }
    spec = spec.fixed(&["A", "G"]);
    for (link, mass, inertia) in LINKS {
        let joints: Vec<String> = link.chars().map(String::from).collect();
        let places = joints.iter().map(|name| {
            let of = JOINTS.iter().find(|(joint, ..)| joint == name).unwrap();
            Vector::new(of.1, of.2)
        });
        let centre = places.sum::<Vector>() / joints.len() as f64;
        let name = format!("S{link}");
        spec = spec.point(&name, centre.x, centre.y);
        let mut points: Vec<&str> = joints.iter().map(String::as_str).collect();
        points.push(&name);
        spec = spec.bar(link, &points).with_mass(mass, &name, inertia);
    }
    Motion::new(Mechanism::new(&spec.crank("AB")).unwrap())
}

/// The force (50, 25) on the last link, at its centre of mass, and gravity downwards.
fn loading(motion: &Motion, gravity: f64) -> Loading {
    let force = |direction: f64, size: f64| LoadSpec::Force {
        at: AnchorSpec::new("CFG", "SCFG"),
        direction,
        turns: false,
        law: Law::Constant(size),
    };
    let spec = LoadingSpec {
        gravity: Vector::new(0.0, gravity),
        loads: vec![force(0.0, 50.0), force(90f64.to_radians(), 25.0)],
        ..LoadingSpec::default()
    };
    Loading::new(motion.mechanism(), &spec).unwrap()
}

/// Reaction on a link at a joint, from all its pairs there.
fn reaction(
    mechanism: &Mechanism,
    forces: &Kinetostatics,
    found: &Reactions,
    at: [&str; 2],
) -> Vector {
    let [joint, link] = at;
    let body = mechanism.body_of(mechanism.link(link));
    let pairs = forces
        .pairs()
        .filter(|(_, pair)| pair.name(mechanism) == joint);
    let on = pairs.map(|(id, pair)| {
        let reaction = found.of(id).vector().unwrap();
        match pair.bodies {
            [on, _] if on == body => reaction,
            [_, from] if from == body => -reaction,
            _ => Vector::zeros(),
        }
    });
    on.sum()
}

#[test]
fn reactions_of_the_six_bar_watt_1() {
    let motion = watt();
    let mechanism = motion.mechanism();
    let forces = Kinetostatics::new(mechanism);
    let table = Table::parse(include_str!("data/forces/watt.csv"));
    let mut rows = 0;
    for row in table.rows() {
        let loading = loading(&motion, row.get("gravity"));
        let input = motion.drawn_input() + row.get("turned_deg").to_radians();
        let pose = motion.pose::<3>(input).unwrap();
        let rates = [row.get("rate"), row.get("acceleration")];
        let found = forces.reactions(&loading, &pose, input, rates).unwrap();
        let expected = OWNERS.map(|(joint, _)| {
            let [x, y] = ["x", "y"].map(|axis| row.get(&format!("{joint}_{axis}")));
            Vector::new(x, y)
        });
        let torque = row.get("torque");
        let greatest = expected
            .iter()
            .map(|force| force.amax())
            .fold(torque.abs(), f64::max);
        for ((joint, link), expected) in OWNERS.iter().zip(expected) {
            let found = reaction(mechanism, &forces, &found, [joint, link]);
            let off = (found - expected).amax();
            assert!(
                off <= 1e-10 * greatest,
                "{joint} on {link} at {input}: {off:e}"
            );
        }
        let off = found.first_drive().unwrap() - torque;
        assert!(off.abs() <= 1e-10 * greatest, "torque at {input}: {off:e}");
        let reduced = loading.reduced(mechanism, &pose, input);
        let off = reduced.balancing(rates[0], rates[1]) - torque;
        assert!(
            off.abs() <= 1e-10 * greatest,
            "reduced torque at {input}: {off:e}"
        );
        rows += 1;
    }
    assert_eq!(rows, 33);
}

/// A crank of length 2 with a mass of 3 at its end, horizontal: gravity of 10 gives the torque 60; at the rate 4 the hinge
/// pulls with 3·2·16 inwards.
#[test]
fn a_crank_by_hand() {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 2.0, 0.0)
        .fixed(&["A"])
        .bar("crank", &["A", "B"])
        .with_mass(3.0, "B", 0.0)
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&spec).unwrap());
    let gravity = Vector::new(0.0, -10.0);
    let loading = LoadingSpec {
        gravity,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(motion.mechanism(), &loading).unwrap();
    let forces = Kinetostatics::new(motion.mechanism());
    let pose = motion.pose::<3>(0.0).unwrap();
    let found = forces.reactions(&loading, &pose, 0.0, [4.0, 0.0]).unwrap();
    assert!((found.first_drive().unwrap() - 60.0).abs() < 1e-12);
    let (id, _) = forces.pairs().next().unwrap();
    let hinge = found.of(id).vector().unwrap();
    assert!((hinge - Vector::new(-96.0, 30.0)).norm() < 1e-12, "{hinge}");
    assert_eq!(found.of(id).place(motion.mechanism()), Point::origin());
    let reduced = loading.reduced(motion.mechanism(), &pose, 0.0);
    assert!((reduced.inertia - 12.0).abs() < 1e-13);
    assert!((reduced.conservative + 60.0).abs() < 1e-12);
}

/// Three equal cranks carry one beam: each crank without mass takes a force along itself, and two equations are left for
/// three of them. What the driver must do is known all the same.
#[test]
fn what_redundant_constraints_share_is_not_invented() {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 2.0, 0.0)
        .point("C", 5.0, 0.0)
        .point("P", 0.6, 0.8)
        .point("Q", 2.6, 0.8)
        .point("R", 5.6, 0.8)
        .fixed(&["A", "B", "C"])
        .bar("first", &["A", "P"])
        .bar("second", &["B", "Q"])
        .bar("third", &["C", "R"])
        .bar("beam", &["P", "Q", "R"])
        .with_mass(3.0, "R", 0.5)
        .crank("first");
    let motion = Motion::new(Mechanism::new(&spec).unwrap());
    let mechanism = motion.mechanism();
    assert_eq!(mechanism.mobility().q(), 1);
    let gravity = Vector::new(0.0, -10.0);
    let loading = LoadingSpec {
        gravity,
        ..LoadingSpec::default()
    };
    let loading = Loading::new(mechanism, &loading).unwrap();
    let forces = Kinetostatics::new(mechanism);
    let input = motion.drawn_input();
    let pose = motion.pose::<3>(input).unwrap();
    let found = forces
        .reactions(&loading, &pose, input, [2.0, 1.0])
        .unwrap();
    // The beam translates: 3 kg at the end of the crank of length 1, with 30 N at 0.6.
    let torque = found.first_drive().unwrap();
    assert!((torque - (30.0 * 0.6 + 3.0)).abs() < 1e-12, "{torque}");
    for (id, pair) in forces.pairs() {
        let reaction = found.of(id);
        assert_eq!(reaction.vector(), None, "{}", pair.name(mechanism));
        assert_eq!(reaction.moment, Some(0.0));
    }
}
