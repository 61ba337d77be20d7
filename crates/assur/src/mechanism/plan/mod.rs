//! The plan of a mechanism: the steps that place its bodies, in the order of solving.

pub(in crate::mechanism) mod body;
pub(in crate::mechanism) mod doubled;
pub(in crate::mechanism) mod driver;
mod natural;
pub(in crate::mechanism) mod resolved;
pub(in crate::mechanism) mod slide;
pub(in crate::mechanism) mod structured;
pub(in crate::mechanism) mod train;
mod willis;

use crate::Vector;
use crate::index::{BodyId, Id, LinkId, List, PointId, StepId};
use crate::position::{
    Arm, BodyPoint, CrankFourBar, DriveLaw, Orientation, Prp, Rpp, Rpr, Rrp, Rrr, Step,
};
use crate::structure::{self, Structure};

use crate::linkage::spec::Defect;
use crate::mechanism::plan::body::{Bodies, Placement};
use crate::mechanism::plan::driver::DrivenPair;
use crate::mechanism::plan::resolved::{Driver, Resolved};
use crate::mechanism::plan::slide::Slide;
use crate::mechanism::plan::train::Singular;

pub(in crate::mechanism) struct Plan {
    pub(in crate::mechanism) steps: List<StepId, Step>,
    /// The drawn input: the coordinate of the first driver.
    pub(in crate::mechanism) drawn_input: f64,
    /// The range of the first driver, if it is a slide.
    pub(in crate::mechanism) range: Option<[f64; 2]>,
    /// Drawn values of the unknowns of groups solved by Newton's method.
    pub(in crate::mechanism) natural: Vec<f64>,
    /// Orientations of the bodies in the drawing; for wheels, as mounted.
    pub(in crate::mechanism) orientations: List<BodyId, Orientation>,
}

/// The drawn pose. The angles of its bodies include whole turns.
#[derive(Clone, Copy)]
pub(in crate::mechanism) struct Drawn<'a> {
    pub(in crate::mechanism) input: f64,
    pub(in crate::mechanism) orientations: &'a List<BodyId, Orientation>,
}

/// The bodies of a mechanism during planning. `solved` marks the bodies that the steps planned so far place.
pub(in crate::mechanism) struct Placed<'a> {
    pub(in crate::mechanism) bodies: &'a Bodies,
    pub(in crate::mechanism) placements: &'a List<LinkId, Placement>,
    pub(in crate::mechanism) solved: List<BodyId, bool>,
    pub(in crate::mechanism) orientations: List<BodyId, Orientation>,
    /// Crank that is hinged to the frame and turned by the input.
    crank: Option<BodyId>,
}

/// Plan with the steps in the order of the structure. Pairs of bodies that stay parallel give additional equations for
/// groups with redundant constraints.
///
/// # Errors
/// A group that no step can solve, or a train whose numbers of teeth do not determine its angles.
pub(in crate::mechanism) fn plan(
    spec: &Resolved<'_>,
    bodies: &Bodies,
    placements: &List<LinkId, Placement>,
    structure: &Structure,
    parallel: &[[BodyId; 2]],
    known: Option<Drawn<'_>>,
) -> Result<Plan, Defect> {
    let solved = bodies.ids().map(|body| body == BodyId::FRAME);
    let mut placed = Placed {
        bodies,
        placements,
        solved: solved.collect(),
        orientations: known
            .map_or_else(|| bodies.orientations(), |known| known.orientations.clone()),
        crank: None,
    };
    let first = spec.drivers.first();
    let drawn_input = first.map_or(0.0, |first| placed.drawn_input(spec, first, known));
    let mut plan = Plan {
        steps: Vec::with_capacity(structure.steps.len()).into(),
        drawn_input,
        range: None,
        natural: Vec::new(),
        orientations: List::default(),
    };
    let names = |group: &[BodyId]| -> Vec<String> {
        let names = group.iter().map(|body| spec.body_name(*body));
        names.map(str::to_owned).collect()
    };
    let unsupported = |group: &[BodyId]| Defect::Unsupported {
        links: names(group),
    };
    let of_group = |links: &[usize; 2]| {
        let [base, body] = links.map(|link| structure.step_of[link]);
        base == body
    };
    let mut within = Vec::new();
    for part in &structure.steps {
        let step = match part {
            structure::Step::Driver { driver, links } => {
                let (index, first) = (*driver, *driver == 0);
                let driver = &spec.drivers[index];
                let course = if first {
                    DriveLaw::FIRST
                } else {
                    DriveLaw::through(
                        index,
                        driver.rate(),
                        [drawn_input, placed.drawn(spec, driver)],
                    )
                };
                if let (true, Driver::Slide { range, .. }) = (first, driver) {
                    plan.range = Some(*range);
                }
                // A driver between two bodies of one group is solved with the group.
                if of_group(links) {
                    within.push(DrivenPair::new(&placed, spec, driver, course));
                    continue;
                }
                let [base, body] = links.map(BodyId::at);
                if let (true, Driver::Crank { .. }, BodyId::FRAME) = (first, driver, base) {
                    placed.crank = Some(body);
                }
                let step = placed.driven(spec, driver, [base, body], course);
                step.ok_or_else(|| unsupported(&[body]))?
            }
            structure::Step::Group(group) => {
                let links: Vec<BodyId> = group.links().into_iter().map(BodyId::at).collect();
                let driven = std::mem::take(&mut within);
                if known.is_none() {
                    placed.mount(&links, &driven);
                }
                let closed = if driven.is_empty() && group.surplus == 0 {
                    let train = placed.train(&links);
                    let train = train.map_err(|Singular| Defect::TrainUndetermined {
                        links: names(&links),
                    })?;
                    train.map(Step::from).or_else(|| placed.closed_form(&links))
                } else {
                    None
                };
                match closed {
                    Some(step) => step,
                    None => {
                        let offset = plan.natural.len() / 2;
                        let places = |point| spec.places[point];
                        let group =
                            natural::group(&placed, &links, &driven, parallel, offset, places);
                        let (group, places) = group.ok_or_else(|| unsupported(&links))?;
                        let places = places.iter().flat_map(|place| [place.x, place.y]);
                        plan.natural.extend(places);
                        group.into()
                    }
                }
            }
        };
        for body in step.bodies() {
            placed.solved[body] = true;
        }
        plan.steps.push(step);
    }
    plan.orientations = placed.orientations;
    Ok(plan)
}

/// Hinge between a body to be solved and a body already solved.
pub(in crate::mechanism) struct Hinge {
    joint: PointId,
    at: BodyPoint,
    /// Position of the hinge on the body to be solved.
    local: Vector,
}

/// Outer pair of a dyad.
enum Outer<'a> {
    Hinge(Hinge),
    Slide(&'a Slide),
}

/// Inner pair of a dyad.
enum Inner<'a> {
    /// Hinge, with its position on each of the two links.
    Hinge(PointId, [Vector; 2]),
    Slide(&'a Slide),
}

impl Placed<'_> {
    /// Closed-form step of a dyad joined to solved bodies. None for other groups and if no closed form is known.
    fn closed_form(&self, group: &[BodyId]) -> Option<Step> {
        match *group {
            [i, j] if self.couplings(group).is_empty() => self.dyad([i, j]),
            _ => None,
        }
    }

    /// Position of a point on a solved body that has the point.
    fn anchor(&self, point: PointId) -> Option<BodyPoint> {
        self.bodies.anchor_of(point, |body| self.solved[body])
    }

    fn outer(&self, body: BodyId) -> Option<Outer<'_>> {
        let hinge = self.bodies.of(body).iter().find_map(|(point, local)| {
            Some(Outer::Hinge(Hinge {
                joint: *point,
                at: self.anchor(*point)?,
                local: *local,
            }))
        });
        hinge.or_else(|| {
            let joins = |slide: &&Slide| slide.joins(body).is_some_and(|other| self.solved[other]);
            self.bodies.slides.iter().find(joins).map(Outer::Slide)
        })
    }

    fn inner(&self, [i, j]: [BodyId; 2]) -> Option<Inner<'_>> {
        let joint = self.bodies.of(i).iter().find_map(|(point, on_i)| {
            let on_j = self.bodies.local(j, *point)?;
            let free = self.anchor(*point).is_none();
            free.then_some(Inner::Hinge(*point, [*on_i, on_j]))
        });
        joint.or_else(|| {
            let mut slides = self.bodies.slides.iter();
            let slide = slides.find(|slide| slide.joins(i) == Some(j));
            slide.map(Inner::Slide)
        })
    }

    fn dyad(&self, [i, j]: [BodyId; 2]) -> Option<Step> {
        let arm = |body: BodyId, outer: &Hinge, inner: PointId, to: Vector| {
            Arm::new(body, outer.at, [outer.local, to], [outer.joint, inner])
        };
        let guided = |body: BodyId, slide: &Slide, inner: PointId, at: Vector| {
            slide.track(body).moved(inner, at)
        };
        let step = match (self.outer(i)?, self.outer(j)?, self.inner([i, j])?) {
            // The links are swapped, so that the hinge is the first outer pair.
            (Outer::Slide(_), Outer::Hinge(_), _) => return self.dyad([j, i]),
            (Outer::Hinge(b), Outer::Hinge(d), Inner::Hinge(c, [c_i, c_j])) => {
                let mut arms = [arm(i, &b, c, c_i), arm(j, &d, c, c_j)];
                if b.at.body == BodyId::FRAME && Some(d.at.body) == self.crank {
                    arms.reverse();
                }
                let four_bar = self.four_bar(&arms);
                Rrr { arms, four_bar }.into()
            }
            (Outer::Hinge(b), Outer::Slide(slide), Inner::Hinge(c, [c_i, c_j])) => {
                let arm = arm(i, &b, c, c_i);
                let track = guided(j, slide, c, c_j);
                Rrp { arm, track }.into()
            }
            (Outer::Slide(first), Outer::Slide(second), Inner::Hinge(c, [c_i, c_j])) => {
                let tracks = [guided(i, first, c, c_i), guided(j, second, c, c_j)];
                Prp { tracks }.into()
            }
            (Outer::Hinge(b), Outer::Hinge(d), Inner::Slide(slide)) => {
                let sides = [slide.side(i, &b), slide.side(j, &d)];
                Rpr { sides }.into()
            }
            (Outer::Hinge(b), Outer::Slide(slide), Inner::Slide(inner)) => {
                let (through, direction) = inner.line_on(j);
                let rpp = Rpp {
                    side: inner.side(i, &b),
                    track: slide.track(j),
                    direction,
                    through,
                };
                rpp.into()
            }
            (Outer::Slide(_), Outer::Slide(_), Inner::Slide(_)) => return None,
        };
        Some(step)
    }

    /// Four-bar of two arms, the first hinged to the driven crank and the second to the frame. The closed form of the
    /// four-bar also gives arcs and dead points. None for other arms.
    fn four_bar(&self, arms: &[Arm; 2]) -> Option<CrankFourBar> {
        let crank = self.crank?;
        if arms.each_ref().map(|arm| arm.outer.body) != [crank, BodyId::FRAME] {
            return None;
        }
        let (_, on_frame, hinge) = self.bodies.hinge([BodyId::FRAME, crank])?;
        CrankFourBar::new(crank, (on_frame.local, hinge), arms)
    }
}
