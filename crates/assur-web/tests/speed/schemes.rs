//! Schemes of 200 links and 300 pairs, with their counts, sections and ranks.

use assur::mobility::{PairKind, PairSpec, Point3, Scheme, SchemeSpec, Space, Vector3};

const LINKS: usize = 200;

/// Arrangement of the pairs between links.
#[derive(Clone, Copy)]
pub(crate) enum Net {
    /// Two rings with a rung at each link.
    Ladder,
    /// A ring with pairs between random links across it.
    Random,
}

/// Returns a scheme of hinges. The axes of a planar one are normal to the plane, those of a spatial one are random.
pub(crate) fn scheme(net: Net, planar: bool) -> Scheme {
    let mut random = Random(1);
    let half = LINKS / 2;
    let joins: Vec<[usize; 2]> = match net {
        Net::Ladder => {
            let ring =
                |start: usize| (0..half).map(move |at| [start + at, start + (at + 1) % half]);
            let rungs = (0..half).map(|at| [at, half + at]);
            ring(0).chain(ring(half)).chain(rungs).collect()
        }
        Net::Random => {
            let ring = (0..LINKS).map(|at| [at, (at + 1) % LINKS]);
            let mut ends: Vec<usize> = (0..LINKS).collect();
            for at in (1..LINKS).rev() {
                ends.swap(at, (random.next() * (at + 1) as f64) as usize);
            }
            let across = ends.chunks_exact(2).map(|ends| [ends[0], ends[1]]);
            ring.chain(across).collect()
        }
    };
    let pairs = joins.iter().enumerate().map(|(at, links)| {
        let mut coordinate = || random.next() - 0.5;
        let place = [coordinate(), coordinate(), coordinate()];
        let axis = Vector3::new(coordinate(), coordinate(), coordinate());
        PairSpec {
            name: at.to_string(),
            kind: PairKind::Revolute,
            links: links.map(|link| link.to_string()).into(),
            place: Some(Point3::from(place)),
            axis: (!planar).then_some(axis),
            second: None,
        }
    });
    let draft = SchemeSpec {
        ground: "0".to_owned(),
        planar,
        pairs: pairs.collect(),
    };
    Scheme::new(&draft).unwrap()
}

/// Returns mobility by count, mobility by sections and rank.
pub(crate) fn judge(scheme: &Scheme, space: Space) -> (isize, isize, usize) {
    let counted = scheme.counts().mobility();
    let sections = scheme.sections(&scheme.automatic()).unwrap();
    let verdict = scheme.rank_report(space).unwrap();
    (counted, sections.by_loops(), verdict.mobility)
}

/// A generator of random numbers from 0 to 1 (Lehmer, 1949, as in MINSTD).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }
}
