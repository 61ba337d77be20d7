//! Checks if a graph with its drivers can be decomposed.

use super::pebbles::{BODY, Pebbles, Surplus};
use super::{Driver, Fault, Graph, Pair};
use crate::numeric::graph::Partition;

/// Counts the freedoms of a graph with its drivers fixed. Returns the pebbles, three of them free on the ground, and
/// the parts with surplus constraints.
///
/// # Errors
/// All faults of single pairs and drivers or, if there are none, all faults of the count. Surplus constraints are a
/// fault only if they are not allowed.
pub(super) fn check(
    graph: &Graph,
    drivers: &[Driver],
    surplus_allowed: bool,
) -> Result<(Pebbles, Vec<Surplus>), Vec<Fault>> {
    let faults = [pairs(graph), driven(graph, drivers)].concat();
    if !faults.is_empty() {
        return Err(faults);
    }
    let (mut pebbles, surplus) = Pebbles::count(graph, drivers, |_| true);

    let mut faults = vec![];
    let (with_ground, joined) = joined_to_ground(graph);
    let apart = (0..graph.links).filter(|&link| !with_ground[link]);
    let apart: Vec<usize> = apart.collect();
    let whole = apart.is_empty();
    if !whole {
        faults.push(Fault::Apart { links: apart });
    }
    pebbles.gather(&[graph.ground], BODY);
    let undriven = (0..graph.links).filter(|&link| {
        link != graph.ground && with_ground[link] && pebbles.moves(link, graph.ground)
    });
    let undriven: Vec<usize> = undriven.collect();
    if drivers.is_empty() {
        let links: Vec<usize> = (0..graph.links)
            .filter(|&link| link != graph.ground && with_ground[link])
            .collect();
        // If all links are locked, no driver is missing: the links are `Rigid`, or overconstrained (reported below).
        if !undriven.is_empty() || links.is_empty() || !whole {
            faults.push(Fault::NoDriver);
        } else if surplus_allowed || surplus.is_empty() {
            faults.push(Fault::Rigid { links });
        }
    }
    if !undriven.is_empty() {
        faults.push(Fault::Undriven {
            links: undriven,
            freedoms: pebbles.free_on(&joined) - BODY,
        });
    }
    for part in surplus.iter().filter(|_| !surplus_allowed) {
        let inside = |node: &usize| part.nodes.binary_search(node).is_ok();
        let within = |driver: &Driver| driver.links.iter().all(inside);
        faults.push(Fault::Overconstrained {
            drivers: (0..drivers.len())
                .filter(|&i| within(&drivers[i]))
                .collect(),
            excess: part.excess,
            links: part
                .nodes
                .iter()
                .copied()
                .filter(|&node| node < graph.links)
                .collect(),
        });
    }
    if faults.is_empty() {
        Ok((pebbles, surplus))
    } else {
        Err(faults)
    }
}

fn pairs(graph: &Graph) -> Vec<Fault> {
    let mut faults = vec![];
    if graph.ground >= graph.links {
        faults.push(Fault::NoGround);
    }
    for (pair, joined) in graph.pairs.iter().enumerate() {
        let links = joined.links();
        for (i, &link) in links.iter().enumerate() {
            if link >= graph.links {
                faults.push(Fault::NoSuchLink { pair, link });
            }
            if links[..i].iter().filter(|&&other| other == link).count() == 1 {
                faults.push(Fault::SelfJoined { pair, link });
            }
        }
        if links.len() < 2 {
            faults.push(Fault::Unjoined { pair });
        }
    }
    faults
}

fn driven(graph: &Graph, drivers: &[Driver]) -> Vec<Fault> {
    let mut faults = vec![];
    for (driver, &Driver { pair, links }) in drivers.iter().enumerate() {
        let [a, b] = links;
        match graph.pairs.get(pair) {
            None => faults.push(Fault::NoSuchPair { driver }),
            Some(Pair::Gear(_)) => faults.push(Fault::HigherPair { driver }),
            Some(joined) => {
                let joined = joined.links();
                if a == b || !joined.contains(&a) || !joined.contains(&b) {
                    faults.push(Fault::NotInPair { driver });
                }
            }
        }
        let same =
            |other: &Driver| other.pair == pair && (other.links == links || other.links == [b, a]);
        if let Some(earlier) = drivers[..driver].iter().position(same) {
            faults.push(Fault::DrivenTwice { driver, earlier });
        }
    }
    faults
}

/// Returns for each link whether pairs connect it to the ground. Then lists all nodes connected to the ground: links
/// and points of hinges.
fn joined_to_ground(graph: &Graph) -> (Vec<bool>, Vec<usize>) {
    let mut parts = Partition::new(graph.links);
    for pair in &graph.pairs {
        parts.join(pair.links().iter().copied());
    }
    let links = (0..graph.links).map(|link| parts.joins(graph.ground, link));
    let links: Vec<bool> = links.collect();
    let hinges = (0..graph.pairs.len())
        .filter(|pair| matches!(&graph.pairs[*pair], Pair::Revolute(joined) if links[joined[0]]));
    let nodes = (0..graph.links).filter(|link| links[*link]);
    let nodes = nodes.chain(hinges.map(|pair| graph.links + pair)).collect();
    (links, nodes)
}
