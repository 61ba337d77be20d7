//! What is printed: a worksheet in the place of the page, the sheets of a class.

use std::fs;

use serde_json::{Value, json};
use thirtyfour::common::print::PrintParameters;

use crate::browser::Page;
use crate::browser::setting::lacking;
use crate::gallery;
use crate::host::home;
use crate::lecturers::{fill, open_tab, press, there};

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
    let page = Page::open_at(&format!("{}#jansen", home()), "en-US").await;
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

/// The steps of the open lesson have text and formula, and lines to answer on or what is to be chosen from.
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
    assert_eq!(titles.len(), 16, "{titles:?}");
    let text = &texts(&page, "#worksheet li:first-child > p").await[0];
    assert!(
        text.starts_with("The mechanism has seven moving links"),
        "{text}"
    );
    assert_eq!(titles[0], title);
    for title in 1..=titles.len() {
        let lines = format!("#worksheet li:nth-child({title}) :is(.blank, .choice)");
        assert!(page.count(&lines).await >= 2, "{title}");
    }
    let dimensions = texts(&page, "#worksheet .tables > table td").await;
    assert!(dimensions.len() > 8, "{dimensions:?}");
    page.close().await;
}

/// What tells the answer of any question of the open lesson is not printed, whichever step is open; on the page the others
/// stay.
#[tokio::test]
async fn a_printed_lesson_does_not_answer_itself() {
    let page = Page::open().await;
    page.stop_at("62").await;
    page.click("tab-lesson").await;
    page.until("the lesson", async || {
        page.count("#lesson-check").await == 1
    })
    .await;
    page.settle().await;
    printed(&page).await;
    let said = texts(&page, "#worksheet .tables p").await;
    for asked in ["ratio", "swing-wheel5", "time-ratio"] {
        let title = format!("#out-{asked}");
        let script = format!(
            "return document.querySelector('{title}').closest('.entry').querySelector('dt').textContent"
        );
        let title = page.ask(&script).await.as_str().unwrap().to_owned();
        let entry = said.iter().find(|entry| entry.starts_with(&title));
        let entry = entry.unwrap_or_else(|| panic!("{title}: {said:?}"));
        assert!(
            entry[title.len()..].trim_start().starts_with('?'),
            "{entry}"
        );
    }
    page.ask("dispatchEvent(new Event('afterprint'))").await;
    page.show_on("", &[]).await;
    page.settle().await;
    assert_eq!(page.value("out-ratio").await, -2.0);
    page.close().await;
}

/// What is printed in motion is one pose, in the drawing and in the table.
#[tokio::test]
async fn a_worksheet_is_of_one_pose() {
    let page = Page::playing().await;
    page.until("what prints", async || {
        page.ask("return performance.getEntriesByName('printable').length")
            .await
            == 1
    })
    .await;
    // The numbers on the page are written five times a second: some of these are in between.
    for _ in 0..10 {
        let script = "dispatchEvent(new Event('beforeprint'));
            const sheet = document.getElementById('worksheet');
            const drawn = [...sheet.querySelectorAll('figure text')].map(({ textContent }) => textContent).find((text) => text.startsWith('φ₁ = '));
            const row = [...sheet.querySelectorAll('.tables > div tr')].find(({ textContent }) => textContent.trim().startsWith('φ₁'));
            const written = row.children[1].textContent;
            dispatchEvent(new Event('afterprint'));
            arguments[0]([drawn.slice(5), written].map((text) => parseFloat(text)))";
        let shown = page.numbers(script).await;
        let off = (shown[0] - shown[1]).rem_euclid(360.0);
        assert!(off.min(360.0 - off) <= 0.6, "{shown:?}");
        page.settle().await;
    }
    page.close().await;
}

/// A lesson with two drawings, with numbers of one's own, and a text as long as a page.
async fn lesson(page: &Page) -> Value {
    let sentence = "The foot goes along a path of which the lower part is nearly straight. ";
    let script = format!(
        "const done = arguments[0];
        window.eval(\"import('assur/pkg/assur_web.js')\").then(({{ catalogue }}) => {{
            const of = (name) => {{
                const {{ kind, document }} = catalogue().find(({{ id }}) => id === name);
                return {{ kind, document }};
            }};
            const number = (quantity) => ({{ text: 'How far is *it* from O?', number: {{ quantity, within: 0.5 }} }});
            const steps = [
                {{ title: 'Leg', text: 'With *your* crank.', formula: 'x_M = l_1 cos φ\\ny_M = l_1 sin φ',
                    shows: {{ ...of('jansen'), view: {{ phi_deg: 120 }}, vary: [{{ field: 'links[0].length', from: 12, to: 18, step: 0.5 }}] }}, question: number('F.x') }},
                {{ title: 'Length', text: '', question: {{ text: 'How long?', number: {{ value: 3.5, unit: 'mm', within: 0.5 }} }} }},
                {{ title: 'Long', text: '{}', shows: {{ ...of('train-magnets'), vary: [{{ field: 'drives[0].rpm', from: 20, to: 80, step: 5 }}] }}, question: number('sun.angle′') }},
                {{ title: 'Class', text: '', question: {{ text: 'Which?', choice: {{ options: ['II', '*III*'], answer: 1 }} }} }},
                {{ title: 'Turn', text: '', shows: of('jansen'), question: {{ text: 'To 90°.', reach: {{ quantity: 'input', value: 90, within: 1 }} }} }},
            ];
            done({{ format: 2, ...of('jansen'), lesson: {{ title: 'Legs', author: 'A. Lecturer', steps }} }});
        }})",
        sentence.repeat(60)
    );
    page.wait_for(&script).await
}

/// Has the sheets stand there as they do while the browser prints.
const HOLD: &str = "let held = null;
addEventListener('beforeprint', () => {
    if (!held) return;
    document.getElementById('worksheet')?.remove();
    document.body.append(held.cloneNode(true));
});
window.print = () => {
    held = null;
    dispatchEvent(new Event('beforeprint'));
    held = document.getElementById('worksheet').cloneNode(true);
};";

/// How many pages a document has, where the file says so in plain words: Firefox packs them.
async fn pages(page: &Page) -> Option<usize> {
    if lacking("pages that can be counted") {
        return None;
    }
    let pdf = page.driver.print_page(PrintParameters::default()).await;
    let pdf = pdf.unwrap();
    let start = b"/Type /Page\n";
    let found = pdf.windows(start.len()).filter(|part| part == start);
    Some(found.count())
}

#[tokio::test]
async fn the_sheets_of_a_class_are_whole() {
    let page = Page::open_at(&format!("{}#jansen", home()), "en-US").await;
    page.until("what prints", async || {
        page.ask("return performance.getEntriesByName('printable').length")
            .await
            == 1
    })
    .await;
    let path = page.downloads().join("class.json");
    fs::write(&path, lesson(&page).await.to_string()).unwrap();
    page.choose_file("file", &path).await;
    open_tab(&page).await;
    there(&page, "lesson-title").await;
    page.click("menu").await;
    page.click("write-lesson").await;
    there(&page, "write-class").await;
    press(&page, "write-class").await;
    fill(&page, "write-names", "Ann\nBo\nCai").await;
    page.ask(HOLD).await;
    press(&page, "write-print_tasks").await;
    page.show_on("print", &[]).await;
    assert_eq!(
        texts(&page, "#worksheet .sheet:first-child .title").await,
        ["Leg", "Length", "Long", "Class", "Turn"]
    );
    let emphasised = texts(&page, "#worksheet .sheet:first-child em").await;
    assert_eq!(emphasised, ["your", "it", "it", "III"]);
    let questions = texts(&page, "#worksheet .sheet:first-child .asked b").await;
    assert_eq!(questions[1], "How long (to within 0.5 mm)?");
    // Drawings are those of the step, where its driver stands.
    let labels = texts(&page, "#worksheet .sheet:first-child figure text").await;
    assert!(labels.contains(&"φ₁ = 120.0°".to_owned()), "{labels:?}");
    // Formulas are one a line; nothing is wider than the paper; what belongs together is kept so.
    let seen = page
        .ask(
            "const sheet = document.getElementById('worksheet');
            const { right } = sheet.getBoundingClientRect();
            const formula = sheet.querySelector('.formula');
            const lines = formula.getBoundingClientRect().height / parseFloat(getComputedStyle(formula).lineHeight);
            const wide = [...sheet.querySelectorAll('*')].filter((one) => one.getBoundingClientRect().right > right + 0.5).length;
            const whole = [...sheet.querySelectorAll('figure, .asked, li')].every((one) => getComputedStyle(one).breakInside === 'avoid');
            // A letter is 0.8 of its size high at most, in the middle of its line.
            const figures = [...sheet.querySelectorAll('figure svg')];
            const cut = figures.flatMap((svg) => {
                const frame = svg.getBoundingClientRect();
                const inside = (text) => {
                    const { left, right, top, bottom } = text.getBoundingClientRect();
                    const free = (bottom - top - 0.8 * parseFloat(getComputedStyle(text).fontSize)) / 2;
                    return left >= frame.left && right <= frame.right && top + free >= frame.top && bottom - free <= frame.bottom;
                };
                return [...svg.querySelectorAll('text')].filter((text) => !inside(text)).map(({ textContent }) => textContent);
            });
            return [Math.round(lines), wide, whole, figures.length, cut];",
        )
        .await;
    assert_eq!(seen, json!([2, 0, true, 9, []]));

    // Each name begins a page, and has as many as the others: all given numbers are on them.
    let count = pages(&page).await;
    assert!(count.is_none_or(|count| count == 12), "{count:?}");

    page.show_on("", &[]).await;
    press(&page, "write-print_answers").await;
    let answers = texts(&page, "#worksheet .sheet:nth-child(2) .answer").await;
    assert_eq!(answers[1], "3.5 mm");
    assert_eq!(answers[3..], ["III", "φ₁ = 90°"]);
    assert_eq!(page.count("#worksheet .answer em").await, 3);
    // Two of them find room on a page; none is divided.
    assert!(pages(&page).await.is_none_or(|count| count == 2));
    page.close().await;
}
