//! Linkages of several tests.

use super::LinkageSpec;

/// A slider-crank with the driven crank AB and the rod BC, drawn with B and C at the given positions. The slider at C
/// slides along the line from A, the origin, to E at (19, 0).
pub(crate) fn slider_crank([b, c]: [[f64; 2]; 2]) -> LinkageSpec {
    LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", b[0], b[1])
        .point("C", c[0], c[1])
        .point("E", 19.0, 0.0)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C"])
        .bar("slider", &["C"])
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank")
}
