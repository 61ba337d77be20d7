//! Mobility and redundant constraints: the paper's table, the formulas against each other, and the rank against the
//! formulas.

mod bad_input;
mod graphs;
mod linkages;
mod names;
mod oracle;
mod paper;
mod practice;
mod random;
mod rank;
mod replacements;
mod schemes;
