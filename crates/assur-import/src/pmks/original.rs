//! URLs of the first PMKS (Silverlight, <https://designengrlab.github.io/PMKS>):
//! `?set=s50&mech=ground,input,R,0,0,0,tfft|…`. A URL lists only joints. A joint has the names of its links, a kind (R,
//! P, RP), coordinates, the direction of its slide in degrees, and four letters. The letters state whether the joint's
//! position, velocity and acceleration are shown and whether it is driven. The first link of a sliding pair has the
//! slot, the second the block or pin.

use std::f64::consts::TAU;

use assur::mechanism::FARTHEST;

use super::decoded;
use crate::sketch::{Body, Driver, Joint, Moves, Sketch, letter};
use crate::{ImportProblem, LeftOut};

/// Name of the parameter that lists the joints.
const JOINTS: &str = "mech";
/// Names of the ground other than those that begin with [`GROUND`].
const GROUNDS: [&str; 6] = ["0", "gnd", "grnd", "grond", "gound", "groud"];
const GROUND: &str = "ground";

/// Kind of a joint between the teeth of two wheels. A joint of this kind is refused, because it gives neither the
/// wheels' centres nor the carrier.
const GEARS: &str = "G";

/// The kinds of joints that are read.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Hinge,
    Slide,
    PinInSlot,
}

/// Fields of a joint, as written in the URL.
#[derive(Debug)]
struct Row<'a> {
    links: Vec<&'a str>,
    kind: Kind,
    at: [f64; 2],
    /// The direction of a slide, radians.
    direction: f64,
    shown: bool,
    driven: bool,
}

pub(super) fn begins(query: &str) -> bool {
    parameter(query, JOINTS).is_some()
}

fn parameter<'a>(query: &'a str, name: &str) -> Option<&'a str> {
    let mut all = query.split('&');
    all.find_map(|one| one.strip_prefix(name)?.strip_prefix('='))
}

/// Reads the mechanism that a query describes.
///
/// # Errors
/// A joint that cannot be read, such as a mesh of gears; an invalid speed; too many parts.
pub(super) fn sketch(query: &str, source: String) -> Result<Sketch, ImportProblem> {
    let joints = decoded(parameter(query, JOINTS).unwrap_or_default(), b"");
    let lines = joints
        .split(['|', '\n'])
        .filter(|line| !line.trim().is_empty());
    let lines: Vec<&str> = lines.collect();
    crate::bounded(lines.len())?;
    let rows = lines.iter().enumerate();
    let rows = rows.map(|(number, line)| row(&letter(number), line));
    let rows: Vec<Row<'_>> = rows.collect::<Result<_, _>>()?;
    crate::bounded(rows.iter().map(|row| row.links.len()).sum())?;
    let mut reading = Reading {
        sketch: Sketch {
            source,
            ..Sketch::default()
        },
        links: Vec::new(),
        size: 0.0,
    };
    reading.joints(&rows);
    let slides = reading.pairs(&rows);
    let settings = decoded(parameter(query, "set").unwrap_or_default(), b"");
    let speed = settings.split('|').find_map(|one| one.strip_prefix('s'));
    let rpm = match speed {
        Some(told) => {
            let value = crate::number(told).filter(|rpm| rpm.abs() <= FARTHEST);
            value.ok_or_else(|| ImportProblem::number("set", told))?
        }
        None => 0.0,
    };
    reading.drive(&rows, &slides, rpm);
    if parameter(query, "ts").is_some_and(|shape| !shape.is_empty()) {
        reading.sketch.left_out.push(LeftOut::Drawn { parts: 1 });
    }
    Ok(reading.sketch)
}

/// Reads one joint: `link,link,…,kind,x,y[,direction][,letters]`, separated by commas or blanks.
fn row<'a>(name: &str, line: &'a str) -> Result<Row<'a>, ImportProblem> {
    let broken = || ImportProblem::part(line.trim());
    let words = line.split([',', ' ']).map(str::trim);
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let kind = |word: &&str| match word.to_ascii_uppercase().as_str() {
        "R" => Some(Kind::Hinge),
        "P" => Some(Kind::Slide),
        "RP" => Some(Kind::PinInSlot),
        _ => None,
    };
    let gears = |word: &&str| word.eq_ignore_ascii_case(GEARS);
    // The last word that names a kind is the kind: a link may also be called R.
    let at = words
        .iter()
        .rposition(|word| gears(word) || kind(word).is_some());
    let (links, rest) = words.split_at(at.ok_or_else(broken)?);
    let [kind_of, x, y, rest @ ..] = rest else {
        return Err(broken());
    };
    if gears(kind_of) {
        return Err(ImportProblem::gears(line.trim()));
    }
    let number = |text: &str| {
        let value = crate::number(text).filter(|x| x.abs() <= FARTHEST);
        value.ok_or_else(|| ImportProblem::number(name, text))
    };
    let (degrees, rest) = match rest {
        [first, rest @ ..] if crate::number(first).is_some() => (number(first)?, rest),
        rest => (0.0, rest),
    };
    let flags = flags(rest).ok_or_else(broken)?;
    let row = Row {
        links: links.to_vec(),
        kind: kind(kind_of).ok_or_else(broken)?,
        at: [number(x)?, number(y)?],
        direction: degrees.to_radians(),
        shown: flags[0],
        driven: flags[3],
    };
    let fits = match (row.kind, row.links.len()) {
        (_, 0) => false,
        // A joint of a single link is a point of that link.
        (_, 1) | (Kind::Hinge | Kind::PinInSlot, _) => true,
        (Kind::Slide, links) => links == 2,
    };
    if fits { Ok(row) } else { Err(broken()) }
}

/// Reads the flags for position, velocity, acceleration and driving: as letters, `tfff` or `+---`, or as words.
fn flags(words: &[&str]) -> Option<[bool; 4]> {
    let letters = |word: &str| word.chars().map(|letter| letter.to_string()).collect();
    let told: Vec<String> = match words {
        [letters_of] if letters_of.len() <= 4 => letters(letters_of),
        words => words.iter().map(|word| (*word).to_owned()).collect(),
    };
    let mut flags = [false; 4];
    if told.len() > flags.len() {
        return None;
    }
    for (flag, word) in flags.iter_mut().zip(told) {
        *flag = match word.to_ascii_lowercase().as_str() {
            "t" | "+" | "true" => true,
            "f" | "-" | "false" => false,
            _ => return None,
        };
    }
    Some(flags)
}

fn is_ground(link: &str) -> bool {
    let link = link.to_ascii_lowercase();
    link.starts_with(GROUND) || GROUNDS.contains(&link.as_str())
}

/// A mechanism that is being read.
struct Reading<'a> {
    sketch: Sketch,
    /// Name of the link from which each bar is made.
    links: Vec<&'a str>,
    /// Size of the drawing, as [`Sketch::size`] defines it.
    size: f64,
}

impl<'a> Reading<'a> {
    /// The body of a link, added if it is new.
    fn body(&mut self, link: &'a str) -> Body {
        if is_ground(link) {
            return Body::Frame;
        }
        let known = self.links.iter().position(|known| *known == link);
        Body::Bar(known.unwrap_or_else(|| {
            self.links.push(link);
            self.sketch.bar(crate::quoted(link), Vec::new())
        }))
    }

    fn put(&mut self, joint: usize, on: Body) {
        match on {
            Body::Frame => self.sketch.joints[joint].fixed = true,
            Body::Bar(bar) => {
                let joints = &mut self.sketch.bars[bar].joints;
                if !joints.contains(&joint) {
                    joints.push(joint);
                }
            }
        }
    }

    /// Adds a point for each joint, named by a letter: PMKS joints have no names.
    fn joints(&mut self, rows: &[Row<'a>]) {
        let joints = rows.iter().enumerate().map(|(number, row)| Joint {
            name: letter(number),
            at: row.at,
            fixed: false,
            traced: row.shown,
            own: true,
        });
        self.sketch.joints.extend(joints);
        self.size = self.sketch.size();
    }

    /// Adds the pairs. Returns for each joint the index of its slide; none for a joint without a slide.
    fn pairs(&mut self, rows: &[Row<'a>]) -> Vec<Option<usize>> {
        let mut slides = vec![None; rows.len()];
        for (joint, row) in rows.iter().enumerate() {
            let bodies: Vec<Body> = row.links.iter().map(|link| self.body(link)).collect();
            let (slot, riders) = match (row.kind, &bodies[..]) {
                // The links of a prismatic pair do not turn relative to each other, so the line may be on either. The
                // ground is preferred.
                (Kind::Slide, [first, Body::Frame]) => (Some(Body::Frame), vec![*first]),
                (Kind::Slide | Kind::PinInSlot, [first, rest @ ..]) if !rest.is_empty() => {
                    (Some(*first), rest.to_vec())
                }
                _ => (None, bodies),
            };
            for rider in &riders {
                self.put(joint, *rider);
            }
            let (Some(slot), [rider, ..]) = (slot, &riders[..]) else {
                continue;
            };
            let name = letter(joint);
            let names = [format!("{name}′"), format!("{name}″")];
            let line = self
                .sketch
                .guide(names, row.at, row.direction, self.size, slot);
            slides[joint] = Some(match (row.kind, rider) {
                (Kind::Slide, Body::Bar(bar)) => self.sketch.slide(*bar, joint, slot, line),
                _ => self.sketch.block(joint, slot, line),
            });
        }
        slides
    }

    /// Adds the driver: the last joint marked as driven or else, as in PMKS, the first hinge or slide of two or more
    /// links.
    fn drive(&mut self, rows: &[Row<'a>], slides: &[Option<usize>], rpm: f64) {
        let usual = |row: &Row<'_>| row.links.len() > 1 && row.kind != Kind::PinInSlot;
        let told = rows.iter().rposition(|row| row.driven);
        let Some(joint) = told.or_else(|| rows.iter().position(usual)) else {
            return;
        };
        let point = letter(joint);
        let row = &rows[joint];
        let bodies: Vec<Body> = row.links.iter().map(|link| self.body(link)).collect();
        let bars = bodies.iter().filter_map(|body| match body {
            Body::Bar(bar) => Some(*bar),
            Body::Frame => None,
        });
        let bars: Vec<usize> = bars.collect();
        let moves = match (row.kind, slides[joint], &bars[..]) {
            (Kind::Slide, Some(slide), _) => {
                let [way, _] = self.sketch.way(slide);
                let range = [way - self.size, way + self.size];
                let [min, max] = range;
                let point = point.clone();
                self.sketch
                    .left_out
                    .push(LeftOut::Range { point, min, max });
                Moves::Slide { slide, range }
            }
            (Kind::Hinge, _, [bar, ..]) if bars.len() < bodies.len() => Moves::Crank {
                bar: *bar,
                base: Body::Frame,
            },
            (Kind::Hinge, _, [base, bar, ..]) => Moves::Crank {
                bar: *bar,
                base: Body::Bar(*base),
            },
            _ => {
                self.sketch.left_out.push(LeftOut::Driver { point });
                return;
            }
        };
        let called = match moves {
            Moves::Crank { bar, .. } => self.sketch.bars[bar].name.clone(),
            Moves::Slide { .. } => point,
        };
        if rpm != 0.0 && matches!(moves, Moves::Crank { .. }) {
            let link = called.clone();
            self.sketch.left_out.push(LeftOut::Speed { link, rpm });
        }
        self.sketch.drivers.push(Driver {
            moves,
            speed: rpm * TAU / 60.0,
            called,
        });
    }
}
