//! Overlays of a linkage: arrows and arcs, with their names.

use std::f64::consts::TAU;

use assur::mechanism::{
    DriverSpec, LinkId, LinkOrFrame, Mechanism, PointId, Pose, Quantity, RrrDyad,
};
use assur::motion::{Motion, Sampling, Shown, Spacing};
use assur::{JetPoint, Point, Vector};

use super::View;
use super::layout::{self, Layout};
use super::names::Names;
use super::posed::Posed;
use crate::list::{List, Look, Role};
use crate::overlays::{self, Scales};
use crate::parts;

/// Sampling of the motion for the scales of velocity and acceleration vectors.
const SAMPLING: Sampling = Sampling {
    turn: 180,
    coarsest: 30,
    most: 32 * 180,
    spacing: Spacing::Middles,
    shown: Shown::Spread,
};
/// Greatest number of points with vectors at which the tips of the vectors are named.
const MAX_NAMED: usize = 3;

/// Greatest radius of the arc of the input, in symbol units.
const LARGEST: f64 = 10.0;
/// Input angle below which the name of the angle is moved along the arc, out of the angle, radians.
const SMALL: f64 = 0.8;
/// Greatest angle through which the name is moved, for an input angle of zero, radians.
const BELOW: f64 = 0.6;

/// The overlays of a linkage, ready to be drawn in any pose.
#[derive(Clone, Debug)]
pub(super) struct Overlaid {
    input: Option<InputArc>,
    /// For each loop vector, the first and the last point, and the index of the name.
    loop_vectors: Vec<([PointId; 2], usize)>,
    /// For each corner, three points (the second is the vertex), and the index of the name.
    corners: Vec<([PointId; 3], usize)>,
    /// For each transmission angle, outer hinge, inner hinge, other outer hinge, and the index of the name.
    transmission: Vec<([PointId; 3], usize)>,
    /// Measured distances and angles, each with the index of its name.
    measures: Vec<(Quantity, usize)>,
    /// Points with vectors of velocity and acceleration, each with the indices of the names of the two tips, if named.
    vectors: Vec<(PointId, Option<[usize; 2]>)>,
    scales: Option<Scales>,
}

#[derive(Clone, Debug)]
struct InputArc {
    link: LinkId,
    base: LinkOrFrame,
    pivot: PointId,
    radius: f64,
    /// Least input angle of the motion, radians. Negative input angles are drawn clockwise.
    least: f64,
    role: Role,
    name: usize,
}

impl Overlaid {
    pub(super) fn new(
        motion: &Motion,
        layout: &Layout,
        home: Posed<'_, 1>,
        view: &View,
        names: &mut Names,
    ) -> Self {
        let (mechanism, shown) = (motion.mechanism(), view.overlays);
        let dyads = mechanism.rrr_dyads();
        let mut overlaid = Self {
            input: InputArc::new(motion, layout, home, view, names),
            loop_vectors: Vec::new(),
            corners: Vec::new(),
            transmission: Vec::new(),
            measures: Vec::new(),
            vectors: Vec::new(),
            scales: None,
        };
        let measured = |one: &Quantity| {
            let symbol = if one.is_angle() { "θ" } else { "d" };
            (*one, names.add_valued(symbol, &one.name(mechanism, 0)))
        };
        overlaid.measures = view.measures.iter().map(measured).collect();
        if shown.loop_vectors {
            let named = |[from, to]: [PointId; 2]| {
                let symbol = view.symbol(&[from, to].map(|point| names.of(point).to_owned()));
                let name = names.add(symbol);
                ([from, to], name)
            };
            let noted = noted_vectors(mechanism, view);
            let vectors = if noted.is_empty() {
                loop_vectors(mechanism, layout, &dyads)
            } else {
                noted
            };
            overlaid.loop_vectors = vectors.into_iter().map(named).collect();
            let corners = view.annotations.corners.iter();
            overlaid.corners = corners
                .filter_map(|(points, symbol)| {
                    let points = known(mechanism, points)?;
                    Some((points, names.add(symbol.clone())))
                })
                .collect();
        }
        if shown.transmission {
            let named = |dyad: &RrrDyad| {
                let [from, to] = dyad.outer.map(|outer| outer.point);
                let readout = format!("{}.transmission", names.of(dyad.inner));
                ([from, dyad.inner, to], names.add_valued("μ", &readout))
            };
            overlaid.transmission = dyads.iter().map(named).collect();
        }
        if shown.vectors {
            let moving = mechanism.point_ids().filter(|point| {
                let joins = layout.is_joint(*point) || !layout.is_centre(*point);
                let asked = joins || view.traced.contains(point);
                asked && layout.is_drawn(*point) && layout.moves(*point)
            });
            let moving: Vec<PointId> = moving.collect();
            let legible = moving.len() <= MAX_NAMED;
            let tips = |point: PointId| {
                let name = names.of(point).to_owned();
                let tips = ["′", "″"].map(|strokes| names.add(format!("{name}{strokes}")));
                (point, legible.then_some(tips))
            };
            overlaid.vectors = moving.into_iter().map(tips).collect();
        }
        overlaid
    }

    /// Sets the scales of velocity and acceleration vectors for a drawing of this size. Returns the tips that must be
    /// within the drawing.
    pub(super) fn scale(&mut self, motion: &Motion, size: f64) -> Vec<Point> {
        if self.vectors.is_empty() {
            return Vec::new();
        }
        let inputs = motion.samples(SAMPLING).into_iter().flatten();
        let poses = inputs.filter_map(|input| motion.pose::<3>(input).ok());
        let poses: Vec<Pose<3>> = poses.collect();
        let path = |(point, _): &(PointId, _)| -> Vec<JetPoint<3>> {
            let places = poses.iter();
            places
                .map(|pose| motion.mechanism().place(pose, *point))
                .collect()
        };
        let paths: Vec<Vec<JetPoint<3>>> = self.vectors.iter().map(path).collect();
        let scales = Scales::of(&paths, size);
        self.scales = Some(scales);
        scales.tips(&paths.concat(), size)
    }

    /// Draws the arc of the input, loop vectors, angles and measures. Draws vectors of velocity and acceleration if the
    /// pose has two derivatives.
    pub(super) fn draw<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>, unit: f64) {
        if let Some(arc) = &self.input {
            arc.draw(list, posed, unit);
        }
        let place = |point: PointId| posed.place(point);
        for (ends, name) in &self.loop_vectors {
            overlays::loop_vector(list, ends.map(place), *name, unit);
        }
        for (points, name) in &self.corners {
            overlays::side_angle(list, points.map(place), *name, unit);
        }
        for (hinges, name) in &self.transmission {
            overlays::transmission(list, hinges.map(place), *name, unit);
        }
        for (measure, name) in &self.measures {
            match measure {
                Quantity::Distance(ends) => {
                    overlays::distance(list, ends.map(place), *name, unit);
                }
                Quantity::Corner(points) => {
                    overlays::corner(list, points.map(place), *name, unit);
                }
                Quantity::Between(links) => {
                    let angles = links.map(|link| posed.angle(link));
                    let centre = meeting(posed.mechanism, *links).map(place);
                    if let Some(centre) = centre {
                        overlays::between(list, centre, angles, *name, unit);
                    }
                }
                _ => {}
            }
        }
        let Some(scales) = self.scales.filter(|_| N >= 3) else {
            return;
        };
        for (point, names) in &self.vectors {
            let place = posed.mechanism.place(posed.pose, *point);
            overlays::vectors(list, &place, *names, scales, unit);
        }
    }
}

impl InputArc {
    fn new(
        motion: &Motion,
        layout: &Layout,
        home: Posed<'_, 1>,
        view: &View,
        names: &mut Names,
    ) -> Option<Self> {
        let mechanism = motion.mechanism();
        let symbol = view.annotations.input.as_ref()?;
        let Some(DriverSpec::Crank { link, base, .. }) = mechanism.spec().drivers.first() else {
            return None;
        };
        let (link, base) = (mechanism.link(link)?, mechanism.link(base));
        let [body, on] = [Some(link), base].map(|link| layout::body_of(mechanism, link));
        let pivot = layout.hinge(mechanism, body, on)?;
        let arms = mechanism.points_of(link).iter();
        let mut arms = arms.map(|point| (home.place(*point) - home.place(pivot)).norm());
        Some(Self {
            link,
            base,
            pivot,
            radius: 0.5 * arms.find(|arm| *arm > 0.0)?,
            least: motion.cycle().axis()[0],
            role: layout.drawn_role(link),
            name: names.add_valued(symbol, "input"),
        })
    }

    /// Draws the arc as an arrow from the direction of the base link to that of the driven link, with the angle's name.
    fn draw<const N: usize>(&self, list: &mut List, posed: Posed<'_, N>, unit: f64) {
        let from = self.base.map_or(0.0, |base| posed.angle(base));
        let turn = self.least + (posed.angle(self.link) - from - self.least).rem_euclid(TAU);
        let centre = posed.place(self.pivot);
        let along = |angle: f64| Vector::new(angle.cos(), angle.sin());
        let radius = self.radius.min(LARGEST * unit);
        let at = |share: f64| centre + along(from + turn * share) * radius;
        let neck = 1.0 - (parts::HEAD * unit / (turn.abs() * radius)).min(0.5);
        let points: Vec<Point> = (0..=48).map(|i| at(neck * f64::from(i) / 48.0)).collect();
        let base = [centre, centre + along(from) * (1.2 * radius)];
        list.polyline(Role::Secondary, Look::Thin, &base);
        list.polyline(self.role, Look::Thin, &points);
        parts::head(list, self.role, at(neck), at(1.0));
        // The name of a small angle would cover the legs of the angle, so it is moved beyond the first leg.
        let beside = BELOW * (1.0 - turn.abs() / SMALL).max(0.0);
        let middle = along(from + 0.5 * turn - beside.copysign(turn));
        let off = [3.1 * middle.x, 1.1 * middle.y];
        list.name(self.role, self.name, centre + middle * radius, off);
    }
}

/// Returns the vertex of the angle between two links: a shared point, or else the first point of the first link.
fn meeting(mechanism: &Mechanism, links: [LinkId; 2]) -> Option<PointId> {
    let [first, second] = links.map(|link| mechanism.points_of(link));
    let shared = first.iter().find(|point| second.contains(point));
    shared.or(first.first()).copied()
}

/// Returns the first and the last point of each annotated loop vector.
fn noted_vectors(mechanism: &Mechanism, view: &View) -> Vec<[PointId; 2]> {
    let noted = view.annotations.loop_vectors.iter();
    noted
        .filter_map(|(ends, _)| known(mechanism, ends))
        .collect()
}

/// Returns the points with these names; none if the linkage lacks any of them.
fn known<const N: usize>(mechanism: &Mechanism, names: &[String; N]) -> Option<[PointId; N]> {
    let points: Option<Vec<PointId>> = names.iter().map(|name| mechanism.point(name)).collect();
    points?.try_into().ok()
}

/// Returns loop vectors: along every link from joint to joint, along the frame from support to support, and across each
/// dyad between its outer hinges, without duplicates.
fn loop_vectors(mechanism: &Mechanism, layout: &Layout, dyads: &[RrrDyad]) -> Vec<[PointId; 2]> {
    let joints = |link: LinkId| -> Vec<PointId> {
        let points = mechanism.points_of(link).iter().copied();
        points.filter(|point| layout.is_joint(*point)).collect()
    };
    let points = mechanism.point_ids();
    let supports = points.filter(|point| layout.is_support(*point));
    let mut chains: Vec<Vec<PointId>> = mechanism.link_ids().map(joints).collect();
    chains.push(supports.collect());
    chains.extend(
        dyads
            .iter()
            .map(|dyad| dyad.outer.map(|outer| outer.point).to_vec()),
    );
    let mut found: Vec<[PointId; 2]> = Vec::new();
    for ends in chains.iter().flat_map(|chain| chain.windows(2)) {
        let [from, to] = [ends[0], ends[1]];
        if from != to && !found.contains(&[from, to]) && !found.contains(&[to, from]) {
            found.push([from, to]);
        }
    }
    found
}
