//! How a step speaks: one line when it begins or is skipped, one sentence when it fails.

use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};

use anyhow::{Context, Error, Result, anyhow, ensure};

/// The words of a command that a sentence has room for.
const MOST_WORDS: usize = 15;

/// One line about a step: what it is, and whether it is done already or being done.
pub(crate) fn announce(what: &str, state: &str) {
    println!("==> {what}: {state}");
}

/// Runs a command with its output on the terminal; `what` names the step in the sentence of failure.
pub(crate) fn run(command: &mut Command, what: &str) -> Result<()> {
    let status = command
        .status()
        .map_err(|error| not_started(command, what, error))?;
    succeeded(status, command, what)
}

/// Runs a command for what it prints; its complaints go to the terminal.
pub(crate) fn output(command: &mut Command, what: &str) -> Result<String> {
    let output = command
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| not_started(command, what, error))?;
    succeeded(output.status, command, what)?;
    String::from_utf8(output.stdout).with_context(|| format!("{what} failed: not text"))
}

/// What a command prints when it is there and works; nothing otherwise, and nothing on the terminal.
pub(crate) fn quiet_output(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then_some(text)
}

fn succeeded(status: ExitStatus, command: &Command, what: &str) -> Result<()> {
    let ending = ending(status.code());
    ensure!(
        status.success(),
        "{what} failed: `{}` ended with {ending}",
        spelled(command)
    );
    Ok(())
}

pub(crate) fn not_started(command: &Command, what: &str, error: std::io::Error) -> Error {
    let program = command.get_program().display();
    if error.kind() == ErrorKind::NotFound {
        anyhow!("{what} failed: the program `{program}` is not installed")
    } else {
        anyhow!("{what} failed: `{program}` did not start: {error}")
    }
}

/// The command as one would type it, for people; quoting is left out, and what follows the first words.
pub(crate) fn spelled(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_stem();
    let words = program.into_iter().chain(command.get_args());
    let mut words: Vec<_> = words.map(|word| word.to_string_lossy()).collect();
    if words.len() > MOST_WORDS {
        words.truncate(MOST_WORDS);
        words.push("…".into());
    }
    words.join(" ")
}

pub(crate) fn ending(code: Option<i32>) -> String {
    code.map_or_else(|| "a signal".to_owned(), |code| format!("exit code {code}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_program_is_named() {
        let error = run(&mut Command::new("no-such-program-here"), "weighing").unwrap_err();
        assert_eq!(
            error.to_string(),
            "weighing failed: the program `no-such-program-here` is not installed"
        );
    }

    #[test]
    fn a_failing_command_is_spelled_with_its_exit_code() {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.arg("no-such-command-here").stderr(Stdio::null());
        let error = run(&mut cargo, "weighing").unwrap_err().to_string();
        assert_eq!(
            error,
            "weighing failed: `cargo no-such-command-here` ended with exit code 101"
        );
        assert_eq!(quiet_output(&mut cargo), None);
    }
}
