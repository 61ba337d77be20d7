//! Names of links and points in saved forces, for edits that rename or remove them.

use std::collections::{BTreeMap, BTreeSet};

use assur::linkage::FRAME;

use super::{AnchorDocument, FrictionDocument};
use crate::kinds::linkage::LinkageDocument;

impl LinkageDocument {
    /// Calls a function with every name of a link in the loads, springs, dampers and friction.
    pub fn links_under_load(&mut self, put: &mut impl FnMut(&mut String)) {
        for load in &mut self.loads {
            put(&mut load.link);
        }
        for spring in &mut self.springs {
            spring.links.iter_mut().flatten().for_each(&mut *put);
        }
        for damper in &mut self.dampers {
            damper.links.iter_mut().flatten().for_each(&mut *put);
        }
        for friction in &mut self.friction {
            friction.slide.iter_mut().for_each(&mut *put);
        }
        for end in self.ends() {
            put(&mut end.link);
        }
    }

    /// Calls a function with every name of a point in the loads, springs and dampers, and with that of its link.
    pub fn points_under_load(&mut self, put: &mut impl FnMut(&mut String, &str)) {
        for load in &mut self.loads {
            if let Some(point) = &mut load.point {
                put(point, &load.link);
            }
        }
        for end in self.ends() {
            put(&mut end.point, &end.link);
        }
    }

    /// Calls a function with every name of a point whose hinges have friction.
    pub fn hinges_with_friction(&mut self, put: &mut impl FnMut(&mut String)) {
        for friction in &mut self.friction {
            friction.hinge.iter_mut().for_each(&mut *put);
        }
    }

    fn ends(&mut self) -> impl Iterator<Item = &mut AnchorDocument> {
        let springs = self.springs.iter_mut();
        let springs = springs.filter_map(|spring| spring.ends.as_mut());
        let dampers = self.dampers.iter_mut();
        let dampers = dampers.filter_map(|damper| damper.ends.as_mut());
        springs.chain(dampers).flatten()
    }

    /// Removes friction at points that are no hinges, and of links that do not slide.
    pub fn remove_idle_friction(&mut self) {
        // Links that are fixed to each other are one body, called by the one to which all are fixed.
        let bodies: BTreeMap<&str, &str> = (self.links.iter())
            .map(|link| (link.name.as_str(), self.body_called(&link.name)))
            .collect();
        let body = |name: &str| bodies.get(name).copied();
        let is_hinge = |point: &String| {
            let links = self.links.iter().filter(|link| link.points.contains(point));
            let on: BTreeSet<Option<&str>> = links.map(|link| body(&link.name)).collect();
            on.len() + usize::from(self.frame.contains(point)) > 1
        };
        let slides = |name: &String| {
            let own = body(name);
            own.is_some() && self.slides.iter().any(|slide| body(&slide.link) == own)
        };
        let fits = |friction: &FrictionDocument| {
            friction.hinge.iter().all(is_hinge) && friction.slide.iter().all(slides)
        };
        let kept: Vec<FrictionDocument> = self
            .friction
            .iter()
            .filter(|one| fits(one))
            .cloned()
            .collect();
        self.friction = kept;
    }

    /// The link to which a link is fixed, directly or through others.
    fn body_called<'a>(&'a self, name: &'a str) -> &'a str {
        let mut at = name;
        for _ in &self.links {
            let of = self.links.iter().find(|link| link.name == at);
            match of.and_then(|link| link.fixed_to.as_deref()) {
                Some(to) => at = to,
                None => break,
            }
        }
        at
    }

    /// Removes loads, springs and dampers on links or points that are gone.
    pub fn remove_under_load(&mut self, link: impl Fn(&str) -> bool, point: impl Fn(&str) -> bool) {
        let is_held = |end: &AnchorDocument| !gone(&link, &end.link) && !point(&end.point);
        let ends = |ends: &Option<[AnchorDocument; 2]>| ends.iter().flatten().all(is_held);
        let links =
            |links: &Option<[String; 2]>| links.iter().flatten().all(|name| !gone(&link, name));
        self.loads.retain(|load| {
            !gone(&link, &load.link) && !load.point.as_ref().is_some_and(|name| point(name))
        });
        self.springs
            .retain(|spring| ends(&spring.ends) && links(&spring.links));
        self.dampers
            .retain(|damper| ends(&damper.ends) && links(&damper.links));
    }
}

/// True if a link that is not the frame is gone.
fn gone(link: &impl Fn(&str) -> bool, name: &str) -> bool {
    name != FRAME && link(name)
}
