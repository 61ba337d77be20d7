//! Speed of the engine, natively and in the browser, beside a reference computation in the same run. `cargo xtask
//! bench` prints the times; none is asserted. Each line reads `speed: NAME = NANOSECONDS`.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a benchmark that cannot run has failed"
)]

#[path = "speed/coupled.rs"]
mod coupled;
#[path = "speed/linkages.rs"]
mod linkages;
#[path = "speed/paths.rs"]
mod paths;
#[path = "speed/schemes.rs"]
mod schemes;

use std::f64::consts::TAU;
use std::hint::black_box;

use assur::dynamics::TICKS_PER_SECOND;
use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur::mobility::Space;
use assur::motion::InputRate;
use assur::synthesis::four_bar::{Family, Frame, Position, Search, Task, TwoPositions};
use assur::{Assembly, FourBar, Pose};
use schemes::Net;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

const LENGTHS: [f64; 4] = [0.37, 0.85, 0.55, 0.85];
/// Number of crank angles in a sweep, and number of sweeps between two readings of the clock.
const SAMPLES: usize = 720;
const SWEEPS: usize = 40;
/// Number of rounds, in each of which every computation is timed once; the median is printed.
const ROUNDS: usize = 25;

/// A timed computation: its name, the number of units in a run, and the run.
type Contestant = (&'static str, usize, Box<dyn FnMut()>);

/// Six columns: φ₂, φ₃ and both derivatives of each.
type Columns = [Vec<f64>; 6];

#[wasm_bindgen_test(unsupported = test)]
fn speed() {
    let linkage = FourBar::new(LENGTHS).unwrap();
    let moving = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
    let rocker = Quantity::named(moving.mechanism(), "rocker.angle").unwrap();
    let mut columns: Columns = std::array::from_fn(|_| vec![0.0; SAMPLES]);
    let mut contestants: Vec<Contestant> = Vec::new();
    let mut own = columns.clone();
    contestants.push((
        "yardstick, scalar closed form, full state",
        SAMPLES * SWEEPS,
        Box::new(move || sweeps(|i, crank| yardstick(&mut columns, i, crank))),
    ));
    contestants.push((
        "engine, full state",
        SAMPLES * SWEEPS,
        Box::new(move || sweeps(|i, crank| store(&mut own, i, &linkage, crank))),
    ));
    contestants.push((
        "engine, position",
        SAMPLES * SWEEPS,
        Box::new(move || {
            sweeps(|_, crank| {
                black_box(linkage.pose::<1>(Assembly::First, crank)).unwrap();
            });
        }),
    ));
    contestants.push((
        "engine, all extrema of a motion",
        1,
        Box::new(move || {
            let _ = black_box(moving.features(&[rocker], InputRate::ANALOGUES));
        }),
    ));
    let family = family();
    contestants.push((
        "family with verdicts at 1,000 points",
        1,
        Box::new(move || {
            black_box(family.sample([0.0, 1.0], 1000));
        }),
    ));
    let eight = eight_positions();
    contestants.push((
        "eight positions, least squares",
        1,
        Box::new(move || {
            black_box(Search::new(&eight).run());
        }),
    ));
    let free = eight_positions();
    contestants.push((
        "eight positions, least squares with free starts",
        1,
        Box::new(move || {
            black_box(Search::free(&free).run());
        }),
    ));
    contestants.extend(linkages::contestants());
    contestants.extend(paths::contestants());
    for (name, load) in [
        ("a second of the differential, synchronous", 5.0),
        ("a second of the differential, slipping", 25.0),
    ] {
        let mut run = coupled::run(load);
        contestants.push((
            name,
            1,
            Box::new(move || run.advance(TICKS_PER_SECOND).unwrap()),
        ));
    }

    for (name, net, planar) in [
        ("200 links in a ladder, in the plane", Net::Ladder, true),
        ("200 links in a ladder, in space", Net::Ladder, false),
        ("200 links at random, in the plane", Net::Random, true),
        ("200 links at random, in space", Net::Random, false),
    ] {
        let scheme = schemes::scheme(net, planar);
        let space = if planar { Space::Plane } else { Space::Whole };
        contestants.push((
            name,
            1,
            Box::new(move || {
                black_box(schemes::judge(&scheme, space));
            }),
        ));
    }

    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..ROUNDS {
        for ((_, count, run), times) in contestants.iter_mut().zip(&mut times) {
            let start = clock::nanoseconds();
            run();
            times.push((clock::nanoseconds() - start) / *count as f64);
        }
    }
    for ((name, _, _), times) in contestants.iter().zip(&mut times) {
        times.sort_by(f64::total_cmp);
        clock::say(&format!("speed: {name} = {:.2}", times[ROUNDS / 2]));
    }
}

fn task(positions: &[Position]) -> Task {
    let frame = Frame {
        length: 10.4,
        angle: 0.0,
    };
    Task::new(frame, positions, Task::RATIOS).unwrap()
}

/// The worked example of the paper.
fn family() -> Family {
    let positions = [(240.0_f64, 45.0_f64), (253.0, 60.0)];
    let positions = positions.map(|(a, b)| Position::new(a.to_radians(), b.to_radians()));
    match TwoPositions::new(&task(&positions)) {
        Some(TwoPositions::Family(family)) => family,
        other => panic!("{other:?}"),
    }
}

/// A task of y = log₂ x from 1 to 2, solved approximately by a four-bar, from poor starting points.
fn eight_positions() -> Task {
    let positions = (0..8).map(|k| {
        let x = 1.0 + f64::from(k) / 7.0;
        Position::new(2.0 - x.log2(), 0.6 + x - 1.0)
    });
    task(&positions.collect::<Vec<_>>())
}

fn sweeps(mut state: impl FnMut(usize, f64)) {
    for _ in 0..SWEEPS {
        for index in 0..SAMPLES {
            state(index, black_box(TAU * index as f64 / SAMPLES as f64));
        }
    }
}

fn store(columns: &mut Columns, index: usize, linkage: &FourBar, crank: f64) {
    let pose: Pose<3> = linkage.pose(Assembly::First, crank).unwrap();
    for order in 0..3 {
        columns[2 * order][index] = pose.coupler.derivative(order);
        columns[2 * order + 1][index] = pose.rocker.derivative(order);
    }
}

/// The plain closed form as the reference: one sine and cosine, two arctangents, without regard to folds, change points
/// or continuity.
fn yardstick(columns: &mut Columns, index: usize, crank: f64) {
    let [l1, l2, l3, l4] = LENGTHS;
    let (s1, c1) = crank.sin_cos();
    let (x, y) = (l4 - l1 * c1, -l1 * s1);
    let square = x * x + y * y;
    // The direction of the coupler is that of the diagonal, turned by the angle at B.
    let along = (l2 * l2 - l3 * l3 + square) / (2.0 * l2);
    let across = (square - along * along).sqrt();
    let (c2, s2) = (
        (x * along - y * across) / square,
        (y * along + x * across) / square,
    );
    let (c3, s3) = ((l2 * c2 - x) / l3, (l2 * s2 - y) / l3);
    let sine = s3 * c2 - c3 * s2;
    let v3 = l1 * (s1 * c2 - c1 * s2) / (l3 * sine);
    let v2 = l1 * (s1 * c3 - c1 * s3) / (l2 * sine);
    let (c12, c13, c32) = (c1 * c2 + s1 * s2, c1 * c3 + s1 * s3, c3 * c2 + s3 * s2);
    let a3 = (l1 * c12 + v2 * v2 * l2 - v3 * v3 * l3 * c32) / (l3 * sine);
    let a2 = (l1 * c13 - v3 * v3 * l3 + v2 * v2 * l2 * c32) / (l2 * sine);
    let row = [s2.atan2(c2), s3.atan2(c3), v2, v3, a2, a3];
    for (column, value) in columns.iter_mut().zip(row) {
        column[index] = value;
    }
}

/// Reading of the clock and printing, on either target.
mod clock {
    #[cfg(target_family = "wasm")]
    pub(super) fn nanoseconds() -> f64 {
        let performance = web_sys::window().and_then(|window| window.performance());
        performance.map_or(f64::NAN, |performance| performance.now() * 1e6)
    }

    #[cfg(not(target_family = "wasm"))]
    pub(super) fn nanoseconds() -> f64 {
        use std::sync::OnceLock;
        use std::time::Instant;
        static START: OnceLock<Instant> = OnceLock::new();
        START.get_or_init(Instant::now).elapsed().as_nanos() as f64
    }

    #[cfg(target_family = "wasm")]
    pub(super) fn say(line: &str) {
        wasm_bindgen_test::console_log!("{line}");
    }

    #[cfg(not(target_family = "wasm"))]
    pub(super) fn say(line: &str) {
        println!("{line}");
    }
}
