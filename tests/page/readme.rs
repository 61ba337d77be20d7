//! The example of the README, as it stands there, run in the browser.

use assur_tests::assert_near;
use serde_json::json;

use crate::browser::Page;

const README: &str = include_str!("../../README.md");

#[tokio::test]
async fn its_javascript_runs() {
    let (_, example) = README.split_once("```js\n").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let page = Page::open().await;
    // It is a module beside `pkg`; what it says on the console is its answer.
    let script = format!(
        "const [source, done] = [{}, arguments[0]];
        const said = [];
        const log = console.log;
        console.log = (...all) => said.push(...all);
        const placed = source.replace('./pkg/', new URL('pkg/', document.baseURI).href);
        const address = URL.createObjectURL(new Blob([placed], {{ type: 'text/javascript' }}));
        import(address).then(() => done(said), (error) => done([String(error)])).finally(() => (console.log = log));",
        json!(example)
    );
    let said = page.wait_for(&script).await;
    let number = |index: usize| said[index].as_f64().unwrap_or_else(|| panic!("{said}"));
    assert_near(number(0).to_degrees(), 87.904_535_205_78, 1e-9, "the swing");
    assert_near(number(1), 1.276_2, 1e-4, "φ₃ at 60°");
    page.close().await;
}
