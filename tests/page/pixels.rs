//! What is drawn stands where the engine says: bars to scale, wheels in place,
//! curves on their axes.

use assur::catalog::mixer::{Case, Mixer};
use assur::{Assembly, FourBar, Link, Offset, Point, Pose};

use crate::browser::Page;
use crate::picture::{COUPLER, Cloud, ROCKER, WHEEL5, apart};

const LENGTHS: [f64; 4] = [0.37, 0.85, 0.55, 0.85];

/// The coupler's bar on the screen: only it has its colour.
async fn coupler(page: &Page, degrees: f64) -> Cloud {
    page.write("angle", &degrees.to_string()).await;
    page.picture("mechanism").await.cloud(COUPLER)
}

fn pose(degrees: f64, assembly: Assembly) -> Pose<1> {
    let linkage = FourBar::new(LENGTHS).unwrap();
    linkage.pose(assembly, degrees.to_radians()).unwrap()
}

/// The middle of the coupler in the model.
fn middle(degrees: f64, assembly: Assembly) -> Point {
    let linkage = FourBar::new(LENGTHS).unwrap();
    let pose = linkage.pose::<1>(assembly, degrees.to_radians()).unwrap();
    linkage
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
        for degrees in [0.0, 60.0, 180.0, 300.0] {
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
        let scale = (right.x - left.x).hypot(right.y - left.y) / (m - n).norm();
        let on_screen = |p: Point| (right.x + scale * (p.x - m.x), right.y - scale * (p.y - m.y));
        let off = |cloud: &Cloud, p: Point| {
            let (x, y) = on_screen(p);
            (cloud.x - x).hypot(cloud.y - y)
        };
        for (bar, middle) in &bars {
            assert!(off(bar, *middle) < 3.0, "{bar:?} {:?}", on_screen(*middle));
            assert!(
                (bar.length / (scale * LENGTHS[1]) - 0.94).abs() < 0.03,
                "{bar:?} {scale}"
            );
        }
        let gears = Mixer::new(&Case::A.dimensions()).unwrap().gears;
        let centre = Point::new(LENGTHS[3], 0.0) + gears.driven_wheel().centre;
        let wheel = page.picture("mechanism").await.cloud(WHEEL5);
        assert!(wheel.count > 200, "{wheel:?}");
        assert!(
            off(&wheel, centre) < 4.0,
            "{wheel:?} {:?}",
            on_screen(centre)
        );
    }
    page.close().await;
}

/// The rocker's greatest angle is at the limit position, 217.15° of the crank:
/// there its curve on the topmost plot is highest.
#[tokio::test]
async fn curves_stand_on_their_axes() {
    let page = Page::open().await;
    page.stop_at("0").await;
    let picture = page.picture("charts").await;
    let (left, right) = (44.0, 10.0); // the chart's margins
    let x = |degrees: f64| left + (picture.width as f64 - left - right) * degrees / 360.0;
    let top_plot: Vec<(usize, usize)> = picture
        .places(ROCKER)
        .filter(|(_, y)| *y > 30 && *y < picture.height / 3)
        .collect();
    // Words in the same colour stand off the curve: only long rows are the curve's.
    let columns: std::collections::BTreeSet<usize> = top_plot.iter().map(|(x, _)| *x).collect();
    assert!(columns.len() as f64 > 0.9 * (picture.width as f64 - left - right));
    for colour in [ROCKER, WHEEL5] {
        for third in 0..3 {
            let rows = third * picture.height / 3..(third + 1) * picture.height / 3;
            let drawn = picture
                .places(colour)
                .filter(|(_, y)| rows.contains(y))
                .count();
            assert!(drawn > 300, "{colour:?} in plot {third}: {drawn}");
        }
    }
    // The curve falls away from its highest point on both sides alike.
    let height = |degrees: f64| {
        let column = x(degrees).round() as usize;
        let ys = top_plot
            .iter()
            .filter(|(x, _)| x.abs_diff(column) <= 1)
            .map(|(_, y)| *y);
        ys.max().unwrap_or(0)
    };
    let peak = height(217.15);
    for (near, far) in [(160.0, 120.0), (275.0, 310.0)] {
        assert!(
            peak < height(near) && height(near) < height(far),
            "{peak} {near}"
        );
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
