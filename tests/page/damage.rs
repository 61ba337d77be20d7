//! Three hundred damaged addresses and three hundred damaged files, from a fixed seed:
//! each is a sentence, and what is on the screen stays as it was. What is damaged and
//! what still is a state is judged by `assur-file`, not by what the page says.

use assur_file::{Document, Problem, State};
use serde_json::{Value, json};

use crate::browser::{Page, setting};
use crate::dice::Dice;

/// What is on the screen. The damaged ones come of another state, so that none taken
/// for sound goes unseen.
const SHOWN: &str = "1&lesson=mixer&d.l1=0.37&d.l2=0.85&d.l3=0.55&d.l4=0.85&d.z4=36&d.z5=18&d.mesh=external&d.module=0.0165&d.centre_line_deg=-40&d.assembly=1&v.phi_deg=75&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";

/// A page opens what is shorter and shallower than this.
const LONGEST: usize = 400_000;
const DEEPEST: usize = 12;

/// Pixels by which two pictures of the same may differ: edges are smoothed from what
/// was drawn before.
const ALIKE: usize = 20;

/// Kinds of damage, and how many of each are made.
const KINDS: usize = 12;
const EACH: usize = 34;

fn sound() -> Value {
    json!({
        "format": 1,
        "lesson": "mixer",
        "document": {
            "l1": 0.37, "l2": 0.85, "l3": 1.0, "l4": 0.85, "z4": 36,
            "wheels": [{ "z": 24, "centre_line_deg": -40 }, { "z": 18, "centre_line_deg": 90 }],
            "mesh": "internal", "module": 0.0165, "assembly": 2,
            "tracers": [{ "link": "coupler", "x": 0.4, "y": 0.2 }],
        },
        "view": {
            "phi_deg": 100.5, "playing": false, "direction": -1, "speed": 2, "traces": false,
            "centres": true, "vectors": false, "loop_vectors": false, "transmission": true,
            "plot": "C2", "axes": "physical", "omega": 2, "omega_unit": "per_min", "epsilon": 0.5,
            "true_time": false, "differenced": true, "step": 0, "lang": "en",
        },
    })
}

/// What nobody means by a value, as JSON.
fn nonsense() -> Vec<String> {
    let mut all: Vec<String> = [
        "null",
        "[]",
        "{}",
        "[[[{}]]]",
        "\"<img src=x onerror='window.hurt=1'>\"",
        "\"<script>window.hurt=1</script>\"",
        "\"javascript:window.hurt=1\"",
        "\"\"",
        "\"NaN\"",
        "\"0.5; window.hurt=1\"",
        "1e300",
        "-1e300",
        "-7",
        "0.3333",
        "1e-320",
        "{\"__proto__\":{\"hurt\":1}}",
        "{\"constructor\":{\"prototype\":{\"hurt\":1}}}",
        "{\"toString\":1,\"valueOf\":1}",
        "{\"length\":1e9}",
    ]
    .map(str::to_owned)
    .to_vec();
    all.push(format!("\"{}\"", "9".repeat(LONGEST + 10)));
    all.push(format!("{}{}", "[".repeat(20), "]".repeat(20)));
    all
}

const KEYS: &[&str] = &[
    "__proto__",
    "constructor",
    "prototype",
    "toString",
    "<img src=x onerror=window.hurt=1>",
    "hasOwnProperty",
    "",
    "\u{202e}l1",
];

const JUNK: &[&str] = &[
    "<", "\"", "'", "%", "%E0%A4%A", "%C0%80", "%u0041", "&", "=", "{", "]", "\\", "\u{0}", "💥",
];

impl Dice {
    /// A part of a text, at least one letter and not all of it.
    fn part(&mut self, text: &str) -> (usize, usize) {
        let starts: Vec<usize> = text.char_indices().map(|(at, _)| at).skip(1).collect();
        let from = self.below(starts.len() - 1);
        let to = (from + 1 + self.below(12)).min(starts.len() - 1);
        (starts[from], starts[to])
    }

    /// Damage that knows nothing of the form.
    fn blind(&mut self, text: &str, kind: usize) -> String {
        let (from, to) = self.part(text);
        let (before, after) = (&text[..from], &text[to..]);
        match kind {
            0 => before.to_owned(),
            1 => format!("{before}{after}"),
            2 => format!("{before}{}{}", self.text(JUNK), &text[from..]),
            3 => format!("{}{before}", &text[from..]),
            _ => format!("{before}{}{after}", text[from..to].to_uppercase()),
        }
    }
}

fn encoded(text: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.,".contains(&byte);
    text.bytes()
        .map(|byte| {
            if plain(byte) {
                (byte as char).to_string()
            } else {
                format!("%{byte:02X}")
            }
        })
        .collect()
}

fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [byte, after @ ..] = rest {
        if *byte == b'%' {
            let digits = std::str::from_utf8(after.get(..2)?).ok()?;
            let hexadecimal = digits.bytes().all(|digit| digit.is_ascii_hexdigit());
            bytes.push(hexadecimal.then(|| u8::from_str_radix(digits, 16))?.ok()?);
            rest = &after[2..];
        } else {
            bytes.push(*byte);
            rest = after;
        }
    }
    String::from_utf8(bytes).ok()
}

/// The pairs of an address; a value is text where it can be read as nothing else.
fn pairs(state: &Value) -> Vec<(String, String)> {
    let text = |value: &Value| match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let mut all = vec![("lesson".to_owned(), text(&state["lesson"]))];
    for (prefix, part) in [("d", "document"), ("v", "view")] {
        let entries = state[part].as_object().unwrap();
        all.extend(
            entries
                .iter()
                .map(|(key, value)| (format!("{prefix}.{key}"), text(value))),
        );
    }
    all
}

fn address(version: &str, pairs: &[(String, String)]) -> String {
    let pairs = pairs
        .iter()
        .map(|(key, value)| format!("{}={}", encoded(key), encoded(value)));
    let all: Vec<String> = [version.to_owned()].into_iter().chain(pairs).collect();
    all.join("&")
}

fn damaged_address(dice: &mut Dice, kind: usize) -> String {
    let mut all = pairs(&sound());
    let at = dice.below(all.len());
    let bad = dice.one(&nonsense()).clone();
    match kind {
        5 => all[at].1 = bad,
        6 => all[at].0 = dice.text(KEYS).to_owned(),
        7 => {
            let start = dice.text(&["d.", "v.", ""]);
            all[at].0 = format!("{start}{}", dice.text(KEYS));
        }
        8 => all.push((all[at].0.clone(), bad)),
        9 => drop(all.remove(at)),
        10 => return address(dice.text(&["0", "2", "", "1.0", "1;", "<b>", "-1"]), &all),
        11 => {
            // Once more, and no other damage: this may still be a state.
            let key = format!("{}{}", dice.text(&["d.", "v.", ""]), dice.text(KEYS));
            all.push((key, dice.text(&["1", "{\"hurt\":1}", "x"]).to_owned()));
            if dice.below(8) > 0 {
                all[at].1.push_str(dice.text(&["!", "<", "e", " 1"]));
            }
        }
        blind => return dice.blind(&address("1", &all), blind),
    }
    address("1", &all)
}

fn damaged_file(dice: &mut Dice, kind: usize) -> String {
    let mut state = sound();
    let part = dice.text(&["document", "view"]);
    let keys: Vec<String> = state[part].as_object().unwrap().keys().cloned().collect();
    let key = dice.one(&keys).clone();
    let bad = dice.one(&nonsense()).clone();
    let text = state.to_string();
    let entry = format!("\"{key}\":{}", state[part][&key]);
    assert!(text.contains(&entry), "{entry}");
    match kind {
        5 => text.replacen(&entry, &format!("\"{key}\":{bad}"), 1),
        6 => text.replacen(&entry, &entry.replace(&key, &encoded(dice.text(KEYS))), 1),
        7 => {
            let whole = ["format", "lesson", "document", "view"];
            state[dice.text(&whole)] = serde_json::from_str(&bad).unwrap();
            state.to_string()
        }
        8 => text.replacen(&entry, &format!("{entry},\"{key}\":{bad}"), 1),
        9 => {
            state[part].as_object_mut().unwrap().remove(&key);
            state.to_string()
        }
        10 => bad,
        11 => {
            let own = dice.text(KEYS);
            state[part][own] = json!({ "hurt": 1 });
            if dice.below(8) > 0 {
                state[part][&key] = json!([own]);
            }
            state.to_string()
        }
        blind => dice.blind(&text, blind),
    }
}

fn depth(value: &Value) -> usize {
    match value {
        Value::Array(all) => 1 + all.iter().map(depth).max().unwrap_or(0),
        Value::Object(all) => 1 + all.values().map(depth).max().unwrap_or(0),
        _ => 0,
    }
}

/// What an address holds, read by the rules of ARCHITECTURE.md; none if nothing.
fn held_by_address(hash: &str) -> Option<Value> {
    let mut pairs = hash.split('&');
    if pairs.next() != Some("1") {
        return None;
    }
    let mut state = json!({ "format": 1, "document": {}, "view": {} });
    for pair in pairs {
        let (key, value) = match pair.split_once('=') {
            None => (decoded(pair)?, Value::Null),
            Some((key, value)) => {
                let text = decoded(value)?;
                let value = serde_json::from_str(&text).unwrap_or(Value::String(text));
                (decoded(key)?, value)
            }
        };
        match key.split_at_checked(2) {
            Some(("d.", rest)) => state["document"][rest] = value,
            Some(("v.", rest)) => state["view"][rest] = value,
            _ if key == "lesson" => state["lesson"] = value,
            _ => (),
        }
    }
    Some(state)
}

/// The state that is held, or what is wrong with it; nothing where none can be made out.
fn judged(held: Option<Value>, length: usize) -> Result<State, Vec<Problem>> {
    let fits = |value: &Value| length <= LONGEST && depth(value) <= DEEPEST;
    let value = held.filter(fits).ok_or_else(Vec::new)?;
    let state = State::read(&value).map_err(|problem| vec![problem])?;
    state.moved()?;
    Ok(state)
}

/// Gives one after the other to the page, as an address or as a file, and tells what
/// came of each.
const GIVE: &str = include_str!("damage.js");

async fn give(page: &Page, kind: &str, inputs: &[String], shown: &str) -> Vec<Value> {
    let picture = async || {
        [
            page.picture("mechanism").await,
            page.picture("charts").await,
        ]
    };
    let before = picture().await;
    let mut answers = Vec::new();
    for some in inputs.chunks(30) {
        let arguments = vec![json!(kind), json!(some), json!(shown)];
        let answer = page.ask_later(GIVE, arguments).await;
        let answer = answer.as_array().unwrap_or_else(|| panic!("{answer}"));
        assert_eq!(answer.len(), some.len());
        answers.extend(answer.iter().cloned());
        page.settle().await;
        let now = picture().await;
        let off = [0, 1].map(|i| now[i].difference(&before[i]));
        assert!(
            off.iter().all(|off| *off < ALIKE),
            "{off:?} after {}",
            answers.len()
        );
    }
    answers
}

/// The controls show the state that was read natively.
fn check_shown(controls: &Value, state: &State, input: &str) {
    let Document::Mixer(document) = &state.document else {
        panic!("{input}");
    };
    for (id, value) in [
        ("field-l1", document.l1),
        ("field-l2", document.l2),
        ("field-l3", document.l3),
        ("field-l4", document.l4),
        ("field-z4", document.z4),
        ("field-z5", document.wheels[0].z),
    ] {
        let text = controls[id].as_str().unwrap();
        let shown: f64 = text.parse().unwrap_or(f64::NAN);
        let off = (shown - value).abs();
        assert!(
            off <= 1e-5 * value.abs(),
            "{id} {text} for {value}: {input}"
        );
    }
    for id in [
        format!("mesh-{}", document.mesh),
        format!("assembly-{}", document.assembly),
    ] {
        assert_eq!(controls[&id], true, "{id}: {input}");
    }
    for (id, checked) in [
        ("traces", state.view.traces),
        ("centres", state.view.centres),
        ("transmission", state.view.transmission),
    ] {
        assert_eq!(controls[id], checked, "{id}: {input}");
    }
}

/// Checks every answer; returns how many inputs were refused.
fn check(
    inputs: &[String],
    answers: &[Value],
    held: impl Fn(&str) -> Option<Value>,
    name: &str,
) -> usize {
    let mut refused = 0;
    for (input, answer) in inputs.iter().zip(answers) {
        let brief: String = input.chars().take(600).collect();
        let brief = format!("{brief}\n{}", answer["said"]);
        let said = answer["said"].as_str().unwrap();
        assert!(answer["hurt"].is_null(), "a script ran: {brief}");
        assert_eq!(answer["clean"], true, "a prototype was changed: {brief}");
        match judged(held(input), input.len()) {
            Ok(state) => {
                assert_eq!(said, "", "it is a state: {brief}");
                assert_eq!(answer["same"], false, "it is a state: {brief}");
                assert_eq!(answer["back"], true, "{brief}");
                check_shown(&answer["controls"], &state, &brief);
            }
            Err(problems) => {
                refused += 1;
                assert_eq!(answer["same"], true, "it is no state: {brief}");
                assert_eq!(answer["injected"], 0, "elements came in: {brief}");
                assert!(said.len() > 40 && !said.contains('{'), "{brief}");
                assert!(said.contains(name), "{brief}");
                // The one value without its form is named by its path.
                if let [Problem::BadState { path, .. }] = &problems[..] {
                    let value = path
                        .split_once('.')
                        .is_some_and(|(part, key)| !part.is_empty() && !key.is_empty());
                    assert!(!value || said.contains(path), "{path}: {brief}");
                }
            }
        }
    }
    refused
}

fn damaged(make: fn(&mut Dice, usize) -> String, sound: &str) -> Vec<String> {
    let mut dice = Dice(0x5eed_a550);
    let all = (0..KINDS * EACH).map(|i| make(&mut dice, i % KINDS));
    all.filter(|input| !input.is_empty() && input != sound)
        .collect()
}

#[tokio::test]
async fn three_hundred_damaged_addresses() {
    let page = Page::open_at(&format!("{}#{SHOWN}", setting("ASSUR_URL")), "en-US").await;
    let whole = address("1", &pairs(&sound()));
    assert!(judged(held_by_address(&whole), whole.len()).is_ok());
    let inputs = damaged(damaged_address, &whole);
    let answers = give(&page, "address", &inputs, SHOWN).await;
    let refused = check(&inputs, &answers, held_by_address, "The link");
    assert!(refused >= 300, "{refused} of {}", inputs.len());
    page.close().await;
}

#[tokio::test]
async fn three_hundred_damaged_files() {
    let page = Page::open_at(&format!("{}#{SHOWN}", setting("ASSUR_URL")), "en-US").await;
    let whole = sound().to_string();
    let held = |text: &str| {
        assur_file::keys_once(text).ok()?;
        serde_json::from_str(text).ok()
    };
    assert!(judged(held(&whole), whole.len()).is_ok());
    let shown = held_by_address(SHOWN).unwrap().to_string();
    let inputs = damaged(damaged_file, &whole);
    let answers = give(&page, "file", &inputs, &shown).await;
    let name = "<img src=x onerror=window.hurt=1>.json";
    let refused = check(&inputs, &answers, held, name);
    assert!(refused >= 300, "{refused} of {}", inputs.len());
    page.close().await;
}
