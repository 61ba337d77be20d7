//! Drivers, meshes, points fixed to the frame, and links fixed to each other.

use assur::mechanism::{Defect, FRAME};
use assur_file::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, LinkageProblem, MeshDocument,
    SlideDocument,
};

use crate::draw::Drawing;

type Done = Result<(), LinkageProblem>;

impl Drawing {
    /// Puts two wheels in mesh. Their earlier mesh, if there is one, is removed.
    pub(crate) fn mesh(&mut self, links: &[String; 2], teeth: [f64; 2], internal: bool) -> Done {
        let [first, second] = links;
        let carrier = self.carrier(links)?;
        self.document
            .gears
            .retain(|gear| !gear.links.contains(first) || !gear.links.contains(second));
        self.document.gears.push(GearDocument {
            links: links.clone(),
            carrier,
            teeth,
            mesh: if internal {
                MeshDocument::Internal
            } else {
                MeshDocument::External
            },
        });
        Ok(())
    }

    /// The link, or the frame, to which both of these links are hinged.
    fn carrier(&self, links: &[String; 2]) -> Result<String, LinkageProblem> {
        let [first, second] = links;
        let own = [&self.linked(first)?.points, &self.linked(second)?.points];
        let carries = |points: &[String]| {
            own.iter()
                .all(|own| own.iter().any(|one| points.contains(one)))
        };
        let mut others = self.document.links.iter();
        let carrier = others.find(|other| !links.contains(&other.name) && carries(&other.points));
        let frame = carries(&self.document.frame).then(|| FRAME.to_owned());
        let carrier = frame.or(carrier.map(|link| link.name.clone()));
        let links = links.clone();
        carrier.ok_or(Defect::NotHinged { links }.into())
    }

    /// Drives a link, or stops driving it if it is driven. If there are enough drivers already, the new
    /// driver replaces the last one.
    pub(crate) fn drive(&mut self, link: &str) -> Done {
        let LinkageDocument { slides, .. } = &self.document;
        let by_slide = slides.iter().position(|slide| slide.link == link);
        let points = &self.linked(link)?.points;
        let drives = |driver: &DriverDocument| {
            let slide = driver.slide.and_then(|slide| slides.get(slide));
            driver.crank.as_deref() == Some(link) || slide.is_some_and(|slide| slide.link == link)
        };
        if let Some(driver) = self.document.drivers.iter().position(drives) {
            self.document.drivers.remove(driver);
            return Ok(());
        }
        let driver = if let Some(slide) = by_slide {
            DriverDocument {
                slide: Some(slide),
                range: Some(self.range(slide)?),
                ..DriverDocument::default()
            }
        } else {
            let base = if points
                .iter()
                .any(|point| self.document.frame.contains(point))
            {
                None
            } else {
                let shares = |other: &&LinkDocument| {
                    other.name != link && other.points.iter().any(|point| points.contains(point))
                };
                let base = self.document.links.iter().find(shares);
                let links = || [link.to_owned(), FRAME.to_owned()];
                Some(
                    base.ok_or_else(|| Defect::NotHinged { links: links() })?
                        .name
                        .clone(),
                )
            };
            DriverDocument {
                crank: Some(link.to_owned()),
                base,
                ..DriverDocument::default()
            }
        };
        let freedoms = self
            .document
            .spec()
            .counts()
            .map_or(1, |counts| counts.mobility);
        let drivers = &mut self.document.drivers;
        if !drivers.is_empty() && freedoms <= drivers.len() as isize {
            drivers.pop();
        }
        drivers.push(driver);
        Ok(())
    }

    /// The range of a driven slide: half the length of its line on either side of the drawn position. If the line has
    /// no length, the size of the drawing replaces the length.
    fn range(&self, slide: usize) -> Result<[f64; 2], LinkageProblem> {
        let SlideDocument { point, line, .. } = &self.document.slides[slide];
        let [from, to] = [self.at(&line[0])?, self.at(&line[1])?];
        let length = (to - from).norm();
        let along = (to - from) / length;
        let way = if along.x.is_finite() {
            (self.at(point)? - from).dot(&along)
        } else {
            0.0
        };
        let half = 0.5 * if length > 0.0 { length } else { self.size() };
        Ok([way - half, way + half])
    }

    /// Fixes a point to the frame, or releases it if it is fixed.
    pub(crate) fn fix(&mut self, point: &str) -> Done {
        self.at(point)?;
        let frame = &mut self.document.frame;
        match frame.iter().position(|one| one == point) {
            Some(place) => {
                frame.remove(place);
            }
            None => {
                frame.push(point.to_owned());
                self.begin_at_pivots();
            }
        }
        Ok(())
    }

    /// Lets each bar begin at its fixed pivot, as if it had been drawn from there. A bar whose direction is in use stays as
    /// it is: it is driven or loaded, or has a traced point.
    fn begin_at_pivots(&mut self) {
        let mut used: Vec<String> = Vec::new();
        for driver in &self.document.drivers {
            used.extend(driver.crank.iter().chain(&driver.base).cloned());
        }
        used.extend(self.document.tracers.iter().map(|one| one.link.clone()));
        (self.document).links_under_load(&mut |link: &mut String| used.push(link.clone()));
        let mut links = std::mem::take(&mut self.document.links);
        for link in &mut links {
            let ends: Result<&[String; 2], _> = link.points.as_slice().try_into();
            let is_turned = link.shape.is_none() && ends.is_ok_and(|ends| self.ends_at_pivot(ends));
            if is_turned && !used.contains(&link.name) {
                link.points.reverse();
            }
        }
        self.document.links = links;
    }

    /// Fixes the first link to the second, or to the frame; releases it if it is already fixed there.
    pub(crate) fn weld(&mut self, [first, second]: &[String; 2]) -> Done {
        if second != FRAME {
            self.linked(second)?;
        }
        let fixed = self.linked(first)?.fixed_to.as_ref() != Some(second);
        self.redraw(|link| link.name == *first);
        self.change(first, |link| link.fixed_to = fixed.then(|| second.clone()));
        Ok(())
    }
}
