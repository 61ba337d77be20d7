//! Speed, as figures to read: nothing here can fail for being slow. Times of the
//! engine stand beside a yardstick of the same run, because machines differ and
//! are shared: a straightforward scalar closed form, natively, is one unit.

use std::fs;
use std::io::Write as _;
use std::process::Command;

use anyhow::{Context, Result};

use crate::browser;
use crate::step::{announce, output};
use crate::test::{browser_tests, page_test};
use crate::tools;
use crate::workspace::Workspace;
use crate::{bundle, server, site};

/// Prints the figures of the engine, natively and in the browser, of the page and
/// of its download.
pub(crate) fn run(workspace: &Workspace) -> Result<()> {
    tools::wasm_pack(workspace)?;
    let browser = browser::find_or_install(workspace)?;
    site::set_up_and_build(workspace)?;
    bundle::write(workspace)?;

    announce("engine, natively", "measuring");
    let mut native = workspace.cargo(["test", "--release", "--package", "assur-web"]);
    native.args(["--test", "speed", "--", "--nocapture"]);
    let native = figures(&mut native, "speed: ")?;
    announce("engine, in the browser", "measuring");
    let mut wasm = browser_tests(workspace, "crates/assur-web", &browser)?;
    wasm.args(["--release", "--test", "speed", "--", "--nocapture"]);
    let wasm = figures(&mut wasm, "speed: ")?;
    announce("page", "measuring");
    let (address, _workers) = server::start(server::listen(0)?, &workspace.site())?;
    let mut page = page_test(workspace, "page_speed", address, &browser);
    let page = figures(page.args(["--", "--nocapture"]), "page: ")?;

    let unit = native.first().map_or(f64::NAN, |(_, time)| *time);
    println!(
        "\n{:44} {:>12} {:>7} {:>12} {:>7}",
        "", "native, ns", "units", "browser, ns", "units"
    );
    for (name, time) in &native {
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
    println!(
        "{:60} {:>10.1}",
        "download of the page, brotli 11, kB",
        download(workspace)? / 1e3
    );
    Ok(())
}

/// The lines `PREFIX NAME = FIGURE` that a command prints.
fn figures(command: &mut Command, prefix: &str) -> Result<Vec<(String, f64)>> {
    let printed = output(command, "measuring")?;
    Ok(printed
        .lines()
        .filter_map(|line| figure(line, prefix))
        .collect())
}

/// The name and the figure of a line, wherever in it the prefix stands.
fn figure(line: &str, prefix: &str) -> Option<(String, f64)> {
    let (name, figure) = line.split_once(prefix)?.1.split_once(" = ")?;
    Some((name.to_owned(), figure.trim().parse().ok()?))
}

/// The bytes of every file that the page asks for at its start, one language.
fn download(workspace: &Workspace) -> Result<f64> {
    let site = workspace.site();
    let mut bytes = 0;
    for folder in [site.clone(), site.join("pkg")] {
        let unread = || format!("{} cannot be read", folder.display());
        for entry in fs::read_dir(&folder).with_context(unread)? {
            let path = entry.with_context(unread)?.path();
            if path.is_file() {
                bytes += compressed(&fs::read(&path).with_context(unread)?)?;
            }
        }
    }
    let words = site.join("lang").join("en.json");
    let words = fs::read(&words).with_context(|| format!("{} cannot be read", words.display()))?;
    Ok((bytes + compressed(&words)?) as f64)
}

fn compressed(bytes: &[u8]) -> Result<usize> {
    let mut packed = Vec::new();
    let mut writer = brotli::CompressorWriter::new(&mut packed, 4096, 11, 22);
    writer.write_all(bytes).context("compressing failed")?;
    drop(writer);
    Ok(packed.len())
}

#[cfg(test)]
mod tests {
    use super::{compressed, figure};

    #[test]
    fn figures_are_read_from_their_lines() {
        let line = "   | speed: engine, full state = 66.10";
        assert_eq!(
            figure(line, "speed: "),
            Some(("engine, full state".to_owned(), 66.1))
        );
        assert_eq!(figure("running 1 test", "speed: "), None);
        assert_eq!(figure("speed: engine = fast", "speed: "), None);
    }

    #[test]
    fn repetition_packs_well() {
        assert!(compressed(&[7; 100_000]).unwrap() < 100);
    }
}
