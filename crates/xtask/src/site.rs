//! The built page in `target/site`: the release build of the wasm side in `pkg/`, and around it what the
//! scripts of `build` make of `www/` and `lang/`.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::step::{announce, run};
use crate::tools::{self, WASM};
use crate::workspace::{VERSION, Workspace, cargo_home};

/// Less is put inline than LLVM would: that makes the download smaller, and nothing slower that
/// could be measured.
const INLINING: &str = "-Cllvm-args=--inline-threshold=50";

/// Installs what the build needs, then builds.
pub(crate) fn set_up_and_build(workspace: &Workspace) -> Result<()> {
    tools::wasm_target(workspace)?;
    let bindgen = tools::wasm_bindgen(workspace)?;
    tools::packages(workspace)?;
    build(workspace, &bindgen)
}

/// Builds beside the old site and puts the new one in its place only when it is whole, so nothing
/// stale survives and a failed build leaves the old one alone.
fn build(workspace: &Workspace, bindgen: &Path) -> Result<()> {
    let (site, fresh) = (workspace.site(), workspace.target().join("site.new"));
    announce("page", "building the release");
    remove(&fresh)?;
    let wasm = compile(workspace)?;
    bind(workspace, bindgen, &wasm, &fresh.join("pkg"))?;
    write(workspace, "site", &fresh, None)?;

    remove(&site)?;
    fs::rename(&fresh, &site)
        .with_context(|| format!("the new page cannot be moved to {}", site.display()))?;
    announce("page", &format!("built in {}", site.display()));
    Ok(())
}

/// The page as it was built, with more folders of lessons and kinds, in a place of its own.
pub(crate) fn build_with(workspace: &Workspace, more: &Path) -> Result<()> {
    let place = workspace.site_with_more();
    remove(&place)?;
    copy(&workspace.site().join("pkg"), &place.join("pkg"))?;
    write(workspace, "site", &place, Some(more))?;
    announce("page with more", &format!("built in {}", place.display()));
    Ok(())
}

/// Writes what is given away of the built page into `dist`: the one file, the folder for a host, the package.
pub(crate) fn give_away(workspace: &Workspace) -> Result<()> {
    write(workspace, "dist", &workspace.site(), None)
}

/// Has the scripts of `build` write the site beside its engine, or `dist` from the site.
fn write(workspace: &Workspace, what: &str, site: &Path, more: Option<&Path>) -> Result<()> {
    let mut node = workspace.node("main.js");
    node.arg(what).args(["--version", VERSION]);
    node.arg("--root").arg(workspace.root());
    node.arg("--target").arg(workspace.target());
    node.arg("--site").arg(site);
    if let Some(more) = more {
        node.arg("--more").arg(more);
    }
    run(&mut node, &format!("writing the {what}"))
}

/// Writes the module that JavaScript imports.
fn bind(workspace: &Workspace, program: &Path, wasm: &Path, place: &Path) -> Result<()> {
    // The names of functions only make the file longer.
    let mut bindgen = workspace.command(program);
    bindgen
        .args(["--target", "web"])
        .args(["--encode-into", "always"])
        .args(["--remove-name-section", "--remove-producers-section"])
        // A trap leaves the stack of the instance as it was: the page begins another one.
        .arg("--experimental-reset-state-function")
        .arg("--out-dir")
        .arg(place)
        .arg(wasm);
    run(&mut bindgen, "writing the bindings")?;
    keep_types(workspace, place)
}

/// The types of what the module offers are not for the browser: the checker, and editors, find them
/// where `tsconfig.json` says.
fn keep_types(workspace: &Workspace, place: &Path) -> Result<()> {
    let types = workspace.types().join("pkg");
    let unmovable = || format!("the types cannot be moved to {}", types.display());
    fs::create_dir_all(&types).with_context(unmovable)?;
    for name in ["assur_web.d.ts", "assur_web_bg.wasm.d.ts"] {
        fs::rename(place.join(name), types.join(name)).with_context(unmovable)?;
    }
    Ok(())
}

/// No wasm-opt follows: an older one makes modules that trap, and the optimiser of rustc does well.
fn compile(workspace: &Workspace) -> Result<PathBuf> {
    // In a file of their own, the flags add to those of the user and the command stays short.
    let flags = workspace.target().join("wasm-flags.toml");
    let mut list = path_remapping(workspace);
    list.push(INLINING.to_owned());
    let list = serde_json::to_string(&list).context("the build flags")?;
    fs::write(&flags, format!("[target.{WASM}]\nrustflags = {list}\n"))
        .with_context(|| format!("{} cannot be written", flags.display()))?;

    let mut cargo = workspace.cargo(["build", "--profile", "page", "--package", "assur-web"]);
    cargo.args(["--target", WASM, "--config"]).arg(flags);
    run(&mut cargo, "building the wasm side")?;
    Ok(workspace
        .target()
        .join(WASM)
        .join("page")
        .join("assur_web.wasm"))
}

/// Messages of panics name source files. These flags shorten them to paths that are the same on
/// every machine, so that the page tells nothing about the one it was built on.
fn path_remapping(workspace: &Workspace) -> Vec<String> {
    let sources = cargo_home().map(|home| home.join("registry").join("src"));
    let registries = sources.and_then(|sources| fs::read_dir(sources).ok());
    registries
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| (entry.path(), "crates"))
        .chain([(workspace.root().to_owned(), "assur")])
        .map(|(from, to)| format!("--remap-path-prefix={}={to}", from.display()))
        .collect()
}

fn remove(directory: &Path) -> Result<()> {
    if !directory.exists() {
        return Ok(());
    }
    fs::remove_dir_all(directory)
        .with_context(|| format!("the old {} cannot be removed", directory.display()))
}

/// Copies the files of a directory.
fn copy(from: &Path, to: &Path) -> Result<()> {
    let unreadable = || format!("{} cannot be read", from.display());
    fs::create_dir_all(to).with_context(|| format!("{} cannot be made", to.display()))?;
    for entry in fs::read_dir(from).with_context(unreadable)? {
        let entry = entry.with_context(unreadable)?;
        fs::copy(entry.path(), to.join(entry.file_name()))
            .with_context(|| format!("{} cannot be copied", entry.path().display()))?;
    }
    Ok(())
}
