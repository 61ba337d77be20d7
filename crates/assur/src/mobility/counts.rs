//! Mobility by counting.

use std::collections::BTreeMap;

use super::Scheme;

/// Numbers of links and pairs, and the resulting mobility.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    /// n: moving links.
    pub links: usize,
    /// P_i: number of pairs with i freedoms in the scheme's own space; a hinge of k links counts as k − 1.
    pub pairs: BTreeMap<u8, usize>,
    /// The same by freedoms in space.
    pub spatial_pairs: BTreeMap<u8, usize>,
    /// W by Chebyshev and Grübler for a planar scheme, W = 3n − 2P₁ − P₂ (mobility paper, (1)).
    pub planar: Option<isize>,
    /// W by Somov and Malyshev, W = 6n − Σ(6 − i)P_i (mobility paper, (2)).
    pub spatial: isize,
}

impl Scheme {
    /// Numbers of links and pairs, with W by the formulas.
    pub fn counts(&self) -> Counts {
        let links = self.links().len() - 1;
        let (mut pairs, mut spatial_pairs) = (BTreeMap::new(), BTreeMap::new());
        for (at, pair) in self.pairs().iter().enumerate() {
            *pairs.entry(self.freedoms(at)).or_default() += pair.count();
            *spatial_pairs.entry(pair.kind.freedoms()).or_default() += pair.count();
        }
        let planar = self.is_planar().then(|| mobility(3, links, &pairs));
        let spatial = mobility(6, links, &spatial_pairs);
        Counts {
            links,
            pairs,
            spatial_pairs,
            planar,
            spatial,
        }
    }
}

/// W of links with `freedoms` each, less the constraints of their pairs.
fn mobility(freedoms: isize, links: usize, pairs: &BTreeMap<u8, usize>) -> isize {
    let constraints = pairs
        .iter()
        .map(|(&i, &count)| (freedoms - isize::from(i)) * count as isize);
    freedoms * links as isize - constraints.sum::<isize>()
}

impl Counts {
    /// W in the scheme's own space.
    pub fn mobility(&self) -> isize {
        self.planar.unwrap_or(self.spatial)
    }

    /// q, the redundant constraints in space for a known mobility: q = Σ(6 − i)P_i − 6n + W (mobility paper, (3), which
    /// prints − W).
    pub fn redundant(&self, mobility: isize) -> isize {
        mobility - self.spatial
    }

    /// q of a planar scheme whose pairs have one freedom each, also in space: q = ΣS + 2(n − P₁), where each of P₁ − n
    /// cut pairs has S = 5 (mobility paper, (6)): 3 for each independent loop. None for other schemes.
    pub fn redundant_by_plane(&self) -> Option<isize> {
        let one = |pairs: &BTreeMap<u8, usize>| pairs.keys().eq([&1]);
        let applies = self.planar.is_some() && one(&self.pairs) && one(&self.spatial_pairs);
        let ones = *self.pairs.get(&1)? as isize;
        let loops = ones - self.links as isize;
        applies.then_some(5 * loops - 2 * loops)
    }
}
