//! Files of the project, as the tests of its texts and names read them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

/// The folder of the project; paths of files start there.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The text of a file.
///
/// # Panics
/// Where there is none.
pub fn source(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The presets of a lesson, by name, with what each takes from an earlier one; none where it has no such file.
///
/// # Panics
/// Where a preset is not as the page takes it.
pub fn presets(lesson: &Path) -> BTreeMap<String, Value> {
    let Ok(text) = fs::read_to_string(lesson.join("presets.json")) else {
        return BTreeMap::new();
    };
    let own: BTreeMap<String, Value> =
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{lesson:?}: {error}"));
    (own.keys())
        .map(|name| (name.clone(), whole(&own, name)))
        .collect()
}

/// Kind and document of a preset.
fn whole(own: &BTreeMap<String, Value>, name: &str) -> Value {
    let preset = &own[name];
    let Some(from) = preset["from"].as_str() else {
        return preset.clone();
    };
    let base = whole(own, from);
    let mut document = base["document"].as_object().unwrap().clone();
    document.extend(preset["document"].as_object().unwrap().clone());
    json!({ "kind": base["kind"], "document": document })
}

/// The document of a preset of a lesson, where it has one of that name.
pub fn preset(lesson: &str, name: &str) -> Option<Value> {
    let folder = root().join("www/lessons").join(lesson);
    Some(presets(&folder).remove(name)?["document"].take())
}

/// The texts of the files of a folder, in the order of their names.
///
/// # Panics
/// Where one cannot be read.
pub fn texts(folder: &str) -> Vec<String> {
    let files = fs::read_dir(root().join(folder)).unwrap();
    let mut files: Vec<_> = files.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let texts = files.into_iter().map(fs::read_to_string);
    texts.map(Result::unwrap).collect()
}

/// The scripts of a folder and of those in it, by their paths; their tests aside.
///
/// # Panics
/// Where one cannot be read.
pub fn scripts(folder: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(root().join(folder)).unwrap() {
        let entry = entry.unwrap();
        let path = format!("{folder}/{}", entry.file_name().into_string().unwrap());
        if entry.path().is_dir() {
            found.extend(scripts(&path));
        } else if path.ends_with(".js") && !path.ends_with(".test.js") {
            found.insert(path.clone(), source(&path));
        }
    }
    found
}
