//! Forces of a linkage at an input.

use assur::forces::{Kinetostatics, Loading, Reactions};
use assur::mechanism::{Mechanism, Pose};
use assur_file::{LinkageDocument, LinkageProblem, Problem};
use serde::Serialize;

use crate::moving::Moving;

/// The loading of a linkage, and the order in which its reactions are found.
pub(crate) struct Forces {
    pub(crate) loading: Loading,
    pub(crate) statics: Kinetostatics,
}

impl Forces {
    pub(crate) fn new(
        document: &LinkageDocument,
        mechanism: &Mechanism,
    ) -> Result<Self, Vec<LinkageProblem>> {
        Ok(Self {
            loading: document.loading(mechanism)?,
            statics: Kinetostatics::new(mechanism),
        })
    }
}

/// Reactions of all pairs at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ForcesHere {
    reactions: Vec<ReactionHere>,
}

/// Reaction of a pair, in newtons and newton metres.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ReactionHere {
    pair: String,
    /// Link on which it acts.
    on: String,
    /// Link that exerts it.
    from: String,
    /// Components of the force and moment; null if statically indeterminate.
    x: Option<f64>,
    y: Option<f64>,
    moment: Option<f64>,
}

impl Moving {
    /// Reactions of all pairs at an input, at ω₁ and ε₁ of the view.
    ///
    /// # Errors
    /// Every defect of the loads; the reason why there is no pose, or no equilibrium in it.
    pub(crate) fn forces_at(&self, input: f64) -> Result<ForcesHere, Vec<Problem>> {
        let units = self.document().force_units();
        let (_, found) = self.balanced(input)?;
        let mechanism = self.mechanism();
        let forces = self.forces().map_err(all)?;
        let reactions = forces.statics.pairs().map(|(id, pair)| {
            let reaction = found.of(id);
            let [x, y] = reaction
                .force
                .map(|part| part.map(|part| part * units.force()));
            let [on, from] = pair.bodies.map(|body| mechanism.body_name(body).to_owned());
            ReactionHere {
                pair: pair.name(mechanism),
                on,
                from,
                x,
                y,
                moment: reaction.moment.map(|moment| moment * units.torque()),
            }
        });
        Ok(ForcesHere {
            reactions: reactions.collect(),
        })
    }

    /// The pose at an input with its reactions, at ω₁ and ε₁ of the view.
    ///
    /// # Errors
    /// Every defect of the loads; the reason why there is no pose, or no equilibrium in it.
    pub(crate) fn balanced(&self, input: f64) -> Result<(Pose<3>, Reactions), Vec<Problem>> {
        let forces = self.forces().map_err(all)?;
        let pose = self.motion().pose(input);
        let pose = pose.map_err(|why| vec![self.problem(&why)])?;
        let found = forces
            .statics
            .reactions(&forces.loading, &pose, input, self.force_rates());
        let found =
            found.map_err(|why| vec![LinkageProblem::unbalanced(why, self.mechanism()).into()])?;
        Ok((pose, found))
    }
}

fn all(problems: &[LinkageProblem]) -> Vec<Problem> {
    problems.iter().cloned().map(Problem::from).collect()
}
