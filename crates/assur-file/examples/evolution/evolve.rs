//! Differential evolution (R. Storn and K. Price, 1997) for the least greatest distance between a path and the curve of a
//! four-bar, with the usual parameters: the best vector plus a difference (`best/1/bin`), a scale of 0.5 to 1 drawn for
//! each generation, crossover 0.7, fifteen vectors for each unknown. A population that has converged starts anew.

use std::f64::consts::TAU;

use assur::Point;
use assur::synthesis::approximation::{Course, Target};
use assur::synthesis::cognates::CouplerFourBar;
use nalgebra::Complex;

/// Unknowns: two fixed pivots, crank, coupler, rocker (negative in the other assembly), the coupler point along and across
/// the coupler; then start and span of the crank's motion, for an open path.
const UNKNOWNS: usize = 11;
type Unknowns = [f64; UNKNOWNS];

/// Limits of the unknowns, in units of the size of the path, measured from its centre.
const LIMITS: [[f64; 2]; UNKNOWNS] = [
    [-2.5, 2.5],
    [-2.5, 2.5],
    [-2.5, 2.5],
    [-2.5, 2.5],
    [0.01, 1.5],
    [0.05, 4.0],
    [-4.0, 4.0],
    [-3.0, 3.0],
    [-3.0, 3.0],
    [0.0, TAU],
    [0.08 * TAU, TAU],
];
const VECTORS: usize = 15;
const CROSSOVER: f64 = 0.7;
/// Ratio of the worst value of a population to the best below which it has converged.
const CONVERGED: f64 = 1.0 + 1e-4;
/// Number of places of the curve, and the greatest number of points of the path: more of them take time from generations.
const PLACES: usize = 100;
const POINTS: usize = 60;

/// A population.
pub(crate) struct Evolution {
    path: Vec<Complex<f64>>,
    is_closed: bool,
    centre: Point,
    size: f64,
    random: u64,
    vectors: Vec<(Unknowns, f64)>,
    best: (Unknowns, f64),
}

impl Evolution {
    pub(crate) fn new(target: &Target, seed: u64) -> Self {
        let points = target.points();
        let low = points.iter().fold(points[0], |low, point| low.inf(point));
        let high = points.iter().fold(points[0], |high, point| high.sup(point));
        let (centre, size) = (nalgebra::center(&low, &high), target.size());
        let thinned = (0..points.len()).step_by(points.len().div_ceil(POINTS));
        let ends = (target.course() != Course::Closed).then_some(points.len() - 1);
        let path = thinned.chain(ends).map(|k| {
            let point = points[k];
            let off = (point - centre) / size;
            Complex::new(off.x, off.y)
        });
        let mut evolution = Self {
            path: path.collect(),
            is_closed: target.course() == Course::Closed,
            centre,
            size,
            random: seed,
            vectors: Vec::new(),
            best: ([0.0; UNKNOWNS], f64::INFINITY),
        };
        evolution.start();
        evolution
    }

    fn unknowns(&self) -> usize {
        if self.is_closed {
            UNKNOWNS - 2
        } else {
            UNKNOWNS
        }
    }

    /// A number from 0 to 1 (SplitMix64; G. Steele and others, 2014).
    fn random(&mut self) -> f64 {
        self.random = self.random.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.random;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn start(&mut self) {
        self.vectors.clear();
        for _ in 0..VECTORS * self.unknowns() {
            let x = LIMITS.map(|[low, high]| low + (high - low) * self.random());
            let value = self.value(&x, f64::INFINITY);
            self.vectors.push((x, value));
        }
    }

    /// One generation.
    pub(crate) fn generation(&mut self) {
        let (count, unknowns) = (self.vectors.len(), self.unknowns());
        let scale = 0.5 + 0.5 * self.random();
        for k in 0..count {
            let [a, b] = [(); 2].map(|()| (self.random() * count as f64) as usize);
            let first = (self.random() * unknowns as f64) as usize;
            let best = self.least();
            let (mut x, value) = self.vectors[k];
            for j in 0..unknowns {
                if j == first || self.random() < CROSSOVER {
                    x[j] = best.0[j] + scale * (self.vectors[a].0[j] - self.vectors[b].0[j]);
                    let [low, high] = LIMITS[j];
                    if !(low..=high).contains(&x[j]) {
                        x[j] = low + (high - low) * self.random();
                    }
                }
            }
            let then = self.value(&x, value);
            if then <= value {
                self.vectors[k] = (x, then);
            }
        }
        let least = self.least();
        if least.1 < self.best.1 {
            self.best = least;
        }
        let worst = self
            .vectors
            .iter()
            .map(|(_, value)| *value)
            .fold(0.0, f64::max);
        if worst <= CONVERGED * least.1 {
            self.start();
        }
    }

    fn least(&self) -> (Unknowns, f64) {
        let least = self.vectors.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        least.copied().unwrap_or(self.best)
    }

    /// The greatest distance, or infinity as soon as it is known to be above `most`. A linkage whose crank does not turn
    /// fully has a value above 10, by how far it is from Grashof's conditions.
    fn value(&self, x: &Unknowns, most: f64) -> f64 {
        let [a, d] = pivots(x);
        let (crank, coupler, rocker, frame) = (x[4], x[5], x[6].abs(), (d - a).norm());
        let stretched = crank + frame - coupler - rocker;
        let folded = (coupler - rocker).abs() - (frame - crank).abs();
        let off = stretched.max(folded);
        if off > 0.0 {
            return 10.0 + off;
        }
        let (from, span) = if self.is_closed {
            (0.0, TAU)
        } else {
            (x[9], x[10])
        };
        let steps = if self.is_closed { PLACES } else { PLACES - 1 };
        let mut curve: Vec<Complex<f64>> = (0..PLACES)
            .map(|k| joints(x, from + span * k as f64 / steps as f64)[2])
            .collect();
        let mut path = self.path.clone();
        if self.is_closed {
            curve.push(curve[0]);
            path.push(path[0]);
        }
        let mut greatest = 0.0;
        for (places, line) in [(&path, &curve), (&curve, &path)] {
            for place in places {
                let square = line
                    .windows(2)
                    .map(|side| square(*place, [side[0], side[1]]));
                greatest = square.fold(f64::INFINITY, f64::min).max(greatest);
                if greatest > most * most {
                    return f64::INFINITY;
                }
            }
        }
        greatest.sqrt()
    }

    /// The best four-bar so far.
    pub(crate) fn best(&self) -> Option<CouplerFourBar> {
        let x = &self.best.0;
        let place = |z: Complex<f64>| {
            Point::new(
                self.centre.x + self.size * z.re,
                self.centre.y + self.size * z.im,
            )
        };
        let [b, c, p] = joints(x, 0.5 * TAU);
        CouplerFourBar::new(pivots(x).map(place), [b, c].map(place), place(p)).ok()
    }
}

fn pivots(x: &Unknowns) -> [Complex<f64>; 2] {
    [Complex::new(x[0], x[1]), Complex::new(x[2], x[3])]
}

/// Both joints of the coupler and the coupler point at a crank angle, measured from the frame.
fn joints(x: &Unknowns, angle: f64) -> [Complex<f64>; 3] {
    let [a, d] = pivots(x);
    let (coupler, rocker) = (x[5], x[6]);
    let b = a + Complex::from_polar(x[4], angle) * (d - a) / (d - a).norm();
    // The diagonal from the crank to the second pivot: a triangle with coupler and rocker.
    let diagonal = d - b;
    let square = diagonal.norm_sqr();
    let along = 0.5 * (square + coupler * coupler - rocker * rocker) / square;
    let across = (coupler * coupler / square - along * along).max(0.0).sqrt();
    let c = b + diagonal * Complex::new(along, across.copysign(rocker));
    [b, c, b + (c - b) / coupler * Complex::new(x[7], x[8])]
}

/// Square of the distance of a place from a segment.
fn square(place: Complex<f64>, [from, to]: [Complex<f64>; 2]) -> f64 {
    let (off, side) = (place - from, to - from);
    let share = (off.conj() * side).re / side.norm_sqr().max(f64::MIN_POSITIVE);
    (off - side * share.clamp(0.0, 1.0)).norm_sqr()
}
