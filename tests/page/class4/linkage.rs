//! The linkage itself: colours of groups, pivots of the frame, vectors.

use super::*;

/// What the drawing is as a picture for print.
async fn drawing(page: &Page) -> String {
    open_dialog(page).await;
    let svg = save_text(page, "export-drawing-svg", "assur-class4-dwell-drawing.svg").await;
    page.click("export-close").await;
    svg
}

/// The colours of CD and FK, and of the first group, the coupler's, on paper.
const OWN: [&str; 2] = ["#77820a", "#b8508a"];
const GROUP: &str = "#d55e00";
const CD: [u8; 3] = [0x77, 0x82, 0x0A];

/// Links take the colours of their groups, in the formula as well; a link of the
/// address keeps it, undo takes it back, and the plots tell links apart as before.
#[tokio::test]
async fn groups_are_drawn_in_colours() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("60").await;
    let formula = page.text("out-formula").await;
    let swatches = "#out-formula .swatch";
    assert_eq!(page.count(swatches).await, 0);
    assert!(page.picture("mechanism").await.places(CD).count() > 200);
    let curve = page.picture("charts").await.places(CD).count();
    let plain = drawing(&page).await;
    assert!(OWN.iter().all(|own| plain.contains(own)));

    page.click("groups").await;
    assert_eq!(page.text("out-formula").await, formula);
    for (role, term) in [
        ("crank", "I(frame,AB)"),
        ("coupler", "IV₃(BE,EGF,HGL,CLK,FK,CD)"),
    ] {
        let term_of = format!("#out-formula .group:has([data-role='{role}'])");
        let shown = page.driver.find(By::Css(&term_of)).await.unwrap();
        assert_eq!(shown.text().await.unwrap(), term);
    }
    assert_eq!(page.count(swatches).await, 2);
    assert_eq!(page.picture("mechanism").await.places(CD).count(), 0);
    let still = page.picture("charts").await.places(CD).count();
    assert!(still.abs_diff(curve) < curve / 10, "{still} {curve}");
    let coloured = drawing(&page).await;
    assert!(!OWN.iter().any(|own| coloured.contains(own)));
    assert!(coloured.matches(GROUP).count() > plain.matches(GROUP).count());

    page.until("the address", async || {
        page.address().await.contains("v.groups=true")
    })
    .await;
    page.reload().await;
    page.until("the formula", async || page.count(swatches).await == 2)
        .await;
    assert!(page.element("groups").await.is_selected().await.unwrap());
    page.click("groups").await;
    assert_eq!(page.count(swatches).await, 0);
    page.click("undo").await;
    assert_eq!(page.count(swatches).await, 2);
    // The lesson's first step shows them, the fourth does not.
    page.click("groups").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-show").await > 0)
        .await;
    page.click("lesson-show").await;
    assert_eq!(page.count(swatches).await, 2);
    for _ in 1..4 {
        page.click("lesson-on").await;
    }
    page.click("lesson-show").await;
    assert_eq!(page.count(swatches).await, 0);
    page.close().await;
}

/// Where H and D stand among the points, and the links that are hinged there.
const H: usize = 8;
const D: usize = 9;
const HGL: usize = 3;
const CD_LINK: usize = 6;

/// The hinges of the frame are moved by number and by slider, and the links keep
/// their dimensions; undone, kept in the address, refused in a sentence.
#[tokio::test]
async fn the_frame_is_regulated() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.stop_at("60").await;
    let mut moved = document("class4-dwell");
    let drawn = moved.clone();
    let shape = moved.links[HGL].points.iter().map(|name| {
        let point = drawn.points.iter().find(|point| point.name == *name);
        point.unwrap().at
    });
    moved.links[HGL].shape = Some(shape.collect());
    moved.points[H].at[0] = 4.2;
    page.write(&format!("field-point-{H}-x"), "4.2").await;
    agrees(&page, &moved, "CD.angle").await;
    let shorter = dwell(&page).await;
    assert_ne!(shorter, "184.289°");
    page.click("undo").await;
    assert_eq!(dwell(&page).await, "184.289°");
    page.click("redo").await;
    assert_eq!(dwell(&page).await, shorter);

    // One step of the slider.
    page.press(&format!("slider-point-{D}-y"), Key::Right).await;
    let field = format!("field-point-{D}-y");
    page.focus(&field).await;
    page.settle().await;
    let at: f64 = page
        .written(&field)
        .await
        .replace('−', "-")
        .parse()
        .unwrap();
    assert!((at + 4.78).abs() < 0.1 && at > -4.78, "{at}");
    let [c, d] = ["C", "D"].map(|name| {
        let point = drawn.points.iter().find(|point| point.name == name);
        point.unwrap().at
    });
    moved.links[CD_LINK].length = Some((c[0] - d[0]).hypot(c[1] - d[1]));
    moved.points[D].at[1] = at;
    agrees(&page, &moved, "CD.angle").await;
    page.until("the address", async || {
        page.address().await.contains(&format!("{at}"))
    })
    .await;
    page.reload().await;
    page.until("the mechanism", async || {
        page.count(&format!("#field-point-{H}-x")).await == 1
    })
    .await;
    agrees(&page, &moved, "CD.angle").await;

    for (text, sentence) in [
        ("far", "x of fixed pivot H"),
        ("40", "can no longer be joined"),
    ] {
        page.write(&format!("field-point-{H}-x"), text).await;
        page.until("a sentence", async || {
            page.text("problem").await.contains(sentence)
        })
        .await;
        // The 4 of 40 works: it is what was there last.
        if text == "40" {
            moved.points[H].at[0] = 4.0;
        }
        agrees(&page, &moved, "CD.angle").await;
    }
    // The points of a guide have fields, too.
    open(&page, "slider-crank").await;
    let frame = page.element("linkage-frame").await;
    assert!(frame.is_displayed().await.unwrap());
    page.close().await;
}

/// Velocity and acceleration at every joint that moves, E, G, F, K, L, C among them:
/// the arrows of the drawing have the directions of the derivatives.
#[tokio::test]
async fn every_joint_has_its_vectors() {
    let page = Page::open().await;
    open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || page.count("#lesson-title").await > 0)
        .await;
    for _ in 1..9 {
        page.click("lesson-on").await;
    }
    let text = page.driver.find(By::Css(".lesson-text")).await.unwrap();
    assert!(text.text().await.unwrap().contains("E, G, F, K, L and C"));
    page.click("lesson-show").await;
    page.settle().await;
    assert!((page.value("out-input").await - 60.0).abs() < 1e-9);
    let svg = drawing(&page).await;
    let svg = roxmltree::Document::parse(&svg).unwrap();
    let motion = document("class4-dwell").motion().unwrap();
    let mechanism = motion.mechanism();
    let pose = motion.pose::<3>(60_f64.to_radians()).unwrap();
    for (order, colour) in [(1, "#c2387f"), (2, "#4b4fc4")] {
        // Shafts, in the coordinates of the mechanism.
        let shafts = svg.descendants().filter(|node| {
            node.attribute("stroke") == Some(colour) && node.attribute("fill") == Some("none")
        });
        let ends = shafts.map(|shaft| {
            let ends = shaft.attribute("d").unwrap().split(['M', 'L', ' ']);
            let ends = ends.filter_map(|number| number.parse().ok());
            let ends: Vec<f64> = ends.collect();
            let [x, y, to_x, to_y] = ends[..] else {
                panic!("{ends:?}");
            };
            [Point::new(x, y), Point::new(to_x, to_y)]
        });
        let ends: Vec<[Point; 2]> = ends.collect();
        assert_eq!(ends.len(), 7);
        for index in mechanism.point_ids() {
            let name = mechanism.point_name(index);
            if "AHD".contains(name) {
                continue;
            }
            let joint = mechanism.place(&pose, index);
            let vector = joint.derivative(order).normalize();
            let mut here = ends.iter();
            let [from, to] = here
                .find(|[from, _]| (from - joint.place()).norm() < 1e-5)
                .unwrap();
            let along = (to - from).normalize();
            assert!((along - vector).norm() < 1e-3, "{name} {order}: {along}");
        }
    }
    page.close().await;
}
