//! Properties of the forces in random linkages of every class: group by group they are those of all Newton–Euler equations
//! at once; their power is zero; Zhukovsky's lever is in equilibrium.

mod newton_euler;
mod plans;

use assur::forces::{
    AnchorSpec, Applied, Kinetostatics, Law, LoadSpec, Loading, LoadingSpec, Reactions,
};
use assur::mechanism::{BodyId, FRAME, Joint, Mechanism, Pose};
use assur::motion::Motion;
use assur::{Point, Vector};
use assur_tests::scaled;
use newton_euler::NewtonEuler;

use super::random::Random;
use crate::any_drawing::linkage::Linkage;

/// How many linkages are compared in a quick run.
const LINKAGES: usize = 2_000;

/// Condition beyond which a pose is counted apart: of the equations, or of the direction of a slide.
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
    let (mut worst_plan, mut worst_lever) = (0.0_f64, 0.0_f64);
    let mut steps = std::collections::BTreeMap::new();
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
        if from >= to {
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
        let lines = mechanism
            .joints()
            .into_iter()
            .filter_map(|joint| match joint {
                Joint::Slide { line, .. } => {
                    let [from, to] = line.map(|point| mechanism.place(&pose, point).place());
                    Some((to - from).norm())
                }
                _ => None,
            });
        // The direction of a line through two places has this condition.
        let line = mechanism.size() / lines.fold(f64::INFINITY, f64::min);
        if condition.is_nan() || condition >= ILL || line >= ILL {
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
        let off = plans::equations((mechanism, &pose), &forces, &found, seed);
        // A factor below 1e-9 is written as zero.
        let least = bound.max(1e-9 * greatest);
        assert!(off.force <= least, "seed {seed}: {:e}", off.force);
        let moment = off.moment / mechanism.size();
        assert!(moment <= least, "seed {seed}: {moment:e}");
        let plan = forces.plan(&found);
        let plan = plan.unwrap_or_else(|error| panic!("seed {seed}: {error:?}"));
        for step in &plan.steps {
            *steps.entry(format!("{:?}", step.kind)).or_insert(0) += 1;
        }
        let off = plans::plan(&forces, &found, &plan);
        let scale = mechanism.size();
        worst_plan = worst_plan.max(off.force.max(off.moment / scale) / (greatest * condition));
        assert!(
            off.force <= bound && off.moment <= bound * scale,
            "seed {seed}: plan {:e} {:e} of {greatest:e}, condition {condition:e}",
            off.force,
            off.moment
        );
        if let Some(off) = plans::lever(mechanism, &pose, &found) {
            let unit = if mechanism.turns() { scale } else { 1.0 };
            worst_lever = worst_lever.max(off.abs() / unit / (greatest * condition));
            assert!(
                off.abs() <= bound * unit,
                "seed {seed}: lever {off:e} of {greatest:e}, condition {condition:e}"
            );
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
        "{compared} of {seed} seeds, {ill} ill, blocks by bodies {blocks:?}, worst {worst:e}, {worst_power:e}; \
         plans {steps:?}, worst {worst_plan:e}, lever {worst_lever:e}"
    );
    assert!(steps.len() == 4, "{steps:?}");
    assert!(
        ill * 100 <= compared,
        "{ill} of {compared} poses are ill-conditioned"
    );
    assert!(blocks.keys().any(|bodies| *bodies > 2));
}
