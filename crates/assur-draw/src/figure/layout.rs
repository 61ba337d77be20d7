//! Points and links as they are drawn: joints, supports, bars, plates.

use assur::mechanism::{FRAME, LinkId, LinkOrFrame, Mechanism, PointId, SlideSpec};
use assur::{Point, Vector};

use super::posed::Posed;
use super::{View, roles};
use crate::list::Role;
use crate::parts;

/// Half-angle of the sector beyond a link's end, radians. A name fits into the sector if no other point of the link
/// lies in it.
const BEYOND: f64 = 0.9;

/// Pose-independent features of the drawing. Bodies are the frame and the links that are not fixed to another body.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    roles: Vec<Role>,
    drawn_roles: Vec<Role>,
    outlines: Vec<Vec<Point>>,
    bars: Vec<bool>,
    /// Whether the centre of mass of each link is given.
    weighed: Vec<bool>,
    points: Vec<Pinned>,
}

/// A point as it is drawn.
#[derive(Clone, Debug)]
struct Pinned {
    /// Bodies to which the point belongs.
    bodies: Vec<LinkOrFrame>,
    /// First link that lists the point.
    link: LinkOrFrame,
    /// Whether a link carries the point and the point joins nothing.
    tracer: bool,
    centre: bool,
    /// Whether the point, if a centre of mass, is shown.
    shown: bool,
    block: bool,
    /// Whether the point is on the line of a slot.
    slot: bool,
    /// Whether the point is a plain shaft: its links are all wheels with a number and with no other point.
    shaft: bool,
    /// A link that turns the point about a fixed point, and this fixed point.
    pivot: Option<(LinkId, PointId)>,
    /// Whether the point is the far end of the link that turns it.
    end: bool,
    neighbours: Vec<PointId>,
}

impl Layout {
    pub(super) fn new(home: Posed<'_, 1>, view: &View) -> Self {
        let mechanism = home.mechanism;
        let points = mechanism.point_ids();
        let points = points.map(|point| pinned(home, view, point));
        let roles = roles::own(mechanism, &view.annotations);
        let links = mechanism.spec().links.iter();
        let mut layout = Self {
            drawn_roles: if view.overlays.groups {
                roles::of_groups(mechanism)
            } else {
                roles.clone()
            },
            roles,
            outlines: Vec::new(),
            bars: Vec::new(),
            weighed: links.map(|link| link.centre_of_mass.is_some()).collect(),
            points: points.collect(),
        };
        for link in mechanism.link_ids() {
            let joints = mechanism.points_of(link).iter();
            let joints = joints.filter(|point| layout.is_joint(**point)).count();
            layout.bars.push(joints > 1);
            layout.outlines.push(layout.outlined(home, link));
        }
        layout
    }

    /// Returns the corners of a link: one for a bare wheel or block, two for a bar, three or more for a plate, none for
    /// a link that is fixed to another and has no points of its own.
    fn outlined(&self, home: Posed<'_, 1>, link: LinkId) -> Vec<Point> {
        let mechanism = home.mechanism;
        let own = mechanism.points_of(link).iter();
        let own: Vec<PointId> = own
            .copied()
            .filter(|point| self.is_joint(*point) || !self.is_centre(*point))
            .collect();
        let fixed = mechanism.spec().links[link.index()].fixed_to.is_some();
        let listed = |point: &PointId| self.link_of(*point) != Some(link);
        if fixed && own.iter().all(listed) {
            return Vec::new();
        }
        let places = own.iter().map(|point| home.local(Some(link), *point));
        parts::hull(places.collect())
    }

    /// Returns the link's own colour, which identifies it in plots.
    pub(super) fn role(&self, link: LinkId) -> Role {
        self.roles[link.index()]
    }

    /// Returns the colour in which a link is drawn: its own, or that of its Assur group.
    pub(super) fn drawn_role(&self, link: LinkId) -> Role {
        self.drawn_roles[link.index()]
    }

    pub(super) fn outline(&self, link: LinkId) -> &[Point] {
        &self.outlines[link.index()]
    }

    /// Returns the centres of mass assumed for links without a given one: the middle of a bar, the centroid of a plate.
    pub(super) fn middles(&self, mechanism: &Mechanism) -> impl Iterator<Item = (LinkId, Point)> {
        let own = mechanism.link_ids().filter(|link| {
            let weighed = self.weighed[link.index()];
            mechanism.root_of(*link) == Some(*link) && !weighed
        });
        own.filter_map(|link| Some((link, parts::centroid(self.outline(link))?)))
    }

    /// Whether a link has two hinges or more.
    pub(super) fn is_bar(&self, link: LinkId) -> bool {
        self.bars[link.index()]
    }

    /// Returns the first link that lists a point.
    pub(super) fn link_of(&self, point: PointId) -> LinkOrFrame {
        self.points[point.index()].link
    }

    /// Whether a point is a traced point: a link carries it, and it joins nothing.
    pub(super) fn is_tracer(&self, point: PointId) -> bool {
        self.points[point.index()].tracer
    }

    /// Returns a link that turns a point about a fixed point, and this fixed point.
    pub(super) fn pivot(&self, point: PointId) -> Option<(LinkId, PointId)> {
        self.points[point.index()].pivot
    }

    /// Returns the fixed point about which a joint turns, if the name of the joint fits beyond the link's end.
    pub(super) fn end_of(&self, point: PointId) -> Option<PointId> {
        let pinned = &self.points[point.index()];
        let ends = pinned.end && self.is_joint(point);
        pinned.pivot.filter(|_| ends).map(|(_, pivot)| pivot)
    }

    /// Returns the link that colours a point: the one that turns it about a fixed point, else the first that lists it.
    pub(super) fn carrier(&self, point: PointId) -> LinkOrFrame {
        let turned = self.pivot(point).map(|(link, _)| link);
        turned.or(self.link_of(point))
    }

    pub(super) fn neighbours(&self, point: PointId) -> &[PointId] {
        &self.points[point.index()].neighbours
    }

    /// Whether bodies are hinged at a point. A plain shaft does not count, because it is drawn with its wheel.
    pub(super) fn is_joint(&self, point: PointId) -> bool {
        self.points[point.index()].bodies.len() > 1 && !self.is_shaft(point)
    }

    pub(super) fn is_shaft(&self, point: PointId) -> bool {
        self.points[point.index()].shaft
    }

    /// Whether a body is hinged to the frame at a point.
    pub(super) fn is_support(&self, point: PointId) -> bool {
        self.is_joint(point) && !self.moves(point)
    }

    /// Returns the size of the support of a fixed pivot, in symbol units; it is smaller under the shaft of a wheel.
    /// None for other points.
    pub(super) fn support(&self, point: PointId) -> Option<f64> {
        let fixed = !self.moves(point);
        let of_links = self.is_joint(point).then_some(1.5);
        of_links
            .or(self.is_shaft(point).then_some(1.0))
            .filter(|_| fixed)
    }

    /// Whether a point does not belong to the frame.
    pub(super) fn moves(&self, point: PointId) -> bool {
        !self.points[point.index()].bodies.contains(&None)
    }

    pub(super) fn is_centre(&self, point: PointId) -> bool {
        self.points[point.index()].centre
    }

    /// Whether a block or a slot is drawn around a point.
    pub(super) fn is_wide(&self, point: PointId) -> bool {
        let pinned = &self.points[point.index()];
        pinned.block || pinned.slot
    }

    /// Whether a point is visible. Points that only define a line of the frame, hidden centres of mass and plain shafts
    /// are not.
    pub(super) fn is_drawn(&self, point: PointId) -> bool {
        let hidden = self.is_centre(point) && !self.points[point.index()].shown;
        let seen = !hidden || self.is_joint(point);
        let on_link = self.link_of(point).is_some() || self.is_tracer(point);
        seen && on_link && !self.is_shaft(point)
    }

    /// Finds a point at which two bodies are hinged to each other.
    pub(super) fn hinge(
        &self,
        mechanism: &Mechanism,
        a: LinkOrFrame,
        b: LinkOrFrame,
    ) -> Option<PointId> {
        let both = |pinned: &Pinned| pinned.bodies.contains(&a) && pinned.bodies.contains(&b);
        let mut points = mechanism.point_ids().zip(&self.points);
        points.find_map(|(point, pinned)| both(pinned).then_some(point))
    }
}

fn pinned(home: Posed<'_, 1>, view: &View, point: PointId) -> Pinned {
    let mechanism = home.mechanism;
    let draft = mechanism.spec();
    let mut links = lists(mechanism, point);
    let mut bodies: Vec<LinkOrFrame> = Vec::new();
    if is_fixed(mechanism, point) {
        bodies.push(None);
    }
    let mut neighbours = Vec::new();
    for link in &links {
        let body = mechanism.root_of(*link);
        if !bodies.contains(&body) {
            bodies.push(body);
        }
        let others = mechanism.points_of(*link).iter().copied();
        neighbours.extend(others.filter(|other| *other != point));
    }
    let first = links.first().copied();
    // A link that is only a wheel has its centre as its only point.
    let tags = &view.annotations.tags;
    let plain = |link: &LinkId| {
        let name = mechanism.link_name(*link);
        tags.iter().any(|tag| tag.link == name) && mechanism.points_of(*link) == [point]
    };
    let shaft = !links.is_empty() && links.iter().all(plain);
    let moves = !bodies.contains(&None);
    links.retain(|_| moves);
    let pivots = links.iter().filter_map(|link| {
        let pivot = pivot_of(mechanism, *link)?;
        Some((*link, pivot))
    });
    let fixed = |link: LinkId| mechanism.root_of(link) != Some(link);
    let pivot = pivots.min_by_key(|(link, _)| fixed(*link));
    let name = mechanism.point_name(point);
    let slotted = |slide: &SlideSpec| {
        slide.line.iter().any(|end| end == name) && slides(mechanism, &slide.on)
    };
    let mut centres = draft
        .links
        .iter()
        .filter_map(|link| link.centre_of_mass.as_ref());
    Pinned {
        shown: view.overlays.centres || view.traced.contains(&point),
        tracer: mechanism.tracer(point).is_some(),
        centre: centres.any(|centre| centre == name),
        block: draft.slides.iter().any(|slide| slide.point == name),
        slot: draft.slides.iter().any(slotted),
        bodies,
        link: first,
        shaft,
        end: pivot.is_some_and(|(link, pivot)| is_end(home, link, pivot, point)),
        pivot,
        neighbours,
    }
}

/// Returns the links that list a point, or the link that carries it.
fn lists(mechanism: &Mechanism, point: PointId) -> Vec<LinkId> {
    match mechanism.tracer(point) {
        Some(tracer) => mechanism.link(&tracer.link).into_iter().collect(),
        None => {
            let links = mechanism.link_ids();
            let lists = links.filter(|link| mechanism.points_of(*link).contains(&point));
            lists.collect()
        }
    }
}

/// Whether a link slides along any other link or the frame.
pub(super) fn slides(mechanism: &Mechanism, link: &str) -> bool {
    let mut slides = mechanism.spec().slides.iter();
    slides.any(|slide| slide.link == link)
}

/// Whether the frame lists a point or carries it.
fn is_fixed(mechanism: &Mechanism, point: PointId) -> bool {
    match mechanism.tracer(point) {
        Some(tracer) => tracer.link == FRAME,
        None => {
            let mut frame = mechanism.spec().frame.iter();
            frame.any(|name| name == mechanism.point_name(point))
        }
    }
}

/// Returns the fixed point about which a link turns.
fn pivot_of(mechanism: &Mechanism, link: LinkId) -> Option<PointId> {
    let body = mechanism.root_of(link)?;
    let links = mechanism.link_ids();
    let same = links.filter(|other| mechanism.root_of(*other) == Some(body));
    let mut points = same.flat_map(|link| mechanism.points_of(link));
    points.find(|point| is_fixed(mechanism, **point)).copied()
}

/// Whether no other point of a link lies in the sector beyond `point`, seen from `from`.
fn is_end(home: Posed<'_, 1>, link: LinkId, from: PointId, point: PointId) -> bool {
    let (at, outward) = (home.place(point), home.place(point) - home.place(from));
    let mut others = home.mechanism.points_of(link).iter();
    others.all(|other| {
        let off = home.place(*other) - at;
        *other == point || off.dot(&outward) < BEYOND.cos() * off.norm() * outward.norm()
    })
}

/// Returns the link to which a link is ultimately fixed: the link itself, another link, or the frame.
pub(super) fn body_of(mechanism: &Mechanism, link: LinkOrFrame) -> LinkOrFrame {
    link.and_then(|link| mechanism.root_of(link))
}

/// Returns the number of a link's coordinate system in a display list; that of the frame is 0.
pub(super) fn number(link: LinkOrFrame) -> usize {
    link.map_or(0, |link| link.index() + 1)
}

pub(super) fn turned(v: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}
