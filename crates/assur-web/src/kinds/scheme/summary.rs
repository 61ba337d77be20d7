//! Summary of a scheme: its counts, the result of its cuts, and the result of its geometry.

use std::collections::BTreeMap;

use assur::mobility::{Cut, CutError, Generic, NoRank, RankReport, Replacement, Sections, Space};
use assur_file::KindDocument;
use serde::Serialize;

use super::Scheme;
use crate::summary::HandleSummary;

/// Maximum number of replacements of pairs in the summary.
pub(crate) const MENDED: usize = 200;

/// Maximum number of pairs in a scheme for which a nearby pose is sought.
const FOLLOWED: usize = 60;

/// Summary of a scheme. W and q are counted in the scheme's own space: in the plane, if it is planar.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SchemeSummary<'a> {
    /// Always null: a scheme has no motion.
    #[cfg_attr(test, ts(type = "null"))]
    moves: Option<&'static str>,
    bounds: [f64; 4],
    handles: Vec<HandleSummary<'a>>,
    roles: BTreeMap<&'a str, &'static str>,
    planar: bool,
    /// Names of the links, the ground first.
    links: Vec<&'a str>,
    pairs: Vec<PairSummary<'a>>,
    counts: CountSummary,
    mobility: isize,
    redundant: isize,
    /// Redundant constraints q by equation (6) of the mobility paper, if it applies.
    redundant_by_plane: Option<isize>,
    /// The result of the cuts, if they open every contour.
    sections: Option<SectionsSummary<'a>>,
    /// The pairs of a contour that is still closed after the cuts.
    closed: &'a [String],
    /// Links that the cuts disconnect.
    apart: &'a [String],
    /// Names of automatically chosen cuts that open every contour.
    automatic: Vec<String>,
    plane: Option<JudgedSummary<'a>>,
    space: Option<JudgedSummary<'a>>,
    /// The first pair that lacks data needed for the rank.
    missing: Option<String>,
    mended: Option<MendedSummary<'a>>,
}

/// A pair. `freedoms` and `constraints` are those in the scheme's own space.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct PairSummary<'a> {
    name: &'a str,
    freedoms: u8,
    constraints: u8,
    spatial_freedoms: u8,
    /// Names of the possible cuts of this pair: one cut, or one for each link of a compound hinge.
    cuts: Vec<String>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CountSummary {
    /// Number of moving links, n.
    links: usize,
    /// Numbers Pᵢ of pairs with i freedoms, in the scheme's own space.
    pairs: Vec<ClassSummary>,
    /// Numbers Pᵢ of pairs with i freedoms, in three-dimensional space.
    spatial_pairs: Vec<ClassSummary>,
    planar: Option<isize>,
    spatial: isize,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ClassSummary {
    freedoms: u8,
    count: usize,
}

/// Counts of the open chain, after the cuts.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SectionsSummary<'a> {
    cuts: Vec<String>,
    /// Numbers Pᵢ of remaining pairs with i freedoms.
    left: Vec<ClassSummary>,
    open: usize,
    removed: usize,
    open_spatial: usize,
    removed_spatial: usize,
    mobility: isize,
    redundant: isize,
    by_loops: isize,
    loops: Vec<LoopSummary<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LoopSummary<'a> {
    cut: String,
    pairs: Vec<&'a str>,
    constraints: u8,
    spatial_constraints: u8,
    motion_space: u8,
    redundant: u8,
}

/// Mobility by the rank of the constraints, in the plane or in space.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct JudgedSummary<'a> {
    mobility: usize,
    rank: usize,
    redundant: usize,
    redundancies: Vec<RedundancySummary<'a>>,
    idle: Vec<Vec<&'a str>>,
    /// W in a nearby pose, if one was found; also 0 if W is 0 in the drawn pose.
    generic: Option<usize>,
    /// Whether the scheme moves only for an instant: by rank W is not 0, but no nearby pose was reached.
    instantaneous: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RedundancySummary<'a> {
    count: usize,
    pairs: Vec<&'a str>,
}

/// Replacements of pairs that remove redundant constraints.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MendedSummary<'a> {
    list: Vec<Vec<ChangedPair<'a>>>,
    complete: bool,
}

#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ChangedPair<'a> {
    pair: &'a str,
    #[cfg_attr(test, ts(type = "KindDocument"))]
    kind: KindDocument,
}

impl<'a> SchemeSummary<'a> {
    pub(crate) fn new(of: &'a Scheme) -> Self {
        let Scheme {
            document,
            scheme,
            sections,
            figure,
            handles,
            ..
        } = of;
        let counts = scheme.counts();
        let handles = handles.iter().map(|handle| HandleSummary {
            name: &handle.name,
            role: handle.role.name(),
            pressed: true,
        });
        let links = scheme.links().iter().enumerate();
        let roles = links.map(|(link, name)| (name.as_str(), figure.role(link).name()));
        let (closed, apart): (&[String], &[String]) = match sections {
            Err(CutError::StillClosed { pairs }) => (pairs, &[]),
            Err(CutError::CutOff { links }) => (&[], links),
            Ok(_) | Err(_) => (&[], &[]),
        };
        let automatic = scheme.automatic().into_iter();
        let rank_report = |space: Space| JudgedSummary::new(scheme, space);
        let plane = scheme.is_planar().then(|| rank_report(Space::Plane).ok());
        let space = rank_report(Space::Whole);
        let missing = space.as_ref().err().and_then(lacking);
        let mended = scheme.replacements(MENDED).ok();
        Self {
            moves: None,
            bounds: figure.bounds(),
            handles: handles.collect(),
            roles: roles.collect(),
            planar: document.planar,
            links: scheme.links().iter().map(String::as_str).collect(),
            pairs: PairSummary::all(scheme),
            mobility: counts.mobility(),
            redundant: counts.redundant(counts.mobility()),
            redundant_by_plane: counts.redundant_by_plane(),
            counts: CountSummary {
                links: counts.links,
                pairs: ClassSummary::all(&counts.pairs),
                spatial_pairs: ClassSummary::all(&counts.spatial_pairs),
                planar: counts.planar,
                spatial: counts.spatial,
            },
            sections: sections
                .as_ref()
                .ok()
                .map(|open| SectionsSummary::new(scheme, open)),
            closed,
            apart,
            automatic: automatic.map(|cut| scheme.cut_name(cut)).collect(),
            plane: plane.flatten(),
            space: space.ok(),
            missing,
            mended: mended.map(|mended| MendedSummary {
                complete: mended.complete,
                list: mended
                    .list
                    .iter()
                    .map(|one| ChangedPair::all(scheme, one))
                    .collect(),
            }),
        }
    }
}

/// The pair whose missing data are the reason why there is no rank; none if there is another reason.
fn lacking(why: &NoRank) -> Option<String> {
    match why {
        NoRank::NoPlace(pair) | NoRank::NoAxis(pair) | NoRank::NoForm(pair) => Some(pair.clone()),
        NoRank::NotPlanar => None,
    }
}

fn named<'a>(scheme: &'a assur::mobility::Scheme, pairs: &[usize]) -> Vec<&'a str> {
    let pairs = pairs.iter().map(|pair| scheme.pairs()[*pair].name.as_str());
    pairs.collect()
}

impl<'a> PairSummary<'a> {
    fn all(scheme: &'a assur::mobility::Scheme) -> Vec<Self> {
        let pairs = scheme.pairs().iter().enumerate();
        let summed = pairs.map(|(index, pair)| {
            let several = if pair.is_compound() {
                &pair.links[..]
            } else {
                &pair.links[1..]
            };
            let cuts = several.iter().map(|link| {
                scheme.cut_name(Cut {
                    pair: index,
                    link: *link,
                })
            });
            Self {
                name: &pair.name,
                freedoms: scheme.freedoms(index),
                constraints: scheme.constraints(index),
                spatial_freedoms: pair.kind.freedoms(),
                cuts: cuts.collect(),
            }
        });
        summed.collect()
    }
}

impl ClassSummary {
    fn all(counts: &BTreeMap<u8, usize>) -> Vec<Self> {
        let counts = counts.iter();
        let classes = counts.map(|(freedoms, count)| Self {
            freedoms: *freedoms,
            count: *count,
        });
        classes.collect()
    }
}

impl<'a> SectionsSummary<'a> {
    fn new(scheme: &'a assur::mobility::Scheme, open: &Sections) -> Self {
        let loops = open.loops.iter().map(|closed| LoopSummary {
            cut: scheme.cut_name(closed.cut),
            pairs: named(scheme, &closed.pairs),
            constraints: closed.constraints,
            spatial_constraints: closed.spatial_constraints,
            motion_space: closed.motion_space,
            redundant: closed.redundant,
        });
        Self {
            cuts: open.cuts.iter().map(|cut| scheme.cut_name(*cut)).collect(),
            left: ClassSummary::all(&open.left),
            open: open.open,
            removed: open.removed,
            open_spatial: open.open_spatial,
            removed_spatial: open.removed_spatial,
            mobility: open.mobility,
            redundant: open.redundant,
            by_loops: open.by_loops(),
            loops: loops.collect(),
        }
    }
}

impl<'a> JudgedSummary<'a> {
    fn new(scheme: &'a assur::mobility::Scheme, space: Space) -> Result<Self, NoRank> {
        let RankReport {
            mobility,
            rank,
            redundancies,
            idle,
        } = scheme.rank_report(space)?;
        // For a scheme with more pairs, the search for a nearby pose may take longer than a drag allows.
        let near = (scheme.pairs().len() <= FOLLOWED).then(|| scheme.generic(space));
        let generic = near.transpose()?;
        let links = |links: &Vec<usize>| {
            let links = links.iter().map(|link| scheme.link_name(*link));
            links.collect()
        };
        let borne = redundancies.iter().map(|one| RedundancySummary {
            count: one.count,
            pairs: named(scheme, &one.pairs),
        });
        Ok(Self {
            mobility,
            rank,
            redundant: redundancies.iter().map(|one| one.count).sum(),
            redundancies: borne.collect(),
            idle: idle.iter().map(links).collect(),
            generic: match generic {
                Some(Generic::At { mobility }) => Some(mobility),
                Some(Generic::Instantaneous | Generic::Contact { .. }) | None => None,
            },
            instantaneous: mobility > 0 && generic == Some(Generic::Instantaneous),
        })
    }
}

impl<'a> ChangedPair<'a> {
    fn all(scheme: &'a assur::mobility::Scheme, replacement: &Replacement) -> Vec<Self> {
        let changes = replacement.changes.iter();
        let changed = changes.map(|change| Self {
            pair: &scheme.pairs()[change.pair].name,
            kind: KindDocument::from(change.kind),
        });
        changed.collect()
    }
}
