//! Assur groups added as a whole: the five dyads and a triad.

use assur::{Point, Vector, nearest, perpendicular};
use assur_file::LinkageProblem;

use crate::draw::Drawing;
use crate::edit::{End, Inner, Line, Outer};

/// Distance of the inner joint of a new RRR dyad from the line through its ends, relative to the distance between the
/// ends. Also the length of the inner line of a new RPP dyad, relative to the drawing's size, if its hinge lies on the
/// outer line.
const OFF: f64 = 0.6;
/// Length of a new line, relative to the distance from its start to the point that slides on it.
const BEYOND: f64 = 1.4;
/// Distance of each corner of a new triad's plate from the plate's centre, relative to the distance from the centre to
/// the far end of the bar hinged at this corner.
const PLATE: f64 = 0.4;
/// Angle, radians, through which a new plate is rotated so that no bar points at its centre.
const TURNED: f64 = 0.5;

type Done = Result<(), LinkageProblem>;

/// Adds a dyad, two links with three pairs. Its outer pairs and its inner pair determine the type: RRR,
/// RRP, RPR, PRP or RPP.
pub(crate) fn dyad(drawing: &mut Drawing, outer: &[Outer; 2], inner: Inner) -> Done {
    match (outer, inner) {
        ([Outer::Hinge(from), Outer::Hinge(to)], Inner::Hinge) => {
            let ends = [drawing.end(from)?, drawing.end(to)?];
            let [a, b] = [drawing.at(&ends[0])?, drawing.at(&ends[1])?];
            let apex = drawing.put(beside(a, b).into());
            let [from, to] = ends;
            drawing.bar(&[from, apex.clone()])?;
            drawing.bar(&[apex, to])?;
        }
        ([Outer::Hinge(from), Outer::Hinge(to)], Inner::Slide) => {
            let ends = [drawing.end(from)?, drawing.end(to)?];
            let [a, b] = [drawing.at(&ends[0])?, drawing.at(&ends[1])?];
            let tip = drawing.put((b + (a - b) * BEYOND).into());
            let [from, to] = ends;
            let rod = drawing.bar(&[to, tip])?;
            drawing.block(&from, &Line::Link(rod))?;
        }
        ([Outer::Hinge(end), slide] | [slide, Outer::Hinge(end)], Inner::Hinge) => {
            let from = drawing.end(end)?;
            let guide = Guide::of(drawing, slide)?;
            let pin = drawing.put(guide.at.into());
            drawing.bar(&[from, pin.clone()])?;
            drawing.block(&pin, &guide.along)?;
        }
        ([Outer::Hinge(end), slide] | [slide, Outer::Hinge(end)], Inner::Slide) => {
            let from = drawing.end(end)?;
            let guide = Guide::of(drawing, slide)?;
            let at = drawing.at(&from)?;
            let base = guide.at + guide.direction * (at - guide.at).dot(&guide.direction);
            let across = perpendicular(guide.direction);
            let off = (at - base).dot(&across);
            let off = if off.abs() > 1e-6 * drawing.size() {
                off * BEYOND
            } else {
                OFF * drawing.size()
            };
            let line = [
                drawing.put(base.into()),
                drawing.put((base + across * off).into()),
            ];
            let yoke = drawing.bar(&line)?;
            let [base, _] = line;
            let along = guide.along_from(drawing, &base)?;
            drawing.slide(&yoke, &base, &along)?;
            drawing.block(&from, &Line::Link(yoke))?;
        }
        ([first, second], Inner::Hinge) => {
            let guides = [Guide::of(drawing, first)?, Guide::of(drawing, second)?];
            let pin = drawing.put(crossing(&guides).into());
            for guide in guides {
                let along = guide.along_from(drawing, &pin)?;
                drawing.block(&pin, &along)?;
            }
        }
        (_, Inner::Slide) => return Err(LinkageProblem::NoSuchDyad),
    }
    Ok(())
}

/// Adds a triad: a plate with three corners, each joined by a bar to one of the ends.
pub(crate) fn triad(drawing: &mut Drawing, ends: &[End; 3]) -> Done {
    let mut points = Vec::new();
    for end in ends {
        points.push(drawing.end(end)?);
    }
    let mut places = Vec::new();
    for point in &points {
        places.push(drawing.at(point)?.coords);
    }
    let middle: Vector = places.iter().sum::<Vector>() / places.len() as f64;
    let (sin, cos) = TURNED.sin_cos();
    let corners: Vec<String> = places
        .iter()
        .map(|place| {
            let off = (place - middle) * PLATE;
            let turned = Vector::new(cos * off.x - sin * off.y, sin * off.x + cos * off.y);
            drawing.put((middle + turned).into())
        })
        .collect();
    for (point, corner) in points.iter().zip(&corners) {
        drawing.bar(&[point.clone(), corner.clone()])?;
    }
    drawing.add_link(&corners, None);
    Ok(())
}

/// The line along which a new slide moves: the slide's place on the line, and the line's direction.
struct Guide {
    along: Line,
    at: Point,
    direction: Vector,
}

impl Guide {
    fn of(drawing: &Drawing, slide: &Outer) -> Result<Self, LinkageProblem> {
        match slide {
            Outer::Slide(link, at) => {
                let at = Point::from(*at);
                let [from, to] = drawing.side(link, at)?;
                let [from, to] = [drawing.at(&from)?, drawing.at(&to)?];
                let direction = to - from;
                if direction.norm() == 0.0 {
                    let link = link.clone();
                    return Err(LinkageProblem::NoLine { link });
                }
                Ok(Self {
                    along: Line::Link(link.clone()),
                    at: nearest(at, from, to),
                    direction: direction.normalize(),
                })
            }
            Outer::Level(at) => {
                let at = Point::from(*at);
                Ok(Self {
                    along: Line::Toward((at + Vector::x() * (0.3 * drawing.size())).into()),
                    at,
                    direction: Vector::x(),
                })
            }
            Outer::Hinge(_) => Err(LinkageProblem::NoSuchDyad),
        }
    }

    /// The guide's line for a slide of the point `point`. A line of the frame is shifted to pass through this point.
    fn along_from(&self, drawing: &Drawing, point: &str) -> Result<Line, LinkageProblem> {
        Ok(match &self.along {
            Line::Toward(_) => {
                let along = self.direction * (0.3 * drawing.size());
                Line::Toward((drawing.at(point)? + along).into())
            }
            line => line.clone(),
        })
    }
}

/// A point beside the middle of the segment between two points, on its upper side.
fn beside(a: Point, b: Point) -> Point {
    let along = b - a;
    let across = perpendicular(along);
    let up = if across.y < 0.0 { -across } else { across };
    a + along / 2.0 + up * OFF
}

/// The intersection of two guides, or the place of the second slide if the guides are parallel.
fn crossing([first, second]: &[Guide; 2]) -> Point {
    let turned = first.direction.perp(&second.direction);
    if turned.abs() < 1e-3 {
        return second.at;
    }
    let way = (second.at - first.at).perp(&second.direction) / turned;
    first.at + first.direction * way
}
