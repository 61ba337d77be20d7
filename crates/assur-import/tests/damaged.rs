//! Damaged links and files: a problem, or a document that is sound and moves; no panic.

mod named;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use allocation_counter::measure;
use assur::Swing;
use assur::mechanism::Defect;
use assur::motion::{Column, Grid, OutputProfile};
use assur_file::{LinkageDocument, LinkageProblem, Problem, from_text};
use assur_import::{ImportProblem, Imported, read, recognised};
use assur_tests::files::root;
use assur_tests::{scaled, seed};
use serde_json::{Value, json};

/// Maximum number of live bytes while a text is read and moved, and its table and summary are made.
const ROOM: u64 = 64 << 20;
/// Rows of a table.
const ROWS: f64 = 72.0;

/// A small generator (D. H. Lehmer, 1951), so that every run damages alike.
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: usize) -> usize {
        self.0 = self.0 * 48_271 % 0x7FFF_FFFF;
        self.0 as usize % most
    }
}

fn files(folder: &str) -> Vec<String> {
    let files = fs::read_dir(root().join(folder)).unwrap();
    let mut files: Vec<_> = files.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let texts = files.into_iter().map(fs::read_to_string);
    texts.map(Result::unwrap).collect()
}

/// Links and files of other programs.
fn published() -> Vec<String> {
    let text = include_str!("published/pmks.txt");
    let links = text.lines().filter_map(|line| line.splitn(3, " | ").nth(2));
    let files = files("crates/assur-import/tests/published/linkage2");
    links.map(str::to_owned).chain(files).collect()
}

/// Files of our own.
fn saved() -> Vec<String> {
    let folders = [
        "crates/assur-file/catalogue",
        "tests/data/linkages",
        "tests/data/drawings",
    ];
    let texts = folders.into_iter().flat_map(files);
    texts.filter(|text| from_text(text).is_ok()).collect()
}

/// What an imported document must be, whatever the text: no wrong names, no number that is none.
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

/// Whether a document moves; then all numbers of its table and of its summary are finite.
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

/// Damaged texts, counted.
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
    /// Opens a text and moves what is in it.
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

/// A text with some of its characters changed.
fn with_other_letters(text: &str, changes: usize, dice: &mut Dice) -> String {
    const LETTERS: &str = "0123456789AZaz_-.,|\"<>/=%&?é\u{0}\n true";
    let letters: Vec<char> = LETTERS.chars().collect();
    let mut worse: Vec<char> = text.chars().collect();
    for _ in 0..changes {
        let at = dice.below(worse.len());
        let letter = letters[dice.below(letters.len())];
        match dice.below(5) {
            0 => worse.truncate(at.max(1)),
            1 => drop(worse.remove(at)),
            2 => worse.insert(at, letter),
            3 => worse[at] = letter,
            // A piece of it once more, somewhere else.
            _ => {
                let end = (at + 1 + dice.below(60)).min(worse.len());
                let piece: Vec<char> = worse[at..end].to_vec();
                let to = dice.below(worse.len());
                worse.splice(to..to, piece);
            }
        }
        if worse.is_empty() {
            worse.push('<');
        }
    }
    worse.into_iter().collect()
}

/// Another value somewhere in a document, mostly one of its kind.
fn with_other_value(value: &mut Value, dice: &mut Dice) {
    let is_alike = dice.below(16) > 0;
    match value {
        Value::Object(fields) if is_alike && !fields.is_empty() => {
            let at = dice.below(fields.len());
            let field = fields.values_mut().nth(at);
            with_other_value(field.unwrap(), dice);
        }
        Value::Array(all) if is_alike && !all.is_empty() => {
            let at = dice.below(all.len());
            match dice.below(8) {
                0 => drop(all.remove(at)),
                1 => all.push(all[at].clone()),
                _ => with_other_value(&mut all[at], dice),
            }
        }
        Value::Number(number) if is_alike => {
            const NUMBERS: [f64; 10] = [-1.0, 0.0, 1.0, 7.0, 1e-320, 1e-9, -1e-3, 1e3, 1e9, 1e300];
            let scaled = number.as_f64().unwrap() * dice.below(2001) as f64 / 1000.0;
            let other = NUMBERS[dice.below(NUMBERS.len())];
            *value = json!(if dice.below(2) == 0 { scaled } else { other });
        }
        Value::String(name) if is_alike => {
            const NAMES: [&str; 8] = ["A", "B", "C", "D", "crank", "coupler", "rocker", "frame"];
            *name = NAMES[dice.below(NAMES.len())].to_owned();
        }
        _ => {
            let others = [
                json!(null),
                json!([]),
                json!({}),
                json!(true),
                json!("9".repeat(1000)),
                json!([0, 1]),
            ];
            *value = others[dice.below(others.len())].clone();
        }
    }
}

#[test]
fn thousands_of_damaged_texts_are_refused_or_sound() {
    let mut dice = Dice(12_345 + seed() % 1_000_000);
    let mut seen = Seen::default();
    for text in published() {
        for k in 0..scaled(40) {
            let mut worse = with_other_letters(&text, 1 + k % 3, &mut dice);
            // Else the check character would find nearly all of them.
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

/// A link with the check character that fits.
pub(crate) fn checked(link: &str) -> String {
    let (host, query) = link.split_once('?').unwrap_or(("", link));
    let mut cut: Vec<char> = query.chars().collect();
    cut.pop();
    let digits = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let check = char::from(digits[cut.len() % 62]);
    let query: String = cut.into_iter().collect();
    format!("{host}?{query}{check}")
}
