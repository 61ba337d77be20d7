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
#[derive(Clone, Copy, ValueEnum)]
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

impl Browser {
    /// The variables by which the tests of the page find it.
    pub(crate) fn variables(&self) -> [(&'static str, &OsStr); 3] {
        let (name, program, driver) = match self.kind {
            Kind::Chromium => ("chromium", CHROME, CHROMEDRIVER),
            Kind::Firefox => ("firefox", FIREFOX, GECKODRIVER),
        };
        [
            ("ASSUR_BROWSER", name.as_ref()),
            (program.variable, self.program.as_ref()),
            (driver.variable, self.driver.as_ref()),
        ]
    }
}

/// One of the programs: the variable that names it, its names, and places that are not on PATH.
struct Program {
    variable: &'static str,
    names: &'static [&'static str],
    places: &'static [&'static str],
}

const CHROME: Program = Program {
    variable: "CHROME",
    // The shell has the same engine without the parts of a window, and starts sooner.
    names: &[
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

/// Finds a browser and its driver or, where the system's packages can be installed, installs what
/// is missing.
pub(crate) fn find_or_install(workspace: &Workspace, kind: Kind) -> Result<Browser> {
    // Without a font the browser would draw no text.
    const FONTS: &str = "fonts-dejavu-core";
    let (program, driver) = match kind {
        Kind::Chromium => in_place(
            workspace,
            "Chromium and its driver",
            || Ok(CHROME.find()?.zip(CHROMEDRIVER.find()?)),
            &["chromium-headless-shell", "chromium-driver", FONTS],
        )?,
        Kind::Firefox => (
            in_place(
                workspace,
                "Firefox",
                || FIREFOX.find(),
                &["firefox-esr", FONTS],
            )?,
            // The system's packages do not have the driver.
            GECKODRIVER
                .find()?
                .map_or_else(|| tools::geckodriver(workspace), Ok)?,
        ),
    };
    Ok(Browser {
        kind,
        program,
        driver,
    })
}

/// What is found, or is found after the system's packages have been installed.
fn in_place<T>(
    workspace: &Workspace,
    what: &str,
    find: impl Fn() -> Result<Option<T>>,
    packages: &[&str],
) -> Result<T> {
    if let Some(found) = find()? {
        announce(what, "already there");
        return Ok(found);
    }
    let variables =
        "or name what is there by the environment variables of `cargo xtask test --help`";
    if !Path::new("/etc/debian_version").exists() || which::which("apt-get").is_err() {
        bail!("{what} must be installed: do so, {variables}");
    }
    if quiet_output(Command::new("id").arg("-u")).is_none_or(|user| user.trim() != "0") {
        let packages = packages.join(" ");
        bail!("{what}: run `apt-get install {packages}` as root, {variables}");
    }
    announce(what, "installing by apt-get");
    let install = ["install", "-y", "--no-install-recommends"];
    for arguments in [&["update"][..], &[&install[..], packages].concat()] {
        let mut apt = workspace.command("apt-get");
        run(
            apt.args(arguments).env("DEBIAN_FRONTEND", "noninteractive"),
            what,
        )?;
    }
    find()?.with_context(|| {
        format!("apt-get installed {what}, which cannot be found in the usual places")
    })
}

impl Program {
    /// The variable wins, then PATH, then the other places. A variable that points nowhere is an
    /// error: silently testing another browser would mislead.
    fn find(&self) -> Result<Option<PathBuf>> {
        if let Some(named) = env::var_os(self.variable).filter(|value| !value.is_empty()) {
            return match which::which(&named) {
                Ok(path) => Ok(Some(path)),
                Err(_) => bail!(
                    "{} names `{}`, which is no program",
                    self.variable,
                    named.display()
                ),
            };
        }
        let on_path = self.names.iter().find_map(|name| which::which(name).ok());
        Ok(on_path.or_else(|| {
            self.places
                .iter()
                .map(PathBuf::from)
                .find(|path| path.is_file())
        }))
    }
}

/// Whether a window could appear: not under CI, and on Linux only with a display server.
pub(crate) fn display_present() -> bool {
    let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
    if set("CI") {
        return false;
    }
    !cfg!(target_os = "linux") || set("DISPLAY") || set("WAYLAND_DISPLAY")
}
