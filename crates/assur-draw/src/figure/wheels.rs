//! Wheels of gear couplings. The sizes of two wheels in mesh follow from the distance between their hinges, and
//! their teeth interlock. A wheel is drawn as part of its link, an idler as a body of its own.

use assur::gears::{GearPair, Mesh, Wheel};
use assur::mechanism::{GearSpec, LinkId, LinkOrFrame, PointId};
use assur::{Point, Vector};

use super::View;
use super::layout::{self, Layout};
use super::posed::Posed;
use crate::annotations::Tag;
use crate::gear::Teeth;
use crate::list::{List, Look, Role};
use crate::parts;

/// Width of a ring's rim outside its pitch circle, in modules.
const RING: f64 = 2.75;
/// Relative difference below which two modules count as equal.
const SAME: f64 = 1e-3;

/// The wheels of a mechanism.
#[derive(Clone, Debug, Default)]
pub(super) struct Gearing {
    wheels: Vec<Drawn>,
    idlers: Vec<Idler>,
    links: usize,
}

/// A wheel on its link.
#[derive(Clone, Debug)]
struct Drawn {
    link: LinkId,
    role: Role,
    /// Centre, in the coordinates of the link.
    centre: Point,
    /// Point about which the wheel turns.
    hinge: PointId,
    /// Direction of a tooth in the coordinates of the link, radians.
    lead: f64,
    teeth: u32,
    ring: bool,
    module: f64,
    mates: Vec<(u32, bool)>,
    /// Number of mixing blades on the wheel.
    blades: usize,
    /// Whether the wheel is on a plain shaft, which is drawn with the wheel.
    shaft: bool,
}

/// A wheel that belongs to no link and meshes with the wheels of two links.
#[derive(Clone, Debug)]
struct Idler {
    carrier: LinkOrFrame,
    /// Centre, in the coordinates of the carrier.
    centre: Point,
    wheel: Wheel,
    /// Link of the driving wheel.
    driver: LinkId,
    /// Direction of a tooth of the driving wheel in the coordinates of that wheel's link, radians.
    lead: f64,
    module: f64,
    mates: Vec<(u32, bool)>,
}

impl Drawn {
    /// Returns the outer radius.
    fn rim(&self) -> f64 {
        let beyond = if self.ring { RING } else { 1.0 };
        (0.5 * f64::from(self.teeth) + beyond) * self.module
    }

    /// Whether this wheel is on the link and has the given teeth and module. (A link may have several wheels.)
    fn is(&self, link: LinkId, wheel: &Wheel, module: f64) -> bool {
        let like = self.link == link && self.teeth == wheel.teeth && self.ring == wheel.ring;
        like && (self.module / module - 1.0).abs() < SAME
    }
}

impl Gearing {
    pub(super) fn new(layout: &Layout, home: Posed<'_, 1>, view: &View) -> Self {
        let mechanism = home.mechanism;
        let draft = mechanism.spec();
        let mut gearing = Self {
            links: draft.links.len(),
            ..Self::default()
        };
        for gear in &draft.gears {
            gearing.add(layout, home, gear);
        }
        // A link may have several wheels; the blades are on the first of them.
        for (name, count) in &view.annotations.blades {
            let link = mechanism.link(name);
            let mut wheels = gearing.wheels.iter_mut();
            if let Some(wheel) = wheels.find(|wheel| Some(wheel.link) == link) {
                wheel.blades = *count;
            }
        }
        gearing
    }

    /// Adds the idler and the new wheels of a gear coupling. Returns none if they cannot be drawn.
    fn add(&mut self, layout: &Layout, home: Posed<'_, 1>, gear: &GearSpec) -> Option<()> {
        let mechanism = home.mechanism;
        let link = |name: &String| mechanism.link(name);
        let [first, second] = [link(&gear.links[0])?, link(&gear.links[1])?];
        let carrier = link(&gear.carrier);
        let hinge = |wheel: LinkId| {
            let on = layout::body_of(mechanism, carrier);
            layout.hinge(mechanism, mechanism.root_of(wheel), on)
        };
        let hinges = [hinge(first)?, hinge(second)?];
        let [from, to] = hinges.map(|point| home.local(carrier, point));
        let between = to - from;
        let line = between.y.atan2(between.x);
        // The module is proportional to the distance between the centres; `unit` has module 1.
        let unit = GearPair::new(gear.teeth, gear.mesh, 1.0, line).ok()?;
        let module = between.norm() / unit.driven_wheel().centre.norm();
        let pair = GearPair::new(gear.teeth, gear.mesh, module, line).ok()?;
        let train = pair.train();
        let [driver, driven] = [train.first()?, train.last()?];

        // Angles relative to the carrier.
        let (_, turn) = home.body(carrier);
        let seen = |link: LinkId| home.angle(link) - turn;
        let lead = |link: LinkId, wheel: &Wheel| {
            let same = |drawn: &&Drawn| drawn.is(link, wheel, module);
            self.wheels.iter().find(same).map(|drawn| drawn.lead)
        };
        let leads = match (lead(first, driver), lead(second, driven)) {
            (Some(one), Some(other)) => [one, other],
            (None, Some(other)) => {
                let mate = (seen(second) + other - driven.mounting) / driven.ratio;
                [mate - seen(first), other]
            }
            (one, None) => {
                let one = one.unwrap_or(0.0);
                let mate = driven.ratio * (seen(first) + one) + driven.mounting;
                [one, mate - seen(second)]
            }
        };
        let mate = |wheel: &Wheel| (wheel.teeth, wheel.ring);
        let beside = [train.get(1).map(mate), train.iter().rev().nth(1).map(mate)];
        for (k, (link, wheel)) in [(first, driver), (second, driven)].into_iter().enumerate() {
            let known = self
                .wheels
                .iter()
                .position(|drawn| drawn.is(link, wheel, module));
            let drawn = known.unwrap_or_else(|| {
                self.wheels.push(Drawn {
                    link,
                    role: layout.drawn_role(link),
                    centre: home.local(Some(link), hinges[k]),
                    hinge: hinges[k],
                    lead: leads[k],
                    teeth: wheel.teeth,
                    ring: wheel.ring,
                    module,
                    mates: Vec::new(),
                    blades: 0,
                    shaft: layout.is_shaft(hinges[k]),
                });
                self.wheels.len() - 1
            });
            self.wheels[drawn].mates.extend(beside[k]);
        }
        if let (Mesh::AsPrinted, Some(idler)) = (gear.mesh, pair.idler()) {
            self.idlers.push(Idler {
                carrier,
                centre: from + idler.centre,
                wheel: idler,
                driver: first,
                lead: leads[0],
                module,
                mates: vec![mate(driver), mate(driven)],
            });
        }
        Some(())
    }

    pub(super) fn is_wheel(&self, link: LinkId) -> bool {
        self.wheels.iter().any(|drawn| drawn.link == link)
    }

    /// Returns two opposite corners of the square around each wheel and each idler in a pose.
    pub(super) fn reach<const N: usize>(&self, posed: Posed<'_, N>) -> impl Iterator<Item = Point> {
        let wheels = self.wheels.iter();
        let wheels = wheels.map(move |drawn| (posed.place(drawn.hinge), drawn.rim()));
        let idlers = self.idlers(posed).zip(&self.idlers);
        let idlers = idlers.map(|((at, _), idler)| {
            let rim = 0.5 * f64::from(idler.wheel.teeth) + 1.0;
            (at, rim * idler.module)
        });
        wheels.chain(idlers).flat_map(|(at, rim)| {
            let corner = Vector::repeat(rim);
            [at - corner, at + corner]
        })
    }

    /// Returns the distance of a point from each wheel (0 on the wheel), with the link of the wheel.
    pub(super) fn distances<const N: usize>(
        &self,
        posed: Posed<'_, N>,
        place: Point,
    ) -> impl Iterator<Item = (f64, LinkId)> {
        self.wheels.iter().map(move |drawn| {
            let off = (place - posed.place(drawn.hinge)).norm();
            let beyond = (off - drawn.rim()).max(0.0);
            let inner = (0.5 * f64::from(drawn.teeth) - 1.0) * drawn.module;
            let distance = if drawn.ring {
                beyond.max(inner - off)
            } else {
                beyond
            };
            (distance, drawn.link)
        })
    }

    /// Finds the smallest wheel at a point and returns its link. A ring covers only its rim, other wheels a whole disc.
    pub(super) fn wheel_at<const N: usize>(
        &self,
        posed: Posed<'_, N>,
        place: Point,
    ) -> Option<LinkId> {
        let distances = self.distances(posed, place);
        let wheels = self.wheels.iter().zip(distances);
        let hit = wheels.filter(|(_, (off, _))| *off <= 0.0);
        let (smallest, _) = hit.min_by(|(one, _), (other, _)| one.rim().total_cmp(&other.rim()))?;
        Some(smallest.link)
    }

    /// Returns the position of a wheel's number.
    pub(super) fn tagged<const N: usize>(
        &self,
        posed: Posed<'_, N>,
        link: LinkId,
        tag: &Tag,
    ) -> Option<Point> {
        let drawn = self.wheels.iter().find(|drawn| drawn.link == link)?;
        let outward = if drawn.ring { 1.0 } else { 0.84 };
        let radius = 0.5 * outward * f64::from(drawn.teeth) * drawn.module;
        let (sin, cos) = tag.direction.sin_cos();
        let at = posed.place(drawn.hinge);
        Some(at + Vector::new(cos, sin) * radius)
    }

    /// Returns the centre and the angle of each idler in a pose.
    pub(super) fn idlers<const N: usize>(
        &self,
        posed: Posed<'_, N>,
    ) -> impl Iterator<Item = (Point, f64)> {
        self.idlers.iter().map(move |idler| {
            let (origin, turn) = posed.body(idler.carrier);
            let at = origin + layout::turned(idler.centre.coords, turn);
            let driver = posed.angle(idler.driver) - turn + idler.lead;
            (at, turn + idler.wheel.ratio * driver + idler.wheel.mounting)
        })
    }

    /// Returns the centres of idlers on the frame.
    pub(super) fn fixed_idlers(&self) -> impl Iterator<Item = Point> {
        let fixed = self.idlers.iter().filter(|idler| idler.carrier.is_none());
        fixed.map(|idler| idler.centre)
    }

    /// Draws all wheels, with rings behind the wheels inside them.
    pub(super) fn draw(&self, list: &mut List, u: f64) {
        let rings = self.wheels.iter().filter(|drawn| drawn.ring);
        for drawn in rings.chain(self.wheels.iter().filter(|drawn| !drawn.ring)) {
            list.body(layout::number(Some(drawn.link)));
            let teeth = Teeth::new(drawn.teeth, drawn.ring, &drawn.mates);
            let place = |p: Point| drawn.centre + layout::turned(p.coords, drawn.lead);
            let outline = teeth.outline(drawn.module).into_iter().map(place);
            let mut loops = vec![outline.collect()];
            if drawn.ring {
                let rim = parts::round(drawn.rim(), 180);
                loops.push(rim.into_iter().map(place).collect());
            }
            list.polygons(drawn.role, Look::Pale, &loops);
            let reach = 0.72 * teeth.pitch_radius() * drawn.module;
            let slender = (0.075 * reach).min(0.8 * u);
            for blade in parts::blades(drawn.blades, reach, slender) {
                let blade = blade.into_iter().map(place).collect();
                list.polygons(drawn.role, Look::Soft, &[blade]);
            }
            if drawn.shaft {
                list.circle(Role::Ink, Look::Hollow, drawn.centre, 0.7 * u);
            }
        }
        for (k, idler) in self.idlers.iter().enumerate() {
            list.body(1 + self.links + k);
            let teeth = Teeth::new(idler.wheel.teeth, false, &idler.mates);
            list.polygons(Role::Idler, Look::Pale, &[teeth.outline(idler.module)]);
            list.circle(Role::Ink, Look::Hollow, Point::origin(), 0.7 * u);
        }
    }
}

#[cfg(test)]
mod tests;
