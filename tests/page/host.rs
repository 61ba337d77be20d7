//! A host of plain files, as far as the folder for one asks: the server of `cargo xtask serve` below a path of its own, with an end.

use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::{LazyLock, Mutex};

use crate::browser::setting;

/// The address of the page as `cargo xtask serve` serves it.
pub(crate) fn home() -> &'static str {
    static HOME: LazyLock<Host> = LazyLock::new(|| Host::of("ASSUR_SITE"));
    &HOME.url
}

/// The address of the page with one more folder of lessons and kinds.
pub(crate) fn more() -> &'static str {
    static MORE: LazyLock<Host> = LazyLock::new(|| Host::of("ASSUR_MORE"));
    &MORE.url
}

/// The folder for a host.
pub(crate) fn folder() -> PathBuf {
    Path::new(&setting("ASSUR_BUNDLE")).with_file_name("site")
}

/// A folder served below a path of its own. The server ends with its input.
pub(crate) struct Host {
    url: String,
    server: Mutex<(Child, BufReader<ChildStdout>)>,
}

impl Host {
    /// The folder that an environment variable names.
    fn of(name: &str) -> Self {
        Self::start(setting(name).as_ref(), "/")
    }

    pub(crate) fn start(root: &Path, below: &str) -> Self {
        let script = assur_tests::files::root().join("crates/xtask/build/serve.js");
        let mut node = Command::new("node");
        node.arg(script).arg(root).args(["--below", below]);
        node.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut server = node.spawn().unwrap();
        let mut said = BufReader::new(server.stdout.take().unwrap());
        let mut url = String::new();
        said.read_line(&mut url).unwrap();
        Self {
            url: url.trim_end().to_owned(),
            server: Mutex::new((server, said)),
        }
    }

    pub(crate) fn url(&self) -> String {
        self.url.clone()
    }

    /// From now on another version is served, or another state of it.
    pub(crate) fn serve(&self, root: &Path) {
        self.told(&format!("serve {}", root.display()));
    }

    /// From now on nothing is answered, or everything again.
    pub(crate) fn down(&self, down: bool) {
        self.told(if down { "down" } else { "up" });
    }

    /// Returns once the server has done what it was told.
    fn told(&self, line: &str) {
        let (server, said) = &mut *self.server.lock().unwrap();
        writeln!(server.stdin.as_mut().unwrap(), "{line}").unwrap();
        let mut answer = String::new();
        said.read_line(&mut answer).unwrap();
        assert_eq!(answer.trim_end(), line);
    }
}
