//! The mixer to scale: linkage, wheels in mesh, stirrer blades.

use std::f64::consts::TAU;

use assur::catalog::mixer::Mixer;
use assur::gears::Wheel;
use assur::{Link, Point, Swing, Unsolved, Vector};

use crate::gear::Teeth;
use crate::list::{Label, List, Look, Role};
use crate::overlays::{self, Overlays, Scales};
use crate::parts;

/// Bodies in the order of their poses; 0 is the frame.
const CRANK: usize = 1;
const COUPLER: usize = 2;
const ROCKER: usize = 3;
const WHEEL5: usize = 4;
const IDLER: usize = 5;

/// A mixer as a drawing: what is rigid, drawn once in the coordinates of its
/// bodies, and the bodies' poses at any crank angle.
#[derive(Clone, Debug)]
pub struct Scene {
    mixer: Mixer,
    wheels: Vec<Wheel>,
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
        let wheels: Vec<Wheel> = [mixer.gears.driver_wheel(), mixer.gears.driven_wheel()]
            .into_iter()
            .chain(mixer.gears.idler())
            .collect();
        let path = path_of_c(mixer);
        let bounds = bounds(mixer, &wheels, &path);
        let [left, bottom, right, top] = bounds;
        let size = (right - left).hypot(top - bottom);
        let mut scene = Self {
            mixer: *mixer,
            wheels,
            bounds,
            unit: size / 100.0,
            overlays,
            scales: overlays.vectors.then(|| Scales::new(mixer, size)),
            rigid: List::default(),
        };
        scene.draw(overlays.traces.then_some(&path));
        scene
    }

    /// The display list of what is rigid.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// The rectangle that holds the drawing at every crank angle: left, bottom,
    /// right, top.
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
        for wheel in &self.wheels[1..] {
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
            overlays::transmission(list, joints, self.unit);
        }
        // At a dead point there is a pose without derivatives.
        if let Some(scales) = self.scales
            && let Ok(pose) = self.mixer.linkage.pose::<3>(self.mixer.assembly, crank)
        {
            overlays::analogues(list, &self.mixer, &pose, scales, self.unit);
        }
    }

    fn draw(&mut self, path: Option<&Vec<Vec<Point>>>) {
        let (u, [l1, l2, l3, l4]) = (self.unit, self.mixer.linkage.lengths());
        let (a, d) = (Point::origin(), Point::new(l4, 0.0));
        let mut list = List::default();
        if let Some(path) = path {
            list.circle(Role::Crank, Look::Dashed, a, l1);
            for arc in path {
                list.polyline(Role::Rocker, Look::Dashed, arc);
            }
        }
        parts::support(&mut list, a, 1.5 * u);
        parts::support(&mut list, d, 1.5 * u);
        // A ring lies behind what turns inside it.
        let mut order: Vec<usize> = (0..self.wheels.len()).collect();
        order.sort_by_key(|index| !self.wheels[*index].ring);
        for index in order {
            self.wheel(&mut list, index);
        }
        for (body, role, length) in [
            (ROCKER, Role::Rocker, l3),
            (COUPLER, Role::Coupler, l2),
            (CRANK, Role::Crank, l1),
        ] {
            list.body(body);
            parts::bar(&mut list, role, a, Point::new(length, 0.0), 1.15 * u);
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
        for (label, wheel) in [
            (Label::Four, &self.wheels[0]),
            (Label::Five, &self.wheels[1]),
        ] {
            let radius = self.mixer.gears.pitch_radius(wheel.teeth);
            let outward = if wheel.ring { 1.0 } else { 0.84 } * radius;
            let (sin, cos) = (self.mixer.gears.centre_line() + 1.9).sin_cos();
            let at = d + wheel.centre + Vector::new(cos, sin) * outward;
            list.label(Role::Ink, label, at, [0.0, 0.0]);
        }
        self.rigid = list;
    }

    /// Wheel `index` of the train (driver, driven, idler) with its blades.
    fn wheel(&self, list: &mut List, index: usize) {
        let (body, role, count) = [
            (ROCKER, Role::Wheel4, 3),
            (WHEEL5, Role::Wheel5, 4),
            (IDLER, Role::Idler, 0),
        ][index];
        let wheel = &self.wheels[index];
        let teeth = Teeth::new(wheel.teeth, wheel.ring, &self.mates(index));
        let module = self.mixer.gears.module();
        let outline = teeth.outline(module);
        list.body(body);
        let loops = if wheel.ring {
            let rim = (teeth.root_radius() + 1.5) * module;
            vec![outline, parts::round(rim, 180)]
        } else {
            vec![outline]
        };
        list.polygons(role, Look::Pale, &loops);
        let reach = 0.72 * teeth.pitch_radius() * module;
        let slender = (0.075 * reach).min(0.8 * self.unit);
        parts::blades(list, role, count, reach, slender);
        if body != ROCKER {
            list.circle(Role::Ink, Look::Hollow, Point::origin(), 0.7 * self.unit);
        }
    }

    /// The wheels that wheel `index` of the train meshes with.
    fn mates(&self, index: usize) -> Vec<(u32, bool)> {
        let mates: &[usize] = match (index, self.wheels.len()) {
            (0, 2) => &[1],
            (1, 2) => &[0],
            (2, _) => &[0, 1],
            _ => &[2],
        };
        let mate = |index: &usize| (self.wheels[*index].teeth, self.wheels[*index].ring);
        mates.iter().map(mate).collect()
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
    let [.., l3, l4] = mixer.linkage.lengths();
    let d = Point::new(l4, 0.0);
    let arc = |swing: Swing| {
        let (from, to) = match swing {
            Swing::Turns => (0.0, TAU),
            Swing::Between { min, max } => (min, max),
        };
        (0..=90)
            .map(|i| from + (to - from) * f64::from(i) / 90.0)
            .map(|angle| d + Vector::new(angle.cos(), angle.sin()) * l3)
            .collect()
    };
    let swings = mixer.linkage.swings(mixer.assembly).into_iter();
    swings.map(arc).collect()
}

/// The rectangle around the circle of B, the path of C, the supports and wheels.
fn bounds(mixer: &Mixer, wheels: &[Wheel], path: &[Vec<Point>]) -> [f64; 4] {
    let [l1, .., l4] = mixer.linkage.lengths();
    let d = Vector::new(l4, 0.0);
    let gears = &mixer.gears;
    let rims = wheels.iter().map(|wheel| {
        let beyond = if wheel.ring { 2.75 } else { 1.0 };
        let radius = gears.pitch_radius(wheel.teeth) + beyond * gears.module();
        (Point::origin() + d + wheel.centre, radius)
    });
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

#[cfg(test)]
mod tests {
    use super::*;
    use assur::catalog::mixer::Case;

    /// Every record of the list, cut apart by its own counts.
    fn records(mut numbers: &[f32]) -> Vec<Vec<f32>> {
        let mut found = Vec::new();
        while let Some(kind) = numbers.first() {
            let length = match *kind as u8 {
                0 => 2,
                1 => {
                    let mut length = 4;
                    for _ in 0..numbers[3] as usize {
                        length += 1 + 2 * numbers[length] as usize;
                    }
                    length
                }
                2 => 4 + 2 * numbers[3] as usize,
                3 => 6,
                4 => 7,
                other => panic!("record {other}"),
            };
            found.push(numbers[..length].to_vec());
            numbers = &numbers[length..];
        }
        found
    }

    #[test]
    fn lists_are_whole_and_bodies_have_poses() {
        for case in Case::ALL {
            let mixer = Mixer::new(&case.dimensions()).unwrap();
            let traces = Overlays {
                traces: true,
                ..Overlays::default()
            };
            let scene = Scene::new(&mixer, traces);
            let frame = scene.frame(1.0).unwrap();
            let bodies = frame[0] as usize;
            assert_eq!(bodies, 5);
            assert!(records(&frame[1 + 3 * bodies..]).len() == 4);
            let rigid = records(scene.rigid().numbers());
            let named = rigid.iter().filter(|record| record[0] == 0.0);
            assert!(named.clone().count() > 5);
            assert!(
                named
                    .map(|record| record[1] as usize)
                    .all(|body| body < bodies)
            );
            assert!(scene.rigid().numbers().iter().all(|x| x.is_finite()));
        }
    }

    /// The bars end where the next ones begin: the drawing closes.
    #[test]
    fn bodies_meet_at_the_joints() {
        let mixer = Mixer::new(&Case::A.dimensions()).unwrap();
        let frame = Scene::new(&mixer, Overlays::default()).frame(1.1).unwrap();
        let end = |body: usize, length: f64| {
            let [x, y, angle] = [0, 1, 2].map(|i| f64::from(frame[1 + 3 * body + i]));
            Point::new(x + length * angle.cos(), y + length * angle.sin())
        };
        let [l1, l2, l3, _] = mixer.linkage.lengths();
        assert!((end(CRANK, l1) - end(COUPLER, 0.0)).norm() < 1e-6);
        assert!((end(COUPLER, l2) - end(ROCKER, l3)).norm() < 1e-6);
    }

    /// Everything over the drawing, at every angle: numbers a screen can show,
    /// one constant number of records away from dead points.
    #[test]
    fn overlays_are_whole() {
        let all = Overlays {
            traces: true,
            centres: true,
            vectors: true,
            loop_vectors: true,
            transmission: true,
        };
        for lengths in [[0.37, 0.85, 0.55, 0.85], [0.6, 0.85, 0.3, 0.85], [0.5; 4]] {
            let dimensions = assur::catalog::mixer::Dimensions {
                lengths,
                ..Case::A.dimensions()
            };
            let mixer = Mixer::new(&dimensions).unwrap();
            let scene = Scene::new(&mixer, all);
            let plain = Scene::new(&mixer, Overlays::default());
            let more = scene.rigid().numbers().len() - plain.rigid().numbers().len();
            assert!(more > 300, "{more}");
            let dead_points = mixer.linkage.dead_points();
            for crank in (0..72).map(|i| 0.0873 * f64::from(i)).chain(dead_points) {
                let (Ok(frame), Ok(before)) = (scene.frame(crank), plain.frame(crank)) else {
                    continue;
                };
                let records = records(&frame[1 + 3 * 5..]).len();
                assert!(records > 4 + 15, "{crank}: {records}");
                assert!(frame.iter().all(|x| x.is_finite()), "{crank}");
                assert!(frame.starts_with(&before), "{crank}");
            }
        }
    }
}
