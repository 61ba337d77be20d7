//! Damage to texts, the same in every run, and a trial of readers with damaged texts.

use std::fmt::Debug;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::seed;

/// The longest time for one text, far above what any has taken: a reader that takes longer has hung.
const MAX_TIME: Duration = Duration::from_secs(60);

/// A small generator (D. H. Lehmer, 1951), so that every run damages alike.
#[derive(Debug)]
pub struct Dice(u64);

impl Dice {
    /// A generator that begins with a seed.
    pub fn new(seed: u64) -> Self {
        Self(12_345 + seed % 1_000_000)
    }

    /// A whole number from 0 to below `most`.
    pub fn below(&mut self, most: usize) -> usize {
        self.0 = self.0 * 48_271 % 0x7FFF_FFFF;
        self.0 as usize % most
    }
}

/// A text with some of its characters changed.
pub fn with_other_letters(text: &str, changes: usize, dice: &mut Dice) -> String {
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
///
/// # Panics
/// Never: a number of JSON is a number.
pub fn with_other_value(value: &mut Value, dice: &mut Dice) {
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

/// A link of PMKS+ with the check character that fits.
pub fn checked(link: &str) -> String {
    let (host, query) = link.split_once('?').unwrap_or(("", link));
    let mut cut: Vec<char> = query.chars().collect();
    cut.pop();
    let digits = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let check = char::from(digits[cut.len() % 62]);
    let query: String = cut.into_iter().collect();
    format!("{host}?{query}{check}")
}

/// What one change, or now and then two or three, make of a text: of characters, or of values where the text is JSON.
pub fn damaged(text: &str, dice: &mut Dice) -> String {
    let changes = [1, 1, 1, 2, 3][dice.below(5)];
    match serde_json::from_str::<Value>(text) {
        Ok(mut value) if dice.below(4) > 0 => {
            (0..changes).for_each(|_| with_other_value(&mut value, dice));
            value.to_string()
        }
        _ => with_other_letters(text, changes, dice),
    }
}

/// What a reader makes of an input, on a thread of its own.
///
/// # Panics
/// Where it panics or hangs; the input is printed.
pub fn outcome<I, T>(input: I, reader: fn(I) -> T) -> T
where
    I: Clone + Debug + Send + 'static,
    T: Send + 'static,
{
    let (send, receive) = mpsc::channel();
    let given = input.clone();
    thread::spawn(move || send.send(reader(given)));
    match receive.recv_timeout(MAX_TIME) {
        Ok(made) => made,
        Err(why) => panic!("ASSUR_SEED={}: {why} over {input:?}", seed()),
    }
}

/// Whether two values are the same but for the last digits of their numbers: `serde_json` does not read every number of
/// 17 digits to the last one.
fn same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => {
            let [one, other] = [one, other].map(|number| number.as_f64().unwrap_or(f64::NAN));
            one == other || (one - other).abs() <= 4.0 * f64::EPSILON * one.abs()
        }
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| same(one, other))
        }
        (Value::Object(one), Value::Object(other)) => {
            let found = |(key, value): (&String, &Value)| {
                other.get(key).is_some_and(|other| same(value, other))
            };
            one.len() == other.len() && one.iter().all(found)
        }
        _ => one == other,
    }
}

/// Gives damaged texts to a reader, which returns what it accepts as JSON: read again, that is the same. Returns how many
/// were accepted.
///
/// # Panics
/// Where a reader panics or hangs, or what was accepted changes by being written and read again.
pub fn fuzz(
    corpus: &[String],
    count: usize,
    damage: fn(&str, &mut Dice) -> String,
    reader: fn(String) -> Option<String>,
) -> usize {
    let mut dice = Dice::new(seed());
    let mut accepted = 0;
    for _ in 0..count {
        let text = damage(&corpus[dice.below(corpus.len())], &mut dice);
        let Some(written) = outcome(text.clone(), reader) else {
            continue;
        };
        accepted += 1;
        let again = outcome(written.clone(), reader);
        let value = |text: &String| serde_json::from_str::<Value>(text).unwrap();
        assert!(
            again
                .as_ref()
                .is_some_and(|again| same(&value(again), &value(&written))),
            "ASSUR_SEED={}: {text}\nis written as {written}\nand again as {again:?}",
            seed()
        );
    }
    println!("{accepted} of {count} are accepted");
    accepted
}
