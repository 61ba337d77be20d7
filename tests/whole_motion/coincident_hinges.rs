//! Dyads of equal links whose outer hinges coincide: the motion goes on if the vector between them has a simple zero.

use super::*;

/// Rockers of a parallelogram with three bays, in line with its rods at the input 0. They are parallel at any distance
/// from there, and turn alike.
#[test]
fn parallel_rockers_pass_the_pivots_of_their_neighbours() {
    let mut draft = LinkageSpec::default();
    let names = ["0", "1", "2", "3"];
    for (k, name) in names.into_iter().enumerate() {
        let x = k as f64;
        let (foot, head) = (format!("A{name}"), format!("B{name}"));
        draft = draft.point(&foot, x, 0.0).point(&head, x + 0.6, 0.8);
        draft = draft.bar(name, &[&foot, &head]);
    }
    for pair in names.windows(2) {
        let ends = [format!("B{}", pair[0]), format!("B{}", pair[1])];
        draft = draft.bar(&format!("rod {}", pair[0]), &[&ends[0], &ends[1]]);
    }
    let motion = moved(&draft.fixed(&["A0", "A1", "A2", "A3"]).crank("0"));
    assert!(motion.cycle().is_full(), "{:?}", motion.dead_points());
    let angles = ["1", "2", "3"].map(|name| quantity(&motion, &format!("{name}.angle")));
    let mut worst = [0.0_f64; 3];
    let near = (-17..=0).flat_map(|power| [10_f64.powi(power), -(10_f64.powi(power))]);
    for input in near.chain([0.0, 0.1309, 0.13, -0.1309, 0.05, 2.0, PI, 4.0]) {
        let pose = motion.pose::<3>(input).unwrap();
        for angle in angles {
            let angle = angle.of(motion.mechanism(), &pose);
            let off = [
                (angle.value() - input).sin().abs(),
                (angle.derivative(1) - 1.0).abs(),
                angle.derivative(2).abs(),
            ];
            for (worst, off) in worst.iter_mut().zip(off) {
                *worst = worst.max(off);
            }
        }
    }
    println!("parallel rockers: {worst:?}");
    assert!(
        worst[0] < 1e-12 && worst[1] < 1e-10 && worst[2] < 1e-8,
        "{worst:?}"
    );
}

const CRANK_ROCKER: [(&str, f64, f64); 5] = [
    ("A", 0.0, 0.0),
    ("B", 1.0, 0.5),
    ("C", 3.4, 2.6),
    ("D", 3.0, 0.0),
    ("E", 1.6, 2.2),
];

/// A crank-rocker with the coupler point E, and a dyad of two links as long as each other from E to the fixed point F.
fn with_dyad(tracer: Vector, fixed: Vector) -> LinkageSpec {
    let base = fixed - tracer;
    let inner = tracer + base * 0.5 + Vector::new(-base.y, base.x).normalize() * 4.0;
    CRANK_ROCKER[..4]
        .iter()
        .fold(LinkageSpec::default(), |draft, (name, x, y)| {
            draft.point(name, *x, *y)
        })
        .point("E", tracer.x, tracer.y)
        .point("F", fixed.x, fixed.y)
        .point("G", inner.x, inner.y)
        .fixed(&["A", "D", "F"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C", "E"])
        .bar("rocker", &["D", "C"])
        .bar("arm", &["E", "G"])
        .bar("lever", &["F", "G"])
        .crank("crank")
}

fn tracer() -> Vector {
    let (_, x, y) = CRANK_ROCKER[4];
    Vector::new(x, y)
}

/// The coupler curve of the crank-rocker alone.
fn curve() -> impl Fn(f64) -> Vector {
    let draft = CRANK_ROCKER
        .iter()
        .fold(LinkageSpec::default(), |draft, (name, x, y)| {
            draft.point(name, *x, *y)
        })
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C", "E"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    let motion = moved(&draft);
    move |input| place(&motion, "E", input)
}

fn place(motion: &Motion, name: &str, input: f64) -> Vector {
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(input).unwrap();
    mechanism
        .place(&pose, mechanism.point(name).unwrap())
        .place()
        .coords
}

/// Side of EF on which G lies.
fn side(motion: &Motion, input: f64) -> f64 {
    let [e, f, g] = ["E", "F", "G"].map(|name| place(motion, name, input));
    (f - e).perp(&(g - e)).signum()
}

/// E passes F at one input of each turn. There G stays where it is and changes its side of EF: the motion repeats after
/// two turns. Away from there G is found from E and F by hand.
#[test]
fn a_coupler_point_passes_the_fixed_hinge() {
    let curve = curve();
    for k in 0..12 {
        let at = 0.4 + TAU * f64::from(k) / 12.0;
        let motion = moved(&with_dyad(tracer(), curve(at)));
        let full = motion.cycle().period();
        assert!((full.unwrap() - 2.0 * TAU).abs() < 1e-12, "{at}: {full:?}");
        for pass in [at, at + TAU] {
            let jump = |gap: f64| {
                (place(&motion, "G", pass + gap) - place(&motion, "G", pass - gap)).norm()
            };
            for gap in [1e-13, 1e-9, 1e-6, 1e-4] {
                assert!(jump(gap) < 50.0 * gap + 1e-12, "{at}, {gap}: {}", jump(gap));
            }
            assert!(
                side(&motion, pass + 1e-3) * side(&motion, pass - 1e-3) < 0.0,
                "{at}"
            );
        }
        for step in 0..40 {
            let input = 0.77 + 2.0 * TAU * f64::from(step) / 40.0;
            let [e, f, g] = ["E", "F", "G"].map(|name| place(&motion, name, input));
            let base = f - e;
            let length = |from: Vector| (g - from).norm();
            assert!((length(e) - length(f)).abs() < 1e-12, "{at}, {input}");
            let height = (length(e).powi(2) - 0.25 * base.norm_squared()).sqrt();
            let across = Vector::new(-base.y, base.x).normalize() * side(&motion, input);
            assert!((e + base * 0.5 + across * height - g).norm() < 1e-9);
        }
    }
}

/// If E passes F at a small distance, G turns to the other side at once, or the motion ends; it never changes its side
/// of EF.
#[test]
fn a_near_miss_does_not_change_the_side() {
    let curve = curve();
    for power in [-2, -4, -6, -8, -10] {
        let at = 2.3;
        let along = curve(at + 1e-5) - curve(at - 1e-5);
        let miss = Vector::new(-along.y, along.x).normalize() * 10_f64.powi(power);
        let motion = moved(&with_dyad(tracer(), curve(at) + miss));
        let drawn = motion.drawn_input();
        let sides: Vec<f64> = (0..500)
            .map(|step| drawn + TAU * f64::from(step) / 500.0)
            .filter(|input| motion.pose::<1>(*input).is_ok())
            .map(|input| side(&motion, input))
            .collect();
        println!(
            "miss 1e{power}: {} poses, {:?}",
            sides.len(),
            motion.dead_points()
        );
        assert!(sides.len() > 10);
        assert!(sides.iter().all(|one| one == &sides[0]), "1e{power}");
    }
}

/// At a cusp of the coupler curve E touches F and goes back: the vector EF has a double zero. The motion ends there.
#[test]
fn a_cusp_ends_the_motion() {
    let [a, b, c, d, _] = CRANK_ROCKER.map(|(_, x, y)| Vector::new(x, y));
    // The instant centre of the coupler, in which its point has no velocity: on AB and on DC.
    let (along, other) = (b - a, c - d);
    let centre = a + along * ((d - a).perp(&other) / along.perp(&other));
    // The coupler with that point in another pose, so that E and F are apart in the drawing.
    let draft = CRANK_ROCKER[..4]
        .iter()
        .fold(LinkageSpec::default(), |draft, (name, x, y)| {
            draft.point(name, *x, *y)
        })
        .point("E", centre.x, centre.y)
        .fixed(&["A", "D"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C", "E"])
        .bar("rocker", &["D", "C"])
        .crank("crank");
    let free = moved(&draft);
    let drawn = free.drawn_input();
    let places = ["A", "B", "C", "D", "E"].map(|name| place(&free, name, drawn + 1.0));
    let base = centre - places[4];
    let inner = places[4] + base * 0.5 + Vector::new(-base.y, base.x).normalize() * 9.0;
    let names = ["A", "B", "C", "D", "E", "F", "G"];
    let all = places.into_iter().chain([centre, inner]);
    let draft = names
        .into_iter()
        .zip(all)
        .fold(LinkageSpec::default(), |draft, (name, at)| {
            draft.point(name, at.x, at.y)
        })
        .fixed(&["A", "D", "F"])
        .bar("crank", &["A", "B"])
        .bar("coupler", &["B", "C", "E"])
        .bar("rocker", &["D", "C"])
        .bar("arm", &["E", "G"])
        .bar("lever", &["F", "G"])
        .crank("crank");
    let motion = moved(&draft);
    let ends = motion.dead_points();
    println!("cusp at {drawn}: {ends:?}");
    assert!(!motion.cycle().is_full());
    for end in ends {
        let off = (end.input - drawn).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 1e-6, "{end:?}");
    }
}
