//! Runs of several freedoms that end, come to rest or are refused.

use super::*;
use assur::forces::{FrictionSpec, NoRun};
use assur::mechanism::Cause;

/// A five-bar whose cranks are pulled apart ends where its couplers are in line; its assembly does not change.
#[test]
fn a_run_ends_at_a_singular_pose() {
    let motion = motion(&five_bar());
    let loading = loading(&motion, &LoadingSpec::default());
    let apart = [5.0, -5.0].map(|torque| Actuator::Motor(Motor::Constant(torque)));
    let from = motion.drawn_input();
    let mut run = LagrangeRun::new(&motion, &loading, &apart, from, &[0.0; 2]).unwrap();
    let end = run.advance(100.0).unwrap_err();
    assert_eq!(end.unsolved.cause, Cause::DeadPoint);
    let links: Vec<&str> = motion.mechanism().links_of(end.unsolved.step).collect();
    assert_eq!(links, ["BC", "DC"]);
    let mut pose = motion.mechanism().blank::<3>();
    run.place(&mut pose).unwrap();
    let [b, c, d] = ["B", "C", "D"].map(|name| {
        let point = motion.mechanism().point(name).unwrap();
        motion.mechanism().place(&pose, point).place()
    });
    let sine = (c - b).normalize().perp(&(d - c).normalize());
    assert!(sine.abs() < 1e-3 && sine < 0.0, "{sine:e}");
    // It stays there.
    let time = run.reading().time;
    assert!(run.advance(200.0).is_err());
    assert!(near(run.reading().time, time, time, 1e-3));
}

#[test]
fn what_cannot_be_run() {
    let motion = motion(&double_pendulum());
    let from = motion.drawn_input();
    let new = |loading: &Loading, rates: &[f64]| {
        LagrangeRun::new(&motion, loading, &[FREE, FREE], from, rates).err()
    };
    let friction = FrictionSpec::Hinge {
        point: "A".to_owned(),
        radius: 0.01,
        coefficient: 0.1,
    };
    let rubbed = LoadingSpec {
        friction: vec![friction],
        ..LoadingSpec::default()
    };
    assert_eq!(
        new(&loading(&motion, &rubbed), &[0.0; 2]),
        Some(NoRun::Friction)
    );
    let idle = Loading::of_masses(motion.mechanism());
    assert_eq!(new(&idle, &[f64::NAN, 0.0]), Some(NoRun::Rate));
    let mut massless = double_pendulum();
    massless.links[1].mass = None;
    let motion = self::motion(&massless);
    let idle = Loading::of_masses(motion.mechanism());
    let run = LagrangeRun::new(&motion, &idle, &[FREE, FREE], from, &[0.0; 2]);
    assert_eq!(run.err(), Some(NoRun::NoInertia));
    let one = LagrangeRun::new(&motion, &idle, &[FREE], from, &[0.0; 2]);
    assert_eq!(one.err(), Some(NoRun::Actuators { drivers: 2 }));
    // A massless link that keeps its rate needs no mass.
    let kept = [FREE, Actuator::Rate];
    assert!(LagrangeRun::new(&motion, &idle, &kept, from, &[1.0, 0.0]).is_ok());
    massless.links[0].mass = None;
    let motion = self::motion(&massless);
    let idle = Loading::of_masses(motion.mechanism());
    let kept = [Actuator::Rate, Actuator::Rate];
    let mut run = LagrangeRun::new(&motion, &idle, &kept, from, &[1.0, -2.0]).unwrap();
    run.advance(3.0).unwrap();
    assert!(near(run.reading().coordinates[0], from + 3.0, 1.0, 1e-13));
}

/// A double pendulum with damped hinges comes to rest and stays; its energy is lost.
#[test]
fn a_damped_pendulum_comes_to_rest() {
    let motion = motion(&double_pendulum());
    let damper = |links: [&str; 2]| DamperSpec::Torsion {
        links: links.map(str::to_owned),
        damping: 2.0,
    };
    let loads = LoadingSpec {
        dampers: vec![damper([FRAME, "upper"]), damper(["upper", "lower"])],
        ..weight()
    };
    let loading = loading(&motion, &loads);
    let from = motion.drawn_input();
    let mut run = LagrangeRun::new(&motion, &loading, &[FREE, FREE], from, &[0.0; 2]).unwrap();
    let start = run.reading();
    run.advance(200.0).unwrap();
    let now = run.reading();
    assert!(now.kinetic < 1e-20, "{now:?}");
    let fallen = start.potential - now.potential;
    assert!(near(now.lost, fallen, fallen, 1e-11), "{now:?}");
}

/// A trolley that carries a load on a rope runs into the end of its rail: the run ends there.
#[test]
fn a_slide_ends_at_its_range() {
    let mut spec = massive(
        LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 1.0, 0.0)
            .point("C", 0.5, 0.0)
            .point("P", 0.5, -0.4)
            .fixed(&["A", "B"])
            .bar("trolley", &["C"])
            .bar("rope", &["C", "P"])
            .slide("trolley", "C", FRAME, ["A", "B"]),
    );
    spec.drivers.push(DriverSpec::Slide {
        slide: 0,
        range: [0.0, 1.2],
        rate: 1.0,
    });
    spec.drivers.push(DriverSpec::Crank {
        link: "rope".to_owned(),
        base: "trolley".to_owned(),
        rate: 1.0,
    });
    let motion = motion(&spec);
    let loading = loading(&motion, &weight());
    let from = motion.drawn_input();
    let mut run = LagrangeRun::new(&motion, &loading, &[FREE, FREE], from, &[3.0, 0.0]).unwrap();
    let end = run.advance(10.0).unwrap_err();
    assert_eq!(end.unsolved.cause, Cause::Input);
    let now = run.reading();
    assert!((now.coordinates[0] - 1.2).abs() < 1e-6, "{now:?}");
    assert!(run.imbalance().abs() < 1e-10 * now.kinetic);
}
