//! Wheels on moving carriers, solved by the general engine: planetary sets against Willis's equation, and meshes
//! within groups of higher classes against inversions and closed forms.

mod draw;
mod groups;
mod refused;
mod satellites;
mod sun_and_planet;
mod willis;

use assur::mechanism::{LinkageSpec, Mechanism};
use assur::motion::Motion;

fn moved(draft: &LinkageSpec) -> Motion {
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
    // Derivatives are of the size of what they are summed of: rates of links, their squares, their accelerations.
    let rates = mechanism.link_ids().map(|link| {
        let angle = mechanism.angle(&pose, link);
        let [first, second] = [1, 2].map(|order| angle.derivative(order).abs());
        [1.0, first, first.powi(2) + second]
    });
    let scale = rates.fold([1.0; 3], |most: [f64; 3], rates| {
        [0, 1, 2].map(|order| most[order].max(rates[order]))
    });
    let all = mechanism.constraints().into_iter().flat_map(|constraint| {
        [0, 1, 2].map(|order| {
            let sides = mechanism.sides(&pose, &constraint, order);
            sides.residual().abs() / (size * scale[order] + sides.left.abs())
        })
    });
    all.fold(0.0, |most, residual| {
        if residual > most || residual.is_nan() {
            residual
        } else {
            most
        }
    })
}
