//! Every test, in one run: what a change is judged by.

use std::fs;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Error, Result, anyhow};
use serde_json::Value;

use crate::browser::{self, Browser, Kind};
use crate::server::Server;
use crate::site;
use crate::step::{announce, run as run_step};
use crate::tally::Tally;
use crate::tools::{self, WASM};
use crate::workspace::Workspace;

/// Seconds a wasm test file may take in the browser; the default is short for a slow machine.
const WASM_TIME: &str = "300";

/// The crate that has the tests of the wasm side: package and directory.
const WASM_CRATE: (&str, &str) = ("assur-web", "crates/assur-web");

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

/// The parts that the first steps need, each or the reason why it is missing.
struct SetUp {
    components: Result<()>,
    target: Result<()>,
    browser: Result<Browser>,
}

/// The tools of the page and the page, each or the reason why it is missing.
struct Built {
    bindgen: Result<PathBuf>,
    pack: Result<PathBuf>,
    packages: Result<()>,
    page: Result<()>,
    took: Duration,
}

/// Runs every step even if an earlier one failed. A step that needs what failed counts as failed.
pub(crate) fn run(workspace: &Workspace, extent: Extent) -> Result<ExitCode> {
    let ready = SetUp::new(workspace);
    let firefox = (extent == Extent::All).then(|| found(workspace, Kind::Firefox));
    let mut tally = Tally::default();

    // Tools and page leave one processor idle for minutes: the steps that need neither use it.
    let built = thread::scope(|scope| {
        let built = scope.spawn(|| Built::new(workspace, &ready));
        without_page(workspace, &ready, extent, &mut tally);
        built.join()
    });
    let built = built.map_err(|_| anyhow!("the build of the page stopped"))?;
    let page = &built.page;
    tally.step("page", page, built.took);
    tally.tests(
        "wasm tests in the browser",
        built.wasm_tests(workspace, &ready),
    );
    with_page(workspace, &ready, &built, extent, &mut tally);
    if let Some(firefox) = firefox {
        let tests = page_tests(workspace, &firefox, page, extent, &[]);
        tally.tests("page tests in Firefox", tests);
    }
    ended(&tally)
}

/// The steps that need no built page.
fn without_page(workspace: &Workspace, ready: &SetUp, extent: Extent, tally: &mut Tally) {
    tally.check("format", || {
        needed(&ready.components)?;
        run_step(&mut workspace.cargo(["fmt", "--all", "--check"]), "format")
    });
    tally.check("lint", || {
        needed(&ready.components)?;
        let mut clippy = workspace.cargo(["clippy", "--workspace", "--all-targets"]);
        run_step(clippy.args(["--", "-D", "warnings"]), "lint")
    });
    tally.check("lint of the wasm side", || {
        needed(&ready.components)?;
        needed(&ready.target)?;
        let mut clippy = workspace.cargo(["clippy", "--tests", "--target", WASM]);
        clippy.args(["--package", WASM_CRATE.0, "--", "-D", "warnings"]);
        run_step(&mut clippy, "lint of the wasm side")
    });
    tally.check("documentation", || {
        let mut doc = workspace.cargo(["doc", "--workspace", "--no-deps"]);
        run_step(doc.env("RUSTDOCFLAGS", "-D warnings"), "documentation")
    });
    tally.check("compilation of the tests", || {
        // Also the page tests, which run later, while both processors have work.
        let targets = ["--tests", "--test", "page", "--no-run"];
        let mut cargo = workspace.cargo(["test", "--workspace"]);
        run_step(cargo.args(targets), "compilation of the tests")
    });
    for (name, targets) in [("native tests", "--tests"), ("doc tests", "--doc")] {
        let mut cargo = workspace.cargo(["test", "--workspace", "--no-fail-fast"]);
        cargo.arg(targets);
        tally.tests(name, Ok(extended(cargo, extent)));
    }
}

/// The steps that need the built page, in Chromium or in Node.
fn with_page(
    workspace: &Workspace,
    ready: &SetUp,
    built: &Built,
    extent: Extent,
    tally: &mut Tally,
) {
    let page = &built.page;
    tally.check("types of the scripts", || {
        needed(&built.packages)?;
        // The build writes the types of the border.
        needed(page)?;
        for project in [".", "crates/xtask/build"] {
            let mut checker = tools::type_checker(workspace);
            run_step(checker.args(["--project", project]), "types of the scripts")?;
        }
        Ok(())
    });
    tally.tests(
        "tests of the scripts in Node",
        needed(page).and_then(|()| node_tests(workspace, extent)),
    );
    tally.tests(
        "page tests in Chromium",
        page_tests(workspace, &ready.browser, page, extent, &[]),
    );
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
    let browser = found(workspace, kind);
    let mut tally = Tally::default();
    let began = Instant::now();
    let page = site::set_up_and_build(workspace).and_then(|()| site::give_away(workspace));
    tally.step("page", &page, began.elapsed());
    let tests = page_tests(workspace, &browser, &page, extent, words);
    tally.tests("page tests", tests);
    ended(&tally)
}

fn ended(tally: &Tally) -> Result<ExitCode> {
    let passed = tally
        .summarise(std::io::stdout())
        .context("the summary cannot be written")?;
    Ok(if passed {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

impl SetUp {
    fn new(workspace: &Workspace) -> Self {
        Self {
            components: reported("rustfmt and clippy", tools::components(workspace)),
            target: reported("wasm target", tools::wasm_target(workspace)),
            browser: found(workspace, Kind::Chromium),
        }
    }
}

impl Built {
    fn new(workspace: &Workspace, ready: &SetUp) -> Self {
        let bindgen = reported("wasm-bindgen", tools::wasm_bindgen(workspace));
        let packages = reported("packages of npm", tools::packages(workspace));
        let began = Instant::now();
        let page = needed(&ready.target)
            .and(needed(&packages))
            .and(needed(&bindgen))
            .and_then(|bindgen| site::build(workspace, bindgen))
            .and_then(|()| site::give_away(workspace));
        let took = began.elapsed();
        Self {
            bindgen,
            pack: reported("wasm-pack", tools::wasm_pack(workspace)),
            packages,
            page,
            took,
        }
    }

    fn wasm_tests(&self, workspace: &Workspace, ready: &SetUp) -> Result<Command> {
        needed(&ready.target)?;
        let (bindgen, pack) = (needed(&self.bindgen)?, needed(&self.pack)?);
        wasm_tests(workspace, bindgen, pack, needed(&ready.browser)?)
    }
}

/// The tests of the wasm side by wasm-pack, which may fetch nothing: all it needs is set up here.
pub(crate) fn wasm_tests(
    workspace: &Workspace,
    bindgen: &Path,
    pack: &Path,
    browser: &Browser,
) -> Result<Command> {
    let mut pack = workspace.command(pack);
    pack.args(["test", "--headless", "--chrome", "--mode", "no-install"])
        .arg("--chromedriver")
        .arg(&browser.driver)
        .arg(WASM_CRATE.1)
        .env("PATH", tools::search_path(bindgen)?)
        .env("WASM_PACK_CACHE", workspace.target().join("wasm-pack"))
        .env(
            "WASM_BINDGEN_TEST_WEBDRIVER_JSON",
            capabilities(workspace, browser)?,
        )
        .env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIME);
    Ok(pack)
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

/// The page tests: of the page as `serve` ships it, the one file and the folder for a host. They find
/// all of these in the environment. All tests, or those whose names hold one of the words.
fn page_tests(
    workspace: &Workspace,
    browser: &Result<Browser>,
    page: &Result<()>,
    extent: Extent,
    words: &[String],
) -> Result<Command> {
    needed(page)?;
    let browser = needed(browser)?;
    let url = Server::start(workspace, 0, &workspace.site())?.keep();
    let folders = workspace.root().join("tests").join("data").join("page");
    let more = site::build_with(workspace, &folders)?;
    let with_more = Server::start(workspace, 0, &more)?.keep();
    let mut test = extended(page_test(workspace, "page", &url, browser), extent);
    test.env("ASSUR_MORE_URL", with_more);
    // A test waits for its browser now and then.
    test.arg(format!("--test-threads={}", processors() + 1));
    test.args(words);
    Ok(test)
}

/// A test target that opens the page served at an address.
pub(crate) fn page_test(
    workspace: &Workspace,
    name: &str,
    url: &str,
    browser: &Browser,
) -> Command {
    // All packages, so that nothing is compiled again with other features.
    let mut test = workspace.cargo(["test", "--workspace", "--test", name]);
    test.env("ASSUR_URL", url)
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

fn found(workspace: &Workspace, kind: Kind) -> Result<Browser> {
    reported(
        "browser and driver",
        browser::find_or_install(workspace, kind),
    )
}

/// Announces at once what cannot be had; the steps that need it repeat it.
fn reported<T>(what: &str, part: Result<T>) -> Result<T> {
    if let Err(error) = &part {
        announce(what, &format!("FAILED. {error:#}"));
    }
    part
}

fn needed<T>(part: &Result<T>) -> Result<&T> {
    part.as_ref()
        .map_err(|error: &Error| anyhow!("not run: {error:#}"))
}
