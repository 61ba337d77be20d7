//! Comparison of a curve with the wanted path at 24 places, whatever the place, size and direction of the curve.
//!
//! The places of curve and path are complex vectors c and z, both with the mean 0. Of all similarities αc + β the
//! nearest to z leaves the sum of squared distances |z|² − |⟨c, z⟩|²/|c|². The places are at equal intervals along
//! curve and path. Both directions of the curve are tried; if the curve is closed, also every first place.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::curve::{Curve, Swing};
use super::target::{Course, Target, along, closed, lengths};

/// Number of places that are compared.
pub(super) const PLACES: usize = 24;
/// Number of poses of a candidate, between which its places are interpolated.
const POSES: usize = 32;
/// Parts of the motion along a closed curve, as fractions of a turn, that are compared with an open path.
pub(super) const PARTS: [f64; 6] = [0.15, 0.25, 0.4, 0.6, 0.8, 1.0];

/// Part of the motion that a candidate compares with the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Part {
    /// A whole turn of τ.
    Whole,
    /// First value of τ, and span.
    Arc([f64; 2]),
    /// First value of φ, and sense: 1 if the given crank angles are added to this value, −1 if subtracted.
    Timed([f64; 2]),
}

/// A curve, or its mirror image, over a part of its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Candidate {
    pub(super) curve: Curve,
    pub(super) mirrored: bool,
    pub(super) part: Part,
}

/// Correspondence of a candidate's places to those of the path, and the distance that remains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Match {
    /// Sum of squared distances after the nearest similarity, relative to |z|²: 0 … 1.
    pub(super) defect: f64,
    /// Share of the path's length at which the candidate begins.
    pub(super) shift: f64,
    /// True if the places of candidate and path correspond in opposite orders.
    pub(super) reversed: bool,
}

/// Places of the path, prepared for many comparisons.
#[derive(Clone, Debug)]
pub(super) struct Pattern {
    closed: bool,
    /// Real parts of z, scaled to |z| = 1; `im` holds the imaginary parts. Both are stored twice in a row, so that
    /// every shift is a slice.
    re: [f32; 2 * PLACES],
    im: [f32; 2 * PLACES],
    count: usize,
    /// Crank angles of the places.
    angles: Option<Vec<f64>>,
    /// e^(iφ) at equal steps of a turn.
    turn: [Complex<f64>; POSES],
}

impl Pattern {
    pub(super) fn new(target: &Target) -> Self {
        let closed_path = target.course() == Course::Closed;
        let (places, angles) = match &target.angles {
            Some(angles) => {
                let count = angles.len().min(PLACES);
                let chosen = |k: usize| k * (angles.len() - 1) / (count - 1);
                let places = (0..count).map(|k| target.compared[chosen(k)]).collect();
                let angles = (0..count).map(|k| angles[chosen(k)]).collect();
                (places, Some(angles))
            }
            None if closed_path => {
                let mut places = along(&closed(&target.outline), PLACES + 1);
                places.pop();
                (places, None)
            }
            None => (along(&target.outline, PLACES), None),
        };
        let places: Vec<Complex<f64>> = places;
        let count = places.len();
        let mean = places.iter().sum::<Complex<f64>>() / count as f64;
        let square: f64 = places.iter().map(|place| (place - mean).norm_sqr()).sum();
        let scale = 1.0 / square.sqrt();
        let (mut re, mut im) = ([0.0; 2 * PLACES], [0.0; 2 * PLACES]);
        for k in 0..2 * count {
            let place = (places[k % count] - mean) * scale;
            (re[k], im[k]) = (place.re as f32, place.im as f32);
        }
        Self {
            closed: closed_path,
            re,
            im,
            count,
            angles,
            turn: std::array::from_fn(|k| Complex::cis(TAU * k as f64 / POSES as f64)),
        }
    }

    /// True if crank angles are given.
    pub(super) fn timed(&self) -> bool {
        self.angles.is_some()
    }

    /// Finds the correspondence of a candidate to the path with the least distance.
    pub(super) fn compare(&self, candidate: &Candidate) -> Match {
        let mut places = [Complex::new(0.0, 0.0); PLACES];
        match (candidate.part, &self.angles) {
            (Part::Timed([from, sense]), Some(angles)) => {
                for (place, angle) in places.iter_mut().zip(angles) {
                    let pose = candidate.curve.place(from + sense * angle);
                    *place = candidate.curve.point(&pose);
                }
            }
            (Part::Arc([from, span]), _) => self.arc(&candidate.curve, [from, span], &mut places),
            _ => self.whole(&candidate.curve, &mut places),
        }
        self.correlated(&places, candidate.mirrored)
    }

    /// Square root of the least defect of a closed line or its mirror image; for an open path the least over parts of
    /// the line. None if crank angles are given, or if the line has fewer than three points.
    pub(super) fn unlikeness(&self, line: &[Complex<f64>]) -> Option<f64> {
        if self.timed() || line.len() < 3 {
            return None;
        }
        let defect = |line: &[Complex<f64>], count: usize| {
            let mut places = [Complex::new(0.0, 0.0); PLACES];
            for (place, at) in places.iter_mut().zip(along(line, count)) {
                *place = at;
            }
            let of = |mirrored| self.correlated(&places, mirrored).defect;
            of(false).min(of(true))
        };
        let least = if self.closed {
            defect(line, PLACES + 1)
        } else {
            let sides = line.len() - 1;
            let twice: Vec<Complex<f64>> = line.iter().chain(&line[1..]).copied().collect();
            let parts = (0..PLACES).flat_map(|k| PARTS.map(|part| (k, part)));
            let of = |(k, part): (usize, f64)| {
                let from = k * sides / PLACES;
                let count = ((part * sides as f64) as usize).max(1);
                defect(&twice[from..=from + count], PLACES)
            };
            parts.map(of).fold(f64::INFINITY, f64::min)
        };
        least.is_finite().then(|| least.sqrt())
    }

    fn whole(&self, curve: &Curve, places: &mut [Complex<f64>; PLACES]) {
        let mut line = [Complex::new(0.0, 0.0); POSES + 1];
        for (k, point) in line[..POSES].iter_mut().enumerate() {
            let pose = match curve.swing {
                Swing::Full => curve.at_crank(self.turn[k]),
                _ => curve.place(TAU * k as f64 / POSES as f64),
            };
            *point = curve.point(&pose);
        }
        line[POSES] = line[0];
        spread(&line, PLACES, places);
    }

    fn arc(&self, curve: &Curve, [from, span]: [f64; 2], places: &mut [Complex<f64>; PLACES]) {
        let mut line = [Complex::new(0.0, 0.0); POSES];
        let step = span / (POSES - 1) as f64;
        let (mut turn, next) = (Complex::cis(from), Complex::cis(step));
        for (k, point) in line.iter_mut().enumerate() {
            let pose = match curve.swing {
                Swing::Full => curve.at_crank(turn),
                _ => curve.place(from + step * k as f64),
            };
            *point = curve.point(&pose);
            turn *= next;
        }
        spread(&line, PLACES - 1, places);
    }

    /// Correspondence with the least distance for given places of a candidate.
    fn correlated(&self, places: &[Complex<f64>; PLACES], mirrored: bool) -> Match {
        let mean = places[..self.count].iter().sum::<Complex<f64>>() / self.count as f64;
        let sign = if mirrored { -1.0 } else { 1.0 };
        let (mut re, mut im) = ([0.0_f32; PLACES], [0.0_f32; PLACES]);
        let mut square = 0.0;
        for (k, place) in places[..self.count].iter().enumerate() {
            let off = place - mean;
            square += off.norm_sqr();
            (re[k], im[k]) = (off.re as f32, (sign * off.im) as f32);
        }
        let shifts = if self.closed { PLACES } else { 1 };
        let mut best = (-1.0, 0, false);
        let directions = if self.timed() { 1 } else { 2 };
        for reversed in [false, true].into_iter().take(directions) {
            if reversed {
                re[..self.count].reverse();
                im[..self.count].reverse();
            }
            let squares = if shifts == 1 {
                self.product(&re, &im)
            } else {
                self.products(&re, &im)
            };
            for (shift, square) in squares[..shifts].iter().enumerate() {
                if *square > best.0 {
                    best = (*square, shift, reversed);
                }
            }
        }
        let (product, shift, reversed) = best;
        // In reversed order place 23 comes first.
        let shift = if reversed { shift + PLACES - 1 } else { shift };
        let rest = 1.0 - f64::from(product) / square;
        let sound = square > 0.0 && rest.is_finite();
        Match {
            defect: if sound { rest.max(0.0) } else { f64::INFINITY },
            shift: if shifts == 1 {
                0.0
            } else {
                shift as f64 / PLACES as f64
            },
            reversed,
        }
    }

    /// |⟨c, z⟩|² without a shift.
    fn product(&self, re: &[f32; PLACES], im: &[f32; PLACES]) -> [f32; PLACES] {
        let (mut x, mut y) = (0.0, 0.0);
        for k in 0..self.count {
            x += re[k] * self.re[k] + im[k] * self.im[k];
            y += re[k] * self.im[k] - im[k] * self.re[k];
        }
        let mut squares = [0.0; PLACES];
        squares[0] = x * x + y * y;
        squares
    }

    /// |⟨c, z⟩|² for all shifts. The inner loop runs over shifts: their sums are independent and can be vectorized.
    fn products(&self, re: &[f32; PLACES], im: &[f32; PLACES]) -> [f32; PLACES] {
        let (mut x, mut y) = ([0.0_f32; PLACES], [0.0_f32; PLACES]);
        for k in 0..PLACES {
            let (c, s) = (re[k], im[k]);
            let (zr, zi) = (&self.re[k..k + PLACES], &self.im[k..k + PLACES]);
            for shift in 0..PLACES {
                x[shift] += c * zr[shift] + s * zi[shift];
                y[shift] += c * zi[shift] - s * zr[shift];
            }
        }
        std::array::from_fn(|shift| x[shift] * x[shift] + y[shift] * y[shift])
    }
}

/// Places at `parts` equal intervals along a polyline.
fn spread<const N: usize>(
    line: &[Complex<f64>; N],
    parts: usize,
    places: &mut [Complex<f64>; PLACES],
) {
    let mut lengths = [0.0; N];
    for k in 1..N {
        lengths[k] = lengths[k - 1] + (line[k] - line[k - 1]).norm_sqr().sqrt();
    }
    let step = lengths[N - 1] / parts as f64;
    let mut k = 1;
    for (j, place) in places.iter_mut().enumerate() {
        let wanted = step * j as f64;
        while k < N - 1 && lengths[k] < wanted {
            k += 1;
        }
        let side = lengths[k] - lengths[k - 1];
        let share = if side > 0.0 {
            (wanted - lengths[k - 1]) / side
        } else {
            0.0
        };
        *place = line[k - 1] + (line[k] - line[k - 1]) * share.min(1.0);
    }
}

impl Candidate {
    /// Values of τ that correspond to the compared places of the path: at the given crank angles or, without them, at
    /// equal fractions of the lengths of curve and path.
    pub(super) fn parameters(&self, found: &Match, target: &Target) -> Vec<f64> {
        let count = target.compared.len();
        let [from, span] = match self.part {
            Part::Timed([from, sense]) => {
                let angles = target.angles.iter().flatten();
                return angles.map(|angle| from + sense * angle).collect();
            }
            Part::Whole => [0.0, TAU],
            Part::Arc(arc) => arc,
        };
        const STEPS: usize = 96;
        let poses = self.curve.places([from, span], STEPS + 1);
        let line: Vec<Complex<f64>> = poses.iter().map(|pose| self.curve.point(pose)).collect();
        let lengths = lengths(&line);
        let whole = lengths[STEPS];
        let shares = shares(target);
        let tau = |share: f64| {
            let turns = share.floor();
            let rest = if share == 1.0 { 1.0 } else { share - turns };
            let wanted = rest * whole;
            let k = lengths
                .partition_point(|length| *length < wanted)
                .clamp(1, STEPS);
            let side = lengths[k] - lengths[k - 1];
            let part = if side > 0.0 {
                (wanted - lengths[k - 1]) / side
            } else {
                0.0
            };
            let turned = if share == 1.0 { 0.0 } else { turns * TAU };
            from + span * ((k - 1) as f64 + part) / STEPS as f64 + turned
        };
        (0..count)
            .map(|k| {
                let share = shares[k] - found.shift;
                match (self.part, found.reversed) {
                    (Part::Whole, false) => tau(share),
                    (Part::Whole, true) => tau(-share),
                    (_, false) => tau(share.clamp(0.0, 1.0)),
                    (_, true) => tau((1.0 - share).clamp(0.0, 1.0)),
                }
            })
            .collect()
    }
}

/// Length of the path up to each of its compared places, as a fraction of the whole length.
fn shares(target: &Target) -> Vec<f64> {
    let count = target.compared.len();
    match target.course() {
        Course::Closed => (0..count).map(|k| k as f64 / count as f64).collect(),
        Course::Open => (0..count).map(|k| k as f64 / (count - 1) as f64).collect(),
        Course::Points => {
            let lengths = lengths(&target.compared);
            let whole = lengths[count - 1];
            lengths.iter().map(|length| length / whole).collect()
        }
    }
}
