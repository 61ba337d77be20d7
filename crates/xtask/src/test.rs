//! All tests in one run, which every change must pass.

use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, anyhow};
use serde_json::{Value, json};
use xshell::{Cmd, Shell, cmd};

use crate::browser::{Browser, Kind};
use crate::packages;
use crate::site;
use crate::step::run as run_step;
use crate::tally::Tally;
use crate::tools::{self, WASM};
use crate::workspace::Workspace;

/// Time limit of a wasm test file in the browser, seconds; the default is too short for a slow machine.
const WASM_TIME: &str = "300";

/// Factor by which the amount of random input is multiplied if long tests are run as well.
const ALL_SCALE: &str = "10";

/// The tests of `soak`: a name, the part of the tests' paths that selects them, and the factor by which their random
/// input is multiplied. Each test of a reader takes about a minute.
const SOAKED: [(&str, &str, &str); 13] = [
    ("rows of 200,000 drawings", "any_drawing::rows_are", "1100"),
    ("200,000 drawings redrawn", "any_drawing::a_motion", "200"),
    ("100,000 damaged files", "damaged::thousands", "25"),
    (
        "50 four-bars from nine points",
        "nine_points::four_bars",
        "50",
    ),
    ("100 sets of nine points", "nine_points::complex", "100"),
    ("states", "readers::damaged_states", "100"),
    ("documents", "readers::damaged_documents", "100"),
    ("short links of PMKS+", "readers::damaged_short", "100"),
    ("long links of PMKS+", "readers::damaged_long", "100"),
    ("links of PMKS", "readers::damaged_links", "100"),
    ("files of Linkage", "readers::damaged_files", "100"),
    ("files for the terminal", "damaged::damaged_files", "100"),
    ("terminal's arguments", "damaged::damaged_arguments", "100"),
];

/// Tests of scripts that read damaged input, and the factor by which their input is multiplied. They take about a
/// minute.
const SOAKED_SCRIPTS: ([&str; 2], &str) =
    (["www/app/damage.test.js", "www/state/codec.test.js"], "100");

/// Runs all steps. If a browser or words are given, runs only page tests, whose names must contain one of the words.
/// With `all`, also runs tests marked `ignore`, and uses more random input.
pub(crate) fn run(
    workspace: &Workspace,
    all: bool,
    kind: Option<Kind>,
    words: &[String],
) -> Result<ExitCode> {
    if all {
        workspace.shell.set_var("ASSUR_SCALE", ALL_SCALE);
    }
    if kind.is_none() && words.is_empty() {
        return run_steps(workspace, all);
    }
    let browser = Browser::find_or_install(workspace, kind.unwrap_or(Kind::Chromium))?;
    pages(workspace)?;
    let mut tally = Tally::default();
    let tests = page_tests(workspace, &browser, all, words);
    tally.tests("page tests", Ok(tests));
    ended(&tally)
}

/// Runs every step even if an earlier one failed. If the page cannot be built, the steps that need it are skipped.
fn run_steps(workspace: &Workspace, all: bool) -> Result<ExitCode> {
    tools::components(workspace)?;
    tools::wasm_target(workspace)?;
    let find = |kind| Browser::find_or_install(workspace, kind);
    let chromium = find(Kind::Chromium)?;
    let firefox = all.then(|| find(Kind::Firefox)).transpose()?;

    let mut tally = Tally::default();
    let began = Instant::now();
    // While the tools are installed and the page is built, one processor is idle: steps that need neither run on it.
    let building = workspace.clone();
    let page = thread::spawn(move || {
        let page = pages(&building).and_then(|()| tools::wasm_pack(&building));
        (page.map(drop), began.elapsed())
    });
    without_page(workspace, all, &mut tally);
    let page = page.join();
    let (page, took) = page.map_err(|_| anyhow!("the build of the page stopped"))?;
    tally.step("page", &page, took);
    if page.is_ok() {
        tally.tests(
            "wasm tests in the browser",
            wasm_tests(workspace, &chromium),
        );
        tally.check("types of the scripts", || types(workspace));
        tally.tests("tests of the scripts in Node", node_tests(workspace));
        let tests = page_tests(workspace, &chromium, all, &[]);
        tally.tests("page tests in Chromium", Ok(tests));
        if let Some(firefox) = firefox {
            let tests = page_tests(workspace, &firefox, all, &[]);
            tally.tests("page tests in Firefox", Ok(tests));
        }
    }
    ended(&tally)
}

/// Builds the page, the page with one more folder, and all distributed forms.
fn pages(workspace: &Workspace) -> Result<()> {
    site::set_up_and_build(workspace)?;
    site::build_with(workspace, &workspace.root.join("tests/data/page"))?;
    site::give_away(workspace)
}

/// The steps that need no built page.
fn without_page(workspace: &Workspace, all: bool, tally: &mut Tally) {
    let shell = &workspace.shell;
    // Test programs are selected by name: `--tests` and `--all-targets` would leave out those that need a browser.
    let lint = cmd!(shell, "cargo clippy --workspace --lib --bins --test *");
    let wasm_lint = cmd!(
        shell,
        "cargo clippy --package assur-web --tests --target {WASM}"
    );
    let strict = ["--", "-D", "warnings"];
    let doc = cmd!(shell, "cargo doc --workspace --no-deps").env("RUSTDOCFLAGS", "-D warnings");
    // The page tests run later, but are compiled here as well, so that both processors are busy.
    let programs = ["native", "integration", "border", "page"].map(|name| ["--test", name]);
    let programs = programs.as_flattened();
    let compilation = cmd!(
        shell,
        "cargo test --workspace --no-run --lib --bins {programs...}"
    );
    for (name, command) in [
        ("format", cmd!(shell, "cargo fmt --all --check")),
        ("lint", lint.args(strict)),
        ("lint of the wasm side", wasm_lint.args(strict)),
        ("documentation", doc),
        ("compilation of the tests", compilation),
    ] {
        tally.check(name, || run_step(command, name));
    }
    if all {
        tally.check("packages", || packages::check(workspace));
    }
    let ignored = all.then_some("--include-ignored");
    for (name, targets) in [("native tests", "--tests"), ("doc tests", "--doc")] {
        let cargo = cmd!(
            shell,
            "cargo test --workspace --no-fail-fast {targets} -- {ignored...}"
        );
        tally.tests(name, Ok(cargo));
    }
}

/// Runs the randomized tests from a given seed, with more input than in a usual run.
pub(crate) fn soak(workspace: &Workspace, seed: u64) -> Result<ExitCode> {
    let mut tally = Tally::default();
    for (name, test, scale) in SOAKED {
        let cargo = cmd!(
            workspace.shell,
            "cargo test --workspace --tests -- --include-ignored {test}"
        );
        let cargo = cargo.env("ASSUR_SCALE", scale);
        tally.tests(name, Ok(cargo.env("ASSUR_SEED", seed.to_string())));
    }
    site::set_up_and_build(workspace)?;
    let (scripts, scale) = SOAKED_SCRIPTS;
    let node = node(workspace, &scripts.map(PathBuf::from));
    let node = node.env("ASSUR_SCALE", scale);
    tally.tests(
        "addresses and files of the page",
        Ok(node.env("ASSUR_SEED", seed.to_string())),
    );
    ended(&tally)
}

fn ended(tally: &Tally) -> Result<ExitCode> {
    let passed = tally.summarise(std::io::stdout());
    let passed = passed.context("the summary cannot be written")?;
    Ok(ExitCode::from(u8::from(!passed)))
}

/// Command that runs the tests of the wasm side with wasm-pack. All that wasm-pack needs is set up here, because it
/// must not download anything.
pub(crate) fn wasm_tests<'a>(workspace: &'a Workspace, browser: &Browser) -> Result<Cmd<'a>> {
    let Workspace { shell, target, .. } = workspace;
    let [pack, bindgen] = [tools::wasm_pack, tools::wasm_bindgen].map(|tool| tool(workspace));
    let (pack, driver) = (pack?, &browser.driver);
    // Without this option the driver might choose another browser, or none.
    let options = shell.read_file("crates/assur-web/webdriver.json")?;
    let mut options: Value = serde_json::from_str(&options)?;
    options["goog:chromeOptions"]["binary"] = json!(browser.program);
    let place = target.join("webdriver.json");
    shell.write_file(&place, options.to_string())?;
    let tests = cmd!(
        shell,
        "{pack} test --headless --chrome --mode no-install --chromedriver {driver} crates/assur-web"
    );
    Ok(tests
        .env("PATH", tools::search_path(&bindgen?)?)
        .env("WASM_PACK_CACHE", target.join("wasm-pack"))
        .env("WASM_BINDGEN_TEST_WEBDRIVER_JSON", place)
        .env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIME))
}

/// Checks the types of the page's scripts and of the build's scripts; the engine's types were written by the build.
fn types(workspace: &Workspace) -> Result<()> {
    let checker = "node_modules/typescript/bin/tsc";
    for project in [".", "crates/xtask/build"] {
        let node = cmd!(workspace.shell, "node {checker} --project {project}");
        run_step(node, "types of the scripts")?;
    }
    Ok(())
}

/// Command that runs the tests of the scripts in `www` and of the scripts that build the page.
fn node_tests(workspace: &Workspace) -> Result<Cmd<'_>> {
    let shell = &workspace.shell;
    let mut tests = files(shell, "www".as_ref())?;
    tests.extend(files(shell, "crates/xtask/build".as_ref())?);
    Ok(node(workspace, &tests))
}

/// Command that runs tests of scripts with the engine of the built page.
fn node<'a>(workspace: &'a Workspace, tests: &[PathBuf]) -> Cmd<'a> {
    let node = cmd!(
        workspace.shell,
        "node --import ./tests/scripts/register.mjs --test --test-reporter=spec"
    );
    node.arg(format!("--test-concurrency={}", processors()))
        .args(tests)
        .env("ASSUR_SITE", workspace.site())
}

/// The files `*.test.js` of a folder and its subfolders.
fn files(shell: &Shell, folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for path in shell.read_dir(folder)? {
        if path.is_dir() {
            found.extend(files(shell, &path)?);
        } else if path.to_string_lossy().ends_with(".test.js") {
            found.push(path);
        }
    }
    Ok(found)
}

/// Command that runs the page tests: all, or those whose names contain one of the words.
fn page_tests<'a>(
    workspace: &'a Workspace,
    browser: &Browser,
    all: bool,
    words: &[String],
) -> Cmd<'a> {
    // One more thread than there are processors, because a test may be waiting for its browser.
    let threads = format!("--test-threads={}", processors() + 1);
    page_test(workspace, "page", browser)
        .args(["--", &threads])
        .args(all.then_some("--include-ignored"))
        .args(words)
}

/// Command that runs a test program. The program gets the paths of the built page in all its forms, and the browser.
pub(crate) fn page_test<'a>(workspace: &'a Workspace, name: &str, browser: &Browser) -> Cmd<'a> {
    // The whole workspace is selected, so that nothing is compiled again with other features.
    cmd!(workspace.shell, "cargo test --workspace --test {name}")
        .env("ASSUR_SITE", workspace.site())
        .env("ASSUR_MORE", workspace.site_with_more())
        .env("ASSUR_BUNDLE", workspace.root.join("dist/assur.html"))
        .envs(browser.variables())
}

fn processors() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}
