//! The dyads in closed form.

mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
#[cfg(test)]
pub(super) mod tests;

pub(crate) use prp::Prp;
pub(crate) use rpp::Rpp;
pub(crate) use rpr::{Rpr, Side};
pub(crate) use rrp::Rrp;
pub(crate) use rrr::Rrr;
pub(super) use rrr::Triangle;
