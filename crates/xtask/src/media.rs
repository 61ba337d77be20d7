//! What kind of thing a file is, by its ending.

/// The media type the server sends and the bundle writes. A module script of another type than
/// JavaScript would be refused by the browser, and so would wasm that is to be compiled as it loads.
pub(crate) fn media_type(path: &str) -> &'static str {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    match ending.to_ascii_lowercase().as_str() {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/vnd.microsoft.icon",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::media_type;

    #[test]
    fn what_the_page_is_made_of_has_its_type() {
        for (path, expected) in [
            ("index.html", "text/html; charset=utf-8"),
            ("style.css", "text/css; charset=utf-8"),
            ("pkg/assur_web.js", "text/javascript; charset=utf-8"),
            ("lang/ru.json", "application/json"),
            ("pkg/assur_web_bg.wasm", "application/wasm"),
            ("icon.SVG", "image/svg+xml"),
            ("picture.png", "image/png"),
        ] {
            assert_eq!(media_type(path), expected, "{path}");
        }
    }

    #[test]
    fn the_unknown_is_bytes() {
        assert_eq!(media_type("LICENSE"), "application/octet-stream");
        assert_eq!(media_type("a.b.xyz"), "application/octet-stream");
    }
}
