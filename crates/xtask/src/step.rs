//! How a step speaks: one line when it begins or is skipped, one sentence when it fails.

use anyhow::{Context, Result};
use xshell::Cmd;

/// One line about a step: what it is, and whether it is done already or being done.
pub(crate) fn announce(what: &str, state: &str) {
    println!("==> {what}: {state}");
}

/// Runs a command with its output on the terminal; `what` names the step in the sentence of failure.
pub(crate) fn run(command: Cmd, what: &str) -> Result<()> {
    let ran = command.quiet().run();
    ran.with_context(|| format!("{what} failed"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use xshell::{Shell, cmd};

    #[test]
    fn a_step_is_named_where_it_fails() {
        let shell = Shell::new().unwrap();
        for (command, reason) in [
            (
                cmd!(shell, "no-such-program"),
                "not found: `no-such-program`",
            ),
            (
                cmd!(shell, "cargo no-such-command"),
                "`cargo no-such-command`: 101",
            ),
        ] {
            let error = run(command.ignore_stderr(), "weighing").unwrap_err();
            let error = format!("{error:#}");
            assert!(
                error.starts_with("weighing failed: ") && error.ends_with(reason),
                "{error}"
            );
        }
    }
}
