//! Grashof's classes.

use super::{FourBar, Link, tolerance};

/// The kind of a four-bar by Grashof: which link can turn fully against which
/// (s shortest, l longest, p and q the others).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grashof {
    /// s + l < p + q, the crank is shortest: it turns, the rocker swings.
    CrankRocker,
    /// s + l < p + q, the rocker is shortest: the input swings, the output can
    /// turn.
    RockerCrank,
    /// s + l < p + q, the frame is shortest: crank and rocker turn (drag link).
    DoubleCrank,
    /// s + l < p + q, the coupler is shortest: it turns, crank and rocker swing.
    DoubleRocker,
    /// s + l > p + q: no link turns fully.
    TripleRocker,
    /// s + l = p + q: all links can lie in one line, where motions cross.
    ChangePoint,
}

impl FourBar {
    /// Grashof's class; a change point is told apart within
    /// |s + l − p − q| ≤ 8 ε (s + l).
    pub fn grashof(&self) -> Grashof {
        let order = [Link::Crank, Link::Coupler, Link::Rocker, Link::Frame];
        let mut sorted = order.map(|link| (self.length(link), link));
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(s, shortest), (p, _), (q, _), (l, _)] = sorted;
        let excess = (s - p) + (l - q);
        if excess.abs() <= tolerance(&self.lengths) {
            return Grashof::ChangePoint;
        }
        if excess > 0.0 {
            return Grashof::TripleRocker;
        }
        match shortest {
            Link::Crank => Grashof::CrankRocker,
            Link::Coupler => Grashof::DoubleRocker,
            Link::Rocker => Grashof::RockerCrank,
            Link::Frame => Grashof::DoubleCrank,
        }
    }
}
