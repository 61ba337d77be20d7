//! TypeScript types of edits for the scripts of the page. The test compares them with this crate's
//! `types.d.ts`; if `ASSUR_WRITE_TYPES` is set, it writes that file first.

use assur_tests::types::assert_declared;

use crate::{Edit, Mend, Outer};

#[test]
fn the_scripts_know_what_can_be_edited() {
    let head = "import { LinkageDocument } from \"assur/types/file.js\";\n";
    assert_declared::<(Edit, Outer, Mend)>(env!("CARGO_MANIFEST_DIR"), head);
}
