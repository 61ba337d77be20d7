//! Properties of the forces in random linkages of every class: group by group they are those of all Newton–Euler equations
//! at once; their power is zero; Zhukovsky's lever is in equilibrium.

use assur::forces::{
    AnchorSpec, Applied, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec, Reactions,
};
use assur::gears::Mesh;
use assur::mechanism::{BodyId, FRAME, Joint, Mechanism, Pose};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::scaled;
use nalgebra::{DMatrix, DVector};

use super::random::Random;
use crate::any_drawing::linkage::Linkage;

/// How many linkages are compared in a quick run.
const LINKAGES: usize = 2_000;

/// Condition beyond which a pose is counted apart.
const ILL: f64 = 1e6;

/// A linkage with random masses and loads.
struct Loaded {
    motion: Motion,
    loading: Loading,
    forces: Vec<(String, String, Vector)>,
    gravity: Vector,
}

impl Loaded {
    fn new(seed: u64) -> Option<Self> {
        let mut random = Random::new(91_000_000 + seed);
        let mut draft = Linkage::new(seed, Linkage::parts_of(seed)).draft;
        for link in &mut draft.links {
            // Some links have no mass, some are uniform bars, some have a mass anywhere.
            match random.below(4) {
                0 => {}
                1 => link.mass = Some(random.within(0.1, 5.0)),
                _ => {
                    link.mass = Some(random.within(0.1, 5.0));
                    link.inertia = Some(random.within(0.0, 3.0));
                    let centre = random.below(link.points.len());
                    link.centre_of_mass = Some(link.points[centre].clone());
                }
            }
        }
        let forces = draft.links.iter().filter(|link| link.name != FRAME);
        let forces = forces.map(|link| {
            let point = link.points[random.below(link.points.len())].clone();
            let force = Vector::new(random.within(-20.0, 20.0), random.within(-20.0, 20.0));
            (link.name.clone(), point, force)
        });
        let forces: Vec<_> = forces.collect();
        let gravity = Vector::new(random.within(-5.0, 5.0), random.within(-10.0, 0.0));
        let loads = forces.iter().map(|(link, point, force)| LoadSpec::Force {
            at: AnchorSpec::new(link, point),
            direction: force.y.atan2(force.x),
            turns: false,
            law: Law::Constant(force.norm()),
        });
        let spec = LoadingSpec {
            gravity,
            loads: loads.collect(),
            ..LoadingSpec::default()
        };
        let mechanism = Mechanism::new(&draft).ok()?;
        if mechanism.mobility().q() != 0 {
            return None;
        }
        let loading = Loading::new(&mechanism, &spec).unwrap();
        let motion = Motion::new(mechanism);
        Some(Self {
            motion,
            loading,
            forces,
            gravity,
        })
    }
}

/// The equations of Newton and Euler of all bodies, about the origin, with the components of all pairs as unknowns.
struct NewtonEuler<'a> {
    mechanism: &'a Mechanism,
    pose: &'a Pose<3>,
    /// Columns: the wrenches (force, moment) of unit components on bodies.
    columns: Vec<Vec<(BodyId, [f64; 3])>>,
    /// For each pair its first column.
    pairs: Vec<(Joint, usize)>,
    /// Number of columns of pairs; those of drives follow.
    held: usize,
}

fn wrench(at: Point, force: Vector, couple: f64, sign: f64) -> [f64; 3] {
    [force.x, force.y, at.coords.perp(&force) + couple].map(|part| sign * part)
}

impl<'a> NewtonEuler<'a> {
    fn new(mechanism: &'a Mechanism, pose: &'a Pose<3>) -> Self {
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

    fn drives(&mut self) {
        use assur::linkage::DriverSpec;
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
    fn system(
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
    fn on(&self, solution: &DVector<f64>, pair: usize, body: BodyId) -> Vector {
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

fn derivative(point: &assur::JetPoint<3>, order: usize) -> Vector {
    match order {
        0 => point.place().coords,
        _ => point.derivative(order),
    }
}

/// Names of a pair in both lists.
fn name(mechanism: &Mechanism, joint: &Joint) -> String {
    match joint {
        Joint::Hinge { point, .. } | Joint::Slide { point, .. } => {
            mechanism.point_name(*point).to_owned()
        }
        Joint::Mesh { .. } => String::new(),
    }
}

/// Force on a body from all pairs of a kind with a name.
fn found_on(
    mechanism: &Mechanism,
    forces: &Kinetostatics,
    found: &Reactions,
    (name, slide, mesh): (&str, bool, bool),
    bodies: &[BodyId],
    body: BodyId,
) -> Vector {
    let pairs = forces.pairs().filter(|(_, pair)| {
        pair.is_slide() == slide
            && pair.is_mesh() == mesh
            && (mesh || pair.name(mechanism) == name)
            && pair.bodies.iter().all(|one| bodies.contains(one))
    });
    let parts = pairs.map(|(id, pair)| {
        let force = found.of(id).vector().unwrap();
        match pair.bodies {
            [on, _] if on == body => force,
            [_, from] if from == body => -force,
            _ => Vector::zeros(),
        }
    });
    parts.sum()
}

/// Power of the applied forces, as forces in velocities and as moments about the pole of the velocity plan turned by a
/// quarter turn; a couple is two forces there.
fn powers(mechanism: &Mechanism, pose: &Pose<3>, applied: &[Applied], rate: f64) -> [f64; 3] {
    let (mut power, mut lever, mut size) = (0.0, 0.0, 0.0);
    for one in applied {
        let place = one.place(mechanism);
        let velocity = |at: Point| mechanism.fixed_to(pose, one.body, at).derivative(1) * rate;
        let spin = mechanism.body_angle(pose, one.body).derivative(1) * rate;
        let own = one.force.dot(&velocity(place)) + one.couple * spin;
        power += own;
        size += one.force.norm() * velocity(place).norm() + (one.couple * spin).abs();
        let turned = |at: Point| {
            let v = velocity(at);
            Vector::new(-v.y, v.x)
        };
        let arm = mechanism.size();
        let beside = place + Vector::new(arm, 0.0);
        let push = Vector::new(0.0, one.couple / arm);
        lever += turned(place).perp(&(one.force - push)) + turned(beside).perp(&push);
    }
    [power, lever, size]
}

#[test]
fn forces_group_by_group_are_those_of_all_equations_at_once() {
    let (mut compared, mut ill, mut blocks) = (0, 0, std::collections::BTreeMap::new());
    let (mut worst, mut worst_power) = (0.0_f64, 0.0_f64);
    let mut seed = 0;
    while compared < scaled(LINKAGES as u16) as usize {
        seed += 1;
        let Some(loaded) = Loaded::new(seed) else {
            continue;
        };
        let mut random = Random::new(92_000_000 + seed);
        let motion = &loaded.motion;
        let arcs = motion.cycle().arcs();
        let [from, to] = arcs[random.below(arcs.len())];
        if !(from < to) {
            continue;
        }
        let input = random.within(from, to);
        let Ok(pose) = motion.pose::<3>(input) else {
            continue;
        };
        let mechanism = motion.mechanism();
        let rates = [random.within(-5.0, 5.0), random.within(-9.0, 9.0)];
        let mut all = NewtonEuler::new(mechanism, &pose);
        all.drives();
        let (matrix, right) = all.system(&loaded, rates);
        assert_eq!(matrix.nrows(), matrix.ncols(), "seed {seed}");
        let values = matrix.clone().svd(false, false).singular_values;
        let condition = values.max() / values.min();
        compared += 1;
        if !(condition < ILL) {
            ill += 1;
            continue;
        }
        let solution = matrix.full_piv_lu().solve(&right).unwrap();
        let forces = Kinetostatics::new(mechanism);
        for bodies in forces.order() {
            *blocks.entry(bodies.len()).or_insert(0) += 1;
        }
        let found = forces.reactions(&loaded.loading, &pose, input, rates);
        let found = found.unwrap_or_else(|error| panic!("seed {seed}: {error:?}"));
        let greatest = solution.amax().max(right.amax());
        let bound = 1e-12 * greatest * condition;
        for (k, (joint, _)) in all.pairs.iter().enumerate() {
            let bodies = joint.bodies();
            let kind = (
                name(mechanism, joint),
                matches!(joint, Joint::Slide { .. }),
                matches!(joint, Joint::Mesh { .. }),
            );
            let kind = (kind.0.as_str(), kind.1, kind.2);
            for body in bodies {
                let expected = all.on(&solution, k, *body);
                let found = found_on(mechanism, &forces, &found, kind, bodies, *body);
                let off = (found - expected).amax();
                worst = worst.max(off / (greatest * condition));
                assert!(
                    off <= bound,
                    "seed {seed}, {joint:?}: {off:e} of {greatest:e}, condition {condition:e}"
                );
            }
            if let Joint::Slide {
                bodies: [_, moving],
                ..
            } = joint
            {
                let expected = solution[all.pairs[k].1 + 1] * mechanism.size();
                let pairs = forces.pairs().find(|(_, pair)| {
                    pair.is_slide()
                        && pair.name(mechanism) == kind.0
                        && pair.bodies.iter().all(|one| bodies.contains(one))
                });
                let (id, pair) = pairs.unwrap();
                let sign = if pair.bodies[0] == *moving { 1.0 } else { -1.0 };
                let off = sign * found.of(id).moment.unwrap() - expected;
                assert!(
                    off.abs() <= bound * mechanism.size(),
                    "seed {seed}, {joint:?}: {off:e}"
                );
            }
        }
        let mut driven = 0.0;
        for (driver, spec) in forces.drivers().zip(&mechanism.spec().drivers) {
            let own = found.drive(driver).unwrap();
            let unit = match spec {
                assur::linkage::DriverSpec::Crank { .. } => mechanism.size(),
                assur::linkage::DriverSpec::Slide { .. } => 1.0,
            };
            let off = own - solution[all.held + driver.index()] * unit;
            assert!(off.abs() <= bound * unit, "seed {seed}, {spec:?}: {off:e}");
            driven += own * spec.rate() * rates[0];
        }
        let [power, lever, size] = powers(mechanism, &pose, found.applied(), rates[0]);
        let bound = 1e-12 * condition * size.max(greatest * mechanism.size() * rates[0].abs());
        worst_power = worst_power.max((driven + power).abs() / (bound * 1e12));
        assert!(
            (driven + power).abs() <= bound,
            "seed {seed}: power {}",
            driven + power
        );
        assert!(
            (driven - lever).abs() <= bound,
            "seed {seed}: lever {}",
            driven - lever
        );
        let reduced = loaded.loading.reduced(mechanism, &pose, input);
        let off = reduced.balancing(rates[0], rates[1]) * rates[0] - driven;
        assert!(off.abs() <= bound, "seed {seed}: reduced {off:e}");
    }
    println!(
        "{compared} of {seed} seeds, {ill} ill, blocks by bodies {blocks:?}, worst {worst:e}, {worst_power:e}"
    );
    assert!(
        ill * 100 <= compared,
        "{ill} of {compared} poses are ill-conditioned"
    );
    assert!(blocks.keys().any(|bodies| *bodies > 2));
}
