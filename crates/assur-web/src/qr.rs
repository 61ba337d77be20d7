//! The URL of a page as a QR code, which telephones read from paper.

use qrcodegen::{QrCode, QrCodeEcc};
use wasm_bindgen::prelude::wasm_bindgen;

/// Cells of the QR code of a text, row by row; 1 is dark. None if the text is too long.
#[wasm_bindgen(js_name = qrCode)]
pub fn qr_code(text: &str) -> Option<Vec<u8>> {
    let code = QrCode::encode_text(text, QrCodeEcc::Low).ok()?;
    let side = 0..code.size();
    let cells = side.clone().flat_map(|y| side.clone().map(move |x| (x, y)));
    Some(
        cells
            .map(|(x, y)| u8::from(code.get_module(x, y)))
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::qr_code;

    /// Codes have finder patterns in three corners. The smallest code has 21 cells a side; the largest has 177.
    #[test]
    fn codes_have_finders() {
        let cells = qr_code("#jansen").unwrap();
        assert_eq!(cells.len(), 21 * 21);
        let dark = |x: usize, y: usize| cells[y * 21 + x] == 1;
        for [left, top] in [[0, 0], [14, 0], [0, 14]] {
            for k in 0..7 {
                assert!(dark(left + k, top) && dark(left, top + k) && dark(left + k, top + 6));
            }
            assert!(dark(left + 3, top + 3) && !dark(left + 1, top + 1));
        }
        assert_eq!(
            qr_code(&"x".repeat(2900)).map(|cells| cells.len()),
            Some(177 * 177)
        );
        assert_eq!(qr_code(&"x".repeat(3000)), None);
    }
}
