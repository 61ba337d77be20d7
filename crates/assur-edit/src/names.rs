//! Names of points and links: free names, and renaming.

use assur::mechanism::{Defect, FRAME};
use assur_file::{LinkageDocument, LinkageProblem};

/// Maximum number of characters in a link's name that is composed of the names of its points.
const MAX_COMPOSED: usize = 24;

/// A free name for a point: A to Z, then A1 to Z1 and so on.
pub(crate) fn new_point(document: &LinkageDocument) -> String {
    const LETTERS: usize = 26;
    let name = |k: usize| {
        let letter = char::from(b'A' + (k % LETTERS) as u8);
        match k / LETTERS {
            0 => letter.to_string(),
            round => format!("{letter}{round}"),
        }
    };
    numbered(0, |name| !is_point(document, name), name)
}

/// A free name for a traced point, as on the page: P1, P2, …
pub(crate) fn new_tracer(document: &LinkageDocument) -> String {
    numbered(1, |name| !is_point(document, name), |k| format!("P{k}"))
}

/// Whether a point or a traced point has the name.
pub(crate) fn is_point(document: &LinkageDocument, name: &str) -> bool {
    document.points.iter().any(|point| point.name == name)
        || document.tracers.iter().any(|tracer| tracer.name == name)
}

/// Whether a link, or the frame, has the name.
pub(crate) fn is_link(document: &LinkageDocument, name: &str) -> bool {
    name == FRAME || document.links.iter().any(|link| link.name == name)
}

/// A free name for a link: `wish`, or else the names of its points together, as in textbooks. A number
/// is added if the name is taken.
pub(crate) fn new_link(
    document: &LinkageDocument,
    points: &[String],
    wish: Option<&str>,
) -> String {
    let name = wish.map_or_else(|| of_points(points), str::to_owned);
    if !is_link(document, &name) {
        return name;
    }
    numbered(
        2,
        |name| !is_link(document, name),
        |k| format!("{name} {k}"),
    )
}

/// A free name for a point: the given name or, if it is taken, a new one.
pub(crate) fn free_point(document: &LinkageDocument, name: &str) -> String {
    if !is_point(document, name) {
        return name.to_owned();
    }
    new_point(document)
}

fn of_points(points: &[String]) -> String {
    let name = points.concat();
    if name.chars().count() <= MAX_COMPOSED {
        name
    } else {
        points.iter().take(2).cloned().collect::<String>() + "…"
    }
}

/// The first name of a numbered sequence that is free.
fn numbered(first: usize, free: impl Fn(&str) -> bool, name: impl Fn(usize) -> String) -> String {
    let mut number = first;
    loop {
        let name = name(number);
        if free(&name) {
            return name;
        }
        number += 1;
    }
}

/// The links named after their points, such as AB.
pub(crate) fn called_by_points(document: &LinkageDocument) -> Vec<String> {
    let links = document.links.iter();
    let called = links.filter(|link| link.points.len() > 1 && link.name == of_points(&link.points));
    called.map(|link| link.name.clone()).collect()
}

/// Renames the links in `before`, which were named after their points, if their points have changed.
pub(crate) fn call_by_points(document: &mut LinkageDocument, before: &[String]) {
    for old in before {
        let link = document.links.iter().find(|link| link.name == *old);
        let Some(points) = link.map(|link| link.points.clone()) else {
            continue;
        };
        if points.len() > 1 && of_points(&points) != *old {
            let new = new_link(document, &points, None);
            rename_link(document, old, &new);
        }
    }
}

/// Renames a link wherever its name occurs.
pub(crate) fn rename_link(document: &mut LinkageDocument, from: &str, to: &str) {
    let put = |name: &mut String| {
        if name == from {
            to.clone_into(name);
        }
    };
    for link in &mut document.links {
        put(&mut link.name);
        link.fixed_to.iter_mut().for_each(put);
    }
    for slide in &mut document.slides {
        put(&mut slide.link);
        put(&mut slide.on);
    }
    for gear in &mut document.gears {
        gear.links.iter_mut().for_each(put);
        put(&mut gear.carrier);
    }
    for driver in &mut document.drivers {
        driver.crank.iter_mut().for_each(put);
        driver.base.iter_mut().for_each(put);
    }
    document
        .tracers
        .iter_mut()
        .for_each(|tracer| put(&mut tracer.link));
    document.links_under_load(&mut { put });
    rename_plots(document, from, to, &["angle"]);
}

/// Renames a point or a traced point wherever its name occurs.
pub(crate) fn rename_point(document: &mut LinkageDocument, from: &str, to: &str) {
    let put = |name: &mut String| {
        if name == from {
            to.clone_into(name);
        }
    };
    document
        .points
        .iter_mut()
        .for_each(|point| put(&mut point.name));
    document
        .tracers
        .iter_mut()
        .for_each(|tracer| put(&mut tracer.name));
    document.frame.iter_mut().for_each(put);
    for link in &mut document.links {
        link.points.iter_mut().for_each(put);
        link.centre_of_mass.iter_mut().for_each(put);
    }
    for slide in &mut document.slides {
        put(&mut slide.point);
        slide.line.iter_mut().for_each(put);
    }
    document.traces.iter_mut().for_each(put);
    document.locks.iter_mut().flatten().for_each(put);
    document.points_under_load(&mut |point, _| put(point));
    document.hinges_with_friction(&mut { put });
    rename_plots(document, from, to, &["x", "y"]);
}

fn rename_plots(document: &mut LinkageDocument, from: &str, to: &str, quantities: &[&str]) {
    for plot in &mut document.plots {
        if let Some((name, quantity)) = plot.rsplit_once('.')
            && name == from
            && quantities.contains(&quantity)
        {
            *plot = format!("{to}.{quantity}");
        }
    }
}

/// Renames a point, a traced point or a link.
///
/// # Errors
/// An unknown name; a name that is taken.
pub(crate) fn rename(
    document: &mut LinkageDocument,
    name: &str,
    to: &str,
) -> Result<(), LinkageProblem> {
    let to = to.trim();
    if name == to {
        return Ok(());
    }
    let taken = || Defect::Twice {
        name: to.to_owned(),
    };
    if is_point(document, name) {
        if is_point(document, to) {
            return Err(taken().into());
        }
        let before = called_by_points(document);
        rename_point(document, name, to);
        call_by_points(document, &before);
        Ok(())
    } else if name != FRAME && is_link(document, name) {
        if is_link(document, to) {
            return Err(taken().into());
        }
        rename_link(document, name, to);
        Ok(())
    } else {
        let name = name.to_owned();
        Err(Defect::UnknownName { name }.into())
    }
}
