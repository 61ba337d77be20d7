//! Speed, as figures to read: nothing here can fail for being slow. Times of the
//! engine stand beside a yardstick of the same run, because machines differ and
//! are shared: a straightforward scalar closed form, natively, is one unit.

use std::fs;
use std::io::Write as _;

use anyhow::{Context, Result};

use crate::browser::{Browser, Kind};
use crate::site;
use crate::step::{announce, output};
use crate::test::{page_test, wasm_tests};
use crate::workspace::Workspace;

/// Prints the figures of the engine, natively and in the browser, of the page and
/// of its download; the page is played and dragged for some minutes.
pub(crate) fn run(workspace: &Workspace, minutes: f64) -> Result<()> {
    let browser = Browser::find_or_install(workspace, Kind::Chromium)?;
    site::set_up_and_build(workspace)?;
    site::give_away(workspace)?;

    announce("engine, natively", "measuring");
    let mut native = workspace.cargo(["test", "--release", "--package", "assur-web"]);
    native.args(["--test", "speed", "--", "--nocapture"]);
    let native = figures(&output(&mut native, "measuring")?, "speed: ");
    announce("engine, in the browser", "measuring");
    let mut wasm = wasm_tests(workspace, &browser)?;
    wasm.args(["--release", "--test", "speed", "--", "--nocapture"]);
    let wasm = figures(&output(&mut wasm, "measuring")?, "speed: ");
    announce("page", "measuring");
    let mut page = page_test(workspace, "page_speed", &browser);
    page.args(["--", "--nocapture"])
        .env("ASSUR_MINUTES", minutes.to_string());
    let page = output(&mut page, "measuring")?;

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
    for (name, figure) in figures(&page, "page: ") {
        println!("{name:60} {figure:>10}");
    }
    let (requests, bytes) = download(workspace, &page)?;
    println!(
        "{:60} {:>10.1}",
        format!("download, {requests} requests, brotli 11, kB"),
        bytes as f64 / 1e3
    );
    Ok(())
}

/// The lines `PREFIX NAME = FIGURE` of what a command printed.
fn figures(printed: &str, prefix: &str) -> Vec<(String, f64)> {
    let lines = printed.lines();
    lines.filter_map(|line| figure(line, prefix)).collect()
}

/// The name and the figure of a line, wherever in it the prefix stands.
fn figure(line: &str, prefix: &str) -> Option<(String, f64)> {
    let (name, figure) = line.split_once(prefix)?.1.split_once(" = ")?;
    Some((name.to_owned(), figure.trim().parse().ok()?))
}

/// How many files the page asked for at its start, and their compressed bytes.
fn download(workspace: &Workspace, printed: &str) -> Result<(usize, usize)> {
    let site = workspace.site();
    let files: Vec<&str> = printed.lines().filter_map(asked).collect();
    let mut bytes = 0;
    for file in &files {
        let path = site.join(file);
        let content = fs::read(&path);
        bytes += compressed(&content.with_context(|| format!("{} is not there", path.display()))?)?
            .len();
    }
    Ok((files.len(), bytes))
}

/// The file of the site that is meant by a line `asked: ADDRESS`.
fn asked(line: &str) -> Option<&str> {
    let (_, address) = line.split_once("asked: http://")?;
    let (_, path) = address.split_once('/')?;
    let path = path.split(['#', '?']).next()?;
    Some(if path.is_empty() { "index.html" } else { path })
}

/// As small as brotli makes it.
fn compressed(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut packed = Vec::new();
    let mut writer = brotli::CompressorWriter::new(&mut packed, 4096, 11, 22);
    writer.write_all(bytes).context("compressing failed")?;
    drop(writer);
    Ok(packed)
}

#[cfg(test)]
mod tests {
    use super::{asked, compressed, figure};

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
    fn files_are_read_from_their_addresses() {
        for (line, file) in [
            ("asked: http://127.0.0.1:80/#1&lesson=mixer", "index.html"),
            ("asked: http://127.0.0.1:80/pkg/a.wasm", "pkg/a.wasm"),
        ] {
            assert_eq!(asked(line), Some(file));
        }
        assert_eq!(asked("asked: data:image/svg+xml,a/b"), None);
    }

    #[test]
    fn repetition_packs_well() {
        assert!(compressed(&[7; 100_000]).unwrap().len() < 100);
    }
}
