//! Published URLs and files: each opens, moves if it moves in the program that it is from, and keeps its lengths. If
//! that program moves it wrongly or not at all, the test names the issue.
//!
//! `published/pmks.txt` lists URLs with the places where they were found. The files in `published/linkage2` are the
//! samples that come with Linkage (<https://github.com/rectorsquid/Linkage>, `samplegallery` of its source), without
//! colours and selections; `issue-12.linkage2` is drawn after the description in that issue, whose own file is no
//! longer public. `published/expected.txt` has the expected result for each: `name | W | motion | what was left out`.

use std::collections::BTreeMap;
use std::fs;

use assur::motion::Motion;
use assur_file::LinkageDocument;
use assur_import::{Imported, read};

/// Tolerance of lengths, relative to the size of the drawing.
const WITHIN: f64 = 1e-12;

fn place(name: &str) -> String {
    format!("{}/tests/published/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Returns all published texts by name.
fn published() -> BTreeMap<String, String> {
    let text = fs::read_to_string(place("pmks.txt")).unwrap();
    let links = text.lines().filter(|line| !line.starts_with('#'));
    let links = links.map(|line| {
        let parts: Vec<&str> = line.splitn(3, " | ").collect();
        assert!(parts[1].len() > 5, "{line}: from where?");
        (parts[0].to_owned(), parts[2].to_owned())
    });
    let files = fs::read_dir(place("linkage2")).unwrap();
    let files = files.map(|entry| {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (name, fs::read_to_string(path).unwrap())
    });
    links.chain(files).collect()
}

fn opened(name: &str) -> Imported {
    read(&published()[name]).unwrap()
}

fn motion(name: &str) -> Motion {
    opened(name).document.motion().unwrap()
}

/// Returns inputs over all arcs, including the ends of the arcs.
fn inputs(motion: &Motion, steps: usize) -> impl Iterator<Item = f64> {
    let arcs = motion.cycle().arcs().to_vec().into_iter();
    arcs.flat_map(move |[from, to]| {
        (0..=steps).map(move |k| from + (to - from) * k as f64 / steps as f64)
    })
}

/// Checks at every input that the points of each link keep their drawn distances, and that the equations of all pairs
/// hold. Returns the number of distances.
pub(crate) fn keeps_its_lengths(name: &str, document: &LinkageDocument, motion: &Motion) -> usize {
    let mechanism = motion.mechanism();
    let size = mechanism.size();
    let drawn = |point: &str| {
        let found = document.points.iter().find(|one| one.name == point);
        found.unwrap().at
    };
    let mut pairs = Vec::new();
    for link in &document.links {
        for (k, a) in link.points.iter().enumerate() {
            for b in &link.points[..k] {
                let [[x, y], [u, v]] = [drawn(a), drawn(b)];
                let ends = [a, b].map(|point| mechanism.point(point).unwrap());
                pairs.push((ends, (x - u).hypot(y - v), &link.name));
            }
        }
    }
    for input in inputs(motion, 180) {
        // At the end of an arc links are in line, and only half of the digits are exact.
        let Ok(pose) = motion.pose::<1>(input) else {
            continue;
        };
        for ([a, b], length, link) in &pairs {
            let [a, b] = [a, b].map(|point| mechanism.place(&pose, *point));
            let now = (a.x.value() - b.x.value()).hypot(a.y.value() - b.y.value());
            assert!(
                (now - length).abs() <= WITHIN * size,
                "{name}, {link} at {input}: {now}, not {length}"
            );
        }
        for constraint in &mechanism.constraints() {
            let residual = mechanism.sides(&pose, constraint, 0).residual().abs();
            assert!(
                residual <= 8.0 * WITHIN * size.max(1.0).powi(2),
                "{name} at {input}: {residual}"
            );
        }
    }
    pairs.len()
}

fn told(imported: &Imported) -> String {
    serde_json::to_string(&imported.left_out).unwrap()
}

#[test]
fn what_is_published_opens_and_moves() {
    let expected = fs::read_to_string(place("expected.txt")).unwrap_or_default();
    let mut lengths = 0;
    let mut found = String::new();
    for (name, text) in published() {
        let imported = read(&text).unwrap_or_else(|problem| panic!("{name}: {problem:?}"));
        let document = &imported.document;
        let comes_to = match document.motion() {
            Ok(motion) => {
                lengths += keeps_its_lengths(&name, document, &motion);
                let w = motion.mechanism().counts().mobility;
                assert_eq!(w, document.drivers.len() as isize, "{name}");
                let cycle = motion.cycle();
                let whole = if cycle.is_full() {
                    format!(
                        "{} turns",
                        (cycle.period().unwrap() / std::f64::consts::TAU).round()
                    )
                } else {
                    let ends: Vec<String> = cycle
                        .arcs()
                        .iter()
                        .map(|[a, b]| format!("{a:.6} to {b:.6}"))
                        .collect();
                    ends.join(", ")
                };
                format!("{w} | {whole}")
            }
            Err(problems) => format!("– | {}", serde_json::to_string(&problems).unwrap()),
        };
        found += &format!("{name} | {comes_to} | {}\n", told(&imported));
    }
    for (line, known) in found.lines().zip(expected.lines()) {
        assert_eq!(line, known);
    }
    assert_eq!(found, expected);
    assert!(lengths > 400, "{lengths}");
}

/// PMKS-Web/PMKSWeb, issue 91: the positions of this four-bar were wrong. At the ends of its motion, coupler and rocker
/// are in line.
#[test]
fn issue_91_of_pmks_ends_where_its_links_are_in_line() {
    let motion = motion("issue 91");
    let mechanism = motion.mechanism();
    let at = |name: &str, input: f64| {
        let pose = motion.pose::<1>(input).unwrap();
        let place = mechanism.place(&pose, mechanism.point(name).unwrap());
        [place.x.value(), place.y.value()]
    };
    let far = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let home = motion.drawn_input();
    let [coupler, rocker] = [("B", "C"), ("C", "D")].map(|(a, b)| far(at(a, home), at(b, home)));
    let [[from, to]] = motion.cycle().arcs()[..] else {
        panic!("{:?}", motion.cycle());
    };
    for end in [from, to] {
        let reach = far(at("B", end), at("D", end));
        assert!((reach - (coupler + rocker)).abs() < 1e-9, "{end}: {reach}");
    }
    assert!(to - from > 5.0);
}

/// PMKS-Web/PMKSWeb, issue 92: links of this six-bar grew and shrank.
#[test]
fn issue_92_of_pmks_keeps_its_lengths() {
    let imported = opened("issue 92");
    let motion = imported.document.motion().unwrap();
    assert_eq!(
        keeps_its_lengths("issue 92", &imported.document, &motion),
        9
    );
    let structure = motion.mechanism().formula();
    assert_eq!(structure, "I(frame,AB) → II₂(CBD,CFG) → II₂(DE,FE)");
}

/// PMKS-Web/PMKSWeb, issues 49, 164 and 199: linkages that could not be simulated, with a point listed twice, a weld at
/// a slider, and three joints in a line.
#[test]
fn what_pmks_could_not_simulate_moves() {
    for (name, least) in [("issue 49", 3.3), ("issue 164", 6.2), ("issue 199", 3.6)] {
        let imported = opened(name);
        let motion = imported.document.motion().unwrap();
        keeps_its_lengths(name, &imported.document, &motion);
        let arcs = motion.cycle().arcs().iter();
        let moved: f64 = arcs.map(|[from, to]| to - from).sum();
        assert!(moved > least, "{name}: {moved}");
    }
}

/// rectorsquid/Linkage, issue 12: a link hinged at three unknown points belongs to a group of class III. That program
/// cannot compute it, and the link stretches.
#[test]
fn issue_12_of_linkage_is_a_group_of_class_iii() {
    let imported = opened("issue-12.linkage2");
    let motion = imported.document.motion().unwrap();
    assert_eq!(
        keeps_its_lengths("issue 12", &imported.document, &motion),
        7
    );
    let formula = motion.mechanism().formula();
    assert!(formula.contains("III"), "{formula}");
}

/// Lengths are in the unit that the program shows; 96 units of a file are one inch.
#[test]
fn lengths_of_linkage_are_in_its_unit() {
    let size = |name: &str| opened(name).document.points[1].at;
    let [x, y] = size("chebyshev.linkage2");
    assert_eq!([x, y], [-2.0, 3.0]);
    let [x, y] = size("varying-speed.linkage2");
    let mm = 25.4 / 96.0;
    assert_eq!([x, y], [505.5 * mm, -126.0 * mm]);
}
