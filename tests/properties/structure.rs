//! Properties of the structure of every linkage. A linkage built of known groups decomposes into them, under any names
//! and in any order. A linkage decomposes if and only if its Jacobian, for random dimensions, can be inverted. The
//! groups are the smallest possible.

mod draw;
mod oracle;

use std::collections::BTreeMap;

use assur::structure::{Fault, Graph, Group, Pair, Step, Structure, decompose};
use assur_tests::scaled;
use proptest::prelude::*;

use super::draw::config;
use draw::{Built, Kind, Links, Shuffled, any_linkage, build, choices, shuffle};

fn group_kind(group: &Group) -> Kind {
    (group.class, group.order(), group.dyad)
}

/// The links of each step and what it is. For a driver, the link it adds.
fn found(structure: &Structure) -> BTreeMap<Links, Kind> {
    let steps = structure.steps.iter().map(|step| match step {
        Step::Driver { links, .. } => (Links::from([links[1]]), (1, 0, None)),
        Step::Group(group) => (group.links().into_iter().collect(), group_kind(group)),
    });
    steps.collect()
}

/// The links of each step, drivers within a group left to it.
fn blocks(structure: &Structure) -> Vec<Links> {
    let mut blocks = BTreeMap::<usize, Links>::new();
    for (link, step) in structure.step_of.iter().enumerate() {
        if let Some(step) = step {
            blocks.entry(*step).or_default().insert(link);
        }
    }
    let mut blocks: Vec<Links> = blocks.into_values().collect();
    blocks.sort();
    blocks
}

fn check_counts(graph: &Graph, structure: &Structure) {
    for (i, step) in structure.steps.iter().enumerate() {
        let Step::Group(group) = step else { continue };
        let gear = |pair: &usize| usize::from(matches!(graph.pairs[*pair], Pair::Gear(_)));
        let outer = group.outer.iter().map(|outer| outer.pair);
        let pairs: Vec<usize> = group.inner.iter().copied().chain(outer).collect();
        let higher: usize = pairs.iter().map(gear).sum();
        let lower = pairs.len() - higher;
        assert_eq!(3 * group.bodies.len(), 2 * lower + higher);
        for outer in &group.outer {
            let joined = graph.pairs[outer.pair].links();
            assert!(joined.contains(&outer.link) && joined.contains(&outer.base));
            assert!(group.links().contains(&outer.link));
            assert!(structure.step_of[outer.base].is_none_or(|step| step < i));
        }
        for link in group.links() {
            assert_eq!(structure.step_of[link], Some(i));
        }
    }
}

proptest! {
    #![proptest_config(config(scaled(400)))]

    #[test]
    fn what_is_built_comes_apart(choices in choices(1..12)) {
        let built = build(&choices);
        let structure = decompose(&built.graph, &built.drivers).unwrap();
        prop_assert_eq!(built.graph.mobility(), built.drivers.len() as isize);
        prop_assert_eq!(found(&structure), built.steps.into_iter().collect());
        check_counts(&built.graph, &structure);
    }

    #[test]
    fn names_and_order_do_not_matter(
        choices in choices(1..10),
        keys in proptest::collection::vec(any::<u32>(), 50),
    ) {
        let Built { graph, drivers, .. } = build(&choices);
        let structure = decompose(&graph, &drivers).unwrap();
        let other = shuffle(&graph, &drivers, &keys);
        let shuffled = decompose(&other.graph, &other.drivers).unwrap();
        check_counts(&other.graph, &shuffled);
        let renamed = found(&structure).into_iter().map(|(links, kind)| {
            (links.into_iter().map(|link| other.links[link]).collect(), kind)
        });
        prop_assert_eq!(found(&shuffled), renamed.collect());
    }

    #[test]
    fn a_linkage_comes_apart_where_its_jacobian_is_regular(
        (graph, drivers) in any_linkage(),
        seed in any::<u64>(),
    ) {
        let regular = oracle::regular(&graph, &drivers, seed);
        prop_assert_eq!(decompose(&graph, &drivers).is_ok(), regular && !drivers.is_empty());
    }

    #[test]
    fn groups_are_the_smallest((graph, drivers) in any_linkage()) {
        prop_assume!(graph.links < 11); // for the sake of time
        if let Ok(structure) = decompose(&graph, &drivers) {
            let groups: Vec<Links> = blocks(&structure);
            prop_assert_eq!(groups, oracle::smallest_groups(&graph, &drivers));
        }
    }

    #[test]
    fn nor_do_they_for_faults(
        (graph, drivers) in any_linkage(),
        keys in proptest::collection::vec(any::<u32>(), 50),
    ) {
        let other = shuffle(&graph, &drivers, &keys);
        let shuffled = decompose(&other.graph, &other.drivers).err().unwrap_or_default();
        let faults = decompose(&graph, &drivers).err().unwrap_or_default();
        let mut faults: Vec<Fault> = faults.into_iter().map(|fault| rename(fault, &other)).collect();
        let mut shuffled: Vec<Fault> = shuffled.into_iter().map(sorted).collect();
        faults.sort_by_key(ToString::to_string);
        shuffled.sort_by_key(ToString::to_string);
        prop_assert_eq!(shuffled, faults);
    }
}

fn sorted(mut fault: Fault) -> Fault {
    match &mut fault {
        Fault::Apart { links }
        | Fault::Undriven { links, .. }
        | Fault::Sliding { links }
        | Fault::Rigid { links } => {
            links.sort_unstable();
        }
        Fault::Overconstrained { links, drivers, .. } => {
            links.sort_unstable();
            drivers.sort_unstable();
        }
        _ => {}
    }
    fault
}

fn rename(mut fault: Fault, to: &Shuffled) -> Fault {
    let rename = |links: &mut Vec<usize>| links.iter_mut().for_each(|link| *link = to.links[*link]);
    match &mut fault {
        Fault::Apart { links }
        | Fault::Undriven { links, .. }
        | Fault::Sliding { links }
        | Fault::Rigid { links } => {
            rename(links);
        }
        Fault::Overconstrained { links, drivers, .. } => {
            rename(links);
            for driver in drivers {
                *driver = to.driver_was.iter().position(|was| was == driver).unwrap();
            }
        }
        _ => {}
    }
    sorted(fault)
}
