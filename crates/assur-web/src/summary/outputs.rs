//! Output profiles and cycles in a summary.

use super::*;

impl OutputSummary {
    /// The outputs of a linkage over its motion.
    pub(crate) fn all(moving: &Moving) -> Vec<Self> {
        let outputs = moving.outputs().into_iter();
        let all = outputs.map(|output| {
            let profile = OutputProfile::new(moving.motion(), output).ok();
            Self::new(output.name(moving.mechanism(), 0), profile.as_ref())
        });
        all.collect()
    }

    /// Makes the summary of a profile; without a search, the name alone.
    fn new(name: String, profile: Option<&OutputProfile<'_>>) -> Self {
        let limits = profile.map(OutputProfile::limits).unwrap_or_default();
        let swings = profile.map(OutputProfile::swings).unwrap_or_default();
        let travels = profile.map(OutputProfile::travels).unwrap_or_default();
        Self {
            name,
            searched: profile.is_some(),
            swing: swings.into_iter().map(between).collect(),
            turns: travels.into_iter().map(|travel| travel / TAU).collect(),
            limits: (limits.into_iter())
                .map(|limit| LimitSummary {
                    input: limit.input,
                    value: limit.value,
                })
                .collect(),
            time_ratio: profile.and_then(OutputProfile::time_ratio),
        }
    }
}

impl CycleSummary {
    pub(super) fn new(cycle: &Cycle) -> Self {
        let [start, end] = cycle.axis();
        Self {
            start,
            end,
            full: cycle.is_full(),
            arcs: cycle.arcs().to_vec(),
        }
    }
}

fn between(swing: Swing) -> Option<Between> {
    match swing {
        Swing::Turns => None,
        Swing::Between { min, max } => Some(Between {
            min,
            max,
            stroke: swing.stroke()?,
        }),
    }
}
