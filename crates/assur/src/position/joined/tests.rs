use super::bilinear::{Affine, C, NOUGHT, Pair, System};
use super::{apart, paths, truss};

struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    }

    fn complex(&mut self) -> C {
        C::new(self.next(), self.next())
    }

    /// Directions that have length 1 at a place of its own, so that one solution at least is real.
    fn system(&mut self, unknowns: usize) -> (System, Vec<C>) {
        let place: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
        let pairs = (0..2 * unknowns).map(|_| {
            let by: Vec<C> = (0..unknowns).map(|_| self.complex()).collect();
            let direction = C::from_polar(1.0, 3.0 * self.next());
            let sum: C = by.iter().zip(&place).map(|(by, z)| by * z).sum();
            Pair::Unit(Affine {
                constant: direction - sum,
                by,
            })
        });
        let pairs = pairs.collect();
        (System::new(unknowns, pairs, Vec::new()).unwrap(), place)
    }
}

fn all(system: &System, candidates: Vec<Vec<C>>) -> Vec<Vec<C>> {
    let mut found = Vec::new();
    system.add(candidates, &mut found);
    found
}

#[test]
fn both_methods_find_the_same() {
    for (unknowns, count) in [(1, 2), (2, 6), (3, 20)] {
        let mut short = 0;
        for seed in 0..40 {
            let (system, place) = Dice(seed).system(unknowns);
            let by_determinant = all(&system, truss::candidates(&system, 0).unwrap());
            let by_paths = all(&system, paths::candidates(&system, seed));
            short += usize::from(by_paths.len() < count || by_determinant.len() < count);
            let both: Vec<C> = place
                .iter()
                .copied()
                .chain(place.iter().map(|z| z.conj()))
                .collect();
            println!(
                "{unknowns} {seed}: {} {}",
                by_determinant.len(),
                by_paths.len()
            );
            assert!(
                by_determinant.iter().any(|one| apart(one, &both) < 1e-6),
                "{seed}"
            );
        }
        assert_eq!(short, 0);
        let _ = NOUGHT;
    }
}
