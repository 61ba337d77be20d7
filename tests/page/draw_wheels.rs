//! Wheels drawn by presses: in mesh, fixed, selected and removed by their discs; guides as they are announced.

use assur::motion::Motion;
use assur_file::LinkageDocument;

use crate::browser::Page;
use crate::draw::{Sheet, place};
use crate::draw_more::drawn;

/// A carrier from the pivot A to B, with a sun on A in mesh with a planet on B.
async fn carrier_with_two_wheels(sheet: &mut Sheet<'_>) {
    sheet.line(&[[0.0, 0.0], [2.0, 0.0]]).await;
    sheet.end().await;
    sheet.tool("wheel").await;
    sheet.line(&[[0.0, 0.0], [2.0, 0.0]]).await;
    sheet.tool("mesh").await;
    sheet.page.write("draw-teeth-1", "20").await;
    sheet.page.write("draw-teeth-2", "20").await;
    sheet.line(&[[0.0, 0.0], [2.0, 0.0]]).await;
}

fn names(document: &LinkageDocument) -> Vec<&str> {
    let links = document.links.iter();
    links.map(|link| link.name.as_str()).collect()
}

/// An epicyclic train with a carrier and a fixed ring, of 20, 20 and 60 teeth: the carrier turns at a quarter of the sun's speed.
#[tokio::test]
async fn an_epicyclic_train_is_drawn_by_presses() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    carrier_with_two_wheels(&mut sheet).await;
    assert_eq!(page.text("problem").await, "");
    sheet.tool("wheel").await;
    sheet.press(0.0, 0.0).await;
    // The planet by its disc, the ring by the hinge on which it was put last.
    sheet.tool("mesh").await;
    page.write("draw-teeth-2", "60").await;
    page.click("draw-internal").await;
    sheet.line(&[[2.0, 0.7], [0.0, 0.0]]).await;
    assert_eq!(page.text("problem").await, "");
    // The ring stands, by its rim; the sun is driven by its disc.
    sheet.tool("fix").await;
    sheet.press(-2.4, 1.8).await;
    sheet.tool("drive").await;
    sheet.press(-0.6, 0.4).await;
    assert_eq!(page.text("problem").await, "");
    let document = drawn(&sheet).await;
    assert_eq!(names(&document), ["AB", "wheel", "wheel 2", "wheel 3"]);
    assert_eq!(document.links[3].fixed_to.as_deref(), Some("frame"));
    let motion = Motion::new(document.mechanism().unwrap());
    for degrees in [30.0_f64, 90.0, 200.0, 720.0] {
        let carrier = (degrees / 4.0).to_radians();
        let wanted = assur::Point::new(2.0 * carrier.cos(), 2.0 * carrier.sin());
        let off = place(&motion, motion.drawn_input() + degrees.to_radians(), "B") - wanted;
        assert!(off.norm() < 1e-12, "{degrees}: {off}");
    }
    sheet.tell("epicyclic train");
    page.close().await;
}

/// A wheel is selected by its disc, and goes alone: by its disc, or by the hinge on which it is.
#[tokio::test]
async fn a_wheel_is_selected_and_goes_alone() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    carrier_with_two_wheels(&mut sheet).await;
    sheet.tool("select").await;
    sheet.press(2.0, 0.7).await;
    assert_eq!(page.written("draw-name").await, "wheel 2");
    assert_eq!(page.count("#draw-act-fix").await, 1);
    sheet.tool("remove").await;
    sheet.press(2.0, -0.7).await;
    let document = drawn(&sheet).await;
    assert_eq!(names(&document), ["AB", "wheel"]);
    assert_eq!(document.gears.len(), 0);
    sheet.press(0.0, 0.0).await;
    assert_eq!(names(&drawn(&sheet).await), ["AB"]);
    assert_eq!(drawn(&sheet).await.points.len(), 2);
    // Alone on its hinge it is the hinge that goes.
    sheet.press(0.0, 0.0).await;
    assert_eq!(names(&drawn(&sheet).await), [""; 0]);
    page.close().await;
}

/// A link that is pressed in its middle slides with its first point: the guide goes from there, level where the second
/// press is level with that point.
#[tokio::test]
async fn a_guide_is_as_announced() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet.line(&[[-3.0, 0.0], [-1.0, 2.0], [1.0, -1.0]]).await;
    sheet.end().await;
    sheet.tool("slide").await;
    // BC in its middle, then to the right, nearly level with B.
    sheet.line(&[[0.0, 0.5], [3.0, 2.1]]).await;
    assert_eq!(page.text("problem").await, "");
    let document = drawn(&sheet).await;
    let at = |name: &str| {
        document
            .points
            .iter()
            .find(|one| one.name == name)
            .unwrap()
            .at
    };
    let [slide] = &document.slides[..] else {
        panic!("{:?}", document.slides);
    };
    assert_eq!(slide.point, "B");
    let [from, to] = [0, 1].map(|end| at(&slide.line[end]));
    assert_eq!([from[1], to[1]], [2.0, 2.0], "{from:?} {to:?}");
    page.close().await;
}

/// A rigid drawing shows its count before a driver is asked for, and offers to remove a link.
#[tokio::test]
async fn the_count_comes_before_the_driver() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    sheet
        .line(&[[-2.0, 0.0], [0.0, 2.0], [2.0, 0.0], [2.0, 0.0]])
        .await;
    assert_eq!(
        page.text("draw-reasons").await,
        "There are too many pairs (W = 0); these links are locked: AB, CB. Remove one of them."
    );
    let mends = page.text("draw-mends").await;
    assert!(
        mends.contains("Remove") && !mends.contains("Drive"),
        "{mends}"
    );
    page.close().await;
}
