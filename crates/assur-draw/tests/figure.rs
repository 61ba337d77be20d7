//! Drawings of any linkage: complete display lists, with bodies where the engine places them.

mod bodies;

use assur::Point;
use assur::mechanism::{DriverSpec, LinkageSpec, Mechanism, Quantity};
use assur::motion::{InputRate, Motion};
use assur_draw::chart::Settings;
use assur_draw::svg::Svg;
use assur_draw::{Annotations, Figure, Overlays, Role, View};

use crate::records::records;

/// An offset slider-crank whose rod is a plate. A block of a lever slides on a point of this plate.
fn draft() -> LinkageSpec {
    LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.5, 0.8)
        .point("C", 3.2, 0.3)
        .point("G", 1.0, 0.3)
        .point("H", 4.0, 0.3)
        .point("M", 2.0, 1.6)
        .point("D", 1.5, -2.0)
        .point("E", 2.2, 2.5)
        .fixed(&["A", "G", "H", "D"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C", "M"])
        .bar("slider", &["C"])
        .bar("block", &["M"])
        .bar("lever", &["D", "E"])
        .slide("slider", "C", "frame", ["G", "H"])
        .slide("block", "M", "lever", ["D", "E"])
        .crank("crank")
}

/// Returns the drawing of the slider-crank with these overlays and the path of M.
fn figure(motion: &Motion, overlays: Overlays) -> Figure {
    let view = View {
        overlays,
        traced: motion.mechanism().point("M").into_iter().collect(),
        ..View::default()
    };
    let figure = Figure::new(motion, &view);
    figure.unwrap_or_else(|unsolved| panic!("{unsolved}"))
}

const TRACES: Overlays = Overlays {
    traces: true,
    centres: false,
    vectors: false,
    loop_vectors: false,
    transmission: false,
    groups: false,
    numbers: false,
};

#[test]
fn lists_are_whole_and_bodies_stand_where_they_are() {
    let draft = draft();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let figure = figure(&motion, TRACES);
    let rigid = records(figure.rigid().numbers());
    assert!(figure.rigid().numbers().iter().all(|x| x.is_finite()));
    let bodies = 1 + draft.links.len();
    for record in rigid.iter().filter(|record| record[0] == 0.0) {
        assert!((record[1] as usize) < bodies);
    }
    // The dashed path of M is drawn first, over a whole turn.
    assert_eq!((rigid[0][0], rigid[0][2]), (2.0, 3.0));
    assert!(rigid[0][3] > 300.0);
    // Hinge symbols: A, D, B, C, and the pin of the block at M.
    let hollow = rigid
        .iter()
        .filter(|record| record[0] == 3.0 && record[2] == 5.0);
    assert_eq!(hollow.count(), 5);
    let [left, bottom, right, top] = figure.bounds();
    for k in 0..36 {
        let input = 0.1745 * f64::from(k);
        let frame = figure.frame(&motion.pose::<1>(input).unwrap());
        assert_eq!(frame[0] as usize, bodies);
        let pose = motion.pose::<1>(input).unwrap();
        for (link, id) in mechanism.link_ids().enumerate() {
            let first = mechanism.points_of(id)[0];
            let at = mechanism.place(&pose, first).place();
            let [x, y, angle] = [1, 2, 3].map(|i| f64::from(frame[3 + 3 * link + i]));
            assert!((x - at.x).abs() < 1e-6 && (y - at.y).abs() < 1e-6);
            assert!((angle - mechanism.angle(&pose, id).value()).abs() < 1e-6);
        }
        for point in ["A", "B", "C", "M", "D", "E"] {
            let point = mechanism.point(point).unwrap();
            let at = mechanism.place(&pose, point).place();
            assert!((left..=right).contains(&at.x) && (bottom..=top).contains(&at.y));
        }
        // Every point has its name, except points that only define the guide.
        let moving = records(&frame[1 + 3 * bodies..]);
        let named: Vec<&str> = moving
            .iter()
            .filter(|record| record[0] == 4.0)
            .map(|record| figure.names()[record[2] as usize].as_str())
            .collect();
        assert_eq!(named, ["A", "B", "C", "M", "D", "E"]);
    }
}

/// A four-bar in which no link turns fully.
fn triple_rocker() -> LinkageSpec {
    LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.3, 0.52)
        .point("C", 1.05, 0.2)
        .point("D", 0.85, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank")
}

/// Returns the sheet with the plots of a link's angle.
fn chart(motion: &Motion, link: &str) -> String {
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let angle = Quantity::named(motion.mechanism(), &format!("{link}.angle"));
    let mut sheet = Svg::new(600.0);
    let figure = figure(motion, Overlays::default());
    let angles: Vec<Quantity> = angle.into_iter().collect();
    sheet.chart(480.0, &figure.chart(&angles, settings), "φ");
    sheet.finish(link)
}

/// The axis spans the range of the input with a margin; it spans a whole turn if the range is nearly a turn.
#[test]
fn axes_fit_the_motion() {
    let swings = Motion::new(Mechanism::new(&triple_rocker()).unwrap());
    let [[from, to]] = swings.cycle().arcs() else {
        panic!("{:?}", swings.cycle());
    };
    let (from, to) = (from.to_degrees(), to.to_degrees());
    let room = 0.04 * (to - from);
    let plotted = chart(&swings, "rocker");
    let whole = chart(&Motion::new(Mechanism::new(&draft()).unwrap()), "rod");
    for k in -6..=12 {
        let degrees = 30.0 * f64::from(k);
        let text = format!(">{}°</text>", degrees.to_string().replace('-', "−"));
        let on_axis = |plotted: &str| plotted[plotted.rfind("″<").unwrap()..].contains(&text);
        let inside = (from - room..=to + room).contains(&degrees);
        assert_eq!(on_axis(&plotted), inside, "{degrees}: {from} to {to}");
        if k % 3 == 0 {
            let inside = (0.0..=360.0).contains(&degrees);
            assert_eq!(on_axis(&whole), inside, "{degrees}");
        }
    }
}

/// Curves of equal coordinates of several points have different colours.
#[test]
fn axes_of_further_points_have_colours_of_their_own() {
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let settings = Settings {
        input: InputRate::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let quantities =
        ["B.x", "C.x", "C.y", "M.x"].map(|name| Quantity::named(motion.mechanism(), name).unwrap());
    let chart = figure(&motion, Overlays::default()).chart(&quantities, settings);
    let roles: Vec<Role> = chart.series().iter().map(|series| series.role).collect();
    assert_eq!(roles, [Role::X, Role::Accent2, Role::Y, Role::Accent1]);
}

/// No pose exists outside the dead points, so nothing can be drawn there.
#[test]
fn beyond_dead_points_nothing_is_drawn() {
    let draft = triple_rocker();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    assert!(!motion.cycle().is_full());
    let figure = Figure::new(&motion, &View::default()).unwrap();
    let home = motion.pose::<3>(motion.drawn_input()).unwrap();
    assert!(figure.frame(&home).iter().all(|x| x.is_finite()));
    assert!(motion.pose::<1>(3.0).is_err());
}

/// The arrows are parallel to the derivatives, with one scale for each order.
#[test]
fn vectors_are_derivatives_to_scale() {
    let draft = draft();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let vectors = Overlays {
        vectors: true,
        ..Overlays::default()
    };
    let figure = figure(&motion, vectors);
    let mut scales = [Vec::new(), Vec::new()];
    for k in 0..24 {
        let input = 0.26 * f64::from(k);
        let pose = motion.pose::<3>(input).unwrap();
        let frame = figure.frame(&pose);
        let lines = records(&frame[1 + 3 * (1 + draft.links.len())..]);
        for (role, order) in [(Role::Velocity, 1), (Role::Acceleration, 2)] {
            let of = |kind: f32| {
                let lines = lines.iter();
                lines.filter(move |line| line[0] == kind && line[1] == f32::from(role as u8))
            };
            // The line of an arrow begins at the point. The polygon of its head begins with the tip.
            for (shaft, head) in of(2.0).zip(of(1.0)) {
                let [x, y] = [shaft[4], shaft[5]].map(f64::from);
                let tip = [head[5], head[6]].map(f64::from);
                let points = mechanism.point_ids();
                let ends = points.map(|point| mechanism.place(&pose, point));
                let mut from = ends.filter(|end| (end.place() - Point::new(x, y)).norm() < 1e-5);
                let vector = from.next().unwrap().derivative(order);
                let drawn = Point::new(tip[0], tip[1]) - Point::new(x, y);
                assert!(drawn.perp(&vector).abs() < 1e-5 * vector.norm(), "{k}");
                scales[order - 1].push(drawn.dot(&vector) / vector.norm_squared());
            }
        }
    }
    for found in scales {
        // B, C, M and E move; the arrows of C and M are too short to be drawn in some poses.
        assert!(found.len() > 24 * 3, "{}", found.len());
        assert!(
            found
                .iter()
                .all(|scale| (scale / found[0] - 1.0).abs() < 1e-4)
        );
    }
}

/// With colours by group, each body has the colour of its group. Only colours change, and plots keep each link's own
/// colour.
#[test]
fn groups_have_their_colours() {
    let draft = draft();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    assert_eq!(
        mechanism.formula(),
        "I(frame,crank) → II₂(rod,slider) → II₂(block,lever)"
    );
    let [plain, grouped] = [false, true].map(|groups| {
        let overlays = Overlays { groups, ..TRACES };
        figure(&motion, overlays)
    });
    let roles: Vec<Role> = grouped.term_roles().collect();
    assert_eq!(roles, [Role::Crank, Role::Coupler, Role::Rocker]);
    let of_links = [0, 1, 1, 2, 2].map(|step| roles[step]);
    let mut body = 0;
    let [before, after] = [&plain, &grouped].map(|figure| records(figure.rigid().numbers()));
    assert_eq!(before.len(), after.len());
    let mut painted = [0; 6];
    for (before, after) in before.iter().zip(&after) {
        if after[0] == 0.0 {
            body = after[1] as usize;
            assert_eq!(before, after);
            continue;
        }
        assert_eq!((before[0], &before[2..]), (after[0], &after[2..]));
        if before[1] == after[1] {
            continue;
        }
        if body > 0 {
            assert_eq!(after[1], f32::from(of_links[body - 1] as u8));
            painted[body] += 1;
        }
    }
    // Slider and lever change their colours; crank and rod keep theirs.
    assert_eq!((painted[1], painted[2]), (0, 0));
    assert!(painted[3] > 0 && painted[5] > 0, "{painted:?}");
    for (link, role) in mechanism.link_ids().zip(of_links) {
        assert_eq!(grouped.drawn_role(link), role);
        assert_eq!(grouped.role(link), plain.drawn_role(link));
    }
    let pose = motion.pose::<1>(0.4).unwrap();
    assert_eq!(plain.frame(&pose), grouped.frame(&pose));
}
