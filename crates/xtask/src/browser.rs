//! Chrome or Chromium and the driver that steers it.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, bail};

use crate::step::{announce, quiet_output, run};
use crate::workspace::Workspace;

/// A browser and its driver.
pub(crate) struct Browser {
    pub(crate) chrome: PathBuf,
    pub(crate) driver: PathBuf,
}

/// One of the two programs: the variable that names it, the names and the places it goes by.
struct Program {
    variable: &'static str,
    names: &'static [&'static str],
    places: &'static [&'static str],
}

const CHROME: Program = Program {
    variable: "CHROME",
    names: &[
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
        "chrome",
    ],
    places: &[
        "/usr/bin/chromium",
        "/usr/bin/chromium-browser",
        "/usr/bin/google-chrome",
        "/usr/lib/chromium/chromium",
        "/usr/lib64/chromium-browser/chromium-browser",
        "/opt/google/chrome/chrome",
        "/snap/bin/chromium",
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
        r"C:\Program Files\Google\Chrome\Application\chrome.exe",
        r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
        r"C:\Program Files\Chromium\Application\chrome.exe",
    ],
};

const DRIVER: Program = Program {
    variable: "CHROMEDRIVER",
    names: &["chromedriver", "chromium.chromedriver"],
    places: &[
        "/usr/bin/chromedriver",
        "/usr/lib/chromium/chromedriver",
        "/usr/lib/chromium-browser/chromedriver",
        "/usr/local/bin/chromedriver",
        "/opt/homebrew/bin/chromedriver",
        "/snap/bin/chromium.chromedriver",
        r"C:\Program Files\chromedriver\chromedriver.exe",
        r"C:\Program Files\Google\Chrome\Application\chromedriver.exe",
    ],
};

const WHAT: &str = "browser and driver";

/// Finds both or, where the system's packages can be installed, installs both.
pub(crate) fn find_or_install(workspace: &Workspace) -> Result<Browser> {
    if let Some(browser) = find()? {
        announce(
            WHAT,
            &format!("already there ({})", browser.chrome.display()),
        );
        return Ok(browser);
    }
    if !Path::new("/etc/debian_version").exists() || which::which("apt-get").is_err() {
        bail!(
            "Chrome or Chromium and the chromedriver of the same version are needed: install both, \
             or name them by the environment variables CHROME and CHROMEDRIVER"
        );
    }
    if quiet_output(Command::new("id").arg("-u")).is_none_or(|user| user.trim() != "0") {
        bail!(
            "Chromium and its driver are needed: run `apt-get install chromium chromium-driver` as \
             root, or name others by the environment variables CHROME and CHROMEDRIVER"
        );
    }
    announce(WHAT, "installing by apt-get");
    for arguments in [
        &["update"][..],
        // Without a font the browser would draw no text.
        &[
            "install",
            "-y",
            "--no-install-recommends",
            "chromium",
            "chromium-driver",
            "fonts-dejavu-core",
        ],
    ] {
        let mut apt = workspace.command("apt-get");
        run(
            apt.args(arguments).env("DEBIAN_FRONTEND", "noninteractive"),
            WHAT,
        )?;
    }
    match find()? {
        Some(browser) => Ok(browser),
        None => {
            bail!("apt-get installed Chromium and its driver but they are not in the usual places")
        }
    }
}

fn find() -> Result<Option<Browser>> {
    let (chrome, driver) = (CHROME.find()?, DRIVER.find()?);
    Ok(chrome
        .zip(driver)
        .map(|(chrome, driver)| Browser { chrome, driver }))
}

impl Program {
    /// The variable wins, then PATH, then the usual places. A variable that points nowhere is an
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
