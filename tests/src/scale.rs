//! Amount of random input in tests, and its first seed.

use std::env;
use std::ops::Mul;

/// The count of a quick run times `ASSUR_SCALE`, which is 1 if it is not set.
///
/// # Panics
/// Where `ASSUR_SCALE` is no whole number of at least 1.
pub fn scaled<T: From<u16> + Mul<Output = T>>(quick: T) -> T {
    quick * T::from(scale())
}

/// True if the counts are above those of the quick run: then a test goes through whole lists.
///
/// # Panics
/// Where `ASSUR_SCALE` is no whole number of at least 1.
pub fn exhaustive() -> bool {
    scale() > 1
}

fn scale() -> u16 {
    let scale = env::var("ASSUR_SCALE").map_or(1, |text| text.parse().unwrap_or(0));
    assert!(scale > 0, "ASSUR_SCALE is a whole number of at least 1");
    scale
}

/// The seed to begin with: `ASSUR_SEED`, which is 0 if it is not set.
///
/// # Panics
/// Where `ASSUR_SEED` is no whole number.
pub fn seed() -> u64 {
    let seed = env::var("ASSUR_SEED").map_or(Ok(0), |text| text.parse());
    assert!(seed.is_ok(), "ASSUR_SEED is a whole number");
    seed.unwrap_or_default()
}
