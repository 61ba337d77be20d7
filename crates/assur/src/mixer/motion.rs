//! The motion of a mixer, found as for any linkage.

use super::Mixer;
use crate::Unsolved;
use crate::mechanism::{Defect, LinkageSpec, Mechanism};
use crate::motion::{Motion, Unjoinable};

/// The reason why a mixer has no motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmoved {
    /// No pose of the mixer can be drawn.
    Unsolved(Unsolved),
    /// The specification of the mixer has defects.
    Defects(Vec<Defect>),
    /// The arcs of the mixer cannot be joined into one motion.
    Unjoinable(Unjoinable),
}

impl Mixer {
    /// The motion over all arcs of [`FourBar::cycle`](crate::FourBar::cycle), in the assembly of the mixer.
    ///
    /// # Errors
    /// There is no pose to draw, the specification has defects, or the arcs cannot be joined.
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
        // The drawing may show the other assembly; the mechanism is then redrawn in the mixer's assembly.
        let redrawn = mechanism.with_four_bar(self.assembly);
        Ok(Motion::new(redrawn.unwrap_or(mechanism)))
    }
}

#[cfg(test)]
mod tests;
