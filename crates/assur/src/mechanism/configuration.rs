//! The configuration of a linkage: one of its assemblies, in a pose.

use super::*;

/// Assembly sign of each step. A step with only one assembly has the sign plus.
pub(crate) type AssemblySigns = List<StepId, Sign>;

/// All that differs between the assemblies of a layout: the input, the signs of the dyads, the orientations of the
/// bodies, the unknowns of groups solved by Newton's method, and the mounting of the wheels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Configuration {
    pub(super) input: f64,
    pub(super) signs: AssemblySigns,
    pub(super) orientations: List<BodyId, Orientation>,
    pub(super) natural: Vec<f64>,
    pub(super) mounting: Mounting,
}

impl Configuration {
    /// Orientations and unknowns of this configuration, near which a step is solved.
    pub(super) fn near(&self) -> Nearby<'_> {
        Nearby {
            orientations: &self.orientations,
            natural: &self.natural,
            smooth_roots: &[],
        }
    }

    /// Data from which a step is solved at the input of this configuration.
    pub(super) fn context(&self, step: StepId, sign: Sign) -> StepContext<'_, 1> {
        StepContext {
            step,
            input: Jet::constant(self.input),
            sign,
            near: self.near(),
            mounting: &self.mounting,
        }
    }

    /// The configuration with the orientations and unknowns of a state.
    pub(super) fn posed<const N: usize>(self, state: &State<N>) -> Self {
        Self {
            orientations: state.orientations(),
            natural: state.natural_values().collect(),
            ..self
        }
    }
}
