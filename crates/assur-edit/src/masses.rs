//! Masses of links: the place of a centre of mass, and uniform bars.

use assur::Vector;
use assur_file::LinkageProblem;

use crate::draw::Drawing;

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
