//! The layout of a linkage: all that its assemblies have in common.

use super::*;

/// Bodies, pairs, structure and order of solving of a linkage, as they follow from its topology and dimensions.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Origin of the coordinates used while solving.
    pub(super) origin: Vector,
    /// The bodies with their points, the slides and the wheels in mesh.
    pub(super) bodies: Bodies,
    /// Link for which each body is made; None for the frame.
    pub(super) made_for: List<BodyId, LinkOrFrame>,
    pub(super) links: List<LinkId, Part>,
    /// Points, each with its position on a body: first the points of the specification, then its traced points.
    pub(super) points: List<PointId, BodyPoint>,
    /// Number of points of the specification without its traced points.
    pub(super) listed: usize,
    pub(super) doubled: Vec<DoubledLink>,
    /// The structure used for solving, with passive links inside their groups.
    pub(super) structure: Structure,
    /// Pairs of bodies that stay parallel to each other, for groups with redundant constraints.
    pub(super) parallel: Vec<[BodyId; 2]>,
    pub(super) steps: List<StepId, Step>,
    /// The step that places each body; None for the frame.
    pub(super) placed_by: List<BodyId, Option<StepId>>,
    pub(super) passive: Option<PassiveLinks>,
    /// Orientations of the bodies as first drawn. They show how the wheels are mounted.
    pub(super) mounted: List<BodyId, Orientation>,
    pub(super) size: f64,
    /// Range of the first driver if it is a slide.
    pub(super) range: Option<[f64; 2]>,
    /// Number of turns of the crank after which all drivers and visible wheels are in their initial positions again;
    /// [`rate::NEVER`] if a wheel never returns. None for a driven slide, or if a further driver is a slide that does
    /// not return.
    pub(super) period_turns: Option<usize>,
    /// Number of turns of the crank after which the assemblies repeat, without regard to wheels that carry nothing.
    pub(super) turns_of_assemblies: Option<usize>,
    /// Number of complex unknowns of groups solved by Newton's method.
    unknowns: usize,
}

/// A moving link. It has a body of its own, or is fixed to another body.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) body: BodyId,
    /// Offset of the angle of the link from the angle of its body.
    pub(super) angle_offset: f64,
    pub(super) points: Vec<PointId>,
}

/// Passive links of groups with redundant constraints.
#[derive(Debug)]
pub(super) struct PassiveLinks {
    /// The structure with passive links as separate steps.
    pub(super) structure: Structure,
    /// RRR dyads inside the groups, found after the passive links are removed.
    pub(super) dyads: Vec<[Arm; 2]>,
}

impl Layout {
    /// Makes the layout of a specification with a given structure, and a first guess of the configuration from the
    /// drawing. The loops of the guess need not close. If the drawn pose is known, it gives the whole turns of the
    /// angles.
    ///
    /// # Errors
    /// Inadmissible rates of drivers, or a group that no step can solve.
    pub(super) fn new(
        resolved: &Resolved<'_>,
        bodies: Bodies,
        placements: &List<LinkId, Placement>,
        structure: Structure,
        parallel: &[[BodyId; 2]],
        drawn: Option<Drawn<'_>>,
    ) -> Result<(Self, Configuration), Vec<Defect>> {
        let period_turns = rate::period_turns(resolved)?;
        let plan = plan::plan(resolved, &bodies, placements, &structure, parallel, drawn);
        let plan = plan.map_err(|defect| vec![defect])?;
        let points = resolved.places.enumerate().map(|(point, at)| {
            // A point that no link lists stays at its drawn position.
            let still = || BodyPoint {
                body: BodyId::FRAME,
                local: *at,
            };
            bodies.anchor_of(point, |_| true).unwrap_or_else(still)
        });
        let points = points.chain(tracer::anchored(resolved, &bodies, placements));
        let links = placements.iter().zip(resolved.links.iter());
        let links = links.map(|(placement, link)| Part {
            body: placement.body,
            angle_offset: placement.angle_offset,
            points: link.points.clone(),
        });
        let mut placed_by = resolved.bodies.same_len(None);
        for (step, placing) in plan.steps.enumerate() {
            for body in placing.bodies() {
                placed_by[body] = Some(step);
            }
        }
        let configuration = Configuration {
            input: plan.drawn_input,
            signs: plan.steps.same_len(Sign::Plus),
            mounting: Mounting::planned(placed_by.len()),
            orientations: plan.orientations,
            natural: plan.natural,
        };
        let mut layout = Self {
            origin: resolved.origin,
            points: points.collect(),
            listed: resolved.places.len(),
            links: links.collect(),
            made_for: resolved.bodies.clone(),
            structure,
            parallel: parallel.to_vec(),
            steps: plan.steps,
            placed_by,
            passive: None,
            mounted: List::default(),
            doubled: resolved.doubled.clone(),
            size: resolved.spec.size(),
            range: plan.range,
            period_turns,
            turns_of_assemblies: period_turns,
            unknowns: configuration.natural.len() / 2,
            bodies,
        };
        layout.count_turns_of_wheels();
        Ok((layout, configuration))
    }

    /// Span of the input: one turn, or the range of the driven slide.
    pub(super) fn span(&self) -> f64 {
        self.range.map_or(TAU, |[from, to]| to - from)
    }

    pub(super) fn blank_state<const N: usize>(&self) -> State<N> {
        State::new(
            self.placed_by.len(),
            self.steps.len(),
            self.unknowns,
            self.size,
        )
    }

    /// Body of a link: the link's own, or the body to which it is fixed.
    pub(super) fn body_of(&self, link: LinkOrFrame) -> BodyId {
        link.map_or(BodyId::FRAME, |link| self.links[link].body)
    }

    pub(super) fn angle_offset(&self, link: LinkOrFrame) -> f64 {
        link.map_or(0.0, |link| self.links[link].angle_offset)
    }

    pub(super) fn tracers(&self) -> impl Iterator<Item = PointId> + use<> {
        self.points.ids().skip(self.listed)
    }

    /// Moves the points of a specification to their positions in a pose.
    pub(super) fn draw<const N: usize>(&self, spec: &mut LinkageSpec, state: &State<N>) {
        for (drawn, anchor) in spec.points.iter_mut().zip(self.points.iter()) {
            drawn.at = Point::from(state.place(*anchor).value() + self.origin);
        }
    }
}
