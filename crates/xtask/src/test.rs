//! Every test, in one run: what a change is judged by.

use std::fs;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, anyhow};
use serde_json::Value;

use crate::browser::{Browser, Kind};
use crate::site;
use crate::step::run as run_step;
use crate::tally::Tally;
use crate::tools::{self, WASM};
use crate::workspace::Workspace;

/// Seconds a wasm test file may take in the browser; the default is short for a slow machine.
const WASM_TIME: &str = "300";

/// The crate that has the tests of the wasm side: package and directory.
const WASM_CRATE: (&str, &str) = ("assur-web", "crates/assur-web");

/// The programs of tests, by name: `--tests` and `--all-targets` leave out those that need a browser.
const PROGRAMS: [&str; 4] = ["native", "integration", "border", "page"];

/// Factor on the counts of random input in a run of everything.
const ALL_SCALE: &str = "10";

/// The tests of `soak`: a name, words of the tests, and the factor on their counts.
const SOAKED: [(&str, &str, u32); 2] = [
    ("200,000 drawings", "any_drawing::", 200),
    ("100,000 damaged files", "damaged::", 20),
];

/// The part of all tests that is run.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    /// At counts of random input that find faults, the page in Chromium.
    Quick,
    /// Also the tests marked `ignore`, at ten times the counts, and the page in Firefox.
    All,
}

/// Runs every step even if an earlier one failed; without a page those that need it are left out.
pub(crate) fn run(workspace: &Workspace, extent: Extent) -> Result<ExitCode> {
    tools::components(workspace)?;
    tools::wasm_target(workspace)?;
    let chromium = Browser::find_or_install(workspace, Kind::Chromium)?;
    let firefox = (extent == Extent::All)
        .then(|| Browser::find_or_install(workspace, Kind::Firefox))
        .transpose()?;

    let mut tally = Tally::default();
    let began = Instant::now();
    // Tools and page leave one processor idle for minutes: the steps that need neither use it.
    let page = thread::scope(|scope| {
        let page = scope.spawn(|| {
            let page = pages(workspace);
            (page, began.elapsed())
        });
        without_page(workspace, extent, &mut tally);
        page.join()
    });
    let (page, took) = page.map_err(|_| anyhow!("the build of the page stopped"))?;
    tally.step("page", &page, took);
    if page.is_ok() {
        let tests = wasm_tests(workspace, &chromium);
        tally.tests("wasm tests in the browser", tests);
        tally.check("types of the scripts", || types(workspace));
        let tests = node_tests(workspace, extent);
        tally.tests("tests of the scripts in Node", tests);
        let tests = page_tests(workspace, &chromium, extent, &[]);
        tally.tests("page tests in Chromium", Ok(tests));
        if let Some(firefox) = firefox {
            let tests = page_tests(workspace, &firefox, extent, &[]);
            tally.tests("page tests in Firefox", Ok(tests));
        }
    }
    ended(&tally)
}

/// Builds the page, the page with one more folder, and all that is given away.
fn pages(workspace: &Workspace) -> Result<()> {
    site::set_up_and_build(workspace)?;
    site::build_with(workspace, &workspace.root().join("tests/data/page"))?;
    site::give_away(workspace)
}

/// The steps that need no built page.
fn without_page(workspace: &Workspace, extent: Extent, tally: &mut Tally) {
    let strict = ["--", "-D", "warnings"];
    let mut doc = workspace.cargo(["doc", "--workspace", "--no-deps"]);
    doc.env("RUSTDOCFLAGS", "-D warnings");
    let programs = ["--lib", "--bins"].into_iter();
    let programs = programs.chain(PROGRAMS.iter().flat_map(|name| ["--test", name]));
    let mut lint = workspace.cargo(["clippy", "--workspace"]);
    lint.args(programs.clone())
        .args(["--test", "*speed"])
        .args(strict);
    let mut wasm_lint = workspace.cargo(["clippy", "--tests", "--target", WASM]);
    wasm_lint.args(["--package", WASM_CRATE.0]).args(strict);
    // Also the page tests, which run later, while both processors have work.
    let mut compilation = workspace.cargo(["test", "--workspace", "--no-run"]);
    compilation.args(programs);
    for (name, mut command) in [
        ("format", workspace.cargo(["fmt", "--all", "--check"])),
        ("lint", lint),
        ("lint of the wasm side", wasm_lint),
        ("documentation", doc),
        ("compilation of the tests", compilation),
    ] {
        tally.check(name, || run_step(&mut command, name));
    }
    for (name, targets) in [("native tests", "--tests"), ("doc tests", "--doc")] {
        let cargo = workspace.cargo(["test", "--workspace", "--no-fail-fast", targets]);
        tally.tests(name, Ok(extended(cargo, extent)));
    }
}

/// Runs the tests of random input at counts for which a run has no time, from a seed.
pub(crate) fn soak(workspace: &Workspace, seed: u64) -> Result<ExitCode> {
    let mut tally = Tally::default();
    for (name, test, scale) in SOAKED {
        let mut cargo = workspace.cargo(["test", "--workspace", "--tests", "--", test]);
        cargo
            .env("ASSUR_SCALE", scale.to_string())
            .env("ASSUR_SEED", seed.to_string());
        tally.tests(name, Ok(cargo));
    }
    ended(&tally)
}

/// Runs the page tests alone, in one browser: all, or those whose names hold one of the words.
pub(crate) fn run_page(
    workspace: &Workspace,
    kind: Kind,
    extent: Extent,
    words: &[String],
) -> Result<ExitCode> {
    let browser = Browser::find_or_install(workspace, kind)?;
    pages(workspace)?;
    let mut tally = Tally::default();
    let tests = page_tests(workspace, &browser, extent, words);
    tally.tests("page tests", Ok(tests));
    ended(&tally)
}

fn ended(tally: &Tally) -> Result<ExitCode> {
    let passed = tally.summarise(std::io::stdout());
    let passed = passed.context("the summary cannot be written")?;
    Ok(ExitCode::from(u8::from(!passed)))
}

/// The tests of the wasm side, which the runner that comes with wasm-bindgen runs in a browser.
pub(crate) fn wasm_tests(workspace: &Workspace, browser: &Browser) -> Result<Command> {
    let bindgen = tools::wasm_bindgen(workspace)?;
    let runner = bindgen.with_file_name("wasm-bindgen-test-runner");
    let mut tests = workspace.cargo(["test", "--target", WASM, "--package", WASM_CRATE.0]);
    tests
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", runner)
        .env("CHROMEDRIVER", &browser.driver)
        // It would take this one first.
        .env_remove("GECKODRIVER")
        .env(
            "WASM_BINDGEN_TEST_WEBDRIVER_JSON",
            capabilities(workspace, browser)?,
        )
        .env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIME);
    Ok(tests)
}

/// The crate's webdriver.json completed with the browser that was found: the driver by itself might
/// choose another, or none.
fn capabilities(workspace: &Workspace, browser: &Browser) -> Result<PathBuf> {
    let source = workspace.root().join(WASM_CRATE.1).join("webdriver.json");
    let known = || format!("{} is not as it should be", source.display());
    let mut value: Value = serde_json::from_str(&fs::read_to_string(&source).with_context(known)?)
        .with_context(known)?;
    value
        .get_mut("goog:chromeOptions")
        .and_then(Value::as_object_mut)
        .with_context(known)?
        .insert(
            "binary".to_owned(),
            browser.program.to_string_lossy().into(),
        );
    let path = workspace.target().join("webdriver.json");
    fs::write(&path, value.to_string())
        .with_context(|| format!("{} cannot be written", path.display()))?;
    Ok(path)
}

/// Checks the types of the scripts of the page and of those that build it; the build has written the types of the border.
fn types(workspace: &Workspace) -> Result<()> {
    for project in [".", "crates/xtask/build"] {
        let mut node = workspace.command("node");
        let checker = node.args(["node_modules/typescript/bin/tsc", "--project", project]);
        run_step(checker, "types of the scripts")?;
    }
    Ok(())
}

/// The tests of the scripts in `www` and of those that build the page.
fn node_tests(workspace: &Workspace, extent: Extent) -> Result<Command> {
    let mut node = workspace.command("node");
    node.args(["--import", "./tests/scripts/register.mjs"]);
    node.args(["--test", "--test-reporter=spec"]);
    node.arg(format!("--test-concurrency={}", processors()));
    for folder in ["www", "crates/xtask/build"] {
        for test in files(&workspace.root().join(folder))? {
            node.arg(test);
        }
    }
    node.env("ASSUR_SITE", workspace.site());
    if extent == Extent::All {
        node.env("ASSUR_SCALE", ALL_SCALE);
    }
    Ok(node)
}

/// The files `*.test.js` of a folder and of those in it.
fn files(folder: &Path) -> Result<Vec<PathBuf>> {
    let unreadable = || format!("{} cannot be read", folder.display());
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).with_context(unreadable)? {
        let path = entry.with_context(unreadable)?.path();
        if path.is_dir() {
            found.extend(files(&path)?);
        } else if path.to_string_lossy().ends_with(".test.js") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// The page tests: all, or those whose names hold one of the words.
fn page_tests(
    workspace: &Workspace,
    browser: &Browser,
    extent: Extent,
    words: &[String],
) -> Command {
    let mut test = extended(page_test(workspace, "page", browser), extent);
    // A test waits for its browser now and then.
    test.arg(format!("--test-threads={}", processors() + 1));
    test.args(words);
    test
}

/// A program of tests that opens the built page, in its forms.
pub(crate) fn page_test(workspace: &Workspace, name: &str, browser: &Browser) -> Command {
    // All packages, so that nothing is compiled again with other features.
    let mut test = workspace.cargo(["test", "--workspace", "--test", name]);
    test.env("ASSUR_SITE", workspace.site())
        .env("ASSUR_MORE", workspace.site_with_more())
        .env("ASSUR_BUNDLE", workspace.bundle())
        .envs(browser.variables());
    test
}

/// A command of `cargo test` with all that an extent asks for; what is added to it goes to the tests.
fn extended(mut cargo: Command, extent: Extent) -> Command {
    cargo.arg("--");
    if extent == Extent::All {
        cargo.arg("--include-ignored").env("ASSUR_SCALE", ALL_SCALE);
    }
    cargo
}

fn processors() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
