//! Benchmarks. Results are printed and never make a run fail. Because machines differ and are shared, times of the
//! engine are relative to a yardstick timed natively in each run: a scalar closed form of the four-bar.

use std::path::Path;

use anyhow::Result;
use xshell::cmd;

use crate::browser::{Browser, Kind};
use crate::measured::{Machine, Measured};
use crate::site;
use crate::step::announce;
use crate::test::{page_test, wasm_tests};
use crate::workspace::Workspace;

/// Measures the engine, natively and in the browser, and the page with its download; prints the figures and writes them
/// to a file. The page is played and dragged for the given minutes.
pub(crate) fn run(workspace: &Workspace, minutes: f64, save: Option<&Path>) -> Result<()> {
    let browser = Browser::find_or_install(workspace, Kind::Chromium)?;
    site::set_up_and_build(workspace)?;
    site::give_away(workspace)?;

    let shell = &workspace.shell;
    announce("engine, natively", "measuring");
    let native = cmd!(
        shell,
        "cargo test --release --package assur-web --test speed -- --nocapture"
    );
    let native = figures(&native.read()?, "speed: ");
    announce("engine, in the browser", "measuring");
    let wasm = wasm_tests(workspace, &browser)?.args(["--release", "--test", "speed"]);
    let wasm = figures(&wasm.args(["--", "--nocapture"]).read()?, "speed: ");
    announce("page", "measuring");
    let page = page_test(workspace, "page_speed", &browser).args(["--", "--nocapture"]);
    let page = page.env("ASSUR_MINUTES", minutes.to_string()).read()?;

    let measured = Measured {
        machine: Machine::this(workspace),
        native,
        browser: wasm,
        page: figures(&page, "page: "),
    };
    print(&measured);
    let usual = workspace.target.join("bench.json");
    let file = save.unwrap_or(&usual);
    measured.write(file)?;
    println!("\nThe figures are in {}", file.display());
    Ok(())
}

fn print(measured: &Measured) {
    let Measured {
        native,
        browser: wasm,
        page,
        ..
    } = measured;
    let unit = measured.unit();
    println!(
        "\n{:44} {:>12} {:>7} {:>12} {:>7}",
        "", "native, ns", "units", "browser, ns", "units"
    );
    for (name, time) in native {
        let there = wasm.iter().find(|(other, _)| other == name);
        let there = there.map_or(f64::NAN, |(_, time)| *time);
        println!(
            "{name:44} {time:>12.1} {:>7.2} {there:>12.1} {:>7.2}",
            time / unit,
            there / unit
        );
    }
    println!();
    for (name, figure) in page {
        println!("{name:60} {figure:>10}");
    }
}

/// Reads the lines `PREFIX NAME = FIGURE` from the output of a command; the prefix may be anywhere in a line.
fn figures(printed: &str, prefix: &str) -> Vec<(String, f64)> {
    let figure = |line: &str| {
        let (name, figure) = line.split_once(prefix)?.1.split_once(" = ")?;
        Some((name.to_owned(), figure.trim().parse().ok()?))
    };
    printed.lines().filter_map(figure).collect()
}

#[cfg(test)]
mod tests {
    use super::figures;

    #[test]
    fn figures_are_read_from_their_lines() {
        let printed = "running 1 test
               | speed: engine, full state = 66.10
            speed: engine = fast";
        let expected = [("engine, full state".to_owned(), 66.1)];
        assert_eq!(figures(printed, "speed: "), expected);
    }
}
