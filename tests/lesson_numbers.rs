//! Numbers in the texts of the lessons, in every language: the engine computes the same.

mod assemblies;
mod class4_notes;
mod differential;
mod flywheel;
mod forces;
mod mixer;
mod mobility;
mod poses_paths;
mod synthesis;

use std::collections::BTreeMap;

use assur::mechanism::{LinkId, Quantity};
use assur::motion::{Dwell, Motion, OutputProfile};
use assur_file::{LinkageDocument, from_catalogue};
use assur_tests::files::source;

const LANGUAGES: [&str; 4] = ["en", "ru", "uk", "kk"];

/// Lessons that have notes for teachers.
const WITH_NOTES: [&str; 8] = [
    "mixer",
    "class4-dwell",
    "mobility",
    "differential",
    "synthesis",
    "mixer-forces",
    "run-up",
    "poses-paths",
];
const LESSON: Lesson = Lesson("class4-dwell");

/// A lesson, by its folder.
struct Lesson(&'static str);

/// A number in a text, and half a unit of its last digit.
type Written = (f64, f64);

/// The numbers of a text, with the language's decimal sign. Another sign would make two
/// numbers of one.
fn numbers(text: &str, lang: &str) -> Vec<Written> {
    let sign = if lang == "en" { '.' } else { ',' };
    let part = |c: char| c.is_ascii_digit() || c == sign;
    let parts = text.split(|c: char| !part(c));
    let number = |part: &str| {
        let digits = part.trim_matches(sign).replace(sign, ".");
        let decimals = digits
            .split_once('.')
            .map_or(0, |(_, decimals)| decimals.len());
        let unit = 0.1_f64.powi(i32::try_from(decimals).unwrap());
        digits.parse().ok().map(|value| (value, 0.5 * unit))
    };
    parts.filter_map(number).collect()
}

impl Lesson {
    fn file(&self, name: &str) -> String {
        source(&format!("www/lessons/{}/{name}", self.0))
    }

    fn words(&self, lang: &str) -> BTreeMap<String, String> {
        serde_json::from_str(&self.file(&format!("words.{lang}.json"))).unwrap()
    }

    /// A text has these numbers, in this order, rounded to the digits it gives.
    fn tells(&self, lang: &str, key: &str, expected: &[f64]) {
        let text = &self.words(lang)[key];
        let found = numbers(text, lang);
        assert_eq!(found.len(), expected.len(), "{lang} {key}: {text}");
        for ((written, half), value) in found.into_iter().zip(expected) {
            assert!(
                (written - value).abs() <= half * (1.0 + 1e-9),
                "{lang} {key}: {written}, but it is {value}"
            );
        }
    }
}

/// Notes for teachers are in every language and have the numbers of the English ones, in their order, and the same commands.
#[test]
fn notes_for_teachers_have_the_same_numbers_in_every_language() {
    for lesson in WITH_NOTES.map(Lesson) {
        let values = |lang: &str| {
            let text = lesson.file(&format!("notes.{lang}.md"));
            let parts: Vec<&str> = text.split('`').collect();
            let prose: Vec<&str> = parts.iter().step_by(2).copied().collect();
            let commands: Vec<String> = parts
                .iter()
                .skip(1)
                .step_by(2)
                .map(|one| (*one).to_owned())
                .collect();
            let found = numbers(&prose.join(" "), lang);
            let found: Vec<f64> = found.into_iter().map(|(value, _)| value).collect();
            (found, commands)
        };
        let english = values("en");
        assert!(english.0.len() > 50, "{}: {}", lesson.0, english.0.len());
        for lang in LANGUAGES {
            assert_eq!(values(lang), english, "{} {lang}", lesson.0);
        }
    }
}

fn document() -> LinkageDocument {
    from_catalogue("class4-dwell").unwrap().unwrap()
}

/// The length of FK as it is drawn.
fn drawn_fk() -> f64 {
    let document = document();
    let at = |name: &str| document.points.iter().find(|one| one.name == name);
    let [[x, y], [u, v]] = ["F", "K"].map(|name| at(name).unwrap().at);
    (u - x).hypot(v - y)
}

/// The mechanism with FK longer by so much, as its slider makes it.
fn lengthened(by: f64) -> Motion {
    let mut document = document();
    let link = document.links.iter_mut().find(|link| link.name == "FK");
    link.unwrap().length = Some(drawn_fk() + by);
    document.motion().unwrap()
}

/// The longest dwell of CD within so many degrees.
fn dwell(motion: &Motion, tolerance_deg: f64) -> Dwell {
    let output = Quantity::named(motion.mechanism(), "CD.angle").unwrap();
    let profile = OutputProfile::new(motion, output).unwrap();
    profile.dwell(tolerance_deg.to_radians()).unwrap()
}

fn length_deg(motion: &Motion, tolerance_deg: f64) -> f64 {
    dwell(motion, tolerance_deg).length().to_degrees()
}

fn stroke(motion: &Motion) -> f64 {
    let output = Quantity::named(motion.mechanism(), "CD.angle").unwrap();
    OutputProfile::new(motion, output)
        .unwrap()
        .stroke()
        .unwrap()
}

/// The length that "Show it" gives to FK.
fn shown_fk() -> f64 {
    let script = LESSON.file("lesson.js");
    let (_, rest) = script.split_once("const REGULATED = ").unwrap();
    rest.split_once(';').unwrap().0.parse().unwrap()
}

/// How the links move while the output dwells: by how much each angle varies, degrees.
fn swings(motion: &Motion, arc: [f64; 2]) -> BTreeMap<String, f64> {
    let mechanism = motion.mechanism();
    let swing = |link: LinkId| {
        let name = mechanism.link_name(link).to_owned();
        let angles = (0..=2000).map(|k| {
            let input = arc[0] + (arc[1] - arc[0]) * f64::from(k) / 2000.0;
            mechanism
                .angle(&motion.pose::<1>(input).unwrap(), link)
                .value()
        });
        let [low, high] = angles.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], angle| {
            [low.min(angle), high.max(angle)]
        });
        (name, (high - low).to_degrees())
    };
    mechanism.link_ids().map(swing).collect()
}

/// The output stands to within the band, the other links move by what is written, and
/// C runs on a circle about D, hardly moving in the dwell.
#[test]
fn what_moves_while_the_output_dwells() {
    let document = document();
    let tolerance = document.band.unwrap();
    let motion = document.motion().unwrap();
    let found = dwell(&motion, tolerance);
    let swings = swings(&motion, found.arc);
    assert!(swings["CD"] <= tolerance * (1.0 + 1e-9), "{swings:?}");
    for (link, swing) in &swings {
        assert!(link == "CD" || *swing > 2.0, "{link}: {swing}");
    }
    let moving = ["BE", "EGF", "FK", "HGL", "CLK"].map(|link| swings[link]);

    let mechanism = motion.mechanism();
    let place = |name: &str, input: f64| {
        let index = mechanism.point(name).unwrap();
        let place = mechanism.place(&motion.pose::<1>(input).unwrap(), index);
        [place.x.value(), place.y.value()]
    };
    let radius = |input: f64| {
        let [[cx, cy], [dx, dy]] = ["C", "D"].map(|name| place(name, input));
        (cx - dx).hypot(cy - dy)
    };
    let first = radius(0.0);
    assert!((0..360).all(|k| (radius(f64::from(k).to_radians()) - first).abs() < 1e-12));
    assert!(swings["CD"].to_radians() * first < 0.02);

    for lang in LANGUAGES {
        LESSON.tells(lang, "dwell.text", &moving);
        let text = &LESSON.words(lang)["dwell.text"];
        let places = ["BE,", "EGF", "FK", "HGL", "CLK"].map(|link| text.find(link).unwrap());
        assert!(places.is_sorted(), "{lang}: {text}");
    }
    // "About half a turn".
    assert!((found.length().to_degrees() - 180.0).abs() < 5.0);
}

#[test]
fn how_the_dwell_depends_on_its_tolerance() {
    let motion = document().motion().unwrap();
    let tolerance = document().band.unwrap();
    let shorter = length_deg(&motion, tolerance) - length_deg(&motion, 0.1 * tolerance);
    for lang in LANGUAGES {
        LESSON.tells(lang, "dwell.question", &[tolerance]);
        LESSON.tells(lang, "dwell.right", &[shorter]);
        LESSON.tells(lang, "regulator.question", &[tolerance]);
    }
}

/// FK longer by what the text says gives the dwell and the stroke it says.
#[test]
fn what_the_regulator_does() {
    let tolerance = document().band.unwrap();
    let drawn = document().motion().unwrap();
    for lang in LANGUAGES {
        let (longer, _) = numbers(&LESSON.words(lang)["regulator.text"], lang)[0];
        let motion = lengthened(longer);
        let percent = |ratio: f64| 100.0 * ratio;
        let expected = [
            longer,
            percent(longer / drawn_fk()),
            tolerance,
            length_deg(&drawn, tolerance),
            length_deg(&motion, tolerance),
            percent(stroke(&motion) / stroke(&drawn) - 1.0),
            shown_fk(),
            shown_fk() - drawn_fk(),
        ];
        LESSON.tells(lang, "regulator.text", &expected);
    }
    // The answer to its question.
    let shown = lengthened(shown_fk() - drawn_fk());
    let answer = length_deg(&shown, tolerance);
    assert!((answer - 121.896).abs() < 0.02, "{answer}");
    let narrow = 0.1 * tolerance;
    let expected = [
        narrow,
        length_deg(&shown, narrow),
        length_deg(&drawn, narrow),
    ];
    for lang in LANGUAGES {
        LESSON.tells(lang, "regulator.right", &expected);
    }
}

/// Links, hinges and pairs, in figures and in words.
#[test]
fn how_many_links_and_pairs() {
    let motion = document().motion().unwrap();
    let mechanism = motion.mechanism();
    let structure = mechanism.structure();
    let [group] = structure.groups().collect::<Vec<_>>()[..] else {
        panic!("one group");
    };
    let (links, pairs) = (group.links().len(), group.inner.len() + group.outer.len());
    let counted = [3.0, links as f64, 2.0, pairs as f64, 0.0];
    assert_eq!(
        (mechanism.links().len(), links, pairs, group.class),
        (7, 6, 9, 4)
    );
    // AB's own hinge is the tenth.
    assert_eq!(pairs + 1, 10);
    let triangles = mechanism.link_ids();
    let triangles = triangles.filter(|link| mechanism.points_of(*link).len() == 3);
    let triangles: Vec<&str> = triangles.map(|link| mechanism.link_name(link)).collect();
    assert_eq!(triangles, ["EGF", "HGL", "CLK"]);
    for (lang, [seven, ten, six, nine]) in [
        ("en", ["seven", "ten", "six", "nine"]),
        ("ru", ["семь", "десять", "шесть", "девять"]),
        ("uk", ["сім", "десять", "шість", "дев’ять"]),
        ("kk", ["жеті", "он ", "алты", "тоғыз"]),
    ] {
        LESSON.tells(lang, "groups.text", &counted);
        LESSON.tells(lang, "groups.right", &[group.order() as f64]);
        let says = |key: &str, word: &str| {
            let text = LESSON.words(lang)[key].to_lowercase();
            assert!(text.contains(word), "{lang} {key}: {text}");
        };
        says("structure.title", seven);
        says("structure.title", ten);
        says("structure.text", seven);
        says("groups.text", six);
        says("groups.text", nine);
        for triangle in &triangles {
            says("structure.text", &triangle.to_lowercase());
        }
    }
}
