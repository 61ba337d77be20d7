//! Tags with attributes, as Linkage writes and reads them. Quoted texts are verbatim, without entities, and attributes
//! may follow each other without a space. A strict XML parser would refuse files that Linkage opens.

use crate::ImportProblem;

/// Maximum nesting depth of tags; no Linkage file exceeds it.
const DEEPEST: usize = 8;

/// A tag with its contents.
#[derive(Debug, Default)]
pub(super) struct Tag<'a> {
    pub(super) name: &'a str,
    attributes: Vec<(&'a str, &'a str)>,
    pub(super) tags: Vec<Tag<'a>>,
}

impl<'a> Tag<'a> {
    /// Text of an attribute; empty if the attribute is absent.
    pub(super) fn text(&self, name: &str) -> &'a str {
        let found = self.attributes.iter().find(|(key, _)| *key == name);
        found.map_or("", |(_, value)| value)
    }

    pub(super) fn is(&self, name: &str) -> bool {
        self.text(name) == "true"
    }

    /// Value of an attribute as a number; none if the attribute is absent or empty.
    ///
    /// # Errors
    /// A value that is not a number.
    pub(super) fn number(&self, name: &str) -> Result<Option<f64>, ImportProblem> {
        self.value(name, crate::number)
    }

    /// Value of an attribute as a whole number; none if the attribute is absent or empty.
    ///
    /// # Errors
    /// A value that is not a whole number.
    pub(super) fn whole(&self, name: &str) -> Result<Option<i64>, ImportProblem> {
        self.value(name, |text| text.parse().ok())
    }

    fn value<T>(
        &self,
        name: &str,
        read: impl Fn(&str) -> Option<T>,
    ) -> Result<Option<T>, ImportProblem> {
        let text = self.text(name).trim();
        if text.is_empty() {
            return Ok(None);
        }
        match read(text) {
            None => Err(self.refused(name)),
            value => Ok(value),
        }
    }

    /// Problem that reports an invalid value of an attribute.
    pub(super) fn refused(&self, name: &str) -> ImportProblem {
        let [tag, id] = [self.name, self.text("id")].map(crate::quoted);
        ImportProblem::number(&format!("{tag} {id}, {name}"), self.text(name))
    }

    /// Number of tags nested inside the direct inner tags, at any depth.
    pub(super) fn mentions(&self) -> usize {
        let inner = self.tags.iter();
        inner.map(|tag| tag.tags.len() + tag.mentions()).sum()
    }

    /// The direct inner tags with this name.
    pub(super) fn all<'t>(&'t self, name: &'t str) -> impl Iterator<Item = &'t Tag<'a>> {
        self.tags.iter().filter(move |tag| tag.name == name)
    }
}

/// Parses a text and returns its outermost tag.
///
/// # Errors
/// The line of the first tag that is malformed, does not end or is out of place.
pub(super) fn parse(text: &str) -> Result<Tag<'_>, ImportProblem> {
    let broken = |rest: &str| {
        let line = 1 + text[..text.len() - rest.len()].matches('\n').count();
        ImportProblem::MarkupBroken { line }
    };
    let mut open: Vec<Tag<'_>> = Vec::new();
    let mut rest = text;
    loop {
        let Some(at) = rest.find('<') else {
            return Err(broken(&rest[rest.len()..]));
        };
        rest = &rest[at + 1..];
        let here = rest;
        let skipped = match rest.as_bytes().first() {
            Some(b'?') => Some("?>"),
            Some(b'!') if rest.starts_with("!--") => Some("-->"),
            // Declarations are refused: they could define entities, and no Linkage file contains any.
            Some(b'!') | None => return Err(broken(here)),
            _ => None,
        };
        if let Some(end) = skipped {
            rest = rest.split_once(end).ok_or_else(|| broken(here))?.1;
            continue;
        }
        let (inner, after) = tag(rest).ok_or_else(|| broken(here))?;
        rest = after;
        let done = if let Some(name) = inner.strip_prefix('/') {
            let tag = open.pop().filter(|tag| tag.name == name.trim());
            Some(tag.ok_or_else(|| broken(here))?)
        } else {
            let (inner, empty) = match inner.strip_suffix('/') {
                Some(inner) => (inner, true),
                None => (inner, false),
            };
            let tag = attributes(inner).ok_or_else(|| broken(here))?;
            if empty {
                Some(tag)
            } else {
                open.push(tag);
                None
            }
        };
        if open.len() > DEEPEST {
            return Err(broken(here));
        }
        if let Some(tag) = done {
            match open.last_mut() {
                Some(parent) => parent.tags.push(tag),
                None => return Ok(tag),
            }
        }
    }
}

/// Contents of a tag, up to the first `>` outside quotes, and the text after the tag.
fn tag(text: &str) -> Option<(&str, &str)> {
    let mut quoted = false;
    let end = text.find(|c| {
        quoted ^= c == '"';
        c == '>' && !quoted
    })?;
    Some((&text[..end], &text[end + 1..]))
}

/// Parses the contents of a tag: its name, then any number of attributes `key="value"`.
fn attributes(text: &str) -> Option<Tag<'_>> {
    let text = text.trim_end();
    let end = text.find(char::is_whitespace).unwrap_or(text.len());
    let (name, mut rest) = text.split_at(end);
    let plain = |text: &str| {
        !text.is_empty()
            && text
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || "_-".contains(c))
    };
    let mut tag = Tag {
        name: plain(name).then_some(name)?,
        ..Tag::default()
    };
    loop {
        rest = rest.trim_start();
        if rest.is_empty() {
            return Some(tag);
        }
        let (key, after) = rest.split_once('=')?;
        let (value, after) = after.trim_start().strip_prefix('"')?.split_once('"')?;
        tag.attributes
            .push((Some(key.trim_end()).filter(|key| plain(key))?, value));
        rest = after;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_read_as_linkage_writes_them() {
        let text = "<?xml version=\"1.0\"?>\n<!-- <a> -->\n<a b=\"1\"c=\"x > & y\">\n <d id=\"-2\"/><e>\n</e></a>";
        let tag = parse(text).unwrap();
        assert_eq!(
            (tag.name, tag.text("b"), tag.text("c")),
            ("a", "1", "x > & y")
        );
        assert_eq!(
            tag.tags.iter().map(|tag| tag.name).collect::<Vec<_>>(),
            ["d", "e"]
        );
        assert_eq!(tag.tags[0].whole("id").unwrap(), Some(-2));
        assert!(tag.number("c").is_err());
    }

    #[test]
    fn what_is_broken_is_told_by_its_line() {
        for (bad, line) in [
            ("<a>", 1),
            ("<a>\n<b></a>", 2),
            ("<a>\n\n<b c=\"", 3),
            ("<a b=1/>", 1),
            ("<!DOCTYPE a [<!ENTITY b \"bbb\">]><a/>", 1),
            ("<a><a><a><a><a><a><a><a><a><a>", 1),
            ("", 1),
        ] {
            let problem = parse(bad).unwrap_err();
            assert_eq!(problem, ImportProblem::MarkupBroken { line }, "{bad}");
        }
    }
}
