//! Practice: mechanisms that nobody has counted yet, set by the page and answered by the engine.

use assur::mobility::{Scheme, generated};

use crate::browser::Page;
use crate::mobility::{cut, document, open};

/// The number of the task that is set.
async fn task(page: &Page) -> Option<u32> {
    let address = page.address().await;
    let (_, rest) = address.split_once("&d.task=")?;
    rest.split('&').next()?.parse().ok()
}

/// The first task at or after a number that has closed contours, or none.
fn numbered(from: u32, closed: bool) -> (u32, Scheme) {
    let mut schemes = (from..).map(|number| (number, Scheme::new(&generated(number)).unwrap()));
    let found = schemes.find(|(_, scheme)| scheme.sections(&[]).is_err() == closed);
    found.unwrap()
}

/// Sets a new task, whose number the page draws by chance.
async fn set(page: &Page, number: u32) {
    let drawn = (f64::from(number) + 0.5) / 100_000.0;
    // Of the page: a script of the driver has a `Math` of its own in Firefox.
    page.ask(&format!("window.Math.random = () => {drawn}"))
        .await;
    page.click("practice-new").await;
    page.until("a task", async || task(page).await == Some(number))
        .await;
}

/// A task shows none of its answers; each answer is checked against the engine's count, and those that need all
/// contours open only then; the next task is another mechanism.
#[tokio::test]
async fn tasks_are_set_and_checked() {
    let page = open(&document("mobility-2a")).await;
    let (number, scheme) = numbered(34_000, true);
    set(&page, number).await;
    assert_eq!(page.count("#out-scheme-w").await, 1);
    assert!(!page.text("status").await.contains('='));
    for section in ["scheme-formulas", "scheme-geometry"] {
        assert_eq!(page.text(section).await, "", "{section}");
    }
    let verdict = async |id: &str| page.attribute(id, "data-verdict").await;
    page.write("practice-open", "1").await;
    assert_eq!(verdict("practice-open").await.as_deref(), Some("first"));

    let automatic = scheme.automatic();
    for one in &automatic {
        cut(&page, &scheme.cut_name(*one)).await;
    }
    let sections = scheme.sections(&automatic).unwrap();
    let counts = scheme.counts();
    let mobility = counts.mobility();
    let mut answers = vec![
        ("links".to_owned(), counts.links as isize),
        ("open".to_owned(), sections.open as isize),
        ("removed".to_owned(), sections.removed as isize),
        ("w".to_owned(), mobility),
        ("q".to_owned(), counts.redundant(mobility)),
    ];
    for (freedoms, count) in &counts.pairs {
        answers.push((format!("pairs-{freedoms}"), *count as isize));
    }
    for (name, answer) in answers {
        let id = format!("practice-{name}");
        for (value, expected) in [(answer + 1, "wrong"), (answer, "right")] {
            page.write(&id, &value.to_string()).await;
            assert_eq!(
                verdict(&id).await.as_deref(),
                Some(expected),
                "{number} {name}"
            );
        }
    }
    let done = page.text("practice-said").await;
    assert!(done.contains("All correct"), "{done}");

    // An open chain needs no cut: its answers are judged at once.
    let (number, scheme) = numbered(number, false);
    set(&page, number).await;
    assert_eq!(page.written("practice-w").await, "");
    let open = scheme.sections(&[]).unwrap().open;
    for (value, expected) in [(open + 1, "wrong"), (open, "right")] {
        page.write("practice-open", &value.to_string()).await;
        assert_eq!(verdict("practice-open").await.as_deref(), Some(expected));
    }
    // The same number drawn again would be the same mechanism.
    page.click("practice-new").await;
    page.until("another task", async || {
        task(&page).await == Some(number + 1)
    })
    .await;
    page.click("practice-end").await;
    let other = page.value("out-scheme-w").await;
    assert!(other.is_finite());
    page.close().await;
}
