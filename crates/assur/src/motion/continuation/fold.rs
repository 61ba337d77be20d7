//! Where two assemblies of a group meet, and its driver must turn back. The poses of a group with their inputs lie on a
//! curve that goes on smoothly there; only the input does not. Along the curve the fold is where the input stands
//! still: a simple root, as exact as the equations are.
//!
//! The curve is followed by the tangent and Newton's method across it (Keller's pseudo-arclength). Two assemblies may
//! come very close without meeting: a step from one to the other is told by the determinant of the equations with the
//! tangent, which keeps its sign along a curve and has the other one on the next.

use std::cell::RefCell;

use nalgebra::{DMatrix, DVector};

use super::{Continuation, Prediction};
use crate::Jet;
use crate::index::StepId;
use crate::motion::root::root;
use crate::position::{Group, Linearized, Predictor, Step, StepContext};

/// Newton's method takes no more steps, and ends where they are this small or rounding is all that is left.
const MOST_STEPS: usize = 12;
const CONVERGED: f64 = 1e-15;
/// The curve is followed for so many steps, the first this part of what the second derivatives expect; none is tried
/// more often with less.
const MOST_ALONG: usize = 64;
const FIRST: f64 = 0.25;
const MOST_TRIES: usize = 48;
/// Rounding leaves a place uncertain by no more than this part of a step.
const RESOLVED: f64 = 0.02;
/// The tangent turns by no more in a step, as the cosine, and by so little where the next may be longer.
const TURNED: f64 = 0.9;
const STRAIGHT: f64 = 0.99;

/// The poses of a group with their inputs around the one it has come to. Places are the unknowns in their units and,
/// last, the input in its own.
struct Curve<'a> {
    motion: &'a Continuation<'a>,
    group: &'a Group,
    step: StepId,
    state: RefCell<Predictor>,
}

/// A place on the curve.
struct Along {
    at: DVector<f64>,
    /// Of length 1.
    tangent: DVector<f64>,
    /// The sign of the determinant of the equations with the tangent.
    side: f64,
    /// What Newton's method changed last: as far as it is uncertain.
    uncertain: f64,
}

impl Continuation<'_> {
    /// Where ahead, no farther off than a window, the input of a group turns back. None where it does not.
    pub(super) fn fold(&self, step: StepId, sense: f64, window: f64) -> Option<f64> {
        let Step::Group(group) = &self.mechanism.steps()[step] else {
            return None;
        };
        let curve = Curve {
            motion: self,
            group,
            step,
            state: RefCell::new(self.mechanism.blank_state()),
        };
        let [place, rate, bend] = [0, 1, 2].map(|order| group.in_units(&self.here.natural, order));
        // By the input in its unit.
        let [rate, bend] = [rate * curve.unit(), bend * (2.0 * curve.unit().powi(2))];
        let tangent = rate.push(1.0).normalize() * sense;
        let mut here = curve.on(&place.push(self.input / curve.unit()), &tangent, 0.0)?;
        let mut way = FIRST * (1.0 + rate.norm_squared()) / bend.norm();
        if !way.is_finite() {
            return None;
        }
        let mut tries = MOST_TRIES;
        for _ in 0..MOST_ALONG {
            let (next, turned) = loop {
                tries = tries.checked_sub(1)?;
                if let Some(next) = curve.on(&here.at, &here.tangent, way)
                    && next.side == here.side
                    && next.uncertain <= RESOLVED * way
                {
                    let turned = next.tangent.dot(&here.tangent);
                    if turned >= TURNED {
                        break (next, turned);
                    }
                }
                way *= 0.5;
            };
            if curve.rate(&next) * sense <= 0.0 {
                return curve.turning(&here, &next, way);
            }
            // A fold ahead, not one that it comes from: the input gets slower all the way.
            let slower = curve.rate(&next).abs() < curve.rate(&here).abs();
            if !slower || (curve.input(&next) - self.input) * sense > window {
                return None;
            }
            here = next;
            if turned >= STRAIGHT {
                way *= 2.0;
            }
        }
        None
    }
}

impl Curve<'_> {
    /// What inputs are measured by, so that a turn is one of 2π.
    fn unit(&self) -> f64 {
        self.motion.mechanism.span() / std::f64::consts::TAU
    }

    fn input(&self, along: &Along) -> f64 {
        self.unit() * along.at[along.at.len() - 1]
    }

    /// How the input changes along the curve.
    fn rate(&self, along: &Along) -> f64 {
        along.tangent[along.tangent.len() - 1]
    }

    /// Where between two places the input turns back.
    fn turning(&self, here: &Along, next: &Along, way: f64) -> Option<f64> {
        let [first, last] = [here, next].map(|along| self.rate(along));
        // With so little left of its rate the input is that of the fold, to rounding: it is off by half of the rate by
        // the way.
        let nothing = f64::EPSILON * (last - first).abs() / way;
        let between = |way: f64| self.on(&here.at, &here.tangent, way);
        let rate = |way: f64| {
            let rate = self.rate(&between(way)?);
            Some(if rate * rate <= nothing { 0.0 } else { rate })
        };
        let way = root([[0.0, first], [way, last]], rate)?;
        Some(self.input(&between(way)?))
    }

    /// The place on the curve across from a way along a tangent.
    fn on(&self, from: &DVector<f64>, tangent: &DVector<f64>, way: f64) -> Option<Along> {
        let rows = tangent.len();
        let foot = from + tangent * way;
        let mut at = foot.clone();
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let Linearized {
                residual,
                slopes,
                is_redundant,
                residual_is_rounding,
            } = self.linearized(&at)?;
            let mut bordered = slopes.resize_vertically(rows, 0.0);
            bordered.row_mut(rows - 1).tr_copy_from(tangent);
            // What is to be mended, and the new tangent.
            let mut asked = DMatrix::zeros(rows, 2);
            asked.view_mut((0, 0), (rows - 1, 1)).copy_from(&residual);
            asked[(rows - 1, 0)] = tangent.dot(&(&at - &foot));
            asked[(rows - 1, 1)] = 1.0;
            let bordered = bordered.lu();
            let solved = bordered.solve(&asked)?;
            let change = solved.column(0).amax();
            if !change.is_finite() {
                return None;
            }
            at -= solved.column(0);
            if change <= CONVERGED || change >= 0.5 * last && residual_is_rounding {
                let tangent = solved.column(1).normalize();
                // Of redundant equations others may be left out next: their determinant keeps no sign.
                let side = if is_redundant {
                    1.0
                } else {
                    bordered.determinant().signum()
                };
                return Some(Along {
                    at,
                    tangent,
                    side,
                    uncertain: change,
                });
            }
            last = change;
        }
        None
    }

    fn linearized(&self, at: &DVector<f64>) -> Option<Linearized> {
        let Continuation {
            mechanism,
            signs,
            orientations,
            here,
            smooth_roots,
            ..
        } = self.motion;
        let last = at.len() - 1;
        let input = self.unit() * at[last];
        let predicted = Prediction::of(here, orientations, input - self.motion.input);
        let near = predicted.near(smooth_roots);
        let state = &mut *self.state.borrow_mut();
        let before = mechanism.solve_before(self.step, input, signs, near, state);
        before.ok()?;
        let given = StepContext {
            step: self.step,
            input: Jet::linear(input, 1.0),
            sign: signs[self.step],
            near,
        };
        let place = at.rows(0, last).into_owned();
        let mut linearized = self.group.linearized(state, &given, &place).ok()?;
        let mut by_input = linearized.slopes.column_mut(last);
        by_input *= self.unit();
        Some(linearized)
    }
}
