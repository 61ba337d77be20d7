//! Counting what passed and failed, over steps of every kind.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};

use crate::step::{announce, ending, not_started, spelled};

/// How long the output of a step may stay open after its end, held by something it left behind.
const LINGER: Duration = Duration::from_secs(5);

/// Tests that passed and failed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) passed: u32,
    pub(crate) failed: u32,
}

/// What a runner of tests reports in a line.
#[derive(Debug, PartialEq, Eq)]
enum Report {
    Sum(Count),
    Failed(String),
}

/// What came of one step.
struct Entry {
    name: String,
    count: Count,
    /// The tests that failed in company and passed alone.
    late: Vec<String>,
    /// Why it failed, when that is not plain from the count.
    reason: Option<String>,
    took: Duration,
}

/// What came of all the steps so far.
#[derive(Default)]
pub(crate) struct Tally(Vec<Entry>);

impl Tally {
    /// A step that passes or fails as a whole, counted as one.
    pub(crate) fn check(&mut self, name: &str, step: impl FnOnce() -> Result<()>) {
        let began = Instant::now();
        announce(name, "running");
        let reason = step().err().map(|error| format!("{error:#}"));
        self.add(name, Count::default(), reason, began.elapsed());
    }

    /// A step that runs tests, each counted.
    pub(crate) fn tests(&mut self, name: &str, command: Result<Command>) {
        let began = Instant::now();
        announce(name, "running");
        let mut count = Count::default();
        let reason = command
            .and_then(|mut command| run_tests(&mut command, name, &mut count, &mut Vec::new()))
            .err()
            .map(|error| format!("{error:#}"));
        self.add(name, count, reason, began.elapsed());
    }

    /// The same for tests that drive a browser as a person would: where the machine is busy one may come too late.
    /// Those that fail are run once more, each alone, and what passes then is told by name. What is added to the
    /// command must go to the tests.
    pub(crate) fn tests_in_company(&mut self, name: &str, command: Result<Command>) {
        let began = Instant::now();
        announce(name, "running");
        let mut count = Count::default();
        let mut failed = Vec::new();
        let mut late = Vec::new();
        let ran = command.and_then(|mut command| {
            let ran = run_tests(&mut command, name, &mut count, &mut failed);
            // What ended otherwise than by failed tests is no matter of time.
            if ran.is_ok() || failed.is_empty() || failed.len() != count.failed as usize {
                return ran;
            }
            announce(
                name,
                &format!("once more, each alone: {}", failed.join(", ")),
            );
            command
                .args(["--test-threads", "1", "--exact"])
                .args(&failed);
            let mut again = Count::default();
            let mut still = Vec::new();
            let ran = run_tests(&mut command, name, &mut again, &mut still);
            late = failed
                .iter()
                .filter(|test| !still.contains(test))
                .cloned()
                .collect();
            (count.passed, count.failed) = (count.passed + again.passed, again.failed);
            ran
        });
        let reason = ran.err().map(|error| format!("{error:#}"));
        self.add(name, count, reason, began.elapsed());
        if let Some(entry) = self.0.last_mut() {
            entry.late = late;
        }
    }

    /// Every step counts: one that fails without a failed test as one failure, one that passes
    /// without tests as one pass.
    fn add(&mut self, name: &str, mut count: Count, reason: Option<String>, took: Duration) {
        if reason.is_some() {
            count.failed = count.failed.max(1);
        } else if count.passed + count.failed == 0 {
            count.passed = 1;
        }
        if let Some(reason) = &reason {
            announce(name, &format!("FAILED. {reason}"));
        }
        self.0.push(Entry {
            name: name.to_owned(),
            count,
            late: Vec::new(),
            reason,
            took,
        });
    }

    fn sum(&self) -> Count {
        self.0.iter().fold(Count::default(), |sum, entry| Count {
            passed: sum.passed + entry.count.passed,
            failed: sum.failed + entry.count.failed,
        })
    }

    /// The outcome of every step, then the sum alone on the last line; true if nothing failed.
    pub(crate) fn summarise(&self, mut out: impl Write) -> io::Result<bool> {
        writeln!(out)?;
        for Entry {
            name,
            count,
            late,
            reason,
            took,
        } in &self.0
        {
            let verdict = if count.failed == 0 {
                "ok    "
            } else {
                "FAILED"
            };
            let Count { passed, failed } = count;
            let seconds = took.as_secs();
            writeln!(
                out,
                "{verdict}  {name}: {passed} passed, {failed} failed ({seconds} s)"
            )?;
            if let Some(reason) = reason {
                writeln!(out, "        {reason}")?;
            }
            if !late.is_empty() {
                writeln!(
                    out,
                    "        passed only when run alone: {}",
                    late.join(", ")
                )?;
            }
        }
        let Count { passed, failed } = self.sum();
        writeln!(out, "\n{passed} passed, {failed} failed")?;
        out.flush()?;
        Ok(failed == 0)
    }
}

/// Runs a command that runs tests; its output goes on to the terminal while it is counted.
fn run_tests(
    command: &mut Command,
    what: &str,
    count: &mut Count,
    failed: &mut Vec<String>,
) -> Result<()> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| not_started(command, what, error))?;
    let output = child
        .stdout
        .take()
        .context("the output of the step is out of reach")?;
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || pass_on(output, &sender));
    let status = child
        .wait()
        .with_context(|| format!("{what} failed: its end is unknown"))?;

    // A browser that a test left running may hold the output open; it is not waited for.
    while let Ok(report) = receiver.recv_timeout(LINGER) {
        match report {
            Report::Sum(sum) => {
                count.passed += sum.passed;
                count.failed += sum.failed;
            }
            Report::Failed(test) => failed.push(test),
        }
    }
    if !status.success() {
        bail!(
            "`{}` ended with {}",
            spelled(command),
            ending(status.code())
        );
    }
    if count.failed > 0 {
        bail!(
            "`{}` reported failed tests and yet ended well",
            spelled(command)
        );
    }
    if count.passed == 0 {
        bail!("`{}` ended well but ran no test", spelled(command));
    }
    Ok(())
}

/// Copies output to the terminal line by line and sends what its lines report.
fn pass_on(output: impl Read, reports: &mpsc::Sender<Report>) {
    let mut output = BufReader::new(output);
    let mut line = Vec::new();
    while output
        .read_until(b'\n', &mut line)
        .is_ok_and(|length| length > 0)
    {
        // A closed terminal is no reason to stop counting.
        let _ = io::stdout().write_all(&line);
        if let Some(report) = reported(&String::from_utf8_lossy(&line)) {
            // The receiver is gone only when the step is over.
            let _ = reports.send(report);
        }
        line.clear();
    }
}

/// What a line of a test runner reports, such as `test result: ok. 3 passed; 0 failed; …`. The
/// runners of cargo and of wasm-bindgen write the same.
fn reported(line: &str) -> Option<Report> {
    let line = anstream::adapter::strip_str(line).to_string();
    let failed = line.trim_end().strip_prefix("test ");
    if let Some(test) = failed.and_then(|line| line.strip_suffix(" ... FAILED")) {
        return Some(Report::Failed(test.to_owned()));
    }
    let (_, result) = line.split_once("test result: ")?;
    let number = |label: &str| {
        let (before, _) = result.split_once(label)?;
        before
            .trim_end()
            .rsplit([' ', ';', '.'])
            .next()?
            .parse()
            .ok()
    };
    Some(Report::Sum(Count {
        passed: number("passed")?,
        failed: number("failed")?,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_of_the_runners_are_read() {
        let count = |passed, failed| Some(Report::Sum(Count { passed, failed }));
        let failed = |test: &str| Some(Report::Failed(test.to_owned()));
        for (line, expected) in [
            (
                "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.1s\n",
                count(12, 0),
            ),
            (
                "test result: FAILED. 1 passed; 2 failed; 0 ignored; 0 filtered out; finished in 0.00s",
                count(1, 2),
            ),
            (
                "test result: \u{1b}[32mok\u{1b}[m. 3 passed; 0 failed; 0 ignored",
                count(3, 0),
            ),
            ("test result: ok. 0 passed; 0 failed;", count(0, 0)),
            ("test tests::result ... ok", None),
            ("test tests::late ... FAILED\n", failed("tests::late")),
            (
                "test tests::\u{1b}[31mlate\u{1b}[m ... FAILED",
                failed("tests::late"),
            ),
            ("test result: who knows", None),
            ("running 3 tests", None),
        ] {
            assert_eq!(reported(line), expected, "{line}");
        }
    }

    /// What a step comes to, by its sum and its reason.
    fn outcome(count: Count, reason: Option<&str>) -> Count {
        let mut tally = Tally::default();
        tally.add("step", count, reason.map(str::to_owned), Duration::ZERO);
        tally.sum()
    }

    #[test]
    fn every_step_counts() {
        let count = |passed, failed| Count { passed, failed };
        assert_eq!(outcome(count(0, 0), None), count(1, 0));
        assert_eq!(outcome(count(7, 0), None), count(7, 0));
        assert_eq!(outcome(count(7, 2), Some("exit code 101")), count(7, 2));
        assert_eq!(outcome(count(7, 0), Some("exit code 101")), count(7, 1));
        assert_eq!(outcome(count(0, 0), Some("not run")), count(0, 1));
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
    fn a_step_that_ends_well_without_tests_fails() {
        let mut tally = Tally::default();
        let mut command = Command::new(env!("CARGO"));
        command.arg("--version");
        tally.tests("nothing", Ok(command));
        assert_eq!(
            tally.sum(),
            Count {
                passed: 0,
                failed: 1
            }
        );
        assert!(tally.0[0].reason.as_ref().unwrap().ends_with("ran no test"));
    }
}
