//! The equations of equilibrium of a free body in a student's senses, and the judgement of the student's answers.

use assur::Point;
use assur::forces::{Addend, Judged};
use assur_draw::{equilibrium_picture, force_symbol};
use assur_file::Problem;
use serde::{Deserialize, Serialize};

use crate::force_plan::{ForcePictureHere, here};
use crate::moving::Moving;

/// What a student has chosen and filled in on the sheet of a link.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct StudentSheet {
    /// Place of the link in the list of moving links, from 0.
    link: usize,
    /// Place of the point of moments among `points` of the result, from 0.
    about: usize,
    /// Numbers of the unknowns whose senses are reversed.
    reversed: Vec<usize>,
    /// For each addend its signs −1, 0 or 1 in ΣX, ΣY and ΣM, and its arm; null where nothing is filled in.
    answers: Vec<[Option<f64>; 4]>,
}

/// The equations of equilibrium of a link in the senses and about the point of a sheet, with the judgement of its
/// answers.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct EquilibriumHere {
    /// Points about which moments can be taken: those of the link first.
    points: Vec<String>,
    addends: Vec<AddendHere>,
    /// The link with the unknowns in the chosen senses, all equally long.
    picture: ForcePictureHere,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct AddendHere {
    symbol: String,
    /// Number of an unknown; null for a given force or couple.
    unknown: Option<usize>,
    /// Direction of the force in its sense, radians from the x-axis; null for a couple.
    direction: Option<f64>,
    /// Factors in ΣX, ΣY and ΣM; the last is the arm with the sign of its moment, or the sense of a couple.
    factors: [f64; 3],
    /// Size in this sense, in N or N·m; null if indeterminate.
    size: Option<f64>,
    /// Whether the signs given for ΣX, ΣY and ΣM are right; null where none is given.
    signs: [Option<bool>; 3],
    /// Whether the given arm is right; null if none is given.
    arm: Option<bool>,
}

impl Moving {
    /// The equations of equilibrium of a link at an input; None if there is no such link.
    ///
    /// # Errors
    /// Those of [`Self::balanced`].
    pub(crate) fn equilibrium(
        &self,
        input: f64,
        sheet: &StudentSheet,
    ) -> Result<Option<EquilibriumHere>, Vec<Problem>> {
        let (pose, found) = self.balanced(input)?;
        let mechanism = self.mechanism();
        let Some(body) = mechanism.bodies().skip(1).nth(sheet.link) else {
            return Ok(None);
        };
        let mut points: Vec<_> = mechanism.points_on(body).collect();
        let others = mechanism.point_ids();
        let others: Vec<_> = others.filter(|point| !points.contains(point)).collect();
        points.extend(others);
        let about = points.get(sheet.about).or(points.first());
        let about = about.map_or_else(Point::origin, |point| {
            mechanism.place(&pose, *point).place()
        });
        let (statics, units) = (&self.forces().statics, self.forces().units);
        let addends = statics.equilibrium(mechanism, &found, body, about, &sheet.reversed);
        let numbers = |body| self.body_number(body);
        let picture = equilibrium_picture(mechanism, &pose, body, (&addends, about), &numbers);
        let written = |(k, one): (usize, &Addend)| {
            let [x, y, moment, arm] = sheet.answers.get(k).copied().unwrap_or_default();
            let given = [x, y, moment].map(|sign| sign.unwrap_or(f64::NAN));
            let Judged { signs, arm } = one.judged(given, arm.unwrap_or(f64::NAN));
            AddendHere {
                symbol: force_symbol(&one.name, one.is_couple, &numbers),
                unknown: one.unknown,
                direction: (!one.is_couple).then(|| one.direction.y.atan2(one.direction.x)),
                factors: one.factors,
                size: one.size.map(|size| size * units.drive(one.is_couple)),
                signs,
                arm,
            }
        };
        let name = |point| mechanism.point_name(point).to_owned();
        Ok(Some(EquilibriumHere {
            addends: addends.iter().enumerate().map(written).collect(),
            points: points.into_iter().map(name).collect(),
            picture: here(picture, units),
        }))
    }
}
