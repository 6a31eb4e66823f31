//! The exponential function and the hyperbolic functions: one reduction by multiples of ln 2, one polynomial.
//!
//! `x = k ln 2 + r` with `|r| <= ln 2 / 2` and `e^x = 2^k (1 + p)`, `p = e^r - 1`. The polynomial is a Chebyshev fit of
//! `(e^r - 1 - r) / r²`. p is carried with a rest, so that sinh and tanh keep their digits where `e^x - 1` is small.

use std::f64::consts::LOG2_E;

use super::{ROUNDER, polynomial};

/// ln 2 in two parts; the first ends in 20 zero bits, so that k times it is exact.
const LN_2_FIRST: f64 = 6.931_471_803_691_238_164_90e-1;
const LN_2_SECOND: f64 = 1.908_214_929_270_587_700_02e-10;

/// To here neither e^x nor e^-x leaves the normal doubles.
const LARGEST: f64 = 708.0;

/// From here on tanh is 1.
const SATURATED: f64 = 20.0;

const CURVATURE: [f64; 10] = [
    0.5,
    0.166_666_666_666_666_674_52,
    0.041_666_666_666_624_161_903,
    0.008_333_333_333_330_044_469_5,
    0.001_388_888_891_719_677_190_7,
    0.000_198_412_698_630_405_452_71,
    2.480_152_132_236_869_326_6e-5,
    2.755_726_848_031_002_552_6e-6,
    2.762_007_587_998_336_658_6e-7,
    2.510_037_583_256_123_366_4e-8,
];

#[inline(always)]
pub(super) fn is_fast(x: f64) -> bool {
    x.abs() <= LARGEST
}

#[inline(always)]
pub(super) fn is_fast_tanh(x: f64) -> bool {
    x.abs() <= SATURATED
}

/// `e^x = power (1 + p)`; what p is off by is `rest`.
struct Parts {
    power: f64,
    p: f64,
    rest: f64,
}

#[inline(always)]
fn parts(x: f64) -> Parts {
    let shifted = x.mul_add(LOG2_E, ROUNDER);
    let k = shifted - ROUNDER;
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    let first = k.mul_add(-LN_2_FIRST, x);
    let r = k.mul_add(-LN_2_SECOND, first);
    let r_rest = k.mul_add(-LN_2_SECOND, first - r);
    let bend = (r * r).mul_add(polynomial(r, CURVATURE), r_rest.mul_add(r, r_rest));
    let p = r + bend;
    Parts { power, p, rest: (r - p) + bend }
}

/// `e^x - 1` for `x >= 0`, and what it is off by.
#[inline(always)]
fn minus_one(Parts { power, p, rest }: &Parts) -> (f64, f64) {
    let below = power - 1.0;
    let value = power.mul_add(*p, below);
    (value, power.mul_add(*rest, power.mul_add(*p, below - value)))
}

#[inline(always)]
pub(super) fn exp(x: f64) -> f64 {
    let Parts { power, p, .. } = parts(x);
    power.mul_add(p, power)
}

#[inline(always)]
pub(super) fn sinh(x: f64) -> f64 {
    sinh_cosh(x).0
}

#[inline(always)]
pub(super) fn cosh(x: f64) -> f64 {
    sinh_cosh(x).1
}

/// With `e = e^|x| - 1`: `sinh |x| = (e + e / (e + 1)) / 2`, which loses nothing where x is small.
#[inline(always)]
pub(super) fn sinh_cosh(x: f64) -> (f64, f64) {
    let parts = parts(x.abs());
    let power = parts.power.mul_add(parts.p, parts.power);
    let (e, rest) = minus_one(&parts);
    let (divisor, divisor_rest) = sum(e, 1.0);
    let inverse = 1.0 / divisor;
    let quotient = e * inverse;
    let remainder = quotient.mul_add(-divisor, e) + quotient.mul_add(-divisor_rest, rest);
    let (twice, twice_rest) = sum(e, quotient);
    let sinh = 0.5 * (twice + (twice_rest + remainder.mul_add(inverse, rest)));
    (sinh.copysign(x), 0.5 * (power + 1.0 / power))
}

/// With `e = e^(2|x|) - 1`: `tanh |x| = e / (e + 2)`, divided with a rest.
#[inline(always)]
pub(super) fn tanh(x: f64) -> f64 {
    let (e, rest) = minus_one(&parts(2.0 * x.abs()));
    super::quotient((e, rest), sum(e, 2.0)).copysign(x)
}

/// The sum of two numbers that are not negative, and what it is off by.
#[inline(always)]
fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let (larger, smaller) = if a > b { (a, b) } else { (b, a) };
    (sum, (larger - sum) + smaller)
}
