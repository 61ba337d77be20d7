//! Drawing of another assembly in dashed lines.

use assur::Point;
use assur::mechanism::PointId;

use super::layout::Layout;
use super::posed::Posed;
use crate::list::{List, Look};

/// Draws each link as dashed lines between its visible points, in the colour of the link.
pub(super) fn draw<const N: usize>(list: &mut List, layout: &Layout, posed: Posed<'_, N>) {
    for link in posed.mechanism.link_ids() {
        let joints = posed.mechanism.points_of(link).iter();
        let joints = joints.filter(|point| layout.is_drawn(**point));
        let place = |point: &PointId| posed.place(*point);
        let mut corners: Vec<Point> = joints.map(place).collect();
        if corners.len() > 2 {
            corners.push(corners[0]);
        }
        if corners.len() > 1 {
            list.polyline(layout.drawn_role(link), Look::Dashed, &corners);
        }
    }
}
