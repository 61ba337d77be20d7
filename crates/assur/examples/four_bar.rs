//! A crank-rocker over a turn: the rocker's angle with two derivatives, its dead points and transmission angle.
//!
//! `cargo run -p assur --example four_bar`

use assur::{Assembly, FourBar};

/// Prints a table of twelve rows.
pub fn main() {
    // Crank, coupler, rocker, frame, in any one unit.
    let linkage = match FourBar::new([2.0, 6.0, 4.5, 6.0]) {
        Ok(linkage) => linkage,
        Err(faults) => return println!("no four-bar: {faults:?}"),
    };
    println!("{:?}", linkage.grashof());
    println!("  φ₁     φ₃       φ₃′      φ₃″");
    for degrees in (0..360).step_by(30) {
        match linkage.pose::<3>(Assembly::First, f64::from(degrees).to_radians()) {
            Ok(pose) => {
                let [angle, first, second] = [0, 1, 2].map(|order| pose.rocker.derivative(order));
                println!(
                    "{degrees:4}°  {:7.3}°  {first:7.4}  {second:7.4}",
                    angle.to_degrees()
                );
            }
            Err(reason) => println!("{degrees:4}°  {reason:?}"),
        }
    }
    for limit in linkage.limits(Assembly::First) {
        println!("limit position at φ₁ = {:.3}°", limit.crank.to_degrees());
    }
}
