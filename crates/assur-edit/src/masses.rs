//! Masses of links: the place of a centre of mass, uniform bars, and counterweights.

use assur::Vector;
use assur::forces::{Counterweight, Loading, counterweights};
use assur::mechanism::Mechanism;
use assur::motion::Motion;
use assur_file::{LinkDocument, LinkageProblem};

use crate::draw::Drawing;

/// Moments of counterweights smaller than this share of the mass of the links times the size of the drawing are
/// rounding errors of zero.
const BALANCED: f64 = 1e-9;

impl Drawing {
    /// Puts the centre of mass of a link at coordinates on it.
    ///
    /// # Errors
    /// An unknown link, or one without points.
    pub(crate) fn centre(&mut self, link: &str, on: [f64; 2]) -> Result<(), LinkageProblem> {
        let at = self.off_link(link, Vector::from(on))?.into();
        let centre = self.linked(link)?.centre_of_mass.clone();
        let own = centre.filter(|point| self.is_centre_alone(link, point));
        let Some(point) = own else {
            let point = self.put(at);
            self.list(link, &point)?;
            self.change(link, |link| link.centre_of_mass = Some(point));
            return Ok(());
        };
        self.redraw(|one| one.name == link);
        let mut points = self.document.points.iter_mut();
        if let Some(point) = points.find(|one| one.name == point) {
            point.at = at;
        }
        Ok(())
    }

    /// Makes a link a uniform bar.
    ///
    /// # Errors
    /// An unknown link; a link without two points.
    pub(crate) fn uniform(
        &mut self,
        link: &str,
        section: f64,
        density: f64,
    ) -> Result<(), LinkageProblem> {
        let [from, to] = match &self.linked(link)?.points[..] {
            [from, to, ..] => [self.at(from)?, self.at(to)?],
            _ => {
                let link = link.to_owned();
                return Err(LinkageProblem::NoLine { link });
            }
        };
        let metre = self.document.force_units().force();
        let volume = section * (to - from).norm() * metre.powi(3);
        self.change(link, |link| {
            link.mass_kg = Some(density * volume);
            link.centre_of_mass = None;
            link.inertia = None;
        });
        Ok(())
    }

    /// Adds the counterweights of a four-bar.
    ///
    /// # Errors
    /// Another linkage; links without mass, or already balanced.
    pub(crate) fn balance(&mut self) -> Result<(), LinkageProblem> {
        let mechanism = Mechanism::new(&self.document.spec());
        let weights = mechanism.ok().and_then(found);
        let (mechanism, weights) = weights.ok_or(LinkageProblem::NotFourBar)?;
        let masses = self.document.links.iter();
        let mass: f64 = masses.filter_map(|link| link.mass_kg).sum();
        let least = BALANCED * mass * self.size();
        let mut added = false;
        for weight in weights {
            let moment = weight.moment.norm();
            if moment <= least {
                continue;
            }
            let hinge = mechanism.point_name(weight.hinge).to_owned();
            let off = weight.moment * (weight.reach / moment);
            let centre = self.put((self.at(&hinge)? + off).into());
            let name = self.add_link(&[hinge, centre.clone()], Some("counterweight"));
            let on = mechanism.body_name(weight.body).to_owned();
            self.change(&name, |link| {
                *link = LinkDocument {
                    mass_kg: Some(moment / weight.reach),
                    centre_of_mass: Some(centre),
                    inertia: Some(0.0),
                    fixed_to: Some(on),
                    ..link.clone()
                };
            });
            added = true;
        }
        let already = LinkageProblem::AlreadyBalanced;
        if added { Ok(()) } else { Err(already) }
    }

    /// Whether a point of a link serves as its centre of mass only: no other link has it, and it does not give the
    /// angle of the link.
    fn is_centre_alone(&self, link: &str, point: &str) -> bool {
        let document = &self.document;
        let has = |points: &[String]| points.iter().any(|one| one == point);
        let of = document.links.iter();
        let on_others = of.clone().any(|one| one.name != link && has(&one.points));
        let mut of = of.filter(|one| one.name == link);
        let gives_angle = of.any(|one| has(&one.points[..one.points.len().min(2)]));
        let slides = document.slides.iter();
        let mut slides = slides.filter(|slide| slide.link == link || slide.on == link);
        let slides = slides.any(|slide| slide.point == point || has(&slide.line));
        !(on_others || gives_angle || slides || has(&document.frame))
    }
}

/// Counterweights of a mechanism in its drawn pose.
fn found(mechanism: Mechanism) -> Option<(Mechanism, [Counterweight; 2])> {
    let motion = Motion::new(mechanism);
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(motion.drawn_input()).ok()?;
    let weights = counterweights(mechanism, &Loading::of_masses(mechanism), &pose)?;
    Some((mechanism.clone(), weights))
}
