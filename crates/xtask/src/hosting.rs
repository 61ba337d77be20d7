//! The page as a folder for any host of plain files, `dist/site`.
//!
//! Every file is called by the hash of what is in it, so that browsers may keep it for ever. Only the
//! import map of `index.html` says these names, because modules find each other by bare ones. A service
//! worker keeps all of it for days without a network, and a Content-Security-Policy lets nothing run
//! that is not of the page. Folders within folders work as well: no address begins at a root.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write as _;
use std::path::Path;

use anyhow::{Context, Result, bail};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};

use crate::bench::compressed;
use crate::bundle::{Files, PREFIX, collect, split_at_literal, text, with_import_map};
use crate::notes::FOLDER as NOTES;
use crate::site;
use crate::step::announce;
use crate::workspace::Workspace;

/// Files of this folder of the site are for a hosted page only.
pub(crate) const OFFLINE: &str = "offline/";

/// The element for pages of others. They name it, so it keeps its name.
pub(crate) const ELEMENT: &str = "assur-mechanism.js";

/// What the browser looks for beside the page, and the place in it for what it keeps.
const WORKER: &str = "service-worker.js";
const WORKER_PLACE: &str = "{{build}}";

/// Where files are that never change under their name: a host can say so by one rule.
const FIXED: &str = "files/";

/// The headers, in the form that several hosts read.
const HEADERS: &str = "_headers";

/// The script of the page that asks for the words before any module does.
const EARLY_WORDS: &str = "`lang/${document.documentElement.lang}.json`";

const CHARSET: &str = "<meta charset=\"utf-8\">";

/// A page in a frame of somebody else, or a browser of old, may have no workers, or forbid them.
const REGISTRATION: &str = "<script>\n    try {\n      navigator.serviceWorker.register(\"service-worker.js\").catch(() => null);\n    } catch {}\n  </script>\n</body>";

/// Writes the folder from the built site.
pub(crate) fn write(workspace: &Workspace) -> Result<()> {
    let mut built = Files::new();
    collect(&workspace.site(), "", &mut built)?;
    let files = hosted(&built)?;
    let folder = workspace.hosted();
    site::remove(&folder)?;
    let mut bytes = 0;
    for (name, content) in &files {
        put(&folder, name, content)?;
        bytes += content.len();
        if name == HEADERS {
            continue;
        }
        for (ending, packed) in [("br", compressed(content)?), ("gz", gzipped(content)?)] {
            if packed.len() < content.len() {
                put(&folder, &format!("{name}.{ending}"), &packed)?;
            }
        }
    }
    let said = format!(
        "{}, {} files, {bytes} bytes unpacked",
        folder.display(),
        files.len()
    );
    announce("folder for a host", &said);
    Ok(())
}

fn put(folder: &Path, name: &str, content: &[u8]) -> Result<()> {
    let path = folder.join(name);
    let unwritable = || format!("{} cannot be written", path.display());
    fs::create_dir_all(path.parent().unwrap_or(folder)).with_context(unwritable)?;
    fs::write(&path, content).with_context(unwritable)
}

fn gzipped(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes).context("compressing failed")?;
    packer.finish().context("compressing failed")
}

/// The files of the folder, by their names in it.
fn hosted(built: &Files) -> Result<Files> {
    let names: BTreeMap<&str, String> = built
        .iter()
        .filter(|(name, _)| {
            !name.ends_with(".html") && !name.starts_with(OFFLINE) && *name != ELEMENT
        })
        .map(|(name, content)| (name.as_str(), hashed(name, content)))
        .collect();
    let mut files = Files::new();
    for (name, fixed) in &names {
        let content = &built[*name];
        let other = files.insert(fixed.clone(), content.clone());
        if other.is_some_and(|other| other != *content) {
            bail!("{name} has the hash of another file: change any of its bytes");
        }
    }
    for (name, content) in built {
        if Path::new(name).parent() == Some(Path::new(NOTES)) || name == ELEMENT {
            files.insert(name.clone(), content.clone());
        }
    }

    let page = page(text(built, "index.html")?, &names)?;
    let build = build(&page, &files);
    let policy = policy(
        files
            .iter()
            .filter(|(name, _)| name.ends_with(".html"))
            .map(|(_, content)| String::from_utf8_lossy(content))
            .chain([page.as_str().into()]),
    );
    let metas = format!(
        "{CHARSET}\n  <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n  <meta name=\"build\" content=\"{build}\">"
    );
    let (before, after) = split_at_literal(&page, CHARSET)?;
    let page = format!("{before}{metas}{after}");

    let kept = files.keys().map(String::as_str);
    let kept: Vec<&str> = [build.as_str(), "./"].into_iter().chain(kept).collect();
    let worker = text(built, &format!("{OFFLINE}{WORKER}"))?;
    let (before, after) = split_at_literal(worker, WORKER_PLACE)?;
    let worker = format!("{before}{}{after}", kept.join(" "));

    files.insert("index.html".to_owned(), page.into());
    files.insert(WORKER.to_owned(), worker.into());
    files.insert(HEADERS.to_owned(), headers(&policy).into());
    Ok(files)
}

/// `files/01234567.js`: the import map is a part of the first download, and so has no more than it needs.
fn hashed(name: &str, content: &[u8]) -> String {
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    format!("{FIXED}{}.{ending}", hex(&Sha256::digest(content), 4))
}

fn hex(digest: &[u8], bytes: usize) -> String {
    digest
        .iter()
        .take(bytes)
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// The page with its import map, its links and its early script by the names of the folder.
fn page(built: &str, names: &BTreeMap<&str, String>) -> Result<String> {
    let relative = |fixed: &String| format!("./{fixed}");
    let imports = names
        .iter()
        .map(|(name, fixed)| (format!("{PREFIX}{name}"), relative(fixed)));
    let mut page = with_import_map(&bare(built)?, imports.collect())?;
    for (name, fixed) in names {
        page = page.replace(&format!("=\"{name}\""), &format!("=\"{fixed}\""));
    }
    let words: BTreeMap<&str, &String> = names
        .iter()
        .filter_map(|(name, fixed)| {
            Some((name.strip_prefix("lang/")?.strip_suffix(".json")?, fixed))
        })
        .collect();
    let words = serde_json::to_string(&words).context("the names of the words")?;
    let (before, after) = split_at_literal(&page, EARLY_WORDS)?;
    page = format!("{before}{words}[document.documentElement.lang]{after}");
    let (before, after) = split_at_literal(&page, "</body>")?;
    Ok(format!("{before}{REGISTRATION}{after}"))
}

/// The page without comments and indentation.
fn bare(page: &str) -> Result<String> {
    let mut said = String::with_capacity(page.len());
    let mut rest = page;
    while let Some((before, comment)) = rest.split_once("<!--") {
        said += before;
        (_, rest) = comment
            .split_once("-->")
            .context("a comment of index.html does not end")?;
    }
    said += rest;
    let lines = said.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.map(|line| format!("{line}\n")).collect())
}

/// What tells this build of the page from all others.
fn build(page: &str, files: &Files) -> String {
    let mut digest = Sha256::new();
    digest.update(page);
    for (name, content) in files {
        digest.update(name);
        digest.update(content);
    }
    hex(&digest.finalize(), 10)
}

/// Lets run what is of the page, its own inline scripts by their hashes.
fn policy<'a>(pages: impl Iterator<Item = std::borrow::Cow<'a, str>>) -> String {
    let (mut scripts, mut styles) = (BTreeSet::new(), BTreeSet::new());
    for page in pages {
        scripts.extend(inline(&page, "script").map(source));
        styles.extend(inline(&page, "style").map(source));
    }
    let listed = |sources: BTreeSet<String>| {
        sources
            .into_iter()
            .map(|one| format!(" {one}"))
            .collect::<String>()
    };
    format!(
        "default-src 'none'; base-uri 'none'; form-action 'none'; connect-src 'self'; img-src 'self' data:; \
         script-src 'self' 'wasm-unsafe-eval'{}; style-src 'self'{}; worker-src 'self'",
        listed(scripts),
        listed(styles)
    )
}

fn source(content: &str) -> String {
    format!("'sha256-{}'", STANDARD.encode(Sha256::digest(content)))
}

/// What stands in the elements of a name.
fn inline<'a>(page: &'a str, element: &'a str) -> impl Iterator<Item = &'a str> {
    let (open, close) = (format!("<{element}"), format!("</{element}>"));
    let mut parts = page.split(&open).skip(1).collect::<Vec<_>>().into_iter();
    std::iter::from_fn(move || {
        let part = parts.next()?;
        let (_, rest) = part.split_once('>')?;
        Some(
            rest.split_once(close.as_str())
                .map_or("", |(content, _)| content),
        )
    })
    .filter(|content| !content.is_empty())
}

/// Who puts the page into a frame is not asked: it is there to be embedded.
fn headers(policy: &str) -> String {
    format!(
        "/*\n  Content-Security-Policy: {policy}\n  X-Content-Type-Options: nosniff\n  Referrer-Policy: no-referrer\n  Cache-Control: no-cache\n\
         /{FIXED}*\n  ! Cache-Control\n  Cache-Control: public, max-age=31536000, immutable\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "<head><meta charset=\"utf-8\"><script type=\"importmap\">{}</script><script>1 < `lang/${document.documentElement.lang}.json`</script>\
        <link rel=\"modulepreload\" href=\"app/main.js\"></head><body></body>";

    fn site(changed: &[(&str, &str)]) -> Files {
        let given = [
            ("index.html", PAGE),
            ("app/main.js", "1"),
            ("lang/en.json", "{}"),
            ("assur-mechanism.js", "2"),
            ("docs/note.html", "<style>a {}</style>"),
            ("offline/service-worker.js", "`{{build}}`.split(` `)"),
        ];
        let all = given.iter().chain(changed);
        all.map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()))
            .collect()
    }

    fn said<'a>(files: &'a Files, name: &str) -> &'a str {
        std::str::from_utf8(&files[name]).unwrap()
    }

    #[test]
    fn only_the_page_says_names_with_hashes() {
        let files = hosted(&site(&[])).unwrap();
        let names: Vec<&str> = files.keys().map(String::as_str).collect();
        // SHA-256 of `1` and of `{}`.
        let (main, words) = ("files/6b86b273.js", "files/44136fa3.json");
        assert_eq!(
            names,
            [
                "_headers",
                "assur-mechanism.js",
                "docs/note.html",
                words,
                main,
                "index.html",
                "service-worker.js"
            ]
        );
        let page = said(&files, "index.html");
        assert!(
            page.contains(&format!("\"assur/app/main.js\":\"./{main}\"")),
            "{page}"
        );
        assert!(
            page.contains(&format!("modulepreload\" href=\"{main}\"")),
            "{page}"
        );
        assert!(
            page.contains(&format!("1 < {{\"en\":\"{words}\"}}[document")),
            "{page}"
        );
        let (_, kept) = said(&files, "service-worker.js")
            .split_once(" ./ ")
            .unwrap();
        assert_eq!(
            kept,
            format!("assur-mechanism.js docs/note.html {words} {main}`.split(` `)")
        );
    }

    #[test]
    fn what_is_inline_has_its_hash_and_nothing_else_runs() {
        let files = hosted(&site(&[])).unwrap();
        let page = said(&files, "index.html");
        let (_, policy) = page
            .split_once("Content-Security-Policy\" content=\"")
            .unwrap();
        let (policy, _) = policy.split_once('"').unwrap();
        for content in inline(page, "script") {
            assert!(policy.contains(&source(content)), "{content}");
        }
        assert_eq!(policy.matches("'sha256-").count(), 4, "{policy}");
        assert!(policy.contains(&source("a {}")), "{policy}");
        assert!(!policy.contains("'unsafe-"), "{policy}");
        assert!(said(&files, "_headers").contains(policy));
    }

    #[test]
    fn every_change_is_another_build() {
        let build = |changed: &[(&str, &str)]| {
            let files = hosted(&site(changed)).unwrap();
            let (_, rest) = said(&files, "index.html")
                .split_once("name=\"build\" content=\"")
                .unwrap();
            let build = rest.split('"').next().unwrap().to_owned();
            assert!(said(&files, "service-worker.js").contains(&format!("`{build} ./ ")));
            build
        };
        let before = build(&[]);
        assert_eq!(before, build(&[]));
        for name in ["app/main.js", "lang/en.json", "docs/note.html"] {
            assert_ne!(before, build(&[(name, "other")]), "{name}");
        }
        assert_ne!(before, build(&[("index.html", &format!("{PAGE}<p>"))]));
    }

    #[test]
    fn a_place_that_is_missing_is_a_sentence() {
        for (name, text, sentence) in [
            ("index.html", "<meta charset=\"utf-8\">", "importmap"),
            ("offline/service-worker.js", "", "{{build}}"),
        ] {
            let error = hosted(&site(&[(name, text)])).unwrap_err().to_string();
            assert!(error.contains(sentence), "{error}");
        }
    }
}
