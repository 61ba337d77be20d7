//! The combined method for the Class IV linkage with dwell (Sakhabutdinova): positions by iteration, analogues from the
//! constraint equations. The paper's equations (1) to (6), coefficients and substitutions are evaluated here.
//!
//! The crank AB turns about the fixed point A, the triangle GHL about H, the output CD about D. The link BE drives the
//! triangle EFG, which the link FK joins to the triangle CKL. The values of [`CombinedMethod::relations`] come from the
//! pose, not from the paper's chain of substitutions, which divides by terms that may be zero.

mod constraints;
mod first;
mod places;
mod second;
mod system;

use crate::Relation;
use crate::mechanism::{DriverSpec, FRAME, Mechanism, PointId, Pose};
use crate::sorting::sort;
use first::First;
use places::Places;
use second::Second;

/// Names of the points in the paper.
const POINTS: [&str; 10] = ["A", "B", "C", "D", "E", "F", "G", "H", "K", "L"];
/// The links in alphabetical order, each named by its points in alphabetical order.
const LINKS: [&str; 7] = ["AB", "BE", "CD", "CKL", "EFG", "FK", "GHL"];

/// The linkage of the paper, with any lengths.
#[derive(Clone, Debug)]
pub struct CombinedMethod {
    points: [PointId; 10],
}

impl CombinedMethod {
    /// The paper's linkage, if the mechanism has exactly its links, pairs and frame, and the crank AB on the frame as
    /// its only driver.
    pub fn of(mechanism: &Mechanism) -> Option<Self> {
        let spec = mechanism.spec();
        let sorted = |names: &[String]| {
            let mut letters: Vec<&str> = names.iter().map(String::as_str).collect();
            sort(&mut letters);
            letters.concat()
        };
        let mut links: Vec<String> = spec.links.iter().map(|link| sorted(&link.points)).collect();
        sort(&mut links);
        let [DriverSpec::Crank { link, base, .. }] = &spec.drivers[..] else {
            return None;
        };
        let crank = spec.links.iter().find(|one| one.name == *link)?;
        let joined = spec.slides.is_empty() && spec.gears.is_empty();
        let same = links == LINKS && sorted(&spec.frame) == "ADH" && joined;
        if !same || base != FRAME || sorted(&crank.points) != "AB" {
            return None;
        }
        let points: Option<Vec<PointId>> =
            POINTS.iter().map(|name| mechanism.point(name)).collect();
        let points = points?.try_into().ok()?;
        Some(Self { points })
    }

    /// The paper's relations in a pose of the mechanism. Lengths are in the unit of the drawing, derivatives with
    /// respect to the crank angle. Relations whose value is not finite are left out.
    pub fn relations(&self, mechanism: &Mechanism, pose: &Pose<3>) -> Vec<Relation> {
        let places = Places::new(self.points.map(|point| mechanism.place(pose, point)));
        let first = First::new(&places);
        let second = Second::new(&places, &first);
        let mut all = constraints::relations(&places);
        all.extend(first.relations(&places));
        all.extend(second.relations(&places, &first));
        all.extend(second::chain(&places, &first));
        all.extend(system::rows(&places, &first, &second));
        all.retain(|one| one.value.is_finite());
        all
    }
}
