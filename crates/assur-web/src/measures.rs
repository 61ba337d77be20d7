//! What a view measures between points or links.

use assur::mechanism::{Mechanism, Quantity};
use assur_file::{Problem, View};

/// So many measures may a view have.
const MOST_MEASURES: usize = 8;

/// What a view measures.
///
/// # Errors
/// What is no measure, one that is there already, or more than can be told apart.
pub(crate) fn measures(view: &View, mechanism: &Mechanism) -> Result<Vec<Quantity>, Vec<Problem>> {
    let mut found = Vec::new();
    for name in &view.measures {
        let quantity = Quantity::named(mechanism, name);
        let quantity = quantity.filter(|one| one.is_measured() && !found.contains(one));
        match quantity.filter(|_| found.len() < MOST_MEASURES) {
            Some(quantity) => found.push(quantity),
            None => {
                let field = "measures".into();
                return Err(vec![Problem::UnknownChoice { field }]);
            }
        }
    }
    Ok(found)
}
