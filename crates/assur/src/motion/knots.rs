//! Samples of a motion: which way each group is joined, and where what is solved
//! by iteration is about to be.

use crate::Jet;
use crate::position::{Near, State};

/// Samples in ascending inputs (or descending, while a motion is followed back):
/// signs of the steps, angles of the bodies, and the unknowns of groups with two
/// derivatives.
#[derive(Clone, Debug, Default)]
pub(super) struct Knots {
    list: Vec<Knot>,
}

#[derive(Clone, Debug)]
struct Knot {
    input: f64,
    signs: Vec<f64>,
    angles: Vec<f64>,
    natural: [Vec<f64>; 3],
}

impl Knots {
    pub(super) fn push(&mut self, input: f64, signs: &[f64], state: &State<3>) {
        let parts = |order: usize| {
            let places = state.natural.iter();
            places.flat_map(move |place| [place.x.derivative(order), place.y.derivative(order)])
        };
        self.list.push(Knot {
            input,
            signs: signs.to_vec(),
            angles: state.angle.iter().map(Jet::value).collect(),
            natural: [0, 1, 2].map(|order| parts(order).collect()),
        });
    }

    /// Other signs from the last knot on.
    pub(super) fn amend(&mut self, signs: &[f64]) {
        if let Some(last) = self.list.last_mut() {
            last.signs = signs.to_vec();
        }
    }

    /// Puts a motion followed back before this one; both begin at the same knot.
    pub(super) fn prepend(&mut self, mut back: Self) {
        back.list.reverse();
        back.list.pop();
        back.list.append(&mut self.list);
        *self = back;
    }

    pub(super) fn shift(&mut self, by: f64) {
        for knot in &mut self.list {
            knot.input += by;
        }
    }

    /// Moves the knots of a full cycle to inputs from 0 to `period`, with one
    /// before and one after them; angles go on continuously.
    pub(super) fn begin_at_zero(&mut self, period: f64) {
        // The last knot is the first one a period later.
        let (Some(last), Some(first)) = (self.list.pop(), self.list.first()) else {
            return;
        };
        let gained: Vec<f64> = last
            .angles
            .iter()
            .zip(&first.angles)
            .map(|(b, a)| b - a)
            .collect();
        let later = |knot: &Knot, periods: f64| Knot {
            input: knot.input + period * periods,
            angles: knot
                .angles
                .iter()
                .zip(&gained)
                .map(|(a, g)| a + g * periods)
                .collect(),
            ..knot.clone()
        };
        for knot in &mut self.list {
            *knot = later(knot, -(knot.input / period).floor());
        }
        self.list.sort_by(|a, b| a.input.total_cmp(&b.input));
        if let [first, .., last] = &self.list[..] {
            let [before, after] = [later(last, -1.0), later(first, 1.0)];
            self.list.insert(0, before);
            self.list.push(after);
        }
    }

    /// The signs at an input, what is known nearby, and a guess for the unknowns
    /// of groups, put into `guess`.
    pub(super) fn near<'a>(&'a self, input: f64, guess: &'a mut Vec<f64>) -> (&'a [f64], Near<'a>) {
        let after = self.list.partition_point(|knot| knot.input <= input);
        let at = after.saturating_sub(1);
        let knot = &self.list[at];
        match self.list.get(at + 1) {
            Some(next) if !knot.natural[0].is_empty() => between(knot, next, input, guess),
            _ => guess.clone_from(&knot.natural[0]),
        }
        let near = Near {
            angles: &knot.angles,
            natural: guess,
        };
        (&knot.signs, near)
    }
}

/// The quintic that has the values and two derivatives of both knots.
fn between(a: &Knot, b: &Knot, input: f64, guess: &mut Vec<f64>) {
    let width = b.input - a.input;
    let u = ((input - a.input) / width).clamp(0.0, 1.0);
    let (u2, u3) = (u * u, u * u * u);
    let start = [
        1.0 + u3 * (-10.0 + u * (15.0 - 6.0 * u)),
        width * (u + u3 * (-6.0 + u * (8.0 - 3.0 * u))),
        0.5 * width * width * (u2 + u3 * (-3.0 + u * (3.0 - u))),
    ];
    let end = [
        1.0 - start[0],
        width * u3 * (-4.0 + u * (7.0 - 3.0 * u)),
        0.5 * width * width * u3 * (1.0 + u * (u - 2.0)),
    ];
    guess.clear();
    guess.extend((0..a.natural[0].len()).map(|k| {
        let terms = (0..3)
            .map(|order| start[order] * a.natural[order][k] + end[order] * b.natural[order][k]);
        terms.sum::<f64>()
    }));
}
