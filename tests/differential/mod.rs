//! Epicyclic trains with two freedoms: the paper's formulas for random numbers, the satellite against integrated
//! rolling, conditions against geometry, refusals.

mod conditions;
mod draw;
mod formulas;
mod motion;
mod refusals;
mod suggestions;
mod turning;
