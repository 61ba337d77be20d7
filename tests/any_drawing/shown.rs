//! Readings of a pose: positions of points and angles of links, with derivatives.

use assur::Vector;
use assur::mechanism::{Mechanism, Pose};
use assur::motion::PoseOrder;

/// What is read off a pose: of each point its place, of each link its angle, with two
/// derivatives; those that the pose does not carry are zero.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) points: Vec<[Vector; 3]>,
    pub(crate) angles: Vec<[f64; 3]>,
}

impl Shown {
    pub(crate) fn of<const N: usize>(mechanism: &Mechanism, pose: &Pose<N>) -> Self
    where
        Pose<N>: PoseOrder,
    {
        let orders = [0, 1, 2];
        let points = mechanism.point_ids().map(|point| {
            let at = mechanism.place(pose, point);
            orders.map(|order| {
                if order < N {
                    at.derivative(order)
                } else {
                    Vector::zeros()
                }
            })
        });
        let angles = mechanism.link_ids().map(|link| {
            let angle = mechanism.angle(pose, link);
            orders.map(|order| {
                if order < N {
                    angle.derivative(order)
                } else {
                    0.0
                }
            })
        });
        Self {
            points: points.collect(),
            angles: angles.collect(),
        }
    }

    /// The largest angle, whole turns included.
    pub(crate) fn largest_angle(&self) -> f64 {
        let angles = self.angles.iter().map(|[angle, ..]| angle.abs());
        angles.fold(0.0, f64::max)
    }

    /// The greatest place, first and second derivative of anything, as lengths; places from that
    /// of the first point.
    pub(crate) fn scales(&self, size: f64) -> [f64; 3] {
        let origin = self.points[0][0];
        let far = |order: usize| {
            let points = self.points.iter().map(move |point| point[order]);
            let from = if order == 0 { origin } else { Vector::zeros() };
            points.fold(0.0, |most: f64, at| most.max((at - from).norm()))
        };
        let reach = far(0).max(size);
        let turning = |order: usize| {
            let angles = self.angles.iter().map(|angle| angle[order].abs());
            reach * angles.fold(0.0, f64::max)
        };
        let rate = turning(1).max(far(1));
        let bent = (rate / reach).powi(2) * reach;
        [reach, rate, bent.max(turning(2)).max(far(2))]
    }
}
