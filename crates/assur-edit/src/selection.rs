//! Copying of parts of a drawing.

use assur::mechanism::FRAME;
use assur_file::LinkageDocument;

use crate::draw::Drawing;
use crate::names;

/// Copies a part of a drawing for [`crate::Edit::Paste`]: these points, and these links with their
/// points and the connections between them.
pub fn selected(
    document: &LinkageDocument,
    points: &[String],
    links: &[String],
) -> LinkageDocument {
    let link = |name: &String| links.contains(name);
    let kept: Vec<_> = document
        .links
        .iter()
        .filter(|one| link(&one.name))
        .cloned()
        .collect();
    let on_frame = |name: &String| name == FRAME || link(name);
    let slides = document.slides.iter().enumerate();
    let slides: Vec<_> = slides
        .filter(|(_, slide)| link(&slide.link) && on_frame(&slide.on))
        .collect();
    let lines = slides.iter().flat_map(|(_, slide)| &slide.line);
    let of_links = kept.iter().flat_map(|one| &one.points);
    let names: Vec<&String> = of_links.chain(lines).chain(points).collect();
    let drivers = document.drivers.iter().filter_map(|driver| {
        let mut driver = driver.clone();
        if let Some(slide) = driver.slide {
            driver.slide = Some(slides.iter().position(|(index, _)| *index == slide)?);
            return Some(driver);
        }
        driver
            .crank
            .iter()
            .chain(&driver.base)
            .all(link)
            .then_some(driver)
    });
    let mut part = LinkageDocument {
        unit: document.unit,
        loads: document.loads.clone(),
        springs: document.springs.clone(),
        dampers: document.dampers.clone(),
        friction: document.friction.clone(),
        points: document
            .points
            .iter()
            .filter(|one| names.contains(&&one.name))
            .cloned()
            .collect(),
        frame: document
            .frame
            .iter()
            .filter(|one| names.contains(one))
            .cloned()
            .collect(),
        drivers: drivers.collect(),
        gears: document
            .gears
            .iter()
            .filter(|gear| gear.links.iter().all(link) && on_frame(&gear.carrier))
            .cloned()
            .collect(),
        locks: document
            .locks
            .iter()
            .filter(|lock| lock.iter().all(|point| names.contains(&point)))
            .cloned()
            .collect(),
        tracers: document
            .tracers
            .iter()
            .filter(|tracer| link(&tracer.link))
            .cloned()
            .collect(),
        slides: slides.into_iter().map(|(_, slide)| slide.clone()).collect(),
        links: kept
            .into_iter()
            .map(|mut one| {
                one.fixed_to = one.fixed_to.filter(link);
                one
            })
            .collect(),
        ..LinkageDocument::default()
    };
    part.remove_under_load(|name| !links.iter().any(|one| one == name), |_| false);
    part.remove_idle_friction();
    part
}

impl Drawing {
    /// Adds another drawing, displaced, to the existing one. The added parts get free names.
    pub(crate) fn paste(&mut self, drawing: &LinkageDocument, [x, y]: [f64; 2]) {
        let mut other = drawing.clone();
        for point in &mut other.points {
            point.at[0] += x;
            point.at[1] += y;
        }
        // Parts get temporary names first, because a name that is free in this drawing may be taken in the other.
        let called = names::called_by_points(&other);
        let points: Vec<String> = (other.points.iter().map(|point| &point.name))
            .chain(other.tracers.iter().map(|tracer| &tracer.name))
            .cloned()
            .collect();
        let links: Vec<String> = other.links.iter().map(|link| link.name.clone()).collect();
        for (k, name) in points.iter().enumerate() {
            names::rename_point(&mut other, name, &aside(k));
        }
        for (k, name) in links.iter().enumerate() {
            names::rename_link(&mut other, name, &aside(k));
        }
        let document = &mut self.document;
        let [first, slides] = [document.links.len(), document.slides.len()];
        for driver in &mut other.drivers {
            driver.slide = driver.slide.map(|slide| slide + slides);
        }
        document.points.extend(other.points);
        document.frame.extend(other.frame);
        document.links.extend(other.links);
        document.slides.extend(other.slides);
        document.gears.extend(other.gears);
        document.drivers.extend(other.drivers);
        document.tracers.extend(other.tracers);
        document.loads.extend(other.loads);
        document.springs.extend(other.springs);
        document.dampers.extend(other.dampers);
        document.friction.extend(other.friction);
        document.locks.extend(other.locks);
        for (k, name) in points.iter().enumerate() {
            let free = names::free_point(document, name);
            names::rename_point(document, &aside(k), &free);
            self.point = Some(free);
        }
        for (k, name) in links.iter().enumerate() {
            let own = &document.links[first + k].points;
            let wish = (!called.contains(name)).then_some(name.as_str());
            let free = names::new_link(document, own, wish);
            names::rename_link(document, &aside(k), &free);
            self.link = Some(free);
        }
    }
}

/// A temporary name. It has a control character, which names of parts cannot contain.
fn aside(k: usize) -> String {
    format!("\u{1}{k}")
}
