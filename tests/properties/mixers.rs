//! The mixer as an ordinary linkage: it moves as the closed form of its four-bar predicts.

use std::f64::consts::TAU;

use assur::gears::Mesh;
use assur::mechanism::{Multiple, Pose, Quantity};
use assur::mixer::{Carrier, Case, Mixer, Tracer};
use assur::motion::{Motion, OutputProfile, PoseOrder, Unjoinable};
use assur::{Assembly, FourBar, Jet, Link, Offset, Swing};
use assur_tests::{Rocker, scaled, scaled_swing};
use proptest::prelude::*;

use super::draw::{config, linkage, posed};

/// As in golden.rs: of a value, its first and its second derivative.
const TOLERANCE: [f64; 3] = [1e-12, 1e-11, 1e-10];

pub(crate) fn mixer(linkage: &FourBar, assembly: Assembly) -> Mixer {
    let mut dimensions = Case::A.dimensions();
    (dimensions.lengths, dimensions.assembly) = (linkage.lengths(), assembly);
    let carriers = [
        Carrier::Crank,
        Carrier::Coupler,
        Carrier::Rocker,
        Carrier::Wheel(0),
    ];
    dimensions.tracers = carriers
        .map(|carrier| Tracer {
            carrier,
            x: 0.3,
            y: -0.2,
        })
        .to_vec();
    Mixer::new(&dimensions).unwrap()
}

fn agree<const N: usize>(
    mixer: &Mixer,
    motion: &Motion,
    crank: f64,
    size: f64,
) -> Result<(), TestCaseError>
where
    Pose<N>: PoseOrder,
{
    let (Ok(exact), Ok(pose)) = (
        mixer.linkage.pose_along::<N>(mixer.assembly, crank),
        motion.pose::<N>(crank),
    ) else {
        let [one, other] = [
            mixer.linkage.pose_along::<N>(mixer.assembly, crank).is_ok(),
            motion.pose::<N>(crank).is_ok(),
        ];
        prop_assert_eq!(one, other, "{:?} at {}", mixer.linkage, crank);
        return Ok(());
    };
    let mechanism = motion.mechanism();
    let pose: &Pose<N> = &pose;
    let link = |name: &str| mechanism.link(name).unwrap();
    let angle = |name: &str| mechanism.angle(pose, link(name));
    let ratio = mixer.gears.pairs()[0].ratio();
    let near = |found: Jet<N>, expected: Jet<N>, units: [f64; 3], what: &str| {
        for (order, unit) in units.iter().enumerate().take(N) {
            let [found, expected] = [found, expected].map(|jet| jet.derivative(order));
            let off = (found - expected).abs();
            let bound = (TOLERANCE[order] * expected.abs()).max(*unit);
            prop_assert!(
                off <= bound,
                "{:?} {:?} at {crank}: {what} {order}: {found} against {expected}",
                mixer.linkage,
                mixer.assembly
            );
        }
        Ok(())
    };
    for (name, expected) in [
        ("crank", exact.crank),
        ("coupler", exact.coupler),
        ("rocker", exact.rocker),
        ("wheel4", exact.rocker),
        ("wheel5", exact.rocker * ratio),
    ] {
        near(angle(name), expected, TOLERANCE, name)?;
    }
    // C is the coupler's here and the rocker's there: the derivatives of the loop close
    // relative to the size of their terms, less what a short diagonal loses (poses.rs).
    let [first, second] = [1, 2].map(|order| {
        let rates = [exact.coupler, exact.rocker].map(|angle| angle.derivative(order).abs());
        rates[0].max(rates[1]).max(1.0)
    });
    let [_, b, _, d] = mixer.linkage.joints(&exact).map(|joint| joint.place());
    let steep = size / (d - b).norm();
    let units = [
        TOLERANCE[0] * size,
        TOLERANCE[1].max(1e-14 * steep) * size * first,
        TOLERANCE[2].max(1e-13 * steep * steep) * size * second.max(first * first),
    ];
    let point = |name: &str| mechanism.place(pose, mechanism.point(name).unwrap());
    let [a, b, c, d] = mixer.linkage.joints(&exact);
    let centre = |link: Link| mixer.linkage.carried(&exact, link, Offset::MIDDLE);
    let traced = |k: usize| mixer.traced(&exact, &mixer.tracers()[k]);
    for (name, expected) in [
        ("A", a),
        ("B", b),
        ("C", c),
        ("D", d),
        ("C1", centre(Link::Crank)),
        ("C2", centre(Link::Coupler)),
        ("C3", centre(Link::Rocker)),
        ("P1", traced(0)),
        ("P2", traced(1)),
        ("P3", traced(2)),
        ("P4", traced(3)),
    ] {
        let found = point(name);
        near(found.x, expected.x, units, name)?;
        near(found.y, expected.y, units, name)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(scaled(600)))]

    /// The same inputs have a pose, and it is the same with two derivatives, in the
    /// same whole turns.
    #[test]
    fn a_mixer_is_a_linkage((linkage, assembly, crank) in posed(), off in -1.0..7.0_f64) {
        let mixer = mixer(&linkage, assembly);
        let motion = match mixer.motion() {
            Ok(motion) => motion,
            Err(reason) => return Err(TestCaseError::fail(format!("{linkage:?}: {reason:?}"))),
        };
        let cycle = linkage.cycle();
        prop_assert_eq!(motion.cycle().is_full(), cycle.is_full());
        prop_assert_eq!(motion.cycle().period(), cycle.period());
        prop_assert_eq!(motion.cycle().arcs().len(), cycle.arcs().len());
        for (found, arc) in motion.cycle().arcs().iter().zip(cycle.arcs()) {
            for end in [0, 1] {
                prop_assert!((found[end] - arc[end]).abs() < 1e-9, "{found:?} {arc:?}");
            }
        }
        let inside = |crank: f64| cycle.arcs().iter().any(|[from, to]| {
            *from + 1e-12 <= crank && crank <= *to - 1e-12
        });
        let size = linkage.lengths().into_iter().fold(0.3, f64::max);
        let crank = cycle.wrap(crank);
        if inside(crank) {
            agree::<1>(&mixer, &motion, crank, size)?;
            agree::<3>(&mixer, &motion, crank, size)?;
        }
        // Where there is none, there is none in both.
        if !cycle.contains(off) {
            prop_assert!(motion.pose::<1>(off).is_err(), "{linkage:?} at {off}");
        } else if inside(cycle.wrap(off)) {
            let off = cycle.wrap(off);
            agree::<1>(&mixer, &motion, off, size)?;
            agree::<3>(&mixer, &motion, off, size)?;
        }
    }

    /// Dead points and change points are those of the closed form.
    #[test]
    fn ends_and_crossings((linkage, assembly) in linkage()) {
        let motion = mixer(&linkage, assembly).motion().unwrap();
        let dead: Vec<f64> = motion.dead_points().iter().map(|dead| dead.input).collect();
        let expected = linkage.dead_points();
        prop_assert_eq!(dead.len(), expected.len());
        prop_assert!(dead.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
        let mut expected: Vec<f64> = linkage.change_points().iter().map(|p| p.crank).collect();
        // Where a kite swings freely its motions meet as well.
        let swings = linkage.pose::<1>(assembly, 0.0);
        if matches!(swings, Err(assur::Unsolved::Undetermined { .. })) {
            let turns = (motion.cycle().period().unwrap() / TAU).round() as u32;
            expected.extend((0..turns).map(|turn| TAU * f64::from(turn)));
            expected.sort_by(f64::total_cmp);
        }
        let found = motion.change_points();
        prop_assert_eq!(found.len(), expected.len(), "{:?}: {:?} {:?}", linkage, found, expected);
        prop_assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}

/// The profile of the angle of a link.
fn profile<'a>(motion: &'a Motion, link: &str) -> OutputProfile<'a> {
    let quantity = Quantity::named(motion.mechanism(), &format!("{link}.angle"));
    OutputProfile::new(motion, quantity.unwrap()).unwrap()
}

proptest! {
    #![proptest_config(config(scaled(300)))]

    /// Its one dyad and four-bar, and the transmission angle, are the four-bar's.
    #[test]
    fn transmission_is_the_four_bars((linkage, assembly, crank) in posed()) {
        let motion = mixer(&linkage, assembly).motion().unwrap();
        let mechanism = motion.mechanism();
        let [four_bar] = mechanism.four_bars()[..] else { panic!("one four-bar") };
        prop_assert_eq!(four_bar.linkage, linkage);
        prop_assert_eq!(four_bar.grashof(), linkage.grashof());
        prop_assert_eq!(four_bar.base, None);
        let links = [four_bar.crank, four_bar.coupler, four_bar.rocker];
        let named = links.map(|link| mechanism.link_name(link));
        prop_assert_eq!(named, ["crank", "coupler", "rocker"]);
        let joints = four_bar.joints.map(|point| mechanism.point_name(point));
        prop_assert_eq!(joints, ["A", "B", "C", "D"]);
        let [dyad] = mechanism.rrr_dyads()[..] else { panic!("one dyad") };
        prop_assert_eq!(mechanism.point_name(dyad.inner), "C");
        let mut outer = dyad.outer.map(|outer| {
            let on = outer.on.map(|on| mechanism.link_name(on));
            (mechanism.point_name(outer.point), on)
        });
        outer.sort();
        prop_assert_eq!(outer, [("B", Some("crank")), ("D", None)]);
        // Lines of short links are known the worse.
        let [_, l2, l3, _] = linkage.lengths();
        let longest = linkage.lengths().into_iter().fold(0.0, f64::max);
        let bound = 1e-14 * longest / l2.min(l3) + 1e-13;
        if let (Ok(expected), Ok(pose)) =
            (linkage.transmission_angle(crank), motion.pose::<1>(crank))
        {
            let found = mechanism.transmission_angle(&pose, &dyad);
            prop_assert!((found - expected).abs() < bound, "{linkage:?}: {found} {expected}");
        }
        let (worst, at) = linkage.worst_transmission();
        let least = motion.least_transmission(&dyad).unwrap().unwrap();
        prop_assert!(
            (least.angle - worst).abs() <= bound,
            "{linkage:?} {assembly:?}: {least:?}, {worst} at {at}"
        );
    }

    /// Limits, swing, travel and time ratio of the rocker and of a wheel.
    #[test]
    fn limits_are_the_four_bars((linkage, assembly) in linkage()) {
        let mixer = mixer(&linkage, assembly);
        let motion = mixer.motion().unwrap();
        for (link, ratio) in [("rocker", 1.0), ("wheel5", mixer.gears.pairs()[0].ratio())] {
            let profile = profile(&motion, link);
            let limits = linkage.limits(assembly);
            let found = profile.limits();
            prop_assert_eq!(found.len(), limits.len(), "{:?} {:?}: {:?} {:?}", linkage, assembly, found, limits);
            for (found, limit) in found.iter().zip(limits) {
                prop_assert!((found.input - limit.crank).abs() < 1e-9, "{linkage:?}: {found:?} {limit:?}");
                prop_assert!((found.value - ratio * limit.rocker).abs() < 1e-9, "{linkage:?}");
            }
            let swings = linkage.swings(assembly).into_iter();
            let swings = swings.map(|swing| scaled_swing(swing, ratio));
            for (found, expected) in profile.swings().into_iter().zip(swings) {
                match (found, expected) {
                    (Swing::Turns, Swing::Turns) => {}
                    (Swing::Between { min: a, max: b }, Swing::Between { min, max }) => {
                        let off = (a - min).abs().max((b - max).abs());
                        prop_assert!(off < 1e-9, "{linkage:?}: {found:?} {expected:?}");
                    }
                    _ => prop_assert!(false, "{linkage:?}: {found:?} {expected:?}"),
                }
            }
            for (found, travel) in profile.travels().iter().zip(linkage.travels(assembly)) {
                let off = (found - ratio.abs() * travel).abs();
                prop_assert!(off < 1e-8, "{linkage:?} {assembly:?}: {found} {travel}");
            }
            match (profile.time_ratio(), linkage.time_ratio(assembly)) {
                (Some(found), Some(expected)) => {
                    prop_assert!((found - expected).abs() < 1e-8 * expected, "{linkage:?}");
                }
                (found, expected) => prop_assert_eq!(found, expected),
            }
        }
    }
}

/// A wheel's angle is a multiple of the rocker's.
#[test]
fn multiples() {
    for mesh in [Mesh::External, Mesh::Internal, Mesh::AsPrinted] {
        let mut dimensions = Case::A.dimensions();
        dimensions.mesh = mesh;
        let mixer = Mixer::new(&dimensions).unwrap();
        let motion = mixer.motion().unwrap();
        let mechanism = motion.mechanism();
        let link = |name: &str| mechanism.link(name).unwrap();
        let ratio = mixer.gears.pairs()[0].ratio();
        for (name, of, factor) in [
            ("wheel5", "rocker", ratio),
            ("wheel4", "rocker", 1.0),
            ("rocker", "rocker", 1.0),
            ("crank", "crank", 1.0),
        ] {
            let of = link(of);
            let expected = Multiple {
                of,
                factor,
                offset: 0.0,
            };
            assert_eq!(mechanism.multiple_of(link(name)), expected, "{name}");
        }
    }
}

/// Motions of one linkage over different inputs are joined, others not.
#[test]
fn only_motions_of_one_linkage_are_joined() {
    let two = FourBar::new([2.0, 1.0, 2.5, 2.0]).unwrap();
    assert_eq!(two.cycle().arcs().len(), 2);
    let motion = mixer(&two, Assembly::First).motion().unwrap();
    assert_eq!(motion.cycle(), &two.cycle());
    assert_eq!(
        motion.clone().joined(motion.clone()).unwrap_err(),
        Unjoinable::Overlap
    );
    let other = FourBar::new([2.0, 1.0, 2.6, 2.0]).unwrap();
    let other = mixer(&other, Assembly::First).motion().unwrap();
    assert_eq!(motion.joined(other).unwrap_err(), Unjoinable::OtherLinkage);
}
