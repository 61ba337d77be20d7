//! Dimensions of linkages set from the pose at hand: what comes of it is closed, is the
//! same assembly, and goes back; what cannot be is refused with the last value that
//! works.
#![cfg(not(target_family = "wasm"))]

use assur::Point;
use assur::mechanism::{ConstraintKind, Mechanism, Pose};
use assur::motion::{Motion, Refusal};
use assur_file::{from_catalogue, gallery};

fn motion(name: &str) -> Motion {
    from_catalogue(name).unwrap().unwrap().motion().unwrap()
}

/// Inputs over a motion: at its drawing, and away from the ends.
fn inputs(motion: &Motion) -> [f64; 3] {
    let [from, to] = motion.cycle().arcs()[0];
    [
        motion.home(),
        from + 0.15 * (to - from),
        from + 0.65 * (to - from),
    ]
}

/// The largest residual of the constraint equations: lengths relative to the size, and
/// angles.
fn residual(mechanism: &Mechanism, pose: &Pose<1>) -> f64 {
    let sides = mechanism.constraints().iter();
    let off = sides.map(|one| {
        let scale = match one.kind {
            ConstraintKind::Distance { .. } | ConstraintKind::Offset { .. } => {
                mechanism.size().powi(2)
            }
            ConstraintKind::Direction { .. } => 1.0,
            ConstraintKind::Mesh { teeth, .. } => teeth[0] + teeth[1],
        };
        mechanism.sides(pose, one, 0).residual().abs() / scale
    });
    off.fold(0.0, f64::max)
}

fn places(mechanism: &Mechanism, pose: &Pose<1>) -> Vec<Point> {
    let points = mechanism.point_ids();
    points
        .map(|point| mechanism.place(pose, point).place())
        .collect()
}

fn off(a: &[Point], b: &[Point]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).norm())
        .fold(0.0, f64::max)
}

#[test]
fn every_dimension_of_the_catalogue() {
    let [mut shown, mut gave, mut refused] = [0, 0, 0];
    let mut slow = (0.0, String::new());
    for name in gallery() {
        let motion = motion(name);
        let mechanism = motion.mechanism();
        for dimension in mechanism.dimensions() {
            let [from, to] = mechanism.range(dimension).unwrap();
            let was = mechanism.value(dimension).unwrap();
            for input in inputs(&motion) {
                let before = places(mechanism, &motion.pose(input).unwrap());
                for k in 0..9 {
                    let value = from + (to - from) * f64::from(k) / 8.0;
                    let at = format!("{name} {dimension:?} {was} → {value} at {input}");
                    let now = cpu();
                    let changed = motion.changed(dimension, value, input);
                    let took = (cpu() - now) * 1e3;
                    if took > slow.0 {
                        slow = (took, at.clone());
                    }
                    match changed {
                        Ok(changed) => {
                            shown += 1;
                            let (after, after_input, gave_way) =
                                (changed.motion, changed.input, changed.gave_way);
                            let got = after.mechanism().value(dimension).unwrap();
                            assert!((got - value).abs() <= 1e-12 * value.abs().max(1.0), "{at}");
                            let pose = after
                                .pose(after_input)
                                .unwrap_or_else(|e| panic!("{at}: {e}"));
                            assert!(residual(after.mechanism(), &pose) < 1e-9, "{at}");
                            if (after_input - input).abs() < 1e-9 {
                                let back = after.changed(dimension, was, after_input);
                                let same = back.as_ref().is_ok_and(|back| {
                                    let again = &back.motion;
                                    let here =
                                        places(again.mechanism(), &again.pose(back.input).unwrap());
                                    off(&before, &here) < 1e-7 * mechanism.size()
                                });
                                // Where the input gave way in between, there may be another way back.
                                if !same {
                                    println!("BACK {at}: {gave_way} {:?}", back.map(|b| b.input));
                                }
                            } else {
                                gave += 1;
                                println!("gave {at} to {}", after_input);
                            }
                        }
                        Err(Refusal::Apart {
                            last,
                            by,
                            links,
                            cause,
                        }) => {
                            refused += 1;
                            println!("refused {at}: last {last} by {by} {links:?} {cause:?}");
                            let works = motion.changed(dimension, last, input);
                            if works.is_err() {
                                println!("NOLAST {at} {last} {:?}", works.err());
                            }
                        }
                        Err(other) => println!("??? {at}: {other:?}"),
                    }
                }
            }
        }
    }
    println!("{shown} shown, {gave} gave way, {refused} refused; slowest {slow:?}");
}

#[test]
fn speed() {
    for name in gallery() {
        let document = from_catalogue(name).unwrap().unwrap();
        let mechanism = document.mechanism().unwrap();
        let time = |f: &mut dyn FnMut()| {
            let now = cpu();
            for _ in 0..20 {
                f();
            }
            (cpu() - now) * 1e6 / 20.0
        };
        let draft = mechanism.draft().clone();
        let make = time(&mut || {
            Mechanism::new(&draft).unwrap();
        });
        let follow = time(&mut || {
            Motion::new(mechanism.clone());
        });
        let motion = Motion::new(mechanism.clone());
        let all = mechanism.dimensions();
        let first = all[0];
        let was = mechanism.value(first).unwrap();
        let near = time(&mut || {
            let _ = motion.changed(first, was * 1.01, motion.home());
        });
        let far = time(&mut || {
            let _ = motion.changed(first, was * 1.5, motion.home());
        });
        let mut drag = (0.0_f64, String::new());
        for one in &all {
            let [from, to] = mechanism.range(*one).unwrap();
            let was = mechanism.value(*one).unwrap();
            for end in [from, to] {
                let (mut motion, mut input) = (motion.clone(), motion.home());
                for k in 0..=80 {
                    let value = was + (end - was) * f64::from(k) / 80.0;
                    let now = cpu();
                    let changed = motion.changed(*one, value, input);
                    let took = (cpu() - now) * 1e6;
                    if took > drag.0 {
                        drag = (took, format!("{one:?} {value} {}", changed.is_ok()));
                    }
                    if let Ok(changed) = changed {
                        (motion, input) = (changed.motion, changed.input);
                    }
                }
            }
        }
        let mut worst = 0.0_f64;
        for one in &all {
            let [from, to] = mechanism.range(*one).unwrap();
            for value in [from, to] {
                let now = cpu();
                let _ = motion.changed(*one, value, motion.home());
                worst = worst.max((cpu() - now) * 1e6);
            }
        }
        println!(
            "{name}: new {make:.0} motion {follow:.0} near {near:.0} far {far:.0} worst {worst:.0} µs drag {drag:?}"
        );
    }
}

fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    text.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
