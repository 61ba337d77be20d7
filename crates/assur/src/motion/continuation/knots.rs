//! Knots: the samples kept of a motion. Between knots the initial guess of Newton's method for groups is interpolated.
//! A sample is dropped if the interpolation between its neighbours reproduces it.

use super::hermite::{Taylor, interpolated};
use crate::index::{BodyId, List, StepId};
use crate::mechanism::AssemblySigns;
use crate::position::{Nearby, Orientation, Predictor, Sign, SmoothRoot};
use crate::sorting::sort_by;
use crate::{Cycle, Vector, tolerance};

/// Maximum angle, in radians, through which a body may turn from knot to knot, so that whole turns can be counted.
pub(in crate::motion) const MAX_TURN: f64 = 1.0;
/// Maximum ratio of the lengths of two merged intervals. The interpolation error is greatest near the middle of the
/// merged interval, so the error is tested at a knot near the middle.
const MAX_INTERVAL_RATIO: f64 = 2.5;

/// Samples in ascending order of input; in descending order while a motion is followed backwards.
#[derive(Clone, Debug, Default)]
pub(in crate::motion) struct Knots {
    list: Vec<Knot>,
    /// Index for look-up in constant time: the number of knots before each cell and, as its last element, of all knots.
    /// [`Knots::index`] divides the range into as many equal cells as there are knots.
    counts_before: Vec<usize>,
    /// Cells per unit of input. The cells begin at the input `first`.
    cells_per_unit: f64,
    first: f64,
    /// Square roots of steps near change points, signed so that the roots are smooth there.
    smooth_roots: Vec<SmoothRoot>,
    /// Maximum distance between neighbouring knots of a motion with groups.
    longest: f64,
    /// Minimum and maximum of each step's first margin ([`State::margins`]) over all samples, including dropped ones.
    margins: List<StepId, [f64; 2]>,
}

#[derive(Clone, Debug)]
struct Knot {
    input: f64,
    /// Assembly signs from this knot to the next.
    signs: AssemblySigns,
    /// Upper bound on the rotation of any body since the previous knot.
    turned: f64,
    /// First margin of each step; for a group its determinant, scaled by the same power of two in all knots.
    margins: List<StepId, f64>,
    orientations: List<BodyId, Orientation>,
    /// Unknowns of the groups with their derivatives: x and y of each unknown in turn.
    natural: Vec<Taylor>,
}

impl Knots {
    pub(in crate::motion) fn new(longest: f64) -> Self {
        Self {
            longest,
            ..Self::default()
        }
    }

    /// Appends a pose; `turned` bounds the rotation of any body since the previous pose. Redundant knots are dropped.
    pub(in crate::motion) fn push(
        &mut self,
        input: f64,
        signs: &AssemblySigns,
        (state, orientations): (&Predictor, List<BodyId, Orientation>),
        turned: f64,
    ) {
        let natural = state.natural.iter().flat_map(|place| {
            [0, 1].map(|axis| [0, 1, 2, 3].map(|order: usize| place[order][axis]))
        });
        let margins = state.margins.iter().map(|[margin, _]| margin.value());
        let knot = Knot {
            input,
            signs: signs.clone(),
            turned,
            margins: margins.collect(),
            orientations,
            natural: natural.collect(),
        };
        self.include_margins(knot.margins.iter().map(|margin| [*margin; 2]));
        self.list.push(knot);
        while let [.., a, b, c] = &self.list[..]
            && b.is_redundant_between(a, c, self.longest)
        {
            let turned = b.turned + c.turned;
            self.list.swap_remove(self.list.len() - 2);
            if let Some(last) = self.list.last_mut() {
                last.turned = turned;
            }
        }
    }

    fn include_margins(&mut self, others: impl Iterator<Item = [f64; 2]>) {
        if self.margins.len() == 0 {
            self.margins = others.collect();
            return;
        }
        for ([low, high], other) in self.margins.iter_mut().zip(others) {
            (*low, *high) = (low.min(other[0]), high.max(other[1]));
        }
    }

    /// The single knot of a motion in closed form.
    pub(in crate::motion) fn single(
        input: f64,
        signs: &AssemblySigns,
        orientations: &List<BodyId, Orientation>,
    ) -> Self {
        Self {
            list: vec![Knot {
                input,
                signs: signs.clone(),
                turned: 0.0,
                margins: signs.same_len(1.0),
                orientations: orientations.clone(),
                natural: Vec::new(),
            }],
            margins: signs.same_len([1.0; 2]),
            ..Self::default()
        }
    }

    pub(in crate::motion) fn count(&self) -> usize {
        self.list.len()
    }

    pub(in crate::motion) fn join(&mut self, mut other: Self) {
        self.include_margins(other.margins.iter().copied());
        self.list.append(&mut other.list);
        sort_by(&mut self.list, |a, b| a.input.total_cmp(&b.input));
        self.smooth_roots.append(&mut other.smooth_roots);
        self.index();
    }

    /// Minimum and maximum of the first margin of a step over the motion; for a group, of its determinant.
    pub(in crate::motion) fn margin_range(&self, step: StepId) -> [f64; 2] {
        self.margins[step]
    }

    /// Scales the determinants of a group by `factor`, a power of two.
    pub(in crate::motion) fn scale_margins(&mut self, step: StepId, factor: f64) {
        for knot in &mut self.list {
            knot.margins[step] *= factor;
        }
        self.margins[step] = self.margins[step].map(|margin| margin * factor);
    }

    /// Prepends a motion followed backwards from the same knot.
    pub(in crate::motion) fn prepend(&mut self, mut back: Self) {
        back.list.reverse();
        back.list.pop();
        back.list.append(&mut self.list);
        self.list = back.list;
        self.include_margins(back.margins.iter().copied());
    }

    pub(in crate::motion) fn shift(&mut self, by: f64) {
        for knot in &mut self.list {
            knot.input += by;
        }
        for smooth in &mut self.smooth_roots {
            *smooth = smooth.shifted(by);
        }
    }

    pub(in crate::motion) fn sign(&self, step: StepId, input: f64) -> Sign {
        self.list[self.index_at(input)].signs[step]
    }

    /// True if the outer hinges of a dyad coincide at a change point.
    pub(in crate::motion) fn has_coincident_hinges(&self) -> bool {
        self.smooth_roots.iter().any(SmoothRoot::has_base)
    }

    /// Adds the smooth root of a change point. In a full cycle, also adds its copies one period away that cover an end
    /// of the cycle.
    pub(in crate::motion) fn add_smooth_root(&mut self, smooth: SmoothRoot, cycle: &Cycle) {
        if let Some(period) = cycle.period().filter(|_| cycle.is_full()) {
            let images = [-period, period].map(|by| smooth.shifted(by)).into_iter();
            let covers_end =
                |image: &SmoothRoot| [0.0, period].iter().any(|end| image.covers(*end));
            self.smooth_roots.extend(images.filter(covers_end));
        }
        self.smooth_roots.push(smooth);
    }

    /// Shifts the knots of a full cycle to inputs from 0 to `period`, with one more knot on either side. Angles stay
    /// continuous.
    pub(in crate::motion) fn begin_at_zero(&mut self, period: f64) {
        // The last knot repeats the first one, a period later.
        let (Some(last), Some(first)) = (self.list.pop(), self.list.first()) else {
            return;
        };
        // Change of each angle over the period, rounded to whole turns: near a singular pose the two knots differ in
        // the last digits. A wheel that moves nothing else may have gained a fraction of a turn; its angle is computed
        // from the wheel that drives it.
        let pairs = last.orientations.iter().zip(first.orientations.iter());
        let gains = pairs.map(|(b, a)| crate::angle::whole_turns(b.angle - a.angle));
        let gains: Vec<f64> = gains.collect();
        let delay = |knot: &mut Knot, periods: f64| {
            knot.input += period * periods;
            for (orientation, gain) in knot.orientations.iter_mut().zip(&gains) {
                orientation.angle += gain * periods;
            }
        };
        for knot in &mut self.list {
            let periods = (knot.input / period).floor();
            delay(knot, -periods);
        }
        sort_by(&mut self.list, |a, b| a.input.total_cmp(&b.input));
        if let [first, .., last] = &self.list[..] {
            let [mut before, mut after] = [last.clone(), first.clone()];
            delay(&mut before, -1.0);
            delay(&mut after, 1.0);
            self.list.insert(0, before);
            self.list.push(after);
        }
    }

    /// Returns the assembly signs at an input, and a nearby pose to solve from. Writes a guess for the unknowns of the
    /// groups into `guess`.
    pub(in crate::motion) fn near<'a>(
        &'a self,
        input: f64,
        guess: &'a mut Vec<f64>,
    ) -> (&'a AssemblySigns, Nearby<'a>) {
        let at = self.index_at(input);
        let knot = &self.list[at];
        guess.clear();
        match self.list.get(at + 1) {
            Some(next) => guess.extend(knot.interpolated(next, input)),
            _ => guess.extend(knot.natural.iter().map(|[value, ..]| value)),
        }
        let near = Nearby {
            orientations: &knot.orientations,
            natural: guess,
            smooth_roots: &self.smooth_roots,
        };
        (&knot.signs, near)
    }

    /// Builds the index for look-up. Afterwards no knot may be moved or added.
    pub(in crate::motion) fn index(&mut self) {
        if let [first, .., last] = &self.list[..] {
            self.first = first.input;
            self.cells_per_unit = self.list.len() as f64 / (last.input - first.input);
        }
        let mut counts = vec![0; self.list.len() + 1];
        for knot in &self.list {
            counts[self.cell(knot.input) + 1] += 1;
        }
        let mut sum = 0;
        for count in &mut counts {
            sum += *count;
            *count = sum;
        }
        self.counts_before = counts;
    }

    /// Cell of an input; a greater input never has a lower cell.
    fn cell(&self, input: f64) -> usize {
        let last = self.list.len().saturating_sub(1);
        (((input - self.first) * self.cells_per_unit) as usize).min(last)
    }

    /// Index of the last knot at or before an input, or of the first knot.
    fn index_at(&self, input: f64) -> usize {
        let cell = self.cell(input);
        let [from, to] = match self.counts_before.get(cell..cell + 2) {
            Some(&[from, to]) => [from, to],
            _ => [0, self.list.len()],
        };
        let after = self.list[from..to].partition_point(|knot| knot.input <= input);
        (from + after).saturating_sub(1)
    }
}

impl Knot {
    /// True if interpolation between two neighbours gives half of this knot's digits; one Newton step gives the rest.
    fn is_redundant_between(&self, before: &Self, after: &Self, longest: f64) -> bool {
        let widths = [before, after].map(|knot| (knot.input - self.input).abs());
        let even = widths[0] <= MAX_INTERVAL_RATIO * widths[1]
            && widths[1] <= MAX_INTERVAL_RATIO * widths[0];
        let turns_little = self.turned + after.turned <= MAX_TURN;
        let same_signs = [before, after].iter().all(|knot| knot.signs == self.signs);
        // Over an interval longer than a step of a group, continuation gives a better guess than interpolation.
        let is_short = widths[0] + widths[1] <= longest;
        let reproduced = || {
            let mut guesses = before.interpolated(after, self.input);
            self.places().enumerate().all(|(k, place)| {
                let guess = [guesses.next(), guesses.next()].map(|x| x.unwrap_or(f64::NAN));
                let moved = after.place(k) - before.place(k);
                let tolerance = (tolerance::DOUBLE_ROOT * moved.norm())
                    .max(tolerance::CONVERGED * place.norm());
                (Vector::from(guess) - place).norm() <= tolerance
            })
        };
        even && turns_little && same_signs && (self.natural.is_empty() || is_short && reproduced())
    }

    /// The unknowns of groups at an input between this knot and the next.
    fn interpolated<'a>(&'a self, next: &'a Self, input: f64) -> impl Iterator<Item = f64> + 'a {
        interpolated(
            [(self.input, &self.natural), (next.input, &next.natural)],
            input,
        )
    }

    /// Unknowns of the groups at this knot, without derivatives.
    fn places(&self) -> impl Iterator<Item = Vector> {
        (0..self.natural.len() / 2).map(|k| self.place(k))
    }

    fn place(&self, k: usize) -> Vector {
        Vector::new(self.natural[2 * k][0], self.natural[2 * k + 1][0])
    }
}

#[cfg(test)]
mod tests {
    use super::{Knot, Knots};
    use crate::index::List;

    /// The index agrees with a linear search if knots crowd at one end, if inputs are equal, and across a gap.
    #[test]
    fn the_index_finds_knots() {
        let inputs = (0..40).map(|k| 1.0 - 0.5_f64.powi(k));
        let inputs: Vec<f64> = inputs.chain([1.0, 1.0, 3.0, 3.5, 9.0]).collect();
        let knot = |input: &f64| Knot {
            input: *input,
            signs: List::default(),
            turned: 0.0,
            margins: List::default(),
            orientations: List::default(),
            natural: Vec::new(),
        };
        let mut knots = Knots {
            list: inputs.iter().map(knot).collect(),
            ..Knots::default()
        };
        let beside = |input: &f64| [input.next_down(), *input, input.next_up(), input + 0.3];
        let asked: Vec<f64> = inputs.iter().flat_map(beside).collect();
        let found = |knots: &Knots| -> Vec<usize> {
            asked.iter().map(|input| knots.index_at(*input)).collect()
        };
        let expected = asked.iter().map(|input| {
            let not_after = inputs.iter().filter(|knot| **knot <= *input);
            not_after.count().saturating_sub(1)
        });
        let expected: Vec<usize> = expected.collect();
        assert_eq!(found(&knots), expected);
        knots.index();
        assert_eq!(found(&knots), expected);
    }
}
