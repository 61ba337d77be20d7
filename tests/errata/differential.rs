//! The differential paper: a misprint in its conditions.

use assur::gears::train::{ConditionKind, Coupling, Layout, Relation, Train};

/// The distance from the main axis to the satellite's outermost point, and the
/// ring's inner radius: there is a gap where the first is less. (2) as printed asks
/// for a distance of the axes with which they overlap.
#[test]
fn differential_2_sign_of_the_gap_at_the_ring() {
    let train = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let (satellite, ring) = (18.0, 60.0);
    for distance in [15.0, 19.5, 20.0, 20.9, 21.1, 25.0] {
        let free = distance + satellite / 2.0 < ring / 2.0;
        let layout = Layout::new(train, 1.0, 1.0, Some(distance)).unwrap();
        let conditions = layout.conditions(Coupling::Magnetic);
        let ours = conditions
            .iter()
            .find(|condition| condition.kind == ConditionKind::RingGap)
            .unwrap();
        assert_eq!(ours.relation, Relation::Less);
        assert_eq!(ours.met(), free, "{distance}");
        assert_eq!(layout.gaps().unwrap()[1] > 0.0, free, "{distance}");
        let printed = distance > (ring - satellite) / 2.0;
        assert_eq!(printed, !free, "{distance}");
    }
}
