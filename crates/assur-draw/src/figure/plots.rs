//! Plots of a linkage's quantities.

use std::cell::RefCell;
use std::f64::consts::PI;

use assur::mechanism::{Pose, Quantity, RrrDyad};
use assur::motion::DeadPoint;

use super::{Figure, paths};
use crate::chart::{Chart, Kind, Sample, Series, Settings};
use crate::list::Role;

/// Next to dead points derivatives grow without bound: ranges are taken where the
/// transmission angle of the dyad that comes into line exceeds this.
const CLEAR: f64 = 15.0 * PI / 180.0;
/// Where it is no dyad of hinges, ranges keep this share of an arc off its end.
const CLEAR_SHARE: f64 = 0.04;

/// The colours of an axis of further points.
const FURTHER: [Role; 3] = [Role::Accent2, Role::Accent1, Role::Crank];

/// What tells that derivatives are far from growing without bound at a dead point.
enum Clear {
    /// Its transmission angle.
    Dyad(RrrDyad),
    /// The way from this input.
    Way { input: f64, least: f64 },
}

impl Figure {
    /// The chart of quantities of one kind over the motion, with the input going as
    /// `settings` say.
    pub fn chart(&self, quantities: &[Quantity], settings: Settings) -> Chart {
        let (motion, mechanism) = (&self.motion, self.motion.mechanism());
        let found = motion.features(quantities, settings.input);
        let series = quantities.iter().zip(self.plotted_roles(quantities));
        let series = series
            .zip(found)
            .map(|((quantity, role), features)| Series {
                name: quantity.name(mechanism, 0),
                role,
                features,
            });
        let ends = self.ends();
        let room = RefCell::new(mechanism.blank::<3>());
        let sample = |input: f64| {
            let pose = &mut *room.borrow_mut();
            motion.place(self.off_the_ends(input), pose).ok()?;
            Some(Sample {
                jets: quantities.iter().map(|q| q.of(mechanism, pose)).collect(),
                clear: ends.iter().all(|end| self.is_clear(end, input, pose)),
            })
        };
        let kind = match quantities.first() {
            Some(quantity) if !quantity.is_angle() => Kind::Length,
            _ => Kind::Angle,
        };
        Chart::new(motion.cycle(), kind, series.collect(), &sample, settings)
    }

    /// Whose colours the curves have: links their own, each axis its own, the same axis of a further point another.
    pub fn plotted_roles(&self, quantities: &[Quantity]) -> Vec<Role> {
        let mut roles: Vec<Role> = Vec::new();
        for quantity in quantities {
            let own = match quantity {
                Quantity::Angle(link) => self.role(*link),
                Quantity::X(_) => Role::X,
                Quantity::Y(_) => Role::Y,
                Quantity::Transmission(_) | Quantity::Pressure(_) => Role::Secondary,
            };
            let mut free = FURTHER.into_iter().filter(|role| !roles.contains(role));
            let taken = !quantity.is_angle() && roles.contains(&own);
            let role = if taken {
                free.next().unwrap_or(own)
            } else {
                own
            };
            roles.push(role);
        }
        roles
    }

    /// The dead points.
    fn ends(&self) -> Vec<Clear> {
        let (motion, mechanism) = (&self.motion, self.motion.mechanism());
        let ends = motion.dead_points().iter();
        let ends = ends.filter(|end| end.kind.is_dead_point());
        let dyads = mechanism.rrr_dyads();
        let clear = |end: &DeadPoint| {
            let [from, to] = self.arc(end.input);
            let links: Vec<&str> = motion.links_at(end).collect();
            let in_line = |dyad: &&RrrDyad| {
                let mut own = dyad.links.iter();
                own.all(|link| links.contains(&mechanism.link_name(*link)))
            };
            let way = Clear::Way {
                input: end.input,
                least: CLEAR_SHARE * (to - from),
            };
            let dyad = dyads.iter().find(in_line);
            dyad.map_or(way, |dyad| Clear::Dyad(*dyad))
        };
        ends.map(clear).collect()
    }

    fn is_clear(&self, end: &Clear, input: f64, pose: &Pose<3>) -> bool {
        match end {
            Clear::Dyad(dyad) => self.motion.mechanism().transmission_angle(pose, dyad) > CLEAR,
            Clear::Way { input: end, least } => (input - end).abs() > *least,
        }
    }

    /// The arc of the motion that an input is in.
    fn arc(&self, input: f64) -> [f64; 2] {
        let arcs = self.motion.cycle().arcs();
        let mut holding = arcs
            .iter()
            .filter(|[from, to]| (*from..=*to).contains(&input));
        *holding.next().unwrap_or(&arcs[0])
    }

    /// An input, but for the very ends of an arc.
    fn off_the_ends(&self, input: f64) -> f64 {
        if self.motion.cycle().is_full() {
            return input;
        }
        let [from, to] = self.arc(input);
        let off = paths::OFF * (to - from);
        input.clamp(from + off, to - off)
    }
}
