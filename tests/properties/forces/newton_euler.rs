//! All Newton–Euler equations of a linkage at once.

use assur::gears::Mesh;
use assur::linkage::DriverSpec;
use assur::mechanism::{BodyId, Joint, Mechanism, Pose};
use assur::{JetPoint, Point, Vector};
use nalgebra::{DMatrix, DVector};

use super::Loaded;

/// The equations of Newton and Euler of all bodies, about the origin, with the components of all pairs as unknowns.
pub(super) struct NewtonEuler<'a> {
    mechanism: &'a Mechanism,
    pose: &'a Pose<3>,
    /// Columns: the wrenches (force, moment) of unit components on bodies.
    columns: Vec<Vec<(BodyId, [f64; 3])>>,
    /// For each pair its first column.
    pub(super) pairs: Vec<(Joint, usize)>,
    /// Number of columns of pairs; those of drives follow.
    pub(super) held: usize,
}

fn wrench(at: Point, force: Vector, couple: f64, sign: f64) -> [f64; 3] {
    [force.x, force.y, at.coords.perp(&force) + couple].map(|part| sign * part)
}

impl<'a> NewtonEuler<'a> {
    pub(super) fn new(mechanism: &'a Mechanism, pose: &'a Pose<3>) -> Self {
        let mut all = Self {
            mechanism,
            pose,
            columns: Vec::new(),
            pairs: Vec::new(),
            held: 0,
        };
        let mut gears = mechanism.spec().gears.iter();
        for joint in mechanism.joints() {
            let first = all.columns.len();
            match &joint {
                Joint::Hinge { point, bodies } => {
                    let at = mechanism.place(pose, *point).place();
                    for body in &bodies[1..] {
                        for way in [Vector::x(), Vector::y()] {
                            all.add([*body, bodies[0]], at, way, 0.0);
                        }
                    }
                }
                Joint::Slide {
                    bodies: [on, body],
                    point,
                    line,
                } => {
                    let [at, from, to] = [*point, line[0], line[1]]
                        .map(|point| mechanism.place(pose, point).place());
                    let way = (to - from).normalize();
                    all.add([*body, *on], at, Vector::new(-way.y, way.x), 0.0);
                    all.add([*body, *on], at, Vector::zeros(), 1.0);
                }
                Joint::Mesh {
                    bodies,
                    carrier,
                    teeth: [first, second],
                } => {
                    // The place of an idler is not known: the mesh exerts couples.
                    if gears
                        .next()
                        .is_some_and(|gear| gear.mesh == Mesh::AsPrinted)
                    {
                        let most = first.abs().max(second.abs());
                        let teeth = [*first, *second, -first - second].map(|z| z / most);
                        let couples = [bodies[0], bodies[1], *carrier].into_iter().zip(teeth);
                        let column = couples.map(|(body, couple)| {
                            (body, wrench(Point::origin(), Vector::zeros(), couple, 1.0))
                        });
                        all.columns.push(column.collect());
                        all.pairs.push((joint, all.columns.len() - 1));
                        continue;
                    }
                    let centres = bodies.map(|wheel| {
                        let own = mechanism.points_on(wheel);
                        let shared = own.into_iter().find(|point| {
                            mechanism.points_on(*carrier).any(|other| other == *point)
                        });
                        mechanism.place(pose, shared.unwrap()).place()
                    });
                    let way = centres[1] - centres[0];
                    let contact = centres[0] + way * (first / (first + second));
                    let way = way.normalize();
                    all.add(*bodies, contact, Vector::new(-way.y, way.x), 0.0);
                }
            }
            all.pairs.push((joint, first));
        }
        all.held = all.columns.len();
        all
    }

    fn add(&mut self, [body, base]: [BodyId; 2], at: Point, force: Vector, couple: f64) {
        let both = [(body, 1.0), (base, -1.0)];
        let column = both.map(|(body, sign)| (body, wrench(at, force, couple, sign)));
        self.columns.push(column.to_vec());
    }

    pub(super) fn drives(&mut self) {
        let spec = self.mechanism.spec().clone();
        let body = |name: &str| self.mechanism.body_of(self.mechanism.link(name));
        let mut found = Vec::new();
        for driver in &spec.drivers {
            match driver {
                DriverSpec::Crank { link, base, .. } => {
                    found.push((
                        [body(link), body(base)],
                        Point::origin(),
                        Vector::zeros(),
                        1.0,
                    ));
                }
                DriverSpec::Slide { slide, .. } => {
                    let slide = &spec.slides[*slide];
                    let place = |name: &String| {
                        let point = self.mechanism.point(name).unwrap();
                        self.mechanism.place(self.pose, point).place()
                    };
                    let way = (place(&slide.line[1]) - place(&slide.line[0])).normalize();
                    let bodies = [body(&slide.link), body(&slide.on)];
                    found.push((bodies, place(&slide.point), way, 0.0));
                }
            }
        }
        for (bodies, at, force, couple) in found {
            self.add(bodies, at, force, couple);
        }
    }

    /// The matrix, and the wrenches that the components must balance.
    pub(super) fn system(
        &self,
        loaded: &Loaded,
        [rate, acceleration]: [f64; 2],
    ) -> (DMatrix<f64>, DVector<f64>) {
        let Self {
            mechanism, pose, ..
        } = self;
        let count = mechanism.bodies().len() - 1;
        let size = mechanism.size();
        let mut matrix = DMatrix::zeros(3 * count, self.columns.len());
        let mut right = DVector::zeros(3 * count);
        for (k, column) in self.columns.iter().enumerate() {
            for (body, wrench) in column {
                if let Some(row) = body.index().checked_sub(1) {
                    for (part, value) in wrench.iter().enumerate() {
                        // Moments are divided by the size, and so are couples among the unknowns.
                        let unit = if part == 2 { size } else { 1.0 };
                        let is_couple = column[0].1[0] == 0.0 && column[0].1[1] == 0.0;
                        let own = if is_couple { size } else { 1.0 };
                        matrix[(3 * row + part, k)] += value * own / unit;
                    }
                }
            }
        }
        let mut act = |body: BodyId, at: Point, force: Vector, couple: f64| {
            if let Some(row) = body.index().checked_sub(1) {
                for (part, value) in wrench(at, force, couple, -1.0).into_iter().enumerate() {
                    let unit = if part == 2 { size } else { 1.0 };
                    right[3 * row + part] += value / unit;
                }
            }
        };
        for link in mechanism.link_ids() {
            let spec = &mechanism.spec().links[link.index()];
            let Some(mass) = spec.mass else { continue };
            let body = mechanism.body_of(Some(link));
            let points = mechanism.points_of(link);
            let place = |point| mechanism.carried(pose, link, point).unwrap();
            let (centre, bar) = match (&spec.centre_of_mass, points) {
                (Some(name), _) => {
                    let centre = place(mechanism.point(name).unwrap());
                    ([0, 1, 2].map(|order| derivative(&centre, order)), 0.0)
                }
                (None, [first, second, ..]) => {
                    let [a, b] = [*first, *second].map(place);
                    let middle = [0, 1, 2]
                        .map(|order| 0.5 * (derivative(&a, order) + derivative(&b, order)));
                    let length = (a.place() - b.place()).norm();
                    (middle, mass * length * length / 12.0)
                }
                (None, points) => {
                    let only = place(points[0]);
                    ([0, 1, 2].map(|order| derivative(&only, order)), 0.0)
                }
            };
            let inertia = spec.inertia.unwrap_or(bar);
            let accelerated = centre[2] * rate * rate + centre[1] * acceleration;
            let angle = mechanism.body_angle(pose, body);
            let spin = angle.derivative(2) * rate * rate + angle.derivative(1) * acceleration;
            act(
                body,
                Point::from(centre[0]),
                (loaded.gravity - accelerated) * mass,
                -inertia * spin,
            );
        }
        for (link, point, force) in &loaded.forces {
            let link = mechanism.link(link).unwrap();
            let point = mechanism.point(point).unwrap();
            let at = mechanism.carried(pose, link, point).unwrap().place();
            act(mechanism.body_of(Some(link)), at, *force, 0.0);
        }
        (matrix, right)
    }

    /// Force and moment about a place on a body from the components of a pair.
    pub(super) fn on(&self, solution: &DVector<f64>, pair: usize, body: BodyId) -> Vector {
        let first = self.pairs[pair].1;
        let end = self.pairs.get(pair + 1).map_or(self.held, |next| next.1);
        let mut force = Vector::zeros();
        for k in first..end {
            for (on, wrench) in &self.columns[k] {
                if *on == body {
                    force += Vector::new(wrench[0], wrench[1]) * solution[k];
                }
            }
        }
        force
    }
}

fn derivative(point: &JetPoint<3>, order: usize) -> Vector {
    match order {
        0 => point.place().coords,
        _ => point.derivative(order),
    }
}
