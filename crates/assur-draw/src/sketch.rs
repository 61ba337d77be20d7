//! The drawing of an unfinished linkage, whose links, slides and gears need not fit together.

mod drawing;

use assur::mechanism::{FRAME, LinkSpec, LinkageSpec, SlideSpec};
use assur::{Point, Vector};

use crate::list::{IN_TURN, List, Look, Role};
use crate::parts::{self, BAR, BLOCK};

/// Half the width of the band along a ring's rim in which the ring can be picked, relative to the ring's radius.
const RIM: f64 = 0.05;
/// Rectangle of an empty drawing: left, bottom, right, top, in the unit of lengths.
const SHEET: [f64; 4] = [-6.0, -4.0, 6.0, 4.0];
/// Free margin around the drawing, for new links, relative to the drawing's size.
const ROOM: f64 = 0.15;
/// Extent of all points, relative to their greatest coordinate, up to which they count as coincident.
const COINCIDENT: f64 = 1e-3;
/// Radius of a wheel that is not yet in mesh, in symbol units.
const WHEEL: f64 = 5.0;

/// View of a sketch: links in special colours, and the size of an empty sheet.
#[derive(Clone, Debug)]
pub struct SketchView {
    /// Links whose motion the drivers do not determine, or that nothing joins to the frame.
    pub loose: Vec<String>,
    /// Links that cannot move.
    pub locked: Vec<String>,
    /// Size of the sheet of an empty drawing, relative to the default size.
    pub sheet: f64,
    /// The symbol unit, in the unit of lengths; by default a hundredth of the drawing's size.
    pub symbol: Option<f64>,
}

impl Default for SketchView {
    fn default() -> Self {
        Self {
            loose: Vec::new(),
            locked: Vec::new(),
            sheet: 1.0,
            symbol: None,
        }
    }
}

/// The drawing of a draft, in the coordinates of the frame.
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

/// A wheel, in mesh or not.
#[derive(Clone, Copy, Debug)]
struct Wheel {
    /// Index of the link to which the wheel belongs.
    link: usize,
    at: Point,
    /// Radius of the pitch circle.
    radius: f64,
    /// Whether the wheel is a ring, with teeth on the inside.
    ring: bool,
}

impl Sketch {
    /// Draws a draft. Unknown names are ignored.
    pub fn new(draft: &LinkageSpec, view: &SketchView) -> Self {
        let bounds = bounds(draft, SHEET.map(|side| side * view.sheet));
        let mut sketch = Self {
            roles: roles(draft, view),
            draft: draft.clone(),
            names: Vec::new(),
            handles: Vec::new(),
            unit: (view.symbol)
                .unwrap_or_else(|| (bounds[2] - bounds[0]).hypot(bounds[3] - bounds[1]) / 100.0),
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

    /// Returns the names to which labels refer by index.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Returns the rectangle around the drawing, or an empty sheet if it has no points: left, bottom, right, top.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Returns the handles: names of points and traced points, colours of their links, and positions.
    pub fn handles(&self) -> &[(String, Role, Point)] {
        &self.handles
    }

    /// Returns the colours of the links, in the order of the draft.
    pub fn roles(&self) -> &[Role] {
        &self.roles
    }

    /// Returns the pose of the frame and the display list, as [`crate::Figure::frame`] does.
    pub fn frame(&self) -> Vec<f32> {
        let mut numbers = vec![1.0, 0.0, 0.0, 0.0];
        numbers.extend(self.list.numbers());
        numbers
    }

    /// Finds the link drawn nearest to a point, and its distance. At equal distances, bars, blocks and plates take
    /// precedence over wheels.
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

    /// Finds the smallest wheel at a point.
    pub fn wheel_at(&self, place: Point) -> Option<&str> {
        let wheels = self.wheels();
        let wheel = wheels
            .iter()
            .find(|wheel| self.off_wheel(wheel, place) <= 0.0)?;
        Some(&self.draft.links[wheel.link].name)
    }

    /// Returns the distance of a point from the disc of a plain wheel, or from the toothed rim of a ring.
    fn off_wheel(&self, wheel: &Wheel, place: Point) -> f64 {
        let beyond = (place - wheel.at).norm() - wheel.radius;
        let off = if wheel.ring {
            beyond.abs() - (BAR * self.unit).max(RIM * wheel.radius)
        } else {
            beyond
        };
        off.max(0.0)
    }

    /// Whether a link consists of a wheel alone, without a bar or a block.
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

    /// Returns the corners of a link, without its centre of mass.
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

    /// Whether a support is drawn at a point of the frame; not if the point only defines a slide's line.
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
}

/// Returns the colours of the links: those for locked, loose and driven links, or else the next colour in turn. Without
/// a driver, the first link on the frame is passed over in the sequence, because it is the likeliest to be driven: the
/// colours of the others then stay the same when a driver is added.
fn roles(draft: &LinkageSpec, view: &SketchView) -> Vec<Role> {
    let driven = |name: &str| {
        draft
            .drivers
            .iter()
            .any(|driver| draft.driven(driver) == Some(name))
    };
    let on_frame = |link: &&LinkSpec| {
        link.points.len() > 1 && link.points.iter().any(|point| draft.frame.contains(point))
    };
    let undriven = draft
        .links
        .iter()
        .find(on_frame)
        .filter(|_| draft.drivers.is_empty());
    let mut turn = IN_TURN.into_iter().cycle();
    let role = |link: &LinkSpec| {
        let own = if driven(&link.name) {
            Role::Crank
        } else if undriven.is_some_and(|first| first.name == link.name) {
            Role::Accent4
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

/// Returns the rectangle around all points, with a margin; if there are none, or all coincide, an empty sheet.
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
    if size <= COINCIDENT * far || size == 0.0 {
        let [x, y] = [low.x, low.y];
        return [sheet[0] + x, sheet[1] + y, sheet[2] + x, sheet[3] + y];
    }
    let room = Vector::repeat(ROOM * size);
    let [low, high] = [low - room, high + room];
    [low.x, low.y, high.x, high.y]
}

#[cfg(test)]
mod tests;
