//! Any linkage to scale: supports, links, blocks on guides, wheels in mesh, paths.

mod layout;
mod plots;
mod slides;
mod wheels;

use std::f64::consts::PI;

use assur::mechanism::{LinkId, Mechanism, PointId, Pose, Unsolved};
use assur::motion::Motion;
use assur::{JetPoint, Point, Vector};

use crate::list::{List, Look, Role};
use crate::overlays::Scales;
use crate::{overlays, parts};
use layout::Layout;
use slides::Guide;
use wheels::Gearing;

/// Samples of an arc of the motion.
const SAMPLES: usize = 360;
/// Samples of an arc for the lengths of vectors.
const VECTORS: u32 = 180;
/// Half the width of a link's bar, in units.
const BAR: f64 = 1.15;
/// Samples keep off the ends of an arc by this part of it: where points coincide
/// there, rounding alone decides how links turn about them.
const OFF: f64 = 1e-9;
/// Room around the drawing, relative to its size.
const ROOM: f64 = 0.07;

/// A linkage as a drawing: what is rigid, drawn once in the coordinates of its
/// bodies, and the bodies' poses at any input. Body 0 is the frame, then come the
/// links, each with its first point as origin and its angle, then idlers.
#[derive(Clone, Debug)]
pub struct Figure {
    motion: Motion,
    layout: Layout,
    gearing: Gearing,
    names: Vec<String>,
    bounds: [f64; 4],
    unit: f64,
    rigid: List,
    vectors: Option<Scales>,
}

impl Figure {
    /// The drawing of a mechanism in its motion, with the paths of these points.
    ///
    /// # Errors
    /// Why there is no pose to draw it in.
    pub fn new(motion: &Motion, traces: &[PointId]) -> Result<Self, Unsolved> {
        Self::drawn(motion, traces, false)
    }

    /// The same drawing with each link in the colour of its Assur group.
    ///
    /// # Errors
    /// As of [`Self::new`].
    pub fn in_groups(motion: &Motion, traces: &[PointId]) -> Result<Self, Unsolved> {
        Self::drawn(motion, traces, true)
    }

    fn drawn(motion: &Motion, traces: &[PointId], in_groups: bool) -> Result<Self, Unsolved> {
        let mechanism = motion.mechanism();
        let draft = mechanism.draft();
        let home = motion.pose::<1>(motion.home())?;
        let layout = Layout::new(draft, mechanism, &home, in_groups);
        let gearing = Gearing::new(draft, &layout, mechanism, &home);
        let samples = sampled(motion);
        let guides = slides::guides(draft, &layout, mechanism, &home, &samples);
        let drawn = mechanism
            .point_ids()
            .filter(|point| layout.is_drawn(*point));
        let places = drawn.flat_map(|point| {
            let paths = samples.iter().flatten();
            paths.map(move |pose| mechanism.place(pose, point).place())
        });
        let places = places
            .chain(gearing.reach(mechanism, &samples))
            .chain(guides.iter().flat_map(Guide::on_frame));
        let bounds = around(places);
        let [left, bottom, right, top] = bounds;
        let mut figure = Self {
            motion: motion.clone(),
            names: mechanism.points().map(str::to_owned).collect(),
            unit: (right - left).hypot(top - bottom) / 100.0,
            bounds,
            layout,
            gearing,
            rigid: List::default(),
            vectors: None,
        };
        figure.draw(&home, &guides, &figure.paths(&samples, traces));
        Ok(figure)
    }

    /// With the first and second derivatives of every moving point as arrows, and
    /// room for them.
    #[must_use]
    pub fn with_vectors(mut self) -> Self {
        let [left, bottom, right, top] = self.bounds;
        let size = (right - left).hypot(top - bottom);
        let cycle = self.motion.cycle();
        let inputs = cycle.arcs().iter().flat_map(|[from, to]| {
            (0..VECTORS)
                .map(move |i| from + (to - from) * (f64::from(i) + 0.5) / f64::from(VECTORS))
        });
        let poses = inputs.filter_map(|input| self.motion.pose::<3>(input).ok());
        let points: Vec<JetPoint<3>> = poses.flat_map(|pose| self.moving(&pose)).collect();
        let scales = Scales::of(&points, f64::MIN_POSITIVE, size);
        let corners = [Point::new(left, bottom), Point::new(right, top)];
        let tips = scales.tips(&points, size).into_iter();
        self.bounds = within(corners.into_iter().chain(tips));
        self.vectors = Some(scales);
        self
    }

    /// Whether a point is drawn by itself: a joint, a traced point, a centre of mass.
    pub fn is_drawn(&self, point: PointId) -> bool {
        self.layout.is_drawn(point)
    }

    /// The points that are drawn and move, in a pose.
    fn moving(&self, pose: &Pose<3>) -> Vec<JetPoint<3>> {
        let points = self.motion.mechanism().point_ids();
        let moving =
            points.filter(|point| self.layout.is_drawn(*point) && self.layout.moves(*point));
        moving
            .map(|point| self.motion.mechanism().place(pose, point))
            .collect()
    }

    /// The display list of what is rigid.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// The rectangle that holds the drawing at every input: left, bottom, right,
    /// top.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// What the labels' numbers stand for: the names of the points.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The role of a link: whose colour it has in plots, and in a drawing that is
    /// not [in groups](Self::in_groups).
    pub fn role(&self, link: LinkId) -> Role {
        self.layout.role(link)
    }

    /// The role of a link in the drawing.
    pub fn drawn_role(&self, link: LinkId) -> Role {
        self.layout.drawn_role(link)
    }

    /// The roles of drivers and Assur groups, in the order of the structure.
    pub fn step_roles(&self) -> impl Iterator<Item = Role> {
        layout::step_roles(self.motion.mechanism().structure())
    }

    /// What moves: `n, x₀, y₀, θ₀, …` of the n bodies, then a display list in
    /// the coordinates of the frame.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn frame(&self, input: f64) -> Result<Vec<f32>, Unsolved> {
        let pose = self.motion.pose::<1>(input)?;
        let mechanism = self.motion.mechanism();
        let mut poses = vec![(Point::origin(), 0.0)];
        for link in mechanism.link_ids() {
            poses.push(layout::body(mechanism, &pose, Some(link)));
        }
        poses.extend(self.gearing.idlers(mechanism, &pose));
        let mut list = List::default();
        // Next to a dead point there are no derivatives.
        if let Some((scales, pose)) = self.vectors.zip(self.motion.pose(input).ok()) {
            for point in self.moving(&pose) {
                overlays::arrows(&mut list, &point, scales, self.unit);
            }
        }
        self.label(&mut list, mechanism, &pose);
        let count = [poses.len() as f32];
        let poses = poses.iter().flat_map(|(at, angle)| [at.x, at.y, *angle]);
        let numbers = count.into_iter().chain(poses.map(|x| x as f32));
        Ok(numbers.chain(list.numbers().iter().copied()).collect())
    }

    /// The names of the points, away from the links that meet there.
    fn label(&self, list: &mut List, mechanism: &Mechanism, pose: &Pose<1>) {
        let place = |point: PointId| mechanism.place(pose, point).place();
        for point in mechanism.point_ids() {
            if !self.layout.is_drawn(point) {
                continue;
            }
            let at = place(point);
            let near = self.layout.neighbours(point).iter();
            let away: Vector = near
                .map(|other| at - place(*other))
                .filter(|off| off.norm() > 0.0)
                .map(|off| off.normalize())
                .sum();
            let off = if self.layout.is_support(point) {
                [-1.5, -0.2]
            } else if away.norm() > 1e-3 {
                let far = if self.layout.is_on_block(point) {
                    2.3
                } else {
                    1.5
                };
                let off = away.normalize() * far;
                [off.x, off.y]
            } else {
                [-1.0, 1.1]
            };
            list.name(Role::Ink, point.index(), at, off);
        }
    }

    /// The paths of points, an unbroken run for each stretch of the motion.
    fn paths(&self, samples: &[Vec<Pose<1>>], traces: &[PointId]) -> Vec<(Role, Vec<Point>)> {
        let mechanism = self.motion.mechanism();
        let path = |point: PointId, run: &Vec<Pose<1>>| -> Vec<Point> {
            run.iter()
                .map(|pose| mechanism.place(pose, point).place())
                .collect()
        };
        let role = |point: PointId| {
            let link = self.layout.link_of(point);
            link.map_or(Role::Secondary, |link| self.layout.drawn_role(link))
        };
        let traces = traces.iter().filter(|point| self.layout.moves(**point));
        traces
            .flat_map(|point| samples.iter().map(|run| (role(*point), path(*point, run))))
            .collect()
    }

    fn draw(&mut self, home: &Pose<1>, guides: &[Guide], paths: &[(Role, Vec<Point>)]) {
        let (u, mechanism) = (self.unit, self.motion.mechanism());
        let mut list = List::default();
        for (role, path) in paths {
            list.polyline(*role, Look::Dashed, path);
        }
        for guide in guides {
            guide.draw_line(&mut list, u);
        }
        list.body(0);
        let points = mechanism.point_ids();
        for point in points
            .clone()
            .filter(|point| self.layout.is_support(*point))
        {
            parts::support(&mut list, mechanism.place(home, point).place(), 1.5 * u);
        }
        self.gearing.draw(&mut list, u);
        // The first link, the crank as a rule, on top.
        for link in mechanism.link_ids().rev() {
            list.body(link.index() + 1);
            let (role, outline) = (self.layout.drawn_role(link), self.layout.outline(link));
            match outline[..] {
                [] | [_] => {}
                [from, to] if self.gearing.is_wheel(link) && !self.layout.is_bar(link) => {
                    list.polyline(role, Look::Thin, &[from, to]);
                }
                [from, to] => parts::bar(&mut list, role, from, to, BAR * u),
                _ => parts::plate(&mut list, role, outline, BAR * u),
            }
        }
        for guide in guides {
            guide.draw_block(&mut list, u);
        }
        for point in points {
            let Some(link) = self.layout.link_of(point) else {
                continue;
            };
            list.body(link.index() + 1);
            let at = layout::local(mechanism, home, Some(link), point);
            if self.layout.is_joint(point) {
                parts::hinge(&mut list, at, 1.1 * u);
            } else if self.layout.is_centre(point) {
                overlays::mass(&mut list, at, u);
            } else {
                list.circle(self.layout.drawn_role(link), Look::Solid, at, 0.6 * u);
            }
        }
        self.rigid = list;
    }
}

/// Poses over the motion, a run for each arc; crowded towards dead points.
fn sampled(motion: &Motion) -> Vec<Vec<Pose<1>>> {
    let cycle = motion.cycle();
    let turns = (cycle.period().unwrap_or(0.0) / (2.0 * PI))
        .round()
        .max(1.0);
    let count = SAMPLES * if cycle.is_full() { turns as usize } else { 1 };
    let place = |t: f64| {
        if cycle.is_full() {
            t
        } else {
            (0.5 - 0.5 * (PI * t).cos()).clamp(OFF, 1.0 - OFF)
        }
    };
    let runs = cycle.arcs().iter().map(|[from, to]| {
        let inputs = (0..=count).map(|i| from + (to - from) * place(i as f64 / count as f64));
        inputs.filter_map(|input| motion.pose(input).ok()).collect()
    });
    runs.filter(|run: &Vec<Pose<1>>| !run.is_empty()).collect()
}

/// The rectangle around places, with room.
fn around(places: impl Iterator<Item = Point>) -> [f64; 4] {
    let [left, bottom, right, top] = within(places);
    if left > right {
        return [-1.0, -1.0, 1.0, 1.0];
    }
    let size = (right - left).hypot(top - bottom);
    let room = ROOM * size.max(f64::MIN_POSITIVE);
    [left - room, bottom - room, right + room, top + room]
}

/// The rectangle that just holds places; of none, its left is beyond its right.
fn within(places: impl Iterator<Item = Point>) -> [f64; 4] {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for place in places {
        low = low.inf(&place.coords);
        high = high.sup(&place.coords);
    }
    [low.x, low.y, high.x, high.y]
}
