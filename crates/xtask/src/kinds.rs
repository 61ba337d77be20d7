//! The kinds of document on the page, found by their folders: a folder of `www/kinds` with `kind.js` is
//! one. The list goes into a module that the page imports, so no script names a kind.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use serde::Deserialize;

use crate::words;

/// The module of the list, in the page.
pub(crate) const LIST: &str = "kinds/index.js";

/// What the type checker knows of it.
pub(crate) const TYPES: &str = "\
type Make = import(\"assur/app/views.js\").Make;
export const HERE: ReadonlyMap<string, Make>;
export const LATER: ReadonlyMap<string, () => Promise<{ views: Make }>>;
";

/// What a kind's folder says of it in `kind.json`, where it says anything.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Facts {
    /// Whether a first visit begins with it: it is loaded with the page then.
    first: bool,
}

/// The text of the module that lists the kinds of a folder: of those of the first view what makes
/// their views, of the others how they are loaded.
pub(crate) fn list(folder: &Path) -> Result<String> {
    let mut imports = String::new();
    let mut here = Vec::new();
    let mut later = Vec::new();
    for (id, Facts { first }) in found(folder)? {
        let script = format!("assur/kinds/{id}/kind.js");
        if first {
            let name = format!("first{}", here.len());
            imports += &format!("import {{ views as {name} }} from \"{script}\";\n");
            here.push(format!("[\"{id}\", {name}]"));
        } else {
            later.push(format!("[\"{id}\", () => import(\"{script}\")]"));
        }
    }
    Ok(format!(
        "{imports}export const HERE = new Map([{}]);\nexport const LATER = new Map([{}]);\n",
        here.join(", "),
        later.join(", ")
    ))
}

/// The kinds of a folder by their names.
fn found(folder: &Path) -> Result<Vec<(String, Facts)>> {
    let unreadable = || format!("{} cannot be read", folder.display());
    let mut kinds = Vec::new();
    for entry in fs::read_dir(folder).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        if !path.is_dir() {
            continue;
        }
        let id = path.file_name().unwrap_or_default().to_string_lossy();
        let id = id.into_owned();
        if !path.join("kind.js").exists() {
            bail!("the kind {id} has no kind.js");
        }
        let facts = path.join("kind.json");
        let facts = match fs::read_to_string(&facts) {
            Ok(text) => serde_json::from_str(&text)
                .with_context(|| format!("{} has the wrong form", facts.display()))?,
            Err(_) => Facts::default(),
        };
        kinds.push((id, facts));
    }
    kinds.sort_by(|one, other| one.0.cmp(&other.0));
    Ok(kinds)
}

/// Puts the words of the kinds, where they have any in `words.LANGUAGE.json`, into the tables of the page.
pub(crate) fn add_words(folder: &Path, tables: &Path) -> Result<()> {
    for (id, _) in found(folder)? {
        let own = fs::read_dir(folder.join(&id)).with_context(|| id.clone())?;
        for entry in own {
            let path = entry.with_context(|| id.clone())?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let Some(language) = name.strip_prefix("words.") else {
                continue;
            };
            let place = tables.join(language);
            let mut table = words::read(&place)?;
            table.extend(words::read(&path)?);
            words::write(&place, &table)?;
            fs::remove_file(&path)
                .with_context(|| format!("{} cannot be removed", path.display()))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::site::copy;

    #[test]
    fn a_folder_more_is_a_kind_more() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let place = std::env::temp_dir().join(format!("assur-kinds-{}", std::process::id()));
        let (kinds, lang) = (place.join("kinds"), place.join("lang"));
        copy(&root.join("www/kinds"), &kinds).unwrap();
        copy(&root.join("lang"), &lang).unwrap();
        let before = list(&kinds).unwrap();
        assert!(!before.contains("another"), "{before}");
        let another = kinds.join("another");
        fs::create_dir(&another).unwrap();
        fs::write(another.join("kind.js"), "").unwrap();
        fs::write(
            another.join("words.en.json"),
            r#"{"kind.another": "Another"}"#,
        )
        .unwrap();
        let after = list(&kinds).unwrap();
        add_words(&kinds, &lang).unwrap();
        let table = words::read(&lang.join("en.json")).unwrap();
        fs::remove_file(another.join("kind.js")).unwrap();
        let error = list(&kinds).unwrap_err().to_string();
        fs::remove_dir_all(&place).unwrap();

        let entry = "[\"another\", () => import(\"assur/kinds/another/kind.js\")]";
        assert!(after.contains(entry), "{after}");
        assert_eq!(table["kind.another"], "Another");
        assert!(table.contains_key("page.title"));
        assert_eq!(error, "the kind another has no kind.js");
    }
}
