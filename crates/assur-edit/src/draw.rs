//! Additions to a drawing: points, links, slides, traced points and centres of mass.

use assur::linkage::COINCIDENT;
use assur::mechanism::{Defect, FRAME};
use assur::{Point, Vector, nearest, perpendicular};
use assur_file::{
    LinkDocument, LinkageDocument, LinkageProblem, PointDocument, SlideDocument, TracerDocument,
};

use crate::edit::{Edit, End, Line};
use crate::{dyads, names};

/// Least size assumed for a drawing. Distances of new parts are proportional to the size.
const MIN_SIZE: f64 = 1e-6;

/// A drawing during an edit.
#[derive(Debug)]
pub(crate) struct Drawing {
    pub(crate) document: LinkageDocument,
    /// The point used or added last.
    pub(crate) point: Option<String>,
    /// The link that was added last.
    pub(crate) link: Option<String>,
    /// Whether locks kept a moved point from reaching its target.
    pub(crate) is_held: bool,
}

type Done = Result<(), LinkageProblem>;

impl Drawing {
    pub(crate) fn new(document: &LinkageDocument) -> Self {
        Self {
            document: document.clone(),
            point: None,
            link: None,
            is_held: false,
        }
    }

    pub(crate) fn apply(&mut self, edit: &Edit) -> Done {
        self.act(edit)?;
        self.document.remove_idle_friction();
        Ok(())
    }

    fn act(&mut self, edit: &Edit) -> Done {
        match edit {
            Edit::Point { at, fixed } => {
                let end = if *fixed {
                    End::Fixed(*at)
                } else {
                    End::At(*at)
                };
                self.end(&end).map(drop)
            }
            Edit::Bar { ends: [from, to] } => {
                let ends = [self.end(from)?, self.end(to)?];
                self.bar(&ends).map(drop)
            }
            Edit::Corner { link, end } => {
                let point = self.end(end)?;
                self.list(link, &point)
            }
            Edit::Block { end, along } => {
                let point = self.end(end)?;
                self.block(&point, along).map(drop)
            }
            Edit::Slide { link, along } => {
                let first = self.linked(link)?.points.first().cloned();
                let unmade = || Defect::Bare { link: link.clone() };
                self.slide(link, &first.ok_or_else(unmade)?, along)
            }
            Edit::Dyad { outer, inner } => dyads::dyad(self, outer, *inner),
            Edit::Triad { ends } => dyads::triad(self, ends),
            Edit::Wheel { end } => {
                let point = self.end(end)?;
                self.add_link(&[point], Some("wheel"));
                Ok(())
            }
            Edit::Mesh {
                links,
                teeth,
                internal,
            } => self.mesh(links, *teeth, *internal),
            Edit::Drive { link } => self.drive(link),
            Edit::Fix { point } => self.fix(point),
            Edit::MakeExact {} => {
                self.make_exact();
                Ok(())
            }
            Edit::Weld { links } => self.weld(links),
            Edit::Join { points } => self.join(points),
            Edit::Part { point } => self.part(point),
            Edit::Trace { link, at } => self.trace(link, *at),
            Edit::Mass { link, at } => self.mass(link, *at),
            Edit::Centre { link, on } => self.centre(link, *on),
            Edit::Uniform {
                link,
                section,
                density,
            } => self.uniform(link, *section, *density),
            Edit::Balance {} => self.balance(),
            Edit::Move { points, by } => self.shift(points, *by),
            Edit::Place { point, at } => self.place(point, *at),
            Edit::Stretch { link, length } => self.stretch(link, *length),
            Edit::Turn { link, angle_deg } => self.turn(link, *angle_deg),
            Edit::Rename { name, to } => names::rename(&mut self.document, name, to),
            Edit::Remove { points, links } => self.remove(points, links),
            Edit::Paste { drawing, by } => {
                self.paste(drawing, *by);
                Ok(())
            }
            Edit::Mirror { points } => self.mirror(points),
            Edit::Lock { points } => self.lock(points),
        }
    }

    /// Moves the points so that redundant constraints that nearly hold in the drawing hold exactly.
    fn make_exact(&mut self) {
        if let Some(exact) = self.document.spec().made_exact() {
            for (point, exact) in self.document.points.iter_mut().zip(exact.spec.points) {
                point.at = exact.at.into();
            }
        }
    }

    pub(crate) fn linked(&self, name: &str) -> Result<&LinkDocument, LinkageProblem> {
        let mut links = self.document.links.iter();
        links
            .find(|link| link.name == name)
            .ok_or_else(|| unknown(name))
    }

    /// Changes the link with this name, if it exists.
    pub(crate) fn change(&mut self, name: &str, change: impl FnOnce(&mut LinkDocument)) {
        let mut links = self.document.links.iter_mut();
        if let Some(link) = links.find(|link| link.name == name) {
            change(link);
        }
    }

    pub(crate) fn at(&self, name: &str) -> Result<Point, LinkageProblem> {
        let mut points = self.document.points.iter();
        let point = points.find(|point| point.name == name);
        let point = point.ok_or_else(|| unknown(name))?;
        Ok(Point::from(point.at))
    }

    /// The diagonal of the rectangle around the drawn points, at least [`MIN_SIZE`]; 1 without points.
    pub(crate) fn size(&self) -> f64 {
        let places = || self.document.points.iter().map(|point| point.at);
        let extent = |axis: usize| {
            let all = || places().map(|at| at[axis]);
            all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
        };
        let size = extent(0).hypot(extent(1));
        if size.is_finite() {
            size.max(MIN_SIZE)
        } else {
            1.0
        }
    }

    /// Adds a point and returns its name.
    pub(crate) fn put(&mut self, at: [f64; 2]) -> String {
        let name = names::new_point(&self.document);
        self.document.points.push(PointDocument {
            name: name.clone(),
            at,
        });
        self.point = Some(name.clone());
        name
    }

    /// The name of the point at an end of a new part. The point is added if necessary.
    pub(crate) fn end(&mut self, end: &End) -> Result<String, LinkageProblem> {
        match end {
            End::Point(name) => {
                self.at(name)?;
                self.point = Some(name.clone());
                Ok(name.clone())
            }
            End::At(at) => Ok(self.put(*at)),
            End::Fixed(at) => {
                let point = self.put(*at);
                self.document.frame.push(point.clone());
                Ok(point)
            }
            End::On(link, at) => {
                self.linked(link)?;
                let point = self.put(*at);
                self.list(link, &point)?;
                Ok(point)
            }
        }
    }

    /// Adds a link between two points. A link to the frame begins at its fixed pivot, where its angle is measured.
    pub(crate) fn bar(&mut self, ends: &[String; 2]) -> Result<String, LinkageProblem> {
        self.apart(ends)?;
        let mut ends = ends.clone();
        if self.ends_at_pivot(&ends) {
            ends.reverse();
        }
        Ok(self.add_link(&ends, None))
    }

    /// Whether the last of two points is fixed to the frame, and the first is not.
    pub(crate) fn ends_at_pivot(&self, [from, to]: &[String; 2]) -> bool {
        let is_fixed = |point| self.document.frame.contains(point);
        is_fixed(to) && !is_fixed(from)
    }

    pub(crate) fn add_link(&mut self, points: &[String], name: Option<&str>) -> String {
        let name = names::new_link(&self.document, points, name);
        self.document.links.push(LinkDocument {
            name: name.clone(),
            points: points.to_vec(),
            ..LinkDocument::default()
        });
        self.link = Some(name.clone());
        name
    }

    /// Checks that two points do not coincide.
    fn apart(&self, ends: &[String; 2]) -> Done {
        let [from, to] = ends;
        let near = (self.at(to)? - self.at(from)?).norm() <= COINCIDENT * self.size();
        let points = ends.clone();
        if from == to || near {
            Err(LinkageProblem::OnePlace { points })
        } else {
            Ok(())
        }
    }

    /// Adds an existing point to a link, at the place where the point is drawn.
    pub(crate) fn list(&mut self, link: &str, point: &str) -> Done {
        let own = &self.linked(link)?.points;
        if own.iter().any(|one| one == point) {
            let (link, point) = (link.to_owned(), point.to_owned());
            return Err(Defect::Repeated { link, point }.into());
        }
        for one in own {
            self.apart(&[one.clone(), point.to_owned()])?;
        }
        self.redraw(|one| one.name == link);
        self.change(link, |link| link.points.push(point.to_owned()));
        Ok(())
    }

    /// Drops the given dimensions of the links that `which` selects: the drawing then determines them.
    pub(crate) fn redraw(&mut self, which: impl Fn(&LinkDocument) -> bool) {
        let links = self.document.links.iter_mut();
        for link in links.filter(|link| which(link)) {
            link.length = None;
            link.shape = None;
        }
    }

    /// Adds a block that is hinged at a point and slides along a line.
    pub(crate) fn block(&mut self, point: &str, along: &Line) -> Result<String, LinkageProblem> {
        if let Line::Link(link) = along
            && self.linked(link)?.points.iter().any(|one| one == point)
        {
            let (link, point) = (link.clone(), point.to_owned());
            return Err(LinkageProblem::OnItsLine { link, point });
        }
        let points = [point.to_owned()];
        let block = self.add_link(&points, Some("block"));
        self.slide(&block, point, along)?;
        Ok(block)
    }

    /// Adds a prismatic pair of a link and a line; `point` is the point of the link that slides along the line.
    pub(crate) fn slide(&mut self, link: &str, point: &str, along: &Line) -> Done {
        let (on, line) = self.line(point, along)?;
        if on == link {
            let link = on;
            return Err(Defect::WithItself { link }.into());
        }
        self.document.slides.push(SlideDocument {
            link: link.to_owned(),
            point: point.to_owned(),
            on,
            line,
        });
        Ok(())
    }

    /// The line along which a point slides: the link or frame that carries the line, and two points on the line. On the
    /// frame, these points are added.
    fn line(&mut self, point: &str, along: &Line) -> Result<(String, [String; 2]), LinkageProblem> {
        match along {
            Line::Toward(to) => {
                let kept = self.point.clone();
                let from = self.at(point)?;
                let ends = [self.put(from.into()), self.put(*to)];
                self.point = kept;
                self.apart(&ends)?;
                self.document.frame.extend(ends.iter().cloned());
                Ok((FRAME.to_owned(), ends))
            }
            Line::Link(link) => {
                let at = self.at(point)?;
                Ok((link.clone(), self.side(link, at)?))
            }
        }
    }

    /// The two points of a link whose connecting segment is nearest to a place.
    pub(crate) fn side(&self, link: &str, to: Point) -> Result<[String; 2], LinkageProblem> {
        let points = &self.linked(link)?.points;
        let mut best: Option<(f64, [String; 2])> = None;
        for (k, from) in points.iter().enumerate() {
            for other in &points[..k] {
                let off = (to - nearest(to, self.at(other)?, self.at(from)?)).norm();
                if best.as_ref().is_none_or(|(least, _)| off < *least) {
                    best = Some((off, [other.clone(), from.clone()]));
                }
            }
        }
        let link = link.to_owned();
        best.map(|(_, side)| side)
            .ok_or(LinkageProblem::NoLine { link })
    }

    fn trace(&mut self, link: &str, at: [f64; 2]) -> Done {
        let place = self.on_link(link, Point::from(at))?;
        let name = names::new_tracer(&self.document);
        self.point = Some(name.clone());
        self.document.tracers.push(TracerDocument {
            name,
            link: link.to_owned(),
            at: place,
        });
        Ok(())
    }

    fn mass(&mut self, link: &str, at: Option<[f64; 2]>) -> Done {
        if let Some(old) = self.linked(link)?.centre_of_mass.clone() {
            self.change(link, |link| link.centre_of_mass = None);
            let elsewhere = |one: &&LinkDocument| one.points.contains(&old);
            if self.document.links.iter().filter(elsewhere).count() == 1 {
                self.remove(&[old], &[])?;
            }
        }
        let Some(at) = at else { return Ok(()) };
        let point = self.put(at);
        self.list(link, &point)?;
        self.change(link, |link| link.centre_of_mass = Some(point));
        Ok(())
    }

    /// Coordinates of a place on a link: the origin is the link's first point, and x points towards its second.
    pub(crate) fn on_link(&self, link: &str, at: Point) -> Result<[f64; 2], LinkageProblem> {
        let (first, along) = self.axes_of(link)?;
        let off = at - first;
        Ok([off.dot(&along), along.perp(&off)])
    }

    /// The place of coordinates on a link.
    pub(crate) fn off_link(&self, link: &str, on: Vector) -> Result<Point, LinkageProblem> {
        let (first, along) = self.axes_of(link)?;
        Ok(first + along * on.x + perpendicular(along) * on.y)
    }

    /// The first point of a link and the direction from it to the second.
    fn axes_of(&self, link: &str) -> Result<(Point, Vector), LinkageProblem> {
        let mut places = self.linked(link)?.points.iter().map(|point| self.at(point));
        let bare = || Defect::Bare {
            link: link.to_owned(),
        };
        let first = places.next().ok_or_else(bare)??;
        let along = match places.next() {
            Some(second) => (second? - first).normalize(),
            None => Vector::x(),
        };
        Ok((first, along))
    }
}

/// The problem that no part has this name.
pub(crate) fn unknown(name: &str) -> LinkageProblem {
    let name = name.to_owned();
    Defect::UnknownName { name }.into()
}
