use super::bilinear::{Affine, C, Pair, System};
use super::{apart, dixon, homotopy};

/// A generator of Knuth's with a fixed beginning.
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

    /// Directions that all have length 1 at a place of its own, and the place with its conjugates.
    fn system(&mut self, unknowns: usize) -> (System, Vec<C>) {
        let place: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
        let pairs = (0..2 * unknowns).map(|_| {
            let by: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
            let direction = C::from_polar(1.0, 3.0 * self.next());
            let sum: C = by.iter().zip(&place).map(|(by, z)| by * z).sum();
            let constant = direction - sum;
            Pair::Unit([
                Affine { constant, by },
                Affine::constant(C::default(), unknowns),
            ])
        });
        let pairs = pairs.collect();
        let conjugates = place.iter().map(|z| z.conj());
        let both = place.iter().copied().chain(conjugates).collect();
        (System::new(unknowns, pairs, Vec::new()).unwrap(), both)
    }
}

fn all(system: &System, candidates: Vec<Vec<C>>) -> Vec<Vec<C>> {
    let mut found = Vec::new();
    system.add(candidates, &mut found);
    found
}

/// Of directions without any relation between them there are as many solutions as there can be, C(2m, m).
#[test]
fn every_solution_of_general_directions() {
    for (unknowns, count) in [(1, 2), (2, 6), (3, 20), (4, 70)] {
        let seeds = if unknowns < 4 { 40 } else { 2 };
        for seed in 0..seeds {
            let (system, place) = Dice(seed).system(unknowns);
            let by_loops = dixon::candidates(&system, seed as usize).unwrap();
            for found in [
                all(&system, by_loops),
                all(&system, homotopy::candidates(&system, seed)),
            ] {
                assert_eq!(found.len(), count, "{unknowns} {seed}");
                let known = found.iter().any(|one| apart(one, &place) < 1e-9);
                assert!(known, "{unknowns} {seed}");
            }
        }
    }
}

/// Of four unknowns the number of solutions in general is not known: two hidden directions that tell the same are enough,
/// and the work that is reckoned with is theirs.
#[test]
fn two_directions_are_enough() {
    for (unknowns, directions) in [(1, 2), (2, 1), (3, 1), (4, 2)] {
        let (system, _) = Dice(unknowns as u64).system(unknowns);
        let mut found = Vec::new();
        let tried = system.directions_tried(&mut found);
        assert!(tried <= directions, "{unknowns}: {tried}");
    }
    let (four, _) = Dice(7).system(4);
    assert_eq!(four.work(super::Method::Usual), 2 * (70_usize.pow(3) / 20));
}
