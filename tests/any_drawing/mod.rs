//! A motion is the linkage's, not the drawing's: properties of random linkages of every class.

mod condition;
mod equations;
mod found;
mod linkage;
mod places;
mod redrawn;
mod rows;
mod same;
mod shown;
mod subject;
mod way;

use assur_tests::scaled;
use found::Found;
use linkage::Linkage;

/// How many drawings are compared in a quick run.
const DRAWINGS: u64 = 1_000;

/// From which seed on, to look at one again.
fn first() -> u64 {
    let asked = std::env::var("ASSUR_SEED").ok();
    asked.map_or(0, |seed| seed.parse().unwrap())
}

#[test]
fn a_motion_is_the_same_however_it_is_drawn() {
    let mut found = Found::default();
    let mut compared = 0;
    let mut seed = first();
    while compared < scaled(DRAWINGS) {
        let parts = Linkage::parts_of(seed);
        found.linkage(seed, parts, |subject, tally| {
            same::holds(subject, seed, tally)
        });
        compared += same::REDRAWN as u64;
        seed += 1;
    }
    found.tell("redrawn");
}

#[test]
fn rows_are_the_linkage_and_each_other() {
    let mut found = Found::default();
    for seed in first()..first() + scaled(DRAWINGS) / 5 {
        let parts = Linkage::parts_of(seed);
        found.linkage(seed, parts, |subject, tally| {
            rows::hold(subject, seed, tally)
        });
    }
    found.tell("rows");
}
