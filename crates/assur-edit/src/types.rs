//! TypeScript types of edits for the scripts of the page: this test writes `types.d.ts` of this
//! crate if `ASSUR_WRITE_TYPES` is set, and otherwise compares it.

use assur_tests::types::assert_declared;

use crate::{Edit, Mend, Outer};

#[test]
fn the_scripts_know_what_can_be_edited() {
    let head = "import { LinkageDocument } from \"assur/types/file.js\";\n";
    assert_declared::<(Edit, Outer, Mend)>(env!("CARGO_MANIFEST_DIR"), head);
}
