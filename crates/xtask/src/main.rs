//! `cargo xtask`: development tasks, such as fetching the tools, building and serving the page, running all tests and
//! writing the one-file page.
//!
//! A command first installs the tools that it needs but does not find, and announces each step on one line. Tools go
//! into a folder of their own inside cargo's folder, by name and version, so that no other tools are overwritten.

mod bench;
mod browser;
mod measured;
mod packages;
mod parts;
mod site;
mod step;
mod tally;
mod test;
mod tools;
mod workspace;

use std::io::{BufRead as _, BufReader};
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

use anyhow::{Context as _, Result, bail};
use clap::{Parser, Subcommand};
use xshell::cmd;

use crate::browser::Kind;
use crate::workspace::Workspace;

/// Sets up, builds, serves and tests Assur.
#[derive(Parser)]
#[command(
    name = "xtask",
    bin_name = "cargo xtask",
    version,
    arg_required_else_help = true
)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Builds the page and serves it on this machine
    ///
    /// Installs the wasm32 target, wasm-bindgen and the packages of npm if they are missing, builds the release, serves
    /// it on 127.0.0.1 without caching, prints the address and opens it if there is a display. Stops with Ctrl-C.
    Serve {
        /// Port to begin with; the next free one is used if it is taken
        #[arg(long, default_value_t = 8080)]
        port: u16,
        /// Only print the address, open no browser
        #[arg(long)]
        no_open: bool,
    },
    /// Runs all checks that a change must pass: format, lint, documentation, and the tests of engine, scripts and page
    ///
    /// Installs what is missing: rustfmt, clippy, the wasm32 target, wasm-bindgen, wasm-pack, the packages of npm and
    /// (on Debian, as root) Chromium with its driver. The environment variables CHROME, CHROMEDRIVER, FIREFOX and
    /// GECKODRIVER select other browsers and drivers. The last line says how many checks passed and failed; the exit
    /// code is 1 if any failed.
    ///
    /// With WORDS or a browser, only page tests are run.
    Test {
        /// Also runs long tests, uses ten times as much random input, and tests the page in Firefox, whose driver cargo
        /// builds
        #[arg(long)]
        all: bool,
        /// Only page tests, in this browser
        #[arg(long)]
        browser: Option<Kind>,
        /// Only page tests whose names contain one of these words, in Chromium unless a browser is named
        words: Vec<String>,
    },
    /// Runs the tests with random input that take more than five minutes: 200,000 drawings, 100,000 damaged files, and
    /// about a minute for each reader of outside data
    Soak {
        /// Seed of the random input, for a run that differs from the last
        #[arg(long, default_value_t = 777)]
        seed: u64,
    },
    /// Makes the start data for four-bars through nine points anew, www/data/nine-points.bin, by monodromy: from one
    /// four-bar to all 1,442 curves
    NinePoints,
    /// Compares the search for a four-bar that traces a path with differential evolution in the same time: thirty curves,
    /// five seeds, half an hour on two processors
    Paths {
        /// Names of curves [default: all; a wrong name lists them]
        curves: Vec<String>,
    },
    /// Prints the speed of engine and page, relative to a yardstick measured in the same run
    ///
    /// Installs what is missing as `test` does. A slow result is not a failure.
    Bench {
        /// Minutes for which the page is played and dragged while its memory is watched
        #[arg(long, default_value_t = 0.5)]
        minutes: f64,
        /// File to which the figures are written, as JSON [default: bench.json in the target directory]
        #[arg(long, value_name = "FILE")]
        save: Option<PathBuf>,
        /// Measures nothing: prints the ratios of the figures of two files
        #[arg(long, num_args = 2, value_names = ["BEFORE", "AFTER"], conflicts_with_all = ["minutes", "save"])]
        compare: Option<Vec<PathBuf>>,
    },
    /// Builds the page as one file, dist/assur.html, that opens by double-click, and as the folder dist/site for a web
    /// host; builds the engine into dist/npm
    Bundle,
    /// Builds the page into the folder `site` of the target directory
    Build {
        /// A folder with further `lessons` and `kinds`: the page is built once more with these, into `site.more`
        #[arg(long, value_name = "FOLDER")]
        with: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    perform(&Arguments::parse().task).unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}

fn perform(task: &Task) -> Result<ExitCode> {
    let workspace = Workspace::locate()?;
    match task {
        Task::Serve { port, no_open } => serve(&workspace, *port, !no_open)?,
        Task::Test {
            all,
            browser,
            words,
        } => return test::run(&workspace, *all, *browser, words),
        Task::Soak { seed } => return test::soak(&workspace, *seed),
        Task::Bench {
            compare: Some(files),
            ..
        } => measured::compare(files)?,
        Task::Bench { minutes, save, .. } => bench::run(&workspace, *minutes, save.as_deref())?,
        Task::NinePoints => {
            example(
                &workspace,
                "assur",
                "nine_points",
                &[NINE_POINTS.to_owned()],
            )?;
        }
        Task::Paths { curves } => example(&workspace, "assur-file", "evolution", curves)?,
        Task::Bundle => {
            site::set_up_and_build(&workspace)?;
            site::give_away(&workspace)?;
        }
        Task::Build { with } => {
            site::set_up_and_build(&workspace)?;
            if let Some(more) = with {
                site::build_with(&workspace, more)?;
            }
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Serves the page with `build/serve.js` until that process ends. The first line of its output is the address.
fn serve(workspace: &Workspace, port: u16, open: bool) -> Result<()> {
    site::set_up_and_build(workspace)?;
    let (site, port) = (workspace.site(), port.to_string());
    let node = cmd!(
        workspace.shell,
        "node crates/xtask/build/serve.js {site} --port {port}"
    );
    let mut node = Command::from(node);
    node.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut server = node.spawn().context("the server cannot be started")?;
    // The server ends when its input is closed. `wait` would close the input, so the input is taken out first.
    let input = server.stdin.take();
    let mut url = String::new();
    let said = server.stdout.take().context("the server has no output")?;
    BufReader::new(said).read_line(&mut url)?;
    let url = url.trim_end();
    if !url.is_empty() {
        println!("The page is at {url} (Ctrl-C stops it)");
        // The address is already on the screen, so a browser that fails to open is no error.
        if open
            && browser::display_present()
            && let Err(error) = open::that_detached(url)
        {
            eprintln!("No browser could be opened ({error}); open the address by hand.");
        }
    }
    let status = server.wait()?;
    drop(input);
    bail!("the server ended with {status}")
}

/// File of the start data for four-bars through nine points.
const NINE_POINTS: &str = "www/data/nine-points.bin";

/// Runs an example of a crate, built for speed.
fn example(workspace: &Workspace, package: &str, name: &str, given: &[String]) -> Result<()> {
    let example = ["--package", package, "--example", name];
    let run = cmd!(
        workspace.shell,
        "cargo run --release {example...} -- {given...}"
    );
    Ok(run.run()?)
}
