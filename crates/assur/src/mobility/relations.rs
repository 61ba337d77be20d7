//! The relations of the mobility paper, evaluated (Ambartsumyants and Arabadzhi, (1) to (6) and those of its figures).

use std::collections::BTreeMap;

use super::{PairKind, Scheme, Sections, Space};
use crate::relation::Relation;

impl Scheme {
    /// The paper's relations between numbers of links, freedoms and constraints for this scheme. Relations of an open
    /// chain need `sections`. The number q of redundant constraints is based on the mobility W by rank if places and
    /// axes of all pairs are known, otherwise on the counted W.
    pub fn relations(&self, sections: Option<&Sections>) -> Vec<Relation> {
        let counts = self.counts();
        let links = counts.links as isize;
        let [plane, space] = [Space::Plane, Space::Whole].map(|space| self.rank_report(space).ok());
        let whole = space
            .as_ref()
            .map_or(counts.mobility(), |verdict| verdict.mobility as isize);
        let hinges = (self.pairs().iter()).all(|pair| pair.kind == PairKind::Revolute);
        let mut all = Vec::new();
        let mut relation = |item, name, value: isize, printed: isize| {
            all.push(Relation::count(item, name, value, printed));
        };
        let spatial = 6 * links - sum(&counts.spatial_pairs, |i| 6 - i);
        if let Some(planar) = counts.planar {
            let of_freedoms = |i: u8| counts.pairs.get(&i).map_or(0, |count| *count as isize);
            let printed = 3 * links - 2 * of_freedoms(1) - of_freedoms(2);
            relation("001.(1)", "W", planar, printed);
        }
        relation("001.(2)", "W", counts.spatial, spatial);
        relation("001.(3)", "q", counts.redundant(whole), -spatial - whole);
        if let Some(open) = sections {
            let left = |weight: fn(isize) -> isize| sum(&open.left, weight);
            // As printed, each term contains the factor Pᵢ twice.
            let squared = |(i, count): (&u8, &usize)| isize::from(*i) * (count * count) as isize;
            let twice = open.left.iter().map(squared).sum();
            let [freedoms, removed, in_space] =
                [open.open, open.removed, open.removed_spatial].map(|number| number as isize);
            let of_space = open.open_spatial as isize;
            let q = in_space + whole - of_space;
            relation("001.(4)", "W_от", freedoms, twice);
            relation("001.(4).n", "n", links, left(|_| 1));
            relation("001.fig2a.q", "q", q, of_space + in_space + whole);
            relation("001.(5)", "W", open.mobility, left(|i| i) - removed);
            relation("001.fig4.q", "q", q, in_space * whole - of_space);
            if counts.planar.is_some() {
                let printed = of_space - in_space;
                relation("001.fig4.Wspace", "W_пр", counts.spatial, printed);
            } else if hinges && (links, counts.pairs.get(&1)) == (3, Some(&4)) {
                // The paper takes W = 1 for the contour of four hinges with axes that are not parallel.
                relation("001.fig2a.q.meaning", "W", open.mobility, 1);
                let printed = in_space + 1 - of_space;
                relation("001.fig2a.q.meaning", "q", open.redundant, printed);
            }
            if let Some(by_plane) = counts.redundant_by_plane() {
                let ones = sum(&counts.pairs, |_| 1);
                relation("001.(6)", "q", by_plane, in_space + 2 * (links - ones));
            }
            if let (None, Some(verdict)) = (counts.planar, &space) {
                let held = verdict.redundancies.iter().map(|part| part.count as isize);
                relation("001.fig3.q", "q", held.sum(), open.redundant);
            }
        }
        if let (Some(planar), Some(verdict)) = (counts.planar, plane) {
            let mobility = verdict.mobility as isize;
            // This relation is listed only if the count differs from the mobility by rank.
            if mobility != planar {
                relation("001.planarW", "W", mobility, planar);
            }
        }
        all
    }
}

/// The sum of the numbers Pᵢ of pairs with i freedoms, weighted by a function of i.
fn sum(pairs: &BTreeMap<u8, usize>, weight: fn(isize) -> isize) -> isize {
    let terms = pairs
        .iter()
        .map(|(i, count)| weight(isize::from(*i)) * *count as isize);
    terms.sum()
}
