//! The drawings of a force plan to scale, of free bodies, and of Zhukovsky's lever.

mod body;
mod lever;
mod room;
mod symbol;

use assur::forces::{Cause, ForceName, ForcePlan, PlanStep, StepKind, Term};
use assur::mechanism::{BodyId, Mechanism, Pose};
use assur::{Point, Vector, perpendicular};

use crate::list::{List, Look, Role};
use crate::parts;
use body::moments_picture;
pub use body::{FrictionCircle, equilibrium_picture, free_body_picture};
pub use lever::lever_picture;
pub use room::PlanRooms;
pub use symbol::force_symbol;

/// Gives the number of a body.
pub type Numbers<'a> = &'a dyn Fn(BodyId) -> String;

/// Vectors shorter than this are not drawn, in symbol units.
const MIN_LENGTH: f64 = 0.3;
/// Distance of a name from its vector, in heights of the text.
const OFF: f64 = 0.9;

/// A drawn plan, free body or lever.
#[derive(Clone, Debug)]
pub struct ForcePicture {
    /// The display list.
    pub list: List,
    /// Names, to which labels refer by index.
    pub names: Vec<String>,
    /// Rectangle of the picture: left, bottom, right, top.
    pub bounds: [f64; 4],
    /// True if the picture is a polygon of forces to scale: then its lengths are forces.
    pub is_plan: bool,
}

struct Drawing {
    list: List,
    names: Vec<String>,
    unit: f64,
}

impl Drawing {
    fn new(bounds: [f64; 4]) -> Self {
        Self {
            list: List::default(),
            names: Vec::new(),
            unit: size(bounds) / 100.0,
        }
    }

    fn picture(self, bounds: [f64; 4], is_plan: bool) -> ForcePicture {
        ForcePicture {
            list: self.list,
            names: self.names,
            bounds,
            is_plan,
        }
    }

    /// Writes a name beside a place.
    fn name(&mut self, role: Role, name: String, at: Point, away: Vector) {
        let off = away.try_normalize(0.0).unwrap_or_default() * OFF;
        self.names.push(name);
        let number = self.names.len() - 1;
        self.list.name(role, number, at, [off.x, off.y]);
    }

    fn arrow(&mut self, role: Role, from: Point, to: Point) -> bool {
        let long = (to - from).norm() > MIN_LENGTH * self.unit;
        if long {
            parts::arrow(&mut self.list, role, from, to, self.unit);
        }
        long
    }
}

/// Colour of a force: found in this step, found before, or given.
fn role(known: bool, is_reaction: bool) -> Role {
    match (known, is_reaction) {
        (false, _) => Role::Accent1,
        (true, true) => Role::Ink,
        (true, false) => Role::Secondary,
    }
}

/// Draws a force plan up to a step: the polygon of its group with the reactions found so far or, for a sum of moments,
/// the links with their forces and arms. `shown` is the number of steps, at least 1; `rooms` keep the scale of each
/// plan over the motion.
pub fn plan_picture(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    (plan, rooms): (&ForcePlan, &PlanRooms),
    shown: usize,
    numbers: Numbers<'_>,
) -> ForcePicture {
    let shown = shown.clamp(1, plan.steps.len().max(1));
    let Some(current) = plan.steps.get(shown - 1) else {
        return Drawing::new([0.0, 0.0, 1.0, 1.0]).picture([0.0, 0.0, 1.0, 1.0], true);
    };
    if !is_polygon(current) {
        return moments_picture(mechanism, pose, current, numbers);
    }
    let own = |step: &&PlanStep| step.plan == current.plan && is_polygon(step);
    let bounds = square(rooms.around(current.plan, extent(plan, current.plan)));
    let mut drawing = Drawing::new(bounds);
    let mut drawn: Vec<&Term> = Vec::new();
    let until = plan.steps[..shown].iter().filter(own);
    let middle = Point::new(0.5 * (bounds[0] + bounds[2]), 0.5 * (bounds[1] + bounds[3]));
    for step in until {
        for term in step.terms.iter().filter(|term| !term.is_couple) {
            if drawn.iter().any(|other| is_drawn(term, other)) {
                continue;
            }
            drawn.push(term);
            let is_new = !term.known && std::ptr::eq(step, current);
            let is_reaction = !matches!(term.name.cause, Cause::Applied(_));
            let role = role(!is_new, is_reaction);
            let [from, to] = term.ends.map(Point::from);
            if drawing.arrow(role, from, to) {
                let half = from + (to - from) * 0.5;
                let mut across = perpendicular(to - from);
                if across.dot(&(half - middle)) < 0.0 {
                    across = -across;
                }
                let name = force_symbol(&term.name, false, numbers);
                drawing.name(role, name, half, across);
            }
        }
    }
    drawing.picture(bounds, true)
}

/// Rectangle around a whole plan; None if nothing is drawn in it.
fn extent(plan: &ForcePlan, number: usize) -> Option<[f64; 4]> {
    let own = plan.steps.iter();
    let own = own.filter(|step| step.plan == number && is_polygon(step));
    let mut ends = own.flat_map(|step| step.terms.iter().flat_map(|term| term.ends));
    let first = ends.next()?;
    Some(around([first].into_iter().chain(ends).map(Point::from)))
}

fn is_polygon(step: &PlanStep) -> bool {
    !matches!(step.kind, StepKind::Moments | StepKind::Along)
}

/// Whether a vector, or the opposite one on the other link, is already drawn: in a plan both are in the same place.
fn is_drawn(term: &Term, other: &Term) -> bool {
    let [one, other] = [term.name, other.name];
    let pair = |name: ForceName| match name.cause {
        Cause::Reaction { pair, .. } => Some(pair),
        _ => None,
    };
    let is_opposite = pair(one).is_some() && pair(one) == pair(other) && one.part == other.part;
    one == other || is_opposite
}

/// Rectangle around places.
fn around(places: impl Iterator<Item = Point>) -> [f64; 4] {
    let none = [f64::MAX, f64::MAX, f64::MIN, f64::MIN];
    let all = places.fold(none, |all, at| {
        [
            all[0].min(at.x),
            all[1].min(at.y),
            all[2].max(at.x),
            all[3].max(at.y),
        ]
    });
    if all[0] > all[2] {
        [0.0, 0.0, 1.0, 1.0]
    } else {
        all
    }
}

/// Returns a rectangle, made higher or wider if it is very flat.
fn square([left, bottom, right, top]: [f64; 4]) -> [f64; 4] {
    let size = (right - left).max(top - bottom);
    let size = if size > 0.0 { size } else { 1.0 };
    let [x, y] = [right - left, top - bottom].map(|side| 0.5 * (0.3 * size - side).max(0.0));
    [left - x, bottom - y, right + x, top + y]
}

fn size([left, bottom, right, top]: [f64; 4]) -> f64 {
    (right - left).max(top - bottom)
}

/// Draws a couple as an arc about a place, counter-clockwise if it is positive, and returns the middle of the arc.
fn couple(drawing: &mut Drawing, role: Role, at: Point, value: f64) -> Point {
    const STEPS: u32 = 18;
    let radius = 5.0 * drawing.unit;
    let on = |k: u32| {
        let turn = (0.25 + f64::from(k) / f64::from(STEPS) * 1.3) * std::f64::consts::PI;
        let x = radius * turn.cos() * -value.signum();
        at + Vector::new(-x, radius * turn.sin())
    };
    let arc: Vec<Point> = (0..STEPS).map(on).collect();
    drawing.list.polyline(role, Look::Line, &arc);
    if let [.., before, last] = arc[..] {
        let along = (last - before).normalize() * (parts::HEAD * drawing.unit);
        parts::head(
            &mut drawing.list,
            role,
            last - along * 0.2,
            last + along * 0.8,
        );
    }
    on(STEPS / 2)
}
