//! Limit positions of the rocker, its swing and the time ratio.

use crate::sorting::{extremes, sort_by};
use std::f64::consts::{PI, TAU};

use super::{Assembly, FourBar};

/// A limit position: the rocker is at rest (φ₃′ = 0) with crank and coupler in line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// φ₁ within the cycle's axis.
    pub crank: f64,
    /// φ₃ there.
    pub rocker: f64,
}

/// Motion of the rocker over an arc of the crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Swing {
    /// It turns fully.
    Turns,
    /// It oscillates between two angles.
    Between {
        /// Minimum of φ₃.
        min: f64,
        /// Maximum of φ₃.
        max: f64,
    },
}

impl Swing {
    /// The stroke max − min; none if the rocker turns.
    pub fn stroke(self) -> Option<f64> {
        match self {
            Self::Turns => None,
            Self::Between { min, max } => Some(max - min),
        }
    }

    /// The swing multiplied by a ratio.
    pub fn scaled(self, ratio: f64) -> Self {
        match self {
            Self::Turns => Self::Turns,
            Self::Between { min, max } => Self::Between {
                min: (min * ratio).min(max * ratio),
                max: (min * ratio).max(max * ratio),
            },
        }
    }
}

impl FourBar {
    /// The limit positions of this assembly in order of ascending crank angle, in closed form from the triangles with
    /// sides l₄, l₃ and l₂ ± l₁.
    pub fn limits(&self, assembly: Assembly) -> Vec<Limit> {
        let cycle = self.cycle();
        let [start, end] = cycle.axis();
        let mut cranks = Vec::new();
        for (crank, side) in self.in_line() {
            // If a cycle takes two turns the position belongs to one of them.
            let mut turned = start + (crank - start).rem_euclid(TAU);
            while turned < end {
                let here = cycle.contains(turned) && self.side(assembly, turned) == side;
                if here {
                    cranks.push(turned);
                }
                turned += TAU;
            }
        }
        sort_by(&mut cranks, f64::total_cmp);
        let limit = |crank| {
            let rocker = self.pose::<1>(assembly, crank).ok()?.rocker.value();
            Some(Limit { crank, rocker })
        };
        cranks.into_iter().filter_map(limit).collect()
    }

    /// Crank angles with crank and coupler in line, each with the side of BD on which C lies. If all four links are in
    /// line (a change point) the rocker is not at rest, and no limit is listed.
    fn in_line(&self) -> Vec<(f64, f64)> {
        let [l1, l2, l3, l4] = self.lengths;
        let ([k1, k2, k3], [s1, s2, s3, s4]) = (self.k, self.slack);
        let perimeter = self.perimeter();
        // Triangle A, C, D with sides l₁ ± l₂, l₃ and l₄, extended and folded: squared length of AC, 16 times its
        // squared area.
        let apart = (l4 - l3) * (l4 + l3);
        let outstretched = k2 * perimeter * s3 * s4;
        let folded = k1 * k3 * s1 * s2;
        // Crank angle from the direction of C, and the side of BD with C above.
        let beyond = if l2 > l1 { (PI, 1.0) } else { (0.0, -1.0) };
        let mut found = Vec::new();
        for (reach, area, (turn, side)) in [
            (l1 + l2, outstretched, (0.0, 1.0)),
            (l2 - l1, folded, beyond),
        ] {
            if area > 0.0 {
                let at_a = area.sqrt().atan2(reach * reach + apart);
                found.push((at_a + turn, side));
                found.push((-at_a + turn, -side));
            }
        }
        found
    }

    /// The rocker's swing on each arc of the cycle in this assembly: between limit positions, or the ends of the arc if
    /// the crank does not turn fully.
    pub fn swings(&self, assembly: Assembly) -> Vec<Swing> {
        let cycle = self.cycle();
        let rocker = |crank| Some(self.pose::<1>(assembly, crank).ok()?.rocker.value());
        if let (true, [start, end]) = (cycle.is_full(), cycle.axis()) {
            // Any angle except a deltoid's undetermined one.
            let (before, after) = (rocker(start + 1.0), rocker(end + 1.0));
            if before.zip(after).is_some_and(|(a, b)| (b - a).abs() > PI) {
                return vec![Swing::Turns];
            }
        }
        let turnings = self.turnings(assembly);
        let between = |[from, to]: &[f64; 2]| {
            let of_arc = turnings
                .iter()
                .filter(|crank| (*from..=*to).contains(*crank));
            let angles = of_arc.filter_map(|crank| rocker(*crank));
            let [min, max] = extremes(angles);
            Swing::Between { min, max }
        };
        cycle.arcs().iter().map(between).collect()
    }

    /// The rocker's total travel on each arc of the cycle in this assembly: over the whole cycle, or over the arc and
    /// back.
    pub fn travels(&self, assembly: Assembly) -> Vec<f64> {
        let cycle = self.cycle();
        let rocker = |crank: f64| Some(self.pose::<1>(assembly, crank).ok()?.rocker.value());
        let turnings = self.turnings(assembly);
        let travel = |[from, to]: &[f64; 2]| {
            // A full cycle may begin anywhere except at a deltoid's undetermined angle.
            let (shift, ways) = if cycle.is_full() {
                (1.0, 1.0)
            } else {
                (0.0, 2.0)
            };
            let [start, end] = [from + shift, to + shift];
            let inside = |crank: &f64| {
                let before = cycle.is_full() && *crank < start;
                if before { crank + (to - from) } else { *crank }
            };
            // Between successive reversals the rocker moves in one direction.
            let (mut at, mut last, mut sum) = (start, rocker(start), 0.0);
            while at < end {
                let ahead = turnings.iter().map(inside).filter(|crank| *crank > at);
                at = ahead.fold(end, f64::min);
                let next = rocker(at).or(last);
                sum += next
                    .zip(last)
                    .map_or(0.0, |(next, last)| (next - last).abs());
                last = next;
            }
            ways * sum
        };
        cycle.arcs().iter().map(travel).collect()
    }

    /// Candidates for the rocker's reversals: limit positions, angles with all links in line, dead points.
    fn turnings(&self, assembly: Assembly) -> Vec<f64> {
        let limits = self.limits(assembly).into_iter().map(|limit| limit.crank);
        let in_line = self.change_points().into_iter().map(|point| point.crank);
        limits.chain(in_line).chain(self.dead_points()).collect()
    }

    /// The time ratio K ≥ 1 of slow to quick stroke at constant crank speed; none if the crank does not turn fully or
    /// the rocker does not oscillate once per turn.
    pub fn time_ratio(&self, assembly: Assembly) -> Option<f64> {
        let cycle = self.cycle();
        let [start, end] = cycle.axis();
        match self.limits(assembly)[..] {
            [first, second] if cycle.is_full() && end - start < 1.5 * TAU => {
                let one = second.crank - first.crank;
                let other = end - start - one;
                Some(one.max(other) / one.min(other))
            }
            _ => None,
        }
    }
}
