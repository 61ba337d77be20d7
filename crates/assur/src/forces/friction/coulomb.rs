//! Coulomb's law in the pairs of a mechanism: the friction of all that slide, together.

use nalgebra::{DMatrix, DVector};

use super::bearing::Bearing;
use super::{Friction, FrictionLaw};
use crate::forces::Reactions;
use crate::forces::applied::{Applied, Source, relative, turning};
use crate::forces::kinetostatics::{Kinetostatics, Unbalanced};
use crate::forces::pair::Kind;
use crate::index::BodyId;
use crate::mechanism::Guide;
use crate::numeric::max_abs;
use crate::position::State;
use crate::{Vector, tolerance};

/// Limit of the steps of Newton's method.
const MAX_STEPS: usize = 60;

/// Change of the friction in one step, relative to the greatest reaction, at which Newton's method has arrived.
const ARRIVED: f64 = 1e-13;

/// Shortest step of the share of the coefficients while friction is followed, relative to the share.
const SHORTEST: f64 = 1e-6;

/// Determinant below which friction grows without bound. Near the share at which it does, the determinant is proportional
/// to the share that is left, and so a few [`SHORTEST`] at the last step.
pub(super) const LOCKING: f64 = 1e-3;

/// Friction of a pair whose bodies move relative to each other.
pub(super) struct Sliding {
    pub(super) of: Friction,
    /// Index of the first component of the pair.
    start: usize,
    /// Bodies of the pair; for a slide the one with the sliding point comes first.
    pub(super) bodies: [BodyId; 2],
    /// Hinge or sliding point, from the origin of the coordinates.
    at: Vector,
    /// Direction of the line; zero for a hinge.
    along: Vector,
    /// Rate of the first body relative to the second, by the input: of rotation, or along the line.
    pub(super) by_input: f64,
    /// The same without a unit: in units of the input, and of the size of the mechanism for a slide.
    pub(super) share: f64,
    /// Sense of the first body's motion relative to the second: 1, −1, or 0 if they do not move relative to each other.
    pub(super) sense: f64,
    /// Side on which a slide bears; None if it follows from the reaction.
    pub(super) bearing: Option<Bearing>,
}

impl Sliding {
    /// Friction of a pair in a pose, without a sense; None if the pair is a mesh.
    pub(super) fn new(forces: &Kinetostatics, of: Friction, state: &State<3>) -> Option<Self> {
        let (start, pair) = forces.held(of.pair);
        let (bodies, at, along, by_input, size) = match pair.kind {
            Kind::Hinge(at, _) => {
                let by_input = relative(state, pair.bodies)[1];
                let at = state.place(at)[0];
                (pair.bodies, at, Vector::zeros(), by_input, 1.0)
            }
            Kind::Slide(guide) => {
                let along = crate::forces::pair::heading(state, &guide);
                let by_input = travel_rate(state, &guide, along);
                let at = state.place(guide.at)[0];
                let bodies = [guide.at.body, guide.on];
                (bodies, at, along, by_input, forces.size())
            }
            Kind::Mesh(_) => return None,
        };
        Some(Self {
            of,
            start,
            bodies,
            at,
            along,
            by_input,
            share: by_input * forces.unit() / size,
            sense: 0.0,
            bearing: None,
        })
    }

    /// Sense of the relative motion while the input increases; zero if the bodies do not move relative to each other.
    pub(super) fn direction(&self) -> f64 {
        if self.share.abs() > tolerance::COINCIDENT {
            self.share.signum()
        } else {
            0.0
        }
    }

    pub(super) fn is_hinge(&self) -> bool {
        matches!(self.of.law, FrictionLaw::Hinge { .. })
    }

    /// True if the components of the pair are statically determinate.
    pub(super) fn is_known(&self, found: &Reactions) -> bool {
        let own = &found.components[self.start..self.start + 2];
        own.iter().all(Option::is_some)
    }

    /// Friction on the first body, and the opposite on the second, for a value of the friction as a force: a couple is
    /// the value times `size`.
    pub(super) fn applied(&self, value: f64, size: f64) -> [Applied; 2] {
        let couple = if self.is_hinge() { value * size } else { 0.0 };
        [0, 1].map(|k| {
            let sign = [1.0, -1.0][k];
            Applied {
                body: self.bodies[k],
                at: self.at,
                force: self.along * (sign * value),
                couple: sign * couple,
                source: Source::Friction(self.of.index),
            }
        })
    }

    /// The friction as a force that the components of the pair cause, with its derivatives by the two components.
    fn friction(&self, [a, b]: [f64; 2], size: f64) -> (f64, [f64; 2]) {
        let sense = -self.sense;
        match self.of.law {
            FrictionLaw::Hinge { circle } => {
                let factor = sense * circle / size;
                let reaction = a.hypot(b);
                let by = if reaction > 0.0 {
                    [a / reaction, b / reaction]
                } else {
                    [0.0; 2]
                };
                (factor * reaction, by.map(|part| factor * part))
            }
            FrictionLaw::Slide { coefficient, .. } => {
                let (factor, arm) = (sense * coefficient, self.arm(size));
                let bearing = self.bearing.unwrap_or(Bearing::of([a, b], arm));
                let (force, by) = bearing.force([a, b], arm);
                (factor * force, by.map(|by| factor * by))
            }
        }
    }

    /// Forces on the ends of the block of a slide together, by a moment of one in units of force; zero for a hinge, and if
    /// the length of the block is not known.
    fn arm(&self, size: f64) -> f64 {
        match self.of.law {
            FrictionLaw::Slide { length, .. } if length > 0.0 => 2.0 * size / length,
            _ => 0.0,
        }
    }
}

/// Derivative, by the input, of the travel of a sliding point along its line.
fn travel_rate(state: &State<3>, guide: &Guide, along: Vector) -> f64 {
    let point = state.place(guide.at);
    let line = &state.bodies[guide.on];
    let arm = point[0] - line.origin[0];
    let carried = line.origin[1] + crate::perpendicular(arm) * turning(state, guide.on)[0];
    along.dot(&(point[1] - carried))
}

/// Coulomb's law for all sliding pairs together. The components of the reactions are those without friction and, in
/// proportion to each friction, those that a friction of size one causes alone.
pub(super) struct Law<'a> {
    pub(super) sliding: &'a [Sliding],
    pub(super) bare: &'a [f64],
    pub(super) responses: &'a [Vec<f64>],
    pub(super) size: f64,
}

impl Law<'_> {
    /// Friction that satisfies the law, with the determinant of the equations for its change.
    ///
    /// # Errors
    /// The mechanism is self-locking, or Newton's method does not find the friction.
    pub(super) fn friction(&self) -> Result<(DVector<f64>, f64), Unbalanced> {
        let none = DVector::zeros(self.sliding.len());
        if none.is_empty() {
            return Ok((none, 1.0));
        }
        match self.settle(1.0, none) {
            Some((friction, determinant)) if determinant > 0.0 => Ok((friction, determinant)),
            _ => self.follow(),
        }
    }

    /// Side on which the block of a slide bears under all friction; None for a hinge.
    pub(super) fn bearing(&self, one: &Sliding, friction: &DVector<f64>) -> Option<Bearing> {
        let components = self.components(one, friction);
        (!one.is_hinge()).then(|| Bearing::of(components, one.arm(self.size)))
    }

    /// Distance, as a force, of a slide from a change of its given bearing; None for a hinge.
    pub(super) fn margin(&self, one: &Sliding, friction: &DVector<f64>) -> Option<f64> {
        let components = self.components(one, friction);
        let bearing = one.bearing?;
        Some(bearing.margin(components, one.arm(self.size)))
    }

    /// Derivative of the friction, from that of the components without friction; None if the equations are singular.
    pub(super) fn slope(&self, friction: &DVector<f64>, bare: &[f64]) -> Option<DVector<f64>> {
        let (mut matrix, mut caused) = (self.identity(), DVector::zeros(self.sliding.len()));
        for (row, one) in self.sliding.iter().enumerate() {
            let (_, by) = self.caused(one, friction);
            self.fill(&mut matrix, row, by);
            caused[row] = by[0] * bare[one.start] + by[1] * bare[one.start + 1];
        }
        matrix.lu().solve(&caused)
    }

    /// The greatest component without friction.
    pub(super) fn greatest(&self) -> f64 {
        max_abs(self.bare.iter().copied())
    }

    fn identity(&self) -> DMatrix<f64> {
        DMatrix::identity(self.sliding.len(), self.sliding.len())
    }

    /// The friction in a pair caused by all friction, with its derivatives by the components of the pair.
    fn caused(&self, one: &Sliding, friction: &DVector<f64>) -> (f64, [f64; 2]) {
        one.friction(self.components(one, friction), self.size)
    }

    /// Components of a pair under all friction.
    fn components(&self, one: &Sliding, friction: &DVector<f64>) -> [f64; 2] {
        let value = |component: usize| {
            let caused = self.responses.iter().zip(friction.iter());
            let caused = caused.map(|(by, size)| by[component] * size);
            self.bare[component] + caused.sum::<f64>()
        };
        [value(one.start), value(one.start + 1)]
    }

    /// Subtracts the derivatives of the friction in a pair by all friction from a row of a matrix.
    fn fill(&self, matrix: &mut DMatrix<f64>, row: usize, by: [f64; 2]) {
        let start = self.sliding[row].start;
        for (column, response) in self.responses.iter().enumerate() {
            matrix[(row, column)] -= by[0] * response[start] + by[1] * response[start + 1];
        }
    }

    /// Friction under a share of all coefficients, by Newton's method from a guess, with the determinant of the equations
    /// for its change; None if it does not arrive.
    fn settle(&self, share: f64, mut friction: DVector<f64>) -> Option<(DVector<f64>, f64)> {
        let greatest = self.greatest();
        for _ in 0..MAX_STEPS {
            let (mut matrix, mut rest) = (self.identity(), friction.clone());
            for (row, one) in self.sliding.iter().enumerate() {
                let (caused, by) = self.caused(one, &friction);
                rest[row] -= share * caused;
                self.fill(&mut matrix, row, by.map(|by| share * by));
            }
            let factors = matrix.lu();
            let step = factors.solve(&rest)?;
            friction -= &step;
            if !friction.iter().all(|value| value.is_finite()) {
                return None;
            }
            if step.amax() <= ARRIVED * greatest.max(friction.amax()) {
                return Some((friction, factors.determinant()));
            }
        }
        None
    }

    /// Friction under the whole coefficients, followed from none while they grow. If the determinant approaches zero on the
    /// way, the friction grows without bound: with greater coefficients nothing balances it.
    ///
    /// # Errors
    /// The mechanism is self-locking, or the friction is lost on the way.
    fn follow(&self) -> Result<(DVector<f64>, f64), Unbalanced> {
        let (mut share, mut step) = (0.0, 0.5);
        let (mut friction, mut determinant) = (DVector::zeros(self.sliding.len()), 1.0);
        while share < 1.0 {
            let next = f64::min(share + step, 1.0);
            match self.settle(next, friction.clone()) {
                Some((found, next_determinant)) if next_determinant > 0.0 => {
                    (friction, determinant, share) = (found, next_determinant, next);
                    step *= 2.0;
                }
                _ if step > SHORTEST * share.max(SHORTEST) => step *= 0.5,
                _ if determinant < LOCKING => return Err(Unbalanced::Locked),
                _ => return Err(Unbalanced::Unsettled),
            }
        }
        Ok((friction, determinant))
    }
}

impl Kinetostatics {
    /// Components of the pairs and drives that balance given forces alone, written into `found`.
    ///
    /// # Errors
    /// The pose is singular.
    pub(super) fn caused(
        &self,
        state: &State<3>,
        applied: impl IntoIterator<Item = Applied>,
        found: &mut Reactions,
    ) -> Result<Vec<f64>, Unbalanced> {
        found.applied.clear();
        found.applied.extend(applied);
        self.solve(state, found)?;
        Ok(found.values.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forces::pair::PairId;
    use crate::index::Id;

    /// A slide with the normal force 10 + r F and the coefficient 0.5, so that F = −0.5 |10 + r F| for the speed 1.
    fn slide(response: f64, coefficient: f64) -> Result<f64, Unbalanced> {
        let law = FrictionLaw::Slide {
            coefficient,
            length: 0.0,
        };
        let bodies = [0, 1].map(BodyId::at);
        let (pair, index) = (PairId(0), 0);
        let sliding = [Sliding {
            of: Friction { pair, index, law },
            start: 0,
            bodies,
            at: Vector::zeros(),
            along: Vector::x(),
            by_input: 1.0,
            share: 1.0,
            sense: 1.0,
            bearing: None,
        }];
        let law = Law {
            sliding: &sliding,
            bare: &[10.0, 0.0],
            responses: &[vec![response, 0.0]],
            size: 1.0,
        };
        law.follow().map(|(friction, _)| friction[0])
    }

    /// With r = 1: F = −5 − F/2, so F = −10/3. With r = −1: F = −5 + F/2, so F = −10.
    #[test]
    fn friction_that_is_followed() {
        for (response, expected) in [(1.0, -10.0 / 3.0), (-1.0, -10.0), (-1.9, -100.0)] {
            let found = slide(response, 0.5).unwrap();
            assert!((found - expected).abs() < 1e-10 * expected.abs(), "{found}");
        }
    }

    /// With r = −2.1 the normal force would grow by more than the friction that it causes.
    #[test]
    fn self_locking_is_not_a_failure_of_the_method() {
        assert_eq!(slide(-2.1, 0.5), Err(Unbalanced::Locked));
        assert_eq!(slide(-2.1, 0.45).map(f64::round), Ok(-82.0));
        assert_eq!(slide(1.0, f64::NAN), Err(Unbalanced::Unsettled));
        assert_eq!(slide(f64::INFINITY, 0.5), Err(Unbalanced::Unsettled));
    }
}
