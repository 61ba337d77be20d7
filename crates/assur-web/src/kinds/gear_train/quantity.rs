//! Read-outs and plotted quantities of a differential, by name.

use assur::dynamics::Mesh;
use assur_draw::{Role, TrainFigure};

/// Names of the bodies, in the order of [`Body::ALL`](assur::dynamics::Body::ALL).
pub(crate) const BODIES: [&str; 4] = ["sun", "satellite", "carrier", "ring"];
/// Numbers of the bodies, in the same order.
pub(crate) const NUMBERS: [&str; 4] = ["1", "2", "3", "4"];

/// Names of the meshes, in the order of [`Mesh::ALL`]: a mesh has the name of its central wheel.
pub(crate) const MESHES: [&str; 2] = ["sun", "ring"];

/// A quantity that is read out and plotted with its first two derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Quantity {
    /// The angle of a body, by its index in [`Body::ALL`](assur::dynamics::Body::ALL), relative to the observer.
    Angle(usize),
    /// The load angle of a mesh, by its index in [`Mesh::ALL`], plus the angle of the slipped periods.
    LoadAngle(usize),
}

/// Finds the quantities plotted for an option of the page; none for an unknown option.
pub(crate) fn plotted(plot: &str, loaded: bool) -> Option<Vec<Quantity>> {
    match plot {
        "angles" => Some(Quantity::angles().collect()),
        "load" if loaded => Some(Quantity::load_angles().collect()),
        other => {
            let found = Quantity::all(loaded).find(|quantity| quantity.name() == other);
            found.map(|quantity| vec![quantity])
        }
    }
}

/// A quantity or one of its derivatives, by order.
#[derive(Clone, Copy)]
pub(crate) struct Column {
    pub(crate) quantity: Quantity,
    pub(crate) order: usize,
}

impl Column {
    /// Finds the column with this heading in tables.
    pub(crate) fn named(name: &str, loaded: bool) -> Option<Self> {
        Quantity::all(loaded).find_map(|quantity| {
            let mut columns = quantity.columns().into_iter();
            let order = columns.position(|column| column == name)?;
            Some(Self { quantity, order })
        })
    }
}

impl Quantity {
    fn angles() -> impl Iterator<Item = Self> {
        (0..BODIES.len()).map(Self::Angle)
    }

    fn load_angles() -> impl Iterator<Item = Self> {
        (0..MESHES.len()).map(Self::LoadAngle)
    }

    /// All quantities with read-outs; load angles are read out only under load.
    pub(crate) fn all(loaded: bool) -> impl Iterator<Item = Self> {
        Self::angles().chain(Self::load_angles().filter(move |_| loaded))
    }

    /// Name of the quantity among read-outs and plots.
    pub(crate) fn name(self) -> String {
        let [name, _, _] = self.columns();
        name
    }

    /// Column headings of the quantity and its first two derivatives in tables, in the form used for linkages.
    pub(crate) fn columns(self) -> [String; 3] {
        let (of, what) = match self {
            Self::Angle(body) => (BODIES[body], "angle"),
            Self::LoadAngle(mesh) => (MESHES[mesh], "load_angle"),
        };
        ["", "d", "dd"].map(|rate| format!("{of}.{rate}{what}"))
    }

    /// Index of the body to which the quantity belongs; for a mesh, its central wheel.
    pub(crate) fn body(self) -> usize {
        match self {
            Self::Angle(body) => body,
            Self::LoadAngle(mesh) => Mesh::ALL[mesh].wheel().index(),
        }
    }

    pub(crate) fn role(self) -> Role {
        TrainFigure::roles()[self.body()]
    }
}
