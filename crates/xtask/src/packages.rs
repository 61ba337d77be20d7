//! A check of the engine's crates as packages: each holds all that it needs, and its documentation gives no warnings.

use std::fmt::Write as _;

use anyhow::Result;
use xshell::cmd;

use crate::step::run;
use crate::workspace::{VERSION, Workspace};

/// The crates that a programmer may use without the page.
const CRATES: [&str; 5] = [
    "assur",
    "assur-draw",
    "assur-edit",
    "assur-file",
    "assur-import",
];

/// Makes the packages, unpacks them and builds their documentation, with warnings as errors.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let Workspace {
        shell,
        root,
        target,
    } = workspace;
    let packed = CRATES.map(|name| ["--package", name]);
    let packed = packed.as_flattened();
    // Everything that the crates need has already been fetched for the tests.
    let pack = cmd!(
        shell,
        "cargo package --offline --no-verify --allow-dirty {packed...}"
    );
    run(pack, "packing")?;

    let place = target.join("packages");
    let (mut members, mut patches) = (String::new(), String::new());
    for name in CRATES {
        let folder = format!("{name}-{VERSION}");
        shell.remove_path(place.join(&folder))?;
        shell.create_dir(&place)?;
        let file = target.join(format!("package/{folder}.crate"));
        run(
            cmd!(shell, "tar -xzf {file} -C {place}"),
            "unpacking of a package",
        )?;
        let _ = write!(members, "{folder:?}, ");
        let _ = writeln!(patches, "{name} = {{ path = {folder:?} }}");
    }
    let manifest = place.join("Cargo.toml");
    let text = format!(
        "[workspace]\nresolver = \"3\"\nmembers = [{members}]\n\n[patch.crates-io]\n{patches}"
    );
    shell.write_file(&manifest, text)?;
    shell.copy_file(root.join("Cargo.lock"), place.join("Cargo.lock"))?;
    let built = place.join("target");
    let doc = cmd!(
        shell,
        "cargo doc --offline --workspace --no-deps --manifest-path {manifest} --target-dir {built}"
    );
    run(doc.env("RUSTDOCFLAGS", "-D warnings"), "documentation")
}
