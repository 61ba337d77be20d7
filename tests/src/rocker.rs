//! Swing, travel and time ratio of the rocker of a four-bar, from its limit positions, for comparison with motions.

use std::f64::consts::{PI, TAU};

use assur::sorting::extremes;
use assur::{Assembly, FourBar, Swing};

/// What a rocker does in one assembly, in closed form.
pub trait Rocker {
    /// The rocker's swing on each arc of the cycle in this assembly: between limit positions, or the ends of the arc if
    /// the crank does not turn fully.
    fn swings(&self, assembly: Assembly) -> Vec<Swing>;

    /// The rocker's total travel on each arc of the cycle in this assembly: over the whole cycle, or over the arc and
    /// back.
    fn travels(&self, assembly: Assembly) -> Vec<f64>;

    /// The time ratio K ≥ 1 of slow to quick stroke at constant crank speed; none if the crank does not turn fully or
    /// the rocker does not oscillate once per turn.
    fn time_ratio(&self, assembly: Assembly) -> Option<f64>;
}

impl Rocker for FourBar {
    fn swings(&self, assembly: Assembly) -> Vec<Swing> {
        let cycle = self.cycle();
        let rocker = |crank| Some(self.pose::<1>(assembly, crank).ok()?.rocker.value());
        if let (true, [start, end]) = (cycle.is_full(), cycle.axis()) {
            // Any angle except a deltoid's undetermined one.
            let (before, after) = (rocker(start + 1.0), rocker(end + 1.0));
            if before.zip(after).is_some_and(|(a, b)| (b - a).abs() > PI) {
                return vec![Swing::Turns];
            }
        }
        let turnings = turnings(self, assembly);
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

    fn travels(&self, assembly: Assembly) -> Vec<f64> {
        let cycle = self.cycle();
        let rocker = |crank: f64| Some(self.pose::<1>(assembly, crank).ok()?.rocker.value());
        let turnings = turnings(self, assembly);
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

    fn time_ratio(&self, assembly: Assembly) -> Option<f64> {
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

/// Candidates for the rocker's reversals: limit positions, angles with all links in line, dead points.
fn turnings(linkage: &FourBar, assembly: Assembly) -> Vec<f64> {
    let limits = linkage
        .limits(assembly)
        .into_iter()
        .map(|limit| limit.crank);
    let in_line = linkage.change_points().into_iter().map(|point| point.crank);
    limits.chain(in_line).chain(linkage.dead_points()).collect()
}

/// A swing multiplied by a ratio.
pub fn scaled_swing(swing: Swing, ratio: f64) -> Swing {
    match swing {
        Swing::Turns => Swing::Turns,
        Swing::Between { min, max } => Swing::Between {
            min: (min * ratio).min(max * ratio),
            max: (min * ratio).max(max * ratio),
        },
    }
}
