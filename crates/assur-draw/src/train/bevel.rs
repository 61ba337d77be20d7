//! The drawing of a bevel differential, seen from the side, slightly from the sun's end and from above.

mod shafts;
mod wheels;

use std::f64::consts::{PI, TAU};

use assur::dynamics::Body;
use assur::gears::train::{Coupling, Layout, Member};
use assur::mobility::{Point3, Vector3};
use assur::sorting::sort_by;
use assur::{Point, Vector};

use super::solid::Frustum;
use super::{TrainPose, TrainView, WorkingMember, members};
use crate::list::List;
use crate::projection::Projection;

/// Direction of view, radians: rotation towards the sun's end, and elevation.
const LOOK: [f64; 2] = [0.4, 0.2];
/// Face width of the wheels relative to their cone distance.
const FACE: f64 = 0.32;
/// Outward displacement of the satellites along their axes, which leaves a gap between magnets, in modules.
const GAP: f64 = 0.9;
/// Width of the rim around the teeth or plates of a central wheel that encloses the satellites, in modules.
const RIM: f64 = 2.0;
/// Clearance between the carrier and the wheels, relative to the size of the train.
const CLEAR: f64 = 0.1;
/// Length of the free ends of shafts, relative to the size of the train.
const SHAFT: f64 = 0.5;
/// Radius of working member 7 (a brush, a blade or the like) on a satellite's pin, relative to the satellite's radius.
const SEVENTH: f64 = 0.8;
/// Working member 8, on the carrier's shaft: its distance from the cage, and its radius, relative to the train's size.
const EIGHTH: [f64; 2] = [0.85, 0.7];
/// Distance of the ground below the main axis, relative to the size of the train.
const FOOT: f64 = 0.55;
/// Radii of a shaft, of the carrier's hollow shaft and of a bearing bush, relative to the size of the train.
const RADII: [f64; 3] = [0.035, 0.06, 0.1];

/// A bevel differential. The x-axis is the main axis and points from the ring to the sun. At the
/// carrier's angle 0 the first satellite is above the main axis, in the direction of z.
#[derive(Clone, Debug)]
pub(super) struct Bevel {
    layout: Layout,
    view: TrainView,
    projection: Projection,
    /// Wide ends of sun and ring: position along the main axis, and radius.
    central: [[f64; 2]; 2],
    /// Wide end of a satellite: distance from the apex along the satellite's axis, and radius.
    satellite: [f64; 2],
    /// Cosine and sine of the angle between a satellite's axis and the main axis.
    inclination: [f64; 2],
    /// Outward displacement of the satellites along their axes.
    gap: f64,
    /// Length of the pins.
    pin: f64,
    /// The carrier's cage: radius, and position along the main axis of its end on the ring's side.
    cage: [f64; 2],
    /// Positions of the outer ends of the shafts of ring and sun along the main axis.
    shafts: [f64; 2],
    /// Position of the outer end of the carrier's hollow shaft along the main axis.
    hollow: f64,
    /// Outlines of the working members 7 and 8; none for a member that is absent.
    members: [Option<Vec<Vec<Point>>>; 2],
    size: f64,
    unit: f64,
}

/// Radial and tangential directions at an angle about the main axis.
fn turning(angle: f64) -> [Vector3; 2] {
    let (sin, cos) = angle.sin_cos();
    // At angle 0 the radial direction is upwards (z); with increasing angle it turns towards the viewer (−y).
    [Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)]
}

/// A part of the drawing, with its nearness to the viewer.
struct Part {
    near: f64,
    list: List,
}

impl Bevel {
    pub(super) fn new(layout: &Layout, view: TrainView) -> Self {
        let train = layout.train();
        let radius = |member| 0.5 * layout.diameter(member);
        let [sun, satellite, ring] = [Member::Sun, Member::Satellite, Member::Ring].map(radius);
        let (sine, cosine) = train.inclination().sin_cos();
        // Distance of the centre of the satellite's pitch circle from the common apex of the pitch cones.
        let along = layout.axis_distance(view.coupling) / sine;
        let central = [
            [along * cosine + satellite * sine, sun],
            [along * cosine - satellite * sine, ring],
        ];
        let gap = match view.coupling {
            Coupling::Contact => 0.0,
            Coupling::Magnetic => GAP * layout.module(),
        };
        let size = sun.max(ring).max(along.hypot(satellite));
        let pin = along + gap + CLEAR * size;
        let moved = gap * cosine;
        let ends = [
            central[0][0],
            central[1][0],
            central[0][0] + moved,
            central[1][0] + moved,
            // Edges of a working member at the end of the pin.
            pin * cosine + satellite * sine,
            pin * cosine - satellite * sine,
        ];
        let left = ends.into_iter().fold(f64::INFINITY, f64::min) - CLEAR * size;
        let right = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let around = sun.max(ring) + CLEAR * size;
        let hollow = if view.members[1].is_some() {
            EIGHTH[0]
        } else {
            0.0
        };
        let outlines = |index: usize, radius: f64| {
            let member: Option<WorkingMember> = view.members[index];
            member.map(|member| members::outlines(member, radius, 0.0))
        };
        Self {
            layout: *layout,
            view,
            projection: Projection::space(LOOK),
            central,
            satellite: [along, satellite],
            inclination: [cosine, sine],
            gap,
            pin,
            cage: [around.max(pin * sine), left],
            shafts: [left - (hollow + SHAFT) * size, right + SHAFT * size],
            hollow: left - hollow.max(0.5 * SHAFT) * size,
            members: [
                outlines(0, SEVENTH * satellite),
                outlines(1, EIGHTH[1] * size),
            ],
            size,
            unit: 0.022 * size,
        }
    }

    /// The rectangle that holds the drawing in every pose: left, bottom, right, top.
    pub(super) fn bounds(&self) -> [f64; 4] {
        let (radius, sine) = (self.satellite[1], self.inclination[1]);
        let rim = RIM * self.layout.module();
        // Distances of the outermost parts from the main axis: a working member on its pin, the wheels, the cage.
        let outer = [
            self.pin * sine + radius,
            self.central[0][1] + rim,
            self.central[1][1] + rim,
            self.cage[0],
        ];
        let around = outer.into_iter().fold(0.0, f64::max);
        let ([left, right], foot) = (self.shafts, (FOOT + 0.06) * self.size);
        // Positions along the main axis, each with the reach of the drawing from the axis at this position.
        let places = [
            (self.cage[1], around),
            (right - SHAFT * self.size, around),
            (self.hollow, EIGHTH[1] * self.size),
            // The hatched ground extends beyond the shafts.
            (left - 0.08 * self.size, foot),
            (right + 0.08 * self.size, foot),
        ];
        let corners = places.into_iter().flat_map(|(x, around)| {
            let at = self.projection.place(Point3::new(x, 0.0, 0.0));
            let round = around + 2.0 * self.unit;
            [-1.0, 1.0].map(|side| at + Vector::new(side * LOOK[0].sin(), side) * round)
        });
        let first = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        corners.fold(first, |[left, bottom, right, top], at| {
            [
                left.min(at.x),
                bottom.min(at.y),
                right.max(at.x),
                top.max(at.y),
            ]
        })
    }

    /// The cone of sun or ring. Angles about its axis are measured from the upward direction.
    fn central_wheel(&self, member: Member) -> Frustum {
        let sun = member == Member::Sun;
        let sign = if sun { 1.0 } else { -1.0 };
        let [along, radius] = self.central[usize::from(!sun)];
        let along = sign * along;
        let narrow = 1.0 - FACE;
        Frustum {
            axis: Vector3::x() * sign,
            across: turning(0.0),
            ends: [[along, radius], [along * narrow, radius * narrow]],
            rim: RIM * self.layout.module(),
        }
    }

    /// The cone of the satellite at the angle `at` about the main axis. Angles about its outward axis start at the mesh
    /// with the sun.
    fn satellite(&self, at: f64) -> Frustum {
        let ([cosine, sine], [outward, ahead]) = (self.inclination, turning(at));
        let [along, radius] = self.satellite;
        let narrow = 1.0 - FACE;
        Frustum {
            axis: Vector3::x() * cosine + outward * sine,
            across: [Vector3::x() * sine - outward * cosine, -ahead],
            ends: [
                [along + self.gap, radius],
                [along * narrow + self.gap, radius * narrow],
            ],
            rim: 0.0,
        }
    }

    /// Periods of the magnetic field around sun, satellite and ring; for gears, their numbers of teeth.
    fn periods(&self) -> [f64; 3] {
        [Member::Sun, Member::Satellite, Member::Ring].map(|member| {
            let plates = self.layout.train().teeth(member);
            f64::from(plates) / f64::from(self.view.plates())
        })
    }

    /// The angles of the first plates of sun and ring, and that of a satellite's first plate as a function of the
    /// satellite's angle about the main axis. Wheels in mesh are mounted half a period of the field apart.
    fn mounted(&self, pose: &TrainPose) -> ([f64; 2], impl Fn(f64) -> f64) {
        let [sun, _, _, ring] = pose.angles;
        let [p1, p2, p4] = self.periods();
        let satellite = move |at: f64| (p1 * (at - sun) - PI) / p2;
        ([sun, ring - PI * p2 / p4], satellite)
    }

    pub(super) fn draw(&self, list: &mut List, pose: &TrainPose) {
        let carrier = pose.angles[Body::Carrier.index()];
        let ([sun, ring], satellite) = self.mounted(pose);
        let mut parts = Vec::new();
        parts.extend(self.draw_central(Member::Sun, sun));
        parts.extend(self.draw_central(Member::Ring, ring));
        parts.extend(self.bearings(pose.ground));
        parts.extend(self.eighth(carrier));
        let count = self.layout.counts().satellites;
        for k in 0..count {
            let at = carrier + TAU * f64::from(k) / f64::from(count);
            parts.push(self.draw_satellite(at, satellite(at), k == 0));
            parts.extend(self.arm(at, k == 0));
        }
        sort_by(&mut parts, |a, b| a.near.total_cmp(&b.near));
        for part in &parts {
            list.append(&part.list);
        }
    }

    fn part(&self, at: Point3, draw: impl FnOnce(&mut List)) -> Part {
        let mut list = List::default();
        draw(&mut list);
        Part {
            near: self.projection.nearness(at),
            list,
        }
    }
}

#[cfg(test)]
mod tests;
