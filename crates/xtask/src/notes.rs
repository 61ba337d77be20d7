//! The notes for teachers beside the page: documents of the repository as pages to read.

use std::path::Path;

use anyhow::{Context, Result};
use pulldown_cmark::{Event, Options, Parser, Tag, html};

use crate::site::{read, write};

/// The folder of the repository and of the site.
pub(crate) const FOLDER: &str = "docs";

/// Those that are for readers of the page.
const NOTES: [&str; 3] = ["model", "errata", "file-format"];

const HEAD: &str = r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Assur</title>
<style>
body { max-width: 52em; margin: 0 auto; padding: 1em 1.2em 4em; font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
table { display: block; overflow-x: auto; border-collapse: collapse; }
th, td { padding: 4px 12px 4px 0; text-align: left; vertical-align: top; border-bottom: 1px solid #8888; }
pre { overflow-x: auto; }
</style>
</head>
<body>
"#;
const FOOT: &str = "</body>\n</html>\n";

/// Writes the notes into a site.
///
/// # Errors
/// A file that cannot be read or written.
pub(crate) fn publish(root: &Path, site: &Path) -> Result<()> {
    let folder = site.join(FOLDER);
    std::fs::create_dir_all(&folder)
        .with_context(|| format!("{} cannot be made", folder.display()))?;
    for name in NOTES {
        let text = read(&root.join(FOLDER).join(name).with_extension("md"))?;
        write(&folder.join(name).with_extension("html"), &page(&text))?;
    }
    Ok(())
}

/// A document as a page; what it links to of the notes is a page as well.
fn page(markdown: &str) -> String {
    let events = Parser::new_ext(markdown, Options::ENABLE_TABLES).map(|event| match event {
        Event::Start(Tag::Link {
            link_type,
            dest_url,
            title,
            id,
        }) => Event::Start(Tag::Link {
            link_type,
            dest_url: linked(&dest_url).into(),
            title,
            id,
        }),
        other => other,
    });
    let mut body = String::new();
    html::push_html(&mut body, events);
    format!("{HEAD}{body}{FOOT}")
}

fn linked(to: &str) -> String {
    let note = |name: &&str| to.strip_suffix(".md") == Some(*name);
    match NOTES.iter().find(|name| note(name)) {
        Some(name) => format!("{name}.html"),
        None => to.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_from_note_to_note() {
        let page = page("see [errata](errata.md), [code](../crates)\n\n| a |\n|---|\n| b |\n");
        assert!(page.contains("href=\"errata.html\""), "{page}");
        assert!(page.contains("href=\"../crates\""), "{page}");
        assert!(page.contains("<td>b</td>"), "{page}");
    }
}
