//! Dimensions for a wanted motion: the result of each search is checked independently.

use assur::Point;
use assur::mechanism::{Dimension, LinkageSpec, Mechanism, Quantity};
use assur::motion::{Motion, OutputProfile};
use assur::synthesis::dwell::{DesignVariable, End, Search, SearchError, Target};
use assur_file::from_catalogue;

/// The dwell that the catalogue's mechanism has.
const WISH: Target = Target {
    tolerance: 0.1 * std::f64::consts::PI / 180.0,
    arc: 184.28 * std::f64::consts::PI / 180.0,
    stroke: 43.2908 * std::f64::consts::PI / 180.0,
};
const OUTPUT: &str = "CD.angle";

fn length(of: &Mechanism, link: &str, range: [f64; 2]) -> DesignVariable {
    let dimension = Dimension::Length(of.link(link).unwrap());
    DesignVariable { dimension, range }
}

/// The Class IV mechanism with FK lengthened.
fn perturbed(fk: f64) -> Mechanism {
    let mut draft = from_catalogue("class4-dwell").unwrap().unwrap().spec();
    let link = draft.links.iter_mut().find(|link| link.name == "FK");
    link.unwrap().shape = Some(vec![Point::origin(), Point::new(fk, 0.0)]);
    Mechanism::new(&draft).unwrap()
}

/// Steps until the search is over, or so many candidates were judged.
fn run(search: &mut Search, most: usize) -> Vec<f64> {
    let mut residuals = vec![search.progress().evaluation.residual];
    while search.progress().end.is_none() && search.progress().judged < most {
        let progress = search.step();
        if progress.accepted {
            residuals.push(progress.evaluation.residual);
        }
    }
    residuals
}

/// What the draft of a search does, found without it: arc, stroke; it turns fully.
fn checked(found: &Mechanism) -> [f64; 2] {
    let mechanism = Mechanism::new(found.spec()).unwrap();
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    assert!(motion.cycle().is_full() && motion.dead_points().is_empty());
    assert!(motion.singularity_margin().abs() >= 1e-3);
    let profile = OutputProfile::new(&motion, Quantity::named(mechanism, OUTPUT).unwrap()).unwrap();
    let values = (0..3600).map(|k| {
        let pose = motion
            .pose::<1>(f64::from(k) * 0.1_f64.to_radians())
            .unwrap();
        let output = mechanism.link("CD").unwrap();
        mechanism.angle(&pose, output).value()
    });
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    [profile.dwell(WISH.tolerance).unwrap().length(), high - low]
}

#[test]
fn perturbed_length_is_found_again() {
    for fk in [4.062, 4.112, 4.212] {
        let start = perturbed(fk);
        let freedoms = [length(&start, "FK", [3.9, 4.4])];
        let mut search = Search::new(&start, OUTPUT, WISH, &freedoms).unwrap();
        let residuals = run(&mut search, 60);
        let last = search.progress().evaluation;
        assert!(last.residual <= 0.5 * residuals[0], "{fk}: {residuals:?}");
        assert!(residuals.is_sorted_by(|a, b| a > b), "{residuals:?}");
        let [arc, stroke] = checked(search.mechanism());
        assert!((arc - last.arc).abs() < 1e-6, "{arc} {last:?}");
        assert!((stroke - last.stroke).abs() < 1e-5, "{stroke} {last:?}");
        assert!((3.9..=4.4).contains(&search.values()[0]));
    }
}

/// Several dimensions at once, by twice; the same search ends the same.
#[test]
fn several_dimensions() {
    let start = perturbed(4.112);
    let freedoms = [
        length(&start, "FK", [3.95, 4.3]),
        length(&start, "CD", [6.5, 6.8]),
        length(&start, "BE", [3.9, 4.02]),
        DesignVariable {
            dimension: Dimension::X(start.point("D").unwrap()),
            range: [-0.35, -0.15],
        },
    ];
    let run = || {
        let mut search = Search::new(&start, OUTPUT, WISH, &freedoms).unwrap();
        let residuals = run(&mut search, 100);
        assert!(
            residuals[residuals.len() - 1] <= 0.5 * residuals[0],
            "{residuals:?}"
        );
        for (value, freedom) in search.values().iter().zip(&freedoms) {
            assert!((freedom.range[0]..=freedom.range[1]).contains(value));
            let of = search.mechanism().value(freedom.dimension).unwrap();
            assert!((of - value).abs() < 1e-12);
        }
        checked(search.mechanism());
        search.values().to_vec()
    };
    assert_eq!(run(), run());
}

/// What cannot be reached within the bounds ends with the best there is.
#[test]
fn the_impossible_ends_with_what_was_reached() {
    let wish = Target {
        stroke: 3.0,
        ..WISH
    };
    let start = perturbed(4.02);
    let freedoms = [length(&start, "FK", [4.0, 4.05])];
    let mut search = Search::new(&start, OUTPUT, wish, &freedoms).unwrap();
    run(&mut search, 1000);
    let progress = search.progress();
    assert_eq!(progress.end, Some(End::Settled), "{progress:?}");
    assert!(progress.evaluation.residual > 0.5);
    checked(search.mechanism());
    // It is over.
    assert_eq!(search.step().judged, progress.judged);
}

#[test]
fn what_is_reached_already_is_fulfilled() {
    let mut wish = WISH;
    wish.arc = 1.0;
    let start = perturbed(4.02);
    let variables = [length(&start, "FK", [4.0, 4.05])];
    let search = Search::new(&start, OUTPUT, wish, &variables).unwrap();
    wish.stroke = search.progress().evaluation.stroke;
    let search = Search::new(&start, OUTPUT, wish, &variables).unwrap();
    assert_eq!(search.progress().end, Some(End::Fulfilled));
}

#[test]
fn refusals_name_their_field() {
    let start = perturbed(4.02);
    let good = [length(&start, "FK", [4.0, 4.05])];
    let refused = |wish: Target, freedoms: &[DesignVariable]| {
        Search::new(&start, OUTPUT, wish, freedoms)
            .map(|_| ())
            .unwrap_err()
    };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let with = |set: fn(&mut Target, f64)| {
            let mut wish = WISH;
            set(&mut wish, bad);
            refused(wish, &good)
        };
        assert_eq!(
            with(|wish, bad| wish.tolerance = bad),
            SearchError::Tolerance
        );
        assert_eq!(with(|wish, bad| wish.arc = bad), SearchError::Arc);
        assert_eq!(with(|wish, bad| wish.stroke = bad), SearchError::Stroke);
    }
    assert_eq!(refused(WISH, &[]), SearchError::Rigid);
    // A link with two points has no corner.
    let corner = DesignVariable {
        dimension: Dimension::Corner(start.link("FK").unwrap(), 2),
        range: [1.0, 9.0],
    };
    assert_eq!(refused(WISH, &[good[0], corner]), SearchError::Dimension(1));
    let joint = Dimension::Y(start.point("E").unwrap());
    let moving = [DesignVariable {
        dimension: joint,
        range: [-9.0, 9.0],
    }];
    assert_eq!(refused(WISH, &moving), SearchError::Dimension(0));
    for range in [
        [4.0, 4.01],
        [4.05, 4.0],
        [f64::NAN, 5.0],
        [0.0, 5.0],
        [-1.0, 5.0],
    ] {
        assert_eq!(
            refused(WISH, &[length(&start, "FK", range)]),
            SearchError::Range(0)
        );
    }
    let output = Search::new(&start, "CD.colour", WISH, &good).map(|_| ());
    assert_eq!(output.unwrap_err(), SearchError::Output);
    // A double rocker: the driven link cannot turn fully.
    let stuck = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.6, 1.7)
        .point("C", 1.6, 1.7)
        .point("D", 2.2, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    let stuck = Mechanism::new(&stuck).unwrap();
    let variables = [length(&stuck, "rocker", [1.0, 3.0])];
    let stuck = Search::new(&stuck, "rocker.angle", WISH, &variables);
    assert_eq!(stuck.map(|_| ()).unwrap_err(), SearchError::Blocked);
}
