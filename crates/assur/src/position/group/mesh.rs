//! Wheels in mesh and driven pairs on links of a group: what their equation takes from what is solved, and from the
//! input. The angles of wheels count whole turns.

use std::f64::consts::TAU;

use crate::Jet;
use crate::index::BodyId;
use crate::position::{Cause, DriveLaw, Nearby, Orientation, State};

use super::equation::MOST_FORMS;

/// A mesh of which not all bodies are solved: the sum of their angles, each multiplied by its number, is constant.
/// Of a driven pair the angle between its two bodies, or the way along its line, is what the input makes it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AngleConstraint {
    /// The bodies of the group, in the order in which their turns stand in the equation.
    pub(crate) turning: Vec<BodyId>,
    /// The solved ones with their numbers.
    pub(crate) known: Vec<(BodyId, f64)>,
    pub(crate) constant: f64,
    /// What whole turns of the solved ones, that they are not drawn by, add to it.
    pub(crate) turned: f64,
    pub(crate) drive: Option<Drive>,
}

/// How a pair between links of a group is driven.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drive {
    pub(crate) course: DriveLaw,
    /// Least and greatest coordinate, of a slide.
    pub(crate) range: Option<[f64; 2]>,
}

impl Drive {
    /// The coordinate.
    ///
    /// # Errors
    /// That it is out of its range.
    fn at<const N: usize>(&self, input: Jet<N>) -> Result<Jet<N>, Cause> {
        let coordinate = self.course.at(input);
        let within = |[from, to]: [f64; 2]| (from..=to).contains(&coordinate.value());
        if self.range.is_none_or(within) {
            Ok(coordinate)
        } else {
            Err(Cause::Input)
        }
    }
}

/// What is given of a mesh while its group is solved.
#[derive(Clone, Copy, Debug)]
pub(in crate::position) struct KnownAngle<const N: usize> {
    /// What the solved bodies contribute, less the constant and the driven coordinate; of a driven slide a length.
    pub(in crate::position) angle: Jet<N>,
    /// How the others are turned nearby: their angles are less than half a turn from there.
    pub(in crate::position) near: [Orientation; MOST_FORMS],
}

impl<const N: usize> KnownAngle<N> {
    /// Nothing yet.
    pub(in crate::position) fn nothing() -> Self {
        Self {
            angle: Jet::constant(0.0),
            near: [Orientation::default(); MOST_FORMS],
        }
    }
}

impl AngleConstraint {
    /// # Errors
    /// That a driven coordinate is out of its range.
    pub(in crate::position) fn given<const N: usize>(
        &self,
        state: &State<N>,
        near: Nearby<'_>,
        input: Jet<N>,
    ) -> Result<KnownAngle<N>, Cause> {
        let known = self.known.iter().map(|(body, by)| state.angle(*body) * *by);
        let mut turning = [Orientation::default(); MOST_FORMS];
        for (orientation, body) in turning.iter_mut().zip(&self.turning) {
            *orientation = near.orientations[*body];
        }
        let mut angle = known.fold(Jet::constant(-self.constant - self.turned), |sum, angle| {
            sum + angle
        });
        if let Some(drive) = &self.drive {
            angle = angle - drive.at(input)?;
            // A driven angle is one but for whole turns: the one that is nearby.
            if let [link, base] = self.turning[..] {
                let [link, base] = [link, base].map(|body| near.orientations[body].angle);
                angle = angle + -TAU * ((link - base + angle.value()) / TAU).round();
            }
        }
        Ok(KnownAngle {
            angle,
            near: turning,
        })
    }
}
