//! The browsers that tests run in, and the drivers that steer them.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use clap::ValueEnum;

use crate::step::{announce, quiet_output, run};
use crate::tools;
use crate::workspace::Workspace;

/// A browser that the tests of the page can be run in.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kind {
    /// Chrome or Chromium
    Chromium,
    /// Firefox, also of extended support
    Firefox,
}

/// A browser and its driver.
pub(crate) struct Browser {
    kind: Kind,
    pub(crate) program: PathBuf,
    pub(crate) driver: PathBuf,
}

/// One of the programs: the variable that names it, its names, and places that are not on PATH.
struct Program {
    variable: &'static str,
    names: &'static [&'static str],
    places: &'static [&'static str],
}

const CHROME: Program = Program {
    variable: "CHROME",
    // The shell has the same engine without the parts of a window, and starts sooner. Debian's script of that name does
    // not pass on the signal by which its driver ends it: the browser would be left over.
    names: &[
        "/usr/lib/chromium/chromium-headless-shell",
        "chromium-headless-shell",
        "chromium",
        "chromium-browser",
        "google-chrome",
        "chrome",
    ],
    places: &[
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
        r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    ],
};

const CHROMEDRIVER: Program = Program {
    variable: "CHROMEDRIVER",
    names: &["chromedriver", "chromium.chromedriver"],
    places: &["/usr/lib/chromium-browser/chromedriver"],
};

const FIREFOX: Program = Program {
    variable: "FIREFOX",
    names: &["firefox-esr", "firefox"],
    places: &[
        "/Applications/Firefox.app/Contents/MacOS/firefox",
        r"C:\Program Files\Mozilla Firefox\firefox.exe",
    ],
};

const GECKODRIVER: Program = Program {
    variable: "GECKODRIVER",
    names: &["geckodriver"],
    places: &[],
};

impl Kind {
    /// Its name, the browser, its driver, and the packages of Debian that have them.
    fn parts(self) -> (&'static str, Program, Program, &'static [&'static str]) {
        // Without a font the browser would draw no text. No package has the driver of Firefox.
        match self {
            Self::Chromium => (
                "chromium",
                CHROME,
                CHROMEDRIVER,
                &[
                    "chromium-headless-shell",
                    "chromium-driver",
                    "fonts-dejavu-core",
                ],
            ),
            Self::Firefox => (
                "firefox",
                FIREFOX,
                GECKODRIVER,
                &["firefox-esr", "fonts-dejavu-core"],
            ),
        }
    }
}

impl Browser {
    /// Finds a browser and its driver or, where the system's packages can be installed, installs what is missing.
    pub(crate) fn find_or_install(workspace: &Workspace, kind: Kind) -> Result<Self> {
        let (name, program, driver, packages) = kind.parts();
        let find = || -> Result<Option<Self>> {
            let Some(program) = program.find()? else {
                return Ok(None);
            };
            let mut driver = driver.find()?;
            if driver.is_none() && kind == Kind::Firefox {
                driver = Some(tools::geckodriver(workspace)?);
            }
            Ok(driver.map(|driver| Self {
                kind,
                program,
                driver,
            }))
        };
        if let Some(found) = find()? {
            announce(name, "already there");
            return Ok(found);
        }
        install(workspace, name, packages)?;
        find()?.with_context(|| {
            format!("apt-get installed {name}, which cannot be found in the usual places")
        })
    }

    /// The variables by which the tests of the page find it.
    pub(crate) fn variables(&self) -> [(&'static str, &OsStr); 3] {
        let (name, program, driver, _) = self.kind.parts();
        [
            ("ASSUR_BROWSER", name.as_ref()),
            (program.variable, self.program.as_ref()),
            (driver.variable, self.driver.as_ref()),
        ]
    }
}

fn install(workspace: &Workspace, name: &str, packages: &[&str]) -> Result<()> {
    let variables =
        "or name what is there by the environment variables of `cargo xtask test --help`";
    if !Path::new("/etc/debian_version").exists() || which::which("apt-get").is_err() {
        bail!("{name} and its driver must be installed: do so, {variables}");
    }
    if quiet_output(Command::new("id").arg("-u")).is_none_or(|user| user.trim() != "0") {
        let packages = packages.join(" ");
        bail!("{name}: run `apt-get install {packages}` as root, {variables}");
    }
    announce(name, "installing by apt-get");
    let install = ["install", "-y", "--no-install-recommends"];
    for arguments in [&["update"][..], &[&install[..], packages].concat()] {
        let mut apt = workspace.command("apt-get");
        apt.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        run(&mut apt, name)?;
    }
    Ok(())
}

impl Program {
    /// The variable wins, then PATH, then the other places. A variable that points nowhere is an
    /// error: silently testing another browser would mislead.
    fn find(&self) -> Result<Option<PathBuf>> {
        if let Some(named) = env::var_os(self.variable).filter(|value| !value.is_empty()) {
            let program = which::which(&named).with_context(|| {
                format!(
                    "{} names `{}`, which is no program",
                    self.variable,
                    named.display()
                )
            });
            return program.map(Some);
        }
        let on_path = self.names.iter().find_map(|name| which::which(name).ok());
        let mut places = self.places.iter().map(PathBuf::from);
        Ok(on_path.or_else(|| places.find(|path| path.is_file())))
    }
}

/// Whether a window could appear: not under CI, and on Linux only with a display server.
pub(crate) fn display_present() -> bool {
    let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    !set("CI") && (!cfg!(target_os = "linux") || set("DISPLAY") || set("WAYLAND_DISPLAY"))
}
