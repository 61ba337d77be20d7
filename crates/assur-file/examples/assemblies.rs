//! All assemblies of a Class IV group at one input, in order of the angle of the output link.
//!
//! `cargo run -p assur-file --example assemblies`

use assur_file::from_catalogue;

/// Prints the real assemblies and the number of complex solutions.
pub fn main() {
    let Some(Ok(document)) = from_catalogue("class4-dwell") else {
        return println!("the catalogue has no such linkage");
    };
    let motion = match document.motion() {
        Ok(motion) => motion,
        Err(problems) => return println!("it does not move: {problems:?}"),
    };
    let mechanism = motion.mechanism();
    let Some(output) = document.output(mechanism) else {
        return println!("no output link");
    };
    let found = motion.assemblies_at(90.0_f64.to_radians(), output);
    println!("complex solutions of each group: {:?}", found.complex);
    for (number, pose) in found.poses.iter().enumerate() {
        let angle = mechanism.angle(pose, output).value().to_degrees();
        println!("assembly {}: {:8.3}°", number + 1, angle.rem_euclid(360.0));
    }
}
