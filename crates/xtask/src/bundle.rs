//! The one-file page, which opens by double-click: no server, no network.
//!
//! A page opened from a file may load no module and fetch no file beside it. But the modules find
//! each other by bare names only, so it is enough to replace the import map by one in which every
//! name stands for a `data:` address that holds the file itself, and to put the style sheets inside.
//! Those in folders are loaded later, by name as modules are.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::path::Path;

use anyhow::{Context, Result, bail};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde::Serialize;

use crate::hosting::{ELEMENT, OFFLINE};
use crate::media::media_type;
use crate::notes::FOLDER;
use crate::step::announce;
use crate::workspace::Workspace;

/// The name under which the import map of the site knows its root.
pub(crate) const PREFIX: &str = "assur/";

const MAP_OPEN: &str = "<script type=\"importmap\">";
const MAP_CLOSE: &str = "</script>";
pub(crate) const STYLE_OPEN: &str = "<link rel=\"stylesheet\" href=\"";
pub(crate) const STYLE_CLOSE: &str = "\">";

/// Between these the page asks at once for files that it will need: those that are in it need no asking.
const EARLY_OPEN: &str = "<!-- early -->";
const EARLY_CLOSE: &str = "<!-- /early -->";

/// The files of the site, by their paths with forward slashes.
pub(crate) type Files = BTreeMap<String, Vec<u8>>;

/// Writes the bundle from the built site.
pub(crate) fn write(workspace: &Workspace) -> Result<()> {
    let mut files = Files::new();
    collect(&workspace.site(), "", &mut files)?;
    // The notes are documents of their own, and a page from the disk needs no hosting.
    files.retain(|name, _| {
        Path::new(name).parent() != Some(Path::new(FOLDER)) && !name.starts_with(OFFLINE)
    });
    let element = files.remove(ELEMENT);
    let page = assemble(&files)?;

    let path = workspace.bundle();
    let unwritable = || format!("{} cannot be written", path.display());
    fs::create_dir_all(path.parent().unwrap_or(workspace.root())).with_context(unwritable)?;
    fs::write(&path, &page).with_context(unwritable)?;
    // For pages of others that have it in a frame.
    if let Some(element) = element {
        fs::write(path.with_file_name(ELEMENT), element).with_context(unwritable)?;
    }
    announce(
        "one-file page",
        &format!("{}, {} bytes", path.display(), page.len()),
    );
    Ok(())
}

pub(crate) fn collect(directory: &Path, prefix: &str, files: &mut Files) -> Result<()> {
    let unreadable = || format!("{} cannot be read", directory.display());
    for entry in fs::read_dir(directory).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        let name = format!(
            "{prefix}{}",
            path.file_name().unwrap_or_default().to_string_lossy()
        );
        if path.is_dir() {
            collect(&path, &format!("{name}/"), files)?;
        } else {
            files.insert(name, fs::read(&path).with_context(unreadable)?);
        }
    }
    Ok(())
}

#[derive(Serialize)]
struct ImportMap {
    imports: BTreeMap<String, String>,
}

fn assemble(files: &Files) -> Result<String> {
    let mut page = text(files, "index.html")?.to_owned();
    if let Some((before, early)) = page.split_once(EARLY_OPEN) {
        let (_, after) = split_at_literal(early, EARLY_CLOSE)?;
        page = format!("{before}{after}");
    }
    let mut imports = BTreeMap::new();
    for (name, bytes) in files {
        let address = data_address(name, bytes);
        match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
            "js" => {
                refuse_relative_imports(name, text(files, name)?)?;
                imports.insert(format!("{PREFIX}{name}"), address);
            }
            "json" => {
                imports.insert(format!("{PREFIX}{name}"), address);
            }
            "wasm" => {
                imports.insert(format!("{PREFIX}{name}"), packed_address(bytes)?);
            }
            "html" if name == "index.html" => {}
            "html" => bail!("the one-file page has no place for {name}"),
            "css" if name.contains('/') => {
                imports.insert(format!("{PREFIX}{name}"), address);
            }
            "css" => {}
            _ => page = page.replace(&format!("=\"{name}\""), &format!("=\"{address}\"")),
        }
    }
    // Only the two literal places of the page are touched, and nothing that is put in may end its
    // element early: in JSON `<` can be written as an escape, in a style sheet `/` can.
    put_styles_inside(with_import_map(&page, imports)?, files)
}

/// The page with another import map: names of modules and where they are.
pub(crate) fn with_import_map(page: &str, imports: BTreeMap<String, String>) -> Result<String> {
    let map = serde_json::to_string(&ImportMap { imports }).context("the import map")?;
    let (before, rest) = split_at_literal(page, MAP_OPEN)?;
    let (_, after) = split_at_literal(rest, MAP_CLOSE)?;
    Ok(format!(
        "{before}{MAP_OPEN}{}{MAP_CLOSE}{after}",
        map.replace('<', "\\u003c")
    ))
}

/// Puts every style sheet in the place of the link to it.
fn put_styles_inside(mut page: String, files: &Files) -> Result<String> {
    let mut inside = Vec::new();
    while let Some((before, rest)) = page.split_once(STYLE_OPEN) {
        let (name, after) = split_at_literal(rest, STYLE_CLOSE)?;
        let mut style = text(files, name)?.replace("</", "<\\/");
        for (name, bytes) in files {
            for quote in ["", "'", "\""] {
                let from = format!("url({quote}{name}{quote})");
                if style.contains(&from) {
                    let address = data_address(name, bytes);
                    style = style.replace(&from, &format!("url({quote}{address}{quote})"));
                }
            }
        }
        inside.push(name.to_owned());
        page = format!("{before}<style>\n{style}</style>{after}");
    }
    let unlinked = files
        .keys()
        .find(|name| name.ends_with(".css") && !name.contains('/') && !inside.contains(name));
    match unlinked {
        Some(name) => bail!("the one-file page has no place for {name}"),
        None => Ok(page),
    }
}

pub(crate) fn text<'a>(files: &'a Files, name: &str) -> Result<&'a str> {
    let bytes = files
        .get(name)
        .with_context(|| format!("the site holds no {name}"))?;
    std::str::from_utf8(bytes).with_context(|| format!("{name} is not UTF-8"))
}

fn data_address(name: &str, bytes: &[u8]) -> String {
    let kind = media_type(name).replace(' ', "");
    format!("data:{kind};base64,{}", STANDARD.encode(bytes))
}

/// The wasm is most of the page, and three times as small packed: the page unpacks it by its media type.
fn packed_address(bytes: &[u8]) -> Result<String> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes).context("packing the wasm")?;
    let packed = packer.finish().context("packing the wasm")?;
    Ok(format!(
        "data:application/gzip;base64,{}",
        STANDARD.encode(packed)
    ))
}

/// A relative name means nothing inside a `data:` address.
fn refuse_relative_imports(name: &str, module: &str) -> Result<()> {
    for (number, line) in module.lines().enumerate() {
        for keyword in ["from", "import", "import("] {
            for quote in ['"', '\'', '`'] {
                for dots in ["./", "../"] {
                    if [" ", ""]
                        .iter()
                        .any(|gap| line.contains(&format!("{keyword}{gap}{quote}{dots}")))
                    {
                        bail!(
                            "{name}:{} imports by a relative path; write `{PREFIX}…`",
                            number + 1
                        );
                    }
                }
            }
        }
    }
    Ok(())
}

pub(crate) fn split_at_literal<'a>(page: &'a str, literal: &str) -> Result<(&'a str, &'a str)> {
    page.split_once(literal)
        .with_context(|| format!("index.html does not hold `{literal}` literally"))
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use flate2::read::GzDecoder;

    use super::*;

    const PAGE: &str = "<!doctype html><title>x</title>\
        <link rel=\"stylesheet\" href=\"style.css\"><link rel=\"icon\" href=\"icon.svg\">\
        <script type=\"importmap\">{\"imports\":{\"assur/\":\"./\"}}</script>\
        <script type=\"module\">import \"assur/main.js\";</script>";

    fn site(changes: &[(&str, &str)]) -> Files {
        let mut files: Files = [
            ("index.html", PAGE),
            ("style.css", "body { color: red }"),
            ("icon.svg", "<svg/>"),
            ("main.js", "import init from \"assur/pkg/assur_web.js\";"),
            ("linkage/style.css", "a { color: blue }"),
            ("pkg/assur_web.js", "export default 1; // </script>"),
            ("pkg/assur_web_bg.wasm", "\0asm"),
            ("lang/en.json", "{}"),
        ]
        .iter()
        .chain(changes)
        .map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()))
        .collect();
        files.retain(|_, bytes| !bytes.is_empty());
        files
    }

    fn imports(page: &str) -> BTreeMap<String, String> {
        let map = page
            .split_once(MAP_OPEN)
            .unwrap()
            .1
            .split_once(MAP_CLOSE)
            .unwrap()
            .0;
        let map: BTreeMap<String, BTreeMap<String, String>> = serde_json::from_str(map).unwrap();
        map["imports"].clone()
    }

    #[test]
    fn every_module_table_and_wasm_is_in_the_map() {
        let page = assemble(&site(&[])).unwrap();
        let imports = imports(&page);
        let names: Vec<_> = imports.keys().map(String::as_str).collect();
        assert_eq!(
            names,
            [
                "assur/lang/en.json",
                "assur/linkage/style.css",
                "assur/main.js",
                "assur/pkg/assur_web.js",
                "assur/pkg/assur_web_bg.wasm"
            ]
        );
        assert_eq!(
            imports["assur/lang/en.json"],
            "data:application/json;base64,e30="
        );
        let wasm =
            imports["assur/pkg/assur_web_bg.wasm"].split_once("data:application/gzip;base64,");
        let packed = STANDARD.decode(wasm.unwrap().1).unwrap();
        let mut unpacked = Vec::new();
        GzDecoder::new(&packed[..])
            .read_to_end(&mut unpacked)
            .unwrap();
        assert_eq!(unpacked, b"\0asm");
        assert!(
            imports["assur/linkage/style.css"].starts_with("data:text/css;charset=utf-8;base64,")
        );
        assert!(imports["assur/main.js"].starts_with("data:text/javascript;charset=utf-8;base64,"));
    }

    #[test]
    fn nothing_is_left_outside_the_file() {
        let page = assemble(&site(&[("style.css", "a{background:url(icon.svg)}")])).unwrap();
        assert!(
            !page.contains("stylesheet") && !page.contains("icon.svg"),
            "{page}"
        );
        assert_eq!(page.matches("data:image/svg+xml;base64,").count(), 2);
        assert_eq!(
            page.matches("</script>").count(),
            PAGE.matches("</script>").count()
        );
    }

    #[test]
    fn what_is_in_the_file_is_not_asked_for() {
        let early =
            "<!-- early --><link rel=\"modulepreload\" href=\"main.js\"><!-- /early --><title>";
        let page = assemble(&site(&[("index.html", &PAGE.replace("<title>", early))])).unwrap();
        assert_eq!(page, assemble(&site(&[])).unwrap());
    }

    #[test]
    fn style_sheets_keep_their_order() {
        let links = PAGE.replace(
            "<link rel=\"icon\"",
            "<link rel=\"stylesheet\" href=\"later.css\"><link rel=\"icon\"",
        );
        let page = assemble(&site(&[("index.html", &links), ("later.css", "b {}")])).unwrap();
        let (first, then) = (page.find("color: red"), page.find("b {}"));
        assert!(first.is_some() && first < then, "{page}");
    }

    #[test]
    fn the_style_sheet_cannot_end_its_element() {
        let page = assemble(&site(&[("style.css", "a::before{content:'</STYLE>'}")])).unwrap();
        assert!(page.contains("content:'<\\/STYLE>'"), "{page}");
        assert_eq!(page.matches("</style>").count(), 1);
    }

    #[test]
    fn what_cannot_go_in_is_a_sentence() {
        for (name, text, sentence) in [
            (
                "index.html",
                "<p>",
                "does not hold `<script type=\"importmap\">`",
            ),
            (
                "index.html",
                "<script type=\"importmap\">{}</script>",
                "no place for style.css",
            ),
            ("style.css", "", "the site holds no style.css"),
            (
                "main.js",
                "\nimport { a } from './a.js';",
                "main.js:2 imports by a relative path",
            ),
            (
                "main.js",
                "await import(`./a.js`)",
                "main.js:1 imports by a relative path",
            ),
            (
                "main.js",
                "await import(\"../a.js\")",
                "main.js:1 imports by a relative path",
            ),
            ("other.html", "<p>", "no place for other.html"),
            ("other.css", "a {}", "no place for other.css"),
        ] {
            let error = assemble(&site(&[(name, text)])).unwrap_err().to_string();
            assert!(error.contains(sentence), "{error}");
        }
    }
}
