//! Names of lessons, mechanisms and kinds of document: they occur only in folders of their own, which the build finds.
//! No script of the page branches on them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use assur_tests::files::{root, scripts};

/// What stands in a folder, by the names without endings.
fn names(folder: &str, is: fn(&Path) -> bool) -> BTreeSet<String> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let stem = |path: PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    paths.filter(|path| is(path)).map(stem).collect()
}

/// The code of a line: a type may name a kind.
fn code(line: &str) -> &str {
    let line = line.trim_start();
    if line.starts_with('*') || line.starts_with("/*") || line.starts_with("//") {
        return "";
    }
    line.split(" // ").next().unwrap_or_default()
}

#[test]
fn lessons_and_mechanisms_are_named_in_their_folders_only() {
    let mut all = names("www/lessons", Path::is_dir);
    all.extend(names("www/kinds", Path::is_dir));
    all.extend(names("crates/assur-file/catalogue", Path::is_file));
    assert!(all.contains("mixer") && all.contains("linkage") && all.len() > 15);
    let mut found = Vec::new();
    for (path, script) in scripts("www") {
        let own = |name: &str| {
            let folder = format!("www/kinds/{name}/");
            // A lesson says of which kinds its documents are, and which mechanisms it shows; the search knows other names of mechanisms.
            // Forces are those of linkages.
            let of_forces = ["www/forces/", "www/force-plan/", "www/under-load/"];
            path.starts_with("www/lessons/")
                || (name == "linkage" && of_forces.iter().any(|folder| path.starts_with(folder)))
                || path.starts_with(&folder)
                || path == "www/gallery/other-names.js"
                // Several poses of a mechanism in one picture are no document.
                || (name == "poses" && path == "www/export/animation.js")
        };
        for (number, line) in (1..).zip(script.lines()) {
            for name in &all {
                let quoted = ['"', '\'', '`'].map(|mark| format!("{mark}{name}{mark}"));
                if !own(name) && quoted.iter().any(|quoted| code(line).contains(quoted)) {
                    found.push(format!("{path}:{number}: {name}"));
                }
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}
