//! The wheels of a mixer as they are drawn: teeth in mesh, blades, names.

use assur::gears::{GearSet, Wheel};
use assur::{Point, Vector};

use crate::gear::Teeth;
use crate::list::{Label, List, Look, Role};
use crate::parts;

/// Roles and names of the peripheral wheels: wheel 5, 6, …
const PERIPHERAL: [(Role, Label); GearSet::MOST] = [
    (Role::Accent2, Label::Five),
    (Role::Accent3, Label::Six),
    (Role::Accent4, Label::Seven),
    (Role::Accent5, Label::Eight),
    (Role::Accent6, Label::Nine),
    (Role::Accent7, Label::Ten),
];

/// What a ring has beyond its pitch circle, in modules: the gaps and a rim.
const RING: f64 = 2.75;

/// How far from the centre line a wheel's name stands, radians.
const NAME: f64 = 1.9;

/// A wheel with what is drawn of it.
#[derive(Clone, Debug)]
pub(crate) struct DrawnWheel {
    /// Its place and its turning.
    pub(crate) wheel: Wheel,
    role: Role,
    /// Its name with the direction in which it stands; an idler has none.
    name: Option<(Label, f64)>,
    blades: usize,
    /// Teeth of all it meshes with, and whether those are rings.
    mates: Vec<(u32, bool)>,
}

/// The role of a peripheral wheel, counted from 0.
pub(crate) fn role(index: usize) -> Role {
    PERIPHERAL
        .get(index)
        .map_or(Role::Accent2, |(role, _)| *role)
}

/// Wheel 4, the wheels around it in their order, then the idlers.
pub(crate) fn drawn(gears: &GearSet) -> Vec<DrawnWheel> {
    let mate = |wheel: &Wheel| (wheel.teeth, wheel.ring);
    let mut driver = Vec::new();
    let mut idlers = Vec::new();
    let mut driven = Vec::new();
    for (pair, (role, label)) in gears.pairs().iter().zip(PERIPHERAL) {
        let name = pair.centre_line() + NAME;
        let train = pair.train();
        let drawn = |index: usize, role, label: Option<Label>, blades| DrawnWheel {
            wheel: train[index],
            role,
            name: label.map(|label| (label, name)),
            blades,
            mates: [index.checked_sub(1), Some(index + 1)]
                .into_iter()
                .flatten()
                .filter_map(|near| train.get(near).map(mate))
                .collect(),
        };
        if driver.is_empty() {
            driver.push(drawn(0, Role::Accent1, Some(Label::Four), 3));
        } else {
            driver[0].mates.extend(train.get(1).map(mate));
        }
        driven.push(drawn(train.len() - 1, role, Some(label), 4));
        idlers.extend((1..train.len() - 1).map(|index| drawn(index, Role::Idler, None, 0)));
    }
    driver.into_iter().chain(driven).chain(idlers).collect()
}

impl DrawnWheel {
    /// Its toothed line, in modules.
    pub(crate) fn teeth(&self) -> Teeth {
        Teeth::new(self.wheel.teeth, self.wheel.ring, &self.mates)
    }

    /// Whether it is no idler.
    pub(crate) fn is_named(&self) -> bool {
        self.name.is_some()
    }

    /// The radius that holds all of it.
    pub(crate) fn rim(&self, module: f64) -> f64 {
        let beyond = if self.wheel.ring { RING } else { 1.0 };
        (0.5 * f64::from(self.wheel.teeth) + beyond) * module
    }

    /// How far a place is from it, with wheel 4's shaft at `shaft`.
    pub(crate) fn distance(&self, shaft: Point, place: Point, module: f64) -> f64 {
        let off = (place - (shaft + self.wheel.centre)).norm();
        let beyond = (off - self.rim(module)).max(0.0);
        if self.wheel.ring {
            let inner = (0.5 * f64::from(self.wheel.teeth) - 1.0) * module;
            beyond.max(inner - off)
        } else {
            beyond
        }
    }

    /// Draws it in its own coordinates.
    pub(crate) fn draw(&self, list: &mut List, module: f64, unit: f64) {
        let teeth = self.teeth();
        let mut loops = vec![teeth.outline(module)];
        if self.wheel.ring {
            loops.push(parts::round(self.rim(module), 180));
        }
        list.polygons(self.role, Look::Pale, &loops);
        let reach = 0.72 * teeth.pitch_radius() * module;
        let slender = (0.075 * reach).min(0.8 * unit);
        for blade in parts::blades(self.blades, reach, slender) {
            list.polygons(self.role, Look::Soft, &[blade]);
        }
        // Wheel 4 is on the rocker's hinge.
        if self.role != Role::Accent1 {
            list.circle(Role::Ink, Look::Hollow, Point::origin(), 0.7 * unit);
        }
    }

    /// Writes its name, in the coordinates of the frame.
    pub(crate) fn name(&self, list: &mut List, shaft: Point, module: f64) {
        let Some((label, direction)) = self.name else {
            return;
        };
        let outward = if self.wheel.ring { 1.0 } else { 0.84 };
        let radius = 0.5 * outward * f64::from(self.wheel.teeth) * module;
        let (sin, cos) = direction.sin_cos();
        let at = shaft + self.wheel.centre + Vector::new(cos, sin) * radius;
        list.label(Role::Ink, label, at, [0.0, 0.0]);
    }
}
