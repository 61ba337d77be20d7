//! Edits of an existing drawing: refused, removed, pasted, moved.

use super::*;

#[test]
fn what_cannot_be_is_refused_by_name() {
    let drawn = four_bar();
    let one_place = refused(
        &drawn,
        &Edit::Bar {
            ends: [point("A"), at(0.0, 0.0)],
        },
    );
    assert_eq!(
        one_place,
        LinkageProblem::OnePlace {
            points: [text("A"), text("E")]
        }
    );
    let same = refused(
        &drawn,
        &Edit::Bar {
            ends: [point("A"), point("A")],
        },
    );
    assert_eq!(
        same,
        LinkageProblem::OnePlace {
            points: [text("A"), text("A")]
        }
    );
    let joined = refused(
        &drawn,
        &Edit::Join {
            points: [text("B"), text("C")],
        },
    );
    let points = [text("B"), text("C")];
    assert_eq!(
        joined,
        LinkageProblem::OneLink {
            link: text("BC"),
            points
        }
    );
    let unknown = refused(&drawn, &Edit::Fix { point: text("Z") });
    assert_eq!(unknown, Defect::UnknownName { name: text("Z") }.into());
    for no in [f64::NAN, f64::INFINITY, -1e10] {
        let far = refused(
            &drawn,
            &Edit::Place {
                point: text("B"),
                at: [no, 0.0],
            },
        );
        assert_eq!(far, Defect::NotFinite { name: text("B") }.into());
    }
}

#[test]
fn a_hinge_cannot_be_joined_with_the_line_it_slides_along() {
    let drawn = done(
        &four_bar(),
        &[Edit::Block {
            end: at(1.0, -1.0),
            along: Line::Toward([3.0, -1.0]),
        }],
    );
    let [hinge, end] = [
        drawn.slides[0].point.clone(),
        drawn.slides[0].line[1].clone(),
    ];
    let joined = refused(
        &drawn,
        &Edit::Join {
            points: [hinge.clone(), end],
        },
    );
    assert_eq!(
        joined,
        LinkageProblem::OnItsLine {
            link: text("block"),
            point: hinge
        }
    );
}

#[test]
fn what_goes_takes_along_what_cannot_be_without_it() {
    let shaper = done(
        &four_bar(),
        &[
            Edit::Block {
                end: point("C"),
                along: Line::Toward([8.0, 2.5]),
            },
            Edit::Drive {
                link: text("block"),
            },
            Edit::Trace {
                link: text("BC"),
                at: [1.0, 3.0],
            },
        ],
    );
    assert_eq!(shaper.drivers[0].slide, Some(0));
    let without = done(
        &shaper,
        &[Edit::Remove {
            points: vec![text("C")],
            links: vec![],
        }],
    );
    let left: Vec<&str> = without
        .links
        .iter()
        .map(|link| link.name.as_str())
        .collect();
    assert_eq!(left, ["AB"]);
    assert!(without.slides.is_empty() && without.drivers.is_empty() && without.tracers.is_empty());
    let points: Vec<&str> = without
        .points
        .iter()
        .map(|point| point.name.as_str())
        .collect();
    assert_eq!(points, ["A", "B"], "the ends of the guide go with it");
    let nothing = done(
        &without,
        &[Edit::Remove {
            points: vec![],
            links: vec![text("AB")],
        }],
    );
    assert_eq!(nothing, LinkageDocument::default());
}

#[test]
fn hinges_part_and_join_again() {
    let driven = done(&four_bar(), &[Edit::Drive { link: text("AB") }]);
    let parted = done(&driven, &[Edit::Part { point: text("C") }]);
    assert_eq!(parted.points.len(), 5);
    let advice = Advice::of(&parted).unwrap().unwrap();
    assert_eq!(advice.mobility, Some(3));
    assert_eq!(advice.loose, ["BC", "DE"]);
    let joined = done(
        &parted,
        &[Edit::Join {
            points: [text("E"), text("C")],
        }],
    );
    assert_eq!(formula(&joined), formula(&driven));
}

#[test]
fn what_is_pasted_moves_alike() {
    let driven = done(&four_bar(), &[Edit::Drive { link: text("AB") }]);
    let links: Vec<String> = driven.links.iter().map(|link| link.name.clone()).collect();
    let copy = selected(&driven, &[], &links);
    assert_eq!(copy.points, driven.points);
    let both = done(
        &driven,
        &[Edit::Paste {
            drawing: Box::new(copy.clone()),
            by: [6.0, 0.0],
        }],
    );
    let names: Vec<&str> = both.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(names, ["AB", "BC", "DC", "EF", "FG", "HG"]);
    let motion = Motion::new(Mechanism::new(&both.spec()).unwrap());
    let mechanism = motion.mechanism();
    for k in 0..36 {
        let input = motion.drawn_input() + f64::from(k) * 0.17;
        let pose = motion.pose::<1>(input).unwrap();
        let [c, g] = ["C", "G"].map(|name| {
            mechanism
                .place(&pose, mechanism.point(name).unwrap())
                .place()
        });
        assert!((g.x - c.x - 6.0).abs() < 1e-12 && (g.y - c.y).abs() < 1e-12);
    }
    // In an empty sheet, the pasted parts keep their names.
    let empty = done(
        &LinkageDocument::default(),
        &[Edit::Paste {
            drawing: Box::new(copy),
            by: [0.0, 0.0],
        }],
    );
    assert_eq!(empty.points, driven.points);
    assert_eq!(empty.links, driven.links);
}

#[test]
fn what_stands_elsewhere_is_as_drawn_and_the_rest_keeps_its_lengths() {
    let mut driven = done(&four_bar(), &[Edit::Drive { link: text("AB") }]);
    driven.links[0].length = Some(1.0);
    driven.links[2].length = Some(7.25_f64.sqrt());
    let moved = done(
        &driven,
        &[Edit::Place {
            point: text("B"),
            at: [0.2, 1.3],
        }],
    );
    assert_eq!(moved.points[1].at, [0.2, 1.3]);
    assert_eq!(
        [moved.links[0].length, moved.links[2].length],
        [None, Some(7.25_f64.sqrt())]
    );
    let all: Vec<String> = driven
        .points
        .iter()
        .map(|point| point.name.clone())
        .collect();
    let shifted = done(
        &driven,
        &[Edit::Move {
            points: all.clone(),
            by: [2.0, 0.0],
        }],
    );
    assert_eq!(shifted.links, driven.links);
    let once = done(
        &driven,
        &[Edit::Mirror {
            points: all.clone(),
        }],
    );
    let back = done(&once, &[Edit::Mirror { points: all }]);
    assert_eq!(back, driven);
}

#[test]
fn a_guide_goes_with_its_block() {
    let drawn = done(
        &four_bar(),
        &[
            Edit::Block {
                end: point("C"),
                along: Line::Toward([8.0, 2.5]),
            },
            Edit::Move {
                points: vec![text("C")],
                by: [0.0, 1.0],
            },
        ],
    );
    let [from, to] = [&drawn.points[4], &drawn.points[5]].map(|point| point.at);
    assert_eq!([from, to], [[3.0, 3.5], [8.0, 3.5]]);
}

#[test]
fn numbers_are_set() {
    let drawn = done(
        &four_bar(),
        &[
            Edit::Corner {
                link: text("AB"),
                end: at(-1.0, 1.0),
            },
            Edit::Trace {
                link: text("BC"),
                at: [1.0, 3.0],
            },
            Edit::Turn {
                link: text("ABE"),
                angle_deg: 0.0,
            },
            Edit::Stretch {
                link: text("ABE"),
                length: 2.0,
            },
            Edit::Place {
                point: text("P1"),
                at: [1.0, 1.0],
            },
        ],
    );
    let place = |name: &str| {
        drawn
            .points
            .iter()
            .find(|point| point.name == name)
            .unwrap()
            .at
    };
    assert_eq!(place("B"), [2.0, 0.0]);
    let [x, y] = place("E");
    assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
    let mechanism =
        Mechanism::new(&done(&drawn, &[Edit::Drive { link: text("ABE") }]).spec()).unwrap();
    let motion = Motion::new(mechanism);
    let pose = motion.pose::<1>(motion.drawn_input()).unwrap();
    let traced = motion.mechanism().point("P1").unwrap();
    let at = motion.mechanism().place(&pose, traced).place();
    assert!((at.x - 1.0).abs() < 1e-14 && (at.y - 1.0).abs() < 1e-14);
    let none = refused(
        &drawn,
        &Edit::Stretch {
            link: text("BC"),
            length: -1.0,
        },
    );
    assert_eq!(
        none,
        LinkageProblem::BadLength {
            path: text("BC.length"),
            value: -1.0
        }
    );
}

/// The result of an edit names the point and the link that were added.
#[test]
fn what_is_made_is_told() {
    let Edited {
        point: made, link, ..
    } = edited(
        &four_bar(),
        &Edit::Bar {
            ends: [End::On(text("BC"), [2.0, 3.0]), at(5.0, 5.0)],
        },
    )
    .unwrap();
    assert_eq!(made.as_deref(), Some("F"));
    assert_eq!(link.as_deref(), Some("EF"));
}

/// A coordinate may be too large in a file, although no edit makes such a coordinate.
#[test]
fn what_is_too_far_is_not_drawn() {
    let mut far = four_bar();
    far.points[2].at[0] = 1e300;
    let told = Advice::of(&far).unwrap_err();
    let name = text("C");
    assert_eq!(told, [Defect::NotFinite { name }.into()]);
}

#[test]
fn what_is_driven_is_not_loose() {
    let free = done(
        &four_bar(),
        &[
            Edit::Fix { point: text("D") },
            Edit::Drive { link: text("AB") },
        ],
    );
    let advice = Advice::of(&free).unwrap().unwrap();
    assert_eq!(advice.loose, ["BC", "DC"]);
}
