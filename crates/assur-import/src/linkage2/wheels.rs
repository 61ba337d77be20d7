//! Two wheels in mesh, or with a chain around them.

use assur_file::MeshDocument;

use super::convert::Conversion;
use super::parts::{Parts, Ratio};
use crate::LeftOut;
use crate::sketch::{Body, Gear};

/// Permitted numbers of teeth (docs/file-format.md).
const TEETH: std::ops::RangeInclusive<u32> = 3..=1000;

/// Preferred minimum number of teeth. A wheel with fewer teeth hardly looks like a wheel, but some ratios require it.
const SEEMLY: u32 = 12;

pub(super) fn mesh(conversion: &mut Conversion<'_>, ratio: &Ratio) {
    let links = ratio.links.map(|id| conversion.link(id));
    let name = |conversion: &Conversion<'_>, link: Option<usize>| match link {
        Some(link) => Parts::called(&conversion.parts.links[link]),
        None => "?".to_owned(),
    };
    let names: Vec<String> = links.iter().map(|link| name(conversion, *link)).collect();
    let Some((bars, carrier)) = joined(conversion, links) else {
        conversion.sketch.left_out.push(LeftOut::Wheels { names });
        return;
    };
    let Some((teeth, exact)) = teeth(ratio.sizes) else {
        conversion.sketch.left_out.push(LeftOut::Wheels { names });
        return;
    };
    if !exact {
        let ratio = ratio.sizes[0] / ratio.sizes[1];
        conversion.sketch.left_out.push(LeftOut::Teeth {
            names: names.clone(),
            ratio,
        });
    }
    let mesh = if ratio.chain {
        MeshDocument::AsPrinted
    } else {
        MeshDocument::External
    };
    if ratio.chain {
        conversion.sketch.left_out.push(LeftOut::Chain { names });
    }
    conversion.sketch.gears.push(Gear {
        bars,
        carrier,
        teeth,
        mesh,
    });
}

/// Finds the bars of two wheels and the wheels' common carrier.
fn joined(conversion: &Conversion<'_>, links: [Option<usize>; 2]) -> Option<([usize; 2], Body)> {
    let [Some(a), Some(b)] = links.map(|link| conversion.bars[link?]) else {
        return None;
    };
    let axis = |bar: usize| conversion.sketch.bars[bar].joints.first().copied();
    let axes = [axis(a)?, axis(b)?];
    if a == b || axes[0] == axes[1] {
        return None;
    }
    Some(([a, b], conversion.shared(axes)?))
}

/// Finds permitted numbers of teeth with a ratio nearest to the ratio of the sizes. The flag is true if the ratios are
/// equal. None if the ratio of the sizes is beyond that of any permitted numbers.
fn teeth(sizes: [f64; 2]) -> Option<([f64; 2], bool)> {
    let ratio = sizes[0] / sizes[1];
    let within = f64::from(*TEETH.start()) / f64::from(*TEETH.end());
    if !(within..=1.0 / within).contains(&ratio) {
        return None;
    }
    let other = |second: u32| (f64::from(second) * ratio).round();
    let fits = |second: &u32| {
        (f64::from(*TEETH.start())..=f64::from(*TEETH.end())).contains(&other(*second))
    };
    let off = |second: u32| (other(second) / f64::from(second) / ratio - 1.0).abs();
    let all = || TEETH.filter(fits);
    let least = all().map(off).fold(f64::INFINITY, f64::min);
    // Ratios this close count as equal: sizes are given to six decimals only.
    let near = |second: &u32| off(*second) <= least + 1e-9;
    let seemly = |second: &u32| *second >= SEEMLY && other(*second) >= f64::from(SEEMLY);
    let second = all()
        .filter(seemly)
        .find(near)
        .or_else(|| all().find(near))?;
    Some(([other(second), f64::from(second)], off(second) < 1e-6))
}

#[cfg(test)]
mod tests {
    use super::teeth;

    #[test]
    fn teeth_are_in_the_ratio_of_sizes() {
        assert_eq!(teeth([2.0, 1.0]), Some(([24.0, 12.0], true)));
        assert_eq!(teeth([25.0, 25.0]), Some(([12.0, 12.0], true)));
        assert_eq!(teeth([8.0, 3.0]), Some(([32.0, 12.0], true)));
        assert_eq!(teeth([100.0, 1.0]), Some(([300.0, 3.0], true)));
        let (near, exact) = teeth([std::f64::consts::SQRT_2, 1.0]).unwrap();
        assert!(
            !exact && (near[0] / near[1] - std::f64::consts::SQRT_2).abs() < 1e-5,
            "{near:?}"
        );
        for none in [[1.0, 0.0], [0.0, 1.0], [1.0, 1e4], [f64::NAN, 1.0]] {
            assert_eq!(teeth(none), None);
        }
    }
}
