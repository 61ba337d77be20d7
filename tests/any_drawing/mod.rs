//! Properties of random linkages of every class: a motion depends on the linkage, not on its drawing.

mod condition;
mod equations;
mod found;
pub(crate) mod linkage;
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
/// folds, or that are drawn next to a change point or pass one and are counted by other turns than they are drawn by; and
/// six at which second derivatives lost digits or a fold is just avoided; and one whose motion begins at the drawn pose.
const NEAR_SINGULAR: [u64; 20] = [
    20_890, 24_937, 31_115, 40_572, 70_882, 85_511, 86_586, 89_143, 119_468, 169_421, 235_835,
    248_127, 256_995, 308_237, 314_643, 20_363_752, 20_380_473, 20_395_314, 20_420_546, 20_420_894,
];

#[test]
fn rows_are_the_linkage_and_each_other_of_even_seeds() {
    rows_are(0);
}

#[test]
fn rows_are_the_linkage_and_each_other_of_odd_seeds() {
    rows_are(1);
}

/// Checks rows of the linkages whose seeds have this remainder of division by 2. A long run has a thread for each.
fn rows_are(remainder: u64) {
    let mut found = Found::default();
    let first = seed();
    let seeds = (first..first + scaled(DRAWINGS) / 5).chain(NEAR_SINGULAR);
    for seed in seeds.filter(|seed| seed % 2 == remainder) {
        let parts = Linkage::parts_of(seed);
        found.linkage(seed, parts, |subject, tally| {
            rows::hold(subject, seed, tally)
        });
    }
    found.tell(&format!("rows-{remainder}"));
}
