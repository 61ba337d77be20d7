//! Files and links of other programs, imported as documents.

use assur_file::Document;
use assur_import::{Imported, LeftOut};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::convert::{refused, to_js};

/// Result of an import. The document is a field of its own, because with serde's `flatten` the code for every kind of
/// document would be compiled a second time.
#[derive(Serialize)]
struct Read {
    read: Document,
    left_out: Vec<LeftOut>,
}

/// Whether a text appears to be a PMKS+ or PMKS URL or a Linkage file, whole or damaged.
#[wasm_bindgen(js_name = isImport)]
pub fn is_import(text: &str) -> bool {
    assur_import::recognised(text)
}

/// Reads a PMKS+ or PMKS URL or a Linkage file: `{read: {kind, document}, left_out}`. `left_out` lists
/// codes of features that could not be imported unchanged. The document may be unable to move.
///
/// # Errors
/// The part that cannot be read.
#[wasm_bindgen(js_name = readImport, unchecked_return_type = "Imported")]
pub fn read_import(text: &str) -> Result<JsValue, JsValue> {
    let read = assur_import::read(text).map_err(|problem| refused(&[problem]))?;
    let Imported { document, left_out } = read;
    let read = document.as_it_moves();
    Ok(to_js(&Read { read, left_out }))
}
