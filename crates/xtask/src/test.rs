//! Everything that must hold, run in one go: this is what a push is judged by.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

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

/// The crates that have tests for the browser: package and directory.
const WASM_CRATES: [(&str, &str); 2] =
    [("assur-tests", "tests"), ("assur-web", "crates/assur-web")];

/// What of the page differs most between browsers, by words in the names of its tests: keys, pointers, fingers,
/// what is one step of undo, files and links. All of its tests are run in Firefox by `cargo xtask test --browser firefox`.
const IN_FIREFOX: [&str; 7] = [
    "undo::",
    "keyboard::",
    "hands::",
    "touch::",
    "draw::",
    "share::",
    "import::",
];

/// What of the set-up is there, each or the reason why not.
struct SetUp {
    components: Result<()>,
    target: Result<()>,
    bindgen: Result<()>,
    pack: Result<()>,
    packages: Result<()>,
    browser: Result<Browser>,
    firefox: Result<Browser>,
}

/// Runs every step even if an earlier one failed, except those that would mean nothing then; they
/// count as failed.
pub(crate) fn run(workspace: &Workspace) -> Result<ExitCode> {
    let ready = SetUp::new(workspace);
    let mut tally = Tally::default();

    tally.check("format", || {
        needed(&ready.components)?;
        run_step(&mut workspace.cargo(["fmt", "--all", "--check"]), "format")
    });
    tally.check("lint", || {
        needed(&ready.components)?;
        let natively = [
            "clippy",
            "--workspace",
            "--all-targets",
            "--",
            "-D",
            "warnings",
        ];
        run_step(&mut workspace.cargo(natively), "lint")
    });
    tally.check("lint of the wasm side", || {
        needed(&ready.components)?;
        needed(&ready.target)?;
        let mut clippy = workspace.cargo(["clippy", "--tests", "--target", WASM]);
        clippy.args(
            WASM_CRATES
                .iter()
                .flat_map(|(package, _)| ["--package", package]),
        );
        run_step(
            clippy.args(["--", "-D", "warnings"]),
            "lint of the wasm side",
        )
    });
    tally.check("documentation", || {
        let mut doc = workspace.cargo(["doc", "--workspace", "--no-deps"]);
        run_step(doc.env("RUSTDOCFLAGS", "-D warnings"), "documentation")
    });
    tally.tests(
        "native tests",
        Ok(workspace.cargo(["test", "--workspace", "--tests", "--no-fail-fast"])),
    );
    tally.tests(
        "doc tests",
        Ok(workspace.cargo(["test", "--workspace", "--doc", "--no-fail-fast"])),
    );
    for (package, directory) in WASM_CRATES {
        tally.tests(
            &format!("wasm tests of {package} in the browser"),
            ready.wasm_tests(workspace, directory),
        );
    }

    let mut site = Err(anyhow!("the page was not built"));
    tally.check("page", || {
        needed(&ready.target)?;
        needed(&ready.bindgen)?;
        needed(&ready.packages)?;
        site::build(workspace)?;
        site = Ok(());
        Ok(())
    });
    tally.check("types of the scripts", || {
        needed(&ready.packages)?;
        // What crosses the border has its types of the build.
        needed(&site)?;
        let mut checker = tools::type_checker(workspace);
        run_step(checker.args(["--project", "."]), "types of the scripts")?;
        let mut checker = tools::type_checker(workspace);
        checker.args(["--project", "crates/xtask/build"]);
        run_step(&mut checker, "types of the scripts of the build")
    });
    let mut bundled = Err(anyhow!("the one-file page was not written"));
    tally.check("one-file page, folder for a host, package", || {
        needed(&site)?;
        bundled = Ok(site::give_away(workspace)?);
        Ok(())
    });
    tally.tests_in_company(
        "page tests in the browser",
        page_tests(workspace, &ready.browser, &site, &bundled, &[]),
    );
    tally.tests_in_company(
        "page tests in Firefox",
        page_tests(
            workspace,
            &ready.firefox,
            &site,
            &bundled,
            &IN_FIREFOX.map(str::to_owned),
        ),
    );

    ended(&tally)
}

/// Runs the tests of the page alone, in one browser: all, or those whose names hold one of the words.
pub(crate) fn run_page(workspace: &Workspace, kind: Kind, words: &[String]) -> Result<ExitCode> {
    let browser = told(
        "browser and driver",
        browser::find_or_install(workspace, kind),
    );
    let mut tally = Tally::default();
    let mut site = Err(anyhow!("the page was not built"));
    tally.check("page", || {
        site::set_up_and_build(workspace)?;
        site = Ok(site::give_away(workspace)?);
        Ok(())
    });
    tally.tests_in_company(
        "page tests in the browser",
        page_tests(workspace, &browser, &site, &site, words),
    );
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
            components: told("rustfmt and clippy", tools::components(workspace)),
            target: told("wasm target", tools::wasm_target(workspace)),
            bindgen: told("wasm-bindgen", tools::wasm_bindgen(workspace)),
            pack: told("wasm-pack", tools::wasm_pack(workspace)),
            packages: told("packages of npm", tools::packages(workspace)),
            browser: told(
                "browser and driver",
                browser::find_or_install(workspace, Kind::Chromium),
            ),
            firefox: told(
                "Firefox and its driver",
                browser::find_or_install(workspace, Kind::Firefox),
            ),
        }
    }

    fn wasm_tests(&self, workspace: &Workspace, directory: &str) -> Result<Command> {
        for part in [&self.target, &self.bindgen, &self.pack] {
            needed(part)?;
        }
        browser_tests(workspace, directory, needed(&self.browser)?)
    }
}

/// Tests of one crate by wasm-pack, which may fetch nothing: all it needs is set up here.
pub(crate) fn browser_tests(
    workspace: &Workspace,
    directory: &str,
    browser: &Browser,
) -> Result<Command> {
    let mut pack = workspace.command(&tools::path(workspace, "wasm-pack"));
    pack.args([
        "test",
        "--headless",
        "--chrome",
        "--mode",
        "no-install",
        "--chromedriver",
    ])
    .arg(&browser.driver)
    .arg(directory)
    .env("PATH", tools::search_path(workspace)?)
    .env("WASM_PACK_CACHE", workspace.target().join("wasm-pack"))
    .env(
        "WASM_BINDGEN_TEST_WEBDRIVER_JSON",
        capabilities(workspace, directory, browser)?,
    )
    .env("WASM_BINDGEN_TEST_TIMEOUT", WASM_TIME);
    Ok(pack)
}

/// The crate's webdriver.json completed with the browser that was found: the driver by itself might
/// choose another, or none.
fn capabilities(workspace: &Workspace, directory: &str, browser: &Browser) -> Result<PathBuf> {
    let source = workspace.root().join(directory).join("webdriver.json");
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

/// Tests of the page as `serve` ships it and as the one file, driven through the browser. They find
/// what they need in the environment. All of them, or those whose names hold one of the words; what is added to the
/// command goes to the tests themselves.
fn page_tests(
    workspace: &Workspace,
    browser: &Result<Browser>,
    site: &Result<()>,
    bundled: &Result<()>,
    words: &[String],
) -> Result<Command> {
    needed(site)?;
    needed(bundled)?;
    let browser = needed(browser)?;
    let url = Server::start(workspace, 0, &workspace.site())?.keep();
    let folders = workspace.root().join("tests").join("data").join("page");
    let more = site::build_with(workspace, &folders)?;
    let with_more = Server::start(workspace, 0, &more)?.keep();
    let mut test = page_test(workspace, "page", &url, browser);
    test.env("ASSUR_MORE_URL", with_more);
    test.arg("--").args(words);
    Ok(test)
}

/// A test target that opens the page served at an address.
pub(crate) fn page_test(
    workspace: &Workspace,
    name: &str,
    url: &str,
    browser: &Browser,
) -> Command {
    let mut test = workspace.cargo(["test", "--package", "assur-tests", "--test", name]);
    test.env("ASSUR_URL", url)
        .env("ASSUR_BUNDLE", workspace.bundle())
        .envs(browser.variables());
    test
}

/// Says at once what cannot be had; the steps that need it repeat it.
fn told<T>(what: &str, part: Result<T>) -> Result<T> {
    if let Err(error) = &part {
        announce(what, &format!("FAILED. {error:#}"));
    }
    part
}

fn needed<T>(part: &Result<T>) -> Result<&T> {
    part.as_ref()
        .map_err(|error: &Error| anyhow!("not run: {error:#}"))
}
