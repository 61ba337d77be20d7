use std::f64::consts::TAU;

use assur::FourBar;

use super::*;
use crate::list::Role;

/// The plots of q = sin φ₁ over a full turn.
fn sine(input: InputRate, differenced: bool) -> [Plot; 3] {
    let cycle = FourBar::new([0.37, 0.85, 0.55, 0.85]).unwrap().cycle();
    let series = Series {
        name: "sine".to_owned(),
        role: Role::Ink,
        features: None,
    };
    let sample = |crank| {
        let jets = vec![Jet::linear(crank, 1.0).sin_cos().0];
        Some(Sample { jets, clear: true })
    };
    let settings = Settings {
        input,
        physical: true,
        differenced,
    };
    plots(
        &sampled(cycle.samples(sampling(1)), &sample),
        true,
        &[series],
        settings,
    )
}

/// Central differences of cos φ₁ over ±h are −sin φ₁ (sin h)/h: close to the exact derivative −sin φ₁, but not equal
/// to it.
#[test]
fn differences_are_of_the_samples() {
    let input = InputRate {
        speed: -3.0,
        acceleration: 2.0,
    };
    for input in [InputRate::ANALOGUES, input] {
        let [value, first, second] = sine(input, true);
        assert!(value.curves[0].differences.is_empty());
        assert!(first.curves[0].differences.is_empty());
        let differences = &second.curves[0].differences;
        assert_eq!(differences.len(), DIFFERENCES);
        let h = TAU / TURN as f64;
        let square = input.speed * input.speed;
        for (crank, shown) in differences {
            let steady = -square * crank.sin() * h.sin() / h;
            let expected = steady + input.acceleration * crank.cos();
            assert!((shown - expected).abs() < 1e-11 * square, "{crank}");
        }
        let exact = second.curves[0].runs[0].clone();
        let off = differences.iter().map(|(crank, shown)| {
            let at = exact.iter().find(|(at, _)| at == crank).unwrap();
            (shown - at.1).abs() / square
        });
        let most = off.fold(0.0, f64::max);
        assert!((1e-6..1e-4).contains(&most), "{most:e}");
    }
    assert!(
        sine(InputRate::ANALOGUES, false)[2].curves[0]
            .differences
            .is_empty()
    );
}

#[test]
fn curves_are_rates() {
    let input = InputRate {
        speed: -3.0,
        acceleration: 2.0,
    };
    let plots = sine(input, false);
    for (order, plot) in plots.iter().enumerate() {
        for (crank, value) in &plot.curves[0].runs[0] {
            let (sin, cos) = crank.sin_cos();
            let expected = [sin, -3.0 * cos, -9.0 * sin + 2.0 * cos][order];
            assert!((value - expected).abs() < 1e-14 * 9.0, "{order} {crank}");
        }
    }
}

#[test]
fn curves_are_cut_at_the_bounds() {
    let curve = Curve {
        runs: vec![vec![
            (0.0, 0.0),
            (1.0, 4.0),
            (2.0, 0.0),
            (3.0, -4.0),
            (4.0, 4.0),
        ]],
        ..Curve::default()
    };
    let parts = curve.within(-1.0, 1.0);
    let expected = [
        vec![(0.0, 0.0), (0.25, 1.0)],
        vec![(1.75, 1.0), (2.0, 0.0), (2.25, -1.0)],
        vec![(3.375, -1.0), (3.625, 1.0)],
    ];
    assert_eq!(parts, expected);
}

#[test]
fn a_dwell_is_marked_at_its_ends() {
    let mark = |(crank, value): (f64, f64)| Mark {
        kind: if value == 0.0 {
            MarkKind::Zero
        } else {
            MarkKind::Max
        },
        crank,
        value,
    };
    let dwell = [
        (2.0, 0.003),
        (2.3, 0.0),
        (2.6, -0.004),
        (2.8, 0.0),
        (3.0, 0.005),
    ];
    let rest = [(1.0, 0.9), (1.5, -0.6), (4.0, -0.08), (5.0, 0.5)];
    let curve = Curve {
        marks: dwell.into_iter().chain(rest).map(mark).collect(),
        ..Curve::default()
    };
    let marked: Vec<f64> = curve
        .marks(-1.0, 1.0)
        .iter()
        .map(|mark| mark.crank)
        .collect();
    assert_eq!(marked, [1.0, 1.5, 2.0, 3.0, 4.0, 5.0]);
    // The least value is marked, wherever it is.
    let marked = Curve {
        marks: dwell.into_iter().map(mark).collect(),
        ..Curve::default()
    };
    let marked: Vec<f64> = marked
        .marks(-1.0, 1.0)
        .iter()
        .map(|mark| mark.crank)
        .collect();
    assert_eq!(marked, [2.0, 2.6, 3.0]);
    // If the dwell fills the plot, its extrema are distinct.
    let marked = curve.marks(-0.01, 0.01);
    assert_eq!(marked.len(), dwell.len());
}

#[test]
fn a_constant_has_room() {
    let range = range([1.0, 1.0].into_iter());
    assert!(range.min < 0.9 && range.max > 1.1);
}
