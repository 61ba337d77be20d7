//! Makes the start data of the search for four-bars through nine points, and writes them to the file that is named.
//!
//! `cargo xtask nine-points` runs it.

use std::process::ExitCode;

use assur::synthesis::path::{CURVES, Start, checksum};

/// Seed of the generic points.
const SEED: u64 = 1923;

fn main() -> ExitCode {
    let Some(file) = std::env::args().nth(1) else {
        eprintln!("give the file to write");
        return ExitCode::from(2);
    };
    let made = Start::make(SEED, |found| println!("{found} of {CURVES} curves"));
    let Some(start) = made else {
        eprintln!("not all curves were found");
        return ExitCode::FAILURE;
    };
    let bytes = start.write();
    if let Err(error) = std::fs::write(&file, &bytes) {
        eprintln!("{file}: {error}");
        return ExitCode::FAILURE;
    }
    println!(
        "{file}: {} bytes, checksum {:016x}",
        bytes.len(),
        checksum(&bytes)
    );
    ExitCode::SUCCESS
}
