//! Measures that a view shows between points or links.

use assur::mechanism::{Mechanism, Quantity};
use assur_file::{Problem, View};

const MAX_MEASURES: usize = 8;

/// Finds the quantities that a view measures.
///
/// # Errors
/// An unknown or duplicate measure; more than [`MAX_MEASURES`].
pub(crate) fn measures(view: &View, mechanism: &Mechanism) -> Result<Vec<Quantity>, Vec<Problem>> {
    let mut found = Vec::new();
    for name in &view.measures {
        let quantity = Quantity::named(mechanism, name);
        let quantity = quantity.filter(|one| one.is_measured() && !found.contains(one));
        match quantity.filter(|_| found.len() < MAX_MEASURES) {
            Some(quantity) => found.push(quantity),
            None => {
                let field = "measures".into();
                return Err(vec![Problem::UnknownChoice { field }]);
            }
        }
    }
    Ok(found)
}
