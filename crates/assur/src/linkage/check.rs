//! Checks of a specification without the geometry of the whole linkage: everything named exists, numbers are valid, and
//! the links of each pair have its points.

use std::collections::BTreeSet;

use super::spec::{Defect, DriverSpec, FRAME, GearSpec, LinkageSpec, PointSpec, SlideSpec, extent};
use super::tracer;
use crate::gears::{Mesh, TEETH};
use crate::tolerance::{self, FARTHEST};

pub(crate) fn defects(spec: &LinkageSpec) -> Vec<Defect> {
    let mut found = Vec::new();
    names(spec, &mut found);
    numbers(spec, &mut found);
    found.extend(tracer::defects(spec, sound));
    for link in &spec.links {
        points_of(spec, &link.name, &link.points, &mut found);
        shape(link, &mut found);
    }
    points_of(spec, FRAME, &spec.frame, &mut found);
    pairs(spec, &mut found);
    found
}

fn names(spec: &LinkageSpec, found: &mut Vec<Defect>) {
    for (k, point) in spec.points.iter().enumerate() {
        if spec.points[..k]
            .iter()
            .any(|other| other.name == point.name)
        {
            found.push(Defect::Twice {
                name: point.name.clone(),
            });
        }
    }
    for (k, link) in spec.links.iter().enumerate() {
        if link.name == FRAME || spec.links[..k].iter().any(|other| other.name == link.name) {
            found.push(Defect::Twice {
                name: link.name.clone(),
            });
        }
        if link.points.is_empty() {
            found.push(Defect::Bare {
                link: link.name.clone(),
            });
        }
    }
    let named_points = spec
        .links
        .iter()
        .flat_map(|link| link.points.iter().chain(&link.centre_of_mass));
    let named_points = named_points.chain(&spec.frame);
    let named_points = named_points.chain(
        spec.slides
            .iter()
            .flat_map(|s| s.line.iter().chain([&s.point])),
    );
    let named_links = spec.links.iter().filter_map(|link| link.fixed_to.as_ref());
    let named_links = named_links.chain(spec.slides.iter().flat_map(|s| [&s.link, &s.on]));
    let named_links = named_links.chain(
        spec.gears
            .iter()
            .flat_map(|g| g.links.iter().chain([&g.carrier])),
    );
    let named_links = named_links.chain(spec.drivers.iter().flat_map(|driver| match driver {
        DriverSpec::Crank { link, base, .. } => vec![link, base],
        DriverSpec::Slide { .. } => Vec::new(),
    }));
    let named_points = named_points.map(String::as_str);
    let named_links = named_links.map(String::as_str);
    let unknown: BTreeSet<&str> = named_points
        .filter(|name| spec.place(name).is_none())
        .chain(named_links.filter(|name| *name != FRAME && spec.link(name).is_none()))
        .collect();
    found.extend(unknown.into_iter().map(|name| Defect::UnknownName {
        name: name.to_owned(),
    }));
}

/// True if a number is finite and at most [`FARTHEST`] in absolute value.
fn sound(value: f64) -> bool {
    value.is_finite() && value.abs() <= FARTHEST
}

fn numbers(spec: &LinkageSpec, found: &mut Vec<Defect>) {
    for point in &spec.points {
        if !sound(point.at.x) || !sound(point.at.y) {
            found.push(Defect::NotFinite {
                name: point.name.clone(),
            });
        }
    }
    for link in &spec.links {
        let places = link.shape.iter().flatten();
        let [mass, inertia] = [link.mass, link.inertia].map(|given| given.unwrap_or(0.0));
        if ![mass, inertia].into_iter().all(sound)
            || !places.clone().all(|at| sound(at.x) && sound(at.y))
        {
            found.push(Defect::NotFinite {
                name: link.name.clone(),
            });
            continue;
        }
        if mass < 0.0 {
            let link = link.name.clone();
            found.push(Defect::NegativeMass { link, mass });
        } else if inertia < 0.0 || inertia > 0.0 && mass == 0.0 {
            let link = link.name.clone();
            found.push(Defect::ImpossibleInertia { link, inertia });
        }
    }
    for driver in &spec.drivers {
        if let DriverSpec::Slide {
            range: [from, to], ..
        } = driver
            && let Some(link) = spec.driven(driver)
        {
            let link = link.to_owned();
            if !sound(*from) || !sound(*to) {
                found.push(Defect::NotFinite { name: link });
            } else if from == to {
                found.push(Defect::RangeEmpty { link, at: *from });
            } else if from > to {
                found.push(Defect::RangeReversed {
                    link,
                    from: *from,
                    to: *to,
                });
            }
        }
    }
}

/// Checks the points of a link or of the frame: none is listed twice, and the first two of a link do not coincide.
fn points_of(spec: &LinkageSpec, link: &str, points: &[String], found: &mut Vec<Defect>) {
    // The points of a link fixed to another link have their places in the shape of that other link.
    let own = spec.link(spec.root_of(link));
    let own = own.and_then(|own| Some((own, own.shape.as_ref()?)));
    let in_shape = |name: &String| {
        let (own, shape) = own?;
        let index = own.points.iter().position(|point| point == name)?;
        shape.get(index).copied()
    };
    let coincide = |a: &String, b: &String| {
        // The distance of points of a shape is compared with the size of the shape, because the link may be drawn at
        // another scale.
        let (ends, size) = match (in_shape(a), in_shape(b), own) {
            (Some(a), Some(b), Some((_, shape))) => {
                ((Some(a), Some(b)), extent(shape.iter().map(|at| at.coords)))
            }
            _ => ((spec.place(a), spec.place(b)), spec.size()),
        };
        matches!(ends, (Some(a), Some(b)) if (a - b).norm() <= tolerance::COINCIDENT * size)
    };
    for (k, point) in points.iter().enumerate() {
        for other in &points[..k] {
            if point == other {
                let (link, point) = (link.to_owned(), point.clone());
                found.push(Defect::Repeated { link, point });
            } else if link != FRAME && k < 2 && coincide(other, point) {
                let (link, points) = (link.to_owned(), [other.clone(), point.clone()]);
                found.push(Defect::Coincident { link, points });
            }
        }
    }
}

fn shape(link: &crate::mechanism::LinkSpec, found: &mut Vec<Defect>) {
    let places = link.shape.as_ref().map(Vec::len);
    if places.is_some_and(|places| places != link.points.len()) {
        found.push(Defect::Shape {
            link: link.name.clone(),
        });
    }
    if let Some(centre) = &link.centre_of_mass
        && !link.points.contains(centre)
    {
        let (link, point) = (link.name.clone(), centre.clone());
        found.push(Defect::NotOnLink { link, point });
    }
}

/// Checks slides, gears, drivers, and links that are fixed to other links.
fn pairs(spec: &LinkageSpec, found: &mut Vec<Defect>) {
    for link in &spec.links {
        if spec.root_of(&link.name).is_empty() {
            found.push(Defect::WithItself {
                link: link.name.clone(),
            });
        }
    }
    for slide in &spec.slides {
        guided(spec, slide, found);
    }
    for gear in &spec.gears {
        meshing(spec, gear, found);
    }
    for driver in &spec.drivers {
        match driver {
            DriverSpec::Crank { link, base, .. } if spec.root_of(link) == spec.root_of(base) => {
                found.push(Defect::WithItself { link: link.clone() });
            }
            DriverSpec::Crank { link, base, .. } if !hinged(spec, [link, base]) => {
                let links = [link.clone(), base.clone()];
                found.push(Defect::NotHinged { links });
            }
            DriverSpec::Slide { slide, .. } if *slide >= spec.slides.len() => {
                found.push(Defect::NoDriver);
            }
            _ => {}
        }
    }
}

fn guided(spec: &LinkageSpec, slide: &SlideSpec, found: &mut Vec<Defect>) {
    let on_line = slide.line.iter().map(|point| (&slide.on, point));
    for (link, point) in on_line.chain([(&slide.link, &slide.point)]) {
        if !has(spec, link, point) {
            let (link, point) = (link.clone(), point.clone());
            found.push(Defect::NotOnLink { link, point });
        }
    }
    if slide.link == slide.on {
        found.push(Defect::WithItself {
            link: slide.link.clone(),
        });
    }
    if let [Some(a), Some(b)] = slide.line.each_ref().map(|name| spec.place(name))
        && (a - b).norm() <= tolerance::COINCIDENT * spec.size()
    {
        let (link, points) = (slide.on.clone(), slide.line.clone());
        found.push(Defect::Coincident { link, points });
    }
}

fn meshing(spec: &LinkageSpec, gear: &GearSpec, found: &mut Vec<Defect>) {
    for (link, value) in gear.links.iter().zip(gear.teeth) {
        let counts = value.is_finite() && value.fract() == 0.0;
        if !counts || !(TEETH.0..=TEETH.1).contains(&value) {
            let link = link.clone();
            found.push(Defect::Teeth { link, value });
        }
        if *link == gear.carrier {
            found.push(Defect::WithItself { link: link.clone() });
        } else if !hinged(spec, [link, &gear.carrier]) {
            let links = [link.clone(), gear.carrier.clone()];
            found.push(Defect::NotHinged { links });
        }
    }
    if gear.links[0] == gear.links[1] {
        found.push(Defect::WithItself {
            link: gear.links[0].clone(),
        });
    }
    if gear.mesh == Mesh::Internal && gear.teeth[0] == gear.teeth[1] {
        found.push(Defect::Concentric {
            links: gear.links.clone(),
        });
    }
}

impl LinkageSpec {
    /// All defects that can be found without the geometry of the whole linkage.
    pub fn defects(&self) -> Vec<Defect> {
        defects(self)
    }

    /// Name of the link to which a link is ultimately fixed: the link itself, another link, or the frame. Empty if
    /// links are fixed to each other in a ring.
    pub(crate) fn root_of<'a>(&'a self, link: &'a str) -> &'a str {
        let mut root = link;
        for _ in 0..=self.links.len() {
            match self.link(root).and_then(|link| link.fixed_to.as_deref()) {
                Some(base) => root = base,
                None => return root,
            }
        }
        ""
    }
}

/// True if a point belongs to a link, or to a link with the same root.
fn has(spec: &LinkageSpec, link: &str, point: &String) -> bool {
    let root = spec.root_of(link);
    let mut links = spec
        .links
        .iter()
        .filter(|other| spec.root_of(&other.name) == root);
    root == FRAME && spec.frame.contains(point) || links.any(|other| other.points.contains(point))
}

/// True if two links share a point, which hinges them to each other.
fn hinged(spec: &LinkageSpec, links: [&str; 2]) -> bool {
    let shared = |point: &PointSpec| links.iter().all(|link| has(spec, link, &point.name));
    spec.points.iter().any(shared)
}
