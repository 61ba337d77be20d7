//! A linkage under load: its masses and loads, with the rate of its input.

use std::cell::OnceCell;

use assur::forces::{Kinetostatics, Loading, PairId, Reactions};
use assur::mechanism::{Mechanism, Pose};
use assur::motion::Sampling;
use assur_draw::{ForceScale, PlanRooms};
use assur_file::{ForceUnits, LinkageDocument, LinkageProblem, Problem};

use crate::moving::Moving;
use crate::reactions::GreatestForces;

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
    pub(crate) greatest: OnceCell<GreatestForces>,
    /// Scale of the arrows over the motion, computed when first drawn.
    pub(crate) scale: OnceCell<ForceScale>,
    /// Room of the force plans over the motion, computed when first drawn.
    pub(crate) rooms: OnceCell<PlanRooms>,
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
            rooms: OnceCell::new(),
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

/// Radius of the friction circle of a pair, and the friction couple on the first of its bodies; none without friction
/// in a hinge.
pub(crate) fn friction_circle(
    loading: &Loading,
    found: &Reactions,
    pair: PairId,
) -> Option<(f64, f64)> {
    let own = loading.friction_circles().filter(|(one, _)| *one == pair);
    let radius: f64 = own.map(|(_, radius)| radius).sum();
    let rubbing = found.friction().iter().filter(|one| one.pair == pair);
    let couple: f64 = rubbing.map(|one| one.value).sum();
    (radius > 0.0).then_some((radius, couple))
}

impl Moving {
    /// Calls a function with each of the sampled poses that has reactions.
    pub(crate) fn each_balanced(
        &self,
        sampling: Sampling,
        mut with: impl FnMut(&Pose<3>, &Reactions),
    ) {
        let mut found = Reactions::default();
        let mut pose = self.mechanism().blank::<3>();
        for at in self.motion().samples(sampling).into_iter().flatten() {
            let placed = self.motion().place(at, &mut pose).is_ok();
            if placed && self.forces().balance(&pose, at, &mut found).is_ok() {
                with(&pose, &found);
            }
        }
    }

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
