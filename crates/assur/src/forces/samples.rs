//! A mechanism under load for the unit tests of several files.

use crate::Vector;
use crate::linkage::LinkageSpec;
use crate::mechanism::Mechanism;
use crate::motion::Motion;

use super::{AnchorSpec, Law, LoadSpec, LoadingSpec};

/// Crank 3 upright, rod 5 from (0, 3) to (4, 0) with the weight 10 at its middle, slider on the x-axis with the weight 20
/// and the force −100.
pub(super) fn slider_crank() -> (Motion, LoadingSpec) {
    let spec = LinkageSpec::default()
        .point("A", 0.0, 0.0)
        .point("B", 0.0, 3.0)
        .point("C", 4.0, 0.0)
        .point("E", 9.0, 0.0)
        .point("S", 2.0, 1.5)
        .fixed(&["A", "E"])
        .bar("crank", &["A", "B"])
        .bar("rod", &["B", "C", "S"])
        .with_mass(1.0, "S", 0.3)
        .bar("slider", &["C"])
        .with_mass(2.0, "C", 0.0)
        .slide("slider", "C", "frame", ["A", "E"])
        .crank("crank");
    let push = LoadSpec::Force {
        at: AnchorSpec::new("slider", "C"),
        direction: 180_f64.to_radians(),
        turns: false,
        law: Law::Constant(100.0),
    };
    let loading = LoadingSpec {
        gravity: Vector::new(0.0, -10.0),
        loads: vec![push],
        ..LoadingSpec::default()
    };
    (Motion::new(Mechanism::new(&spec).unwrap()), loading)
}
