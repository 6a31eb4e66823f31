//! The natural logarithm: `x = 2^k m` with `√½ <= m < √2`, then one polynomial.
//!
//! The formula and the polynomial in `s² = (f / (2 + f))²`, `f = m - 1`, are those of fdlibm (`e_log.c`; Sun
//! Microsystems, freely granted).

/// The bits of √½, rounded so that the bits of m - √½ are a fraction's.
const ROOT_OF_HALF: u64 = 0x3fe6_a09e_0000_0000;
const FRACTION: u64 = (1 << 52) - 1;

/// 2^52 as bits: with an integer below 2^52 in its fraction it is 2^52 plus that integer.
const INTEGER_CARRIER: u64 = 0x4330_0000_0000_0000;
/// 2^52 plus the bias of the exponents.
const CARRIER_AND_BIAS: f64 = 4_503_599_627_370_496.0 + 1023.0;

const LN_2_FIRST: f64 = 6.931_471_803_691_238_164_90e-1;
const LN_2_SECOND: f64 = 1.908_214_929_270_587_700_02e-10;

const SERIES: [f64; 7] = [
    6.666_666_666_666_735_13e-1,
    3.999_999_999_940_941_908e-1,
    2.857_142_874_366_239_149e-1,
    2.222_219_843_214_978_396e-1,
    1.818_357_216_161_805_012e-1,
    1.531_383_769_920_937_332e-1,
    1.479_819_860_511_658_591e-1,
];

/// Positive normal numbers.
#[inline(always)]
pub(super) fn is_fast(x: f64) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&x)
}

#[inline(always)]
pub(super) fn ln(x: f64) -> f64 {
    let shifted = x.to_bits().wrapping_add(1.0_f64.to_bits() - ROOT_OF_HALF);
    let k = f64::from_bits((shifted >> 52) | INTEGER_CARRIER) - CARRIER_AND_BIAS;
    let m = f64::from_bits((shifted & FRACTION) + ROOT_OF_HALF);
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let half_square = 0.5 * f * f;
    let series = z * super::polynomial(z, SERIES);
    let bend = s * (half_square + series) + k * LN_2_SECOND;
    k * LN_2_FIRST - ((half_square - bend) - f)
}
