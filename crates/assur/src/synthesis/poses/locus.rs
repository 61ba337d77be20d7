//! Circle points of a given centre point, and centre points of a given circle point; poles.
//!
//! A circle point is a point of the body, given by its place in the first pose, whose places in all poses lie on a
//! circle; its centre is the centre point. For a given C each pose but the first gives a linear condition on W, whose
//! coefficients are MC. For two poses W is on a line, the perpendicular bisector of the two images of C as seen from
//! the body. For three poses W is a point, the centre of the circle through three such images. For more poses there is
//! no W in general.

use super::task::{Place, Task, Triple};
use crate::tolerance;
use crate::{Point, Vector};

/// The points that correspond to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Locus {
    /// Every point.
    Any,
    /// The points of a line: one of them, and a unit vector along the line.
    Line {
        /// The point of the line that is nearest to the mean of the places of the body's origin.
        through: Point,
        /// Unit vector along the line.
        along: Vector,
    },
    /// One point, possibly at infinity.
    One(Place),
    /// No point.
    None,
}

impl Task {
    /// Circle points of a centre point. A centre at infinity is given by the direction perpendicular to the line on
    /// which its circle points move.
    pub fn circle_points(&self, centre: Place) -> Locus {
        let centre = self.triple(centre);
        self.locus(self.displacements().iter().map(|one| one.matrix() * centre))
    }

    /// Centre points of a circle point. A circle point at infinity is given by the direction perpendicular to the lines
    /// of the body that pass through its centre points in all poses.
    pub fn centre_points(&self, point: Place) -> Locus {
        let point = self.triple(point);
        self.locus((self.displacements().iter()).map(|one| one.matrix().tr_mul(&point)))
    }

    /// The pole of two poses, about which a rotation takes the body from one to the other; at infinity for parallel
    /// poses. None for equal poses, or if there is no such pose.
    pub fn pole(&self, j: usize, k: usize) -> Option<Place> {
        Some(self.place(self.pole_triple(j, k)?))
    }

    /// The image pole: the place in the first pose of the body's point that is at the pole in the poses `j` and `k`.
    /// With the poles of the first pose it forms the pole triangle of three poses.
    pub fn image_pole(&self, j: usize, k: usize) -> Option<Place> {
        let pole = self.pole_triple(j, k)?;
        Some(self.place(match self.order(j)? {
            0 => pole,
            place => self.displacements()[place - 1].back(pole),
        }))
    }

    fn pole_triple(&self, j: usize, k: usize) -> Option<Triple> {
        let all = self.displacements();
        match (self.order(j)?, self.order(k)?) {
            (j, k) if j == k => None,
            (0, k) | (k, 0) => Some(all[k - 1].pole()),
            (j, k) => Some(all[j - 1].to(&all[k - 1]).pole()),
        }
    }

    /// The points whose triples are perpendicular to all given ones.
    fn locus(&self, conditions: impl Iterator<Item = Triple>) -> Locus {
        let conditions: Vec<Triple> = conditions.collect();
        match common(&conditions) {
            Common::Any => Locus::Any,
            Common::Line(line) => {
                let normal = line.xy();
                if normal.norm() <= tolerance::COINCIDENT * line.norm() {
                    return Locus::None;
                }
                let foot = -normal * (line.z / normal.norm_squared());
                let Place::Finite(through) = self.place(foot.push(1.0)) else {
                    return Locus::None;
                };
                let along = crate::perpendicular(normal).normalize();
                Locus::Line { through, along }
            }
            Common::One(triple) => Locus::One(self.place(triple)),
            Common::None => Locus::None,
        }
    }
}

/// Triples perpendicular to all of a list.
pub(super) enum Common {
    Any,
    /// Those perpendicular to this one.
    Line(Triple),
    One(Triple),
    None,
}

/// The triples perpendicular to all given ones, which have norms of at most about 1.
pub(super) fn common(conditions: &[Triple]) -> Common {
    let longest = |all: &mut dyn Iterator<Item = Triple>| {
        all.fold(Triple::zeros(), |longest, next| {
            if next.norm_squared() > longest.norm_squared() {
                next
            } else {
                longest
            }
        })
    };
    let line = longest(&mut conditions.iter().copied());
    if line.norm() <= tolerance::NEGLIGIBLE {
        return Common::Any;
    }
    let one = longest(&mut conditions.iter().map(|next| line.cross(next)));
    if one.norm() <= tolerance::NEGLIGIBLE * line.norm() {
        return Common::Line(line);
    }
    let one = one.normalize();
    // The scalar products are zero in exact arithmetic; the bound allows for the solution of a cubic or a quartic.
    let met = (conditions.iter()).all(|next| next.dot(&one).abs() <= tolerance::COINCIDENT);
    if met { Common::One(one) } else { Common::None }
}

/// The triple that is most nearly perpendicular to all given ones: the longest of their vector products. None if all
/// given ones are multiples of one.
pub(super) fn nearly_common(conditions: &[Triple]) -> Option<Triple> {
    let mut best = Triple::zeros();
    for (k, a) in conditions.iter().enumerate() {
        for b in &conditions[..k] {
            let one = a.cross(b);
            if one.norm_squared() > best.norm_squared() {
                best = one;
            }
        }
    }
    (best.norm() > tolerance::NEGLIGIBLE).then(|| best.normalize())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::synthesis::poses::Pose;

    fn task(poses: &[[f64; 3]]) -> Task {
        let poses: Vec<Pose> = (poses.iter())
            .map(|&[x, y, angle]| Pose { x, y, angle })
            .collect();
        Task::new(&poses).unwrap()
    }

    fn finite(place: Place) -> Point {
        match place {
            Place::Finite(point) => point,
            Place::Infinite(direction) => panic!("at infinity towards {direction}"),
        }
    }

    /// The bisector of (0, 0) and (2, 0) is x = 1.
    #[test]
    fn the_bisector_of_two_poses() {
        let two = task(&[[0.0, 0.0, 0.0], [2.0, 0.0, FRAC_PI_2]]);
        let Locus::Line { through, along } = two.centre_points(Place::Finite(Point::origin()))
        else {
            panic!("no line");
        };
        assert!(
            (through.x - 1.0).abs() < 1e-14 && along.x.abs() < 1e-14,
            "{through} {along}"
        );
        assert!((finite(two.pole(0, 1).unwrap()) - Point::new(1.0, 1.0)).norm() < 1e-14);
        // The point of the body at the pole does not move: every point is its centre point.
        assert_eq!(
            two.centre_points(Place::Finite(Point::new(1.0, 1.0))),
            Locus::Any
        );
    }

    /// The body's origin is at (1, 0), (0, 1) and (−1, 0), on the unit circle, whatever the angles are.
    #[test]
    fn the_circle_of_three_poses() {
        let three = task(&[[1.0, 0.0, 0.3], [0.0, 1.0, -0.4], [-1.0, 0.0, 1.1]]);
        let Locus::One(centre) = three.centre_points(Place::Finite(Point::new(1.0, 0.0))) else {
            panic!("no centre");
        };
        assert!(finite(centre).coords.norm() < 1e-14);
        let Locus::One(point) = three.circle_points(Place::Finite(Point::origin())) else {
            panic!("no circle point");
        };
        assert!((finite(point) - Point::new(1.0, 0.0)).norm() < 1e-14);
    }

    /// Places on the x-axis have their centre at infinity, in the direction of y; the circle point of that centre is
    /// the body's origin.
    #[test]
    fn a_slider_has_its_centre_at_infinity() {
        let three = task(&[[1.0, 0.0, 0.3], [0.0, 0.0, -0.4], [-2.0, 0.0, 1.1]]);
        let Locus::One(Place::Infinite(centre)) =
            three.centre_points(Place::Finite(Point::new(1.0, 0.0)))
        else {
            panic!("not at infinity");
        };
        assert!(centre.x.abs() < 1e-14);
        let Locus::One(point) = three.circle_points(Place::Infinite(Vector::y())) else {
            panic!("no circle point");
        };
        assert!((finite(point) - Point::new(1.0, 0.0)).norm() < 1e-14);
    }

    /// The image pole is carried to the pole of both poses.
    #[test]
    fn image_poles() {
        let three = task(&[[1.0, 0.0, 0.3], [0.0, 1.0, -0.4], [-1.0, 0.5, 1.1]]);
        let [image, pole] =
            [three.image_pole(1, 2), three.pole(1, 2)].map(|one| finite(one.unwrap()));
        for k in [1, 2] {
            assert!((three.carried(image, k) - pole).norm() < 1e-13);
        }
        assert_eq!(three.pole(1, 1), None);
        assert_eq!(three.pole(0, 7), None);
    }
}
