//! Counts of passed and failed checks, over steps of every kind.

use std::io::{self, BufRead, BufReader, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use xshell::Cmd;

use crate::step::announce;

/// The outcome of one step.
struct Entry {
    name: String,
    passed: u32,
    failed: u32,
    /// Error of the step if it failed; none if it passed.
    reason: Option<String>,
    took: Duration,
}

/// The outcome of all steps so far.
#[derive(Default)]
pub(crate) struct Tally(Vec<Entry>);

impl Tally {
    /// Runs a step that passes or fails as a whole, and counts it as one check.
    pub(crate) fn check(&mut self, name: &str, step: impl FnOnce() -> Result<()>) {
        let began = Instant::now();
        announce(name, "running");
        self.step(name, &step(), began.elapsed());
    }

    /// Counts a step that has already run as one check.
    pub(crate) fn step(&mut self, name: &str, outcome: &Result<()>, took: Duration) {
        self.add(name, [u32::from(outcome.is_ok()), 0], outcome, took);
    }

    /// Runs a command that runs tests, and counts each test.
    pub(crate) fn tests(&mut self, name: &str, command: Result<Cmd>) {
        let began = Instant::now();
        announce(name, "running");
        let mut count = [0; 2];
        let ran = command.and_then(|command| run_tests(command, &mut count, io::stdout()));
        self.add(name, count, &ran, began.elapsed());
    }

    /// Adds an entry; a step that fails without a failed test counts as one failure.
    fn add(&mut self, name: &str, count: [u32; 2], outcome: &Result<()>, took: Duration) {
        let [passed, mut failed] = count;
        let reason = outcome.as_ref().err().map(|error| format!("{error:#}"));
        if let Some(reason) = &reason {
            failed = failed.max(1);
            announce(name, &format!("FAILED. {reason}"));
        }
        let name = name.to_owned();
        self.0.push(Entry {
            name,
            passed,
            failed,
            reason,
            took,
        });
    }

    /// Writes the outcome of every step, then the total on the last line; returns true if nothing failed.
    pub(crate) fn summarise(&self, mut out: impl Write) -> io::Result<bool> {
        writeln!(out)?;
        let [mut passed, mut failed] = [0; 2];
        for entry in &self.0 {
            let verdict = if entry.failed == 0 {
                "ok    "
            } else {
                "FAILED"
            };
            let counts = format!("{} passed, {} failed", entry.passed, entry.failed);
            writeln!(
                out,
                "{verdict}  {}: {counts} ({} s)",
                entry.name,
                entry.took.as_secs()
            )?;
            if let Some(reason) = &entry.reason {
                writeln!(out, "        {reason}")?;
            }
            passed += entry.passed;
            failed += entry.failed;
        }
        writeln!(out, "\n{passed} passed, {failed} failed")?;
        out.flush()?;
        Ok(failed == 0)
    }
}

/// Runs a command that runs tests; passes on its output while counting passed and failed tests.
fn run_tests(command: Cmd, count: &mut [u32; 2], mut out: impl Write) -> Result<()> {
    let mut command = Command::from(command);
    let child = command.stdout(Stdio::piped()).spawn();
    let mut child = child.context("it cannot be started")?;
    let output = child.stdout.take().context("no output")?;
    for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line);
        // Counting goes on even if the output cannot be written, as to a closed terminal.
        let _ = writeln!(out, "{line}");
        for (sum, more) in count.iter_mut().zip(counted(&line)) {
            *sum += more;
        }
    }
    let status = child.wait().context("its end is unknown")?;
    match *count {
        _ if !status.success() => bail!("it ended with {status}"),
        [_, failed] if failed > 0 => bail!("it reported failed tests and yet ended well"),
        [0, _] => bail!("it ended well but ran no test"),
        _ => Ok(()),
    }
}

/// Passed and failed tests in a line of a test runner: `test result: ok. 3 passed; 0 failed; …` of cargo and of
/// wasm-bindgen, `ℹ pass 3` and `ℹ fail 0` of Node.
fn counted(line: &str) -> [u32; 2] {
    let line = anstream::adapter::strip_str(line).to_string();
    let words = line.split_whitespace();
    let words: Vec<&str> = words.map(|word| word.trim_end_matches(';')).collect();
    let number = |word: &str| word.parse().unwrap_or(0);
    match words[..] {
        ["ℹ", "pass", passed] => [number(passed), 0],
        ["ℹ", "fail", failed] => [0, number(failed)],
        ["test", "result:", _, passed, "passed", failed, "failed", ..] => {
            [number(passed), number(failed)]
        }
        _ => [0; 2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use xshell::{Shell, cmd};

    #[test]
    fn results_of_the_runners_are_read() {
        for (count, line) in [
            (
                [12, 0],
                "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; finished in 0.1s",
            ),
            (
                [1, 2],
                "test result: FAILED. 1 passed; 2 failed; 0 ignored; finished in 0.00s",
            ),
            (
                [3, 0],
                "test result: \u{1b}[32mok\u{1b}[m. 3 passed; 0 failed",
            ),
            ([17, 0], "ℹ pass 17"),
            ([0, 2], "\u{1b}[34mℹ fail 2\u{1b}[39m"),
            ([0, 0], "test tests::result ... ok"),
            ([0, 0], "test result: who knows"),
            ([0, 0], "running 3 tests"),
        ] {
            assert_eq!(counted(line), count, "{line}");
        }
    }

    #[test]
    fn the_sum_is_alone_on_the_last_line() {
        let mut tally = Tally::default();
        tally.check("format", || Ok(()));
        tally.check("lint", || bail!("a warning"));
        let mut out = Vec::new();
        assert!(!tally.summarise(&mut out).unwrap());
        let out = String::from_utf8(out).unwrap();
        assert_eq!(out.lines().last(), Some("1 passed, 1 failed"), "{out}");
        assert!(
            out.contains("FAILED  lint: 0 passed, 1 failed (0 s)\n        a warning\n"),
            "{out}"
        );
    }

    #[test]
    fn a_step_that_ends_otherwise_than_by_its_tests_fails() {
        let shell = Shell::new().unwrap();
        for (expected, reason, script) in [
            ([7, 0], "", "console.log('ℹ pass 7')"),
            ([7, 0], "status: 3", "console.log('ℹ pass 7'); exit(3)"),
            ([0, 2], "status: 1", "console.log('ℹ fail 2'); exit(1)"),
            ([0, 2], "yet ended well", "console.log('ℹ fail 2')"),
            ([0, 0], "ran no test", ""),
        ] {
            let script = format!("const {{ exit }} = process; {script}");
            let mut count = [0; 2];
            let ran = run_tests(cmd!(shell, "node -e {script}"), &mut count, io::sink());
            assert_eq!(count, expected, "{script}");
            let given = ran.err().map_or(String::new(), |error| error.to_string());
            assert!(given.contains(reason), "{script}: {given}");
            assert_eq!(given.is_empty(), reason.is_empty(), "{script}: {given}");
        }
    }
}
