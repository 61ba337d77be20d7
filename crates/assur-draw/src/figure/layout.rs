//! Which points are joints, which links are drawn how.

use assur::mechanism::{Draft, FRAME, Mechanism, Pose};
use assur::{Point, Vector};

use super::{View, roles};
use crate::list::Role;
use crate::parts;

/// A link, or the frame: none.
pub(super) type LinkOrFrame = Option<usize>;

/// Within this angle of the line beyond a link's end nothing else of the link may
/// be, for a name to stand there.
const BEYOND: f64 = 0.9;

/// What is known of a draft before it is drawn. Bodies are links that are fixed to
/// no other, or the frame.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    roles: Vec<Role>,
    drawn_roles: Vec<Role>,
    outlines: Vec<Vec<Point>>,
    bars: Vec<bool>,
    /// The body of each link.
    bodies: Vec<LinkOrFrame>,
    /// Whether a link's centre of mass is given.
    weighed: Vec<bool>,
    points: Vec<Pinned>,
    tracers: usize,
}

/// A point and what it is for.
#[derive(Clone, Debug)]
struct Pinned {
    /// The bodies that have it.
    bodies: Vec<LinkOrFrame>,
    /// The first link that lists it.
    link: LinkOrFrame,
    centre: bool,
    /// Whether a centre of mass is shown.
    shown: bool,
    block: bool,
    /// The shaft of a wheel that is drawn plainly.
    shaft: bool,
    /// A link on which it turns about a fixed point, and that point.
    pivot: Option<(usize, usize)>,
    /// Whether it is the far end of that link.
    end: bool,
    neighbours: Vec<usize>,
}

impl Layout {
    pub(super) fn new(draft: &Draft, mechanism: &Mechanism, home: &Pose<1>, view: &View) -> Self {
        let points = 0..mechanism.points().len();
        let points = points.map(|point| pinned(draft, mechanism, home, view, point));
        let roles = roles::own(draft, &view.annotations);
        let mut layout = Self {
            drawn_roles: if view.overlays.groups {
                roles::of_groups(draft, mechanism)
            } else {
                roles.clone()
            },
            roles,
            outlines: Vec::new(),
            bars: Vec::new(),
            bodies: (0..draft.links.len())
                .map(|link| body_of(draft, Some(link)))
                .collect(),
            weighed: draft
                .links
                .iter()
                .map(|link| link.centre_of_mass.is_some())
                .collect(),
            points: points.collect(),
            tracers: draft.points.len(),
        };
        for link in 0..draft.links.len() {
            let joints = mechanism.points_of(link).iter();
            let joints = joints.filter(|point| layout.is_joint(**point)).count();
            layout.bars.push(joints > 1);
            layout
                .outlines
                .push(layout.outlined(draft, mechanism, home, link));
        }
        layout
    }

    /// The corners of a link: two of a bar, three and more of a plate; none of
    /// one that lies on what it is fixed to.
    fn outlined(
        &self,
        draft: &Draft,
        mechanism: &Mechanism,
        home: &Pose<1>,
        link: usize,
    ) -> Vec<Point> {
        let own = mechanism.points_of(link).iter();
        let own: Vec<usize> = own
            .copied()
            .filter(|point| self.is_joint(*point) || !self.is_centre(*point))
            .collect();
        let fixed = draft.links[link].fixed_to.is_some();
        let listed = |point: &usize| self.link_of(*point) != Some(link);
        if fixed && own.iter().all(listed) {
            return Vec::new();
        }
        let places = own
            .iter()
            .map(|point| local(mechanism, home, Some(link), *point));
        parts::hull(places.collect())
    }

    /// The colour of a link's own, by which plots tell links apart.
    pub(super) fn role(&self, link: usize) -> Role {
        self.roles.get(link).copied().unwrap_or(Role::Coupler)
    }

    /// The colour it is drawn in: its own, or that of its Assur group.
    pub(super) fn drawn_role(&self, link: usize) -> Role {
        let drawn = self.drawn_roles.get(link).copied();
        drawn.unwrap_or(Role::Coupler)
    }

    pub(super) fn outline(&self, link: usize) -> &[Point] {
        &self.outlines[link]
    }

    /// The link that a link is fixed to in the end; none for one fixed to the frame.
    pub(super) fn body(&self, link: usize) -> LinkOrFrame {
        self.bodies[link]
    }

    /// Where the centres of mass of the links are for which none is given: in the
    /// middle of a bar, at the centroid of a plate.
    pub(super) fn middles(&self) -> impl Iterator<Item = (usize, Point)> {
        let links = 0..self.outlines.len();
        let own = links.filter(|link| self.body(*link) == Some(*link) && !self.weighed[*link]);
        own.filter_map(|link| Some((link, parts::centroid(self.outline(link))?)))
    }

    /// Whether a link joins two hinges or more.
    pub(super) fn is_bar(&self, link: usize) -> bool {
        self.bars[link]
    }

    /// The first link that lists a point.
    pub(super) fn link_of(&self, point: usize) -> LinkOrFrame {
        self.points[point].link
    }

    /// Whether it is a tracer: a point that a link carries and that joins nothing.
    pub(super) fn is_tracer(&self, point: usize) -> bool {
        point >= self.tracers
    }

    /// A link on which a point turns about a fixed one, and that one.
    pub(super) fn pivot(&self, point: usize) -> Option<(usize, usize)> {
        self.points[point].pivot
    }

    /// The fixed point about which a link turns beyond whose end a joint's name
    /// can stand.
    pub(super) fn end_of(&self, point: usize) -> Option<usize> {
        let pinned = &self.points[point];
        let ends = pinned.end && self.is_joint(point);
        pinned.pivot.filter(|_| ends).map(|(_, pivot)| pivot)
    }

    /// The link whose colour a point has: that on which it turns about a fixed
    /// point, else the first.
    pub(super) fn carrier(&self, point: usize) -> LinkOrFrame {
        let turned = self.pivot(point).map(|(link, _)| link);
        turned.or(self.link_of(point))
    }

    pub(super) fn neighbours(&self, point: usize) -> &[usize] {
        &self.points[point].neighbours
    }

    /// Whether bodies are hinged there; a plain shaft of a wheel is drawn with it.
    pub(super) fn is_joint(&self, point: usize) -> bool {
        self.points[point].bodies.len() > 1 && !self.is_shaft(point)
    }

    pub(super) fn is_shaft(&self, point: usize) -> bool {
        self.points[point].shaft
    }

    /// Whether something is hinged on the frame there.
    pub(super) fn is_support(&self, point: usize) -> bool {
        self.is_joint(point) && !self.moves(point)
    }

    /// Whether it is not a point of the frame.
    pub(super) fn moves(&self, point: usize) -> bool {
        !self.points[point].bodies.contains(&None)
    }

    pub(super) fn is_centre(&self, point: usize) -> bool {
        self.points[point].centre
    }

    /// Whether a block is drawn around it.
    pub(super) fn is_on_block(&self, point: usize) -> bool {
        self.points[point].block
    }

    /// Whether anything is seen there: points that only give a line of the frame,
    /// and centres of mass that are not shown, are not.
    pub(super) fn is_drawn(&self, point: usize) -> bool {
        let hidden = self.is_centre(point) && !self.points[point].shown;
        let seen = !hidden || self.is_joint(point);
        let on_link = self.link_of(point).is_some() || self.is_tracer(point);
        seen && on_link && !self.is_shaft(point)
    }

    /// A point at which two bodies are hinged.
    pub(super) fn hinge(&self, a: LinkOrFrame, b: LinkOrFrame) -> Option<usize> {
        let both = |pinned: &Pinned| pinned.bodies.contains(&a) && pinned.bodies.contains(&b);
        self.points.iter().position(both)
    }
}

fn pinned(
    draft: &Draft,
    mechanism: &Mechanism,
    home: &Pose<1>,
    view: &View,
    point: usize,
) -> Pinned {
    let name = draft.points.get(point).map(|point| &point.name);
    let mut links = lists(draft, mechanism, point);
    let mut bodies: Vec<LinkOrFrame> = Vec::new();
    // A tracer without a moving link is on the frame.
    if name.map_or(links.is_empty(), |name| draft.frame.contains(name)) {
        bodies.push(None);
    }
    let mut neighbours = Vec::new();
    for link in &links {
        let body = body_of(draft, Some(*link));
        if !bodies.contains(&body) {
            bodies.push(body);
        }
        let others = mechanism.points_of(*link).iter().copied();
        neighbours.extend(others.filter(|other| *other != point));
    }
    let first = links.first().copied();
    // A wheel that is nothing else: its centre is its only point.
    let tags = &view.annotations.tags;
    let plain = |link: &usize| {
        let tagged = |link: &str| tags.iter().any(|tag| tag.link == link);
        tagged(&draft.links[*link].name) && mechanism.points_of(*link) == [point]
    };
    let shaft = !links.is_empty() && links.iter().all(plain);
    let moves = !bodies.contains(&None);
    links.retain(|_| moves);
    let pivots = links.iter().filter_map(|link| {
        let pivot = pivot_of(draft, mechanism, *link)?;
        Some((*link, pivot))
    });
    let pivot = pivots.min_by_key(|(link, _)| draft.links[*link].fixed_to.is_some());
    let is = |named: &String| Some(named) == name;
    let centre = draft
        .links
        .iter()
        .any(|link| link.centre_of_mass.as_ref().is_some_and(is));
    Pinned {
        shown: view.overlays.centres || view.traced.contains(&point),
        centre,
        block: draft.slides.iter().any(|slide| is(&slide.point)),
        bodies,
        link: first,
        shaft,
        end: pivot.is_some_and(|(link, pivot)| is_end(mechanism, home, link, pivot, point)),
        pivot,
        neighbours,
    }
}

/// The links that list a point, or the one that carries it.
fn lists(draft: &Draft, mechanism: &Mechanism, point: usize) -> Vec<usize> {
    if let Some(tracer) = point.checked_sub(draft.points.len()) {
        let tracer = draft.tracers.get(tracer);
        let link = tracer.and_then(|tracer| index_of(draft, &tracer.link));
        return link.into_iter().collect();
    }
    let links = 0..draft.links.len();
    links
        .filter(|link| mechanism.points_of(*link).contains(&point))
        .collect()
}

/// The fixed point about which a link turns.
fn pivot_of(draft: &Draft, mechanism: &Mechanism, link: usize) -> Option<usize> {
    let body = body_of(draft, Some(link))?;
    let same = (0..draft.links.len()).filter(|other| body_of(draft, Some(*other)) == Some(body));
    let mut points = same.flat_map(|link| mechanism.points_of(link));
    let fixed = |point: &&usize| {
        let name = draft.points.get(**point).map(|point| &point.name);
        name.is_some_and(|name| draft.frame.contains(name))
    };
    points.find(fixed).copied()
}

/// Whether nothing of a link is beyond a point of it, seen from another.
fn is_end(mechanism: &Mechanism, home: &Pose<1>, link: usize, from: usize, point: usize) -> bool {
    let place = |point: usize| mechanism.place(home, point).place();
    let (at, outward) = (place(point), place(point) - place(from));
    let mut others = mechanism.points_of(link).iter();
    others.all(|other| {
        let off = place(*other) - at;
        *other == point || off.dot(&outward) < BEYOND.cos() * off.norm() * outward.norm()
    })
}

/// The link that a link is fixed to in the end.
pub(super) fn body_of(draft: &Draft, link: LinkOrFrame) -> LinkOrFrame {
    let mut body = link;
    for _ in 0..draft.links.len() {
        match body.and_then(|link| draft.links[link].fixed_to.as_ref()) {
            Some(base) => body = index_of(draft, base),
            None => break,
        }
    }
    body
}

/// The index of a link; none for the frame.
pub(super) fn index_of(draft: &Draft, name: &str) -> LinkOrFrame {
    if name == FRAME {
        return None;
    }
    draft.links.iter().position(|link| link.name == name)
}

/// Where a link's own coordinates are: its first point and its angle.
pub(super) fn body<const N: usize>(
    mechanism: &Mechanism,
    pose: &Pose<N>,
    link: LinkOrFrame,
) -> (Point, f64) {
    let first = link.and_then(|link| Some((link, *mechanism.points_of(link).first()?)));
    first.map_or((Point::origin(), 0.0), |(link, point)| {
        let angle = mechanism.angle(pose, link).value();
        (mechanism.place(pose, point).place(), angle)
    })
}

/// Where a point is in the coordinates of a link.
pub(super) fn local<const N: usize>(
    mechanism: &Mechanism,
    pose: &Pose<N>,
    link: LinkOrFrame,
    point: usize,
) -> Point {
    let (origin, angle) = body(mechanism, pose, link);
    Point::origin() + turned(mechanism.place(pose, point).place() - origin, -angle)
}

pub(super) fn turned(v: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}
