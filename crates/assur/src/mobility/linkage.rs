//! Any linkage of the simulator as a scheme.

use std::collections::BTreeSet;

use super::{PairDraft, PairKind, Point3, SchemeDraft, Vector3};
use crate::gears::{GearPair, Wheel};
use crate::mechanism::{DraftGear, DraftSlide, FRAME, LinkId, Mechanism, PointId, Pose};
use crate::{Point, Vector};

/// The name of a contact of wheels in mesh: P, as textbooks have the pitch point.
const PITCH_POINT: &str = "P";

/// The name of a wheel between two others that a draft does not have, but its mesh as printed implies.
const IDLER: &str = "idler";

/// α of involute gears (ISO 53): the angle between the line of action and the common tangent of the pitch circles.
const PRESSURE_ANGLE: f64 = std::f64::consts::PI / 9.0;

impl SchemeDraft {
    /// A linkage at a pose. A hinge has the name of its point, a slide that of the point or the link that slides,
    /// wheels in mesh touch in P. Links that are fixed to each other are one; between wheels that mesh "as
    /// printed" there is an idler, as [`Mechanism::counts`] has it. Meshes of wheels about one centre have no place.
    pub fn of(mechanism: &Mechanism, pose: &Pose<1>) -> Self {
        let mut parts = Parts {
            mechanism,
            pose,
            pairs: vec![],
            names: BTreeSet::new(),
            links: mechanism.body_names().map(str::to_owned).collect(),
        };
        let draft = mechanism.draft();
        for point in mechanism.point_ids().take(draft.points.len()) {
            parts.hinge(point);
        }
        for slide in &draft.slides {
            parts.slide(slide);
        }
        for gear in &draft.gears {
            parts.gear(gear);
        }
        Self {
            ground: FRAME.to_owned(),
            planar: true,
            pairs: parts.pairs,
        }
    }
}

/// A scheme that is being made.
struct Parts<'a> {
    mechanism: &'a Mechanism,
    pose: &'a Pose<1>,
    pairs: Vec<PairDraft>,
    /// Names of pairs that are given.
    names: BTreeSet<String>,
    /// Names of links that are given.
    links: BTreeSet<String>,
}

impl Parts<'_> {
    fn hinge(&mut self, point: PointId) {
        let name = self.mechanism.point_name(point);
        let links = self.joined(point);
        if links.len() > 1 {
            let place = self.place(point);
            self.pair(
                name.to_owned(),
                PairKind::Revolute,
                links,
                Some(place),
                Some(Vector3::z()),
            );
        }
    }

    /// The names of the bodies that have a point.
    fn joined(&self, point: PointId) -> Vec<String> {
        let mechanism = self.mechanism;
        let fixed = &mechanism.draft().frame;
        let on_frame = fixed.iter().any(|name| name == mechanism.point_name(point));
        let has = |link: &LinkId| mechanism.points_of(*link).contains(&point);
        let roots = mechanism
            .link_ids()
            .filter(has)
            .map(|link| mechanism.root_of(link));
        let roots: BTreeSet<_> = roots.chain(on_frame.then_some(None)).collect();
        let names = roots.into_iter();
        names
            .map(|root| {
                root.map_or(FRAME, |link| mechanism.link_name(link))
                    .to_owned()
            })
            .collect()
    }

    fn slide(&mut self, slide: &DraftSlide) {
        let point = |name: &str| self.mechanism.point(name).map(|point| self.place(point));
        let [from, to] = [&slide.line[0], &slide.line[1]].map(|name| point(name));
        let along = from.zip(to).map(|(from, to)| spatial(to - from));
        let links = [self.body(&slide.on), self.body(&slide.link)];
        let name = [&slide.point, &slide.link];
        let name = name.into_iter().find(|name| !self.names.contains(*name));
        let name = name.unwrap_or(&slide.link).clone();
        self.pair(
            name,
            PairKind::Prismatic,
            links.into(),
            point(&slide.point),
            along,
        );
    }

    fn gear(&mut self, gear: &DraftGear) {
        let carrier = self.body(&gear.carrier);
        let ends = [0, 1].map(|end| self.body(&gear.links[end]));
        let centres = ends.clone().map(|wheel| self.hinged(&wheel, &carrier));
        let centres = match centres {
            [Some(from), Some(to)] if from != to => Some([from, to]),
            _ => None,
        };
        let line = centres.map_or(0.0, |[from, to]| (to - from).y.atan2((to - from).x));
        // Of a mechanism the numbers of teeth are sound.
        let Ok(pair) = GearPair::new(gear.teeth, gear.mesh, 1.0, line) else {
            debug_assert!(false, "numbers of teeth of a mechanism");
            return;
        };
        let train = pair.train();
        let length = train.last().map_or(1.0, |last| last.centre.norm());
        // The wheels as large as the distance of the centres wants them.
        let at = |wheel: &Wheel| {
            centres.map(|[from, to]| from + wheel.centre * ((to - from).norm() / length))
        };
        let mut names = vec![ends[0].clone()];
        for wheel in train.iter().skip(1).rev().skip(1) {
            let idler = unused(IDLER.to_owned(), &mut self.links);
            let place = at(wheel);
            let links = vec![carrier.clone(), idler.clone()];
            self.pair(
                idler.clone(),
                PairKind::Revolute,
                links,
                place,
                Some(Vector3::z()),
            );
            names.push(idler);
        }
        names.push(ends[1].clone());
        for (links, wheels) in names.windows(2).zip(train.windows(2)) {
            let contact = at(&wheels[0]).zip(at(&wheels[1])).map(|(one, other)| {
                let ratio = wheels[1].ratio / wheels[0].ratio;
                contact([one, other], ratio)
            });
            let (place, normal) = contact.unzip();
            let (name, kind) = (PITCH_POINT.to_owned(), PairKind::CylinderOnPlane);
            self.pair(name, kind, links.to_vec(), place, normal.map(spatial));
        }
    }

    /// Adds a pair; its name gets primes where there is another one of this name.
    fn pair(
        &mut self,
        name: String,
        kind: PairKind,
        links: Vec<String>,
        place: Option<Point>,
        axis: Option<Vector3>,
    ) {
        self.pairs.push(PairDraft {
            name: unused(name, &mut self.names),
            kind,
            links,
            place: place.map(|at| Point3::new(at.x, at.y, 0.0)),
            axis,
            second: None,
        });
    }

    /// The name of the body of a link.
    fn body(&self, link: &str) -> String {
        let root = self
            .mechanism
            .link(link)
            .and_then(|link| self.mechanism.root_of(link));
        root.map_or(FRAME, |root| self.mechanism.link_name(root))
            .to_owned()
    }

    /// Where two bodies are hinged on each other.
    fn hinged(&self, one: &String, other: &String) -> Option<Point> {
        let draft = self.mechanism.draft();
        let mut points = self.mechanism.point_ids().take(draft.points.len());
        let joint = points.find(|point| {
            let joined = self.joined(*point);
            joined.contains(one) && joined.contains(other)
        });
        joint.map(|point| self.place(point))
    }

    fn place(&self, point: PointId) -> Point {
        self.mechanism.place(self.pose, point).place()
    }
}

/// The pitch point of two wheels about these centres, of which the second turns in this ratio to the first, and
/// the direction of the line of action.
fn contact([one, other]: [Point; 2], ratio: f64) -> (Point, Vector) {
    let line = other - one;
    let along = line.normalize();
    let tangent = Vector::new(-along.y, along.x);
    let (sin, cos) = PRESSURE_ANGLE.sin_cos();
    (
        one + line * (ratio / (ratio - 1.0)),
        tangent * cos + along * sin,
    )
}

fn spatial(direction: Vector) -> Vector3 {
    Vector3::new(direction.x, direction.y, 0.0)
}

/// The name, with as many primes as it needs to be new.
fn unused(mut name: String, given: &mut BTreeSet<String>) -> String {
    while !given.insert(name.clone()) {
        name.push('′');
    }
    name
}
