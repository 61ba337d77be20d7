//! Where things are. Cargo itself is asked, so `CARGO_TARGET_DIR` and the user's cargo
//! configuration are honoured; the workspace is the one this program was started from.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use serde::Deserialize;

use crate::step;

/// The version of every crate of the workspace, and so of the page.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The root of the repository and the target directory of cargo, from which all other places follow.
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
        cargo.args([
            "metadata",
            "--no-deps",
            "--format-version=1",
            "--manifest-path",
        ]);
        cargo.arg(own.join("Cargo.toml"));
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

    pub(crate) fn site(&self) -> PathBuf {
        self.target.join("site")
    }

    pub(crate) fn site_with_more(&self) -> PathBuf {
        self.target.join("site.more")
    }

    /// Where `tsconfig.json` looks for the types of the engine.
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

    /// The version of a crate that Cargo.lock has settled on. Two versions of one crate are refused by
    /// cargo, which then names them.
    pub(crate) fn locked_version(&self, name: &str) -> Result<String> {
        // `registry+…#NAME@VERSION`
        let what = format!("finding the version of {name}");
        let id = step::output(&mut self.cargo(["pkgid", name]), &what)?;
        let (_, version) = id.trim().rsplit_once('@').context(what)?;
        Ok(version.to_owned())
    }
}

/// The folder of cargo itself.
pub(crate) fn cargo_home() -> Option<PathBuf> {
    let named = env::var_os("CARGO_HOME").map(PathBuf::from);
    named.or_else(|| env::home_dir().map(|home| home.join(".cargo")))
}

/// The cargo that runs this program, which rustup has already chosen.
fn cargo_program() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}
