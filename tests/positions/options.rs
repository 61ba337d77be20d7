//! The options for each number of given positions, and the main equation.

use assur::synthesis::four_bar::{NoOptions, Options, Position, Proportions, Solution, Task};

use super::draw::task;

/// Positions of output and input in degrees.
fn positions(degrees: &[(f64, f64)]) -> Vec<Position> {
    let radians =
        |(output, input): &(f64, f64)| Position::new(output.to_radians(), input.to_radians());
    degrees.iter().map(radians).collect()
}

fn given(degrees: &[(f64, f64)]) -> Task {
    task(&positions(degrees))
}

const EXAMPLE: [(f64, f64); 2] = [(240.0, 45.0), (253.0, 60.0)];
const THREE: [(f64, f64); 3] = [(272.0, 30.0), (280.0, 75.0), (298.0, 120.0)];

#[test]
fn by_how_many_positions() {
    let two = Options::new(&given(&EXAMPLE), false).unwrap();
    assert!(matches!(two, Options::Family(_)));
    assert!(two.solutions().is_empty());
    let three = Options::new(&given(&THREE), false).unwrap();
    assert!(matches!(&three, Options::Exact(all) if all.len() == 1));
    let mut many = THREE.to_vec();
    many.extend([(311.0, 150.0), (320.0, 180.0)]);
    let searched = Options::new(&given(&many), false).unwrap();
    let Options::Minima { minima, starts } = &searched else {
        panic!("{searched:?}");
    };
    let reached: usize = minima.iter().map(|one| one.reached).sum();
    assert_eq!(reached, *starts);
    // The best that no bound holds comes before others, though one at a bound may be better.
    let best = &minima[searched.best()];
    let inner = minima.iter().filter(|one| one.held.is_empty());
    let least = inner.map(|one| one.value).fold(f64::INFINITY, f64::min);
    assert!(best.held.is_empty() && best.value == least, "{best:?}");
    let free = Options::new(&given(&many), true).unwrap();
    assert!(matches!(free, Options::Exact(all) if !all.is_empty()));
}

#[test]
fn why_there_are_none() {
    let none = |degrees: &[(f64, f64)], free| Options::new(&given(degrees), free).unwrap_err();
    assert_eq!(none(&EXAMPLE[..1], false), NoOptions::TooFew { least: 2 });
    assert_eq!(none(&THREE, true), NoOptions::TooFew { least: 5 });
    let [one, other] = [(90.0, 120.0), (60.0, 100.0)];
    assert!(matches!(none(&[one, other], false), NoOptions::NoFamily(_)));
    let mirrored = [(70.0, 40.0), (-70.0, -40.0)];
    assert_eq!(none(&mirrored, false), NoOptions::Any);
    let negative = none(&[(240.0, 45.0), (253.0, 60.0), (230.0, 75.0)], false);
    let NoOptions::Negative { output, input } = negative else {
        panic!("{negative:?}");
    };
    assert!(output < 0.0 || input < 0.0);
}

/// Both sides are equal where the contour closes, and differ by the weighted difference where not.
#[test]
fn main_equation() {
    for degrees in [&EXAMPLE[..], &THREE] {
        let task = given(degrees);
        let exact = match Options::new(&task, false).unwrap() {
            Options::Family(family) => family.with_output(0.5).unwrap(),
            options => options.solutions()[0].clone(),
        };
        for equation in exact.main_equations(&task) {
            let off = equation.right() - equation.left;
            assert!(off.abs() < 1e-12, "{equation:?}");
        }
    }
    let task = given(&EXAMPLE);
    let printed = Proportions {
        coupler: 10.0 / 10.4,
        output: 5.0 / 10.4,
        input: 4.0 / 10.4,
    };
    let shown = Solution::new(&task, printed);
    for (equation, closure) in shown.main_equations(&task).iter().zip(&shown.closures) {
        let Proportions {
            coupler,
            output,
            input,
        } = printed;
        let gap = closure.residual + coupler;
        let difference = gap * gap - coupler * coupler;
        let off = equation.left - equation.right();
        assert!((off - difference / (2.0 * output * input)).abs() < 1e-12);
        assert!(off.abs() > 1e-3, "{equation:?}");
    }
}
