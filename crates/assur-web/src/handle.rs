//! What a hand can take hold of in the drawing.

use assur::Point;
use assur::mechanism::{Mechanism, PointId};
use assur_draw::Figure;

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

impl Handle {
    /// The points of a linkage that are drawn.
    pub(crate) fn of_points(mechanism: &Mechanism, figure: &Figure) -> Vec<Self> {
        let points = mechanism.point_ids();
        let drawn = points.filter(|point| figure.is_drawn(*point));
        let handle = |point: PointId| Self {
            name: mechanism.point_name(point).to_owned(),
            role: role(mechanism, figure, point),
            at: HandlePlace::Point(point),
        };
        drawn.map(handle).collect()
    }
}

/// The role that a link with the point is drawn in; of the frame's points none is.
fn role(mechanism: &Mechanism, figure: &Figure, point: PointId) -> &'static str {
    let mut links = mechanism.link_ids();
    let link = links.find(|link| mechanism.points_of(*link).contains(&point));
    link.map_or("ink", |link| figure.drawn_role(link).name())
}
