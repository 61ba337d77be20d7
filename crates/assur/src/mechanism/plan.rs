//! In which order a mechanism is solved, and by which closed form each group.

use crate::gears::Mesh;
use crate::position::{
    Anchor, Angle, Arm, Closed, Complex, Group, Input, Near, Obstacle, Prp, Rpp, Rpr, Rrp, Rrr,
    State, Track, finite,
};
use crate::structure::{self, Structure};
use crate::{FourBar, Jet, Vector};

use super::body::{Bodies, Seat, Slide};
use super::natural;
use super::{Draft, DraftDriver};

/// One step: it places a body or two, from those placed before.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    /// The driven crank.
    Crank {
        body: usize,
        at: Anchor,
        hinge: Vector,
        /// What the angle of the driven link has more than its body's.
        lead: f64,
    },
    /// The driven slide.
    Slider {
        track: Track,
        range: [f64; 2],
    },
    Geared(Geared),
    Closed(Closed),
    Rrr(Rrr),
    Rrp(Rrp),
    Rpr(Rpr),
    Prp(Prp),
    Rpp(Rpp),
    /// A group of any class.
    Group(Group),
}

/// A wheel hinged on a solved carrier and in mesh with a solved wheel.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Geared {
    pub(crate) body: usize,
    pub(crate) at: Anchor,
    pub(crate) hinge: Vector,
    pub(crate) mate: usize,
    /// dθ/dθ of the mate, seen from the carrier, and the angle at its zero.
    pub(crate) ratio: f64,
    pub(crate) shift: f64,
}

impl Step {
    /// Places the bodies of this step at an input.
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        input: Jet<N>,
        sign: f64,
        near: Near<'_>,
        step: usize,
    ) -> Result<(), Obstacle> {
        match self {
            Self::Crank {
                body,
                at,
                hinge,
                lead,
            } => {
                pin(state, *body, input + -lead, *at, *hinge);
            }
            Self::Slider { track, range } => {
                if !(range[0]..=range[1]).contains(&input.value()) {
                    return Err(Obstacle::Input);
                }
                let (start, direction) = state.line(track);
                let at = direction * Complex::new(input, Jet::constant(track.off));
                state.slid(track, direction, start + at);
            }
            Self::Geared(wheel) => {
                let carrier = state.angle(wheel.at.body);
                let turned = state.angle(wheel.mate) - carrier;
                let angle = carrier + turned * wheel.ratio + wheel.shift;
                pin(state, wheel.body, angle, wheel.at, wheel.hinge);
            }
            Self::Closed(closed) => closed.solve(state, sign, step)?,
            Self::Rrr(dyad) => dyad.solve(state, sign, step)?,
            Self::Rrp(dyad) => dyad.solve(state, sign, step)?,
            Self::Rpr(dyad) => dyad.solve(state, sign, step)?,
            Self::Prp(dyad) => dyad.solve(state, step)?,
            Self::Rpp(dyad) => dyad.solve(state, step)?,
            Self::Group(group) => return group.solve(state, near, step),
        }
        let winds = self.winds();
        let mut sum = Vector::zeros();
        for body in self.bodies() {
            if winds {
                state.winds(body, near);
            }
            sum += state.origin[body].nought() + state.turn[body].nought();
        }
        finite(sum)
    }

    /// The bodies that it places.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = usize> + '_ {
        let (group, pair) = match self {
            Self::Group(group) => (&group.bodies[..], [None; 2]),
            Self::Crank { body, .. } => (&[][..], [Some(*body), None]),
            Self::Slider { track, .. } => (&[][..], [Some(track.body), None]),
            Self::Geared(wheel) => (&[][..], [Some(wheel.body), None]),
            Self::Closed(Closed { arms: [i, j], .. }) | Self::Rrr(Rrr { arms: [i, j] }) => {
                (&[][..], [Some(i.body), Some(j.body)])
            }
            Self::Rrp(dyad) => (&[][..], [Some(dyad.arm.body), Some(dyad.track.body)]),
            Self::Rpr(Rpr { sides: [i, j] }) => (&[][..], [Some(i.body), Some(j.body)]),
            Self::Prp(Prp { tracks: [i, j] }) => (&[][..], [Some(i.body), Some(j.body)]),
            Self::Rpp(dyad) => (&[][..], [Some(dyad.side.body), Some(dyad.track.body)]),
        };
        let group = group.iter().map(|(body, _)| *body);
        group.chain(pair.into_iter().flatten())
    }

    /// Whether it needs the place of a body solved before.
    pub(crate) fn leans_on(&self, body: usize) -> bool {
        let on = |anchor: &Anchor| anchor.body == body;
        match self {
            Self::Crank { at, .. } => on(at),
            Self::Slider { track, .. } => on(&track.line),
            Self::Geared(wheel) => on(&wheel.at) || wheel.mate == body,
            Self::Closed(Closed { arms: [i, j], .. }) | Self::Rrr(Rrr { arms: [i, j] }) => {
                on(&i.outer) || on(&j.outer)
            }
            Self::Rrp(dyad) => on(&dyad.arm.outer) || on(&dyad.track.line),
            Self::Rpr(Rpr { sides: [i, j] }) => on(&i.outer) || on(&j.outer),
            Self::Prp(Prp { tracks: [i, j] }) => on(&i.line) || on(&j.line),
            Self::Rpp(dyad) => on(&dyad.side.outer) || on(&dyad.track.line),
            Self::Group(group) => group.inputs.iter().any(|input| match input {
                Input::Place(anchor) | Input::Direction(anchor) => on(anchor),
            }),
        }
    }

    /// Whether it is a wheel of this body.
    pub(crate) fn is_wheel(&self, body: usize) -> bool {
        matches!(self, Self::Geared(wheel) if wheel.body == body)
    }

    /// Whether the angles of its bodies come from their turns, to a whole turn.
    pub(crate) fn winds(&self) -> bool {
        !matches!(self, Self::Crank { .. } | Self::Geared(_) | Self::Closed(_))
    }

    /// Whether there are two ways to join its links, told apart by a sign.
    pub(crate) fn has_sign(&self) -> bool {
        matches!(
            self,
            Self::Closed(_) | Self::Rrr(_) | Self::Rrp(_) | Self::Rpr(_)
        )
    }

    /// Whether a margin that touches zero lets the links pass through in line:
    /// the smooth motion goes on with the other sign. (Parallel guides let
    /// nothing pass; the four-bar's closed form passes by itself.)
    pub(crate) fn passes(&self) -> bool {
        matches!(self, Self::Rrr(_) | Self::Rrp(_) | Self::Rpr(_))
    }

    /// The size of the squares its margins are made of.
    pub(crate) fn scale(&self) -> f64 {
        match self {
            Self::Rrr(Rrr { arms: [i, j] }) => (i.length() + j.length()).powi(2),
            Self::Rrp(dyad) => dyad.arm.length().powi(2),
            Self::Rpr(Rpr { sides: [i, j] }) => (i.off - j.off).powi(2),
            _ => 1.0,
        }
    }
}

fn pin<const N: usize>(
    state: &mut State<N>,
    body: usize,
    angle: Jet<N>,
    at: Anchor,
    hinge: Vector,
) {
    let turn = Complex::turn(angle);
    state.angle[body] = Angle::Known(angle);
    state.turn[body] = turn;
    state.origin[body] = state.place(at) - turn.by(hinge);
}

/// The plan of a mechanism.
pub(super) struct Planned {
    pub(super) steps: Vec<Step>,
    /// The drawn input.
    pub(super) home: f64,
    /// The drawn unknowns of groups that Newton's method solves.
    pub(super) natural: Vec<f64>,
}

/// The steps in the order of the structure, and the drawn input.
///
/// # Errors
/// A group that no step can solve.
pub(super) fn plan(
    draft: &Draft,
    bodies: &Bodies,
    seats: &[Seat],
    structure: &Structure,
) -> Result<Planned, Vec<usize>> {
    let mut solved = vec![false; bodies.count()];
    solved[0] = true;
    let (mut steps, mut home, mut crank) = (Vec::new(), 0.0, None);
    let mut natural = Vec::new();
    let drawn = |point: usize| draft.points[point].at.coords;
    for part in &structure.steps {
        let step = match part {
            structure::Step::Driver {
                driver,
                links: [base, link],
            } => {
                let driven = driver_step(
                    draft,
                    bodies,
                    seats,
                    &draft.drivers[*driver],
                    [*base, *link],
                );
                let (step, at) = driven.ok_or(vec![*link])?;
                home = at;
                crank = matches!(step, Step::Crank { .. }).then_some(*link);
                step
            }
            structure::Step::Group(group) => {
                let links = group.links();
                match step_for(bodies, &links, &solved, crank) {
                    Some(step) => step,
                    None => {
                        let offset = natural.len() / 2;
                        let planned = natural::group(bodies, &links, &solved, offset, drawn);
                        let (group, places) = planned.ok_or(links)?;
                        natural.extend(places.iter().flat_map(|place| [place.x, place.y]));
                        Step::Group(group)
                    }
                }
            }
        };
        for body in step.bodies() {
            solved[body] = true;
        }
        steps.push(step);
    }
    Ok(Planned {
        steps,
        home,
        natural,
    })
}

/// A driver on the frame, and its drawn coordinate.
fn driver_step(
    draft: &Draft,
    bodies: &Bodies,
    seats: &[Seat],
    driver: &DraftDriver,
    [base, body]: [usize; 2],
) -> Option<(Step, f64)> {
    if base != 0 {
        return None;
    }
    match driver {
        DraftDriver::Crank { link, .. } => {
            let (local, hinge) = bodies.crank_hinge(body)?;
            let lead = draft.links.iter().position(|other| other.name == *link);
            let lead = lead.map_or(0.0, |k| seats[k].lead);
            let at = Anchor { body: 0, local };
            let home = bodies.drawn_angle(body) + lead;
            Some((
                Step::Crank {
                    body,
                    at,
                    hinge,
                    lead,
                },
                home,
            ))
        }
        DraftDriver::Slide { slide, range } => {
            let track = bodies.slides.get(*slide)?.track(body);
            let home = bodies.drawn_way(&track).clamp(range[0], range[1]);
            Some((
                Step::Slider {
                    track,
                    range: *range,
                },
                home,
            ))
        }
    }
}

/// The step that solves a group of bodies, all others of which it is joined to
/// being solved; none where no closed form is known.
pub(super) fn step_for(
    bodies: &Bodies,
    group: &[usize],
    solved: &[bool],
    crank: Option<usize>,
) -> Option<Step> {
    match *group {
        [wheel] => geared(bodies, wheel, solved).map(Step::Geared),
        [i, j] => dyad(bodies, [i, j], solved, crank),
        _ => None,
    }
}

/// How a link of a dyad is joined to what is solved.
enum Outer<'a> {
    Hinge { outer: Anchor, hinge: Vector },
    Slide { slide: &'a Slide },
}

fn dyad(bodies: &Bodies, pair: [usize; 2], solved: &[bool], crank: Option<usize>) -> Option<Step> {
    let outer = |body: usize| -> Option<Outer<'_>> {
        let hinge = bodies.of(body).iter().find_map(|(point, hinge)| {
            let outer = bodies.anchor_of(*point, |other| solved[other])?;
            Some(Outer::Hinge {
                outer,
                hinge: *hinge,
            })
        });
        hinge.or_else(|| {
            let slide = bodies
                .slides
                .iter()
                .find(|slide| slide.joins(body).is_some_and(|other| solved[other]));
            slide.map(|slide| Outer::Slide { slide })
        })
    };
    let [i, j] = pair;
    let joint = bodies.of(i).iter().find_map(|(point, on_i)| {
        let on_j = bodies.local(j, *point)?;
        let free = bodies.anchor_of(*point, |other| solved[other]).is_none();
        free.then_some((*on_i, on_j))
    });
    let sliding = bodies.slides.iter().find(|slide| slide.joins(i) == Some(j));
    let track = |body: usize, slide: &Slide, point: Option<Vector>| {
        let track = slide.track(body);
        point.map_or(track.clone(), |point| track.moved(point))
    };
    let step = match (outer(i)?, outer(j)?, joint, sliding) {
        (
            Outer::Hinge {
                outer: b,
                hinge: from,
            },
            Outer::Hinge {
                outer: d,
                hinge: start,
            },
            Some((c_i, c_j)),
            _,
        ) => {
            let arms = [Arm::new(i, b, [from, c_i]), Arm::new(j, d, [start, c_j])];
            closed(bodies, &arms, crank).unwrap_or(Step::Rrr(Rrr { arms }))
        }
        (Outer::Hinge { outer, hinge }, Outer::Slide { slide }, Some((c_i, c_j)), _) => {
            Step::Rrp(Rrp {
                arm: Arm::new(i, outer, [hinge, c_i]),
                track: track(j, slide, Some(c_j)),
            })
        }
        (Outer::Slide { slide }, Outer::Hinge { outer, hinge }, Some((c_i, c_j)), _) => {
            Step::Rrp(Rrp {
                arm: Arm::new(j, outer, [hinge, c_j]),
                track: track(i, slide, Some(c_i)),
            })
        }
        (Outer::Slide { slide: first }, Outer::Slide { slide: second }, Some((c_i, c_j)), _) => {
            Step::Prp(Prp {
                tracks: [track(i, first, Some(c_i)), track(j, second, Some(c_j))],
            })
        }
        (
            Outer::Hinge {
                outer: b,
                hinge: on_i,
            },
            Outer::Hinge {
                outer: d,
                hinge: on_j,
            },
            None,
            Some(slide),
        ) => Step::Rpr(Rpr {
            sides: [slide.side(i, b, on_i), slide.side(j, d, on_j)],
        }),
        (Outer::Hinge { outer, hinge }, Outer::Slide { slide }, None, Some(inner)) => {
            Step::Rpp(rpp(inner, [i, j], outer, hinge, slide))
        }
        (Outer::Slide { slide }, Outer::Hinge { outer, hinge }, None, Some(inner)) => {
            Step::Rpp(rpp(inner, [j, i], outer, hinge, slide))
        }
        _ => return None,
    };
    Some(step)
}

fn rpp(inner: &Slide, [i, j]: [usize; 2], outer: Anchor, hinge: Vector, slide: &Slide) -> Rpp {
    let (through, direction) = inner.line_on(j);
    Rpp {
        side: inner.side(i, outer, hinge),
        track: slide.track(j),
        direction,
        through,
    }
}

/// The closed form of a four-bar where the dyad joins the driven crank and the
/// frame: exact next to change points, and it tells arcs and dead points as well.
fn closed(bodies: &Bodies, arms: &[Arm; 2], crank: Option<usize>) -> Option<Step> {
    let crank = crank?;
    let [coupler, rocker] = match (arms[0].outer.body, arms[1].outer.body) {
        (first, 0) if first == crank => arms.clone(),
        (0, second) if second == crank => [arms[1].clone(), arms[0].clone()],
        _ => return None,
    };
    let (a, hinge) = bodies.crank_hinge(crank)?;
    let out = coupler.outer.local - hinge;
    let base = rocker.outer.local - a;
    let lengths = [out.norm(), coupler.length(), rocker.length(), base.norm()];
    let linkage = FourBar::new(lengths).ok()?;
    let [out, frame] = [out, base].map(|v| v.y.atan2(v.x));
    let arms = [coupler, rocker];
    let leads = arms.each_ref().map(|arm| {
        let along = arm.to - arm.from;
        frame - along.y.atan2(along.x)
    });
    Some(Step::Closed(Closed {
        linkage,
        crank,
        lead: out - frame,
        arms,
        leads,
    }))
}

fn geared(bodies: &Bodies, wheel: usize, solved: &[bool]) -> Option<Geared> {
    bodies.gears.iter().find_map(|gear| {
        let second = gear.bodies[1] == wheel;
        if !second && gear.bodies[0] != wheel {
            return None;
        }
        let mate = gear.bodies[usize::from(!second)];
        if !solved[mate] || !solved[gear.carrier] {
            return None;
        }
        let step = gear.teeth[0] / gear.teeth[1];
        let step = if second { step } else { 1.0 / step };
        let ratio = if gear.mesh == Mesh::External {
            -step
        } else {
            step
        };
        let (point, hinge) = bodies
            .of(wheel)
            .iter()
            .find(|(point, _)| bodies.local(gear.carrier, *point).is_some())?;
        let at = Anchor {
            body: gear.carrier,
            local: bodies.local(gear.carrier, *point)?,
        };
        let [own, other, carrier] =
            [wheel, mate, gear.carrier].map(|body| bodies.drawn_angle(body));
        // A wheel without a marked radius turns from where its mate is at zero.
        let marked = bodies.of(wheel).len() > 1;
        let shift = if marked {
            own - carrier - ratio * (other - carrier)
        } else {
            0.0
        };
        Some(Geared {
            body: wheel,
            at,
            hinge: *hinge,
            mate,
            ratio,
            shift,
        })
    })
}
