//! Mobility by counting.

use std::collections::BTreeMap;

use super::Scheme;

/// Numbers of links and pairs, and the resulting mobility.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Number of moving links, n.
    pub links: usize,
    /// Number P_i of pairs with i freedoms, in the plane if the scheme is planar. A k-link hinge counts as k − 1 pairs.
    pub pairs: BTreeMap<u8, usize>,
    /// Number of pairs with i freedoms in space, for each i.
    pub spatial_pairs: BTreeMap<u8, usize>,
    /// Mobility W by Chebyshev and Grübler for a planar scheme, W = 3n − 2P₁ − P₂ (mobility paper, (1)).
    pub planar: Option<isize>,
    /// Mobility W by Somov and Malyshev, W = 6n − Σ(6 − i)P_i (mobility paper, (2)).
    pub spatial: isize,
}

impl Scheme {
    /// Numbers of links and pairs, with the mobility W by the formulas.
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

/// Mobility W: `freedoms` for each of `links` moving links, less the constraints of the pairs.
fn mobility(freedoms: isize, links: usize, pairs: &BTreeMap<u8, usize>) -> isize {
    let constraints = pairs
        .iter()
        .map(|(&i, &count)| (freedoms - isize::from(i)) * count as isize);
    freedoms * links as isize - constraints.sum::<isize>()
}

impl Counts {
    /// Mobility W, in the plane for a planar scheme and otherwise in space.
    pub fn mobility(&self) -> isize {
        self.planar.unwrap_or(self.spatial)
    }

    /// Number q of redundant constraints in space for a known mobility W: q = Σ(6 − i)P_i − 6n + W (mobility paper,
    /// (3), which prints − W instead of + W).
    pub fn redundant(&self, mobility: isize) -> isize {
        mobility - self.spatial
    }

    /// Number q of redundant constraints in space, for a planar scheme of n moving links and P₁ pairs that have one
    /// freedom each, both in the plane and in space: q = ΣS + 2(n − P₁) (mobility paper, (6)). One pair is cut in each
    /// of the P₁ − n independent loops, with S = 5 constraints, so q is 3 for each loop. None for other schemes.
    pub fn redundant_by_plane(&self) -> Option<isize> {
        let one = |pairs: &BTreeMap<u8, usize>| pairs.keys().eq([&1]);
        let applies = self.planar.is_some() && one(&self.pairs) && one(&self.spatial_pairs);
        let ones = *self.pairs.get(&1)? as isize;
        let loops = ones - self.links as isize;
        applies.then_some(5 * loops - 2 * loops)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::mobility::{PairKind, PairSpec, SchemeSpec};

    /// Contour of pairs of given kinds, from the ground through links 1, 2, … and back to the ground.
    pub(in crate::mobility) fn contour(planar: bool, kinds: &[PairKind]) -> Scheme {
        let link = |number: usize| (number % kinds.len()).to_string();
        let pairs = kinds.iter().enumerate().map(|(at, kind)| PairSpec {
            name: format!("P{at}"),
            kind: *kind,
            links: vec![link(at), link(at + 1)],
            place: None,
            axis: None,
            second: None,
        });
        let spec = SchemeSpec {
            ground: "0".to_owned(),
            planar,
            pairs: pairs.collect(),
        };
        Scheme::new(&spec).unwrap()
    }

    /// Mobilities in the plane and in space. Four-bar: 3·3 − 2·4 and 6·3 − 5·4; five-bar: 3·4 − 2·5 and 6·4 − 5·5. A
    /// contour of two spheres and two hinges has 6·3 − 5 − 3 − 3 − 5 in space: one freedom is the rotation of the
    /// coupler about its own axis.
    #[test]
    fn contours() {
        use PairKind::{Revolute, Spherical};
        for (planar, kinds, in_plane, spatial) in [
            (true, &[Revolute; 4][..], Some(1), -2),
            (true, &[Revolute; 5], Some(2), -1),
            (false, &[Revolute, Spherical, Spherical, Revolute], None, 2),
        ] {
            let counts = contour(planar, kinds).counts();
            assert_eq!((counts.planar, counts.spatial), (in_plane, spatial));
            assert_eq!(counts.links, kinds.len() - 1);
        }
        let four_bar = contour(true, &[Revolute; 4]).counts();
        assert_eq!(
            (four_bar.redundant(1), four_bar.redundant_by_plane()),
            (3, Some(3))
        );
    }

    /// Spatial four-bars with 6·3 − 17 = 1: RSCR with 5 + 3 + 4 + 5 constraints, RCCC with 5 + 4 + 4 + 4, RSUR with
    /// 5 + 3 + 4 + 5. A contour of seven hinges has 6·6 − 7·5, one of four 6·3 − 4·5.
    #[test]
    fn contours_in_space_by_somov_and_malyshev() {
        use PairKind::{Cylindrical, Revolute, Spherical, Universal};
        for (kinds, spatial) in [
            (&[Revolute, Spherical, Cylindrical, Revolute][..], 1),
            (&[Revolute, Cylindrical, Cylindrical, Cylindrical], 1),
            (&[Revolute, Spherical, Universal, Revolute], 1),
            (&[Revolute; 7], 1),
            (&[Revolute; 4], -2),
        ] {
            let counts = contour(false, kinds).counts();
            assert_eq!(
                (counts.planar, counts.spatial),
                (None, spatial),
                "{kinds:?}"
            );
            assert_eq!(counts.mobility(), spatial);
        }
    }

    #[test]
    fn each_planar_loop_of_hinges_has_three_redundant_constraints() {
        for (count, mobility) in [(4, 1), (5, 2), (6, 3)] {
            let counts = contour(true, &vec![PairKind::Revolute; count]).counts();
            assert_eq!(counts.planar, Some(mobility));
            assert_eq!(counts.redundant(mobility), 3);
            assert_eq!(counts.redundant_by_plane(), Some(3));
        }
    }
}
