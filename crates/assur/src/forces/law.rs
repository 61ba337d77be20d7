//! The law by which the magnitude of a load follows the input.

use std::f64::consts::TAU;

use crate::tolerance::FARTHEST;

/// Magnitude of a load by the input.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// The same at every input.
    Constant(f64),
    /// Linear between knots, each an input and a value, with increasing inputs. If the input is the angle of a crank,
    /// the table covers at most one turn and repeats each turn, linear also from its last knot to its first. For a
    /// slide the first and last values hold beyond the table.
    Table(Vec<[f64; 2]>),
    /// Sum of harmonics of the input.
    Harmonics(Vec<Harmonic>),
}

/// Harmonic A cos(kφ − α) of the input φ; of order 0 it is the constant A cos α.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Amplitude A.
    pub amplitude: f64,
    /// Order k.
    pub order: f64,
    /// Phase α, radians.
    pub phase: f64,
}

impl Law {
    /// True if all numbers are finite and in range, and a table is ordered and, for a crank, within a turn.
    pub(super) fn is_valid(&self, turns: bool) -> bool {
        let sound = |value: &f64| value.is_finite() && value.abs() <= FARTHEST;
        match self {
            Self::Constant(value) => sound(value),
            Self::Table(knots) => {
                let ordered = knots.windows(2).all(|pair| pair[0][0] < pair[1][0]);
                let ends = knots.first().zip(knots.last());
                let within = ends.is_some_and(|([from, _], [to, _])| !turns || to - from <= TAU);
                ordered && within && knots.iter().flatten().all(sound)
            }
            Self::Harmonics(terms) => terms
                .iter()
                .all(|term| [term.amplitude, term.order, term.phase].iter().all(sound)),
        }
    }

    /// Magnitude at an input; `turns` is true if the input is the angle of a crank.
    pub fn value(&self, input: f64, turns: bool) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Table(knots) => interpolated(knots, input, turns),
            Self::Harmonics(terms) => terms
                .iter()
                .map(|term| term.amplitude * (term.order * input - term.phase).cos())
                .fold(0.0, |sum, term| sum + term),
        }
    }
}

fn interpolated(knots: &[[f64; 2]], input: f64, turns: bool) -> f64 {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
        return 0.0;
    };
    let input = if turns {
        first[0] + (input - first[0]).rem_euclid(TAU)
    } else {
        input
    };
    let between = |[a, from]: [f64; 2], [b, to]: [f64; 2]| {
        if b > a {
            from + (to - from) * ((input - a) / (b - a))
        } else {
            from
        }
    };
    let later = knots.partition_point(|[at, _]| *at <= input);
    match (later.checked_sub(1), knots.get(later)) {
        (Some(before), Some(after)) => between(knots[before], *after),
        (Some(_), None) if turns => between(*last, [first[0] + TAU, first[1]]),
        (Some(_), None) => last[1],
        (None, _) => first[1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_table_repeats_each_turn_of_a_crank() {
        let law = Law::Table(vec![[0.0, 1.0], [PI, 3.0]]);
        for (input, expected) in [(0.0, 1.0), (PI / 2.0, 2.0), (1.5 * PI, 2.0), (-PI, 3.0)] {
            let found = law.value(input, true);
            assert!((found - expected).abs() < 1e-15, "{input}: {found}");
        }
        assert!((law.value(4.5 * TAU, true) - 3.0).abs() < 1e-12);
        assert_eq!([-1.0, 9.0].map(|input| law.value(input, false)), [1.0, 3.0]);
        let whole = Law::Table(vec![[0.0, 1.0], [TAU, 5.0]]);
        assert_eq!(whole.value(0.0, true), 1.0);
    }

    #[test]
    fn harmonics_are_added() {
        let harmonic = |amplitude, order, phase| Harmonic {
            amplitude,
            order,
            phase,
        };
        let law = Law::Harmonics(vec![harmonic(2.0, 0.0, 0.0), harmonic(3.0, 2.0, PI / 2.0)]);
        assert!((law.value(PI / 4.0, true) - 5.0).abs() < 1e-15);
    }

    #[test]
    fn laws_that_are_no_numbers_or_not_in_order() {
        let bad = [
            Law::Constant(f64::NAN),
            Law::Table(vec![]),
            Law::Table(vec![[1.0, 0.0], [1.0, 2.0]]),
            Law::Table(vec![[0.0, 0.0], [7.0, 2.0]]),
            Law::Table(vec![[0.0, f64::INFINITY]]),
        ];
        assert!(bad.iter().all(|law| !law.is_valid(true)));
        assert!(bad[3].is_valid(false));
    }
}
