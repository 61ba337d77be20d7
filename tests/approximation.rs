//! Approximations of paths drawn by hand, moved by the engine: the mechanism traces what the search promises.

use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur::synthesis::approximation::{
    Course, Kind, Norm, PathVerdict, Search, Target, Tracing, Wanted,
};
use assur::synthesis::four_bar::Passage;
use assur::{Point, Vector};
use assur_tests::scaled;

use crate::properties::random::Random;

/// Relative to the size of the path.
const ROUNDING: f64 = 1e-9;

/// A closed path of three harmonics with the noise of a hand.
fn drawn(random: &mut Random) -> Vec<Point> {
    let [a, b, c, d] = std::array::from_fn(|_| random.within(-0.4, 0.4));
    let turn = std::f64::consts::TAU / 80.0;
    let place = |k: u32| {
        let t = f64::from(k) * turn;
        let mut noise = || random.within(-0.005, 0.005);
        let x = 5.0 + t.cos() + a * (2.0 * t).cos() + b * (2.0 * t).sin() + noise();
        let y = -2.0 + 0.7 * t.sin() + c * (2.0 * t).sin() + d * (3.0 * t).cos() + noise();
        Point::new(x, y)
    };
    (0..80).map(place).collect()
}

/// Distance of a place from the nearest of given places.
fn off(place: Point, places: &[Point]) -> f64 {
    let distances = places.iter().map(|other| (other - place).norm());
    distances.fold(f64::INFINITY, f64::min)
}

#[test]
fn mechanisms_trace_what_the_search_promises() {
    let mut random = Random::new(5);
    for k in 0..scaled(4_u16) {
        let points = drawn(&mut random);
        let kind = [Kind::FourBar, Kind::SliderCrank][usize::from(k) % 2];
        let norm = [Norm::Greatest, Norm::Squares][usize::from(k) / 2 % 2];
        let target = Target::new(&points, Course::Closed, None).unwrap();
        let size = target.size();
        let wanted = Wanted {
            norm,
            four_bars: kind == Kind::FourBar,
            slider_cranks: kind == Kind::SliderCrank,
            seed: k.into(),
            ..Wanted::default()
        };
        let mut search = Search::new(target, wanted);
        search.step(6_000);
        for found in search.found() {
            assert_eq!(
                matches!(found.linkage, Tracing::FourBar(_)),
                kind == Kind::FourBar
            );
            let mechanism = Mechanism::new(&found.linkage.spec()).unwrap();
            let motion = Motion::new(mechanism);
            assert!(motion.cycle().is_full(), "{found:?}");
            let point = motion.mechanism().point("P").unwrap();
            let traced = |input: f64| {
                let pose = motion.pose::<2>(input).unwrap();
                let here = motion.mechanism().place(&pose, point);
                [here.place().coords, here.derivative(1)]
            };
            let place = |input: f64| Point::from(traced(input)[0]);
            // At the inputs given for the places of the path the point is as near to the path as promised.
            let on_path: Vec<Point> = (0..points.len())
                .flat_map(|k| {
                    let (from, to) = (points[k], points[(k + 1) % points.len()]);
                    (0..20).map(move |j| from + (to - from) * (f64::from(j) / 20.0))
                })
                .collect();
            let step = size * 0.01;
            for input in &found.inputs {
                let far = off(place(*input), &on_path);
                assert!(far <= found.deviation.greatest + step, "{far} {found:?}");
            }
            // The curve that is drawn is the curve of the mechanism.
            let curve = found.curve(73);
            assert!((curve[0] - curve[72]).norm() < ROUNDING * size);
            // Near a dead point the traced point is fast. There the crank lies along the frame or across the guide: the
            // reference is an eighth of a turn away from both.
            const AWAY: usize = 9;
            let from = nearest_input(&traced, curve[AWAY]);
            let turn = std::f64::consts::TAU / 72.0;
            // A mirror image runs the other way.
            let matches = [turn, -turn].into_iter().any(|turn| {
                let input = |k: usize| from + turn * (k as f64 - AWAY as f64);
                let near = |k: usize| (place(input(k)) - curve[k]).norm();
                (0..72).all(|k| near(k) < 1e-6 * size)
            });
            assert!(matches, "{found:?}");
            if let Some(PathVerdict::FourBar(verdict)) = found.verdict {
                assert_eq!(verdict.passage, Passage::Continuous);
                assert!(verdict.turns);
            }
        }
    }
}

/// The input at which a point comes nearest to a place: a grid, then halving where the distance neither grows nor falls.
fn nearest_input(traced: &impl Fn(f64) -> [Vector; 2], place: Point) -> f64 {
    let off = |input: f64| traced(input)[0] - place.coords;
    let along = |input: f64| off(input).dot(&traced(input)[1]);
    let grid = (0..3_600).map(|k| f64::from(k) * std::f64::consts::TAU / 3_600.0);
    let best = grid
        .min_by(|a, b| off(*a).norm().total_cmp(&off(*b).norm()))
        .unwrap_or(0.0);
    let (mut low, mut high) = (best - 2e-3, best + 2e-3);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if along(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}
