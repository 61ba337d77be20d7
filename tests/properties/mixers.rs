//! A mixer as a linkage like any other moves as its four-bar's closed form says.

use assur::catalog::mixer::{Carrier, Case, Mixer, Tracer};
use assur::mechanism::Pose;
use assur::motion::Motion;
use assur::{Assembly, FourBar, Jet, Link, Offset};
use proptest::prelude::*;

use crate::draw::{config, linkage, posed};

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
) -> Result<(), TestCaseError> {
    let (Ok(exact), Ok(pose)) = (
        mixer.linkage.pose::<N>(mixer.assembly, crank),
        motion.pose::<N>(crank),
    ) else {
        let [one, other] = [
            mixer.linkage.pose::<N>(mixer.assembly, crank).is_ok(),
            motion.pose::<N>(crank).is_ok(),
        ];
        prop_assert_eq!(one, other, "{:?} at {}", mixer.linkage, crank);
        return Ok(());
    };
    let mechanism = motion.mechanism();
    let pose: &Pose<N> = &pose;
    let link = |name: &str| mechanism.links().position(|link| link == name).unwrap();
    let angle = |name: &str| mechanism.angle(pose, link(name));
    let ratio = mixer.gears.pairs()[0].ratio();
    let near = |found: Jet<N>, expected: Jet<N>, unit: f64, what: &str| {
        for (order, tolerance) in TOLERANCE.iter().enumerate().take(N) {
            let [found, expected] = [found, expected].map(|jet| jet.derivative(order));
            let off = (found - expected).abs();
            prop_assert!(
                off <= tolerance * expected.abs().max(unit),
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
        near(angle(name), expected, 1.0, name)?;
    }
    // Places lose what the rates of the angles blow up.
    let rates = [exact.coupler, exact.rocker].map(|angle| angle.derivative(1).abs());
    let unit = size * (1.0 + rates[0].max(rates[1])).powi(2);
    let point = |name: &str| {
        let at = mechanism.points().position(|point| point == name).unwrap();
        mechanism.place(pose, at)
    };
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
        near(found.x, expected.x, unit, name)?;
        near(found.y, expected.y, unit, name)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(6_000))]

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
        let expected: Vec<f64> = linkage.change_points().iter().map(|p| p.crank).collect();
        let found = motion.change_points();
        prop_assert_eq!(found.len(), expected.len(), "{:?}: {:?} {:?}", linkage, found, expected);
        prop_assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}
