use assur::FourBar;

use super::*;

/// The input axis, in degrees, of a four-bar whose coupler and output link both have this length. The crank swings
/// about 0. At both ends of its swing, coupler and output link are in line.
fn of(link: f64) -> [f64; 2] {
    let four_bar = FourBar::new([1.0, link, link, 4.0]).unwrap();
    super::panel::axis(&four_bar.cycle()).map(f64::to_degrees)
}

/// The greatest angle of the crank of a four-bar as in [`of`], degrees, by the law of cosines.
fn reach(link: f64) -> f64 {
    ((17.0 - 4.0 * link * link) / 8.0).acos().to_degrees()
}

#[test]
fn the_axis_spans_only_what_a_crank_swings_over() {
    for (link, about) in [(2.0, 83.0), (1.5005, 2.23), (1.50005, 0.71)] {
        let reach = reach(link);
        assert!((reach / about - 1.0).abs() < 0.02, "{reach}");
        // The margin is a share of the whole arc.
        let end = reach * (1.0 + 2.0 * BESIDE);
        let [from, to] = of(link);
        assert!((from + end).abs() < 1e-6, "{from} {end}");
        assert!((to - end).abs() < 1e-6, "{to} {end}");
    }
}

#[test]
fn the_axis_of_an_instant_or_of_nearly_a_turn_is_a_turn() {
    for link in [1.5 + 1e-6, 2.499] {
        let [from, to] = of(link);
        assert_eq!((from, to), (-180.0, 180.0), "{link}");
    }
}
