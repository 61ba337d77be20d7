//! Instant centres with Kennedy's lines, centrodes, evolutes, inflection circle and circles of curvature.

use assur::centres::{Centre, InstantCentre, Source};
use assur::curvature::{Centrodes, Circles, Curvature, Evolute};
use assur::mechanism::{BodyId, LinkId, LinkOrFrame, Mechanism, PointId};
use assur::motion::Motion;
use assur::{JetPoint, Point, Vector};

use super::layout::{self, Layout};
use super::names::Names;
use super::posed::Posed;
use super::{Figure, View, bounds};
use crate::list::{List, Look, Role};

/// Greatest distance from the middle of the drawing at which lines are drawn, relative to the drawing's size.
const MAX_DISTANCE: f64 = 4.0;
/// Length by which a line extends beyond the centres that define it, in symbol units.
const BEYOND: f64 = 6.0;
/// Maximum number of bodies for which all centres are drawn. With more bodies, only centres relative to the frame are
/// drawn.
const MAX_NAMED: usize = 12;

/// Choice of lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lines {
    /// Whether to draw all instant centres, and the lines that define the centre of `link` relative to `against`.
    pub centres: bool,
    /// Whether to draw the centrodes of `link`.
    pub centrodes: bool,
    /// Whether to draw the inflection circle of `link`, and the circles of curvature and evolutes of traced paths.
    pub curvature: bool,
    /// The link whose instant centre, centrodes and inflection circle are drawn. By default, the first link with two or
    /// more points that is not joined to the frame; if there is none, the last link.
    pub link: Option<LinkId>,
    /// Reference link of the instant centre; by default the frame.
    pub against: LinkOrFrame,
}

/// Lines of a linkage, ready to be drawn in any pose.
#[derive(Clone, Debug)]
pub(super) struct Drawn {
    lines: Lines,
    /// Link whose centre, centrodes and inflection circle are drawn.
    link: Option<LinkId>,
    /// Text index of the centre's name for each pair of bodies; none for a centre without a name. Bodies i < j have the
    /// entry i · `bodies` + j.
    names: Vec<Option<usize>>,
    bodies: usize,
    /// Text indices of the names of the pole and the inflection pole.
    symbols: [usize; 2],
    /// Points whose paths have circles of curvature, with the text index of the circle's centre.
    traced: Vec<(PointId, usize)>,
    middle: Point,
    size: f64,
}

impl Drawn {
    pub(super) fn new(
        mechanism: &Mechanism,
        layout: &Layout,
        view: &View,
        names: &mut Names,
    ) -> Self {
        let lines = view.lines;
        let bodies = mechanism.bodies().len();
        let mut drawn = Self {
            lines,
            link: lines.link.or_else(|| floating(mechanism)),
            names: Vec::new(),
            bodies,
            symbols: [0; 2],
            traced: Vec::new(),
            middle: Point::origin(),
            size: 0.0,
        };
        if lines.centrodes || lines.curvature {
            let pole = [BodyId::FRAME, mechanism.body_of(drawn.link)];
            let pole = centre_name(mechanism, view, pole);
            drawn.symbols = [pole, "J".to_owned()].map(|symbol| names.add(symbol));
        }
        if lines.centres {
            for first in mechanism.bodies() {
                for second in mechanism.bodies() {
                    let named = first < second && (bodies <= MAX_NAMED || first == BodyId::FRAME);
                    let name = |bodies| names.add(centre_name(mechanism, view, bodies));
                    drawn.names.push(named.then_some([first, second]).map(name));
                }
            }
        }
        if lines.curvature {
            let moving = mechanism.point_ids().filter(|point| {
                let asked = layout.is_tracer(*point) || view.traced.contains(point);
                asked && layout.moves(*point)
            });
            let centre = |point| {
                (
                    point,
                    names.add(format!("K_{}", mechanism.point_name(point))),
                )
            };
            drawn.traced = moving.map(centre).collect();
        }
        drawn
    }

    /// Sets the rectangle of the drawing.
    pub(super) fn within(&mut self, base: [f64; 4]) {
        let [left, bottom, right, top] = base;
        self.middle = Point::new(0.5 * (left + right), 0.5 * (bottom + top));
        self.size = bounds::size(base);
    }

    fn is_near(&self, place: Point) -> bool {
        (place - self.middle).norm() < MAX_DISTANCE * self.size
    }

    /// Draws the curves that are fixed to the frame or to the link: evolutes and centrodes.
    pub(super) fn draw_rigid(&self, list: &mut List, motion: &Motion) {
        for (point, _) in &self.traced {
            list.body(layout::number(None));
            for piece in Evolute::of(motion, *point).pieces {
                for near in self.near(&piece, |at| *at) {
                    list.polyline(Role::Accent1, Look::Dashed, near);
                }
            }
        }
        let Some(link) = self.link.filter(|_| self.lines.centrodes) else {
            return;
        };
        for piece in Centrodes::of(motion, link).pieces {
            for near in self.near(&piece, |rolling| rolling.fixed) {
                let fixed: Vec<Point> = near.iter().map(|rolling| rolling.fixed).collect();
                let moving = near.iter().map(|rolling| Point::from(rolling.moving));
                let moving: Vec<Point> = moving.collect();
                list.body(layout::number(None));
                list.polyline(Role::Accent3, Look::Line, &fixed);
                list.body(layout::number(Some(link)));
                list.polyline(Role::Accent4, Look::Line, &moving);
            }
        }
    }

    /// Returns the parts of a curve near the drawing.
    fn near<'a, T>(
        &self,
        curve: &'a [T],
        place: impl Fn(&T) -> Point + Copy,
    ) -> impl Iterator<Item = &'a [T]> {
        let is_near = move |one: &T| self.is_near(place(one));
        let parts = curve.chunk_by(move |a, b| is_near(a) == is_near(b));
        parts.filter(move |part| part.len() > 1 && is_near(&part[0]))
    }

    /// Draws the lines that change with the pose. Circles of curvature need a pose with three derivatives. If the pose
    /// has no derivatives, as at a dead point, only instant centres that follow from positions are drawn.
    pub(super) fn draw<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>, unit: f64) {
        if self.lines.centres {
            self.centres(list, posed, unit);
        }
        if N >= 4 && self.lines.curvature {
            self.circles(list, posed, unit);
        }
        let Some(link) = self.link.filter(|_| self.lines.centrodes) else {
            return;
        };
        let about = [BodyId::FRAME, posed.mechanism.body_of(Some(link))];
        let centres = all(posed);
        let pole = centres.iter().find(|centre| centre.bodies == about);
        if let Some(Centre::At(pole)) = pole.map(|pole| pole.centre) {
            self.mark(list, pole, self.symbols[0], unit);
        }
    }

    /// Marks a point with its name, if it is near the drawing.
    fn mark(&self, list: &mut List, at: Point, name: usize, unit: f64) {
        if self.is_near(at) {
            list.circle(Role::Ink, Look::Solid, at, 0.7 * unit);
            list.name(Role::Ink, name, at, [1.1, 1.0]);
        }
    }

    fn centres<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>, unit: f64) {
        let centres = all(posed);
        let of = |[a, b]: [BodyId; 2]| {
            let bodies = [a.min(b), a.max(b)];
            let found = centres.iter().find(|centre| centre.bodies == bodies);
            found.map(|found| found.centre)
        };
        let asked = self.link.and_then(|link| {
            let about = [Some(link), self.lines.against];
            let [a, b] = about.map(|link| posed.mechanism.body_of(link));
            let about = [a.min(b), a.max(b)];
            centres.iter().find(|centre| centre.bodies == about)
        });
        if let Some(InstantCentre {
            bodies: [i, j],
            centre,
            source: Source::Kennedy(by),
        }) = asked
        {
            for k in by {
                let through = [of([*i, *k]), of([*k, *j]), Some(*centre)];
                self.line(list, through.into_iter().flatten(), unit);
            }
        }
        for centre in &centres {
            let [first, second] = centre.bodies;
            let name = self.names[first.index() * self.bodies + second.index()];
            if let (Centre::At(at), Some(name)) = (centre.centre, name)
                && self.is_near(at)
            {
                let is_asked = asked.is_some_and(|asked| asked.bodies == centre.bodies);
                let (role, look) = if is_asked {
                    (Role::Velocity, Look::Solid)
                } else {
                    (Role::Ink, Look::Hollow)
                };
                list.circle(role, look, at, 0.8 * unit);
                list.name(role, name, at, [1.3, 0.9]);
            }
        }
    }

    /// Draws the line through instant centres. It ends a little beyond them, or far away if a centre is at infinity.
    fn line(&self, list: &mut List, through: impl Iterator<Item = Centre>, unit: f64) {
        let mut places = Vec::new();
        let mut way = None;
        for centre in through {
            match centre {
                Centre::At(place) => places.push(place),
                Centre::Infinity(direction) => way = Some(direction),
                Centre::Anywhere => {}
            }
        }
        let Some(base) = places.first().copied() else {
            return;
        };
        let farthest = places.iter().map(|place| place - base);
        let farthest = farthest.max_by(|a, b| a.norm().total_cmp(&b.norm()));
        let Some(along) = way.or(farthest).and_then(|way| way.try_normalize(0.0)) else {
            return;
        };
        let reach = MAX_DISTANCE * self.size;
        let at = |place: &Point| (place - base).dot(&along).clamp(-reach, reach);
        let ends = places.iter().map(at);
        let [low, high] = ends.fold([0.0_f64; 2], |[low, high], at| [low.min(at), high.max(at)]);
        let on = if way.is_some() { reach } else { BEYOND * unit };
        let line = [base + along * (low - on), base + along * (high + on)];
        list.polyline(Role::Velocity, Look::Thin, &line);
    }

    fn circles<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>, unit: f64) {
        let Posed { mechanism, pose } = posed;
        let [pole_name, inflection_pole] = self.symbols;
        let circles = self
            .link
            .and_then(|link| Circles::of(mechanism, pose, mechanism.body_of(Some(link))));
        if let Some(circles) = circles {
            let (centre, radius) = circles.inflection();
            if self.is_near(circles.pole)
                && radius < MAX_DISTANCE * self.size
                && radius > 0.1 * unit
            {
                list.circle(Role::Accent2, Look::Thin, centre, radius);
                self.mark(list, circles.pole, pole_name, unit);
                self.mark(list, circles.pole + circles.diameter, inflection_pole, unit);
            }
        }
        for (point, name) in &self.traced {
            let place: JetPoint<N> = mechanism.place(pose, *point);
            let Some(bend) = Curvature::of(&place, self.size) else {
                continue;
            };
            let radius = bend.curvature.recip().abs();
            if let Some(centre) = bend.centre
                && radius < MAX_DISTANCE * self.size
            {
                list.circle(Role::Accent1, Look::Thin, centre, radius);
                list.polyline(Role::Accent1, Look::Thin, &[centre, bend.at]);
                self.mark(list, centre, *name, unit);
            } else {
                // A circle of very large or infinite radius is drawn as its tangent.
                let along: Vector = bend.tangent * (MAX_DISTANCE * self.size);
                list.polyline(
                    Role::Accent1,
                    Look::Thin,
                    &[bend.at - along, bend.at + along],
                );
            }
        }
    }
}

impl Figure {
    /// Returns the points whose circles of curvature are drawn.
    pub fn curved(&self) -> Vec<PointId> {
        self.lines.traced.iter().map(|(point, _)| *point).collect()
    }

    /// Returns the link whose inflection circle is drawn.
    pub fn inflected(&self) -> Option<LinkId> {
        let Drawn { link, lines, .. } = self.lines;
        link.filter(|_| lines.curvature)
    }
}

/// Returns all instant centres of a pose; without derivatives, those that follow from positions alone.
fn all<const N: usize>(Posed { mechanism, pose }: Posed<'_, N>) -> Vec<InstantCentre> {
    if N >= 2 {
        mechanism.instant_centres(pose)
    } else {
        mechanism.kennedy(pose)
    }
}

/// Finds a coupler: the first link with two or more points that is not joined to the frame. If there is none, finds the
/// last link.
fn floating(mechanism: &Mechanism) -> Option<LinkId> {
    let joined: Vec<BodyId> = mechanism
        .joints()
        .iter()
        .filter(|joint| joint.bodies().contains(&BodyId::FRAME))
        .flat_map(|joint| joint.bodies().to_vec())
        .collect();
    let links = mechanism.link_ids();
    let mut own = links.filter(|link| mechanism.root_of(*link) == Some(*link));
    let coupler = own.clone().find(|link| {
        let body = mechanism.body_of(Some(*link));
        !joined.contains(&body) && mechanism.points_of(*link).len() > 1
    });
    coupler.or_else(|| own.next_back())
}

/// Returns the name of the centre of two bodies, formed from their numbers.
fn centre_name(mechanism: &Mechanism, view: &View, bodies: [BodyId; 2]) -> String {
    let [a, b] = bodies.map(|body| body_number(mechanism, view, body));
    let comma = if a.len() + b.len() > 2 { "," } else { "" };
    low(&format!("P{a}{comma}{b}"))
}

/// Returns the number of a body in the drawing.
fn body_number(mechanism: &Mechanism, view: &View, body: BodyId) -> String {
    let name = mechanism.body_name(body);
    let mut noted = view.annotations.numbers.iter();
    let noted = noted.find(|(link, _)| link == name);
    noted.map_or_else(|| body.index().to_string(), |(_, number)| number.clone())
}

/// Replaces the digits of a text by subscripts.
fn low(text: &str) -> String {
    let digit = |c: char| {
        let low = c
            .to_digit(10)
            .and_then(|digit| char::from_u32(0x2080 + digit));
        low.unwrap_or(c)
    };
    text.chars().map(digit).collect()
}
