//! Settings of a run, which `cargo xtask test` passes as environment variables.

use std::env;

/// Whether the pages are opened in Firefox: `ASSUR_BROWSER` says so.
pub(crate) fn in_firefox() -> bool {
    env::var("ASSUR_BROWSER").is_ok_and(|browser| browser == "firefox")
}

/// Whether a test can only be asked of Chromium, which it is not in; the reason is printed.
pub(crate) fn lacking(what: &str) -> bool {
    if in_firefox() {
        println!("not asked of Firefox, which lacks {what}");
    }
    in_firefox()
}

/// An environment variable that `cargo xtask test` sets.
pub(crate) fn setting(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("{name} is not set: run `cargo xtask test`"))
}
