//! Linkages drawn from an empty sheet, and refused edits.

mod changes;
mod masses;

use assur::mechanism::{Defect, Mechanism};
use assur::motion::Motion;
use assur_edit::{Advice, Edit, Edited, End, Inner, Line, Mend, Outer, edited, selected};
use assur_file::{LinkageDocument, LinkageProblem, Problem};

fn at(x: f64, y: f64) -> End {
    End::At([x, y])
}

fn point(name: &str) -> End {
    End::Point(name.to_owned())
}

fn text(name: &str) -> String {
    name.to_owned()
}

#[track_caller]
fn done(document: &LinkageDocument, edits: &[Edit]) -> LinkageDocument {
    edits.iter().fold(document.clone(), |document, edit| {
        let after = edited(&document, edit);
        after
            .unwrap_or_else(|problems| panic!("{edit:?}: {problems:?}"))
            .document
    })
}

/// Draws a four-bar with A and D on the frame and without a driver.
fn four_bar() -> LinkageDocument {
    done(
        &LinkageDocument::default(),
        &[
            Edit::Point {
                at: [0.0, 0.0],
                fixed: true,
            },
            Edit::Bar {
                ends: [point("A"), at(0.0, 1.0)],
            },
            Edit::Bar {
                ends: [point("B"), at(3.0, 2.5)],
            },
            Edit::Bar {
                ends: [point("C"), at(4.0, 0.0)],
            },
            Edit::Fix { point: text("D") },
        ],
    )
}

#[track_caller]
fn refused(document: &LinkageDocument, edit: &Edit) -> LinkageProblem {
    match edited(document, edit).unwrap_err().remove(0) {
        Problem::Linkage(problem) => problem,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn formula(document: &LinkageDocument) -> String {
    let mechanism = Mechanism::new(&document.spec());
    let mechanism = mechanism.unwrap_or_else(|defects| panic!("{defects:?}"));
    mechanism.formula()
}

#[test]
fn a_four_bar_moves_as_soon_as_it_is_driven() {
    let drawn = four_bar();
    let advice = Advice::of(&drawn).unwrap().unwrap();
    assert_eq!(advice.mobility, Some(1));
    assert_eq!(
        advice.mends[..2],
        [Mend::Drive(text("AB")), Mend::Drive(text("DC"))]
    );
    let driven = done(&drawn, &[advice.mends[0].edit()]);
    assert!(Advice::of(&driven).unwrap().is_none());
    assert_eq!(formula(&driven), "I(frame,AB) → II₂(BC,DC)");
    let again = done(&driven, &[Edit::Drive { link: text("AB") }]);
    assert_eq!(again, drawn);
    // With one degree of freedom, a new driver replaces the existing one.
    let other = done(&driven, &[Edit::Drive { link: text("DC") }]);
    assert_eq!(other.drivers.len(), 1);
    assert_eq!(other.drivers[0].crank.as_deref(), Some("DC"));
}

/// The angle of a rocker is measured at its fixed pivot, whichever end was drawn first. A bar keeps its direction if a
/// traced point depends on it.
#[test]
fn a_link_to_the_frame_begins_at_its_pivot() {
    let ends = |document: &LinkageDocument| document.links.last().unwrap().points.clone();
    let drawn = four_bar();
    assert_eq!(ends(&drawn), ["D", "C"]);
    let to_pivot = Edit::Bar {
        ends: [point("B"), End::Fixed([1.0, -2.0])],
    };
    assert_eq!(ends(&done(&drawn, &[to_pivot])), ["E", "B"]);
    let loose = [
        Edit::Bar {
            ends: [point("C"), at(6.0, 0.0)],
        },
        Edit::Trace {
            link: text("CE"),
            at: [5.0, 1.0],
        },
        Edit::Fix { point: text("E") },
    ];
    assert_eq!(ends(&done(&drawn, &loose)), ["C", "E"]);
}

#[test]
fn what_needs_two_edits_is_told_the_first() {
    let free = done(&four_bar(), &[Edit::Fix { point: text("D") }]);
    let advice = Advice::of(&free).unwrap().unwrap();
    assert_eq!(advice.mobility, Some(3));
    let mend = Mend::Fix(text("D"));
    assert_eq!(advice.mends[0], mend);
    let next = Advice::of(&done(&free, &[mend.edit()])).unwrap().unwrap();
    assert_eq!(next.mends[0], Mend::Drive(text("AB")));
}

/// A triangle fixed to the frame has mobility 0: it is locked, and the advice is to remove a link.
#[test]
fn what_is_rigid_is_told_by_its_count() {
    let rigid = done(
        &four_bar(),
        &[
            Edit::Remove {
                points: vec![text("D")],
                links: vec![],
            },
            Edit::Fix { point: text("C") },
        ],
    );
    let advice = Advice::of(&rigid).unwrap().unwrap();
    assert_eq!(advice.mobility, Some(0));
    assert_eq!(advice.locked, ["AB", "CB"]);
    let [Problem::Linkage(LinkageProblem::Defect(Defect::Locked { mobility: 0, .. }))] =
        &advice.problems[..]
    else {
        panic!("{:?}", advice.problems);
    };
    assert_eq!(
        advice.mends,
        [Mend::Remove(text("AB")), Mend::Remove(text("CB"))]
    );
}

/// The same edit fixes a wheel to the frame and releases it.
#[test]
fn a_wheel_is_fixed_to_the_frame() {
    let wheel = done(
        &LinkageDocument::default(),
        &[Edit::Wheel { end: at(0.0, 0.0) }],
    );
    let weld = Edit::Weld {
        links: [text("wheel"), text("frame")],
    };
    let fixed = done(&wheel, std::slice::from_ref(&weld));
    assert_eq!(fixed.links[0].fixed_to.as_deref(), Some("frame"));
    assert_eq!(done(&fixed, &[weld]), wheel);
}

/// Three cranks that are parallel only to four decimals. The advised correction moves every point by less than 1e-4,
/// and then the linkage moves.
#[test]
fn what_is_nearly_redundant_is_made_exact() {
    let text = r#"{
        "points": [
            { "name": "A", "at": [0, 0] }, { "name": "D", "at": [4, 0] }, { "name": "G", "at": [2, 0.3] },
            { "name": "B", "at": [0.6001, 0.8] }, { "name": "C", "at": [4.6, 0.7999] }, { "name": "H", "at": [2.6, 1.1] }
        ],
        "frame": ["A", "D", "G"],
        "links": [
            { "name": "AB", "points": ["A", "B"] }, { "name": "rod", "points": ["B", "C", "H"] },
            { "name": "DC", "points": ["D", "C"] }, { "name": "GH", "points": ["G", "H"] }
        ],
        "drivers": [{ "crank": "AB" }]
    }"#;
    let drawn: LinkageDocument = serde_json::from_str(text).unwrap();
    let advice = Advice::of(&drawn).unwrap().unwrap();
    let [mend @ Mend::Exact { by, .. }] = &advice.mends[..] else {
        panic!("{:?}", advice.mends);
    };
    assert!(*by > 1e-5 && *by < 1e-4, "{by}");
    let exact = done(&drawn, &[mend.edit()]);
    assert!(Advice::of(&exact).unwrap().is_none());
    assert_eq!(formula(&exact), "I(frame,AB) → II₂(rod,DC) → q₁(GH)");
    let moved = drawn.points.iter().zip(&exact.points).map(|(one, other)| {
        let [x, y] = [0, 1].map(|axis| one.at[axis] - other.at[axis]);
        x.hypot(y)
    });
    assert_eq!(moved.fold(0.0, f64::max), *by);
}

#[test]
fn links_are_called_by_their_points() {
    let plate = done(
        &four_bar(),
        &[Edit::Corner {
            link: text("BC"),
            end: at(2.0, 3.0),
        }],
    );
    assert_eq!(plate.links[1].name, "BCE");
    let called = done(
        &plate,
        &[Edit::Rename {
            name: text("E"),
            to: text("M"),
        }],
    );
    assert_eq!(called.links[1].name, "BCM");
    let own = done(
        &called,
        &[Edit::Rename {
            name: text("BCM"),
            to: text("coupler"),
        }],
    );
    let renamed = done(
        &own,
        &[Edit::Rename {
            name: text("M"),
            to: text("K"),
        }],
    );
    assert_eq!(renamed.links[1].name, "coupler");
    let taken = refused(
        &renamed,
        &Edit::Rename {
            name: text("K"),
            to: text("A"),
        },
    );
    assert_eq!(taken, Defect::Twice { name: text("A") }.into());
}

#[test]
fn all_five_dyads_make_groups() {
    let crank = done(
        &LinkageDocument::default(),
        &[
            Edit::Point {
                at: [0.0, 0.0],
                fixed: true,
            },
            Edit::Bar {
                ends: [point("A"), at(0.4, 1.0)],
            },
            Edit::Point {
                at: [4.0, 0.5],
                fixed: true,
            },
            Edit::Drive { link: text("AB") },
        ],
    );
    let hinge = |name: &str| Outer::Hinge(point(name));
    let level = |x: f64, y: f64| Outer::Level([x, y]);
    let all = [
        ([hinge("B"), hinge("C")], Inner::Hinge),
        ([hinge("B"), level(4.0, -0.3)], Inner::Hinge),
        ([hinge("B"), hinge("C")], Inner::Slide),
        (
            [Outer::Slide(text("AB"), [0.2, 0.5]), level(4.0, 0.7)],
            Inner::Hinge,
        ),
        ([level(0.0, 3.0), hinge("B")], Inner::Slide),
    ];
    for (outer, inner) in all {
        let drawn = done(
            &crank,
            &[Edit::Dyad {
                outer: outer.clone(),
                inner,
            }],
        );
        let formula = formula(&drawn);
        let [from, to] = drawn.links[1..]
            .iter()
            .map(|link| link.name.as_str())
            .collect::<Vec<_>>()[..]
        else {
            panic!("{formula}")
        };
        let either = [[from, to], [to, from]].map(|[a, b]| format!("I(frame,AB) → II₂({a},{b})"));
        assert!(either.contains(&formula), "{outer:?} {inner:?}: {formula}");
    }
    let three = [level(0.0, 1.0), Outer::Slide(text("AB"), [0.0, 0.5])];
    let none = Edit::Dyad {
        outer: three,
        inner: Inner::Slide,
    };
    assert_eq!(refused(&crank, &none), LinkageProblem::NoSuchDyad);
}

#[test]
fn a_triad_is_of_class_three() {
    let base = done(
        &LinkageDocument::default(),
        &[
            Edit::Point {
                at: [0.0, 0.0],
                fixed: true,
            },
            Edit::Bar {
                ends: [point("A"), at(0.4, 1.0)],
            },
            Edit::Point {
                at: [4.0, 0.5],
                fixed: true,
            },
            Edit::Point {
                at: [3.0, 4.0],
                fixed: true,
            },
            Edit::Drive { link: text("AB") },
            Edit::Triad {
                ends: [point("B"), point("C"), point("D")],
            },
        ],
    );
    assert_eq!(formula(&base), "I(frame,AB) → III₃(BE,CF,DG,EFG)");
}
