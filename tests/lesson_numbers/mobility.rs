//! The lesson on mobility by sections: its numbers, and its claims about mechanisms.

mod notes;
mod paper;

use assur::Point;
use assur::mechanism::{LinkageSpec, Mechanism};
use assur::mobility::{Cut, CutError, Generic, PairKind, RankReport, Scheme, Sections, Space};
use assur::motion::Motion;
use assur_file::{Document, LinkageDocument, SchemeDocument, from_catalogue};
use assur_tests::files::preset;

use super::{LANGUAGES, Lesson};

const LESSON: Lesson = Lesson("mobility");

/// What a preset of the lesson has, or of the catalogue: as the page does, it looks for its own first.
fn document(name: &str) -> SchemeDocument {
    if let Some(own) = preset("mobility", name) {
        return serde_json::from_value(own).unwrap();
    }
    let Some(Ok(Document::Scheme(scheme))) = assur_file::document(name) else {
        panic!("{name} is no scheme");
    };
    scheme
}

fn scheme(name: &str) -> Scheme {
    document(name).scheme().unwrap()
}

/// The scheme opened by the cuts of its document.
fn opened(name: &str) -> Sections {
    let document = document(name);
    let scheme = document.scheme().unwrap();
    let cuts = document.cuts(&scheme).unwrap();
    scheme.sections(&cuts).unwrap()
}

fn cut(scheme: &Scheme, names: &[&str]) -> Vec<Cut> {
    let cuts = names.iter().map(|name| scheme.cut_named(name).unwrap());
    cuts.collect()
}

/// What the rank says in the scheme's own space.
fn rank_report(scheme: &Scheme) -> RankReport {
    let space = if scheme.is_planar() {
        Space::Plane
    } else {
        Space::Whole
    };
    scheme.rank_report(space).unwrap()
}

fn redundant(verdict: &RankReport) -> usize {
    verdict.redundancies.iter().map(|one| one.count).sum()
}

/// Numbers of texts, in all languages.
fn tells(key: &str, expected: &[f64]) {
    for lang in LANGUAGES {
        LESSON.tells(lang, key, expected);
    }
}

/// W of every choice of two cuts that opens the scheme.
fn by_pairs_of_cuts(scheme: &Scheme) -> Vec<isize> {
    let names: Vec<&str> = scheme
        .pairs()
        .iter()
        .map(|pair| pair.name.as_str())
        .collect();
    let choices = names
        .iter()
        .enumerate()
        .flat_map(|(at, one)| names[at + 1..].iter().map(move |other| [*one, *other]));
    let opened = choices.filter_map(|names| scheme.sections(&cut(scheme, &names)).ok());
    opened.map(|sections| sections.mobility).collect()
}

#[test]
fn arms_have_seven_freedoms() {
    let arm = scheme("mobility-1a");
    let freedoms: Vec<f64> = (0..arm.pairs().len())
        .map(|pair| f64::from(arm.freedoms(pair)))
        .collect();
    let [one, three] = [PairKind::Revolute, PairKind::Spherical].map(PairKind::freedoms);
    let expected = [&[f64::from(one), f64::from(three)][..], &freedoms].concat();
    tells("arm.text", &expected);
    for name in ["mobility-1a", "mobility-1b"] {
        assert_eq!(opened(name).open, 7);
        assert_eq!(scheme(name).counts().mobility(), 7);
    }
    let hinges = scheme("mobility-1b");
    assert!(
        hinges
            .pairs()
            .iter()
            .all(|pair| pair.kind == PairKind::Revolute)
    );
    assert_eq!(hinges.pairs().len(), arm.pairs().len() + 2 * 2);
}

/// Whichever hinge of the four-bar is cut; of a hinge the plane has 3 − 1, space 6 − 1 constraints.
#[test]
fn four_bar_cut_anywhere() {
    let scheme = scheme("mobility-2a");
    let sections = opened("mobility-2a");
    let [open, removed] = [sections.open, sections.removed].map(|count| count as f64);
    tells("four_bar.text", &[3.0, open, removed]);
    for pair in scheme.pairs() {
        let other = scheme.sections(&cut(&scheme, &[&pair.name])).unwrap();
        assert_eq!(
            (other.open, other.removed, other.mobility),
            (sections.open, sections.removed, sections.mobility)
        );
        assert_eq!(Some(other.mobility), scheme.counts().planar);
    }
}

/// Of the constraints of the cut hinge in space some are needed, the others redundant: the rank
/// says so, too, and that a tilted axis locks the mechanism.
#[test]
fn four_bar_in_space() {
    let sections = opened("mobility-2a");
    let needed = sections.open as isize - sections.mobility;
    assert_eq!(
        sections.redundant,
        sections.removed_spatial as isize - needed
    );
    let four_bar = scheme("mobility-2a");
    let parallel = four_bar.rank_report(Space::Whole).unwrap();
    assert_eq!(parallel.mobility as isize, sections.mobility);
    assert_eq!(redundant(&parallel) as isize, sections.redundant);

    let tilted = scheme("tilted");
    let axes: Vec<_> = tilted
        .pairs()
        .iter()
        .map(|pair| pair.axis.unwrap())
        .collect();
    let tilt = axes[3].angle(&axes[0]).to_degrees();
    assert!(axes[..3].iter().all(|axis| axis == &axes[0]));
    assert_eq!(rank_report(&tilted).mobility, 0);
    assert_ne!(
        tilted.generic(Space::Whole).unwrap(),
        Generic::At { mobility: 1 }
    );

    let counted = [
        sections.open as f64,
        sections.mobility as f64,
        needed as f64,
        sections.mobility as f64,
    ];
    tells(
        "redundant.text",
        &[&[6.0, sections.removed_spatial as f64][..], &counted].concat(),
    );
    tells("redundant.hint", &[sections.removed_spatial as f64]);
    // The equation (3).
    tells("redundant.right", &[3.0]);

    let cut = opened("tilted");
    let [open, removed] = [cut.open, cut.removed].map(|count| count as f64);
    assert_eq!(cut.mobility, -2);
    tells("tilted.text", &[tilt, open, removed]);
    tells("tilted.hint", &[removed]);
    let by_rank = rank_report(&tilted).mobility as f64;
    let told = [by_rank, sections.redundant as f64, sections.mobility as f64];
    tells("tilted.right", &told);
}

/// After the cut Q the moving contour is closed; any second cut of it opens it, and any two cuts that open all
/// contours of the mechanisms give the same W.
#[test]
fn moving_contour() {
    let moving = scheme("moving");
    let names = ["C", "D", "E", "F"];
    let Err(CutError::StillClosed { mut pairs }) = moving.sections(&cut(&moving, &["Q"])) else {
        panic!("nothing is closed");
    };
    pairs.sort_unstable();
    assert_eq!(pairs, names);
    assert_eq!(document("moving").cut, ["Q"]);
    assert_eq!(document("moving").pairs, document("mobility-4").pairs);
    for second in names {
        let sections = moving.sections(&cut(&moving, &["Q", second])).unwrap();
        assert!(sections.loops.iter().all(|contour| contour.redundant == 3));
        for lang in LANGUAGES {
            let text = &LESSON.words(lang)["moving.text"];
            assert!(text.contains(second), "{lang}: {text}");
        }
        let [open, removed, in_space] =
            [sections.open, sections.removed, sections.removed_spatial].map(|count| count as f64);
        // And the equation (6).
        tells("moving.text", &[open, removed, in_space, 6.0]);
        let counts = moving.counts();
        let [links, hinges] = [counts.links, counts.pairs[&1]].map(|count| count as f64);
        tells("moving.hint", &[2.0, in_space, links, hinges]);
        assert_eq!(counts.redundant_by_plane(), Some(sections.redundant));
        tells("moving.right", &[3.0]);
    }
    tells("contours.text", &[3.0]);
    for name in ["moving", "mobility-2c"] {
        let scheme = scheme(name);
        let counts = scheme.counts();
        assert_eq!(counts.pairs.values().sum::<usize>() - counts.links, 2);
        let all = by_pairs_of_cuts(&scheme);
        assert!(all.len() > 4, "{name}: {all:?}");
        assert!(
            all.iter().all(|mobility| Some(*mobility) == counts.planar),
            "{name}: {all:?}"
        );
    }
    for lang in LANGUAGES {
        for (key, text) in LESSON.words(lang) {
            if key.starts_with("contours.right.") && !key.ends_with(".one") {
                LESSON.tells(lang, &key, &[3.0]);
                assert!(text.contains("{pairs}") && text.contains("{links}"));
            }
        }
    }
}

#[test]
fn spatial_mechanism() {
    let scheme = scheme("mobility-3");
    let sections = opened("mobility-3");
    let constraints: Vec<f64> = sections
        .loops
        .iter()
        .map(|contour| f64::from(contour.constraints))
        .collect();
    let [first, second] = constraints[..] else {
        panic!("{constraints:?}");
    };
    assert_eq!(document("mobility-3").cut, ["E", "Q"]);
    tells("spatial.text", &[first, second, sections.open as f64, 1.0]);
    assert_eq!(sections.mobility, scheme.counts().spatial);
    assert_eq!(sections.redundant, 0);
    tells("layout.right", &[sections.redundant as f64]);
    // Other cuts leave other numbers, and the same W.
    let other = scheme.sections(&cut(&scheme, &["B", "Q"])).unwrap();
    assert_ne!(
        (other.open, other.removed),
        (sections.open, sections.removed)
    );
    assert_eq!(other.mobility, sections.mobility);
}

/// What is counted and what the rank says, by the text: too low, or right with links that move idly.
#[test]
fn where_counting_is_mistaken() {
    for (name, counted, mobility, idle) in [
        ("parallelogram", 0, 1, &[][..]),
        ("roller", 2, 2, &["2"]),
        ("sarrus", 0, 1, &[]),
        ("bennett", -2, 1, &[]),
        ("rssr", 2, 2, &["2"]),
        ("hooke", 0, 1, &[]),
    ] {
        let scheme = scheme(name);
        let space = if scheme.is_planar() {
            Space::Plane
        } else {
            Space::Whole
        };
        assert_eq!(scheme.counts().mobility(), counted, "{name}");
        let verdict = rank_report(&scheme);
        assert_eq!(verdict.mobility, mobility, "{name}");
        assert_eq!(
            redundant(&verdict) as isize,
            mobility as isize - counted,
            "{name}"
        );
        let alone: Vec<&str> = verdict
            .idle
            .iter()
            .flatten()
            .map(|link| scheme.link_name(*link))
            .collect();
        assert_eq!(alone, idle, "{name}");
        // They move farther than for an instant.
        let generic = scheme.generic(space).unwrap();
        assert_eq!(generic, Generic::At { mobility }, "{name}");
    }
}

/// One ball in a cylinder is enough, as are a ball and a cylindrical pair; two balls are not.
#[test]
fn mending_the_four_bar() {
    let scheme = scheme("mobility-2a");
    let found = scheme.replacements(1000).unwrap();
    assert!(found.complete);
    let kinds: Vec<Vec<PairKind>> = found
        .list
        .iter()
        .map(|one| one.changes.iter().map(|change| change.kind).collect())
        .collect();
    let sizes: Vec<usize> = kinds.iter().map(Vec::len).collect();
    assert!(sizes.is_sorted(), "{sizes:?}");
    assert_eq!(kinds[0], [PairKind::SphereInCylinder]);
    let mut two = kinds.iter().filter(|kinds| kinds.len() == 2);
    assert!(two.any(|kinds| {
        kinds.contains(&PairKind::Spherical) && kinds.contains(&PairKind::Cylindrical)
    }));
    let balls = |kinds: &&Vec<PairKind>| {
        let balls = kinds.iter().filter(|kind| **kind == PairKind::Spherical);
        balls.count() > 1
    };
    assert!(kinds.iter().find(balls).is_none());
    let [ball, cylindrical, four] = [
        PairKind::Spherical,
        PairKind::Cylindrical,
        PairKind::SphereInCylinder,
    ]
    .map(|kind| kind.freedoms() - 1);
    assert_eq!((ball, cylindrical, four), (2, 1, 3));
    tells("mending.question", &[0.0]);
}

/// A hinge of k links is k − 1 pairs.
#[test]
fn press_with_a_compound_hinge() {
    let scheme = scheme("press");
    let counts = scheme.counts();
    let compound = &scheme.pairs()[scheme.pair("C").unwrap()];
    assert_eq!((compound.links.len(), compound.count()), (3, 2));
    assert_eq!(counts.pairs.iter().collect::<Vec<_>>(), [(&1, &7)]);
    assert_eq!((counts.planar, rank_report(&scheme).mobility), (Some(1), 1));
    tells("practice.text", &[1.0]);
    tells("practice.hint", &[1.0]);
    // W = 3n − 2P₁.
    tells("practice.right", &[3.0, 2.0]);
}

/// A linkage among the lesson's presets, or of the catalogue.
fn linkage(name: &str) -> LinkageSpec {
    let Some(own) = preset("mobility", name) else {
        return from_catalogue(name).unwrap().unwrap().spec();
    };
    let own: LinkageDocument = serde_json::from_value(own).unwrap();
    own.spec()
}

/// Two linkages with a redundant constraint move; with one link a little longer they do not.
#[test]
fn redundant_constraints_in_motion() {
    for (name, longer) in [
        ("coupled-cranks", "third crank"),
        ("doubled", "second coupler"),
    ] {
        let mut draft = linkage(name);
        let mechanism = Mechanism::new(&draft).unwrap();
        assert!(Motion::new(mechanism.clone()).cycle().is_full(), "{name}");
        let counts =
            [mechanism.counts().links, mechanism.counts().lower_pairs].map(|count| count as f64);
        let count = mechanism.mobility().by_count as f64;
        tells("moves.text", &[&counts[..], &[count]].concat());
        let rank = mechanism.mobility().by_rank as f64;
        tells("moves.hint", &[rank]);
        tells("moves.right", &[rank, count]);

        let place = |point: &String| {
            draft
                .points
                .iter()
                .find(|one| one.name == *point)
                .unwrap()
                .at
        };
        let link = draft
            .links
            .iter()
            .position(|link| link.name == longer)
            .unwrap();
        let [from, to] = [0, 1].map(|end| place(&draft.links[link].points[end]));
        draft.links[link].shape = Some(vec![
            Point::origin(),
            Point::new(1.01 * (to - from).norm(), 0.0),
        ]);
        assert!(Mechanism::new(&draft).is_err(), "{name}");
    }
}
