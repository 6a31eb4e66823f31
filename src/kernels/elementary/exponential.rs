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

/// Taylor series of `(sinh r - r) / r³` and `(cosh r - 1)`, over r², in r²; what they leave out is below 10^-18.
const SINH: [f64; 6] =
    [1.0 / 6.0, 1.0 / 120.0, 1.0 / 5040.0, 1.0 / 362_880.0, 1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0];
const COSH: [f64; 7] =
    [0.5, 1.0 / 24.0, 1.0 / 720.0, 1.0 / 40_320.0, 1.0 / 3_628_800.0, 1.0 / 479_001_600.0, 1.0 / 87_178_291_200.0];

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
    let (power, r, r_rest) = reduced(x);
    let bend = (r * r).mul_add(polynomial(r, CURVATURE), r_rest.mul_add(r, r_rest));
    let p = r + bend;
    Parts { power, p, rest: (r - p) + bend }
}

/// 2^k, and r with what it is off by.
#[inline(always)]
fn reduced(x: f64) -> (f64, f64, f64) {
    let shifted = x.mul_add(LOG2_E, ROUNDER);
    let k = shifted - ROUNDER;
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    let first = k.mul_add(-LN_2_FIRST, x);
    let r = k.mul_add(-LN_2_SECOND, first);
    (power, r, k.mul_add(-LN_2_SECOND, first - r))
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

/// With `c = (2^k + 2^-k) / 2` and `d = (2^k - 2^-k) / 2`: `sinh |x| = c sinh r + d cosh r` and
/// `cosh |x| = c cosh r + d sinh r`. No division, and nothing is lost where x is small, since d is then zero.
#[inline(always)]
pub(super) fn sinh_cosh(x: f64) -> (f64, f64) {
    let (power, r, rest) = reduced(x.abs());
    let inverse = f64::from_bits((2 * 1.0_f64.to_bits()).wrapping_sub(power.to_bits()));
    let (half, half_inverse) = (0.5 * power, 0.5 * inverse);
    let (c, d) = (half + half_inverse, half - half_inverse);
    let (c_rest, d_rest) = ((half - c) + half_inverse, (half - d) - half_inverse);
    let z = r * r;
    let sinh = r + (r * z).mul_add(polynomial(z, SINH), rest);
    let cosh_less_one = z * polynomial(z, COSH);
    let sinh_x = d + sinh.mul_add(c, cosh_less_one.mul_add(d, d_rest));
    let cosh_x = c + cosh_less_one.mul_add(c, sinh.mul_add(d, c_rest));
    (sinh_x.copysign(x), cosh_x)
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
