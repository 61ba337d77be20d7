//! Interpolation and the weighted difference as special cases of the least ΣJ.

use assur::synthesis::four_bar::{
    Position, Proportions, Search, Solution, Task, ThreePositions, weighted_difference,
};

use super::draw::{Dice, task};

fn distance(a: &Proportions, b: &Proportions) -> f64 {
    let off = [
        a.coupler - b.coupler,
        a.output - b.output,
        a.input - b.input,
    ];
    off.iter().fold(0.0, |sum: f64, off| sum.hypot(*off))
}

/// Three positions: Freudenstein's interpolation, the least sum of squares of his equations and the
/// least ΣJ are one linkage, and nothing is left of either sum.
#[test]
fn interpolation_of_three_positions() {
    let mut dice = Dice::new(31);
    let mut done = 0;
    while done < 200 {
        let z = dice.proportions(3.0);
        let Some(positions) = dice.taken(&z, 3) else {
            continue;
        };
        done += 1;
        let task = task(&positions);
        let Some(ThreePositions::One(exact)) = ThreePositions::new(&task) else {
            panic!("{positions:?}");
        };
        let linear = weighted_difference(&task).unwrap();
        assert!(
            distance(&linear, &exact.proportions) < 1e-6,
            "{linear:?} {exact:?}"
        );
        let best = Search::new(&task).run().swap_remove(0);
        assert!(best.value < 1e-26, "{}", best.value);
        assert!(distance(&best.solution.proportions, &exact.proportions) < 1e-6);
    }
}

/// What Freudenstein's equation is off by.
fn off(z: &Proportions, at: &Position) -> f64 {
    let constant =
        (z.coupler.powi(2) - z.output.powi(2) - z.input.powi(2) - 1.0) / (2.0 * z.output * z.input);
    let terms = constant + at.output.cos() / z.input + at.input.cos() / z.output;
    (at.output - at.input).cos() - terms
}

/// At any proportions, good or bad, the sum of Levitsky's squares is ΣJ with the weights
/// ((|r| + z₁)/(2z₂z₃))².
#[test]
fn weights_that_make_the_one_the_other() {
    let mut dice = Dice::new(32);
    for _ in 0..2000 {
        let z = dice.proportions(5.0);
        let mut positions = dice.positions(6);
        let squares: f64 = positions.iter().map(|at| off(&z, at).powi(2)).sum();
        let gaps = Solution::new(&task(&positions), z).closures;
        for (position, closure) in positions.iter_mut().zip(gaps) {
            let gap = closure.residual + z.coupler;
            position.weight = ((gap + z.coupler) / (2.0 * z.output * z.input)).powi(2);
        }
        let weighted = task(&positions);
        let sum = Solution::new(&weighted, z).defect(&weighted);
        assert!((sum / squares - 1.0).abs() < 1e-10, "{sum} {squares}");
    }
}

/// Near a linkage the two minima differ by the square of what is left open: halving that brings them
/// four times nearer to each other, and only twice nearer to the linkage. There the weights are the
/// same at every position but for what is left open.
#[test]
fn minima_differ_in_the_second_order() {
    let mut dice = Dice::new(33);
    let mut done = 0;
    while done < 40 {
        let z = dice.proportions(2.0);
        let Some(exact) = dice.taken(&z, 7) else {
            continue;
        };
        let noise: Vec<f64> = exact.iter().map(|_| dice.between(-1.0, 1.0)).collect();
        let both = |size: f64| {
            let mut positions = exact.clone();
            for (position, noise) in positions.iter_mut().zip(&noise) {
                position.output += size * noise;
            }
            let wide = Task::new(task(&exact).frame(), &positions, [0.01, 100.0]).unwrap();
            let least = Search::new(&wide).run().swap_remove(0).solution.proportions;
            let linear = weighted_difference(&wide).unwrap();
            [distance(&least, &linear), distance(&least, &z)]
        };
        let [apart, from_exact] = both(2e-4);
        // Positions that hardly tell the lengths apart are for no asymptotics.
        if from_exact > 5e-3 || apart < 1e-9 {
            continue;
        }
        done += 1;
        let [nearer, from_exact_then] = both(1e-4);
        let ratio = apart / nearer;
        assert!((3.6..4.4).contains(&ratio), "{ratio} {apart:e} {nearer:e}");
        let ratio = from_exact / from_exact_then;
        assert!((1.8..2.2).contains(&ratio), "{ratio}");
    }
}
