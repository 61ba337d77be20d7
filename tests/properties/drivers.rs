//! Properties of every chain of dyads and every higher group when the driver is a pair between two moving links.

use assur::mechanism::{DriverSpec, LinkageSpec, Mechanism, Pose};
use assur::motion::Motion;
use assur_tests::scaled;

use super::following::{Random, closes, inputs, leads_to_itself, rate};
use super::{dyads, groups};

const LINKAGES: u64 = 150;

/// A pair of a linkage.
enum Pair {
    /// A link on another one.
    Hinge([String; 2]),
    Slide(usize),
}

impl Pair {
    /// Any two links, or a slide; none where the links share no point.
    fn any(draft: &LinkageSpec, random: &mut Random) -> Option<Self> {
        let (links, slides) = (&draft.links, draft.slides.len());
        let pair = random.below(slides + links.len() * links.len());
        let Some(two) = pair.checked_sub(slides) else {
            return Some(Self::Slide(pair));
        };
        let [link, base] = [two % links.len(), two / links.len()].map(|at| &links[at]);
        let shared = link.points.iter().any(|point| base.points.contains(point));
        let names = [&link.name, &base.name].map(String::clone);
        (names[0] != names[1] && shared).then_some(Self::Hinge(names))
    }

    fn driver(&self) -> DriverSpec {
        match self {
            Self::Hinge([link, base]) => DriverSpec::Crank {
                link: link.clone(),
                base: base.clone(),
                rate: 1.0,
            },
            Self::Slide(slide) => DriverSpec::Slide {
                slide: *slide,
                range: [-12.0, 12.0],
                rate: 1.0,
            },
        }
    }

    /// Its coordinate in a pose.
    fn coordinate(&self, mechanism: &Mechanism, pose: &Pose<1>) -> f64 {
        match self {
            Self::Hinge(names) => {
                let angle = |name: &String| mechanism.angle(pose, mechanism.link(name).unwrap());
                let [link, base] = names.each_ref().map(angle);
                link.value() - base.value()
            }
            Self::Slide(slide) => {
                let slide = &mechanism.spec().slides[*slide];
                let names = [&slide.line[0], &slide.line[1], &slide.point];
                let [from, to, point] = names.map(|name| {
                    let point = mechanism.point(name).unwrap();
                    mechanism.place(pose, point).place()
                });
                (to - from).normalize().dot(&(point - from))
            }
        }
    }
}

/// A linkage with one of its other pairs as the driver.
struct Driven {
    draft: LinkageSpec,
    pair: Pair,
    /// As it was driven before, and as it is now.
    was: Motion,
    now: Motion,
}

/// None where the pair does not move, or cannot drive alone.
fn driven(seed: u64) -> Option<Driven> {
    let mut random = Random::new(9_000_000 + seed);
    let (mut draft, was) = if seed.is_multiple_of(3) {
        let (kind, _) = groups::KINDS[random.below(groups::KINDS.len())];
        groups::moving(kind, seed)
    } else {
        dyads::moving(seed)?
    };
    let pair = (0..20).find_map(|_| Pair::any(&draft, &mut random))?;
    draft.drivers = vec![pair.driver()];
    let mechanism = Mechanism::new(&draft).ok()?;
    Some(Driven {
        draft,
        pair,
        was,
        now: Motion::new(mechanism),
    })
}

#[test]
fn any_pair_leads_to_the_same_poses() {
    let mut checked = 0;
    for seed in 0..scaled(LINKAGES) {
        let Some(Driven { was, now, pair, .. }) = driven(seed) else {
            continue;
        };
        let (home, size) = (was.drawn_input(), was.mechanism().size());
        let poses = (was.pose::<4>(home), now.pose::<4>(now.drawn_input()));
        let (Ok(before), Ok(after)) = poses else {
            continue;
        };
        // Next to a dead point of either driver the other one can go on.
        if rate(was.mechanism(), &before).max(rate(now.mechanism(), &after)) > 20.0 {
            continue;
        }
        let coordinate = |pose: &Pose<1>| pair.coordinate(was.mechanism(), pose);
        let from = coordinate(&was.pose::<1>(home).unwrap());
        for off in [-2e-3, 0.0, 2e-3] {
            let Ok(pose) = was.pose::<1>(home + off) else {
                continue;
            };
            let same = now.pose::<1>(now.drawn_input() + coordinate(&pose) - from);
            let same = same.unwrap_or_else(|why| panic!("{seed} {off}: {why} {:?}", pair.driver()));
            for point in was.mechanism().point_ids() {
                let one = was.mechanism().place(&pose, point).place();
                let other = now.mechanism().place(&same, point).place();
                let by = (one - other).norm();
                assert!(by < 1e-9 * size, "{seed} {off} {:?}: {by}", pair.driver());
            }
            checked += 1;
        }
    }
    assert!(checked > scaled(100), "{checked}");
}

#[test]
fn driven_pairs_close_with_all_derivatives() {
    let mut checked = 0;
    for seed in 0..scaled(LINKAGES) {
        let Some(Driven { draft, now, .. }) = driven(seed) else {
            continue;
        };
        let mut random = Random::new(seed);
        let inputs = inputs(&now, &mut random);
        checked += closes(seed, &draft, &now, &inputs);
    }
    assert!(checked > scaled(400), "{checked}");
}

#[test]
fn any_pose_leads_to_the_same_motion() {
    let mut checked = 0;
    for seed in 0..scaled(LINKAGES) {
        let Some(Driven { draft, now, .. }) = driven(seed) else {
            continue;
        };
        let mut random = Random::new(seed);
        let inputs = inputs(&now, &mut random);
        checked += leads_to_itself(seed, &draft, &now, &inputs);
    }
    assert!(checked > scaled(200), "{checked}");
}
