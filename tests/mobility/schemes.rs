//! Schemes written down shortly.

use assur::mobility::{PairDraft, PairKind, Point3, SchemeDraft, Vector3};

/// A pair without a place: `pair("A", Revolute, "0 1")`.
pub(crate) fn pair(name: &str, kind: PairKind, links: &str) -> PairDraft {
    PairDraft {
        name: name.to_owned(),
        kind,
        links: links.split_whitespace().map(str::to_owned).collect(),
        place: None,
        axis: None,
        second: None,
    }
}

/// The pair at a place, with an axis.
pub(crate) fn placed(pair: PairDraft, place: [f64; 3], axis: [f64; 3]) -> PairDraft {
    PairDraft {
        place: Some(Point3::from(place)),
        axis: Some(Vector3::from(axis)),
        ..pair
    }
}

/// A hinge of a planar scheme.
pub(crate) fn hinge(name: &str, links: &str, at: [f64; 2]) -> PairDraft {
    placed(
        pair(name, PairKind::Revolute, links),
        [at[0], at[1], 0.0],
        [0.0, 0.0, 1.0],
    )
}

/// Pairs in the plane, grounded at the link 0.
pub(crate) fn planar(pairs: impl IntoIterator<Item = PairDraft>) -> SchemeDraft {
    SchemeDraft {
        ground: "0".to_owned(),
        planar: true,
        pairs: pairs.into_iter().collect(),
    }
}

/// Pairs in space, grounded at the link 0.
pub(crate) fn spatial(pairs: impl IntoIterator<Item = PairDraft>) -> SchemeDraft {
    SchemeDraft {
        planar: false,
        ..planar(pairs)
    }
}
