//! The scheme of a linkage.

use std::collections::BTreeSet;

use super::{PairKind, PairSpec, Point3, SchemeSpec, Vector3};
use crate::gears::{GearPair, Wheel};
use crate::mechanism::{
    Defect, FRAME, GearSpec, LinkSpec, LinkageSpec, Mechanism, PointSpec, Pose, SlideSpec,
};
use crate::{Point, Vector, perpendicular};

/// Name of the contact of wheels in mesh: P, the letter of the pitch point in textbooks.
const PITCH_POINT: &str = "P";

/// Name of the idler implied by a mesh as printed in the paper.
const IDLER: &str = "idler";

/// Pressure angle α of involute gears (ISO 53), between the line of action and the common tangent of the pitch circles.
const PRESSURE_ANGLE: f64 = std::f64::consts::PI / 9.0;

impl SchemeSpec {
    /// The scheme of a linkage in a pose. A hinge is named after its point, a slide after its point or its sliding
    /// link, and a contact of wheels in mesh is named P. Links fixed to each other are one link. Wheels that mesh "as
    /// printed" have an idler between them ([`Mechanism::counts`]). A contact of coaxial wheels has no position.
    pub fn of(mechanism: &Mechanism, pose: &Pose<1>) -> Self {
        Self::of_sound(&mechanism.drawn_in(pose))
    }

    /// The scheme of a linkage with its pairs as drawn, even if it is locked, has too few drivers, or does not close.
    ///
    /// # Errors
    /// All defects of names and numbers ([`LinkageSpec::defects`]), with which there are no pairs to count.
    pub fn of_drawing(spec: &LinkageSpec) -> Result<Self, Vec<Defect>> {
        let defects = spec.defects();
        if defects.is_empty() {
            Ok(Self::of_sound(spec))
        } else {
            Err(defects)
        }
    }

    /// The scheme of a specification without defects.
    fn of_sound(spec: &LinkageSpec) -> Self {
        let own = spec.links.iter().filter(|link| link.fixed_to.is_none());
        let own = own.map(|link| link.name.as_str());
        let mut parts = Parts {
            spec,
            pairs: vec![],
            names: BTreeSet::new(),
            links: [FRAME].into_iter().chain(own).map(str::to_owned).collect(),
        };
        for point in &spec.points {
            parts.hinge(point);
        }
        for slide in &spec.slides {
            parts.slide(slide);
        }
        for gear in &spec.gears {
            parts.gear(gear);
        }
        Self {
            ground: FRAME.to_owned(),
            planar: true,
            pairs: parts.pairs,
        }
    }
}

/// A scheme under construction.
struct Parts<'a> {
    spec: &'a LinkageSpec,
    pairs: Vec<PairSpec>,
    /// Names of pairs in use.
    names: BTreeSet<String>,
    /// Names of links in use.
    links: BTreeSet<String>,
}

impl Parts<'_> {
    fn hinge(&mut self, point: &PointSpec) {
        let links = self.joined(&point.name);
        if links.len() > 1 {
            self.pair(
                point.name.clone(),
                PairKind::Revolute,
                links,
                Some(point.at),
                Some(Vector3::z()),
            );
        }
    }

    /// Names of the bodies to which a point belongs, in the order of the specification.
    fn joined(&self, point: &String) -> Vec<String> {
        let spec = self.spec;
        let on_frame = spec.frame.contains(point).then_some(FRAME);
        let has = |link: &&LinkSpec| link.points.contains(point);
        let roots = spec.links.iter().filter(has);
        let roots: BTreeSet<&str> = roots
            .map(|link| spec.root_of(&link.name))
            .chain(on_frame)
            .collect();
        let bodies = spec.links.iter().map(|link| link.name.as_str());
        let bodies = [FRAME].into_iter().chain(bodies);
        bodies
            .filter(|body| roots.contains(body))
            .map(str::to_owned)
            .collect()
    }

    fn slide(&mut self, slide: &SlideSpec) {
        let [from, to] = slide.line.each_ref().map(|name| self.spec.place(name));
        let along = from.zip(to).map(|(from, to)| spatial(to - from));
        let links = [self.body(&slide.on), self.body(&slide.link)];
        let name = [&slide.point, &slide.link];
        let name = name.into_iter().find(|name| !self.names.contains(*name));
        let name = name.unwrap_or(&slide.link).clone();
        self.pair(
            name,
            PairKind::Prismatic,
            links.into(),
            self.spec.place(&slide.point),
            along,
        );
    }

    fn gear(&mut self, gear: &GearSpec) {
        let carrier = self.body(&gear.carrier);
        let ends = [0, 1].map(|end| self.body(&gear.links[end]));
        let centres = ends.clone().map(|wheel| self.hinged(&wheel, &carrier));
        let centres = match centres {
            [Some(from), Some(to)] if from != to => Some([from, to]),
            _ => None,
        };
        let line = centres.map_or(0.0, |[from, to]| (to - from).y.atan2((to - from).x));
        // A valid specification has valid numbers of teeth.
        let Ok(pair) = GearPair::new(gear.teeth, gear.mesh, 1.0, line) else {
            debug_assert!(false, "numbers of teeth of a mechanism");
            return;
        };
        let train = pair.train();
        let length = train.last().map_or(1.0, |last| last.centre.norm());
        // Centre of a wheel of the train, scaled to the drawn distance between the centres.
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

    /// Adds a pair; if its name is in use, primes are added to the name.
    fn pair(
        &mut self,
        name: String,
        kind: PairKind,
        links: Vec<String>,
        place: Option<Point>,
        axis: Option<Vector3>,
    ) {
        self.pairs.push(PairSpec {
            name: unused(name, &mut self.names),
            kind,
            links,
            place: place.map(|at| Point3::new(at.x, at.y, 0.0)),
            axis,
            second: None,
        });
    }

    /// The name of a link's body.
    fn body(&self, link: &str) -> String {
        self.spec.root_of(link).to_owned()
    }

    /// Position of a hinge between two bodies.
    fn hinged(&self, one: &String, other: &String) -> Option<Point> {
        let mut points = self.spec.points.iter();
        let joint = points.find(|point| {
            let joined = self.joined(&point.name);
            joined.contains(one) && joined.contains(other)
        });
        joint.map(|point| point.at)
    }
}

/// Pitch point of two wheels with given centres, and direction of their line of action. The second wheel turns at
/// `ratio` times the rate of the first.
fn contact([one, other]: [Point; 2], ratio: f64) -> (Point, Vector) {
    let line = other - one;
    let along = line.normalize();
    let tangent = perpendicular(along);
    let (sin, cos) = PRESSURE_ANGLE.sin_cos();
    (
        one + line * (ratio / (ratio - 1.0)),
        tangent * cos + along * sin,
    )
}

fn spatial(direction: Vector) -> Vector3 {
    Vector3::new(direction.x, direction.y, 0.0)
}

/// The name, with primes added until it is unique.
fn unused(mut name: String, given: &mut BTreeSet<String>) -> String {
    while !given.insert(name.clone()) {
        name.push('′');
    }
    name
}
