//! Drawings that nearly have redundant constraints.

use super::*;

/// Spoiled by more than rounding they are refused.
#[test]
fn spoiled_ones_are_refused() {
    let mut random = Random::new(36);
    for family in families() {
        let Some(point) = family.spoils else { continue };
        for seed in 0..scaled(EACH) {
            let mut draft = (family.drawn)(&mut random);
            let off = size(&draft) * 10_f64.powf(random.within(-6.0, -1.5));
            let way = turned(random.within(0.0, TAU), off);
            let spoiled = draft.points.iter_mut().find(|one| one.name == point);
            spoiled.unwrap().at += way;
            let name = family.name;
            let defects = Mechanism::new(&draft).err().unwrap_or_default();
            let locked =
                |defect: &Defect| matches!(defect, Defect::Locked { .. } | Defect::Instant { .. });
            assert!(defects.iter().any(locked), "{name} {seed}: {defects:?}");
        }
    }
}

/// Whether the cranks are drawn within half a degree of a pose in line with their pivots, if they are cranks on a rod.
fn is_in_line(draft: &LinkageSpec) -> bool {
    let place = |name: &str| draft.points.iter().find(|point| point.name == name);
    let [Some(a), Some(b), Some(c)] = ["A0", "A1", "B0"].map(place) else {
        return false;
    };
    let [line, crank] = [b.at - a.at, c.at - a.at].map(|way| way.normalize());
    line.perp(&crank).abs() < 0.5_f64.to_radians()
}

/// As files with four decimals have them: made exact they move, and no point has moved by more than a few of these. A
/// drawing in line may have no offer: there the rounding outweighs the shape.
#[test]
fn nearly_exact_ones_are_made_exact() {
    let mut random = Random::new(37);
    for family in families()
        .into_iter()
        .filter(|family| family.spoils.is_some())
    {
        for seed in 0..scaled(EACH) / 4 {
            let name = family.name;
            let mut draft = (family.drawn)(&mut random);
            for point in &mut draft.points {
                point.at = (point.at * 1e4).map(f64::round) / 1e4;
            }
            if Mechanism::new(&draft).is_ok() {
                continue;
            }
            let Some(exact) = draft.made_exact() else {
                assert!(is_in_line(&draft), "{name} {seed}: {:?}", draft.points);
                continue;
            };
            // Near a singular pose more than the last digit has to change.
            let most = NEARLY * size(&draft);
            assert!(exact.by <= most, "{name} {seed}: {}", exact.by);
            let motion = Motion::new(Mechanism::new(&exact.spec).unwrap());
            assert_eq!(motion.cycle().is_full(), family.turns, "{name} {seed}");
        }
    }
}

/// Parallel cranks of other lengths let their rod move in the drawn pose only; cranks that are not parallel not even there.
#[test]
fn unequal_cranks_are_mobile_for_an_instant() {
    let cranks = |turns: [f64; 3]| {
        let mut draft = LinkageSpec::default();
        for (k, (length, turn)) in [1.0, 1.2, 0.8].into_iter().zip(turns).enumerate() {
            let (x, y) = (2.0 * k as f64, 0.3 * k as f64);
            let end = [x + length * f64::cos(turn), y + length * f64::sin(turn)];
            draft = draft.point(&format!("A{k}"), x, y);
            draft = draft.point(&format!("B{k}"), end[0], end[1]);
        }
        let draft = draft
            .fixed(&["A0", "A1", "A2"])
            .bar("rod", &["B0", "B1", "B2"]);
        let draft = draft
            .bar("crank", &["A0", "B0"])
            .bar("second", &["A1", "B1"]);
        draft.bar("third", &["A2", "B2"]).crank("crank")
    };
    let defects = |turns| Mechanism::new(&cranks(turns)).unwrap_err();
    let instant = |defect: &Defect| matches!(defect, Defect::Instant { links } if links.len() == 5);
    assert!(
        defects([1.0; 3]).iter().all(instant),
        "{:?}",
        defects([1.0; 3])
    );
    let locked = |defect: &Defect| matches!(defect, Defect::Locked { .. });
    assert!(defects([1.0, 1.4, 0.9]).iter().all(locked));
}

/// A pose that is looked at beside the drawn one may be in line: the cranks turn fully all the same.
#[test]
fn a_pose_beside_the_drawn_one_may_be_in_line() {
    let mut random = Random::new(38);
    for cranks in 3..=6 {
        for aside in [-0.02, -7e-3, -1e-3, 1e-3, 7e-3, 0.05] {
            for aside in [aside, aside + 1e-7] {
                let along = random.within(0.0, TAU);
                let draft = drawn_rods(&mut random, true, cranks, [along, along + aside]);
                let motion = Motion::new(Mechanism::new(&draft).unwrap());
                assert!(motion.cycle().is_full(), "{cranks} cranks {aside}");
            }
        }
    }
}

/// Six cranks drawn with four decimals, three degrees from in line.
#[test]
fn a_drawing_near_in_line_is_made_exact() {
    let pivots = [
        [0.7285, -0.1718],
        [1.6824, -0.3968],
        [3.8784, -0.9147],
        [5.5156, -1.3008],
        [7.4113, -1.7478],
        [8.6789, -2.0468],
    ];
    let ends = [
        [-0.1645, 0.0893],
        [0.7893, -0.1357],
        [2.9853, -0.6536],
        [4.6226, -1.0397],
        [6.5182, -1.4868],
        [7.7858, -1.7857],
    ];
    let mut draft = drawn_rods(&mut Random::new(0), true, 6, [0.0, 1.0]);
    for (name, at) in ["A", "B"].into_iter().zip([pivots, ends]) {
        for (k, at) in at.into_iter().enumerate() {
            let name = format!("{name}{k}");
            let drawn = draft.points.iter_mut().find(|point| point.name == name);
            drawn.unwrap().at = Point::new(at[0], at[1]);
        }
    }
    let exact = draft.made_exact().unwrap();
    assert!(exact.by <= 1e-3, "{}", exact.by);
    let motion = Motion::new(Mechanism::new(&exact.spec).unwrap());
    assert!(motion.cycle().is_full());
}

/// A point of the frame far off makes no two links one body.
#[test]
fn a_link_that_nearly_doubles_another_is_not_one_body_with_it() {
    let draft = doubled(&mut Random::new(43), ["B", "C"]).point("Z", 1e6, 0.0);
    let mut draft = draft.fixed(&["Z"]);
    let mechanism = Mechanism::new(&draft).unwrap();
    let coupler = Dimension::Length(mechanism.link("coupler").unwrap());
    let length = mechanism.value(coupler).unwrap();
    for (name, length) in [("coupler", length), ("double", length + 1e-3)] {
        let link = draft.links.iter_mut().find(|link| link.name == name);
        link.unwrap().shape = Some(vec![Point::origin(), Point::new(length, 0.0)]);
    }
    let defects = Mechanism::new(&draft).unwrap_err();
    assert!(
        matches!(defects[..], [Defect::Locked { .. }]),
        "{defects:?}"
    );
}

/// What the frame, or a plate on which another link lies, keeps is no dimension of a link that doubles it.
#[test]
fn dimensions_that_others_keep() {
    let mut random = Random::new(44);
    let mechanism = Mechanism::new(&doubled(&mut random, ["A", "D"])).unwrap();
    let [crank, double] = ["crank", "double"].map(|name| mechanism.link(name).unwrap());
    let [a, d] = ["A", "D"].map(|name| mechanism.point(name).unwrap());
    assert!(mechanism.value(Dimension::Length(crank)).is_some());
    for none in [Dimension::Length(double), Dimension::X(a), Dimension::Y(d)] {
        assert_eq!(mechanism.value(none), None, "{none:?}");
    }
    let mut draft = doubled(&mut random, ["B", "C"]).point("E", 1.5, 2.5);
    draft = draft.point("M", 1.0, 2.0).bar("arm", &["M", "E"]);
    for link in &mut draft.links {
        match &*link.name {
            "coupler" | "double" => link.points.push("M".to_owned()),
            "arm" => link.fixed_to = Some("double".to_owned()),
            _ => {}
        }
    }
    let mechanism = Mechanism::new(&draft).unwrap();
    let coupler = mechanism.link("coupler").unwrap();
    for none in [
        Dimension::Length(coupler),
        Dimension::Side(coupler, [0, 2]),
        Dimension::Corner(coupler, 2),
    ] {
        assert_eq!(mechanism.value(none), None, "{none:?}");
    }
}

/// The change points of parallelograms, whatever their size: one at each end of the turn.
#[test]
fn change_points_at_the_beginning_of_a_turn_are_found() {
    let mut random = Random::new(46);
    for scale in [1.0, 1e6, 1e-6] {
        for _ in 0..scaled(100) {
            let base = Vector::new(random.within(1.5, 3.5) * scale, 0.0);
            let arm = turned(random.within(0.1, 3.0), random.within(0.4, 1.2) * scale);
            let draft = with(LinkageSpec::default().point("A", 0.0, 0.0), "D", base);
            let draft = with(with(draft, "B", arm), "C", base + arm)
                .fixed(&["A", "D"])
                .bar("crank", &["A", "B"])
                .bar("coupler", &["B", "C"])
                .bar("rocker", &["D", "C"])
                .crank("crank");
            let motion = Motion::new(Mechanism::new(&draft).unwrap());
            assert_eq!(motion.change_points().len(), 2, "{draft:?}");
        }
    }
}
