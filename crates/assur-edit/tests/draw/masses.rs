//! Masses and centres of mass of the links of a drawing.

use super::*;

/// A centre of mass is put at coordinates on its link. It is a point of its own, which moves with further edits.
#[test]
fn a_centre_of_mass_is_put_on_its_link() {
    let drawn = four_bar();
    // The added point changes the name of a link that is named after its points.
    let centre = |of: &LinkageDocument, on| Edit::Centre {
        link: of.links[1].name.clone(),
        on,
    };
    let once = done(&drawn, &[centre(&drawn, [1.0, 0.5])]);
    let twice = done(&once, &[centre(&once, [2.0, 0.0])]);
    assert_eq!(once.points.len(), drawn.points.len() + 1);
    assert_eq!(twice.points.len(), once.points.len());
    // The link goes from (0, 1) to (3, 2.5).
    let along = 3.0_f64.hypot(1.5);
    let [x, y] = [3.0 / along, 1.5 / along];
    for (document, on) in [(&once, [1.0, 0.5]), (&twice, [2.0, 0.0])] {
        let centre = document.links[1].centre_of_mass.as_ref().unwrap();
        let found = document.points.iter().find(|point| point.name == *centre);
        let [fx, fy] = found.unwrap().at;
        let [ex, ey] = [x * on[0] - y * on[1], 1.0 + y * on[0] + x * on[1]];
        assert!(
            (fx - ex).abs() < 1e-14 && (fy - ey).abs() < 1e-14,
            "{fx} {fy}"
        );
    }
}

/// A joint that serves as the centre of mass is not moved; a new point is added instead.
#[test]
fn a_joint_is_not_moved_as_a_centre_of_mass() {
    let mut drawn = four_bar();
    drawn.links[1].centre_of_mass = drawn.links[1].points.first().cloned();
    let link = drawn.links[1].name.clone();
    let on = [1.0, 0.0];
    let put = done(&drawn, &[Edit::Centre { link, on }]);
    assert_eq!(put.points.len(), drawn.points.len() + 1);
    assert_eq!(put.points[..drawn.points.len()], drawn.points[..]);
}

#[test]
fn a_uniform_bar_has_the_mass_of_its_volume() {
    let mut drawn = four_bar();
    drawn.links[0].inertia = Some(1.0);
    drawn.links[0].mass_kg = Some(1.0);
    let link = drawn.links[0].name.clone();
    let edit = Edit::Uniform {
        link,
        section: 0.01,
        density: 7850.0,
    };
    let bar = done(&drawn, &[edit]);
    assert_eq!(bar.links[0].mass_kg, Some(78.5));
    assert_eq!(bar.links[0].inertia, None);
}
