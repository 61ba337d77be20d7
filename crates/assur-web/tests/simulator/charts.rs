//! Plots.

use super::*;

/// Returns the layout of a chart of 400 by 600 pixels, and the context on which it was drawn. `extra` is added to the
/// request.
fn chart(simulator: &Simulator, extra: &str) -> (JsValue, CanvasRenderingContext2d) {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().unchecked_into();
    canvas.set_width(800);
    canvas.set_height(1200);
    let context = canvas.get_context("2d").unwrap().unwrap();
    let context: CanvasRenderingContext2d = context.unchecked_into();
    context.scale(2.0, 2.0).unwrap();
    let grey = "[200,200,200]";
    let palette: Vec<&str> = assur_web::role_names()
        .iter()
        .map(|name| if name == "rocker" { "[1,2,250]" } else { grey })
        .collect();
    let request = format!(
        r#"{{"width":400,"height":600,"palette":[{}]{extra}}}"#,
        palette.join(",")
    );
    let layout = simulator
        .chart(&context, JSON::parse(&request).unwrap())
        .unwrap();
    (layout, context)
}

/// The plotted quantities, the variable of their derivatives, and the marks on the curves.
#[wasm_bindgen_test]
fn plots_are_chosen() {
    let mut simulator = simulator();
    let crank = 1.0_f64;
    let [.., analogues] = at(&simulator, crank).unwrap();
    assert_eq!(analogues.len(), 6);
    let (layout, _) = chart(&simulator, "");
    let texts = |path: &str, key: &str| -> Vec<String> {
        let list: Array = get(&layout, path).unchecked_into();
        let text = |item: JsValue| get(&item, key).as_string().unwrap();
        list.iter().map(text).collect()
    };
    assert_eq!(
        texts("panels.0.series", "name"),
        ["rocker.angle", "wheel5.angle"]
    );
    // φ₃ and φ₅ oscillate without a zero; each derivative of both has two zeros.
    let zeros = |panel: usize| {
        let kinds = texts(&format!("panels.{panel}.marks"), "kind");
        kinds.iter().filter(|kind| *kind == "zero").count()
    };
    assert_eq!([0, 1, 2].map(zeros), [0, 4, 4]);
    assert_eq!(
        texts("panels.0.marks", "kind"),
        ["min", "max", "max", "min"]
    );
    let limit = number(&layout, "panels.0.marks.0.phi").to_degrees();
    assert!((limit - 23.051_351_3).abs() < 1e-6, "{limit}");

    let state = state();
    put(&state, "view", "axes", "physical".into());
    put(&state, "view", "omega", (-3.0).into());
    put(&state, "view", "epsilon", 2.0.into());
    simulator.set(state.clone()).unwrap();
    let [.., rates] = at(&simulator, crank).unwrap();
    for (analogue, rate) in analogues.chunks(3).zip(rates.chunks(3)) {
        assert_eq!(rate[0], analogue[0]);
        assert_eq!(rate[1], -3.0 * analogue[1]);
        assert_eq!(rate[2], 9.0 * analogue[2] + 2.0 * analogue[1]);
    }

    put(&state, "view", "plot", "C1".into());
    put(&state, "view", "axes", "analogues".into());
    simulator.set(state.clone()).unwrap();
    let [.., plotted] = at(&simulator, crank).unwrap();
    let expected = [
        crank.cos(),
        -crank.sin(),
        -crank.cos(),
        crank.sin(),
        crank.cos(),
        -crank.sin(),
    ];
    for (value, expected) in plotted.iter().zip(expected) {
        assert!((value - 0.185 * expected).abs() < 1e-15);
    }
    assert_eq!(
        get(&chart(&simulator, "").0, "panels.1.kind")
            .as_string()
            .unwrap(),
        "length"
    );

    for (key, value, code) in [
        ("plot", "C9".into(), "unknown_choice"),
        ("omega", JsValue::from_f64(2e4), "out_of_range"),
    ] {
        let bad = self::state();
        put(&bad, "view", key, value);
        let problems = thrown(simulator.set(bad).unwrap_err());
        assert_eq!(problems, [(code.to_owned(), key.to_owned())]);
    }
    assert_eq!(at(&simulator, crank).unwrap()[3], plotted);
}

/// The curves are where the layout says: the pixel of φ₃ at 60° has the colour of the rocker.
#[wasm_bindgen_test]
fn chart_draws_where_its_layout_says() {
    let simulator = simulator();
    let large = chart(&simulator, r#","scale":1.5"#).0;
    assert_eq!(number(&large, "panels.0.left"), 66.0);
    let (layout, context) = chart(&simulator, "");
    assert_eq!(number(&layout, "panels.0.left"), 44.0);
    let crank = 60.0_f64.to_radians();
    let [_, _, values, _] = at(&simulator, crank).unwrap();
    for order in 0..3 {
        let panel = get(&layout, &format!("panels.{order}"));
        let of = |key: &str| number(&panel, key);
        let value = values[place(&simulator, "rocker.angle", order)];
        let x = of("left") + of("width") * (crank - of("x0")) / (of("x1") - of("x0"));
        let y = of("top") + of("height") * (of("y1") - value) / (of("y1") - of("y0"));
        let data = context
            .get_image_data(2.0 * x - 1.0, 2.0 * y - 1.0, 3.0, 3.0)
            .unwrap()
            .data();
        let blue = data
            .chunks(4)
            .filter(|pixel| pixel[2] > 230 && pixel[0] < 40)
            .count();
        assert!(blue >= 4, "{order}: {blue} pixels of the curve at {x}, {y}");
    }
    let bad = simulator.chart(&context, JSON::parse(r#"{"width":-4}"#).unwrap());
    assert_eq!(thrown(bad.unwrap_err())[0].0, "bad_state");
}
