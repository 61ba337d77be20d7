//! Messages of steps: one line when a step begins or is skipped, one sentence when it fails.

use anyhow::{Context, Result};
use xshell::Cmd;

/// Prints a line about a step: its name, and its state, such as already done or running.
pub(crate) fn announce(what: &str, state: &str) {
    println!("==> {what}: {state}");
}

/// Runs a command with its output on the terminal; `what` names the step in the error message.
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
        let error = run(cmd!(shell, "no-such-program"), "weighing").unwrap_err();
        let said = "weighing failed: command not found: `no-such-program`";
        assert_eq!(format!("{error:#}"), said);
    }
}
