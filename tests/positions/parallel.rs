//! Verdicts where links are parallel to each other or to the frame.

use std::f64::consts::PI;

use assur::synthesis::four_bar::theorems::{
    Angles, Truth, Unknown, conditions, opening, theorems, third_pair, truth,
};

use super::theorems::angles;

/// True if some z ≥ 0 have the sum z₁e₁ + z₂e₂ + z₃e₃ = t: one of them or two suffice.
fn is_in_closed_cone(turns: [f64; 3], t: [f64; 2]) -> bool {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let e = turns.map(|turn| [turn.cos(), turn.sin()]);
    let alone = e.map(|e| cross(e, t).abs() < 1e-9 && e[0] * t[0] + e[1] * t[1] > 0.0);
    let pair = [[0, 1], [0, 2], [1, 2]].map(|[i, j]| {
        let across = cross(e[i], e[j]);
        let z = [cross(t, e[j]), -cross(t, e[i])];
        across.abs() > 1e-9 && z.iter().all(|z| z / across > -1e-9)
    });
    alone.contains(&true) || pair.contains(&true)
}

/// Where links are parallel, to each other or to the frame, all verdicts hold, too: at every set of multiples of 20° and
/// of 45°, and with the frame turned. Positive lengths exist just where the closed cone also contains e₀ less a little of
/// e₁ + e₂ + e₃.
#[test]
fn verdicts_where_links_are_parallel() {
    for (step, frame) in [(20, 0.0), (45, 0.0), (20, 0.37)] {
        let turns = || (0..360 / step).map(|k| f64::from(k * step).to_radians());
        for (coupler, output, input) in turns().flat_map(|one| {
            turns().flat_map(move |two| turns().map(move |three| (one, two, three)))
        }) {
            let off = [coupler, output, input];
            let angles = Angles {
                frame,
                coupler: frame + coupler,
                output: frame + output,
                input: frame + input,
            };
            let (mut x, mut y) = (1.0, 0.0);
            for turn in off {
                x -= 1e-3 * turn.cos();
                y -= 1e-3 * turn.sin();
            }
            let solvable = is_in_closed_cone(off, [x, y]);
            let border = is_in_closed_cone(off, [1.0, 0.0]);
            assert_eq!(truth(&angles).unwrap().holds(), solvable, "{angles:?}");
            let told = theorems(&angles).unwrap();
            let truths = told.map(|one| one.truth);
            assert_eq!(truths[2..], [border, solvable, border], "{angles:?}");
            // Theorem 5 is necessary, and with the pair exact where (13) holds.
            let by = angles.subsystem(Unknown::Coupler);
            let pair = third_pair(&angles).is_none_or(|pair| pair.holds);
            assert!(told[4].conditions || !border, "{angles:?}");
            assert!(
                by.is_none() || (told[4].conditions && pair) == border,
                "{angles:?}"
            );
            // The formula of the cone supposes that none of the three points along e₀.
            let along = off.contains(&0.0);
            let inside = opening(&angles).is_some_and(|opening| opening < PI - 1e-9);
            assert!(inside == solvable || along && !inside, "{angles:?}");
            let Some(by) = by else { continue };
            // One of three cases holds just where some z₁ ≥ 0 leaves z ≥ 0; they exclude each other but for P or Q = 0.
            let all = conditions(&angles);
            for (k, loose, numbers) in [(0, 14, [33, 34, 35]), (1, 25, [36, 37, 38])] {
                let (p, q) = (by.constant[k], by.slope[k]);
                let cases = all.iter().filter(|one| numbers.contains(&one.number));
                let holding = cases.clone().filter(|one| one.holds).count();
                let truth = p >= 0.0 || q > 0.0;
                assert_eq!(holding > 0, truth, "{angles:?}");
                assert!(holding < 2 || p == 0.0 || q == 0.0, "{angles:?}");
                let loose = all.iter().find(|one| one.number == loose).unwrap();
                assert!(cases.chain([loose]).all(|one| one.truth == truth));
                let excepted = q == 0.0 && p < 0.0;
                assert_eq!(loose.holds && !truth, excepted, "{angles:?}");
            }
        }
    }
}

/// The counterexamples of the texts to what holds only where no links are parallel.
#[test]
fn counterexamples_with_parallel_links() {
    let values = |degrees: [f64; 3], k: usize| {
        let by = angles(degrees).subsystem(Unknown::Coupler).unwrap();
        [by.constant[k], by.slope[k]]
    };
    let of = |degrees: [f64; 3], number: u8| {
        let all = conditions(&angles(degrees));
        let one = all.iter().find(|one| one.number == number).unwrap();
        (one.holds, one.truth)
    };
    // Q = 0 and P < 0: (14) and (25) hold, and no z₁ makes the length positive; nor does a case hold.
    for (degrees, k, p, loose) in [
        ([45.0, 90.0, 45.0], 0, -1.0, 14),
        ([225.0, 90.0, 45.0], 0, -1.0, 14),
        ([90.0, 90.0, 135.0], 1, -(2.0_f64.sqrt()), 25),
    ] {
        let [constant, slope] = values(degrees, k);
        assert!((constant - p).abs() < 1e-12 && slope == 0.0, "{degrees:?}");
        assert_eq!(of(degrees, loose), (true, false));
        let first = [33, 36][k];
        for number in first..first + 3 {
            assert_eq!(of(degrees, number), (false, false), "{degrees:?} {number}");
        }
    }
    // P₂ = 0: (33) and (34) both hold. (21) shows its bound for P₂ = 0 as well.
    let [constant, slope] = values([-30.0, 100.0, 0.0], 0);
    assert!(constant == 0.0 && slope > 0.0);
    assert_eq!(
        [33, 34, 35].map(|number| of([-30.0, 100.0, 0.0], number).0),
        [true, true, false]
    );
    // e₁ along e₀, the others on both sides of it: the formula of the cone would say 200°.
    let along = angles([0.0, 100.0, 260.0]);
    assert_eq!(opening(&along), None);
    let Some(Truth::Between { from, to: None }) = truth(&along) else {
        panic!("{:?}", truth(&along));
    };
    assert!((from - 1.0).abs() < 1e-12, "{from}");
    for k in 0..2 {
        let [constant, slope] = values([0.0, 100.0, 260.0], k);
        assert!((constant + 2.879).abs() < 5e-4 && (slope - 2.879).abs() < 5e-4);
    }
    // Output and input opposite: one l₁; links in line with the frame: a range of l₁.
    let single = truth(&angles([45.0, 90.0, 270.0])).unwrap().range();
    let (from, to) = single.unwrap();
    assert!((from - 2.0_f64.sqrt()).abs() < 1e-12 && to == Some(from));
    let line = |degrees| truth(&angles(degrees)).unwrap().range();
    assert_eq!(line([0.0, 0.0, 0.0]), Some((0.0, Some(1.0))));
    assert_eq!(line([0.0, 180.0, 180.0]), Some((1.0, None)));
    assert_eq!(line([180.0, 0.0, 360.0]), Some((0.0, None)));
    assert_eq!(line([180.0, 180.0, 180.0]), None);
}
