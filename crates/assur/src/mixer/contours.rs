//! The closed vector contours of the mixer's linkage: relations (1) to (26) of Smelyagin and Prikhodko, evaluated.

use std::f64::consts::TAU;

use super::Mixer;
use crate::relation::Relation;
use crate::tolerance::NEGLIGIBLE;
use crate::{Assembly, FourBar, Link, Offset, Pose, Unsolved, Vector};

impl Mixer {
    /// The paper's relations at a crank angle φ₁, radians. Lengths are in the unit of the dimensions; derivatives are
    /// with respect to φ₁.
    ///
    /// # Errors
    /// The angle is not finite, there is no pose at this angle, or a derivative is unbounded.
    pub fn relations(&self, crank: f64) -> Result<Vec<Relation>, Unsolved> {
        let pose = self.linkage.pose(self.assembly, crank)?;
        let mut all = self.triangles(&pose)?;
        all.extend(derivatives(&self.linkage, &pose));
        all.extend(centres(&self.linkage, &pose));
        all.extend(self.wheels(&pose));
        Ok(all)
    }

    /// Relations (1) to (6) of the triangles ABD and BCD. In the paper's first assembly the angle φ₃₅ from the diagonal
    /// BD to the rocker is less than half a turn.
    fn triangles(&self, pose: &Pose<3>) -> Result<Vec<Relation>, Unsolved> {
        let [l1, l2, l3, l4] = self.linkage.lengths();
        let crank = pose.crank.value();
        let (sin, cos) = crank.sin_cos();
        let l5 = (l4 - l1 * cos).hypot(l1 * sin);
        let phi5 = (-l1 * sin).atan2(l4 - l1 * cos);
        // If the crank is in line with the frame, the quotient of sines is 0/0. The test has a tolerance, because sin π
        // rounds to a nonzero number.
        let quotient = if sin.abs() > NEGLIGIBLE {
            -l1 * sin / phi5.sin()
        } else {
            f64::NAN
        };
        let sum = along(l1, crank) + along(l5, phi5) - along(l4, 0.0);
        let mut all = Vec::from(closed("002.(1)", sum));
        all.extend([
            Relation::of("002.(2)", "Σx", 0.0, l1 * cos + l5 * phi5.cos() - l4),
            Relation::of("002.(2)", "Σy", 0.0, l1 * sin + l5 * phi5.sin()),
            Relation::angle(
                "002.(3)phi5",
                "φ₅",
                phi5,
                (-l1 * sin / (l4 - l1 * cos)).atan(),
            ),
            Relation::of("002.(3)l5", "l₅", l5, quotient),
        ]);
        let here = pose.rocker.value() - phi5;
        let at_b = pose.coupler.value() - phi5;
        all.extend([
            Relation::of(
                "002.(4)",
                "l₂²",
                l2 * l2,
                l3 * l3 + l5 * l5 + 2.0 * l3 * l5 * here.cos(),
            ),
            Relation::of(
                "002.(4)",
                "l₃²",
                l3 * l3,
                l2 * l2 + l5 * l5 - 2.0 * l2 * l5 * at_b.cos(),
            ),
        ]);
        let [phi35, phi25] = [
            ((l2 * l2 - l3 * l3 - l5 * l5) / (2.0 * l3 * l5)).acos(),
            ((l2 * l2 - l3 * l3 + l5 * l5) / (2.0 * l2 * l5)).acos(),
        ];
        let poses =
            [Assembly::First, Assembly::Second].map(|one| self.linkage.pose::<1>(one, crank));
        let [mut first, mut second] = [poses[0]?, poses[1]?];
        if (first.rocker.value() - phi5).sin() < 0.0 {
            std::mem::swap(&mut first, &mut second);
        }
        for (pose, [phi35, phi25], names) in [
            (
                first,
                [phi35, phi25],
                ["φ₃₅⁽¹⁾", "φ₂₅⁽¹⁾", "φ₂⁽¹⁾", "φ₃⁽¹⁾"],
            ),
            (
                second,
                [TAU - phi35, TAU - phi25],
                ["φ₃₅⁽²⁾", "φ₂₅⁽²⁾", "φ₂⁽²⁾", "φ₃⁽²⁾"],
            ),
        ] {
            let [coupler, rocker] = [pose.coupler.value(), pose.rocker.value()];
            all.extend([
                Relation::angle("002.(5)", names[0], (rocker - phi5).rem_euclid(TAU), phi35),
                Relation::angle("002.(5)", names[1], (coupler - phi5).rem_euclid(TAU), phi25),
                Relation::angle("002.(6)", names[2], coupler, phi25 + phi5),
                Relation::angle("002.(6)", names[3], rocker, phi35 + phi5),
            ]);
        }
        Ok(all)
    }

    /// Relations (25) and (26) of the wheels, with the gear ratio u unsigned as in the paper; then u with its sign.
    fn wheels(&self, pose: &Pose<3>) -> Vec<Relation> {
        let mut all = Vec::new();
        let strokes = [["ψ₄", "ψ₅"], ["ψ₄′", "ψ₅′"], ["ψ₄″", "ψ₅″"]];
        let first = self.gears.pairs().first();
        for (order, names) in strokes.into_iter().enumerate() {
            let relation = if order == 0 {
                Relation::turned
            } else {
                Relation::of
            };
            let rocker = pose.rocker.derivative(order);
            all.push(relation("002.(25)", names[0], rocker, rocker));
            all.extend(first.map(|pair| {
                let driven = pair.driven(pose.rocker).derivative(order);
                relation("002.(26)", names[1], driven, pair.ratio().abs() * rocker)
            }));
        }
        all.extend(first.map(|pair| {
            let rates = [pair.driven(pose.rocker), pose.rocker].map(|angle| angle.derivative(1));
            Relation::of("002.u", "u", pair.ratio(), rates[0] / rates[1])
        }));
        all
    }
}

fn along(length: f64, angle: f64) -> Vector {
    Vector::new(angle.cos(), angle.sin()) * length
}

/// Relations that compare the sum of the vectors of a closed contour with zero.
fn closed(item: &'static str, sum: Vector) -> [Relation; 2] {
    Relation::both(item, ["Σx", "Σy"], Vector::zeros(), sum)
}

/// Relations (7) to (13) of the contour ABCD: both sides of each, and the analogues of velocity and acceleration.
fn derivatives(linkage: &FourBar, pose: &Pose<3>) -> Vec<Relation> {
    let [l1, l2, l3, l4] = linkage.lengths();
    let (s1, c1) = pose.crank.value().sin_cos();
    let [p2, v2, a2] = [0, 1, 2].map(|order| pose.coupler.derivative(order));
    let [p3, v3, a3] = [0, 1, 2].map(|order| pose.rocker.derivative(order));
    let p1 = pose.crank.value();
    let ((s2, c2), (s3, c3)) = (p2.sin_cos(), p3.sin_cos());
    let [sin32, cos32] = [(p3 - p2).sin(), (p3 - p2).cos()];
    let links = along(l1, p1) + along(l2, p2) - along(l3, p3) - along(l4, 0.0);
    let mut all = Vec::from(closed("002.(7)", links));
    all.extend([
        Relation::of("002.(8)", "l₃ cos φ₃", l3 * c3, -l4 + l1 * c1 + l2 * c2),
        Relation::of("002.(8)", "l₃ sin φ₃", l3 * s3, l1 * s1 + l2 * s2),
        Relation::of(
            "002.(9)",
            "−l₃ sin φ₃ φ₃′",
            -l3 * s3 * v3,
            -l1 * s1 - l2 * s2 * v2,
        ),
        Relation::of(
            "002.(9)",
            "l₃ cos φ₃ φ₃′",
            l3 * c3 * v3,
            l1 * c1 + l2 * c2 * v2,
        ),
        Relation::of("002.(10)", "φ₃′", v3, l1 * (p1 - p2).sin() / (l3 * sin32)),
        Relation::of("002.(11)", "φ₂′", v2, -l1 * (p1 - p3).sin() / (l2 * -sin32)),
        Relation::of(
            "002.(12)",
            "φ₃′² l₃ cos φ₃ + φ₃″ l₃ sin φ₃",
            v3 * v3 * l3 * c3 + a3 * l3 * s3,
            l1 * c1 + v2 * v2 * l2 * c2 + a2 * l2 * s2,
        ),
        Relation::of(
            "002.(12)",
            "−φ₃′² l₃ sin φ₃ + φ₃″ l₃ cos φ₃",
            -v3 * v3 * l3 * s3 + a3 * l3 * c3,
            -l1 * s1 - v2 * v2 * l2 * s2 + a2 * l2 * c2,
        ),
        Relation::of(
            "002.(13)phi3",
            "φ₃″",
            a3,
            (l1 * (p1 - p2).cos() + v2 * v2 * l2 - v3 * v3 * l3 * cos32) / (l3 * sin32),
        ),
        Relation::of(
            "002.(13)phi2",
            "φ₂″",
            a2,
            (l1 * (p1 - p3).cos() - v3 * v3 * l3 + v2 * v2 * l2 * cos32) / (l2 * sin32),
        ),
    ]);
    all
}

/// Relations (14) to (24) of the centres of mass, which are in the middle of crank, coupler and rocker.
fn centres(linkage: &FourBar, pose: &Pose<3>) -> Vec<Relation> {
    let [l1, l2, l3, l4] = linkage.lengths();
    let (s1, c1) = pose.crank.value().sin_cos();
    let [p2, v2, a2] = [0, 1, 2].map(|order| pose.coupler.derivative(order));
    let [p3, v3, a3] = [0, 1, 2].map(|order| pose.rocker.derivative(order));
    let ((s2, c2), (s3, c3)) = (p2.sin_cos(), p3.sin_cos());
    let [h1, h2, h3] = [l1, l2, l3].map(|length| 0.5 * length);
    let places = [Link::Crank, Link::Coupler, Link::Rocker]
        .map(|link| linkage.carried(pose, link, Offset::MIDDLE));
    let x = |centre: usize, order: usize| places[centre].derivative(order).x;
    let y = |centre: usize, order: usize| places[centre].derivative(order).y;
    let of_c2 = along(l1, pose.crank.value()) + along(h2, p2) - places[1].derivative(0);
    let of_c3 = places[2].derivative(0) - along(h3, p3) - along(l4, 0.0);
    let mut all = vec![
        Relation::of("002.(14)", "x_C1", x(0, 0), h1 * c1),
        Relation::of("002.(14)", "y_C1", y(0, 0), h1 * s1),
        Relation::of("002.(15)", "x′_C1", x(0, 1), -h1 * s1),
        Relation::of("002.(15)", "y′_C1", y(0, 1), h1 * c1),
        Relation::of("002.(16)x", "x″_C1", x(0, 2), -h1 * c1),
        Relation::of("002.(16)y", "y″_C1", y(0, 2), h1 * s1),
    ];
    all.extend(closed("002.(17)", of_c2));
    all.extend([
        Relation::of("002.(18)", "x_C2", x(1, 0), l1 * c1 + h2 * c2),
        Relation::of("002.(18)", "y_C2", y(1, 0), l1 * s1 + h2 * s2),
        Relation::of("002.(19)", "x′_C2", x(1, 1), -l1 * s1 - h2 * s2 * v2),
        Relation::of("002.(19)", "y′_C2", y(1, 1), l1 * c1 + h2 * c2 * v2),
        Relation::of(
            "002.(20)",
            "x″_C2",
            x(1, 2),
            -l1 * c1 - h2 * c2 * v2 * v2 - h2 * s2 * a2,
        ),
        Relation::of(
            "002.(20)",
            "y″_C2",
            y(1, 2),
            -l1 * s1 - h2 * s2 * v2 * v2 + h2 * c2 * a2,
        ),
    ]);
    all.extend(closed("002.(21)", of_c3));
    all.extend([
        Relation::of("002.(22)", "x_C3", x(2, 0), l4 + h3 * c3),
        Relation::of("002.(22)", "y_C3", y(2, 0), h3 * s3),
        Relation::of("002.(23)", "x′_C3", x(2, 1), -h3 * s3 * v3),
        Relation::of("002.(23)", "y′_C3", y(2, 1), h3 * c3 * v3),
        Relation::of(
            "002.(24)x",
            "x″_C3",
            x(2, 2),
            -h3 * c3 * v3 * v3 - h3 * s3 * a3,
        ),
        Relation::of(
            "002.(24)y",
            "y″_C3",
            y(2, 2),
            h3 * s3 * v3 * v3 + h3 * c3 * a3,
        ),
    ]);
    all
}
