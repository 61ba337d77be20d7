//! Constraint equations of a mechanism: the conditions that its links and pairs impose on its points. They have the
//! form used in papers, so that a reader can check a pose; the engine solves for other unknowns, group by group.

use std::f64::consts::TAU;

use crate::Jet;
use crate::index::{BodyId, LinkId, PointId};
use crate::mechanism::plan::body::Gear;
use crate::mechanism::plan::resolved;
use crate::mechanism::plan::slide::Slide;
use crate::mechanism::{Layout, Mechanism, Pose};
use crate::position::{conjugate, product};

/// A link; None for the frame.
pub type LinkOrFrame = Option<LinkId>;

/// Constraint equation: a constant expression on the left, and the value of the constant on the right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Expression that stays constant.
    pub kind: ConstraintKind,
    /// Value of the constant, in the square of the unit of length or in radians.
    pub constant: f64,
}

/// An expression that stays constant while a mechanism moves. A subscript PQ is a difference, `x_PQ = x_P − x_Q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConstraintKind {
    /// `x_PQ² + y_PQ² = l²`: a link keeps the distance l of two of its points, P and Q.
    Distance {
        /// The link.
        link: LinkId,
        /// Points P and Q.
        points: [PointId; 2],
    },
    /// `x_QP y_SP − y_QP x_SP = h·|PQ|`: a sliding point S keeps its distance h from the line PQ, positive to the left.
    Offset {
        /// The link that slides.
        link: LinkOrFrame,
        /// Point S.
        point: PointId,
        /// Points P and Q.
        line: [PointId; 2],
    },
    /// `θ − θ₀ = α`: a sliding link at the angle θ keeps its angle α to the link with the line, which is at the angle
    /// θ₀.
    Direction {
        /// The link that slides.
        link: LinkOrFrame,
        /// The link with the line.
        on: LinkOrFrame,
    },
    /// `z₁(θ₁ − θ₀) + z₂(θ₂ − θ₀) = α`: wheels in mesh, at the angles θ₁ and θ₂, with the carrier at the angle θ₀.
    Mesh {
        /// The wheels.
        links: [LinkOrFrame; 2],
        /// Link to which both wheels are hinged.
        carrier: LinkOrFrame,
        /// Numbers of teeth z₁ and z₂. z₂ is negative if, seen from the carrier, both wheels turn in the same sense.
        teeth: [f64; 2],
    },
}

/// Values of both sides of a constraint equation, or of one of its derivatives, in a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// Left side in the pose. Each point enters with one position, even if several links share the point.
    pub left: f64,
    /// Required value of the left side.
    pub right: f64,
}

impl Sides {
    /// Left side less right side.
    pub fn residual(&self) -> f64 {
        self.left - self.right
    }
}

impl Layout {
    /// Equations in the order of links, slides and gears.
    fn constraints(&self) -> Vec<Constraint> {
        let links = self.made_for.iter().flatten();
        let links = links.flat_map(|link| self.distances(*link));
        let slides = self.bodies.slides.iter();
        let slides = slides.flat_map(|slide| self.guided(slide));
        let gears = self.bodies.gears.iter();
        let gears = gears.map(|gear| self.mesh(gear));
        links.chain(slides).chain(gears).collect()
    }

    /// Distances between the joints of a link that has a body of its own. The distance of the first two joints, and two
    /// distances for each further joint, make the link rigid without redundancy.
    fn distances(&self, link: LinkId) -> Vec<Constraint> {
        let body = self.links[link].body;
        let points = self.bodies.of(body).iter();
        let points = points.filter(|(point, _)| self.is_joint(body, *point));
        let points: Vec<_> = points.collect();
        let mut found = Vec::new();
        for (k, (point, place)) in points.iter().enumerate() {
            for (other, base) in &points[..k.min(2)] {
                found.push(Constraint {
                    kind: ConstraintKind::Distance {
                        link,
                        points: [*other, *point],
                    },
                    constant: (place - base).norm_squared(),
                });
            }
        }
        found
    }

    /// True if a point of a body is hinged to another body, slides, or defines a line.
    fn is_joint(&self, body: BodyId, point: PointId) -> bool {
        let having = self.bodies.ids();
        let having = having.filter(|other| self.bodies.local(*other, point).is_some());
        let slides = |slide: &Slide| {
            let ([on, moving], by_link) = (slide.bodies, slide.by_link);
            moving == body && by_link.point == point || on == body && by_link.line.contains(&point)
        };
        having.count() > 1 || self.bodies.slides.iter().any(slides)
    }

    /// Equations of a slide: the distance of its point from the line, and the direction of the sliding link.
    fn guided(&self, slide: &Slide) -> [Constraint; 2] {
        let [base, moving] = slide.bodies;
        let resolved::Slide {
            link,
            point,
            on,
            line,
        } = slide.by_link;
        let (_, heading) = slide.line_on(base);
        let (through, direction) = slide.line_on(moving);
        let off = product(slide.point() - through, conjugate(direction)).y;
        let turn = product(heading, conjugate(direction));
        let angle_offset = self.angle_offset(link) - self.angle_offset(on);
        [
            Constraint {
                kind: ConstraintKind::Offset { link, point, line },
                constant: off * slide.line_length(),
            },
            Constraint {
                kind: ConstraintKind::Direction { link, on },
                constant: turn.y.atan2(turn.x) + angle_offset,
            },
        ]
    }

    fn mesh(&self, gear: &Gear) -> Constraint {
        let resolved::Gear { links, carrier, .. } = gear.by_link;
        let angle =
            |link: LinkOrFrame| self.mounted[self.body_of(link)].angle + self.angle_offset(link);
        let teeth = gear.signed_teeth();
        let [a, b] = links.map(|link| angle(link) - angle(carrier));
        Constraint {
            kind: ConstraintKind::Mesh {
                links,
                carrier,
                teeth,
            },
            constant: teeth[0] * a + teeth[1] * b,
        }
    }
}

impl Mechanism {
    /// Constraint equations: distances that keep each link rigid, two equations for each slide, and one for each pair
    /// of wheels. With hinges alone, there are as many equations as coordinates of moving joints, less the mobility.
    pub fn constraints(&self) -> Vec<Constraint> {
        self.layout.constraints()
    }

    /// Both sides of an equation in a pose (`order` 0), or of the equation's derivative of `order` 1 to `N` − 1 with
    /// respect to the input. Derivatives of squared distances are halved, as in papers: `x x′ + y y′ = 0`,
    /// `x x″ + y y″ = −(x′² + y′²)`.
    pub fn sides<const N: usize>(
        &self,
        pose: &Pose<N>,
        constraint: &Constraint,
        order: usize,
    ) -> Sides {
        let between = |p: PointId, q: PointId| {
            let [p, q] = [p, q].map(|point| pose.state.place(self.layout.points[point]));
            let way = p - q;
            [way.x(), way.y()]
        };
        let angle =
            |link: LinkOrFrame| link.map_or(Jet::constant(0.0), |link| self.angle(pose, link));
        let turns = |left: Jet<N>| {
            let off = (left.value() - constraint.constant) / TAU;
            left + -TAU * off.round()
        };
        let left = match constraint.kind {
            ConstraintKind::Distance { points: [p, q], .. } if order > 0 => {
                return differentiated(between(p, q), order);
            }
            ConstraintKind::Distance { points: [p, q], .. } => {
                let [x, y] = between(p, q);
                x.square() + y.square()
            }
            ConstraintKind::Offset { point, line, .. } => {
                let [along, to] = [line[1], point].map(|point| between(point, line[0]));
                along[0] * to[1] - along[1] * to[0]
            }
            ConstraintKind::Direction { link, on } => turns(angle(link) - angle(on)),
            ConstraintKind::Mesh {
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

/// Derivative of half the square of a vector of constant length, by Leibniz's rule. The term with the highest
/// derivative is the left side; the other terms are on the right.
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
