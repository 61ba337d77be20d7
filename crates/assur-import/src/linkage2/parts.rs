//! Parts of a Linkage file: connectors, links, ratios of wheels.

use assur_file::LengthUnit;

use super::markup::Tag;
use crate::ImportProblem;
use assur::mechanism::FARTHEST;

/// Bit mask of the layers with moving parts; the other layers hold only drawings.
const MECHANISM: i64 = 0xFFFF_FFF0;

/// Number of a file's units of length per inch.
const TO_AN_INCH: f64 = 96.0;
const MM_TO_AN_INCH: f64 = 25.4;

/// A point of the mechanism.
#[derive(Debug, Default)]
pub(super) struct Connector {
    pub(super) id: i64,
    pub(super) name: String,
    pub(super) at: [f64; 2],
    pub(super) anchor: bool,
    pub(super) input: bool,
    pub(super) traced: bool,
    pub(super) by_hand: bool,
    /// Revolutions per minute, positive clockwise.
    pub(super) rpm: f64,
    /// Angle through which an input oscillates, degrees; 0 if the input keeps rotating.
    pub(super) swing: f64,
    /// The two connectors between which a pin slides.
    pub(super) slot: Option<[i64; 2]>,
    pub(super) slider: bool,
    /// Radius of the slot; 0 for a straight slot.
    pub(super) radius: f64,
    /// Number of the link to which the connector is fastened.
    pub(super) carried: Option<i64>,
}

/// A link, an actuator or a wheel.
#[derive(Debug, Default)]
pub(super) struct Link {
    pub(super) id: i64,
    pub(super) name: String,
    pub(super) connectors: Vec<i64>,
    pub(super) wheel: bool,
    /// Stroke of an actuator and its cycles per minute, which are negative if the actuator shortens first.
    pub(super) stroke: Option<[f64; 2]>,
    /// Displacement within the stroke at which the actuator is drawn.
    pub(super) start: f64,
    pub(super) by_hand: bool,
    pub(super) fastened: Option<i64>,
    pub(super) fastened_to_connector: Option<i64>,
}

/// Two wheels in mesh or joined by a chain, with their sizes.
#[derive(Debug)]
pub(super) struct Ratio {
    pub(super) links: [i64; 2],
    pub(super) sizes: [f64; 2],
    pub(super) chain: bool,
}

/// All parts of a file. Lengths are in inches or millimetres, as `unit` states.
#[derive(Debug, Default)]
pub(super) struct Parts {
    pub(super) unit: Option<LengthUnit>,
    pub(super) scale: f64,
    pub(super) connectors: Vec<Connector>,
    pub(super) links: Vec<Link>,
    pub(super) ratios: Vec<Ratio>,
    /// Number of parts that are drawn but do not belong to the mechanism.
    pub(super) drawn: usize,
}

impl Parts {
    /// Reads the parts of a file.
    ///
    /// # Errors
    /// Numbers that are missing, invalid or out of range; two connectors with the same number; too many parts.
    pub(super) fn read(root: &Tag<'_>) -> Result<Self, ImportProblem> {
        let program = root.all("program").next();
        let inches =
            program.is_some_and(|program| program.text("units").eq_ignore_ascii_case("inches"));
        let scale = program.map_or(Ok(None), |program| program.number("scalefactor"))?;
        let length = Length(if inches { 1.0 } else { MM_TO_AN_INCH } / TO_AN_INCH);
        let mut parts = Self {
            unit: Some(if inches {
                LengthUnit::In
            } else {
                LengthUnit::Mm
            }),
            scale: scale.unwrap_or(1.0),
            ..Self::default()
        };
        crate::bounded(root.tags.len())?;
        crate::bounded(root.mentions())?;
        for tag in root.all("connector") {
            if drawn(tag)? {
                parts.drawn += 1;
                continue;
            }
            let connector = length.connector(tag)?;
            if parts
                .connectors
                .iter()
                .any(|other| other.id == connector.id)
            {
                let part = format!("connector {}", connector.id);
                return Err(ImportProblem::twice(&part));
            }
            parts.connectors.push(connector);
        }
        for tag in root
            .tags
            .iter()
            .filter(|tag| ["Link", "element"].contains(&tag.name))
        {
            if drawn(tag)? {
                parts.drawn += 1;
            } else {
                parts.links.push(length.link(tag)?);
            }
        }
        for tag in root.all("ratios").flat_map(|ratios| ratios.all("ratio")) {
            parts.ratios.extend(ratio(tag)?);
        }
        Ok(parts)
    }

    /// Name of a link; for a link without one, the number that Linkage shows instead.
    pub(super) fn called(link: &Link) -> String {
        let name = link.name.trim();
        if name.is_empty() {
            (link.id + 1).to_string()
        } else {
            name.to_owned()
        }
    }
}

fn drawn(tag: &Tag<'_>) -> Result<bool, ImportProblem> {
    let layer = tag.whole("layer")?.unwrap_or(0);
    Ok((layer != 0 && layer & MECHANISM == 0) || tag.is("measurementelement"))
}

fn id(tag: &Tag<'_>, name: &str) -> Result<Option<i64>, ImportProblem> {
    tag.whole(name)
}

/// Factor that converts lengths, as written in a file, to inches or millimetres.
struct Length(f64);

impl Length {
    fn of(&self, tag: &Tag<'_>, name: &str) -> Result<Option<f64>, ImportProblem> {
        let Some(value) = finite(tag, name)? else {
            return Ok(None);
        };
        Ok(Some(value * self.0))
    }

    fn connector(&self, tag: &Tag<'_>) -> Result<Connector, ImportProblem> {
        let limits = tag.all("slidelimit").map(|limit| id(limit, "id"));
        let limits: Vec<i64> = limits
            .collect::<Result<Vec<_>, _>>()?
            .into_iter()
            .flatten()
            .collect();
        let slider = tag.is("slider");
        let carried = match id(tag, "fasten")? {
            Some(link) => Some(link),
            None => id(tag, "fastenlink")?,
        };
        Ok(Connector {
            id: required(tag, id(tag, "id")?, "id")?,
            name: crate::quoted(tag.text("name").trim()),
            at: [
                required(tag, self.of(tag, "x")?, "x")?,
                required(tag, self.of(tag, "y")?, "y")?,
            ],
            anchor: tag.is("anchor"),
            input: tag.is("input"),
            traced: tag.is("draw"),
            by_hand: tag.is("alwaysmanual"),
            rpm: finite(tag, "rpm")?.unwrap_or(0.0),
            swing: finite(tag, "limitangle")?.unwrap_or(0.0),
            slot: match limits[..] {
                [from, to, ..] if slider => Some([from, to]),
                _ => None,
            },
            slider,
            radius: self.of(tag, "slideradius")?.unwrap_or(0.0).abs(),
            carried,
        })
    }

    fn link(&self, tag: &Tag<'_>) -> Result<Link, ImportProblem> {
        let connectors = tag.all("connector").map(|connector| id(connector, "id"));
        let connectors = connectors.collect::<Result<Vec<_>, _>>()?;
        let carried = tag
            .all("fastenconnector")
            .map(|connector| id(connector, "id"));
        let carried = carried.collect::<Result<Vec<_>, _>>()?;
        let mut own: Vec<i64> = Vec::new();
        for connector in connectors.into_iter().chain(carried).flatten() {
            if !own.contains(&connector) {
                own.push(connector);
            }
        }
        let stroke = match tag.is("actuator") {
            true => {
                let throw = self.of(tag, "throw")?.unwrap_or(0.0);
                Some([throw, finite(tag, "cpm")?.unwrap_or(0.0)])
            }
            false => None,
        };
        let fastened = match id(tag, "fasten")? {
            Some(link) => Some(link),
            None => id(tag, "fastenlink")?,
        };
        Ok(Link {
            id: required(tag, id(tag, "id")?, "id")?,
            name: crate::quoted(tag.text("name")),
            connectors: own,
            wheel: tag.is("gear"),
            stroke,
            start: self.of(tag, "startoffset")?.unwrap_or(0.0),
            by_hand: tag.is("alwaysmanual"),
            fastened,
            fastened_to_connector: id(tag, "fastenconnector")?,
        })
    }
}

/// Reads the ratio of two wheels; none if the tag has fewer than two wheels.
fn ratio(tag: &Tag<'_>) -> Result<Option<Ratio>, ImportProblem> {
    let wheels = tag
        .all("link")
        .map(|wheel| Ok((id(wheel, "id")?, finite(wheel, "size")?)));
    let wheels: Vec<_> = wheels.collect::<Result<_, _>>()?;
    Ok(match wheels[..] {
        [(Some(a), Some(first)), (Some(b), Some(second)), ..] => Some(Ratio {
            links: [a, b],
            sizes: [first, second],
            chain: tag.text("type") != "gears",
        }),
        _ => None,
    })
}

/// Reads a number, which must not exceed [`FARTHEST`] in absolute value.
fn finite(tag: &Tag<'_>, name: &str) -> Result<Option<f64>, ImportProblem> {
    let value = tag.number(name)?;
    match value {
        Some(value) if value.abs() > FARTHEST => Err(tag.refused(name)),
        _ => Ok(value),
    }
}

fn required<T>(tag: &Tag<'_>, value: Option<T>, name: &str) -> Result<T, ImportProblem> {
    value.ok_or_else(|| tag.refused(name))
}
