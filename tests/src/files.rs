//! Files of the project, as tests of its words and names read them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

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
