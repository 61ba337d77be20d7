//! The range of the crank angle of a four-bar, and of the input of any linkage.

use crate::sorting::sort_by;
use std::f64::consts::{PI, TAU};

use super::FourBar;

/// The inputs of a motion: one period if the crank turns fully, otherwise the arcs on which the loop closes.
///
/// ```
/// use assur::FourBar;
/// let cycle = FourBar::new([1.0, 4.0, 3.0, 4.0]).unwrap().cycle();
/// assert!(cycle.is_full());
/// assert_eq!(cycle.period(), Some(std::f64::consts::TAU));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cycle {
    /// Period of the input after which the motion repeats, radians. It is a whole number of turns: two, for example, if
    /// a change point connects both assemblies. None for a driven slide, and for an oscillating crank if inputs a turn
    /// apart give different poses.
    period: Option<f64>,
    /// True if the input is the angle of a crank.
    turns: bool,
    full: bool,
    arcs: Vec<[f64; 2]>,
}

impl Cycle {
    /// The cycle of a crank that turns fully; the motion repeats after this number of turns.
    pub(crate) fn turning(turns: usize) -> Self {
        let period = TAU * turns as f64;
        Self {
            period: Some(period),
            turns: true,
            full: true,
            arcs: vec![[0.0, period]],
        }
    }

    /// The cycle of a driver that oscillates between two inputs; `period` is one turn for a crank, none for a slide.
    pub(crate) fn swinging(arc: [f64; 2], period: Option<f64>) -> Self {
        Self {
            period,
            turns: period.is_some(),
            full: false,
            arcs: vec![arc],
        }
    }

    /// The cycle of a crank that oscillates between two inputs, if inputs a turn apart give different poses.
    pub(crate) fn swinging_by_turns(arc: [f64; 2]) -> Self {
        Self {
            turns: true,
            ..Self::swinging(arc, None)
        }
    }

    /// The union of this cycle and another, and the shift by whole turns that brings the other cycle's arcs after the
    /// arcs of this cycle. The shift is zero if there is no period. None if a driver turns fully, periods differ or
    /// arcs overlap.
    pub(crate) fn joined(&self, other: &Self) -> Option<(Self, f64)> {
        let ends = |cycle: &Self| Some([cycle.arcs.first()?[0], cycle.arcs.last()?[1]]);
        let ([from, to], [first, last]) = (ends(self)?, ends(other)?);
        if self.full || other.full || self.period != other.period {
            return None;
        }
        let shift = self
            .period
            .map_or(0.0, |turn| turn * ((to - first) / turn).ceil());
        let after =
            first + shift >= to && self.period.is_none_or(|turn| last + shift <= from + turn);
        let before = self.period.is_none() && last <= from;
        let later = other.arcs.iter().map(|arc| arc.map(|end| end + shift));
        let mut arcs: Vec<[f64; 2]> = self.arcs.iter().copied().chain(later).collect();
        sort_by(&mut arcs, |a, b| a[0].total_cmp(&b[0]));
        let joined = Self {
            arcs,
            ..self.clone()
        };
        (after || before).then_some((joined, shift))
    }

    pub(crate) fn set_arc(&mut self, arc: usize, ends: [f64; 2]) {
        self.arcs[arc] = ends;
    }

    /// True if the crank turns fully.
    pub fn is_full(&self) -> bool {
        self.full
    }

    /// True if the input is the angle of a crank, false if it is the coordinate of a driven slide.
    pub fn turns(&self) -> bool {
        self.turns
    }

    /// Period of the input after which the motion repeats, radians: a whole number of turns. Inputs that differ by
    /// whole periods give the same pose ([`Self::wrap`]). None for a driven slide, and for an oscillating crank if
    /// inputs a turn apart give different poses.
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// The arcs on which the loop closes, in ascending order: first and last input of each, both included.
    pub fn arcs(&self) -> &[[f64; 2]] {
        &self.arcs
    }

    /// The interval of the input to show. For a full cycle it is the period. For an oscillating crank it is one turn
    /// that contains all arcs, from 0 or from −π if possible. For a slide, or for arcs that do not fit into a turn, it
    /// is the range of the arcs.
    pub fn axis(&self) -> [f64; 2] {
        let [from, to] = [self.arcs[0][0], self.arcs[self.arcs.len() - 1][1]];
        match self.period {
            Some(period) if self.full => [0.0, period],
            Some(_) if from >= 0.0 && to <= TAU => [0.0, TAU],
            Some(_) if from >= -PI && to <= PI => [-PI, PI],
            Some(turn) if to - from <= turn => {
                let start = 0.5 * (from + to - turn);
                [start, start + turn]
            }
            _ => [from, to],
        }
    }

    /// The input at which the linkage is drawn: the middle of the first arc, far from its ends.
    pub fn drawn_input(&self) -> f64 {
        0.5 * (self.arcs[0][0] + self.arcs[0][1])
    }

    /// Shifts an input outside the interval [`Self::axis`] by whole periods into the first period of this interval.
    /// Other inputs are returned unchanged, and so are all inputs if there is no period.
    pub fn wrap(&self, crank: f64) -> f64 {
        let [start, end] = self.axis();
        match self.period {
            Some(period) if !(start..=end).contains(&crank) => {
                start + (crank - start).rem_euclid(period)
            }
            _ => crank,
        }
    }

    /// True if the loop closes at `crank`, shifted by [`Self::wrap`].
    pub fn contains(&self, crank: f64) -> bool {
        let crank = self.wrap(crank);
        self.arcs
            .iter()
            .any(|[from, to]| (*from..=*to).contains(&crank))
    }

    /// Moves the crank by `step`. At the end of a full cycle it continues from the start; at the end of an arc it turns
    /// back. Returns the new angle, and −1 after an odd number of reversals, otherwise 1.
    ///
    /// A crank outside all arcs is first moved to the nearest end of an arc.
    pub fn advance(&self, crank: f64, step: f64) -> (f64, f64) {
        if !(crank + step).is_finite() {
            return (self.arcs[0][0], 1.0);
        }
        if self.is_full() {
            return (self.wrap(crank + step), 1.0);
        }
        let crank = self.wrap(crank);
        let [from, to] = self.nearest_arc(crank);
        let width = to - from;
        // The oscillation has the period 2·width: forward in its first half, backward in its second.
        let travelled = (crank.max(from).min(to) - from + step).rem_euclid(2.0 * width);
        if travelled <= width {
            ((from + travelled).min(to), 1.0)
        } else {
            ((to - (travelled - width)).max(from), -1.0)
        }
    }

    fn nearest_arc(&self, crank: f64) -> [f64; 2] {
        let distance = |[from, to]: [f64; 2]| (from - crank).max(crank - to).max(0.0);
        self.arcs
            .iter()
            .copied()
            .reduce(|best, arc| {
                if distance(arc) < distance(best) {
                    arc
                } else {
                    best
                }
            })
            .unwrap_or([0.0, TAU])
    }
}

impl FourBar {
    /// The crank angles of the motion.
    ///
    /// The loop closes if the factors P and Q of the squared area (see the module) are not negative. P ≥ 0 gives a
    /// lower bound of cos²(φ₁/2), and Q ≥ 0 one of sin²(φ₁/2). The ends of the arcs are dead points.
    pub fn cycle(&self) -> Cycle {
        // At the end of an arc P or Q is zero, and tan²(φ₁/2) is minus the ratio of this factor's values at φ₁ = 0 and
        // π. An acos would lose digits near 0 and π.
        let ([p_pi, p_zero], [q_zero, q_pi]) = (self.p_ends(), self.q_ends());
        let high = 2.0 * p_zero.sqrt().atan2((-p_pi).max(0.0).sqrt());
        let low = 2.0 * (-q_zero).max(0.0).sqrt().atan2(q_pi.sqrt());
        let crosses = u8::from(self.changes_at_pi()) + u8::from(self.changes_at_zero());
        let turns = if crosses == 1 { 2 } else { 1 };
        let (turns, arcs) = match (q_zero < 0.0, p_pi < 0.0) {
            (false, false) => (Some(turns), vec![[0.0, TAU * f64::from(turns)]]),
            (false, true) => (None, vec![[-high, high]]),
            (true, false) => (None, vec![[low, TAU - low]]),
            (true, true) => (None, vec![[low, high], [TAU - high, TAU - low]]),
        };
        Cycle {
            period: Some(TAU * f64::from(turns.unwrap_or(1))),
            turns: true,
            full: turns.is_some(),
            arcs,
        }
    }

    /// The dead points: crank angles at the ends of the arcs, where coupler and rocker are in line and the crank must
    /// turn back. Empty if the crank turns fully.
    pub fn dead_points(&self) -> Vec<f64> {
        let cycle = self.cycle();
        if cycle.is_full() {
            Vec::new()
        } else {
            cycle.arcs.into_iter().flatten().collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A crank may oscillate over more than one turn. Angles outside its arc are still shifted by whole turns.
    #[test]
    fn an_arc_longer_than_a_turn() {
        let cycle = Cycle::swinging([2.7, 10.2], Some(TAU));
        assert_eq!(cycle.wrap(3.0), 3.0);
        assert_eq!(cycle.wrap(10.0), 10.0);
        assert!((cycle.wrap(1.9) - (1.9 + TAU)).abs() < 1e-14);
        assert!((cycle.wrap(10.5) - (10.5 - TAU)).abs() < 1e-14);
        assert!((cycle.wrap(-20.0) - (-20.0 + 4.0 * TAU)).abs() < 1e-14);
    }

    /// Crank and frame 4, coupler and rocker 1 and 2: the diagonal BD lies between 1 and 3. In the triangle ABD with
    /// two sides of 4, BD is opposite to φ₁, so cos φ₁ = (32 − BD²)/32. With a coupler and a rocker of 2, BD is at most
    /// 4, and ABD is then equilateral.
    #[test]
    fn ends_of_the_arcs_follow_from_the_law_of_cosines() {
        let [near, far] = [31.0_f64 / 32.0, 23.0 / 32.0].map(f64::acos);
        let sixty = 60_f64.to_radians();
        for (lengths, expected) in [
            (
                [4.0, 1.0, 2.0, 4.0],
                vec![[near, far], [TAU - far, TAU - near]],
            ),
            ([4.0, 2.0, 2.0, 4.0], vec![[-sixty, sixty]]),
        ] {
            let linkage = FourBar::new(lengths).unwrap();
            let cycle = linkage.cycle();
            assert!(!cycle.is_full());
            assert_eq!(cycle.arcs().len(), expected.len(), "{cycle:?}");
            for (arc, expected) in cycle.arcs().iter().zip(&expected) {
                assert!((arc[0] - expected[0]).abs() < 1e-14, "{cycle:?}");
                assert!((arc[1] - expected[1]).abs() < 1e-14, "{cycle:?}");
            }
            assert_eq!(linkage.dead_points(), cycle.arcs().concat());
        }
    }

    /// The driver oscillates between 0 and 1 and starts at 0.75. A step of 0.5 leads to 1 and back to 0.75; a step of
    /// 1.5 leads to 1, back to 0 and on to 0.25.
    #[test]
    fn an_oscillating_driver_turns_back_at_the_ends() {
        let cycle = Cycle::swinging([0.0, 1.0], None);
        for (step, expected) in [
            (0.25, (1.0, 1.0)),
            (0.5, (0.75, -1.0)),
            (1.5, (0.25, 1.0)),
            (-1.0, (0.25, -1.0)),
            (4.0, (0.75, 1.0)),
        ] {
            assert_eq!(cycle.advance(0.75, step), expected, "{step}");
        }
        let full = Cycle::turning(1);
        assert_eq!(full.advance(0.0, 0.5 * TAU), (0.5 * TAU, 1.0));
        assert_eq!(cycle.advance(7.0, 0.0), (1.0, 1.0));
    }

    /// Arcs of a slide join if they do not overlap. Arcs of a crank are shifted by whole turns to follow one another.
    #[test]
    fn arcs_of_two_cycles_join_in_order() {
        let slide = |arc| Cycle::swinging(arc, None);
        let (joined, shift) = slide([0.0, 1.0]).joined(&slide([2.0, 3.0])).unwrap();
        assert_eq!((joined.arcs(), shift), (&[[0.0, 1.0], [2.0, 3.0]][..], 0.0));
        let (joined, _) = slide([2.0, 3.0]).joined(&slide([0.0, 1.0])).unwrap();
        assert_eq!(joined.arcs(), [[0.0, 1.0], [2.0, 3.0]]);
        assert_eq!(slide([0.0, 2.0]).joined(&slide([1.0, 3.0])), None);
        let crank = |arc| Cycle::swinging(arc, Some(TAU));
        let (joined, shift) = crank([1.0, 2.0]).joined(&crank([-1.0, 0.0])).unwrap();
        assert_eq!(
            (joined.arcs(), shift),
            (&[[1.0, 2.0], [TAU - 1.0, TAU]][..], TAU)
        );
        assert_eq!(Cycle::turning(1).joined(&crank([0.0, 1.0])), None);
    }

    #[test]
    fn the_axis_of_a_crank_is_one_turn() {
        for (arc, expected) in [
            ([1.0, 2.0], [0.0, TAU]),
            ([-1.0, 1.0], [-PI, PI]),
            ([4.0, 8.0], [6.0 - PI, 6.0 + PI]),
            ([2.0, 10.0], [2.0, 10.0]),
        ] {
            let axis = Cycle::swinging(arc, Some(TAU)).axis();
            for (found, expected) in axis.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-15, "{arc:?}: {axis:?}");
            }
        }
    }
}
