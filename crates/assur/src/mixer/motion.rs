//! The motion of a mixer, as of any linkage.

use super::Mixer;
use crate::Unsolved;
use crate::mechanism::{Defect, LinkageSpec, Mechanism};
use crate::motion::{Motion, Unjoinable};

/// The reason why a mixer has no motion as a linkage.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmoved {
    /// It cannot be drawn.
    Unsolved(Unsolved),
    /// Its specification is no mechanism.
    Defects(Vec<Defect>),
    /// Its arcs are not those of one linkage.
    Unjoinable(Unjoinable),
}

impl Mixer {
    /// The motion over all arcs of [`FourBar::cycle`](crate::FourBar::cycle), in the
    /// assembly of the mixer.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn motion(&self) -> Result<Motion, Unmoved> {
        let mut motion = self.moved(&self.spec().map_err(Unmoved::Unsolved)?)?;
        let cycle = self.linkage.cycle();
        for arc in cycle.arcs().iter().skip(1) {
            let spec = self.spec_on(*arc);
            let other = self.moved(&spec.map_err(Unmoved::Unsolved)?)?;
            motion = motion.joined(other).map_err(Unmoved::Unjoinable)?;
        }
        Ok(motion)
    }

    fn moved(&self, spec: &LinkageSpec) -> Result<Motion, Unmoved> {
        let mechanism = Mechanism::new(spec).map_err(Unmoved::Defects)?;
        // A drawing that fits both assemblies is redrawn.
        let redrawn = mechanism.with_four_bar(self.assembly);
        Ok(Motion::new(redrawn.unwrap_or(mechanism)))
    }
}

#[cfg(test)]
mod tests;
