//! Conversion of Linkage's connectors and links to the joints and bars of a sketch.

use std::f64::consts::TAU;

use super::parts::{Connector, Link, Parts};
use super::wheels;
use crate::LeftOut;
use crate::sketch::{Body, Driver, Joint, Moves, Sketch, distance, letter};

/// Length of an actuator's cylinder, as a fraction of the actuator's drawn length. The rod remains visible.
const CYLINDER: f64 = 0.6;

/// A file during its conversion to a sketch.
pub(super) struct Conversion<'a> {
    pub(super) parts: &'a Parts,
    pub(super) sketch: Sketch,
    /// For each link of the file, the index of the bar made from it, if any.
    pub(super) bars: Vec<Option<usize>>,
}

/// Converts the parts of a file to a sketch.
pub(super) fn sketch(parts: &Parts) -> Sketch {
    let mut conversion = Conversion {
        parts,
        sketch: Sketch {
            source: "Linkage (.linkage2)".to_owned(),
            unit: parts.unit,
            ..Sketch::default()
        },
        bars: vec![None; parts.links.len()],
    };
    if parts.scale != 1.0 {
        let factor = parts.scale;
        conversion.sketch.left_out.push(LeftOut::Scale { factor });
    }
    conversion.joints();
    conversion.links();
    conversion.fasten();
    conversion.slots();
    conversion.cranks();
    conversion.actuators();
    conversion.wheels();
    if parts.drawn > 0 {
        let parts = parts.drawn;
        conversion.sketch.left_out.push(LeftOut::Drawn { parts });
    }
    conversion.sketch
}

impl Conversion<'_> {
    /// Finds the joint made from the connector with this number.
    pub(super) fn joint(&self, id: i64) -> Option<usize> {
        self.parts
            .connectors
            .iter()
            .position(|connector| connector.id == id)
    }

    /// Finds the first link with this number.
    pub(super) fn link(&self, id: i64) -> Option<usize> {
        self.parts.links.iter().position(|link| link.id == id)
    }

    /// Links that became bars, each with the index of its bar.
    fn made(&self) -> impl Iterator<Item = (&Link, usize)> {
        let all = self.parts.links.iter().zip(&self.bars);
        all.filter_map(|(link, bar)| Some((link, (*bar)?)))
    }

    fn joints(&mut self) {
        for Connector {
            id,
            name,
            at,
            anchor,
            traced,
            ..
        } in &self.parts.connectors
        {
            let number = usize::try_from(*id).unwrap_or(0);
            self.sketch.joints.push(Joint {
                name: if name.is_empty() {
                    letter(number)
                } else {
                    name.clone()
                },
                at: *at,
                fixed: *anchor,
                traced: *traced,
                own: true,
            });
        }
    }

    /// Adds a bar for each wheel, and for each link with two or more joints, except actuators with two joints.
    fn links(&mut self) {
        for (k, link) in self.parts.links.iter().enumerate() {
            let joints: Vec<usize> = link
                .connectors
                .iter()
                .filter_map(|id| self.joint(*id))
                .collect();
            if link.stroke.is_some() && joints.len() == 2 {
                continue;
            }
            if joints.len() > 1 || (link.wheel && !joints.is_empty()) {
                let bar = self.sketch.bar(Parts::called(link), joints);
                self.sketch.bars[bar].wheel = link.wheel;
                self.bars[k] = Some(bar);
            }
        }
    }

    /// Joins connectors, links and wheels to the links to which they are fastened.
    fn fasten(&mut self) {
        for (joint, connector) in self.parts.connectors.iter().enumerate() {
            let Some(id) = connector.carried else {
                continue;
            };
            match self.link(id).and_then(|link| self.bars[link]) {
                Some(bar) => {
                    let joints = &mut self.sketch.bars[bar].joints;
                    if !joints.contains(&joint) {
                        joints.push(joint);
                    }
                }
                None => {
                    let name = self.sketch.joints[joint].name.clone();
                    self.sketch.left_out.push(LeftOut::Fastened { name });
                }
            }
        }
        for (k, link) in self.parts.links.iter().enumerate() {
            let Some(bar) = self.bars[k] else {
                continue;
            };
            let to_link = link
                .fastened
                .map(|id| self.link(id).and_then(|link| self.bars[link]));
            // A part fastened to an anchor is fixed to the frame.
            let anchor = |id: i64| {
                self.joint(id)
                    .filter(|joint| self.sketch.joints[*joint].fixed)
            };
            let to_frame = link
                .fastened_to_connector
                .map(|id| anchor(id).map(|_| Body::Frame));
            match to_link.map(|bar| bar.map(Body::Bar)).or(to_frame) {
                None => {}
                Some(Some(body)) if body != Body::Bar(bar) => {
                    if link.wheel {
                        self.sketch.bars[bar].fixed_to = Some(body);
                    } else {
                        self.sketch.welds.push((bar, body));
                    }
                }
                Some(_) => {
                    let name = Parts::called(link);
                    self.sketch.left_out.push(LeftOut::Fastened { name });
                }
            }
        }
    }

    /// Finds the body to which both joints belong.
    pub(super) fn shared(&self, ends: [usize; 2]) -> Option<Body> {
        let has = |bar: usize| {
            ends.iter()
                .all(|end| self.sketch.bars[bar].joints.contains(end))
        };
        let bar = self.made().find(|(link, bar)| !link.wheel && has(*bar));
        let anchored = ends.iter().all(|end| self.sketch.joints[*end].fixed);
        bar.map(|(_, bar)| Body::Bar(bar))
            .or(anchored.then_some(Body::Frame))
    }

    /// Converts pins in straight slots to slides, and pins in curved slots to links.
    fn slots(&mut self) {
        let mut names = Vec::new();
        for (pin, connector) in self
            .parts
            .connectors
            .iter()
            .enumerate()
            .filter(|(_, one)| one.slider)
        {
            let ends = connector
                .slot
                .and_then(|[from, to]| Some([self.joint(from)?, self.joint(to)?]));
            let ends = ends.filter(|ends| !ends.contains(&pin));
            let place = |joint: usize| self.sketch.joints[joint].at;
            // The ends must be so far apart that half their distance does not round to zero.
            let ends = ends.filter(|[from, to]| distance(place(*from), place(*to)) / 2.0 > 0.0);
            let Some((line, on)) = ends.and_then(|ends| Some((ends, self.shared(ends)?))) else {
                let point = self.sketch.joints[pin].name.clone();
                self.sketch.left_out.push(LeftOut::Slideless { point });
                continue;
            };
            if connector.radius > 0.0 {
                names.push(self.curved(pin, on, line, connector.radius));
            } else {
                self.sketch.block(pin, on, line);
            }
        }
        if !names.is_empty() {
            self.sketch.left_out.push(LeftOut::Curved { names });
        }
    }

    /// Replaces a pin in a circular slot by a link from the slot's centre to the pin. Returns the name of the pin.
    fn curved(&mut self, pin: usize, on: Body, line: [usize; 2], radius: f64) -> String {
        let [from, to] = line.map(|joint| self.sketch.joints[joint].at);
        let half = distance(from, to) / 2.0;
        let at = self.sketch.joints[pin].at;
        // The radius of an arc is at least half its chord.
        let radius = radius.max(half);
        let rise = (radius * radius - half * half).max(0.0).sqrt();
        let [x, y] = [
            (to[0] - from[0]) / (2.0 * half),
            (to[1] - from[1]) / (2.0 * half),
        ];
        let centre = |side: f64| {
            let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
            [middle[0] - side * rise * y, middle[1] + side * rise * x]
        };
        // Of the two possible centres, the slot has the one that fits the drawn pin better.
        let off = |centre: [f64; 2]| (distance(centre, at) - radius).abs();
        let [left, right] = [centre(1.0), centre(-1.0)];
        let centre = if off(left) <= off(right) { left } else { right };
        let point = self.sketch.joints[pin].name.clone();
        let joint = self
            .sketch
            .helper(format!("{point}′"), centre, on == Body::Frame);
        if let Body::Bar(bar) = on {
            self.sketch.bars[bar].joints.push(joint);
        }
        self.sketch
            .bar(format!("{point}–{point}′"), vec![joint, pin]);
        point
    }

    /// Makes one link at each anchored input connector the crank, and fixes the other links there to the crank.
    fn cranks(&mut self) {
        for (joint, connector) in self
            .parts
            .connectors
            .iter()
            .enumerate()
            .filter(|(_, one)| one.input)
        {
            let here = self
                .made()
                .filter(|(_, bar)| self.sketch.bars[*bar].joints.contains(&joint));
            // A bar can turn only if it has no fixed point besides the input connector.
            let turns = |bar: usize| {
                let mut others = self.sketch.bars[bar]
                    .joints
                    .iter()
                    .filter(|other| **other != joint);
                others.all(|other| !self.sketch.joints[*other].fixed)
            };
            let here: Vec<(bool, usize)> = here
                .filter(|(_, bar)| {
                    turns(*bar) && self.sketch.bars[*bar].fixed_to != Some(Body::Frame)
                })
                .map(|(link, bar)| (link.wheel, bar))
                .collect();
            let point = self.sketch.joints[joint].name.clone();
            let crank = here.iter().find(|(wheel, _)| !wheel).or(here.first());
            let Some((_, crank)) = crank.copied().filter(|_| connector.anchor) else {
                self.sketch.left_out.push(LeftOut::Driver { point });
                continue;
            };
            for (wheel, bar) in here.into_iter().filter(|(_, bar)| *bar != crank) {
                if wheel {
                    self.sketch.bars[bar]
                        .fixed_to
                        .get_or_insert(Body::Bar(crank));
                } else {
                    self.sketch.welds.push((bar, Body::Bar(crank)));
                }
            }
            let link = self.sketch.bars[crank].name.clone();
            if connector.swing > 0.0 {
                let angle = connector.swing;
                self.sketch.left_out.push(LeftOut::Swing {
                    link: link.clone(),
                    angle,
                });
            }
            let rpm = connector.rpm;
            self.driven(&link, rpm, connector.by_hand, |link| LeftOut::Speed {
                link,
                rpm,
            });
            let moves = Moves::Crank {
                bar: crank,
                base: Body::Frame,
            };
            self.drive(moves, -connector.rpm * TAU / 60.0, connector.by_hand, link);
        }
    }

    /// Converts each actuator, a link of variable length, to a cylinder and a rod that ends at the second hinge.
    fn actuators(&mut self) {
        for link in &self.parts.links {
            let Some([throw, cpm]) = link.stroke else {
                continue;
            };
            let joints: Vec<usize> = link
                .connectors
                .iter()
                .filter_map(|id| self.joint(*id))
                .collect();
            let name = Parts::called(link);
            let [from, to] = joints[..] else {
                self.sketch.left_out.push(LeftOut::Actuator { link: name });
                continue;
            };
            let [a, b] = [from, to].map(|joint| self.sketch.joints[joint].at);
            let along = |share: f64| [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
            let end = format!("{}′", self.sketch.joints[from].name);
            let end = self.sketch.helper(end, along(CYLINDER), false);
            let cylinder = self.sketch.bar(name.clone(), vec![from, end]);
            let slide = self.sketch.block(to, Body::Bar(cylinder), [from, end]);
            let drawn = distance(a, b);
            let least = if cpm < 0.0 {
                drawn - throw + link.start
            } else {
                drawn - link.start
            };
            // An actuator's length must stay positive.
            let range = [least.max(0.01 * drawn), least + throw];
            if range[0] > least {
                let [min, max] = range;
                let point = name.clone();
                self.sketch
                    .left_out
                    .push(LeftOut::Range { point, min, max });
            }
            self.driven(&name, cpm, link.by_hand, |link| LeftOut::Pace {
                link,
                cycles: cpm.abs(),
            });
            let moves = Moves::Slide { slide, range };
            // A cycle is two strokes, out and back.
            self.drive(moves, 2.0 * throw * cpm / 60.0, link.by_hand, name);
        }
        if self.sketch.drivers.len() > 1 {
            let cylinders = self.sketch.drivers.iter();
            let cylinders = cylinders.filter(|driver| {
                driver.speed != 0.0 && matches!(driver.moves, Moves::Slide { .. })
            });
            let names: Vec<String> = cylinders.map(|driver| driver.called.clone()).collect();
            if !names.is_empty() {
                self.sketch.left_out.push(LeftOut::OneWay { names });
            }
        }
    }

    /// Lists the property that a driver loses: motion by hand or, for the first driver that moves, its speed. `told` makes the
    /// entry for the speed.
    fn driven(&mut self, link: &str, speed: f64, by_hand: bool, told: impl Fn(String) -> LeftOut) {
        let link = link.to_owned();
        if by_hand {
            self.sketch.left_out.push(LeftOut::ByHand { link });
        } else if speed != 0.0 && self.sketch.is_still() {
            self.sketch.left_out.push(told(link));
        }
    }

    fn drive(&mut self, moves: Moves, speed: f64, by_hand: bool, called: String) {
        let speed = if by_hand { 0.0 } else { speed };
        self.sketch.drivers.push(Driver {
            moves,
            speed,
            called,
        });
    }

    fn wheels(&mut self) {
        for ratio in &self.parts.ratios {
            wheels::mesh(self, ratio);
        }
    }
}
