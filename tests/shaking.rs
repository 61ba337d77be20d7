//! Shaking force and moment; full static balance of a four-bar.

use assur::forces::{Kinetostatics, Loading, LoadingSpec, counterweights};
use assur::mechanism::{LinkId, Mechanism};
use assur::motion::Motion;
use assur_file::{LinkageDocument, from_catalogue};
use assur_tests::assert_near;

fn four_bar() -> LinkageDocument {
    let mut document = from_catalogue("crank-rocker").unwrap().unwrap();
    for (link, mass) in document.links.iter_mut().zip([1.0, 3.0, 2.0]) {
        link.mass_kg = Some(mass);
    }
    document
}

/// Shaking force and moment over a turn, at a rate of 5 rad/s.
fn shaking(mechanism: &Mechanism, loading: &Loading) -> Vec<(assur::Vector, f64)> {
    let statics = Kinetostatics::new(mechanism);
    let motion = Motion::new(mechanism.clone());
    let inputs = (0..36).map(|step| motion.drawn_input() + f64::from(step) * 0.17);
    let found = inputs.map(|input| {
        let pose = motion.pose(input).unwrap();
        let found = statics
            .reactions(loading, &pose, input, [5.0, 0.0])
            .unwrap();
        found.shaking(mechanism)
    });
    found.collect()
}

/// Without loads and gravity the frame bears the shaking force alone: it is the sum of the reactions on it.
#[test]
fn the_frame_bears_the_shaking_force() {
    let mechanism = four_bar().mechanism().unwrap();
    let loading = Loading::new(&mechanism, &LoadingSpec::default()).unwrap();
    let statics = Kinetostatics::new(&mechanism);
    let motion = Motion::new(mechanism.clone());
    let input = motion.drawn_input() + 0.5;
    let pose = motion.pose(input).unwrap();
    let found = statics
        .reactions(&loading, &pose, input, [5.0, 2.0])
        .unwrap();
    let on_frame = statics
        .pairs()
        .filter(|(_, pair)| mechanism.body_name(pair.bodies[1]) == "frame");
    let borne: assur::Vector = on_frame
        .map(|(id, _)| -found.of(id).vector().unwrap())
        .sum();
    let (force, _) = found.shaking(&mechanism);
    assert_near((borne - force).norm(), 0.0, 1e-10 * force.norm(), "force");
}

#[test]
fn counterweights_balance_a_four_bar() {
    let mut document = four_bar();
    let mechanism = document.mechanism().unwrap();
    let loading = Loading::new(&mechanism, &LoadingSpec::default()).unwrap();
    let before = shaking(&mechanism, &loading);
    let most = before
        .iter()
        .map(|(force, _)| force.norm())
        .fold(0.0, f64::max);
    let motion = Motion::new(mechanism.clone());
    let pose = motion.pose(motion.drawn_input()).unwrap();
    let weights = counterweights(&mechanism, &loading, &pose).unwrap();
    // Each counterweight as a link of its own, fixed to the one that bears it, of 10 kg.
    for (k, weight) in weights.iter().enumerate() {
        let hinge = mechanism.point_name(weight.hinge).to_owned();
        let at = document
            .points
            .iter()
            .find(|point| point.name == hinge)
            .unwrap()
            .at;
        let centre = format!("W{k}");
        let own = serde_json::json!({
            "name": format!("weight {k}"), "points": [hinge, centre], "centre_of_mass": centre, "mass_kg": 10.0,
            "inertia": 0.0, "fixed_to": mechanism.body_name(weight.body),
        });
        let at = [
            at[0] + weight.moment.x / 10.0,
            at[1] + weight.moment.y / 10.0,
        ];
        document
            .points
            .push(serde_json::from_value(serde_json::json!({ "name": centre, "at": at })).unwrap());
        document.links.push(serde_json::from_value(own).unwrap());
    }
    let balanced = document.mechanism().unwrap();
    assert_eq!(balanced.link_ids().map(LinkId::index).count(), 5);
    let loading = Loading::new(&balanced, &LoadingSpec::default()).unwrap();
    for (force, _) in shaking(&balanced, &loading) {
        assert_near(force.norm(), 0.0, 1e-9 * most, "balanced");
    }
}

#[test]
fn only_a_four_bar_has_this_rule() {
    for id in ["class4-dwell", "slider-crank-offset"] {
        let mechanism = from_catalogue(id).unwrap().unwrap().mechanism().unwrap();
        let loading = Loading::new(&mechanism, &LoadingSpec::default()).unwrap();
        let motion = Motion::new(mechanism.clone());
        let pose = motion.pose(motion.drawn_input()).unwrap();
        assert_eq!(counterweights(&mechanism, &loading, &pose), None, "{id}");
    }
}
