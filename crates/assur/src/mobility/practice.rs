//! Schemes for practice, with 2 to 6 moving links, positions for a drawing, and a counted mobility W ≥ 1.

use crate::numeric::random::Random;

use super::{PairKind, PairSpec, Point3, SchemeSpec, Vector3};

/// Columns and rows of the grid of cells for the joints. The lowest row is for joints of the ground.
const CELLS: [usize; 2] = [4, 3];

/// Maximum distance of a joint from the middle of its unit cell on each axis. Joints are at least 1 − 2 · JITTER apart.
const JITTER: f64 = 0.15;

/// Number of the ground, which also serves as its name.
const GROUND: usize = 0;

/// A scheme for counting, determined by the seed. Most schemes are planar, with cranks, sliders, cams and dyads, which
/// may share a compound hinge. The others are contours or open chains in space.
pub fn generated(seed: u32) -> SchemeSpec {
    let mut random = Random(u64::from(seed));
    let planar = random.below(4) > 0;
    let mut task = Task::new(random, planar);
    if planar {
        task.planar();
    } else {
        task.spatial();
    }
    SchemeSpec {
        ground: GROUND.to_string(),
        planar,
        pairs: task.pairs,
    }
}

/// A scheme under construction.
struct Task {
    random: Random,
    planar: bool,
    pairs: Vec<PairSpec>,
    /// Number of links, including the ground.
    links: usize,
    /// Free cells in the lowest row.
    ground: Vec<[usize; 2]>,
    /// Free cells above the lowest row.
    above: Vec<[usize; 2]>,
}

impl Task {
    fn new(mut random: Random, planar: bool) -> Self {
        let [columns, rows] = CELLS;
        let row = |y: usize| (0..columns).map(move |x| [x, y]);
        let mut ground: Vec<_> = row(0).collect();
        let mut above: Vec<_> = (1..rows).flat_map(row).collect();
        random.shuffle(&mut ground);
        random.shuffle(&mut above);
        Self {
            random,
            planar,
            pairs: vec![],
            links: 1,
            ground,
            above,
        }
    }

    fn planar(&mut self) {
        let crank = self.link();
        self.pair(PairKind::Revolute, &[GROUND, crank]);
        let dyads = match self.random.below(6) {
            0 => {
                self.follower(crank);
                self.random.below(3)
            }
            1 => {
                let second = self.link();
                self.pair(PairKind::Revolute, &[GROUND, second]);
                1 + self.random.below(2)
            }
            _ => 1 + self.random.below(2),
        };
        for _ in 0..dyads {
            self.dyad();
        }
    }

    /// Adds a link joined to the ground and moved by a cam.
    fn follower(&mut self, cam: usize) {
        let follower = self.link();
        let kind = [PairKind::Revolute, PairKind::Prismatic][self.random.below(2)];
        self.pair(kind, &[GROUND, follower]);
        self.pair(PairKind::CylinderOnPlane, &[cam, follower]);
    }

    /// Adds two links, hinged to each other and joined to two existing links.
    fn dyad(&mut self) {
        let first = self.random.below(self.links);
        let mut second = self.random.below(self.links - 1);
        if second >= first {
            second += 1;
        }
        let hosts = [first.max(second), first.min(second)];
        let [one, other] = [self.link(), self.link()];
        let joints = self.pairs.iter().enumerate();
        let hinges = joints.filter(|(_, pair)| {
            let host = hosts[0].to_string();
            pair.kind == PairKind::Revolute && pair.links.contains(&host)
        });
        let hinges: Vec<usize> = hinges.map(|(at, _)| at).collect();
        // Sometimes the dyad shares an existing hinge of the first host link, but not a hinge of both hosts.
        let other_host = hosts[1].to_string();
        let hinge = (self.random.below(4) == 0)
            .then(|| {
                hinges
                    .into_iter()
                    .find(|at| !self.pairs[*at].links.contains(&other_host))
            })
            .flatten();
        match hinge {
            Some(hinge) => self.pairs[hinge].links.push(one.to_string()),
            None => self.pair(PairKind::Revolute, &[hosts[0], one]),
        }
        self.pair(PairKind::Revolute, &[one, other]);
        let slides = self.random.below(3) == 0;
        let last = if slides {
            PairKind::Prismatic
        } else {
            PairKind::Revolute
        };
        self.pair(last, &[other, hosts[1]]);
    }

    fn spatial(&mut self) {
        if self.random.below(5) == 0 {
            let mut end = GROUND;
            for _ in 0..2 + self.random.below(3) {
                let next = self.link();
                let kind = self.kind();
                self.pair(kind, &[end, next]);
                end = next;
            }
            return;
        }
        let freedoms = 7 + self.random.below(2);
        let pairs = 4 + self.random.below(2);
        self.chain([GROUND, GROUND], pairs, freedoms);
        if pairs == 4 && self.random.below(2) == 0 {
            // As in figure 3 of the mobility paper: the second contour adds nothing to W.
            self.chain([2, GROUND], 3, 6);
        }
    }

    /// Adds a chain of links between two existing links, with a given number of pairs and a given total number of
    /// freedoms. At most one of the pairs slides.
    fn chain(&mut self, [start, end]: [usize; 2], pairs: usize, freedoms: usize) {
        let kinds = loop {
            let kinds: Vec<PairKind> = (0..pairs).map(|_| self.kind()).collect();
            let sum: usize = kinds.iter().map(|kind| usize::from(kind.freedoms())).sum();
            let slides =
                |kind: &&PairKind| matches!(kind, PairKind::Prismatic | PairKind::Cylindrical);
            if sum == freedoms && kinds.iter().filter(slides).count() < 2 {
                break kinds;
            }
        };
        let mut from = start;
        for (at, kind) in kinds.into_iter().enumerate() {
            let to = if at + 1 < pairs { self.link() } else { end };
            self.pair(kind, &[from, to]);
            from = to;
        }
    }

    /// Random kind of spatial pair, most often a hinge or a ball.
    fn kind(&mut self) -> PairKind {
        let forms = [
            PairKind::Revolute,
            PairKind::Revolute,
            PairKind::Revolute,
            PairKind::Prismatic,
            PairKind::Cylindrical,
            PairKind::Universal,
            PairKind::Spherical,
            PairKind::Spherical,
        ];
        forms[self.random.below(forms.len())]
    }

    fn link(&mut self) -> usize {
        self.links += 1;
        self.links - 1
    }

    /// Adds a pair of given links in a free cell.
    fn pair(&mut self, kind: PairKind, links: &[usize]) {
        let cells = if links.contains(&GROUND) {
            self.ground.pop().or_else(|| self.above.pop())
        } else {
            self.above.pop().or_else(|| self.ground.pop())
        };
        let place = cells.map(|[x, y]| {
            let [x, y] = [x, y].map(|at| at as f64 + self.random.between(-JITTER, JITTER));
            let z = if self.planar {
                0.0
            } else {
                self.random.between(-1.0, 1.0)
            };
            Point3::new(x, y, z)
        });
        let has_normal = self.planar && kind == PairKind::Revolute;
        let axis = match kind {
            _ if has_normal => Some(Vector3::z()),
            _ if kind.has_axis() => Some(self.direction()),
            _ => None,
        };
        let second = (kind.has_second() && !self.planar).then(|| self.direction());
        // There are fewer pairs than letters.
        let letter = char::from(b'A' + self.pairs.len() as u8);
        self.pairs.push(PairSpec {
            name: letter.to_string(),
            kind,
            links: links.iter().map(usize::to_string).collect(),
            place,
            axis,
            second,
        });
    }

    /// A random direction, in the plane for a planar scheme.
    fn direction(&mut self) -> Vector3 {
        let planar = self.planar;
        let mut component = |in_plane: bool| match in_plane || !planar {
            true => self.random.between(-1.0, 1.0),
            false => 0.0,
        };
        let direction = Vector3::new(component(true), component(true), component(false));
        // A minimum length, to avoid rounding errors.
        if direction.norm() > 0.1 {
            direction
        } else {
            Vector3::new(0.6, 0.8, 0.0)
        }
    }
}
