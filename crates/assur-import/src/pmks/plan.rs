//! Contents of a PMKS+ URL in plain or abbreviated form, and the mechanism that they describe.

use std::f64::consts::{PI, TAU};

use assur_file::LengthUnit;

use assur::mechanism::FARTHEST;

use crate::sketch::{Bar, Body, Driver, Joint, Moves, Sketch};
use crate::{ImportProblem, LeftOut};

/// Resolution of angles in a PMKS+ URL, radians.
const ANGLE_STEP: f64 = 0.001;

/// A joint: a hinge or a prismatic pair.
#[derive(Debug, Default)]
pub(super) struct Pin {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) at: [f64; 2],
    pub(super) prismatic: bool,
    pub(super) grounded: bool,
    pub(super) input: bool,
    pub(super) welded: bool,
    pub(super) traced: bool,
    /// Direction of a prismatic pair on the ground, radians.
    pub(super) angle: f64,
    /// For a prismatic pair on a link: that link, and two of its joints, which define the line.
    pub(super) slot: Option<[String; 3]>,
    /// Speed of this joint as a driver, if it has its own, revolutions per minute.
    pub(super) rpm: Option<f64>,
}

/// A link, or a block that slides.
#[derive(Debug, Default)]
pub(super) struct Member {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) block: bool,
    /// Whether the link is not part of another link.
    pub(super) root: bool,
    pub(super) mass: f64,
    pub(super) joints: Vec<String>,
    pub(super) parts: Vec<String>,
}

/// All parts of a mechanism.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub(super) unit: Option<LengthUnit>,
    /// Speed of the drivers, revolutions per minute, positive counter-clockwise.
    pub(super) rpm: f64,
    pub(super) pins: Vec<Pin>,
    pub(super) members: Vec<Member>,
    pub(super) forces: Vec<String>,
    pub(super) unknown: Vec<String>,
}

impl Plan {
    /// Checks that there are not too many parts or references to parts.
    ///
    /// # Errors
    /// Too many parts or references.
    pub(super) fn bounded(&self) -> Result<(), ImportProblem> {
        let told = self.forces.len() + self.unknown.len();
        crate::bounded(self.pins.len() + self.members.len() + told)?;
        let mentions = |member: &Member| member.joints.len() + member.parts.len();
        crate::bounded(self.members.iter().map(mentions).sum())
    }

    /// Converts the parts to a mechanism.
    ///
    /// # Errors
    /// Duplicate or unknown names; coordinates out of range; too many parts.
    pub(super) fn sketch(self, source: String) -> Result<Sketch, ImportProblem> {
        self.bounded()?;
        let mut sketch = Sketch {
            source,
            unit: self.unit,
            ..Sketch::default()
        };
        for (k, pin) in self.pins.iter().enumerate() {
            let twice = self.pins[..k].iter().any(|other| other.id == pin.id);
            if twice {
                return Err(ImportProblem::twice(&pin.id));
            }
            if let Some(far) = pin.at.iter().find(|x| x.abs() > FARTHEST) {
                return Err(ImportProblem::number(&pin.id, &format!("{far:e}")));
            }
            sketch.joints.push(Joint {
                name: pin.name.clone(),
                at: pin.at,
                fixed: pin.grounded && !pin.prismatic,
                traced: pin.traced && !pin.prismatic,
                own: !pin.prismatic,
            });
        }
        let size = sketch.size();
        let blocks = self.blocks(&mut sketch)?;
        let bars = self.bars(&mut sketch, &blocks)?;
        // For each joint, the index of its slide if the joint is prismatic.
        let mut slides = vec![None; self.pins.len()];
        for Block { pair, pin } in &blocks {
            slides[*pair] = Some(self.slide(&mut sketch, &bars, *pair, *pin, size)?);
        }
        self.weld(&mut sketch, &bars);
        self.drive(&mut sketch, &bars, &slides, size);
        self.leave_out(&mut sketch, &bars);
        Ok(sketch)
    }

    /// Finds the index of the joint with this id.
    fn pin(&self, id: &str) -> Result<usize, ImportProblem> {
        let found = self.pins.iter().position(|pin| pin.id == id);
        found.ok_or_else(|| ImportProblem::part(id))
    }

    /// Pairs each prismatic joint with the pin that it guides. Without a block, the joint itself is that pin.
    fn blocks(&self, sketch: &mut Sketch) -> Result<Vec<Block>, ImportProblem> {
        let mut blocks: Vec<Block> = Vec::new();
        for member in self.members.iter().filter(|member| member.block) {
            let joints = member.joints.iter().map(|id| self.pin(id));
            let joints = joints.collect::<Result<Vec<_>, _>>()?;
            let of = |prismatic: bool| {
                joints
                    .iter()
                    .find(|k| self.pins[**k].prismatic == prismatic)
            };
            if let (Some(pair), Some(pin)) = (of(true), of(false)) {
                blocks.push(Block {
                    pair: *pair,
                    pin: *pin,
                });
            }
        }
        for (pair, pin) in self
            .pins
            .iter()
            .enumerate()
            .filter(|(_, pin)| pin.prismatic)
        {
            if blocks.iter().any(|block| block.pair == pair) {
                continue;
            }
            let guided = self
                .members
                .iter()
                .filter(|member| member.joints.contains(&pin.id));
            if guided.count() > 0 {
                sketch.joints[pair].own = true;
                sketch.joints[pair].traced = pin.traced;
                blocks.push(Block { pair, pin: pair });
            }
        }
        Ok(blocks)
    }

    /// Adds a bar for each link that is neither a block nor part of another link. Returns each
    /// bar's index with its link.
    fn bars(
        &self,
        sketch: &mut Sketch,
        blocks: &[Block],
    ) -> Result<Vec<(usize, &Member)>, ImportProblem> {
        let mut bars = Vec::new();
        let roots = self
            .members
            .iter()
            .filter(|member| member.root && !member.block);
        for member in roots {
            let mut joints = Vec::new();
            for id in &member.joints {
                let joint = self.pin(id)?;
                // A prismatic joint of the link is replaced by the pin that this joint guides.
                let guided = blocks.iter().find(|block| block.pair == joint);
                let joint = guided.map_or(joint, |block| block.pin);
                if !joints.contains(&joint) {
                    joints.push(joint);
                }
            }
            if joints.is_empty() {
                return Err(ImportProblem::part(&member.id));
            }
            bars.push((sketch.bar(member.name.clone(), joints), member));
        }
        Ok(bars)
    }

    /// Adds a slide for a prismatic joint: of a block hinged at the pin, or of the link welded to that block.
    fn slide(
        &self,
        sketch: &mut Sketch,
        bars: &[(usize, &Member)],
        pair: usize,
        pin: usize,
        size: f64,
    ) -> Result<usize, ImportProblem> {
        let told = &self.pins[pair];
        let (on, line) = match &told.slot {
            Some([carrier, from, to]) => {
                let carries =
                    |member: &Member| member.id == *carrier || member.parts.contains(carrier);
                let found = bars.iter().find(|(_, member)| carries(member));
                let line = [self.pin(from)?, self.pin(to)?];
                let has = |bar: usize| line.iter().all(|end| sketch.bars[bar].joints.contains(end));
                let carrier = found.map(|(bar, _)| *bar).filter(|bar| has(*bar));
                let part = || ImportProblem::part(&told.id);
                (Body::Bar(carrier.ok_or_else(part)?), line)
            }
            None => (Body::Frame, self.ground(sketch, told, size)),
        };
        let mut riders = bars.iter().map(|(bar, _)| *bar);
        let rides = |bar: &usize| Body::Bar(*bar) != on && sketch.bars[*bar].joints.contains(&pin);
        // If two parts of one link meet at a welded pin, the weld in older URLs joins these parts, not the block.
        let id = &self.pins[pin].id;
        let meet = self
            .members
            .iter()
            .filter(|member| !member.root && member.joints.contains(id));
        let welded = self.pins[pin].welded && meet.count() < 2;
        let rider = riders.find(rides).filter(|_| welded);
        Ok(match rider {
            Some(rider) => sketch.slide(rider, pin, on, line),
            None => sketch.block(pin, on, line),
        })
    }

    /// Adds two points of the ground, which define the line of a prismatic pair.
    fn ground(&self, sketch: &mut Sketch, pair: &Pin, size: f64) -> [usize; 2] {
        let names = [pair.name.clone(), format!("{}′", pair.name)];
        sketch.guide(names, pair.at, whole_degrees(pair.angle), size, Body::Frame)
    }

    /// Welds the links at each welded joint into one body. If two or more parts of one link meet at the joint, only
    /// those parts, already one body, are taken as welded, and the other links stay hinged. At a grounded joint the
    /// welded links turn about the joint as one body, like a bell crank; but if only one link meets there, it is welded
    /// to the ground.
    fn weld(&self, sketch: &mut Sketch, bars: &[(usize, &Member)]) {
        for (k, pin) in self.pins.iter().enumerate().filter(|(_, pin)| pin.welded) {
            let here = bars
                .iter()
                .filter(|(bar, _)| sketch.bars[*bar].joints.contains(&k));
            let here: Vec<(usize, &Member)> = here.copied().collect();
            let of_parts = |(_, member): &(usize, &Member)| self.parts_at(member, pin) > 1;
            if here.iter().any(of_parts) {
                continue;
            }
            if let (true, [(alone, _)]) = (pin.grounded, &here[..]) {
                sketch.welds.push((*alone, Body::Frame));
            }
            let pairs = here.windows(2);
            let pairs = pairs.map(|pair| (pair[1].0, Body::Bar(pair[0].0)));
            sketch.welds.extend(pairs);
        }
    }

    /// Number of parts of a link that meet at a joint.
    fn parts_at(&self, member: &Member, pin: &Pin) -> usize {
        let parts = self.members.iter();
        let parts = parts.filter(|part| !part.root && member.parts.contains(&part.id));
        parts.filter(|part| part.joints.contains(&pin.id)).count()
    }

    fn drive(
        &self,
        sketch: &mut Sketch,
        bars: &[(usize, &Member)],
        slides: &[Option<usize>],
        size: f64,
    ) {
        for (k, pin) in self.pins.iter().enumerate().filter(|(_, pin)| pin.input) {
            let rpm = pin.rpm.unwrap_or(self.rpm);
            let has = |bar: &Bar| bar.joints.contains(&k);
            let mut here = bars
                .iter()
                .map(|(bar, _)| *bar)
                .filter(|bar| has(&sketch.bars[*bar]));
            let moves = match slides[k] {
                Some(slide) => {
                    let [way, length] = sketch.way(slide);
                    // A slot ends at its two joints; a guide on the ground has no ends.
                    let range = match pin.slot {
                        Some(_) => [way.min(0.0), way.max(length)],
                        None => [way - size, way + size],
                    };
                    let [min, max] = range;
                    let point = pin.name.clone();
                    sketch.left_out.push(LeftOut::Range { point, min, max });
                    Moves::Slide { slide, range }
                }
                None => {
                    let first = here.next();
                    let second = here.next().filter(|_| !pin.grounded);
                    match (first, second) {
                        (Some(bar), None) => Moves::Crank {
                            bar,
                            base: Body::Frame,
                        },
                        (Some(base), Some(bar)) => Moves::Crank {
                            bar,
                            base: Body::Bar(base),
                        },
                        (None, _) => {
                            let point = pin.name.clone();
                            sketch.left_out.push(LeftOut::Driver { point });
                            continue;
                        }
                    }
                }
            };
            let called = match moves {
                Moves::Crank { bar, .. } => sketch.bars[bar].name.clone(),
                Moves::Slide { .. } => pin.name.clone(),
            };
            if rpm != 0.0 && slides[k].is_none() && sketch.is_still() {
                let link = called.clone();
                sketch.left_out.push(LeftOut::Speed { link, rpm });
            }
            sketch.drivers.push(Driver {
                moves,
                speed: rpm * TAU / 60.0,
                called,
            });
        }
    }

    fn leave_out(&self, sketch: &mut Sketch, bars: &[(usize, &Member)]) {
        for (bar, member) in bars.iter().filter(|(_, member)| !member.parts.is_empty()) {
            let called = |id: &String| {
                let part = self.members.iter().find(|part| part.id == *id);
                part.map_or_else(|| crate::quoted(id), |part| part.name.clone())
            };
            sketch.left_out.push(LeftOut::Welded {
                link: sketch.bars[*bar].name.clone(),
                parts: member.parts.iter().map(called).collect(),
            });
        }
        // A mass of 1 is not listed: PMKS+ gives this mass to every new link.
        let heavy = self
            .members
            .iter()
            .filter(|member| member.root && ![0.0, 1.0].contains(&member.mass));
        let names: Vec<String> = heavy.map(|member| member.name.clone()).collect();
        if !names.is_empty() {
            sketch.left_out.push(LeftOut::Masses { names });
        }
        if !self.forces.is_empty() {
            let names = self.forces.clone();
            sketch.left_out.push(LeftOut::Forces { names });
        }
        let unknown = self
            .unknown
            .iter()
            .map(|part| LeftOut::Unknown { part: part.clone() });
        sketch.left_out.extend(unknown);
    }
}

/// A prismatic joint and the pin that it guides, as indices of joints.
struct Block {
    pair: usize,
    pin: usize,
}

/// Rounds an angle to whole degrees if the difference is within the resolution. The digits in a
/// URL cannot distinguish a guide at 90° from one that is a hundredth of a degree off.
fn whole_degrees(angle: f64) -> f64 {
    let whole = angle.to_degrees().round() * PI / 180.0;
    if (whole - angle).abs() <= 0.5 * ANGLE_STEP + 1e-12 {
        whole
    } else {
        angle
    }
}
