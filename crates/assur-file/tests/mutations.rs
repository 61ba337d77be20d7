//! Three hundred damaged states: each is refused with a problem that names a part, or can be shown. None causes a
//! panic.

use assur::gears::Mate;
use assur::mixer::{Carrier, Case, Tracer};
use assur_file::{MixerDocument, Problem, State};
use serde_json::{Value, json};

fn good() -> Value {
    let mut dimensions = Case::A.dimensions();
    dimensions.wheels.push(Mate {
        teeth: 24.0,
        centre_line: 1.0,
    });
    dimensions.tracers.push(Tracer {
        carrier: Carrier::Wheel(1),
        x: 0.3,
        y: 0.2,
    });
    json!({
        "format": 1,
        "lesson": "mixer",
        "document": MixerDocument::new(&dimensions),
        "view": {
            "phi_deg": 62, "playing": false, "direction": 1,
            "speed": 1, "traces": true, "lang": "en",
            "plot": "C2", "only": "second", "axes": "physical", "omega": 2, "omega_unit": "per_min",
            "epsilon": 0.5, "true_time": true, "differenced": true,
        },
    })
}

fn problems(text: &str) -> Vec<Problem> {
    match State::parse(text) {
        Err(problem) => vec![problem],
        Ok(state) => state.moved().err().unwrap_or_default(),
    }
}

/// Collects the paths of a value, beginning with the whole, and of everything in it.
fn paths(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_owned());
    for (key, inner) in value.as_object().into_iter().flatten() {
        paths(inner, &format!("{at}/{key}"), all);
    }
    for (index, inner) in value.as_array().into_iter().flatten().enumerate() {
        paths(inner, &format!("{at}/{index}"), all);
    }
}

#[test]
fn three_hundred_damaged_states_are_refused() {
    let whole = good();
    assert_eq!(problems(&whole.to_string()), []);
    let mut places = Vec::new();
    paths(&whole, "", &mut places);
    let bad = [
        json!(null),
        json!([]),
        json!([[[{}]]]),
        json!({"__proto__": {"l1": 1}}),
        json!({"constructor": 1}),
        json!("<img src=x onerror=alert(1)>"),
        json!("9".repeat(100_000)),
        json!(1e300),
        json!(-0.5),
        json!(1e-320),
    ];
    let mut refused = 0;
    let mut see = |text: &str| {
        for problem in problems(text) {
            let said = serde_json::to_value(&problem).unwrap();
            assert!(said["code"].is_string(), "{said}");
            // A problem must not repeat text from the damaged state.
            let named = said["field"].as_str().or(said["path"].as_str());
            assert!(named.is_none_or(|name| !name.contains('<')), "{said}");
        }
        refused += usize::from(!problems(text).is_empty());
    };
    let mut harmless = 0;
    for place in &places {
        for value in &bad {
            let mut state = whole.clone();
            *state.pointer_mut(place).unwrap() = value.clone();
            // Any text may be a language; the centre line and the crank may have any angle.
            let text = place == "/view/lang" && value.is_string();
            let angle = place.ends_with("_deg") && value.is_number();
            let slow = place == "/view/speed" && *value == json!(1e-320);
            // ε₁ may be any number that is not too large; ω₁ may be any such number except zero.
            let input = ["/view/omega", "/view/epsilon"].contains(&place.as_str());
            let input = input && value.as_f64().is_some_and(|x| x.abs() < 1e4);
            // A traced point may have any coordinates within reach, and the list of traced points may be empty.
            let near = value.as_f64().is_some_and(|value| value.abs() < 1.0);
            let point = near
                && ["/tracers/0/x", "/tracers/0/y"]
                    .iter()
                    .any(|end| place.ends_with(end));
            let pointless = place == "/document/tracers" && *value == json!([]);
            harmless += usize::from(text || slow || input || point || pointless);
            if !angle {
                see(&state.to_string());
            }
        }
    }
    let text = whole.to_string();
    let cuts = (0..text.len()).step_by(2);
    let count = cuts.clone().count();
    cuts.for_each(|end| see(&text[..end]));
    let total = places.len() * bad.len() - 3 * 3 + count;
    assert!(total >= 300, "{total}");
    assert_eq!(refused, total - harmless);
}
