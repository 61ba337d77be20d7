//! Where things are. Cargo itself is asked, so `CARGO_TARGET_DIR` and the user's cargo
//! configuration are honoured; the workspace is the one this program was started from.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use serde::Deserialize;

use crate::step;

/// The version of every crate of the workspace, and so of the page.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The two directories everything else hangs on.
pub(crate) struct Workspace {
    root: PathBuf,
    target: PathBuf,
}

#[derive(Deserialize)]
struct Metadata {
    workspace_root: PathBuf,
    target_directory: PathBuf,
}

impl Workspace {
    pub(crate) fn locate() -> Result<Self> {
        let own = env::var_os("CARGO_MANIFEST_DIR")
            .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
        let mut cargo = Command::new(cargo_program());
        cargo
            .args([
                "metadata",
                "--no-deps",
                "--format-version",
                "1",
                "--manifest-path",
            ])
            .arg(own.join("Cargo.toml"));
        let answer = step::output(&mut cargo, "finding the workspace")?;
        let metadata: Metadata =
            serde_json::from_str(&answer).context("cargo metadata answered in an unknown form")?;
        Ok(Self {
            root: metadata.workspace_root,
            target: metadata.target_directory,
        })
    }

    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    pub(crate) fn target(&self) -> &Path {
        &self.target
    }

    /// Where cargo installs the tools of this project.
    pub(crate) fn tools(&self) -> PathBuf {
        self.target.join("tools")
    }

    pub(crate) fn site(&self) -> PathBuf {
        self.target.join("site")
    }

    /// Where `tsconfig.json` looks for the types of modules that the build writes.
    pub(crate) fn types(&self) -> PathBuf {
        self.root.join("target").join("types")
    }

    /// A script of the build, to be given its arguments.
    pub(crate) fn node(&self, script: &str) -> Command {
        let mut node = self.command("node");
        node.arg(self.root.join("crates/xtask/build").join(script));
        node
    }

    pub(crate) fn bundle(&self) -> PathBuf {
        self.root.join("dist").join("assur.html")
    }

    /// A cargo command that starts in the root.
    pub(crate) fn cargo<'a>(&self, arguments: impl IntoIterator<Item = &'a str>) -> Command {
        let mut cargo = self.command(&cargo_program());
        cargo.args(arguments);
        cargo
    }

    /// Any command that starts in the root.
    pub(crate) fn command(&self, program: &(impl AsRef<std::ffi::OsStr> + ?Sized)) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.root);
        command
    }

    /// The version of a crate that Cargo.lock has settled on.
    pub(crate) fn locked_version(&self, name: &str) -> Result<String> {
        let path = self.root.join("Cargo.lock");
        let lock = fs::read_to_string(&path)
            .with_context(|| format!("{} cannot be read", path.display()))?;
        version_in_lock(&lock, name)
    }
}

/// The cargo that runs this program, which rustup has already chosen.
fn cargo_program() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

#[derive(Deserialize)]
struct Lock {
    #[serde(default)]
    package: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
}

/// Two versions of one crate would leave the choice open, so they are refused.
fn version_in_lock(lock: &str, name: &str) -> Result<String> {
    let lock: Lock = toml::from_str(lock).context("Cargo.lock is not in the known form")?;
    let mut versions = lock
        .package
        .into_iter()
        .filter(|package| package.name == name);
    match (versions.next(), versions.next()) {
        (Some(package), None) => Ok(package.version),
        (None, _) => bail!("Cargo.lock holds no {name}"),
        (Some(_), Some(_)) => bail!("Cargo.lock holds more than one {name}"),
    }
}

#[cfg(test)]
mod tests {
    use super::version_in_lock;

    const LOCK: &str = r#"
version = 4

[[package]]
name = "twice"
version = "1.0.0"

[[package]]
name = "twice"
version = "2.0.0"

[[package]]
name = "wasm-bindgen"
version = "0.2.130"
source = "elsewhere"
dependencies = ["wasm-bindgen-shared"]

[[package]]
name = "wasm-bindgen-shared"
version = "0.2.99"
"#;

    #[test]
    fn the_locked_version_is_that_of_the_exact_name() {
        assert_eq!(version_in_lock(LOCK, "wasm-bindgen").unwrap(), "0.2.130");
    }

    #[test]
    fn a_missing_or_doubled_crate_is_a_sentence() {
        let absent = version_in_lock(LOCK, "nalgebra").unwrap_err().to_string();
        assert_eq!(absent, "Cargo.lock holds no nalgebra");
        let doubled = version_in_lock(LOCK, "twice").unwrap_err().to_string();
        assert_eq!(doubled, "Cargo.lock holds more than one twice");
        assert!(version_in_lock("not = [toml", "twice").is_err());
    }
}
