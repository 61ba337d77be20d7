use super::*;
use crate::forces::{Loading, LoadingSpec, samples};
use crate::linkage::LinkageSpec;
use crate::motion::Motion;

fn plan_of(motion: &Motion, loading: &LoadingSpec) -> (Kinetostatics, ForcePlan) {
    let mechanism = motion.mechanism();
    let loading = Loading::new(mechanism, loading).unwrap();
    let forces = Kinetostatics::new(mechanism);
    let input = motion.drawn_input();
    let pose = motion.pose::<3>(input).unwrap();
    let found = forces.reactions(&loading, &pose, input, [0.0; 2]).unwrap();
    let plan = forces.plan(&found).unwrap();
    (forces, plan)
}

fn is(found: Vector, x: f64, y: f64) {
    let off = (found - Vector::new(x, y)).norm();
    assert!(off < 1e-12, "{found}, not ({x}, {y})");
}

/// By hand: moments of the rod about C give 10·2 + 5 Rᵗ = 0; then the polygon of the group closes
/// with 122 along the rod and 100 from the guide; the crank has the force (−100, 70) at its end.
#[test]
fn a_slider_crank_by_hand() {
    let (motion, loading) = samples::slider_crank();
    let (forces, plan) = plan_of(&motion, &loading);
    let kinds: Vec<StepKind> = plan.steps.iter().map(|step| step.kind).collect();
    use StepKind::{Moments, Polygon};
    assert_eq!(
        kinds,
        [Moments, Polygon, Polygon, Moments, Moments, Polygon]
    );
    let plans: Vec<usize> = plan.steps.iter().map(|step| step.plan).collect();
    assert_eq!(plans, [0, 0, 0, 0, 1, 1]);
    let about = |step: usize| {
        let about = plan.steps[step].about.unwrap();
        forces.pairs[about.0].name(motion.mechanism())
    };
    assert_eq!([0, 3, 4].map(about), ["C", "C", "A"]);
    let last = |step: usize| *plan.steps[step].terms.last().unwrap();
    let terms = &plan.steps[0].terms;
    assert_eq!(terms.len(), 2);
    assert!((terms[0].value - 20.0).abs() < 1e-12);
    assert!((terms[0].arm().unwrap() - 2.0).abs() < 1e-12);
    assert_eq!(last(0).name.part, Component::Tangential);
    is(last(0).force, 2.4, 3.2);
    assert!((last(0).value + 20.0).abs() < 1e-12);
    let found = plan.steps[1].terms.iter().filter(|term| !term.known);
    let mut found: Vec<Vector> = found.map(|term| term.force).collect();
    found.sort_by(|a, b| a.x.total_cmp(&b.x));
    is(found[0], 0.0, 100.0);
    is(found[1], 97.6, -73.2);
    is(last(1).ends[1], 0.0, 0.0);
    // The reaction of the inner hinge is the diagonal from the end of the rod's forces to their start.
    let on = plan.steps[2].bodies[0];
    let sign = if motion.mechanism().body_name(on) == "rod" {
        1.0
    } else {
        -1.0
    };
    is(last(2).force * sign, -100.0, 80.0);
    is(last(2).ends[1] - plan.steps[2].terms[0].ends[0], 0.0, 0.0);
    // All forces on the slider pass through C.
    assert!(last(3).is_couple && last(3).value.abs() < 1e-12);
    assert!(last(4).is_couple && (last(4).value + 300.0).abs() < 1e-12);
    is(last(5).force, 100.0, -70.0);
}

/// Three equal cranks carry one beam: nothing is drawn, and every reaction is named.
#[test]
fn what_is_indeterminate_is_named() {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 2.0, 0.0)
        .point("C", 5.0, 0.0)
        .point("P", 0.6, 0.8)
        .point("Q", 2.6, 0.8)
        .point("R", 5.6, 0.8)
        .fixed(&["A", "B", "C"])
        .bar("first", &["A", "P"])
        .bar("second", &["B", "Q"])
        .bar("third", &["C", "R"])
        .bar("beam", &["P", "Q", "R"])
        .with_mass(3.0, "R", 0.5)
        .crank("first");
    let motion = Motion::new(Mechanism::new(&spec).unwrap());
    let gravity = Vector::new(0.0, -10.0);
    let loading = LoadingSpec {
        gravity,
        ..LoadingSpec::default()
    };
    let (_, plan) = plan_of(&motion, &loading);
    let steps = plan.steps.iter();
    assert!(
        steps
            .clone()
            .all(|step| step.kind == StepKind::Indeterminate)
    );
    let open: Vec<usize> = steps.map(|step| step.open.len()).collect();
    assert_eq!(open.iter().sum::<usize>(), 9);
    // What the driver must do is known all the same.
    let mut known = plan.steps.iter().flat_map(|step| &step.terms);
    let torque = known.find(|term| matches!(term.name.cause, Cause::Drive { .. }));
    assert!((torque.unwrap().value - 18.0).abs() < 1e-12);
}
