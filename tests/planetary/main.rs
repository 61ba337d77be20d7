//! Wheels on moving carriers, solved by the general engine: planetary sets against Willis's equation, and meshes
//! within groups of higher classes against inversions and closed forms.

mod draw;
mod groups;
mod refused;
mod satellites;
mod sun_and_planet;
mod willis;

use assur::mechanism::{Draft, Mechanism};
use assur::motion::Motion;

fn moved(draft: &Draft) -> Motion {
    Motion::new(Mechanism::new(draft).unwrap())
}

/// The angle of a link with two derivatives.
fn angle(motion: &Motion, link: &str, input: f64) -> [f64; 3] {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let jet = mechanism.angle(&pose, mechanism.link(link).unwrap());
    [0, 1, 2].map(|order| jet.derivative(order))
}

/// What the constraint equations are left with, and their derivatives, relative to their size: the largest.
fn residual(motion: &Motion, input: f64) -> f64 {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(input).unwrap();
    let size = mechanism.size().powi(2).max(1.0);
    let all = mechanism.constraints().iter().flat_map(|constraint| {
        let sides = [0, 1, 2].map(|order| mechanism.sides(&pose, constraint, order));
        sides.map(|sides| sides.residual().abs() / (size + sides.left.abs()))
    });
    all.fold(0.0, |most, residual| {
        if residual > most || residual.is_nan() {
            residual
        } else {
            most
        }
    })
}
