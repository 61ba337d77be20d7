//! One quantity plotted against another: chosen, driven along its curve, kept, saved, given up
//! where what it is of is gone.

use assur::mechanism::Quantity;
use assur_file::presets;

use crate::access::named_and_fits;
use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::open;
use crate::host::home;
use crate::plots::texts;

/// The colour of what has y as its ordinate.
const Y: [u8; 3] = [0xB3, 0x5C, 0x00];

/// The least and the greatest value of a quantity of a mechanism of the catalogue.
fn ends(preset: &str, name: &str) -> [f64; 2] {
    let mut presets = presets().map(Result::unwrap);
    let preset = presets.find(|one| one.id == preset).unwrap();
    let motion = preset.document.moved("angles").unwrap().motion;
    let quantity = Quantity::named(motion.mechanism(), name).unwrap();
    let values = (0..3600).map(|k| {
        let pose = motion.pose::<1>(f64::from(k).to_radians() / 10.0).unwrap();
        quantity.of(motion.mechanism(), &pose).value()
    });
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], value| {
        [min.min(value), max.max(value)]
    })
}

/// Where the curve is highest and lowest, and where it is farthest to the left and to the right.
async fn extremes(page: &Page) -> [(f64, f64); 4] {
    // The numbers at the cursor have its colour, too.
    page.ask("document.getElementById('chart-cursor').style.visibility = 'hidden'")
        .await;
    let picture = page.picture("charts").await;
    let curve: Vec<(usize, usize)> = picture.places(Y).filter(|(_, y)| *y > 26).collect();
    let at = |(x, y): &(usize, usize)| (*x as f64, *y as f64);
    [
        at(curve.iter().min_by_key(|(_, y)| *y).unwrap()),
        at(curve.iter().max_by_key(|(_, y)| *y).unwrap()),
        at(curve.iter().min_by_key(|(x, _)| *x).unwrap()),
        at(curve.iter().max_by_key(|(x, _)| *x).unwrap()),
    ]
}

/// A press on the highest place of a curve drives to its greatest ordinate, and so on, for the path of a
/// point and for its hodograph; both have one scale on both axes.
#[tokio::test]
async fn a_press_on_the_curve_drives_there() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("30").await;
    for (plot, order) in [("F.x|F.y", 0), ("F.dx|F.dy", 1)] {
        page.choose("plot", plot).await;
        let places = extremes(&page).await;
        let mut found = Vec::new();
        for (place, out) in places.into_iter().zip(["y", "y", "x", "x"]) {
            page.drag_along("charts", &[place, place]).await;
            let stroke = ["", "′"][order];
            found.push(page.value(&format!("out-F.{out}{stroke}")).await);
        }
        let [top, bottom, left, right] = places;
        let scale = (right.0 - left.0) / (found[3] - found[2]);
        let upright = (bottom.1 - top.1) / (found[0] - found[1]);
        assert!(
            (scale / upright - 1.0).abs() < 0.02,
            "{plot}: {scale} {upright}"
        );
        if order == 0 {
            let [[left, right], [bottom, top]] = ["F.x", "F.y"].map(|name| ends("jansen", name));
            // A press is on a pixel.
            let pixel = scale.recip();
            for (found, expected) in found.into_iter().zip([top, bottom, left, right]) {
                assert!(
                    (found - expected).abs() < pixel,
                    "{plot}: {found} {expected} {pixel}"
                );
            }
        }
    }
    page.close().await;
}

/// Any two quantities by their lists, with derivatives: it is told by the axes, in the address, undone, and
/// in the picture that is saved.
#[tokio::test]
async fn any_two_quantities_are_chosen() {
    let page = Page::open().await;
    page.stop_at("62").await;
    assert!(!page.element("against").await.is_displayed().await.unwrap());
    page.choose("plot", "|own").await;
    page.choose("against-y", "rocker.ddangle").await;
    page.choose("against-x", "C.dx").await;
    assert_eq!(page.written("plot").await, "|own");
    let seen = texts(&page).await;
    for title in ["↑ φ₃″, 1/rad", "x′ C →"] {
        let told = seen
            .iter()
            .any(|text| text.starts_with(title) || text.starts_with("x′ C, "));
        assert!(told, "{title}: {seen:?}");
    }
    let [y, x] = [
        page.value("out-rocker.angle″").await,
        page.value("out-C.x′").await,
    ];
    let at = seen.iter().find(|text| text.contains("; ")).unwrap();
    let numbers = at
        .split("; ")
        .map(|text| text.replace('−', "-").parse::<f64>().unwrap());
    let numbers: Vec<f64> = numbers.collect();
    assert!(
        (numbers[0] - x).abs() < 6e-4 && (numbers[1] - y).abs() < 6e-4,
        "{at}: {x} {y}"
    );
    page.until("the address", async || {
        page.address().await.contains("C.dx")
    })
    .await;
    page.reload().await;
    assert_eq!(page.written("against-y").await, "rocker.ddangle");
    assert_eq!(page.written("against-x").await, "C.dx");
    page.choose("against-x", "input").await;
    page.click("undo").await;
    assert_eq!(page.written("against-x").await, "C.dx");
    page.choose("plot", "input|rocker.angle").await;
    page.ask("document.getElementById('charts-description').textContent = ''")
        .await;
    page.stop_at("63").await;
    page.until("the description", async || {
        page.text("charts-description")
            .await
            .starts_with("φ₃ against φ₁.")
    })
    .await;
    open_dialog(&page).await;
    let svg = save_text(&page, "export-plots-svg", "assur-mixer-a-plots.svg").await;
    assert!(svg.contains("↑ φ₃, °") && svg.contains("φ₁, ° →"), "{svg}");
    page.close().await;
}

/// Another mechanism has no such quantity: its usual plots are shown. A link that asks for one says so.
#[tokio::test]
async fn what_is_gone_is_not_plotted() {
    let page = Page::open().await;
    open(&page, "jansen").await;
    page.stop_at("30").await;
    page.choose("plot", "F.x|F.y").await;
    open(&page, "whitworth").await;
    assert_eq!(page.written("plot").await, "angles");
    assert!(!page.element("against").await.is_displayed().await.unwrap());
    let pair = "%7B%22x%22:%22Q.x%22,%22y%22:%22F.y%22%7D";
    let url = format!("{}#jansen&v.against={pair}", home());
    page.goto(&url).await;
    page.until("a sentence", async || {
        (page.text("notice").await).contains("Plot of two quantities: there is no such choice.")
    })
    .await;
    page.close().await;
}

/// In every language, on a phone, too, the lists are named and fit.
#[tokio::test]
async fn lists_of_quantities_are_named_and_fit() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.choose("plot", "C.dx|C.dy").await;
    named_and_fits(&page).await;
    page.close().await;
}
