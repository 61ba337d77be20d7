//! A planetary train with two driven shafts: the speed of the third shaft, the sum of the powers and the six ratios.
//!
//! `cargo run -p assur --example train`

use assur::gears::train::{Differential, Drive, Input, Shaft};

/// Prints the speed, the sum of the powers and the ratios.
pub fn main() {
    // Numbers of teeth of the sun and the ring; each satellite has 20.
    let differential = match Differential::planar([20.0, 60.0]) {
        Ok(differential) => differential,
        Err(faults) => return println!("no train: {faults:?}"),
    };
    let inputs = [(Shaft::Sun, 10.0), (Shaft::Ring, -2.0)].map(|(shaft, speed)| Input {
        shaft,
        drive: Drive::Given(speed),
    });
    match differential.solve(&inputs) {
        Ok(speeds) => {
            println!("ω₃ = {} rad/s", speeds.of(Shaft::Carrier));
            if let Ok(torques) = differential.torques(Shaft::Sun, 1.0) {
                let powers = torques.powers(&speeds);
                println!("sum of the powers: {:.1e} W", powers.sum());
            }
        }
        Err(faults) => println!("the speeds do not determine the train: {faults:?}"),
    }
    for ratio in differential.ratios() {
        println!("{ratio:?} = {:.4}", ratio.value());
    }
}
