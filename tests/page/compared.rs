//! A mechanism that is kept as A beside what it becomes, B: drawn, plotted, in numbers, kept, undone, exchanged, taken away.

use assur_tests::angle_between;
use serde_json::json;

use crate::access::named_and_fits;
use crate::browser::Page;
use crate::export::{open_dialog, save_text};
use crate::gallery::open;
use crate::host::home;

/// The numbers of a row: value and two derivatives of the rocker, of what stands in it.
async fn row(page: &Page, of: &str) -> [f64; 3] {
    let mut row = [0.0; 3];
    for (number, order) in row.iter_mut().zip(["", "′", "″"]) {
        *number = page.value(&format!("{of}-rocker.angle{order}")).await;
    }
    row
}

async fn is_there(page: &Page) -> bool {
    page.count("#a-rocker\\.angle").await == 1
}

/// Where nothing is changed B is A to the last digit; a length changed, A is what it was, at every input, and the difference that of the
/// two numbers; curves and drawing have both.
#[tokio::test]
async fn a_is_beside_b() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let alone = page.picture("mechanism").await;
    let at = ["62", "200", "315"];
    let mut were = Vec::new();
    for degrees in at {
        page.stop_at(degrees).await;
        were.push(row(&page, "out").await);
    }
    page.stop_at("62").await;
    assert!(!is_there(&page).await);
    page.click("compare-freeze").await;
    page.settle().await;
    assert_eq!(row(&page, "a").await, were[0]);
    assert_eq!(row(&page, "difference").await, [0.0; 3]);
    page.write("field-l4", "0.9").await;
    page.settle().await;
    for (degrees, were) in at.into_iter().zip(&were) {
        page.stop_at(degrees).await;
        let [a, b, difference] = [
            row(&page, "a").await,
            row(&page, "out").await,
            row(&page, "difference").await,
        ];
        assert_eq!(a, *were, "{degrees}");
        assert_ne!(b, a);
        for order in 0..3 {
            let off = difference[order] - (b[order] - a[order]);
            assert!(off.abs() < 1e-12, "{degrees} {order}: {off:e}");
        }
    }
    page.stop_at("62").await;
    let both = page.picture("mechanism").await;
    let curves = page.picture("charts").await;
    // B itself as A: its curves stay, those of the other A are gone.
    page.click("compare-freeze").await;
    page.settle().await;
    assert!(page.picture("charts").await.difference(&curves) > 300);
    page.click("compare-remove").await;
    page.settle().await;
    assert!(!is_there(&page).await);
    assert_eq!(page.focused().await.as_deref(), Some("compare-freeze"));
    let b = page.picture("mechanism").await;
    assert!(both.difference(&b) > 300 && both.difference(&alone) > 300);
    page.close().await;
}

/// It is in the address and in what is undone; A and B are exchanged; another mechanism is compared with nothing.
#[tokio::test]
async fn a_is_kept_undone_and_exchanged() {
    let page = Page::open().await;
    page.stop_at("62").await;
    let first = row(&page, "out").await;
    page.click("compare-freeze").await;
    page.write("field-l4", "0.9").await;
    page.settle().await;
    let second = row(&page, "out").await;
    page.until("the address", async || {
        let address = page.address().await;
        address.contains("compared=") && address.contains("d.l4=0.9")
    })
    .await;
    let other = Page::open_at(&page.address().await, "en-US").await;
    assert_eq!(
        (row(&other, "a").await, row(&other, "out").await),
        (first, second)
    );
    other.close().await;

    page.click("compare-swap").await;
    page.settle().await;
    assert_eq!(
        (row(&page, "a").await, row(&page, "out").await),
        (second, first)
    );
    assert_eq!(page.written("field-l4").await, "0.85");
    page.click("undo").await;
    page.settle().await;
    assert_eq!(
        (row(&page, "a").await, row(&page, "out").await),
        (first, second)
    );
    page.click("undo").await;
    page.click("undo").await;
    page.settle().await;
    assert!(!is_there(&page).await);
    for _ in 0..3 {
        page.click("redo").await;
    }
    page.settle().await;
    assert_eq!(
        (row(&page, "a").await, row(&page, "out").await),
        (second, first)
    );
    open(&page, "jansen").await;
    page.settle().await;
    assert_eq!(page.count("#readouts .beside").await, 0);
    assert!(
        !page
            .element("compare-remove")
            .await
            .is_displayed()
            .await
            .unwrap()
    );
    page.close().await;
}

/// What A has not, or cannot do, is said; a damaged A is a sentence, and what was there stays.
#[tokio::test]
async fn what_a_cannot_do_is_said() {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    page.stop_at("50").await;
    page.click("compare-freeze").await;
    page.settle().await;
    // Driven by the rocker it goes to and fro, where A turns.
    page.choose("driver", "rocker").await;
    page.settle().await;
    assert!(page.text("compare-said").await.contains("Ⓐ is grey"));
    page.click("compare-freeze").await;
    page.choose("driver", "crank").await;
    page.stop_at("200").await;
    page.settle().await;
    page.until("the sentence", async || {
        page.text("compare-said").await == "Ⓐ cannot be assembled here."
    })
    .await;
    let dash = "return [...document.querySelectorAll('#readouts .beside td')].every(({ textContent }) => textContent === '—')";
    assert_eq!(page.ask(dash).await, json!(true));
    let before = page.written("field-length-0").await;
    for (compared, sentence) in [
        (
            "%7B%22kind%22:%22mixer%22%7D",
            "compared has the wrong format",
        ),
        (
            "%7B%22kind%22:%22%3Cb%3E%22,%22document%22:%7B%7D%7D",
            "compared.kind has the wrong format",
        ),
        (
            "%7B%22kind%22:%22linkage%22,%22document%22:%7B%22points%22:%5B%5D,%22frame%22:%5B%5D,%22links%22:%5B%5D,%22drivers%22:%5B%5D%7D%7D",
            "In mechanism Ⓐ of the comparison:",
        ),
    ] {
        let url = format!("{}#jansen&compared={compared}", home());
        page.goto(&url).await;
        page.until(sentence, async || {
            page.text("notice").await.contains(sentence)
        })
        .await;
        assert_eq!(page.written("field-length-0").await, before);
    }
    page.close().await;
}

/// The cells of a saved table, the first line those of its head.
fn cells(table: &str) -> Vec<Vec<&str>> {
    let table = table.trim_start_matches('\u{feff}');
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split(',').collect()).collect()
}

/// The table has A's columns beside B's and says which are A's; a screen reader hears of A, and how B differs.
#[tokio::test]
async fn a_is_in_the_table_and_told() {
    let page = Page::open().await;
    page.stop_at("62").await;
    page.click("compare-freeze").await;
    page.write("field-l4", "0.9").await;
    page.settle().await;
    let shown = [row(&page, "a").await[0], row(&page, "out").await[0]];
    page.until("what is told", async || {
        let said = "return document.getElementById('mechanism-description').textContent";
        let said = page.ask(said).await;
        let said = said.as_str().unwrap();
        let value = format!(" {:.1}°, Ⓑ − Ⓐ = ", shown[0]);
        said.contains("For comparison, mechanism Ⓐ: ") && said.contains(&value)
    })
    .await;
    open_dialog(&page).await;
    let table = save_text(&page, "export-table-csv", "assur-mixer.csv").await;
    assert!(table.contains("\n# Ⓐ: "), "{}", &table[..400]);
    let lines = cells(&table);
    let head = &lines[0];
    let own = head.iter().filter(|name| !name.starts_with("Ⓐ: ")).count();
    // But for the input each column of B is one of A, too.
    assert_eq!(own, head.len() - own + 1);
    let column = |name: &str| head.iter().position(|one| *one == name).unwrap();
    for (name, degrees) in ["Ⓐ: rocker.angle_deg", "rocker.angle_deg"]
        .into_iter()
        .zip(shown)
    {
        let found: f64 = lines[1 + 62][column(name)].parse().unwrap();
        let off = angle_between(found.to_radians(), degrees.to_radians());
        assert!(off < 1e-12, "{name}: {found}, {off:e} off");
    }
    assert!(lines.iter().all(|line| line.len() == head.len()));
    page.close().await;
}

/// Where A cannot be assembled the table has the reason, and B's row all the same.
#[tokio::test]
async fn the_table_says_why_a_has_no_row() {
    let page = Page::open().await;
    open(&page, "crank-rocker").await;
    // Driven by the rocker it goes to and fro.
    page.choose("driver", "rocker").await;
    page.settle().await;
    page.click("compare-freeze").await;
    page.choose("driver", "crank").await;
    page.stop_at("200").await;
    page.settle().await;
    page.until("what is told", async || {
        let said = "return document.getElementById('mechanism-description').textContent";
        let said = page.ask(said).await;
        said.as_str()
            .unwrap()
            .contains("Ⓐ cannot be assembled here.")
    })
    .await;
    open_dialog(&page).await;
    let table = save_text(&page, "export-table-csv", "assur-crank-rocker.csv").await;
    let lines = cells(&table);
    let column = |name: &str| lines[0].iter().position(|one| *one == name).unwrap();
    let row = &lines[1 + 200];
    assert_eq!(row[0], "200");
    assert_eq!(row[column("Ⓐ: C.x_length")], "");
    assert_eq!(row[column("Ⓐ: reason")], "links_apart");
    assert_ne!(row[column("C.x_length")], "");
    assert_eq!(row[column("reason")], "");
    page.close().await;
}

/// In every language, on a phone, too, all of it is named and fits.
#[tokio::test]
async fn comparisons_are_named_and_fit() {
    let page = Page::open().await;
    page.stop_at("75").await;
    page.click("compare-freeze").await;
    page.write("field-l4", "0.9").await;
    named_and_fits(&page).await;
    page.close().await;
}
