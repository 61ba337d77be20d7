//! Read-outs of a moving linkage at a given input.

use std::borrow::Cow;
use std::collections::BTreeMap;

use assur::forces::Reactions;
use assur::mechanism::{PointId, Pose, Quantity};
use assur::{Jet, Point};
use assur_draw::chart::{Against, Chart};
use assur_file::Problem;

use super::Moving;
use crate::capabilities::Moves;
use crate::column::Column;
use crate::handle::HandlePlace;
use crate::here::{Here, ReadoutId};
use crate::pair::INPUT;
use crate::table::SweepTable;

impl Moving {
    /// Value and first two derivatives of each quantity, at the input rate chosen for the axes.
    fn rates<'a>(
        &'a self,
        quantities: &'a [Quantity],
        pose: &'a Pose<3>,
    ) -> impl Iterator<Item = f64> + 'a {
        let input = self.input();
        quantities.iter().flat_map(move |one| {
            let jet: Jet<3> = one.of(self.mechanism(), pose);
            [0, 1, 2].map(|order| input.rate(&jet, order))
        })
    }

    /// The plotted values at an input; empty if a plotted force has none there.
    fn on_plots(&self, input: f64, pose: &Pose<3>) -> Vec<f64> {
        let Some(pair) = &self.pair else {
            let forces = self.forces_on_plots(input, pose);
            return self.rates(&self.plotted, pose).chain(forces).collect();
        };
        let mut found = Reactions::default();
        let balanced =
            self.plots_forces() && self.forces().balance(pose, input, &mut found).is_ok();
        let values = pair.values(input, |column| match column {
            Column::Kinematic(column) => {
                let jet = column.quantity.of(self.mechanism(), pose);
                Some(self.input().rate(&jet, column.order))
            }
            Column::Force(force) if balanced => force.value(self.forces(), &found),
            Column::Force(_) => None,
        });
        values.unwrap_or_default()
    }

    /// Frame of the animation in a pose, with the other assemblies if they are shown.
    fn frame<const N: usize>(&self, input: f64, pose: &Pose<N>) -> Vec<f32> {
        let mut others = Vec::new();
        if self.others {
            let (found, shown) = self.assembled(input);
            others = found.poses;
            if let Some(shown) = shown {
                others.remove(shown);
            }
        }
        self.figure.frame_beside(pose, &others)
    }

    /// The linkage in a pose that need not be one of its motion, without read-outs.
    pub(crate) fn in_pose<const N: usize>(&self, pose: &Pose<N>) -> Here {
        Here {
            frame: self.figure.frame(pose),
            handles: self.places(pose),
            ..Here::default()
        }
    }

    fn place<const N: usize>(&self, pose: &Pose<N>, point: PointId) -> Point {
        self.mechanism().place(pose, point).place()
    }

    fn places<const N: usize>(&self, pose: &Pose<N>) -> Vec<f64> {
        let places = self.handles.iter().map(|handle| match handle.at {
            HandlePlace::Point(point) => self.place(pose, point),
            HandlePlace::Fixed(at) => at,
        });
        places.flat_map(|at| [at.x, at.y]).collect()
    }
}

impl Moves for Moving {
    fn at(&self, input: f64) -> Result<Here, Problem> {
        match self.motion.pose::<3>(input) {
            Ok(pose) => {
                let mechanism = self.mechanism();
                let angles = self.transmitting.iter();
                let angles = angles.map(|angle| angle.of(mechanism, &pose).value());
                let further = self.curvature.then(|| self.motion.pose::<4>(input).ok());
                let mut frame = match further.flatten() {
                    Some(further) => self.frame(input, &further),
                    None => self.frame(input, &pose),
                };
                if self.arrows {
                    self.add_arrows(&mut frame, input, &pose);
                }
                Ok(Here {
                    frame,
                    handles: self.places(&pose),
                    readouts: [input]
                        .into_iter()
                        .chain(angles)
                        .chain(self.rates(&self.quantities, &pose))
                        .collect(),
                    plotted: self.on_plots(input, &pose),
                })
            }
            Err(unsolved) => {
                let place = self.motion.pose::<1>(input);
                let pose = place.map_err(|_| self.problem(&unsolved))?;
                Ok(Here {
                    frame: self.frame(input, &pose),
                    handles: self.places(&pose),
                    readouts: Vec::new(),
                    plotted: Vec::new(),
                })
            }
        }
    }

    fn plotted_at(&self, input: f64) -> Result<Vec<f64>, Problem> {
        let pose = self.motion.pose::<3>(input);
        let pose = pose.map_err(|unsolved| self.problem(&unsolved))?;
        Ok(self.on_plots(input, &pose))
    }

    fn why(&self, input: f64) -> Option<Problem> {
        let unsolved = self.motion.pose::<3>(input).err()?;
        Some(self.problem(&unsolved))
    }

    fn readouts(&self) -> Vec<ReadoutId> {
        let mechanism = self.mechanism();
        let angles = self.transmitting.iter().map(|one| one.name(mechanism, 0));
        let quantities = self.quantities.iter().map(|one| one.name(mechanism, 0));
        [INPUT.to_owned()]
            .into_iter()
            .chain(angles)
            .map(ReadoutId::value)
            .chain(quantities.flat_map(|name| ReadoutId::rates(&name)))
            .collect()
    }

    fn advance(&self, input: f64, by: f64) -> (f64, f64) {
        self.motion.cycle().advance(input, by)
    }

    fn chart(&self, _around: f64) -> Cow<'_, Chart> {
        let chart = || match &self.plotted_forces[..] {
            [] => self.figure.chart(&self.plotted, self.settings),
            forces => self.chart_of_forces(forces),
        };
        Cow::Borrowed(self.chart.get_or_init(chart))
    }

    fn against(&self, _around: f64) -> Option<Cow<'_, Against>> {
        let pair = self.pair?;
        let against = || {
            let kinematic = (pair.x.map(Column::kinematic), pair.y.kinematic());
            match kinematic {
                (x @ (None | Some(Some(_))), Some(y)) => {
                    self.figure.against(x.flatten(), y, self.settings)
                }
                _ => self.against_with_forces(pair),
            }
        };
        Some(Cow::Borrowed(self.against.get_or_init(against)))
    }

    fn numbers(&self) -> &BTreeMap<String, String> {
        &self.numbers
    }

    fn table(&self, steps: u32) -> SweepTable {
        SweepTable::of(self, steps)
    }
}
