//! Wheels of gear couplings: sizes from the distance of their hinges, teeth in
//! mesh. A wheel is drawn on its link; an idler is a body of its own.

use assur::gears::{GearPair, Mesh, Wheel};
use assur::mechanism::{Draft, DraftGear, LinkId, LinkOrFrame, Mechanism, PointId, Pose};
use assur::{Point, Vector};

use super::layout::{self, Layout};
use crate::gear::Teeth;
use crate::list::{List, Look, Role};
use crate::parts;

/// What a ring has beyond its pitch circle, in modules.
const RING: f64 = 2.75;
/// Modules that differ by less than this relative to their size are one.
const SAME: f64 = 1e-3;

/// The wheels of a draft.
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
    /// Its centre on the link, the point it turns about, and where a tooth is.
    centre: Point,
    hinge: PointId,
    lead: f64,
    teeth: u32,
    ring: bool,
    module: f64,
    mates: Vec<(u32, bool)>,
}

/// A wheel between two others, in no link's list.
#[derive(Clone, Debug)]
struct Idler {
    carrier: LinkOrFrame,
    /// Its centre on the carrier.
    centre: Point,
    wheel: Wheel,
    /// The driving wheel's link and where its tooth is.
    driver: LinkId,
    lead: f64,
    module: f64,
    mates: Vec<(u32, bool)>,
}

impl Drawn {
    /// Whether it is this wheel of this link, of this module. (A link may hold
    /// several.)
    fn is(&self, link: LinkId, wheel: &Wheel, module: f64) -> bool {
        let like = self.link == link && self.teeth == wheel.teeth && self.ring == wheel.ring;
        like && (self.module / module - 1.0).abs() < SAME
    }
}

impl Gearing {
    pub(super) fn new(
        draft: &Draft,
        layout: &Layout,
        mechanism: &Mechanism,
        home: &Pose<1>,
    ) -> Self {
        let mut gearing = Self {
            links: draft.links.len(),
            ..Self::default()
        };
        for gear in &draft.gears {
            gearing.add(layout, mechanism, home, gear);
        }
        gearing
    }

    /// Adds what is not there yet of a coupling; none where it cannot be drawn.
    fn add(
        &mut self,
        layout: &Layout,
        mechanism: &Mechanism,
        home: &Pose<1>,
        gear: &DraftGear,
    ) -> Option<()> {
        let link = |name: &String| mechanism.link(name);
        let [first, second] = [link(&gear.links[0])?, link(&gear.links[1])?];
        let carrier = link(&gear.carrier);
        let hinge = |wheel: LinkId| {
            let [body, other] = [Some(wheel), carrier].map(|link| layout::body_of(mechanism, link));
            layout.hinge(mechanism, body, other)
        };
        let hinges = [hinge(first)?, hinge(second)?];
        let [from, to] = hinges.map(|point| layout::local(mechanism, home, carrier, point));
        let between = to - from;
        let line = between.y.atan2(between.x);
        // The module that makes the wheels meet: as many times that of one.
        let unit = GearPair::new(gear.teeth, gear.mesh, 1.0, line).ok()?;
        let module = between.norm() / unit.driven_wheel().centre.norm();
        let pair = GearPair::new(gear.teeth, gear.mesh, module, line).ok()?;
        let train = pair.train();
        let [driver, driven] = [train.first()?, train.last()?];

        // Angles seen from the carrier.
        let (_, turn) = layout::body(mechanism, home, carrier);
        let seen = |link: LinkId| mechanism.angle(home, link).value() - turn;
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
        let meshing = [train.get(1).map(mate), train.iter().rev().nth(1).map(mate)];
        for (k, (link, wheel)) in [(first, driver), (second, driven)].into_iter().enumerate() {
            let known = self
                .wheels
                .iter()
                .position(|drawn| drawn.is(link, wheel, module));
            let drawn = known.unwrap_or_else(|| {
                self.wheels.push(Drawn {
                    link,
                    role: layout.drawn_role(link),
                    centre: layout::local(mechanism, home, Some(link), hinges[k]),
                    hinge: hinges[k],
                    lead: leads[k],
                    teeth: wheel.teeth,
                    ring: wheel.ring,
                    module,
                    mates: Vec::new(),
                });
                self.wheels.len() - 1
            });
            self.wheels[drawn].mates.extend(meshing[k]);
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

    /// Corners of the squares around the wheels in these poses.
    pub(super) fn reach(&self, mechanism: &Mechanism, samples: &[Vec<Pose<1>>]) -> Vec<Point> {
        let mut corners = Vec::new();
        for pose in samples.iter().flatten() {
            for drawn in &self.wheels {
                let at = mechanism.place(pose, drawn.hinge).place();
                let beyond = if drawn.ring { RING } else { 1.0 };
                let radius = (0.5 * f64::from(drawn.teeth) + beyond) * drawn.module;
                corners.extend([at - Vector::repeat(radius), at + Vector::repeat(radius)]);
            }
        }
        corners
    }

    /// Where the idlers are.
    pub(super) fn idlers(
        &self,
        mechanism: &Mechanism,
        pose: &Pose<1>,
    ) -> impl Iterator<Item = (Point, f64)> {
        self.idlers.iter().map(|idler| {
            let (origin, turn) = layout::body(mechanism, pose, idler.carrier);
            let at = origin + layout::turned(idler.centre.coords, turn);
            let driver = mechanism.angle(pose, idler.driver).value() - turn + idler.lead;
            (at, turn + idler.wheel.ratio * driver + idler.wheel.mounting)
        })
    }

    /// Draws all, rings behind what turns inside them.
    pub(super) fn draw(&self, list: &mut List, u: f64) {
        let rings = self.wheels.iter().filter(|drawn| drawn.ring);
        for drawn in rings.chain(self.wheels.iter().filter(|drawn| !drawn.ring)) {
            list.body(drawn.link.index() + 1);
            let teeth = Teeth::new(drawn.teeth, drawn.ring, &drawn.mates);
            let place = |p: Point| drawn.centre + layout::turned(p.coords, drawn.lead);
            let outline = teeth.outline(drawn.module).into_iter().map(place);
            let mut loops = vec![outline.collect()];
            if drawn.ring {
                let rim = (0.5 * f64::from(drawn.teeth) + RING) * drawn.module;
                loops.push(parts::round(rim, 180).into_iter().map(place).collect());
            }
            list.polygons(drawn.role, Look::Pale, &loops);
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
mod tests {
    use std::f64::consts::PI;

    use assur::motion::Motion;

    use super::*;

    /// An arm with a sun on the frame and a planet, in a ring, and a train driven by that.
    fn draft() -> Draft {
        // Where the second wheel's module is the same in both of its meshes.
        let module = 2.0 * 10.0_f64.sqrt() / 94.0;
        let mut draft = Draft::default()
            .point("O", 0.0, 0.0)
            .point("Q", 0.1, 0.4)
            .point("P", 1.0, 0.2)
            .point("M", 1.2, 0.5)
            .point("E", 3.0, 1.0)
            .point("F", 3.0 + 19.5 * module, 1.0)
            .fixed(&["O", "Q", "E", "F"])
            .bar("arm", &["O", "P"])
            .bar("planet", &["P", "M"])
            .bar("ring", &["O"])
            .bar("second", &["E"])
            .bar("third", &["F"])
            .crank("arm");
        let mut sun = assur::mechanism::DraftLink {
            name: "sun".to_owned(),
            points: vec!["O".to_owned(), "Q".to_owned()],
            ..Default::default()
        };
        sun.fixed_to = Some("frame".to_owned());
        draft.links.push(sun);
        for (links, carrier, teeth, mesh) in [
            // Not in the order in which they turn each other.
            (["third", "second"], "frame", [15.0, 24.0], Mesh::External),
            (["sun", "planet"], "arm", [30.0, 20.0], Mesh::External),
            (["planet", "ring"], "arm", [20.0, 70.0], Mesh::Internal),
            (["ring", "second"], "frame", [70.0, 24.0], Mesh::External),
        ] {
            draft.gears.push(DraftGear {
                links: links.map(str::to_owned),
                carrier: carrier.to_owned(),
                teeth,
                mesh,
            });
        }
        draft
    }

    /// Where two wheels touch, a tooth's middle stands against a gap's, at every
    /// input, though some wheels mesh with two others.
    #[test]
    fn teeth_meet_gaps_all_along_a_train() {
        let draft = draft();
        let mechanism = Mechanism::new(&draft).unwrap();
        let motion = Motion::new(mechanism);
        let mechanism = motion.mechanism();
        let home = motion.pose::<1>(motion.home()).unwrap();
        let layout = Layout::new(&draft, mechanism, &home, false);
        let gearing = Gearing::new(&draft, &layout, mechanism, &home);
        // The ring has an outer rim of teeth as well, for the train.
        assert_eq!(gearing.wheels.len(), 6);
        for input in [0.0, 0.3, 1.7, 4.0] {
            let pose = motion.pose::<1>(input).unwrap();
            for gear in &draft.gears {
                let internal = gear.mesh == Mesh::Internal;
                let drawn = [0, 1].map(|k| {
                    let link = mechanism.link(&gear.links[k]).unwrap();
                    let ring = internal && gear.teeth[k] > gear.teeth[1 - k];
                    let mut wheels = gearing.wheels.iter();
                    wheels
                        .find(|one| one.link == link && one.ring == ring)
                        .unwrap()
                });
                let [a, b] = drawn.map(|one| mechanism.place(&pose, one.hinge).place());
                let line = (b - a).y.atan2((b - a).x);
                let phase = |one: &Drawn, contact: f64| {
                    let angle = mechanism.angle(&pose, one.link).value() + one.lead;
                    (contact - angle) * f64::from(one.teeth) / (2.0 * PI)
                };
                let [first, second] = drawn;
                let sum = if internal {
                    let contact = if second.ring { line + PI } else { line };
                    phase(first, contact) - phase(second, contact)
                } else {
                    phase(first, line) + phase(second, line + PI)
                };
                let off = (sum - 0.5) - (sum - 0.5).round();
                assert!(off.abs() < 1e-9, "{:?} at {input}: {off}", gear.links);
                let [r, s] = drawn.map(|one| 0.5 * f64::from(one.teeth) * one.module);
                let apart = if internal { (r - s).abs() } else { r + s };
                assert!((apart - (b - a).norm()).abs() < 1e-12);
            }
        }
    }
}
