//! A wanted function: precision positions, least squares, the error curve.

use std::f64::consts::PI;

use assur::synthesis::four_bar::{
    FunctionError, Mapping, Position, Search, Solution, Table, Task, ThreePositions, chebyshev,
    five_positions,
};

use super::draw::{output, task};

/// y = log₁₀ x from 1 to 10, φ₃ over 60°, φ₂ over 90°.
fn mapping() -> Mapping {
    let degrees = |ends: [f64; 2]| ends.map(f64::to_radians);
    Mapping::new(
        [1.0, 10.0],
        [0.0, 1.0],
        degrees([30.0, 90.0]),
        degrees([120.0, 30.0]),
    )
    .unwrap()
}

fn three(positions: &[Position]) -> Solution {
    match ThreePositions::new(&task(positions)) {
        Some(ThreePositions::One(solution)) => solution,
        other => panic!("{other:?}"),
    }
}

#[test]
fn chebyshev_spacing() {
    let places = chebyshev([1.0, 3.0], 3);
    let half = 3.0_f64.sqrt() / 2.0;
    for (place, expected) in places.iter().zip([2.0 - half, 2.0, 2.0 + half]) {
        assert!((place - expected).abs() < 1e-15, "{places:?}");
    }
    assert!((chebyshev([0.0, 1.0], 1)[0] - 0.5).abs() < 1e-15);
    assert!(chebyshev([0.0, 1.0], 7).is_sorted_by(|a, b| a < b));
}

#[test]
fn error_vanishes_at_precision_positions() {
    let mapping = mapping();
    let f = |x: f64| x.log10();
    let positions = mapping.precision(3, &f).unwrap();
    let solution = three(&positions);
    let task = task(&positions);
    let curve = mapping
        .error_curve(&task, &solution, 200, &f)
        .unwrap()
        .unwrap();
    assert!(curve.complete);
    assert_eq!(curve.samples.len(), 200);
    assert_eq!((curve.samples[0].x, curve.samples[199].x), (1.0, 10.0));
    // The sign of the error changes three times, at Chebyshev's places.
    let mut zeros = Vec::new();
    for pair in curve.samples.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|sample| sample.error().unwrap());
        if a * b < 0.0 {
            zeros.push(pair[0].x + (pair[1].x - pair[0].x) * a / (a - b));
        }
    }
    assert_eq!(zeros.len(), 3, "{zeros:?}");
    for (zero, place) in zeros.iter().zip(chebyshev([1.0, 10.0], 3)) {
        assert!((zero - place).abs() < 1e-2, "{zeros:?}");
    }
    // The greatest error, by another way and many more places.
    let z = solution.proportions;
    let error = |x: f64| {
        let wanted = mapping.position(x, x.log10());
        let off = [true, false].map(|up| {
            let turned = output(&z, wanted.input, up).unwrap() - wanted.output;
            (turned + PI).rem_euclid(2.0 * PI) - PI
        });
        let off = if off[0].abs() < off[1].abs() {
            off[0]
        } else {
            off[1]
        };
        // A right angle of the output falls while y grows by 1.
        -off / (PI / 2.0)
    };
    let dense = (0..=90_000).map(|k| error(1.0 + f64::from(k) * 1e-4).abs());
    let dense = dense.fold(0.0, f64::max);
    let greatest = curve.greatest.unwrap();
    assert!((greatest.error().unwrap().abs() - dense).abs() < 1e-9);
    assert!((greatest.error().unwrap() - error(greatest.x)).abs() < 1e-12);
    assert!(dense > 1e-3, "{dense}");
}

/// Functions of the literature (Freudenstein 1955; Hartenberg and Denavit 1964). Lengths and greatest errors were worked out apart from
/// this code: Freudenstein's equation at Chebyshev's places by Cramer's rule, then the triangle of coupler and output at 20,001 places.
#[test]
fn functions_of_the_literature() {
    type Known = ([f64; 3], [f64; 2]);
    let check = |f: &dyn Fn(f64) -> f64, x: [f64; 2], ends: [[f64; 2]; 2], known: Known| {
        let [input, output] = ends.map(|ends| ends.map(f64::to_radians));
        let mapping = Mapping::new(x, x.map(f), input, output).unwrap();
        let positions = mapping.precision(3, f).unwrap();
        let solution = three(&positions);
        let z = solution.proportions;
        let (lengths, [error, at]) = known;
        for (found, known) in [z.coupler, z.output, z.input].iter().zip(lengths) {
            assert!((found - known).abs() < 1e-12, "{z:?}");
        }
        let curve = mapping.error_curve(&task(&positions), &solution, 101, f);
        let curve = curve.unwrap().unwrap();
        assert!(curve.complete);
        let greatest = curve.greatest.unwrap();
        assert!((greatest.x - at).abs() < 1e-9);
        assert!((greatest.error().unwrap() - error).abs() < 1e-12);
    };
    check(
        &f64::log10,
        [1.0, 2.0],
        [[90.0, 150.0], [210.0, 270.0]],
        (
            [1.6581561403242848, 0.7156565718615332, 0.7130240539785865],
            [-0.000521470237586174, 2.0],
        ),
    );
    check(
        &|x| x.powf(1.5),
        [1.0, 4.0],
        [[345.0, 405.0], [105.0, 195.0]],
        (
            [3.1854353345417987, 1.2000711124593582, 4.652938288321832],
            [0.006896759194007911, 4.0],
        ),
    );
}

/// y = log₂ x from 1 to 2, both angles over 60°, the starts free: five precision positions are off by
/// less than 10⁻⁴, three from the same starts by more, the least squares of many by less.
#[test]
fn five_and_many_positions_do_better() {
    let f = |x: f64| x.log2();
    let third = PI / 3.0;
    let greatest = |positions: &[Position], solution: &Solution, starts: [f64; 2]| {
        let [output, input] = starts;
        let mapping = started([output, output - third], [input, input + third]);
        let task = task(positions);
        let curve = mapping
            .error_curve(&task, solution, 100, &f)
            .unwrap()
            .unwrap();
        assert!(curve.complete);
        curve.greatest.unwrap().error().unwrap().abs()
    };
    let mapping = started([0.0, -third], [0.0, third]);
    let of_five = mapping.precision(5, &f).unwrap();
    let found = five_positions(&task(&of_five)).unwrap();
    assert_eq!(found.len(), 1);
    let by_five = greatest(&of_five, &found[0], [0.0; 2]);
    assert!(by_five < 1e-4, "{by_five}");

    let starts = [found[0].output_start, found[0].input_start];
    let [output, input] = starts;
    let of_three = started([output, output - third], [input, input + third]);
    let of_three = of_three.precision(3, &f).unwrap();
    let by_three = greatest(&of_three, &three(&of_three), starts);
    assert!(by_three > 1.5 * by_five, "{by_three} {by_five}");

    let many = mapping.even(13, &f).unwrap();
    let best = Search::free(&task(&many)).run().swap_remove(0);
    assert!(best.held.is_empty());
    let by_many = greatest(&many, &best.solution, [0.0; 2]);
    assert!(by_many < by_five, "{by_many} {by_five}");
}

fn started(output: [f64; 2], input: [f64; 2]) -> Mapping {
    Mapping::new([1.0, 2.0], [0.0, 1.0], input, output).unwrap()
}

/// Where the linkage cannot go on, the curve ends, on both sides of the first position.
#[test]
fn the_curve_ends_where_the_linkage_does() {
    let mapping = Mapping::new([0.0, 1.0], [0.0, 1.0], [-3.0, 3.0], [2.0, 4.0]).unwrap();
    let f = |x: f64| x;
    let positions = vec![mapping.position(0.5, 0.5), mapping.position(0.55, 0.6)];
    let task = task(&positions);
    let z = assur::synthesis::four_bar::Proportions {
        coupler: 0.6,
        output: 0.6,
        input: 0.5,
    };
    let solution = Solution::new(&task, z);
    let curve = mapping
        .error_curve(&task, &solution, 61, &f)
        .unwrap()
        .unwrap();
    assert!(!curve.complete);
    let linkage = z.four_bar(1.0).unwrap();
    for sample in &curve.samples {
        let input = -3.0 + 6.0 * sample.x;
        let closes = linkage.pose::<1>(curve.assembly, input).is_ok();
        assert_eq!(sample.generated.is_some(), closes, "{sample:?}");
    }
    // These lengths make no linkage.
    let never = Solution::new(
        &task,
        assur::synthesis::four_bar::Proportions { coupler: 9.0, ..z },
    );
    assert_eq!(mapping.error_curve(&task, &never, 11, &f).unwrap(), None);
}

#[test]
fn tables_are_functions() {
    let table = Table::new(&[[0.0, 1.0], [1.0, 3.0], [4.0, 0.0]]).unwrap();
    assert_eq!(table.interval(), [0.0, 4.0]);
    let values = [-1.0, 0.0, 0.5, 1.0, 2.0, 4.0, 5.0].map(|x| table.value(x));
    assert_eq!(values, [-1.0, 1.0, 2.0, 3.0, 2.0, 0.0, -1.0]);
    assert_eq!(Table::new(&[[0.0, 1.0]]), Err(vec![FunctionError::Rows]));
    let bad = [[0.0, 1.0], [0.0, 2.0], [1.0, f64::NAN], [2.0, 1.0]];
    let expected = vec![FunctionError::Row(1), FunctionError::Row(2)];
    assert_eq!(Table::new(&bad), Err(expected));
}

#[test]
fn refusals_name_what_is_wrong() {
    let bad = Mapping::new(
        [1.0, 1.0],
        [0.0, f64::NAN],
        [0.0, f64::INFINITY],
        [2.0, 2.0],
    );
    let expected = vec![
        FunctionError::Interval,
        FunctionError::Values,
        FunctionError::InputAngles,
        FunctionError::OutputAngles,
    ];
    assert_eq!(bad, Err(expected));
    let mapping = mapping();
    assert_eq!(mapping.precision(0, &|x| x), Err(FunctionError::Count(0)));
    let most = Task::MAX_POSITIONS + 1;
    assert_eq!(mapping.even(most, &|x| x), Err(FunctionError::Count(most)));
    let undefined = mapping.even(3, &|x| if x > 5.0 { f64::NAN } else { x });
    assert_eq!(undefined, Err(FunctionError::Undefined { x: 5.5 }));
}
