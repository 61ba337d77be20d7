//! Positions of the points of groups of higher classes after a quarter turn.

use std::f64::consts::PI;

use assur::Point;

use super::moved;

/// Where the points of the higher groups are after a quarter turn: found by
/// Newton's method on distances, apart from this program.
#[test]
fn higher_groups_after_a_quarter_turn() {
    type Places = &'static [(&'static str, f64, f64)];
    let expected: [(&str, Places); 5] = [
        (
            "stephenson-2",
            &[
                ("P", 3.362_168_137_461_875_7, 0.386_953_985_873_702_33),
                ("Q", 1.491_299_994_177_627_5, 2.732_130_395_111_215),
                ("R", 4.096_112_983_695_771, 2.609_863_107_427_416),
            ],
        ),
        (
            "class3-platform",
            &[
                ("P", 0.284_484_673_318_737_16, 2.481_241_204_802_492),
                ("Q", 5.420_542_565_544_927_5, 3.243_415_284_459_534),
                ("R", 2.831_738_348_045_853_6, 5.888_806_129_582_237),
            ],
        ),
        (
            "class3-slide",
            &[
                ("P", 3.543_440_963_566_161, 2.324_536_499_387_970_7),
                ("Q", 5.256_295_021_042_122, 2.886_791_759_735_203_3),
                ("R", 3.114_335_931_906_519, 5.534_812_012_767_528),
            ],
        ),
        (
            "class4-order2",
            &[
                ("C", 1.236_022_579_819_072_3, 0.647_414_999_498_103_5),
                ("E", 2.500_316_640_856_836, 3.754_111_078_490_164),
                ("F", 6.116_152_520_766_838, 3.046_233_825_392_458),
                ("H", 3.435_083_554_909_198_3, 2.669_578_544_910_361_3),
            ],
        ),
        (
            "class5",
            &[
                ("P", 2.068_659_577_885_342, 2.214_831_639_206_379_6),
                ("Q", 3.906_988_263_066_399, 2.238_233_460_513_406),
                ("R", 4.811_813_130_519_115, 2.202_289_626_004_898_5),
                ("S", 3.799_132_835_610_808_3, 4.837_527_493_884_082),
                ("T", 1.560_784_218_998_869_7, 5.375_854_040_239_934),
                ("U", 5.738_094_987_325_756, 5.973_496_584_228_067),
            ],
        ),
    ];
    for (name, places) in expected {
        let motion = moved(name);
        let pose = motion.pose::<1>(PI / 2.0).unwrap();
        for (point, x, y) in places {
            let index = motion.mechanism().point(point).unwrap();
            let off = motion.mechanism().place(&pose, index).place() - Point::new(*x, *y);
            assert!(off.norm() < 1e-12, "{name} {point}: {off:?}");
        }
    }
}
