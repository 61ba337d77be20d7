//! Opening of a chain at cut pairs: the other pairs move slightly, within their freedoms, until the two halves of each
//! cut pair separate.

use std::collections::VecDeque;

use assur::mobility::{Cut, Pair, PairKind, Point3, Scheme, Vector3};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

/// Gap between the halves of a cut pair, relative to the size of the drawing.
const GAP: f64 = 0.09;
/// Greatest rotation of a pair in opening one gap, radians.
const MAX_ROTATION: f64 = 0.45;

/// Translation in a pair that counts as much as a turn of one radian, relative to the size of the drawing.
const LEVER: f64 = 0.3;

pub(super) type Displacement = Isometry3<f64>;

/// A chain with cuts; `left` lists, for each pair, the links that the pair still joins.
pub(super) struct Chain<'a> {
    scheme: &'a Scheme,
    places: &'a [Point3],
    left: Vec<Vec<usize>>,
    cuts: &'a [Cut],
    size: f64,
}

/// Last step of the path from the ground to a link: the pair, and the link before it. None for the ground and for a
/// link that is not connected to the ground.
type Reached = Option<(usize, usize)>;

impl<'a> Chain<'a> {
    pub(super) fn new(
        scheme: &'a Scheme,
        places: &'a [Point3],
        cuts: &'a [Cut],
        size: f64,
    ) -> Self {
        let pairs = scheme.pairs().iter().enumerate();
        let left = pairs.map(|(index, pair)| {
            let left = pair.links.iter().copied();
            left.filter(|&link| !cuts.contains(&Cut { pair: index, link }))
                .collect()
        });
        Self {
            scheme,
            places,
            left: left.collect(),
            cuts,
            size,
        }
    }

    /// Returns the displacements of all links. The last cut is open by the share `last`; all other cuts are fully open.
    /// Links that are no longer connected to the ground move down.
    pub(super) fn opened(&self, last: f64) -> Vec<Displacement> {
        let pairs = self.scheme.pairs();
        let (reached, order) = self.reach();
        let mut moved = vec![Displacement::identity(); pairs.len()];
        for (k, cut) in self.cuts.iter().enumerate() {
            let share = if k + 1 == self.cuts.len() { last } else { 1.0 };
            self.part(*cut, share, &reached, &mut moved);
        }
        let mut links = vec![Displacement::identity(); self.scheme.links().len()];
        let down = if self.scheme.is_planar() { -1.0 } else { 0.0 };
        let fallen = Vector3::new(0.0, down, -1.0) * (GAP * self.size * last);
        for (link, way) in reached.iter().enumerate() {
            if link > 0 && way.is_none() {
                links[link] = Translation3::from(fallen).into();
            }
        }
        for link in order {
            if let Some((pair, from)) = reached[link] {
                links[link] = links[from] * moved[pair];
            }
        }
        links
    }

    /// Opens a cut: moves the pairs on the paths from the ground to the two halves of the cut pair.
    fn part(&self, cut: Cut, share: f64, reached: &[Reached], moved: &mut [Displacement]) {
        let Some(&kept) = self.left[cut.pair].first() else {
            return;
        };
        let [off, on] = [cut.link, kept].map(|link| way_to(link, reached));
        // A pair on both paths would move both halves alike, so it stays at rest.
        let both = |pair: &usize| !(off.contains(pair) && on.contains(pair));
        let at = self.places[cut.pair];
        let around: Vec<Point3> = off
            .iter()
            .chain(&on)
            .map(|pair| self.places[*pair])
            .collect();
        let middle =
            around.iter().map(|place| place.coords).sum::<Vector3>() / around.len().max(1) as f64;
        let away = (at.coords - middle)
            .try_normalize(1e-12)
            .unwrap_or_else(Vector3::x);
        let free = off
            .iter()
            .map(|pair| (*pair, 1.0))
            .chain(on.iter().map(|pair| (*pair, -1.0)));
        let free = free.filter(|(pair, _)| both(pair) && self.parts(*pair));
        let ways: Vec<(usize, f64, Small)> = free
            .map(|(pair, sense)| {
                let small = Small::of(
                    &self.scheme.pairs()[pair],
                    self.places[pair],
                    at,
                    away,
                    self.size,
                );
                (
                    pair,
                    sense * small.along(self.places[pair], at, away),
                    small,
                )
            })
            .collect();
        let whole: f64 = ways.iter().map(|(_, along, _)| along.abs()).sum();
        if whole < 1e-9 * self.size {
            return;
        }
        let by = (GAP * self.size / whole).min(MAX_ROTATION);
        for (pair, along, small) in ways {
            let by = share * by * along.signum();
            moved[pair] = small.displacement(self.places[pair], by) * moved[pair];
        }
    }

    /// Whether the pair joins exactly two links and the chain falls apart without it.
    fn parts(&self, pair: usize) -> bool {
        let [one, other] = self.left[pair][..] else {
            return false;
        };
        let mut seen = vec![false; self.scheme.links().len()];
        let mut waiting = VecDeque::from([one]);
        while let Some(link) = waiting.pop_front() {
            if std::mem::replace(&mut seen[link], true) {
                continue;
            }
            for (index, left) in self.left.iter().enumerate() {
                if index != pair && left.contains(&link) {
                    waiting.extend(left);
                }
            }
        }
        !seen[other]
    }

    /// Returns the last steps of the paths from the ground, and the links in the order in which they are reached.
    fn reach(&self) -> (Vec<Reached>, Vec<usize>) {
        let mut reached = vec![None; self.scheme.links().len()];
        let mut order = vec![0];
        let mut next = 0;
        while let Some(&link) = order.get(next) {
            next += 1;
            for (pair, left) in self.left.iter().enumerate() {
                if !left.contains(&link) {
                    continue;
                }
                for &other in left {
                    if other != 0 && reached[other].is_none() && other != link {
                        reached[other] = Some((pair, link));
                        order.push(other);
                    }
                }
            }
        }
        (reached, order)
    }
}

/// Returns the pairs on the path between a link and the ground.
fn way_to(mut link: usize, reached: &[Reached]) -> Vec<usize> {
    let mut way = Vec::new();
    while let Some((pair, from)) = reached[link] {
        way.push(pair);
        link = from;
    }
    way
}

/// A small motion allowed by a pair: a turn about an axis given by a unit vector, or a translation.
enum Small {
    Turn(Vector3),
    Slide(Vector3),
}

impl Small {
    /// Selects one motion of a pair for opening a cut. If the kind of pair does not fix the direction of the motion,
    /// the direction is chosen that moves the point `at` farthest in the direction `away`.
    fn of(pair: &Pair, here: Point3, at: Point3, away: Vector3, size: f64) -> Self {
        let axis = pair.axis.unwrap_or_else(Vector3::z);
        let best = || {
            let turn = (at - here).cross(&away);
            Self::Turn(turn.try_normalize(1e-12).unwrap_or(axis))
        };
        match pair.kind {
            PairKind::Prismatic => Self::Slide(axis * (LEVER * size)),
            PairKind::Planar => {
                let along = away - axis * away.dot(&axis);
                Self::Slide(along.try_normalize(1e-12).unwrap_or(axis) * (LEVER * size))
            }
            PairKind::Revolute
            | PairKind::Screw { .. }
            | PairKind::Cylindrical
            | PairKind::Universal
            | PairKind::CylinderOnPlane => Self::Turn(
                pair.second
                    .filter(|_| pair.kind == PairKind::CylinderOnPlane)
                    .unwrap_or(axis),
            ),
            PairKind::Spherical
            | PairKind::SphereInCylinder
            | PairKind::SphereOnPlane
            | PairKind::Class(_) => best(),
        }
    }

    /// Returns the displacement of `at` in the direction `away`, per radian of a turn or for the whole translation.
    fn along(&self, here: Point3, at: Point3, away: Vector3) -> f64 {
        match self {
            Self::Turn(axis) => axis.cross(&(at - here)).dot(&away),
            Self::Slide(axis) => axis.dot(&away),
        }
    }

    fn displacement(&self, here: Point3, by: f64) -> Displacement {
        match self {
            Self::Turn(axis) => {
                let turn = UnitQuaternion::from_scaled_axis(axis * by);
                turned_about(turn, here)
            }
            Self::Slide(axis) => Translation3::from(axis * by).into(),
        }
    }
}

/// Returns the displacement due to a turn about an axis through the point `here`.
fn turned_about(turn: UnitQuaternion<f64>, here: Point3) -> Displacement {
    Displacement::from_parts(Translation3::from(here - turn * here), turn)
}
