//! The least ΣJ against an optimiser that knows nothing of ours: a grid of all three lengths, and
//! from its lowest places the simplex of Nelder and Mead (1965).

use assur::synthesis::four_bar::{Position, Proportions, Search, Task};

use super::draw::{Dice, output, task};

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

#[test]
fn never_worse_than_another_optimiser() {
    let mut dice = Dice::new(200);
    let (mut worst, mut better, mut ours_only) = (0.0_f64, 0, 0);
    for number in 0..200 {
        let count = 4 + number % 9;
        let positions = drawn(&mut dice, number % 3, count);
        let mut search = Search::new(&task(&positions));
        let minima = search.run();
        let other = independent(&positions);
        let best = &minima[0];
        let Proportions {
            coupler,
            output,
            input,
        } = best.solution.proportions;
        let again = defect(&positions, [coupler, output, input]);
        assert!(
            (again - best.value).abs() <= 1e-13 * (1.0 + again),
            "{again} {}",
            best.value
        );
        for z in [coupler, output, input] {
            assert!(
                (Task::RATIOS[0]..=Task::RATIOS[1]).contains(&(z * (1.0 - 1e-15)))
                    || z <= 10.000001,
                "{z}"
            );
        }
        if best.value > other * (1.0 + 1e-9) + 1e-15 {
            println!(
                "{number} kind {}: {} {other} reached {} of {}",
                number % 3,
                best.value,
                best.reached,
                search.progress().starts
            );
        }
        worst = worst.max(best.value - other);
        better += usize::from(best.value < other * (1.0 - 1e-6));
        ours_only += minima.len();
    }
    println!("worst {worst:e}, better in {better}, minima {ours_only}");
}

#[test]
fn eight() {
    let mut dice = Dice::new(8);
    let tasks: Vec<_> = (0..30).map(|k| task(&drawn(&mut dice, k % 3, 8))).collect();
    let t = std::time::Instant::now();
    for task in &tasks {
        Search::new(task).run();
    }
    println!("ms {}", t.elapsed().as_secs_f64() * 1e3 / 30.0);
    for task in tasks.iter().take(6) {
        let mut s = Search::new(task);
        let m = s.run();
        println!(
            "{} starts; {:?}",
            s.progress().starts,
            m.iter()
                .map(|m| (
                    m.value,
                    m.reached,
                    m.path.len(),
                    m.held.clone(),
                    m.solution.proportions
                ))
                .collect::<Vec<_>>()
        );
    }
    let t = std::time::Instant::now();
    for task in &tasks {
        Search::free(task).run();
    }
    println!("free ms {}", t.elapsed().as_secs_f64() * 1e3 / 30.0);
    for task in tasks.iter().take(6) {
        let mut s = Search::free(task);
        let m = s.run();
        println!(
            "{} starts; {:?}",
            s.progress().starts,
            m.iter()
                .take(4)
                .map(|m| (m.value, m.reached, m.path.len(), m.held.clone()))
                .collect::<Vec<_>>()
        );
    }
    let _ = output;
}
