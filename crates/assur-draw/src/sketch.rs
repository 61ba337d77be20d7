//! A linkage that is being drawn, where it stands: nothing of it need fit together.

use assur::mechanism::{FRAME, LinkSpec, LinkageSpec, SlideSpec};
use assur::{Point, Vector};

use crate::list::{List, Look, Role};
use crate::parts;

/// Half the width of a link's bar, half the sides of a block, in units, as of a linkage that moves.
const BAR: f64 = 1.15;
/// Half the width of a ring's rim where it is pressed, relative to its radius.
const RIM: f64 = 0.05;
const BLOCK: [f64; 2] = [2.6, 1.7];
/// The sheet of an empty drawing: left, bottom, right, top, in the unit of lengths.
const SHEET: [f64; 4] = [-6.0, -4.0, 6.0, 4.0];
/// Free room around what is drawn, for what comes next, relative to its size.
const ROOM: f64 = 0.15;
/// The least size for symbols, relative to the greatest coordinate: of points in one place.
const LEAST: f64 = 1e-3;
/// A wheel that is in no mesh yet, in units.
const WHEEL: f64 = 5.0;

/// Colours of links in turn.
const ROLES: [Role; 6] = [
    Role::Coupler,
    Role::Rocker,
    Role::Accent2,
    Role::Accent3,
    Role::Accent5,
    Role::Accent6,
];

/// What is said of links in colour, and how large an empty sheet is.
#[derive(Clone, Debug)]
pub struct SketchView {
    /// Links that move by themselves or are joined to nothing.
    pub loose: Vec<String>,
    /// Links that cannot move.
    pub locked: Vec<String>,
    /// The size of the sheet of an empty drawing, relative to that of one without a unit.
    pub sheet: f64,
}

impl Default for SketchView {
    fn default() -> Self {
        Self {
            loose: Vec::new(),
            locked: Vec::new(),
            sheet: 1.0,
        }
    }
}

/// A draft as a drawing. All of it is in the coordinates of the frame.
#[derive(Clone, Debug)]
pub struct Sketch {
    draft: LinkageSpec,
    roles: Vec<Role>,
    names: Vec<String>,
    handles: Vec<(String, Role, Point)>,
    bounds: [f64; 4],
    unit: f64,
    list: List,
}

/// A wheel in a mesh, or in none.
#[derive(Clone, Copy, Debug)]
struct Wheel {
    /// The number of its link.
    link: usize,
    at: Point,
    /// Of the pitch circle.
    radius: f64,
    /// Whether its teeth are inside.
    ring: bool,
}

impl Sketch {
    /// The drawing of a draft. Things that it names and has not are passed over.
    pub fn new(draft: &LinkageSpec, view: &SketchView) -> Self {
        let bounds = bounds(draft, SHEET.map(|side| side * view.sheet));
        let mut sketch = Self {
            roles: roles(draft, view),
            draft: draft.clone(),
            names: Vec::new(),
            handles: Vec::new(),
            unit: (bounds[2] - bounds[0]).hypot(bounds[3] - bounds[1]) / 100.0,
            bounds,
            list: List::default(),
        };
        sketch.list.body(0);
        sketch.draw_frame();
        sketch.draw_wheels();
        sketch.draw_links();
        sketch.draw_blocks();
        sketch.draw_points();
        sketch
    }

    /// The names of the labels, by their numbers.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The rectangle that holds it: left, bottom, right, top; of an empty sheet one to draw on.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// What a hand can take hold of: names of points and tracers, the colours of their links, places.
    pub fn handles(&self) -> &[(String, Role, Point)] {
        &self.handles
    }

    /// The colour of every link, in the draft's order.
    pub fn roles(&self) -> &[Role] {
        &self.roles
    }

    /// As of [`crate::Figure::frame`]: the frame's pose and the display list.
    pub fn frame(&self) -> Vec<f32> {
        let mut numbers = vec![1.0, 0.0, 0.0, 0.0];
        numbers.extend(self.list.numbers());
        numbers
    }

    /// The link drawn nearest to a place, and how far that is from it. Bars, plates and blocks lie over wheels.
    pub fn link_at(&self, place: Point) -> Option<(&str, f64)> {
        let links = self.draft.links.iter().filter_map(|link| {
            let outline = parts::hull(self.corners(link));
            let off = match outline[..] {
                [] => return None,
                [_] if self.is_wheel(link) => return None,
                [at] => (place - at).norm() - BLOCK[1] * self.unit,
                [from, to] => parts::distance(place, from, to) - BAR * self.unit,
                _ => parts::distance_to_plate(place, &outline)? - BAR * self.unit,
            };
            Some((link.name.as_str(), off.max(0.0)))
        });
        let wheels = self.wheels();
        let wheels = wheels.iter().map(|wheel| {
            let name = self.draft.links[wheel.link].name.as_str();
            (name, self.off_wheel(wheel, place))
        });
        links
            .chain(wheels)
            .reduce(|best, next| if next.1 < best.1 { next } else { best })
    }

    /// The smallest wheel that a place is on.
    pub fn wheel_at(&self, place: Point) -> Option<&str> {
        let wheels = self.wheels();
        let wheel = wheels
            .iter()
            .find(|wheel| self.off_wheel(wheel, place) <= 0.0)?;
        Some(&self.draft.links[wheel.link].name)
    }

    /// How far a place is off a wheel: off the disc of a plain one, off the rim of a ring, where its teeth are.
    fn off_wheel(&self, wheel: &Wheel, place: Point) -> f64 {
        let beyond = (place - wheel.at).norm() - wheel.radius;
        let off = if wheel.ring {
            beyond.abs() - (BAR * self.unit).max(RIM * wheel.radius)
        } else {
            beyond
        };
        off.max(0.0)
    }

    /// Whether a link is a wheel alone, without a bar or a block.
    fn is_wheel(&self, link: &LinkSpec) -> bool {
        let mut slides = self.draft.slides.iter();
        link.points.len() == 1 && !slides.any(|slide| slide.link == link.name)
    }

    fn place(&self, name: &str) -> Option<Point> {
        let mut points = self.draft.points.iter();
        points
            .find(|point| point.name == name)
            .map(|point| point.at)
    }

    /// The corners of a link, without its centre of mass.
    fn corners(&self, link: &LinkSpec) -> Vec<Point> {
        let centre = |name: &&String| link.centre_of_mass.as_ref() != Some(name);
        let own = link.points.iter().filter(centre);
        own.filter_map(|name| self.place(name)).collect()
    }

    fn role(&self, name: &str) -> Role {
        let mut links = self.draft.links.iter().zip(&self.roles);
        links
            .find(|(link, _)| link.name == name)
            .map_or(Role::Secondary, |(_, role)| *role)
    }

    /// Whether the frame has a point that is seen: not one that only gives a line.
    fn is_support(&self, name: &String) -> bool {
        let lines = self.draft.slides.iter().filter(|slide| slide.on == FRAME);
        let of_line = lines.flat_map(|slide| &slide.line).any(|end| end == name);
        let of_link = self
            .draft
            .links
            .iter()
            .any(|link| link.points.contains(name));
        self.draft.frame.contains(name) && (of_link || !of_line)
    }

    fn draw_frame(&mut self) {
        let u = self.unit;
        for slide in self.draft.slides.clone() {
            if slide.on != FRAME {
                continue;
            }
            if let Some([from, to]) = self.line(&slide) {
                let along = (to - from).normalize();
                let across = Vector::new(along.y, -along.x);
                let down = if across.y > 0.0 { -across } else { across };
                let wall = [from - along * (5.0 * u), to + along * (5.0 * u)];
                let wall = wall.map(|end| end + down * (BLOCK[1] * u));
                parts::hatched(&mut self.list, wall, down, u);
            }
        }
        for name in self.draft.frame.clone() {
            if let Some(at) = self.place(&name).filter(|_| self.is_support(&name)) {
                parts::support(&mut self.list, at, 1.5 * u);
            }
        }
    }

    /// The ends of a slide's line, where they are apart.
    fn line(&self, slide: &SlideSpec) -> Option<[Point; 2]> {
        let [from, to] = [self.place(&slide.line[0])?, self.place(&slide.line[1])?];
        ((to - from).norm() > 0.0).then_some([from, to])
    }

    fn draw_wheels(&mut self) {
        for wheel in self.wheels().into_iter().rev() {
            let role = self.roles[wheel.link];
            self.list.circle(role, Look::Pale, wheel.at, wheel.radius);
        }
    }

    /// The wheels, one for each mesh, the smallest first. One in no mesh has a radius of its own.
    fn wheels(&self) -> Vec<Wheel> {
        let of = |name: &str| {
            let links = self.draft.links.iter();
            let (at, link) = links.enumerate().find(|(_, link)| link.name == name)?;
            Some((at, self.place(link.points.first()?)?))
        };
        let mut wheels = Vec::new();
        for gear in &self.draft.gears {
            let [one, other] = &gear.links;
            if let (Some((one, a)), Some((other, b))) = (of(one), of(other)) {
                let [z1, z2] = gear.teeth;
                let internal = matches!(gear.mesh, assur::gears::Mesh::Internal);
                let sum = if internal { (z1 - z2).abs() } else { z1 + z2 };
                let module = (b - a).norm() / sum;
                for (link, at, z, mate) in [(one, a, z1, z2), (other, b, z2, z1)] {
                    wheels.push(Wheel {
                        link,
                        at,
                        radius: module * z,
                        ring: internal && z > mate,
                    });
                }
            }
        }
        for link in self.draft.links.iter().filter(|link| self.is_wheel(link)) {
            let mut gears = self.draft.gears.iter();
            let meshes = gears.any(|gear| gear.links.contains(&link.name));
            if let (false, Some((link, at))) = (meshes, of(&link.name)) {
                wheels.push(Wheel {
                    link,
                    at,
                    radius: WHEEL * self.unit,
                    ring: false,
                });
            }
        }
        wheels.retain(|wheel| wheel.radius.is_finite());
        wheels.sort_by(|one, other| one.radius.total_cmp(&other.radius));
        wheels
    }

    fn draw_links(&mut self) {
        for (link, role) in self.draft.links.iter().zip(&self.roles).rev() {
            match parts::hull(self.corners(link))[..] {
                [] | [_] => {}
                [from, to] => parts::bar(&mut self.list, *role, from, to, BAR * self.unit),
                ref outline => parts::plate(&mut self.list, *role, outline, BAR * self.unit),
            }
        }
    }

    fn draw_blocks(&mut self) {
        for slide in &self.draft.slides {
            let (Some(at), Some([from, to])) = (self.place(&slide.point), self.line(slide)) else {
                continue;
            };
            let along = (to - from).normalize();
            let across = Vector::new(-along.y, along.x);
            let middle = from + along * (at - from).dot(&along);
            let half = [
                along * (BLOCK[0] * self.unit),
                across * (BLOCK[1] * self.unit),
            ];
            let corners = parts::rectangle(middle, half);
            let role = self.role(&slide.link);
            if (at - middle).norm() > 0.1 * self.unit {
                parts::bar(&mut self.list, role, at, middle, 0.9 * self.unit);
            }
            self.list
                .polygons(Role::Paper, Look::Solid, std::slice::from_ref(&corners));
            self.list.polygons(role, Look::Pale, &[corners]);
        }
    }

    fn draw_points(&mut self) {
        let u = self.unit;
        for point in &self.draft.points {
            let links: Vec<&LinkSpec> = (self.draft.links.iter())
                .filter(|link| link.points.contains(&point.name))
                .collect();
            let frame = self.draft.frame.contains(&point.name);
            if links.is_empty() && frame && !self.is_support(&point.name) {
                // The end of a guide can be moved.
                self.handles
                    .push((point.name.clone(), Role::Secondary, point.at));
                self.list
                    .circle(Role::Secondary, Look::Solid, point.at, 0.5 * u);
                continue;
            }
            let role = links
                .first()
                .map_or(Role::Ink, |link| self.role(&link.name));
            let centre = |link: &&LinkSpec| link.centre_of_mass.as_ref() == Some(&point.name);
            if links.iter().all(centre) && !links.is_empty() {
                crate::overlays::mass(&mut self.list, point.at, u);
            } else if links.len() + usize::from(frame) > 1 {
                parts::hinge(&mut self.list, point.at, 1.1 * u);
            } else {
                self.list.circle(role, Look::Hollow, point.at, 0.8 * u);
            }
            let others = links.iter().flat_map(|link| self.corners(link));
            let away = others
                .map(|other| point.at - other)
                .filter(|off| off.norm() > 0.0);
            let away: Vector = away.map(|off| off.normalize()).sum();
            let off = if frame {
                [-1.5, -0.2]
            } else if away.norm() > 1e-3 {
                (away.normalize() * 1.5).into()
            } else {
                [-1.0, 1.1]
            };
            self.list.name(Role::Ink, self.names.len(), point.at, off);
            self.names.push(point.name.clone());
            self.handles.push((point.name.clone(), role, point.at));
        }
        for tracer in &self.draft.tracers {
            let Some(at) = self.traced(&tracer.link, tracer.at) else {
                continue;
            };
            let role = self.role(&tracer.link);
            parts::tracer(&mut self.list, role, at, u);
            self.list.name(Role::Ink, self.names.len(), at, [1.2, 0.9]);
            self.names.push(tracer.name.clone());
            self.handles.push((tracer.name.clone(), role, at));
        }
    }

    /// Where a place of a link's own coordinates is drawn.
    fn traced(&self, link: &str, at: Vector) -> Option<Point> {
        let mut links = self.draft.links.iter();
        let points = &links.find(|one| one.name == link)?.points;
        let first = self.place(points.first()?)?;
        let second = points.get(1).and_then(|name| self.place(name));
        let along = second.map_or(Vector::x(), |second| second - first);
        let along = along.try_normalize(0.0)?;
        Some(first + along * at.x + Vector::new(-along.y, along.x) * at.y)
    }
}

/// The colour of a link: the crank's if it is driven, that of its state if it is loose or locked, else the next one.
fn roles(draft: &LinkageSpec, view: &SketchView) -> Vec<Role> {
    let driven = |name: &str| {
        draft
            .drivers
            .iter()
            .any(|driver| draft.driven(driver) == Some(name))
    };
    let mut turn = ROLES.into_iter().cycle();
    let role = |link: &LinkSpec| {
        let own = if driven(&link.name) {
            Role::Crank
        } else {
            turn.next().unwrap_or(Role::Coupler)
        };
        if view.locked.contains(&link.name) {
            Role::Locked
        } else if view.loose.contains(&link.name) {
            Role::Loose
        } else {
            own
        }
    };
    draft.links.iter().map(role).collect()
}

/// The rectangle around all points, with room; a sheet where there are too few.
fn bounds(draft: &LinkageSpec, sheet: [f64; 4]) -> [f64; 4] {
    let places = draft.points.iter().map(|point| point.at.coords);
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY].map(Vector::repeat);
    for place in places {
        low = low.inf(&place);
        high = high.sup(&place);
    }
    let size = (high - low).norm();
    let far = low.amax().max(high.amax());
    if !size.is_finite() {
        return sheet;
    }
    if size <= LEAST * far || size == 0.0 {
        let [x, y] = [low.x, low.y];
        return [sheet[0] + x, sheet[1] + y, sheet[2] + x, sheet[3] + y];
    }
    let room = Vector::repeat(ROOM * size);
    let [low, high] = [low - room, high + room];
    [low.x, low.y, high.x, high.y]
}

#[cfg(test)]
mod tests;
