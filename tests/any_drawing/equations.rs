//! The equations of a linkage, from its specification alone, with three coordinates for each link: residuals in a pose,
//! with two derivatives.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::{DriverSpec, FRAME, LinkageSpec};
use assur::{Point, Vector};

use super::shown::Shown;

/// A link as a body: its points with their places on it, from its first point, the axis
/// towards its second.
pub(crate) struct Body {
    pub(crate) points: Vec<(usize, Vector)>,
    pub(crate) drawn: f64,
    pub(crate) base: Option<usize>,
}

/// A slide: the link, its point, the other link (none: the frame), the line's first point and
/// angle on that, and the angle of the link against it.
pub(crate) struct Slide {
    pub(crate) link: usize,
    pub(crate) point: usize,
    pub(crate) on: Option<usize>,
    pub(crate) start: usize,
    pub(crate) line: f64,
    pub(crate) turned: f64,
    pub(crate) off: f64,
    pub(crate) length: f64,
}

/// Wheels with what counts of each: `Σ weight · θ` is constant; the frame does not turn.
pub(crate) struct Gear {
    pub(crate) terms: Vec<(usize, f64)>,
}

/// The equations of a draft.
pub(crate) struct Equations {
    pub(crate) places: Vec<Vector>,
    pub(crate) frame: Vec<usize>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) slides: Vec<Slide>,
    pub(crate) gears: Vec<Gear>,
    pub(crate) driver: Driver,
    pub(crate) size: f64,
}

pub(crate) enum Driver {
    Crank(usize),
    /// The slide's link's point, the first point of the line and the line's direction.
    Slide {
        link: usize,
        point: usize,
        start: usize,
        direction: Vector,
    },
}

/// The direction of an angle.
pub(crate) fn along(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// A quarter turn further.
pub(crate) fn across(v: Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

fn turned(v: Vector, angle: f64) -> Vector {
    let c = along(angle);
    c * v.x + across(c) * v.y
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.x * b.y - a.y * b.x
}

/// What is left of a whole turn.
pub(crate) fn modulo_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

impl Equations {
    /// Of a draft that names only what there is and is driven on the frame.
    pub(crate) fn new(draft: &LinkageSpec) -> Self {
        let point = |name: &String| draft.points.iter().position(|p| p.name == *name).unwrap();
        let link = |name: &String| draft.links.iter().position(|l| l.name == *name);
        let places: Vec<Vector> = draft.points.iter().map(|point| point.at.coords).collect();
        let angle = |a: usize, b: usize| (places[b] - places[a]).y.atan2((places[b] - places[a]).x);
        let bodies = draft.links.iter().map(|link| {
            let points: Vec<usize> = link.points.iter().map(point).collect();
            let own: Vec<Vector> = match &link.shape {
                Some(shape) => shape.iter().map(|at: &Point| at.coords).collect(),
                None => points.iter().map(|point| places[*point]).collect(),
            };
            let axis = own.get(1).map_or(Vector::x(), |at| at - own[0]);
            let axis = axis.y.atan2(axis.x);
            let drawn = points
                .get(1)
                .map_or(0.0, |second| angle(points[0], *second));
            let own = own.iter().map(|at| turned(at - own[0], -axis));
            let base = link.fixed_to.as_ref();
            let base = base.and_then(|base| draft.links.iter().position(|l| l.name == *base));
            Body {
                points: points.iter().copied().zip(own).collect(),
                drawn,
                base,
            }
        });
        let mut bodies: Vec<Body> = bodies.collect();
        let slides = draft.slides.iter().map(|slide| {
            let [a, b] = slide.line.each_ref().map(point);
            let (p, body) = (point(&slide.point), link(&slide.link).unwrap());
            let on = link(&slide.on);
            let base = on.map_or(0.0, |on| bodies[on].drawn);
            let line = angle(a, b);
            if bodies[body].points.len() == 1 {
                bodies[body].drawn = line;
            }
            Slide {
                link: body,
                point: p,
                on,
                start: a,
                line: line - base,
                turned: bodies[body].drawn - base,
                off: cross(along(line), places[p] - places[a]),
                length: (places[b] - places[a]).norm(),
            }
        });
        let slides: Vec<Slide> = slides.collect();
        let gears = draft.gears.iter().map(|gear| {
            let sign = if gear.mesh == Mesh::External {
                1.0
            } else {
                -1.0
            };
            let [z1, z2] = gear.teeth.map(|z| z / (gear.teeth[0] + gear.teeth[1]));
            let weights = [z1, sign * z2, -z1 - sign * z2];
            let named = [&gear.links[0], &gear.links[1], &gear.carrier];
            let terms = named.into_iter().zip(weights);
            let terms = terms.filter_map(|(name, weight)| Some((link(name)?, weight)));
            Gear {
                terms: terms.collect(),
            }
        });
        let driver = match &draft.drivers[0] {
            DriverSpec::Crank {
                link: name, base, ..
            } => {
                assert_eq!(base, FRAME);
                Driver::Crank(link(name).unwrap())
            }
            DriverSpec::Slide { slide, .. } => {
                let slide = &slides[*slide];
                Driver::Slide {
                    link: slide.link,
                    point: slide.point,
                    start: slide.start,
                    direction: along(slide.line),
                }
            }
        };
        Self {
            gears: gears.collect(),
            frame: draft.frame.iter().map(point).collect(),
            size: extent(&places),
            places,
            bodies,
            slides,
            driver,
        }
    }

    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// The pose that is drawn.
    pub(crate) fn drawn(&self) -> Shown {
        let none = Vector::zeros();
        let points = self.places.iter().map(|at| [*at, none, none]);
        let angles = self.bodies.iter().map(|body| [body.drawn, 0.0, 0.0]);
        Shown {
            points: points.collect(),
            angles: angles.collect(),
        }
    }

    /// The drawn input.
    pub(crate) fn drawn_input(&self) -> f64 {
        match self.driver {
            Driver::Crank(link) => self.bodies[link].drawn,
            Driver::Slide {
                point,
                start,
                direction,
                ..
            } => (self.places[point] - self.places[start]).dot(&direction),
        }
    }

    /// The shortest distance of two points that tell an angle, those of a link or of a guide, relative to
    /// the size: by it rounding of a drawing becomes that of an angle.
    pub(crate) fn shortest(&self) -> f64 {
        let links = self.bodies.iter().filter_map(|body| body.points.get(1));
        let lengths = links.map(|(_, at)| at.norm());
        let guides = self.slides.iter().map(|slide| slide.length);
        lengths.chain(guides).fold(self.size, f64::min) / self.size
    }

    /// What a pose leaves of all equations, relative to the scale of each order, greatest first of
    /// links, then of slides, of gears and of the driver. Gears hold against another pose.
    pub(crate) fn residuals(&self, input: f64, pose: &Shown, home: &Shown) -> [[f64; 3]; 4] {
        let scales = pose.scales(self.size);
        let turns = [0, 1, 2].map(|order| (scales[order] / scales[0]).max(f64::MIN_POSITIVE));
        let mut found = [[0.0_f64; 3]; 4];
        let mut meet = |which: usize, order: usize, off: f64| {
            found[which][order] = found[which][order].max(off);
        };
        let none = [0.0; 3];
        let angle = |link: Option<usize>| link.map_or(none, |link| pose.angles[link]);
        let length = |order: usize| scales[order].max(f64::MIN_POSITIVE);
        for point in &self.frame {
            let off = pose.points[*point][0] - self.places[*point];
            meet(0, 0, off.norm() / length(0));
            meet(0, 1, pose.points[*point][1].norm() / length(1));
            meet(0, 2, pose.points[*point][2].norm() / length(2));
        }
        for (body, theta) in self.bodies.iter().zip(&pose.angles) {
            let origin = pose.points[body.points[0].0];
            for (point, own) in &body.points {
                let at = turned(*own, theta[0]);
                let carried = [
                    at,
                    across(at) * theta[1],
                    across(at) * theta[2] - at * theta[1] * theta[1],
                ];
                for order in 0..3 {
                    let off = origin[order] + carried[order] - pose.points[*point][order];
                    meet(0, order, off.norm() / length(order));
                }
            }
            if let Some(base) = body.base {
                let other = &self.bodies[base];
                let lead = body.drawn - other.drawn;
                let own = angle(Some(base));
                meet(0, 0, modulo_turn(theta[0] - own[0] - lead).abs());
                for order in [1, 2] {
                    meet(0, order, (theta[order] - own[order]).abs() / turns[order]);
                }
                let first = self.places[body.points[0].0] - self.places[other.points[0].0];
                let at = turned(first, own[0] - other.drawn);
                let off = pose.points[other.points[0].0][0] + at - origin[0];
                meet(0, 0, off.norm() / length(0));
            }
        }
        for slide in &self.slides {
            let [base, own] = [angle(slide.on), pose.angles[slide.link]];
            meet(1, 0, modulo_turn(own[0] - base[0] - slide.turned).abs());
            for order in [1, 2] {
                meet(1, order, (own[order] - base[order]).abs() / turns[order]);
            }
            let u = along(base[0] + slide.line);
            let du = across(u) * base[1];
            let ddu = across(u) * base[2] - u * base[1] * base[1];
            let [p, a] = [slide.point, slide.start].map(|point| pose.points[point]);
            let [q, dq, ddq] = [0, 1, 2].map(|order| p[order] - a[order]);
            meet(1, 0, (cross(u, q) - slide.off).abs() / length(0));
            meet(1, 1, (cross(du, q) + cross(u, dq)).abs() / length(1));
            let second = cross(ddu, q) + 2.0 * cross(du, dq) + cross(u, ddq);
            meet(1, 2, second.abs() / length(2));
        }
        for gear in &self.gears {
            let sum = |of: &Shown, order: usize| -> f64 {
                let terms = gear.terms.iter();
                terms
                    .map(|(link, weight)| weight * of.angles[*link][order])
                    .sum()
            };
            // An angle of many turns has fewer digits behind the point.
            let largest = pose.largest_angle().max(home.largest_angle()).max(1.0);
            meet(2, 0, (sum(pose, 0) - sum(home, 0)).abs() / largest);
            meet(2, 1, sum(pose, 1).abs() / turns[1]);
            meet(2, 2, sum(pose, 2).abs() / turns[2]);
        }
        match &self.driver {
            Driver::Crank(link) => {
                let own = pose.angles[*link];
                meet(
                    3,
                    0,
                    modulo_turn(own[0] - input).abs() / input.abs().max(1.0),
                );
                meet(3, 1, (own[1] - 1.0).abs() / turns[1]);
                meet(3, 2, own[2].abs() / turns[2]);
            }
            Driver::Slide {
                point,
                direction,
                start,
                ..
            } => {
                let way = pose.points[*point].map(|order| order.dot(direction));
                let from = self.places[*start].dot(direction);
                meet(3, 0, (way[0] - from - input).abs() / length(0));
                meet(3, 1, (way[1] - 1.0).abs() / length(1));
                meet(3, 2, way[2].abs() / length(2));
            }
        }
        found
    }
}

/// The diagonal of the box around places.
fn extent(places: &[Vector]) -> f64 {
    let low = places.iter().fold(places[0], |low, at| low.inf(at));
    let high = places.iter().fold(places[0], |high, at| high.sup(at));
    (high - low).norm()
}
