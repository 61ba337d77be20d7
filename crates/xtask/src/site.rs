//! The built page: `www/` with its places for words filled in, `lang/`, and the release build of the
//! wasm side in `pkg/`; scripts and style sheets put together and made small.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, Result};

use crate::bundle::{STYLE_CLOSE, STYLE_OPEN};
use crate::kinds;
use crate::lessons;
use crate::minify;
use crate::notes;
use crate::scripts::{self, Sources};
use crate::step::{announce, run};
use crate::tools::{self, WASM};
use crate::words::Words;
use crate::workspace::{VERSION, Workspace};

/// The script of the first view.
const FIRST: &str = "app/main.js";

/// The style sheet of the first view.
const STYLE: &str = "style.css";

/// Less is put inline than LLVM would: that makes the download smaller, and nothing slower that
/// could be measured.
const INLINING: &str = "-Cllvm-args=--inline-threshold=50";

/// Installs what the build needs, then builds.
pub(crate) fn set_up_and_build(workspace: &Workspace) -> Result<()> {
    tools::wasm_target(workspace)?;
    tools::wasm_bindgen(workspace)?;
    build(workspace)
}

/// Builds beside the old site and puts the new one in its place only when it is whole, so nothing
/// stale survives and a failed build leaves the old one alone.
pub(crate) fn build(workspace: &Workspace) -> Result<()> {
    let (site, fresh) = (workspace.site(), workspace.target().join("site.new"));
    announce("page", "building the release");
    put_together(workspace, None, &fresh)?;
    bind(workspace, &compile(workspace)?, &fresh.join("pkg"))?;
    minify_all(&fresh)?;

    remove(&site)?;
    fs::rename(&fresh, &site)
        .with_context(|| format!("the new page cannot be moved to {}", site.display()))?;
    announce("page", &format!("built in {}", site.display()));
    Ok(())
}

/// The page as it was built, with more folders of lessons and kinds, in a place of its own.
pub(crate) fn build_with(workspace: &Workspace, more: &Path) -> Result<PathBuf> {
    let place = workspace.target().join("site.more");
    put_together(workspace, Some(more), &place)?;
    copy(&workspace.site().join("pkg"), &place.join("pkg"))?;
    minify_all(&place)?;
    announce("page with more", &format!("built in {}", place.display()));
    Ok(place)
}

/// All of the page but the wasm side.
fn put_together(workspace: &Workspace, more: Option<&Path>, site: &Path) -> Result<()> {
    let root = workspace.root();
    remove(site)?;
    copy(&root.join("www"), site)?;
    if let Some(more) = more {
        copy(more, site)?;
    }
    copy(&root.join("lang"), &site.join("lang"))?;
    kinds::add_words(&site.join("kinds"), &site.join("lang"))?;
    fill_words(site)?;
    lessons::name(&site.join("lessons"), &site.join("lang"))?;
    notes::publish(root, site)?;
    list_folders(workspace, site)?;
    join_scripts(site)?;
    join_styles(site)
}

/// Writes the module that JavaScript imports.
fn bind(workspace: &Workspace, wasm: &Path, place: &Path) -> Result<()> {
    // The names of functions only make the file longer.
    let mut bindgen = workspace.command(&tools::path(workspace, "wasm-bindgen"));
    bindgen
        .args(["--target", "web"])
        .args(["--encode-into", "always"])
        .args(["--remove-name-section", "--remove-producers-section"])
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
    let home = env::var_os("CARGO_HOME")
        .map(PathBuf::from)
        .or_else(|| env::home_dir().map(|home| home.join(".cargo")));
    let sources = home.map(|home| home.join("registry").join("src"));
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

fn fill_words(site: &Path) -> Result<()> {
    let index = site.join("index.html");
    let filled = Words::load(&site.join("lang"))?.fill(&read(&index)?, VERSION)?;
    write(&index, &filled)
}

/// Writes the lists of the lessons and of the kinds, and their types for the checker.
fn list_folders(workspace: &Workspace, site: &Path) -> Result<()> {
    let lists = [
        (
            lessons::LIST,
            lessons::list(&site.join("lessons"))?,
            lessons::TYPES,
        ),
        (kinds::LIST, kinds::list(&site.join("kinds"))?, kinds::TYPES),
    ];
    for (place, list, types) in lists {
        write(&site.join(place), &list)?;
        let declared = workspace.types().join(place).with_extension("d.ts");
        let folder = declared.parent().unwrap_or(&declared);
        fs::create_dir_all(folder).with_context(|| unwritable(folder))?;
        write(&declared, types)?;
    }
    Ok(())
}

/// Puts the scripts together, before those of the wasm side are beside them.
fn join_scripts(site: &Path) -> Result<()> {
    let mut sources = Sources::new();
    for path in files(site, "js")? {
        let name = path.strip_prefix(site).unwrap_or(&path).to_string_lossy();
        sources.insert(name.replace('\\', "/"), read(&path)?);
        fs::remove_file(&path).with_context(|| unwritable(&path))?;
    }
    for (name, script) in scripts::join(&sources, FIRST)? {
        write(&site.join(name), &script)?;
    }
    Ok(())
}

/// Puts the style sheets of the first view into one, which is linked where the first of them was.
fn join_styles(site: &Path) -> Result<()> {
    let index = site.join("index.html");
    let page = read(&index)?;
    let mut sheet = String::new();
    let mut rest = page.as_str();
    let mut linked = String::new();
    while let Some((before, after)) = rest.split_once(STYLE_OPEN) {
        let (name, after) = after
            .split_once(STYLE_CLOSE)
            .context("a link of index.html")?;
        linked += before;
        if sheet.is_empty() {
            linked += &format!("{STYLE_OPEN}{STYLE}{STYLE_CLOSE}");
        }
        let path = site.join(name);
        sheet += &read(&path)?;
        fs::remove_file(&path).with_context(|| unwritable(&path))?;
        rest = after;
    }
    write(&index, &(linked + rest))?;
    write(&site.join(STYLE), &sheet)
}

/// Makes every script and style sheet small.
fn minify_all(site: &Path) -> Result<()> {
    for path in files(site, "js")? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        write(&path, &minify::module(&name, &read(&path)?)?)?;
    }
    for path in files(site, "css")? {
        write(&path, &minify::style(&read(&path)?)?)?;
    }
    Ok(())
}

/// The files of a directory, and of those in it, whose names have this ending.
fn files(directory: &Path, ending: &str) -> Result<Vec<PathBuf>> {
    let unreadable = || format!("{} cannot be read", directory.display());
    let mut found = Vec::new();
    for entry in fs::read_dir(directory).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        if path.is_dir() {
            found.extend(files(&path, ending)?);
        } else if path.extension() == Some(OsStr::new(ending)) {
            found.push(path);
        }
    }
    Ok(found)
}

pub(crate) fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("{} cannot be read", path.display()))
}

pub(crate) fn write(path: &Path, text: &str) -> Result<()> {
    fs::write(path, text).with_context(|| unwritable(path))
}

fn unwritable(path: &Path) -> String {
    format!("{} cannot be written", path.display())
}

pub(crate) fn remove(directory: &Path) -> Result<()> {
    if !directory.exists() {
        return Ok(());
    }
    fs::remove_dir_all(directory)
        .with_context(|| format!("the old {} cannot be removed", directory.display()))
}

/// Copies a directory with all that is in it, hidden files aside.
pub(crate) fn copy(from: &Path, to: &Path) -> Result<()> {
    let unreadable = || format!("{} cannot be read", from.display());
    fs::create_dir_all(to).with_context(|| format!("{} cannot be made", to.display()))?;
    for entry in fs::read_dir(from).with_context(unreadable)? {
        let entry = entry.with_context(unreadable)?;
        let (path, name) = (entry.path(), entry.file_name());
        if name.to_string_lossy().starts_with('.') {
            continue;
        }
        if path.is_dir() {
            copy(&path, &to.join(name))?;
        } else {
            fs::copy(&path, to.join(name))
                .with_context(|| format!("{} cannot be copied", path.display()))?;
        }
    }
    Ok(())
}
