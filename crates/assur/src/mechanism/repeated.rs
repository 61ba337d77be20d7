//! Comparison of poses, without regard to wheels that move nothing else.

use crate::index::BodyId;
use crate::mechanism::{Layout, Mechanism, Pose};
use crate::position::{Predictor, State, Step};

impl Mechanism {
    /// True if all links have the same position in two poses. A round wheel that moves nothing else may have turned.
    pub(crate) fn is_same_pose(&self, a: &Predictor, b: &Predictor, within: f64) -> bool {
        let layout = &self.layout;
        let mut bodies = self.bodies();
        bodies.all(|body| {
            let is_round = !layout.shows_its_angle(body);
            layout.is_near(a, b, body, within) || is_round && layout.is_idle_wheel(body)
        })
    }

    /// Distance between two poses: the greatest rotation (radians, if small) or displacement of a body. A displacement
    /// is relative to the linkage's size or, if greater, to the body's distance from the origin. Wheels that move
    /// nothing else do not count.
    pub(crate) fn distance<const N: usize, const M: usize>(&self, a: &Pose<N>, b: &Pose<M>) -> f64 {
        let bodies = self.bodies();
        let bodies = bodies.filter(|body| !self.layout.is_idle_wheel(*body));
        let off = bodies.map(|body| {
            let [turned, moved] = off(&a.state, &b.state, body);
            let out = a.state.bodies[body].origin.value().norm();
            turned.max(moved / out.max(self.size()))
        });
        off.fold(0.0, f64::max)
    }
}

impl Layout {
    /// Body whose position or orientation differs between two poses; None if there is none. A wheel that moves nothing
    /// else may have turned.
    pub(crate) fn moved<const N: usize>(
        &self,
        a: &State<N>,
        b: &State<N>,
        within: f64,
    ) -> Option<BodyId> {
        let mut bodies = self.bodies.ids();
        bodies.find(|body| !self.is_near(a, b, *body, within) && !self.is_idle_wheel(*body))
    }

    fn is_near<const N: usize>(
        &self,
        a: &State<N>,
        b: &State<N>,
        body: BodyId,
        within: f64,
    ) -> bool {
        let [turned, moved] = off(a, b, body);
        turned <= within && moved <= within * self.size
    }

    fn is_idle_wheel(&self, body: BodyId) -> bool {
        let placing = self.placed_by[body].map(|step| &self.steps[step]);
        matches!(placing, Some(Step::Epicyclic(_))) && !self.carries(body)
    }

    /// True if a body has a point away from its hinge, so that its orientation is visible.
    pub(super) fn shows_its_angle(&self, body: BodyId) -> bool {
        let mut tracers = self.points.iter().skip(self.listed);
        self.bodies.of(body).len() > 1 || tracers.any(|tracer| tracer.body == body)
    }

    /// True if a step depends on the position or the angle of a body.
    pub(super) fn carries(&self, body: BodyId) -> bool {
        self.steps.iter().any(|step| step.depends_on(body))
    }
}

/// Rotation (radians if small) and displacement of a body between two poses.
fn off<const N: usize, const M: usize>(a: &State<N>, b: &State<M>, body: BodyId) -> [f64; 2] {
    let turned = a.bodies[body].turn.value() - b.bodies[body].turn.value();
    let moved = a.bodies[body].origin.value() - b.bodies[body].origin.value();
    [turned.norm(), moved.norm()]
}
