//! Paths of the workspace, as cargo gives them, so that `CARGO_TARGET_DIR` and the user's cargo configuration are
//! honoured. The workspace is the one in which this program was built.

use std::env;
use std::path::PathBuf;

use anyhow::{Context, Result};
use serde::Deserialize;
use xshell::{Shell, cmd};

/// The version of every crate of the workspace, and so of the page.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The root of the repository and the target directory of cargo, which determine all other paths.
#[derive(Clone)]
pub(crate) struct Workspace {
    /// A shell whose commands start in the root.
    pub(crate) shell: Shell,
    pub(crate) root: PathBuf,
    pub(crate) target: PathBuf,
}

#[derive(Deserialize)]
struct Metadata {
    workspace_root: PathBuf,
    target_directory: PathBuf,
}

impl Workspace {
    pub(crate) fn locate() -> Result<Self> {
        let shell = Shell::new()?;
        shell.change_dir(env!("CARGO_MANIFEST_DIR"));
        let answer = cmd!(shell, "cargo metadata --no-deps --format-version=1").read()?;
        let metadata: Metadata =
            serde_json::from_str(&answer).context("cargo metadata answered in an unknown form")?;
        shell.change_dir(&metadata.workspace_root);
        Ok(Self {
            shell,
            root: metadata.workspace_root,
            target: metadata.target_directory,
        })
    }

    pub(crate) fn site(&self) -> PathBuf {
        self.target.join("site")
    }

    /// Folder of the page built with further folders of lessons and kinds.
    pub(crate) fn site_with_more(&self) -> PathBuf {
        self.target.join("site.more")
    }

    /// The version of a crate in Cargo.lock. If there are two, cargo refuses the query and names both.
    pub(crate) fn locked_version(&self, name: &str) -> Result<String> {
        // The answer has the form `registry+…#NAME@VERSION`.
        let id = cmd!(self.shell, "cargo pkgid {name}").read()?;
        let (_, version) = id
            .rsplit_once('@')
            .context("cargo pkgid names no version")?;
        Ok(version.to_owned())
    }
}

pub(crate) fn cargo_home() -> Result<PathBuf> {
    let named = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = named.or_else(|| env::home_dir().map(|home| home.join(".cargo")));
    home.context("the folder of cargo is unknown")
}
