//! What is printed: a worksheet in the place of the page.

use serde_json::json;
use thirtyfour::common::print::PrintParameters;

use crate::browser::{Page, setting};
use crate::gallery;

/// The worksheet as it is when the browser prints, of a reader who likes dark pages.
async fn printed(page: &Page) {
    page.until("what prints", async || {
        page.ask("return performance.getEntriesByName('printable').length")
            .await
            == 1
    })
    .await;
    page.ask("dispatchEvent(new Event('beforeprint'))").await;
    page.show_on("print", &[("prefers-color-scheme", "dark")])
        .await;
}

async fn texts(page: &Page, selector: &str) -> Vec<String> {
    let script = format!(
        "return [...document.querySelectorAll('{selector}')].map(({{ textContent }}) => textContent)"
    );
    serde_json::from_value(page.ask(&script).await).unwrap()
}

#[tokio::test]
async fn a_mechanism_is_printed_with_its_numbers_and_its_address() {
    let page = Page::open_at(&format!("{}#jansen", setting("ASSUR_URL")), "en-US").await;
    page.stop_at("30").await;
    printed(&page).await;
    assert_eq!(texts(&page, "#worksheet h1").await, ["Jansen leg linkage"]);
    assert_eq!(page.count("#worksheet figure svg").await, 2);
    let lengths = texts(&page, "#worksheet .tables > table td").await;
    assert!(
        lengths.len() > 8 && lengths.iter().all(|length| !length.is_empty()),
        "{lengths:?}"
    );
    let link = &texts(&page, "#worksheet footer p").await[0];
    assert!(
        link.ends_with("#jansen&v.phi_deg=30&v.playing=false"),
        "{link}"
    );
    assert_eq!(page.count("#worksheet footer .code path").await, 1);

    // Nothing else is on the paper, which is white; pictures keep their proportions.
    let seen = page
        .ask(
            "const sheet = document.getElementById('worksheet');
            const others = [...document.body.children].filter((one) => one !== sheet && getComputedStyle(one).display !== 'none');
            const bent = [...sheet.querySelectorAll('figure svg')].map((svg) => {
                const { width, height } = svg.getBoundingClientRect();
                return width / height / (svg.viewBox.baseVal.width / svg.viewBox.baseVal.height);
            });
            return [others.length, getComputedStyle(sheet).backgroundColor, bent.every((by) => Math.abs(by - 1) < 0.01)];",
        )
        .await;
    assert_eq!(seen, json!([0, "rgb(255, 255, 255)", true]));
    let pdf = page.driver.print_page(PrintParameters::default()).await;
    assert!(pdf.unwrap().len() > 15_000);
    page.ask("dispatchEvent(new Event('afterprint'))").await;
    assert_eq!(page.count("#worksheet").await, 0);
    page.close().await;
}

/// The questions of the open lesson have lines to answer on or what is to be chosen from; nothing that a step withholds
/// is printed.
#[tokio::test]
async fn a_lesson_is_printed_with_its_questions() {
    let page = Page::open().await;
    page.stop_at("62").await;
    gallery::open(&page, "class4-dwell").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || {
        page.count("#lesson-check").await == 1
    })
    .await;
    page.settle().await;
    let title = page.text("lesson-title").await;
    printed(&page).await;
    let titles = texts(&page, "#worksheet li > b").await;
    assert_eq!(titles.len(), 7, "{titles:?}");
    assert_eq!(titles[0], title);
    for title in 1..=titles.len() {
        let lines = format!("#worksheet li:nth-child({title}) :is(.blank, .choice)");
        assert!(page.count(&lines).await >= 2, "{title}");
    }
    let dimensions = texts(&page, "#worksheet .tables > table td").await;
    assert!(dimensions.len() > 8, "{dimensions:?}");
    page.close().await;
}
