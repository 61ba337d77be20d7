//! Room for each force plan over the whole motion, so that the scale of a plan is constant while the linkage moves.

use assur::forces::ForcePlan;
use assur::sorting::sort_by;

use super::{extent, size};

/// Limit of a plan's size, relative to the size that nine tenths of the poses do not exceed. Larger plans are left out,
/// because forces grow without bound near dead points.
const UNUSUAL: f64 = 2.0;
/// Margin on every side for poses between the sampled ones, relative to the size.
const MARGIN: f64 = 0.02;

/// Rectangles that hold each plan, by its number, in all usual poses of a motion.
#[derive(Clone, Debug, Default)]
pub struct PlanRooms(Vec<Option<[f64; 4]>>);

impl PlanRooms {
    /// Returns the rooms of the plans in poses over a motion, without unusually large plans.
    pub fn over(poses: &[ForcePlan]) -> Self {
        let numbers = poses.iter().flat_map(|plan| &plan.steps);
        let count = numbers.map(|step| step.plan + 1).max().unwrap_or(0);
        let room = |number: usize| {
            let plans = poses.iter().filter_map(|plan| extent(plan, number));
            let mut plans: Vec<[f64; 4]> = plans.collect();
            sort_by(&mut plans, |a, b| size(*a).total_cmp(&size(*b)));
            let usual = plans
                .get(plans.len() * 9 / 10)
                .map_or(0.0, |plan| size(*plan));
            plans.retain(|plan| size(*plan) <= UNUSUAL * usual);
            plans.into_iter().reduce(joined).map(|room| {
                let [left, bottom, right, top] = room;
                let free = MARGIN * size(room);
                [left - free, bottom - free, right + free, top + free]
            })
        };
        Self((0..count).map(room).collect())
    }

    /// Returns the room of a plan, enlarged to hold the plan in this pose.
    pub(super) fn around(&self, number: usize, here: Option<[f64; 4]>) -> [f64; 4] {
        let usual = self.0.get(number).copied().flatten();
        let both = usual.into_iter().chain(here);
        both.reduce(joined).unwrap_or([0.0, 0.0, 1.0, 1.0])
    }
}

fn joined(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [
        a[0].min(b[0]),
        a[1].min(b[1]),
        a[2].max(b[2]),
        a[3].max(b[3]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_room_holds_the_usual_and_the_present() {
        let rooms = PlanRooms(vec![Some([0.0, -1.0, 2.0, 1.0])]);
        let small = rooms.around(0, Some([0.0, 0.0, 0.5, 0.5]));
        assert_eq!(small, [0.0, -1.0, 2.0, 1.0]);
        let great = rooms.around(0, Some([-9.0, 0.0, 0.5, 0.5]));
        assert_eq!(great, [-9.0, -1.0, 2.0, 1.0]);
        assert_eq!(rooms.around(3, None), [0.0, 0.0, 1.0, 1.0]);
    }
}
