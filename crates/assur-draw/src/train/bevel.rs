//! The drawing of a bevel differential from the side, a little from the sun's end and from above.

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

/// Direction of view: turned towards the sun's end, and from above, radians.
const LOOK: [f64; 2] = [0.4, 0.2];
/// The width of the wheels relative to their cones.
const FACE: f64 = 0.32;
/// Outward displacement of magnets along their axes for a gap, in modules.
const GAP: f64 = 0.9;
/// Width of an outer wheel's rim beyond its teeth or plates, in modules.
const RIM: f64 = 2.0;
/// Clearance of the carrier around the wheels, and the lengths of shafts, relative to the size.
const CLEAR: f64 = 0.1;
const SHAFT: f64 = 0.5;
/// The radius of a working member on a pin relative to that of its satellite.
const SEVENTH: f64 = 0.8;
/// Distance of the working member on the carrier's shaft from the wheels, and its radius.
const EIGHTH: [f64; 2] = [0.85, 0.7];
/// Distance of the ground below the main axis.
const FOOT: f64 = 0.55;
/// The radii of shafts, of the carrier's hollow one and of bushes, relative to the size.
const RADII: [f64; 3] = [0.035, 0.06, 0.1];

/// A bevel differential. The main axis is x, from the ring to the sun; the first satellite is above
/// it, along z, at the carrier's angle 0.
#[derive(Clone, Debug)]
pub(super) struct Bevel {
    layout: Layout,
    view: TrainView,
    projection: Projection,
    /// Positions of the wide ends of sun and ring along the main axis, and their radii.
    central: [[f64; 2]; 2],
    /// Position of a satellite's wide end along its axis, and its radius.
    satellite: [f64; 2],
    /// The inclination of a satellite's axis: cosine and sine.
    inclination: [f64; 2],
    /// Outward displacement of the satellites.
    gap: f64,
    /// Length of the pins.
    pin: f64,
    /// Radius of the carrier's cage, and its position on the ring's side.
    cage: [f64; 2],
    /// The ends of the shafts of ring and sun.
    shafts: [f64; 2],
    /// The end of the carrier's hollow shaft.
    hollow: f64,
    /// The outlines of the working members.
    members: [Option<Vec<Vec<Point>>>; 2],
    size: f64,
    unit: f64,
}

/// Directions that rotate about the main axis: radial, and tangential.
fn turning(angle: f64) -> [Vector3; 2] {
    let (sin, cos) = angle.sin_cos();
    // The reader looks along y.
    [Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)]
}

/// A part of the drawing, with its nearness to the reader.
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
        // The middle of the satellite's pitch circle, from the common apex.
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
            // At the end of the pin, with a working member.
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

    /// The rectangle that holds the drawing at all times.
    pub(super) fn bounds(&self) -> [f64; 4] {
        let (radius, sine) = (self.satellite[1], self.inclination[1]);
        let rim = RIM * self.layout.module();
        // Corners of wheels, of a working member on its pin, and of the cage.
        let outer = [
            self.pin * sine + radius,
            self.central[0][1] + rim,
            self.central[1][1] + rim,
            self.cage[0],
        ];
        let around = outer.into_iter().fold(0.0, f64::max);
        let ([left, right], foot) = (self.shafts, (FOOT + 0.06) * self.size);
        // Distances from the main axis, and positions along it.
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

    /// Sun or ring; its angles are measured about the main axis from above.
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

    /// A satellite at an angle about the main axis; its own angles are measured about its axis,
    /// outward, from the mesh with the sun.
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

    /// Periods of the field per turn of sun, satellite and ring; for gears their teeth.
    fn periods(&self) -> [f64; 3] {
        [Member::Sun, Member::Satellite, Member::Ring].map(|member| {
            let plates = self.layout.train().teeth(member);
            f64::from(plates) / f64::from(self.view.plates())
        })
    }

    /// The angles of the first plates at which meshing wheels are half a period of the field apart:
    /// of sun and ring, and of a satellite by its angle about the main axis.
    fn mounted(&self, pose: &TrainPose) -> ([f64; 2], impl Fn(f64) -> f64) {
        let [sun, _, _, ring] = pose.angles;
        let [p1, p2, p4] = self.periods();
        let satellite = move |at: f64| (p1 * (at - sun) - PI) / p2;
        ([sun, ring - PI * p2 / p4], satellite)
    }

    /// Draws the differential in a pose.
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
