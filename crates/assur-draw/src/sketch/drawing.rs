//! Drawing of the frame, links, blocks, wheels and points of a sketch.

use super::*;
use assur::perpendicular;
use assur::sorting::sort_by;

impl Sketch {
    pub(super) fn draw_frame(&mut self) {
        let u = self.unit;
        for slide in self.draft.slides.clone() {
            if slide.on != FRAME {
                continue;
            }
            if let Some([from, to]) = self.line(&slide) {
                let along = (to - from).normalize();
                let down = self.outer(from, along);
                let wall = [from - along * (5.0 * u), to + along * (5.0 * u)];
                let wall = wall.map(|end| end + down * (BLOCK[1] * u));
                parts::hatched(&mut self.list, wall, down, u);
            }
        }
        for name in self.draft.frame.clone() {
            if let Some(at) = self.place(&name).filter(|_| self.is_support(&name)) {
                parts::support(&mut self.list, at, 1.5 * u);
            }
        }
    }

    /// Returns the side of a frame line that faces away from the fixed pivots, or the lower side if they are on both
    /// sides. The drawing of the motion has the same side, unless there are pivots near the line.
    pub(super) fn outer(&self, start: Point, along: Vector) -> Vector {
        let across = parts::lower(along);
        let pivots = self.draft.frame.iter().filter(|name| self.is_support(name));
        let offs = pivots.filter_map(|name| Some(self.place(name)? - start));
        parts::outer(across, offs)
    }

    /// Returns the ends of a slide's line, if they do not coincide.
    fn line(&self, slide: &SlideSpec) -> Option<[Point; 2]> {
        let [from, to] = [self.place(&slide.line[0])?, self.place(&slide.line[1])?];
        ((to - from).norm() > 0.0).then_some([from, to])
    }

    pub(super) fn draw_wheels(&mut self) {
        for wheel in self.wheels().into_iter().rev() {
            let role = self.roles[wheel.link];
            self.list.circle(role, Look::Pale, wheel.at, wheel.radius);
        }
    }

    /// Returns the wheels, the smallest first. A wheel occurs once for each mesh or, without a mesh, once with a
    /// default radius.
    pub(super) fn wheels(&self) -> Vec<Wheel> {
        let of = |name: &str| {
            let links = self.draft.links.iter();
            let (at, link) = links.enumerate().find(|(_, link)| link.name == name)?;
            Some((at, self.place(link.points.first()?)?))
        };
        let mut wheels = Vec::new();
        for gear in &self.draft.gears {
            let [one, other] = &gear.links;
            if let (Some((one, a)), Some((other, b))) = (of(one), of(other)) {
                let [z1, z2] = gear.teeth;
                let internal = matches!(gear.mesh, assur::gears::Mesh::Internal);
                let sum = if internal { (z1 - z2).abs() } else { z1 + z2 };
                let module = (b - a).norm() / sum;
                for (link, at, z, mate) in [(one, a, z1, z2), (other, b, z2, z1)] {
                    wheels.push(Wheel {
                        link,
                        at,
                        radius: module * z,
                        ring: internal && z > mate,
                    });
                }
            }
        }
        for link in self.draft.links.iter().filter(|link| self.is_wheel(link)) {
            let mut gears = self.draft.gears.iter();
            let meshes = gears.any(|gear| gear.links.contains(&link.name));
            if let (false, Some((link, at))) = (meshes, of(&link.name)) {
                wheels.push(Wheel {
                    link,
                    at,
                    radius: WHEEL * self.unit,
                    ring: false,
                });
            }
        }
        wheels.retain(|wheel| wheel.radius.is_finite());
        sort_by(&mut wheels, |one, other| {
            one.radius.total_cmp(&other.radius)
        });
        wheels
    }

    pub(super) fn draw_links(&mut self) {
        for (link, role) in self.draft.links.iter().zip(&self.roles).rev() {
            match parts::hull(self.corners(link))[..] {
                [] | [_] => {}
                [from, to] => parts::bar(&mut self.list, *role, from, to, BAR * self.unit),
                ref outline => parts::plate(&mut self.list, *role, outline, BAR * self.unit),
            }
        }
    }

    pub(super) fn draw_blocks(&mut self) {
        for slide in &self.draft.slides {
            let (Some(at), Some([from, to])) = (self.place(&slide.point), self.line(slide)) else {
                continue;
            };
            let along = (to - from).normalize();
            let middle = from + along * (at - from).dot(&along);
            let role = self.role(&slide.link);
            parts::block(&mut self.list, role, [at, middle], along, self.unit);
        }
    }

    pub(super) fn draw_points(&mut self) {
        let u = self.unit;
        for point in &self.draft.points {
            let links: Vec<&LinkSpec> = (self.draft.links.iter())
                .filter(|link| link.points.contains(&point.name))
                .collect();
            let frame = self.draft.frame.contains(&point.name);
            if links.is_empty() && frame && !self.is_support(&point.name) {
                // The end of a guide has a handle, by which it can be dragged.
                self.handles
                    .push((point.name.clone(), Role::Secondary, point.at));
                self.list
                    .circle(Role::Secondary, Look::Solid, point.at, 0.5 * u);
                continue;
            }
            let role = links
                .first()
                .map_or(Role::Ink, |link| self.role(&link.name));
            let centre = |link: &&LinkSpec| link.centre_of_mass.as_ref() == Some(&point.name);
            if links.iter().all(centre) && !links.is_empty() {
                crate::overlays::mass(&mut self.list, point.at, u);
            } else if links.len() + usize::from(frame) > 1 {
                parts::hinge(&mut self.list, point.at, 1.1 * u);
            } else {
                self.list.circle(role, Look::Hollow, point.at, 0.8 * u);
            }
            let others = links.iter().flat_map(|link| self.corners(link));
            let away = others
                .map(|other| point.at - other)
                .filter(|off| off.norm() > 0.0);
            let away: Vector = away.map(|off| off.normalize()).sum();
            let off = if frame {
                [-1.5, -0.2]
            } else if away.norm() > 1e-3 {
                (away.normalize() * 1.5).into()
            } else {
                [-1.0, 1.1]
            };
            self.list.name(Role::Ink, self.names.len(), point.at, off);
            self.names.push(point.name.clone());
            self.handles.push((point.name.clone(), role, point.at));
        }
        for tracer in &self.draft.tracers {
            let Some(at) = self.traced(&tracer.link, tracer.at) else {
                continue;
            };
            let role = self.role(&tracer.link);
            parts::tracer(&mut self.list, role, at, u);
            self.list.name(Role::Ink, self.names.len(), at, [1.2, 0.9]);
            self.names.push(tracer.name.clone());
            self.handles.push((tracer.name.clone(), role, at));
        }
    }

    /// Returns the position in the drawing of a point given in a link's own coordinates.
    fn traced(&self, link: &str, at: Vector) -> Option<Point> {
        let mut links = self.draft.links.iter();
        let points = &links.find(|one| one.name == link)?.points;
        let first = self.place(points.first()?)?;
        let second = points.get(1).and_then(|name| self.place(name));
        let along = second.map_or(Vector::x(), |second| second - first);
        let along = along.try_normalize(0.0)?;
        Some(first + along * at.x + perpendicular(along) * at.y)
    }
}
