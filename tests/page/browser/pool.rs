//! Browsers that serve one test after the other: each test has a window of its own, with storage, cache and
//! downloads of its own, and the browser goes on to the next one.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{LazyLock, Mutex, MutexGuard, Once, PoisonError};
use std::time::Duration;
use std::{env, fs, thread};

use thirtyfour::SessionId;
use thirtyfour::prelude::*;
use tokio::runtime::{Builder, Runtime};

use super::line::Line;
use super::{chromium, firefox, in_firefox, setting};

/// Time that a driver is given to end its browser.
const FAREWELL: Duration = Duration::from_secs(20);

/// Browsers that may wait for a test; those of rare profiles are ended first.
const WAITING: usize = 4;

/// The settings that a browser takes when it starts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Profile {
    pub(crate) lang: &'static str,
    /// Pages open at rest: the reader has asked the system for reduced motion.
    pub(crate) calm: bool,
}

/// A running browser with its driver. Both end when it is dropped.
pub(crate) struct Browser {
    profile: Profile,
    port: u16,
    pub(super) driver: WebDriver,
    pub(super) line: Line,
}

/// A window of one test, with a storage of its own. Its browser goes to the next test when it is dropped.
pub(crate) struct Window {
    browser: Option<Browser>,
    context: String,
    pub(super) downloads: PathBuf,
}

/// The session of a driver, to be ended with the tests.
struct Session {
    driver: Child,
    id: SessionId,
}

static WAITING_BROWSERS: Mutex<Vec<Browser>> = Mutex::new(Vec::new());

/// All browsers that run, by the port of their driver.
static SESSIONS: Mutex<BTreeMap<u16, Session>> = Mutex::new(BTreeMap::new());

/// Runtime of the connections to browsers, which outlive the runtime of a test.
static RUNTIME: LazyLock<Runtime> = LazyLock::new(|| {
    let mut builder = Builder::new_multi_thread();
    builder.worker_threads(1).enable_all().build().unwrap()
});

pub(super) fn locked<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Window {
    /// A window of a browser with a profile. A browser that breaks where the window is opened is replaced once: the
    /// test has not begun.
    pub(super) async fn open(profile: Profile) -> Self {
        let waiting = {
            let mut waiting = locked(&WAITING_BROWSERS);
            let at = waiting.iter().rposition(|one| one.profile == profile);
            at.map(|at| waiting.remove(at))
        };
        if let Some(browser) = waiting {
            match Self::within(browser).await {
                Ok(window) => return window,
                Err(broken) => println!("a browser is replaced: {broken}"),
            }
        }
        Self::within(Browser::start(profile).await).await.unwrap()
    }

    async fn within(browser: Browser) -> WebDriverResult<Self> {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let folder = format!("assur-page-{}-{number}", std::process::id());
        let downloads = env::temp_dir().join(folder);
        let context = browser.window(&downloads).await?;
        fs::create_dir_all(&downloads).unwrap();
        Ok(Self {
            browser: Some(browser),
            context,
            downloads,
        })
    }

    pub(super) fn browser(&self) -> &Browser {
        self.browser.as_ref().unwrap()
    }
}

impl Drop for Window {
    /// Closes the window; the browser waits for the next test, unless this one failed and may have left it in any state.
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.downloads);
        let browser = self.browser.take().filter(|_| !thread::panicking());
        let Some(browser) = browser else { return };
        let context = std::mem::take(&mut self.context);
        RUNTIME.spawn(async move {
            if browser.line.close(&context).await.is_ok() {
                let mut waiting = locked(&WAITING_BROWSERS);
                waiting.push(browser);
                let surplus = (waiting.len() > WAITING).then(|| waiting.remove(0));
                // It takes its time to end, and others wait for this list.
                drop(waiting);
                drop(surplus);
            }
        });
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        end(self.port);
    }
}

impl Browser {
    async fn start(profile: Profile) -> Self {
        static AT_THE_END: Once = Once::new();
        AT_THE_END.call_once(|| assert!(shutdown_hooks::add_shutdown_hook(end_all)));
        let (server, port) = (0..5).find_map(|_| driver()).unwrap();
        let connected = RUNTIME.spawn(connected(port, profile)).await;
        let (driver, line) = connected.unwrap();
        let session = Session {
            driver: server,
            id: driver.handle().session_id().clone(),
        };
        locked(&SESSIONS).insert(port, session);
        Self {
            profile,
            port,
            driver,
            line,
        }
    }

    /// Opens a window with a storage of its own, and returns the name of that.
    async fn window(&self, downloads: &Path) -> WebDriverResult<String> {
        let Self { driver, line, .. } = self;
        let context = line.window(driver).await?;
        if in_firefox() {
            firefox::prepare(driver, self.profile.calm, downloads).await?;
        } else {
            chromium::prepare(driver, &context, downloads).await?;
        }
        Ok(context)
    }
}

/// A session of a driver, and the line to its browser.
async fn connected(port: u16, profile: Profile) -> (WebDriver, Line) {
    let address = format!("http://127.0.0.1:{port}");
    let wanted: Capabilities = if in_firefox() {
        firefox::wanted(profile).into()
    } else {
        chromium::wanted(profile).into()
    };
    // An open connection would belong to the runtime of one test.
    let client = reqwest::Client::builder().pool_max_idle_per_host(0);
    let driver = WebDriver::builder(address, wanted)
        .client(client.build().unwrap())
        .await
        .unwrap();
    let line = Line::of(&driver).await;
    (driver, line)
}

/// A driver of browsers and its port. It looks for a free port before it takes it: where another one
/// takes it in between, it ends without one.
fn driver() -> Option<(Child, u16)> {
    let (program, options, before_port) = if in_firefox() {
        firefox::DRIVER
    } else {
        chromium::DRIVER
    };
    let mut server = Command::new(setting(program))
        .args(options)
        .envs(firefox::ROOM)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut said = BufReader::new(server.stdout.take().unwrap()).lines();
    let port = said.by_ref().map_while(Result::ok).find_map(|line| {
        let (_, port) = line.split_once(before_port)?;
        port.trim().trim_end_matches('.').parse().ok()
    });
    // A driver that goes on talking is not to wait for a listener.
    thread::spawn(move || said.for_each(drop));
    if port.is_none() {
        server.wait().unwrap();
    }
    Some((server, port?))
}

/// Ends a browser and its driver, by a plain request: the client may belong to a runtime that is no more.
fn end(port: u16) {
    let Some(mut session) = locked(&SESSIONS).remove(&port) else {
        return;
    };
    if let Ok(mut server) = TcpStream::connect(("127.0.0.1", port)) {
        let request = format!(
            "DELETE /session/{} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n",
            session.id
        );
        let _ = server.write_all(request.as_bytes());
        let _ = server.set_read_timeout(Some(FAREWELL));
        let _ = server.read(&mut [0; 256]);
    }
    let _ = session.driver.kill();
    let _ = session.driver.wait();
}

/// Ends all browsers; run where the tests are over.
extern "C" fn end_all() {
    let ports: Vec<u16> = locked(&SESSIONS).keys().copied().collect();
    ports.into_iter().for_each(end);
}
