//! Bevel wheels with their teeth or plates, and the parts on the satellites' pins.

use std::f64::consts::PI;

use assur::Point;
use assur::dynamics::{Body, Poles};
use assur::gears::train::{Coupling, Member};
use assur::mobility::{Point3, Vector3};

use super::{Bevel, Part, RADII};
use crate::list::{List, Look, Role};
use crate::parts;
use crate::train::planar::FINE;
use crate::train::solid::Frustum;
use crate::train::wheel::POLES;
use crate::train::{Name, role};

impl Bevel {
    /// Draws a wheel with its mark and its teeth or plates, the first of which is at the angle `zero`.
    fn draw_wheel(&self, list: &mut List, member: Member, body: Body, wheel: &Frustum, zero: f64) {
        let teeth = self.layout.train().teeth(member);
        wheel.draw(list, &self.projection, role(body));
        if PI * self.layout.module() > FINE * 2.0 * self.size {
            let [even, odd] = wheel.plates(&self.projection, teeth, zero);
            match (self.view.coupling, self.view.poles) {
                (Coupling::Contact, _) => {
                    list.polygons(role(body), Look::Soft, &[even, odd].concat());
                }
                (Coupling::Magnetic, Poles::Alike) => {
                    list.polygons(POLES[0], Look::Solid, &[even, odd].concat());
                }
                (Coupling::Magnetic, Poles::Alternating) => {
                    list.polygons(POLES[0], Look::Solid, &even);
                    list.polygons(POLES[1], Look::Solid, &odd);
                }
            }
        }
        // The mark lies between two plates, where its line is visible.
        let mark = zero + PI / f64::from(teeth);
        wheel.mark(list, &self.projection, role(body), mark);
    }

    /// Sun or ring, with its shaft.
    pub(super) fn draw_central(&self, member: Member, angle: f64) -> [Part; 2] {
        let sun = member == Member::Sun;
        let (body, name) = match sun {
            true => (Body::Sun, Name::Sun),
            false => (Body::Ring, Name::Ring),
        };
        let sign = if sun { 1.0 } else { -1.0 };
        let wheel = self.central_wheel(member);
        let along = self.central[usize::from(!sun)][0];
        let end = self.shafts[usize::from(sun)];
        let shaft = self.line(role(body), [along, end], RADII[0]);
        let wheel = self.part(wheel.middle(), |list| {
            self.draw_wheel(list, member, body, &wheel, angle);
            let at = self.projection.place(wheel.place(0, PI));
            list.name(role(body), name as usize, at, [0.7 * sign, -0.7]);
        });
        let middle = Point3::new(0.5 * (along + end), 0.0, 0.0);
        let shaft = self.part(middle, |list| list.append(&shaft));
        [wheel, shaft]
    }

    /// A satellite on its pin, with the working member on its shaft (number 7), such as a fan.
    pub(super) fn draw_satellite(&self, at: f64, turned: f64, first: bool) -> Part {
        let wheel = self.satellite(at);
        let axis = wheel.axis;
        let [[wide, radius], [narrow, _]] = wheel.ends;
        let colour = role(Body::Satellite);
        let place = |along: f64| self.projection.place(Point3::from(axis * along));
        let half = 0.8 * RADII[0] * self.size;
        let inside = [0.0, narrow].map(place);
        let outside = [wide, self.pin].map(place);
        let draw_inside = |list: &mut List| {
            parts::bar(list, role(Body::Carrier), inside[0], inside[1], half);
        };
        let draw_outside = |list: &mut List| {
            parts::bar(list, role(Body::Carrier), outside[0], outside[1], half);
            let Some(outlines) = &self.members[0] else {
                return;
            };
            let across = [turned, turned + 0.5 * PI].map(|angle| wheel.direction(angle));
            let centre = axis * (0.5 * (wide + self.pin));
            self.disc(list, colour, centre, across, outlines);
            if first {
                let off = wheel.direction(0.0) * (0.6 * radius);
                let at = self.projection.place(Point3::from(centre + off));
                list.name(colour, Name::Seventh as usize, at, [0.0, 0.0]);
            }
        };
        self.part(wheel.middle(), |list| {
            let towards = wheel.seen_end(&self.projection) == 0;
            if towards {
                draw_inside(list);
            } else {
                draw_outside(list);
            }
            self.draw_wheel(list, Member::Satellite, Body::Satellite, &wheel, turned);
            if towards {
                draw_outside(list);
            } else {
                draw_inside(list);
            }
            if first {
                let at = self.projection.place(wheel.place(0, 0.6 * PI));
                list.name(colour, Name::Satellite as usize, at, [0.0, 0.0]);
            }
        })
    }

    /// Draws outlines in the plane through `centre` that the directions `across` span.
    pub(super) fn disc(
        &self,
        list: &mut List,
        colour: Role,
        centre: Vector3,
        across: [Vector3; 2],
        outlines: &[Vec<Point>],
    ) {
        let place = |at: &Point| {
            let at = centre + across[0] * at.x + across[1] * at.y;
            self.projection.place(Point3::from(at))
        };
        let outlines = outlines.iter();
        let loops = outlines.map(|outline| outline.iter().map(place).collect());
        list.polygons(colour, Look::Pale, &loops.collect::<Vec<_>>());
    }
}
