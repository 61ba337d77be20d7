//! The numbers in the notes for teachers on mobility, computed by the engine.

use assur::mobility::{PairKind, Scheme, Space, Vector3};

use super::{LESSON, by_pairs_of_cuts, document, opened, redundant, scheme};

/// Every number that the notes for teachers have of the paper's figures and in the answers to their tasks.
#[test]
fn the_notes_for_teachers_have_the_numbers_of_the_engine() {
    let notes = LESSON.file("notes.en.md");
    let notes = notes.split_whitespace().collect::<Vec<_>>().join(" ");
    let says = |said: String| assert!(notes.contains(&said), "{said}");
    let signed = |number: isize| number.to_string().replace('-', "−");

    for (figure, name) in [
        ("1а", "mobility-1a"),
        ("1б", "mobility-1b"),
        ("2а", "mobility-2a"),
        ("2в", "mobility-2c"),
        ("3", "mobility-3"),
        ("4", "mobility-4"),
    ] {
        let (document, open) = (document(name), opened(name));
        let cut = document.cut.join(", ");
        let cut = if cut.is_empty() { "–" } else { &cut };
        let plane = document.planar.then(|| open.removed.to_string());
        says(format!(
            "| {figure} | {} | {cut} | {} | {} | {} | {} | {} |",
            scheme(name).counts().links,
            open.open,
            plane.as_deref().unwrap_or("–"),
            open.removed_spatial,
            open.mobility,
            open.redundant,
        ));
    }

    // Task 1.
    for (name, sum) in [
        ("mobility-2c", "3·1 + 3·3 + 1·3"),
        ("mobility-4", "3·2 + 3·2 + 2·2"),
    ] {
        let all = by_pairs_of_cuts(&scheme(name));
        says(format!("{sum} = {}", all.len()));
        assert!(all.iter().all(|mobility| *mobility == 1), "{name}");
        assert_eq!(scheme(name).pairs().len(), 7);
    }
    says(format!("There are {} ways", 7 * 6 / 2));

    // Task 2: the same is said of the tilted axis.
    let tilted = scheme("tilted");
    let mut skew = tilted.spec();
    let tilts = [[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5], [0.6, 0.2]];
    for (pair, [x, y]) in skew.pairs.iter_mut().zip(tilts) {
        pair.axis = Some(Vector3::new(x, y, 1.0));
    }
    for scheme in [tilted, Scheme::new(&skew).unwrap()] {
        let count = signed(scheme.counts().spatial);
        let verdict = scheme.rank_report(Space::Whole).unwrap();
        let by_rank = format!(
            "by rank W = {} and q = {}",
            verdict.mobility,
            redundant(&verdict)
        );
        says(format!("W = 18 − 20 = {count}; {by_rank}"));
        says(format!("W = 3 − 5 = {count}"));
        says(format!("gives q = 0; {by_rank}: the four-bar is locked"));
    }
    let balls = scheme("rssr");
    let verdict = balls.rank_report(Space::Whole).unwrap();
    assert_eq!(
        (verdict.mobility, redundant(&verdict), verdict.idle.len()),
        (2, 0, 1)
    );
    says(format!("W = 18 − 16 = {} by count", balls.counts().spatial));

    // Task 3.
    let layout = scheme("layout");
    let verdict = layout.rank_report(Space::Whole).unwrap();
    let [part] = &verdict.redundancies[..] else {
        panic!("{verdict:?}");
    };
    let carriers: Vec<&str> = part
        .pairs
        .iter()
        .map(|pair| layout.pairs()[*pair].name.as_str())
        .collect();
    assert_eq!(carriers, ["A", "B", "C", "E"]);
    says(format!(
        "The count gives W = {}, the rank W = {}, q = {}.",
        layout.counts().spatial,
        verdict.mobility,
        part.count
    ));
    let mut mended = layout.spec();
    mended.pairs[layout.pair("E").unwrap()].kind = PairKind::Cylindrical;
    let mended = Scheme::new(&mended).unwrap();
    let verdict = mended.rank_report(Space::Whole).unwrap();
    says(format!(
        "the count gives W = {} as well, and q = {}",
        mended.counts().spatial,
        redundant(&verdict)
    ));
    assert_eq!(verdict.mobility as isize, mended.counts().spatial);

    // Task 4.
    let press = scheme("press");
    let counts = press.counts();
    let [n, p] = [counts.links, counts.pairs[&1]];
    says(format!(
        "P₁ = {p}. W = 3·{n} − 2·{p} = {}.",
        counts.planar.unwrap()
    ));
    let spatial = signed(counts.spatial);
    let q = counts.redundant(counts.mobility());
    says(format!(
        "W = 6·{n} − 5·{p} = {spatial} by the count, and q = {q}"
    ));
    assert_eq!(
        redundant(&press.rank_report(Space::Whole).unwrap()) as isize,
        q
    );
}
