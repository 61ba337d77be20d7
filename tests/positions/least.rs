//! The least ΣJ against an independent optimiser: a grid of all three lengths, then the simplex of Nelder and Mead
//! (1965) from the lowest points of the grid.

use std::f64::consts::PI;

use assur::synthesis::four_bar::{Options, Position, Search, Solution, Surface, Task};
use assur::{Assembly, FourBar};

use super::draw::{Dice, task};

/// Places of the grid along each length, and from how many a simplex goes down.
const GRID: usize = 20;
const LOWEST: usize = 8;

/// ΣJ, by the angles themselves.
fn defect(positions: &[Position], z: [f64; 3]) -> f64 {
    let open = |position: &Position| {
        let x = 1.0 - z[1] * position.output.cos() - z[2] * position.input.cos();
        let y = -z[1] * position.output.sin() - z[2] * position.input.sin();
        position.weight * (x.hypot(y) - z[0]).powi(2)
    };
    positions.iter().map(open).sum()
}

fn independent(positions: &[Position]) -> f64 {
    let [from, to] = Task::RATIOS.map(f64::ln);
    let table: Vec<[f64; 4]> = positions
        .iter()
        .map(|p| [p.output.cos(), p.output.sin(), p.input.cos(), p.input.sin()])
        .collect();
    let f = |x: [f64; 3]| {
        let [z1, z2, z3] = x.map(|x| x.clamp(from, to).exp());
        let open = |(at, p): (&[f64; 4], &Position)| {
            let [x, y] = [1.0 - z2 * at[0] - z3 * at[2], -z2 * at[1] - z3 * at[3]];
            p.weight * ((x * x + y * y).sqrt() - z1).powi(2)
        };
        table.iter().zip(positions).map(open).sum::<f64>()
    };
    let at = |k: usize| from + k as f64 / (GRID - 1) as f64 * (to - from);
    let mut grid: Vec<(f64, [f64; 3])> = (0..GRID.pow(3))
        .map(|k| [at(k % GRID), at(k / GRID % GRID), at(k / GRID / GRID)])
        .map(|x| (f(x), x))
        .collect();
    grid.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Lowest places apart from each other.
    let mut starts: Vec<[f64; 3]> = Vec::new();
    for (_, x) in grid {
        let apart = |y: &[f64; 3]| (0..3).any(|k| (x[k] - y[k]).abs() > 0.6);
        if starts.len() < LOWEST && starts.iter().all(apart) {
            starts.push(x);
        }
    }
    let ends = starts.into_iter().map(|x| {
        let once = simplex(&f, x, 0.2);
        f(simplex(&f, once, 0.02))
    });
    ends.fold(f64::INFINITY, f64::min)
}

fn simplex(f: &impl Fn([f64; 3]) -> f64, start: [f64; 3], size: f64) -> [f64; 3] {
    let mut corners: Vec<([f64; 3], f64)> = (0..4)
        .map(|k| {
            let mut x = start;
            if k < 3 {
                x[k] += size;
            }
            (x, f(x))
        })
        .collect();
    for _ in 0..600 {
        corners.sort_by(|a, b| a.1.total_cmp(&b.1));
        let centre: [f64; 3] =
            std::array::from_fn(|k| corners[..3].iter().map(|c| c.0[k]).sum::<f64>() / 3.0);
        let worst = corners[3];
        let along = |t: f64| {
            let x: [f64; 3] = std::array::from_fn(|k| centre[k] + t * (worst.0[k] - centre[k]));
            (x, f(x))
        };
        let turned = along(-1.0);
        let next = if turned.1 < corners[0].1 {
            let far = along(-2.0);
            if far.1 < turned.1 { far } else { turned }
        } else if turned.1 < corners[2].1 {
            turned
        } else {
            along(if turned.1 < worst.1 { -0.5 } else { 0.5 })
        };
        if next.1 < worst.1 {
            corners[3] = next;
        } else {
            let best = corners[0].0;
            for corner in &mut corners[1..] {
                let x: [f64; 3] = std::array::from_fn(|k| 0.5 * (corner.0[k] + best[k]));
                *corner = (x, f(x));
            }
        }
    }
    corners.sort_by(|a, b| a.1.total_cmp(&b.1));
    corners[0].0
}

/// Positions of all kinds: at random, along a smooth function, near those of a linkage; weighted.
fn drawn(dice: &mut Dice, kind: usize, count: usize) -> Vec<Position> {
    let mut positions = dice.positions(count);
    if kind == 1 {
        let [from, width, bend] = [(); 3].map(|()| dice.between(-1.5, 1.5));
        for (k, position) in positions.iter_mut().enumerate() {
            let x = k as f64 / count as f64;
            position.input = from + width * x;
            position.output = 2.0 + x + bend * x * x;
        }
    } else if kind == 2 {
        while let Some(taken) = Some(dice.proportions(5.0)).map(|z| dice.taken(&z, count)) {
            if let Some(taken) = taken {
                positions = taken;
                break;
            }
        }
        for position in &mut positions {
            position.output += dice.between(-0.05, 0.05);
        }
    }
    for position in &mut positions {
        position.weight = dice.ratio(3.0);
    }
    positions
}

/// In none of 200 tasks is the least that is found greater than the other one's.
#[test]
fn never_worse_than_another_optimiser() {
    let mut dice = Dice::new(200);
    let mut inner = 0;
    for number in 0..200 {
        let positions = drawn(&mut dice, number % 3, 4 + number % 9);
        let mut search = Search::new(&task(&positions));
        let minima = search.run();
        let best = &minima[0];
        let z = best.solution.proportions;
        let [least, greatest] = Task::RATIOS;
        for z in [z.coupler, z.output, z.input] {
            assert!((least..=greatest).contains(&z), "{z}");
        }
        let again = defect(&positions, [z.coupler, z.output, z.input]);
        assert!((again - best.value).abs() <= 1e-13 * (1.0 + again));
        assert!((best.solution.defect(&task(&positions)) - again).abs() <= 1e-13 * (1.0 + again));
        let other = independent(&positions);
        assert!(
            best.value <= other * (1.0 + 1e-9) + 1e-15,
            "{number}: {} {other}",
            best.value
        );
        inner += usize::from(best.held.is_empty());
        // Every start ended in one of them, each the best of its own.
        let ended: usize = minima.iter().map(|minimum| minimum.reached).sum();
        assert_eq!(ended, search.progress().starts);
        assert!(minima.is_sorted_by(|a, b| a.value <= b.value));
    }
    assert!((20..180).contains(&inner), "{inner}");
}

/// What is found is a minimum: nothing near is less, within the bounds.
#[test]
fn every_minimum_is_one() {
    let mut dice = Dice::new(201);
    for number in 0..30 {
        let positions = drawn(&mut dice, number % 3, 6);
        for minimum in Search::new(&task(&positions)).run() {
            let z = minimum.solution.proportions;
            let z = [z.coupler, z.output, z.input];
            let [least, greatest] = Task::RATIOS;
            for _ in 0..200 {
                let near = z.map(|z| (z * dice.ratio(1.003)).clamp(least, greatest));
                let value = defect(&positions, near);
                assert!(value >= minimum.value - 1e-15, "{value} {minimum:?}");
            }
        }
    }
}

/// The search goes downhill, step by step, can be asked at any time, and is the same each time.
#[test]
fn step_by_step() {
    let mut dice = Dice::new(202);
    let task = task(&drawn(&mut dice, 1, 8));
    let mut search = Search::new(&task);
    let mut steps = 0;
    let mut before = search.progress();
    loop {
        let now = search.step();
        steps += 1;
        if now.ended == before.ended {
            assert!(now.value <= before.value);
            let last = search.path().last().unwrap();
            assert_eq!(*last, now.proportions);
        }
        if now.over {
            break;
        }
        before = now;
    }
    assert!(steps > before.starts);
    let minima = search.minima();
    assert_eq!(search.progress().best, Some(minima[0].value));
    assert_eq!(minima, Search::new(&task).run());
    // Every start has its way, to the minimum that it ended in.
    let ways: usize = minima.iter().map(|minimum| minimum.paths.len()).sum();
    assert_eq!(ways, before.starts);
    for minimum in &minima {
        assert_eq!(minimum.paths.len(), minimum.reached);
        for way in &minimum.paths {
            assert_eq!(way.last(), Some(&minimum.solution.proportions));
        }
    }
    // Once over, nothing changes.
    assert_eq!(search.step(), search.progress());
}

/// Linkages are found again from many positions, with free starts from eight.
#[test]
fn exact_positions_are_met() {
    let mut dice = Dice::new(203);
    let mut done = 0;
    while done < 60 {
        let z = dice.proportions(4.0);
        let Some(mut positions) = dice.taken(&z, 8) else {
            continue;
        };
        done += 1;
        let best = Search::new(&task(&positions)).run().swap_remove(0);
        assert!(best.value < 1e-24, "{}", best.value);
        assert!((best.solution.proportions.output / z.output - 1.0).abs() < 1e-7);
        let starts = [dice.angle(), dice.angle()];
        for position in &mut positions {
            position.output -= starts[0];
            position.input -= starts[1];
        }
        let best = Search::free(&task(&positions)).run().swap_remove(0);
        assert!(best.value < 1e-24, "{}", best.value);
        assert!(best.held.is_empty());
        assert!(best.solution.worst_residual() < 1e-11);
    }
}

/// Free starts can only be better than given ones; the surface has the same least.
#[test]
fn freedom_helps() {
    let mut dice = Dice::new(204);
    for _ in 0..10 {
        let task = task(&drawn(&mut dice, 2, 7));
        let given = Search::new(&task).run().swap_remove(0);
        let free = Search::free(&task).run().swap_remove(0);
        assert!(free.value <= given.value, "{} {}", free.value, given.value);
        let surface = Surface::new(&task);
        let z = given.solution.proportions;
        let least = surface.value(z.output, z.input).unwrap();
        assert!((least - given.value).abs() <= 1e-14);
        for k in 0..400 {
            let at = |k: usize| 0.1 * 100.0_f64.powf(k as f64 / 19.0);
            let value = surface.value(at(k % 20), at(k / 20)).unwrap();
            assert!(value >= given.value * (1.0 - 1e-12));
        }
        assert_eq!(surface.value(0.0, 1.0), None);
        assert_eq!(surface.value(f64::NAN, 1.0), None);
    }
}

/// With free starts the least does not hang on where the angles are measured from, nor on the order of the
/// positions, though both change every start of the search.
#[test]
fn free_starts_are_free() {
    let mut dice = Dice::new(205);
    for number in 0..24 {
        let mut positions = drawn(&mut dice, number % 3, 8);
        let least = Search::free(&task(&positions)).run()[0].value;
        for _ in 0..4 {
            for k in (1..positions.len()).rev() {
                let other = dice.between(0.0, (k + 1) as f64) as usize;
                positions.swap(k, other);
            }
            let starts = [dice.angle(), dice.angle()];
            for position in &mut positions {
                position.output += starts[0];
                position.input += starts[1];
            }
            let again = Search::free(&task(&positions)).run()[0].value;
            assert!(
                (again - least).abs() <= 1e-6 * least + 1e-14,
                "{again} {least}"
            );
        }
    }
}

/// By how much the output is off is what the poses of the four-bar have it, in the nearer assembly.
#[test]
fn errors_of_the_output_are_those_of_the_poses() {
    let mut dice = Dice::new(206);
    let (mut reached, mut missed) = (0, 0);
    for _ in 0..500 {
        let z = dice.proportions(3.0);
        let given = Position::new(dice.angle(), dice.angle());
        let solution = Solution::new(&task(&[given]), z);
        let found = solution.output_error(&task(&[given]));
        // What no four-bar can be made of closes nowhere.
        let linkage = FourBar::new([z.input, z.coupler, z.output, 1.0]).ok();
        let off = [Assembly::First, Assembly::Second].map(|assembly| {
            let pose = linkage.as_ref()?.pose::<1>(assembly, given.input).ok()?;
            let off = pose.rocker.value() - (given.output + PI);
            Some(((off + PI).rem_euclid(2.0 * PI) - PI).abs())
        });
        match off {
            [Some(one), Some(other)] => {
                reached += 1;
                let expected = one.min(other);
                let error = found.unwrap();
                assert!((error - expected).abs() < 1e-9, "{error} {expected}");
            }
            _ => {
                missed += 1;
                assert_eq!(found, None);
            }
        }
    }
    assert!(reached > 100 && missed > 30, "{reached} {missed}");
}

/// What is shown first is off by least of all that no bound holds, and numbers stay those of the sums.
#[test]
fn solutions_are_shown_by_their_error() {
    let mut dice = Dice::new(207);
    let mut others = 0;
    for number in 0..30 {
        let positions = drawn(&mut dice, number % 3, 6);
        let options = Options::new(&task(&positions), false).unwrap();
        let order = options.order();
        let Options::Minima { minima, .. } = &options else {
            panic!("{options:?}");
        };
        let key = |number: &usize| {
            let one = &minima[*number];
            (
                !one.held.is_empty(),
                one.output_error.unwrap_or(f64::INFINITY),
            )
        };
        let keys: Vec<(bool, f64)> = order.iter().map(key).collect();
        assert!(keys.is_sorted(), "{keys:?}");
        assert_eq!(options.best(), order[0]);
        assert!(minima.is_sorted_by(|a, b| a.value <= b.value));
        let mut numbers = order.clone();
        numbers.sort_unstable();
        assert!(numbers.into_iter().eq(0..minima.len()));
        others += usize::from(order[0] != 0);
    }
    assert!(others > 3, "{others}");
}

/// Angles of the output from D to C in place of C to D are known for what they are, exact or not.
#[test]
fn turned_outputs_are_told() {
    let mut dice = Dice::new(208);
    let mut done = 0;
    while done < 60 {
        let z = dice.proportions(4.0);
        let Some(mut positions) = dice.taken(&z, 6) else {
            continue;
        };
        done += 1;
        for position in &mut positions {
            position.output += dice.between(-1e-5, 1e-5);
        }
        assert!(!task(&positions).output_is_turned());
        for position in &mut positions {
            position.output += PI;
        }
        assert!(task(&positions).output_is_turned());
        assert!(!task(&positions[..3]).output_is_turned());
    }
}
