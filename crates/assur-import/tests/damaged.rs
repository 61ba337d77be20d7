//! Damaged URLs and files: each yields a problem, or a valid document whose motion is finite. None causes a panic.

mod named;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use allocation_counter::measure;
use assur::Swing;
use assur::mechanism::Defect;
use assur::motion::{Column, Grid, OutputProfile};
use assur_file::{LinkageDocument, LinkageProblem, Problem, from_text};
use assur_import::{ImportProblem, Imported, read, recognised};
use assur_tests::damage::{Dice, checked, with_other_letters, with_other_value};
use assur_tests::files::texts;
use assur_tests::{scaled, seed};
use serde_json::Value;

/// Maximum number of live bytes while a text is read and moved, and its table and summary are made.
const ROOM: u64 = 64 << 20;
/// Number of rows of a table.
const ROWS: f64 = 72.0;

/// Returns the URLs and files of other programs.
fn published() -> Vec<String> {
    let text = include_str!("published/pmks.txt");
    let links = text.lines().filter_map(|line| line.splitn(3, " | ").nth(2));
    let files = texts("crates/assur-import/tests/published/linkage2");
    links.map(str::to_owned).chain(files).collect()
}

/// Returns files of Assur.
fn saved() -> Vec<String> {
    let folders = [
        "crates/assur-file/catalogue",
        "tests/data/linkages",
        "tests/data/drawings",
    ];
    let all = folders.into_iter().flat_map(texts);
    all.filter(|text| from_text(text).is_ok()).collect()
}

/// Checks an imported document: its names are valid and its numbers are finite.
fn sound(Imported { document, .. }: &Imported) {
    let places = document.points.iter().flat_map(|point| point.at);
    assert!(places.into_iter().all(f64::is_finite));
    let ranges = document.drivers.iter().filter_map(|driver| driver.range);
    assert!(ranges.flatten().all(f64::is_finite));
    let rates = document.drivers.iter().filter_map(|driver| driver.rate);
    assert!(rates.into_iter().all(f64::is_finite));
    let teeth = document.gears.iter().flat_map(|gear| gear.teeth);
    assert!(teeth.into_iter().all(f64::is_finite));
    let problems = document.mechanism().err().unwrap_or_default();
    for problem in problems {
        let ours = matches!(
            problem,
            Problem::Linkage(
                LinkageProblem::BadName { .. }
                    | LinkageProblem::BadText { .. }
                    | LinkageProblem::Defect(
                        Defect::Twice { .. }
                            | Defect::UnknownName { .. }
                            | Defect::Bare { .. }
                            | Defect::Repeated { .. }
                            | Defect::NotOnLink { .. }
                    )
                    | LinkageProblem::BadDriver { .. }
                    | LinkageProblem::NothingToTrace { .. }
            )
        );
        assert!(!ours, "{problem:?}");
    }
}

/// Returns whether a document moves. If so, checks that all numbers of its table and summary are finite.
fn moves(document: &LinkageDocument) -> bool {
    let Ok(motion) = document.motion() else {
        return false;
    };
    let mechanism = motion.mechanism();
    let finite = |value: f64, what: &str| assert!(value.is_finite(), "{what}: {value}");
    let [from, to] = motion.cycle().axis();
    finite(motion.drawn_input(), "home");
    finite(motion.singularity_margin(), "margin");
    let grid = Grid {
        unit: 1.0,
        origin: from,
        step: (to - from) / ROWS,
    };
    let columns: Vec<Column> = Column::all(mechanism)
        .into_iter()
        .chain(Column::transmitting(mechanism))
        .collect();
    for at in motion.rows(grid) {
        let row = motion.row(&columns, at.input);
        assert!(row.reason.is_some() || row.values.iter().all(Option::is_some));
        for (column, value) in columns.iter().zip(row.values) {
            finite(value.unwrap_or(0.0), &column.name(mechanism));
        }
    }
    for worst in motion.transmissions().iter().filter_map(|one| one.worst) {
        finite(worst.angle, "transmission");
    }
    for quantity in document.outputs(mechanism) {
        let Ok(profile) = OutputProfile::new(&motion, quantity) else {
            continue;
        };
        for swing in profile.swings() {
            if let Swing::Between { min, max } = swing {
                finite(min, "swing");
                finite(max, "swing");
            }
        }
        let travels = profile.travels().into_iter();
        travels.for_each(|travel| finite(travel, "travel"));
        let ratio = profile.time_ratio().into_iter();
        ratio.for_each(|ratio| finite(ratio, "time ratio"));
    }
    true
}

/// Counts of damaged texts.
#[derive(Default)]
struct Seen {
    texts: usize,
    opened: usize,
    moved: usize,
    /// Texts with a panic, a number that is not finite, or too many bytes.
    failed: Vec<String>,
    longest: Duration,
    most_bytes: u64,
}

impl Seen {
    /// Reads a text and moves the mechanism in it.
    fn see(&mut self, text: &str) {
        let mut found = Ok(None);
        let began = Instant::now();
        let room = measure(|| {
            found = catch_unwind(AssertUnwindSafe(|| {
                let document = if recognised(text) {
                    let imported = read(text).ok()?;
                    sound(&imported);
                    imported.document
                } else {
                    from_text(text).ok()?
                };
                Some(moves(&document))
            }));
        });
        self.longest = self.longest.max(began.elapsed());
        self.most_bytes = self.most_bytes.max(room.bytes_max);
        self.texts += 1;
        self.opened += usize::from(matches!(found, Ok(Some(_))));
        self.moved += usize::from(matches!(found, Ok(Some(true))));
        if found.is_err() || room.bytes_max > ROOM {
            let bytes = room.bytes_max;
            self.failed.push(format!("{bytes} bytes: {text}"));
        }
    }
}

#[test]
fn thousands_of_damaged_texts_are_refused_or_sound() {
    let mut dice = Dice::new(seed());
    let mut seen = Seen::default();
    for text in published() {
        for k in 0..scaled(40) {
            let mut worse = with_other_letters(&text, 1 + k % 3, &mut dice);
            // Without a correct check character, nearly all damaged texts would be refused at once.
            if k % 2 == 0 && !worse.contains("j=") && !worse.contains('<') {
                worse = checked(&worse);
            }
            seen.see(&worse);
        }
    }
    for text in saved() {
        let whole: Value = serde_json::from_str(&text).unwrap();
        for k in 0..scaled(16) {
            let worse = if k % 8 == 0 {
                with_other_letters(&text, 1 + k % 3, &mut dice)
            } else {
                let mut worse = whole.clone();
                (0..=k % 3).for_each(|_| with_other_value(&mut worse, &mut dice));
                worse.to_string()
            };
            seen.see(&worse);
        }
    }
    let Seen {
        texts,
        opened,
        moved,
        failed,
        ..
    } = &seen;
    println!(
        "{texts} damaged texts, {opened} open, {moved} move; one takes at most {:?} and {} bytes",
        seen.longest, seen.most_bytes
    );
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(
        *texts > scaled(4000) && *opened > scaled(800) && *moved > scaled(300),
        "{moved} of {opened} of {texts}"
    );
}
