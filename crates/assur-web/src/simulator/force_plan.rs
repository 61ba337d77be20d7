//! Force plans, Zhukovsky's lever and free bodies.

use super::*;
use crate::convert::read_value;
use crate::equilibrium::StudentSheet;

#[wasm_bindgen]
impl Simulator {
    /// The force plan at an input, at ω₁ and ε₁ of the view: all steps, but the picture of only the step `shown`, from 1.
    ///
    /// # Errors
    /// The reasons why there is none: no linkage, a defect of the loads, no pose, no equilibrium.
    #[wasm_bindgen(js_name = forcePlan, unchecked_return_type = "ForcePlanHere")]
    pub fn force_plan(&self, input: f64, shown: usize) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.force_plan(input, shown);
        Ok(to_js(&here.map_err(thrown)?))
    }

    /// Zhukovsky's lever at an input, at ω₁ and ε₁ of the view.
    ///
    /// # Errors
    /// Those of `forcePlan`.
    #[wasm_bindgen(js_name = forceLever, unchecked_return_type = "LeverHere")]
    pub fn force_lever(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.force_lever(input);
        Ok(to_js(&here.map_err(thrown)?))
    }

    /// All forces and couples on a moving link at an input, at ω₁ and ε₁ of the view. `link` is its place among `links` of the
    /// result.
    ///
    /// # Errors
    /// Those of `forcePlan`.
    #[wasm_bindgen(js_name = freeBody, unchecked_return_type = "FreeBodyHere")]
    pub fn free_body(&self, input: f64, link: usize) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.free_body(input, link);
        Ok(to_js(&here.map_err(thrown)?))
    }

    /// The equations of equilibrium of a link at an input, in the senses and about the point that a student has chosen,
    /// with the judgement of what the student has filled in; null if there is no such link.
    ///
    /// # Errors
    /// Those of `forcePlan`; a malformed sheet.
    #[wasm_bindgen(unchecked_return_type = "EquilibriumHere | null")]
    pub fn equilibrium(
        &self,
        input: f64,
        #[wasm_bindgen(unchecked_param_type = "StudentSheet")] sheet: JsValue,
    ) -> Result<JsValue, JsValue> {
        let sheet: StudentSheet = read_value(&sheet)?;
        let here = self.linkage()?.equilibrium(input, &sheet);
        Ok(to_js(&here.map_err(thrown)?))
    }
}
