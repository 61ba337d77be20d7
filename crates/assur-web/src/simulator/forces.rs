//! Forces and motion under load.

use super::*;

#[wasm_bindgen]
impl Simulator {
    /// Reactions of all pairs at an input, at ω₁ and ε₁ of the view.
    ///
    /// # Errors
    /// The reasons why there are none: no linkage, a defect of the loads, no pose, no equilibrium.
    #[wasm_bindgen(unchecked_return_type = "ForcesHere")]
    pub fn forces(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.forces_at(input);
        Ok(to_js(&here.map_err(thrown)?))
    }
}
