//! Enclosures of dyads in closed form.

use std::f64::consts::PI;

use super::{Enclosure, PointBound};
use crate::Vector;
use crate::index::BodyId;
use crate::position::{Arm, Predictor, Track, product};

/// Bound on a link's rotation, radians, above which the triangle of links and base gives a second bound.
const LARGE_TURN: f64 = 0.5;

impl Enclosure {
    /// Encloses the motion of two links, hinged to each other at C and to the solved points B and D. Returns false if
    /// the links may come into line.
    ///
    /// Let X be the vector from B to C, d the vector from B to D, and e₂, e₃ unit vectors along the links.
    /// Then e₂·X″ = −v₂²/l₂ and e₃·X″ = e₃·d″ − v₃²/l₃, with the speeds v₂, v₃ of C relative to B and D. So |X″| is at
    /// most the sum of the absolute values of the right sides, divided by the sine of the angle between the links.
    pub(crate) fn enclose_arms(&mut self, from: &Predictor, arms: &[Arm; 2]) -> bool {
        let [b, d] = arms.each_ref().map(|arm| self.point(from, arm.outer));
        let base = d.minus(&b);
        let [least, most] = self.distances(&base);
        let [l2, l3] = arms.each_ref().map(Arm::length);
        let (sum, difference) = (l2 + l3, (l2 - l3).abs());
        if !(most < sum && least > difference) {
            return false;
        }
        // 16 S², with S the area of the triangle whose base is r; concave in r², so least at an end of the interval.
        let square = |r: f64| (sum - r) * (sum + r) * (r - difference) * (r + difference);
        let sine = square(least).min(square(most)).sqrt() / (2.0 * l2 * l3);
        let lengths = l2.recip() + l3.recip();
        let v0 = arms
            .each_ref()
            .map(|arm| self.turn_rate(from, arm.body).abs() * arm.length());
        let v0 = v0[0].max(v0[1]);
        let crude = self.max_speed(&base) / sine;
        let v = self.bounded_speed(v0, lengths / sine, base.acceleration / sine);
        let v = v.map_or(crude, |v| v.min(crude));
        let acceleration = (v * v * lengths + base.acceleration) / sine;
        if !acceleration.is_finite() {
            return false;
        }
        let joint = b.acceleration.min(d.acceleration) + acceleration;
        for (arm, outer) in arms.iter().zip([b, d]) {
            let places = [(arm.from, outer.acceleration), (arm.to, joint)];
            self.set(arm.body, acceleration / arm.length(), places);
        }
        // The bound on the angular acceleration gives a bound on the turn of each link. That bound is poor if the base
        // is short or the links are nearly in line. If it is large, the triangle of links and base gives another one.
        for (arm, other) in [(&arms[0], l3), (&arms[1], l2)] {
            if self.turned(from, arm.body) > LARGE_TURN {
                let opening = angle_range([arm.length(), other], [least, most]);
                self.bodies[arm.body].max_turn = self.max_direction_turn(&base) + opening;
            }
        }
        true
    }

    /// Bound on the angle through which a vector turns over the step. The vector must not vanish within the step.
    fn max_direction_turn(&self, vector: &PointBound) -> f64 {
        let end = vector.at + vector.rate * self.width;
        let straight = vector.at.perp(&end).atan2(vector.at.dot(&end)).abs();
        let [least, _] = self.distances(vector);
        let radius = 0.5 * self.step_len * self.step_len * vector.acceleration;
        straight + (radius / (least + radius)).asin()
    }

    /// Bound on the second derivative of the intersection of two lines on bodies; None if they may become parallel.
    ///
    /// Let Q be the point of a body that coincides with the intersection C at the start of the step, σ the displacement
    /// of C from Q along the body's line, and n the unit normal of this line. Then n·C″ = n·Q″ + 2σ′ω + σε for each
    /// body, with its angular velocity ω and angular acceleration ε.
    pub(crate) fn crossing_acceleration(
        &self,
        from: &Predictor,
        at: Vector,
        lines: [(BodyId, Vector); 2],
    ) -> Option<f64> {
        let bodies = lines.map(|(body, _)| body);
        let [q1, q2] = bodies.map(|body| self.point_at(from, body, at));
        let [u, v] = lines.map(|(body, heading)| product(from.bodies[body].turn.value(), heading));
        let rates = bodies.map(|body| self.turn_rate(from, body));
        let angular_accelerations = bodies.map(|body| self.angular_acceleration(body));
        let angle = u.perp(&v).abs().atan2(u.dot(&v).abs());
        // The angle between lines fixed to the same body is constant.
        let relative_rate = if bodies[0] == bodies[1] {
            0.0
        } else {
            (rates[0] - rates[1]).abs() + self.step_len * angular_accelerations.iter().sum::<f64>()
        };
        let least = angle - self.step_len * relative_rate;
        if least <= 0.0 {
            return None;
        }
        let sine = least.sin();
        let max_rates = bodies.map(|body| self.max_turn_rate(from, body));
        let relative = q2.minus(&q1);
        let speed = self.max_speed(&relative);
        let slide = self.step_len * speed / sine;
        let slide_rate = (speed + slide * (max_rates[0] + max_rates[1])) / sine + speed;
        let each = |k: usize| {
            2.0 * slide_rate * max_rates[k]
                + (slide + self.step_len * speed) * angular_accelerations[k]
        };
        let acceleration = q1.acceleration + (each(0) + each(1) + relative.acceleration) / sine;
        acceleration.is_finite().then_some(acceleration)
    }

    /// Sets the bounds of a body that slides along a line, from a bound on the second derivative of the body's `point`.
    pub(crate) fn set_slider(&mut self, track: &Track, acceleration: f64) {
        let angular_acceleration = self.angular_acceleration(track.line.body);
        self.set(
            track.body,
            angular_acceleration,
            [(track.point, acceleration); 2],
        );
    }
}

/// Width of the range of the angle between base and first side of a triangle, for base lengths in an interval.
fn angle_range([side, other]: [f64; 2], base: [f64; 2]) -> f64 {
    let [sum, difference] = [side + other, side - other];
    let angle = |r: f64| {
        let cosine = (r * r + sum * difference) / (2.0 * r * side);
        cosine.clamp(-1.0, 1.0).acos()
    };
    let [least, most] = base;
    // The angle is greatest where the other side is perpendicular to the base.
    let widest = (sum * difference).max(0.0).sqrt().max(least).min(most);
    let angles = [least, widest, most].map(angle);
    let range = angles.into_iter().fold([PI, 0.0], |[low, high], angle| {
        [angle.min(low), angle.max(high)]
    });
    range[1] - range[0]
}

#[cfg(test)]
mod tests {
    use super::angle_range;

    /// The width of the range equals the width found by sampling base lengths.
    #[test]
    fn angles_of_triangles() {
        for [side, other] in [[2.0, 3.0], [3.0, 2.0], [1.0, 1.0], [5.0, 0.1]] {
            let [short, long] = [f64::abs(side - other), side + other];
            for (from, to) in [(0.001, 1.0), (0.1, 0.3), (0.4, 0.41), (0.7, 0.99)] {
                let base = [from, to].map(|part| short + part * (long - short));
                let angle = |k: u32| {
                    let r = base[0] + f64::from(k) / 1e4 * (base[1] - base[0]);
                    let cosine = (r * r + side * side - other * other) / (2.0 * r * side);
                    cosine.clamp(-1.0, 1.0).acos()
                };
                let angles = (0..=10_000).map(angle);
                let [low, high] = angles.fold([9.0, 0.0], |[low, high], angle: f64| {
                    [angle.min(low), angle.max(high)]
                });
                let found = angle_range([side, other], base);
                let off = found - (high - low);
                assert!(
                    (-1e-12..1e-3).contains(&off),
                    "{side} {other} {base:?}: {off:e}"
                );
            }
        }
    }
}
