//! Independent checks of a structure: the rank of a Jacobian, and a trial of every set of links.

use assur::structure::{Driver, Graph, Pair};

use super::draw::Links;

/// Arithmetic modulo a prime: a rank without rounding.
const PRIME: u128 = (1 << 61) - 1;

/// Whether the velocities of all links follow from those of the drivers, with
/// random dimensions: 3n independent constraints on the 3n velocities.
pub(super) fn regular(graph: &Graph, drivers: &[Driver], seed: u64) -> bool {
    let mut state = seed;
    let mut random = || {
        // splitmix64
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        u128::from(z ^ (z >> 31)) % PRIME
    };
    // A row constrains (vx, vy, ω) of one link against another's.
    let mut rows = vec![];
    let mut row = |a: usize, b: usize, [x, y, w]: [u128; 3]| {
        let mut row = vec![0; 3 * graph.links];
        for (i, value) in [x, y, w].into_iter().enumerate() {
            row[3 * a + i] = value;
            row[3 * b + i] = (PRIME - value) % PRIME;
        }
        rows.push(row);
    };
    let mut slides = vec![];
    for pair in &graph.pairs {
        let (x, y, n) = (random(), random(), random());
        slides.push([1, n, random()]);
        match pair {
            Pair::Revolute(links) => {
                for link in &links[1..] {
                    row(links[0], *link, [1, 0, PRIME - y]);
                    row(links[0], *link, [0, 1, x]);
                }
            }
            Pair::Prismatic([a, b]) => {
                row(*a, *b, [0, 0, 1]);
                row(*a, *b, [PRIME - n, 1, 0]);
            }
            Pair::Gear([a, b]) => row(*a, *b, [x, y, n]),
        }
    }
    for driver in drivers {
        let [a, b] = driver.links;
        match graph.pairs[driver.pair] {
            Pair::Prismatic(_) => row(a, b, slides[driver.pair]),
            _ => row(a, b, [0, 0, 1]),
        }
    }
    let ground = 3 * graph.ground;
    rows.iter_mut()
        .for_each(|row| row[ground..ground + 3].fill(0));
    let freedoms = 3 * (graph.links - 1);
    rows.len() == freedoms && rank(rows) == freedoms
}

fn rank(mut rows: Vec<Vec<u128>>) -> usize {
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else {
            continue;
        };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        let pivot = &done[rank];
        for row in rest {
            let by = row[column];
            for (value, above) in row.iter_mut().zip(pivot) {
                *value = (*value * pivot[column] + (PRIME - by) * above) % PRIME;
            }
        }
        rank += 1;
    }
    rank
}

/// The links in the groups of the theory: the smallest sets that can be added
/// with as many constraints as freedoms, again and again. In ascending order.
pub(super) fn smallest_groups(graph: &Graph, drivers: &[Driver]) -> Vec<Links> {
    let mut solved = Links::from([graph.ground]);
    let mut groups = vec![];
    while solved.len() < graph.links {
        let left: Vec<usize> = (0..graph.links)
            .filter(|link| !solved.contains(link))
            .collect();
        let sets = (1..1_usize << left.len()).map(|set| -> Links {
            let chosen = (0..left.len()).filter(|i| set >> i & 1 == 1);
            chosen.map(|i| left[i]).collect()
        });
        let all = |links: &Links| constraints(graph, drivers, &(&solved | links));
        let group = sets
            .filter(|links| all(links) == all(&Links::new()) + 3 * links.len())
            .min_by_key(Links::len)
            .unwrap();
        solved.extend(&group);
        groups.push(group);
    }
    groups.sort();
    groups
}

fn constraints(graph: &Graph, drivers: &[Driver], links: &Links) -> usize {
    let pairs = graph.pairs.iter().map(|pair| {
        let here = pair.links().iter().filter(|link| links.contains(link));
        let joins = here.count().saturating_sub(1);
        match pair {
            Pair::Gear(_) => joins,
            _ => 2 * joins,
        }
    });
    let driven = drivers
        .iter()
        .filter(|driver| driver.links.iter().all(|link| links.contains(link)));
    pairs.sum::<usize>() + driven.count()
}
