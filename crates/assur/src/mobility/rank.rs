//! Mobility by rank of the constraints.

use super::constraints::Constraints;
use super::elimination::Eliminated;
use super::screw::Form;
use super::{PairKind, Scheme};
use crate::numeric::graph::Partition;
use crate::sorting::sort_by_key;

/// Space of the motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// The plane; for planar schemes only.
    Plane,
    /// Three-dimensional space.
    Whole,
}

impl Space {
    /// Number of freedoms of an unconstrained link.
    pub(super) fn freedoms(self) -> usize {
        match self {
            Self::Plane => 3,
            Self::Whole => 6,
        }
    }
}

/// Reasons why a scheme has no rank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoRank {
    /// The first pair without a place.
    NoPlace(String),
    /// The first pair without an axis, or without a second direction if its kind has one.
    NoAxis(String),
    /// The first pair given only by its number of freedoms.
    NoForm(String),
    /// Motions in the plane were requested, and the scheme is not planar.
    NotPlanar,
}

/// Mobility by rank in the drawn pose. Pairs and links are listed in the order of their names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RankReport {
    /// Mobility W: number of independent motions.
    pub mobility: usize,
    /// Number of independent constraints.
    pub rank: usize,
    /// Redundant constraints, grouped by independent parts of the scheme.
    pub redundancies: Vec<Redundancy>,
    /// Links that can move while all others are at rest, single or as two joined links.
    pub idle: Vec<Vec<usize>>,
}

/// Redundant constraints in one part of a scheme.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Redundancy {
    /// Number of redundant constraints.
    pub count: usize,
    /// Pairs involved: those that can be stressed without a load.
    pub pairs: Vec<usize>,
}

impl Scheme {
    /// Mobility by rank in the drawn pose.
    ///
    /// # Errors
    /// The scheme lacks data that the rank needs, or motions in the plane are requested for a scheme that is not
    /// planar.
    pub fn rank_report(&self, space: Space) -> Result<RankReport, NoRank> {
        let forms = self.forms(space)?;
        let constraints = Constraints::new(self, &forms, space);
        let equilibrium = constraints.equilibrium(self).eliminated(None);
        let rank = equilibrium.rank();
        let mobility = space.freedoms() * (self.links().len() - 1) - rank;
        Ok(RankReport {
            mobility,
            rank,
            redundancies: self.redundancies(&constraints, &equilibrium),
            idle: self.idle(&constraints, space, mobility),
        })
    }

    /// Rank of the constraints in a pose given by `forms` of the pairs.
    pub(super) fn rank_of(&self, forms: &[Form], space: Space) -> usize {
        let constraints = Constraints::new(self, forms, space);
        constraints.equilibrium(self).eliminated(None).rank()
    }

    /// Forms of the pairs in the drawn pose, from which their screws follow.
    pub(super) fn forms(&self, space: Space) -> Result<Vec<Form>, NoRank> {
        if space == Space::Plane && !self.is_planar() {
            return Err(NoRank::NotPlanar);
        }
        let scale = self.scale();
        let pairs = self.pairs().iter().enumerate();
        let forms = pairs.map(|(at, pair)| {
            self.form(at, &scale).ok_or_else(|| {
                let name = pair.name.clone();
                match pair.kind {
                    PairKind::Class(_) => NoRank::NoForm(name),
                    _ if pair.place.is_none() => NoRank::NoPlace(name),
                    _ => NoRank::NoAxis(name),
                }
            })
        });
        forms.collect()
    }

    /// Self-stresses, grouped by independent parts. Two self-stresses belong to one part if they stress a common pair.
    fn redundancies(&self, constraints: &Constraints, equilibrium: &Eliminated) -> Vec<Redundancy> {
        let count = self.pairs().len();
        let mut parts = Partition::new(count);
        // If a generic combination of the stresses of one part stresses a pair of another part, the two parts are one.
        let mut apart = false;
        while !apart {
            apart = true;
            for pair in 0..count {
                let own = |free: usize| parts.representative(constraints.pair_of(free)) == pair;
                if parts.representative(pair) == pair && equilibrium.free().any(own) {
                    let stressed = constraints.stressed(&equilibrium.mixture(own));
                    apart &= !parts.join(stressed);
                }
            }
        }
        let mut counts = vec![0; count];
        for free in equilibrium.free() {
            counts[parts.representative(constraints.pair_of(free))] += 1;
        }
        let parts = (0..count)
            .filter(|representative| counts[*representative] > 0)
            .map(|representative| {
                let mut pairs: Vec<usize> = (0..count)
                    .filter(|pair| parts.representative(*pair) == representative)
                    .collect();
                sort_by_key(&mut pairs, |pair| &self.pairs()[*pair].name);
                Redundancy {
                    count: counts[representative],
                    pairs,
                }
            });
        let mut parts: Vec<Redundancy> = parts.collect();
        sort_by_key(&mut parts, |part| self.pair_names(&part.pairs));
        parts
    }

    fn pair_names(&self, pairs: &[usize]) -> Vec<&str> {
        let names = pairs.iter().map(|pair| self.pairs()[*pair].name.as_str());
        names.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::mobility::{PairSpec, Point3, SchemeSpec, Vector3};

    /// Hinges about z between links at places of the plane.
    fn hinges(planar: bool, pairs: &[([usize; 2], [f64; 2])]) -> Scheme {
        let pairs = pairs
            .iter()
            .enumerate()
            .map(|(at, (links, [x, y]))| PairSpec {
                name: format!("P{at}"),
                kind: PairKind::Revolute,
                links: links.map(|link| link.to_string()).to_vec(),
                place: Some(Point3::new(*x, *y, 0.0)),
                axis: Some(Vector3::z()),
                second: None,
            });
        let spec = SchemeSpec {
            ground: "0".to_owned(),
            planar,
            pairs: pairs.collect(),
        };
        Scheme::new(&spec).unwrap()
    }

    const FOUR_BAR: [([usize; 2], [f64; 2]); 4] = [
        ([0, 1], [0.0, 0.0]),
        ([1, 2], [1.0, 2.0]),
        ([2, 3], [4.0, 3.0]),
        ([3, 0], [5.0, 0.0]),
    ];

    /// Freedoms less independent constraints: a triangle 6 − 6, a four-bar 9 − 8, and in space 18 − 17 with 3 of its 20
    /// constraints redundant.
    #[test]
    fn mobility_is_freedoms_less_the_rank() {
        for (pairs, planar, space, mobility, rank, redundant) in [
            (
                &[
                    ([0, 1], [0.0, 0.0]),
                    ([1, 2], [3.0, 0.0]),
                    ([2, 0], [3.0, 4.0]),
                ][..],
                true,
                Space::Plane,
                0,
                6,
                0,
            ),
            (&FOUR_BAR, true, Space::Plane, 1, 8, 0),
            (&FOUR_BAR, false, Space::Whole, 1, 17, 3),
        ] {
            let report = hinges(planar, pairs).rank_report(space).unwrap();
            assert_eq!(
                (report.mobility, report.rank),
                (mobility, rank),
                "{space:?}"
            );
            let found: usize = report.redundancies.iter().map(|one| one.count).sum();
            assert_eq!(found, redundant, "{space:?}");
        }
    }

    /// With the hinges in line, one constraint along the line is redundant, and none acts across the line: the triangle
    /// moves for an instant.
    #[test]
    fn a_flat_triangle_moves_for_an_instant() {
        let flat = [
            ([0, 1], [0.0, 0.0]),
            ([1, 2], [1.0, 0.0]),
            ([2, 0], [3.0, 0.0]),
        ];
        let report = hinges(true, &flat).rank_report(Space::Plane).unwrap();
        assert_eq!((report.mobility, report.rank), (1, 5));
        let [part] = &report.redundancies[..] else {
            panic!("not one part")
        };
        assert_eq!((part.count, &part.pairs[..]), (1, &[0, 1, 2][..]));
    }

    #[test]
    fn a_spatial_scheme_has_no_rank_in_the_plane() {
        let found = hinges(false, &FOUR_BAR).rank_report(Space::Plane);
        assert_eq!(found, Err(NoRank::NotPlanar));
    }
}
