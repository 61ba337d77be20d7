//! A solution as a linkage like any other.

use nalgebra::{Complex, Rotation2};

use super::{Solution, Task};
use crate::mechanism::{Draft, DraftDriver, DraftLink, DraftPoint, FRAME};
use crate::{Assembly, FourBar, Invalid, Point, Pose, Unsolved};

/// Why a solution cannot be drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Undrawn {
    /// Its lengths make no linkage.
    Lengths(Vec<Invalid>),
    /// It is in no position, and its links cannot be laid on its first arc either.
    Unsolved(Unsolved),
}

/// The links from joint to joint.
const LINKS: [[&str; 3]; 3] = [
    ["crank", "A", "B"],
    ["coupler", "B", "C"],
    ["rocker", "D", "C"],
];

impl Solution {
    /// The linkage as a draft: input `crank` AB with A at the origin, `coupler` BC, output
    /// `rocker` DC, drawn in the first position that its input reaches, in the assembly in which
    /// C is nearer to where the position asks for it. The crank's angle is φ₃, the rocker's
    /// φ₂ + 180°.
    ///
    /// # Errors
    /// Why it cannot be drawn.
    pub fn draft(&self, task: &Task) -> Result<Draft, Undrawn> {
        let frame = task.frame();
        let linkage = self.proportions.four_bar(frame.length);
        let linkage = linkage.map_err(Undrawn::Lengths)?;
        let pose = self.drawn(task, &linkage).map_err(Undrawn::Unsolved)?;
        let turn = Rotation2::new(frame.angle);
        let joints = linkage.joints(&pose).map(|joint| turn * joint.place());
        let named = |(name, at): (&str, Point)| DraftPoint {
            name: name.to_owned(),
            at,
        };
        let [l3, l1, l2, _] = self.proportions.lengths(frame.length);
        let links = LINKS.iter().zip([l3, l1, l2]);
        let links = links.map(|([name, from, to], length)| DraftLink {
            name: (*name).to_owned(),
            points: [from, to].map(|joint| (*joint).to_owned()).to_vec(),
            shape: Some(vec![Point::origin(), Point::new(length, 0.0)]),
            ..DraftLink::default()
        });
        Ok(Draft {
            points: ["A", "B", "C", "D"]
                .into_iter()
                .zip(joints)
                .map(named)
                .collect(),
            frame: ["A", "D"].map(str::to_owned).to_vec(),
            links: links.collect(),
            drivers: vec![DraftDriver::Crank {
                link: "crank".to_owned(),
                base: FRAME.to_owned(),
            }],
            ..Draft::default()
        })
    }

    /// The pose to draw, the frame along the x-axis.
    fn drawn(&self, task: &Task, linkage: &FourBar) -> Result<Pose<1>, Unsolved> {
        let frame = task.frame();
        let assemblies = [Assembly::First, Assembly::Second];
        for direction in task.directions([self.output_start, self.input_start]) {
            let wanted = Complex::new(1.0, 0.0) - direction.output * self.proportions.output;
            let wanted = Point::new(wanted.re, wanted.im) * frame.length;
            let poses = assemblies.map(|one| linkage.pose::<1>(one, direction.input_angle).ok());
            let off = |pose: &Pose<1>| {
                let [_, _, c, _] = linkage.joints(pose);
                (c.place() - wanted).norm()
            };
            let reached = poses.into_iter().flatten();
            let nearest = reached.min_by(|one, other| off(one).total_cmp(&off(other)));
            if let Some(pose) = nearest {
                return Ok(pose);
            }
        }
        let cycle = linkage.cycle();
        let [from, to] = cycle.arcs().first().copied().unwrap_or_default();
        let assembly = self.assembly().unwrap_or(Assembly::First);
        linkage.pose(assembly, 0.5 * (from + to))
    }
}
