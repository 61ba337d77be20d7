//! The drawing of a linkage to scale: supports, links, blocks on guides, wheels in mesh, paths and overlays.

mod beside;
pub(crate) mod bounds;
mod given;
mod labels;
mod layout;
mod lines;
pub(crate) mod names;
mod nearest;
mod numbers;
mod overlaid;
mod paths;
mod plots;
mod posed;
mod roles;
mod slides;
mod wheels;

use assur::mechanism::{LinkId, PointId, Pose, Quantity, Unsolved};
use assur::motion::Motion;
use assur::{Point, Vector};

use crate::annotations::{Annotations, Tag};
use crate::force_arrows::{self, ForceArrow, ForceScale};
use crate::list::{List, Look, Role};
use crate::overlays::{self, Overlays};
use crate::parts::{self, BAR};
use given::Given;
use layout::Layout;
pub use lines::Lines;
use names::Names;
use numbers::Number;
use overlaid::Overlaid;
use paths::Path;
pub use plots::Values;
use posed::Posed;
use slides::Guide;
use wheels::Gearing;

/// Least angle between a name beyond a link's end and the other links at that end, radians.
const MIN_ANGLE: f64 = 0.7;

/// View of a linkage: everything that is drawn in addition to its links.
#[derive(Clone, Debug, Default)]
pub struct View {
    /// Overlays of the drawing.
    pub overlays: Overlays,
    /// Points in addition to the linkage's traced points. Their paths are drawn with
    /// [`Overlays::traces`], their derivatives with [`Overlays::vectors`].
    pub traced: Vec<PointId>,
    /// Instant centres, centrodes and circles of curvature.
    pub lines: Lines,
    /// Distances between points and angles between links to be shown.
    pub measures: Vec<Quantity>,
    /// Annotations of the document.
    pub annotations: Annotations,
    /// Names of forces, to which their arrows refer by index.
    pub forces: Vec<String>,
    /// The symbol unit, in the unit of lengths; by default a hundredth of the drawing's size.
    pub symbol: Option<f64>,
}

impl View {
    /// Returns the annotated symbol of a loop vector or, without one, the names of the vector's two points.
    fn symbol(&self, ends: &[String; 2]) -> String {
        let [from, to] = ends;
        let mut noted = self.annotations.loop_vectors.iter();
        let same = |[a, b]: &[String; 2]| (a, b) == (from, to) || (a, b) == (to, from);
        let noted = noted.find(|(points, _)| same(points));
        noted.map_or_else(|| ends.concat(), |(_, symbol)| symbol.clone())
    }
}

/// Turns a direction away from the nearest of other directions until it is at least [`MIN_ANGLE`] from it.
fn clear_of(others: impl Iterator<Item = Vector>, direction: Vector) -> Vector {
    let angle = |other: Vector| other.perp(&direction).atan2(other.dot(&direction));
    let nearest = others
        .filter(|other| other.norm() > 0.0)
        .map(angle)
        .reduce(|a, b| if b.abs() < a.abs() { b } else { a });
    let by = nearest.map_or(0.0, |off| (MIN_ANGLE - off.abs()).max(0.0).copysign(off));
    layout::turned(direction, by)
}

/// A point with the parts of its path.
type Ways = (PointId, Vec<Path>);

/// The drawing of a linkage. Whatever moves with the bodies is drawn once, in the coordinates of the bodies; then only
/// the poses of the bodies change. Body 0 is the frame. Next come the links, each with its first point as origin and
/// turned through its angle, then the idlers.
#[derive(Clone, Debug)]
pub struct Figure {
    motion: Motion,
    layout: Layout,
    gearing: Gearing,
    names: Names,
    overlaid: Overlaid,
    lines: lines::Drawn,
    numbers: Vec<Number>,
    given: Given,
    /// Indices of the names of forces among the names.
    forces: Vec<usize>,
    /// Wheel numbers, each with the wheel's link, the tag, and the index of the tag's text among the names.
    tags: Vec<(LinkId, Tag, usize)>,
    bounds: [f64; 4],
    /// The symbol unit.
    unit: f64,
    rigid: List,
}

impl Figure {
    /// Makes the drawing of a mechanism over its motion.
    ///
    /// # Errors
    /// The reason why there is no pose in which to draw the mechanism.
    pub fn new(motion: &Motion, view: &View) -> Result<Self, Unsolved> {
        let mechanism = motion.mechanism();
        let home = motion.pose::<1>(motion.drawn_input())?;
        let posed = |pose| Posed { mechanism, pose };
        let home = posed(&home);
        let layout = Layout::new(home, view);
        let gearing = Gearing::new(&layout, home, view);
        let mut names = Names::new(mechanism);
        let tags = view.annotations.tags.iter().filter_map(|tag| {
            let link = mechanism.link(&tag.link)?;
            Some((link, tag.clone(), names.add(tag.text.clone())))
        });
        let tags = tags.collect();
        let mut overlaid = Overlaid::new(motion, &layout, home, view, &mut names);
        let mut lines = lines::Drawn::new(mechanism, &layout, view, &mut names);
        let numbers = if view.overlays.numbers {
            numbers::numbers(home, &layout, view, &mut names)
        } else {
            Vec::new()
        };
        let given = Given::new(&view.annotations, &mut names);
        let forces = view.forces.iter().map(|name| names.add(name.clone()));
        let forces = forces.collect();

        let runs = paths::sampled(motion);
        let guides = slides::guides(&layout, home, &runs, view);
        let path = |point: PointId| (point, paths::path(motion, &layout, &runs, point));
        let points = mechanism.point_ids();
        let (tracers, listed): (Vec<PointId>, Vec<PointId>) =
            points.partition(|point| layout.is_tracer(*point));
        let (moving, fixed): (Vec<PointId>, Vec<PointId>) =
            listed.iter().partition(|point| layout.moves(**point));
        let drawn = moving.iter().filter(|point| layout.is_drawn(**point));
        let ways: Vec<Ways> = drawn.copied().map(path).collect();
        let tracers = tracers.into_iter().filter(|point| layout.moves(*point));
        let traced: Vec<Ways> = tracers.map(path).collect();

        let joints = ways
            .iter()
            .flat_map(|(_, paths)| paths)
            .flat_map(Path::reach);
        let fixed = fixed.into_iter();
        let fixed: Vec<PointId> = fixed.filter(|point| layout.is_drawn(*point)).collect();
        let poses = runs.iter().flatten();
        let wheels = poses.flat_map(|(_, pose)| gearing.reach(posed(pose)));
        let rails = guides.iter().flat_map(Guide::on_frame);
        let base = bounds::around(
            joints
                .chain(wheels)
                .chain(rails)
                .chain(given.reach())
                .chain(fixed.iter().map(|point| home.place(*point))),
        );
        let size = bounds::size(base);
        let unit = view.symbol.unwrap_or(size / 100.0);
        let supports = mechanism.point_ids().filter_map(|point| {
            let size = layout.support(point)?;
            Some(parts::support_reach(home.place(point), size * unit))
        });
        let symbols = supports.flatten();
        let symbols = symbols.chain(guides.iter().flat_map(|guide| guide.reach(unit)));
        let ground = slides::ground(base, size, view.annotations.ground);
        let base = bounds::grown(base, symbols.chain(ground.into_iter().flatten()), size);
        let curves = traced
            .iter()
            .flat_map(|(_, paths)| paths)
            .flat_map(Path::reach);
        let tips = overlaid.scale(motion, size);
        lines.within(base);
        let mut figure = Self {
            motion: motion.clone(),
            bounds: bounds::grown(base, curves.chain(tips), size),
            unit,
            layout,
            gearing,
            names,
            overlaid,
            lines,
            numbers,
            given,
            forces,
            tags,
            rigid: List::default(),
        };
        let asked = |point: &PointId| view.overlays.traces && view.traced.contains(point);
        let asked = moving.into_iter().filter(asked);
        let seen: Vec<Ways> = asked
            .map(|point| (point, paths::path(motion, &figure.layout, &runs, point)))
            .chain(traced)
            .collect();
        figure.draw(home, &guides, ground, &seen, view);
        Ok(figure)
    }

    /// Whether a point has its own symbol, as joints, traced points and shown centres of mass do.
    pub fn is_drawn(&self, point: PointId) -> bool {
        self.layout.is_drawn(point)
    }

    /// Returns the display list of whatever moves with the bodies.
    pub fn rigid(&self) -> &List {
        &self.rigid
    }

    /// Returns the rectangle that holds the drawing in every pose: left, bottom, right, top. Overlays that grow without
    /// bound may extend beyond it.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Returns the texts to which labels refer by index: the names of the points, then symbols. A symbol may be
    /// followed by a tab and the name of a read-out, as in `μ` and `C.transmission`; `input` names the input. The value
    /// of the read-out is then written after the symbol.
    pub fn names(&self) -> &[String] {
        self.names.all()
    }

    /// Returns the role of a link, whose colour it has in plots, and in drawings without [`Overlays::groups`].
    pub fn role(&self, link: LinkId) -> Role {
        self.layout.role(link)
    }

    /// Returns the role of a link in the drawing.
    pub fn drawn_role(&self, link: LinkId) -> Role {
        self.layout.drawn_role(link)
    }

    /// Returns the roles of drivers, Assur groups and doubled links, in the order of
    /// [`Mechanism::terms`](assur::mechanism::Mechanism::terms).
    pub fn term_roles(&self) -> impl Iterator<Item = Role> {
        roles::of_terms(self.motion.mechanism())
    }

    /// Returns what changes with the pose: `n, x₀, y₀, θ₀, …`, the number n of bodies and the pose of each, then a
    /// display list in the coordinates of the frame. Derivatives are drawn if the pose has at least two (`N` ≥ 3).
    pub fn frame<const N: usize>(&self, pose: &Pose<N>) -> Vec<f32> {
        self.frame_beside(pose, &[])
    }

    /// Returns the same as [`Figure::frame`], with other assemblies drawn dashed behind the names.
    pub fn frame_beside<const N: usize>(&self, pose: &Pose<N>, others: &[Pose<1>]) -> Vec<f32> {
        let posed = self.posed(pose);
        let mut list = List::default();
        for other in others {
            beside::draw(&mut list, &self.layout, self.posed(other));
        }
        self.label(&mut list, posed);
        self.overlaid.draw(&mut list, posed, self.unit);
        self.lines.draw(&mut list, posed, self.unit);
        let mut numbers = self.bodies(pose);
        numbers.extend(list.numbers());
        numbers
    }

    /// Adds arrows of forces to a frame.
    pub fn add_forces(&self, frame: &mut Vec<f32>, arrows: &[ForceArrow], scale: ForceScale) {
        let mut list = List::default();
        force_arrows::draw(&mut list, arrows, scale, &self.forces, self.unit);
        frame.extend(list.numbers());
    }

    /// Returns the radius with which the friction circle of a hinge is drawn: the true one, unless it is too small to
    /// be seen.
    pub fn drawn_circle(&self, radius: f64) -> f64 {
        force_arrows::drawn_radius(radius, self.unit)
    }

    /// Returns the size of the drawing, in the unit of lengths.
    pub fn size(&self) -> f64 {
        bounds::size(self.bounds)
    }

    /// Returns the poses of the bodies, with which a frame begins: `n, x₀, y₀, θ₀, …`.
    pub fn bodies<const N: usize>(&self, pose: &Pose<N>) -> Vec<f32> {
        let posed = self.posed(pose);
        let links = posed.mechanism.link_ids();
        let mut poses = vec![(Point::origin(), 0.0)];
        poses.extend(links.map(|link| posed.body(Some(link))));
        poses.extend(self.gearing.idlers(posed));
        let count = [poses.len() as f32];
        let poses = poses.iter().flat_map(|(at, angle)| [at.x, at.y, *angle]);
        count.into_iter().chain(poses.map(|x| x as f32)).collect()
    }

    fn draw(
        &mut self,
        home: Posed<'_, 1>,
        guides: &[Guide],
        ground: Option<[Point; 3]>,
        seen: &[Ways],
        view: &View,
    ) {
        let (u, mechanism) = (self.unit, home.mechanism);
        let mut list = List::default();
        for (point, paths) in seen {
            let link = self.layout.carrier(*point);
            let role = link.map_or(Role::Secondary, |link| self.layout.drawn_role(link));
            for path in paths {
                path.draw(&mut list, role);
            }
        }
        self.given.draw(&mut list, u);
        if let Some([from, to, _]) = ground {
            parts::hatched(&mut list, [from, to], -Vector::y(), u);
        }
        for guide in guides {
            guide.draw_line(&mut list, u);
        }
        for guide in guides {
            guide.empty(&mut list, u);
        }
        list.body(0);
        let points = mechanism.point_ids();
        for point in points.clone() {
            if let Some(size) = self.layout.support(point) {
                parts::support(&mut list, home.place(point), size * u);
            }
        }
        for centre in self.gearing.fixed_idlers() {
            parts::support(&mut list, centre, u);
        }
        self.gearing.draw(&mut list, u);
        // Links are drawn in reverse order, so that the first link, usually the crank, is on top.
        for link in mechanism.link_ids().rev() {
            list.body(layout::number(Some(link)));
            let (role, outline) = (self.layout.drawn_role(link), self.layout.outline(link));
            let mut slots = guides.iter().filter(|guide| guide.is_slot_of(link));
            if let Some(slot) = slots.next() {
                slot.draw_slot(&mut list, outline, BAR * u, u);
                continue;
            }
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
        for point in points.filter(|point| self.layout.is_drawn(*point)) {
            let link = self.layout.link_of(point);
            list.body(layout::number(link));
            let at = home.local(link, point);
            let role = link.map_or(Role::Secondary, |link| self.layout.drawn_role(link));
            if self.layout.is_joint(point) {
                parts::hinge(&mut list, at, 1.1 * u);
            } else if self.layout.is_tracer(point) {
                parts::tracer(&mut list, role, at, u);
            } else if self.layout.is_centre(point) {
                overlays::mass(&mut list, at, u);
            } else {
                list.circle(role, Look::Solid, at, 0.6 * u);
            }
        }
        if view.overlays.centres {
            for (link, at) in self.layout.middles(mechanism) {
                list.body(layout::number(Some(link)));
                overlays::mass(&mut list, at, u);
            }
        }
        for number in &self.numbers {
            number.draw(&mut list, u);
        }
        self.lines.draw_rigid(&mut list, &self.motion);
        self.rigid = list;
    }
}
