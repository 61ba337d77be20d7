//! Zhukovsky's lever: the plan of velocities turned by a quarter turn, with the forces at the images of their points.

use super::Reactions;
use super::applied::{Applied, turning};
use super::free_body::Cause;
use crate::index::BodyId;
use crate::linkage::DriverSpec;
use crate::mechanism::{Mechanism, Pose};
use crate::{Point, Vector};

/// A force or couple on the lever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeverTerm {
    /// The body on which it acts.
    pub body: BodyId,
    /// What it comes from.
    pub cause: Cause,
    /// The force; zero for a couple.
    pub force: Vector,
    /// The couple; zero for a force.
    pub couple: f64,
    /// Place of the force in the pose.
    pub place: Point,
    /// Image of this place: the velocity of its point at the unit rate of the input, turned clockwise by a quarter turn.
    pub image: Vector,
    /// Moment about the pole. That of a couple is the couple times the angular velocity of its body at the unit rate.
    pub moment: f64,
}

/// Zhukovsky's lever in a pose. The velocities are those at the unit rate of the input, so moments about the pole are
/// torques at a crank, or forces at a driven slide.
#[derive(Clone, Debug, PartialEq)]
pub struct Lever {
    /// Applied forces and couples on moving bodies, in the order of [`Reactions::applied`].
    pub terms: Vec<LeverTerm>,
    /// Sum of the moments.
    pub sum: f64,
    /// Balancing torque or force of the driver that holds the lever in equilibrium; None if there are several drivers.
    pub balancing: Option<f64>,
}

impl Lever {
    /// The lever of a pose with these forces.
    ///
    /// ```
    /// # use assur::{Vector, linkage::LinkageSpec, mechanism::Mechanism, motion::Motion};
    /// use assur::forces::{Kinetostatics, Lever, Loading, LoadingSpec};
    /// let spec = LinkageSpec::default().point("A", 0.0, 0.0).point("B", 2.0, 0.0).fixed(&["A"])
    ///     .bar("crank", &["A", "B"]).with_mass(3.0, "B", 0.0).crank("crank");
    /// let motion = Motion::new(Mechanism::new(&spec).unwrap());
    /// let gravity = LoadingSpec { gravity: Vector::new(0.0, -10.0), ..LoadingSpec::default() };
    /// let (mechanism, pose) = (motion.mechanism(), motion.pose::<3>(0.0).unwrap());
    /// let loading = Loading::new(mechanism, &gravity).unwrap();
    /// let found = Kinetostatics::new(mechanism).reactions(&loading, &pose, 0.0, [0.0; 2]).unwrap();
    /// // The weight 30 acts at the image of B, at the distance 2 from the pole.
    /// assert!((Lever::new(mechanism, &pose, &found).balancing.unwrap() - 60.0).abs() < 1e-12);
    /// ```
    pub fn new(mechanism: &Mechanism, pose: &Pose<3>, found: &Reactions) -> Self {
        let moving = found
            .applied()
            .iter()
            .filter(|one| one.body != BodyId::FRAME);
        let mut terms = Vec::new();
        for one in moving {
            let (force, couple) = (one.force, one.couple);
            if force != Vector::zeros() {
                terms.push(term(mechanism, pose, one, force, 0.0));
            }
            if couple != 0.0 {
                terms.push(term(mechanism, pose, one, Vector::zeros(), couple));
            }
        }
        let sum = terms.iter().map(|term| term.moment).sum();
        let rate = match &mechanism.spec().drivers[..] {
            [only] => Some(DriverSpec::rate(only)),
            _ => None,
        };
        Self {
            terms,
            sum,
            balancing: rate.map(|rate| -sum / rate),
        }
    }
}

fn term(
    mechanism: &Mechanism,
    pose: &Pose<3>,
    one: &Applied,
    force: Vector,
    couple: f64,
) -> LeverTerm {
    let of = &pose.state().bodies[one.body];
    let [spin, _] = turning(pose.state(), one.body);
    let arm = one.at - of.origin[0];
    let velocity = of.origin[1] + crate::perpendicular(arm) * spin;
    let image = Vector::new(velocity.y, -velocity.x);
    LeverTerm {
        body: one.body,
        cause: Cause::Applied(one.source),
        force,
        couple,
        place: one.place(mechanism),
        image,
        moment: image.perp(&force) + couple * spin,
    }
}
