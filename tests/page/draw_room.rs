//! Room to draw: the stage stands still whatever the drawing does, its tools have words, messages leave.

use serde_json::{Value, json};

use crate::browser::Page;
use crate::draw::Sheet;
use crate::draw_more::drawn;

/// Place and size of the stage.
async fn stage(page: &Page) -> Value {
    page.settle().await;
    let script = "const { x, y, width, height } = document.getElementById('mechanism').getBoundingClientRect(); return [x, y, width, height]";
    page.ask(script).await
}

/// A four-bar is drawn, driven, given a free link, and loses it again: each press lands where it would on the empty sheet.
#[tokio::test]
async fn the_stage_stands_still() {
    let page = Page::open().await;
    for plots in [false, true] {
        let mut sheet = Sheet::new(&page).await;
        if plots {
            page.click("draw-plots").await;
            sheet = Sheet::new(&page).await;
        }
        let before = stage(&page).await;
        let width = before[2].as_f64().unwrap();
        assert_eq!(width > 900.0, !plots, "{width}");
        let four_bar = [
            [-3.0, -1.0],
            [-3.0, 0.0],
            [1.0, 2.0],
            [2.0, -1.0],
            [2.0, -1.0],
        ];
        for place in four_bar {
            sheet.press(place[0], place[1]).await;
            assert_eq!(stage(&page).await, before);
        }
        let count =
            "return document.querySelector('.entry:not(.elsewhere) .draw-count').textContent";
        assert_eq!(page.ask(count).await, "= 3n − 2p₅ − p₄ = 3·3 − 2·4 − 0 =");
        sheet.mend().await;
        page.until("motion", async || {
            page.count("[data-still=false]").await == 1
        })
        .await;
        assert_eq!(stage(&page).await, before);
        assert_eq!(page.ask(count).await, "= 3n − 2p₅ − p₄ = 3·3 − 2·4 − 0 =");
        // A free link: it does not move any more.
        sheet.line(&[[1.0, 2.0], [3.0, 2.0]]).await;
        sheet.end().await;
        assert_eq!(page.count("[data-still=true]").await, 1);
        assert_eq!(stage(&page).await, before);
        assert_eq!(page.text("out-draft-w").await, "2");
        assert_eq!(page.ask(count).await, "= 3n − 2p₅ − p₄ = 3·4 − 2·5 − 0 =");
        let places: Vec<[f64; 2]> = drawn(&sheet)
            .await
            .points
            .iter()
            .map(|one| one.at)
            .collect();
        assert_eq!(
            places,
            [
                [-3.0, -1.0],
                [-3.0, 0.0],
                [1.0, 2.0],
                [2.0, -1.0],
                [3.0, 2.0]
            ]
        );
        page.chord(&[thirtyfour::Key::Control], 'z').await;
        assert_eq!(stage(&page).await, before);
        assert_eq!(page.count("[data-still=false]").await, 1);
    }
    page.close().await;
}

/// An empty sheet invites; five tools are in sight, with words; the others come with one press more.
#[tokio::test]
async fn an_empty_sheet_invites() {
    let page = Page::open().await;
    let mut sheet = Sheet::new(&page).await;
    let said = page.text("draw-reasons").await;
    assert!(
        said.starts_with("Click two places to draw a link"),
        "{said}"
    );
    let seen = "return [...document.querySelectorAll('.draw-tools button')].filter((one) => one.checkVisibility()).map((one) => one.innerText)";
    assert_eq!(
        page.ask(seen).await,
        json!(["Select", "Links", "Slide", "Frame", "Driver", "More"])
    );
    sheet.tool("wheel").await;
    assert_eq!(page.text("draw-more").await, "Wheel");
    assert_eq!(
        page.attribute("draw-more", "aria-expanded")
            .await
            .as_deref(),
        Some("false")
    );
    // A message about a press covers no tool, and leaves with the next press.
    sheet.tool("drive").await;
    sheet.press(4.0, 3.0).await;
    assert_eq!(
        page.text("problem").await,
        "Click a link here, not empty space."
    );
    sheet.tool("bars").await;
    sheet.press(0.0, -3.0).await;
    assert_eq!(page.text("problem").await, "");
    assert_eq!(drawn(&sheet).await.points[0].at, [0.0, -3.0]);
    page.close().await;
}

/// On a phone the stage has the larger part of the screen, and what it fits is between the prompt and the buttons.
#[tokio::test]
async fn a_phone_has_room_to_draw() {
    let page = Page::open().await;
    page.screen((360, 740), 1.0).await;
    let mut sheet = Sheet::new(&page).await;
    let before = stage(&page).await;
    let height = before[3].as_f64().unwrap();
    assert!(height > 0.6 * 740.0, "{height}");
    sheet.line(&[[-6.0, 4.0], [6.0, -4.0]]).await;
    sheet.end().await;
    assert_eq!(stage(&page).await, before);
    let places: Vec<[f64; 2]> = drawn(&sheet)
        .await
        .points
        .iter()
        .map(|one| one.at)
        .collect();
    assert_eq!(places, [[-6.0, 4.0], [6.0, -4.0]]);
    page.close().await;
}
