use super::*;

#[test]
fn an_empty_sheet_has_room() {
    let sketch = Sketch::new(&Draft::default(), &SketchView::default());
    assert_eq!(sketch.bounds(), SHEET);
    assert_eq!(sketch.frame(), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(sketch.link_at(Point::origin()).is_none());
}

#[test]
fn links_are_found_and_told_in_colour() {
    let draft = Draft::default()
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
fn damaged_drafts_are_drawn_without_what_is_not_there() {
    let draft = Draft::default()
        .point("A", 1.0, 1.0)
        .point("B", 1.0, 1.0)
        .bar("bar", &["A", "B"])
        .slide("bar", "A", FRAME, ["A", "Z"])
        .slide("none", "Q", "bar", ["A", "B"]);
    let sketch = Sketch::new(&draft, &SketchView::default());
    assert!(sketch.frame().iter().all(|number| number.is_finite()));
}
