//! The pairs of five poses against another method: Newton's method in complex affine coordinates from many starts, on
//! the condition that each of five places of the circle point lies on one circle of unknown squared radius.

use assur::synthesis::poses::{Burmester, Dyad, Task};
use nalgebra::{Complex, Matrix4, Vector4};

use super::sample::{anywhere, guided};
use crate::positions::draw::Dice;

type C = Complex<f64>;

const TASKS: usize = 60;
const STARTS: usize = 400;

/// The circle point (u, v) and the centre (x, y), complex.
type Unknowns = Vector4<C>;

/// Differences of the squared distances in the first pose and in each other one, with their derivatives.
fn system(task: &Task, z: &Unknowns) -> (Vector4<C>, Matrix4<C>) {
    let first = task.poses()[0];
    let mut values = Vector4::zeros();
    let mut slopes = Matrix4::zeros();
    let real = |x: f64| C::new(x, 0.0);
    for k in 0..4 {
        let pose = task.poses()[k + 1];
        let (sin, cos) = (pose.angle - first.angle).sin_cos();
        let [u, v] = [z[0] - first.x, z[1] - first.y];
        let moved = [
            u * cos - v * sin + pose.x - z[2],
            u * sin + v * cos + pose.y - z[3],
        ];
        let start = [z[0] - z[2], z[1] - z[3]];
        let square = |[a, b]: [C; 2]| a * a + b * b;
        values[k] = square(moved) - square(start);
        let two = real(2.0);
        slopes[(k, 0)] = two * (moved[0] * cos + moved[1] * sin - start[0]);
        slopes[(k, 1)] = two * (moved[1] * cos - moved[0] * sin - start[1]);
        slopes[(k, 2)] = two * (start[0] - moved[0]);
        slopes[(k, 3)] = two * (start[1] - moved[1]);
    }
    (values, slopes)
}

fn solution(task: &Task, mut z: Unknowns) -> Option<Unknowns> {
    for _ in 0..60 {
        let (values, slopes) = system(task, &z);
        let step = slopes.lu().solve(&values)?;
        z -= step;
        let size = z.map(|z| z.norm()).max();
        if size > 1e7 {
            return None;
        }
        if step.map(|z| z.norm()).max() < 1e-13 * (1.0 + size) {
            return Some(z);
        }
    }
    None
}

/// Solutions from many starts, each with the number of starts that led to it.
fn solutions(task: &Task, dice: &mut Dice) -> Vec<(Unknowns, usize)> {
    let mut found: Vec<(Unknowns, usize)> = Vec::new();
    for _ in 0..STARTS {
        let reach = dice.ratio(10.0);
        let mut part = || C::new(dice.between(-reach, reach), dice.between(-reach, reach));
        let start = Unknowns::new(part(), part(), part(), part());
        let Some(z) = solution(task, start) else {
            continue;
        };
        let near = |other: &&mut (Unknowns, usize)| {
            (z - other.0).map(|z| z.norm()).max() < 1e-6 * (1.0 + z.map(|z| z.norm()).max())
        };
        match found.iter_mut().find(near) {
            Some(other) => other.1 += 1,
            None => found.push((z, 1)),
        }
    }
    found
}

#[test]
fn no_pair_of_five_poses_is_missing() {
    let mut dice = Dice::new(55);
    let (mut real_ones, mut all) = (0, 0);
    for number in 0..TASKS {
        let task = if number % 2 == 0 {
            anywhere(&mut dice, 5)
        } else {
            guided(&mut dice, 5, 0.05).task
        };
        let found = Burmester::new(&task).unwrap();
        assert!(found.complete, "{task:?} {found:?}");
        assert_eq!(found.dyads.len() + found.complex, 4, "{task:?} {found:?}");
        let expected = solutions(&task, &mut dice);
        assert!(expected.len() <= 4, "{task:?} {expected:?}");
        all += expected.len();
        for (z, _) in &expected {
            let size = 1.0 + z.map(|z| z.norm()).max();
            let is_real = z.iter().all(|z| z.im.abs() < 1e-8 * size);
            let near = |dyad: &Dyad| match *dyad {
                Dyad::Hinges { pivot, point } => {
                    let at = [point.x, point.y, pivot.x, pivot.y];
                    (0..4).all(|k| (z[k] - C::new(at[k], 0.0)).norm() < 1e-6 * size)
                }
                _ => false,
            };
            assert_eq!(
                found.dyads.iter().any(near),
                is_real,
                "{task:?} {found:?} {z}"
            );
            real_ones += usize::from(is_real);
        }
    }
    // Newton's method misses few pairs itself.
    assert!(all >= 4 * TASKS - 8, "{all}");
    assert!(real_ones >= TASKS, "{real_ones}");
}
