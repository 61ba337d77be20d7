//! The mixer's dimensions as they are saved.

use assur::Assembly;
use assur::catalog::mixer::{Dimensions, Mixer};
use assur::gears::Mesh;
use serde::{Deserialize, Serialize};

use crate::Problem;

/// The mixer: lengths in metres, numbers of teeth, and how the wheels are set.
/// Numbers are taken as they come; [`MixerDocument::mixer`] checks them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MixerDocument {
    /// Crank AB.
    pub l1: f64,
    /// Coupler BC.
    pub l2: f64,
    /// Rocker DC.
    pub l3: f64,
    /// Frame AD.
    pub l4: f64,
    /// Teeth of the wheel on the rocker's shaft.
    pub z4: f64,
    /// Teeth of the wheel it drives.
    pub z5: f64,
    /// `external`, `internal` or `as_printed`.
    pub mesh: String,
    /// Module of the wheels, metres.
    pub module: f64,
    /// Direction from the shaft of wheel 4 to that of wheel 5, degrees.
    pub centre_line_deg: f64,
    /// 1 or 2.
    pub assembly: f64,
}

const MESHES: [(Mesh, &str); 3] = [
    (Mesh::External, "external"),
    (Mesh::Internal, "internal"),
    (Mesh::AsPrinted, "as_printed"),
];

impl MixerDocument {
    /// The saved form of these dimensions.
    pub fn new(dimensions: &Dimensions) -> Self {
        let [l1, l2, l3, l4] = dimensions.lengths;
        let [z4, z5] = dimensions.teeth;
        let name = MESHES.iter().find(|(mesh, _)| *mesh == dimensions.mesh);
        Self {
            l1,
            l2,
            l3,
            l4,
            z4,
            z5,
            mesh: name.map_or("", |(_, name)| name).to_owned(),
            module: dimensions.module,
            centre_line_deg: dimensions.centre_line.to_degrees(),
            assembly: match dimensions.assembly {
                Assembly::First => 1.0,
                Assembly::Second => 2.0,
            },
        }
    }

    /// The mixer that is described.
    ///
    /// # Errors
    /// Every problem at once, each naming its field.
    pub fn mixer(&self) -> Result<Mixer, Vec<Problem>> {
        let mut problems = Vec::new();
        let mesh = MESHES.iter().find(|(_, name)| *name == self.mesh);
        if mesh.is_none() {
            problems.push(Problem::UnknownChoice { field: "mesh" });
        }
        let assembly = match self.assembly {
            1.0 => Some(Assembly::First),
            2.0 => Some(Assembly::Second),
            _ => None,
        };
        if assembly.is_none() {
            problems.push(Problem::UnknownChoice { field: "assembly" });
        }
        let made = Mixer::new(&Dimensions {
            lengths: [self.l1, self.l2, self.l3, self.l4],
            teeth: [self.z4, self.z5],
            mesh: mesh.map_or(Mesh::External, |(mesh, _)| *mesh),
            module: self.module,
            centre_line: self.centre_line_deg.to_radians(),
            assembly: assembly.unwrap_or(Assembly::First),
        });
        match made {
            Ok(mixer) if problems.is_empty() => Ok(mixer),
            made => {
                problems.extend(made.err().into_iter().flatten().map(Problem::from));
                Err(problems)
            }
        }
    }
}
