//! The mixer as the specification of a linkage.

use nalgebra::Rotation2;

use super::{Carrier, Mixer};
use crate::mechanism::{FRAME, GearSpec, LinkSpec, LinkageSpec, PointSpec, TracerSpec};
use crate::{Link, Point, Unsolved, Vector};

/// The links with two joints, each with the names of the link, of its joints and of its centre of mass.
const BARS: [(Link, Carrier, [&str; 4]); 3] = [
    (Link::Crank, Carrier::Crank, ["crank", "A", "B", "C1"]),
    (Link::Coupler, Carrier::Coupler, ["coupler", "B", "C", "C2"]),
    (Link::Rocker, Carrier::Rocker, ["rocker", "D", "C", "C3"]),
];

impl Mixer {
    /// The mixer as a specification. Its links are `crank`, `coupler`, `rocker`, `wheel4` (fixed to the rocker), and
    /// `wheel5`, … (hinged to the frame). Its points are A, B, C, D (joints), C1, C2, C3 (centres of mass in the middle
    /// of crank, coupler and rocker), and E5, … (centres of the wheels). Its traced points are P1, ….
    ///
    /// # Errors
    /// The reason why there is no pose to draw.
    pub fn spec(&self) -> Result<LinkageSpec, Unsolved> {
        let cycle = self.linkage.cycle();
        if cycle.is_full() {
            // If the crank turns fully, any crank angle can be drawn.
            return self.spec_at(1.0);
        }
        self.spec_on(cycle.arcs()[0])
    }

    /// Specification drawn in the middle of an arc. If the mixer has no pose there, as a kite may have none, it is
    /// drawn a tenth of the arc before the middle.
    pub(super) fn spec_on(&self, [from, to]: [f64; 2]) -> Result<LinkageSpec, Unsolved> {
        let drawn = self.spec_at(0.5 * (from + to));
        drawn.or_else(|_| self.spec_at(0.6 * from + 0.4 * to))
    }

    fn spec_at(&self, crank: f64) -> Result<LinkageSpec, Unsolved> {
        let pose = self.linkage.pose::<1>(self.assembly, crank)?;
        let joints = self.linkage.joints(&pose).map(|joint| joint.place());
        let mut spec = LinkageSpec::default().fixed(&["A", "D"]);
        let mut point = |name: &str, at: Point| {
            let name = name.to_owned();
            spec.points.push(PointSpec { name, at });
        };
        for (name, at) in ["A", "B", "C", "D"].into_iter().zip(joints) {
            point(name, at);
        }
        let place = |carrier: Carrier, x: f64, y: f64| {
            let (origin, angle) = self.body(&pose, carrier);
            origin.offset(angle, x, y).place()
        };
        for (link, carrier, [.., centre]) in BARS {
            point(centre, place(carrier, 0.5 * self.linkage.length(link), 0.0));
        }
        let wheels = self.gears.pairs().len();
        for wheel in 0..wheels {
            point(
                &format!("E{}", wheel + 5),
                place(Carrier::Wheel(wheel), 0.0, 0.0),
            );
        }
        for (link, _, [name, from, to, centre]) in BARS {
            let length = self.linkage.length(link);
            let along = |x: f64| Point::new(x, 0.0);
            spec.links.push(LinkSpec {
                name: name.to_owned(),
                points: [from, to, centre].map(str::to_owned).to_vec(),
                shape: Some([0.0, length, 0.5 * length].map(along).to_vec()),
                centre_of_mass: Some(centre.to_owned()),
                ..LinkSpec::default()
            });
        }
        spec.links.push(LinkSpec {
            name: "wheel4".to_owned(),
            points: vec!["D".to_owned(), "C".to_owned()],
            fixed_to: Some("rocker".to_owned()),
            ..LinkSpec::default()
        });
        for (wheel, pair) in self.gears.pairs().iter().enumerate() {
            let centre = format!("E{}", wheel + 5);
            let name = format!("wheel{}", wheel + 5);
            spec.links.push(LinkSpec {
                name: name.clone(),
                points: vec![centre.clone()],
                ..LinkSpec::default()
            });
            spec.frame.push(centre);
            spec.gears.push(GearSpec {
                links: ["wheel4".to_owned(), name],
                carrier: FRAME.to_owned(),
                teeth: [pair.driver_wheel(), pair.driven_wheel()]
                    .map(|wheel| f64::from(wheel.teeth)),
                mesh: pair.mesh(),
            });
        }
        spec.tracers.extend(self.spec_tracers());
        Ok(spec.crank("crank"))
    }

    /// The traced points in the coordinates of the specification. In the linkage, the angle of a wheel is the angle of
    /// the rocker times the ratio. In the mixer, the x-axis of a wheel is rotated from this angle by `mounting`.
    fn spec_tracers(&self) -> impl Iterator<Item = TracerSpec> {
        self.tracers().iter().enumerate().map(|(k, tracer)| {
            let at = Vector::new(tracer.x, tracer.y);
            let (link, at) = match tracer.carrier {
                Carrier::Crank => ("crank".to_owned(), at),
                Carrier::Coupler => ("coupler".to_owned(), at),
                Carrier::Rocker => ("rocker".to_owned(), at),
                Carrier::Wheel(wheel) => {
                    let pair = self.gears.pairs().get(wheel);
                    let mounting = pair.map_or(0.0, |pair| pair.driven_wheel().mounting);
                    let turn = Rotation2::new(mounting);
                    (format!("wheel{}", wheel + 5), turn * at)
                }
            };
            let name = format!("P{}", k + 1);
            TracerSpec { name, link, at }
        })
    }
}
