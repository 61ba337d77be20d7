//! Dimensions for a wanted motion.

pub mod dwell;
