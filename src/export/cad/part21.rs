//! The exchange structure of ISO 10303-21: numbered entities, reals, strings.

use std::fmt::Write;

/// The data section, entity after entity.
#[derive(Default)]
pub(super) struct Entities {
    text: String,
    count: usize,
}

/// The number of an entity.
pub(super) type Id = usize;

impl Entities {
    /// Adds `entity`, for example `VERTEX_POINT('',#7)`, and returns its number.
    pub fn add(&mut self, entity: &str) -> Id {
        self.count += 1;
        // Writing to a string does not fail.
        let _ = writeln!(self.text, "#{}={entity};", self.count);
        self.count
    }

    /// Adds a point.
    pub fn point(&mut self, point: &[f64; 3]) -> Id {
        let coordinates = list(point.iter().map(|x| real(*x)));
        self.add(&format!("CARTESIAN_POINT('',{coordinates})"))
    }

    /// Adds points, and returns the list of their numbers.
    pub fn points(&mut self, points: &[[f64; 3]]) -> String {
        let ids: Vec<Id> = points.iter().map(|point| self.point(point)).collect();
        references(&ids)
    }

    pub fn into_text(self) -> String {
        self.text
    }
}

/// `(a,b,c)`
pub(super) fn list(items: impl Iterator<Item = String>) -> String {
    format!("({})", items.collect::<Vec<_>>().join(","))
}

/// `(#1,#2)`
pub(super) fn references(ids: &[Id]) -> String {
    list(ids.iter().map(|id| format!("#{id}")))
}

/// A finite number with the fewest digits that read back to it; a real has a decimal point, always.
pub(super) fn real(x: f64) -> String {
    with_point(x, 'E')
}

/// `1.5`, `2.`, `1.E-7`: a decimal point always, `exponent` as the mark of the exponent.
pub(in crate::export) fn with_point(x: f64, exponent: char) -> String {
    let digits = format!("{x:?}");
    let (mantissa, power) = digits.split_once('e').map_or((digits.as_str(), None), |(m, p)| (m, Some(p)));
    let mantissa = mantissa.strip_suffix(".0").unwrap_or(mantissa);
    let point = if mantissa.contains('.') { "" } else { "." };
    match power {
        None => format!("{mantissa}{point}"),
        Some(power) => format!("{mantissa}{point}{exponent}{power}"),
    }
}

/// `text` in quotes: apostrophes and backslashes twice, everything that is not printable ASCII as its code.
pub(super) fn string(text: &str) -> String {
    let mut quoted = String::from("'");
    for c in text.chars() {
        let code = u32::from(c);
        // Writing to a string does not fail.
        let _ = match c {
            '\'' => write!(quoted, "''"),
            '\\' => write!(quoted, "\\\\"),
            ' '..='~' => write!(quoted, "{c}"),
            _ if code <= 0xffff => write!(quoted, "\\X2\\{code:04X}\\X0\\"),
            _ => write!(quoted, "\\X4\\{code:08X}\\X0\\"),
        };
    }
    quoted + "'"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_point_and_read_back() {
        let texts = [0.0, -1.0, 0.1, 1e-7, -1.25e300, 1e16, 5e-324].map(real);
        assert_eq!(texts, ["0.", "-1.", "0.1", "1.E-7", "-1.25E300", "1.E16", "5.E-324"]);
        for text in texts {
            let readable = text.replace(".E", ".0E");
            assert_eq!(real(readable.parse().expect("a number")), text);
        }
    }

    #[test]
    fn strings_are_encoded_as_the_standard_says() {
        assert_eq!(string("it's a \\ α\n𝑥"), "'it''s a \\\\ \\X2\\03B1\\X0\\\\X2\\000A\\X0\\\\X4\\0001D465\\X0\\'");
    }
}
