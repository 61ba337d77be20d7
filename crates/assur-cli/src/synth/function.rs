//! A wanted function y = f(x) in place of positions.

use assur_file::{FormulaDocument, FunctionDocument, Wanted};
use clap::Args;

use super::Degrees;
use crate::Failure;
use crate::words::Words;

/// Arguments of a wanted function.
#[derive(Args)]
pub(crate) struct OnFunction {
    /// A function y = f(x) instead of positions: log10, exp, sin (x in degrees), x^P with a number P, or a file with x
    /// and y in each line. x is mapped linearly to the angle of the driver, y to that of the output link.
    #[arg(long, value_name = "F", requires_all = ["input", "output"])]
    function: Option<String>,
    /// Interval of x [default for a file: from its first line to its last]
    #[arg(long, requires = "function", value_name = "X0,X1", value_parser = pair, allow_hyphen_values = true)]
    x: Option<[f64; 2]>,
    /// Angles of the driver at the ends of --x, degrees from the x-axis.
    #[arg(long, requires = "function", value_name = "PHI3,PHI3", value_parser = pair, allow_hyphen_values = true)]
    input: Option<[f64; 2]>,
    /// Angles of the output link at the ends of --x, measured as for --position.
    #[arg(long, requires = "function", value_name = "PHI2,PHI2", value_parser = pair, allow_hyphen_values = true)]
    output: Option<[f64; 2]>,
    /// Number of positions on the function, in Chebyshev spacing.
    #[arg(
        id = "count",
        long = "positions",
        value_name = "N",
        default_value_t = 3
    )]
    count: usize,
    /// Spaces the positions on the function at equal steps of x, including the ends.
    #[arg(long, requires = "function")]
    even: bool,
}

/// Fields of the document, each with the option that sets it.
const OPTIONS: [(&str, &str); 4] = [
    ("function.of", "--function"),
    ("function.x", "--x"),
    ("function.input_deg", "--input"),
    ("function.output_deg", "--output"),
];

fn pair(text: &str) -> Result<[f64; 2], String> {
    numbers(text).ok_or_else(|| "two numbers are wanted, as 1,2".to_owned())
}

/// Parses two numbers separated by a comma, a semicolon or spaces.
fn numbers(text: &str) -> Option<[f64; 2]> {
    let parts = text.split([',', ';', ' ', '\t']);
    let parts = parts.filter(|part| !part.is_empty()).map(str::parse);
    let parts: Result<Vec<f64>, _> = parts.collect();
    parts.ok()?.try_into().ok()
}

impl OnFunction {
    /// Returns the wanted function and the positions on it, if a function is given.
    ///
    /// # Errors
    /// An invalid function; a file that cannot be read.
    pub(super) fn wanted(&self) -> Result<Option<(Vec<Degrees>, Wanted)>, Failure> {
        let (Some(name), Some(input_deg), Some(output_deg)) =
            (&self.function, self.input, self.output)
        else {
            return Ok(None);
        };
        let of = formula(name)?;
        let x = match (self.x, &of) {
            (Some(x), _) => x,
            (None, FormulaDocument::Table(rows)) if !rows.is_empty() => {
                [rows[0][0], rows[rows.len() - 1][0]]
            }
            _ => return Err(Failure::Input("--function: --x is missing".to_owned())),
        };
        let function = FunctionDocument {
            of,
            x,
            input_deg,
            output_deg,
        };
        let positions = function.positions(self.count, self.even);
        let made = positions.and_then(|positions| Ok((positions, function.wanted()?)));
        let (positions, wanted) = match made {
            Ok(made) => made,
            Err(problems) => {
                let words = Words::english()?;
                let said = problems.iter().map(|problem| words.sentence(problem));
                let said: Vec<String> = said.collect::<Result<_, _>>()?;
                let mut said = said.join("\n");
                for (field, option) in OPTIONS {
                    said = said.replace(field, option);
                }
                return Err(Failure::Input(said));
            }
        };
        let degrees = positions.iter().map(|position| Degrees {
            output: position.output_deg,
            input: position.input_deg,
            weight: position.weight,
        });
        Ok(Some((degrees.collect(), wanted)))
    }
}

/// Returns the named function, or the table in the file of this name.
fn formula(name: &str) -> Result<FormulaDocument, Failure> {
    match name {
        "log10" => return Ok(FormulaDocument::Log10),
        "exp" => return Ok(FormulaDocument::Exp),
        "sin" => return Ok(FormulaDocument::Sin),
        _ => {}
    }
    if let Some(power) = name.strip_prefix("x^") {
        let power: Option<f64> = power.parse().ok();
        let power = power.filter(|power| power.is_finite());
        return power
            .map(FormulaDocument::Power)
            .ok_or_else(|| Failure::Input(format!("--function {name}: after x^ stands a number")));
    }
    let text =
        std::fs::read_to_string(name).map_err(|error| Failure::Io(format!("{name}: {error}")))?;
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    // An invalid line becomes NaN and, like a line whose x does not increase, is reported later by its number.
    let rows = lines.map(|line| numbers(line).unwrap_or([f64::NAN; 2]));
    Ok(FormulaDocument::Table(rows.collect()))
}
