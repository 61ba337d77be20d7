//! Verdicts on a solution, against the motion of the same linkage in the simulator.

use std::f64::consts::PI;

use assur::FourBar;
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::synthesis::four_bar::{
    Frame, Order, Passage, Position, Proportions, Solution, Task, ThreePositions, five_positions,
};
use assur_tests::{angle_between, scaled};

use super::draw::{Dice, task};

/// The motion of a solution from its first position, and whether it takes up each position.
fn met(solution: &Solution, task: &Task) -> (Motion, Vec<bool>) {
    let motion = Motion::new(Mechanism::new(&solution.spec(task).unwrap()).unwrap());
    let rocker = motion.mechanism().link("rocker").unwrap();
    let met = task.positions().iter().map(|position| {
        let input = motion.cycle().wrap(position.input + solution.input_start);
        let turns = motion.cycle().period().filter(|_| motion.cycle().is_full());
        let again = turns.map(|period| input + period / 2.0);
        let inputs = [Some(input), again.filter(|_| turns > Some(7.0))];
        inputs.into_iter().flatten().any(|input| {
            let Ok(pose) = motion.pose::<1>(input) else {
                return false;
            };
            let angle = motion.mechanism().angle(&pose, rocker).value();
            let wanted = position.output + solution.output_start + PI;
            angle_between(angle, wanted) < 1e-6
        })
    });
    let met = met.collect();
    (motion, met)
}

/// The verdict says that it goes through all positions where the motion does, and only there; the
/// other reasons are those of the motion, too.
#[test]
fn passage_is_that_of_the_motion() {
    let mut dice = Dice::new(77);
    let mut seen = [0; 4];
    for _ in 0..600 {
        let z = dice.proportions(3.0);
        let Some(positions) = dice.taken(&z, 3) else {
            continue;
        };
        let task = task(&positions);
        let solution = Solution::new(&task, z);
        let verdict = solution.verdict.as_ref().unwrap();
        let (motion, met) = met(&solution, &task);
        assert!(met[0]);
        let all = met.iter().all(|met| *met);
        assert_eq!(verdict.passage == Passage::Continuous, all, "{solution:?}");
        assert_eq!(verdict.turns, motion.cycle().is_full());
        let kind = match verdict.passage {
            Passage::Continuous => 0,
            // With one arc of the input both assemblies meet at its ends.
            Passage::AcrossDeadPoint => {
                assert!(!verdict.turns);
                let linkage = z.four_bar(1.0).unwrap();
                assert_eq!(verdict.assembly, None);
                let arcs = linkage.cycle().arcs().len();
                let same_side =
                    |p: &Position| (p.input.sin() > 0.0) == (positions[0].input.sin() > 0.0);
                assert!(arcs == 1 || positions.iter().all(same_side));
                1
            }
            Passage::OtherCircuit => {
                let linkage = z.four_bar(1.0).unwrap();
                assert!(verdict.turns || linkage.cycle().arcs().len() == 2);
                2
            }
            other => panic!("{other:?}"),
        };
        seen[kind] += 1;
    }
    assert!(seen[..3].iter().all(|count| *count > 20), "{seen:?}");
}

/// The order is the one in which the motion comes to the positions; the least transmission angle is
/// that of many poses on the way.
#[test]
fn order_and_transmission_are_those_of_the_motion() {
    let mut dice = Dice::new(78);
    let mut seen = [0; 3];
    for _ in 0..scaled(2_000) {
        let z = dice.proportions(3.0);
        let Some(positions) = dice.taken(&z, 3) else {
            continue;
        };
        let solution = Solution::new(&task(&positions), z);
        let verdict = solution.verdict.unwrap();
        if verdict.passage != Passage::Continuous {
            assert_eq!(
                (verdict.order, verdict.transmission_between),
                (Order::Mixed, None)
            );
            continue;
        }
        let linkage = z.four_bar(1.0).unwrap();
        let inputs = [0, 1, 2].map(|k: usize| positions[k].input);
        // From the first position on, a step at a time, one way and the other.
        let ways = [1.0, -1.0].map(|sense| walk(&linkage, inputs, sense));
        let order = match (ways[0].0, ways[1].0) {
            (true, false) => Order::Growing,
            (false, true) => Order::Falling,
            (false, false) => Order::Mixed,
            (true, true) => panic!("{inputs:?}"),
        };
        assert_eq!(verdict.order, order, "{inputs:?} {linkage:?}");
        let least = match order {
            Order::Growing => ways[0].1,
            Order::Falling => ways[1].1,
            _ => continue,
        };
        let between = verdict.transmission_between.unwrap();
        assert!((between - least).abs() < 2e-2, "{between} {least}");
        assert!(verdict.transmission <= between + 1e-12);
        seen[usize::from(verdict.turns)] += 1;
    }
    assert!(seen[0] > scaled(10) && seen[1] > scaled(10), "{seen:?}");
}

/// Whether the second and then the third input come while the first grows (or falls), before the
/// dead point or the first again; the least transmission angle until the third.
fn walk(linkage: &FourBar, inputs: [f64; 3], sense: f64) -> (bool, f64) {
    const STEPS: usize = 20_000;
    let step = std::f64::consts::TAU / STEPS as f64;
    let mut next = 1;
    let mut least = f64::INFINITY;
    for k in 0..STEPS {
        let input = inputs[0] + sense * step * k as f64;
        let Ok(angle) = linkage.transmission_angle(input) else {
            return (false, least);
        };
        least = least.min(angle);
        let ahead = (sense * (inputs[next] - input)).rem_euclid(std::f64::consts::TAU);
        let beyond =
            next == 1 && (sense * (inputs[2] - input)).rem_euclid(std::f64::consts::TAU) < step;
        if beyond && (sense * (inputs[1] - inputs[2])).rem_euclid(std::f64::consts::TAU) > step {
            return (false, least);
        }
        if ahead < step {
            next += 1;
            if next == 3 {
                return (true, least);
            }
        }
    }
    (false, least)
}

/// With any frame and with free starts a solution goes through its positions as the simulator moves
/// it, where the verdict says so.
#[test]
fn solutions_take_up_their_positions() {
    let mut dice = Dice::new(79);
    let (mut three, mut five) = (0, 0);
    for _ in 0..300 {
        let z = dice.proportions(3.0);
        let frame = Frame {
            length: dice.ratio(100.0),
            angle: dice.angle(),
        };
        for count in [3, 5] {
            let Some(mut positions) = dice.taken(&z, count) else {
                continue;
            };
            let starts = if count == 5 {
                [dice.angle(), dice.angle()]
            } else {
                [0.0; 2]
            };
            for position in &mut positions {
                position.output += frame.angle - starts[0];
                position.input += frame.angle - starts[1];
            }
            let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
            let found = if count == 5 {
                five_positions(&task).unwrap()
            } else {
                match ThreePositions::new(&task) {
                    Some(ThreePositions::One(one)) => vec![one],
                    other => panic!("{other:?}"),
                }
            };
            for solution in found {
                for k in 0..count {
                    let drawn = solution.drawn(&task, k).unwrap();
                    let gap = (drawn.c - drawn.coupler_end).norm();
                    assert!(
                        gap < 1e-9 * frame.length * solution.proportions.size_ratio(),
                        "{gap}"
                    );
                }
                let Ok(verdict) = solution.verdict.clone() else {
                    continue;
                };
                if verdict.passage != Passage::Continuous
                    || verdict.transmission_between < Some(0.01)
                {
                    continue;
                }
                let (_, met) = met(&solution, &task);
                assert!(met.iter().all(|met| *met), "{solution:?} {met:?}");
                if count == 3 { three += 1 } else { five += 1 }
            }
        }
    }
    assert!(three > 20 && five > 5, "{three} {five}");
}

/// The inputs that close the loop with given coupler and output are those and all of them.
#[test]
fn closing_inputs() {
    let mut dice = Dice::new(80);
    let mut counts = [0; 3];
    for _ in 0..scaled(2_000) {
        let task = task(&dice.positions(1));
        let [coupler, output] = [dice.ratio(5.0), dice.ratio(5.0)];
        let found = task.closing_inputs(0, coupler, output);
        assert!(found.is_sorted_by(|a, b| a < b));
        for input in &found {
            let z = Proportions {
                coupler,
                output,
                input: *input,
            };
            let off = Solution::new(&task, z).worst_residual();
            assert!(off < 1e-12 * (1.0 + input), "{off} {z:?}");
        }
        // As many as the residual changes its sign along z₃, in steps that miss few.
        let residual = |input: f64| {
            let z = Proportions {
                coupler,
                output,
                input,
            };
            Solution::new(&task, z).closures[0].residual
        };
        let steps = (1..400).map(|k| residual(0.05 * f64::from(k)) > 0.0);
        let signs: Vec<bool> = [residual(1e-9) > 0.0].into_iter().chain(steps).collect();
        let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(changes <= found.len(), "{changes} {found:?}");
        let close = found.windows(2).any(|pair| pair[1] - pair[0] < 0.06);
        assert!(changes == found.len() || close, "{changes} {found:?}");
        counts[found.len()] += 1;
    }
    assert!(counts.iter().all(|count| *count > scaled(50)), "{counts:?}");
    let task = task(&dice.positions(1));
    assert!(task.closing_inputs(1, 1.0, 1.0).is_empty());
    assert!(task.closing_inputs(0, f64::NAN, 1.0).is_empty());
}

/// Positions of a parallelogram: at the change points it may go either way.
#[test]
fn change_points() {
    let z = Proportions {
        coupler: 1.0,
        output: 0.5,
        input: 0.5,
    };
    let verdict = |positions: &[(f64, f64)]| {
        let positions: Vec<Position> = (positions.iter())
            .map(|(output, input): &(f64, f64)| {
                Position::new(output.to_radians(), input.to_radians())
            })
            .collect();
        Solution::new(&task(&positions), z).verdict.unwrap()
    };
    // As a parallelogram on both sides of the line: one motion, smooth through the change point.
    let along = verdict(&[(240.0, 60.0), (380.0, 200.0)]);
    assert_eq!(along.passage, Passage::Continuous);
    assert_eq!(along.grashof, assur::Grashof::ChangePoint);
    // Once as a parallelogram and once as an antiparallelogram.
    let crossed = super::draw::output(&z, 1.0, true).unwrap();
    let other = super::draw::output(&z, 1.0, false).unwrap();
    let parallel = |output: f64| angle_between(output, 1.0 + PI) < 1e-9;
    let crossed = if parallel(crossed) { other } else { crossed };
    let both = verdict(&[(240.0, 60.0), (crossed.to_degrees(), 1.0_f64.to_degrees())]);
    assert_eq!(both.passage, Passage::ThroughChangePoint);
}
