//! Forces and motion under load.

use super::*;

#[wasm_bindgen]
impl Simulator {
    /// Reactions, torques and forces of the drivers, and applied forces at an input, at the rate and acceleration of the
    /// input in the view.
    ///
    /// # Errors
    /// The reason why there are none: no linkage, no pose, or unbounded reactions.
    #[wasm_bindgen(unchecked_return_type = "ForcesHere")]
    pub fn forces(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.forces_at(input);
        Ok(to_js(&here.map_err(thrown)?))
    }

    /// The greatest values of the reactions, of the drivers' torques and forces and of the shaking force over the
    /// motion, each with its input.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(js_name = greatestForces, unchecked_return_type = "GreatestForces")]
    pub fn greatest_forces(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(self.linkage()?.greatest_forces()))
    }

    /// Whether a force is plotted, in place of quantities of the motion.
    #[wasm_bindgen(js_name = plotsForces)]
    pub fn plots_forces(&self) -> bool {
        let document = self.document.as_ref();
        let linkage = document.and_then(|document| document.linkage());
        linkage.is_some_and(Moving::plots_forces)
    }

    /// Masses, centres of mass and moments of inertia of the moving links.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(unchecked_return_type = "MassHere[]")]
    pub fn masses(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.linkage()?.masses()))
    }
}
