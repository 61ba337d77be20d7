use super::*;

const N: usize = 4;
type Moment = super::Moment<N>;

/// Accelerations of four independent coordinates: a pendulum, a damped oscillator, a fan that runs down, and a
/// force that grows with time.
fn accelerations(start: f64, q: &[f64; N], moment: &Moment) -> [f64; N] {
    let at = |n: usize| q[n] + moment.moved[n];
    let v = moment.rates;
    let time = start + moment.time;
    [
        -at(0).sin(),
        -4.0 * at(1) - 0.6 * v[1],
        -v[2] * v[2].abs(),
        time.powi(5),
    ]
}

fn run(steps: u32, end: f64) -> ([f64; N], [f64; N]) {
    let (mut q, mut v) = ([0.3, 1.0, 0.0, 0.0], [1.2, 0.0, 2.0, 0.0]);
    let length = end / f64::from(steps);
    let mut past = Past::NONE;
    for at in 0..steps {
        let start = length * f64::from(at);
        let f = |moment: &Moment| accelerations(start, &q, moment);
        let step = step(&mut past, length, &v, f).unwrap();
        for n in 0..N {
            q[n] += step.moved[n];
            v[n] += step.gained[n];
        }
    }
    (q, v)
}

#[test]
fn order_six() {
    let (exact, _) = run(4000, 4.0);
    let errors = [20, 40, 80].map(|steps| {
        let (q, _) = run(steps, 4.0);
        std::array::from_fn::<f64, 3, _>(|n| (q[n] - exact[n]).abs())
    });
    for pair in errors.windows(2) {
        for (n, (coarse, fine)) in pair[0].iter().zip(&pair[1]).enumerate() {
            let order = (coarse / fine).log2();
            assert!((order - 6.0).abs() < 0.35, "equation {n}: order {order}");
        }
    }
}

#[test]
fn closed_forms() {
    let end = 4.0;
    let (q, v) = run(400, end);
    // Solution of φ̈ + 0.6φ̇ + 4φ = 0, from φ = 1 at rest.
    let (decay, rate) = (0.3_f64, (4.0_f64 - 0.09).sqrt());
    let (sin, cos) = (rate * end).sin_cos();
    let swing = (-decay * end).exp() * (cos + decay / rate * sin);
    assert!((q[1] - swing).abs() < 1e-12);
    // The fan: ω = 2/(1 + 2t), φ = ln(1 + 2t).
    assert!((v[2] - 2.0 / 9.0).abs() < 1e-11 && (q[2] - 9.0_f64.ln()).abs() < 1e-11);
    // The growing force: φ = t⁷/42.
    assert!((q[3] - end.powi(7) / 42.0).abs() < 1e-9 * q[3]);
}

/// With adaptive steps a pendulum that starts from rest keeps its energy over many swings.
#[test]
fn adaptive_steps() {
    let (mut q, mut v, mut time, mut count) = (2.5_f64, 0.0_f64, 0.0_f64, 0);
    let mut steps = Adaptive::<1>::new(1.0);
    while time < 100.0 {
        let f = |moment: &super::Moment<1>| [-(q + moment.moved[0]).sin()];
        let error = |[moved, gained]: [[f64; 1]; 2]| moved[0].abs().max(gained[0].abs()) / 1e-13;
        let advance = steps.step([100.0 - time, 1e-9], &[v], f, error).unwrap();
        q += advance.moved[0];
        v += advance.gained[0];
        time += advance.length;
        count += 1;
    }
    let off = 0.5 * v * v - q.cos() + 2.5_f64.cos();
    assert!(off.abs() < 1e-13, "{off:e}");
    assert!((200..4_000).contains(&count), "{count}");
    let no = steps.step([1.0, 1e-3], &[v], |_| [f64::NAN], |_| 0.0);
    assert!(no.is_none());
}

#[test]
fn a_pendulum_keeps_its_energy() {
    let (mut q, mut v) = ([2.5, 0.0, 0.0, 0.0], [0.0; N]);
    let mut past = Past::NONE;
    let energy = |q: &[f64; N], v: &[f64; N]| 0.5 * v[0] * v[0] - q[0].cos();
    let start = energy(&q, &v);
    let mut worst = [0.0_f64; 2];
    for at in 0..200_000 {
        let f = |moment: &Moment| [-(q[0] + moment.moved[0]).sin(), 0.0, 0.0, 0.0];
        let step = step(&mut past, 0.25, &v, f).unwrap();
        q[0] += step.moved[0];
        v[0] += step.gained[0];
        let half = usize::from(at >= 100_000);
        worst[half] = worst[half].max((energy(&q, &v) - start).abs());
    }
    // The energy oscillates within the same bounds in the second half.
    assert!(worst[0] < 1e-7 && worst[1] < 1.05 * worst[0], "{worst:?}");
}

#[test]
fn a_step_too_long_is_told() {
    let mut past = Past::NONE;
    let f = |moment: &Moment| [-1e6 * moment.moved[0] - 1.0, 0.0, 0.0, 0.0];
    assert!(step(&mut past, 0.1, &[0.0; N], f).is_none());
}
