//! The tables of words: how they are read and written, and what the page needs of them before any
//! script has run.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};

/// The language of the title and the first of every joined text.
const FIRST: &str = "en";

/// Texts by their keys.
pub(crate) type Table = BTreeMap<String, String>;

/// The table of words in a file.
pub(crate) fn read(path: &Path) -> Result<Table> {
    let text =
        fs::read_to_string(path).with_context(|| format!("{} cannot be read", path.display()))?;
    serde_json::from_str(&text)
        .with_context(|| format!("{} is not one flat object of texts", path.display()))
}

/// Writes a table of words into a file.
pub(crate) fn write(path: &Path, table: &Table) -> Result<()> {
    let text = serde_json::to_string(table).context("a table of words")?;
    fs::write(path, text).with_context(|| format!("{} cannot be written", path.display()))
}

/// Every language's table, by the name of its file.
pub(crate) struct Words(BTreeMap<String, Table>);

impl Words {
    pub(crate) fn load(directory: &Path) -> Result<Self> {
        let mut tables = BTreeMap::new();
        let unreadable = || {
            format!(
                "the tables of words in {} cannot be read",
                directory.display()
            )
        };
        for entry in fs::read_dir(directory).with_context(unreadable)? {
            let path = entry.with_context(unreadable)?.path();
            if path.extension().is_none_or(|ending| ending != "json") {
                continue;
            }
            let language = path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            tables.insert(language, read(&path)?);
        }
        if !tables.contains_key(FIRST) {
            bail!("{} holds no {FIRST}.json", directory.display());
        }
        Ok(Self(tables))
    }

    /// Fills the places `{{key}}` of a page. A reader whose browser runs no script has chosen no
    /// language either, so a place holds the text in all of them; only a title is short enough for
    /// just one. `{{version}}` is the version, `{{languages}}` the languages with spaces between them.
    pub(crate) fn fill(&self, page: &str, version: &str) -> Result<String> {
        let mut filled = String::with_capacity(page.len());
        let mut rest = page;
        while let Some((before, after)) = rest.split_once("{{") {
            filled.push_str(before);
            let Some((key, after)) = after.split_once("}}") else {
                bail!("the page opens a place for words by {{{{ and does not close it");
            };
            let key = key.trim();
            let text = match key {
                "version" => version.to_owned(),
                "languages" => self.languages(),
                _ if inside_title(&filled) => self.text(FIRST, key)?.to_owned(),
                _ => self.all(key)?,
            };
            filled.push_str(&escaped(&text));
            rest = after;
        }
        filled.push_str(rest);
        Ok(filled)
    }

    fn languages(&self) -> String {
        let languages: Vec<&str> = self.0.keys().map(String::as_str).collect();
        languages.join(" ")
    }

    fn text(&self, language: &str, key: &str) -> Result<&str> {
        self.0
            .get(language)
            .and_then(|table| table.get(key))
            .map(String::as_str)
            .with_context(|| {
                format!("the page asks for the words `{key}`, which {language}.json lacks")
            })
    }

    /// The text in every language, each different one once.
    fn all(&self, key: &str) -> Result<String> {
        let others = self
            .0
            .keys()
            .map(String::as_str)
            .filter(|&language| language != FIRST);
        let mut texts = Vec::new();
        for language in std::iter::once(FIRST).chain(others) {
            let text = self.text(language, key)?;
            if !texts.contains(&text) {
                texts.push(text);
            }
        }
        Ok(texts.join(" · "))
    }
}

fn inside_title(before: &str) -> bool {
    before
        .rfind("<title")
        .is_some_and(|open| !before[open..].contains("</title"))
}

/// Safe as text and inside a quoted attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words() -> Words {
        let table = |pairs: &[(&str, &str)]| {
            pairs
                .iter()
                .map(|&(key, text)| (key.to_owned(), text.to_owned()))
                .collect()
        };
        Words(BTreeMap::from([
            (
                "be".to_owned(),
                table(&[("name", "Assur"), ("wait", "чакайце"), ("odd", "?")]),
            ),
            (
                "en".to_owned(),
                table(&[("name", "Assur"), ("wait", "wait <\"&\">"), ("lone", "!")]),
            ),
            (
                "ru".to_owned(),
                table(&[("name", "Ассур"), ("wait", "подождите"), ("odd", "?")]),
            ),
        ]))
    }

    #[test]
    fn a_title_is_english_and_the_rest_is_in_every_language() {
        let filled = words().fill(
            "<title>{{name}}</title><p>{{ name }}, {{version}}, {{languages}}</p>",
            "1.2.3",
        );
        assert_eq!(
            filled.unwrap(),
            "<title>Assur</title><p>Assur · Ассур, 1.2.3, be en ru</p>"
        );
    }

    #[test]
    fn words_are_escaped() {
        let filled = words().fill("<p title=\"{{wait}}\">", "1").unwrap();
        assert_eq!(
            filled,
            "<p title=\"wait &lt;&quot;&amp;&quot;&gt; · чакайце · подождите\">"
        );
    }

    #[test]
    fn missing_words_name_key_and_language() {
        for (page, language) in [
            ("{{lone}}", "be"),
            ("{{odd}}", "en"),
            ("<title>{{odd}}", "en"),
        ] {
            let error = words().fill(page, "1").unwrap_err().to_string();
            assert!(error.contains(&format!("{language}.json lacks")), "{error}");
        }
        assert!(words().fill("<p>{{wait</p>", "1").is_err());
    }

    #[test]
    fn a_page_without_places_stays_as_it_is() {
        assert_eq!(words().fill("a } b { c {d}", "1").unwrap(), "a } b { c {d}");
    }
}
