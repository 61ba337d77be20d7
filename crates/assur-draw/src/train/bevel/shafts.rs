//! Parts of a bevel train on the main axis: shafts, the carrier's cage, bearings.

use std::f64::consts::PI;

use assur::Point;
use assur::dynamics::Body;
use assur::mobility::{Point3, Vector3};

use super::{Bevel, EIGHTH, FOOT, Part, RADII, turning};
use crate::list::{List, Look, Role};
use crate::parts;
use crate::train::solid::Frustum;
use crate::train::{Name, role};

impl Bevel {
    /// A piece of a shaft along the main axis.
    pub(super) fn line(&self, role: Role, ends: [f64; 2], radius: f64) -> List {
        let [from, to] = ends.map(|x| self.projection.place(Point3::new(x, 0.0, 0.0)));
        let mut list = List::default();
        parts::bar(&mut list, role, from, to, radius * self.size);
        list
    }

    /// An arm of the carrier, from a satellite's pin around the wheels to the hollow shaft behind the ring.
    pub(super) fn arm(&self, at: f64, first: bool) -> [Part; 2] {
        let ([cosine, sine], [outward, _]) = (self.inclination, turning(at));
        let [radius, left] = self.cage;
        let corners = [
            [self.pin * cosine, self.pin * sine],
            [self.pin * cosine, radius],
            [left, radius],
            [left, 0.0],
        ];
        let places = corners.map(|[x, off]| Point3::from(Vector3::x() * x + outward * off));
        let seen = places.map(|at| self.projection.place(at));
        let colour = role(Body::Carrier);
        let draw = |list: &mut List, seen: &[Point]| {
            for (from, to) in seen.iter().zip(&seen[1..]) {
                if (to - from).norm() > 1e-9 * self.size {
                    parts::bar(list, colour, *from, *to, 0.8 * RADII[0] * self.size);
                }
            }
        };
        [
            self.part(places[2], |list| draw(list, &seen[..3])),
            self.part(places[3], |list| {
                draw(list, &seen[2..]);
                if first {
                    let outer = seen[2] + (seen[3] - seen[2]) * 0.2;
                    list.name(colour, Name::Carrier as usize, outer, [-0.9, 0.0]);
                }
            }),
        ]
    }

    /// The carrier's hollow shaft, and working member 8 on it: the driven tool, such as a fan.
    pub(super) fn eighth(&self, angle: f64) -> [Part; 2] {
        let [left, at] = [self.cage[1], self.hollow];
        let colour = role(Body::Carrier);
        let shaft = self.part(Point3::new(left, 0.0, 0.0), |list| {
            list.append(&self.line(colour, [at, left], RADII[1]));
        });
        let centre = Point3::new(at, 0.0, 0.0);
        let member = self.part(centre, |list| {
            let Some(outlines) = &self.members[1] else {
                return;
            };
            self.disc(list, colour, centre.coords, turning(angle), outlines);
            let blade = turning(angle)[0] * (0.6 * EIGHTH[1] * self.size);
            let at = self.projection.place(centre + blade);
            list.name(colour, Name::Eighth as usize, at, [-1.0, 0.0]);
        });
        [shaft, member]
    }

    /// The bearings of sun and ring, each with a foot on the ground. `ground` is the rotation of the ground as seen by
    /// the observer, radians.
    pub(super) fn bearings(&self, ground: f64) -> [Part; 2] {
        let ends = [(self.shafts[0], 1.0), (self.shafts[1], -1.0)];
        ends.map(|(end, inward)| {
            let [near, far] = [0.03, 0.13].map(|off| end + inward * off * self.size);
            let radius = RADII[2] * self.size;
            let bush = Frustum {
                axis: Vector3::x(),
                across: turning(ground),
                ends: [[near.max(far), radius], [near.min(far), radius]],
                rim: 0.0,
            };
            let down = turning(ground + PI)[0];
            self.part(bush.middle(), |list| {
                let place = |x: f64, off: f64| {
                    self.projection
                        .place(Point3::from(Vector3::x() * x + down * off))
                };
                let (middle, foot) = (0.5 * (near + far), FOOT * self.size);
                list.polyline(
                    Role::Secondary,
                    Look::Line,
                    &[place(middle, radius), place(middle, foot)],
                );
                let half = 0.13 * self.size;
                let ends = [place(middle - half, foot), place(middle + half, foot)];
                list.polyline(Role::Secondary, Look::Line, &ends);
                for k in 0..5 {
                    let x = middle - 0.8 * half + 0.4 * half * f64::from(k);
                    let hatch = [place(x, foot), place(x - 0.3 * half, foot + 0.4 * half)];
                    list.polyline(Role::Secondary, Look::Thin, &hatch);
                }
                bush.draw(list, &self.projection, Role::Secondary);
            })
        })
    }
}
