//! Random schemes from a seed.

use assur::mobility::{PairKind, PairSpec, Point3, SchemeSpec, Vector3};
use proptest::prelude::Rng as _;
use proptest::test_runner::{RngAlgorithm, TestRng};

use super::schemes::pair;

/// Random numbers, the same for the same seed.
pub(crate) struct Random(TestRng);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    /// From 0 to one less.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.0.next_u64() % end as u64) as usize
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for at in (1..items.len()).rev() {
            items.swap(at, self.below(at + 1));
        }
    }
}

/// Where pairs are and how they are turned.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Geometry {
    /// Anywhere.
    Generic,
    /// At the points of a lattice and along its lines: much is parallel and meets.
    Lattice,
}

impl Geometry {
    fn coordinate(self, random: &mut Random) -> f64 {
        match self {
            Self::Generic => random.between(-1.0, 1.0),
            Self::Lattice => random.below(3) as f64 - 1.0,
        }
    }

    fn direction(self, random: &mut Random, planar: bool) -> Vector3 {
        loop {
            let z = if planar { 0.0 } else { self.coordinate(random) };
            let direction = Vector3::new(self.coordinate(random), self.coordinate(random), z);
            if direction.norm() > 0.2 {
                return direction;
            }
        }
    }
}

/// A pair with a place and directions; of a planar scheme such as fit the plane.
pub(crate) fn located(
    random: &mut Random,
    geometry: Geometry,
    planar: bool,
    (name, kind, links): (&str, PairKind, &str),
) -> PairSpec {
    let z = if planar {
        0.0
    } else {
        geometry.coordinate(random)
    };
    let place = Point3::new(geometry.coordinate(random), geometry.coordinate(random), z);
    let axis = match kind {
        PairKind::Revolute if planar => Vector3::z(),
        _ => geometry.direction(random, planar),
    };
    let mut second = geometry.direction(random, false);
    while second.cross(&axis).norm() < 0.1 {
        second = geometry.direction(random, false);
    }
    PairSpec {
        place: Some(place),
        axis: Some(axis),
        second: (!planar).then_some(second),
        ..pair(name, kind, links)
    }
}

/// The forms of random schemes.
pub(crate) fn forms(planar: bool) -> Vec<PairKind> {
    if planar {
        use PairKind::{CylinderOnPlane, Prismatic, Revolute};
        vec![Revolute, Revolute, Prismatic, CylinderOnPlane]
    } else {
        PairKind::forms(0.7).to_vec()
    }
}

/// A connected scheme of these many links with so many more pairs than a tree has; now and then a hinge of three
/// links.
pub(crate) fn scheme(
    random: &mut Random,
    geometry: Geometry,
    planar: bool,
    [links, loops]: [usize; 2],
) -> SchemeSpec {
    let forms = forms(planar);
    let mut joins: Vec<[usize; 2]> = (1..links).map(|link| [random.below(link), link]).collect();
    for _ in 0..loops {
        let one = random.below(links);
        let other = (one + 1 + random.below(links - 1)) % links;
        joins.push([one, other]);
    }
    random.shuffle(&mut joins);
    let pairs = joins.iter().enumerate().map(|(at, [one, other])| {
        let mut kind = random.pick(&forms);
        let mut links_of = format!("{one} {other}");
        let third = random.below(links);
        if random.below(8) == 0 && third != *one && third != *other {
            kind = PairKind::Revolute;
            links_of = format!("{links_of} {third}");
        }
        let name = format!("p{at}");
        located(random, geometry, planar, (&name, kind, &links_of))
    });
    SchemeSpec {
        ground: "0".to_owned(),
        planar,
        pairs: pairs.collect(),
    }
}

/// A scheme of which nothing is redundant unless by special dimensions: links are added that have as many freedoms
/// as their pairs have constraints, or some more.
pub(crate) fn sound(random: &mut Random, geometry: Geometry, planar: bool) -> SchemeSpec {
    let own = if planar { 3 } else { 6 };
    let forms = forms(planar);
    let in_plane = |kind: PairKind| match kind {
        PairKind::CylinderOnPlane => 2,
        _ => 1,
    };
    let freedoms = |kind: PairKind| match planar {
        true => in_plane(kind),
        false => usize::from(kind.freedoms()),
    };
    let slides = |kind: &PairKind| match kind {
        PairKind::Prismatic | PairKind::Cylindrical | PairKind::SphereInCylinder => 1,
        PairKind::Planar | PairKind::CylinderOnPlane | PairKind::SphereOnPlane => 2,
        _ => 0,
    };
    let mut pairs: Vec<PairSpec> = vec![];
    let mut links = 1;
    let mut add = |random: &mut Random, kinds: &[PairKind], ends: [usize; 2], links: &mut usize| {
        let mut from = ends[0];
        for (at, kind) in kinds.iter().enumerate() {
            let to = if at + 1 < kinds.len() {
                *links += 1;
                *links - 1
            } else {
                ends[1]
            };
            let (name, joined) = (format!("p{}", pairs.len()), format!("{from} {to}"));
            pairs.push(located(random, geometry, planar, (&name, *kind, &joined)));
            from = to;
        }
    };
    // A link that moves, then chains between links that can move against each other.
    links += 1;
    add(random, &[PairKind::Revolute], [0, 1], &mut links);
    for _ in 0..1 + random.below(4) {
        let one = random.below(links);
        let other = (one + 1 + random.below(links - 1)) % links;
        loop {
            let kinds: Vec<_> = (0..2 + random.below(3))
                .map(|_| random.pick(&forms))
                .collect();
            let sum: usize = kinds.iter().map(|kind| freedoms(*kind)).sum();
            let most = if planar { 1 } else { 3 };
            let slide: usize = kinds.iter().map(slides).sum();
            let balls = kinds.iter().filter(|kind| kind.freedoms() == 3).count();
            if sum == own && slide <= most && balls < 2 {
                add(random, &kinds, [one, other], &mut links);
                break;
            }
        }
    }
    SchemeSpec {
        ground: "0".to_owned(),
        planar,
        pairs,
    }
}
