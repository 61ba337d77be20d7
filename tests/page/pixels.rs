//! What is drawn stands where the engine says: bars to scale, wheels in place,
//! curves on their axes.

use assur::mixer::{Case, Mixer};
use assur::{Assembly, Link, Offset, Point, Pose};

use crate::browser::Page;
use crate::picture::{COUPLER, Cloud, ROCKER, WHEEL5, apart};

const LENGTHS: [f64; 4] = [0.37, 0.85, 0.55, 0.85];

/// The coupler's bar on the screen: only it has its colour.
async fn coupler(page: &Page, degrees: f64) -> Cloud {
    page.write("angle", &degrees.to_string()).await;
    page.picture("mechanism").await.cloud(COUPLER)
}

fn mixer() -> Mixer {
    Mixer::new(&Case::A.dimensions()).unwrap()
}

fn pose(degrees: f64, assembly: Assembly) -> Pose<1> {
    mixer()
        .linkage
        .pose(assembly, degrees.to_radians())
        .unwrap()
}

/// The middle of the coupler; of its bar hinges hide as much at either end.
fn middle(degrees: f64, assembly: Assembly) -> Point {
    let pose = pose(degrees, assembly);
    mixer()
        .linkage
        .carried(&pose, Link::Coupler, Offset::MIDDLE)
        .place()
}

#[tokio::test]
async fn mechanism_is_drawn_to_scale() {
    let page = Page::open().await;
    page.stop_at("0").await;
    page.click("traces").await;
    for (assembly, id) in [
        (Assembly::First, "assembly-1"),
        (Assembly::Second, "assembly-2"),
    ] {
        page.click(id).await;
        let mut bars = Vec::new();
        // Not where crank and coupler overlap. The second assembly is the first in
        // the mirror.
        for degrees in [60.0, 100.0, 150.0, 300.0] {
            let degrees = match assembly {
                Assembly::First => degrees,
                Assembly::Second => 360.0 - degrees,
            };
            let bar = coupler(&page, degrees).await;
            let angle = pose(degrees, assembly).coupler.value().to_degrees();
            assert!(bar.count > 500, "{bar:?}");
            assert!(apart(bar.direction, angle) < 0.7, "{degrees}° {bar:?}");
            bars.push((bar, middle(degrees, assembly)));
        }
        // Two positions give scale and origin; the others must agree with them,
        // and so must wheel 5 on the end of the centre line.
        let [(right, m), _, (left, n), _] = bars[..] else {
            panic!("four bars")
        };
        let (right, left) = (right.middle, left.middle);
        let scale = (right.0 - left.0).hypot(right.1 - left.1) / (m - n).norm();
        let off = |place: (f64, f64), p: Point| {
            let (x, y) = (right.0 + scale * (p.x - m.x), right.1 - scale * (p.y - m.y));
            (place.0 - x).hypot(place.1 - y)
        };
        for (bar, middle) in &bars {
            assert!(off(bar.middle, *middle) < 2.5, "{bar:?} {middle}");
            let seen = bar.length / (scale * LENGTHS[1]);
            assert!((0.93..0.98).contains(&seen), "{bar:?} {scale}");
        }
        let centre = Point::new(LENGTHS[3], 0.0) + mixer().gears.pairs()[0].driven_wheel().centre;
        let wheel = page.picture("mechanism").await.cloud(WHEEL5);
        assert!(wheel.count > 200, "{wheel:?}");
        assert!(off((wheel.x, wheel.y), centre) < 4.0, "{wheel:?} {centre}");
    }
    page.close().await;
}

/// Wheel 5's least angle is at the rocker's limit position, 217.15° of the crank:
/// there its curve on the topmost plot is lowest.
#[tokio::test]
async fn curves_stand_on_their_axes() {
    let page = Page::open().await;
    page.stop_at("0").await;
    let picture = page.picture("charts").await;
    for colour in [ROCKER, WHEEL5] {
        for third in 0..3 {
            let rows = third * picture.height / 3..(third + 1) * picture.height / 3;
            let drawn = picture.places(colour).filter(|(_, y)| rows.contains(y));
            assert!(drawn.count() > 300, "{colour:?} in plot {third}");
        }
    }
    let (left, right) = (44.0, 10.0); // the chart's margins
    let depth = |degrees: f64| {
        let column = left + (picture.width as f64 - left - right) * degrees / 360.0;
        // Of what has the colour in this column, the words stand above the curve.
        picture
            .places(WHEEL5)
            .filter(|(x, y)| x.abs_diff(column as usize) <= 1 && *y < picture.height / 3)
            .map(|(_, y)| y)
            .max()
    };
    for away in [[217.15, 160.0, 120.0, 80.0], [217.15, 275.0, 310.0, 340.0]] {
        let depths = away.map(depth);
        assert!(depths.is_sorted_by(|a, b| a > b), "{depths:?}");
    }
    page.close().await;
}

/// The cursor on the plots follows the crank.
#[tokio::test]
async fn cursor_follows_the_crank() {
    let page = Page::open().await;
    page.stop_at("90").await;
    let at_90 = page.picture("chart-cursor").await;
    page.write("angle", "270").await;
    let at_270 = page.picture("chart-cursor").await;
    assert!(at_90.difference(&at_270) > 300);
    page.close().await;
}
