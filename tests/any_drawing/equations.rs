//! The equations of a linkage, of its draft alone, with a body of three coordinates for each link:
//! what a pose leaves of them, with two derivatives, and how far it is determined by them.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::{Draft, DraftDriver, FRAME, Mechanism, Pose};
use assur::motion::Placed;
use assur::{Point, Vector};
use nalgebra::DMatrix;

/// What is read off a pose: of each point its place, of each link its angle, with two
/// derivatives; those that the pose does not carry are zero.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) points: Vec<[Vector; 3]>,
    pub(crate) angles: Vec<[f64; 3]>,
}

impl Shown {
    pub(crate) fn of<const N: usize>(mechanism: &Mechanism, pose: &Pose<N>) -> Self
    where
        Pose<N>: Placed,
    {
        let orders = [0, 1, 2];
        let points = mechanism.point_ids().map(|point| {
            let at = mechanism.place(pose, point);
            orders.map(|order| {
                if order < N {
                    at.derivative(order)
                } else {
                    Vector::zeros()
                }
            })
        });
        let angles = mechanism.link_ids().map(|link| {
            let angle = mechanism.angle(pose, link);
            orders.map(|order| {
                if order < N {
                    angle.derivative(order)
                } else {
                    0.0
                }
            })
        });
        Self {
            points: points.collect(),
            angles: angles.collect(),
        }
    }

    /// The greatest place, first and second derivative of anything, as lengths; places from that
    /// of the first point.
    pub(crate) fn scales(&self, size: f64) -> [f64; 3] {
        let origin = self.points[0][0];
        let far = |order: usize| {
            let points = self.points.iter().map(move |point| point[order]);
            let from = if order == 0 { origin } else { Vector::zeros() };
            points.fold(0.0, |most: f64, at| most.max((at - from).norm()))
        };
        let reach = far(0).max(size);
        let turning = |order: usize| {
            let angles = self.angles.iter().map(|angle| angle[order].abs());
            reach * angles.fold(0.0, f64::max)
        };
        let rate = turning(1).max(far(1));
        let bent = (rate / reach).powi(2) * reach;
        [reach, rate, bent.max(turning(2)).max(far(2))]
    }
}

/// A link as a body: its points with their places on it, from its first point, the axis
/// towards its second.
struct Body {
    points: Vec<(usize, Vector)>,
    drawn: f64,
    base: Option<usize>,
}

/// A slide: the link, its point, the other link (none: the frame), the line's first point and
/// angle on that, and the angle of the link against it.
struct Slide {
    link: usize,
    point: usize,
    on: Option<usize>,
    start: usize,
    line: f64,
    turned: f64,
    off: f64,
    length: f64,
}

/// Wheels with what counts of each: `Σ weight · θ` is constant; the frame does not turn.
struct Gear {
    terms: Vec<(usize, f64)>,
}

/// The equations of a draft.
pub(crate) struct Equations {
    places: Vec<Vector>,
    frame: Vec<usize>,
    bodies: Vec<Body>,
    slides: Vec<Slide>,
    gears: Vec<Gear>,
    driver: Driver,
    size: f64,
}

enum Driver {
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
fn along(angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin())
}

/// A quarter turn further.
fn across(v: Vector) -> Vector {
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
    pub(crate) fn new(draft: &Draft) -> Self {
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
            DraftDriver::Crank {
                link: name, base, ..
            } => {
                assert_eq!(base, FRAME);
                Driver::Crank(link(name).unwrap())
            }
            DraftDriver::Slide { slide, .. } => {
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
            // Of angles of many turns so many digits fewer are told.
            let all = gear
                .terms
                .iter()
                .map(|(link, _)| pose.angles[*link][0].abs());
            let many = all.fold(1.0, f64::max);
            meet(2, 0, (sum(pose, 0) - sum(home, 0)).abs() / many);
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

    /// How far a pose is determined by the equations.
    pub(crate) fn condition(&self, pose: &Shown) -> Condition {
        let unknowns = 3 * self.bodies.len();
        let mut rows = Rows {
            size: self.size,
            unknowns,
            matrix: vec![],
        };
        let at = |point: usize| pose.points[point][0];
        let origin = |link: usize| at(self.bodies[link].points[0].0);
        for point in 0..self.places.len() {
            let has = |body: &Body| body.points.iter().any(|(other, _)| *other == point);
            let links = (0..self.bodies.len()).filter(|link| has(&self.bodies[*link]));
            let links: Vec<usize> = links.collect();
            let first = links.first().copied();
            let base = if self.frame.contains(&point) {
                None
            } else {
                first
            };
            for link in links {
                if Some(link) != base {
                    rows.hinge(Some(link), base, at(point), &origin);
                }
            }
        }
        for (link, body) in self.bodies.iter().enumerate() {
            if body.base.is_some() {
                rows.hinge(Some(link), body.base, origin(link), &origin);
                rows.turning(&[(link, 1.0)], body.base);
            }
        }
        for slide in &self.slides {
            rows.turning(&[(slide.link, 1.0)], slide.on);
            let base = slide.on.map_or(0.0, |on| pose.angles[on][0]);
            let u = along(base + slide.line);
            let [p, start] = [slide.point, slide.start].map(at);
            rows.line((slide.link, p), slide.on, start, u, &origin);
        }
        for gear in &self.gears {
            rows.turning(&gear.terms, None);
        }
        match &self.driver {
            Driver::Crank(link) => rows.turning(&[(*link, 1.0)], None),
            Driver::Slide {
                link,
                point,
                direction,
                ..
            } => rows.line(
                (*link, at(*point)),
                None,
                Vector::zeros(),
                -across(*direction),
                &origin,
            ),
        }
        assert_eq!(
            rows.matrix.len(),
            unknowns * unknowns,
            "equations for unknowns"
        );
        let matrix = DMatrix::from_row_slice(unknowns, unknowns, &rows.matrix);
        Condition::of(matrix, &self.driver, self.size)
    }
}

/// Rows of the Jacobian, lengths relative to the size.
struct Rows {
    size: f64,
    unknowns: usize,
    matrix: Vec<f64>,
}

impl Rows {
    fn row(&mut self, entries: &[(usize, f64)]) {
        let start = self.matrix.len();
        self.matrix.resize(start + self.unknowns, 0.0);
        for (unknown, value) in entries {
            self.matrix[start + unknown] += value;
        }
    }

    /// A point is the same on two links; none is the frame.
    fn hinge(
        &mut self,
        a: Option<usize>,
        b: Option<usize>,
        at: Vector,
        origin: &impl Fn(usize) -> Vector,
    ) {
        for axis in 0..2 {
            let mut entries = vec![];
            for (link, sign) in [(a, 1.0), (b, -1.0)] {
                let Some(link) = link else { continue };
                let arm = across(at - origin(link)) / self.size;
                entries.extend([(3 * link + axis, sign), (3 * link + 2, sign * arm[axis])]);
            }
            self.row(&entries);
        }
    }

    /// Angles in a constant sum, less that of another link.
    fn turning(&mut self, terms: &[(usize, f64)], base: Option<usize>) {
        let terms = terms.iter().map(|(link, weight)| (3 * link + 2, *weight));
        let base = base.map(|base| (3 * base + 2, -1.0));
        self.row(&terms.chain(base).collect::<Vec<_>>());
    }

    /// A point of a link stays on a line of another, of this direction.
    fn line(
        &mut self,
        (link, p): (usize, Vector),
        on: Option<usize>,
        start: Vector,
        u: Vector,
        origin: &impl Fn(usize) -> Vector,
    ) {
        let n = across(u);
        let arm = across(p - origin(link)) / self.size;
        let mut entries = vec![
            (3 * link, n.x),
            (3 * link + 1, n.y),
            (3 * link + 2, n.dot(&arm)),
        ];
        if let Some(on) = on {
            let arm = across(start - origin(on)) / self.size;
            let turns = -n.dot(&arm) - u.dot(&(p - start)) / self.size;
            entries.extend([(3 * on, -n.x), (3 * on + 1, -n.y), (3 * on + 2, turns)]);
        }
        self.row(&entries);
    }
}

/// How far a pose is determined by its equations, to first order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Condition {
    /// By how much a small error of any equation, relative to the size or in radians, may grow in
    /// the coordinates of the links: ‖J⁻¹‖, infinite where it is singular.
    pub(crate) pose: f64,
    /// By how much it may grow in the input at which something comes to pass, such as a dead
    /// point: what it does to the pose over what the input does.
    pub(crate) input: f64,
    /// The sign of the determinant.
    pub(crate) sign: f64,
}

impl Condition {
    fn of(matrix: DMatrix<f64>, driver: &Driver, size: f64) -> Self {
        let last = matrix.nrows() - 1;
        let lu = matrix.lu();
        let sign = lu.determinant().signum();
        let Some(inverse) = lu.try_inverse() else {
            let (pose, input) = (f64::INFINITY, f64::INFINITY);
            return Self { pose, input, sign };
        };
        let rate = inverse.column(last).norm();
        let (pose, unit) = (
            inverse.norm(),
            match driver {
                Driver::Crank(_) => 1.0,
                Driver::Slide { .. } => size,
            },
        );
        let input = unit * pose / rate;
        Self { pose, input, sign }
    }
}

/// The diagonal of the box around places.
fn extent(places: &[Vector]) -> f64 {
    let low = places.iter().fold(places[0], |low, at| low.inf(at));
    let high = places.iter().fold(places[0], |high, at| high.sup(at));
    (high - low).norm()
}
