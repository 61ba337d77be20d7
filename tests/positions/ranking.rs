//! Solutions selected and ranked by their verdicts.

use assur::Grashof;
use assur::synthesis::four_bar::{
    Criterion, Order, Passage, Proportions, Requirement, Requirements, Solution, rank,
};

use super::draw::{Dice, task};

/// Linkages of all kinds at the same three positions, met or not.
fn drawn() -> Vec<Solution> {
    let mut dice = Dice::new(55);
    let known = dice.proportions(2.0);
    let task = loop {
        if let Some(positions) = dice.taken(&known, 3) {
            break task(&positions);
        }
    };
    let mut all: Vec<Solution> = (0..500)
        .map(|_| Solution::new(&task, dice.proportions(4.0)))
        .collect();
    all.push(Solution::new(&task, known));
    all
}

#[test]
fn each_requirement_says_what_it_asks() {
    let all = drawn();
    type Asked = (Requirements, Requirement, fn(&Solution) -> bool);
    let nothing = Requirements::default();
    let asked: [Asked; 6] = [
        (
            Requirements {
                continuous: true,
                ..nothing
            },
            Requirement::Continuous,
            |one| one.verdict.as_ref().unwrap().passage == Passage::Continuous,
        ),
        (
            Requirements {
                in_order: true,
                ..nothing
            },
            Requirement::InOrder,
            |one| one.verdict.as_ref().unwrap().order != Order::Mixed,
        ),
        (
            Requirements {
                turns: true,
                ..nothing
            },
            Requirement::Turns,
            |one| one.verdict.as_ref().unwrap().turns,
        ),
        (
            Requirements {
                grashof: Some(Grashof::CrankRocker),
                ..nothing
            },
            Requirement::Grashof,
            |one| one.verdict.as_ref().unwrap().grashof == Grashof::CrankRocker,
        ),
        (
            Requirements {
                transmission: Some(0.3),
                ..nothing
            },
            Requirement::Transmission,
            |one| one.verdict.as_ref().unwrap().transmission_between > Some(0.3),
        ),
        (
            Requirements {
                size_ratio: Some(5.0),
                ..nothing
            },
            Requirement::SizeRatio,
            |one| one.proportions.size_ratio() <= 5.0,
        ),
    ];
    let mut impossible = 0;
    for one in &all {
        if one.verdict.is_err() {
            impossible += 1;
            assert_eq!(nothing.unmet(one), [Requirement::Linkage]);
            continue;
        }
        assert!(nothing.unmet(one).is_empty());
        for (requirements, requirement, meets) in &asked {
            let expected: &[Requirement] = if meets(one) { &[] } else { &[*requirement] };
            assert_eq!(requirements.unmet(one), expected, "{one:?}");
        }
    }
    assert!(impossible > 10);
    for (requirements, ..) in &asked {
        let met = all.iter().filter(|one| requirements.unmet(one).is_empty());
        assert!(
            (3..all.len() - 3).contains(&met.count()),
            "{requirements:?}"
        );
    }
}

#[test]
fn the_best_comes_first() {
    let all = drawn();
    let requirements = Requirements {
        continuous: true,
        turns: true,
        ..Requirements::default()
    };
    type Cost = fn(&Solution) -> f64;
    let costs: [(Criterion, Cost); 4] = [
        (Criterion::Closure, Solution::worst_residual),
        (Criterion::SizeRatio, |one| one.proportions.size_ratio()),
        (Criterion::Transmission, |one| {
            let verdict = one.verdict.as_ref();
            verdict.map_or(1.0, |verdict| -verdict.transmission_between.unwrap_or(0.0))
        }),
        (Criterion::TransmissionOverall, |one| {
            one.verdict
                .as_ref()
                .map_or(1.0, |verdict| -verdict.transmission)
        }),
    ];
    for (criterion, cost) in costs {
        let mut ranked = all.clone();
        rank(&mut ranked, &requirements, criterion);
        assert_eq!(ranked.len(), all.len());
        let unmet = |one: &Solution| requirements.unmet(one).len();
        for pair in ranked.windows(2) {
            let [before, after] = [unmet(&pair[0]), unmet(&pair[1])];
            assert!(before <= after);
            assert!(
                before < after || cost(&pair[0]) <= cost(&pair[1]),
                "{criterion:?}"
            );
        }
    }
    // Among all, the one that meets the positions closes best.
    let mut ranked = all;
    rank(&mut ranked, &Requirements::default(), Criterion::Closure);
    assert!(ranked[0].worst_residual() < 1e-12);
    let Proportions { coupler, .. } = ranked[0].proportions;
    assert!((0.5..2.0).contains(&coupler));
}
