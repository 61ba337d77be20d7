//! The lessons of the page, found by their folders: a folder of `www/lessons` that holds `lesson.json` is
//! one. The list goes into a module that the page imports, and what lessons are called into the words of
//! the page, so no script names a lesson.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use serde::{Deserialize, Serialize};

use crate::words;

/// The module of the list, in the page.
pub(crate) const LIST: &str = "lessons/index.js";

/// What a lesson that its reader has written is called in the state.
const OWN: &str = "own";

/// What the type checker knows of it.
pub(crate) const TYPES: &str =
    "export const LESSONS: readonly import(\"assur/lesson/offer.js\").Entry[];\n";

/// What a lesson's folder says of it in `lesson.json`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Facts {
    about: Vec<String>,
    /// Where it stands among the others; those without a place come last.
    #[serde(default = "last")]
    place: u32,
}

fn last() -> u32 {
    u32::MAX
}

/// A lesson as the page finds it in the list.
#[derive(Debug, PartialEq, Serialize)]
struct Lesson {
    /// The name of its folder.
    id: String,
    /// Origins or kinds of the documents it is about.
    about: Vec<String>,
    /// Whether it has presets of its own.
    presets: bool,
    #[serde(skip)]
    place: u32,
}

/// The text of the module that lists the lessons of a folder.
pub(crate) fn list(folder: &Path) -> Result<String> {
    let lessons = serde_json::to_string(&found(folder)?).context("the list of lessons")?;
    Ok(format!("export const LESSONS = {lessons};\n"))
}

/// Of a lesson's words those that the page has before it is opened: they go into the page's own under
/// `lessons.ID.…`.
const CALLED: [&str; 2] = ["title", "line"];

/// Puts what the lessons are called into every table of words of a folder.
pub(crate) fn name(lessons: &Path, tables: &Path) -> Result<()> {
    let unreadable = || format!("{} cannot be read", tables.display());
    for entry in fs::read_dir(tables).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        let language = path.file_stem().unwrap_or_default().to_string_lossy();
        let mut page = words::read(&path)?;
        for Lesson { id, .. } in found(lessons)? {
            let own = lessons.join(&id).join(format!("words.{language}.json"));
            let own = words::read(&own)?;
            for key in CALLED {
                let text = own.get(key).with_context(|| {
                    format!("the lesson {id} has no {key} in its words of {language}")
                })?;
                page.insert(format!("lessons.{id}.{key}"), text.clone());
            }
        }
        words::write(&path, &page)?;
    }
    Ok(())
}

/// The lessons of a folder in their order.
fn found(folder: &Path) -> Result<Vec<Lesson>> {
    let unreadable = || format!("{} cannot be read", folder.display());
    let mut lessons = Vec::new();
    for entry in fs::read_dir(folder).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        if path.is_dir() {
            lessons.push(lesson(&path)?);
        }
    }
    lessons.sort_by(|one, other| (one.place, &one.id).cmp(&(other.place, &other.id)));
    Ok(lessons)
}

fn lesson(folder: &Path) -> Result<Lesson> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let id = name.into_owned();
    // The state takes no other names.
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if !id.chars().all(plain) {
        bail!("the lesson {id}: a name has small letters, digits and hyphens only");
    }
    if id == OWN {
        bail!("the lesson {id}: that is what one that is in the state is called");
    }
    for file in ["lesson.js", "words.en.json"] {
        if !folder.join(file).exists() {
            bail!("the lesson {id} has no {file}");
        }
    }
    let facts = folder.join("lesson.json");
    let text = fs::read_to_string(&facts)
        .with_context(|| format!("{} cannot be read", facts.display()))?;
    let Facts { about, place } = serde_json::from_str(&text)
        .with_context(|| format!("{} does not say what it is about", facts.display()))?;
    let presets = folder.join("presets.json").exists();
    Ok(Lesson {
        id,
        about,
        presets,
        place,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scripts::{self, Sources};
    use crate::site::copy;
    use std::io;
    use std::path::PathBuf;

    /// A copy of the lessons, in a folder that goes when the test is over.
    struct Copy(PathBuf);

    impl Copy {
        fn of_the_lessons(name: &str) -> Self {
            let place = std::env::temp_dir().join(format!("assur-{name}-{}", std::process::id()));
            copy(&root().join("www").join("lessons"), &place).unwrap();
            Self(place)
        }
    }

    impl Drop for Copy {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn root() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join("..")
    }

    /// A lesson is added by its folder alone: it is in the list, and its script in the page.
    #[test]
    fn a_folder_more_is_a_lesson_more() {
        let lessons = Copy::of_the_lessons("fixture");
        let before = found(&lessons.0).unwrap();
        let fixture = root()
            .join("tests")
            .join("data")
            .join("page")
            .join("lessons");
        copy(&fixture.join("fixture"), &lessons.0.join("fixture")).unwrap();
        let mut after = found(&lessons.0).unwrap();
        let added = after.iter().position(|lesson| lesson.id == "fixture");
        let expected = Lesson {
            id: "fixture".to_owned(),
            about: vec!["chebyshev".to_owned()],
            presets: true,
            place: last(),
        };
        assert_eq!(after.remove(added.unwrap()), expected);
        assert_eq!(after, before);

        let page = "import { LESSONS } from \"assur/lessons/index.js\";\n\
                    const load = (id) => import(`assur/lessons/${id}/lesson.js`);\n\
                    load(LESSONS[0].id);\n";
        let script = fs::read_to_string(lessons.0.join("fixture").join("lesson.js")).unwrap();
        let sources = Sources::from([
            ("app/main.js".to_owned(), page.to_owned()),
            (LIST.to_owned(), list(&lessons.0).unwrap()),
            ("lessons/fixture/lesson.js".to_owned(), script),
        ]);
        let joined = scripts::join(&sources, "app/main.js").unwrap();
        let names: Vec<_> = joined.keys().map(String::as_str).collect();
        assert_eq!(names, ["app/main.js", "lessons/fixture/lesson.js"]);
        assert!(joined["app/main.js"].contains("\"fixture\""));
        assert!(joined["lessons/fixture/lesson.js"].contains("as LESSON"));
    }

    #[test]
    fn what_lessons_are_called_is_in_the_words_of_the_page() {
        let lessons = Copy::of_the_lessons("called");
        let tables = lessons.0.join("lang");
        copy(&root().join("lang"), &tables).unwrap();
        let of_page = |lang: &str| words::read(&tables.join(format!("{lang}.json"))).unwrap();
        let before = of_page("ru").len();
        // The folder of the words is no lesson.
        let only = Copy::of_the_lessons("called-only");
        name(&only.0, &tables).unwrap();
        let after = of_page("ru");
        let own = words::read(&only.0.join("mixer").join("words.ru.json")).unwrap();
        assert_eq!(after["lessons.mixer.title"], own["title"]);
        assert_eq!(after.len(), before + 2 * found(&only.0).unwrap().len());
        fs::write(only.0.join("mixer").join("words.kk.json"), "{}").unwrap();
        let error = format!("{:#}", name(&only.0, &tables).unwrap_err());
        assert!(
            error.contains("mixer has no title in its words of kk"),
            "{error}"
        );
    }

    /// A change of a lesson's folder.
    type Spoil = fn(&Path) -> io::Result<()>;

    #[test]
    fn what_is_no_lesson_is_a_sentence() {
        let faults: [(&str, Spoil); 4] = [
            ("fixture has no lesson.js", |folder| {
                fs::remove_file(folder.join("lesson.js"))
            }),
            ("lesson.json cannot be read", |folder| {
                fs::remove_file(folder.join("lesson.json"))
            }),
            ("does not say what it is about", |folder| {
                fs::write(folder.join("lesson.json"), "{}")
            }),
            ("small letters", |folder| {
                fs::rename(folder, folder.with_file_name("Fix ture"))
            }),
        ];
        for (number, (sentence, spoil)) in faults.into_iter().enumerate() {
            let lessons = Copy::of_the_lessons(&format!("fault-{number}"));
            copy(
                &root()
                    .join("tests")
                    .join("data")
                    .join("page")
                    .join("lessons"),
                &lessons.0,
            )
            .unwrap();
            spoil(&lessons.0.join("fixture")).unwrap();
            let error = format!("{:#}", list(&lessons.0).unwrap_err());
            assert!(error.contains(sentence), "{error}");
        }
    }
}
