//! Properties of random linkages of every class: a motion depends on the linkage, not on its drawing.

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

use assur_tests::{scaled, seed};
use found::Found;
use linkage::Linkage;

/// How many drawings are compared in a quick run.
const DRAWINGS: u64 = 1_000;

/// A linkage with a group that folds just before the group it depends on.
const TWO_FOLDS: u64 = 116_566;

#[test]
fn a_motion_is_the_same_however_it_is_drawn() {
    let mut found = Found::default();
    let first = seed();
    for seed in (first..first + scaled(DRAWINGS) / same::REDRAWN as u64).chain([TWO_FOLDS]) {
        let parts = Linkage::parts_of(seed);
        found.linkage(seed, parts, |subject, tally| {
            same::holds(subject, seed, tally)
        });
    }
    found.tell("redrawn");
}

/// Linkages in which outer hinges of a dyad come close to each other, or guides become parallel just before another group
/// folds, or that are drawn next to a change point or pass one and are counted by other turns than they are drawn by.
const NEAR_SINGULAR: [u64; 13] = [
    20_890, 24_937, 31_115, 40_572, 85_511, 89_143, 119_468, 169_421, 235_835, 248_127, 256_995,
    308_237, 314_643,
];

#[test]
fn rows_are_the_linkage_and_each_other() {
    let mut found = Found::default();
    let first = seed();
    for seed in (first..first + scaled(DRAWINGS) / 5).chain(NEAR_SINGULAR) {
        let parts = Linkage::parts_of(seed);
        found.linkage(seed, parts, |subject, tally| {
            rows::hold(subject, seed, tally)
        });
    }
    found.tell("rows");
}
