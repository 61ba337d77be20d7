//! A linkage under load: its masses and loads, with the rate of its input.

use std::cell::OnceCell;

use assur::forces::{Kinetostatics, Loading, Reactions};
use assur::mechanism::{Mechanism, Pose};
use assur_draw::ForceScale;
use assur_file::{ForceUnits, LinkageDocument, LinkageProblem, Problem};

use crate::moving::Moving;
use crate::reactions::GreatestHere;

/// The loading of a linkage, and the order in which its reactions are found.
pub(crate) struct Forces {
    pub(crate) mechanism: Mechanism,
    pub(crate) loading: Loading,
    pub(crate) statics: Kinetostatics,
    /// The engine's units in N and N·m.
    pub(crate) units: ForceUnits,
    /// Speed and acceleration of the input: ω₁ and ε₁ of the view, whatever the axes.
    pub(crate) rates: [f64; 2],
    /// The greatest reactions over the motion, computed when first asked for.
    pub(crate) greatest: OnceCell<Vec<GreatestHere>>,
    /// Scale of the arrows over the motion, computed when first drawn.
    pub(crate) scale: OnceCell<ForceScale>,
}

impl Forces {
    /// Masses, gravity and loads of a document, with the rates of its input.
    ///
    /// # Errors
    /// Every problem of gravity, loads, springs, dampers and motor.
    pub(crate) fn new(
        document: &LinkageDocument,
        mechanism: &Mechanism,
        rates: [f64; 2],
    ) -> Result<Self, Vec<Problem>> {
        let loading = document.loading(mechanism).map_err(Problem::all)?;
        let motor = document.motor(mechanism);
        motor.map_err(|problem| vec![problem.into()])?;
        Ok(Self::under(loading, document, mechanism, rates))
    }

    /// Masses of a document without gravity and loads, with the rates of its input.
    pub(crate) fn of_masses(
        document: &LinkageDocument,
        mechanism: &Mechanism,
        rates: [f64; 2],
    ) -> Self {
        Self::under(Loading::of_masses(mechanism), document, mechanism, rates)
    }

    fn under(
        loading: Loading,
        document: &LinkageDocument,
        mechanism: &Mechanism,
        rates: [f64; 2],
    ) -> Self {
        Self {
            loading,
            statics: Kinetostatics::new(mechanism),
            mechanism: mechanism.clone(),
            units: document.force_units(),
            rates,
            greatest: OnceCell::new(),
            scale: OnceCell::new(),
        }
    }

    /// Writes the reactions in a pose at an input into `found`.
    ///
    /// # Errors
    /// The pose is singular.
    pub(crate) fn balance(
        &self,
        pose: &Pose<3>,
        input: f64,
        found: &mut Reactions,
    ) -> Result<(), Problem> {
        let balanced = (self.statics).balance(&self.loading, pose, input, self.rates, found);
        balanced.map_err(|why| LinkageProblem::unbalanced(why, &self.mechanism).into())
    }
}

impl Moving {
    /// The pose at an input with its reactions, at ω₁ and ε₁ of the view.
    ///
    /// # Errors
    /// The reason why there is no pose, or no equilibrium in it.
    pub(crate) fn balanced(&self, input: f64) -> Result<(Pose<3>, Reactions), Vec<Problem>> {
        let pose = self.motion().pose(input);
        let pose = pose.map_err(|why| vec![self.problem(&why)])?;
        let mut found = Reactions::default();
        let balanced = self.forces().balance(&pose, input, &mut found);
        balanced.map_err(|problem| vec![problem])?;
        Ok((pose, found))
    }
}
