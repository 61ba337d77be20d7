//! Removal of parts, with the parts that depend on them; joining and separating hinges.

use std::collections::BTreeSet;

use assur::mechanism::FRAME;
use assur_file::{LinkageProblem, SlideDocument};

use crate::draw::{Drawing, unknown};
use crate::names;

type Done = Result<(), LinkageProblem>;

impl Drawing {
    /// Removes points and links, with the parts that depend on them. A link that loses points is removed if fewer than
    /// two remain. A point is removed with its last link or slide.
    pub(crate) fn remove(&mut self, points: &[String], links: &[String]) -> Done {
        let mut unknown_names = points
            .iter()
            .filter(|name| !names::is_point(&self.document, name));
        let mut unknown_links = links
            .iter()
            .filter(|name| *name == FRAME || !names::is_link(&self.document, name));
        if let Some(name) = unknown_names.next().or(unknown_links.next()) {
            return Err(unknown(name));
        }
        self.redraw(|link| link.points.iter().any(|point| points.contains(point)));
        let mut gone: BTreeSet<String> = links.iter().cloned().collect();
        let mut bared: BTreeSet<String> = BTreeSet::new();
        for link in &mut self.document.links {
            let before = link.points.len();
            if gone.contains(&link.name) {
                bared.extend(link.points.iter().cloned());
                continue;
            }
            link.points.retain(|point| !points.contains(point));
            let left = link.points.len();
            if left < before && left < 2 {
                gone.insert(link.name.clone());
                bared.extend(link.points.iter().cloned());
            }
        }
        let document = &mut self.document;
        document.links.retain(|link| !gone.contains(&link.name));
        for link in &mut document.links {
            if link.fixed_to.as_ref().is_some_and(|to| gone.contains(to)) {
                link.fixed_to = None;
            }
            if link
                .centre_of_mass
                .as_ref()
                .is_some_and(|centre| !link.points.contains(centre))
            {
                link.centre_of_mass = None;
            }
        }
        document
            .tracers
            .retain(|tracer| !gone.contains(&tracer.link) && !points.contains(&tracer.name));
        let is_gone = |name: &str| points.iter().any(|point| point == name);
        document.remove_under_load(|link| gone.contains(link), is_gone);
        document.gears.retain(|gear| {
            !gear
                .links
                .iter()
                .chain([&gear.carrier])
                .any(|link| gone.contains(link))
        });
        document.drivers.retain(|driver| {
            !driver
                .crank
                .iter()
                .chain(&driver.base)
                .any(|link| gone.contains(link))
        });
        self.drop_slides(
            |slide| {
                let links = [&slide.link, &slide.on];
                let used = slide.line.iter().chain([&slide.point]);
                links.into_iter().any(|link| gone.contains(link))
                    || used.into_iter().any(|point| points.contains(point))
            },
            &mut bared,
        );
        let lost: BTreeSet<String> = points
            .iter()
            .cloned()
            .chain(bared.into_iter().filter(|point| self.is_bare(point)))
            .collect();
        let document = &mut self.document;
        document.points.retain(|point| !lost.contains(&point.name));
        document.frame.retain(|point| !lost.contains(point));
        self.forget();
        Ok(())
    }

    /// Removes slides and their drivers. If a removed slide's line is on the frame, adds the points of this line to
    /// `bared`.
    fn drop_slides(&mut self, gone: impl Fn(&SlideDocument) -> bool, bared: &mut BTreeSet<String>) {
        let document = &mut self.document;
        let kept: Vec<bool> = document.slides.iter().map(|slide| !gone(slide)).collect();
        for slide in document.slides.iter().filter(|slide| gone(slide)) {
            if slide.on == FRAME {
                bared.extend(slide.line.iter().cloned());
            }
        }
        document.drivers.retain_mut(|driver| {
            let Some(slide) = driver.slide else {
                return true;
            };
            driver.slide = Some(kept.iter().take(slide).filter(|kept| **kept).count());
            kept.get(slide) == Some(&true)
        });
        let mut kept = kept.into_iter();
        document.slides.retain(|_| kept.next().unwrap_or(true));
    }

    /// Whether no link and no slide uses a point.
    pub(crate) fn is_bare(&self, point: &str) -> bool {
        let document = &self.document;
        let has = |points: &[String]| points.iter().any(|one| one == point);
        !document.links.iter().any(|link| has(&link.points))
            && !document
                .slides
                .iter()
                .any(|slide| has(&slide.line) || slide.point == point)
    }

    /// Removes plots, traces and locks of parts that no longer exist.
    fn forget(&mut self) {
        let document = &self.document;
        let traced = |name: &String| names::is_point(document, name);
        let traces = document.traces.iter().filter(|name| traced(name)).cloned();
        let plotted = |plot: &&String| match plot.rsplit_once('.') {
            Some((link, "angle")) => names::is_link(document, link),
            Some((point, _)) => names::is_point(document, point),
            None => false,
        };
        let plots = document.plots.iter().filter(plotted).cloned();
        let (traces, plots): (Vec<_>, Vec<_>) = (traces.collect(), plots.collect());
        self.document.traces = traces;
        self.document.plots = plots;
        let points: BTreeSet<&String> = self.document.points.iter().map(|one| &one.name).collect();
        let whole = |lock: &Vec<String>| lock.iter().all(|point| points.contains(point));
        self.document.locks.retain(whole);
    }

    /// Joins two points in one hinge at the position of the second.
    pub(crate) fn join(&mut self, points: &[String; 2]) -> Done {
        let [from, to] = points;
        self.at(from)?;
        self.at(to)?;
        if from == to {
            return Ok(());
        }
        let both = |own: &[String]| own.contains(from) && own.contains(to);
        if let Some(link) = self.document.links.iter().find(|link| both(&link.points)) {
            let (link, points) = (link.name.clone(), points.clone());
            return Err(LinkageProblem::OneLink { link, points });
        }
        let runs_on = |slide: &&SlideDocument| {
            let ends = [&slide.point, &slide.line[0], &slide.line[1]];
            ends.contains(&from) && ends.contains(&to)
        };
        if let Some(slide) = self.document.slides.iter().find(runs_on) {
            let (link, point) = (slide.link.clone(), slide.point.clone());
            return Err(LinkageProblem::OnItsLine { link, point });
        }
        self.redraw(|link| link.points.contains(from));
        let called = names::called_by_points(&self.document);
        let document = &mut self.document;
        document.points.retain(|point| point.name != *from);
        if both(&document.frame) {
            document.frame.retain(|point| point != from);
        }
        names::rename_point(document, from, to);
        names::call_by_points(document, &called);
        let mut seen = BTreeSet::new();
        self.document
            .traces
            .retain(|name| seen.insert(name.clone()));
        let mut seen = BTreeSet::new();
        self.document.plots.retain(|name| seen.insert(name.clone()));
        self.join_locks(to);
        self.point = Some(to.clone());
        Ok(())
    }

    /// Separates the links hinged at a point. The frame keeps the point or, if the point is not on the frame,
    /// the link listed first; every other link gets a point of its own.
    pub(crate) fn part(&mut self, point: &str) -> Done {
        let at = self.at(point)?;
        let on_frame = self.document.frame.iter().any(|one| one == point);
        let has = self
            .document
            .links
            .iter()
            .filter(|link| link.points.iter().any(|one| one == point));
        let links: Vec<String> = has.map(|link| link.name.clone()).collect();
        for link in links.into_iter().skip(usize::from(!on_frame)) {
            let own = self.put(at.into());
            let put = |name: &mut String| {
                if name == point {
                    own.clone_into(name);
                }
            };
            let document = &mut self.document;
            for one in document.links.iter_mut().filter(|one| one.name == link) {
                one.points.iter_mut().for_each(put);
                one.centre_of_mass.iter_mut().for_each(put);
            }
            document.points_under_load(&mut |name, of| {
                if of == link {
                    put(name);
                }
            });
            for slide in &mut document.slides {
                if slide.link == link {
                    put(&mut slide.point);
                }
                if slide.on == link {
                    slide.line.iter_mut().for_each(put);
                }
            }
        }
        Ok(())
    }
}
