//! Assessment of a linkage of two dyads: circuit, branch and order of the poses, transmission.

use super::Linkage;
use super::driven::Driven;
use super::dyad::Dyad;
use super::task::{Task, complex};
use crate::synthesis::four_bar::{self, Direction, Met, Order, Passage, Proportions};
use crate::tolerance::DISTINCT;
use crate::{Grashof, Invalid};

/// Type of a linkage of two dyads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mechanism {
    /// RR and RR.
    FourBar(Grashof),
    /// RR and PR.
    SliderCrank,
    /// RR and RP: the inverted slider-crank.
    Inversion,
    /// PR and PR: the elliptic trammel.
    DoubleSlider,
    /// PR and RP.
    SliderBlock,
    /// RP and RP: the inversion of the elliptic trammel, as in Oldham's coupling.
    DoubleBlock,
}

/// Properties of a linkage that is to guide a body through poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// Type of the linkage.
    pub mechanism: Mechanism,
    /// Passage through all poses, driven by the first dyad.
    pub passage: Passage,
    /// Order in which the poses are met. Repeated poses count once.
    pub order: Order,
    /// True if the link or block of the first dyad turns fully.
    pub turns: bool,
    /// Minimum transmission angle of the motion from the first pose to the last, 0 … π/2; none if the linkage does not
    /// pass through all of them. For a slider on the frame it is the angle between the coupler and the normal of the
    /// line; for a block, the angle between the line from hinge to pivot and the normal of the body's line.
    pub transmission: Option<f64>,
    /// Ratio of the greatest to the least length of the links, the frame included. A slider has no length; the frame of
    /// a linkage with a slider on it has none either.
    pub size_ratio: f64,
}

/// Reasons why two dyads form no linkage that guides the body.
#[derive(Clone, Debug, PartialEq)]
pub enum LinkageError {
    /// These lengths of crank, coupler, rocker and frame are no four-bar.
    Lengths(Vec<Invalid>),
    /// Both dyads slide in the same direction, or share a hinge: the body is not determined by the input.
    Parallel,
}

impl Mechanism {
    /// Name of the type in files and program output.
    pub fn code(self) -> &'static str {
        match self {
            Self::FourBar(_) => "four_bar",
            Self::SliderCrank => "slider_crank",
            Self::Inversion => "inverted_slider_crank",
            Self::DoubleSlider => "double_slider",
            Self::SliderBlock => "slider_block",
            Self::DoubleBlock => "double_block",
        }
    }
}

/// The verdict on a linkage driven by its first dyad.
///
/// # Errors
/// The reason why the dyads form no linkage.
pub(super) fn verdict(task: &Task, dyads: [Dyad; 2]) -> Result<Verdict, LinkageError> {
    match dyads {
        [
            Dyad::Hinges { pivot: a, point: b },
            Dyad::Hinges { pivot: d, point: c },
        ] => {
            let frame = d - a;
            let length = frame.norm();
            let proportions = Proportions {
                input: (b - a).norm() / length,
                coupler: (c - b).norm() / length,
                output: (c - d).norm() / length,
            };
            let base = complex(frame).conj() / length;
            let directions = task.distinct().iter().map(|&k| {
                let input = complex((task.carried(b, k) - a).normalize()) * base;
                let output = complex((d - task.carried(c, k)).normalize()) * base;
                Direction {
                    output,
                    input,
                    input_angle: input.arg(),
                }
            });
            let directions: Vec<Direction> = directions.collect();
            let found = four_bar::verdict(proportions, &directions);
            let found = found.map_err(LinkageError::Lengths)?;
            Ok(Verdict {
                mechanism: Mechanism::FourBar(found.grashof),
                passage: found.passage,
                order: found.order,
                turns: found.turns,
                transmission: found.transmission_between,
                size_ratio: found.size_ratio,
            })
        }
        _ => sliding(task, dyads),
    }
}

/// The verdict on a linkage with a slider or a block.
fn sliding(task: &Task, dyads: [Dyad; 2]) -> Result<Verdict, LinkageError> {
    let driven = Driven::new(dyads, task.unit()).map_err(|_| LinkageError::Parallel)?;
    let turns = driven.is_free && driven.period().is_some();
    let mut met = Met::new(driven.period().filter(|_| driven.is_free));
    let (mut passage, mut start): (_, Option<(usize, f64)>) = (Passage::Continuous, None);
    for &k in task.distinct() {
        let Some((arc, input)) = within(&driven, driven.input(task, k)) else {
            passage = Passage::Unreached(k);
            break;
        };
        let side = driven.side(task, k).signum() * f64::from(u8::from(driven.side(task, k) != 0.0));
        let (first_arc, first_side) = *start.get_or_insert((arc, side));
        if first_side == 0.0 {
            start = Some((first_arc, side));
        }
        let apart = side * first_side < 0.0;
        let next = match (first_arc != arc, apart, driven.is_free) {
            (true, ..) | (_, true, true) => Passage::OtherCircuit,
            (_, true, false) => Passage::AcrossDeadPoint,
            (_, false, _) => Passage::Continuous,
        };
        if passage == Passage::Continuous || next == Passage::OtherCircuit {
            passage = next;
        }
        met.next(input);
    }
    let continuous = passage == Passage::Continuous;
    Ok(Verdict {
        mechanism: mechanism(&dyads),
        passage,
        order: if continuous {
            met.order()
        } else {
            Order::Mixed
        },
        turns,
        transmission: continuous.then(|| driven.least_transmission(met.span())),
        size_ratio: Linkage::lengths_of(&dyads).map_or(1.0, |[least, most]| most / least),
    })
}

/// Index of the arc that contains an input, and the input shifted by whole turns into this arc.
fn within(driven: &Driven, input: f64) -> Option<(usize, f64)> {
    let period = driven.period();
    for (index, [from, to]) in driven.arcs.iter().enumerate() {
        let turns = period.map_or(0.0, |turn| turn * ((from - DISTINCT - input) / turn).ceil());
        let input = input + turns;
        let scale = if period.is_some() {
            1.0
        } else {
            1.0 + input.abs()
        };
        if (from - DISTINCT * scale..=to + DISTINCT * scale).contains(&input) {
            return Some((index, input.clamp(*from, *to)));
        }
    }
    None
}

fn mechanism(dyads: &[Dyad; 2]) -> Mechanism {
    match dyads {
        [Dyad::Hinges { .. }, Dyad::Block { .. }] => Mechanism::Inversion,
        [Dyad::Slider { .. }, Dyad::Slider { .. }] => Mechanism::DoubleSlider,
        [Dyad::Slider { .. }, Dyad::Block { .. }] => Mechanism::SliderBlock,
        [Dyad::Block { .. }, _] => Mechanism::DoubleBlock,
        _ => Mechanism::SliderCrank,
    }
}
