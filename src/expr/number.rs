//! Numbers in expressions: exact rationals while they fit 128 bits, doubles beyond.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg};

use num_rational::Ratio;
use num_traits::{CheckedAdd, CheckedMul, One, Signed, Zero};

/// An exact rational, or a double where the rational would not fit.
///
/// Decimal literals are exact (`0.1` is one tenth), so folding `0.1 + 0.2` prints `0.3`.
#[derive(Debug, Clone, Copy)]
pub enum Number {
    /// Numerator and denominator of 127 bits.
    Exact(Ratio<i128>),
    /// Taken when an exact result does not fit; never NaN.
    Real(f64),
}

/// Integers up to here are exact in a double, so their quotient is correctly rounded.
const EXACT_IN_F64: i128 = 1 << 53;

impl Number {
    /// Zero.
    pub const ZERO: Number = Number::Exact(Ratio::new_raw(0, 1));
    /// One.
    pub const ONE: Number = Number::Exact(Ratio::new_raw(1, 1));
    /// Minus one.
    pub const MINUS_ONE: Number = Number::Exact(Ratio::new_raw(-1, 1));

    /// An integer.
    #[must_use]
    pub fn integer(value: i64) -> Number {
        Number::Exact(Ratio::from_integer(i128::from(value)))
    }

    /// The fraction `numerator / denominator`; `None` for a zero denominator.
    #[must_use]
    pub fn fraction(numerator: i64, denominator: i64) -> Option<Number> {
        (denominator != 0).then(|| Number::Exact(Ratio::new(i128::from(numerator), i128::from(denominator))))
    }

    /// A double; integers and short decimals become exact. `None` for NaN and infinities.
    #[must_use]
    pub fn from_f64(value: f64) -> Option<Number> {
        value.is_finite().then(|| Number::parse(&format!("{value:e}")).unwrap_or(Number::Real(value)))
    }

    /// Reads a decimal literal such as `2`, `.5` or `1e-3`.
    ///
    /// `None` when it is not one, or overflows a double.
    #[must_use]
    pub fn parse(text: &str) -> Option<Number> {
        let approximate: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
        Some(parse_exact(text).map_or(Number::Real(approximate), Number::Exact))
    }

    /// Whether this is exactly zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        match self {
            Number::Exact(ratio) => ratio.is_zero(),
            Number::Real(value) => value == 0.0,
        }
    }

    /// Whether this is exactly one.
    #[must_use]
    pub fn is_one(self) -> bool {
        match self {
            Number::Exact(ratio) => ratio.is_one(),
            Number::Real(value) => value == 1.0,
        }
    }

    /// Whether this is below zero.
    #[must_use]
    pub fn is_negative(self) -> bool {
        match self {
            Number::Exact(ratio) => ratio.is_negative(),
            Number::Real(value) => value < 0.0,
        }
    }

    /// The value, when it is an integer of 32 bits.
    #[must_use]
    pub fn as_integer(self) -> Option<i32> {
        match self {
            Number::Exact(ratio) if ratio.is_integer() => i32::try_from(*ratio.numer()).ok(),
            _ => None,
        }
    }

    /// The nearest double; decimals of up to 17 digits and fractions of 53-bit integers are correctly rounded.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        match self {
            Number::Real(value) => value,
            Number::Exact(ratio) => {
                let (numerator, denominator) = (*ratio.numer(), *ratio.denom());
                if numerator.abs() < EXACT_IN_F64 && denominator < EXACT_IN_F64 {
                    return numerator as f64 / denominator as f64;
                }
                decimal(&ratio)
                    .and_then(|text| text.parse().ok())
                    .unwrap_or_else(|| numerator as f64 / denominator as f64)
            }
        }
    }

    /// The power; `None` for a zero base with a negative exponent.
    #[must_use]
    pub fn powi(self, exponent: i32) -> Option<Number> {
        if exponent < 0 {
            let inverse = match self {
                Number::Exact(ratio) if !ratio.is_zero() => Number::Exact(ratio.recip()),
                Number::Real(value) if value != 0.0 => Number::from_f64(1.0 / value)?,
                _ => return None,
            };
            return inverse.powi(exponent.checked_neg()?);
        }
        let (mut power, mut square, mut left) = (Number::ONE, self, exponent);
        while left > 0 {
            if left % 2 == 1 {
                power = power * square;
            }
            left /= 2;
            if left > 0 {
                square = square * square;
            }
        }
        power.to_f64().is_finite().then_some(power)
    }

    fn combine(
        self,
        other: Number,
        exact: impl Fn(Ratio<i128>, Ratio<i128>) -> Option<Ratio<i128>>,
        real: impl Fn(f64, f64) -> f64,
    ) -> Number {
        if let (Number::Exact(a), Number::Exact(b)) = (self, other)
            && let Some(result) = exact(a, b)
            // The one value of 128 bits that has no negative.
            && *result.numer() != i128::MIN
        {
            return Number::Exact(result);
        }
        let value = real(self.to_f64(), other.to_f64());
        // Exact again where its shortest decimal fits, so that equal values are one number whatever their history.
        Number::from_f64(value).unwrap_or(Number::Real(value))
    }

    /// What two numbers must share to be one number: kind and bits.
    fn key(self) -> (u8, i128, i128) {
        match self {
            Number::Exact(ratio) => (0, *ratio.numer(), *ratio.denom()),
            Number::Real(value) => (1, i128::from(value.to_bits()), 0),
        }
    }
}

fn parse_exact(text: &str) -> Option<Ratio<i128>> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: i128 = format!("{whole}{part}").parse().ok()?;
    let shift = exponent.checked_sub(i32::try_from(part.len()).ok()?)?;
    let scale = 10_i128.checked_pow(shift.unsigned_abs())?;
    if shift < 0 { Some(Ratio::new(digits, scale)) } else { Some(Ratio::from_integer(digits.checked_mul(scale)?)) }
}

/// The decimal notation of `ratio`, when it is finite and short enough; with an exponent beyond 18 places.
fn decimal(ratio: &Ratio<i128>) -> Option<String> {
    let (mut scale, mut places) = (1_i128, 0_usize);
    while scale % ratio.denom() != 0 {
        scale = scale.checked_mul(10)?;
        places += 1;
    }
    let digits = ratio.numer().checked_mul(&(scale / ratio.denom()))?;
    if places > 18 {
        return Some(format!("{digits}e-{places}"));
    }
    let sign = if digits < 0 { "-" } else { "" };
    let padded = format!("{:0>width$}", digits.unsigned_abs(), width = places + 1);
    let (whole, part) = padded.split_at(padded.len() - places);
    Some(if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") })
}

impl fmt::Display for Number {
    /// A decimal where it is finite and short, a fraction `a/b` otherwise; reads back as the same number.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Number::Real(value) => write!(f, "{value:?}"),
            Number::Exact(ratio) => match decimal(ratio) {
                Some(text) => f.write_str(&text),
                None => write!(f, "{}/{}", ratio.numer(), ratio.denom()),
            },
        }
    }
}

impl Add for Number {
    type Output = Number;

    fn add(self, other: Number) -> Number {
        self.combine(other, |a, b| a.checked_add(&b), |a, b| a + b)
    }
}

impl Mul for Number {
    type Output = Number;

    fn mul(self, other: Number) -> Number {
        self.combine(other, |a, b| a.checked_mul(&b), |a, b| a * b)
    }
}

impl Neg for Number {
    type Output = Number;

    fn neg(self) -> Number {
        self * Number::MINUS_ONE
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Number {}

impl std::hash::Hash for Number {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> Ordering {
        self.to_f64().total_cmp(&other.to_f64()).then_with(|| self.key().cmp(&other.key()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_literals_are_exact() {
        let sum = Number::parse("0.1").and_then(|a| Number::parse("0.2").map(|b| a + b));
        assert_eq!(sum.map(|s| s.to_string()), Some("0.3".to_owned()));
    }

    #[test]
    fn literals_round_as_the_compiler_rounds_them() {
        for text in [
            "0.8",
            "12.1",
            "3.14159265358979312",
            "1e-300",
            "123456789012345678901234567890",
            "2.2250738585072011e-308",
        ] {
            let expected: f64 = text.parse().expect("a literal");
            assert_eq!(Number::parse(text).map(Number::to_f64), Some(expected), "{text}");
        }
    }

    #[test]
    fn overflowing_products_continue_as_doubles() {
        let big = Number::parse("1e37").expect("a literal");
        assert_eq!(big * big, Number::Real(1e74));
    }

    #[test]
    fn least_integer_of_128_bits_continues_as_a_double() {
        let half = Number::parse("-85070591730234615865843651857942052864").expect("-2^126");
        let sum = half + half;
        assert_eq!(sum.to_f64(), -(2.0_f64.powi(127)));
        assert_eq!((-sum).to_f64(), 2.0_f64.powi(127));
    }

    #[test]
    fn overflowing_literals_are_refused() {
        assert_eq!(Number::parse("1e999"), None);
    }
}
