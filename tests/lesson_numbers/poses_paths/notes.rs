//! Notes for teachers on poses of a body: the English ones. Those of the other languages have the same numbers.

use assur_file::Guidance;

use super::{LESSON, document, guidance, shown, turns};

/// Numbers of the dyads of the shown pair, from 1.
fn dyads(found: &Guidance) -> [usize; 2] {
    let all = &found.solutions.dyads;
    let number = |dyad| all.iter().position(|one| one == dyad).unwrap() + 1;
    found.shown().unwrap().dyads.each_ref().map(number)
}

/// Number of poses on the branch of the first one.
fn met(found: &Guidance, document: &assur_file::PosesDocument) -> usize {
    let side = |k: usize| {
        let [_, b, c, d] = shown(found, document, k);
        (c - b).perp(&(d - c)) > 0.0
    };
    (0..document.poses.len())
        .filter(|k| side(*k) == side(0))
        .count()
}

#[test]
fn what_the_notes_say_of_the_linkages() {
    let text = LESSON.file("notes.en.md");
    for (number, name) in (1..).zip(["renumbered", "circuit", "five", "branch"]) {
        let (document, found) = (document(name), guidance(name));
        let [one, other] = dyads(&found);
        let row = format!("| linkage {number} | {one} and {other} |");
        let line = text.lines().find(|line| line.starts_with(&row)).unwrap();
        let count = format!("| {}", met(&found, &document));
        assert!(line[row.len()..].contains(&count), "{line}");
    }
    let ours = guidance("ours");
    let list = &ours.solutions;
    for (found, what) in [
        (&ours, "ours, of the\ndyads"),
        (&guidance("task"), "of the dyads"),
    ] {
        let [one, other] = dyads(found);
        assert!(
            text.contains(&format!("{what} {one} and {other}")),
            "{what} {one} {other}"
        );
    }
    let [count, dyads] = [list.linkages.len(), list.dyads.len()];
    assert!(text.contains(&format!("has {count} linkages of {dyads} dyads")));
    let [five, higher] = ["five", "higher"].map(document).map(|one| one.poses[1].y);
    let said = format!("at y = {five} with four real pairs and at y = {higher} with two");
    assert!(text.contains(&said), "{said}");
    // Linkage 1 is linkage 3 with two poses exchanged.
    let turned = |name: &str| turns(&guidance(name), &document(name));
    let [one, mut three] = ["renumbered", "five"].map(turned);
    three.swap(1, 2);
    assert!(one.iter().zip(three).all(|(a, b)| (a - b).abs() < 1e-9));
}
