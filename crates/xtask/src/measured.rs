//! The figures of a benchmark as data: a small file for each run, and the ratios of two runs.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, thread};

use anyhow::{Context as _, Result};
use serde::{Deserialize, Serialize};
use xshell::cmd;

use crate::workspace::{VERSION, Workspace};

/// Measured values with their names, in the order in which they are printed.
type Figures = Vec<(String, f64)>;

/// The values measured in one run of the benchmark.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Measured {
    pub(crate) machine: Machine,
    /// Times of the engine compiled natively, nanoseconds. The first is the yardstick for all engine times.
    pub(crate) native: Figures,
    /// Times of the engine in the browser, nanoseconds.
    pub(crate) browser: Figures,
    pub(crate) page: Figures,
}

/// The machine of a run, and the version and commit that were measured on it.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Machine {
    system: String,
    architecture: String,
    processor: Option<String>,
    processors: usize,
    version: String,
    commit: Option<String>,
}

impl Machine {
    /// This machine with the commit that is checked out.
    pub(crate) fn this(workspace: &Workspace) -> Self {
        let commit = cmd!(workspace.shell, "git rev-parse --short HEAD");
        Self {
            system: env::consts::OS.to_owned(),
            architecture: env::consts::ARCH.to_owned(),
            processor: fs::read_to_string("/proc/cpuinfo").ok().and_then(model),
            processors: thread::available_parallelism().map_or(1, usize::from),
            version: VERSION.to_owned(),
            commit: commit.quiet().ignore_stderr().read().ok(),
        }
    }

    fn is_like(&self, other: &Self) -> bool {
        let parts = |machine: &Self| (machine.processor.clone(), machine.processors);
        parts(self) == parts(other)
    }
}

/// The name of the processor in the description that Linux gives.
fn model(described: String) -> Option<String> {
    let mut lines = described.lines();
    let line = lines.find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

impl Measured {
    /// The time of the yardstick, nanoseconds.
    pub(crate) fn unit(&self) -> f64 {
        self.native.first().map_or(f64::NAN, |(_, time)| *time)
    }

    pub(crate) fn write(&self, file: &Path) -> Result<()> {
        let text = serde_json::to_string_pretty(self)?;
        fs::write(file, text).with_context(|| format!("{} cannot be written", file.display()))
    }

    fn read(file: &Path) -> Result<Self> {
        let text = fs::read_to_string(file);
        let text = text.with_context(|| format!("{} cannot be read", file.display()))?;
        let read = serde_json::from_str(&text);
        read.with_context(|| format!("{} holds no figures of `bench`", file.display()))
    }
}

/// Prints the ratios of the figures of two files.
pub(crate) fn compare(files: &[PathBuf]) -> Result<()> {
    let read: Result<Vec<Measured>> = files.iter().map(|file| Measured::read(file)).collect();
    if let [before, after] = &read?[..] {
        print!("{}", compared(before, after));
    }
    Ok(())
}

/// A table of the figures in both runs: before, after, ratio. Engine times are in units of the yardstick of their run.
fn compared(before: &Measured, after: &Measured) -> String {
    let mut text = String::new();
    if !before.machine.is_like(&after.machine) {
        text += "The machines differ: only figures in units compare.\n";
    }
    let units = [before.unit(), after.unit()];
    for (part, [one, other], units) in [
        ("native, units", [&before.native, &after.native], units),
        ("browser, units", [&before.browser, &after.browser], units),
        ("page", [&before.page, &after.page], [1.0; 2]),
    ] {
        let _ = writeln!(
            text,
            "\n{part:60} {:>10} {:>10} {:>7}",
            "before", "after", "ratio"
        );
        for (name, figure) in one {
            let Some((_, now)) = other.iter().find(|(found, _)| found == name) else {
                continue;
            };
            let [was, is] = [figure / units[0], now / units[1]];
            let _ = writeln!(text, "{name:60} {was:>10.2} {is:>10.2} {:>7.3}", is / was);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(processors: usize, yardstick: f64, engine: f64, frame: f64) -> Measured {
        let figures = |named: &[(&str, f64)]| {
            let figures = named
                .iter()
                .map(|(name, value)| ((*name).to_owned(), *value));
            figures.collect::<Figures>()
        };
        Measured {
            machine: Machine {
                system: "linux".to_owned(),
                architecture: "x86_64".to_owned(),
                processor: None,
                processors,
                version: VERSION.to_owned(),
                commit: None,
            },
            native: figures(&[("yardstick", yardstick), ("engine", engine), ("new", 1.0)]),
            browser: Vec::new(),
            page: figures(&[("frame", frame)]),
        }
    }

    #[test]
    fn times_of_the_engine_compare_in_units() {
        let mut before = measured(2, 10.0, 20.0, 4.0);
        before.native.pop();
        let text = compared(&before, &measured(2, 20.0, 60.0, 3.0));
        let row = |name: &str| -> Vec<f64> {
            let line = text.lines().find(|line| line.starts_with(name)).unwrap();
            let numbers = line[name.len()..].split_whitespace().map(str::parse);
            numbers.collect::<Result<_, _>>().unwrap()
        };
        assert_eq!(row("yardstick"), [1.0, 1.0, 1.0]);
        assert_eq!(row("engine"), [2.0, 3.0, 1.5]);
        assert_eq!(row("frame"), [4.0, 3.0, 0.75]);
        assert!(!text.contains("new") && !text.contains("differ"), "{text}");
        let other = compared(&before, &measured(4, 20.0, 60.0, 3.0));
        assert!(other.contains("The machines differ"), "{other}");
    }

    #[test]
    fn figures_come_back_from_their_file() {
        let file = env::temp_dir().join(format!("assur-bench-{}.json", std::process::id()));
        let written = measured(2, 62.5, 12.25, 3.6);
        written.write(&file).unwrap();
        let read = Measured::read(&file);
        fs::remove_file(&file).unwrap();
        assert_eq!(read.unwrap(), written);
        let missing = Measured::read(&file).unwrap_err();
        assert!(missing.to_string().ends_with("cannot be read"), "{missing}");
    }

    #[test]
    fn the_processor_has_its_name() {
        let described = "processor\t: 0\nmodel name\t: A Processor @ 2 GHz\n";
        let name = Some("A Processor @ 2 GHz".to_owned());
        assert_eq!(model(described.to_owned()), name);
        assert_eq!(model(String::new()), None);
    }
}
