//! Small swings against the linearised equations.

use std::f64::consts::TAU;

use assur::dynamics::{Body, Differential, Drive, Mesh, Run, Start};
use assur_tests::assert_near;
use nalgebra::Matrix2;

use super::sample::{speed, undamped};

/// Mean period between zeros in the same sense, found by a line between ticks.
fn frequency(run: &mut Run, read: impl Fn(&Run) -> f64) -> f64 {
    let mut zeros = vec![];
    let mut before = read(run);
    for tick in 1..20_000 {
        run.advance(1).unwrap();
        let now = read(run);
        if before < 0.0 && now >= 0.0 {
            zeros.push((f64::from(tick) - now / (now - before)) / 1024.0);
        }
        before = now;
    }
    TAU * (zeros.len() - 1) as f64 / (zeros.last().unwrap() - zeros[0])
}

#[test]
fn satellites_between_wheels_that_are_held() {
    let mut parameters = undamped();
    parameters.sun.drive = Drive::held();
    parameters.carrier.drive = Drive::held();
    parameters.ring.drive = Drive::held();
    // Slow enough for a line between ticks.
    parameters.satellites.inertia = 0.02;
    let differential = Differential::new(&parameters).unwrap();
    let rate = (10.0 * 10.0 * (2.0 / 20.0 + 5.0 / 43.0) / 0.02_f64).sqrt();
    let [sun, ring] = Mesh::ALL.map(|mesh| differential.swing_rate(mesh));
    assert_near(sun.hypot(ring), rate, 1e-14, "both meshes");
    let mut start = Start::rest();
    start.angles[Body::Satellite.index()] = 1e-4;
    let mut run = Run::new(differential, &start).unwrap();
    let found = frequency(&mut run, |run| {
        run.reading().body(Body::Satellite).angle.part()
    });
    assert_near(found / rate, 1.0, 1e-6, "small swings");
}

/// Carrier and satellites swing together between driven shafts: both modes by the eigenvalues of M⁻¹K.
#[test]
fn carrier_and_satellites_between_driven_shafts() {
    let mut parameters = undamped();
    parameters.sun.drive = speed(6.0);
    parameters.ring.drive = speed(2.0);
    parameters.satellites.inertia = 0.02;
    parameters.carrier.inertia = 3.0;
    let (e1, e4) = (3.0 * 2.0 / 20.0, 3.0 * 5.0 / 43.0);
    let (j2, j3) = (3.0 * 0.02, 3.0 + 3.0 * 0.3 * 0.08 * 0.08);
    // δₛ = 10 φ₂ − 30 φ₃, δᵣ = 10 φ₂ + 33 φ₃.
    let across = e1 * -300.0 + e4 * 330.0;
    let stiffness = Matrix2::new(100.0 * (e1 + e4), across, across, 900.0 * e1 + 1089.0 * e4);
    let roots = Matrix2::new(1.0 / f64::sqrt(j2), 0.0, 0.0, 1.0 / f64::sqrt(j3));
    let modes = (roots * stiffness * roots).symmetric_eigen();
    for mode in 0..2 {
        let shape = roots * modes.eigenvectors.column(mode);
        let differential = Differential::new(&parameters).unwrap();
        let mut start = Start::synchronous(&differential, 6.0, 2.0);
        start.angles[1] = 1e-4 * shape[0];
        start.angles[2] = 1e-4 * shape[1];
        let sync = start.speeds;
        let mut run = Run::new(differential, &start).unwrap();
        let found = frequency(&mut run, |run| {
            let of = |body: Body| run.reading().body(body).angle.radians();
            // Away from where it would be without swings, along the mode.
            let away = of(Body::Carrier) - sync[2] * run.time();
            away * shape[1].signum()
        });
        let rate = modes.eigenvalues[mode].sqrt();
        assert_near(found / rate, 1.0, 2e-6, &format!("mode {mode}"));
    }
}
