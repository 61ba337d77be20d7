//! Another assembly, dashed beside the drawn one.

use assur::Point;
use assur::mechanism::{Mechanism, PointId, Pose};

use super::layout::Layout;
use crate::list::{List, Look};

/// Draws each link by lines between its joints, in its colour.
pub(super) fn draw<const N: usize>(
    list: &mut List,
    layout: &Layout,
    mechanism: &Mechanism,
    pose: &Pose<N>,
) {
    for link in mechanism.link_ids() {
        let joints = mechanism.points_of(link).iter();
        let joints = joints.filter(|point| layout.is_drawn(**point));
        let place = |point: &PointId| mechanism.place(pose, *point).place();
        let mut corners: Vec<Point> = joints.map(place).collect();
        if corners.len() > 2 {
            corners.push(corners[0]);
        }
        if corners.len() > 1 {
            list.polyline(layout.drawn_role(link), Look::Dashed, &corners);
        }
    }
}
