//! The shapes of what is saved, as the scripts of the page know them: `types.d.ts` of this crate is
//! written by this test where `ASSUR_WRITE_TYPES` is set, and compared else.

use assur_tests::types::assert_declared;

use crate::kinds::numbers::NumberField;
use crate::{
    Document, GalleryCategory, LengthUnit, LessonDocument, MeshDocument, PictureDocument, Preset,
    Shelf, View,
};

#[test]
fn the_scripts_know_what_is_saved() {
    type Saved = (View, Document, LessonDocument, PictureDocument, LengthUnit);
    type Shown = (NumberField, Preset, Shelf, GalleryCategory, MeshDocument);
    assert_declared::<(Saved, Shown)>(env!("CARGO_MANIFEST_DIR"), "");
}
