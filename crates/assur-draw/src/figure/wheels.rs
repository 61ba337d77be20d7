//! Wheels of gear couplings: sizes from the distance of their hinges, teeth in
//! mesh. A wheel is drawn on its link; an idler is a body of its own.

use assur::gears::{GearPair, Mesh, Wheel};
use assur::mechanism::{Draft, DraftGear, Mechanism, Pose};
use assur::{Point, Vector};

use super::layout::{self, Layout, LinkOrFrame};
use crate::gear::Teeth;
use crate::list::{List, Look, Role};
use crate::parts;

/// What a ring has beyond its pitch circle, in modules.
const RING: f64 = 2.75;

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
    link: usize,
    role: Role,
    /// Its centre on the link, the point it turns about, and where a tooth is.
    centre: Point,
    hinge: usize,
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
    driver: usize,
    lead: f64,
    module: f64,
    mates: Vec<(u32, bool)>,
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
            gearing.add(draft, layout, mechanism, home, gear);
        }
        gearing
    }

    /// Adds what is not there yet of a coupling; none where it cannot be drawn.
    fn add(
        &mut self,
        draft: &Draft,
        layout: &Layout,
        mechanism: &Mechanism,
        home: &Pose<1>,
        gear: &DraftGear,
    ) -> Option<()> {
        let link = |name: &String| layout::index_of(draft, name);
        let [first, second] = [link(&gear.links[0])?, link(&gear.links[1])?];
        let carrier = link(&gear.carrier);
        let hinge = |wheel: usize| {
            let body = layout::body_of(draft, Some(wheel));
            layout.hinge(body, layout::body_of(draft, carrier))
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
        let seen = |link: usize| mechanism.angle(home, link).value() - turn;
        let lead = |link: usize, wheel: &Wheel| {
            let same = |drawn: &&Drawn| drawn.link == link && drawn.teeth == wheel.teeth;
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
            let same = |drawn: &Drawn| drawn.link == link && drawn.teeth == wheel.teeth;
            let known = self.wheels.iter().position(same);
            let drawn = known.unwrap_or_else(|| {
                self.wheels.push(Drawn {
                    link,
                    role: layout.role(link),
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

    pub(super) fn is_wheel(&self, link: usize) -> bool {
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
            list.body(drawn.link + 1);
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
