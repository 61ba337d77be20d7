//! The tools of other makers: each is looked for and, if it is not there, installed.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, Result};
use xshell::{Cmd, cmd};

use crate::step::{announce, run};
use crate::workspace::{Workspace, cargo_home};

/// What the browser runs.
pub(crate) const WASM: &str = "wasm32-unknown-unknown";

/// Versions of the tools that the code is not locked to.
const WASM_PACK: &str = "0.15.1";
const GECKODRIVER: &str = "0.37.1";

const THERE: &str = "already there";

/// The standard library for the browser. It is looked for on disk rather than in rustup's list, so a
/// compiler that came without rustup is as good.
pub(crate) fn wasm_target(workspace: &Workspace) -> Result<()> {
    let shell = &workspace.shell;
    let library = cmd!(shell, "rustc --print target-libdir --target {WASM}").read()?;
    let adding = cmd!(shell, "rustup target add {WASM}");
    by_rustup(WASM, Path::new(&library).is_dir(), adding)
}

/// Formatter and linter, which rustup's minimal profile leaves out.
pub(crate) fn components(workspace: &Workspace) -> Result<()> {
    let shell = &workspace.shell;
    for (component, command) in [("rustfmt", "fmt"), ("clippy", "clippy")] {
        let version = cmd!(shell, "cargo {command} --version").ignore_stderr();
        let adding = cmd!(shell, "rustup component add {component}");
        by_rustup(component, version.read().is_ok(), adding)?;
    }
    Ok(())
}

fn by_rustup(what: &str, there: bool, adding: Cmd) -> Result<()> {
    if there {
        announce(what, THERE);
        return Ok(());
    }
    announce(what, "installing by rustup");
    run(adding, &format!("adding {what} by rustup"))
}

/// wasm-bindgen of exactly the version the code is locked to: no other can read its output. Its own lock file is not used:
/// the crates it shares with the code must match.
pub(crate) fn wasm_bindgen(workspace: &Workspace) -> Result<PathBuf> {
    let version = workspace.locked_version("wasm-bindgen")?;
    installed(
        workspace,
        "wasm-bindgen-cli",
        "wasm-bindgen",
        &version,
        None,
    )
}

/// wasm-pack, which runs the tests of the wasm side in a browser.
pub(crate) fn wasm_pack(workspace: &Workspace) -> Result<PathBuf> {
    let locked = Some("--locked");
    installed(workspace, "wasm-pack", "wasm-pack", WASM_PACK, locked)
}

/// The driver of Firefox.
pub(crate) fn geckodriver(workspace: &Workspace) -> Result<PathBuf> {
    let locked = Some("--locked");
    installed(workspace, "geckodriver", "geckodriver", GECKODRIVER, locked)
}

/// The packages of npm that the build, its server and the checker of types need, of the versions in `package-lock.json`.
pub(crate) fn packages(workspace: &Workspace) -> Result<()> {
    const WHAT: &str = "packages of npm";
    let written = |name| fs::metadata(workspace.root.join(name)).and_then(|file| file.modified());
    let there = written("node_modules/.package-lock.json");
    if there.is_ok_and(|there| written("package-lock.json").is_ok_and(|wanted| wanted <= there)) {
        announce(WHAT, THERE);
        return Ok(());
    }
    let npm = which::which("node").and_then(|_| which::which("npm"));
    let npm = npm.context("Node.js with npm is needed to build the page: install it")?;
    announce(WHAT, "installing by npm");
    run(cmd!(workspace.shell, "{npm} ci --no-audit --no-fund"), WHAT)
}

/// The path of a tool of a version, which is installed if it is not there: below cargo's own folder, so that every
/// clone has it.
fn installed(
    workspace: &Workspace,
    package: &str,
    program: &str,
    version: &str,
    locked: Option<&str>,
) -> Result<PathBuf> {
    let what = format!("{program} {version}");
    let tools = cargo_home()?.join("assur-tools");
    let root = tools.join(format!("{package}-{version}"));
    let path = root
        .join("bin")
        .join(program)
        .with_extension(env::consts::EXE_EXTENSION);
    let there = cmd!(workspace.shell, "{path} --version")
        .ignore_stderr()
        .read();
    if there.is_ok() {
        announce(&what, THERE);
        return Ok(path);
    }
    announce(&what, "installing by cargo (takes a minute or two)");
    let cargo = cmd!(
        workspace.shell,
        "cargo install {package} --version {version} {locked...} --root {root} --force"
    )
    // The tools wait for others most of the time: less optimised they are there sooner.
    .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1")
    .env("CARGO_PROFILE_RELEASE_LTO", "off")
    .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
    run(cargo, &what)?;
    Ok(path)
}

/// PATH with the folder of a tool first, so that others find it in the right version.
pub(crate) fn search_path(tool: &Path) -> Result<OsString> {
    let others = env::var_os("PATH").unwrap_or_default();
    let own = tool.parent().map(Path::to_owned);
    env::join_paths(own.into_iter().chain(env::split_paths(&others)))
        .context("the path of cargo's folder cannot be put into PATH")
}
