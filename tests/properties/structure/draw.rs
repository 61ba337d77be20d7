//! Linkages to decompose: built of known groups or of random pairs; and the same linkages under other names.

use std::collections::BTreeSet;

use assur::structure::{Driver, Dyad, Graph, Pair};
use proptest::prelude::*;
use proptest::sample::Index;

pub(super) type Links = BTreeSet<usize>;

/// What should come out for one step: class, order, form; 1 and 0 for drivers.
pub(super) type Kind = (usize, usize, Option<Dyad>);

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
pub(super) struct Built {
    pub(super) graph: Graph,
    pub(super) drivers: Vec<Driver>,
    pub(super) steps: Vec<(Links, Kind)>,
}

/// One choice of a part and choices of what it is joined to.
pub(super) type Choice = (Index, Vec<(Index, Index)>);

pub(super) fn choices(
    count: impl Into<proptest::collection::SizeRange>,
) -> impl Strategy<Value = Vec<Choice>> {
    let joined = (any::<Index>(), any::<Index>());
    let choice = (any::<Index>(), proptest::collection::vec(joined, 4));
    proptest::collection::vec(choice, count)
}

pub(super) fn build(choices: &[Choice]) -> Built {
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
pub(super) struct Shuffled {
    pub(super) graph: Graph,
    pub(super) drivers: Vec<Driver>,
    pub(super) links: Vec<usize>,
    pub(super) driver_was: Vec<usize>,
}

pub(super) fn shuffle(graph: &Graph, drivers: &[Driver], keys: &[u32]) -> Shuffled {
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

/// Sound or not: pairs at random, or a linkage of known groups with other
/// drivers.
pub(super) fn any_linkage() -> impl Strategy<Value = (Graph, Vec<Driver>)> {
    let graph = prop_oneof![
        2 => random_pairs(),
        1 => choices(1..3).prop_map(|choices| build(&choices).graph),
    ];
    let ends = proptest::collection::vec((any::<Index>(), any::<bool>()), 4);
    // One too few or too many now and then.
    let wrong = prop_oneof![8 => Just(0), 1 => Just(-1), 1 => Just(1_isize)];
    (graph, ends, wrong).prop_map(|(graph, ends, wrong)| {
        let drivable = |i: &usize| !matches!(graph.pairs[*i], Pair::Gear(_));
        let drivable: Vec<usize> = (0..graph.pairs.len()).filter(drivable).collect();
        let count = usize::try_from(graph.mobility() + wrong).unwrap_or_default();
        let mut drivers: Vec<Driver> = vec![];
        for (pair, end) in ends.into_iter().take(count) {
            let pair = *pair.get(&drivable);
            let joined = graph.pairs[pair].links();
            let i = usize::from(end && joined.len() > 2);
            let links = [joined[i], joined[i + 1]];
            let driver = Driver { pair, links };
            if !drivers.contains(&driver) {
                drivers.push(driver);
            }
        }
        (graph, drivers)
    })
}

/// Links joined in a tree, then pairs until the count is right.
fn random_pairs() -> impl Strategy<Value = Graph> {
    let pair = (0..10, any::<[Index; 3]>());
    let pairs = proptest::collection::vec(pair, 40);
    (2..9_usize, 1..3_isize, pairs).prop_map(|(links, mobility, pairs)| {
        let mut graph = Graph {
            links,
            ground: 0,
            pairs: vec![],
        };
        for (i, (kind, at)) in pairs.into_iter().enumerate() {
            let left = graph.mobility() - mobility;
            let tree = i + 1 < links;
            if left <= 0 && !tree {
                break;
            }
            let [a, b, c] = if tree {
                [i + 1, at[1].index(i + 1), at[1].index(i + 1)]
            } else {
                at.map(|i| i.index(links))
            };
            if a == b {
                continue;
            }
            graph.pairs.push(match kind {
                _ if !tree && left == 1 => Pair::Gear([a, b]),
                0 if !tree => Pair::Gear([a, b]),
                1..4 => Pair::Prismatic([a, b]),
                4 if left > 3 && c != a && c != b => Pair::Revolute(vec![a, b, c]),
                _ => Pair::Revolute(vec![a, b]),
            });
        }
        graph
    })
}
