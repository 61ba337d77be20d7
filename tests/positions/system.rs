//! The linear system of the paper, and the minimum of the functional.

use assur::synthesis::four_bar::theorems::{Angles, System, functional, truth};
use assur::synthesis::four_bar::{Position, TwoPositions};

use super::draw::{Dice, task};
use super::theorems::angles;

/// One position: a Gram matrix of plane vectors, of rank two, or one where all are parallel; its
/// least ΣJ is nothing. More positions have rank three.
#[test]
fn ranks_of_the_system() {
    let mut dice = Dice::new(347);
    for _ in 0..2000 {
        let one = |dice: &mut Dice| Angles {
            frame: dice.angle(),
            coupler: dice.angle(),
            output: dice.angle(),
            input: dice.angle(),
        };
        let [a, b] = [one(&mut dice), one(&mut dice)];
        let single = System::new(&[a]).unwrap();
        assert_eq!((single.rank, single.minimum()), (2, None));
        assert_eq!(single.augmented_rank(), 2);
        // With another right-hand side it could not be solved.
        let right = [1.0 + single.right[0], single.right[1], single.right[2]];
        assert_eq!(System { right, ..single }.augmented_rank(), 3);
        let both = System::new(&[a, b]).unwrap();
        assert_eq!((both.rank, both.augmented_rank()), (3, 3));
        let least = both.minimum().unwrap();
        let sum = |z: [f64; 3]| functional(&a, z) + functional(&b, z);
        let size = least.iter().fold(1.0, |most: f64, z| most.max(z.abs()));
        assert!((both.value(least) - sum(least)).abs() < 1e-12 * size * size);
        let positive = both.positive_minimum();
        assert!(positive.z.iter().all(|z| *z >= 0.0));
        assert!((positive.value - sum(positive.z)).abs() < 1e-12 * (1.0 + sum(positive.z)));
        assert!(positive.value >= sum(least) - 1e-12 * size * size);
        for _ in 0..20 {
            let near = positive.z.map(|z| (z + dice.between(-0.1, 0.1)).max(0.0));
            assert!(sum(near) >= positive.value - 1e-12);
        }
    }
    let line = System::new(&[angles([30.0, 210.0, 30.0])]).unwrap();
    assert_eq!((line.rank, line.augmented_rank()), (1, 1));
    assert_eq!(System::new(&[]), None);
}

/// The lemma: where the least J over z ≥ 0 is nothing there are positive lengths, and only there; not on the border of the cone,
/// where no z > 0 has it. The same of the least ΣJ of two positions.
#[test]
fn least_functional_is_nothing_where_lengths_close() {
    let mut dice = Dice::new(349);
    let mut seen = [0; 2];
    for _ in 0..2000 {
        let one = Angles {
            frame: dice.angle(),
            coupler: dice.angle(),
            output: dice.angle(),
            input: dice.angle(),
        };
        let least = System::new(&[one]).unwrap().positive_minimum();
        let size = least.z.iter().fold(1.0, |most: f64, z| most.max(*z));
        let solvable = truth(&one).unwrap().holds();
        assert_eq!(least.value < 1e-13 * size * size, solvable, "{least:?}");
        assert!((functional(&one, least.z) - least.value).abs() < 1e-12 * size * size);
        seen[usize::from(solvable)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 800), "{seen:?}");
    let border = angles([0.0, 30.0, 45.0]);
    let least = System::new(&[border]).unwrap().positive_minimum();
    assert!(least.value < 1e-30 && least.z[1..] == [0.0; 2], "{least:?}");
    assert!(!truth(&border).unwrap().holds());

    // Two positions: the least ΣJ is nothing at the lengths of the linkage that takes up both, and with another φ₁ it is not.
    let positions = [[240.0_f64, 45.0], [253.0, 60.0]].map(|p| p.map(f64::to_radians));
    let task = task(&positions.map(|[output, input]| Position::new(output, input)));
    let Some(TwoPositions::Family(family)) = TwoPositions::new(&task) else {
        panic!("no family");
    };
    let exact = family.with_output(0.5).unwrap();
    let at = |off: f64| {
        let all = exact.closures.iter().zip(positions);
        let all: Vec<Angles> = all
            .map(|(closure, [output, input])| Angles {
                frame: 0.0,
                coupler: closure.coupler + off,
                output,
                input,
            })
            .collect();
        System::new(&all).unwrap().positive_minimum()
    };
    let least = at(0.0);
    let z = exact.proportions;
    for (found, expected) in least.z.into_iter().zip([z.coupler, z.output, z.input]) {
        assert!((found - expected).abs() < 1e-9, "{least:?}");
    }
    assert!(least.value < 1e-13 && at(0.2).value > 1e-5, "{:?}", at(0.2));
}
