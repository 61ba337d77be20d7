//! Gear meshes and driven pairs within a group: the terms of their equations that follow from solved bodies and from
//! the input. The angles of wheels include whole turns.

use crate::Jet;
use crate::index::BodyId;
use crate::position::{Cause, DriveLaw, Orientation, State, StepContext};

use super::equation::MAX_FORMS;

/// Linear equation between the angles θᵢ of bodies, some of them unknown. In a gear mesh Σ nᵢ θᵢ is constant, with
/// factors nᵢ. A driven pair prescribes the angle between its two bodies, or the displacement along its line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AngleConstraint {
    /// Bodies of the group with unknown angles, in the order of their turns e^(iθ) in the equation.
    pub(crate) turning: Vec<BodyId>,
    /// Solved bodies, with the factors nᵢ of their angles.
    pub(crate) known: Vec<(BodyId, f64)>,
    pub(crate) constant: f64,
    pub(crate) drive: Option<Drive>,
}

/// The drive of a pair between links of a group.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drive {
    pub(crate) law: DriveLaw,
    /// Minimum and maximum coordinate of a driven slide.
    pub(crate) range: Option<[f64; 2]>,
}

impl Drive {
    /// Driven coordinate at an input.
    ///
    /// # Errors
    /// The coordinate is out of its range.
    fn at<const N: usize>(&self, input: Jet<N>) -> Result<Jet<N>, Cause> {
        let coordinate = self.law.at(input);
        let within = |[from, to]: [f64; 2]| (from..=to).contains(&coordinate.value());
        if self.range.is_none_or(within) {
            Ok(coordinate)
        } else {
            Err(Cause::Input)
        }
    }
}

/// The known part of an angle constraint.
#[derive(Clone, Copy, Debug)]
pub(in crate::position) struct KnownAngle<const N: usize> {
    /// Σ nᵢθᵢ over the solved bodies, less the constant and the driven coordinate; for a driven slide, a length.
    pub(in crate::position) angle: Jet<N>,
    /// Orientations of the unknown bodies in a nearby pose, less than half a turn from those sought.
    pub(in crate::position) near: [Orientation; MAX_FORMS],
}

impl<const N: usize> KnownAngle<N> {
    pub(in crate::position) fn zero() -> Self {
        Self {
            angle: Jet::constant(0.0),
            near: [Orientation::default(); MAX_FORMS],
        }
    }
}

impl AngleConstraint {
    /// Evaluates the known part of the constraint.
    ///
    /// # Errors
    /// A driven coordinate is out of its range.
    pub(in crate::position) fn known_angle<const N: usize>(
        &self,
        state: &State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<KnownAngle<N>, Cause> {
        let &StepContext {
            input,
            near,
            mounting,
            ..
        } = context;
        let turns = self.known.iter();
        let turned: f64 = turns
            .map(|(body, factor)| factor * mounting.turns[*body])
            .sum();
        let known = self
            .known
            .iter()
            .map(|(body, factor)| state.angle(*body) * *factor);
        let mut turning = [Orientation::default(); MAX_FORMS];
        for (orientation, body) in turning.iter_mut().zip(&self.turning) {
            *orientation = near.orientations[*body];
        }
        let mut angle = known.fold(Jet::constant(-self.constant - turned), |sum, angle| {
            sum + angle
        });
        if let Some(drive) = &self.drive {
            angle = angle - drive.at(input)?;
            // A driven angle is known except for whole turns. The value nearest to the angle in the nearby pose is
            // taken.
            if let [link, base] = self.turning[..] {
                let [link, base] = [link, base].map(|body| near.orientations[body].angle);
                angle = angle + -crate::angle::whole_turns(link - base + angle.value());
            }
        }
        Ok(KnownAngle {
            angle,
            near: turning,
        })
    }
}
