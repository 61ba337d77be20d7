//! New positions of points: moved, placed, rotated, reflected.

use std::collections::{BTreeMap, BTreeSet};

use assur::mechanism::FRAME;
use assur::{Point, Vector};
use assur_file::{LinkDocument, LinkageProblem};

use crate::draw::Drawing;

type Done = Result<(), LinkageProblem>;

impl Drawing {
    /// Moves points by a displacement.
    pub(crate) fn shift(&mut self, points: &[String], [x, y]: [f64; 2]) -> Done {
        for point in points {
            self.at(point)?;
        }
        let by = Vector::new(x, y);
        let points = self.with_guides(points);
        let moved = points.into_iter().map(|point| {
            let to = self.at(&point)?.coords + by;
            Ok((point, to))
        });
        let moved = moved.collect::<Result<_, LinkageProblem>>()?;
        self.go(&moved, None);
        Ok(())
    }

    /// Moves a traced point to a place, or another point as near to the place as locks allow.
    pub(crate) fn place(&mut self, point: &str, to: [f64; 2]) -> Done {
        let tracers = &self.document.tracers;
        if let Some(index) = tracers.iter().position(|tracer| tracer.name == point) {
            let at = self.on_link(&tracers[index].link, Point::from(to))?;
            self.document.tracers[index].at = at;
            return Ok(());
        }
        let moved = self.carried(point, to)?;
        self.go(&moved, None);
        Ok(())
    }

    /// The targets of a point, and of the ends of guides that move with it.
    fn carried(
        &self,
        point: &str,
        to: [f64; 2],
    ) -> Result<BTreeMap<String, Vector>, LinkageProblem> {
        let by = Point::from(to) - self.at(point)?;
        let mut moved = BTreeMap::new();
        for other in self.with_guides(&[point.to_owned()]) {
            let at = self.at(&other)?.coords + by;
            moved.insert(other, at);
        }
        moved.insert(point.to_owned(), Vector::from(to));
        Ok(moved)
    }

    /// Moves points to their targets, as far as locks allow; points locked to them follow. A link whose points
    /// do not all have the same displacement takes its dimensions from the drawing. The lock `released` is ignored.
    fn go(&mut self, wanted: &BTreeMap<String, Vector>, released: Option<&[String]>) {
        let (places, reached) = self.held(wanted, released);
        self.is_held |= !reached;
        let way = |point: &String| match (places.get(point), self.at(point)) {
            (Some(to), Ok(at)) => to - at.coords,
            _ => Vector::zeros(),
        };
        let links = self.document.links.iter();
        let reshaped = links.filter(|link| {
            let mut ways = link.points.iter().map(way);
            let first = ways.next();
            ways.any(|way| Some(way) != first)
        });
        let reshaped: BTreeSet<String> = reshaped.map(|link| link.name.clone()).collect();
        self.redraw(|link| reshaped.contains(&link.name));
        for point in &mut self.document.points {
            if let Some(to) = places.get(&point.name) {
                point.at = (*to).into();
            }
        }
    }

    /// Gives a link a length by moving its second point along the link.
    pub(crate) fn stretch(&mut self, link: &str, length: f64) -> Done {
        let [first, second] = self.ends(link)?;
        let [from, to] = [self.at(&first)?, self.at(&second)?];
        let along = (to - from).try_normalize(0.0);
        let points = [first.clone(), second.clone()];
        let along = along.ok_or(LinkageProblem::OnePlace { points })?;
        if !(length > 0.0 && length.is_finite()) {
            let path = format!("{link}.length");
            return Err(LinkageProblem::BadLength {
                path,
                value: length,
            });
        }
        // A lock of this length does not resist the change: it holds the new length from then on.
        let mut moved = self.carried(&second, (from + along * length).into())?;
        moved.insert(first.clone(), from.coords);
        self.go(&moved, Some(&[first, second]));
        Ok(())
    }

    /// Gives a link an angle by rotating it about its first point.
    pub(crate) fn turn(&mut self, link: &str, angle_deg: f64) -> Done {
        let [first, second] = self.ends(link)?;
        let [from, to] = [self.at(&first)?, self.at(&second)?];
        let along = to - from;
        let wanted = angle_deg.to_radians();
        let turned = |angle: f64, off: Vector| {
            let (sin, cos) = angle.sin_cos();
            [
                from.x + cos * off.x - sin * off.y,
                from.y + sin * off.x + cos * off.y,
            ]
        };
        let mut moved = BTreeMap::new();
        for point in self.linked(link)?.points.clone() {
            if point == first {
                // The centre of rotation also has a target, so that it does not follow points locked to it.
                moved.insert(point, from.coords);
                continue;
            }
            let off = self.at(&point)? - from;
            // The second point is placed directly at the angle, without the rounding of a rotation.
            let to = if point == second {
                turned(wanted, Vector::new(along.norm(), 0.0))
            } else {
                turned(wanted - along.y.atan2(along.x), off)
            };
            moved.extend(self.carried(&point, to)?);
        }
        self.go(&moved, None);
        Ok(())
    }

    /// The first two points of a link.
    fn ends(&self, link: &str) -> Result<[String; 2], LinkageProblem> {
        match &self.linked(link)?.points[..] {
            [first, second, ..] => Ok([first.clone(), second.clone()]),
            _ => {
                let link = link.to_owned();
                Err(LinkageProblem::NoLine { link })
            }
        }
    }

    /// Reflects points in the vertical line midway between the leftmost and the rightmost of them.
    pub(crate) fn mirror(&mut self, points: &[String]) -> Done {
        let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
        for point in points {
            let x = self.at(point)?.x;
            ends = [ends[0].min(x), ends[1].max(x)];
        }
        if points.is_empty() {
            return Ok(());
        }
        let points: BTreeSet<String> = points.iter().cloned().collect();
        self.redraw(|link| partly(link, &points));
        let document = &mut self.document;
        for point in &mut document.points {
            if points.contains(&point.name) {
                point.at[0] = ends[0] + ends[1] - point.at[0];
            }
        }
        let whole = |link: &LinkDocument| link.points.iter().all(|point| points.contains(point));
        for link in document.links.iter_mut().filter(|link| whole(link)) {
            let places = link.shape.iter_mut().flatten();
            places.for_each(|[_, y]| *y = -*y);
        }
        for tracer in &mut document.tracers {
            if document
                .links
                .iter()
                .any(|link| link.name == tracer.link && whole(link))
            {
                tracer.at[1] = -tracer.at[1];
            }
        }
        Ok(())
    }

    /// The given points, and the ends of the frame lines along which they slide. An end that belongs to a link is left
    /// out. Both ends of a line are left out if the line of another slide contains one of them.
    fn with_guides(&self, points: &[String]) -> BTreeSet<String> {
        let mut all: BTreeSet<String> = points.iter().cloned().collect();
        let slides = &self.document.slides;
        for slide in slides {
            let own = |end: &String| {
                slides
                    .iter()
                    .filter(|other| other.line.contains(end))
                    .count()
                    == 1
            };
            if slide.on == FRAME && points.contains(&slide.point) && slide.line.iter().all(own) {
                let ends = slide.line.iter().filter(|end| !self.is_hinge(end));
                all.extend(ends.cloned());
            }
        }
        all
    }

    /// Whether a point belongs to any link.
    fn is_hinge(&self, point: &str) -> bool {
        let mut links = self.document.links.iter();
        links.any(|link| link.points.iter().any(|one| one == point))
    }
}

/// Whether some but not all points of a link move.
fn partly(link: &LinkDocument, points: &BTreeSet<String>) -> bool {
    let moved = link
        .points
        .iter()
        .filter(|point| points.contains(*point))
        .count();
    moved > 0 && moved < link.points.len()
}
