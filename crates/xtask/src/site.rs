//! The built page in `target/site`: the release build of the wasm side, and the files that the scripts in `build` make
//! from `www/` and `lang/`.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use serde_json::json;
use xshell::cmd;

use crate::parts;
use crate::step::{announce, run};
use crate::tools::{self, WASM};
use crate::workspace::{VERSION, Workspace, cargo_home};

/// Inlining threshold below LLVM's default. It makes the download smaller, and nothing is measurably slower.
const INLINING: &str = "-Cllvm-args=--inline-threshold=50";

/// The imports of the module, as the bindings list them.
const IMPORTS: &str = "\"./assur_web_bg.js\": import0,";
/// The import of the first part that loads the second.
const LOAD: &str = "second: { load: () => second.load() },";
/// The function behind this import. The page replaces it.
const LOADER: &str = "
export const second = {
    load() {
        throw new Error(\"nothing loads the second part of the engine\");
    },
};
";
const LOADER_TYPE: &str = "
/** Loads the second part of the module, if the module is divided. */
export const second: { load(): void };
";

/// Installs what the build needs, then builds the page.
pub(crate) fn set_up_and_build(workspace: &Workspace) -> Result<()> {
    tools::wasm_target(workspace)?;
    let bindgen = tools::wasm_bindgen(workspace)?;
    tools::packages(workspace)?;
    announce("page", "building the release");
    let wasm = compile(workspace)?;
    bind(workspace, &bindgen, &wasm)?;
    divide(workspace)?;
    write(workspace, "site", None)
}

/// Builds the page with further folders of lessons and kinds of documents, into a separate folder.
pub(crate) fn build_with(workspace: &Workspace, more: &Path) -> Result<()> {
    write(workspace, "site", Some(more))
}

/// Writes the built page into `dist` in its distributed forms: one file, folder for a web host, npm package.
pub(crate) fn give_away(workspace: &Workspace) -> Result<()> {
    write(workspace, "dist", None)
}

/// Runs the scripts of `build` to write the site from the engine, or `dist` from the site.
fn write(workspace: &Workspace, what: &str, more: Option<&Path>) -> Result<()> {
    let (root, target) = (&workspace.root, &workspace.target);
    let node = cmd!(
        workspace.shell,
        "node crates/xtask/build/main.js {what} {more...} --root {root} --target {target} --version {VERSION}"
    );
    run(node, &format!("writing the {what}"))
}

/// Writes the module that JavaScript imports, and its types, where `build/site.js` and `tsconfig.json` expect them.
fn bind(workspace: &Workspace, program: &Path, wasm: &Path) -> Result<()> {
    // Function names would only make the file longer. A trap does not reset the stack of the instance, so after a trap
    // the page starts a new instance through the reset function.
    let bindgen = cmd!(
        workspace.shell,
        "{program} {wasm} --out-dir target/engine --target web --encode-into always
            --remove-name-section --remove-producers-section --experimental-reset-state-function"
    );
    run(bindgen, "writing the bindings")
}

/// Divides the module into two parts. The first holds the functions that the calls of `build/first-view.js` use.
fn divide(workspace: &Workspace) -> Result<()> {
    let Workspace { shell, root, .. } = workspace;
    let engine = workspace.target.join("engine");
    let whole = shell.read_binary_file(engine.join("assur_web_bg.wasm"))?;
    let marked = engine.join("marked.wasm");
    shell.write_file(&marked, parts::marked(&whole)?)?;
    let script = root.join("crates/xtask/build/first-view.js");
    let called = cmd!(shell, "node {script} {engine} {marked}").read()?;
    let called =
        serde_json::from_str(&called).context("the functions of the first view cannot be read")?;
    let [first, second] = parts::divided(&whole, &called)?;
    shell.write_file(engine.join("first.wasm"), first)?;
    shell.write_file(engine.join("second.wasm"), second)?;

    let [script, types] = ["assur_web.js", "assur_web.d.ts"].map(|name| engine.join(name));
    let text = shell.read_file(&script)?;
    ensure!(
        text.contains(IMPORTS),
        "the bindings do not list their imports as expected"
    );
    let text = text.replace(IMPORTS, &format!("{IMPORTS} {LOAD}"));
    shell.write_file(script, text + LOADER)?;
    let text = shell.read_file(&types)?;
    shell.write_file(types, text + LOADER_TYPE)?;
    Ok(())
}

/// Compiles the wasm side. wasm-opt is not run: older versions of it make modules that trap, and rustc optimises well.
fn compile(workspace: &Workspace) -> Result<PathBuf> {
    let mut flags = path_remapping(workspace)?;
    flags.push(INLINING.to_owned());
    // These flags are added to the user's own flags.
    let flags = format!("target.{WASM}.rustflags={}", json!(flags));
    let cargo = cmd!(
        workspace.shell,
        "cargo build --profile page --package assur-web --target {WASM} --config {flags}"
    );
    run(cargo, "building the wasm side")?;
    Ok(workspace.target.join(WASM).join("page/assur_web.wasm"))
}

/// Flags that hide the build machine: paths of source files in panic messages become the same on every machine.
fn path_remapping(workspace: &Workspace) -> Result<Vec<String>> {
    let sources = cargo_home()?.join("registry/src");
    let registries = workspace.shell.read_dir(sources).unwrap_or_default();
    let crates = registries.iter().map(|registry| (registry, "crates"));
    let all = crates.chain([(&workspace.root, "assur")]);
    let flag = |(from, to): (&PathBuf, _)| format!("--remap-path-prefix={}={to}", from.display());
    Ok(all.map(flag).collect())
}
