//! Damaged files and arguments: the exit status is 0, 1 or 2, with a sentence unless it is 0; no panic, no hang.

use std::env::temp_dir;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use assur_tests::damage::{Dice, damaged, outcome};
use assur_tests::files::texts;
use assur_tests::{scaled, seed};

/// Number of runs of the program for each test target in a quick run.
const QUICK: usize = 60;

/// An empty folder for the files that the program writes; deleted when the value is dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = temp_dir().join(format!("assur-cli-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Runs the program in a folder and returns whether it accepted its arguments.
fn accepts((folder, arguments): (PathBuf, Vec<String>)) -> bool {
    let mut program = Command::new(env!("CARGO_BIN_EXE_assur"));
    let output = program.args(&arguments).current_dir(folder).output();
    let output = output.unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    let status = output.status.code();
    assert!(
        matches!(status, Some(0..=2)),
        "{status:?} {arguments:?}: {said}"
    );
    assert!(
        status == Some(0) || !said.trim().is_empty(),
        "{arguments:?}"
    );
    status == Some(0)
}

fn words(line: &str) -> Vec<String> {
    line.split(' ').map(str::to_owned).collect()
}

/// Damages a text and returns its bytes. One file in four gets a random byte, which may make it invalid UTF-8.
fn bytes(text: &str, dice: &mut Dice) -> Vec<u8> {
    let mut bytes = damaged(text, dice).into_bytes();
    if dice.below(4) == 0 {
        let at = dice.below(bytes.len());
        bytes[at] = dice.below(256) as u8;
    }
    bytes
}

#[test]
fn damaged_files_end_with_a_status() {
    const COMMANDS: [&str; 6] = [
        "structure FILE --json",
        "sweep FILE --step 45",
        "assemblies FILE",
        "mobility FILE",
        "plot FILE --svg -",
        "synth --frame 10 --function FILE --input 0,90 --output 10,80",
    ];
    let folder = Folder::new("files");
    let mut dice = Dice::new(seed());
    let tables = ["1,0.5\n2 3\n4;7\n", "0\t0\n1\t1\n\n2\t4\n3\t9\n"].map(str::to_owned);
    let published = texts("crates/assur-import/tests/published/linkage2");
    let ours = ["crates/assur-file/catalogue", "tests/data/linkages"];
    let ours: Vec<String> = ours.into_iter().flat_map(texts).chain(published).collect();
    let mut accepted = 0;
    for at in 0..scaled(QUICK) {
        let command = COMMANDS[at % COMMANDS.len()];
        let corpus = if command.contains("--function") {
            &tables[..]
        } else {
            &ours
        };
        let text = &corpus[dice.below(corpus.len())];
        fs::write(folder.0.join("FILE"), bytes(text, &mut dice)).unwrap();
        accepted += usize::from(outcome((folder.0.clone(), words(command)), accepts));
    }
    println!("{accepted} are accepted");
    assert!(accepted > 0, "{accepted}");
}

#[test]
fn damaged_arguments_end_with_a_status() {
    const LINES: [&str; 10] = [
        "sweep jansen --from 10.5 --to 70 --step 7.5 --omega 2 --degrees",
        "structure watt-1 --json",
        "assemblies class3-platform --at 30",
        "circuits whitworth",
        "mobility mobility-1a",
        "differential --z1 24 --z4 60 --w1 100 --w4 -20 --satellites 3",
        "plot mixer-a --svg -",
        "synth --frame 10 --position 240,45 --position 253,60",
        "synth --frame 10 --function log10 --x 1,2 --input 90,150 --output 210,270 --positions 3",
        "structure https://designengrlab.github.io/PMKS/pmks.html?mech=ground,crank,R,0,0,0,tfft|crank,rod,R,25,0,0,tfff|rod,rocker,R,30,38,0,tfff|rocker,ground,R,50,0,0,tfff|",
    ];
    let folder = Folder::new("arguments");
    // Undamaged, all command lines are accepted.
    for line in LINES {
        assert!(outcome((folder.0.clone(), words(line)), accepts), "{line}");
    }
    let mut dice = Dice::new(seed());
    for line in LINES.iter().cycle().take(scaled(QUICK)) {
        // The operating system passes no argument that contains a zero byte.
        let line = damaged(line, &mut dice).replace('\0', "");
        outcome((folder.0.clone(), words(&line)), accepts);
    }
}
