//! Traced points on links.

use super::*;

/// A tracer is a point like any other, and changes nothing else: it follows its link through the
/// motion and through a redraw, in the link's own coordinates.
#[test]
fn tracers_follow_their_links() {
    let bare = four_bar([0.37, 0.85, 0.55, 0.85], 1.0, Assembly::First);
    let draft = bare
        .clone()
        .tracer("T", "coupler", 0.3, -0.2)
        .tracer("F", "frame", 0.1, 0.4);
    let [plain, mechanism] = [&bare, &draft].map(|draft| Mechanism::new(draft).unwrap());
    assert_eq!(mechanism.points().collect::<Vec<_>>()[4..], ["T", "F"]);
    assert_eq!(mechanism.structure(), plain.structure());
    assert_eq!(
        mechanism.signed_assemblies().count(),
        plain.signed_assemblies().count()
    );
    let [coupler, rocker] = ["coupler", "rocker"].map(|link| mechanism.link(link).unwrap());
    let [b, c, t, f] = ["B", "C", "T", "F"].map(|point| mechanism.point(point).unwrap());
    assert_eq!(mechanism.points_of(coupler), plain.points_of(coupler));
    assert!(Quantity::named(&mechanism, "T.x").is_some());
    let check = |mechanism: Mechanism, at: Vector| {
        let motion = Motion::new(mechanism);
        let mechanism = motion.mechanism();
        for input in [0.2, 1.0, 4.0] {
            let pose = motion.pose::<3>(input).unwrap();
            let [from, traced] = [b, t].map(|point| mechanism.place(&pose, point));
            let expected = from.offset(mechanism.angle(&pose, coupler), at.x, at.y);
            for order in 0..3 {
                let off = traced.derivative(order) - expected.derivative(order);
                assert!(off.norm() < 1e-13, "{input} {order}: {off}");
            }
            assert!(
                (mechanism.place(&pose, f).place() - Vector::new(0.1, 0.4))
                    .coords
                    .norm()
                    < 1e-15
            );
            assert_eq!(mechanism.carried(&pose, coupler, t), Some(traced));
            assert_eq!(mechanism.carried(&pose, rocker, t), None);
        }
        motion
    };
    let at = Vector::new(0.3, -0.2);
    let motion = check(mechanism, at);
    let mechanism = motion.mechanism();
    let pose = motion.pose::<1>(2.0).unwrap();
    let to = mechanism.place(&pose, c).place() + Vector::new(0.02, 0.05);
    let redrawn = mechanism.redrawn(&pose, c, to);
    check(Mechanism::new(&redrawn).unwrap(), at);
    // Drawn elsewhere itself, it has another place on its link.
    let to = Point::new(0.9, 0.1);
    let moved = Motion::new(Mechanism::new(&mechanism.redrawn(&pose, t, to)).unwrap());
    let there = moved.pose::<1>(2.0).unwrap();
    assert!((moved.mechanism().place(&there, t).place() - to).norm() < 1e-12);
}

/// On a part fixed to a link, and on a wheel, which turns the same with it and without.
#[test]
fn tracers_on_parts_and_wheels() {
    let mut draft = four_bar([0.37, 0.85, 0.55, 0.85], 1.0, Assembly::First)
        .point("E", 1.5, 0.0)
        .fixed(&["E"])
        .bar("wheel", &["E"])
        .bar("part", &["C", "D"])
        .tracer("T", "part", 0.1, 0.2)
        .tracer("W", "wheel", 0.1, 0.2);
    draft.links[4].fixed_to = Some("rocker".to_owned());
    draft.gears.push(GearSpec {
        links: ["rocker", "wheel"].map(str::to_owned),
        carrier: "frame".to_owned(),
        teeth: [30.0, 20.0],
        mesh: Mesh::External,
    });
    let motion = Motion::new(Mechanism::new(&draft).unwrap());
    let mechanism = motion.mechanism();
    let links = ["rocker", "wheel", "part"].map(|link| mechanism.link(link).unwrap());
    let points = ["C", "E", "T", "W"].map(|point| mechanism.point(point).unwrap());
    for input in [0.2, 1.0, 4.0] {
        let pose = motion.pose::<3>(input).unwrap();
        let [rocker, wheel, part] = links.map(|link| mechanism.angle(&pose, link));
        assert_eq!(wheel, rocker * -1.5);
        let [c, e, t, w] = points.map(|point| mechanism.place(&pose, point));
        for (found, from, angle) in [(t, c, part), (w, e, wheel)] {
            let expected = from.offset(angle, 0.1, 0.2);
            for order in 0..3 {
                let off = found.derivative(order) - expected.derivative(order);
                assert!(off.norm() < 1e-13, "{input} {order}: {off}");
            }
        }
    }
}

#[test]
fn bad_tracers_are_named() {
    let draft = four_bar([0.37, 0.85, 0.55, 0.85], 1.0, Assembly::First)
        .tracer("T", "coupler", f64::NAN, 0.0)
        .tracer("T", "shaft", 0.0, 0.0)
        .tracer("A", "crank", 0.0, 1e10);
    let name = |name: &str| name.to_owned();
    assert_eq!(
        Mechanism::new(&draft).unwrap_err(),
        [
            Defect::NotFinite { name: name("T") },
            Defect::Twice { name: name("T") },
            Defect::UnknownName {
                name: name("shaft")
            },
            Defect::Twice { name: name("A") },
            Defect::NotFinite { name: name("A") },
        ]
    );
    // A link cannot be hinged at one.
    let hinged = four_bar([0.37, 0.85, 0.55, 0.85], 1.0, Assembly::First)
        .tracer("T", "coupler", 0.1, 0.0)
        .bar("bar", &["T", "A"]);
    assert_eq!(
        Mechanism::new(&hinged).unwrap_err(),
        [Defect::UnknownName { name: name("T") }]
    );
}
