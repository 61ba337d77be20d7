//! Short notation for schemes.

use assur::mobility::{PairKind, PairSpec, Point3, SchemeSpec, Vector3};

/// A pair without a place: `pair("A", Revolute, "0 1")`.
pub(crate) fn pair(name: &str, kind: PairKind, links: &str) -> PairSpec {
    PairSpec {
        name: name.to_owned(),
        kind,
        links: links.split_whitespace().map(str::to_owned).collect(),
        place: None,
        axis: None,
        second: None,
    }
}

/// The pair at a place, with an axis.
pub(crate) fn placed(pair: PairSpec, place: [f64; 3], axis: [f64; 3]) -> PairSpec {
    PairSpec {
        place: Some(Point3::from(place)),
        axis: Some(Vector3::from(axis)),
        ..pair
    }
}

/// A hinge of a planar scheme.
pub(crate) fn hinge(name: &str, links: &str, at: [f64; 2]) -> PairSpec {
    placed(
        pair(name, PairKind::Revolute, links),
        [at[0], at[1], 0.0],
        [0.0, 0.0, 1.0],
    )
}

/// Pairs in the plane, grounded at the link 0.
pub(crate) fn planar(pairs: impl IntoIterator<Item = PairSpec>) -> SchemeSpec {
    SchemeSpec {
        ground: "0".to_owned(),
        planar: true,
        pairs: pairs.into_iter().collect(),
    }
}

/// Pairs in space, grounded at the link 0.
pub(crate) fn spatial(pairs: impl IntoIterator<Item = PairSpec>) -> SchemeSpec {
    SchemeSpec {
        planar: false,
        ..planar(pairs)
    }
}
