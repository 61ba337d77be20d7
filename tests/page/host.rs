//! A host of plain files, as far as the folder for one asks: its headers, packed files, an end.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use crate::browser::setting;

/// The folder for a host.
pub(crate) fn folder() -> PathBuf {
    Path::new(&setting("ASSUR_BUNDLE")).with_file_name("site")
}

/// A folder served below a path of its own.
pub(crate) struct Host {
    port: u16,
    below: String,
    down: Arc<AtomicBool>,
    root: Arc<Mutex<PathBuf>>,
}

impl Host {
    pub(crate) fn start(root: &Path, below: &str) -> Self {
        let listener = TcpListener::bind(("127.0.0.1", 0)).unwrap();
        let host = Self {
            port: listener.local_addr().unwrap().port(),
            below: below.to_owned(),
            down: Arc::default(),
            root: Arc::new(Mutex::new(root.to_owned())),
        };
        let (down, root, below) = (host.down.clone(), host.root.clone(), host.below.clone());
        thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                // Who asks a host that is down hears nothing.
                if down.load(Ordering::SeqCst) {
                    continue;
                }
                let (root, below) = (root.lock().unwrap().clone(), below.clone());
                thread::spawn(move || answer(stream, &root, &below));
            }
        });
        host
    }

    pub(crate) fn url(&self) -> String {
        format!("http://127.0.0.1:{}{}", self.port, self.below)
    }

    /// From now on another version is served, or another state of it.
    pub(crate) fn serve(&self, root: &Path) {
        *self.root.lock().unwrap() = root.to_owned();
    }

    /// From now on nothing is answered, or everything again.
    pub(crate) fn down(&self, down: bool) {
        self.down.store(down, Ordering::SeqCst);
    }
}

fn answer(mut stream: TcpStream, root: &Path, below: &str) -> Option<()> {
    let mut request = BufReader::new((&stream).take(64 * 1024));
    let mut lines = Vec::new();
    loop {
        let mut line = String::new();
        if request.read_line(&mut line).ok()? <= 2 {
            break;
        }
        lines.push(line.to_ascii_lowercase());
    }
    let url = lines.first()?.split(' ').nth(1)?;
    let name = url.split('?').next()?.strip_prefix(below)?;
    let name = if name.is_empty() { "index.html" } else { name };
    let packed = lines
        .iter()
        .any(|line| line.starts_with("accept-encoding:") && line.contains("br"));
    let path = |ending: &str| root.join(format!("{name}{ending}"));
    let (status, body, coding) = match (fs::read(path(".br")), fs::read(path(""))) {
        (Ok(body), _) if packed => ("200 OK", body, "Content-Encoding: br\r\n"),
        (_, Ok(body)) => ("200 OK", body, ""),
        _ => ("404 Not Found", Vec::new(), ""),
    };
    let kind = match Path::new(name).extension()?.to_str()? {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript",
        "css" => "text/css",
        "json" => "application/json",
        "wasm" => "application/wasm",
        _ => "application/octet-stream",
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nVary: Accept-Encoding\r\nConnection: close\r\n{coding}{}\r\n",
        body.len(),
        headers(root, name),
    );
    stream.write_all(head.as_bytes()).ok()?;
    stream.write_all(&body).ok()
}

/// Those that the folder asks for.
fn headers(root: &Path, name: &str) -> String {
    let asked = fs::read_to_string(root.join("_headers")).unwrap_or_default();
    let mut given: Vec<(String, String)> = Vec::new();
    let mut meant = false;
    for line in asked.lines() {
        if let Some(pattern) = line.strip_prefix('/') {
            meant = name.starts_with(pattern.trim_end_matches('*'));
        } else if meant && let Some(removed) = line.trim().strip_prefix("! ") {
            given.retain(|(key, _)| key != removed);
        } else if meant && let Some((key, value)) = line.trim().split_once(": ") {
            given.push((key.to_owned(), value.to_owned()));
        }
    }
    let lines = given
        .iter()
        .map(|(key, value)| format!("{key}: {value}\r\n"));
    lines.collect()
}
