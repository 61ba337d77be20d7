//! Plots of a linkage's quantities.

use std::cell::RefCell;
use std::f64::consts::PI;

use assur::Jet;
use assur::mechanism::{Mechanism, Pose, Quantity, RrrDyad};
use assur::motion::{Column, DeadPoint};

use super::{Figure, paths};
use crate::chart::{Against, At, Axis, Chart, Kind, Sample, Series, Settings, sampled, sampling};
use crate::list::Role;

/// Transmission angle above which values determine the ranges of axes. At smaller angles a dead point, where the links
/// of a dyad are in line, is near, and derivatives grow without bound.
const CLEAR: f64 = 15.0 * PI / 180.0;
/// Share of an arc of the motion, next to a dead point, in which values do not affect the ranges of axes. It is used if
/// no dyad is in line at the dead point.
const CLEAR_SHARE: f64 = 0.04;

/// Colours for further coordinates or distances of the same kind, such as `C.x` after `B.x`.
const FURTHER: [Role; 3] = [Role::Accent2, Role::Accent1, Role::Crank];

/// Values in a pose at an input, with derivatives if they have any; none where they are unbounded.
pub type Values<'a> = &'a dyn Fn(f64, &Pose<3>) -> Option<Vec<Jet<3>>>;

fn kind_of(quantity: &Quantity) -> Kind {
    if quantity.is_angle() {
        Kind::Angle
    } else {
        Kind::Length
    }
}

/// Returns the axis of a column or, if none is given, of the input.
fn axis(mechanism: &Mechanism, column: Option<Column>) -> Axis {
    let Some(Column { quantity, order }) = column else {
        let kind = if mechanism.turns() {
            Kind::Angle
        } else {
            Kind::Length
        };
        return Axis {
            name: None,
            kind,
            order: 0,
        };
    };
    Axis {
        name: Some(quantity.name(mechanism, 0)),
        kind: kind_of(&quantity),
        order,
    }
}

/// Measure of the distance from a dead point, near which derivatives grow without bound.
enum Clear {
    /// The transmission angle of this dyad.
    Dyad(RrrDyad),
    /// The distance of the input from the dead point's `input`; this distance must exceed `least`.
    Way { input: f64, least: f64 },
}

impl Figure {
    /// Makes the chart of quantities of one kind over the motion, with the input rate of `settings`.
    pub fn chart(&self, quantities: &[Quantity], settings: Settings) -> Chart {
        let (motion, mechanism) = (&self.motion, self.motion.mechanism());
        // If the motion has too many turns to be searched, no features are shown.
        let mut found = (motion.features(quantities, settings.input).ok()).map(Vec::into_iter);
        let series = quantities.iter().zip(self.plotted_roles(quantities));
        let series = series.map(|(quantity, role)| Series {
            name: quantity.name(mechanism, 0),
            role,
            features: found.as_mut().and_then(Iterator::next),
        });
        let ends = self.ends();
        let room = RefCell::new(mechanism.blank::<3>());
        let sample = |input: f64| {
            let pose = &mut *room.borrow_mut();
            self.sample(input, pose, &ends, |pose| {
                Some(quantities.iter().map(|q| q.of(mechanism, pose)).collect())
            })
        };
        let kind = quantities.first().map_or(Kind::Angle, kind_of);
        let runs = sampled(motion.samples(sampling(quantities.len())), &sample);
        Chart::new(motion.cycle(), kind, series.collect(), &runs, settings)
    }

    /// Makes the chart of values without derivatives, such as forces, over the motion. `values` gives the values in a
    /// pose at an input, in the order of `series`; none where they are unbounded.
    pub fn chart_of_values(
        &self,
        kind: Kind,
        series: Vec<Series>,
        settings: Settings,
        values: Values<'_>,
    ) -> Chart {
        let runs = self.sampled_values(series.len(), values);
        Chart::new(self.motion.cycle(), kind, series, &runs, settings)
    }

    /// Makes the plot of a column over the motion against another column or, if `x` is none, against the input.
    pub fn against(&self, x: Option<Column>, y: Column, settings: Settings) -> Against {
        let mechanism = self.motion.mechanism();
        let axes = [x, Some(y)].map(|column| axis(mechanism, column));
        let role = self.own_role(y.quantity);
        self.against_values(axes, role, settings, &|input, pose| {
            let abscissa = x.map(|x| x.quantity.of(mechanism, pose));
            let abscissa = abscissa.unwrap_or(Jet::linear(input, 1.0));
            Some(vec![abscissa, y.quantity.of(mechanism, pose)])
        })
    }

    /// Makes the plot of one value over the motion against another; `values` gives abscissa and ordinate in a pose at an
    /// input, none where they are unbounded.
    pub fn against_values(
        &self,
        axes: [Axis; 2],
        role: Role,
        settings: Settings,
        values: Values<'_>,
    ) -> Against {
        let runs = self.sampled_values(2, values);
        Against::new(axes, role, &runs, self.motion.cycle().is_full(), settings)
    }

    /// The axis of a column or, if none is given, of the input.
    pub fn axis(&self, column: Option<Column>) -> Axis {
        axis(self.motion.mechanism(), column)
    }

    fn sampled_values(&self, count: usize, values: Values<'_>) -> Vec<Vec<At>> {
        let motion = &self.motion;
        let ends = self.ends();
        let room = RefCell::new(motion.mechanism().blank::<3>());
        let sample = |input: f64| {
            let pose = &mut *room.borrow_mut();
            self.sample(input, pose, &ends, |pose| values(input, pose))
        };
        sampled(motion.samples(sampling(count)), &sample)
    }

    /// Returns the values of quantities at an input; none if the pose there has no derivatives.
    fn sample(
        &self,
        input: f64,
        pose: &mut Pose<3>,
        ends: &[Clear],
        jets: impl Fn(&Pose<3>) -> Option<Vec<Jet<3>>>,
    ) -> Option<Sample> {
        self.motion.place(self.off_the_ends(input), pose).ok()?;
        Some(Sample {
            jets: jets(pose)?,
            clear: ends.iter().all(|end| self.is_clear(end, input, pose)),
        })
    }

    /// Returns the roles of the curves: each quantity's own role, or a further role for a length if its own is taken.
    pub fn plotted_roles(&self, quantities: &[Quantity]) -> Vec<Role> {
        let mut roles: Vec<Role> = Vec::new();
        for quantity in quantities {
            let own = self.own_role(*quantity);
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

    /// Returns the role of a quantity's curve, if no other curve is plotted.
    fn own_role(&self, quantity: Quantity) -> Role {
        match quantity {
            Quantity::Angle(link) => self.role(link),
            Quantity::X(_) => Role::X,
            Quantity::Y(_) => Role::Y,
            Quantity::Transmission(_) | Quantity::Pressure(_) => Role::Secondary,
            Quantity::Distance(_) => Role::Accent3,
            Quantity::Corner(_) | Quantity::Between(_) => Role::Accent4,
        }
    }

    /// Returns the measure of the distance from each dead point.
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

    /// Returns the arc of the motion that contains an input.
    fn arc(&self, input: f64) -> [f64; 2] {
        let arcs = self.motion.cycle().arcs();
        let mut holding = arcs
            .iter()
            .filter(|[from, to]| (*from..=*to).contains(&input));
        *holding.next().unwrap_or(&arcs[0])
    }

    /// Returns the input, moved away from the very ends of its arc.
    fn off_the_ends(&self, input: f64) -> f64 {
        if self.motion.cycle().is_full() {
            return input;
        }
        let [from, to] = self.arc(input);
        let off = paths::OFF * (to - from);
        input.clamp(from + off, to - off)
    }
}
