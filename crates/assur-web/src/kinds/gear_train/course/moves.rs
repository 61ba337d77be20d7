//! A gear train as a document that moves with time.

use super::*;

impl Moves for GearTrain {
    fn at(&self, input: f64) -> Result<Here, Problem> {
        let input = on_axis(input);
        let known = self.course.known(input);
        let rates = |quantity| known.rates(quantity);
        let rest = known.reading.iter().flat_map(of_run);
        Ok(Here {
            frame: self.figure.frame(&self.course.pose(&known)),
            handles: Vec::new(),
            readouts: [input]
                .into_iter()
                .chain(self.course.quantities().flat_map(rates))
                .chain(rest)
                .collect(),
            plotted: self.course.on_plots(input, &known),
        })
    }

    fn plotted_at(&self, input: f64) -> Result<Vec<f64>, Problem> {
        Ok(self.course.on_plots(input, &self.course.known(input)))
    }

    fn why(&self, _input: f64) -> Option<Problem> {
        None
    }

    fn readouts(&self) -> Vec<ReadoutId> {
        let quantities = self.course.quantities().map(|one| one.name());
        [ReadoutId::value(INPUT.to_owned())]
            .into_iter()
            .chain(quantities.flat_map(|name| ReadoutId::rates(&name)))
            .chain(self.course.names_of_run().map(ReadoutId::value))
            .collect()
    }

    /// A run under load begins again after its end. Without load, time goes on to its limit, and a negative time is
    /// reflected at 0.
    fn advance(&self, input: f64, by: f64) -> (f64, f64) {
        let next = input + by;
        if !next.is_finite() {
            (0.0, 1.0)
        } else if self.course.loaded() {
            // A run that halts at its start has no length to repeat.
            let end = self.course.end();
            (if end > 0.0 { next.rem_euclid(end) } else { 0.0 }, 1.0)
        } else if next < 0.0 {
            (-next, -1.0)
        } else {
            (next.min(Turning::MAX_TIME), 1.0)
        }
    }

    fn chart(&self, around: f64) -> Cow<'_, Chart> {
        match &self.course.chart {
            Some(chart) => Cow::Borrowed(chart),
            None => Cow::Owned(self.course.plotted_around(around)),
        }
    }

    fn against(&self, around: f64) -> Option<Cow<'_, Against>> {
        let course = &self.course;
        let pair = course.pair.as_ref()?;
        Some(match &course.against {
            Some(against) => Cow::Borrowed(against),
            None => Cow::Owned(course.plotted_against(pair, &course.around(around).1)),
        })
    }

    fn numbers(&self) -> &BTreeMap<String, String> {
        self.course.numbers()
    }

    fn table(&self, steps: u32) -> SweepTable {
        let steps = steps.max(1);
        let row = |step: u32| {
            let input = self.course.end() * f64::from(step) / f64::from(steps);
            let known = self.course.known(input);
            let quantities = self.course.quantities();
            let rates = quantities.flat_map(|one| known.rates(one));
            let rest = known.reading.iter().flat_map(of_run);
            SweepRow {
                input,
                values: rates.chain(rest).map(Some).collect(),
                reason: None,
            }
        };
        let columns = self.course.quantities().flat_map(Quantity::columns);
        let columns = columns.chain(self.course.names_of_run());
        SweepTable {
            dimensions: Vec::new(),
            columns: columns.map(SweepColumn::named).collect(),
            rows: (0..=steps).map(row).collect(),
            compared: None,
        }
    }
}
