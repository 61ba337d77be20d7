//! Counts of what passed and failed, over steps of every kind.

use std::io::{self, BufRead, BufReader, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};

use crate::step::{announce, ending, not_started, spelled};

/// Tests that passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Count {
    passed: u32,
    failed: u32,
}

impl Count {
    fn add(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
    }
}

/// The outcome of one step.
struct Entry {
    name: String,
    count: Count,
    /// The reason of a failure that the count does not show.
    reason: Option<String>,
    took: Duration,
}

/// The outcome of all steps so far.
#[derive(Default)]
pub(crate) struct Tally(Vec<Entry>);

impl Tally {
    /// Runs a step that passes or fails as a whole, counted as one.
    pub(crate) fn check(&mut self, name: &str, step: impl FnOnce() -> Result<()>) {
        let began = Instant::now();
        announce(name, "running");
        self.step(name, &step(), began.elapsed());
    }

    /// Counts a step that has been run.
    pub(crate) fn step(&mut self, name: &str, outcome: &Result<()>, took: Duration) {
        let count = match outcome {
            Ok(()) => Count {
                passed: 1,
                failed: 0,
            },
            Err(_) => Count::default(),
        };
        self.add(name, count, outcome.as_ref().err(), took);
    }

    /// Runs a command that runs tests, each counted.
    pub(crate) fn tests(&mut self, name: &str, command: Result<Command>) {
        let began = Instant::now();
        announce(name, "running");
        let mut count = Count::default();
        let ran = command
            .and_then(|mut command| run_tests(&mut command, name, &mut count, &mut io::stdout()));
        self.add(name, count, ran.as_ref().err(), began.elapsed());
    }

    /// A step that fails without a failed test counts as one failure.
    fn add(
        &mut self,
        name: &str,
        mut count: Count,
        reason: Option<&anyhow::Error>,
        took: Duration,
    ) {
        let reason = reason.map(|error| format!("{error:#}"));
        if let Some(reason) = &reason {
            count.failed = count.failed.max(1);
            announce(name, &format!("FAILED. {reason}"));
        }
        self.0.push(Entry {
            name: name.to_owned(),
            count,
            reason,
            took,
        });
    }

    /// Writes the outcome of every step, then the sum alone on the last line; returns whether nothing failed.
    pub(crate) fn summarise(&self, mut out: impl Write) -> io::Result<bool> {
        let mut sum = Count::default();
        writeln!(out)?;
        for entry in &self.0 {
            let Count { passed, failed } = entry.count;
            sum.add(entry.count);
            let verdict = if failed == 0 { "ok    " } else { "FAILED" };
            let (name, seconds) = (&entry.name, entry.took.as_secs());
            writeln!(
                out,
                "{verdict}  {name}: {passed} passed, {failed} failed ({seconds} s)"
            )?;
            if let Some(reason) = &entry.reason {
                writeln!(out, "        {reason}")?;
            }
        }
        writeln!(out, "\n{} passed, {} failed", sum.passed, sum.failed)?;
        out.flush()?;
        Ok(sum.failed == 0)
    }
}

/// Runs a command that runs tests; its output is passed on while it is counted.
fn run_tests(
    command: &mut Command,
    what: &str,
    count: &mut Count,
    out: &mut impl Write,
) -> Result<()> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| not_started(command, what, error))?;
    let output = child
        .stdout
        .take()
        .context("the output of the step is out of reach")?;
    for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line);
        // A closed terminal is no reason to stop counting.
        let _ = writeln!(out, "{line}");
        count.add(counted(&line));
    }
    let status = child
        .wait()
        .with_context(|| format!("{what} failed: its end is unknown"))?;
    let spelled = spelled(command);
    if !status.success() {
        bail!("`{spelled}` ended with {}", ending(status.code()));
    }
    if count.failed > 0 {
        bail!("`{spelled}` reported failed tests and yet ended well");
    }
    if count.passed == 0 {
        bail!("`{spelled}` ended well but ran no test");
    }
    Ok(())
}

/// The count in a line of a test runner: `test result: ok. 3 passed; 0 failed; …` of cargo and of wasm-bindgen,
/// `ℹ pass 3` and `ℹ fail 0` of Node.
fn counted(line: &str) -> Count {
    let line = anstream::adapter::strip_str(line).to_string();
    let words: Vec<&str> = line.split([' ', ';']).collect();
    let before = |label: &str| {
        let at = words.iter().position(|word| *word == label)?;
        words.get(at.checked_sub(1)?)?.parse().ok()
    };
    match words[..] {
        ["ℹ", "pass", number] => Count {
            passed: number.parse().unwrap_or(0),
            failed: 0,
        },
        ["ℹ", "fail", number] => Count {
            passed: 0,
            failed: number.parse().unwrap_or(0),
        },
        _ if line.contains("test result: ") => Count {
            passed: before("passed").unwrap_or(0),
            failed: before("failed").unwrap_or(0),
        },
        _ => Count::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_of_the_runners_are_read() {
        for (line, passed, failed) in [
            (
                "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; finished in 0.1s",
                12,
                0,
            ),
            (
                "test result: FAILED. 1 passed; 2 failed; 0 ignored; finished in 0.00s",
                1,
                2,
            ),
            (
                "test result: \u{1b}[32mok\u{1b}[m. 3 passed; 0 failed",
                3,
                0,
            ),
            ("ℹ pass 17", 17, 0),
            ("\u{1b}[34mℹ fail 2\u{1b}[39m", 0, 2),
            ("test tests::result ... ok", 0, 0),
            ("test result: who knows", 0, 0),
            ("running 3 tests", 0, 0),
        ] {
            assert_eq!(counted(line), Count { passed, failed }, "{line}");
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
        for (script, passed, failed, reason) in [
            ("console.log('ℹ pass 7')", 7, 0, ""),
            (
                "console.log('ℹ pass 7'); process.exit(3)",
                7,
                0,
                "exit code 3",
            ),
            (
                "console.log('ℹ fail 2'); process.exit(1)",
                0,
                2,
                "exit code 1",
            ),
            ("console.log('ℹ fail 2')", 0, 2, "yet ended well"),
            ("", 0, 0, "ran no test"),
        ] {
            let mut node = Command::new("node");
            node.args(["-e", script]);
            let mut count = Count::default();
            let ran = run_tests(&mut node, "step", &mut count, &mut io::sink());
            assert_eq!(count, Count { passed, failed }, "{script}");
            let given = ran.err().map_or(String::new(), |error| error.to_string());
            assert!(given.contains(reason), "{script}: {given}");
            assert_eq!(given.is_empty(), reason.is_empty(), "{script}: {given}");
        }
    }
}
