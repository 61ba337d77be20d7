//! Drawings of any linkage: whole lists, bodies where the engine has them.

use assur::Point;
use assur::mechanism::{Draft, DraftDriver, Mechanism, Quantity};
use assur::motion::{Input, Motion};
use assur_draw::chart::Settings;
use assur_draw::svg::Svg;
use assur_draw::{Annotations, Figure, Overlays, Role, View};

use crate::records::records;

/// An offset slider-crank with a plate as rod, on whose point a block of a lever
/// slides.
fn draft() -> Draft {
    Draft::default()
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

/// The drawing of the slider-crank's motion with these overlays and the path of M.
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
    // The path of M, dashed, is drawn first: all of a turn.
    assert_eq!((rigid[0][0], rigid[0][2]), (2.0, 3.0));
    assert!(rigid[0][3] > 300.0);
    // Hinges: A, D, B, C, and M with the block.
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
        // Every point but those that only give the guide has its name.
        let moving = records(&frame[1 + 3 * bodies..]);
        let named: Vec<&str> = moving
            .iter()
            .filter(|record| record[0] == 4.0)
            .map(|record| figure.names()[record[2] as usize].as_str())
            .collect();
        assert_eq!(named, ["A", "B", "C", "M", "D", "E"]);
    }
}

/// A four-bar without a link that turns fully.
fn triple_rocker() -> Draft {
    Draft::default()
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

/// The plots of a link's angle as a file.
fn chart(motion: &Motion, link: &str) -> String {
    let settings = Settings {
        input: Input::ANALOGUES,
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

/// The axis spans where the input goes, with a little room; all of a turn where that is nearly all of it.
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

/// Curves of the same axis of two points can be told apart.
#[test]
fn axes_of_further_points_have_colours_of_their_own() {
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let settings = Settings {
        input: Input::ANALOGUES,
        physical: false,
        differenced: false,
    };
    let quantities =
        ["B.x", "C.x", "C.y", "M.x"].map(|name| Quantity::named(motion.mechanism(), name).unwrap());
    let chart = figure(&motion, Overlays::default()).chart(&quantities, settings);
    let roles: Vec<Role> = chart.series().iter().map(|series| series.role).collect();
    assert_eq!(roles, [Role::X, Role::Accent2, Role::Y, Role::Accent1]);
}

/// Where there is no pose there is no frame.
#[test]
fn beyond_dead_points_nothing_is_drawn() {
    let draft = triple_rocker();
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    assert!(!motion.cycle().is_full());
    let figure = Figure::new(&motion, &View::default()).unwrap();
    let home = motion.pose::<3>(motion.home()).unwrap();
    assert!(figure.frame(&home).iter().all(|x| x.is_finite()));
    assert!(motion.pose::<1>(3.0).is_err());
}

/// The arrows lie along the derivatives and keep one scale for each order.
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
            // The shaft begins at the point, the head with the tip.
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
        // B, C, M and E move; C and M stop now and then.
        assert!(found.len() > 24 * 3, "{}", found.len());
        assert!(
            found
                .iter()
                .all(|scale| (scale / found[0] - 1.0).abs() < 1e-4)
        );
    }
}

/// In groups every body has the colour of its group and of no other, the plots
/// keep the links' own; only colours change.
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
    // Slider and lever had other colours before; crank and rod have kept theirs.
    assert_eq!((painted[1], painted[2]), (0, 0));
    assert!(painted[3] > 0 && painted[5] > 0, "{painted:?}");
    for (link, role) in mechanism.link_ids().zip(of_links) {
        assert_eq!(grouped.drawn_role(link), role);
        assert_eq!(grouped.role(link), plain.drawn_role(link));
    }
    let pose = motion.pose::<1>(0.4).unwrap();
    assert_eq!(plain.frame(&pose), grouped.frame(&pose));
}

/// The records of a drawing that are in the coordinates of a body.
fn on_body(figure: &Figure, body: usize) -> Vec<Vec<f32>> {
    let mut on = 0;
    let records = records(figure.rigid().numbers()).into_iter();
    let of_body = records.filter(|record| {
        if record[0] == 0.0 {
            on = record[1] as usize;
        }
        on == body && record[0] != 0.0
    });
    of_body.collect()
}

/// The unit of symbols: a hinge is 1.1 of it.
fn unit(figure: &Figure) -> f64 {
    let records = records(figure.rigid().numbers());
    let mut hinges = records.iter().filter(|record| record[0] == 3.0);
    hinges
        .next()
        .map_or(f64::NAN, |hinge| f64::from(hinge[5]) / 1.1)
}

/// A block stands on a hatched line all along its stroke; its pin is off the line. A lever
/// goes through its block, which hides it.
#[test]
fn blocks_stand_on_their_guides() {
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let mechanism = motion.mechanism();
    let figure = figure(&motion, Overlays::default());
    let unit = unit(&figure);
    let [half_length, half_width] = [2.6 * unit, 1.7 * unit];
    let c = mechanism.point("C").unwrap();
    let places = (0..720).map(|k| {
        let pose = motion.pose::<1>(f64::from(k).to_radians() / 2.0).unwrap();
        mechanism.place(&pose, c).place().x
    });
    let [low, high] = places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(x), high.max(x)]
    });
    let level = 0.3 - half_width;
    let frame = on_body(&figure, 0);
    let is_line = |record: &&Vec<f32>| record[0] == 2.0 && record[2] == 2.0 && record[3] == 2.0;
    let mut lines = frame.iter().filter(is_line).map(|record| {
        let [x, y, to_x, to_y] = [4, 5, 6, 7].map(|i| f64::from(record[i]));
        assert!((y - to_y).abs() < 1e-6, "a level line");
        [x, to_x, y]
    });
    let [from, to, _] = lines.find(|line| (line[2] - level).abs() < 1e-6).unwrap();
    assert!(from < low - half_length && high + half_length < to);
    let strokes = frame.iter().filter(|record| {
        let begins = record[0] == 2.0 && (f64::from(record[5]) - level).abs() < 1e-6;
        begins && record[2] == 4.0
    });
    let strokes: Vec<f64> = strokes.map(|record| f64::from(record[7])).collect();
    assert!(strokes.len() > 10 && strokes.iter().all(|y| *y < level - 0.5 * unit));

    // Paper below, so that nothing is seen through it, and a pale block on it.
    for link in ["slider", "block"] {
        let link = mechanism.link(link).unwrap();
        let body = on_body(&figure, link.index() + 1);
        let polygons = body.iter().filter(|record| record[0] == 1.0);
        let looks: Vec<[f32; 4]> = polygons.map(|it| [it[1], it[2], it[3], it[4]]).collect();
        let [paper, own] = [Role::Paper, figure.drawn_role(link)].map(|role| f32::from(role as u8));
        assert!(looks.ends_with(&[[paper, 0.0, 1.0, 4.0], [own, 1.0, 1.0, 4.0]]));
    }
}

/// A yoke is a slot with an arm to its own block, not a bar; two ways on the frame that cross
/// are channels, open where they do.
#[test]
fn yokes_have_slots_and_crossing_ways_are_channels() {
    let yoke = Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.5, 0.75)
        .point("S", 0.5, 1.5)
        .point("T", 0.5, -1.5)
        .point("D", 3.0, 0.0)
        .point("G", 1.0, 0.0)
        .point("H", 5.0, 0.0)
        .fixed(&["A", "G", "H"])
        .bar("crank", &["A", "B"])
        .bar("block", &["B"])
        .bar("yoke", &["T", "S", "D"])
        .slide("block", "B", "yoke", ["T", "S"])
        .slide("yoke", "D", "frame", ["G", "H"])
        .crank("crank");
    let motion = Motion::new(Mechanism::new(&yoke).unwrap());
    let figure = figure_of(&motion);
    let link = motion.mechanism().link("yoke").unwrap();
    let body = on_body(&figure, link.index() + 1);
    let polygons: Vec<_> = body.iter().filter(|record| record[0] == 1.0).collect();
    let role = f32::from(figure.drawn_role(link) as u8);
    // The arm with its light line, the slot with a hole, the block.
    let [arm, light, slot, paper, block] = polygons[..] else {
        panic!("{}", polygons.len());
    };
    assert_eq!([slot[1], slot[2], slot[3]], [role, 0.0, 2.0]);
    assert_eq!([arm[1], arm[2], arm[3]], [role, 0.0, 1.0]);
    let paper_role = f32::from(Role::Paper as u8);
    assert_eq!(
        [light[1], paper[1], block[1]],
        [paper_role, paper_role, role]
    );

    let mut trammel = Draft::default()
        .point("A", 1.5, 0.0)
        .point("B", 0.0, 1.3)
        .point("E", -3.0, 0.0)
        .point("F", 3.0, 0.0)
        .point("G", 0.0, -3.0)
        .point("H", 0.0, 3.0)
        .fixed(&["E", "F", "G", "H"])
        .bar("level", &["A"])
        .bar("upright", &["B"])
        .bar("rod", &["A", "B"])
        .slide("level", "A", "frame", ["E", "F"])
        .slide("upright", "B", "frame", ["G", "H"]);
    trammel.drivers.push(DraftDriver::Crank {
        link: "rod".to_owned(),
        base: "level".to_owned(),
        rate: 1.0,
    });
    let motion = Motion::new(Mechanism::new(&trammel).unwrap());
    let frame = on_body(&figure_of(&motion), 0);
    let walls = frame
        .iter()
        .filter(|record| record[0] == 2.0 && record[2] == 2.0);
    assert_eq!(walls.count(), 4);
    let emptied = frame
        .iter()
        .filter(|record| record[0] == 1.0 && record[1] == paper_role);
    assert_eq!(emptied.count(), 2);
}

fn figure_of(motion: &Motion) -> Figure {
    let view = View {
        annotations: Annotations::of_linkage(None),
        ..View::default()
    };
    Figure::new(motion, &view).unwrap_or_else(|unsolved| panic!("{unsolved}"))
}

/// The ground is a hatched line below all of the drawing; one out of sight is not drawn.
#[test]
fn legs_stand_on_the_ground() {
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let lines = |ground: Option<f64>| {
        let view = View {
            annotations: Annotations::of_linkage(ground),
            ..View::default()
        };
        let figure = Figure::new(&motion, &view).unwrap();
        let frame = on_body(&figure, 0);
        let level = |y: f32| ground.is_some_and(|ground| (f64::from(y) - ground).abs() < 1e-6);
        let on_ground = frame
            .iter()
            .filter(|it| it[0] == 2.0 && it[3] == 2.0 && level(it[5]));
        let ends: Vec<[f32; 3]> = on_ground.map(|it| [it[4], it[6], it[7]]).collect();
        (ends, figure.bounds())
    };
    let (none, plain) = lines(None);
    assert!(none.is_empty());
    let (ends, bounds) = lines(Some(-4.0));
    // It reaches as far as the supports do, in the precision of a list.
    let [from, to, _] = ends[0];
    assert!(from <= plain[0] as f32 && plain[2] as f32 <= to && bounds[1] < -4.0);
    assert!(ends.len() > 20 && ends[1..].iter().all(|[_, _, y]| *y < -4.0));
    for far in [-1e300, 1e300, f64::NAN] {
        let (ends, bounds) = lines(Some(far));
        assert!(ends.is_empty() && bounds == plain, "{far}");
    }
}

/// Each link has its number once, in the order of the document, a bar on itself; the frame has 0 at
/// each support. They are not there where they are not asked for.
#[test]
fn links_have_their_numbers() {
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let mechanism = motion.mechanism();
    let numbers = Overlays {
        numbers: true,
        ..Overlays::default()
    };
    let [plain, figure] = [Overlays::default(), numbers].map(|shown| figure(&motion, shown));
    let labels = |figure: &Figure, body: usize| -> Vec<(String, Point)> {
        let records = on_body(figure, body);
        let labels = records.iter().filter(|record| record[0] == 4.0);
        let read = labels.map(|it| {
            let at = Point::new(f64::from(it[3]), f64::from(it[4]));
            (figure.names()[it[2] as usize].clone(), at)
        });
        read.collect()
    };
    let frame: Vec<String> = labels(&figure, 0)
        .into_iter()
        .map(|(text, _)| text)
        .collect();
    assert_eq!(frame, ["0", "0"]);
    for link in mechanism.link_ids() {
        let body = link.index() + 1;
        assert!(labels(&plain, body).is_empty());
        let [(text, at)] = &labels(&figure, body)[..] else {
            panic!("{body}");
        };
        assert_eq!(*text, body.to_string());
        if ["crank", "lever"].contains(&mechanism.link_name(link)) {
            assert!(at.x > 0.2 && at.y.abs() < 1e-6, "{text}: {at}");
        }
    }
}

/// The arc of a crank's angle ends in an arrow on the crank, at every angle; beside a block that
/// drives is one along its way, off the line it stands on.
#[test]
fn what_drives_has_an_arrow() {
    let tips = |records: &[Vec<f32>], role: Role| -> Vec<Point> {
        let heads = records
            .iter()
            .filter(|record| record[..5] == [1.0, f32::from(role as u8), 0.0, 1.0, 3.0]);
        let tips = heads.map(|head| Point::new(f64::from(head[5]), f64::from(head[6])));
        tips.collect()
    };
    let motion = Motion::new(Mechanism::new(&draft()).unwrap());
    let figure = figure_of(&motion);
    let mechanism = motion.mechanism();
    let crank = figure.drawn_role(mechanism.link("crank").unwrap());
    let b = mechanism.point("B").unwrap();
    for k in 0..72 {
        let pose = motion.pose::<1>(f64::from(k) * 0.0873).unwrap();
        let frame = figure.frame(&pose);
        assert!(frame.iter().all(|x| x.is_finite()));
        let moving = records(&frame[1 + 3 * frame[0] as usize..]);
        let middle = mechanism.place(&pose, b).place() * 0.5;
        let [tip] = tips(&moving, crank)[..] else {
            panic!("{k}");
        };
        assert!((tip - middle).norm() < 1e-6, "{k}: {tip}");
    }
    let mut driven = draft();
    driven.drivers = vec![DraftDriver::Slide {
        slide: 0,
        range: [2.0, 2.3],
        rate: 1.0,
    }];
    let motion = Motion::new(Mechanism::new(&driven).unwrap());
    let figure = figure_of(&motion);
    let link = motion.mechanism().link("slider").unwrap();
    let body = on_body(&figure, link.index() + 1);
    // Seen from the pin: ahead of the block and above it.
    let [tip] = tips(&body, figure.drawn_role(link))[..] else {
        panic!("no arrow");
    };
    let unit = unit(&figure);
    assert!(
        (tip - Point::new(4.0 * unit, 3.4 * unit)).norm() < 1e-4 * unit,
        "{tip} {unit}"
    );
}

/// Watt's line: its rocker goes from −75° to 34°.
fn rocker() -> Draft {
    Draft::default()
        .point("A", 0.0, 0.0)
        .point("B", 4.0, 0.0)
        .point("C", 4.0, -3.0)
        .point("D", 8.0, -3.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"])
        .crank("crank")
}

/// A rocker, whose angle counts from below zero: its arc goes down to a negative angle.
#[test]
fn negative_angles_go_the_other_way() {
    let motion = Motion::new(Mechanism::new(&rocker()).unwrap());
    let figure = figure_of(&motion);
    let link = motion.mechanism().link("crank").unwrap();
    let role = f32::from(figure.drawn_role(link) as u8);
    for input in [-0.6, 0.5] {
        let frame = figure.frame(&motion.pose::<1>(input).unwrap());
        let moving = records(&frame[1 + 3 * frame[0] as usize..]);
        let mut arcs = moving
            .iter()
            .filter(|it| it[0] == 2.0 && it[1] == role && it[3] > 40.0);
        let arc = arcs.next().unwrap();
        let [from, to] = [&arc[4..6], &arc[arc.len() - 2..]];
        let spanned = f64::from(to[1].atan2(to[0]) - from[1].atan2(from[0]));
        assert!(
            spanned * input > 0.0 && spanned.abs() < input.abs(),
            "{spanned}"
        );
        let middle = &arc[4 + 48..];
        assert!(f64::from(middle[1]) * input > 0.0 && middle[0] > 0.0);
    }
}

/// With the letters of the paper on the combined method its sides and corners are named, and no other vector is drawn.
#[test]
fn letters_of_the_combined_method() {
    let draft = Draft::default()
        .point("H", 0.0, 0.0)
        .point("G", 2.0, 0.0)
        .point("L", 1.0, 3.0)
        .fixed(&["H"])
        .bar("HGL", &["H", "G", "L"])
        .crank("HGL");
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let names = |annotations: Annotations| {
        let view = View {
            overlays: Overlays {
                loop_vectors: true,
                ..Overlays::default()
            },
            annotations,
            ..View::default()
        };
        let figure = Figure::new(&motion, &view).unwrap();
        let points = motion.mechanism().points().len();
        figure.names()[points..].to_vec()
    };
    let plain = names(Annotations::default());
    assert!(!plain.contains(&"t".to_owned()), "{plain:?}");
    let lettered = names(Annotations::default().with_letters_of_combined_method());
    assert_eq!(lettered, ["g", "t", "η_H"]);
}
