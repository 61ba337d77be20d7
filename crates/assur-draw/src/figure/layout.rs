//! Which points are joints, which links are drawn how.

use assur::mechanism::{Draft, LinkId, LinkOrFrame, Mechanism, PointId, Pose};
use assur::structure::{Step, Structure};
use assur::{Point, Vector};

use crate::list::Role;
use crate::parts;

/// Colours of links that are not driven, or of Assur groups, in turn.
const ROLES: [Role; 6] = [
    Role::Coupler,
    Role::Rocker,
    Role::Wheel5,
    Role::Wheel6,
    Role::Wheel8,
    Role::Wheel9,
];

/// What is known of a draft before it is drawn. Bodies are links that are fixed to
/// no other, or the frame.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    roles: Vec<Role>,
    drawn_roles: Vec<Role>,
    outlines: Vec<Vec<Point>>,
    bars: Vec<bool>,
    points: Vec<Pinned>,
}

/// A point and what it is for.
#[derive(Clone, Debug)]
struct Pinned {
    /// The bodies that have it.
    bodies: Vec<LinkOrFrame>,
    /// The first link that lists it.
    link: LinkOrFrame,
    centre: bool,
    block: bool,
    neighbours: Vec<PointId>,
}

impl Layout {
    pub(super) fn new(
        draft: &Draft,
        mechanism: &Mechanism,
        home: &Pose<1>,
        in_groups: bool,
    ) -> Self {
        let points = mechanism
            .point_ids()
            .map(|point| pinned(draft, mechanism, point));
        let roles = roles(mechanism);
        let mut layout = Self {
            drawn_roles: if in_groups {
                group_roles(mechanism)
            } else {
                roles.clone()
            },
            roles,
            outlines: Vec::new(),
            bars: Vec::new(),
            points: points.collect(),
        };
        for link in mechanism.link_ids() {
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
        link: LinkId,
    ) -> Vec<Point> {
        let own = mechanism.points_of(link).iter();
        let own: Vec<PointId> = own
            .copied()
            .filter(|point| self.is_joint(*point) || !self.is_centre(*point))
            .collect();
        let fixed = draft.links[link.index()].fixed_to.is_some();
        let listed = |point: &PointId| self.link_of(*point) != Some(link);
        if fixed && own.iter().all(listed) {
            return Vec::new();
        }
        let places = own
            .iter()
            .map(|point| local(mechanism, home, Some(link), *point));
        parts::hull(places.collect())
    }

    /// The colour of a link's own, by which plots tell links apart.
    pub(super) fn role(&self, link: LinkId) -> Role {
        self.roles
            .get(link.index())
            .copied()
            .unwrap_or(Role::Coupler)
    }

    /// The colour it is drawn in: its own, or that of its Assur group.
    pub(super) fn drawn_role(&self, link: LinkId) -> Role {
        let drawn = self.drawn_roles.get(link.index()).copied();
        drawn.unwrap_or(Role::Coupler)
    }

    pub(super) fn outline(&self, link: LinkId) -> &[Point] {
        &self.outlines[link.index()]
    }

    /// Whether a link joins two hinges or more.
    pub(super) fn is_bar(&self, link: LinkId) -> bool {
        self.bars[link.index()]
    }

    /// The first link that lists a point.
    pub(super) fn link_of(&self, point: PointId) -> LinkOrFrame {
        self.points[point.index()].link
    }

    pub(super) fn neighbours(&self, point: PointId) -> &[PointId] {
        &self.points[point.index()].neighbours
    }

    /// Whether bodies are hinged there.
    pub(super) fn is_joint(&self, point: PointId) -> bool {
        self.points[point.index()].bodies.len() > 1
    }

    /// Whether something is hinged on the frame there.
    pub(super) fn is_support(&self, point: PointId) -> bool {
        self.is_joint(point) && !self.moves(point)
    }

    /// Whether it is not a point of the frame.
    pub(super) fn moves(&self, point: PointId) -> bool {
        !self.points[point.index()].bodies.contains(&None)
    }

    pub(super) fn is_centre(&self, point: PointId) -> bool {
        self.points[point.index()].centre
    }

    /// Whether a block is drawn around it.
    pub(super) fn is_on_block(&self, point: PointId) -> bool {
        self.points[point.index()].block
    }

    /// Whether anything is seen there: points that only give a line of the frame
    /// are not.
    pub(super) fn is_drawn(&self, point: PointId) -> bool {
        self.link_of(point).is_some()
    }

    /// A point at which two bodies are hinged.
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

fn pinned(draft: &Draft, mechanism: &Mechanism, point: PointId) -> Pinned {
    let name = &draft.points[point.index()].name;
    let mut bodies: Vec<LinkOrFrame> = Vec::new();
    if draft.frame.contains(name) {
        bodies.push(None);
    }
    let mut neighbours = Vec::new();
    let mut first = None;
    for link in mechanism.link_ids() {
        let points = mechanism.points_of(link);
        if points.contains(&point) {
            let body = body_of(mechanism, Some(link));
            if !bodies.contains(&body) {
                bodies.push(body);
            }
            first = first.or(Some(link));
            neighbours.extend(points.iter().copied().filter(|other| *other != point));
        }
    }
    let mut links = draft.links.iter();
    Pinned {
        centre: links.any(|link| link.centre_of_mass.as_ref() == Some(name)),
        block: draft.slides.iter().any(|slide| slide.point == *name),
        bodies,
        link: first,
        neighbours,
    }
}

/// The link that a link is fixed to in the end.
pub(super) fn body_of(mechanism: &Mechanism, link: LinkOrFrame) -> LinkOrFrame {
    let links = &mechanism.draft().links;
    let mut body = link;
    for _ in links {
        match body.and_then(|link| links[link.index()].fixed_to.as_ref()) {
            Some(base) => body = mechanism.link(base),
            None => break,
        }
    }
    body
}

/// The driven link is a crank by its colour, the others take theirs in turn; what
/// is fixed to a link has its.
fn roles(mechanism: &Mechanism) -> Vec<Role> {
    let draft = mechanism.draft();
    let driven = |name: &String| {
        let mut drivers = draft.drivers.iter();
        drivers.any(|driver| draft.driven(driver) == Some(name))
    };
    let mut turn = ROLES.into_iter().cycle();
    let mut own = |link: &assur::mechanism::DraftLink| {
        if link.fixed_to.is_some() {
            Role::Secondary
        } else if driven(&link.name) {
            Role::Crank
        } else {
            turn.next().unwrap_or(Role::Coupler)
        }
    };
    let roles: Vec<Role> = draft.links.iter().map(&mut own).collect();
    let role = |body: LinkId| roles[body.index()];
    (mechanism.link_ids())
        .map(|link| body_of(mechanism, Some(link)).map_or(Role::Secondary, role))
        .collect()
}

/// The colours of drivers and Assur groups, in the order of the structure.
pub(super) fn step_roles(structure: &Structure) -> impl Iterator<Item = Role> {
    let mut turn = ROLES.into_iter().cycle();
    structure.steps.iter().map(move |step| match step {
        Step::Driver { .. } => Role::Crank,
        Step::Group(_) => turn.next().unwrap_or(Role::Coupler),
    })
}

/// Of each link the colour of the step that places it; what is fixed to the frame
/// has none.
fn group_roles(mechanism: &Mechanism) -> Vec<Role> {
    let structure = mechanism.structure();
    let roles: Vec<Role> = step_roles(structure).collect();
    let of_body = |name: &str| {
        let mut bodies = mechanism.bodies();
        let body = bodies.find(|body| mechanism.body_name(*body) == name)?;
        roles.get(structure.step_of[body.index()]?).copied()
    };
    let role = |link: LinkId| {
        let body = body_of(mechanism, Some(link))?;
        of_body(mechanism.link_name(body))
    };
    let links = mechanism.link_ids();
    links
        .map(|link| role(link).unwrap_or(Role::Secondary))
        .collect()
}

/// Where a link's own coordinates are: its first point and its angle.
pub(super) fn body(mechanism: &Mechanism, pose: &Pose<1>, link: LinkOrFrame) -> (Point, f64) {
    let first = link.and_then(|link| Some((link, *mechanism.points_of(link).first()?)));
    first.map_or((Point::origin(), 0.0), |(link, point)| {
        let angle = mechanism.angle(pose, link).value();
        (mechanism.place(pose, point).place(), angle)
    })
}

/// Where a point is in the coordinates of a link.
pub(super) fn local(
    mechanism: &Mechanism,
    pose: &Pose<1>,
    link: LinkOrFrame,
    point: PointId,
) -> Point {
    let (origin, angle) = body(mechanism, pose, link);
    Point::origin() + turned(mechanism.place(pose, point).place() - origin, -angle)
}

pub(super) fn turned(v: Vector, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}
