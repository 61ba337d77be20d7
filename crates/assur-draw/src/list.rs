//! The display list: records of numbers that a painter executes in order.
//!
//! | record | meaning |
//! |---|---|
//! | `0, body` | the following records are in the coordinates of that body (0: the frame) |
//! | `1, role, look, loops, n₁, x, y, …, n₂, …` | `loops` polygons of n₁, n₂, … corners, filled by the even-odd rule |
//! | `2, role, look, n, x, y, …` | an open polyline of n points |
//! | `3, role, look, x, y, r` | a circle |
//! | `4, role, label, x, y, dx, dy` | a label whose middle is offset from (x, y) by (dx, dy) text heights |
//!
//! Roles and looks are numbers in the order of their enumerations. Labels are indices of the drawing's names
//! ([`crate::Figure::names`]). Coordinates are the model's, y upwards. Numbers are `f32`, precise enough for a screen.

use assur::Point;

/// Defines the roles, with their names, in the order of their numbers.
macro_rules! roles {
    ($($role:ident = $name:literal,)+) => {
        /// Role of a shape: its colour, the same in the drawing and in the plots. (`Paper` is the background.)
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[expect(missing_docs, reason = "a role is its name")]
        pub enum Role {
            $($role,)+
        }

        /// The names of the roles, in the order of their numbers.
        pub const ROLES: [&str; [$($name),+].len()] = [$($name),+];
    };
}

roles! {
    Ink = "ink",
    Secondary = "secondary",
    Line = "line",
    Crank = "crank",
    Coupler = "coupler",
    Rocker = "rocker",
    Accent1 = "accent1",
    Accent2 = "accent2",
    Idler = "idler",
    Paper = "paper",
    Velocity = "velocity",
    Acceleration = "acceleration",
    X = "x",
    Y = "y",
    Accent3 = "accent3",
    Accent4 = "accent4",
    Accent5 = "accent5",
    Accent6 = "accent6",
    Accent7 = "accent7",
    Loose = "loose",
    Locked = "locked",
    Reaction = "reaction",
    Force = "force",
    Weight = "weight",
    Inertia = "inertia",
    Torque = "torque",
}

impl Role {
    /// Returns the name, as in [`ROLES`].
    pub fn name(self) -> &'static str {
        ROLES[self as usize]
    }
}

/// Colours assigned in turn to links that are not driven, or to Assur groups.
pub(crate) const IN_TURN: [Role; 6] = [
    Role::Coupler,
    Role::Rocker,
    Role::Accent2,
    Role::Accent3,
    Role::Accent5,
    Role::Accent6,
];

/// Look of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    /// Filled.
    Solid,
    /// Filled faintly, with an outline.
    Pale,
    /// A plain line.
    Line,
    /// A dashed line.
    Dashed,
    /// A hairline.
    Thin,
    /// Filled with the colour of the paper, with an outline.
    Hollow,
    /// Filled at medium strength.
    Soft,
}

/// A display list under construction.
#[derive(Clone, Debug, Default)]
pub struct List(Vec<f32>);

impl List {
    /// Returns the records, one after the other.
    pub fn numbers(&self) -> &[f32] {
        &self.0
    }

    /// Adds the records of another list.
    pub(crate) fn append(&mut self, other: &Self) {
        self.0.extend(&other.0);
    }

    pub(crate) fn body(&mut self, body: usize) {
        self.0.extend([0.0, body as f32]);
    }

    pub(crate) fn polygons(&mut self, role: Role, look: Look, loops: &[Vec<Point>]) {
        self.head(1, role, look);
        self.0.push(loops.len() as f32);
        for points in loops {
            self.points(points);
        }
    }

    pub(crate) fn polyline(&mut self, role: Role, look: Look, points: &[Point]) {
        self.head(2, role, look);
        self.points(points);
    }

    pub(crate) fn circle(&mut self, role: Role, look: Look, centre: Point, radius: f64) {
        self.head(3, role, look);
        self.0
            .extend([centre.x, centre.y, radius].map(|x| x as f32));
    }

    /// Adds the label with this index.
    pub(crate) fn name(&mut self, role: Role, name: usize, at: Point, off: [f64; 2]) {
        self.0.extend([4.0, role as u8 as f32, name as f32]);
        self.0
            .extend([at.x, at.y, off[0], off[1]].map(|x| x as f32));
    }

    fn head(&mut self, record: u8, role: Role, look: Look) {
        self.0
            .extend([record, role as u8, look as u8].map(f32::from));
    }

    fn points(&mut self, points: &[Point]) {
        self.0.push(points.len() as f32);
        self.0
            .extend(points.iter().flat_map(|p| [p.x as f32, p.y as f32]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_numbers() {
        assert_eq!(ROLES[Role::Paper as usize], "paper");
        assert_eq!(ROLES[Role::Accent2 as usize], "accent2");
        assert_eq!(ROLES[Role::Acceleration as usize], "acceleration");
        assert_eq!(ROLES[Role::Y as usize], "y");
        assert_eq!(ROLES[Role::Accent7 as usize], "accent7");
        assert_eq!(Look::Soft as u8, 6);
    }

    #[test]
    fn records() {
        let mut list = List::default();
        list.body(2);
        list.circle(Role::Crank, Look::Hollow, Point::new(1.0, 2.0), 0.5);
        list.name(Role::Ink, 1, Point::new(3.0, 4.0), [0.0, 1.0]);
        list.polygons(Role::Ink, Look::Solid, &[vec![Point::new(5.0, 6.0)]]);
        let expected = [
            [0.0, 2.0].as_slice(),
            &[3.0, 3.0, 5.0, 1.0, 2.0, 0.5],
            &[4.0, 0.0, 1.0, 3.0, 4.0, 0.0, 1.0],
            &[1.0, 0.0, 0.0, 1.0, 1.0, 5.0, 6.0],
        ];
        assert_eq!(list.numbers(), expected.concat());
    }
}
