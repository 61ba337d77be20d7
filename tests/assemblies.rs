//! All ways to join linkages.

use std::f64::consts::TAU;

use assur::mechanism::{Draft, Mechanism, Method};
use assur_tests::Table;

#[path = "class4.rs"]
#[allow(dead_code)]
mod class4;

#[test]
fn the_class_iv_mechanism() {
    let _ = TAU;
    let mechanism = Mechanism::new(&class4::dwell()).unwrap();
    let output = mechanism.link("CD").unwrap();
    for row in include_str!("/work/shared/reference/class4_assemblies.csv")
        .lines()
        .skip(1)
    {
        let mut cells = row.split(',');
        let phi: f64 = cells.next().unwrap().parse().unwrap();
        let count: usize = cells.next().unwrap().parse().unwrap();
        let expected: Vec<f64> = cells
            .next()
            .unwrap()
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        let ways = mechanism.ways(phi.to_radians(), Method::Usual);
        let angle = |pose| {
            mechanism
                .angle(pose, output)
                .value()
                .to_degrees()
                .rem_euclid(360.0)
        };
        let mut found: Vec<f64> = ways.poses.iter().map(angle).collect();
        found.sort_by(f64::total_cmp);
        println!(
            "{phi} {count} {} {:?}",
            found.len(),
            found
                .iter()
                .zip(&expected)
                .map(|(a, b)| (a - b).to_radians())
                .collect::<Vec<_>>()
        );
        assert_eq!(found.len(), count);
    }
    let _ = Table::parse("a\n1\n");
    let _ = Draft::default();
}
