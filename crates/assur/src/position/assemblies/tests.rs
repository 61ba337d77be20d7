use super::bilinear::{Affine, Bilinear, C, System};
use super::solutions::distance;
use super::{dixon, homotopy};

/// Knuth's linear congruential generator, with a given seed.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn complex(&mut self) -> C {
        C::new(self.next(), self.next())
    }

    /// A system of directions of length 1 with a known solution, and this solution with its conjugates.
    fn system(&mut self, unknowns: usize) -> (System, Vec<C>) {
        let solution: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
        let equations = (0..2 * unknowns).map(|_| {
            let by: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
            let direction = C::from_polar(1.0, 3.0 * self.next());
            let sum: C = by.iter().zip(&solution).map(|(by, z)| by * z).sum();
            let constant = direction - sum;
            Bilinear::Unit([
                Affine { constant, by },
                Affine::constant(C::default(), unknowns),
            ])
        });
        let equations = equations.collect();
        let conjugates = solution.iter().map(|z| z.conj());
        let both = solution.iter().copied().chain(conjugates).collect();
        (System::new(unknowns, equations, Vec::new()).unwrap(), both)
    }
}

fn all(system: &System, candidates: Vec<Vec<C>>) -> Vec<Vec<C>> {
    let mut found = Vec::new();
    system.add(candidates, &mut found);
    found
}

/// Directions in general position have the maximum number of solutions, C(2m, m).
#[test]
fn every_solution_of_general_directions() {
    for (unknowns, count) in [(1, 2), (2, 6), (3, 20), (4, 70)] {
        let seeds = if unknowns < 4 { 40 } else { 2 };
        for seed in 0..seeds {
            let (system, solution) = Dice(seed).system(unknowns);
            let by_dixon = dixon::candidates(&system, seed as usize).unwrap();
            for found in [
                all(&system, by_dixon),
                all(&system, homotopy::candidates(&system, seed)),
            ] {
                assert_eq!(found.len(), count, "{unknowns} {seed}");
                let known = found.iter().any(|one| distance(one, &solution) < 1e-9);
                assert!(known, "{unknowns} {seed}");
            }
        }
    }
}

/// The general number of solutions for four unknowns is not known: two hidden directions with the same solutions are
/// enough, and the estimate of the work counts both.
#[test]
fn two_directions_are_enough() {
    for (unknowns, directions) in [(1, 2), (2, 1), (3, 1), (4, 2)] {
        let (system, _) = Dice(unknowns as u64).system(unknowns);
        let mut found = Vec::new();
        let tried = system.add_by_dixon(&mut found);
        assert!(tried <= directions, "{unknowns}: {tried}");
    }
    let (four, _) = Dice(7).system(4);
    assert_eq!(four.work(super::Method::Usual), 2 * (70_usize.pow(3) / 20));
}
