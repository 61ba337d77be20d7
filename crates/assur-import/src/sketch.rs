//! A mechanism read from another program, with indices instead of names, and its conversion to a linkage.

mod document;
mod names;
mod rates;

use assur::sorting::extremes;
use assur_file::{LengthUnit, MeshDocument};

use crate::{ImportProblem, Imported, LeftOut};
pub(crate) use names::letter;

/// A body: the frame, or a bar by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    Frame,
    Bar(usize),
}

#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) at: [f64; 2],
    pub(crate) fixed: bool,
    pub(crate) traced: bool,
    /// Whether the point exists in the other program. If not, it only helps to define a part.
    pub(crate) own: bool,
}

/// A rigid link, a block or a wheel.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bar {
    pub(crate) name: String,
    pub(crate) joints: Vec<usize>,
    /// The body to which a wheel is fixed, in the drawn position.
    pub(crate) fixed_to: Option<Body>,
    /// Whether the bar is a wheel. A wheel remains a link even on a shaft at rest.
    pub(crate) wheel: bool,
}

/// A prismatic pair: a joint of a bar slides along a line through two joints of another body.
#[derive(Clone, Debug)]
pub(crate) struct Slide {
    pub(crate) bar: usize,
    pub(crate) joint: usize,
    pub(crate) on: Body,
    pub(crate) line: [usize; 2],
}

/// Two wheels in mesh.
#[derive(Clone, Debug)]
pub(crate) struct Gear {
    pub(crate) bars: [usize; 2],
    pub(crate) carrier: Body,
    pub(crate) teeth: [f64; 2],
    pub(crate) mesh: MeshDocument,
}

/// A driver, with its speed: radians per second for a crank, units of length per second for a slide.
#[derive(Clone, Debug)]
pub(crate) struct Driver {
    pub(crate) moves: Moves,
    pub(crate) speed: f64,
    /// Name of the driven part in the other program.
    pub(crate) called: String,
}

#[derive(Clone, Debug)]
pub(crate) enum Moves {
    Crank { bar: usize, base: Body },
    Slide { slide: usize, range: [f64; 2] },
}

/// All parts of a mechanism.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sketch {
    pub(crate) source: String,
    pub(crate) unit: Option<LengthUnit>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) bars: Vec<Bar>,
    /// Bars welded to a body.
    pub(crate) welds: Vec<(usize, Body)>,
    pub(crate) slides: Vec<Slide>,
    pub(crate) gears: Vec<Gear>,
    pub(crate) drivers: Vec<Driver>,
    pub(crate) left_out: Vec<LeftOut>,
}

impl Sketch {
    /// Whether no driver has a speed.
    pub(crate) fn is_still(&self) -> bool {
        self.drivers.iter().all(|driver| driver.speed == 0.0)
    }

    /// Adds a point that only helps to define a part.
    pub(crate) fn helper(&mut self, name: String, at: [f64; 2], fixed: bool) -> usize {
        self.joints.push(Joint {
            name,
            at,
            fixed,
            traced: false,
            own: false,
        });
        self.joints.len() - 1
    }

    /// Adds a named bar through joints; returns its index.
    pub(crate) fn bar(&mut self, name: String, joints: Vec<usize>) -> usize {
        self.bars.push(Bar {
            name,
            joints,
            ..Bar::default()
        });
        self.bars.len() - 1
    }

    /// Adds a block, hinged at a pin, on a line of a body. Returns the index of the block's slide.
    pub(crate) fn block(&mut self, pin: usize, on: Body, line: [usize; 2]) -> usize {
        let name = self.joints[pin].name.clone();
        let bar = self.bar(name, vec![pin]);
        self.slide(bar, pin, on, line)
    }

    pub(crate) fn slide(&mut self, bar: usize, joint: usize, on: Body, line: [usize; 2]) -> usize {
        self.slides.push(Slide {
            bar,
            joint,
            on,
            line,
        });
        self.slides.len() - 1
    }

    /// Adds to a body two points that define the line of a slide, through a given place at a given angle (radians). The
    /// distance between the points is a fraction of the drawing's size.
    pub(crate) fn guide(
        &mut self,
        names: [String; 2],
        at: [f64; 2],
        direction: f64,
        size: f64,
        of: Body,
    ) -> [usize; 2] {
        let half = 0.15 * if size > 0.0 { size } else { 1.0 };
        // The cosine of 90° is 6e-17 in floating point.
        let exact = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
        let [x, y] = [exact(direction.cos()), exact(direction.sin())];
        let end = |way: f64| [at[0] + way * x, at[1] + way * y];
        let [from, to] = names;
        let fixed = of == Body::Frame;
        let line = [
            self.helper(from, end(-half), fixed),
            self.helper(to, end(half), fixed),
        ];
        if let Body::Bar(bar) = of {
            self.bars[bar].joints.extend(line);
        }
        line
    }

    /// The drawn displacement of a slide along its line, and the length of the line.
    pub(crate) fn way(&self, slide: usize) -> [f64; 2] {
        let Slide { joint, line, .. } = &self.slides[slide];
        let [from, to] = line.map(|end| self.joints[end].at);
        let length = distance(from, to);
        let at = self.joints[*joint].at;
        let along = (at[0] - from[0]) * (to[0] - from[0]) + (at[1] - from[1]) * (to[1] - from[1]);
        [if length > 0.0 { along / length } else { 0.0 }, length]
    }

    /// Diagonal of the rectangle around all joints.
    pub(crate) fn size(&self) -> f64 {
        let extent = |axis: usize| {
            let places = self.joints.iter().map(|joint| joint.at[axis]);
            let ends = extremes(places);
            (ends[1] - ends[0]).max(0.0)
        };
        extent(0).hypot(extent(1))
    }

    /// Converts the sketch to a linkage, and lists the parts that could not be imported unchanged.
    ///
    /// # Errors
    /// A mechanism without links.
    pub(crate) fn imported(self) -> Result<Imported, ImportProblem> {
        document::imported(self)
    }

    /// The body of each bar after welding: the bar itself, the bar to which it is welded, or the
    /// frame. This body takes over the joints of the welded bars.
    fn bodies(&mut self) -> Vec<Body> {
        let mut into: Vec<Body> = (0..self.bars.len()).map(Body::Bar).collect();
        for (bar, to) in self.welds.clone() {
            let (from, to) = (root(&into, Body::Bar(bar)), root(&into, to));
            match (from, to) {
                (Body::Bar(a), Body::Bar(b)) if a != b => self.join(&mut into, a.min(b), a.max(b)),
                (Body::Bar(a), Body::Frame) | (Body::Frame, Body::Bar(a)) => self.fix(&mut into, a),
                _ => {}
            }
        }
        let mut still = Vec::new();
        while let Some(bar) = self.held(&into) {
            self.fix(&mut into, bar);
            // A bar with only two joints merely draws the frame, so it is not listed as left out.
            let told = |joint: &usize| !self.joints[*joint].own;
            if self.bars[bar].joints.len() > 2 && !self.bars[bar].joints.iter().any(told) {
                still.push(self.bars[bar].name.clone());
            }
        }
        if !still.is_empty() {
            self.left_out.push(LeftOut::Fixed { names: still });
        }
        (0..self.bars.len())
            .map(|bar| root(&into, Body::Bar(bar)))
            .collect()
    }

    /// Finds the first bar that the frame holds: at two points, or at one point and by a slide. Wheels are not
    /// considered.
    fn held(&self, into: &[Body]) -> Option<usize> {
        let mut slid = vec![false; self.bars.len()];
        for slide in &self.slides {
            let ends = [Body::Bar(slide.bar), slide.on].map(|body| root(into, body));
            if let [Body::Bar(bar), Body::Frame] | [Body::Frame, Body::Bar(bar)] = ends {
                slid[bar] = true;
            }
        }
        (0..self.bars.len()).find(|bar| {
            let Bar { joints, wheel, .. } = &self.bars[*bar];
            let fixed = joints.iter().filter(|joint| self.joints[**joint].fixed);
            let held = fixed.count() + usize::from(slid[*bar]);
            into[*bar] == Body::Bar(*bar) && !wheel && held > 1
        })
    }

    fn join(&mut self, into: &mut [Body], stays: usize, goes: usize) {
        into[goes] = Body::Bar(stays);
        for joint in std::mem::take(&mut self.bars[goes].joints) {
            if !self.bars[stays].joints.contains(&joint) {
                self.bars[stays].joints.push(joint);
            }
        }
        let name = self.bars[goes].name.clone();
        let link = self.bars[stays].name.clone();
        let known = self.left_out.iter_mut().find_map(|told| match told {
            LeftOut::Welded { link: of, parts } if *of == link => Some(parts),
            _ => None,
        });
        match known {
            Some(parts) => parts.push(name),
            None => self.left_out.push(LeftOut::Welded {
                parts: vec![link.clone(), name],
                link,
            }),
        }
    }

    fn fix(&mut self, into: &mut [Body], bar: usize) {
        into[bar] = Body::Frame;
        for joint in self.bars[bar].joints.clone() {
            self.joints[joint].fixed = true;
        }
    }
}

const FRAME: &str = "frame";

fn root(into: &[Body], mut of: Body) -> Body {
    while let Body::Bar(bar) = of
        && into[bar] != of
    {
        of = into[bar];
    }
    of
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
