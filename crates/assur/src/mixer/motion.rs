//! The motion of a mixer, as of a linkage like any other.

use super::Mixer;
use crate::Unsolved;
use crate::mechanism::{Defect, Draft, Mechanism};
use crate::motion::{Motion, Unjoinable};

/// Why a mixer has no motion as a linkage.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmoved {
    /// It cannot be drawn.
    Unsolved(Unsolved),
    /// Its draft is no mechanism.
    Defects(Vec<Defect>),
    /// Its arcs are not those of one linkage.
    Unjoinable(Unjoinable),
}

impl Mixer {
    /// The motion over all arcs of [`FourBar::cycle`](crate::FourBar::cycle), in the
    /// assembly of the mixer.
    ///
    /// # Errors
    /// Why there is none.
    pub fn motion(&self) -> Result<Motion, Unmoved> {
        let mut motion = self.moved(&self.draft().map_err(Unmoved::Unsolved)?)?;
        let cycle = self.linkage.cycle();
        for arc in cycle.arcs().iter().skip(1) {
            let draft = self.draft_on(*arc);
            let other = self.moved(&draft.map_err(Unmoved::Unsolved)?)?;
            motion = motion.joined(other).map_err(Unmoved::Unjoinable)?;
        }
        Ok(motion)
    }

    fn moved(&self, draft: &Draft) -> Result<Motion, Unmoved> {
        let mechanism = Mechanism::new(draft).map_err(Unmoved::Defects)?;
        // Where the drawing does not tell the assemblies apart, it is redrawn.
        let assembly = mechanism.assembly_with(self.assembly);
        let other = assembly.filter(|assembly| *assembly != mechanism.drawn_assembly());
        let redrawn = other.and_then(|other| mechanism.assembly(other));
        debug_assert!(
            other.is_none() || redrawn.is_some(),
            "an assembly that is listed"
        );
        Ok(Motion::new(redrawn.unwrap_or(mechanism)))
    }
}

#[cfg(test)]
mod tests;
