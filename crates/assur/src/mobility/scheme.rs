//! A validated scheme of links and pairs.

use std::collections::{BTreeMap, BTreeSet};

use super::screw::{Form, across};
use super::{PairKind, PairSpec, Point3, SchemeDefect, SchemeSpec, Vector3};
use crate::numeric::graph::Partition;

/// Maximum magnitude of a coordinate, a component of a direction or a pitch: squares and products remain finite.
const RANGE: f64 = 1e60;

/// Links joined by pairs, all connected to the ground. Links are numbered in the order in which the pairs first name
/// them; the ground is number 0.
///
/// ```
/// use assur::mobility::{PairKind, PairSpec, Scheme, SchemeSpec};
/// let pair = |name: &str, links: [&str; 2]| PairSpec {
///     name: name.to_owned(), kind: PairKind::Revolute, links: links.map(str::to_owned).to_vec(),
///     place: None, axis: None, second: None,
/// };
/// let pairs = vec![pair("A", ["0", "1"]), pair("B", ["1", "2"]), pair("C", ["2", "3"]), pair("D", ["3", "0"])];
/// let four_bar = Scheme::new(&SchemeSpec { ground: "0".to_owned(), planar: true, pairs }).unwrap();
/// let sections = four_bar.sections(&four_bar.automatic()).unwrap();
/// assert_eq!((sections.mobility, sections.redundant), (1, 3));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scheme {
    planar: bool,
    links: Vec<String>,
    pairs: Vec<Pair>,
    /// Number of freedoms of each pair, in the plane for a planar scheme and otherwise in space.
    freedoms: Vec<u8>,
}

/// A pair of a scheme.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Name of the pair, unique in the scheme.
    pub name: String,
    /// Form of the pair.
    pub kind: PairKind,
    /// Numbers of the links that the pair joins: two, or k links in a compound hinge, which counts as k − 1 pairs.
    pub links: Vec<usize>,
    /// Position of the pair; None if it is not given.
    pub place: Option<Point3>,
    /// Unit vector along the axis or normal of the pair. None if the kind of pair has none, or if neither the
    /// specification nor a default gives it.
    pub axis: Option<Vector3>,
    /// Second direction, a unit vector perpendicular to the axis; only a universal pair or a line contact has one.
    pub second: Option<Vector3>,
}

impl Pair {
    /// Number of two-link pairs that this pair counts as.
    pub fn count(&self) -> usize {
        self.links.len() - 1
    }

    /// True if the pair joins more than two links.
    pub fn is_compound(&self) -> bool {
        self.links.len() > 2
    }
}

impl Scheme {
    /// Builds the scheme of a specification.
    ///
    /// # Errors
    /// All defects of the specification.
    pub fn new(spec: &SchemeSpec) -> Result<Self, Vec<SchemeDefect>> {
        let mut defects = vec![];
        if spec.pairs.is_empty() {
            return Err(vec![SchemeDefect::NoPairs]);
        }
        let mut names = BTreeMap::new();
        for pair in &spec.pairs {
            let times: &mut usize = names.entry(pair.name.as_str()).or_default();
            *times += 1;
            if *times == 2 || (*times == 1 && pair.name.is_empty()) {
                defects.push(SchemeDefect::SamePair {
                    pair: pair.name.clone(),
                });
            }
        }
        let links = links(spec);
        let numbers = links.iter().enumerate();
        let numbers: BTreeMap<&str, usize> = numbers.map(|(at, link)| (*link, at)).collect();
        let mut pairs = vec![];
        let mut freedoms = vec![];
        for pair in &spec.pairs {
            joins(pair, &mut defects);
            let sound = directed(pair, spec.planar)
                .and_then(|pair| Ok((own_freedoms(&pair, spec.planar)?, pair)));
            match sound {
                Err(defect) => defects.push(defect),
                Ok((own, directed)) => {
                    freedoms.push(own);
                    pairs.push(Pair {
                        name: pair.name.clone(),
                        kind: pair.kind,
                        links: pair
                            .links
                            .iter()
                            .map(|link| numbers[link.as_str()])
                            .collect(),
                        place: pair.place,
                        axis: directed.axis,
                        second: directed.second,
                    });
                }
            }
        }
        let named = |pair: &PairSpec| pair.links.contains(&spec.ground);
        if spec.pairs.iter().any(named) {
            let apart = apart(spec, &numbers);
            if !apart.is_empty() {
                let names = apart.into_iter().map(|link| links[link].to_owned());
                defects.push(SchemeDefect::SchemeApart {
                    links: names.collect(),
                });
            }
        } else {
            defects.push(SchemeDefect::NoGround {
                link: spec.ground.clone(),
            });
        }
        if !defects.is_empty() {
            return Err(defects);
        }
        Ok(Self {
            planar: spec.planar,
            links: links.into_iter().map(str::to_owned).collect(),
            pairs,
            freedoms,
        })
    }

    /// True if all motion is in the plane.
    pub fn is_planar(&self) -> bool {
        self.planar
    }

    /// The names of the links; the first is the ground.
    pub fn links(&self) -> &[String] {
        &self.links
    }

    /// The pairs, in the order of the specification.
    pub fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// The name of a link.
    pub fn link_name(&self, link: usize) -> &str {
        &self.links[link]
    }

    /// Number of the link with a given name.
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.iter().position(|link| link == name)
    }

    /// Number of the pair with a given name.
    pub fn pair(&self, name: &str) -> Option<usize> {
        self.pairs.iter().position(|pair| pair.name == name)
    }

    /// Number of freedoms of a pair, i: in the plane for a planar scheme, otherwise in space.
    pub fn freedoms(&self, pair: usize) -> u8 {
        self.freedoms[pair]
    }

    /// Number of constraints of a pair, S: in the plane for a planar scheme, otherwise in space.
    pub fn constraints(&self, pair: usize) -> u8 {
        (if self.planar { 3 } else { 6 }) - self.freedoms[pair]
    }

    /// Numbers of the pairs on each link.
    pub(super) fn pairs_of(&self) -> Vec<Vec<usize>> {
        let mut pairs_of = vec![vec![]; self.links.len()];
        for (at, pair) in self.pairs.iter().enumerate() {
            for &link in &pair.links {
                pairs_of[link].push(at);
            }
        }
        pairs_of
    }

    pub(super) fn scale(&self) -> Scale {
        Scale::of(&self.pairs)
    }

    /// Kind, place and directions of a pair, with lengths in units of `scale`. None if the place or a direction is
    /// missing, or for a [`PairKind::Class`].
    pub(super) fn form(&self, pair: usize, scale: &Scale) -> Option<Form> {
        let pair = &self.pairs[pair];
        let kind = match pair.kind {
            PairKind::Class(_) => return None,
            PairKind::Screw { pitch } => PairKind::Screw {
                pitch: pitch / scale.size,
            },
            kind => kind,
        };
        let place = (pair.place?.coords - scale.centre) / scale.size;
        let axis = match pair.axis {
            None if !kind.has_axis() => Vector3::z(),
            axis => axis?,
        };
        let second = match pair.second {
            None if kind.has_second() => return None,
            second => second,
        };
        Some(Form::new(kind, place, axis, second))
    }

    /// Specification of the scheme, including directions that the original specification left to defaults.
    pub fn spec(&self) -> SchemeSpec {
        let pairs = self.pairs.iter().map(|pair| PairSpec {
            name: pair.name.clone(),
            kind: pair.kind,
            links: pair
                .links
                .iter()
                .map(|link| self.links[*link].clone())
                .collect(),
            place: pair.place,
            axis: pair.axis,
            second: pair.second,
        });
        SchemeSpec {
            ground: self.links[0].clone(),
            planar: self.planar,
            pairs: pairs.collect(),
        }
    }
}

/// Centre of the pairs and unit of length, chosen to reduce rounding errors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    pub(super) centre: Vector3,
    pub(super) size: f64,
}

impl Scale {
    fn of(pairs: &[Pair]) -> Self {
        let places = || pairs.iter().filter_map(|pair| pair.place);
        let count = places().count().max(1) as f64;
        let centre = places().map(|place| place.coords / count).sum::<Vector3>();
        let distances = places().map(|place| (place.coords - centre).norm());
        let pitches = pairs.iter().map(|pair| match pair.kind {
            PairKind::Screw { pitch } => pitch.abs(),
            _ => 0.0,
        });
        let size = distances.chain(pitches).fold(0.0, f64::max);
        // Without extent (all pairs at the same place, no screws) the size is 1, to avoid division by zero.
        let size = if size > 0.0 { size } else { 1.0 };
        Self { centre, size }
    }
}

/// The names of the links, the ground first.
fn links(spec: &SchemeSpec) -> Vec<&str> {
    let ground = spec.ground.as_str();
    let named = spec.pairs.iter().flat_map(|pair| &pair.links);
    let mut seen = BTreeSet::new();
    seen.insert(ground);
    let others = named.map(String::as_str).filter(|link| seen.insert(link));
    [ground].into_iter().chain(others).collect()
}

/// Checks the links of a pair and adds their defects.
fn joins(pair: &PairSpec, defects: &mut Vec<SchemeDefect>) {
    let mut seen = BTreeSet::new();
    let again = pair.links.iter().find(|link| !seen.insert(link.as_str()));
    if let Some(link) = again {
        let (pair, link) = (pair.name.clone(), link.clone());
        defects.push(SchemeDefect::PairWithItself { pair, link });
    } else if pair.links.len() < 2 || (pair.links.len() > 2 && !pair.kind.joins_many()) {
        let (pair, count) = (pair.name.clone(), pair.links.len());
        defects.push(SchemeDefect::LinksOfPair { pair, count });
    }
}

/// A pair with its given or default directions as unit vectors.
struct Directed<'a> {
    pair: &'a PairSpec,
    axis: Option<Vector3>,
    second: Option<Vector3>,
}

fn directed(pair: &PairSpec, planar: bool) -> Result<Directed<'_>, SchemeDefect> {
    let wrong = || SchemeDefect::PairGeometry {
        pair: pair.name.clone(),
    };
    let sound = |value: f64| value.is_finite() && value.abs() <= RANGE;
    let pitch = match pair.kind {
        PairKind::Screw { pitch } => sound(pitch) && pitch != 0.0,
        _ => true,
    };
    let place = pair
        .place
        .is_none_or(|place| place.iter().all(|value| sound(*value)));
    let given = [pair.axis, pair.second];
    let directions = given.iter().flatten().flatten();
    if !(pitch && place && directions.into_iter().all(|value| sound(*value))) {
        return Err(wrong());
    }
    let normal = (planar && pair.kind.turns_in_plane()).then(Vector3::z);
    let axis = match pair.axis {
        _ if !pair.kind.has_axis() => None,
        None => normal,
        Some(axis) => Some(unit(axis).ok_or_else(wrong)?),
    };
    let second = match (axis, pair.second) {
        _ if !pair.kind.has_second() => None,
        (None, second) => second
            .map(|second| unit(second).ok_or_else(wrong))
            .transpose()?,
        (Some(axis), Some(second)) => {
            let second = unit(second).ok_or_else(wrong)?;
            Some(unit_across(&axis, &second).ok_or_else(wrong)?)
        }
        (Some(axis), None) if planar => {
            let across = unit_across(&axis, &Vector3::z()).or(unit_across(&axis, &Vector3::y()));
            Some(across.ok_or_else(wrong)?)
        }
        (Some(_), None) => None,
    };
    Ok(Directed { pair, axis, second })
}

/// Unit vector of a direction; None for a zero vector.
fn unit(direction: Vector3) -> Option<Vector3> {
    // Scaled to a length of about 1 first, so that squares do not underflow.
    let longest = direction.amax();
    (longest > 0.0).then(|| (direction / longest).normalize())
}

/// Unit vector along the component of a direction perpendicular to an axis; None if that component vanishes.
fn unit_across(axis: &Vector3, direction: &Vector3) -> Option<Vector3> {
    let across = direction - axis * axis.dot(direction);
    (across.norm() > super::screw::ZERO).then(|| across.normalize())
}

/// Number of freedoms of a pair, in the plane or in space.
fn own_freedoms(directed: &Directed<'_>, planar: bool) -> Result<u8, SchemeDefect> {
    let pair = directed.pair;
    let freedoms = pair.kind.freedoms();
    if let PairKind::Class(_) = pair.kind {
        let most = if planar { 2 } else { 5 };
        return if (1..=most).contains(&freedoms) {
            Ok(freedoms)
        } else {
            let pair = pair.name.clone();
            Err(SchemeDefect::FreedomsOfPair { pair, freedoms })
        };
    }
    if !planar {
        return Ok(freedoms);
    }
    // Missing directions are chosen to suit the plane: directions of slides and normals of contacts lie in the plane.
    let axis = directed.axis.unwrap_or_else(Vector3::x);
    let second = directed
        .second
        .and_then(|second| unit_across(&axis, &second));
    let second = second
        .unwrap_or_else(|| unit_across(&axis, &Vector3::z()).unwrap_or_else(|| across(&axis)));
    let form = Form::new(pair.kind, Vector3::zeros(), axis, Some(second));
    match form.constraints_in_plane().len() {
        1 => Ok(2),
        2 => Ok(1),
        _ => Err(SchemeDefect::OutOfPlane {
            pair: pair.name.clone(),
        }),
    }
}

/// Numbers of the links that are not connected to the ground, which is number 0.
fn apart(spec: &SchemeSpec, numbers: &BTreeMap<&str, usize>) -> Vec<usize> {
    let mut parts = Partition::new(numbers.len());
    for pair in &spec.pairs {
        parts.join(pair.links.iter().map(|link| numbers[link.as_str()]));
    }
    let links = 0..numbers.len();
    links.filter(|link| !parts.joins(0, *link)).collect()
}
