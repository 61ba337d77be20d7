//! The conditions for building a train, against geometry.

use assur::gears::train::{
    Condition, ConditionKind, Coupling, Kind, Layout, Member, Relation, Train,
};
use proptest::prelude::*;

use super::draw::{bevel_teeth, config, planar, stepped, teeth};

fn find(conditions: &[Condition], kind: ConditionKind) -> Option<&Condition> {
    conditions.iter().find(|condition| condition.kind == kind)
}

/// Whether a satellite can be put in at a k-th of a turn from the first one, by
/// trying all its angles that fit the sun: phases in pitches, whole where teeth
/// meet gaps, in units of 1/(k z₂).
fn fits([z1, z2, step, z4]: [u32; 4], k: u32) -> bool {
    let [z1, z2, step, z4, k] = [z1, z2, step, z4, k].map(i64::from);
    (0..z2).any(|n| (step * (z1 + z2 + n * k) - z2 * (step - z4)) % (k * z2) == 0)
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn assembly_is_that_of_the_phases(teeth in teeth(), k in 1..=6_u32) {
        let [z1, z2, _, z4] = teeth;
        let one = planar(teeth).differential().assembly(k);
        prop_assert_eq!([one.left, one.right], [f64::from(z1 + z4), f64::from(k)]);
        prop_assert_eq!(one.met(), (z1 + z4) % k == 0);
        prop_assert_eq!(one.met(), fits([z1, z2, z2, z4], k));
        let two = stepped(teeth).differential().assembly(k);
        prop_assert_eq!(two.met(), fits(teeth, k));
    }

    #[test]
    fn gaps_are_what_is_between_the_circles(
        teeth in teeth(),
        k in 1..=6_u32,
        module in 0.1..10.0_f64,
        part in -0.2..1.2_f64,
    ) {
        let train = stepped(teeth);
        let [d1, d2, step, d4] = [Member::Sun, Member::Satellite, Member::Step, Member::Ring]
            .map(|member| module * f64::from(train.teeth(member)));
        let room = (d4 - step) / 2.0 - (d1 + d2) / 2.0;
        let distance = (d1 + d2) / 2.0 + part * room;
        prop_assume!(room.abs() > 1e-3 && distance > 0.0 && part.abs() > 1e-3 && (1.0 - part).abs() > 1e-3);
        let layout = Layout::new(train, f64::from(k), module, Some(distance)).unwrap();
        let conditions = layout.conditions(Coupling::Magnetic);
        let met = |kind| find(&conditions, kind).unwrap().met();
        prop_assert_eq!(met(ConditionKind::Room), room > 0.0);
        prop_assert_eq!(met(ConditionKind::SunGap), distance - d2 / 2.0 > d1 / 2.0);
        prop_assert_eq!(met(ConditionKind::RingGap), distance + step / 2.0 < d4 / 2.0);
        let [sun, ring] = layout.gaps().unwrap();
        prop_assert!((sun - part * room).abs() < 1e-11);
        prop_assert!((ring - (1.0 - part) * room).abs() < 1e-11);
        prop_assert!(find(&conditions, ConditionKind::Coaxiality).is_none());
        // Without a distance the gaps are equal.
        let equal = Layout::new(train, f64::from(k), module, None).unwrap();
        let [sun, ring] = equal.gaps().unwrap();
        prop_assert!((sun - ring).abs() < 1e-11 && (sun + ring - room).abs() < 1e-11);
    }

    #[test]
    fn neighbours_are_apart_by_the_chord(teeth in teeth(), k in 2..=6_u32) {
        let [z1, z2, _, z4] = teeth.map(f64::from);
        let angle = std::f64::consts::PI / f64::from(k);
        let layout = Layout::new(planar(teeth), f64::from(k), 1.0, None).unwrap();
        for (coupling, distance, tip) in [
            (Coupling::Contact, (z1 + z2) / 2.0, z2 + 2.0),
            (Coupling::Magnetic, (z1 + z4) / 4.0, z2),
        ] {
            let conditions = layout.conditions(coupling);
            let found = find(&conditions, ConditionKind::Neighbours).unwrap();
            let clear = 2.0 * distance * angle.sin() - tip;
            prop_assert!((found.left - angle.sin()).abs() < 1e-15);
            prop_assert!((found.right - tip / (2.0 * distance)).abs() < 1e-13 * (1.0 + found.right));
            if clear.abs() > 1e-9 {
                prop_assert_eq!(found.met(), clear > 0.0);
            }
        }
    }

    /// Tip cones of bevel satellites, by the angle between their axes.
    #[test]
    fn bevel_neighbours_are_apart_by_their_cones(teeth in bevel_teeth(), k in 2..=6_u32) {
        let [z1, z2, z4] = teeth.map(f64::from);
        let train = Train::bevel([z1, z2, z4]).unwrap();
        let layout = Layout::new(train, f64::from(k), 1.0, None).unwrap();
        let axis = train.inclination();
        let turn = std::f64::consts::TAU / f64::from(k);
        let between = axis.cos().powi(2) + axis.sin().powi(2) * turn.cos();
        let between = between.clamp(-1.0, 1.0).acos();
        let cone = (2.0 * z2 * axis.sin() / (z1 + z4)).atan();
        let length = z2 / 2.0 / cone.sin();
        let tip = cone + (1.0 / length).atan();
        let conditions = layout.conditions(Coupling::Contact);
        prop_assert_eq!(conditions.len(), 2);
        let found = find(&conditions, ConditionKind::Neighbours).unwrap();
        if (between - 2.0 * tip).abs() > 1e-6 {
            prop_assert_eq!(found.met(), between > 2.0 * tip);
        }
        prop_assert_eq!(layout.gaps(), None);
    }
}

/// Gears in contact are coaxial and have no gap; magnets are not coaxial as gears.
#[test]
fn contact_and_magnets_exclude_each_other() {
    let kinds = |layout: &Layout, coupling| -> Vec<(ConditionKind, Relation, bool)> {
        let conditions = layout.conditions(coupling);
        let told = conditions.iter().map(|c| (c.kind, c.relation, c.met()));
        told.collect()
    };
    use ConditionKind::*;
    use Relation::*;
    let contact = Train::in_contact([20.0, 60.0]).unwrap().unwrap();
    assert_eq!(contact.kind(), Kind::Planar);
    let layout = Layout::new(contact, 4.0, 0.3, None).unwrap();
    assert_eq!(
        kinds(&layout, Coupling::Contact),
        [
            (Coaxiality, Equal, true),
            (Assembly, Multiple, true),
            (Neighbours, Greater, true)
        ]
    );
    assert_eq!(
        kinds(&layout, Coupling::Magnetic)[..3],
        [
            (Room, Greater, false),
            (SunGap, Greater, false),
            (RingGap, Less, false)
        ]
    );
    assert_eq!(layout.gaps(), Some([0.0; 2]));
    let magnets = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let layout = Layout::new(magnets, 1.0, 0.3, None).unwrap();
    assert_eq!(
        kinds(&layout, Coupling::Contact),
        [(Coaxiality, Equal, false), (Assembly, Multiple, true)]
    );
    assert!(layout.can_be_built(Coupling::Magnetic));
    let found = layout.conditions(Coupling::Contact)[0];
    assert_eq!([found.left, found.right], [60.0, 56.0]);
}
