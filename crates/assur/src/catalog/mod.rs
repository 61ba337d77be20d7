//! Named mechanisms, each with the figure it stands for.

pub mod mixer;
