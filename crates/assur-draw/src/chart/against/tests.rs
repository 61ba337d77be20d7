use assur::Jet;
use assur::motion::InputRate;

use super::super::Sample;
use super::*;

const SETTINGS: Settings = Settings {
    input: InputRate::ANALOGUES,
    physical: false,
    differenced: false,
};

fn axis(kind: Kind, order: usize) -> Axis {
    Axis {
        name: Some("C.x".to_owned()),
        kind,
        order,
    }
}

/// A circle of radius 2 about (5, 1), traced once.
fn circle(order: usize) -> Against {
    let samples = (0..=360).map(|degrees| {
        let input = f64::from(degrees).to_radians();
        let (sin, cos) = Jet::<3>::linear(input, 1.0).sin_cos();
        let jets = vec![cos * 2.0 + 5.0, sin * 2.0 + 1.0];
        (input, Sample { jets, clear: true })
    });
    let axes = [axis(Kind::Length, order), axis(Kind::Length, order)];
    Against::new(axes, Role::Y, &[samples.collect()], true, SETTINGS)
}

fn field(against: &Against, [width, height]: [u32; 2]) -> Option<Field> {
    let fine = FINE.unsigned_abs();
    against.field((width * fine, height * fine), 1.0)
}

#[test]
fn lengths_have_one_scale() {
    for order in [0, 1, 2] {
        let field = field(&circle(order), [640, 340]).unwrap();
        let [[x0, x1], [y0, y1]] = field.spans;
        let [across, up] = [field.width / (x1 - x0), field.height / (y1 - y0)];
        assert!((across / up - 1.0).abs() < 1e-12, "{across} {up}");
        let [run] = &field.curve[..] else {
            panic!("{} runs", field.curve.len())
        };
        let centre = if order == 0 { [5.0, 1.0] } else { [0.0, 0.0] };
        let turned = [0.0, 0.5, 1.0][order] * std::f64::consts::PI;
        for one in run {
            let (sin, cos) = (one.input + turned).sin_cos();
            let x = field.left + across * (centre[0] + 2.0 * cos - x0);
            let y = field.top + up * (y1 - centre[1] - 2.0 * sin);
            assert!((one.at[0] - x).hypot(one.at[1] - y) < 1e-9, "{one:?}");
        }
        assert_eq!(run.len(), 361);
    }
}

#[test]
fn other_axes_fill_the_field() {
    let mut against = circle(0);
    against.axes[0] = axis(Kind::Angle, 0);
    let filled = field(&against, [640, 340]).unwrap();
    assert_eq!(filled.spans, [[2.6, 7.4], [-1.4, 3.4]]);
    let degrees: Vec<f64> = filled.ticks[0].iter().map(|tick| tick.value).collect();
    assert_eq!(
        degrees,
        [
            150.0, 180.0, 210.0, 240.0, 270.0, 300.0, 330.0, 360.0, 390.0, 420.0
        ]
    );
    assert_eq!(field(&against, [70, 340]), None);
}

#[test]
fn curves_are_cut_where_they_leave() {
    let spans = [[0.0, 10.0], [0.0, 10.0]];
    let passed = |(k, at): (usize, &[f64; 2])| Passed {
        input: k as f64,
        at: *at,
    };
    let run = |points: &[[f64; 2]]| points.iter().enumerate().map(passed).collect::<Vec<_>>();
    let seen = within(
        &run(&[[2.0, 2.0], [2.0, 14.0], [6.0, 14.0], [6.0, 6.0], [6.0, 6.0]]),
        spans,
    );
    let told: Vec<Vec<(f64, [f64; 2])>> = (seen.iter())
        .map(|part| part.iter().map(|one| (one.input, one.at)).collect())
        .collect();
    let expected = [
        vec![(0.0, [2.0, 2.0]), (2.0 / 3.0, [2.0, 10.0])],
        vec![(2.5, [6.0, 10.0]), (3.0, [6.0, 6.0]), (4.0, [6.0, 6.0])],
    ];
    assert_eq!(told, expected);
    // One segment may cross the whole field.
    let crossing = within(&run(&[[-10.0, 5.0], [30.0, 5.0]]), spans);
    let inputs: Vec<f64> = crossing[0].iter().map(|one| one.input).collect();
    assert_eq!(inputs, [0.25, 0.5]);
    assert!(within(&run(&[[-1.0, 5.0], [-1.0, 8.0]]), spans).is_empty());
}
