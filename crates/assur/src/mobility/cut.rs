//! Cuts of pairs: names, an automatic choice, and errors.

use super::Scheme;
use crate::sorting::sort;

/// A link detached from a pair. If the pair joins two links, detaching either link removes the pair; a compound hinge
/// loses one link at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cut {
    /// Index of the pair.
    pub pair: usize,
    /// Index of the detached link.
    pub link: usize,
}

/// Reasons why cuts do not open a scheme into a chain joined to the ground.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "code", rename_all = "snake_case")
)]
#[expect(
    missing_docs,
    reason = "parameters are named by the variant's sentence"
)]
pub enum CutError {
    /// No pair has this name.
    NoSuchPair { pair: String },
    /// The pair does not have this link.
    NotOfPair { pair: String, link: String },
    /// More than two links meet in this pair, so the detached link must be named.
    WhichLink { pair: String },
    /// This cut was made before, or the pair has only one link left.
    CutTwice { pair: String },
    /// A contour is still closed; the pairs of the shortest one are listed in order.
    StillClosed { pairs: Vec<String> },
    /// These links are disconnected from the ground.
    CutOff { links: Vec<String> },
}

impl Scheme {
    /// Cut with a given name: the name of a pair, or the names of a compound hinge and a link, as in `Q:3`.
    ///
    /// # Errors
    /// The scheme has no such pair, the pair has no such link, or a compound hinge is named without a link.
    pub fn cut_named(&self, name: &str) -> Result<Cut, CutError> {
        if let Some(pair) = self.pair(name) {
            let joined = &self.pairs()[pair];
            return match joined.links[..] {
                [_, link] => Ok(Cut { pair, link }),
                _ => Err(CutError::WhichLink {
                    pair: name.to_owned(),
                }),
            };
        }
        let no_pair = || CutError::NoSuchPair {
            pair: name.to_owned(),
        };
        let (pair_name, link_name) = name.rsplit_once(':').ok_or_else(no_pair)?;
        let pair = self.pair(pair_name).ok_or_else(no_pair)?;
        let has = |link: &usize| self.pairs()[pair].links.contains(link);
        let link = self.link(link_name).filter(has);
        let link = link.ok_or_else(|| CutError::NotOfPair {
            pair: pair_name.to_owned(),
            link: link_name.to_owned(),
        })?;
        Ok(Cut { pair, link })
    }

    /// The name of a cut, as read by [`Scheme::cut_named`].
    pub fn cut_name(&self, cut: Cut) -> String {
        let pair = &self.pairs()[cut.pair];
        if pair.is_compound() {
            format!("{}:{}", pair.name, self.link_name(cut.link))
        } else {
            pair.name.clone()
        }
    }

    /// Cuts that open every contour. A depth-first search from the ground cuts each pair that leads to a visited link.
    pub fn automatic(&self) -> Vec<Cut> {
        let pairs_of = self.pairs_of();
        let mut been = vec![false; self.links().len()];
        let mut passed = vec![false; self.pairs().len()];
        let mut cuts = vec![];
        // The current path of links and pairs, each with the index of the next element to try.
        let mut way = vec![Stop::Link(0, 0)];
        been[0] = true;
        while let Some(stop) = way.last_mut() {
            match stop {
                Stop::Link(link, next) => match pairs_of[*link].get(*next) {
                    None => {
                        way.pop();
                    }
                    Some(&pair) => {
                        *next += 1;
                        if !passed[pair] {
                            passed[pair] = true;
                            let from = *link;
                            way.push(Stop::Pair {
                                pair,
                                from,
                                next: 0,
                            });
                        }
                    }
                },
                Stop::Pair { pair, from, next } => match self.pairs()[*pair].links.get(*next) {
                    None => {
                        way.pop();
                    }
                    Some(&link) => {
                        *next += 1;
                        if link == *from {
                            continue;
                        }
                        if been[link] {
                            cuts.push(Cut { pair: *pair, link });
                        } else {
                            been[link] = true;
                            way.push(Stop::Link(link, 0));
                        }
                    }
                },
            }
        }
        sort(&mut cuts);
        cuts
    }
}

/// An element of the path in [`Scheme::automatic`].
enum Stop {
    /// A link, and the index of its next pair.
    Link(usize, usize),
    /// A pair, the link from which it was entered, and the index of its next link.
    Pair {
        pair: usize,
        from: usize,
        next: usize,
    },
}
