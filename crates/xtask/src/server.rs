//! A server for one directory, for this machine only: GET and HEAD, a thread and
//! a connection for every request.
//!
//! So plain on purpose: tiny_http's pool of threads was seen to leave one of the
//! connections that a browser opens at once without a thread, and the page blank.

use std::fs;
use std::io::{BufRead, BufReader, Read, Result as IoResult, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use anyhow::{Context, Result, anyhow, bail};
use percent_encoding::percent_decode_str;

use crate::media::media_type;

/// How many ports after the wished one are tried.
const PORTS: u16 = 100;

/// The most that is read of a request: it has no body.
const LONGEST_REQUEST: u64 = 64 * 1024;

/// How long a browser may keep a connection open without asking.
const PATIENCE: Duration = Duration::from_secs(60);

/// The thread that takes connections.
pub(crate) struct Workers(JoinHandle<()>);

impl Workers {
    /// Waits as long as the server runs, which is for ever unless something breaks.
    pub(crate) fn wait(self) -> Result<()> {
        let ended = self.0.join();
        ended.map_err(|_| anyhow!("the server stopped unexpectedly"))
    }
}

/// Takes the wished port or the next free one; port 0 means any.
pub(crate) fn listen(port: u16) -> Result<TcpListener> {
    for candidate in port..=port.saturating_add(PORTS) {
        if let Ok(listener) = TcpListener::bind((Ipv4Addr::LOCALHOST, candidate)) {
            return Ok(listener);
        }
    }
    bail!(
        "no port from {port} to {} is free, choose one by --port",
        port.saturating_add(PORTS)
    )
}

/// Serves a directory from threads of its own.
pub(crate) fn start(listener: TcpListener, root: &Path) -> Result<(SocketAddr, Workers)> {
    let address = listener.local_addr().context("the server has no address")?;
    let root = root.to_owned();
    let taking = thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let root = root.clone();
            // Whoever asked may be gone by now, which harms no one else.
            thread::spawn(move || answer(&stream, &root).ok());
        }
    });
    Ok((address, Workers(taking)))
}

fn answer(stream: &TcpStream, root: &Path) -> IoResult<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    let mut request = BufReader::new(stream.take(LONGEST_REQUEST));
    let mut first = String::new();
    request.read_line(&mut first)?;
    // All of the request is read: a connection closed before that is an error to a browser.
    let mut line = String::new();
    while request.read_line(&mut line)? > 2 {
        line.clear();
    }
    let mut words = first.split_ascii_whitespace();
    let (method, url) = (
        words.next().unwrap_or_default(),
        words.next().unwrap_or_default(),
    );
    let plain = media_type("txt.txt");
    let (status, kind, body) = match (method, read(root, url)) {
        ("GET" | "HEAD", Some((kind, body))) => ("200 OK", kind, body),
        ("GET" | "HEAD", None) => ("404 Not Found", plain, b"not found\n".to_vec()),
        _ => {
            let words = b"only GET and HEAD are answered\n";
            ("405 Method Not Allowed", plain, words.to_vec())
        }
    };
    let mut stream = stream;
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\
         Cache-Control: no-store\r\nAllow: GET, HEAD\r\nConnection: close\r\n\r\n",
        body.len()
    )?;
    if method != "HEAD" {
        stream.write_all(&body)?;
    }
    stream.flush()
}

fn read(root: &Path, url: &str) -> Option<(&'static str, Vec<u8>)> {
    let path = root.join(relative_path(url)?);
    let body = fs::read(&path).ok()?;
    Some((media_type(&path.to_string_lossy()), body))
}

/// The file that an address means, below the root; nothing if the address could lead out of it.
/// Decoding comes first, so an encoded `..`, `/` or `\` is judged like a plain one.
fn relative_path(url: &str) -> Option<PathBuf> {
    let address = url.split(['?', '#']).next()?;
    let decoded = percent_decode_str(address).decode_utf8().ok()?;
    let mut path = PathBuf::new();
    for part in decoded.strip_prefix('/')?.split('/') {
        if part == ".." || part.contains(['\\', ':', '\0']) {
            return None;
        }
        path.push(part);
    }
    if decoded.ends_with('/') {
        path.push("index.html");
    }
    Some(path)
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Write};
    use std::net::TcpStream;

    use super::*;

    #[test]
    fn addresses_become_paths_below_the_root() {
        for (url, path) in [
            ("/", "index.html"),
            ("/index.html?x=1#y", "index.html"),
            ("/lang/en.json", "lang/en.json"),
            ("/a%20b.js", "a b.js"),
            ("/docs/", "docs/index.html"),
        ] {
            assert_eq!(relative_path(url), Some(PathBuf::from(path)), "{url}");
        }
    }

    #[test]
    fn nothing_leads_out_of_the_root() {
        for url in [
            "",
            "index.html",
            "/..",
            "/../Cargo.toml",
            "/%2e%2e/Cargo.toml",
            "/lang/..%2f..%2fCargo.toml",
            "/..%5cCargo.toml",
            "/C:/Windows",
            "/%00",
            "/%ff",
        ] {
            assert_eq!(relative_path(url), None, "{url}");
        }
        // An empty part would make the rest absolute if it were taken as it stands.
        assert!(relative_path("//etc/passwd").unwrap().is_relative());
        assert!(relative_path("/%2fetc/passwd").unwrap().is_relative());
    }

    fn ask(address: SocketAddr, request: &str) -> String {
        let mut stream = TcpStream::connect(address).unwrap();
        write!(
            stream,
            "{request} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"
        )
        .unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer.to_ascii_lowercase()
    }

    #[test]
    fn a_file_is_served_with_type_length_and_no_caching() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let (address, _workers) = start(listen(0).unwrap(), root).unwrap();

        let whole = ask(address, "GET /Cargo.toml");
        assert!(whole.starts_with("http/1.1 200"), "{whole}");
        assert!(whole.contains("cache-control: no-store"), "{whole}");
        assert!(whole.contains("content-length: "), "{whole}");
        assert!(whole.contains("[dependencies]"), "{whole}");

        let head = ask(address, "HEAD /Cargo.toml");
        assert!(head.starts_with("http/1.1 200"), "{head}");
        assert!(!head.contains("[dependencies]"), "{head}");

        assert!(ask(address, "GET /absent.html").starts_with("http/1.1 404"));
        assert!(ask(address, "GET /src").starts_with("http/1.1 404"));
        assert!(ask(address, "GET /..%2fxtask/Cargo.toml").starts_with("http/1.1 404"));
        assert!(ask(address, "POST /Cargo.toml").starts_with("http/1.1 405"));
    }

    /// A browser opens connections ahead of need and uses some of them only later.
    #[test]
    fn idle_connections_keep_no_one_waiting() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let (address, _workers) = start(listen(0).unwrap(), root).unwrap();
        let idle: Vec<_> = (0..20)
            .map(|_| TcpStream::connect(address).unwrap())
            .collect();
        for _ in 0..20 {
            assert!(ask(address, "GET /Cargo.toml").starts_with("http/1.1 200"));
        }
        drop(idle);
    }

    #[test]
    fn a_taken_port_gives_the_next_one() {
        let taken = listen(0).unwrap();
        let port = taken.local_addr().unwrap().port();
        let next = listen(port).unwrap().local_addr().unwrap().port();
        assert!(next > port);
    }
}
