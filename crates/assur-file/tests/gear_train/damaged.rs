//! Damaged documents.

use super::*;

/// Collects the paths of a value and of everything in it.
fn places(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_owned());
    for (key, inner) in value.as_object().into_iter().flatten() {
        places(inner, &format!("{at}/{key}"), all);
    }
    for (index, inner) in value.as_array().into_iter().flatten().enumerate() {
        places(inner, &format!("{at}/{index}"), all);
    }
}

#[test]
fn damaged_documents_are_refused_or_move() {
    let mut whole = written();
    let full = json!({
        "title": "A", "source": "B", "form": "planar", "satellites": 3, "coupling": "magnetic", "module_mm": 4,
        "axis_distance_mm": 63, "observer": "ground", "loaded": true, "span_s": 1, "load": [[0.1, 0], [0.2, 5]],
        "magnets": {"poles": "alike", "peak": [2, 5], "damping": [0.01, 0.02]},
        "bodies": {"inertia": [1e-3, 2e-4, 2e-3, 5e-3], "mass": 0.3, "damping": [0, 0, 0, 0]},
        "members": {"satellite": {"kind": "fan", "torque": 0.1}, "carrier": {"kind": "brush", "torque": 1}},
    });
    for (key, value) in full.as_object().unwrap() {
        whole[key] = value.clone();
    }
    whole["drives"][1] =
        json!({"shaft": "ring", "rpm": 5, "start_s": 1, "to": "sun", "factor": 0.5});
    assert!(
        serde_json::from_value::<GearTrainDocument>(whole.clone())
            .unwrap()
            .train()
            .is_ok()
    );
    let mut all = Vec::new();
    places(&whole, "", &mut all);
    let bad = [
        json!(null),
        json!([]),
        json!({}),
        json!("sun"),
        json!("bevel"),
        json!("stepped"),
        json!("contact"),
        json!("alternating"),
        json!("carrier"),
        json!(true),
        json!(false),
        json!(1e300),
        json!(-1e300),
        json!(0),
        json!(-0.5),
        json!(1e-320),
        json!(1e6),
        json!(5),
        json!(1e-9),
        json!("9".repeat(1000)),
    ];
    let (mut tried, mut good) = (0, 0);
    for place in &all {
        for value in &bad {
            let mut damaged = whole.clone();
            *damaged.pointer_mut(place).unwrap() = value.clone();
            tried += 1;
            let Ok(document) = serde_json::from_value::<GearTrainDocument>(damaged) else {
                continue;
            };
            match document.train() {
                Ok(train) => {
                    good += 1;
                    for time in [0.0, 0.7, 1e6] {
                        let at = train.turning.at(time);
                        let numbers = at.speeds.iter().chain(&at.accelerations);
                        assert!(numbers.copied().all(f64::is_finite), "{place} {value}");
                        assert!(at.angles.iter().all(|angle| angle.radians().is_finite()));
                    }
                    let Some(differential) = &train.differential else {
                        continue;
                    };
                    match train.run(differential) {
                        Ok(mut run) => {
                            let _ = run.advance(2);
                            let reading = run.reading();
                            let bodies = reading.bodies.iter();
                            assert!(bodies.clone().all(|body| body.speed.is_finite()));
                            assert!(
                                bodies.clone().all(|body| body.acceleration.is_finite()),
                                "{place} {value}"
                            );
                        }
                        Err(problems) => once(&problems, place, value),
                    }
                }
                Err(problems) => once(&problems, place, value),
            }
        }
    }
    assert!(tried > 900 && good > 100, "{tried} {good}");
}

/// Checks that there is a problem, and that no problem is reported twice.
fn once(problems: &[Problem], place: &str, value: &Value) {
    assert!(!problems.is_empty(), "{place} {value}");
    for (at, problem) in problems.iter().enumerate() {
        assert!(
            !problems[..at].contains(problem),
            "{place} {value}: {problems:?}"
        );
    }
}
