//! Random linkages of every class, each part joined at random to earlier ones, and drawn nearly degenerate on purpose.

use assur::Point;
use assur::gears::Mesh;
use assur::mechanism::{DriverSpec, FRAME, GearSpec, LinkageSpec, PointSpec};

use super::places::Places;
use crate::properties::random::Random;

/// What a linkage is built of.
const PARTS: [Part; 15] = [
    Part::Rrr,
    Part::Rrr,
    Part::Rrp,
    Part::Rpr,
    Part::Prp,
    Part::Rpp,
    Part::Triad,
    Part::TriadWithSlide,
    Part::Four,
    Part::Five,
    Part::Wheel,
    Part::Planet,
    Part::Wheel,
    Part::Fixed,
    Part::Train,
];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Rrr,
    Rrp,
    Rpr,
    Prp,
    Rpp,
    Triad,
    TriadWithSlide,
    Four,
    Five,
    Wheel,
    Planet,
    Train,
    Fixed,
}

/// A linkage that grows part by part.
pub(crate) struct Linkage {
    pub(crate) draft: LinkageSpec,
    random: Random,
    places: Places,
    named: usize,
    /// Links that are hinged on the frame, to which wheels may be geared, with their hinges.
    turning: Vec<(String, String)>,
}

impl Linkage {
    /// The linkage of a seed, of so many parts beside its driver: with one part fewer it is the
    /// same without its last part.
    pub(crate) fn new(seed: u64, parts: usize) -> Self {
        let mut random = Random::new(77_000_000 + seed);
        let mut linkage = Self {
            draft: LinkageSpec::default(),
            places: Places::any(&mut random),
            random,
            named: 0,
            turning: vec![],
        };
        linkage.driven();
        for part in 0..parts {
            linkage.random = Random::new(78_000_000 + 100 * seed + part as u64);
            let kind = PARTS[linkage.random.below(PARTS.len())];
            linkage.add(kind);
        }
        linkage
    }

    /// How many parts the linkage of a seed has: few are more often at fault plainly.
    pub(crate) fn parts_of(seed: u64) -> usize {
        1 + Random::new(79_000_000 + seed).below(4)
    }

    /// A crank on the frame, or a block that is moved along a line of it.
    fn driven(&mut self) {
        let [a, b] = [self.place(), self.place()];
        if self.random.below(6) > 0 {
            let (a, b) = (self.point(a), self.point(b));
            self.draft.frame.push(a.clone());
            self.draft = std::mem::take(&mut self.draft)
                .bar("crank", &[&a, &b])
                .crank("crank");
            self.turning.push(("crank".to_owned(), a));
            return;
        }
        let along = (b - a) * self.random.within(0.3, 0.7);
        let block = self.point(a + along);
        let (a, b) = (self.point(a), self.point(b));
        self.draft.frame.extend([a.clone(), b.clone()]);
        self.draft = std::mem::take(&mut self.draft)
            .bar("block", &[&block])
            .slide("block", &block, FRAME, [&a, &b]);
        let reach = self.random.within(0.1, 0.5);
        let range = [1.0 - reach, 1.0 + reach].map(|part| part * along.norm());
        let (slide, rate) = (0, 1.0);
        let driver = DriverSpec::Slide { slide, range, rate };
        self.draft.drivers.push(driver);
    }

    fn add(&mut self, part: Part) {
        match part {
            Part::Rrr => {
                let [p, q] = self.two_hinges();
                let c = self.new_point();
                let extra = self.random.below(2) == 0;
                let extra = extra.then(|| self.new_point());
                self.bar([Some(p), Some(c.clone()), extra]);
                self.bar([Some(q), Some(c), None]);
            }
            Part::Rrp => {
                let p = self.hinge();
                let c = self.new_point();
                self.bar([Some(p), Some(c.clone()), None]);
                self.block(&c);
            }
            Part::Rpr => {
                let [p, q] = self.two_hinges();
                let e = self.new_point();
                let guide = self.bar([Some(p.clone()), Some(e.clone()), None]);
                let end = self.random.below(2) == 0;
                let end = end.then(|| self.new_point());
                let rod = self.bar([Some(q.clone()), end, None]);
                self.slide(&rod, &q, &guide, [&p, &e]);
            }
            Part::Prp => {
                let c = self.new_point();
                self.block(&c);
                self.block(&c);
            }
            Part::Rpp => {
                let [p, e] = [self.hinge(), self.new_point()];
                let arm = self.bar([Some(p.clone()), Some(e), None]);
                let [u, v] = [self.new_point(), self.new_point()];
                let cross = self.bar([Some(u.clone()), Some(v.clone()), None]);
                let (base, line) = self.line();
                self.slide(&cross, &u, &base, [&line[0], &line[1]]);
                self.slide(&arm, &p, &cross, [&u, &v]);
            }
            Part::Triad | Part::TriadWithSlide => {
                let ([g, h], k) = (self.two_hinges(), self.hinge());
                let [p, q, r] = [(); 3].map(|()| self.new_point());
                self.bar([Some(p.clone()), Some(q.clone()), Some(r.clone())]);
                self.bar([Some(g), Some(p), None]);
                self.bar([Some(h), Some(q), None]);
                if part == Part::TriadWithSlide {
                    self.block(&r);
                } else {
                    self.bar([Some(k), Some(r), None]);
                }
            }
            Part::Four => {
                let [b, d] = self.two_hinges();
                let [c, e, f, h] = [(); 4].map(|()| self.new_point());
                self.bar([Some(b), Some(c.clone()), Some(e.clone())]);
                self.bar([Some(c), Some(f.clone()), None]);
                self.bar([Some(e), Some(h.clone()), None]);
                self.bar([Some(d), Some(f), Some(h)]);
            }
            Part::Five => {
                let ([b, d], h) = (self.two_hinges(), self.hinge());
                let [p, q, r, s, t, u] = [(); 6].map(|()| self.new_point());
                self.bar([Some(b), Some(t.clone()), Some(p.clone())]);
                self.bar([Some(p), Some(q.clone()), None]);
                self.bar([Some(d), Some(q), Some(r.clone())]);
                self.bar([Some(r), Some(s.clone()), Some(u.clone())]);
                self.bar([Some(s), Some(t), None]);
                self.bar([Some(h), Some(u), None]);
            }
            Part::Wheel => self.wheel(),
            Part::Planet => self.planet(),
            Part::Train => self.train(),
            Part::Fixed => {
                let on = self.random.below(self.draft.links.len());
                let on = self.draft.links[on].name.clone();
                let [p, q] = [self.new_point(), self.new_point()];
                self.bar([Some(p), Some(q), None]);
                if let Some(link) = self.draft.links.last_mut() {
                    link.fixed_to = Some(on);
                }
            }
        }
    }

    /// A wheel on the frame, in mesh with a link that turns on the frame.
    fn wheel(&mut self) {
        let Some((mate, _)) = self.one_turning() else {
            return self.add(Part::Rrr);
        };
        let [w, v] = [self.new_point(), self.new_point()];
        self.draft.frame.push(w.clone());
        let wheel = self.bar([Some(w.clone()), Some(v), None]);
        self.gear([mate, wheel.clone()], FRAME);
        self.turning.push((wheel, w));
    }

    /// A wheel on a link that turns on the frame, around a wheel that stands.
    fn planet(&mut self) {
        let Some((carrier, _)) = self.one_turning() else {
            return self.add(Part::Rrp);
        };
        let [w, v] = [self.new_point(), self.new_point()];
        self.give(&carrier, &w);
        let planet = self.bar([Some(w), Some(v), None]);
        self.gear([FRAME.to_owned(), planet], &carrier);
    }

    /// Wheels on a link that turns on the frame, in mesh one with the other, the first with one that stands; what is drawn
    /// by a point of theirs hangs on how often their carrier has turned.
    fn train(&mut self) {
        let Some((carrier, _)) = self.one_turning() else {
            return self.add(Part::Rrr);
        };
        let mut mate = FRAME.to_owned();
        for _ in 0..2 {
            let [w, v] = [self.new_point(), self.new_point()];
            self.give(&carrier, &w);
            let wheel = self.bar([Some(w), Some(v), None]);
            self.gear([mate, wheel.clone()], &carrier);
            mate = wheel;
        }
    }

    fn one_turning(&mut self) -> Option<(String, String)> {
        let count = self.turning.len();
        (count > 0).then(|| self.turning[self.random.below(count)].clone())
    }

    fn gear(&mut self, links: [String; 2], carrier: &str) {
        const TEETH: [[u32; 2]; 9] = [
            [20, 20],
            [20, 40],
            [40, 20],
            [30, 20],
            [24, 36],
            [20, 100],
            [17, 51],
            [24, 25],
            [30, 31],
        ];
        let mut teeth = TEETH[self.random.below(TEETH.len())];
        if self.random.below(8) == 0 {
            teeth = [0; 2].map(|_| 13 + self.random.below(50) as u32);
        }
        let mesh = match self.random.below(3) {
            0 if teeth[0] != teeth[1] => Mesh::Internal,
            1 => Mesh::AsPrinted,
            _ => Mesh::External,
        };
        self.draft.gears.push(GearSpec {
            links,
            carrier: carrier.to_owned(),
            teeth: teeth.map(f64::from),
            mesh,
        });
    }

    fn bar(&mut self, points: [Option<String>; 3]) -> String {
        self.named += 1;
        let name = format!("k{}", self.named);
        let points: Vec<&str> = points.iter().flatten().map(String::as_str).collect();
        self.draft = std::mem::take(&mut self.draft).bar(&name, &points);
        let on_frame = points.iter().find(|point| self.is_fixed(point));
        if let Some(hinge) = on_frame {
            self.turning.push((name.clone(), (*hinge).to_owned()));
        }
        name
    }

    fn is_fixed(&self, point: &str) -> bool {
        self.draft.frame.iter().any(|fixed| fixed == point)
    }

    /// A block at a point, on a line of the frame or of any link.
    fn block(&mut self, point: &str) {
        let (base, line) = self.line();
        self.named += 1;
        let block = format!("b{}", self.named);
        self.draft = std::mem::take(&mut self.draft).bar(&block, &[point]);
        self.slide(&block, point, &base, [&line[0], &line[1]]);
    }

    fn slide(&mut self, link: &str, point: &str, on: &str, line: [&str; 2]) {
        self.draft = std::mem::take(&mut self.draft).slide(link, point, on, line);
    }

    /// A line of the frame, new, or of one of the links with two points that were there before
    /// what is being added.
    fn line(&mut self) -> (String, [String; 2]) {
        let own = self.random.below(3) == 0;
        let bodies = self.draft.links.iter().take(self.drawn_before());
        let bodies: Vec<_> = bodies
            .filter(|link| link.points.len() > 1)
            .map(|link| (link.name.clone(), [0, 1].map(|k| link.points[k].clone())))
            .collect();
        if own && !bodies.is_empty() {
            return bodies[self.random.below(bodies.len())].clone();
        }
        let line = [self.new_point(), self.new_point()];
        self.draft.frame.extend(line.clone());
        (FRAME.to_owned(), line)
    }

    /// How many links are none of the part that is being added: those before the last few. A group
    /// that slides on itself would be another one.
    fn drawn_before(&self) -> usize {
        self.draft.links.len().saturating_sub(6).max(1)
    }

    /// A hinge on anything that is there: a point that it has, or a new one.
    fn hinge(&mut self) -> String {
        let count = self.drawn_before();
        if self.random.below(5) < 2 {
            let point = self.new_point();
            self.draft.frame.push(point.clone());
            return point;
        }
        let link = self.random.below(count);
        let link = self.draft.links[link].clone();
        if self.random.below(3) == 0 || link.fixed_to.is_some() || link.points.len() < 2 {
            return link.points[self.random.below(link.points.len())].clone();
        }
        let point = self.new_point();
        self.give(&link.name, &point);
        point
    }

    /// Two hinges, the first on a link that moves, the second elsewhere.
    fn two_hinges(&mut self) -> [String; 2] {
        let count = self.draft.links.len();
        let link = self.draft.links[count - 1 - self.random.below(count.min(3))].clone();
        let first = link.points[link.points.len() - 1].clone();
        for _ in 0..20 {
            let second = self.hinge();
            let together = self
                .draft
                .links
                .iter()
                .any(|link| link.points.contains(&first) && link.points.contains(&second));
            if !together && second != first && !(self.is_fixed(&first) && self.is_fixed(&second)) {
                return [first, second];
            }
        }
        let second = self.new_point();
        self.draft.frame.push(second.clone());
        [first, second]
    }

    fn give(&mut self, link: &str, point: &str) {
        let mut links = self.draft.links.iter_mut();
        if let Some(link) = links.find(|other| other.name == link) {
            link.points.push(point.to_owned());
        }
    }

    fn place(&mut self) -> Point {
        let drawn: Vec<Point> = self.draft.points.iter().map(|point| point.at).collect();
        self.places.another(&drawn, &mut self.random)
    }

    fn new_point(&mut self) -> String {
        let at = self.place();
        self.point(at)
    }

    fn point(&mut self, at: Point) -> String {
        let name = format!("P{}", self.draft.points.len());
        self.draft.points.push(PointSpec {
            name: name.clone(),
            at,
        });
        name
    }
}
