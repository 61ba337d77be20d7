//! Outputs, transmission angles, dwell, equations, curvature and polygons of a linkage.

use super::*;

#[wasm_bindgen]
impl Simulator {
    /// Ranges, limit positions and time ratios of the outputs of a linkage over its motion.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(unchecked_return_type = "OutputSummary[]")]
    pub fn outputs(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&OutputSummary::all(self.linkage()?)))
    }

    /// The worst transmission or pressure angle of each dyad of a linkage over its motion.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(unchecked_return_type = "TransmissionSummary[]")]
    pub fn transmissions(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&TransmissionSummary::all(self.linkage()?)))
    }

    /// Stroke, longest dwell and phases of the first plotted quantity of a linkage; `null` if it is not an output or
    /// was not searched for extrema.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(unchecked_return_type = "ProfileSummary | null")]
    pub fn profile(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&ProfileSummary::of(self.linkage()?)))
    }

    /// The constraint equations of a linkage: the kind of each, with its links and points.
    ///
    /// # Errors
    /// A document that is not a moving linkage.
    #[wasm_bindgen(unchecked_return_type = "EquationSummary[]")]
    pub fn constraints(&self) -> Result<JsValue, JsValue> {
        Ok(to_js(&EquationSummary::all(self.linkage()?.mechanism())))
    }

    /// Left side, right side and residual of every constraint equation at an input, in the order of `constraints`;
    /// with order 1 or 2, their derivatives with respect to the input.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or unbounded derivatives.
    pub fn equations(&self, input: f64, order: usize) -> Result<Vec<f64>, JsValue> {
        self.linkage()?.equations(input, order).map_err(one)
    }

    /// Relations of the paper that describes the document, with their values at an input:
    /// `[{item, name, angle, turned, count, value, printed}]`, in the order of the paper.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or unbounded derivatives.
    #[wasm_bindgen(unchecked_return_type = "RelationHere[]")]
    pub fn relations(&self, input: f64) -> Result<JsValue, JsValue> {
        let relations = self.document()?.relations(input).map_err(one)?;
        let here: Vec<RelationHere> = relations.into_iter().map(Into::into).collect();
        Ok(to_js(&here))
    }

    /// Values of the drawn circles of curvature: `{circles: [{point, radius, centre, reason}],
    /// inflection: {link, diameter, reason}}`. If there is no circle, `reason` is the problem.
    ///
    /// # Errors
    /// The reason why there are none: no linkage, no pose, or unbounded derivatives.
    #[wasm_bindgen(unchecked_return_type = "CurvatureHere")]
    pub fn curvature(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.curvature(input).map_err(one)?;
        Ok(to_js(&here))
    }

    /// The polygons of velocities and accelerations at an input: `{steps, pictures}`, with all steps of their
    /// construction, but pictures of only the first `shown` steps.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or unbounded derivatives.
    #[wasm_bindgen(unchecked_return_type = "PolygonsHere")]
    pub fn polygons(&self, input: f64, shown: usize) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.polygons(input, shown);
        Ok(to_js(&here.map_err(one)?))
    }
}
