//! Four-bars that pass through two given positions of output and input: a family with one free length.
//!
//! `cargo run -p assur --example synthesis`

use assur::synthesis::four_bar::{Frame, Position, Task, TwoPositions};

/// Prints members of the family with their verdicts.
pub fn main() {
    // Angles φ₂ of the output and φ₃ of the input, measured from the frame as in the source paper.
    let positions = [[240.0, 45.0], [253.0, 60.0]]
        .map(|[output, input]: [f64; 2]| Position::new(output.to_radians(), input.to_radians()));
    let frame = Frame {
        length: 10.4,
        angle: 0.0,
    };
    let task = match Task::new(frame, &positions, Task::RATIOS) {
        Ok(task) => task,
        Err(faults) => return println!("no task: {faults:?}"),
    };
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        return println!("no four-bar takes up both positions");
    };
    for member in family.sample([0.0, 1.0], 9) {
        let lengths = member.proportions;
        let [l1, l2, l3] =
            [lengths.coupler, lengths.output, lengths.input].map(|z| z * frame.length);
        match member.verdict {
            Ok(verdict) => println!(
                "{l1:8.3} {l2:8.3} {l3:8.3}  {:?}, {:?}",
                verdict.grashof, verdict.passage
            ),
            Err(reason) => println!("{l1:8.3} {l2:8.3} {l3:8.3}  {reason:?}"),
        }
    }
}
