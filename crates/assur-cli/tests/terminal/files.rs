//! Reading and writing: text with a byte-order mark, repeated keys, pipes and devices, and the messages about files.

use std::io::{Read, Write};
use std::process::{Command, Stdio};

use super::run::{Scratch, data, refused, said};

const SLIDE: &str = include_str!("../../../../tests/data/linkages/slide.json");

#[test]
fn a_byte_order_mark_is_passed_over() {
    let file = Scratch::with("mark.json", &format!("\u{feff}{SLIDE}"));
    let plain = data("linkages/slide.json");
    assert_eq!(said(&["sweep", file.path()]), said(&["sweep", &plain]));
}

/// A parser would silently take the last of two equal keys and drop the first.
#[test]
fn keys_that_stand_twice_are_refused() {
    for (once, twice, path) in [
        ("\"frame\":", "\"frame\": [\"A\"], \"frame\":", "frame"),
        ("\"at\":", "\"at\": [0, 0], \"at\":", "points[0].at"),
    ] {
        let text = SLIDE.replacen(once, twice, 1);
        assert_ne!(text, SLIDE);
        let file = Scratch::with("twice.json", &text);
        let (status, said) = refused(&["structure", file.path()]);
        assert_eq!(status, 2, "{said}");
        assert!(
            said.ends_with(&format!(": The key {path} is given twice.\n")),
            "{said}"
        );
    }
}

#[test]
fn sentences_speak_of_files() {
    for (text, part) in [
        (
            "{\"a\": 1,}",
            ": This is not JSON: trailing comma at line 1 column 9.",
        ),
        (
            "",
            ": This is not JSON: EOF while parsing a value at line 1 column 0.",
        ),
        ("[1, 2]", ": The file has the wrong form: "),
        (
            "null",
            ": The file has the wrong form: null, expected an object.",
        ),
        ("{}", ": The file has the wrong form: missing key `points`."),
        (
            "{\"points\": [], \"frame\": [], \"links\": [], \"drivers\": [7]}",
            ": drivers[0] has the wrong form: integer `7`, expected an object.",
        ),
        (
            "{\"format\": 4}",
            ": There is no format 4; 1 and 2 can be read.",
        ),
    ] {
        let file = Scratch::with("sentence.json", text);
        let (status, said) = refused(&["sweep", file.path()]);
        assert_eq!(status, 2, "{said}");
        assert!(said.contains(part), "{text}: {said}");
        for word in ["settings", "struct", "?"] {
            assert!(!said.contains(word), "{said}");
        }
    }
}

/// If the reader of a pipe closes it early, this is no failure.
#[test]
fn closed_output_is_silent() {
    let mut running = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["sweep", "mixer-a", "--step", "0.01"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 100];
    let mut out = running.stdout.take().unwrap();
    out.read_exact(&mut first).unwrap();
    drop(out);
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}

/// A pipe is read like a file. From a pipe or device no more bytes are read than a file may have.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_bounded() {
    let piped = |command: &str, text: &[u8]| {
        let mut running = Command::new(env!("CARGO_BIN_EXE_assur"))
            .args([command, "/dev/stdin"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let written = running.stdin.take().unwrap().write_all(text);
        (written, running.wait_with_output().unwrap())
    };
    for command in ["structure", "mobility"] {
        let (written, output) = piped(command, SLIDE.as_bytes());
        written.unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(
            String::from_utf8(output.stdout).unwrap(),
            said(&[command, &data("linkages/slide.json")])
        );
    }
    // The program exits before all bytes are written.
    let (written, output) = piped("structure", &vec![b' '; 8 << 20]);
    assert!(written.is_err());
    assert_eq!(output.status.code(), Some(2));
    let (status, said) = refused(&["structure", "/dev/zero"]);
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("/dev/zero: too large to be a mechanism"),
        "{said}"
    );
}
