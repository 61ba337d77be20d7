//! Assemblies numbered by the signs of their dyads, as in older files and web addresses. Otherwise assemblies are
//! numbered by the angle of a link: see [`Motion::assemblies_at`](crate::motion::Motion::assemblies_at).

use crate::Assembly;
use crate::mechanism::{AssemblySigns, Mechanism};
use crate::position::Predictor;

/// Limits of the search in the numbering of older files: the number of assemblies, and the number of steps solved to
/// find them.
const LIMITS: [usize; 2] = [256, (1 << 14) - 1];

/// Assemblies at the drawn input from which a motion can start, in the order of the signs of their dyads. Groups of
/// higher class stay in their drawn assembly. The search stops at 256 assemblies or 16,383 solved steps; the drawn
/// assembly is included in any case.
#[derive(Clone, Debug)]
pub struct SignedAssemblies<'a> {
    mechanism: &'a Mechanism,
    all: Vec<AssemblySigns>,
}

impl SignedAssemblies<'_> {
    /// Number of assemblies.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// Number of the drawn assembly, from 0.
    pub fn drawn(&self) -> usize {
        let others = self.all.iter();
        others
            .take_while(|signs| **signs != self.mechanism.drawn.signs)
            .count()
    }

    /// The mechanism redrawn in the assembly with a given number, from 0, at the drawn input or, if assemblies meet
    /// there, just beside it. None if no assembly has this number, or no drawing selects this assembly.
    pub fn assembly(&self, number: usize) -> Option<Mechanism> {
        self.mechanism.with_signs(self.all.get(number)?)
    }
}

impl Mechanism {
    /// Assemblies at the drawn input, numbered by their signs. Each call searches anew, for up to a few milliseconds.
    pub fn signed_assemblies(&self) -> SignedAssemblies<'_> {
        let mut all = self.layout.found_by_signs(&self.drawn, LIMITS);
        // The search may have stopped before the drawn assembly.
        if !all.contains(&self.drawn.signs) {
            all.push(self.drawn.signs.clone());
        }
        let mut state = self.blank_state();
        let whole = self.whole_closed_form();
        let mut begins =
            |signs: &_| whole || self.layout.entry(signs, &self.drawn, &mut state).is_some();
        all.retain(|signs| begins(signs));
        SignedAssemblies {
            mechanism: self,
            all,
        }
    }

    /// The mechanism redrawn with its four-bar in a given assembly. None if it has no four-bar in closed form or is
    /// already drawn in this assembly, if the links do not close, or if no drawing selects this assembly.
    pub(crate) fn with_four_bar(&self, assembly: Assembly) -> Option<Self> {
        let step = self.closed_steps().next()?.step;
        let mut signs = self.drawn.signs.clone();
        if Assembly::from(signs[step]) == assembly {
            return None;
        }
        signs[step] = signs[step].opposite();
        self.with_signs(&signs)
    }

    fn with_signs(&self, signs: &AssemblySigns) -> Option<Self> {
        let mut state: Predictor = self.blank_state();
        let inputs = self.layout.entries(&self.drawn);
        inputs.into_iter().find_map(|input| {
            let solved = self.solve(input, signs, self.drawn.near(), &mut state);
            let other = solved.ok().map(|()| Self::new(&self.drawn_by(&state)))?;
            other.ok().filter(|other| other.drawn.signs == *signs)
        })
    }
}
