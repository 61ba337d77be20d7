//! Random edits; a nearly redundant drawing.

use super::*;

/// What follows the # of an address, as a state.
fn addressed(hash: &str) -> State {
    let mut state = Map::new();
    let [mut document, mut view] = [Map::new(), Map::new()];
    for pair in hash.trim_start_matches('#').split('&').skip(1) {
        let (key, value) = pair.split_once('=').unwrap();
        let text = percent_encoding::percent_decode_str(value)
            .decode_utf8()
            .unwrap();
        let value = serde_json::from_str(&text).unwrap_or_else(|_| Value::from(text.as_ref()));
        match key.split_once('.') {
            Some(("d", key)) => document.insert(key.to_owned(), value),
            Some(("v", key)) => view.insert(key.to_owned(), value),
            _ => state.insert(key.to_owned(), value),
        };
    }
    state.insert("format".to_owned(), Value::from(2));
    state.insert("document".to_owned(), document.into());
    state.insert("view".to_owned(), view.into());
    State::read(&state.into()).unwrap()
}

/// What draws by chance.
const CHANCE: &str = include_str!("../chance.js");

#[tokio::test]
async fn edits_by_chance_are_undone_and_redone() {
    let page = Page::open().await;
    let _sheet = Sheet::new(&page).await;
    page.ask(CHANCE).await;
    let asked = async |what: &str| {
        let script = format!("window.chance.{what}.then(arguments[arguments.length - 1])");
        page.ask_later(&script, vec![]).await
    };
    // A script may not take longer than a person waits.
    for _ in 0..scaled(6) {
        assert_eq!(asked("edit(20)").await, 20);
    }
    let last = page.ask("return window.chance.address()").await;
    let mut addresses = Vec::new();
    loop {
        let back = asked("walk('undo', 50)").await;
        addresses.extend(back["addresses"].as_array().unwrap().clone());
        if back["over"] == true {
            break;
        }
    }
    assert!(addresses.len() >= scaled(100), "{} steps", addresses.len());
    // The last step back is the mechanism that was there before the sheet, which has a short address.
    let drawn = &addresses[..addresses.len() - 1];
    for address in drawn {
        let state = addressed(address.as_str().unwrap());
        match state.document {
            Document::Draft(DraftDocument(document)) => document.check().unwrap(),
            Document::Linkage(document) => drop(document.mechanism().unwrap()),
            _ => {}
        }
    }
    // A thousand steps are kept: before them is what was drawn then.
    if addresses.len() < 1000 {
        let empty = addressed(drawn[drawn.len() - 1].as_str().unwrap());
        assert_eq!(empty.document, Document::Draft(DraftDocument::default()));
    }
    while asked("walk('redo', 50)").await["over"] != true {}
    assert_eq!(page.ask("return window.chance.address()").await, last);
    assert_eq!(
        page.ask("return window.chance.errors").await,
        Value::Array(vec![])
    );
    page.close().await;
}

/// Three cranks parallel to four decimals: one press makes them exact, and they turn.
#[tokio::test]
async fn a_nearly_redundant_drawing_is_made_exact() {
    const NEAR: &str = "#2&kind=draft&d.points=%5B%7B%22name%22:%22A%22,%22at%22:%5B0,0%5D%7D,%7B%22name%22:%22D%22,%22at%22:%5B4,0%5D%7D,%7B%22name%22:%22G%22,%22at%22:%5B2,0%5D%7D,%7B%22name%22:%22B%22,%22at%22:%5B0,1%5D%7D,%7B%22name%22:%22C%22,%22at%22:%5B4,1%5D%7D,%7B%22name%22:%22H%22,%22at%22:%5B2.0002,0.9999%5D%7D%5D&d.frame=%5B%22A%22,%22D%22,%22G%22%5D&d.links=%5B%7B%22name%22:%22c1%22,%22points%22:%5B%22A%22,%22B%22%5D%7D,%7B%22name%22:%22rod%22,%22points%22:%5B%22B%22,%22H%22,%22C%22%5D%7D,%7B%22name%22:%22c2%22,%22points%22:%5B%22D%22,%22C%22%5D%7D,%7B%22name%22:%22c3%22,%22points%22:%5B%22G%22,%22H%22%5D%7D%5D&d.drivers=%5B%7B%22crank%22:%22c1%22%7D%5D&v.phi_deg=50&v.playing=false&v.direction=1&v.speed=1&v.traces=true&v.lang=en";
    let page = Page::open_at(&format!("{}{NEAR}", home()), "en-US").await;
    page.until("the offer", async || {
        page.text("draw-mends").await.starts_with("Make it exact: ")
    })
    .await;
    assert_eq!(page.count("#draw-mends button").await, 1);
    assert_eq!(defects(&page, 0).await, serde_json::json!([]));
    page.ask("document.querySelector('#draw-mends button').click()")
        .await;
    page.until("the mechanism", async || {
        page.count("#out-redundant").await > 0
            && page
                .text("out-redundant")
                .await
                .contains("W = 0 by count, q = 1")
    })
    .await;
    assert_eq!(page.text("out-linkage-w").await, "1");
    page.click("undo").await;
    page.until("the drawing again", async || {
        page.text("draw-mends").await.starts_with("Make it exact: ")
    })
    .await;
    page.close().await;
}
