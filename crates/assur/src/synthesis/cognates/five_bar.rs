//! The five-bar with equal gears.

use crate::Point;
use crate::gears::Mesh;
use crate::linkage::{GearSpec, LinkageSpec};
use crate::tolerance::COINCIDENT;

/// A five-bar with equal gears, in one pose. Its two cranks turn alike, because each is in mesh with an idler of as
/// many teeth. The joint of the other two bars traces the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearedFiveBar {
    /// The fixed pivots.
    pub pivots: [Point; 2],
    /// The ends of the cranks.
    pub joints: [Point; 2],
    /// The joint of the other two bars, which traces the curve.
    pub point: Point,
}

/// Teeth of the two cranks and of the idler.
const TEETH: f64 = 20.0;

impl GearedFiveBar {
    /// The five-bar in a pose; None if the joints of a bar, or the pivots, coincide.
    pub(super) fn new(pivots: [Point; 2], joints: [Point; 2], point: Point) -> Option<Self> {
        let bars = [
            pivots[1] - pivots[0],
            joints[0] - pivots[0],
            joints[1] - pivots[1],
            point - joints[0],
            point - joints[1],
        ];
        let lengths = bars.map(|bar| bar.norm());
        let size: f64 = lengths.iter().sum();
        let found = Self {
            pivots,
            joints,
            point,
        };
        let sound = lengths.iter().all(|length| *length > COINCIDENT * size);
        sound.then_some(found)
    }

    /// Specification as a mechanism: the cranks `crank` (A, B) and `follower` (E, D), the bars `left` (B, P) and
    /// `right` (D, P), and the `idler` at O, half-way between the pivots. The crank is driven.
    pub fn spec(&self) -> LinkageSpec {
        let [a, e] = self.pivots;
        let [b, d] = self.joints;
        let (o, p) = (nalgebra::center(&a, &e), self.point);
        let mut spec = LinkageSpec::default();
        for (name, at) in [("A", a), ("B", b), ("P", p), ("D", d), ("E", e), ("O", o)] {
            spec = spec.point(name, at.x, at.y);
        }
        for links in [["crank", "idler"], ["idler", "follower"]] {
            spec.gears.push(GearSpec {
                links: links.map(str::to_owned),
                carrier: "frame".to_owned(),
                teeth: [TEETH; 2],
                mesh: Mesh::External,
            });
        }
        spec.fixed(&["A", "E", "O"])
            .bar("crank", &["A", "B"])
            .bar("idler", &["O"])
            .bar("follower", &["E", "D"])
            .bar("left", &["B", "P"])
            .bar("right", &["D", "P"])
            .crank("crank")
    }
}
