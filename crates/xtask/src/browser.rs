//! The browsers in which tests run, and the drivers that control them.

use std::env;
use std::ffi::OsStr;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use clap::ValueEnum;
use xshell::cmd;

use crate::step::{announce, run};
use crate::tools;
use crate::workspace::Workspace;

/// A kind of browser in which the tests of the page can run.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Chrome or Chromium
    Chromium,
    /// Firefox, including the extended support release
    Firefox,
}

pub(crate) struct Browser {
    facts: &'static Facts,
    pub(crate) program: PathBuf,
    pub(crate) driver: PathBuf,
}

struct Facts {
    name: &'static str,
    program: Program,
    driver: Program,
    /// Debian packages of the browser, its driver and a font; without a font a browser would draw no text.
    packages: &'static str,
}

/// A program: the environment variable that may hold its path, and the names or full paths that are tried.
struct Program {
    variable: &'static str,
    names: &'static [&'static str],
}

const CHROMIUM: Facts = Facts {
    name: "chromium",
    program: Program {
        variable: "CHROME",
        // The headless shell has the same engine without a window, and starts sooner. Its full path comes first: when
        // the driver ends Debian's script of the same name, the script does not end the browser.
        names: &[
            "/usr/lib/chromium/chromium-headless-shell",
            "chromium-headless-shell",
            "chromium",
            "chromium-browser",
            "google-chrome",
            "chrome",
            "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
            "/Applications/Chromium.app/Contents/MacOS/Chromium",
            r"C:\Program Files\Google\Chrome\Application\chrome.exe",
        ],
    },
    driver: Program {
        variable: "CHROMEDRIVER",
        names: &[
            "chromedriver",
            "chromium.chromedriver",
            "/usr/lib/chromium-browser/chromedriver",
        ],
    },
    packages: "chromium-headless-shell chromium-driver fonts-dejavu-core",
};

const FIREFOX: Facts = Facts {
    name: "firefox",
    program: Program {
        variable: "FIREFOX",
        names: &[
            "firefox-esr",
            "firefox",
            "/Applications/Firefox.app/Contents/MacOS/firefox",
            r"C:\Program Files\Mozilla Firefox\firefox.exe",
        ],
    },
    // No Debian package contains geckodriver, so cargo builds it.
    driver: Program {
        variable: "GECKODRIVER",
        names: &["geckodriver"],
    },
    packages: "firefox-esr fonts-dejavu-core",
};

impl Browser {
    /// Finds a browser and its driver, or installs what is missing if system packages can be installed.
    pub(crate) fn find_or_install(workspace: &Workspace, kind: Kind) -> Result<Self> {
        let facts = match kind {
            Kind::Chromium => &CHROMIUM,
            Kind::Firefox => &FIREFOX,
        };
        let find = || -> Result<Option<Self>> {
            let Some(program) = facts.program.find()? else {
                return Ok(None);
            };
            let driver = match (facts.driver.find()?, kind) {
                (None, Kind::Firefox) => Some(tools::geckodriver(workspace)?),
                (found, _) => found,
            };
            Ok(driver.map(|driver| Self {
                facts,
                program,
                driver,
            }))
        };
        if let Some(found) = find()? {
            announce(facts.name, "already there");
            return Ok(found);
        }
        facts.install(workspace)?;
        find()?.with_context(|| format!("{} is not where apt-get should put it", facts.name))
    }

    /// The environment variables by which page tests find this browser and its driver.
    pub(crate) fn variables(&self) -> [(&'static str, &OsStr); 3] {
        [
            ("ASSUR_BROWSER", self.facts.name.as_ref()),
            (self.facts.program.variable, self.program.as_ref()),
            (self.facts.driver.variable, self.driver.as_ref()),
        ]
    }
}

impl Facts {
    fn install(&self, workspace: &Workspace) -> Result<()> {
        let Self { name, packages, .. } = self;
        let shell = &workspace.shell;
        let root = cmd!(shell, "id -u").ignore_stderr().read();
        ensure!(
            which::which("apt-get").is_ok() && root.is_ok_and(|user| user == "0"),
            "{name} and its driver are missing: install them, on Debian by `apt-get install {packages}` as root, \
             or name what is there by the environment variables of `cargo xtask test --help`"
        );
        announce(name, "installing by apt-get");
        shell.set_var("DEBIAN_FRONTEND", "noninteractive");
        run(cmd!(shell, "apt-get update"), name)?;
        let install = cmd!(shell, "apt-get install -y --no-install-recommends");
        run(install.args(packages.split(' ')), name)
    }
}

impl Program {
    /// Finds the program. A variable that names no program is an error: a test in another browser would mislead.
    fn find(&self) -> Result<Option<PathBuf>> {
        let Self { variable, names } = self;
        if let Some(named) = env::var_os(variable).filter(|value| !value.is_empty()) {
            let program = which::which(&named);
            let unknown = || format!("{variable} names {named:?}, which is no program");
            return program.with_context(unknown).map(Some);
        }
        Ok(names.iter().find_map(|name| which::which(name).ok()))
    }
}

/// True if a browser window could appear: not under CI, and on Linux only with a display server.
pub(crate) fn display_present() -> bool {
    let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("CI") && (!cfg!(target_os = "linux") || set("DISPLAY") || set("WAYLAND_DISPLAY"))
}
