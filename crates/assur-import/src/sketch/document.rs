//! Conversion of a sketch to a linkage with names.

use assur_file::{
    DriverDocument, GearDocument, LinkDocument, LinkageDocument, PointDocument, SlideDocument,
};

use super::names::Names;
use super::{Body, Driver, FRAME, Moves, Sketch, Slide, rates};
use crate::{ImportProblem, Imported, LeftOut};

/// Maximum number of drawn paths.
const MAX_TRACES: usize = 32;

/// Makes the linkage, and lists the parts that could not be imported unchanged.
///
/// # Errors
/// A mechanism without links.
pub(super) fn imported(mut sketch: Sketch) -> Result<Imported, ImportProblem> {
    let bodies = sketch.bodies();
    let mut left_out = std::mem::take(&mut sketch.left_out);
    let drivers = std::mem::take(&mut sketch.drivers);
    let named = Named::new(&sketch, bodies);
    let mut document = LinkageDocument {
        source: Some(sketch.source.clone()),
        unit: sketch.unit,
        points: named.points().collect(),
        frame: named.joints(|joint| sketch.joints[joint].fixed),
        links: named.links().collect(),
        slides: named.slides().collect(),
        gears: named.gears().collect(),
        drivers: named.drivers(drivers, &mut left_out),
        traces: named.joints(|joint| sketch.joints[joint].traced && !sketch.joints[joint].fixed),
        ..LinkageDocument::default()
    };
    document.traces.truncate(MAX_TRACES);
    if document.links.is_empty() {
        return Err(ImportProblem::NothingImported);
    }
    let unused = sketch.joints.iter().zip(&named.used);
    let unused = unused.filter(|(joint, used)| joint.own && !joint.fixed && !**used);
    let names: Vec<String> = unused.map(|(joint, _)| joint.name.clone()).collect();
    if !names.is_empty() {
        left_out.push(LeftOut::Unused { names });
    }
    Ok(Imported { document, left_out })
}

/// A sketch with the final body of each bar, and with valid names.
struct Named<'a> {
    sketch: &'a Sketch,
    bodies: Vec<Body>,
    /// Whether each joint belongs to the linkage.
    used: Vec<bool>,
    points: Vec<String>,
    links: Vec<String>,
}

impl<'a> Named<'a> {
    fn new(sketch: &'a Sketch, bodies: Vec<Body>) -> Self {
        let mut named = Self {
            sketch,
            bodies,
            used: vec![false; sketch.joints.len()],
            points: vec![String::new(); sketch.joints.len()],
            links: vec![String::new(); sketch.bars.len()],
        };
        let bars = (0..sketch.bars.len()).filter(|bar| named.stays(*bar));
        let bars: Vec<usize> = bars.collect();
        let slides = sketch.slides.iter().filter(|slide| named.moves(slide));
        // The sliding joint is included: its bar may be fixed to the frame.
        let of_slides = slides.flat_map(|slide| [slide.joint, slide.line[0], slide.line[1]]);
        let of_slides: Vec<usize> = of_slides.collect();
        let of_bars = bars.iter().flat_map(|bar| sketch.bars[*bar].joints.clone());
        for joint in of_bars.chain(of_slides) {
            named.used[joint] = true;
        }
        let mut taken = Names::default();
        for (k, joint) in sketch
            .joints
            .iter()
            .enumerate()
            .filter(|(k, _)| named.used[*k])
        {
            named.points[k] = taken.take(&joint.name, k);
        }
        let mut taken = Names::links();
        for bar in bars {
            named.links[bar] = taken.take(&sketch.bars[bar].name, bar);
        }
        named
    }

    fn body(&self, of: Body) -> Body {
        match of {
            Body::Frame => Body::Frame,
            Body::Bar(bar) => self.bodies[bar],
        }
    }

    /// Whether a bar remains a separate link.
    fn stays(&self, bar: usize) -> bool {
        self.bodies[bar] == Body::Bar(bar)
    }

    /// Whether a slide can move: the bodies that it connects are different.
    fn moves(&self, slide: &Slide) -> bool {
        self.bodies[slide.bar] != self.body(slide.on)
    }

    fn name(&self, of: Body) -> String {
        match self.body(of) {
            Body::Frame => FRAME.to_owned(),
            Body::Bar(bar) => self.links[bar].clone(),
        }
    }

    /// The names of the joints that satisfy a condition.
    fn joints(&self, such: impl Fn(usize) -> bool) -> Vec<String> {
        let all = (0..self.points.len()).filter(|joint| self.used[*joint] && such(*joint));
        all.map(|joint| self.points[joint].clone()).collect()
    }

    fn points(&self) -> impl Iterator<Item = PointDocument> {
        let all = self.sketch.joints.iter().enumerate();
        all.filter(|(k, _)| self.used[*k])
            .map(|(k, joint)| PointDocument {
                name: self.points[k].clone(),
                at: joint.at,
            })
    }

    fn links(&self) -> impl Iterator<Item = LinkDocument> {
        let all = self.sketch.bars.iter().enumerate();
        all.filter(|(k, _)| self.stays(*k)).map(|(k, bar)| {
            // Fixed points come first, because a link's angle is the direction from its first point to its second.
            let first = |joint: &&usize| bar.wheel || self.sketch.joints[**joint].fixed;
            let (first, others): (Vec<usize>, Vec<usize>) = bar.joints.iter().partition(first);
            let joints = first.into_iter().chain(others);
            LinkDocument {
                name: self.links[k].clone(),
                points: joints.map(|joint| self.points[joint].clone()).collect(),
                fixed_to: bar.fixed_to.map(|to| self.name(to)),
                ..LinkDocument::default()
            }
        })
    }

    fn slides(&self) -> impl Iterator<Item = SlideDocument> {
        let all = self.sketch.slides.iter().filter(|slide| self.moves(slide));
        all.map(|slide| SlideDocument {
            link: self.name(Body::Bar(slide.bar)),
            point: self.points[slide.joint].clone(),
            on: self.name(slide.on),
            line: slide.line.map(|joint| self.points[joint].clone()),
        })
    }

    /// Index of a slide among the slides that remain in the linkage.
    fn number(&self, slide: usize) -> usize {
        let before = self.sketch.slides[..slide].iter();
        before.filter(|slide| self.moves(slide)).count()
    }

    fn gears(&self) -> impl Iterator<Item = GearDocument> {
        self.sketch.gears.iter().map(|gear| GearDocument {
            links: gear.bars.map(|bar| self.name(Body::Bar(bar))),
            carrier: self.name(gear.carrier),
            teeth: gear.teeth,
            mesh: gear.mesh,
        })
    }

    /// The drivers that move a link, with their rates; the others are listed in `left_out`.
    fn drivers(&self, all: Vec<Driver>, left_out: &mut Vec<LeftOut>) -> Vec<DriverDocument> {
        let (moving, idle): (Vec<Driver>, Vec<Driver>) =
            all.into_iter().partition(|driver| match driver.moves {
                Moves::Crank { bar, base } => {
                    let turned = self.bodies[bar];
                    turned != Body::Frame && turned != self.body(base)
                }
                Moves::Slide { slide, .. } => self.moves(&self.sketch.slides[slide]),
            });
        let idle = idle.into_iter().map(|driver| driver.called);
        left_out.extend(idle.map(|point| LeftOut::Driver { point }));
        let rated = rates::of(moving, left_out).into_iter();
        rated
            .map(|(driver, rate)| match driver.moves {
                Moves::Crank { bar, base } => DriverDocument {
                    crank: Some(self.name(Body::Bar(bar))),
                    base: (self.body(base) != Body::Frame).then(|| self.name(base)),
                    rate,
                    ..DriverDocument::default()
                },
                Moves::Slide { slide, range } => DriverDocument {
                    slide: Some(self.number(slide)),
                    range: Some(range),
                    rate,
                    ..DriverDocument::default()
                },
            })
            .collect()
    }
}
