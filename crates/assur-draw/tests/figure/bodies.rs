//! Blocks, guides, numbers and arrows of bodies.

use super::*;

/// Returns the records in the coordinates of a body.
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

/// Returns the symbol unit: the radius of a hinge's circle divided by 1.1.
fn unit(figure: &Figure) -> f64 {
    let records = records(figure.rigid().numbers());
    let mut hinges = records.iter().filter(|record| record[0] == 3.0);
    hinges
        .next()
        .map_or(f64::NAN, |hinge| f64::from(hinge[5]) / 1.1)
}

/// A block is drawn on a hatched line along its whole stroke; its pin is off that line. A lever passes through its
/// block, which covers it.
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

    // Each block is filled with the colour of the paper, which hides what is behind it, and then with a pale colour.
    for link in ["slider", "block"] {
        let link = mechanism.link(link).unwrap();
        let body = on_body(&figure, link.index() + 1);
        let polygons = body.iter().filter(|record| record[0] == 1.0);
        let looks: Vec<[f32; 4]> = polygons.map(|it| [it[1], it[2], it[3], it[4]]).collect();
        let [paper, own] = [Role::Paper, figure.drawn_role(link)].map(|role| f32::from(role as u8));
        assert!(looks.ends_with(&[[paper, 0.0, 1.0, 4.0], [own, 1.0, 1.0, 4.0]]));
    }
}

/// A yoke is drawn as a slot with an arm to its own block, not as a bar. Two guides on the frame that cross are
/// channels; their walls are open at the crossing.
#[test]
fn yokes_have_slots_and_crossing_ways_are_channels() {
    let yoke = LinkageSpec::default()
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
    // The arm with its lighter line, the slot with its hole, the block.
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

    let mut trammel = LinkageSpec::default()
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
    trammel.drivers.push(DriverSpec::Crank {
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

/// The ground is a hatched line below the drawing. A ground line far from the drawing is not drawn.
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
    // The line extends at least as far as the supports, within the precision of `f32`.
    let [from, to, _] = ends[0];
    assert!(from <= plain[0] as f32 && plain[2] as f32 <= to && bounds[1] < -4.0);
    assert!(ends.len() > 20 && ends[1..].iter().all(|[_, _, y]| *y < -4.0));
    for far in [-1e300, 1e300, f64::NAN] {
        let (ends, bounds) = lines(Some(far));
        assert!(ends.is_empty() && bounds == plain, "{far}");
    }
}

/// With numbers shown, each link has its number once, in document order; the number of a bar is on the bar. The frame
/// has 0 at each support.
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

/// The arc of the crank's angle ends at every angle in an arrow on the crank. A driven block has an arrow along its
/// guide, off the guide's line.
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
    driven.drivers = vec![DriverSpec::Slide {
        slide: 0,
        range: [2.0, 2.3],
        rate: 1.0,
    }];
    let motion = Motion::new(Mechanism::new(&driven).unwrap());
    let figure = figure_of(&motion);
    let link = motion.mechanism().link("slider").unwrap();
    let body = on_body(&figure, link.index() + 1);
    // The tip is ahead of the pin and above the block.
    let [tip] = tips(&body, figure.drawn_role(link))[..] else {
        panic!("no arrow");
    };
    let unit = unit(&figure);
    assert!(
        (tip - Point::new(4.0 * unit, 3.4 * unit)).norm() < 1e-4 * unit,
        "{tip} {unit}"
    );
}

/// Watt's linkage for a straight line. Its rocker swings from −75° to 34°.
fn rocker() -> LinkageSpec {
    LinkageSpec::default()
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

/// If the input angle is negative, its arc is drawn clockwise.
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

/// With the letters of the paper on the combined method, its sides and corners have names, and no other vector is
/// drawn.
#[test]
fn letters_of_the_combined_method() {
    let draft = LinkageSpec::default()
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
