//! Trains under load.

use super::*;

#[test]
fn what_is_not_followed_under_load_is_named() {
    let not = [json!({"code": "not_under_load"})];
    assert_eq!(unloadable(|d| d.coupling = CouplingDocument::Contact), not);
    let bevel = |d: &mut GearTrainDocument| {
        d.form = FormDocument::Bevel;
        d.z4 = 24.0;
    };
    assert_eq!(unloadable(bevel), not);
    let stepped = |d: &mut GearTrainDocument| {
        d.form = FormDocument::Stepped;
        d.z2_step = Some(9.0);
    };
    assert_eq!(unloadable(stepped), not);
    let longest = out_of_range("span_s", 31.0, 0.5, 30.0);
    assert_eq!(unloadable(|d| d.span_s = 31.0), [longest]);
}

/// Alternating poles require an even number of plates on each wheel. All satellites must have the same phase in periods
/// of the field, of two plates each.
#[test]
fn alternating_poles_need_even_wheels_and_their_own_phase() {
    let alternating = |d: &mut GearTrainDocument, z4: f64, satellites: f64| {
        d.magnets.poles = PolesDocument::Alternating;
        d.z4 = z4;
        d.satellites = satellites;
    };
    let odd = [json!({"code": "odd_plates", "field": "z4"})];
    assert_eq!(refused(|d| alternating(d, 43.0, 3.0)), odd);
    assert_eq!(unloadable(|d| alternating(d, 43.0, 3.0)), odd);
    let phase = |satellites: u32, periods: u32| {
        [json!({"code": "out_of_phase", "satellites": satellites, "periods": periods})]
    };
    assert_eq!(unloadable(|d| d.satellites = 4.0), phase(4, 63));
    // 62 plates are 31 periods. Two satellites divide 62, so like poles fit, but they do not divide 31.
    assert_eq!(unloadable(|d| alternating(d, 42.0, 2.0)), phase(2, 31));
    for (z4, satellites, left, met) in [(42.0, 2.0, 31.0, false), (44.0, 4.0, 32.0, true)] {
        let mut document = read();
        alternating(&mut document, z4, satellites);
        let train = document.train().unwrap();
        let conditions = train.layout.conditions(train.coupling);
        let mut conditions = conditions.iter();
        let found = conditions.find(|one| one.kind == ConditionKind::Assembly);
        let found = found.unwrap();
        assert_eq!((found.left, found.met()), (left, met));
        assert_eq!(train.layout.can_be_built(train.coupling), met);
        for near in train.layout.suggestions(train.coupling, 5) {
            use assur::gears::train::Member::{Ring, Satellite, Sun};
            let [sun, satellite, ring] = [Sun, Satellite, Ring].map(|of| near.train.teeth(of));
            assert!(
                [sun, satellite, ring].iter().all(|plates| plates % 2 == 0),
                "{near:?}"
            );
            assert_eq!((sun + ring) % (2 * satellites as u32), 0, "{near:?}");
        }
    }
}

#[test]
fn loads_that_cannot_be_are_named() {
    let load = |knots: &[[f64; 2]]| refused(|d| d.load = knots.to_vec());
    let order = [json!({"code": "load_order", "knot": 2})];
    assert_eq!(load(&[[1.0, 0.0], [1.0, 5.0]]), order);
    assert_eq!(load(&[[0.0, f64::NAN]]), [not_a_number("load[0][1]")]);
    assert_eq!(
        load(&[[0.0, 0.0], [f64::NAN, 0.0]]),
        [not_a_number("load[1][0]")]
    );
    assert_eq!(
        load(&[[1e10, 0.0]]),
        [out_of_range("load[0][0]", 1e10, -1e9, 1e9)]
    );
    let many: Vec<[f64; 2]> = (0..101).map(|at| [f64::from(at), 0.0]).collect();
    assert_eq!(
        load(&many),
        [json!({"code": "too_many", "path": "load", "max": 100})]
    );
    let heavy = unloadable(|d| d.load = vec![[0.0, 1e10]]);
    assert_eq!(heavy, [out_of_range("load", 1e10, -1e9, 1e9)]);
}

#[test]
fn bodies_magnets_and_members_are_named_under_load() {
    let light = unloadable(|d| d.bodies.inertia[1] = 1e-12);
    assert_eq!(
        light,
        [json!({"code": "too_quick", "field": "bodies.inertia[1]"})]
    );
    assert_eq!(
        unloadable(|d| d.bodies.inertia[3] = 0.0),
        [not_positive("bodies.inertia[3]", 0.0)]
    );
    assert_eq!(
        unloadable(|d| d.bodies.damping[2] = -1.0),
        [out_of_range("bodies.damping[2]", -1.0, 0.0, 1e9)]
    );
    assert_eq!(
        unloadable(|d| d.bodies.mass = f64::NAN),
        [not_a_number("bodies.mass")]
    );
    assert_eq!(
        unloadable(|d| d.magnets.peak[1] = -5.0),
        [not_positive("magnets.peak[1]", -5.0)]
    );
    assert_eq!(
        unloadable(|d| d.magnets.damping[0] = f64::INFINITY),
        [not_a_number("magnets.damping[0]")]
    );
    for kind in [MemberKind::Brush, MemberKind::Fan] {
        let member = |torque| Some(MemberDocument { kind, torque });
        let found = unloadable(|d| {
            d.members.satellite = member(-1.0);
            d.members.carrier = member(f64::NAN);
        });
        assert_eq!(found.len(), 2, "{found:?}");
        assert_eq!(found[0]["code"], "out_of_range");
        assert_eq!(found[0]["field"], "members.satellite.torque");
        assert_eq!(found[1], not_a_number("members.carrier.torque"));
    }
}
