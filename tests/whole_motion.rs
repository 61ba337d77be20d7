//! What is read off a whole motion: of many turns as finely as of one, of a small part as of a large one.

use std::f64::consts::{PI, TAU};
use std::fs;

use assur::mechanism::{Defect, Dimension, DriverSpec, LinkageSpec, Mechanism, Quantity};
use assur::motion::{Column, InputRate, Motion, OutputProfile, Refusal};
use assur::{Swing, Vector};
use assur_draw::chart::Settings;
use assur_draw::svg::Svg;
use assur_draw::{Figure, View};
use assur_file::from_text;
use assur_tests::files::root;

fn file(name: &str) -> Motion {
    let path = root().join(format!("tests/data/drawings/{name}.json"));
    let text = fs::read_to_string(path).unwrap();
    from_text(&text).unwrap().motion().unwrap()
}

fn moved(draft: &LinkageSpec) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

fn quantity(motion: &Motion, name: &str) -> Quantity {
    Quantity::named(motion.mechanism(), name).unwrap()
}

/// The numbers behind a letter or an attribute of a text, one after the other.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|letter: char| !(letter.is_ascii_digit() || "-.e".contains(letter)));
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// The chart of a quantity as it is drawn: the points of each curve, and the places of the dots at its extrema.
fn drawn(motion: &Motion, name: &str) -> (Vec<Vec<[f64; 2]>>, Vec<[f64; 2]>) {
    let figure = Figure::new(motion, &View::default()).unwrap();
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let mut sheet = Svg::new(20_000.0);
    sheet.chart(
        2000.0,
        &figure.chart(&[quantity(motion, name)], settings),
        "φ",
    );
    let text = sheet.finish(name);
    let attribute = |line: &str, name: &str| {
        let (_, rest) = line.split_once(&format!("{name}=\""))?;
        Some(rest.split_once('"')?.0.to_owned())
    };
    let paths = text.lines().filter_map(|line| attribute(line, "<path d"));
    let curves = paths.map(|path| {
        let places = numbers(&path);
        places.chunks_exact(2).map(|at| [at[0], at[1]]).collect()
    });
    // What has more than a few points is a curve, not a line of the grid.
    let curves = curves.filter(|curve: &Vec<[f64; 2]>| curve.len() > 9);
    let dots = text.lines().filter(|line| line.contains("<circle"));
    let dots = dots.filter(|line| attribute(line, " r").as_deref() == Some("3"));
    let dots = dots.map(|line| ["cx", "cy"].map(|name| attribute(line, name).unwrap()));
    let dots = dots.map(|at| at.map(|x| x.parse().unwrap()));
    (curves.collect(), dots.collect())
}

/// A motion of 31 turns is plotted with as many samples to a turn as one of a single turn: marked extrema lie on the curve.
#[test]
fn plots_of_many_turns_are_as_fine_as_of_one() {
    let motion = file("many-turns");
    let (curves, dots) = drawn(&motion, "C.x");
    let [value, rate, second] = &curves[..] else {
        panic!("{} curves", curves.len());
    };
    for curve in [value, rate, second] {
        assert!(curve.len() >= 31 * 720, "{}", curve.len());
    }
    // Two extrema to a turn, each order; zeros have dots of the same size.
    assert!(dots.len() > 3 * 2 * 31, "{}", dots.len());
    for [x, y] in dots {
        let lines = curves.iter().flat_map(|curve| curve.windows(2));
        let off = lines.map(|line| {
            let [a, b] = [line[0], line[1]].map(|at| Vector::new(at[0] - x, at[1] - y));
            let along = b - a;
            let share = (-a.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (a + share * along).norm()
        });
        let off = off.fold(f64::INFINITY, f64::min);
        assert!(off < 0.2, "{x} {y}: {off}");
    }
}

/// Of wheels that mesh anew only after 974 153 turns the plot shows whole turns, never a curve between far samples; what is
/// extreme is not marked.
#[test]
fn plots_of_very_many_turns_are_of_whole_ones() {
    let motion = file("hunting-wheels");
    let (curves, dots) = drawn(&motion, "T.x");
    assert!(dots.is_empty());
    assert!(curves.len() > 1000);
    for curve in curves {
        let xs = curve.iter().map(|at| at[0]);
        let [first, last] = xs.fold([f64::INFINITY, 0.0], |[a, b], x: f64| [a.min(x), b.max(x)]);
        // A turn is a hundredth of a pixel.
        assert!(last - first < 0.2, "{first} {last}");
    }
}

/// A five-bar with a second crank at another rate, and a slide that its joint C pushes to and fro along the axis.
fn pushed(rate: f64) -> Motion {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.6, 0.8)
        .point("C", 2.2, 3.1)
        .point("D", 3.9, 0.7)
        .point("E", 4.0, 0.0)
        .point("S", 7.0, 1.0)
        .point("G", 0.0, 1.0)
        .point("H", 9.0, 1.0)
        .fixed(&["A", "E", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("BC", &["B", "C"])
        .bar("DC", &["D", "C"])
        .bar("second", &["E", "D"])
        .bar("rod", &["C", "S"])
        .bar("slider", &["S"])
        .slide("slider", "S", "frame", ["G", "H"])
        .crank("crank");
    draft.drivers.push(DriverSpec::Crank {
        link: "second".to_owned(),
        base: "frame".to_owned(),
        rate,
    });
    moved(&draft)
}

/// The way of a slide, from which it becomes the driver, is exact in a motion of 24 turns as in one of one.
#[test]
fn a_slides_range_is_exact_over_many_turns() {
    for (rate, turns) in [(1.0, 1.0), (25.0 / 24.0, 24.0)] {
        let motion = pushed(rate);
        assert_eq!(motion.cycle().period(), Some(turns * TAU));
        let driver = motion.driver("slider").unwrap().unwrap();
        let DriverSpec::Slide { range, .. } = driver else {
            panic!("{driver:?}");
        };
        let s = motion.mechanism().point("S").unwrap();
        let way = motion.telling(|pose: &assur::mechanism::Pose<1>| {
            motion.mechanism().place(pose, s).place().x
        });
        let count = 20_000.0 * turns;
        let inputs = (0..count as usize).map(|k| turns * TAU * k as f64 / count);
        let ways = inputs.map(|input| way(input).unwrap());
        let sampled = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
            [a.min(x), b.max(x)]
        });
        // Samples fall short by no more than the curve bends between two of them.
        assert!(
            range[0] <= sampled[0] && sampled[0] - range[0] < 1e-6,
            "{range:?} {sampled:?}"
        );
        assert!(
            range[1] >= sampled[1] && range[1] - sampled[1] < 1e-6,
            "{range:?} {sampled:?}"
        );
        assert!(range[1] - range[0] > 0.1, "{range:?}");
    }
}

/// A crank-rocker with a dyad on its rocker that is `size` as large as all else.
fn small_dyad(size: f64) -> Motion {
    let at = Vector::new(4.0, 0.0);
    let small = [[0.9, 0.3], [1.9, 1.4], [2.4, -0.2]].map(|[x, y]| at + size * Vector::new(x, y));
    let [q, e, f] = small;
    moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 3.2, 2.9)
            .point("D", 4.0, 0.0)
            .point("Q", q.x, q.y)
            .point("E", e.x, e.y)
            .point("F", f.x, f.y)
            .fixed(&["A", "D", "F"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C", "Q"])
            .bar("QE", &["Q", "E"])
            .bar("FE", &["F", "E"])
            .crank("crank"),
    )
}

/// The least transmission angle of a dyad does not depend on how large the drawing around it is.
#[test]
fn a_small_dyad_keeps_its_least_transmission_angle() {
    for size in [1.0, 1e-2, 3e-5, 1e-6] {
        let motion = small_dyad(size);
        let dyads = motion.mechanism().rrr_dyads();
        let name =
            |dyad: &&assur::mechanism::RrrDyad| motion.mechanism().point_name(dyad.inner) == "E";
        let dyad = dyads.iter().find(name).unwrap();
        let least = motion.least_transmission(dyad).unwrap().unwrap();
        let sampled = (0..36_000).map(|k| {
            let pose = motion.pose::<1>(TAU * f64::from(k) / 36_000.0).unwrap();
            motion.mechanism().transmission_angle(&pose, dyad)
        });
        let sampled = sampled.fold(f64::INFINITY, f64::min);
        assert!(sampled > 0.05, "{size}: {sampled}");
        let digits = 1e-6 + 1e-14 / size;
        assert!(
            (least.angle - sampled).abs() < digits,
            "{size}: {least:?} {sampled}"
        );
        assert!(
            least.angle <= sampled + 1e-14 / size,
            "{size}: {least:?} {sampled}"
        );
    }
}

/// The distance of two joints within a small part of a drawing has its extrema.
#[test]
fn a_small_distance_has_its_extrema() {
    for size in [1.0, 3e-5, 1e-8] {
        let motion = small_dyad(size);
        let distance = quantity(&motion, "Q-F.distance");
        let [value, ..] = motion
            .features(&[distance], InputRate::ANALOGUES)
            .unwrap()
            .swap_remove(0);
        assert_eq!((value.extrema.len(), value.level), (2, None), "{size}");
        let profile = OutputProfile::new(&motion, distance).unwrap();
        let stroke = profile.stroke().unwrap();
        assert!(stroke > 0.3 * size, "{size}: {stroke}");
        let [Swing::Between { min, max }] = profile.swings()[..] else {
            panic!("one arc");
        };
        assert!((max - min - stroke).abs() < 1e-9 * size + 1e-15);
    }
}

/// A point far from the origin moves as much as one near it.
#[test]
fn places_far_off_have_their_extrema() {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 3.2, 2.9)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    for point in &mut draft.points {
        point.at = (1e-3 * point.at.coords + Vector::new(1e7, 0.0)).into();
    }
    let motion = moved(&draft);
    let x = quantity(&motion, "C.x");
    let [value, ..] = motion
        .features(&[x], InputRate::ANALOGUES)
        .unwrap()
        .swap_remove(0);
    assert_eq!((value.extrema.len(), value.level), (2, None));
}

fn crank_rocker() -> Motion {
    moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 3.2, 2.9)
            .point("D", 4.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank"),
    )
}

/// The angle of a crank and its rocker grows by a turn with each cycle, as the crank's own does.
#[test]
fn an_angle_between_links_turns() {
    let motion = crank_rocker();
    let between = quantity(&motion, "rocker-crank.between");
    let profile = OutputProfile::new(&motion, between).unwrap();
    assert_eq!(profile.swings(), [Swing::Turns]);
    let travel = profile.travels()[0];
    assert!(travel >= TAU - 1e-12, "{travel}");
    // It goes on over the end of the cycle.
    let dwell = profile.dwell(0.1).unwrap();
    for k in 0..=20 {
        let input = dwell.arc[0] + dwell.length() * f64::from(k) / 20.0;
        let row = motion.row(
            &[Column {
                quantity: between,
                order: 0,
            }],
            input,
        );
        let value = row.values[0].unwrap();
        let within = dwell.band[0] - 1e-9..=dwell.band[1] + 1e-9;
        assert!(within.contains(&value), "{value} {dwell:?}");
    }
}

/// A deltoid whose links lie on each other at the start of its cycle, where coupler and rocker swing freely: beyond the
/// cycle angles go on, and an angle that only grows has its dwell.
#[test]
fn a_deltoid_goes_on_beyond_its_cycle() {
    // A kite of two long and two short links, the crank and the frame short.
    let motion = moved(
        &LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("C", 2.0, 2.0)
            .point("D", 1.0, 0.0)
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("rocker", &["D", "C"])
            .crank("crank"),
    );
    assert!(motion.cycle().is_full());
    let period = motion.cycle().period().unwrap();
    assert!(motion.change_points().contains(&0.0));
    let mechanism = motion.mechanism();
    for link in ["crank", "coupler", "rocker"] {
        let angle = quantity(&motion, &format!("{link}.angle"));
        let columns = [Column {
            quantity: angle,
            order: 0,
        }];
        let value = |input: f64| motion.row(&columns, input).values[0].unwrap();
        let [early, later] = [1.0, 1.0 + period].map(value);
        let by_steps = (0..3600).map(|k| {
            let at = |k: f64| {
                let input = 1.0 + period * k / 3600.0;
                let pose = motion.pose::<1>(input.rem_euclid(period));
                pose.map(|pose| {
                    mechanism
                        .angle(&pose, mechanism.link(link).unwrap())
                        .value()
                })
            };
            let [Ok(a), Ok(b)] = [f64::from(k), f64::from(k) + 1.0].map(at) else {
                return 0.0;
            };
            let by = b - a;
            by - TAU * (by / TAU).round()
        });
        let gained: f64 = by_steps.sum();
        assert!(
            (later - early - gained).abs() < 0.1,
            "{link}: {early} {later} {gained}"
        );
        let profile = OutputProfile::new(&motion, angle).unwrap();
        assert!(profile.dwell(0.1).is_some(), "{link}");
        // Zeros are those at which a fine sweep over the cycle changes its sign.
        let [found, ..] = motion
            .features(&[angle], InputRate::ANALOGUES)
            .unwrap()
            .swap_remove(0);
        let sweep = (0..36_000).filter_map(|k| {
            let input = period * (f64::from(k) + 0.5) / 36_000.0;
            let pose = motion.pose::<1>(input).ok()?;
            Some(angle.of(mechanism, &pose).value())
        });
        let sweep: Vec<f64> = sweep.collect();
        let passes = sweep.windows(2).filter(|pair| pair[0] * pair[1] < 0.0);
        let inside = found
            .zeros
            .iter()
            .filter(|zero| **zero > 1e-3 && **zero < period - 1e-3);
        assert_eq!(inside.count(), passes.count(), "{link}: {:?}", found.zeros);
    }
}

/// A hinge that is set so far off that the points of a guide are one place beside it: they are at fault, not the links of the
/// first step of the plan.
#[test]
fn a_guide_without_a_direction_is_named() {
    let motion = moved(
        &LinkageSpec::default()
            .point("O", 0.0, 0.0)
            .point("B", 0.0, 1.0)
            .point("A", 4.0, 0.0)
            .point("P", 3.0, 0.25)
            .point("T", 2.0, 0.5)
            .point("S", 2.0, -3.0)
            .point("G", 0.0, -3.0)
            .point("H", 1e-5, -3.0)
            .fixed(&["O", "A", "G", "H"])
            .bar("crank", &["O", "B"])
            .bar("block", &["B"])
            .bar("rocker", &["A", "P", "T"])
            .bar("rod", &["B", "S"])
            .bar("slider", &["S"])
            .slide("block", "B", "rocker", ["P", "T"])
            .slide("slider", "S", "frame", ["G", "H"])
            .crank("crank"),
    );
    let point = motion.mechanism().point("A").unwrap();
    let refused = motion.changed(Dimension::X(point), 1e5, 0.5 * PI);
    let refused = refused.unwrap_err();
    let Refusal::Defects(defects) = refused else {
        panic!("{refused:?}");
    };
    let [Defect::Coincident { link, points }] = &defects[..] else {
        panic!("{defects:?}");
    };
    assert_eq!(
        (link.as_str(), points),
        ("frame", &["G", "H"].map(str::to_owned))
    );
}

/// A linkage drawn in any unit of length can be changed: determinants of its groups are not beyond all numbers.
#[test]
fn groups_in_any_unit_can_be_changed() {
    for name in ["class4-order2", "class4-dwell", "class5"] {
        let plain = assur_file::from_catalogue(name).unwrap().unwrap();
        let plain = plain.mechanism().unwrap();
        for unit in [1.0, 1e-9, 1e8, 1e-40, 1e-60] {
            let mut draft = plain.spec().clone();
            for point in &mut draft.points {
                point.at *= unit;
            }
            for link in &mut draft.links {
                for at in link.shape.iter_mut().flatten() {
                    *at *= unit;
                }
            }
            draft.tracers.clear();
            let motion = moved(&draft);
            let margin = motion.singularity_margin();
            assert!(
                margin.is_finite() && margin != 0.0,
                "{name} {unit:e}: {margin}"
            );
            let mut dimensions = motion.mechanism().dimensions().into_iter();
            let length = dimensions
                .find(|one| matches!(one, Dimension::Length(_)))
                .unwrap();
            let value = motion.mechanism().value(length).unwrap();
            let changed = motion.changed(length, 1.001 * value, motion.drawn_input());
            assert!(changed.is_ok(), "{name} {unit:e}: {:?}", changed.err());
        }
    }
}

/// A lever that the crank's pin turns fully: what its angle gains in a turn is no jump through zero.
#[test]
fn an_angle_that_turns_fully_passes_zero_once() {
    let points = [
        ("A", 0.0, 0.0),
        ("B", 0.0, 2.0),
        ("D", 0.5, 0.5),
        ("F", -0.25, 2.75),
    ];
    let motion = lever(points, 0.0);
    let lever = quantity(&motion, "lever.angle");
    let found = motion.features(&[lever], InputRate::ANALOGUES).unwrap();
    let zeros = &found[0][0].zeros;
    assert_eq!(zeros.len(), 1, "{zeros:?}");
}

/// The least pressure angle of a central slider-crank is 0, where its rate jumps.
#[test]
fn an_extremum_where_the_rate_jumps_is_exact() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 8_f64.sqrt(), 0.0)
        .point("G", -1.0, 0.0)
        .point("H", 5.0, 0.0)
        .fixed(&["A", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["G", "H"])
        .crank("crank");
    let motion = moved(&draft);
    let profile = OutputProfile::new(&motion, quantity(&motion, "C.pressure")).unwrap();
    let swings = profile.swings();
    let [Swing::Between { min, max }] = swings[..] else {
        panic!("{swings:?}");
    };
    assert!(min < 1e-9, "{min}");
    assert!((max - (1.0_f64 / 3.0).asin()).abs() < 1e-9, "{max}");
}

/// Points, turned about the origin by an angle.
fn points_turned(points: [(&str, f64, f64); 4], by: f64) -> LinkageSpec {
    let (sin, cos) = by.sin_cos();
    let turned = |draft: LinkageSpec, (name, x, y): (&str, f64, f64)| {
        draft.point(name, cos * x - sin * y, sin * x + cos * y)
    };
    points.into_iter().fold(LinkageSpec::default(), turned)
}

/// A lever DF that the crank AB drives by a block on it, turned by an angle.
fn lever(points: [(&str, f64, f64); 4], by: f64) -> Motion {
    let draft = points_turned(points, by)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("lever", &["D", "F"])
        .bar("block", &["B"])
        .slide("block", "B", "lever", ["D", "F"]);
    moved(&draft.crank("crank"))
}

/// A crank-rocker, turned by an angle.
fn turned(by: f64) -> Motion {
    let points = [
        ("A", 0.0, 0.0),
        ("B", 0.0, 1.0),
        ("C", 2.4, 2.8),
        ("D", 3.0, 1.0),
    ];
    let draft = points_turned(points, by)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"]);
    moved(&draft.crank("crank"))
}

/// Where the crank is in line with a frame of any direction, the transmission angle has one extremum.
#[test]
fn extrema_in_line_are_found_once() {
    for k in 0..40 {
        let motion = turned(0.15 * f64::from(k));
        let profile = OutputProfile::new(&motion, quantity(&motion, "C.transmission")).unwrap();
        let limits = profile.limits();
        for pair in limits.windows(2) {
            let apart = pair[1].input - pair[0].input;
            assert!(apart > 1e-9, "{k}: {limits:?}");
        }
    }
}

/// Within a band as wide as its stroke a quantity stays for one cycle, not for two.
#[test]
fn a_band_as_wide_as_the_stroke_holds_one_cycle() {
    let motion = turned(0.0);
    for name in ["rocker.angle", "coupler.angle", "C.x", "C.y", "B.x"] {
        let profile = OutputProfile::new(&motion, quantity(&motion, name)).unwrap();
        let stroke = profile.stroke().unwrap();
        for tolerance in [stroke.next_down(), stroke, stroke.next_up()] {
            let dwell = profile.dwell(tolerance).unwrap();
            let off = (dwell.length() - TAU).abs();
            assert!(off < 1e-12, "{name} {tolerance}: {:?}", dwell.arc);
        }
    }
}

/// The longest dwell of what only grows is as long wherever the turn of the crank begins.
#[test]
fn the_longest_dwell_may_pass_the_start_of_the_cycle() {
    let lengths = (0..8).map(|k| {
        let points = [
            ("A", 0.0, 0.0),
            ("B", 0.0, 2.0),
            ("C", 2.0, 2.5),
            ("D", 0.5, 0.0),
        ];
        let draft = points_turned(points, 0.8 * f64::from(k))
            .fixed(&["A", "D"])
            .bar("crank", &["A", "B"])
            .bar("coupler", &["B", "C"])
            .bar("follower", &["D", "C"]);
        let motion = moved(&draft.crank("crank"));
        let profile = OutputProfile::new(&motion, quantity(&motion, "follower.angle")).unwrap();
        assert!(profile.limits().is_empty());
        profile.dwell(1.0).unwrap().length()
    });
    let lengths: Vec<f64> = lengths.collect();
    for length in &lengths {
        assert!((length - lengths[0]).abs() < 1e-6, "{lengths:?}");
    }
}

/// A lever whose pivot the crank's pin nearly meets swings through nearly half a turn within any small angle of the crank,
/// in whatever direction the frame lies.
#[test]
fn a_lever_whose_pivot_the_pin_nearly_meets() {
    let [crank, frame] = [1.469_559_657_2, 1.469_559_664_6_f64];
    for k in 0..8 {
        let by = 0.8 * f64::from(k);
        let points = [
            ("A", 0.0, 0.0),
            ("B", 0.0, crank),
            ("D", frame, 0.0),
            ("F", -frame, 2.0 * crank),
        ];
        let motion = lever(points, by);
        assert!(motion.cycle().is_full(), "{by}");
        let profile = OutputProfile::new(&motion, quantity(&motion, "lever.angle")).unwrap();
        let stroke = 2.0 * (crank / frame).asin();
        let found = profile.stroke().unwrap();
        assert!((found - stroke).abs() < 1e-6, "{by}: {found} {stroke}");
    }
}
