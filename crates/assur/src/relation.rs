//! Relations of a paper, evaluated: the value of a quantity in a pose, and its value by the relation as printed.

use std::borrow::Cow;

use crate::Vector;

/// A quantity for which a paper gives a relation.
#[derive(Clone, Debug, PartialEq)]
pub struct Relation {
    /// Row of the table in docs/papers.md, such as `002.(10)`, or an id of its own for a relation that is not in this
    /// table.
    pub item: &'static str,
    /// The quantity in the paper's notation, such as `φ₃′`; with the number of the assembly if there are several:
    /// `φ₂⁽¹⁾`.
    pub name: Cow<'static, str>,
    /// True for an angle in radians; false for a length or a number.
    pub is_angle: bool,
    /// True for an angle of rotation, in which whole turns count; false for a direction and for any other quantity.
    pub is_turned: bool,
    /// True for a count, which is a whole number.
    pub is_count: bool,
    /// Value of the quantity in the pose.
    pub value: f64,
    /// Value by the relation as printed; None if it is not finite, for example because the relation divides by zero.
    pub printed: Option<f64>,
}

impl Relation {
    pub(crate) fn of(
        item: &'static str,
        name: impl Into<Cow<'static, str>>,
        value: f64,
        printed: f64,
    ) -> Self {
        Self {
            item,
            name: name.into(),
            is_angle: false,
            is_turned: false,
            is_count: false,
            value,
            printed: printed.is_finite().then_some(printed),
        }
    }

    /// A quantity shown beside the relations, for which the paper prints no relation: its printed value is its own
    /// value.
    pub(crate) fn shown(
        item: &'static str,
        name: impl Into<Cow<'static, str>>,
        value: f64,
    ) -> Self {
        Self::of(item, name, value, value)
    }

    /// Relations for both coordinates of a vector.
    pub(crate) fn both(
        item: &'static str,
        [x, y]: [&'static str; 2],
        value: Vector,
        printed: Vector,
    ) -> [Self; 2] {
        [
            Self::of(item, x, value.x, printed.x),
            Self::of(item, y, value.y, printed.y),
        ]
    }

    pub(crate) fn angle(
        item: &'static str,
        name: impl Into<Cow<'static, str>>,
        value: f64,
        printed: f64,
    ) -> Self {
        Self {
            is_angle: true,
            ..Self::of(item, name, value, printed)
        }
    }

    pub(crate) fn turned(
        item: &'static str,
        name: impl Into<Cow<'static, str>>,
        value: f64,
        printed: f64,
    ) -> Self {
        Self {
            is_turned: true,
            ..Self::angle(item, name, value, printed)
        }
    }

    pub(crate) fn count(
        item: &'static str,
        name: impl Into<Cow<'static, str>>,
        value: isize,
        printed: isize,
    ) -> Self {
        Self {
            is_count: true,
            ..Self::of(item, name, value as f64, printed as f64)
        }
    }
}
