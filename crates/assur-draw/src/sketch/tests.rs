use super::*;

#[test]
fn an_empty_sheet_has_room() {
    let sketch = Sketch::new(&LinkageSpec::default(), &SketchView::default());
    assert_eq!(sketch.bounds(), SHEET);
    assert_eq!(sketch.frame(), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(sketch.link_at(Point::origin()).is_none());
}

#[test]
fn links_are_found_and_told_in_colour() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 4.0, 0.0)
        .point("C", 4.0, 3.0)
        .bar("one", &["A", "B"])
        .bar("two", &["B", "C"])
        .bar("nowhere", &["X", "Y"])
        .fixed(&["A"])
        .crank("one");
    let view = SketchView {
        loose: vec!["two".to_owned()],
        locked: vec!["nowhere".to_owned()],
        ..SketchView::default()
    };
    let sketch = Sketch::new(&draft, &view);
    assert_eq!(sketch.roles(), [Role::Crank, Role::Loose, Role::Locked]);
    assert_eq!(sketch.link_at(Point::new(4.0, 2.0)), Some(("two", 0.0)));
    let (name, off) = sketch.link_at(Point::new(2.0, -1.0)).unwrap();
    assert_eq!(name, "one");
    assert!((off - (1.0 - BAR * sketch.unit)).abs() < 1e-12);
    assert_eq!(sketch.names(), ["A", "B", "C"]);
}

#[test]
fn a_driver_changes_no_other_links_colour() {
    let draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 1.0)
        .point("C", 3.0, 2.0)
        .point("D", 4.0, 0.0)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C"])
        .bar("rocker", &["D", "C"]);
    let roles = |draft: &LinkageSpec| {
        let sketch = Sketch::new(draft, &SketchView::default());
        sketch.roles().to_vec()
    };
    let before = roles(&draft);
    let driven = roles(&draft.crank("crank"));
    assert_eq!(before[1..], driven[1..]);
    assert_eq!([before[0], driven[0]], [Role::Accent4, Role::Crank]);
}

#[test]
fn a_given_unit_keeps_the_size_of_symbols() {
    let view = SketchView {
        symbol: Some(0.07),
        ..SketchView::default()
    };
    let near = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 1.0, 0.0);
    let far = near.clone().point("C", 40.0, 30.0);
    for draft in [LinkageSpec::default(), near, far] {
        assert_eq!(Sketch::new(&draft, &view).unit, 0.07);
    }
}

#[test]
fn the_hatching_of_a_guide_is_away_from_the_pivots() {
    for (height, down) in [(-1.0, -1.0), (1.0, 1.0), (0.0, -1.0)] {
        let draft = LinkageSpec::default()
            .point("A", 0.0, 0.0)
            .point("B", 0.5, 0.5)
            .point("C", 4.0, height)
            .point("G", 3.0, height)
            .point("H", 6.0, height)
            .fixed(&["A", "G", "H"])
            .bar("crank", &["A", "B"])
            .bar("block", &["C"])
            .slide("block", "C", FRAME, ["G", "H"]);
        let sketch = Sketch::new(&draft, &SketchView::default());
        let side = sketch.outer(Point::new(3.0, height), Vector::x());
        assert_eq!(side.y, down, "{height}");
    }
}

#[test]
fn damaged_drafts_are_drawn_without_what_is_not_there() {
    let draft = LinkageSpec::default()
        .point("A", 1.0, 1.0)
        .point("B", 1.0, 1.0)
        .bar("bar", &["A", "B"])
        .slide("bar", "A", FRAME, ["A", "Z"])
        .slide("none", "Q", "bar", ["A", "B"]);
    let sketch = Sketch::new(&draft, &SketchView::default());
    assert!(sketch.frame().iter().all(|number| number.is_finite()));
}

#[test]
fn a_sheet_has_room_for_its_unit() {
    let view = SketchView {
        sheet: 20.0,
        ..SketchView::default()
    };
    let sketch = Sketch::new(&LinkageSpec::default(), &view);
    assert_eq!(sketch.bounds(), SHEET.map(|side| 20.0 * side));
    let one = LinkageSpec::default().point("A", 100.0, 50.0);
    let bounds = Sketch::new(&one, &view).bounds();
    assert_eq!(bounds, [-20.0, -30.0, 220.0, 130.0]);
}

#[test]
fn wheels_are_found_by_their_discs_and_a_ring_by_its_rim() {
    let mut draft = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 4.0, 0.0)
        .bar("carrier", &["A", "B"])
        .bar("sun", &["A"])
        .bar("planet", &["B"])
        .bar("ring", &["A"])
        .fixed(&["A"]);
    let unmeshed = Sketch::new(&draft, &SketchView::default());
    let rim = WHEEL * unmeshed.unit;
    let above = |x: f64, y: f64| Point::new(x, y);
    assert_eq!(unmeshed.wheel_at(above(4.0, 0.9 * rim)), Some("planet"));
    assert_eq!(
        unmeshed.link_at(above(4.0, 0.9 * rim)),
        Some(("planet", 0.0))
    );
    assert_eq!(unmeshed.wheel_at(above(4.0, 1.1 * rim)), None);

    draft.gears = vec![
        assur::mechanism::GearSpec {
            links: ["sun", "planet"].map(str::to_owned),
            carrier: "carrier".to_owned(),
            teeth: [20.0, 20.0],
            mesh: assur::gears::Mesh::External,
        },
        assur::mechanism::GearSpec {
            links: ["planet", "ring"].map(str::to_owned),
            carrier: "carrier".to_owned(),
            teeth: [20.0, 60.0],
            mesh: assur::gears::Mesh::Internal,
        },
    ];
    let sketch = Sketch::new(&draft, &SketchView::default());
    for (place, wheel, link) in [
        (above(0.0, 1.5), Some("sun"), Some("sun")),
        (above(4.0, -1.5), Some("planet"), Some("planet")),
        (above(-5.0, 0.5), None, None),
        (above(-6.0, 0.0), Some("ring"), Some("ring")),
        (above(0.0, 6.1), Some("ring"), Some("ring")),
        (above(0.0, -5.9), Some("ring"), Some("ring")),
        (above(1.0, 0.0), Some("sun"), Some("carrier")),
        (above(6.5, 0.0), None, None),
    ] {
        assert_eq!(sketch.wheel_at(place), wheel, "{place}");
        let found = sketch.link_at(place).filter(|(_, off)| *off == 0.0);
        assert_eq!(found.map(|(name, _)| name), link, "{place}");
    }
}
