//! The constraint equations of a mechanism: what its links and pairs demand of the
//! places of its points. The engine solves them group by group and in other
//! unknowns; here they stand as a paper writes them, so that a reader can check
//! every pose against them.

use std::f64::consts::TAU;

use super::body::{Bodies, Seat, body_of};
use super::draft::{Draft, DraftSlide, FRAME};
use super::{Mechanism, Pose};
use crate::Jet;
use crate::gears::Mesh;
use crate::position::{Stand, conjugate, product};

/// A link, by index, or the frame: none.
pub type LinkOrFrame = Option<usize>;

/// One constraint equation: what is demanded, and the constant on its right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// What stays constant; points and links by index.
    pub demand: Demand,
    /// The constant: in the square of the unit of lengths, or radians.
    pub constant: f64,
}

/// What stays constant while a mechanism moves. A subscript PQ is a difference,
/// `x_PQ = x_P − x_Q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// `x_PQ² + y_PQ² = l²`: a link keeps two of its points apart.
    Distance {
        /// The link.
        link: usize,
        /// P and Q.
        points: [usize; 2],
    },
    /// `x_QP y_SP − y_QP x_SP = h·PQ`: S keeps its distance h to the left of the
    /// line PQ.
    Offset {
        /// The link that slides.
        link: LinkOrFrame,
        /// S.
        point: usize,
        /// P and Q.
        line: [usize; 2],
    },
    /// `θ − θ₀ = α`: a link that slides keeps its angle against what has the line.
    Direction {
        /// The link that slides.
        link: LinkOrFrame,
        /// The link that has the line.
        on: LinkOrFrame,
    },
    /// `z₁(θ₁ − θ₀) + z₂(θ₂ − θ₀) = α`: wheels in mesh, seen from their carrier.
    Mesh {
        /// The wheels.
        links: [LinkOrFrame; 2],
        /// The link both are hinged on.
        carrier: LinkOrFrame,
        /// Numbers of teeth; z₂ below zero where the sense is kept.
        teeth: [f64; 2],
    },
}

/// Both sides of a constraint equation, or of a derivative of it, in a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// From the places of the points, each taken once.
    pub left: f64,
    /// What it must be.
    pub right: f64,
}

impl Sides {
    /// By how much the left side misses the right one.
    pub fn residual(&self) -> f64 {
        self.left - self.right
    }
}

/// The equations of sound bodies, in the order of links, slides and gears. `stands`
/// says how the bodies stand in the drawn pose: wheels are mounted there.
pub(super) fn all(
    draft: &Draft,
    bodies: &Bodies,
    seats: &[Seat],
    stands: &[Stand],
) -> Vec<Constraint> {
    let index = |name: &String| draft.points.iter().position(|point| point.name == *name);
    let link_of = |name: &String| draft.links.iter().position(|link| link.name == *name);
    let on_slides = |body: usize, point: usize| {
        let gives = |slide: &DraftSlide| {
            let line = slide.line.each_ref().map(index);
            body_of(draft, seats, &slide.link) == body && index(&slide.point) == Some(point)
                || body_of(draft, seats, &slide.on) == body && line.contains(&Some(point))
        };
        draft.slides.iter().any(gives)
    };
    let mut joined = vec![0; draft.points.len()];
    for (point, _) in (0..bodies.count()).flat_map(|body| bodies.of(body)) {
        joined[*point] += 1;
    }
    let mut found = Vec::new();
    for (link, (drawn, seat)) in draft.links.iter().zip(seats).enumerate() {
        if drawn.fixed_to.is_some() {
            continue;
        }
        let points = bodies.of(seat.body).iter();
        let points: Vec<_> = points
            .filter(|(point, _)| joined[*point] > 1 || on_slides(seat.body, *point))
            .collect();
        // Two for each point more than the first two: rigid, and none too many.
        for (k, (point, place)) in points.iter().enumerate() {
            for (other, base) in &points[..k.min(2)] {
                found.push(Constraint {
                    demand: Demand::Distance {
                        link,
                        points: [*other, *point],
                    },
                    constant: (place - base).norm_squared(),
                });
            }
        }
    }
    for (drawn, slide) in draft.slides.iter().zip(&bodies.slides) {
        let [on, moving] = slide.bodies;
        let [link, base] = [&drawn.link, &drawn.on].map(link_of);
        let ends = drawn.line.each_ref().map(index);
        let ([Some(p), Some(q)], Some(point)) = (ends, index(&drawn.point)) else {
            continue;
        };
        let on_line = [p, q].map(|end| bodies.local(on, end));
        let ([Some(from), Some(to)], Some(place)) = (on_line, bodies.local(moving, point)) else {
            continue;
        };
        let (_, heading) = slide.line_on(on);
        let (through, direction) = slide.line_on(moving);
        let off = product(place - through, conjugate(direction)).y;
        found.push(Constraint {
            demand: Demand::Offset {
                link,
                point,
                line: [p, q],
            },
            constant: off * (to - from).norm(),
        });
        let turn = product(heading, conjugate(direction));
        let lead = |link: LinkOrFrame| link.map_or(0.0, |link| seats[link].lead);
        found.push(Constraint {
            demand: Demand::Direction { link, on: base },
            constant: turn.y.atan2(turn.x) + lead(link) - lead(base),
        });
    }
    for gear in &draft.gears {
        let links = gear.links.each_ref().map(link_of);
        let carrier = Some(&gear.carrier)
            .filter(|name| *name != FRAME)
            .and_then(link_of);
        let angle = |link: LinkOrFrame| {
            link.map_or(0.0, |link| {
                stands[seats[link].body].angle + seats[link].lead
            })
        };
        let sense = if gear.mesh == Mesh::External {
            1.0
        } else {
            -1.0
        };
        let teeth = [gear.teeth[0], sense * gear.teeth[1]];
        let [a, b] = links.map(|link| angle(link) - angle(carrier));
        found.push(Constraint {
            demand: Demand::Mesh {
                links,
                carrier,
                teeth,
            },
            constant: teeth[0] * a + teeth[1] * b,
        });
    }
    found
}

impl Mechanism {
    /// Its constraint equations: of each link as many distances as keep it rigid,
    /// two equations of each slide, one of each pair of wheels. Where all pairs are
    /// hinges there are as many of them as there are coordinates of moving points,
    /// less the mobility.
    pub fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    /// Both sides of an equation in a pose, or of its derivative of an order below
    /// `N` by the input; the derivatives of half the square of a distance as
    /// papers write them: `x x′ + y y′ = 0`, `x x″ + y y″ = −(x′² + y′²)`.
    pub fn sides<const N: usize>(
        &self,
        pose: &Pose<N>,
        constraint: &Constraint,
        order: usize,
    ) -> Sides {
        let between = |p: usize, q: usize| {
            let [p, q] = [p, q].map(|point| self.place(pose, point));
            [p.x - q.x, p.y - q.y]
        };
        let angle =
            |link: LinkOrFrame| link.map_or(Jet::constant(0.0), |link| self.angle(pose, link));
        let turns = |left: Jet<N>| {
            let off = (left.value() - constraint.constant) / TAU;
            left + -TAU * off.round()
        };
        let left = match constraint.demand {
            Demand::Distance { points: [p, q], .. } if order > 0 => {
                return differentiated(between(p, q), order);
            }
            Demand::Distance { points: [p, q], .. } => {
                let [x, y] = between(p, q);
                x.square() + y.square()
            }
            Demand::Offset { point, line, .. } => {
                let [along, to] = [line[1], point].map(|point| between(point, line[0]));
                along[0] * to[1] - along[1] * to[0]
            }
            Demand::Direction { link, on } => turns(angle(link) - angle(on)),
            Demand::Mesh {
                links,
                carrier,
                teeth,
            } => {
                let [a, b] = links.map(|link| angle(link) - angle(carrier));
                turns(a * teeth[0] + b * teeth[1])
            }
        };
        Sides {
            left: left.derivative(order),
            right: if order == 0 { constraint.constant } else { 0.0 },
        }
    }
}

/// Leibniz's rule for half the square of a way: what has the highest derivatives
/// on the left, the rest on the right.
fn differentiated<const N: usize>(way: [Jet<N>; 2], order: usize) -> Sides {
    let term = |k: usize| -> f64 {
        let terms = way.iter();
        terms
            .map(|x| x.derivative(k) * x.derivative(order - k))
            .sum()
    };
    let mut choices = 1.0;
    let mut rest = 0.0;
    for k in 1..order {
        choices *= (order + 1 - k) as f64 / k as f64;
        rest += 0.5 * choices * term(k);
    }
    Sides {
        left: term(0),
        right: 0.0 - rest,
    }
}
