//! The media type that a file is served as.

use std::path::Path;

/// The type by the file's extension.
///
/// A browser wants `application/wasm` to compile wasm while it loads, and a JavaScript type to run
/// a module at all.
pub fn media_type(file: &Path) -> &'static str {
    let extension = file.extension().and_then(|e| e.to_str()).unwrap_or("");
    match extension.to_ascii_lowercase().as_str() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "wasm" => "application/wasm",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "webp" => "image/webp",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "txt" | "md" | "nc" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::media_type;
    use std::path::Path;

    #[test]
    fn knows_what_a_site_consists_of() {
        for (file, expected) in [
            ("index.html", "text/html; charset=utf-8"),
            ("assets/index-D1x.js", "text/javascript; charset=utf-8"),
            ("assets/nctape_bg-Ab.wasm", "application/wasm"),
            ("ICON.SVG", "image/svg+xml"),
            ("tape", "application/octet-stream"),
        ] {
            assert_eq!(media_type(Path::new(file)), expected, "{file}");
        }
    }
}
