//! Lines and numbers of CSV.

use std::io::{self, Write};

/// How a table is written.
#[derive(Clone, Copy)]
pub(crate) struct Csv {
    /// 0,5 for 0.5, and so a semicolon between cells.
    pub(crate) decimal_comma: bool,
}

impl Csv {
    /// One line, cells quoted where they must be.
    pub(crate) fn line(
        self,
        out: &mut impl Write,
        cells: impl Iterator<Item = String>,
    ) -> io::Result<()> {
        let separator = if self.decimal_comma { ';' } else { ',' };
        for (k, cell) in cells.enumerate() {
            if k > 0 {
                write!(out, "{separator}")?;
            }
            if cell.contains([separator, '"', '\n', '\r']) {
                write!(out, "\"{}\"", cell.replace('"', "\"\""))?;
            } else {
                out.write_all(cell.as_bytes())?;
            }
        }
        out.write_all(b"\n")
    }

    /// The shortest text that reads back as the same number.
    pub(crate) fn number(self, value: f64) -> String {
        let value = value + 0.0;
        let text = if value == 0.0 || (1e-5..1e16).contains(&value.abs()) {
            format!("{value}")
        } else {
            format!("{value:e}")
        };
        if self.decimal_comma {
            text.replace('.', ",")
        } else {
            text
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: Csv = Csv {
        decimal_comma: false,
    };
    const COMMA: Csv = Csv {
        decimal_comma: true,
    };

    #[test]
    fn cells_are_quoted() {
        let written = |csv: Csv| {
            let mut out = Vec::new();
            let cells = ["plain", "a, b", "\"c\"", "d;e", ""].map(str::to_owned);
            csv.line(&mut out, cells.into_iter()).unwrap();
            String::from_utf8(out).unwrap()
        };
        assert_eq!(written(POINT), "plain,\"a, b\",\"\"\"c\"\"\",d;e,\n");
        assert_eq!(written(COMMA), "plain;a, b;\"\"\"c\"\"\";\"d;e\";\n");
    }

    #[test]
    fn numbers_read_back() {
        for value in [
            0.1 + 0.2,
            1.0 / 3.0,
            -1e-17,
            6.02e23,
            360.0,
            f64::MIN_POSITIVE,
        ] {
            assert_eq!(POINT.number(value).parse::<f64>().unwrap(), value);
            let point = COMMA.number(value).replace(',', ".");
            assert_eq!(point, POINT.number(value));
        }
        assert_eq!(
            [-0.0, 5.0, 1e-17].map(|value| POINT.number(value)),
            ["0", "5", "1e-17"]
        );
        assert_eq!(COMMA.number(-0.25), "-0,25");
    }
}
