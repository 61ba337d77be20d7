//! Distances and angles measured between points and links: by lists and by presses, read, plotted, kept, undone, taken away.

use assur::mechanism::Quantity;
use assur::mixer::{Case, Mixer};
use assur_tests::assert_near;
use thirtyfour::prelude::*;

use crate::access::named_and_fits;
use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::open;
use crate::plots::texts;

/// A quantity of case a and its two derivatives by the crank angle.
fn jet(name: &str, degrees: f64) -> [f64; 3] {
    let motion = Mixer::new(&Case::A.dimensions()).unwrap().motion().unwrap();
    let quantity = Quantity::named(motion.mechanism(), name).unwrap();
    let pose = motion.pose::<3>(degrees.to_radians()).unwrap();
    let jet = quantity.of(motion.mechanism(), &pose);
    [0, 1, 2].map(|order| jet.derivative(order))
}

/// The read-outs of a measure, against the engine.
async fn agrees(page: &Page, name: &str, degrees: f64) {
    let [value, first, second] = jet(name, degrees);
    let value = if name.ends_with("distance") {
        value
    } else {
        value.to_degrees()
    };
    for (stroke, expected) in [("", value), ("′", first), ("″", second)] {
        let found = page.value(&format!("out-{name}{stroke}")).await;
        assert_near(found, expected, 1e-12, &format!("{name}{stroke}"));
    }
}

/// By keys alone: lists, then the button. It is read with both derivatives, drawn, plotted, in the table, in the address,
/// undone, and taken away.
#[tokio::test]
async fn measures_are_chosen_by_lists() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let before = page.picture("mechanism").await;
    page.choose("measure-0", "B").await;
    page.choose("measure-1", "B").await;
    assert!(
        !page
            .element("measure-add")
            .await
            .is_enabled()
            .await
            .unwrap()
    );
    page.choose("measure-1", "D").await;
    page.press("measure-add", Key::Enter).await;
    agrees(&page, "B-D.distance", 62.0).await;
    page.choose("measure-what", "corner").await;
    page.choose("measure-1", "C").await;
    page.choose("measure-2", "D").await;
    page.press("measure-add", Key::Enter).await;
    agrees(&page, "B-C-D.corner", 62.0).await;
    page.choose("measure-what", "between").await;
    page.choose("measure-0", "coupler").await;
    page.choose("measure-1", "rocker").await;
    page.press("measure-add", Key::Enter).await;
    agrees(&page, "coupler-rocker.between", 62.0).await;
    page.stop_at("200").await;
    agrees(&page, "B-D.distance", 200.0).await;
    agrees(&page, "B-C-D.corner", 200.0).await;
    agrees(&page, "coupler-rocker.between", 200.0).await;
    page.stop_at("62").await;
    assert!(page.picture("mechanism").await.difference(&before) > 200);
    page.choose("plot", "B-D.distance").await;
    let seen = texts(&page).await;
    assert!(seen.iter().any(|text| text.contains("d B-D")), "{seen:?}");
    page.until("the address", async || {
        let address = page.address().await;
        // 62° is where a mixer opens: the short address leaves it out.
        ["B-C-D.corner", "plot=B-D"]
            .iter()
            .all(|part| address.contains(part))
            && !address.contains("phi_deg")
    })
    .await;
    page.reload().await;
    agrees(&page, "B-C-D.corner", 62.0).await;
    open_dialog(&page).await;
    let table = save_text(&page, "export-table-csv", "assur-mixer-a.csv").await;
    for column in [
        ",B-D.distance_",
        ",B-D.ddistance_",
        ",B-C-D.ddcorner_",
        ",coupler-rocker.ddbetween_",
    ] {
        assert!(table.contains(column), "{column}");
    }
    page.keys(Key::Escape + "").await;
    page.click("measure-remove-0").await;
    assert_eq!(page.count("#measured button").await, 2);
    assert_eq!(page.written("plot").await, "angles");
    page.click("undo").await;
    assert_eq!(page.count("#measured button").await, 3);
    page.close().await;
}

/// By presses in the drawing, on two points or on two links; another mechanism has none of it.
#[tokio::test]
async fn measures_are_chosen_in_the_drawing() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("30").await;
    for (count, what) in [(1, "distance"), (2, "between")] {
        page.choose("measure-what", what).await;
        page.click("measure-pick").await;
        let picture = page.element("mechanism").await.rect().await.unwrap();
        // A press takes the point or link that is near: some are, wherever the drawing stands.
        const APART: f64 = 30.0;
        let places = (1..(picture.height / APART) as u32).flat_map(|row| {
            (1..(picture.width / APART) as u32).map(move |column| [column, row].map(f64::from))
        });
        for [x, y] in places {
            let at = (x * APART, y * APART);
            page.drag_along("mechanism", &[at, at]).await;
            let pressed = page.attribute("measure-pick", "aria-pressed").await;
            if pressed.as_deref() == Some("false") {
                break;
            }
        }
        assert_eq!(page.count("#measured button").await, count);
    }
    page.until("the address", async || {
        page.address().await.contains(".between")
    })
    .await;
    open(&page, "whitworth").await;
    assert_eq!(page.count("#measured button").await, 0);
    page.close().await;
}

/// In every language the lists are named, and fit on a phone.
#[tokio::test]
async fn lists_of_points_are_named_and_fit() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.choose("measure-what", "corner").await;
    page.click("measure-add").await;
    named_and_fits(&page).await;
    page.close().await;
}
