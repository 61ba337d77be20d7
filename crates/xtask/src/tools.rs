//! External tools: each is looked for and, if missing, installed.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, Result};
use xshell::{Cmd, cmd};

use crate::step::{announce, run};
use crate::workspace::{Workspace, cargo_home};

/// Target of the compiled code that runs in the browser.
pub(crate) const WASM: &str = "wasm32-unknown-unknown";

/// Version of wasm-pack, which Cargo.lock does not determine.
const WASM_PACK: &str = "0.15.1";
/// Version of geckodriver, which Cargo.lock does not determine.
const GECKODRIVER: &str = "0.37.1";

const THERE: &str = "already there";

/// Installs the standard library for [`WASM`]. The library is looked for on disk, so a compiler without rustup works
/// too.
pub(crate) fn wasm_target(workspace: &Workspace) -> Result<()> {
    let shell = &workspace.shell;
    let library = cmd!(shell, "rustc --print target-libdir --target {WASM}").read()?;
    let adding = cmd!(shell, "rustup target add {WASM}");
    by_rustup(WASM, Path::new(&library).is_dir(), adding)
}

/// Installs formatter and linter, which rustup's minimal profile leaves out.
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

/// Installs the version of wasm-bindgen that Cargo.lock determines: no other version can process the compiled code. The
/// lock file of the tool itself is not used, because the crates that it shares with the code must match.
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

/// Installs wasm-pack, which runs the tests of the wasm side in a browser.
pub(crate) fn wasm_pack(workspace: &Workspace) -> Result<PathBuf> {
    let locked = Some("--locked");
    installed(workspace, "wasm-pack", "wasm-pack", WASM_PACK, locked)
}

/// Installs the driver of Firefox.
pub(crate) fn geckodriver(workspace: &Workspace) -> Result<PathBuf> {
    let locked = Some("--locked");
    installed(workspace, "geckodriver", "geckodriver", GECKODRIVER, locked)
}

/// Installs the npm packages for the build, its server and the type checker, in the versions of `package-lock.json`.
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

/// Returns the path of a tool in a given version, and installs the tool if it is missing. The tool is installed inside
/// cargo's folder, so all clones of the repository share it.
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
    // The tools mostly wait for other programs, so they are built faster, with less optimisation.
    .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1")
    .env("CARGO_PROFILE_RELEASE_LTO", "off")
    .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
    run(cargo, &what)?;
    Ok(path)
}

/// PATH with the folder of a tool first, so that other programs find this tool in the right version.
pub(crate) fn search_path(tool: &Path) -> Result<OsString> {
    let others = env::var_os("PATH").unwrap_or_default();
    let own = tool.parent().map(Path::to_owned);
    env::join_paths(own.into_iter().chain(env::split_paths(&others)))
        .context("the path of cargo's folder cannot be put into PATH")
}
