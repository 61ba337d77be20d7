//! What is plotted of a mixer: quantities become the curves of a chart.

use std::f64::consts::PI;

use assur::Jet;
use assur::catalog::mixer::{Axis, Mixer, Quantity, Turning};
use assur::motion::{Features, Input, features};

use crate::chart::{Chart, Kind, Sample, Series, Settings};
use crate::list::Role;
use crate::wheels;

/// Where the crank cannot turn fully, derivatives grow without bound towards the
/// dead points: ranges are taken where the transmission angle exceeds this.
const CLEAR: f64 = 15.0 * PI / 180.0;

/// The chart of some quantities of one kind over the mixer's cycle, with its
/// input turning as `settings` say.
pub fn chart(mixer: &Mixer, quantities: &[Quantity], settings: Settings) -> Chart {
    let found = marks(mixer, quantities, settings.input);
    let series = quantities
        .iter()
        .zip(found)
        .map(|(quantity, features)| Series {
            name: quantity.name(),
            role: role(*quantity),
            features,
        });
    let kind = match quantities.first() {
        Some(quantity) if !quantity.is_angle() => Kind::Length,
        _ => Kind::Angle,
    };
    let sample = |crank: f64| {
        let clear = mixer.linkage.transmission_angle(crank).ok()? > CLEAR;
        let jets = mixer.jets(quantities, crank).ok()?;
        Some(Sample { jets, clear })
    };
    let cycle = mixer.linkage.cycle();
    Chart::new(&cycle, kind, series.collect(), &sample, settings)
}

/// Zeros and extrema of the quantities: found once for all that are multiples of
/// the same one.
fn marks(mixer: &Mixer, quantities: &[Quantity], input: Input) -> Vec<[Features; 3]> {
    let multiples: Vec<(Quantity, f64)> = quantities.iter().map(|q| mixer.multiple(*q)).collect();
    let mut bases: Vec<Quantity> = Vec::new();
    for (base, _) in &multiples {
        if !bases.contains(base) {
            bases.push(*base);
        }
    }
    let longest = mixer.linkage.lengths().into_iter().fold(0.0, f64::max);
    let unit = |base: &Quantity| if base.is_angle() { 1.0 } else { longest };
    let units: Vec<f64> = bases.iter().map(unit).collect();
    let motion = |crank: f64| -> Option<Vec<Jet<5>>> { mixer.jets(&bases, crank).ok() };
    let found = features(&mixer.linkage.cycle(), &motion, &units, input);
    let scaled = |(base, factor): (Quantity, f64)| {
        let index = bases.iter().position(|one| *one == base)?;
        Some(
            found[index]
                .each_ref()
                .map(|features| features.scaled(factor)),
        )
    };
    let scaled = multiples.into_iter().map(scaled);
    scaled.map(Option::unwrap_or_default).collect()
}

/// An angle's curve has the colour of what turns.
fn role(quantity: Quantity) -> Role {
    match quantity {
        Quantity::Angle(Turning::Crank) => Role::Crank,
        Quantity::Angle(Turning::Coupler) => Role::Coupler,
        Quantity::Angle(Turning::Rocker) => Role::Rocker,
        Quantity::Angle(Turning::Wheel(index)) => wheels::role(index),
        Quantity::Coordinate(_, Axis::X) => Role::X,
        Quantity::Coordinate(_, Axis::Y) => Role::Y,
    }
}
