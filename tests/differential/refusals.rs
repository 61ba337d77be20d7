//! Every reason why a train does not exist, or its motion is not determined.

use assur::Fault;
use assur::gears::train::{
    Counts, Differential, InputError, Layout, Member, Shaft, Train, TrainError,
};

use super::draw::{given, tied};

#[test]
fn all_bad_numbers_are_named_at_once() {
    let teeth = |member, fault| TrainError::Teeth { member, fault };
    assert_eq!(
        Train::planar([0.0, -3.0, 1.5]).unwrap_err(),
        [
            teeth(Member::Sun, Fault::NotPositive { value: 0.0 }),
            teeth(Member::Satellite, Fault::NotPositive { value: -3.0 }),
            teeth(Member::Ring, Fault::NotWhole { value: 1.5 }),
        ]
    );
    let (min, max) = (3.0, 1000.0);
    assert_eq!(
        Train::stepped([f64::NAN, 20.0, 2.0, 1e9]).unwrap_err(),
        [
            teeth(Member::Sun, Fault::NotFinite),
            teeth(
                Member::Step,
                Fault::OutOfRange {
                    value: 2.0,
                    min,
                    max
                }
            ),
            teeth(
                Member::Ring,
                Fault::OutOfRange {
                    value: 1e9,
                    min,
                    max
                }
            ),
        ]
    );
    let not_finite = Train::bevel([20.0, f64::INFINITY, 20.0]).unwrap_err();
    assert_eq!(not_finite, [teeth(Member::Satellite, Fault::NotFinite)]);
    let of_shafts = Differential::planar([2.5, -1.0]).unwrap_err();
    assert_eq!(
        of_shafts,
        [
            teeth(Member::Sun, Fault::NotWhole { value: 2.5 }),
            teeth(Member::Ring, Fault::NotPositive { value: -1.0 }),
        ]
    );
}

#[test]
fn a_planar_ring_is_the_largest() {
    let smaller = |sun, ring| TrainError::RingNotLarger { sun, ring };
    let outside = |satellite, ring| TrainError::SatelliteNotInside { satellite, ring };
    assert_eq!(
        Train::planar([20.0, 10.0, 20.0]).unwrap_err(),
        [smaller(20, 20)]
    );
    assert_eq!(
        Train::planar([20.0, 60.0, 60.0]).unwrap_err(),
        [outside(60, 60)]
    );
    assert_eq!(
        Train::stepped([30.0, 10.0, 40.0, 20.0]).unwrap_err(),
        [smaller(30, 20), outside(40, 20)]
    );
    assert_eq!(
        Train::in_contact([30.0, 20.0]).unwrap_err(),
        [smaller(30, 20)]
    );
    assert_eq!(
        Differential::planar([20.0, 20.0]).unwrap_err(),
        [smaller(20, 20)]
    );
}

#[test]
fn bevel_wheels_need_common_cones() {
    let no_cones = |sun, satellite, ring| {
        vec![TrainError::NoCones {
            sun,
            satellite,
            ring,
        }]
    };
    assert_eq!(
        Train::bevel([20.0, 10.0, 40.0]).unwrap_err(),
        no_cones(20, 10, 40)
    );
    assert_eq!(
        Train::bevel([50.0, 10.0, 20.0]).unwrap_err(),
        no_cones(50, 10, 20)
    );
    assert!(Train::bevel([20.0, 10.0, 39.0]).is_ok());
    assert!(Train::bevel([20.0, 10.0, 20.0]).is_ok());
}

#[test]
fn layouts_name_what_is_wrong() {
    let train = Train::planar([20.0, 18.0, 60.0]).unwrap();
    let (min, max) = (1.0, 6.0);
    assert_eq!(
        Layout::new(train, 7.0, 0.0, Some(f64::NAN)).unwrap_err(),
        [
            TrainError::Satellites {
                fault: Fault::OutOfRange {
                    value: 7.0,
                    min,
                    max
                }
            },
            TrainError::Module {
                fault: Fault::NotPositive { value: 0.0 }
            },
            TrainError::AxisDistance {
                fault: Fault::NotFinite
            },
        ]
    );
    for (value, fault) in [
        (0.0, Fault::NotPositive { value: 0.0 }),
        (2.5, Fault::NotWhole { value: 2.5 }),
    ] {
        assert_eq!(Counts::new(value), Err(TrainError::Satellites { fault }));
    }
}

#[test]
fn inputs_that_do_not_determine_the_motion_are_named() {
    use Shaft::{Carrier, Ring, Sun};
    let train = Train::planar([20.0, 20.0, 60.0]).unwrap().differential();
    let refused = |inputs: &[_]| train.solve(inputs).unwrap_err();
    assert_eq!(refused(&[]), [InputError::Underdetermined { given: 0 }]);
    assert_eq!(
        refused(&[given(Sun, 1.0)]),
        [InputError::Underdetermined { given: 1 }]
    );
    let all = [given(Sun, 1.0), given(Carrier, 1.0), given(Ring, 1.0)];
    assert_eq!(refused(&all), [InputError::Overdetermined { given: 3 }]);
    let twice = [given(Ring, 1.0), given(Ring, 1.0)];
    assert_eq!(refused(&twice), [InputError::Twice { shaft: Ring }]);
    let itself = [tied(Sun, Sun, 2.0), given(Ring, f64::NAN)];
    assert_eq!(
        refused(&itself),
        [
            InputError::TiedToItself { shaft: Sun },
            InputError::Number {
                shaft: Ring,
                fault: Fault::NotFinite
            }
        ]
    );
    // ω₄ = −ω₁ z₁/z₄ holds the carrier whatever the speed is.
    let factor = -20.0 / 60.0;
    let singular = [given(Carrier, 3.0), tied(Ring, Sun, factor)];
    let (shaft, to) = (Ring, Sun);
    assert_eq!(
        refused(&singular),
        [InputError::SingularTie { shaft, to, factor }]
    );
    // The same tie twice.
    let same = [tied(Ring, Sun, 2.0), tied(Sun, Ring, 0.5)];
    let factor = 2.0;
    assert_eq!(
        refused(&same),
        [InputError::SingularTie { shaft, to, factor }]
    );
    // Next to the singular one it works, and a tie with the tied shaft driven does.
    assert!(
        train
            .solve(&[given(Carrier, 3.0), tied(Ring, Sun, -0.33)])
            .is_ok()
    );
    let speeds = train
        .solve(&[given(Carrier, 3.0), tied(Carrier, Sun, 2.0)])
        .unwrap();
    assert_eq!([speeds.sun, speeds.carrier, speeds.ring], [1.5, 3.0, 3.5]);
    // Two held shafts, or two ties, hold the train.
    let held = train
        .solve(&[given(Carrier, 0.0), given(Ring, 0.0)])
        .unwrap();
    assert_eq!(held.sun, 0.0);
    let fault = train.torques(Sun, f64::INFINITY).unwrap_err();
    assert_eq!(fault, Fault::NotFinite);
}
