//! The gap that output and input leave for the coupler.

use crate::sorting::sort_by;
use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::{Proportions, Task};

/// Directions of output and input relative to the frame's, e₂/e₀ and e₃/e₀.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    pub(super) output: Complex<f64>,
    pub(super) input: Complex<f64>,
    /// φ₃ − φ₀.
    pub(super) input_angle: f64,
}

/// What a linkage leaves open at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closure {
    /// φ₁ = arg r, the coupler's angle at which the least is left open, in (−π, π] from the
    /// frame's direction, φ₀ added. Where the gap is nothing any angle will do: φ₀.
    pub coupler: f64,
    /// |r| − z₁: excess of the gap over the coupler, in lengths of the frame. Its
    /// square is J.
    pub residual: f64,
}

impl Direction {
    /// r = e₀ − z₂e₂ − z₃e₃, relative to e₀.
    pub(super) fn gap(&self, output: f64, input: f64) -> Complex<f64> {
        Complex::new(1.0, 0.0) - self.output * output - self.input * input
    }

    /// By the sign of this C lies to the left (+) or to the right of the diagonal from B to D:
    /// e₂ × r, in which z₂ cancels.
    pub(super) fn side(&self, input: f64) -> f64 {
        -self.output.im - input * cross(self.output, self.input)
    }
}

impl Task {
    /// The lengths z₃ > 0, ascending, with which coupler and output of these lengths close the loop
    /// in a position: none or one or two, those of the quadratic |p − z₃e₃| = z₁ with p = e₀ − z₂e₂.
    /// They are real where |p × e₃| ≤ z₁, the region of theorems 1 and 2 in the plane of z₁ and z₂.
    /// Empty also where the task has no such position.
    pub fn closing_inputs(&self, position: usize, coupler: f64, output: f64) -> Vec<f64> {
        if position >= self.positions().len() {
            return Vec::new();
        }
        let at = self.direction(position, [0.0; 2]);
        let p = at.gap(output, 0.0);
        let (along, across) = (dot(p, at.input), cross(p, at.input));
        // NaN where the loop cannot be closed: no root of it is positive.
        let root = (coupler * coupler - across * across).sqrt();
        let far = along + root.copysign(along);
        let near = (p.norm() - coupler) * (p.norm() + coupler) / far;
        let mut found = vec![far, near];
        found.retain(|z| *z > 0.0 && z.is_finite());
        sort_by(&mut found, f64::total_cmp);
        found.dedup();
        found
    }
}

impl Closure {
    pub(super) fn new(proportions: Proportions, direction: &Direction, frame: f64) -> Self {
        let gap = direction.gap(proportions.output, proportions.input);
        Self {
            coupler: gap.arg() + frame,
            residual: gap.norm() - proportions.coupler,
        }
    }
}

/// a × b.
pub(super) fn cross(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.im - a.im * b.re
}

/// a · b.
pub(super) fn dot(a: Complex<f64>, b: Complex<f64>) -> f64 {
    a.re * b.re + a.im * b.im
}

/// An angle brought next to another one by whole turns.
pub(super) fn near(angle: f64, to: f64) -> f64 {
    to + (angle - to + PI).rem_euclid(TAU) - PI
}
