//! Numbers of teeth, similar to given ones, with which a train can be built.

use super::{Coupling, Kind, Layout, Member, Train};
use crate::sorting::sort_by_key;

/// A train that meets all conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// Train with the suggested numbers of teeth.
    pub train: Train,
    /// Sum of the absolute changes of all numbers of teeth.
    pub change: u32,
}

impl Layout {
    /// Maximum total change of teeth in the search; less for stepped satellites, whose fourth wheel adds candidates.
    fn reach(&self) -> i32 {
        match self.train().kind() {
            Kind::Planar | Kind::Bevel => 60,
            Kind::Stepped => 20,
        }
    }

    /// Trains that can be built with this layout's number of satellites, module and axis distance. They are sorted by
    /// the sum of the changes of the wheels' numbers of teeth, then by the greatest of these changes. The train of this
    /// layout comes first if it can be built.
    ///
    /// At most `count` trains, with a sum of changes of at most 60 teeth, 20 with stepped satellites.
    pub fn suggestions(&self, coupling: Coupling, count: usize) -> Vec<Suggestion> {
        let mut found = Vec::new();
        for change in 0..=self.reach() {
            if found.len() >= count {
                break;
            }
            let mut shell: Vec<([i32; 4], Train)> = changes(self.train().kind(), change)
                .into_iter()
                .filter_map(|changes| Some((changes, self.train().changed(changes)?)))
                .filter(|(_, train)| self.with(*train).can_be_built(coupling))
                .collect();
            sort_by_key(&mut shell, |(changes, _)| {
                (changes.map(i32::abs).into_iter().max(), *changes)
            });
            let change = change.unsigned_abs();
            found.extend(shell.iter().map(|&(_, train)| Suggestion { train, change }));
        }
        found.truncate(count);
        found
    }
}

impl Train {
    /// The train with z₁, z₂, z₂′, z₄ changed by these numbers of teeth; none if it is invalid.
    fn changed(&self, [sun, satellite, step, ring]: [i32; 4]) -> Option<Self> {
        let teeth = |member, change: i32| f64::from(self.teeth(member)) + f64::from(change);
        let sun = teeth(Member::Sun, sun);
        let satellite = teeth(Member::Satellite, satellite);
        let step = teeth(Member::Step, step);
        let ring = teeth(Member::Ring, ring);
        match self.kind() {
            Kind::Planar => Self::planar([sun, satellite, ring]),
            Kind::Stepped => Self::stepped([sun, satellite, step, ring]),
            Kind::Bevel => Self::bevel([sun, satellite, ring]),
        }
        .ok()
    }
}

/// All changes of z₁, z₂, z₂′, z₄ whose absolute values add up to `total`; z₂′ changes only in stepped satellites.
fn changes(kind: Kind, total: i32) -> Vec<[i32; 4]> {
    let mut changes = Vec::new();
    for sun in -total..=total {
        let rest = total - sun.abs();
        for satellite in -rest..=rest {
            let rest = rest - satellite.abs();
            let steps = if kind == Kind::Stepped { rest } else { 0 };
            for step in -steps..=steps {
                let ring = rest - step.abs();
                changes.push([sun, satellite, step, ring]);
                if ring > 0 {
                    changes.push([sun, satellite, step, -ring]);
                }
            }
        }
    }
    changes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Changes of three numbers of teeth by n in all are the points of an octahedron: 1 for n = 0, otherwise 4n² + 2.
    /// With a fourth number there are 8 for n = 1 and 32 for n = 2.
    #[test]
    fn changes_are_the_points_of_an_octahedron() {
        for (kind, total, count) in [
            (Kind::Planar, 0, 1),
            (Kind::Planar, 1, 6),
            (Kind::Planar, 2, 18),
            (Kind::Bevel, 2, 18),
            (Kind::Stepped, 1, 8),
            (Kind::Stepped, 2, 32),
        ] {
            let mut found = changes(kind, total);
            assert!(
                found
                    .iter()
                    .all(|change| change.iter().map(|by| by.abs()).sum::<i32>() == total)
            );
            assert!(kind == Kind::Stepped || found.iter().all(|change| change[2] == 0));
            found.sort_unstable();
            found.dedup();
            assert_eq!(found.len(), count, "{kind:?} {total}");
        }
    }

    /// Of the trains that differ from 20, 21 and 60 teeth by one tooth, only 20, 20 and 60 is coaxial, 60 = 20 + 2·20.
    /// Four satellites can be mounted in it.
    #[test]
    fn the_nearest_train_has_one_tooth_less() {
        let train = Train::planar([20.0, 21.0, 60.0]).unwrap();
        let layout = Layout::new(train, 4.0, 1.0, None).unwrap();
        let found = layout.suggestions(Coupling::Contact, 1);
        let expected = Suggestion {
            train: Train::planar([20.0, 20.0, 60.0]).unwrap(),
            change: 1,
        };
        assert_eq!(found, [expected]);
        assert!(layout.suggestions(Coupling::Contact, 0).is_empty());
    }

    /// Five satellites, 22 wide over the tips, have a chord of 40 sin 36° > 22 between centres. Six, with 40 sin 30° =
    /// 20, need other wheels.
    #[test]
    fn six_satellites_need_other_wheels() {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        for (satellites, is_same) in [(5.0, true), (6.0, false)] {
            let layout = Layout::new(train, satellites, 1.0, None).unwrap();
            let found = layout.suggestions(Coupling::Contact, 1)[0];
            assert_eq!(found.change == 0, is_same, "{satellites}");
            assert_eq!(found.train == train, is_same);
        }
    }
}
