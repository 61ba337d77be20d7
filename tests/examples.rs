//! The examples of the crates, run to their end.
#![allow(unreachable_pub)] // `main` of an example is called from here alone.

#[path = "../crates/assur-file/examples/assemblies.rs"]
mod assemblies;
#[path = "../crates/assur/examples/four_bar.rs"]
mod four_bar;
#[path = "../crates/assur-file/examples/linkage.rs"]
mod linkage;
#[path = "../crates/assur/examples/synthesis.rs"]
mod synthesis;
#[path = "../crates/assur/examples/train.rs"]
mod train;

#[test]
fn they_run() {
    four_bar::main();
    linkage::main();
    assemblies::main();
    synthesis::main();
    train::main();
}
