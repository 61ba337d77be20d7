//! Samples of a motion, and between them by Hermite interpolation the guess from which groups are solved. Of the
//! samples only those are kept that the interpolation between others does not tell.

use std::f64::consts::TAU;

use crate::Cycle;
use crate::Vector;
use crate::index::{BodyId, List, StepId};
use crate::mechanism::AssemblySigns;
use crate::position::{Nearby, Orientation, Predictor, Sign, SmoothRoot};
use crate::sorting::sort_by;

/// A body turns by less than this from knot to knot, radians, so that its whole turns are counted.
pub(super) const MOST_TURNED: f64 = 1.0;
/// A knot that the interpolation meets within this part of the way between those beside it tells nothing …
const MET: f64 = 1e-8;
/// … or within what rounding leaves of a place.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
/// Of two stretches that become one neither is so many times as long as the other: the error of the interpolation is
/// greatest about the middle, where the knot between them is.
const UNEVEN: f64 = 2.5;

/// Samples in ascending inputs (or descending, while a motion is followed back):
/// which way each group is joined, how the bodies are turned, and the unknowns of
/// groups with three derivatives.
#[derive(Clone, Debug, Default)]
pub(super) struct Knots {
    list: Vec<Knot>,
    /// Of each of as many equal parts of the way as there are knots, how many of them come before it, and of all how
    /// many there are: to find one at once. Made when all are there.
    before: Vec<usize>,
    /// How many parts there are to a unit of the way, and where they begin.
    parts: f64,
    first: f64,
    /// Where links pass through in line.
    smooth_roots: Vec<SmoothRoot>,
    /// The greatest distance of knots between which a guess is interpolated.
    longest: f64,
    /// The least and the greatest first margin of each step over all samples, those not kept among them.
    margins: List<StepId, [f64; 2]>,
}

#[derive(Clone, Debug)]
struct Knot {
    input: f64,
    signs: AssemblySigns,
    /// How far bodies turn at most on the way from the knot before it.
    turned: f64,
    /// The first margin of each step: of a group its determinant, in all knots a multiple of the same power of two.
    margins: List<StepId, f64>,
    orientations: List<BodyId, Orientation>,
    /// Of each coordinate the value and the coefficients of three derivatives.
    natural: Vec<[f64; 4]>,
}

impl Knots {
    pub(super) fn new(longest: f64) -> Self {
        Self {
            longest,
            ..Self::default()
        }
    }

    /// Goes on to a pose, to which bodies turn by no more than `turned`.
    pub(super) fn push(
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
        self.span(knot.margins.iter().map(|margin| [*margin; 2]));
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

    /// With the margins of other samples.
    fn span(&mut self, others: impl Iterator<Item = [f64; 2]>) {
        if self.margins.len() == 0 {
            self.margins = others.collect();
            return;
        }
        for ([low, high], other) in self.margins.iter_mut().zip(others) {
            (*low, *high) = (low.min(other[0]), high.max(other[1]));
        }
    }

    /// The one knot that a motion in closed form needs.
    pub(super) fn alone(
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
            before: Vec::new(),
            parts: 0.0,
            first: 0.0,
            smooth_roots: Vec::new(),
            longest: 0.0,
            margins: signs.same_len([1.0; 2]),
        }
    }

    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    /// With the knots of another motion over other inputs.
    pub(super) fn join(&mut self, mut other: Self) {
        self.span(other.margins.iter().copied());
        self.list.append(&mut other.list);
        sort_by(&mut self.list, |a, b| a.input.total_cmp(&b.input));
        self.smooth_roots.append(&mut other.smooth_roots);
        self.index();
    }

    /// Between which values the determinant of a group of higher class is over the motion.
    pub(super) fn range(&self, step: StepId) -> [f64; 2] {
        self.margins[step]
    }

    /// Tells the determinants of a group as multiples of another power of two.
    pub(super) fn tell_by(&mut self, step: StepId, factor: f64) {
        for knot in &mut self.list {
            knot.margins[step] *= factor;
        }
        self.margins[step] = self.margins[step].map(|margin| margin * factor);
    }

    /// Puts a motion followed back before this one; both begin at the same knot.
    pub(super) fn prepend(&mut self, mut back: Self) {
        back.list.reverse();
        back.list.pop();
        back.list.append(&mut self.list);
        self.list = back.list;
        self.span(back.margins.iter().copied());
    }

    pub(super) fn shift(&mut self, by: f64) {
        for knot in &mut self.list {
            knot.input += by;
        }
        for smooth in &mut self.smooth_roots {
            *smooth = smooth.shifted(by);
        }
    }

    /// Which way a step is joined at an input.
    pub(super) fn sign(&self, step: StepId, input: f64) -> Sign {
        self.list[self.before(input)].signs[step]
    }

    /// Links pass through in line; of a full cycle at its end as well as at its beginning.
    pub(super) fn passes(&mut self, smooth: SmoothRoot, cycle: &Cycle) {
        if let Some(period) = cycle.period().filter(|_| cycle.is_full()) {
            let again = [-period, period].map(|periods| smooth.shifted(periods));
            let told = again
                .into_iter()
                .filter(|again| [0.0, period].iter().any(|end| again.covers(*end)));
            self.smooth_roots.extend(told);
        }
        self.smooth_roots.push(smooth);
    }

    /// Moves the knots of a full cycle to inputs from 0 to `period`, with one
    /// before and one after them; angles go on continuously.
    pub(super) fn begin_at_zero(&mut self, period: f64) {
        // The last knot is the first one a period later.
        let (Some(last), Some(first)) = (self.list.pop(), self.list.first()) else {
            return;
        };
        // Whole turns: where a pose is nearly singular the two are not the same to the last digit. An idle wheel that may
        // stand otherwise is told by what turns it.
        let turned = last.orientations.iter().zip(first.orientations.iter());
        let gained = turned.map(|(b, a)| TAU * ((b.angle - a.angle) / TAU).round());
        let gained: Vec<f64> = gained.collect();
        let delay = |knot: &mut Knot, periods: f64| {
            knot.input += period * periods;
            for (orientation, gain) in knot.orientations.iter_mut().zip(&gained) {
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

    /// The signs at an input, what is known nearby, and a guess for the unknowns
    /// of groups, put into `guess`.
    pub(super) fn near<'a>(
        &'a self,
        input: f64,
        guess: &'a mut Vec<f64>,
    ) -> (&'a AssemblySigns, Nearby<'a>) {
        let at = self.before(input);
        let knot = &self.list[at];
        guess.clear();
        match self.list.get(at + 1) {
            Some(next) if !knot.natural.is_empty() => guess.extend(between(knot, next, input)),
            _ => guess.extend(knot.natural.iter().map(|[value, ..]| value)),
        }
        let near = Nearby {
            orientations: &knot.orientations,
            natural: guess,
            smooth_roots: &self.smooth_roots,
        };
        (&knot.signs, near)
    }

    /// Lets knots be found at once; after it none is moved or put in.
    pub(super) fn index(&mut self) {
        if let [first, .., last] = &self.list[..] {
            self.first = first.input;
            self.parts = self.list.len() as f64 / (last.input - first.input);
        }
        let mut before = vec![0; self.list.len() + 1];
        for knot in &self.list {
            before[self.part(knot.input) + 1] += 1;
        }
        let mut sum = 0;
        for count in &mut before {
            sum += *count;
            *count = sum;
        }
        self.before = before;
    }

    /// The part of the way that an input is in: never a lesser one for a greater input.
    fn part(&self, input: f64) -> usize {
        let parts = self.list.len();
        (((input - self.first) * self.parts) as usize).min(parts.saturating_sub(1))
    }

    /// The last knot that is not after an input, or the first.
    fn before(&self, input: f64) -> usize {
        let part = self.part(input);
        let [from, to] = match self.before.get(part..part + 2) {
            Some(&[from, to]) => [from, to],
            _ => [0, self.list.len()],
        };
        let after = self.list[from..to].partition_point(|knot| knot.input <= input);
        (from + after).saturating_sub(1)
    }
}

impl Knot {
    /// Whether the two knots beside it tell what it tells.
    fn is_redundant_between(&self, before: &Self, after: &Self, longest: f64) -> bool {
        let ways = [before, after].map(|knot| (knot.input - self.input).abs());
        let even = ways[0] <= UNEVEN * ways[1] && ways[1] <= UNEVEN * ways[0];
        let few = self.turned + after.turned <= MOST_TURNED;
        let joined = [before, after].iter().all(|knot| knot.signs == self.signs);
        // Longer than the steps of groups the guess would not be as good as Newton's method makes it.
        let is_short = ways[0] + ways[1] <= longest;
        let meets = || {
            let mut guesses = between(before, after, self.input);
            self.places().enumerate().all(|(k, place)| {
                let guess = [guesses.next(), guesses.next()].map(|x| x.unwrap_or(f64::NAN));
                let way = after.place(k) - before.place(k);
                let met = (MET * way.norm()).max(ROUNDED * place.norm());
                (Vector::from(guess) - place).norm() <= met
            })
        };
        even && few && joined && (self.natural.is_empty() || is_short && meets())
    }

    /// The unknowns of groups, in their places.
    fn places(&self) -> impl Iterator<Item = Vector> {
        (0..self.natural.len() / 2).map(|k| self.place(k))
    }

    fn place(&self, k: usize) -> Vector {
        Vector::new(self.natural[2 * k][0], self.natural[2 * k + 1][0])
    }
}

/// The polynomial of degree 7 that has the values and three derivatives of both
/// knots.
fn between(a: &Knot, b: &Knot, input: f64) -> impl Iterator<Item = f64> {
    let width = b.input - a.input;
    let u = ((input - a.input) / width).clamp(0.0, 1.0);
    let start = weights(u, width);
    let end = weights(1.0 - u, -width);
    a.natural.iter().zip(&b.natural).map(move |(a, b)| {
        let terms = (0..4).map(|order| start[order] * a[order] + end[order] * b[order]);
        terms.sum::<f64>()
    })
}

/// By what the Taylor coefficients of one end count, `u` of the `width` from it:
/// the polynomials that vanish with three derivatives at the other end.
fn weights(u: f64, width: f64) -> [f64; 4] {
    let rest = (1.0 - u).powi(4);
    let way = u * width;
    let sums = [
        1.0 + u * (4.0 + u * (10.0 + u * 20.0)),
        1.0 + u * (4.0 + u * 10.0),
        1.0 + u * 4.0,
        1.0,
    ];
    let powers = [1.0, way, way * way, way * way * way];
    std::array::from_fn(|order| rest * powers[order] * sums[order])
}

#[cfg(test)]
mod tests {
    use super::{Knot, Knots, weights};
    use crate::index::List;

    /// Knots crowded at one end, two at one input among them, and a gap: found as by going through all.
    #[test]
    fn knots_are_found_at_once() {
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
            asked.iter().map(|input| knots.before(*input)).collect()
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

    /// Polynomials of degree 7 come out as they are.
    #[test]
    fn polynomials_are_kept() {
        let (from, to) = (0.4_f64, 0.7_f64);
        for degree in 0..8_i32 {
            let binomial =
                |k: i32| (0..k).fold(1.0, |c, i| c * f64::from(degree - i) / f64::from(i + 1));
            let coefficient = |at: f64, k: i32| binomial(k) * at.powi(degree - k);
            for k in 0..=10 {
                let u = f64::from(k) / 10.0;
                let width = to - from;
                let [start, end] = [weights(u, width), weights(1.0 - u, -width)];
                let value: f64 = (0..4)
                    .map(|k| {
                        let order = k as usize;
                        start[order] * coefficient(from, k) + end[order] * coefficient(to, k)
                    })
                    .sum();
                let expected = (from + u * width).powi(degree);
                assert!((value - expected).abs() < 1e-15, "{degree} {u}: {value}");
            }
        }
    }
}
