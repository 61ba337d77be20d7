//! In which order a mechanism is solved, and by which closed form each group.

use crate::Vector;
use crate::gears::Mesh;
use crate::index::{BodyId, Id, LinkId, List, PointId, StepId};
use crate::position::{
    Anchor, Arm, Closed, Course, Crank, Geared, Prp, Rpp, Rpr, Rrp, Rrr, Slider, Step,
};
use crate::structure::{self, Structure};

use super::body::{Bodies, Placement, Slide};
use super::natural;
use super::resolved::{Driver, Resolved};

/// The plan of a mechanism.
pub(super) struct Plan {
    pub(super) steps: List<StepId, Step>,
    /// The drawn input: the coordinate of the first driver.
    pub(super) home: f64,
    /// The range of the first driver, if it is a slide.
    pub(super) range: Option<[f64; 2]>,
    /// The drawn unknowns of groups that Newton's method solves.
    pub(super) natural: Vec<f64>,
}

/// What has been placed by the steps so far.
struct Placed<'a> {
    bodies: &'a Bodies,
    solved: List<BodyId, bool>,
    /// The crank that the input turns.
    crank: Option<BodyId>,
}

/// The steps in the order of the structure, and the drawn input.
///
/// # Errors
/// A group that no step can solve.
pub(super) fn plan(
    draft: &Resolved<'_>,
    bodies: &Bodies,
    placements: &List<LinkId, Placement>,
    structure: &Structure,
) -> Result<Plan, Vec<BodyId>> {
    let solved = bodies.ids().map(|body| body == BodyId::FRAME);
    let mut placed = Placed {
        bodies,
        solved: solved.collect(),
        crank: None,
    };
    let first = draft.drivers.first();
    let mut plan = Plan {
        steps: List::default(),
        home: first.map_or(0.0, |driver| drawn(draft, bodies, placements, driver)),
        range: None,
        natural: Vec::new(),
    };
    for part in &structure.steps {
        let step = match part {
            structure::Step::Driver { driver, links } => {
                let [base, body] = links.map(BodyId::at);
                let first = *driver == 0;
                let driver = &draft.drivers[*driver];
                if base != BodyId::FRAME {
                    return Err(vec![body]);
                }
                let drawn = drawn(draft, bodies, placements, driver);
                let course = if first {
                    Course::FIRST
                } else {
                    Course::through(driver.rate(), [plan.home, drawn])
                };
                match driver {
                    Driver::Crank { .. } if first => placed.crank = Some(body),
                    Driver::Slide { range, .. } if first => plan.range = Some(*range),
                    Driver::Crank { .. } | Driver::Slide { .. } => {}
                }
                let lead = lead(placements, driver);
                driven(bodies, driver, body, lead, course).ok_or_else(|| vec![body])?
            }
            structure::Step::Group(group) => {
                let links: Vec<BodyId> = group.links().into_iter().map(BodyId::at).collect();
                match placed.closed_form(&links) {
                    Some(step) => step,
                    None => {
                        let offset = plan.natural.len() / 2;
                        let places = |point| draft.places[point];
                        let group = natural::group(bodies, &links, &placed.solved, offset, places);
                        let (group, places) = group.ok_or(links)?;
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
    Ok(plan)
}

/// What the angle of a driven link has more than its body's.
fn lead(placements: &List<LinkId, Placement>, driver: &Driver) -> f64 {
    match driver {
        Driver::Crank { link, .. } => link.map_or(0.0, |link| placements[link].lead),
        Driver::Slide { .. } => 0.0,
    }
}

/// The drawn coordinate of a driver; that of a slide is within its range.
fn drawn(
    draft: &Resolved<'_>,
    bodies: &Bodies,
    placements: &List<LinkId, Placement>,
    driver: &Driver,
) -> f64 {
    match driver {
        Driver::Crank { link, .. } => {
            bodies.drawn_angle(draft.body(*link)) + lead(placements, driver)
        }
        Driver::Slide { slide, range, .. } => {
            let slide = &bodies.slides[*slide];
            let track = slide.track(slide.bodies[1]);
            bodies.drawn_way(&track).clamp(range[0], range[1])
        }
    }
}

/// A driver on the frame; `lead` is what the driven link's angle has more than its body's.
fn driven(
    bodies: &Bodies,
    driver: &Driver,
    body: BodyId,
    lead: f64,
    course: Course,
) -> Option<Step> {
    match driver {
        Driver::Crank { .. } => {
            let (local, hinge) = bodies.crank_hinge(body)?;
            let crank = Crank {
                body,
                at: Anchor {
                    body: BodyId::FRAME,
                    local,
                },
                hinge,
                lead,
                course,
            };
            Some(crank.into())
        }
        Driver::Slide { slide, range, .. } => {
            let slider = Slider {
                track: bodies.slides[*slide].track(body),
                range: *range,
                course,
            };
            Some(slider.into())
        }
    }
}

/// How a link of a dyad is joined to what is solved.
enum Outer<'a> {
    Hinge { at: Anchor, hinge: Vector },
    Slide(&'a Slide),
}

/// How the two links of a dyad are joined.
enum Inner<'a> {
    /// By a hinge, on each of them.
    Hinge([Vector; 2]),
    Slide(&'a Slide),
}

impl Placed<'_> {
    /// The step that solves a group of bodies, all others of which it is joined to
    /// being solved; none where no closed form is known.
    fn closed_form(&self, group: &[BodyId]) -> Option<Step> {
        match *group {
            [wheel] => self.geared(wheel).map(Step::from),
            [i, j] => self.dyad([i, j]),
            _ => None,
        }
    }

    /// A point on the solved body that has it.
    fn anchor(&self, point: PointId) -> Option<Anchor> {
        self.bodies.anchor_of(point, |body| self.solved[body])
    }

    fn outer(&self, body: BodyId) -> Option<Outer<'_>> {
        let hinge = self.bodies.of(body).iter().find_map(|(point, hinge)| {
            let (at, hinge) = (self.anchor(*point)?, *hinge);
            Some(Outer::Hinge { at, hinge })
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
            free.then_some(Inner::Hinge([*on_i, on_j]))
        });
        joint.or_else(|| {
            let mut slides = self.bodies.slides.iter();
            let slide = slides.find(|slide| slide.joins(i) == Some(j));
            slide.map(Inner::Slide)
        })
    }

    fn dyad(&self, [i, j]: [BodyId; 2]) -> Option<Step> {
        let guided = |body: BodyId, slide: &Slide, point: Vector| slide.track(body).moved(point);
        let step = match (self.outer(i)?, self.outer(j)?, self.inner([i, j])?) {
            // The hinge first: the dyad is the same.
            (Outer::Slide(_), Outer::Hinge { .. }, _) => return self.dyad([j, i]),
            (
                Outer::Hinge { at: b, hinge: from },
                Outer::Hinge {
                    at: d,
                    hinge: start,
                },
                Inner::Hinge([c_i, c_j]),
            ) => {
                let arms = [Arm::new(i, b, [from, c_i]), Arm::new(j, d, [start, c_j])];
                let closed = self.four_bar(&arms).map(Step::from);
                closed.unwrap_or_else(|| Rrr { arms }.into())
            }
            (Outer::Hinge { at, hinge }, Outer::Slide(slide), Inner::Hinge([c_i, c_j])) => {
                let arm = Arm::new(i, at, [hinge, c_i]);
                let track = guided(j, slide, c_j);
                Rrp { arm, track }.into()
            }
            (Outer::Slide(first), Outer::Slide(second), Inner::Hinge([c_i, c_j])) => {
                let tracks = [guided(i, first, c_i), guided(j, second, c_j)];
                Prp { tracks }.into()
            }
            (
                Outer::Hinge { at: b, hinge: on_i },
                Outer::Hinge { at: d, hinge: on_j },
                Inner::Slide(slide),
            ) => {
                let sides = [slide.side(i, b, on_i), slide.side(j, d, on_j)];
                Rpr { sides }.into()
            }
            (Outer::Hinge { at, hinge }, Outer::Slide(slide), Inner::Slide(inner)) => {
                let (through, direction) = inner.line_on(j);
                let rpp = Rpp {
                    side: inner.side(i, at, hinge),
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

    /// The closed form of a four-bar where the dyad joins the driven crank and the
    /// frame: exact next to change points, and it tells arcs and dead points as well.
    fn four_bar(&self, arms: &[Arm; 2]) -> Option<Closed> {
        let crank = self.crank?;
        let [first, second] = arms.each_ref().map(|arm| arm.outer.body);
        let arms = if [first, second] == [crank, BodyId::FRAME] {
            arms.clone()
        } else if [first, second] == [BodyId::FRAME, crank] {
            [arms[1].clone(), arms[0].clone()]
        } else {
            return None;
        };
        Closed::new(crank, self.bodies.crank_hinge(crank)?, arms)
    }

    fn geared(&self, wheel: BodyId) -> Option<Geared> {
        self.bodies.gears.iter().find_map(|gear| {
            let second = gear.bodies[1] == wheel;
            if !second && gear.bodies[0] != wheel {
                return None;
            }
            let mate = gear.bodies[usize::from(!second)];
            if !self.solved[mate] || !self.solved[gear.carrier] {
                return None;
            }
            let step = gear.teeth[0] / gear.teeth[1];
            let step = if second { step } else { 1.0 / step };
            let ratio = if gear.mesh == Mesh::External {
                -step
            } else {
                step
            };
            let own = self.bodies.of(wheel);
            let (at, hinge) = own.iter().find_map(|(point, hinge)| {
                let (body, local) = (gear.carrier, self.bodies.local(gear.carrier, *point)?);
                Some((Anchor { body, local }, *hinge))
            })?;
            let drawn = |body| self.bodies.drawn_angle(body);
            let [angle, other, carrier] = [wheel, mate, gear.carrier].map(drawn);
            // A wheel without a marked radius turns from where its mate is at zero.
            let shift = if own.len() > 1 {
                angle - carrier - ratio * (other - carrier)
            } else {
                0.0
            };
            Some(Geared {
                body: wheel,
                at,
                hinge,
                mate,
                ratio,
                shift,
            })
        })
    }
}
