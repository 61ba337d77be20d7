//! The drawing of a planar differential, seen along its main axis: the bodies and their poses.

mod field;

use std::f64::consts::{PI, TAU};

use assur::Point;
use assur::dynamics::{Body, Poles};
use assur::gears::train::{Coupling, Kind, Layout, Member, Mounting};

use super::wheel::{POLES, Rim, Wheel, polar};
use super::{Name, TrainPose, TrainView, members, role, velocities};
use crate::list::{List, Look, Role};
use crate::parts;

/// Indices of the bodies in the drawing; those of the satellites come last.
const FRAME: usize = 0;
const SUN: usize = 1;
const CARRIER: usize = 2;
const RING: usize = 3;
const SATELLITES: usize = 4;

/// Smallest pitch at which teeth or plates are drawn, relative to the diameter of the train.
pub(super) const FINE: f64 = 0.005;
/// Smallest pitch with room for a letter, relative to the width of the drawing.
const LETTERS: f64 = 0.035;
/// Smallest radius of a wheel with room for more than its number, in units of the drawing.
const ROOM: f64 = 11.0;
/// Distance from the main axis to the edge of the drawing. The unit of the drawing is 1/50 of this distance.
const HALF: f64 = 50.0;
/// Distances of the inner and the outer edge of the hatched ground from the wheels, in units.
const GROUND: [f64; 2] = [1.6, 4.4];

#[derive(Clone, Debug)]
pub(super) struct Planar {
    layout: Layout,
    view: TrainView,
    sun: Wheel,
    satellite: Wheel,
    /// The second wheel of a stepped satellite.
    step: Option<Wheel>,
    ring: Wheel,
    mounting: Mounting,
    /// Distance of the satellites from the main axis.
    distance: f64,
    /// Angles of the satellites about the main axis, relative to the carrier, radians.
    directions: Vec<f64>,
    unit: f64,
    reach: f64,
}

impl Planar {
    pub(super) fn new(layout: &Layout, view: TrainView) -> Self {
        let train = layout.train();
        let teeth = |member| train.teeth(member);
        let stepped = train.kind() == Kind::Stepped;
        let wheel = |member: Member, mates: &[Member]| {
            let body = match member {
                Member::Sun => Body::Sun,
                Member::Satellite | Member::Step => Body::Satellite,
                Member::Ring => Body::Ring,
            };
            let rim = match view.coupling {
                Coupling::Contact => {
                    let mate = |mate: &Member| (teeth(*mate), *mate == Member::Ring);
                    Rim::Teeth(mates.iter().map(mate).collect())
                }
                Coupling::Magnetic => Rim::Plates(view.poles),
            };
            Wheel {
                role: role(body),
                teeth: teeth(member),
                module: layout.module(),
                ring: member == Member::Ring,
                rim,
            }
        };
        let mut sun = wheel(Member::Sun, &[Member::Satellite]);
        let mut satellite = match stepped {
            true => wheel(Member::Satellite, &[Member::Sun]),
            false => wheel(Member::Satellite, &[Member::Sun, Member::Ring]),
        };
        let mut step = stepped.then(|| wheel(Member::Step, &[Member::Ring]));
        let mut ring = wheel(Member::Ring, &[Member::Step]);
        let distance = layout.axis_distance(view.coupling);
        let orbit = |wheel: &Wheel| distance + wheel.reach();
        let wheels = [Some(&satellite), step.as_ref()].into_iter().flatten();
        let outer = wheels.map(orbit).fold(ring.reach(), f64::max);
        let fine = PI * layout.module() < FINE * 2.0 * outer;
        let all = [
            Some(&mut sun),
            Some(&mut satellite),
            step.as_mut(),
            Some(&mut ring),
        ];
        for wheel in all.into_iter().flatten().filter(|_| fine) {
            wheel.rim = Rim::Fine;
        }
        let count = layout.counts().satellites;
        let directions = (0..count).map(|k| TAU * f64::from(k) / f64::from(count));
        let unit = outer / (HALF - GROUND[1]);
        Self {
            mounting: layout.mounting(view.plates()),
            layout: *layout,
            view,
            sun,
            satellite,
            step,
            ring,
            distance,
            directions: directions.collect(),
            unit,
            reach: HALF * unit,
        }
    }

    /// The rectangle that holds the drawing in every pose: left, bottom, right, top.
    pub(super) fn bounds(&self) -> [f64; 4] {
        [-self.reach, -self.reach, self.reach, self.reach]
    }

    /// The pose of each body: x and y of its centre, and its angle, which includes the mounting of plates or teeth.
    pub(super) fn poses(&self, pose: &TrainPose) -> Vec<[f64; 3]> {
        let [sun, satellite, carrier, ring] = pose.angles;
        let centred = [pose.ground, sun, carrier, ring + self.mounting.ring];
        let centred = centred.into_iter().map(|angle| [0.0, 0.0, angle]);
        let mounted = self.directions.iter().zip(&self.mounting.satellites);
        let satellites = mounted.map(|(direction, mounted)| {
            let centre = polar(self.distance, carrier + direction);
            [centre.x, centre.y, satellite + mounted]
        });
        centred.chain(satellites).collect()
    }

    /// The part of the drawing that moves with the bodies, in the coordinates of each body.
    pub(super) fn rigid(&self) -> List {
        let mut list = List::default();
        self.draw_ground(&mut list);
        self.draw_eighth(&mut list);
        self.draw_wheels(&mut list);
        self.draw_carrier(&mut list);
        list.body(FRAME);
        parts::support(&mut list, Point::origin(), 1.1 * self.unit);
        parts::hinge(&mut list, Point::origin(), 1.3 * self.unit);
        list
    }

    /// Draws the hatched ground below the wheels.
    fn draw_ground(&self, list: &mut List) {
        let [inner, outer] = GROUND.map(|off| (HALF - GROUND[1] + off) * self.unit);
        let at = |k: usize| -0.25 * TAU + 0.03 * (k as f64 - 12.0);
        list.body(FRAME);
        let line: Vec<Point> = (0..=24).map(|k| polar(inner, at(k))).collect();
        list.polyline(Role::Secondary, Look::Line, &line);
        for k in (2..=24).step_by(2) {
            let hatch = [polar(inner, at(k)), polar(outer, at(k - 2))];
            list.polyline(Role::Secondary, Look::Thin, &hatch);
        }
    }

    /// Draws working member 8 on the carrier, behind the wheels.
    fn draw_eighth(&self, list: &mut List) {
        let Some(member) = self.view.members[1] else {
            return;
        };
        let radius = 0.97 * self.ring.radius();
        list.body(CARRIER);
        let between = PI / self.directions.len() as f64;
        let loops = members::outlines(member, radius, between);
        list.polygons(role(Body::Carrier), Look::Pale, &loops);
        list.name(
            role(Body::Carrier),
            Name::Eighth as usize,
            polar(0.86 * radius, between),
            [0.0, 0.0],
        );
    }

    /// Draws the wheels from back to front. The smaller wheel of a stepped satellite is in front of the larger.
    fn draw_wheels(&self, list: &mut List) {
        let small = self.step.as_ref();
        let behind = small.filter(|step| step.teeth > self.satellite.teeth);
        let before = small.filter(|step| step.teeth <= self.satellite.teeth);
        if behind.is_some() {
            self.draw_ring(list);
        }
        for (wheel, name) in [
            (behind, Name::Step),
            (Some(&self.satellite), Name::Satellite),
            (before, Name::Step),
        ] {
            let Some(wheel) = wheel else { continue };
            for (k, _) in self.directions.iter().enumerate() {
                list.body(SATELLITES + k);
                wheel.draw(list);
                self.mark(list, wheel);
                if k == 0 {
                    let at = polar(0.72 * wheel.back(), wheel.marked() + 0.5 * PI);
                    list.name(wheel.role, name as usize, at, [0.0, 0.0]);
                    self.letters(list, wheel);
                }
            }
        }
        if behind.is_none() {
            self.draw_ring(list);
        }
        list.body(SUN);
        self.sun.draw(list);
        self.mark(list, &self.sun);
        let at = polar(0.6 * self.sun.back(), self.sun.marked() + 0.4 * PI);
        list.name(self.sun.role, Name::Sun as usize, at, [0.0, 0.0]);
        self.letters(list, &self.sun);
        self.draw_sevenths(list);
    }

    fn draw_ring(&self, list: &mut List) {
        list.body(RING);
        self.ring.draw(list);
        self.mark(list, &self.ring);
        let middle = 0.5 * (self.ring.back() + self.ring.reach());
        let at = polar(middle, self.ring.marked() - 0.35 * PI);
        list.name(self.ring.role, Name::Ring as usize, at, [0.0, 0.0]);
        self.letters(list, &self.ring);
    }

    /// Draws the working members 7 on the satellites' shafts.
    fn draw_sevenths(&self, list: &mut List) {
        let Some(member) = self.view.members[0] else {
            return;
        };
        let radius = 0.82 * self.satellite.back();
        for k in 0..self.directions.len() {
            list.body(SATELLITES + k);
            let loops = members::outlines(member, radius, 0.0);
            list.polygons(self.satellite.role, Look::Soft, &loops);
            if k == 0 {
                let at = polar(0.6 * radius, self.satellite.marked() - 0.5 * PI);
                list.name(self.satellite.role, Name::Seventh as usize, at, [0.0, 0.0]);
            }
        }
    }

    /// Draws a mark that makes a wheel's rotation visible.
    fn mark(&self, list: &mut List, wheel: &Wheel) {
        let (at, back, size) = (wheel.marked(), wheel.back(), 0.8 * self.unit);
        if wheel.ring {
            let middle = polar(0.5 * (back + wheel.reach()), at);
            list.circle(wheel.role, Look::Solid, middle, size);
            return;
        }
        let size = size.min(0.12 * back);
        list.polyline(wheel.role, Look::Line, &[Point::origin(), polar(back, at)]);
        list.circle(wheel.role, Look::Solid, polar(back - 1.6 * size, at), size);
    }

    /// Draws the letter of the pole on the plate after the marked one and, if poles alternate, on the plate after that.
    fn letters(&self, list: &mut List, wheel: &Wheel) {
        let Rim::Plates(poles) = wheel.rim else {
            return;
        };
        let pitch_seen = PI * wheel.module > LETTERS * 2.0 * self.reach;
        if !pitch_seen || wheel.radius() < ROOM * self.unit {
            return;
        }
        let pitch = TAU / f64::from(wheel.teeth);
        let marked = (wheel.marked() / pitch).round() as usize;
        let plates = match poles {
            Poles::Alike => vec![(marked + 1, Name::North)],
            Poles::Alternating => [1, 2]
                .map(|off| marked + off)
                .map(|plate| match plate % 2 {
                    0 => (plate, Name::North),
                    _ => (plate, Name::South),
                })
                .to_vec(),
        };
        let off = if wheel.ring { 2.2 } else { -2.2 } * self.unit;
        for (plate, name) in plates {
            let colour = POLES[usize::from(name == Name::South)];
            let at = polar(wheel.back() + off, pitch * plate as f64);
            list.name(colour, name as usize, at, [0.0, 0.0]);
        }
    }

    /// Draws arms from the main axis to the satellites, and arrows of the magnetic field in the gaps.
    fn draw_carrier(&self, list: &mut List) {
        let half = (0.9 * self.unit).min(0.2 * self.satellite.back());
        list.body(CARRIER);
        for direction in &self.directions {
            let pin = polar(self.distance, *direction);
            parts::bar(list, role(Body::Carrier), Point::origin(), pin, half);
        }
        for direction in &self.directions {
            parts::hinge(list, polar(self.distance, *direction), 1.1 * half);
        }
        if let Some(last) = self.directions.last() {
            let at = polar(0.5 * (self.distance + self.sun.radius() * 0.6), *last);
            list.name(role(Body::Carrier), Name::Carrier as usize, at, [1.0, 0.0]);
        }
        if self.view.coupling == Coupling::Magnetic {
            list.polygons(Role::Secondary, Look::Solid, &self.field());
        }
    }

    /// Draws the arrows that change during the motion: forces on the satellites, and velocities of the first satellite.
    pub(super) fn draw_moving(&self, list: &mut List, pose: &TrainPose) {
        list.body(CARRIER);
        if let Some(torques) = pose.torques {
            list.polygons(Role::Ink, Look::Solid, &self.forces(torques));
        }
        let [_, spin, carrier, _] = pose.speeds;
        let layout = self.view.velocities.then_some(&self.layout);
        if let Some(velocities) =
            layout.and_then(|layout| layout.velocities_of(self.view.coupling, carrier, spin))
        {
            velocities::draw(list, &velocities, self.reach, self.unit);
        }
    }
}
