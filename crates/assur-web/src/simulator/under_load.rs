//! Motion under load.

use super::*;

#[wasm_bindgen]
impl Simulator {
    /// Begins a run of the motion under load at an input and a rate; an earlier run ends. The run keeps its linkage if
    /// the document changes.
    ///
    /// # Errors
    /// The reasons why there is none: no linkage, a defect of the loads or the motor, no pose.
    #[wasm_bindgen(js_name = startRun)]
    pub fn start_run(&self, input: f64, rate: f64) -> Result<(), JsValue> {
        let run = self.linkage()?.run(input, rate).map_err(thrown)?;
        self.run.replace(Some(run));
        Ok(())
    }

    /// Advances the run to a time, in seconds since its start, with a number of readings at equal intervals.
    ///
    /// # Errors
    /// No run; a time that is not a number.
    #[wasm_bindgen(js_name = advanceRun, unchecked_return_type = "RunHere")]
    pub fn advance_run(&self, time: f64, count: u32) -> Result<JsValue, JsValue> {
        let mut run = self.run.borrow_mut();
        let run = run.as_mut().filter(|_| time.is_finite() && count > 0);
        let run = run.ok_or_else(|| one(unknown("time")))?;
        Ok(to_js(&run.advance(time, count)))
    }

    /// The steady cycle near a rate, and the flywheels for a coefficient of non-uniformity. It takes up to a second, so
    /// the page asks for it in a worker.
    ///
    /// # Errors
    /// The reasons why there is none: no linkage, a defect of the loads or the motor, a bad coefficient, no cycle.
    #[wasm_bindgen(unchecked_return_type = "CycleHere")]
    pub fn cycle(&self, rate: f64, non_uniformity: f64) -> Result<JsValue, JsValue> {
        let cycle = self.linkage()?.cycle(rate, non_uniformity);
        Ok(to_js(&cycle.map_err(thrown)?))
    }
}
