//! What holds of the structure of every linkage: linkages built of known groups
//! come apart into them, under any names and in any order; a linkage comes
//! apart exactly where its Jacobian, with random dimensions, can be inverted;
//! the groups are the smallest there are.

use std::collections::{BTreeMap, BTreeSet};

use assur::structure::{Driver, Dyad, Fault, Graph, Group, Pair, Step, Structure, decompose};
use proptest::prelude::*;
use proptest::sample::Index;

use crate::draw::config;

type Links = BTreeSet<usize>;

/// What should come out for one step: class, order, form; 1 and 0 for drivers.
type Kind = (usize, usize, Option<Dyad>);

/// A group to add: its own links from 0, pairs within, links with an outer
/// hinge, with an outer slider, with a mesh; and what it is.
struct Part {
    links: usize,
    inner: Vec<Pair>,
    hinged: &'static [usize],
    slides: &'static [usize],
    meshes: &'static [usize],
    kind: Kind,
}

fn hinges(hinges: &[&[usize]]) -> Vec<Pair> {
    let hinges = hinges.iter().map(|links| Pair::Revolute(links.to_vec()));
    hinges.collect()
}

#[rustfmt::skip]
fn parts() -> Vec<Part> {
    let part = |links, inner, hinged, slides, meshes, kind| Part { links, inner, hinged, slides, meshes, kind };
    let dyad = |dyad| (2, 2, Some(dyad));
    let slider = || vec![Pair::Prismatic([0, 1])];
    vec![
        part(2, hinges(&[&[0, 1]]), &[0, 1], &[], &[], dyad(Dyad::RRR)),
        part(2, hinges(&[&[0, 1]]), &[0], &[1], &[], dyad(Dyad::RRP)),
        part(2, slider(), &[0, 1], &[], &[], dyad(Dyad::RPR)),
        part(2, hinges(&[&[0, 1]]), &[], &[0, 1], &[], dyad(Dyad::PRP)),
        part(2, slider(), &[0], &[1], &[], dyad(Dyad::RPP)),
        // Geared wheel; satellite and carrier between two wheels; rack.
        part(1, vec![], &[0], &[], &[0], (2, 2, None)),
        part(2, hinges(&[&[0, 1]]), &[0], &[], &[1, 1], (3, 3, None)),
        part(1, vec![], &[], &[0], &[0], (2, 2, None)),
        part(4, hinges(&[&[0, 1], &[0, 2], &[0, 3]]), &[1, 2, 3], &[], &[], (3, 3, None)),
        part(4, hinges(&[&[0, 1], &[0, 2], &[0, 3]]), &[1, 2], &[3], &[], (3, 3, None)),
        part(6, hinges(&[&[0, 1], &[0, 2], &[0, 3], &[1, 4], &[1, 5]]), &[2, 3, 4, 5], &[], &[], (3, 4, None)),
        // A base link of three bars.
        part(6, hinges(&[&[0, 1, 3], &[1, 2, 4], &[2, 0, 5]]), &[3, 4, 5], &[], &[], (3, 3, None)),
        part(4, hinges(&[&[0, 1], &[1, 2], &[2, 3], &[3, 0]]), &[0, 2], &[], &[], (4, 2, None)),
        part(6, hinges(&[&[0, 1], &[1, 2], &[2, 3], &[3, 0], &[0, 4], &[2, 5]]), &[4, 1, 5], &[], &[], (4, 3, None)),
        part(8, hinges(&[&[0, 1, 4], &[1, 2, 5], &[2, 3, 6], &[3, 0, 7]]), &[4, 5, 6, 7], &[], &[], (4, 4, None)),
        part(6, hinges(&[&[0, 1], &[1, 2], &[2, 3], &[3, 4], &[4, 0], &[4, 5]]), &[0, 2, 5], &[], &[], (5, 3, None)),
        part(6, hinges(&[&[0, 2], &[2, 1], &[0, 3], &[3, 1], &[0, 4], &[4, 5], &[5, 1]]), &[2, 4], &[], &[], (5, 2, None)),
        part(6, hinges(&[&[0, 1], &[1, 2], &[2, 3], &[3, 4], &[4, 5], &[5, 0]]), &[0, 2, 4], &[], &[], (6, 3, None)),
    ]
}

/// A linkage with what it is built of.
#[derive(Clone, Debug)]
struct Built {
    graph: Graph,
    drivers: Vec<Driver>,
    steps: Vec<(Links, Kind)>,
}

/// One choice of a part and choices of what it is joined to.
type Choice = (Index, Vec<(Index, Index)>);

fn choices(
    count: impl Into<proptest::collection::SizeRange>,
) -> impl Strategy<Value = Vec<Choice>> {
    let joined = (any::<Index>(), any::<Index>());
    let choice = (any::<Index>(), proptest::collection::vec(joined, 4));
    proptest::collection::vec(choice, count)
}

fn build(choices: &[Choice]) -> Built {
    let parts = parts();
    let mut built = Built {
        graph: Graph {
            links: 2,
            ground: 0,
            pairs: hinges(&[&[0, 1]]),
        },
        drivers: vec![Driver {
            pair: 0,
            links: [0, 1],
        }],
        steps: vec![(Links::from([1]), (1, 0, None))],
    };
    for (which, joined) in choices {
        let Built {
            graph,
            drivers,
            steps,
        } = &mut built;
        let first = graph.links;
        let mut joined = joined.iter();
        let mut base = || joined.next().map_or(0, |(link, _)| link.index(first));
        let which = which.index(parts.len() + 1);
        let Some(part) = parts.get(which) else {
            // A further driver, on any link.
            let links = [base(), first];
            drivers.push(Driver {
                pair: graph.pairs.len(),
                links,
            });
            graph.pairs.push(Pair::Revolute(links.to_vec()));
            graph.links += 1;
            steps.push((Links::from([first]), (1, 0, None)));
            continue;
        };
        let own = graph.pairs.len();
        let mut used = vec![];
        for (&link, (index, (at, reuse))) in part.hinged.iter().zip(joined.clone().enumerate()) {
            let hinge = reuse.index(2 * own);
            let base = at.index(first);
            match graph.pairs.get_mut(hinge) {
                // A hinge that is there becomes a compound one, at most once,
                Some(Pair::Revolute(links))
                    if hinge < own && !used.contains(&hinge) && index < 2 =>
                {
                    used.push(hinge);
                    links.push(first + link);
                }
                // or else there is a new one.
                _ => graph.pairs.push(Pair::Revolute(vec![base, first + link])),
            }
        }
        let mut base = {
            let mut rest = joined.rev();
            move || rest.next().map_or(0, |(link, _)| link.index(first))
        };
        for &link in part.slides {
            graph.pairs.push(Pair::Prismatic([base(), first + link]));
        }
        for &link in part.meshes {
            graph.pairs.push(Pair::Gear([base(), first + link]));
        }
        for pair in &part.inner {
            graph.pairs.push(renamed(pair, |link| link + first));
        }
        graph.links += part.links;
        steps.push(((first..graph.links).collect(), part.kind));
    }
    built
}

fn renamed(pair: &Pair, name: impl Fn(usize) -> usize) -> Pair {
    match pair {
        Pair::Revolute(links) => Pair::Revolute(links.iter().map(|&link| name(link)).collect()),
        Pair::Prismatic(links) => Pair::Prismatic(links.map(name)),
        Pair::Gear(links) => Pair::Gear(links.map(name)),
    }
}

/// The same linkage with links, pairs and drivers renamed and reordered.
struct Shuffled {
    graph: Graph,
    drivers: Vec<Driver>,
    links: Vec<usize>,
    driver_was: Vec<usize>,
}

fn shuffle(graph: &Graph, drivers: &[Driver], keys: &[u32]) -> Shuffled {
    let order = |count: usize, salt: u32| {
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|&i| {
            keys[i % keys.len()]
                .rotate_left(salt + i as u32 / 7)
                .wrapping_mul(2_654_435_761)
        });
        order
    };
    let links = order(graph.links, 3);
    let pair_was = order(graph.pairs.len(), 11);
    let driver_was = order(drivers.len(), 17);
    let pairs = pair_was.iter().map(|&was| {
        let mut pair = renamed(&graph.pairs[was], |link| links[link]);
        match &mut pair {
            Pair::Revolute(links) => links.sort_by_key(|&link| keys[link % keys.len()]),
            Pair::Prismatic(links) | Pair::Gear(links) => links.reverse(),
        }
        pair
    });
    let pair_is = |was| pair_was.iter().position(|&pair| pair == was);
    let driver = |was: &usize| Driver {
        pair: pair_is(drivers[*was].pair).unwrap(),
        links: drivers[*was].links.map(|link| links[link]),
    };
    Shuffled {
        graph: Graph {
            links: graph.links,
            ground: links[graph.ground],
            pairs: pairs.collect(),
        },
        drivers: driver_was.iter().map(driver).collect(),
        links,
        driver_was,
    }
}

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
    #![proptest_config(config(2_000))]

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

    /// The second set of drivers makes most of these linkages faulty.
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
        Fault::Apart { links } | Fault::Undriven { links, .. } | Fault::Sliding { links } => {
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
        Fault::Apart { links } | Fault::Undriven { links, .. } | Fault::Sliding { links } => {
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

/// Up to seven links, pairs at random until they are as many as the count asks
/// for, sound or not.
fn any_linkage() -> impl Strategy<Value = (Graph, Vec<Driver>)> {
    let pair = (0..10, any::<[Index; 3]>());
    let driver = (any::<Index>(), any::<bool>());
    (
        2..8_usize,
        1..3_isize,
        proptest::collection::vec(pair, 30),
        proptest::collection::vec(driver, 0..4),
    )
        .prop_map(|(links, mobility, pairs, moved)| {
            let mut graph = Graph {
                links,
                ground: 0,
                pairs: vec![],
            };
            for (kind, at) in pairs {
                if graph.mobility() <= mobility {
                    break;
                }
                let mut at = at.map(|i| i.index(links)).to_vec();
                at.dedup();
                if at.len() == 3 && at[0] == at[2] {
                    at.pop();
                }
                graph.pairs.push(match (kind, at.as_slice()) {
                    (_, [_]) => continue,
                    (0..2, &[a, b, ..]) => Pair::Prismatic([a, b]),
                    (2, &[a, b, ..]) => Pair::Gear([a, b]),
                    (3.., &[_, _, _]) => Pair::Revolute(at),
                    (_, &[a, b, ..]) => Pair::Revolute(vec![a, b]),
                    _ => continue,
                });
            }
            let lower: Vec<usize> = (0..graph.pairs.len())
                .filter(|&i| !matches!(graph.pairs[i], Pair::Gear(_)))
                .collect();
            let mut drivers: Vec<Driver> = vec![];
            for (pair, end) in moved {
                if !lower.is_empty() {
                    let pair = *pair.get(&lower);
                    let joined = graph.pairs[pair].links();
                    let i = usize::from(end && joined.len() > 2);
                    let driver = Driver {
                        pair,
                        links: [joined[i], joined[i + 1]],
                    };
                    if !drivers.contains(&driver) {
                        drivers.push(driver);
                    }
                }
            }
            (graph, drivers)
        })
}
