//! Checks of single fields of a linkage before the mechanism is built, and limits on the number of parts.

use assur::mechanism::Defect;

use super::spec::driver;
use super::{LinkageDocument, LinkageProblem};
use crate::problem::is_plain;

/// Maximum number of points in a list. The next four constants limit the other lists of a document.
const MAX_POINTS: usize = 200;
const MAX_LINKS: usize = 64;
const MAX_PAIRS: usize = 64;
const MAX_DRIVERS: usize = 8;
const MAX_SHOWN: usize = 32;
/// Maximum number of characters in a name.
const MAX_NAME: usize = 40;
/// Maximum number of characters in a title or source.
const MAX_TEXT: usize = 400;

/// All problems of single fields, with the paths of the fields. If lists are too long, only these lists are reported.
pub(super) fn problems(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let found = counts(document);
    if found.is_empty() {
        [
            names(document),
            links(document),
            shown(document),
            locks(document),
        ]
        .concat()
    } else {
        found
    }
}

fn counts(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let lists = [
        ("points".to_owned(), document.points.len(), MAX_POINTS),
        ("frame".to_owned(), document.frame.len(), MAX_POINTS),
        ("tracers".to_owned(), document.tracers.len(), MAX_POINTS),
        ("links".to_owned(), document.links.len(), MAX_LINKS),
        ("slides".to_owned(), document.slides.len(), MAX_PAIRS),
        ("gears".to_owned(), document.gears.len(), MAX_PAIRS),
        ("drivers".to_owned(), document.drivers.len(), MAX_DRIVERS),
        ("loads".to_owned(), document.loads.len(), MAX_PAIRS),
        ("springs".to_owned(), document.springs.len(), MAX_PAIRS),
        ("dampers".to_owned(), document.dampers.len(), MAX_PAIRS),
        ("friction".to_owned(), document.friction.len(), MAX_PAIRS),
        ("plots".to_owned(), document.plots.len(), MAX_SHOWN),
        ("traces".to_owned(), document.traces.len(), MAX_SHOWN),
        ("locks".to_owned(), document.locks.len(), MAX_PAIRS),
    ];
    let of_links = document.links.iter().enumerate();
    let of_links = of_links.map(|(k, link)| {
        let most = link
            .points
            .len()
            .max(link.shape.as_ref().map_or(0, Vec::len));
        (format!("links[{k}].points"), most, MAX_POINTS)
    });
    let all = lists.into_iter().chain(of_links);
    all.filter(|(_, count, most)| count > most)
        .map(|(path, _, max)| LinkageProblem::TooMany { path, max })
        .collect()
}

fn names(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let points = document.points.iter().enumerate();
    let points = points.map(|(k, point)| (format!("points[{k}].name"), &point.name));
    let links = document.links.iter().enumerate();
    let links = links.map(|(k, link)| (format!("links[{k}].name"), &link.name));
    let tracers = document.tracers.iter().enumerate();
    let tracers = tracers.map(|(k, tracer)| (format!("tracers[{k}].name"), &tracer.name));
    let names = points
        .chain(links)
        .chain(tracers)
        .filter(|(_, name)| name.is_empty() || !is_plain(name, MAX_NAME));
    let texts = [("title", &document.title), ("source", &document.source)];
    let texts = texts.into_iter().filter_map(|(path, text)| {
        let unsound = !is_plain(text.as_ref()?, MAX_TEXT);
        unsound.then(|| LinkageProblem::BadText {
            path: path.to_owned(),
            max: MAX_TEXT,
        })
    });
    names
        .map(|(path, _)| LinkageProblem::BadName {
            path,
            max: MAX_NAME,
        })
        .chain(texts)
        .collect()
}

fn links(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let mut found = Vec::new();
    for (k, link) in document.links.iter().enumerate() {
        let path = format!("links[{k}].length");
        if link.length.is_some() && (link.points.len() != 2 || link.shape.is_some()) {
            found.push(LinkageProblem::LengthOfTwo { path });
        } else if let Some(value) = link.length
            && !(value > 0.0 && value.is_finite())
        {
            found.push(LinkageProblem::BadLength { path, value });
        }
        if link.fixed_to.is_some() && (link.length.is_some() || link.shape.is_some()) {
            let path = format!("links[{k}].fixed_to");
            found.push(LinkageProblem::FixedAsDrawn { path });
        }
    }
    if let Some(value) = document.band
        && !(value > 0.0 && value.is_finite())
    {
        let path = "band".to_owned();
        found.push(LinkageProblem::BadBand { path, value });
    }
    for (k, one) in document.drivers.iter().enumerate() {
        if driver(one).is_none() {
            let path = format!("drivers[{k}]");
            found.push(LinkageProblem::BadDriver { path });
        }
    }
    found
}

/// The problems of plots and traces whose quantity or point does not exist.
fn shown(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let points = document.points.iter().map(|point| &point.name);
    let points = points.chain(document.tracers.iter().map(|tracer| &tracer.name));
    let is_point = |name: &str| points.clone().any(|point| point == name);
    let is_link = |name: &str| document.links.iter().any(|link| link.name == name);
    let plotted = |name: &String| match name.rsplit_once('.') {
        Some((link, "angle")) => is_link(link),
        Some((point, "x" | "y")) => is_point(point),
        _ => false,
    };
    let plots = document.plots.iter().enumerate();
    let plots = plots.filter(|(_, name)| !plotted(name));
    let traces = document.traces.iter().enumerate();
    let traces = traces.filter(|(_, name)| !is_point(name));
    plots
        .map(|(k, _)| LinkageProblem::NothingToPlot {
            path: format!("plots[{k}]"),
        })
        .chain(traces.map(|(k, _)| LinkageProblem::NothingToTrace {
            path: format!("traces[{k}]"),
        }))
        .collect()
}

/// The problems of locks that do not name two or three distinct points.
fn locks(document: &LinkageDocument) -> Vec<LinkageProblem> {
    let is_point = |name: &String| document.points.iter().any(|point| point.name == *name);
    let mut found = Vec::new();
    for (k, lock) in document.locks.iter().enumerate() {
        let once = (1..lock.len()).all(|k| !lock[..k].contains(&lock[k]));
        if !(2..=3).contains(&lock.len()) || !once {
            let path = format!("locks[{k}]");
            found.push(LinkageProblem::BadLock { path });
        } else if let Some(name) = lock.iter().find(|name| !is_point(name)) {
            let name = name.clone();
            found.push(Defect::UnknownName { name }.into());
        }
    }
    found
}
