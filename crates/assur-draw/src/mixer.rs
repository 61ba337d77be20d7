//! The mixer to scale: linkage, wheels in mesh, stirrer blades.

use std::f64::consts::TAU;

use assur::catalog::mixer::{Carrier, Mixer, Tracer};
use assur::{Link, Point, Unsolved, Vector};

use crate::list::{Label, List, Look, Role};
use crate::overlays::{self, Overlays, Scales};
use crate::wheels::{self, DrawnWheel};
use crate::{parts, tracers};

/// Bodies in the order of their poses; 0 is the frame. Wheel 4 is the rocker's;
/// after it come wheels 5, 6, …, and then the idlers.
const CRANK: usize = 1;
const COUPLER: usize = 2;
const ROCKER: usize = 3;

/// Half the width of a link's bar, in units.
const BAR: f64 = 1.15;

/// A mixer as a drawing: what is rigid, drawn once in the coordinates of its
/// bodies, and the bodies' poses at any crank angle.
#[derive(Clone, Debug)]
pub struct Scene {
    mixer: Mixer,
    wheels: Vec<DrawnWheel>,
    bounds: [f64; 4],
    /// The unit of symbols, a hundredth of the drawing's size.
    unit: f64,
    overlays: Overlays,
    scales: Option<Scales>,
    rigid: List,
}

impl Scene {
    /// The drawing of a mixer and what lies over it.
    pub fn new(mixer: &Mixer, overlays: Overlays) -> Self {
        let wheels = wheels::drawn(&mixer.gears);
        let path = path_of_c(mixer);
        let curves: Vec<_> = mixer
            .tracers()
            .iter()
            .map(|tracer| tracers::path(mixer, tracer))
            .collect();
        let base = bounds(mixer, &wheels, &path);
        let [left, bottom, right, top] = base;
        let size = (right - left).hypot(top - bottom);
        let scales = overlays.vectors.then(|| Scales::new(mixer, size));
        let (scales, tips) = scales.unzip();
        let laid = curves.iter().flatten().flatten();
        let laid = laid.chain(tips.iter().flatten());
        let mut scene = Self {
            mixer: mixer.clone(),
            bounds: around(base, laid, size),
            wheels,
            unit: size / 100.0,
            overlays,
            scales,
            rigid: List::default(),
        };
        scene.draw(overlays.traces.then_some(&path), &curves);
        scene
    }

    /// The display list of what is rigid.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// The rectangle that holds the drawing at every crank angle: left, bottom,
    /// right, top. What is laid over it may leave the rectangle where it goes
    /// beyond all measure.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// What moves: `n, x₀, y₀, θ₀, …` of the n bodies, then a display list in
    /// the coordinates of the frame.
    ///
    /// # Errors
    /// [`Unsolved`] where the linkage has no pose.
    pub fn frame(&self, crank: f64) -> Result<Vec<f32>, Unsolved> {
        let linkage = &self.mixer.linkage;
        let pose = linkage.pose::<1>(self.mixer.assembly, crank)?;
        let [a, b, c, d] = linkage.joints(&pose).map(|joint| joint.place());
        let [phi, coupler, rocker] = [pose.crank, pose.coupler, pose.rocker].map(|x| x.value());
        let mut poses = vec![(Point::origin(), 0.0), (a, phi), (b, coupler), (d, rocker)];
        for DrawnWheel { wheel, .. } in &self.wheels[1..] {
            poses.push((d + wheel.centre, wheel.ratio * rocker + wheel.mounting));
        }
        let mut list = List::default();
        self.angle_arc(&mut list, phi);
        self.moving_label(&mut list, Label::B, b, b - a);
        self.moving_label(&mut list, Label::C, c, c - d);
        self.lay_over(&mut list, crank, [a, b, c, d]);
        let poses = poses.iter().flat_map(|(at, angle)| [at.x, at.y, *angle]);
        let count = [self.wheels.len() + 3].map(|n| n as f32);
        let numbers = count.into_iter().chain(poses.map(|x| x as f32));
        Ok(numbers.chain(list.numbers().iter().copied()).collect())
    }

    /// What is shown over the mechanism and changes its shape.
    fn lay_over(&self, list: &mut List, crank: f64, joints: [Point; 4]) {
        if self.overlays.loop_vectors {
            overlays::loop_vectors(list, joints, self.unit);
        }
        if self.overlays.transmission {
            let [_, b, c, d] = joints;
            overlays::transmission(list, [b, c, d], Label::Mu as usize, self.unit);
        }
        // At a dead point there is a pose without derivatives.
        if let Some(scales) = self.scales
            && let Ok(pose) = self.mixer.linkage.pose::<3>(self.mixer.assembly, crank)
        {
            overlays::analogues(list, &self.mixer, &pose, scales, self.unit);
        }
    }

    fn draw(&mut self, path: Option<&Vec<Vec<Point>>>, curves: &[Vec<Vec<Point>>]) {
        let (u, [l1, l2, l3, l4]) = (self.unit, self.mixer.linkage.lengths());
        let (a, d) = (Point::origin(), Point::new(l4, 0.0));
        let mut list = List::default();
        if let Some(path) = path {
            list.circle(Role::Crank, Look::Dashed, a, l1);
            for arc in path {
                list.polyline(Role::Rocker, Look::Dashed, arc);
            }
        }
        for (tracer, curve) in self.mixer.tracers().iter().zip(curves) {
            for run in curve {
                list.polyline(self.carrier(tracer.carrier).1, Look::Dashed, run);
            }
        }
        parts::support(&mut list, a, 1.5 * u);
        parts::support(&mut list, d, 1.5 * u);
        // A ring lies behind what turns inside it.
        let (rings, discs): (Vec<usize>, Vec<usize>) =
            (0..self.wheels.len()).partition(|index| self.wheels[*index].wheel.ring);
        for index in rings.into_iter().chain(discs) {
            list.body(ROCKER + index);
            self.wheels[index].draw(&mut list, self.mixer.gears.module(), u);
        }
        for (body, role, length) in [
            (ROCKER, Role::Rocker, l3),
            (COUPLER, Role::Coupler, l2),
            (CRANK, Role::Crank, l1),
        ] {
            list.body(body);
            parts::bar(&mut list, role, a, Point::new(length, 0.0), BAR * u);
        }
        for (body, at) in [(0, a), (COUPLER, a), (ROCKER, Point::new(l3, 0.0)), (0, d)] {
            list.body(body);
            parts::hinge(&mut list, at, 1.1 * u);
        }
        if self.overlays.centres {
            for (body, label, length) in [
                (CRANK, Label::C1, l1),
                (COUPLER, Label::C2, l2),
                (ROCKER, Label::C3, l3),
            ] {
                list.body(body);
                overlays::centre_of_mass(&mut list, label, length, u);
            }
            list.body(0);
        }
        for (label, at) in [(Label::A, a), (Label::D, d)] {
            list.label(Role::Ink, label, at, [-1.5, -0.2]);
        }
        for drawn in &self.wheels {
            drawn.name(&mut list, d, self.mixer.gears.module());
        }
        for (tracer, label) in self.mixer.tracers().iter().zip(tracers::LABELS) {
            let (body, role) = self.carrier(tracer.carrier);
            list.body(body);
            tracers::mark(&mut list, role, label, Point::new(tracer.x, tracer.y), u);
        }
        self.rigid = list;
    }

    /// The body that carries a point, and its role.
    fn carrier(&self, carrier: Carrier) -> (usize, Role) {
        match carrier {
            Carrier::Crank => (CRANK, Role::Crank),
            Carrier::Coupler => (COUPLER, Role::Coupler),
            Carrier::Rocker => (ROCKER, Role::Rocker),
            Carrier::Wheel(index) => (ROCKER + 1 + index, wheels::role(index)),
        }
    }

    /// What is drawn nearest to a place: the body that a point put there is on.
    ///
    /// # Errors
    /// [`Unsolved`] where the linkage has no pose.
    pub fn carrier_at(&self, crank: f64, place: Point) -> Result<Carrier, Unsolved> {
        let linkage = &self.mixer.linkage;
        let pose = linkage.pose::<1>(self.mixer.assembly, crank)?;
        let [a, b, c, d] = linkage.joints(&pose).map(|joint| joint.place());
        let bar = |from, to| (parts::distance(place, from, to) - BAR * self.unit).max(0.0);
        let bars = [
            (bar(a, b), Carrier::Crank),
            (bar(b, c), Carrier::Coupler),
            (bar(d, c), Carrier::Rocker),
        ];
        let module = self.mixer.gears.module();
        let shafts = [Carrier::Rocker]
            .into_iter()
            .chain((0..).map(Carrier::Wheel));
        let named = self.wheels.iter().filter(|drawn| drawn.is_named());
        let wheels = named
            .map(|drawn| drawn.distance(d, place, module))
            .zip(shafts);
        // Bars lie over wheels: where both are met, the bar is.
        let nearest = bars
            .into_iter()
            .chain(wheels)
            .reduce(|best, next| if next.0 < best.0 { next } else { best });
        Ok(nearest.map_or(Carrier::Coupler, |(_, carrier)| carrier))
    }

    /// The arc from the frame to the crank with the name of its angle.
    fn angle_arc(&self, list: &mut List, phi: f64) {
        let radius = 0.5 * self.mixer.linkage.length(Link::Crank);
        let turn = phi.rem_euclid(TAU);
        let at = |angle: f64| Point::new(radius * angle.cos(), radius * angle.sin());
        let points: Vec<Point> = (0..=48).map(|i| at(turn * f64::from(i) / 48.0)).collect();
        list.polyline(Role::Crank, Look::Thin, &points);
        let half = 0.5 * turn;
        list.label(
            Role::Crank,
            Label::Phi1,
            at(half),
            [2.4 * half.cos(), 1.1 * half.sin()],
        );
    }

    /// The name of a joint beyond the end of its link.
    fn moving_label(&self, list: &mut List, label: Label, at: Point, outward: Vector) {
        let off = outward.normalize() * 1.5;
        list.label(Role::Ink, label, at, [off.x, off.y]);
    }
}

/// The path of C: around D over the rocker's swing on each arc, drawn once.
fn path_of_c(mixer: &Mixer) -> Vec<Vec<Point>> {
    let c = Tracer {
        carrier: Carrier::Rocker,
        x: mixer.linkage.length(Link::Rocker),
        y: 0.0,
    };
    tracers::path(mixer, &c)
}

/// The rectangle around the circle of B, the path of C, the supports and wheels.
fn bounds(mixer: &Mixer, wheels: &[DrawnWheel], path: &[Vec<Point>]) -> [f64; 4] {
    let [l1, .., l4] = mixer.linkage.lengths();
    let d = Point::new(l4, 0.0);
    let module = mixer.gears.module();
    let rims = wheels
        .iter()
        .map(|drawn| (d + drawn.wheel.centre, drawn.rim(module)));
    let joints = path.iter().flatten().map(|c| (*c, 0.0));
    rims.chain(joints).chain([(Point::origin(), l1)]).fold(
        [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY],
        |b, (at, r)| {
            [
                b[0].min(at.x - r),
                b[1].min(at.y - r),
                b[2].max(at.x + r),
                b[3].max(at.y + r),
            ]
        },
    )
}

/// The rectangle grown around points, on every side by no more than `most`.
fn around<'a>(base: [f64; 4], points: impl Iterator<Item = &'a Point>, most: f64) -> [f64; 4] {
    let [left, bottom, right, top] = base;
    points.fold(base, |b, at| {
        [
            b[0].min(at.x.max(left - most)),
            b[1].min(at.y.max(bottom - most)),
            b[2].max(at.x.min(right + most)),
            b[3].max(at.y.min(top + most)),
        ]
    })
}

#[cfg(test)]
mod tests;
