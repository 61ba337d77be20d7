//! A server of one folder for this machine only: `build/serve.js`, in a process of its own.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Stdio};

use anyhow::{Context, Result, bail};

use crate::step::{ending, not_started};
use crate::workspace::Workspace;

/// A running server, which ends with its input: when this is dropped, or this program ends.
pub(crate) struct Server {
    process: Child,
    pub(crate) url: String,
}

impl Server {
    /// Serves a folder at the wished port or the next free one; port 0 means any.
    pub(crate) fn start(workspace: &Workspace, port: u16, root: &Path) -> Result<Self> {
        let mut node = workspace.node("serve.js");
        node.arg(root).args(["--port", &port.to_string()]);
        node.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = node
            .spawn()
            .map_err(|error| not_started(&node, "serving the page", error))?;
        let said = process.stdout.take().context("the server says nothing")?;
        let mut url = String::new();
        BufReader::new(said)
            .read_line(&mut url)
            .context("the server says nothing")?;
        if url.is_empty() {
            bail!(
                "the server ended with {}",
                ending(process.wait().context("the server")?.code())
            );
        }
        Ok(Self {
            process,
            url: url.trim_end().to_owned(),
        })
    }

    /// The address, at which it goes on serving until this program ends.
    pub(crate) fn keep(self) -> String {
        let url = self.url.clone();
        std::mem::forget(self);
        url
    }

    /// Waits as long as the server runs, which is for ever unless something breaks.
    pub(crate) fn wait(mut self) -> Result<()> {
        // `wait` would close its input.
        let input = self.process.stdin.take();
        let status = self.process.wait().context("the server")?;
        drop(input);
        bail!("the server ended with {}", ending(status.code()))
    }
}
