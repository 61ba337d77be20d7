//! Saved form of the poses through which a linkage is to guide a body.

use assur::synthesis::four_bar::{Criterion, Requirements};
use assur::synthesis::poses::{
    Dyad, Linkage, LinkageError, Place, Pose, Solutions, Task, TaskError, Wanted,
};
use assur::{Point, Vector};
use serde::{Deserialize, Serialize};

use super::Kind;
use super::numbers::{self, NumberField};
use crate::problem::Problems;
use crate::{Field, LengthUnit, LinkageDocument, Problem};

/// Poses of a body, and the choice among the linkages that guide the body through them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
#[serde(deny_unknown_fields)]
pub struct PosesDocument {
    /// Unit of lengths; if absent, only proportions count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// Two to five poses, in their order.
    pub poses: Vec<PoseDocument>,
    /// Corners of the drawn body, in its own coordinates; by default a triangle that points along its x-axis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub body: Vec<[f64; 2]>,
    /// At most two wanted hinges, one for each dyad. Four poses leave a curve for them, on which the nearest point is
    /// taken; five poses leave no choice of hinges. Without them, hinges at two corners of the body for up to three
    /// poses, and points all along the curve for four.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<_>"))]
    pub hinges: Vec<HingeDocument>,
    /// Opposite corners of the rectangle in which all hinges on the frame must be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<[[f64; 2]; 2]>,
    /// Number of the pair of dyads that is shown, from 1; if absent, the pair of the wanted hinges or the best one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solution: Option<usize>,
}

/// A pose of the body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct PoseDocument {
    /// Coordinates of the body's origin.
    pub x: f64,
    /// See `x`.
    pub y: f64,
    /// Direction of the body's x-axis.
    pub angle_deg: f64,
}

/// A wanted hinge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum HingeDocument {
    /// On the frame.
    Frame([f64; 2]),
    /// On the body, in its own coordinates.
    Body([f64; 2]),
}

/// A problem of poses; serialised like [`Problem`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum PosesProblem {
    /// No pair of dyads guides the body through the poses.
    NoGuidance,
    /// The pair of dyads leaves the body free to move while the input stands still.
    LooseGuidance,
}

/// Maximum absolute value of a coordinate; see [`TaskError`].
const FARTHEST: f64 = 1e9;

/// Limits of the number of corners of a body.
const CORNERS: [f64; 2] = [3.0, 24.0];

/// Maximum number of wanted hinges: each dyad has one.
const MAX_HINGES: usize = 2;

/// Maximum number of poses that leave a choice of hinges.
const MOST_CHOSEN: usize = 4;

/// Corners of the usual body, as multiples of its size.
const BODY: [[f64; 2]; 3] = [[-0.5, -0.4], [1.0, 0.0], [-0.5, 0.4]];

/// Size of the usual body, as a part of the greatest distance between poses.
const SIZE: f64 = 0.2;

/// Distance, as a part of the task's size, below which a wanted hinge and the hinge of a dyad count as the same. A
/// hinge is saved with all its digits, but the nearest point of a curve is found to about half of them.
const SAME: f64 = 1e-6;

/// The dyads and linkages for the poses of a document.
#[derive(Clone, Debug)]
pub struct Guidance {
    /// The task.
    pub task: Task,
    /// Corners of the body, in its own coordinates.
    pub body: Vec<Point>,
    /// The dyads and their pairs, which are numbered in this order.
    pub solutions: Solutions,
    /// Indices of the pairs, the best first.
    pub order: Vec<usize>,
    /// Index of the pair that is shown; none if there is no pair.
    pub number: Option<usize>,
}

impl PosesDocument {
    /// The task, the dyads and the pair that is shown. It is not an error if there is no pair.
    ///
    /// # Errors
    /// Every problem of the document.
    pub fn guidance(&self) -> Result<Guidance, Vec<Problem>> {
        let poses = self.poses.iter().map(|pose| Pose {
            x: pose.x,
            y: pose.y,
            angle: pose.angle_deg.to_radians(),
        });
        let poses: Vec<Pose> = poses.collect();
        let mut problems = self.problems();
        let task = match Task::new(&poses) {
            Ok(task) if problems.0.is_empty() => task,
            made => {
                for fault in made.err().into_iter().flatten() {
                    problems.add(self.problem(fault));
                }
                return Err(problems.0);
            }
        };
        let body: Vec<Point> = if self.body.is_empty() {
            let size = size(&task);
            BODY.map(|[x, y]| Point::new(x, y) * size).to_vec()
        } else {
            self.body.iter().copied().map(Point::from).collect()
        };
        let solutions = Solutions::new(&task, &self.wanted(&task, &body));
        let mut found = Guidance {
            task,
            body,
            solutions,
            order: Vec::new(),
            number: None,
        };
        found.order = found.ranked();
        found.number = self.chosen(&found);
        Ok(found)
    }

    fn problems(&self) -> Problems {
        let mut problems = Problems::default();
        let most = [-FARTHEST, FARTHEST];
        problems.range("hinges", self.hinges.len() as f64, [0.0, MAX_HINGES as f64]);
        if !self.body.is_empty() {
            problems.range("body", self.body.len() as f64, CORNERS);
        }
        let hinges = self.hinges.iter().map(|hinge| match hinge {
            HingeDocument::Frame(at) | HingeDocument::Body(at) => *at,
        });
        for (k, [x, y]) in hinges.enumerate() {
            problems.range(format!("hinges[{k}].x"), x, most);
            problems.range(format!("hinges[{k}].y"), y, most);
        }
        for (k, [x, y]) in self.body.iter().enumerate() {
            problems.range(format!("body[{k}].x"), *x, most);
            problems.range(format!("body[{k}].y"), *y, most);
        }
        for (k, [x, y]) in self.region.iter().flatten().enumerate() {
            problems.range(format!("region[{k}].x"), *x, most);
            problems.range(format!("region[{k}].y"), *y, most);
        }
        problems
    }

    fn problem(&self, fault: TaskError) -> Problem {
        let number = |k: usize, name: &str, value: f64| {
            let field = Field::from(format!("poses[{k}].{name}"));
            match value.is_finite() {
                true => Problem::OutOfRange {
                    field,
                    value,
                    min: -FARTHEST,
                    max: FARTHEST,
                },
                false => Problem::NotANumber { field },
            }
        };
        match fault {
            TaskError::TooFew { count } | TaskError::TooMany { count } => Problem::OutOfRange {
                field: "poses".into(),
                value: count as f64,
                min: 2.0,
                max: Task::MAX_POSES as f64,
            },
            TaskError::X(k) => number(k, "x", self.poses[k].x),
            TaskError::Y(k) => number(k, "y", self.poses[k].y),
            TaskError::Angle(k) => number(k, "angle_deg", self.poses[k].angle_deg),
        }
    }

    fn wanted(&self, task: &Task, body: &[Point]) -> Wanted {
        let region = self.region.map(|corners| corners.map(Point::from));
        let mut wanted = Wanted {
            pivot_region: region,
            ..Wanted::default()
        };
        let poses = task.distinct().len();
        if poses > MOST_CHOSEN {
            return wanted;
        }
        for hinge in &self.hinges {
            match *hinge {
                HingeDocument::Frame(at) => wanted.pivots.push(at.into()),
                HingeDocument::Body(at) => wanted.points.push(on_body(task, at.into())),
            }
        }
        if poses < MOST_CHOSEN {
            let corners = [body.first(), body.last()].into_iter().flatten();
            let missing = MAX_HINGES - self.hinges.len();
            let corners = corners.take(missing);
            wanted.points.extend(corners.map(|at| on_body(task, *at)));
        }
        wanted
    }

    /// Index of the pair that is shown.
    fn chosen(&self, found: &Guidance) -> Option<usize> {
        let pairs = &found.solutions.linkages;
        if let Some(number) = self.solution {
            // After a change of poses there may be fewer pairs. The last one is then shown.
            return Some(number.clamp(1, pairs.len().max(1)) - 1).filter(|k| *k < pairs.len());
        }
        // The dyads of wanted hinges come last, and so does their pair.
        let wanted = self.hinges.len() == MAX_HINGES
            && found.task.distinct().len() <= MOST_CHOSEN
            && found.solutions.dyads.len() >= MAX_HINGES;
        if wanted {
            return pairs.len().checked_sub(1);
        }
        found.order.first().copied()
    }
}

/// The place in the first pose of a point of the body.
fn on_body(task: &Task, at: Point) -> Point {
    let first = task.poses()[0];
    let (sin, cos) = first.angle.sin_cos();
    first.place() + Vector::new(cos * at.x - sin * at.y, sin * at.x + cos * at.y)
}

/// Size of the usual body: 1, 2 or 5 times a power of ten, so that the size rarely changes while a pose is dragged.
fn size(task: &Task) -> f64 {
    let poses = task.poses();
    let apart = poses.iter().flat_map(|one| {
        let others = poses.iter();
        others.map(|other| (other.place() - one.place()).norm())
    });
    let apart = SIZE * apart.fold(0.0, f64::max);
    if apart < f64::MIN_POSITIVE.sqrt() {
        return 1.0;
    }
    let power = 10.0_f64.powf(apart.log10().floor());
    let part = [5.0, 2.0].into_iter().find(|part| apart >= part * power);
    part.unwrap_or(1.0) * power
}

impl Guidance {
    /// Indices of the pairs, the best first: those that pass through all poses without a break and in order, then by
    /// the least transmission angle.
    fn ranked(&self) -> Vec<usize> {
        let mut ranked = self.solutions.clone();
        ranked.rank(&self.task, &self.requirements(), Criterion::Transmission);
        let pairs = &self.solutions.linkages;
        let place = |pair: &Linkage| pairs.iter().position(|one| one.dyads == pair.dyads);
        ranked.linkages.iter().filter_map(place).collect()
    }

    /// The requirements that a pair without defects meets.
    pub fn requirements(&self) -> Requirements {
        Requirements {
            continuous: true,
            in_order: true,
            ..Requirements::default()
        }
    }

    /// The pair that is shown.
    pub fn shown(&self) -> Option<&Linkage> {
        self.solutions.linkages.get(self.number?)
    }

    /// The place of a point of the body, in its own coordinates, in a pose.
    pub fn placed(&self, at: Point, pose: usize) -> Point {
        self.task.carried(on_body(&self.task, at), pose)
    }

    /// The point of the body that is at a place in the first pose, in its own coordinates.
    pub fn own(&self, place: Point) -> Point {
        let first = self.task.poses()[0];
        let (sin, cos) = first.angle.sin_cos();
        let off = place - first.place();
        Point::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x)
    }

    /// The place in the first pose of the point of the body that is at a place in the last pose.
    pub fn first(&self, place: Point) -> Point {
        let poses = self.task.poses();
        let last = poses[poses.len() - 1];
        let off = place - last.place();
        let (sin, cos) = last.angle.sin_cos();
        let own = Point::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x);
        on_body(&self.task, own)
    }

    /// Whether a dyad has a wanted hinge.
    pub fn is_at(&self, dyad: &Dyad, hinge: &HingeDocument) -> bool {
        let (place, at) = match *hinge {
            HingeDocument::Frame(at) => (dyad.centre(), Point::from(at)),
            HingeDocument::Body(at) => (dyad.point(), on_body(&self.task, at.into())),
        };
        match place {
            Place::Finite(place) => (place - at).norm() <= SAME * size(&self.task) / SIZE,
            Place::Infinite(_) => false,
        }
    }

    /// The shown pair as a linkage of the simulator, drawn in the first pose.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let shown = self.shown().ok_or(PosesProblem::NoGuidance);
        let shown = shown.map_err(|problem| vec![problem.into()])?;
        match &shown.verdict {
            Ok(_) => {}
            Err(LinkageError::Lengths(faults)) => {
                return Err(faults.iter().copied().map(Problem::from).collect());
            }
            Err(LinkageError::Parallel) => return Err(vec![PosesProblem::LooseGuidance.into()]),
        }
        let spec = shown.spec(&self.task, 0);
        let mut document = LinkageDocument::new(&spec);
        let names = spec.points.iter().map(|point| &point.name);
        let traced = names.filter(|name| ["B", "C", "P"].contains(&name.as_str()));
        document.traces = traced.cloned().collect();
        Ok(document)
    }
}

impl Kind for PosesDocument {
    fn unit(&self) -> LengthUnit {
        self.unit.unwrap_or(LengthUnit::None)
    }

    fn chooses_unit(&self) -> bool {
        true
    }

    fn linkage(&self) -> Result<LinkageDocument, Vec<Problem>> {
        let mut document = self.guidance()?.linkage()?;
        document.unit = self.unit;
        Ok(document)
    }

    fn numbers(&self) -> Result<Vec<NumberField>, Vec<Problem>> {
        Ok(numbers::written(self, &numbers::POSES))
    }
}
