//! A server for one directory, for this machine only.

use std::fs;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use anyhow::{Context, Result, anyhow, bail};
use percent_encoding::percent_decode_str;
use tiny_http::{Header, Method, Request, Response, Server};

use crate::media::media_type;

/// A page asks for some twenty files at once; a few workers answer them without waiting in line.
const WORKERS: usize = 4;

/// How many ports after the wished one are tried.
const PORTS: u16 = 100;

/// The threads that answer.
pub(crate) struct Workers(Vec<JoinHandle<()>>);

impl Workers {
    /// Waits as long as the server runs, which is for ever unless something breaks.
    pub(crate) fn wait(self) -> Result<()> {
        for worker in self.0 {
            worker
                .join()
                .map_err(|_| anyhow!("the server stopped unexpectedly"))?;
        }
        Ok(())
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
    let server = Server::from_listener(listener, None)
        .map_err(|error| anyhow!("the server did not start: {error}"))?;
    let server = Arc::new(server);
    let workers = (0..WORKERS)
        .map(|_| {
            let (server, root) = (Arc::clone(&server), root.to_owned());
            thread::spawn(move || {
                server
                    .incoming_requests()
                    .for_each(|request| answer(request, &root))
            })
        })
        .collect();
    Ok((address, Workers(workers)))
}

fn answer(request: Request, root: &Path) {
    let (status, kind, body) = match *request.method() {
        Method::Get | Method::Head => match read(root, request.url()) {
            Some((kind, body)) => (200, kind, body),
            None => (404, media_type("txt.txt"), b"not found\n".to_vec()),
        },
        _ => (
            405,
            media_type("txt.txt"),
            b"only GET and HEAD are answered\n".to_vec(),
        ),
    };
    let mut response = Response::from_data(body)
        .with_status_code(status)
        // The length is known, so it is always said.
        .with_chunked_threshold(usize::MAX);
    for (name, value) in [
        ("Content-Type", kind),
        ("Cache-Control", "no-store"),
        ("Allow", "GET, HEAD"),
    ] {
        if let Ok(header) = Header::from_bytes(name, value) {
            response.add_header(header);
        }
    }
    // Whoever asked may be gone by now, which harms no one else.
    let _ = request.respond(response);
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

    #[test]
    fn a_taken_port_gives_the_next_one() {
        let taken = listen(0).unwrap();
        let port = taken.local_addr().unwrap().port();
        let next = listen(port).unwrap().local_addr().unwrap().port();
        assert!(next > port);
    }
}
