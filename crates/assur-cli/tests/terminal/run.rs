//! Functions that run the program, and files for it.

use std::path::PathBuf;
use std::process::{Command, Output};

pub(crate) fn assur(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_assur");
    Command::new(program).args(arguments).output().unwrap()
}

/// Runs the program, expects success, and returns standard output.
pub(crate) fn said(arguments: &[&str]) -> String {
    let output = assur(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {complaint}");
    assert_eq!(complaint, "");
    String::from_utf8(output.stdout).unwrap()
}

/// Runs the program, expects failure, and returns exit status and standard error.
pub(crate) fn refused(arguments: &[&str]) -> (i32, String) {
    let output = assur(arguments);
    assert_eq!(
        String::from_utf8(output.stdout).unwrap(),
        "",
        "{arguments:?}"
    );
    let complaint = String::from_utf8(output.stderr).unwrap();
    (output.status.code().unwrap(), complaint)
}

pub(crate) fn data(name: &str) -> String {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/data");
    data.join(name).to_str().unwrap().to_owned()
}

/// A file that is deleted when the value is dropped.
pub(crate) struct Scratch(pub PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Self {
        let name = format!("assur-cli-{}-{name}", std::process::id());
        Self(std::env::temp_dir().join(name))
    }

    pub(crate) fn with(name: &str, text: &str) -> Self {
        let file = Self::new(name);
        std::fs::write(&file.0, text).unwrap();
        file
    }

    pub(crate) fn path(&self) -> &str {
        self.0.to_str().unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

/// A table with a header. Its cells must not be quoted.
pub(crate) struct Table {
    pub(crate) header: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn of(text: &str) -> Self {
        let split = |line: &str| line.split(',').map(str::to_owned).collect();
        let mut lines = text.lines().map(split);
        let header = lines.next().unwrap();
        Self {
            header,
            rows: lines.collect(),
        }
    }

    pub(crate) fn cell(&self, row: usize, name: &str) -> &str {
        let column = self.header.iter().position(|one| one == name);
        &self.rows[row][column.unwrap_or_else(|| panic!("{name}"))]
    }

    pub(crate) fn number(&self, row: usize, name: &str) -> f64 {
        self.cell(row, name).parse().unwrap()
    }
}
