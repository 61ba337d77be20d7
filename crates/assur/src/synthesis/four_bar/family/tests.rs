//! Families of two positions with lines that can be read off their cosines.

use super::*;
use crate::synthesis::four_bar::{Frame, Position};

/// The linkages through two positions, with φ₂ and φ₃ in degrees and the frame along the x-axis.
fn linkages(positions: [[f64; 2]; 2]) -> TwoPositions {
    let frame = Frame {
        length: 1.0,
        angle: 0.0,
    };
    let positions =
        positions.map(|[output, input]| Position::new(output.to_radians(), input.to_radians()));
    let task = Task::new(frame, &positions, Task::RATIOS).unwrap();
    TwoPositions::new(&task).unwrap()
}

fn family(positions: [[f64; 2]; 2]) -> Family {
    match linkages(positions) {
        TwoPositions::Family(family) => family,
        other => panic!("{other:?}"),
    }
}

/// With φ₂ from 60° to −60° the line is (1 − 1/2)/z₂ = 1/2 + 1/2: z₂ is 1/2, and z₃ is free.
#[test]
fn a_mirrored_output_has_one_length() {
    let family = family([[60.0, 0.0], [-60.0, 60.0]]);
    for at in [0.1, 0.5, 0.9] {
        let found = family.proportions(at).unwrap();
        assert!((found.output - 0.5).abs() < 1e-14, "{found:?}");
        let solution = family.member(at).unwrap();
        assert!(solution.worst_residual() < 1e-14, "{solution:?}");
    }
    // In the middle, at 45°, z₃ is z₂.
    assert!((family.proportions(0.5).unwrap().input - 0.5).abs() < 1e-14);
    assert_eq!(family.proportions(0.0), None);
    assert_eq!(family.proportions(1.0), None);
}

/// Output opposite to the input: z₂ = z₃ in every size, and a coupler as long as the frame.
#[test]
fn parallelograms_are_a_family_of_sizes() {
    let family = family([[200.0, 20.0], [230.0, 50.0]]);
    for (at, size) in [
        (0.5, 1.0),
        (1.0 / 3.0, 3_f64.sqrt().recip()),
        (2.0 / 3.0, 3_f64.sqrt()),
    ] {
        let found = family.proportions(at).unwrap();
        let length = size * 0.5_f64.sqrt();
        for (z, expected) in found.z().into_iter().zip([1.0, length, length]) {
            assert!((z - expected).abs() < 1e-13, "{at}: {found:?}");
        }
    }
}

/// A position and its mirror image in the frame: every output and input closes with the same coupler.
#[test]
fn mirrored_positions_suit_any_linkage() {
    let found = linkages([[30.0, 20.0], [-30.0, -20.0]]);
    assert_eq!(found, TwoPositions::Any);
}

/// With output and input both from 90° to 0° the line is −1/z₂ − 1/z₃ = 0, which no positive lengths satisfy.
#[test]
fn cosines_that_grow_together_leave_no_linkage() {
    let TwoPositions::None(line) = linkages([[90.0, 90.0], [0.0, 0.0]]) else {
        panic!("not none")
    };
    assert!((line.output + 1.0).abs() < 1e-15 && (line.input + 1.0).abs() < 1e-15);
    assert_eq!(line.right, 0.0);
}
