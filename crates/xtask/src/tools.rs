//! The tools of other makers: each is looked for and, if it is not there, installed.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use anyhow::{Context, Result};

use crate::step::{announce, output, quiet_output, run};
use crate::workspace::{self, Workspace};

/// What the browser runs.
pub(crate) const WASM: &str = "wasm32-unknown-unknown";

/// The version of the driver of Firefox.
const GECKODRIVER: &str = "0.37.1";

const THERE: &str = "already there";

/// The standard library for the browser. It is looked for on disk rather than in rustup's list, so a
/// compiler that came without rustup is as good.
pub(crate) fn wasm_target(workspace: &Workspace) -> Result<()> {
    let what = format!("target {WASM}");
    let mut rustc = workspace.command("rustc");
    rustc.args(["--print", "target-libdir", "--target", WASM]);
    let library = fs::read_dir(output(&mut rustc, &what)?.trim());
    let names = library.into_iter().flatten().flatten();
    let there = names
        .map(|entry| entry.file_name())
        .any(|name| name.to_string_lossy().starts_with("libstd-"));
    by_rustup(workspace, &what, there, ["target", "add", WASM])
}

/// Formatter and linter, which rustup's minimal profile leaves out.
pub(crate) fn components(workspace: &Workspace) -> Result<()> {
    for (component, command) in [("rustfmt", "fmt"), ("clippy", "clippy")] {
        let there = quiet_output(&mut workspace.cargo([command, "--version"])).is_some();
        let arguments = ["component", "add", component];
        by_rustup(workspace, component, there, arguments)?;
    }
    Ok(())
}

fn by_rustup(workspace: &Workspace, what: &str, there: bool, arguments: [&str; 3]) -> Result<()> {
    if there {
        announce(what, THERE);
        return Ok(());
    }
    announce(what, "installing by rustup");
    run(workspace.command("rustup").args(arguments), what)
        .with_context(|| format!("{what} is missing, add it by rustup"))
}

/// wasm-bindgen of exactly the version the code is locked to: no other can read its output. Its own
/// lock file is not used, because the crates it shares with the code must match.
pub(crate) fn wasm_bindgen(workspace: &Workspace) -> Result<PathBuf> {
    let version = workspace.locked_version("wasm-bindgen")?;
    installed(workspace, "wasm-bindgen", "wasm-bindgen-cli", &version, &[])
}

/// The driver of Firefox.
pub(crate) fn geckodriver(workspace: &Workspace) -> Result<PathBuf> {
    installed(
        workspace,
        "geckodriver",
        "geckodriver",
        GECKODRIVER,
        &["--locked"],
    )
}

/// The packages of npm that the build, its server and the checker of types need, of the versions in `package-lock.json`.
pub(crate) fn packages(workspace: &Workspace) -> Result<()> {
    const WHAT: &str = "packages of npm";
    let written = |name: &str| fs::metadata(workspace.root().join(name))?.modified();
    let there = written("node_modules/.package-lock.json");
    if there.is_ok_and(|there| written("package-lock.json").is_ok_and(|wanted| wanted <= there)) {
        announce(WHAT, THERE);
        return Ok(());
    }
    let npm = which::which("npm")
        .ok()
        .filter(|_| which::which("node").is_ok());
    let npm = npm.context("Node.js with npm is needed to build the page: install it")?;
    announce(WHAT, "installing by npm");
    let mut npm = workspace.command(&npm);
    run(npm.args(["ci", "--no-audit", "--no-fund"]), WHAT)
}

/// The path of a tool of a version, which is installed if it is not there: below cargo's own folder, so that every
/// clone has it.
fn installed(
    workspace: &Workspace,
    program: &str,
    package: &str,
    version: &str,
    options: &[&str],
) -> Result<PathBuf> {
    let what = format!("{program} {version}");
    let home = workspace::cargo_home().context("the folder of cargo is unknown")?;
    let root = home
        .join("assur-tools")
        .join(format!("{package}-{version}"));
    let file = format!("{program}{}", env::consts::EXE_SUFFIX);
    let path = root.join("bin").join(file);
    let answer = quiet_output(Command::new(&path).arg("--version"));
    if answer.is_some_and(|answer| answer.split_whitespace().nth(1) == Some(version)) {
        announce(&what, THERE);
        return Ok(path);
    }
    announce(&what, "installing by cargo (takes a minute or two)");
    let mut cargo = workspace.cargo(["install", package, "--version", version, "--force"]);
    cargo.args(options).arg("--root").arg(&root);
    // The tools wait for others most of the time: less optimised they are there sooner.
    for (setting, value) in [("OPT_LEVEL", "1"), ("LTO", "off"), ("CODEGEN_UNITS", "16")] {
        cargo.env(format!("CARGO_PROFILE_RELEASE_{setting}"), value);
    }
    run(&mut cargo, &what)?;
    Ok(path)
}
