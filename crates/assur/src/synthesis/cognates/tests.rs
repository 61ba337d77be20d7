use super::*;
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::perpendicular;

fn point(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// Crank (0, 0)–(0, 3), coupler to (4, 3), rocker from (4, −1), and the coupler point half-way and 2 above: w = ½ + ½i.
fn golden() -> CouplerFourBar {
    let pivots = [point(0.0, 0.0), point(4.0, -1.0)];
    let joints = [point(0.0, 3.0), point(4.0, 3.0)];
    CouplerFourBar::new(pivots, joints, point(2.0, 5.0)).unwrap()
}

/// w(B₀ − A₀) = (½ + ½i)(4 − i) = 2.5 + 1.5i. A′ = P − A = (2, 2); w(A − A₀) = (½ + ½i)3i = −1.5 + 1.5i. B′ = B₀ + P −
/// B = (2, 1); (1 − w)(B − B₀) = (½ − ½i)4i = 2 + 2i.
#[test]
fn cognates_of_a_pose_in_small_numbers() {
    let linkage = golden();
    assert_eq!(linkage.ratio(), Complex::new(0.5, 0.5));
    assert_eq!(linkage.third_pivot(), point(2.5, 1.5));
    let [first, second] = linkage.cognates().map(Result::unwrap);
    assert_eq!(first.pivots(), [point(0.0, 0.0), point(2.5, 1.5)]);
    assert_eq!(first.joints(), [point(2.0, 2.0), point(0.5, 3.5)]);
    assert_eq!(second.pivots(), [point(4.0, -1.0), point(2.5, 1.5)]);
    assert_eq!(second.joints(), [point(2.0, 1.0), point(4.0, 3.0)]);
    assert_eq!([first.point(), second.point()], [point(2.0, 5.0); 2]);
    // Lengths 3, 4, 4, √17 in another order, times √½.
    let l4 = 17_f64.sqrt();
    for (cognate, lengths) in [(first, [4.0, 3.0, 4.0, l4]), (second, [4.0, 4.0, 3.0, l4])] {
        for (found, expected) in cognate.lengths().into_iter().zip(lengths) {
            assert!(
                (found - expected * 0.5_f64.sqrt()).abs() < 1e-14,
                "{cognate:?}"
            );
        }
    }
}

/// The cognates of a cognate are the other two linkages.
#[test]
fn three_linkages_are_cognates_of_each_other() {
    let linkage = golden();
    let [first, _] = linkage.cognates().map(Result::unwrap);
    let [back, third] = first.cognates().map(Result::unwrap);
    for (found, expected) in [
        (back.joints(), linkage.joints()),
        (back.pivots(), linkage.pivots()),
    ] {
        assert!(
            (0..2).all(|k| (found[k] - expected[k]).norm() < 1e-14),
            "{found:?}"
        );
    }
    let [_, second] = linkage.cognates().map(Result::unwrap);
    let swapped = |[a, b]: [Point; 2]| [b, a];
    for (found, expected) in [
        (third.joints(), swapped(second.joints())),
        (third.pivots(), swapped(second.pivots())),
    ] {
        assert!(
            (0..2).all(|k| (found[k] - expected[k]).norm() < 1e-14),
            "{found:?}"
        );
    }
}

/// Chebyshev's linkage of crossed bars 5, 2, 5 on a frame of 4, whose coupler's middle is nearly straight: one cognate
/// is his lambda linkage, with a crank of 1 on a frame of 2 and bars of 2.5.
#[test]
fn chebyshevs_two_straight_lines_are_cognates() {
    let pivots = [point(-2.0, 0.0), point(2.0, 0.0)];
    let joints = [point(1.0, 4.0), point(-1.0, 4.0)];
    let crossed = CouplerFourBar::new(pivots, joints, point(0.0, 4.0)).unwrap();
    assert_eq!(crossed.grashof(), Ok(Grashof::DoubleRocker));
    for cognate in crossed.cognates() {
        let mut lengths = cognate.unwrap().lengths();
        lengths.sort_by(f64::total_cmp);
        for (found, expected) in lengths.into_iter().zip([1.0, 2.0, 2.5, 2.5]) {
            assert!((found - expected).abs() < 1e-14, "{lengths:?}");
        }
    }
}

#[test]
fn a_joint_or_a_parallelogram_has_no_cognate() {
    let linkage = golden();
    let ([a, b], pivots) = (linkage.joints(), linkage.pivots());
    let at = |place| CouplerFourBar::new(pivots, [a, b], place).unwrap();
    assert_eq!(at(a).cognates()[0], Err(NoCognate::AtJoint));
    assert_eq!(at(b).cognates()[1], Err(NoCognate::AtJoint));
    // The other cognate of the joint with the crank has the same crank.
    let other = at(a).cognates()[1].unwrap();
    assert_eq!((other.pivots()[1], other.joints()[1]), (pivots[0], a));
    assert_eq!(at(a).geared()[1], None);
    let joints = [point(1.0, 2.0), point(6.0, 2.0)];
    let pivots = [point(0.0, 0.0), point(5.0, 0.0)];
    let parallelogram = CouplerFourBar::new(pivots, joints, point(3.0, 4.0)).unwrap();
    assert_eq!(parallelogram.cognates(), [Err(NoCognate::Collapsed); 2]);
}

/// Crank 1 and rod 2 without offset, and the point of the rod at w = i: the guide turns upright, and the crank is 2
/// long.
#[test]
fn the_cognate_of_a_slider_crank_exchanges_crank_and_rod() {
    let (pivot, a) = (Point::origin(), point(0.0, 1.0));
    let b = point(3_f64.sqrt(), 0.0);
    let p = a + perpendicular(b - a);
    let linkage = CouplerSliderCrank::new(pivot, [a, b], Vector::x(), p).unwrap();
    let cognate = linkage.cognate().unwrap();
    let [crank, rod, offset] = cognate.lengths();
    assert!((crank - 2.0).abs() < 1e-14 && (rod - 1.0).abs() < 1e-14 && offset.abs() < 1e-14);
    assert!((cognate.guide() - Vector::y()).norm() < 1e-15);
    // The slider of the cognate is at the place of the given slider, rotated by a quarter turn about the pivot.
    assert!((cognate.joints()[1] - point(0.0, 3_f64.sqrt())).norm() < 1e-14);
    let back = cognate.cognate().unwrap();
    assert!((back.joints()[1] - b).norm() < 1e-14);
    let end = CouplerSliderCrank::new(pivot, [a, b], Vector::x(), a).unwrap();
    assert_eq!(end.cognate(), Err(NoCognate::AtJoint));
}

#[test]
fn places_that_form_no_linkage_are_refused() {
    let far = [point(0.0, 0.0), point(1.0, 0.0)];
    let refused = CouplerFourBar::new(far, [point(f64::NAN, 0.0); 2], point(0.0, 0.0));
    assert_eq!(refused, Err(CouplerError::NotFinite));
    let refused = CouplerFourBar::new(far, [point(1.0, 1.0); 2], point(0.0, 0.0));
    assert!(matches!(refused, Err(CouplerError::Lengths(_))));
    let slider = |a, b, guide| CouplerSliderCrank::new(Point::origin(), [a, b], guide, a);
    let (a, b) = (point(1.0, 0.0), point(3.0, 0.0));
    assert_eq!(
        slider(Point::origin(), b, Vector::x()),
        Err(SliderCrankError::Crank)
    );
    assert_eq!(slider(a, a, Vector::x()), Err(SliderCrankError::Rod));
    assert_eq!(slider(a, b, Vector::zeros()), Err(SliderCrankError::Guide));
}

/// A linkage is found again in its own mechanism.
#[test]
fn a_linkage_is_recognised() {
    let linkage = golden();
    let motion = Motion::new(Mechanism::new(&linkage.spec()).unwrap());
    let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
    let found = CouplerFourBar::of(motion.mechanism(), &pose, "P").unwrap();
    let off = |k: usize| (found.joints()[k] - linkage.joints()[k]).norm();
    assert!(off(0) < 1e-14 && off(1) < 1e-14 && (found.point() - linkage.point()).norm() < 1e-14);
    assert_eq!(CouplerSliderCrank::of(motion.mechanism(), &pose, "P"), None);
    let (a, b) = (point(0.0, 1.0), point(3.0, 0.5));
    let slider = CouplerSliderCrank::new(Point::origin(), [a, b], Vector::x(), point(1.0, 2.0));
    let slider = slider.unwrap();
    let motion = Motion::new(Mechanism::new(&slider.spec()).unwrap());
    let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
    let found = CouplerSliderCrank::of(motion.mechanism(), &pose, "P").unwrap();
    assert!((found.point() - slider.point()).norm() < 1e-14);
    assert_eq!(CouplerFourBar::of(motion.mechanism(), &pose, "P"), None);
}
