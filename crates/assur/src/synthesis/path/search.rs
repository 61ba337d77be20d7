//! The search for all coupler curves through nine points, by paths that are divided among workers.

use super::alt::{Displacements, Dyads};
use super::certificate::{Certificate, certified};
use super::curve::{Distinct, smallest};
use super::start::Start;
use super::task::NinePoints;
use super::tracker::{CAREFUL, Ending, USUAL, Way, track};
use super::wide::Wide;
use super::{C, CURVES};

/// Maximum number of ways from the start data to the points.
const MAX_WAYS: usize = 3;

/// The paths of one way that are to be followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// Number of the way from the start data to the points, from 0.
    pub way: usize,
    /// True for paths that are followed with shorter steps.
    pub careful: bool,
    /// Indices of the paths.
    pub paths: Vec<usize>,
}

/// Paths from the start data to nine points, on one way. A worker makes a homotopy from the start data and a [`Work`].
pub struct Homotopy<'a> {
    start: &'a Start,
    way: Way,
    turns: [C; 2],
    careful: bool,
    target: Displacements<Wide>,
}

/// End of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Index of the path.
    pub path: usize,
    pub(super) ending: Ending,
    pub(super) certificate: Option<Certificate>,
}

impl End {
    /// True if the path ended in a solution that is proved.
    pub fn is_proved(&self) -> bool {
        self.certificate.is_some()
    }

    /// Length of the list by [`Self::numbers`].
    pub const NUMBERS: usize = 21;

    /// The end as a list of numbers, which a worker can send.
    pub fn numbers(&self) -> [f64; Self::NUMBERS] {
        let mut numbers = [0.0; Self::NUMBERS];
        numbers[0] = self.path as f64;
        match self.ending {
            Ending::Lost => {}
            Ending::Singular => numbers[1] = 1.0,
            Ending::Solution(at) => {
                numbers[1] = 2.0;
                for (pair, z) in numbers[2..18].as_chunks_mut().0.iter_mut().zip(at) {
                    *pair = [z.re, z.im];
                }
            }
        }
        if let Some(certificate) = &self.certificate {
            numbers[18] = certificate.error;
            numbers[19] = certificate.alone;
            numbers[20] = certificate
                .real
                .map_or(0.0, |real| if real { 1.0 } else { -1.0 });
        }
        numbers
    }

    /// The end from its list of numbers.
    pub fn from_numbers(numbers: &[f64; Self::NUMBERS]) -> Self {
        let [path, ending, .., error, alone, real] = *numbers;
        Self {
            path: path as usize,
            ending: match ending {
                2.0 => Ending::Solution(
                    [0, 1, 2, 3, 4, 5, 6, 7]
                        .map(|k| C::new(numbers[2 + 2 * k], numbers[3 + 2 * k])),
                ),
                1.0 => Ending::Singular,
                _ => Ending::Lost,
            },
            certificate: (alone > 0.0).then(|| Certificate {
                error,
                alone,
                real: (real != 0.0).then_some(real > 0.0),
            }),
        }
    }
}

impl<'a> Homotopy<'a> {
    /// Homotopy with the paths of a [`Work`].
    pub fn new(start: &'a Start, points: &NinePoints, work: &Work) -> Self {
        // If displacements and conjugates are rotated independently, the solutions rotate with them. This gives another
        // generic start for each way.
        let turn = |k: usize| C::from_polar(1.0, 0.7 + 2.399_963 * (2 * work.way + k) as f64);
        let turns = [turn(0), turn(1)];
        let Displacements { forward, backward } = start.displacements;
        let from = Displacements {
            forward: forward.map(|z| z * turns[0]),
            backward: backward.map(|z| z * turns[1]),
        };
        let target = points.displacements();
        Self {
            start,
            way: Way::new(from, &target.map(|wide| wide.rounded())),
            turns,
            careful: work.careful,
            target,
        }
    }

    /// Follows one path to its end; none if there is no such path.
    pub fn track(&self, path: usize) -> Option<End> {
        let start = self.start.dyads.get(path)?;
        let from = std::array::from_fn(|k| start[k] * self.turns[k / 4]);
        let mut ending = Ending::Lost;
        if !self.careful {
            ending = track(&from, &self.way, USUAL);
        }
        if ending == Ending::Lost {
            ending = track(&from, &self.way, CAREFUL);
        }
        let mut certificate = None;
        if let Ending::Solution(at) = &mut ending
            && let Some((better, proof)) = certified(&smallest(at), &self.target)
        {
            *at = better;
            certificate = Some(proof);
        }
        Some(End {
            path,
            ending,
            certificate,
        })
    }
}

/// A coupler curve through nine points, real or complex, by one of its four-bars.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    pub(super) at: Dyads,
    pub(super) certificate: Option<Certificate>,
    /// Numbers of the way and of the path.
    found: [usize; 2],
}

/// The curves found so far.
#[derive(Clone, Debug)]
pub struct Search {
    points: NinePoints,
    curves: Vec<Curve>,
    distinct: Distinct,
    /// The last work given out; `left` is the number of its paths that have not ended.
    work: Work,
    left: usize,
    given: bool,
    lost: usize,
    /// Paths that ended in one curve with another path of the same way, and these other paths.
    doubled: Vec<usize>,
}

impl Search {
    /// A search in which nothing is found yet.
    pub fn new(points: NinePoints) -> Self {
        Self {
            points,
            curves: Vec::new(),
            distinct: Distinct::default(),
            work: Work {
                way: 0,
                careful: false,
                paths: (0..CURVES).collect(),
            },
            left: CURVES,
            given: false,
            lost: 0,
            doubled: Vec::new(),
        }
    }

    /// The nine points.
    pub fn points(&self) -> &NinePoints {
        &self.points
    }

    /// The paths to be followed next. None if paths of the last work have not ended, and at the end of the search.
    pub fn work(&mut self) -> Option<Work> {
        if self.given && !self.is_next() {
            return None;
        }
        self.given = true;
        Some(self.work.clone())
    }

    /// Prepares the next work after the last; false if there is none.
    fn is_next(&mut self) -> bool {
        if self.left > 0 || self.curves.len() >= CURVES {
            return false;
        }
        let mut doubled = std::mem::take(&mut self.doubled);
        let lost = std::mem::take(&mut self.lost);
        if !self.work.careful && !doubled.is_empty() {
            doubled.sort_unstable();
            doubled.dedup();
            self.work.paths = doubled;
            self.work.careful = true;
            // Lost paths are not followed again in this work, so their number stays.
            self.lost = lost;
        } else if (lost > 0 || !doubled.is_empty()) && self.work.way + 1 < MAX_WAYS {
            self.work = Work {
                way: self.work.way + 1,
                careful: false,
                paths: (0..CURVES).collect(),
            };
        } else {
            return false;
        }
        self.left = self.work.paths.len();
        true
    }

    /// Adds the end of a path of the last work.
    pub fn add(&mut self, end: End) {
        self.left = self.left.saturating_sub(1);
        match end.ending {
            Ending::Lost => self.lost += 1,
            Ending::Singular => {}
            Ending::Solution(at) => {
                let curve = Curve {
                    at,
                    certificate: end.certificate,
                    found: [self.work.way, end.path],
                };
                let Some(known) = self.distinct.add(&at, self.curves.len()) else {
                    self.curves.push(curve);
                    return;
                };
                let known = &mut self.curves[known];
                known.certificate = known.certificate.or(end.certificate);
                let [way, path] = known.found;
                if way == self.work.way && path != end.path {
                    self.doubled.extend([path, end.path]);
                }
            }
        }
    }

    /// Follows paths of the search one by one until it ends, or until `go_on` is false.
    pub fn run(&mut self, start: &Start, mut go_on: impl FnMut(&Self) -> bool) {
        while let Some(work) = self.work() {
            let homotopy = Homotopy::new(start, &self.points, &work);
            for end in work.paths.iter().filter_map(|path| homotopy.track(*path)) {
                self.add(end);
                if !go_on(self) {
                    return;
                }
            }
        }
    }

    /// The curves with all their coordinates, real and complex.
    pub(super) fn curves(&self) -> &[Curve] {
        &self.curves
    }

    /// Number of different curves found and proved.
    pub fn count(&self) -> usize {
        let proved = |curve: &&Curve| curve.certificate.is_some();
        self.curves.iter().filter(proved).count()
    }

    /// Number of different curves found that double precision cannot prove.
    pub fn unproved(&self) -> usize {
        self.curves.len() - self.count()
    }

    /// Number of paths of the last work whose end is not known yet.
    pub fn left(&self) -> usize {
        self.left
    }

    /// True if all 1,442 curves are found and proved.
    pub fn is_complete(&self) -> bool {
        self.count() == CURVES
    }
}
