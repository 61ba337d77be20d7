//! Numbers of the links; the frame is 0.

use assur::Point;
use assur::mechanism::{LinkId, LinkOrFrame};
use assur::sorting::sort_by;

use super::View;
use super::layout::{self, Layout};
use super::names::Names;
use super::posed::Posed;
use crate::list::{List, Look, Role};
use crate::parts;

/// Radius of the circle around a number, in symbol units.
const CIRCLE: f64 = 1.9;
/// Position of the number on a bar, as a share of the bar's length.
const MIDDLE: f64 = 0.5;
/// Position of the number on a driving bar, as a share of its length, if there is room beyond the arc of the input.
const BEYOND_ARC: f64 = 0.75;
/// Least distance of the number from the end of a driving bar, in symbol units.
const ROOM: f64 = 3.2;
/// Offset of a number from the pin beside which it stands, in text heights.
const BESIDE: [f64; 2] = [1.5, -1.5];
/// Anchor of a number beside a support, measured from the pivot, in symbol units for a support of size 1.
const AT_SUPPORT: [f64; 2] = [2.3, -2.6];
/// Offset of a number from its anchor beside a support, in text heights.
const BESIDE_SUPPORT: [f64; 2] = [0.8, 0.0];

#[derive(Clone, Debug)]
pub(super) struct Number {
    link: LinkOrFrame,
    /// Position of the number in the link's coordinates.
    at: Place,
    name: usize,
}

#[derive(Clone, Copy, Debug)]
enum Place {
    /// On the link, in a circle.
    On(Point),
    /// On the driver, in a circle between these points, beyond the arc of the input angle if the bar is long enough.
    Driving([Point; 2]),
    /// Beside the pin of a block or wheel.
    Beside(Point),
    /// Beside the support of a fixed pivot: the pivot and the size of the support, in symbol units.
    Support(Point, f64),
}

/// Returns the numbers of the moving bodies, as annotated or else in document order, and 0 at each support. Wheels with
/// a number beside the rim are left out.
pub(super) fn numbers(
    home: Posed<'_, 1>,
    layout: &Layout,
    view: &View,
    names: &mut Names,
) -> Vec<Number> {
    let mechanism = home.mechanism;
    let notes = &view.annotations;
    let bodies = mechanism
        .link_ids()
        .filter(|link| mechanism.root_of(*link) == Some(*link));
    let mut numbers = Vec::new();
    for (index, link) in bodies.enumerate() {
        let own = mechanism.link_name(link);
        if notes.tags.iter().any(|tag| tag.link == own) {
            continue;
        }
        let noted = notes.numbers.iter().find(|(name, _)| name == own);
        let text = noted.map_or_else(|| (index + 1).to_string(), |(_, number)| number.clone());
        let Some(at) = place(home, layout, link) else {
            continue;
        };
        let (link, name) = (Some(link), names.add(text));
        numbers.push(Number { link, at, name });
    }
    let supports = mechanism.point_ids().filter_map(|point| {
        let at = home.place(point);
        Some(Place::Support(at, layout.support(point)?))
    });
    let name = names.add("0".to_owned());
    numbers.extend(supports.map(|at| Number {
        link: None,
        at,
        name,
    }));
    numbers
}

/// Returns the position of a link's number: the middle of a plate, or of the longest part of a bar between two points.
fn place(home: Posed<'_, 1>, layout: &Layout, link: LinkId) -> Option<Place> {
    let mechanism = home.mechanism;
    let outline = layout.outline(link);
    let [from, to] = outline else {
        let middle = parts::centroid(outline).map(Place::On);
        return middle.or(outline.first().copied().map(Place::Beside));
    };
    let along = (to - from).normalize();
    let points = mechanism.points_of(link).iter();
    let places = points.map(|point| home.local(Some(link), *point));
    let mut ways: Vec<f64> = places.map(|at| (at - from).dot(&along)).collect();
    sort_by(&mut ways, f64::total_cmp);
    let parts = ways.windows(2).map(|part| [part[0], part[1]]);
    let [start, end] = parts.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let drivers = &mechanism.spec().drivers;
    let mut driven = drivers
        .iter()
        .filter_map(|driver| mechanism.spec().driven(driver));
    let drives = driven.any(|name| name == mechanism.link_name(link));
    let ends = [start, end].map(|way| from + along * way);
    let on = Place::On(ends[0] + (ends[1] - ends[0]) * MIDDLE);
    Some(if drives { Place::Driving(ends) } else { on })
}

impl Number {
    pub(super) fn draw(&self, list: &mut List, u: f64) {
        list.body(layout::number(self.link));
        let mut circled = |at: Point| {
            list.circle(Role::Secondary, Look::Hollow, at, CIRCLE * u);
            (at, [0.0, 0.0])
        };
        let (at, off) = match self.at {
            Place::On(at) => circled(at),
            Place::Driving([from, to]) => {
                let room = (1.0 - BEYOND_ARC) * (to - from).norm() > ROOM * u;
                let share = if room { BEYOND_ARC } else { MIDDLE };
                circled(from + (to - from) * share)
            }
            Place::Beside(at) => (at, BESIDE),
            Place::Support(at, size) => {
                let [x, y] = AT_SUPPORT.map(|by| by * size * u);
                (at + assur::Vector::new(x, y), BESIDE_SUPPORT)
            }
        };
        list.name(Role::Ink, self.name, at, off);
    }
}
