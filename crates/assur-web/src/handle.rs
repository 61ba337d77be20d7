//! Handles of the drawing.

use assur::Point;
use assur::mechanism::{Mechanism, PointId};
use assur_draw::Figure;

/// A handle, with its name and the role of its colour.
pub(crate) struct Handle {
    pub(crate) name: String,
    pub(crate) role: &'static str,
    pub(crate) at: HandlePlace,
}

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum HandlePlace {
    /// On a point of the linkage.
    Point(PointId),
    /// At a fixed place.
    Fixed(Point),
}

impl Handle {
    /// Makes handles for the drawn points of a linkage.
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

/// Colour role of the first link that lists the point; "ink" if no link does.
fn role(mechanism: &Mechanism, figure: &Figure, point: PointId) -> &'static str {
    let mut links = mechanism.link_ids();
    let link = links.find(|link| mechanism.points_of(*link).contains(&point));
    link.map_or("ink", |link| figure.drawn_role(link).name())
}
