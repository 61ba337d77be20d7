//! The structure of known linkages with each driver: groups, class, order and formula; and the faults of those without
//! a structure.

mod faults;
mod groups;
mod linkages;

use assur::structure::{Driver, Fault, Graph, Pair, Structure, decompose};

/// A linkage on link 0 with hinges only.
fn hinged(links: usize, hinges: &[&[usize]]) -> Graph {
    Graph {
        links,
        ground: 0,
        pairs: hinges
            .iter()
            .map(|links| Pair::Revolute(links.to_vec()))
            .collect(),
    }
}

fn driver(pair: usize, links: [usize; 2]) -> Driver {
    Driver { pair, links }
}

fn taken_apart(graph: &Graph, pair: usize, links: [usize; 2]) -> Structure {
    decompose(graph, &[driver(pair, links)]).unwrap()
}

fn formula(graph: &Graph, pair: usize, links: [usize; 2]) -> String {
    taken_apart(graph, pair, links).formula(|link| link)
}

/// For each link hinged on the ground, the formula with it as the crank.
fn by_crank(graph: &Graph) -> Vec<String> {
    let hinges = graph.pairs.iter().enumerate();
    let cranks = hinges.filter_map(|(pair, joined)| match joined.links() {
        [ground, crank] | [crank, ground] if *ground == graph.ground => {
            Some(formula(graph, pair, [*ground, *crank]))
        }
        _ => None,
    });
    cranks.collect()
}

fn faults(graph: &Graph, drivers: &[Driver]) -> Vec<Fault> {
    decompose(graph, drivers).unwrap_err()
}

const FOUR_BAR: &[&[usize]] = &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
