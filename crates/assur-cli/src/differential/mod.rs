//! The command `differential`: speeds, ratios and conditions of an epicyclic train from numbers of teeth or poles.

mod lines;
mod words;

use std::io::Write;

use assur::gears::train::{
    Condition, ConditionKind, Counts, Coupling, Differential, Drive, Input, Kind, Layout, Member,
    Ratio, Shaft, Shafts, Train, TrainError,
};
use clap::Args;
use serde_json::{Map, Value, json};

use crate::Failure;
use crate::words::number;

/// Maximum number of suggested trains.
const SUGGESTIONS: usize = 5;

/// Arguments of `assur differential`.
#[derive(Args)]
pub(crate) struct Asked {
    /// Teeth or poles of the sun.
    #[arg(long, value_parser = number, value_name = "N", allow_hyphen_values = true)]
    z1: f64,
    /// Teeth or poles of the ring (with --bevel: of the second side wheel)
    #[arg(long, value_parser = number, value_name = "N", allow_hyphen_values = true)]
    z4: f64,
    /// Teeth or poles of the satellite [default: (z4 - z1)/2, for gears in contact]
    #[arg(long, value_parser = number, value_name = "N", allow_hyphen_values = true)]
    z2: Option<f64>,
    /// Teeth or poles of a stepped satellite's second wheel, which meshes with the ring.
    #[arg(
        value_parser = number,
        long,
        value_name = "N",
        allow_hyphen_values = true,
        requires = "z2",
        conflicts_with = "bevel"
    )]
    z2_step: Option<f64>,
    /// Bevel wheels: sun and ring are the two side wheels, of equal or different size.
    #[arg(long, requires = "z2")]
    bevel: bool,
    /// Speed of the sun, in any unit; 0 holds it.
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    w1: Option<f64>,
    /// Speed of the carrier.
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    w3: Option<f64>,
    /// Speed of the ring.
    #[arg(long, value_parser = number, value_name = "X", allow_hyphen_values = true)]
    w4: Option<f64>,
    /// Speed of a shaft as a multiple of another's: 4/1=0.5 makes the ring half as fast as the sun.
    #[arg(long = "tie", value_name = "I/J=K", value_parser = tie)]
    ties: Vec<Input>,
    /// Number of satellites, 1 to 6.
    #[arg(
        value_parser = number,
        long,
        value_name = "K",
        default_value_t = 1.0,
        allow_hyphen_values = true
    )]
    satellites: f64,
    /// Module: a wheel's diameter divided by its number of teeth or poles.
    #[arg(
        value_parser = number,
        long,
        value_name = "M",
        default_value_t = 1.0,
        allow_hyphen_values = true
    )]
    module: f64,
    /// Distance of the satellites' axes from the main axis, for magnets [default: the one with equal gaps]
    #[arg(
        value_parser = number,
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        requires = "z2"
    )]
    axis_distance: Option<f64>,
    /// Kind of coupling whose conditions are shown, contact or magnets [default: magnets with --axis-distance, else
    /// contact if the gears can mesh, with or without profile shift, else both]
    #[arg(long, value_name = "KIND", value_parser = coupling)]
    coupling: Option<Coupling>,
    /// Prints JSON.
    #[arg(long)]
    json: bool,
}

fn coupling(text: &str) -> Result<Coupling, String> {
    match text {
        "contact" => Ok(Coupling::Contact),
        "magnets" => Ok(Coupling::Magnetic),
        _ => Err("a coupling is contact or magnets".to_owned()),
    }
}

/// Parses the ratio of two shaft speeds.
fn tie(text: &str) -> Result<Input, String> {
    let shaft = |number: &str| {
        Shaft::ALL
            .into_iter()
            .find(|shaft| shaft.number().to_string() == number.trim())
    };
    let parts = text.split_once('=').and_then(|(shafts, factor)| {
        let (of, to) = shafts.split_once('/')?;
        Some((shaft(of)?, shaft(to)?, factor.trim().parse().ok()?))
    });
    let (shaft, to, factor) = parts.ok_or("a tie is as 4/1=0.5, of the shafts 1, 3 and 4")?;
    let drive = Drive::Tied { to, factor };
    Ok(Input { shaft, drive })
}

impl Asked {
    /// Builds the train. Returns none if no satellite is given and no satellite allows gears in contact.
    fn train(&self) -> Result<Option<Train>, Vec<TrainError>> {
        let Self { z1, z4, .. } = *self;
        match (self.z2, self.z2_step) {
            (None, _) => Train::in_contact([z1, z4]),
            (Some(z2), Some(step)) => Train::stepped([z1, z2, step, z4]).map(Some),
            (Some(z2), None) if self.bevel => Train::bevel([z1, z2, z4]).map(Some),
            (Some(z2), None) => Train::planar([z1, z2, z4]).map(Some),
        }
    }

    /// Returns the kinds of coupling whose conditions the text report shows.
    fn couplings(&self, layout: &Layout) -> Vec<Coupling> {
        let both = [Coupling::Contact, Coupling::Magnetic];
        let coaxial = layout.conditions(Coupling::Contact);
        let coaxial = coaxial
            .iter()
            .find(|one| one.kind == ConditionKind::Coaxiality);
        let meshes = coaxial.is_some_and(|one| one.met() || one.within_profile_shift());
        match self.coupling {
            Some(coupling) => vec![coupling],
            None if self.axis_distance.is_some() => vec![Coupling::Magnetic],
            None if meshes => vec![Coupling::Contact],
            None => both.to_vec(),
        }
    }

    fn inputs(&self) -> Vec<Input> {
        let speeds = Shaft::ALL.into_iter().zip([self.w1, self.w3, self.w4]);
        let given = speeds.filter_map(|(shaft, speed)| {
            let drive = Drive::Given(speed?);
            Some(Input { shaft, drive })
        });
        given.chain(self.ties.iter().copied()).collect()
    }
}

/// Writes the report, as text or as JSON.
///
/// # Errors
/// Invalid numbers or an impossible train; inputs that do not determine the motion; output that cannot be written.
pub(crate) fn write(out: &mut impl Write, asked: &Asked) -> Result<(), Failure> {
    let told = told(asked).map_err(|sentences| Failure::Input(sentences.join("\n")))?;
    if asked.json {
        writeln!(out, "{:#}", Value::Object(told))?;
    } else {
        lines::write(out, &told)?;
    }
    Ok(())
}

/// Builds the report, or lists the reasons why there is none.
fn told(asked: &Asked) -> Result<Map<String, Value>, Vec<String>> {
    let of_train = |errors: Vec<TrainError>| -> Vec<String> {
        errors.iter().map(words::train_error).collect()
    };
    let sentences = |error: TrainError| vec![words::train_error(&error)];
    let train = asked.train().map_err(of_train)?;
    let layout = train.map(|train| {
        let Asked {
            satellites,
            module,
            axis_distance,
            ..
        } = *asked;
        Layout::new(train, satellites, module, axis_distance)
    });
    let layout = layout.transpose().map_err(of_train)?;
    let counts = Counts::new(asked.satellites).map_err(sentences)?;
    let differential = match train {
        Some(train) => train.differential(),
        None => Differential::planar([asked.z1, asked.z4]).map_err(of_train)?,
    };
    let speeds = differential
        .solve(&asked.inputs())
        .map_err(|errors| errors.iter().map(words::input_error).collect::<Vec<_>>())?;
    let mut told = Map::new();
    let mut tell = |fields: Value| {
        if let Value::Object(mut fields) = fields {
            told.append(&mut fields);
        }
    };
    // Both numbers were checked above to be whole.
    let [z1, z4] = [asked.z1, asked.z4].map(|teeth| teeth as u32);
    tell(json!({"z1": z1, "z4": z4, "satellites": counts.satellites}));
    tell(of_speeds(&speeds, train.as_ref()));
    tell(of_differential(&differential));
    tell(of_counts(&counts));
    tell(match &layout {
        Some(layout) => {
            let mut fields = of_layout(layout, &speeds);
            fields["couplings"] = couplings(&asked.couplings(layout));
            fields["notes"] = notes(layout);
            fields
        }
        None => {
            let assembly = conditions(&[differential.assembly(counts.satellites)]);
            json!({
                "z2": null,
                "couplings": couplings(asked.coupling.as_slice()),
                "notes": [words::NO_CONTACT],
                "conditions": {"contact": assembly.clone(), "magnets": assembly},
            })
        }
    });
    Ok(told)
}

/// Returns the speeds; those of the satellite are null if no satellite is known.
fn of_speeds(speeds: &Shafts, train: Option<&Train>) -> Value {
    let spin = train.map(|train| train.spin(speeds));
    json!({
        "w1": speeds.sun,
        "w3": speeds.carrier,
        "w4": speeds.ring,
        "w2": spin.map(|spin| spin.along),
        "w2_across": spin.map(|spin| spin.across).filter(|_| train.is_some_and(|t| t.kind() == Kind::Bevel)),
        "w2_to_carrier": spin.map(|spin| spin.relative),
    })
}

fn of_differential(differential: &Differential) -> Value {
    let ratios = differential.ratios();
    let named = |value: fn(&Ratio) -> Value| -> Value {
        let all = ratios.iter().map(|ratio| (ratio.to_string(), value(ratio)));
        Value::Object(all.collect())
    };
    let largest = ratios.iter().filter(|ratio| differential.is_largest(ratio));
    let identities = differential.identities().map(|identity| {
        let (numerator, denominator) = identity.sum();
        json!({
            "terms": identity.terms.map(|term| term.to_string()),
            "sum": numerator as f64 / denominator as f64,
        })
    });
    json!({
        "ratios": named(|ratio| json!(ratio.value())),
        "fractions": named(|ratio| json!([ratio.numerator, ratio.denominator])),
        "largest": largest.map(Ratio::to_string).collect::<Vec<_>>(),
        "identities": identities,
        "torques": {
            "1": differential.weight(Shaft::Sun),
            "3": differential.weight(Shaft::Carrier),
            "4": differential.weight(Shaft::Ring),
        },
    })
}

fn of_counts(counts: &Counts) -> Value {
    json!({
        "mobility": counts.mobility() + counts.passive(),
        "n": counts.links,
        "p1": counts.one_freedom,
        "p2": counts.two_freedoms,
        "w_counted": counts.mobility(),
        "passive": counts.passive(),
    })
}

fn of_layout(layout: &Layout, speeds: &Shafts) -> Value {
    let train = layout.train();
    let both = |value: &dyn Fn(Coupling) -> Value| json!({"contact": value(Coupling::Contact), "magnets": value(Coupling::Magnetic)});
    let stepped = train.kind() == Kind::Stepped;
    json!({
        "z2": train.teeth(Member::Satellite),
        "z2_step": stepped.then(|| train.teeth(Member::Step)),
        "axis_distance": both(&|coupling| json!(layout.axis_distance(coupling))),
        "gaps": layout.gaps(),
        "conditions": both(&|coupling| conditions(&layout.conditions(coupling))),
        "can_be_built": both(&|coupling| json!(layout.can_be_built(coupling))),
        "suggestions": both(&|coupling| {
            let suggestions = layout.suggestions(coupling, SUGGESTIONS);
            suggestions.iter().map(|found| teeth(&found.train)).collect()
        }),
        "velocities": both(&|coupling| {
            layout.velocities(coupling, speeds).map_or(Value::Null, |found| {
                let points = [found.sun, found.centre, found.ring];
                json!({
                    "radius": points.map(|point| point.radius),
                    "velocity": points.map(|point| point.velocity),
                    "instantaneous_centre": found.instantaneous_centre,
                })
            })
        }),
    })
}

/// Returns the names of these kinds of coupling, or of both kinds if the list is empty.
fn couplings(all: &[Coupling]) -> Value {
    let name = |coupling: &Coupling| match coupling {
        Coupling::Contact => "contact",
        Coupling::Magnetic => "magnets",
    };
    match all {
        [] => json!(["contact", "magnets"]),
        all => all.iter().map(name).collect(),
    }
}

/// Returns notes on gears that mesh only with profile shift.
fn notes(layout: &Layout) -> Value {
    let conditions = layout.conditions(Coupling::Contact).into_iter();
    let shifted = conditions.filter(Condition::within_profile_shift);
    shifted
        .map(|one| words::shifted(one.left - one.right))
        .collect()
}

fn teeth(train: &Train) -> Value {
    let mut teeth = json!({
        "z1": train.teeth(Member::Sun),
        "z2": train.teeth(Member::Satellite),
        "z4": train.teeth(Member::Ring),
    });
    if train.kind() == Kind::Stepped {
        teeth["z2_step"] = json!(train.teeth(Member::Step));
    }
    teeth
}

fn conditions(all: &[Condition]) -> Value {
    let named = all.iter().map(|condition| {
        let told = json!({
            "met": condition.met(),
            "left": condition.left,
            "relation": words::relation(condition.relation),
            "right": condition.right,
        });
        (condition.kind.code().to_owned(), told)
    });
    Value::Object(named.collect())
}
