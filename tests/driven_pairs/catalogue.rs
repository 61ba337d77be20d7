//! The linkages of the catalogue, driven by each of their pairs in turn.

use assur::mechanism::{Defect, FRAME, LinkageSpec, Mechanism};
use assur::motion::Motion;

use super::{angle, assert_smooth, motion, moved, on_line, place, turned};

/// Every pair between moving links of the catalogue's linkages, as the driver of the same linkage from the same pose:
/// its poses are those of the motion as it was, with derivatives by the other input.
#[test]
fn any_pair_of_the_catalogue_drives() {
    let mut tried = 0;
    for name in assur_file::catalogue() {
        let draft = assur_file::from_catalogue(name).unwrap().unwrap().spec();
        let as_it_was = motion(&draft);
        let Some(input) = regular(&as_it_was) else {
            continue;
        };
        if draft.drivers.len() > 1 {
            continue;
        }
        let pose = as_it_was.pose::<1>(input).unwrap();
        let drawn = LinkageSpec {
            drivers: Vec::new(),
            ..as_it_was.mechanism().drawn_in(&pose)
        };
        for (k, slide) in drawn.slides.iter().enumerate() {
            if slide.on != FRAME {
                let line = [&slide.line[0], &slide.line[1], &slide.point].map(String::as_str);
                let way = |input| on_line(&as_it_was, line, input)[0];
                let wide = [way(input) - 1e6, way(input) + 1e6];
                let driven = moved(drawn.clone(), k, wide, 1.0);
                tried += usize::from(drives(&as_it_was, input, &driven, way, name));
            }
        }
        for (k, link) in drawn.links.iter().enumerate() {
            for base in &drawn.links[..k] {
                let angles = |input: f64| {
                    [&link.name, &base.name].map(|name| angle(&as_it_was, name, input)[0])
                };
                let against = |input: f64| {
                    let [link, base] = angles(input);
                    link - base
                };
                let driven = turned(drawn.clone(), &link.name, &base.name, 1.0);
                tried += usize::from(drives(&as_it_was, input, &driven, against, name));
            }
        }
    }
    assert!(tried > 80, "{tried}");
}

/// An input where a motion is far from its ends.
fn regular(motion: &Motion) -> Option<f64> {
    let [from, to] = motion.cycle().axis();
    let input = if motion.dead_points().is_empty() {
        motion.drawn_input() + 0.3
    } else {
        0.45 * from + 0.55 * to
    };
    motion.pose::<3>(input).ok().map(|_| input)
}

/// Whether another driver drives a linkage; then it must do so as the one before, from an input of that one on.
fn drives(
    was: &Motion,
    input: f64,
    draft: &LinkageSpec,
    coordinate: impl Fn(f64) -> f64,
    name: &str,
) -> bool {
    let mechanism = match Mechanism::new(draft) {
        Ok(mechanism) => mechanism,
        // No pair at all, or one that does not move, or more wheels than it may have.
        Err(defects) => {
            let known = |defect: &Defect| {
                matches!(
                    defect,
                    Defect::NotHinged { .. }
                        | Defect::WithItself { .. }
                        | Defect::Locked { .. }
                        | Defect::Underdriven { .. }
                )
            };
            assert!(
                defects.iter().all(known),
                "{name} {:?}: {defects:?}",
                draft.drivers
            );
            return false;
        }
    };
    let what = format!("{name} {:?}", draft.drivers);
    let now = Motion::new(mechanism);
    let h = 1e-4 * was.mechanism().size().min(1.0);
    let rate = (coordinate(input + h) - coordinate(input - h)) / (2.0 * h);
    if rate.abs() < 0.05 {
        return false;
    }
    for off in [0.0, 0.01, -0.01] {
        let by = coordinate(input + off) - coordinate(input);
        let pose = now.pose::<1>(now.drawn_input() + by);
        let pose = pose.unwrap_or_else(|why| panic!("{what} {off}: {why}"));
        for point in was.mechanism().points() {
            let found = now
                .mechanism()
                .place(&pose, now.mechanism().point(point).unwrap())
                .place();
            let exact = place(was, point, input + off)[0];
            assert!(
                (found.coords - exact).norm() < 1e-9 * was.mechanism().size(),
                "{what} {point} {off}"
            );
        }
    }
    assert_smooth(&now, now.drawn_input(), 1e-4);
    true
}
