//! Poses of a body on the page: dragged, turned, typed, added; linkages listed, chosen and opened.

use std::collections::BTreeSet;

use serde_json::json;

use crate::access::kind_is_named_and_fits;
use crate::browser::Page;
use crate::host::home;

/// The page with a task of the catalogue, at rest.
async fn open(name: &str) -> Page {
    let page = Page::open_at(&format!("{}#{name}&v.playing=false", home()), "en-US").await;
    there(&page).await;
    page
}

/// Waits until what is of poses is there.
async fn there(page: &Page) {
    let there = "return Boolean(document.getElementById('pairs-said')?.textContent || document.querySelector('[name=pair]'))";
    page.until("what is of poses", async || {
        page.ask(there).await == json!(true)
    })
    .await;
    page.settle().await;
    assert_eq!(page.text("notice-text").await, "");
}

/// What the fields of the poses hold.
async fn fields(page: &Page) -> Vec<(String, String)> {
    let script = "return [...document.querySelectorAll('#poses .card:not([hidden]) input')].map((one) => [one.id, one.value])";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The ids of the listed linkages, the best first.
async fn listed(page: &Page) -> Vec<String> {
    let script = "return [...document.querySelectorAll('[name=pair]')].map((one) => one.id)";
    serde_json::from_value(page.ask(script).await).unwrap()
}

/// The end of the body's axis turns its pose, its origin moves it: x and y, or the angle, and nothing else.
#[tokio::test]
async fn poses_are_dragged_and_turned() {
    let page = open("poses-three").await;
    let before = fields(&page).await;
    assert_eq!(before.len(), 9);
    let mut moved = BTreeSet::new();
    page.click("zoom-fit").await;
    for (x, y) in page.handles().await {
        page.drag_along(
            "mechanism",
            &[(x, y), (x + 11.0, y + 5.0), (x + 19.0, y + 12.0)],
        )
        .await;
        let after = fields(&page).await;
        let changed = before
            .iter()
            .zip(&after)
            .filter(|(one, other)| one != other);
        let changed: Vec<&str> = changed.map(|(one, _)| one.0.as_str()).collect();
        if !changed.is_empty() {
            let n = changed[0].rsplit_once('-').unwrap().1;
            let place = [format!("field-pose-x-{n}"), format!("field-pose-y-{n}")];
            let turn = format!("field-pose-angle-{n}");
            assert!(
                changed == [turn] || changed.iter().all(|one| place.iter().any(|id| id == one)),
                "{changed:?}"
            );
            moved.extend(changed.into_iter().map(str::to_owned));
        }
        // A dragged hinge changes the linkage; a drag beside a handle moves the drawing.
        if page
            .ask("return document.getElementById('undo').disabled")
            .await
            == json!(false)
        {
            page.click("undo").await;
            page.settle().await;
            assert_eq!(fields(&page).await, before);
        }
        page.click("zoom-fit").await;
        page.settle().await;
    }
    assert!(moved.len() >= 6, "{moved:?}");
    page.close().await;
}

/// A typed angle changes the drawing; poses are added up to five and removed down to two.
#[tokio::test]
async fn poses_are_typed_added_and_removed() {
    let page = open("poses-three").await;
    let before = page.picture("mechanism").await;
    page.write("field-pose-angle-2", "75").await;
    assert_eq!(page.written("field-pose-angle-2").await, "75°");
    assert_eq!(page.text("problem").await, "");
    assert!(page.picture("mechanism").await.difference(&before) > 300);
    page.write("field-pose-x-1", "what").await;
    assert_eq!(
        page.attribute("field-pose-x-1", "aria-invalid")
            .await
            .as_deref(),
        Some("true")
    );
    page.write("field-pose-x-1", "0").await;
    for count in [4, 5] {
        page.click("poses-add").await;
        assert_eq!(page.count("#poses .card:not([hidden])").await, count);
        assert_eq!(page.text("problem").await, "");
    }
    assert_eq!(
        page.ask("return document.getElementById('poses-add').disabled")
            .await,
        json!(true)
    );
    for count in [4, 3, 2] {
        page.click(&format!("poses-remove-{}", count + 1)).await;
        assert_eq!(page.count("#poses .card:not([hidden])").await, count);
    }
    assert_eq!(
        page.count("#poses button[id^=poses-remove]:not([hidden])")
            .await,
        0
    );
    page.close().await;
}

/// Five poses: every linkage is listed with its verdict; another is chosen, goes to a pose, and opens as a linkage.
#[tokio::test]
async fn a_linkage_of_five_poses_is_chosen_and_opened() {
    let page = open("poses-five").await;
    let Some(Ok(assur_file::Document::Poses(document))) = assur_file::document("poses-five") else {
        panic!("not there");
    };
    let found = document.guidance().unwrap();
    let expected = found
        .order
        .iter()
        .map(|number| format!("pair-{}", number + 1));
    let expected: Vec<String> = expected.collect();
    assert_eq!(listed(&page).await, expected);
    assert!(
        page.text("pairs-said")
            .await
            .contains(&format!("{} of 4 pairs", found.solutions.dyads.len()))
    );
    // The best meets all poses: each has its button.
    assert_eq!(page.count("#pairs-go button:not(:disabled)").await, 5);
    let before = page.picture("mechanism").await;
    page.click("pose-go-4").await;
    assert!(page.picture("mechanism").await.difference(&before) > 100);
    let last = expected.last().unwrap();
    page.click(last).await;
    let chosen = "return document.querySelector('[name=pair]:checked').id";
    assert_eq!(page.ask(chosen).await, json!(last));
    page.click("undo").await;
    assert_eq!(page.ask(chosen).await, json!(expected[0]));
    // Without defects there is at least the crank-rocker itself.
    let filter = "const filter = document.getElementById('pairs-filter'); filter.value = 'sound'; filter.dispatchEvent(new Event('change'))";
    page.ask(filter).await;
    page.settle().await;
    let sound = listed(&page).await;
    assert!(!sound.is_empty() && sound.len() <= expected.len());
    let kind = async || {
        page.ask("return document.documentElement.dataset.kind")
            .await
    };
    page.click("pairs-send").await;
    page.until("the linkage", async || kind().await == json!("linkage"))
        .await;
    page.settle().await;
    assert_eq!(page.text("problem").await, "");
    page.click("undo").await;
    page.until("the poses", async || kind().await == json!("poses"))
        .await;
    page.close().await;
}

/// Poses for which there is no linkage stay drawn, with the reason.
#[tokio::test]
async fn poses_without_a_linkage_stay() {
    let page = open("poses-three").await;
    for (n, [x, y]) in [["0", "0"], ["1", "0"], ["2", "0"]].iter().enumerate() {
        page.write(&format!("field-pose-x-{}", n + 1), x).await;
        page.write(&format!("field-pose-y-{}", n + 1), y).await;
        page.write(&format!("field-pose-angle-{}", n + 1), "30")
            .await;
    }
    let said = page.text("pairs-said").await;
    assert!(said.contains("parallel and in line"), "{said}");
    assert_eq!(page.text("problem").await, "");
    assert!(!page.handles().await.is_empty());
    let fields = fields(&page).await;
    assert_eq!(fields[5].1, "30°");
    page.click("undo").await;
    assert!(page.count("#poses .card:not([hidden])").await == 3);
    page.close().await;
}

/// Every word is there in every language, on a laptop and on a phone; targets of a finger are 44 pixels high.
#[tokio::test]
async fn poses_are_named_and_fit() {
    let page = open("poses-five").await;
    kind_is_named_and_fits(&page, "poses", "poses.").await;
    page.close().await;
}
