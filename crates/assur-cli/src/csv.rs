//! Writing of CSV: lines, cells and numbers.

use std::io::{self, Write};

/// Format of a table.
#[derive(Clone, Copy)]
pub(crate) struct Csv {
    /// Whether the decimal sign is a comma (0,5 for 0.5). Cells are then separated by semicolons.
    pub(crate) decimal_comma: bool,
}

pub(crate) enum Cell {
    Text(String),
    Number(f64),
    Empty,
}

impl Csv {
    /// Writes a line; texts are quoted if necessary.
    pub(crate) fn line(
        self,
        out: &mut impl Write,
        cells: impl Iterator<Item = Cell>,
    ) -> io::Result<()> {
        let separator = if self.decimal_comma { ';' } else { ',' };
        for (k, cell) in cells.enumerate() {
            if k > 0 {
                out.write_all(&[separator as u8])?;
            }
            match cell {
                Cell::Text(text) if text.contains([separator, '"', '\n', '\r']) => {
                    write!(out, "\"{}\"", text.replace('"', "\"\""))?;
                }
                Cell::Text(text) => out.write_all(text.as_bytes())?,
                Cell::Number(value) => self.number(out, value)?,
                Cell::Empty => {}
            }
        }
        out.write_all(b"\n")
    }

    /// Writes the shortest text that reads back as the same number, without allocation: long tables are mainly numbers.
    fn number(self, out: &mut impl Write, value: f64) -> io::Result<()> {
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format(value + 0.0);
        let text = text.strip_suffix(".0").unwrap_or(text);
        if self.decimal_comma
            && let Some((whole, rest)) = text.split_once('.')
        {
            return write!(out, "{whole},{rest}");
        }
        out.write_all(text.as_bytes())
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
            let cells = ["plain", "a, b", "\"c\"", "d;e"].map(|text| Cell::Text(text.to_owned()));
            csv.line(&mut out, cells.into_iter().chain([Cell::Empty]))
                .unwrap();
            String::from_utf8(out).unwrap()
        };
        assert_eq!(written(POINT), "plain,\"a, b\",\"\"\"c\"\"\",d;e,\n");
        assert_eq!(written(COMMA), "plain;a, b;\"\"\"c\"\"\";\"d;e\";\n");
    }

    #[test]
    fn numbers_read_back() {
        let written = |csv: Csv, value: f64| {
            let mut out = Vec::new();
            csv.number(&mut out, value).unwrap();
            String::from_utf8(out).unwrap()
        };
        for value in [
            0.1 + 0.2,
            1.0 / 3.0,
            -1e-17,
            6.02e23,
            360.0,
            f64::MIN_POSITIVE,
        ] {
            assert_eq!(written(POINT, value).parse::<f64>().unwrap(), value);
            let point = written(COMMA, value).replace(',', ".");
            assert_eq!(point, written(POINT, value));
        }
        assert_eq!(
            [-0.0, 5.0, 1e-17, 1e-5, 123_456_789.0, 1e16].map(|value| written(POINT, value)),
            ["0", "5", "1e-17", "0.00001", "123456789", "1e+16"]
        );
        assert_eq!(written(COMMA, -0.25), "-0,25");
    }
}
