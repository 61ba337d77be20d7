//! What a hand can take hold of in the drawing.

use assur::Point;
use assur::mechanism::PointId;

/// A handle, by its name, in the colour of a role.
pub(crate) struct Handle {
    pub(crate) name: String,
    pub(crate) role: &'static str,
    pub(crate) at: HandlePlace,
}

/// Where a handle is.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum HandlePlace {
    /// Where a point of the linkage is.
    Point(PointId),
    /// Where it stays, whatever moves.
    Fixed(Point),
}
