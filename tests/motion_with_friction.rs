//! Motion under load with dry friction: closed forms, the reactions at its accelerations, the account of energy, rest and
//! self-locking.

mod catalogue;
mod invariance;

use std::f64::consts::TAU;

use assur::Vector;
use assur::forces::{
    AnchorSpec, FrictionSpec, Halt, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec, Motor, Run,
    SteadyCycle,
};
use assur::linkage::{DriverSpec, LinkageSpec};
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_file::Document;
use assur_tests::{Table, assert_near};

use crate::friction::hinge;

const GRAVITY: f64 = 9.81;

fn loaded(spec: &LinkageSpec, loading: LoadingSpec) -> (Motion, Loading) {
    let mechanism = Mechanism::new(spec).unwrap();
    let loading = Loading::new(&mechanism, &loading).unwrap();
    (Motion::new(mechanism), loading)
}

fn slide(link: &str, coefficient: f64) -> FrictionSpec {
    let (link, length) = (link.to_owned(), None);
    FrictionSpec::Slide {
        link,
        coefficient,
        length,
    }
}

/// A balanced rotor bears on its pin with its weight alone: it slows down evenly by f r m g/J, and then stands.
#[test]
fn a_rotor_runs_down_and_stands() {
    let (mass, inertia, coefficient, radius) = (2.0, 0.05, 0.2, 0.01);
    let spec = LinkageSpec::default()
        .point("A", 0.3, -0.2)
        .point("B", 0.5, 0.0)
        .fixed(&["A"])
        .bar("rotor", &["A", "B"])
        .with_mass(mass, "A", inertia)
        .crank("rotor");
    let loading = LoadingSpec {
        gravity: Vector::new(0.0, -GRAVITY),
        friction: vec![hinge("A", coefficient, radius)],
        ..LoadingSpec::default()
    };
    let (motion, loading) = loaded(&spec, loading);
    let slowing = coefficient * radius * mass * GRAVITY / inertia;
    for first in [7.0, -7.0_f64] {
        let from = motion.drawn_input();
        let mut run = Run::new(&motion, &loading, &Motor::NONE, [from, first]).unwrap();
        let stands = first.abs() / slowing;
        for part in [0.25, 0.5, 0.99] {
            let time = part * stands;
            run.advance(time).unwrap();
            let now = run.reading();
            let sense = first.signum();
            assert_near(now.rate, first - sense * slowing * time, 1e-11, "rate");
            assert_near(now.acceleration, -sense * slowing, 1e-11, "acceleration");
            assert!(!run.rests());
        }
        for time in [1.001 * stands, 5.0 * stands] {
            run.advance(time).unwrap();
            let now = run.reading();
            assert_eq!((now.time, now.rate, now.acceleration), (time, 0.0, 0.0));
            assert!(run.rests());
            let way = (now.input - from).abs();
            assert_near(way, 0.5 * first * first / slowing, 1e-10, "way");
            assert_near(now.lost, 0.5 * inertia * first * first, 1e-11, "lost");
        }
    }
}

/// A block on an incline with tan α = 0.5. It slides if the coefficient is smaller, with g(sin α − f cos α); thrown
/// upwards it slows down with g(sin α + f cos α), and then slides back or stays.
#[test]
fn a_block_on_an_incline() {
    let spec = LinkageSpec::default()
        .point("O", 0.0, 0.0)
        .point("E", 20.0, 10.0)
        .point("P", 2.0, 1.0)
        .fixed(&["O", "E"])
        .bar("block", &["P"])
        .with_mass(3.0, "P", 0.0)
        .slide("block", "P", "frame", ["O", "E"]);
    let driver = DriverSpec::Slide {
        slide: 0,
        rate: 1.0,
        range: [0.5, 20.0],
    };
    let spec = LinkageSpec {
        drivers: vec![driver],
        ..spec
    };
    let (sine, cosine) = (1.0 / 5.0_f64.sqrt(), 2.0 / 5.0_f64.sqrt());
    for coefficient in [0.2, 0.49, 0.51, 0.8] {
        let loading = LoadingSpec {
            gravity: Vector::new(0.0, -GRAVITY),
            friction: vec![slide("block", coefficient)],
            ..LoadingSpec::default()
        };
        let (motion, loading) = loaded(&spec, loading);
        let from = motion.drawn_input();
        let down = GRAVITY * (sine - coefficient * cosine);
        let up = GRAVITY * (sine + coefficient * cosine);
        let stays = down <= 0.0;
        let mut run = Run::new(&motion, &loading, &Motor::NONE, [from, 0.0]).unwrap();
        run.advance(0.3).unwrap();
        let expected = if stays { 0.0 } else { -down * 0.3 };
        assert_near(run.reading().rate, expected, 1e-12, "from rest");
        let first = 4.0;
        let mut run = Run::new(&motion, &loading, &Motor::NONE, [from, first]).unwrap();
        let top = first / up;
        run.advance(top + 0.4).unwrap();
        let now = run.reading();
        let (rate, back) = if stays {
            (0.0, 0.0)
        } else {
            (-down * 0.4, 0.5 * down * 0.16)
        };
        assert_near(now.rate, rate, 1e-11, "after the turn");
        let input = from + 0.5 * first * top - back;
        assert_near(now.input, input, 1e-11, "place after the turn");
        assert_eq!(run.rests(), stays);
        assert!(run.imbalance().abs() < 1e-11);
    }
}

/// A slider-crank with masses in which all pairs rub.
fn slider_crank(coefficient: f64) -> (LinkageSpec, LoadingSpec) {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.05, 0.08)
        .point("C", 0.3, 0.02)
        .point("D", 0.1, 0.02)
        .point("E", 0.9, 0.02)
        .point("S", 0.15, 0.06)
        .fixed(&["A", "D", "E"])
        .bar("crank", &["A", "B"])
        .with_mass(1.5, "A", 0.04)
        .bar("rod", &["B", "C", "S"])
        .with_mass(0.8, "S", 0.003)
        .bar("slider", &["C"])
        .with_mass(1.2, "C", 0.0)
        .slide("slider", "C", "frame", ["D", "E"])
        .crank("crank");
    let press = LoadSpec::Force {
        at: AnchorSpec::new("slider", "C"),
        direction: 0.0,
        turns: false,
        law: Law::Constant(15.0),
    };
    let loading = LoadingSpec {
        gravity: Vector::new(0.0, -GRAVITY),
        loads: vec![press],
        friction: vec![
            hinge("A", coefficient, 0.012),
            hinge("B", coefficient, 0.01),
            hinge("C", coefficient, 0.008),
            slide("slider", coefficient),
        ],
        ..LoadingSpec::default()
    };
    (spec, loading)
}

const LINEAR: Motor = Motor::Linear {
    stall: 16.0,
    no_load: 30.0,
};

/// Friction that a run finds is that of the reactions at its acceleration, whose drive is the motor.
fn check_reactions(run: &mut Run, forces: &Kinetostatics, loading: &Loading, motor: &Motor) -> f64 {
    let now = run.reading();
    let pose = run.motion().pose(now.input).unwrap();
    let motion = [now.rate, now.acceleration];
    let found = forces.reactions(loading, &pose, now.input, motion).unwrap();
    let expected = motor.torque(now.rate)[0];
    let applied = found.applied().iter();
    let size = run.motion().mechanism().size();
    let scale = applied
        .map(|one| one.force.norm() * size + one.couple.abs())
        .fold(expected.abs(), f64::max);
    (found.first_drive().unwrap() - expected).abs() / scale
}

/// An offset slider-crank with a short block, from rest, against an independent program: Newton–Euler equations with
/// multipliers, contacts that change found as events, DOP853.
#[test]
fn the_motion_of_an_independent_program() {
    let text = include_str!("data/benchmarks/friction.json");
    let Document::Linkage(document) = assur_file::document_of(text).unwrap() else {
        panic!("a linkage")
    };
    let mechanism = Mechanism::new(&document.spec()).unwrap();
    let loading = document.loading(&mechanism).unwrap();
    let motor = document.motor(&mechanism).unwrap();
    let motion = Motion::new(mechanism);
    let mut run = Run::new(&motion, &loading, &motor, [motion.drawn_input(), 0.0]).unwrap();
    let table = Table::parse(include_str!("data/benchmarks/friction.csv"));
    let mut worst = [0.0_f64; 3];
    for row in table.rows() {
        run.advance(row.get("t")).unwrap();
        let now = run.reading();
        let found = [now.input, now.rate, now.lost];
        for (k, name) in ["input", "rate", "lost"].into_iter().enumerate() {
            worst[k] = worst[k].max((found[k] - row.get(name)).abs());
        }
    }
    println!("slider-crank of an independent program: {worst:?}");
    assert!(worst.iter().all(|off| *off < 1e-9), "{worst:?}");
}

#[test]
fn a_slider_crank_with_friction() {
    let (spec, loading) = slider_crank(0.15);
    let (motion, loading) = loaded(&spec, loading);
    let forces = Kinetostatics::new(motion.mechanism());
    let mut run = Run::new(&motion, &loading, &LINEAR, [motion.drawn_input(), 0.0]).unwrap();
    let (mut worst, mut lost) = (0.0_f64, 0.0);
    for k in 1..=400 {
        run.advance(f64::from(k) * 0.02).unwrap();
        worst = worst.max(check_reactions(&mut run, &forces, &loading, &LINEAR));
        let now = run.reading();
        assert!(now.lost > lost, "friction takes energy");
        lost = now.lost;
    }
    let now = run.reading();
    let off = run.imbalance().abs() / now.work;
    println!("slider-crank: drive off {worst:e}, energy off {off:e}");
    assert!(worst < 1e-11, "{worst:e}");
    assert!(off < 1e-10, "{off:e}");
    // The steady cycle.
    let mut cycle = SteadyCycle::new(&motion, &loading, Some(&LINEAR), 20.0).unwrap();
    let mut next = run.clone();
    next.advance(now.time + 10.0).unwrap();
    let reading = next.reading();
    let expected = cycle.rate(reading.input).unwrap();
    let off = (reading.rate / expected - 1.0).abs();
    println!("cycle {} {}: off {off:e}", cycle.mean(), cycle.multiplier);
    assert!(off < 1e-9, "{off:e}");
    let bare = LoadingSpec {
        friction: Vec::new(),
        ..slider_crank(0.15).1
    };
    let bare = Loading::new(motion.mechanism(), &bare).unwrap();
    let free = SteadyCycle::new(&motion, &bare, Some(&LINEAR), 20.0).unwrap();
    assert!(cycle.mean() < free.mean(), "friction slows down the cycle");
    let before = next.reading();
    let mut turn = next.clone();
    turn.advance(before.time + cycle.time).unwrap();
    assert!((turn.reading().input - before.input - TAU).abs() < 1e-8);
    // The multiplier is that of a small change of the energy, seen over a turn of a run.
    let rate = cycle.rate(before.input).unwrap();
    let changed = |part: f64| {
        let start = [before.input, rate * (1.0 + part)];
        let run = Run::new(&motion, &loading, &LINEAR, start).unwrap();
        // The time of the turn, by Newton's method.
        let mut time = cycle.time;
        loop {
            let mut trial = run.clone();
            trial.advance(time).unwrap();
            let now = trial.reading();
            let left = before.input + TAU - now.input;
            if left.abs() < 1e-12 {
                return now.kinetic;
            }
            time += left / now.rate;
        }
    };
    let energy = run_energy(&motion, &loading, [before.input, rate]);
    let part = 1e-4;
    let slope = (changed(part) - changed(-part)) / (energy * 4.0 * part);
    assert_near(slope, cycle.multiplier, 1e-6, "multiplier");
}

fn run_energy(motion: &Motion, loading: &Loading, start: [f64; 2]) -> f64 {
    let mut run = Run::new(motion, loading, &Motor::NONE, start).unwrap();
    run.reading().kinetic
}

/// A constant torque against friction alone: the rate at which the inertia forces load the pairs enough.
#[test]
fn a_constant_torque_against_friction() {
    let (spec, loading) = slider_crank(0.2);
    let (motion, loading) = loaded(&spec, loading);
    let motor = Motor::Constant(0.9);
    let mut cycle = SteadyCycle::new(&motion, &loading, Some(&motor), 20.0).unwrap();
    let from = motion.drawn_input();
    let rate = cycle.rate(from).unwrap();
    let mut run = Run::new(&motion, &loading, &motor, [from, 0.99 * rate]).unwrap();
    run.advance(20.0 * cycle.time).unwrap();
    let now = run.reading();
    let expected = cycle.rate(now.input).unwrap();
    // An excess of the energy shrinks by the multiplier in each turn.
    let left = 0.01 * cycle.multiplier.powi(20);
    assert!(left < 3e-4);
    assert_near(
        1.0 - now.rate / expected,
        left,
        0.02 * left,
        "what is left of the start",
    );
}

/// A rod that presses its slider ever more towards the angle of friction. The friction begins to grow without bound, and
/// the linkage locks in full motion, whatever the motor does.
#[test]
fn a_linkage_that_locks_itself() {
    let (mut spec, mut loading) = slider_crank(1.6);
    spec.points[2].at.x = 0.17;
    loading.flywheel = 0.4;
    let (motion, loading) = loaded(&spec, loading);
    let motor = Motor::Constant(40.0);
    let mut run = Run::new(&motion, &loading, &motor, [0.2, 5.0]).unwrap();
    let mut ended = None;
    for k in 1..=200 {
        if let Err(halt) = run.advance(f64::from(k) * 0.05) {
            ended = Some(halt);
            break;
        }
    }
    let Some(Halt::Locked { time }) = ended else {
        panic!("{ended:?}")
    };
    let now = run.reading();
    assert!(now.time == time && (0.05..0.1).contains(&time), "{time}");
    assert!(now.rate > 0.0 && now.acceleration < 0.0, "{now:?}");
    assert!(run.imbalance().abs() < 1e-9 * now.work);
}
