//! Numbers as text.

use std::fmt;

/// The shortest decimal that reads back to the same double, in whichever notation stays short.
///
/// ```
/// use trimline::diagnostic::Shortest;
/// assert_eq!([0.3, 1e300].map(|number| Shortest(number).to_string()), ["0.3", "1e300"]);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Shortest(pub f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        // Rust's plain notation never uses an exponent: 1e300 would take 301 digits.
        if size == 0.0 || (1e-5..1e17).contains(&size) { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

/// The shortest decimal that reads back to the same single.
#[derive(Debug, Clone, Copy)]
pub struct Single(pub f32);

impl fmt::Display for Single {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-5..1e9).contains(&size) { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_short_as_they_read_back() {
        let written = |x: f64| Shortest(x).to_string();
        assert_eq!(written(0.1), "0.1");
        assert_eq!(written(1.0), "1");
        assert_eq!(written(-0.0), "-0");
        assert_eq!(written(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(written(1e300), "1e300");
        assert_eq!(written(-2.5e-9), "-2.5e-9");
        assert_eq!(Single(0.1).to_string(), "0.1");
        assert_eq!(Single(1e-10).to_string(), "1e-10");
    }

    #[test]
    fn awkward_numbers_read_back_bit_for_bit() {
        let awkward = [f64::MIN_POSITIVE, 5e-324, f64::MAX, 1.0 / 3.0, 1e-5, 9.999999999999999e-6, 1e17, 2f64.powi(60)];
        for x in awkward.into_iter().flat_map(|x| [x, -x]) {
            let read: f64 = Shortest(x).to_string().parse().unwrap();
            assert_eq!(read.to_bits(), x.to_bits(), "{x:e}");
        }
        for x in [f32::MAX, f32::MIN_POSITIVE, 1e-45, 1.0 / 3.0, 16_777_217.0, 1e-5, 1e9] {
            let read: f32 = Single(x).to_string().parse().unwrap();
            assert_eq!(read.to_bits(), x.to_bits(), "{x:e}");
        }
    }
}
