//! The engine as a package of npm, `dist/npm/assur-VERSION.tgz`: the wasm side of the built page with its types, a
//! README and an example.

use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};
use flate2::Compression;
use flate2::write::GzEncoder;
use tar::{Builder, Header};

use crate::step::announce;
use crate::workspace::{VERSION, Workspace};

/// Where the version stands in the sources of the package.
const VERSION_PLACE: &str = "{{version}}";

/// How the types of the border name those of saved files, in the workspace and in the package.
const TYPES: (&str, &str) = ("\"assur/types/file.js\"", "\"./file.js\"");

/// As npm itself dates the files of packages: the same sources make the same package.
const DATE: u64 = 499_162_500;

/// Packs what was built.
pub(crate) fn write(workspace: &Workspace) -> Result<()> {
    let files = files(workspace)?;
    let path = workspace.package();
    let unwritable = || format!("{} cannot be written", path.display());
    fs::create_dir_all(path.parent().unwrap_or(workspace.root())).with_context(unwritable)?;
    let packed = pack(&files, Vec::new()).with_context(unwritable)?;
    fs::write(&path, &packed).with_context(unwritable)?;
    let said = format!("{}, {} bytes", path.display(), packed.len());
    announce("package for npm", &said);
    Ok(())
}

type Files = Vec<(String, Vec<u8>)>;

fn files(workspace: &Workspace) -> Result<Files> {
    let root = workspace.root();
    let web = root.join("crates").join("assur-web");
    let own = web.join("npm");
    let mut files = Files::new();
    for name in [
        "package.json",
        "README.md",
        "index.js",
        "index.d.ts",
        "browser.js",
        "mechanism.js",
        "example.js",
    ] {
        let text = text(&own.join(name))?;
        files.push((name.into(), text.replace(VERSION_PLACE, VERSION).into()));
    }
    let (there, here) = TYPES;
    let types = text(&web.join("types.d.ts"))?.replace(there, here);
    files.push(("types/web.d.ts".into(), types.into()));
    let (engine, declared) = (workspace.site().join("pkg"), workspace.types().join("pkg"));
    for (name, path) in [
        ("engine/assur_web.js", engine.join("assur_web.js")),
        ("engine/assur_web_bg.wasm", engine.join("assur_web_bg.wasm")),
        ("engine/assur_web.d.ts", declared.join("assur_web.d.ts")),
        (
            "types/file.d.ts",
            root.join("crates").join("assur-file").join("types.d.ts"),
        ),
        ("LICENSE-MIT", root.join("LICENSE-MIT")),
        ("LICENSE-APACHE", root.join("LICENSE-APACHE")),
    ] {
        let bytes =
            fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
        files.push((name.into(), bytes));
    }
    Ok(files)
}

fn text(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("{} cannot be read", path.display()))
}

/// An archive as npm takes it: all files in the folder `package`.
fn pack<W: Write>(files: &Files, out: W) -> Result<W> {
    let mut archive = Builder::new(GzEncoder::new(out, Compression::best()));
    for (name, content) in files {
        let mut header = Header::new_ustar();
        header.set_size(content.len() as u64);
        header.set_mode(0o644);
        header.set_mtime(DATE);
        archive.append_data(&mut header, format!("package/{name}"), content.as_slice())?;
    }
    Ok(archive.into_inner()?.finish()?)
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use flate2::read::GzDecoder;
    use tar::Archive;

    use super::*;

    #[test]
    fn what_is_packed_is_unpacked_the_same() {
        let files = vec![
            ("package.json".to_owned(), b"{}".to_vec()),
            ("engine/a.wasm".to_owned(), b"\0asm".repeat(1000)),
        ];
        let packed = pack(&files, Vec::new()).unwrap();
        assert_eq!(packed, pack(&files, Vec::new()).unwrap());
        let mut archive = Archive::new(GzDecoder::new(packed.as_slice()));
        let mut unpacked = Files::new();
        for entry in archive.entries().unwrap() {
            let mut entry = entry.unwrap();
            let name = entry.path().unwrap().to_string_lossy().into_owned();
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).unwrap();
            unpacked.push((name.strip_prefix("package/").unwrap().to_owned(), bytes));
        }
        assert_eq!(unpacked, files);
    }
}
