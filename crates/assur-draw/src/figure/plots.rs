//! Plots of a linkage's quantities.

use assur::Jet;
use assur::mechanism::Quantity;
use assur::motion::{DeadPointKind, features};

use super::{Figure, OFF};
use crate::chart::{Chart, Kind, Sample, Series, Settings};
use crate::list::Role;

/// Next to dead points derivatives grow without bound: ranges are taken this
/// share of the way off the ends.
const CLEAR: f64 = 0.04;

impl Figure {
    /// The chart of quantities of one kind over the motion, with the input going as
    /// `settings` say.
    pub fn chart(&self, quantities: &[Quantity], settings: Settings) -> Chart {
        let (motion, mechanism) = (&self.motion, self.motion.mechanism());
        let unit = |quantity: &Quantity| {
            if quantity.is_angle() {
                1.0
            } else {
                mechanism.size()
            }
        };
        let units: Vec<f64> = quantities.iter().map(unit).collect();
        let jets = |input: f64| -> Option<Vec<Jet<5>>> {
            let pose = motion.pose::<5>(input).ok()?;
            Some(quantities.iter().map(|q| q.of(mechanism, &pose)).collect())
        };
        let found = features(motion.cycle(), &jets, &units, settings.input);
        let series = quantities.iter().zip(found);
        let series = series.map(|(quantity, features)| Series {
            name: quantity.name(mechanism, 0),
            role: match quantity {
                Quantity::Angle(link) => self.role(*link),
                Quantity::X(_) => Role::X,
                Quantity::Y(_) => Role::Y,
            },
            features,
        });
        let ends: Vec<f64> = motion
            .dead_points()
            .iter()
            .filter(|end| end.kind != DeadPointKind::Range)
            .map(|end| end.input)
            .collect();
        let [from, to] = motion.cycle().arcs()[0];
        let sample = |input: f64| {
            let kept = if ends.is_empty() {
                input
            } else {
                let off = OFF * (to - from);
                input.clamp(from + off, to - off)
            };
            let pose = motion.pose::<3>(kept).ok()?;
            let off = |end: &f64| (input - end).abs() > CLEAR * (to - from);
            Some(Sample {
                jets: quantities.iter().map(|q| q.of(mechanism, &pose)).collect(),
                clear: ends.iter().all(off),
            })
        };
        let kind = match quantities.first() {
            Some(quantity) if !quantity.is_angle() => Kind::Length,
            _ => Kind::Angle,
        };
        Chart::new(motion.cycle(), kind, series.collect(), &sample, settings)
    }
}
