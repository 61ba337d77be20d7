use super::*;

/// Crank 1 about the origin, rod 2, slider on a line 0.5 above: the crank turns. With a rod of 1 it reaches
/// sin φ = −0.5.
#[test]
fn slider_cranks() {
    let point = Point::new(1.0, 0.0);
    let crank = Dyad::Hinges {
        pivot: Point::origin(),
        point,
    };
    let slider = |x: f64| Dyad::Slider {
        point: Point::new(x, 0.5),
        along: Vector::x(),
    };
    let of = |rod: f64| {
        let x = 1.0 + (rod * rod - 0.25).sqrt();
        Driven::new([crank, slider(x)], 1.0).unwrap()
    };
    let turning = of(2.0);
    assert!(turning.is_free);
    // The crank pin is farthest from the line at −90°: 1.5, with a rod of 2.
    let least = turning.least_transmission([-PI, PI]);
    assert!((least - 0.75_f64.acos()).abs() < 1e-14);
    let swinging = of(1.0);
    assert!(!swinging.is_free);
    let [[from, to]] = swinging.arcs[..] else {
        panic!("{:?}", swinging.arcs);
    };
    assert!((from.sin() + 0.5).abs() < 1e-12 && (to.sin() + 0.5).abs() < 1e-12);
    assert!(
        (to - from - 240_f64.to_radians()).abs() < 1e-7,
        "{from} {to}"
    );
}

/// Crank 3 and frame 4 with a line of the body at 1 from the crank's end: the distance is from 1 to 7.
#[test]
fn an_inverted_slider_crank() {
    let crank = Dyad::Hinges {
        pivot: Point::origin(),
        point: Point::new(0.0, 3.0),
    };
    let block = |along: Vector| Dyad::Block {
        pivot: Point::new(4.0, 0.0),
        along,
    };
    // The line through (4, 0) along (4, −3)/5 passes through B. A line across it has the whole distance 5 as offset.
    let through = Driven::new([crank, block(Vector::new(0.8, -0.6))], 1.0).unwrap();
    assert!(through.is_free && (through.least_transmission([0.0, TAU]) - PI / 2.0).abs() < 1e-12);
    let across = Driven::new([crank, block(Vector::new(0.6, 0.8))], 1.0).unwrap();
    let [[from, to]] = across.arcs[..] else {
        panic!("{:?}", across.arcs);
    };
    assert!((from - PI / 2.0).abs() < 1e-7 && (to - 1.5 * PI).abs() < 1e-7);
}

/// Sliders on both axes, at a distance of 5 from each other: the first one moves up to 5 from the origin.
#[test]
fn a_double_slider() {
    let (point, along) = (Point::new(3.0, 0.0), Vector::x());
    let first = Dyad::Slider { point, along };
    let second = Dyad::Slider {
        point: Point::new(0.0, 4.0),
        along: Vector::y(),
    };
    let driven = Driven::new([first, second], 1.0).unwrap();
    let [[from, to]] = driven.arcs[..] else {
        panic!("{:?}", driven.arcs);
    };
    assert!((from + 8.0).abs() < 1e-14 && (to - 2.0).abs() < 1e-14);
    assert_eq!(driven.period(), None);
    assert_eq!(
        Driven::new(
            [
                first,
                Dyad::Slider {
                    point: Point::new(0.0, 4.0),
                    along
                }
            ],
            1.0
        ),
        Err(Parallel)
    );
}
