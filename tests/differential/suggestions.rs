//! Suggested trains: each can be built, and those that differ least from the given train come first.

use assur::gears::train::{Coupling, Layout, Member, Train};

const MEMBERS: [Member; 4] = [Member::Sun, Member::Satellite, Member::Step, Member::Ring];

/// By how many teeth two planar or bevel trains differ.
fn difference(one: &Train, other: &Train) -> u32 {
    let members = [Member::Sun, Member::Satellite, Member::Ring];
    let each = members.map(|member| one.teeth(member).abs_diff(other.teeth(member)));
    each.iter().sum()
}

#[test]
fn they_can_be_built_and_differ_least() {
    for (teeth, k) in [
        ([20.0, 18.0, 60.0], 3.0),
        ([19.0, 21.0, 60.0], 5.0),
        ([20.0, 22.0, 60.0], 4.0),
        ([12.0, 50.0, 60.0], 6.0),
    ] {
        for coupling in [Coupling::Contact, Coupling::Magnetic] {
            let train = Train::planar(teeth).unwrap();
            let layout = Layout::new(train, k, 1.0, None).unwrap();
            let found = layout.suggestions(coupling, 8);
            assert_eq!(found.len(), 8, "{teeth:?}");
            for pair in found.windows(2) {
                assert!(pair[0].change <= pair[1].change);
                assert_ne!(pair[0].train, pair[1].train);
            }
            for one in &found {
                let other = Layout::new(one.train, k, 1.0, None).unwrap();
                assert!(other.can_be_built(coupling));
                assert_eq!(one.change, difference(&train, &one.train));
            }
            // None that differs less was passed over: all around are tried.
            let least = found[0].change as i32;
            for change in all_below(least) {
                let changed = [0, 1, 2].map(|i| teeth[i] + f64::from(change[i]));
                let Ok(other) = Train::planar(changed) else {
                    continue;
                };
                let other = Layout::new(other, k, 1.0, None).unwrap();
                assert!(!other.can_be_built(coupling), "{teeth:?}: {changed:?}");
            }
        }
    }
}

fn all_below(total: i32) -> impl Iterator<Item = [i32; 3]> {
    let all = -total..=total;
    let triples = all.clone().flat_map(move |a| {
        let all = all.clone();
        all.clone()
            .flat_map(move |b| all.clone().map(move |c| [a, b, c]))
    });
    triples.filter(move |triple| triple.iter().map(|change| change.abs()).sum::<i32>() < total)
}

#[test]
fn what_can_be_built_comes_first_itself() {
    let train = Train::in_contact([20.0, 60.0]).unwrap().unwrap();
    let layout = Layout::new(train, 4.0, 1.0, None).unwrap();
    let found = layout.suggestions(Coupling::Contact, 3);
    assert_eq!((found[0].train, found[0].change), (train, 0));
    assert!(layout.suggestions(Coupling::Contact, 0).is_empty());
}

#[test]
fn stepped_and_bevel_trains_have_them_too() {
    let stepped = Train::stepped([20.0, 30.0, 18.0, 70.0]).unwrap();
    let layout = Layout::new(stepped, 3.0, 1.0, None).unwrap();
    let found = layout.suggestions(Coupling::Contact, 3);
    assert_eq!(found.len(), 3);
    for one in found {
        let other = Layout::new(one.train, 3.0, 1.0, None).unwrap();
        assert!(other.can_be_built(Coupling::Contact));
        let [z1, z2, step, z4] = MEMBERS.map(|member| one.train.teeth(member));
        assert_eq!(z1 + z2 + step, z4);
    }
    let bevel = Train::bevel([17.0, 10.0, 18.0]).unwrap();
    let layout = Layout::new(bevel, 2.0, 1.0, None).unwrap();
    let found = layout.suggestions(Coupling::Contact, 2);
    assert_eq!(found[0].change, 1);
    assert_eq!(
        (found[0].train.teeth(Member::Sun) + found[0].train.teeth(Member::Ring)) % 2,
        0
    );
}
