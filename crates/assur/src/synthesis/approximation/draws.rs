//! Candidates of the search, from a deterministic sequence that fills the space of the dimensions evenly: the
//! fractional parts of multiples of irrational numbers (R. D. Richtmyer, 1951).

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::compare::{Candidate, Part};
use super::curve::{Curve, Kind, Swing};
use super::target::Course;

/// √2, √3, √5, √7, √11, √13, √17, √19, √23, √29.
const ROOTS: [f64; 10] = [
    std::f64::consts::SQRT_2,
    1.732_050_807_568_877_2,
    2.236_067_977_499_79,
    2.645_751_311_064_590_7,
    3.316_624_790_355_4,
    3.605_551_275_463_989,
    4.123_105_625_617_661,
    4.358_898_943_540_674,
    4.795_831_523_312_719,
    5.385_164_807_134_505,
];

/// Logarithms of the least and the greatest length drawn, relative to the crank.
const LENGTHS: [f64; 2] = [-0.7, 2.2];
/// Greatest distance of a coupler point from the middle of the coupler, relative to the mean of the lengths of coupler
/// and crank.
const ARM: f64 = 2.5;

/// Number of candidates of which one has its coupler point near the joint of coupler and rocker, or near the slider.
/// Its curve is narrow, as few other curves are.
const NARROW: usize = 7;

/// An endless sequence of candidates.
#[derive(Clone, Debug)]
pub(super) struct Draws {
    next: [f64; 10],
    kinds: [bool; 2],
    course: Course,
    timed: bool,
    swinging: bool,
    count: usize,
}

impl Draws {
    /// The sequence for a seed. `kinds` admits four-bars and slider-cranks. `swinging` admits cranks that do not turn
    /// fully, unless crank angles are given (`timed`).
    pub(super) fn new(
        seed: u64,
        kinds: [bool; 2],
        course: Course,
        [timed, swinging]: [bool; 2],
    ) -> Self {
        // Each seed has a first place of its own, from multiples of further irrational numbers.
        let start = (seed % (1 << 20)) as f64;
        Self {
            next: ROOTS.map(|root| (0.5 + start * (root * 7.0).sqrt()).fract()),
            kinds,
            course,
            timed,
            swinging: swinging && !timed,
            count: 0,
        }
    }

    /// The next point of the unit cube.
    fn advance(&mut self) -> [f64; 10] {
        for (next, root) in self.next.iter_mut().zip(ROOTS) {
            *next = (*next + root).fract();
        }
        self.count += 1;
        self.next
    }

    fn kind(&self) -> Kind {
        // Three of four candidates are four-bars, because a four-bar has two dimensions more than a slider-crank.
        let slider = self.kinds[1] && (!self.kinds[0] || self.count.is_multiple_of(4));
        if slider {
            Kind::SliderCrank
        } else {
            Kind::FourBar
        }
    }

    /// The next candidate with a motion.
    pub(super) fn next(&mut self) -> Candidate {
        loop {
            let u = self.advance();
            let kind = self.kind();
            let (unknowns, coupler) = match kind {
                Kind::FourBar => four_bar([u[0], u[1], u[2]]),
                Kind::SliderCrank => slider_crank([u[0], u[1]]),
            };
            let arm = ARM * 0.5 * (1.0 + coupler) / coupler;
            let w = if self.count.is_multiple_of(NARROW) {
                Complex::new(1.0, 0.0) + Complex::from_polar(arm * u[3].powi(3), TAU * u[4])
            } else {
                Complex::new(0.5, 0.0) + Complex::from_polar(arm * u[3], TAU * u[4])
            };
            let Some(curve) = Curve::new(kind, unknowns, w) else {
                continue;
            };
            if let Some(found) = self.moved(curve, &u) {
                return found;
            }
        }
    }

    /// A candidate near another: its unknowns changed by at most `step`, the start of its motion by at most twice as
    /// much.
    pub(super) fn near(&mut self, shape: [f64; 5], of: &Candidate, step: f64) -> Candidate {
        for _ in 0..16 {
            let u = self.advance();
            let moved = |k: usize| step * (2.0 * u[k] - 1.0);
            let [x, y, a, b, c] = shape;
            let w = Complex::new(x + moved(0), y + moved(1));
            let share = if of.curve.kind == Kind::SliderCrank {
                0.0
            } else {
                1.0
            };
            let unknowns = [a + moved(2), b + moved(3), c + share * moved(4)];
            let curve = Curve::new(of.curve.kind, unknowns, w);
            let curve = curve.filter(|curve| self.swinging || curve.swing == Swing::Full);
            if let Some(curve) = curve {
                let mut found = Candidate { curve, ..*of };
                if let Part::Arc([from, span]) = of.part {
                    found.part =
                        Part::Arc([from + 2.0 * moved(5), (span * (1.0 + moved(6))).min(TAU)]);
                }
                if let Part::Timed([from, sense]) = of.part {
                    found.part = Part::Timed([from + 2.0 * moved(5), sense]);
                }
                return found;
            }
        }
        *of
    }

    /// The candidate of a curve; None if its crank swings, but must turn fully.
    fn moved(&self, curve: Curve, u: &[f64; 10]) -> Option<Candidate> {
        if !self.swinging && curve.swing != Swing::Full {
            return None;
        }
        let part = if self.timed {
            Part::Timed([TAU * u[5], if u[6] < 0.5 { 1.0 } else { -1.0 }])
        } else if self.course == Course::Closed {
            Part::Whole
        } else {
            Part::Arc([TAU * u[5], TAU * (0.08 + 0.92 * u[6])])
        };
        let mirrored = u[7] < 0.5;
        Some(Candidate {
            curve,
            mirrored,
            part,
        })
    }
}

/// Logarithms of l₂, l₃ and l₄ from three coordinates in the unit cube, then l₂. If the crank would swing on one side
/// of the frame, it is exchanged with the shortest link, as in one of the cognates.
fn four_bar(u: [f64; 3]) -> ([f64; 3], f64) {
    let [least, greatest] = LENGTHS;
    let [mut x, mut y, mut z] = u.map(|u| least + (greatest - least) * u);
    let sum = |x: f64, y: f64, z: f64| {
        let lengths = [1.0, x.exp(), y.exp(), z.exp()];
        let [shortest, longest] = crate::sorting::extremes(lengths.into_iter());
        lengths.iter().sum::<f64>() - 2.0 * (shortest + longest)
    };
    let shortest = x.min(y).min(z).min(0.0);
    if sum(x, y, z) > 0.0 && shortest < 0.0 && shortest < z {
        // The shortest link becomes the crank, of length 1.
        if shortest == x {
            x = 0.0;
        } else {
            y = 0.0;
        }
        [x, y, z] = [x - shortest, y - shortest, z - shortest];
    }
    ([x, y, z], x.exp())
}

/// Logarithm of the rod, and ratio of the offset to rod less crank; then the rod.
fn slider_crank(u: [f64; 2]) -> ([f64; 3], f64) {
    let rod = 0.02 + 2.2 * u[0];
    ([rod, 2.0 * u[1] - 1.0, 0.0], rod.exp())
}
