//! Sine, cosine and tangent: one reduction by multiples of π/2, one polynomial each.
//!
//! `|x| = k π/2 + r` with `|r| <= π/4`; π/2 is taken in three parts of 53 bits, so that r keeps its relative accuracy
//! next to every zero. The polynomials are those of fdlibm (`k_sin.c`, `k_cos.c`; Sun Microsystems, freely granted).

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use super::{ROUNDER, polynomial};

/// The second and third part of π/2; the first is [`FRAC_PI_2`].
const SECOND_PART: f64 = 6.123_233_995_736_766e-17;
const THIRD_PART: f64 = -1.497_384_904_859_183_3e-33;

/// To here k is below 2^30, and the parts of π/2 that are left out are 10^-15 of the smallest r there is.
const LARGEST: f64 = 1_073_741_824.0;

const SINE: [f64; 6] = [
    -1.666_666_666_666_663_243_48e-1,
    8.333_333_333_322_489_461_24e-3,
    -1.984_126_982_985_794_931_34e-4,
    2.755_731_370_707_006_767_89e-6,
    -2.505_076_025_340_686_341_95e-8,
    1.589_690_995_211_550_102_21e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_660_190_37e-2,
    -1.388_888_888_887_410_957_49e-3,
    2.480_158_728_947_672_941_78e-5,
    -2.755_731_435_139_066_330_35e-7,
    2.087_572_321_298_174_827_90e-9,
    -1.135_964_755_778_819_482_65e-11,
];

#[inline(always)]
pub(super) fn is_fast(x: f64) -> bool {
    x.abs() <= LARGEST
}

#[inline(always)]
pub(super) fn sin(x: f64) -> f64 {
    sin_cos(x).0
}

#[inline(always)]
pub(super) fn cos(x: f64) -> f64 {
    sin_cos(x).1
}

#[inline(always)]
pub(super) fn sin_cos(x: f64) -> (f64, f64) {
    let (quadrant, k, r) = reduced(x.abs());
    // One rounding each, relative to what is left, however small that is.
    let r = k.mul_add(-THIRD_PART, k.mul_add(-SECOND_PART, r));
    let z = r * r;
    let sine = (r * z).mul_add(polynomial(z, SINE), r);
    let (one, rest) = cosine(z);
    let cosine = one + rest;
    let is_odd = quadrant & 1 == 1;
    let (sine, cosine) = if is_odd { (cosine, sine) } else { (sine, cosine) };
    // The sine is odd: on |x| first, so that zero keeps its sign.
    let sign = (quadrant & 2) << 62 ^ (x.to_bits() & SIGN);
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    (f64::from_bits(sine.to_bits() ^ sign), f64::from_bits(cosine.to_bits() ^ cosine_sign))
}

const SIGN: u64 = 1 << 63;

/// The quotient of sine and cosine, each with its rest.
#[inline(always)]
pub(super) fn tan(x: f64) -> f64 {
    let (quadrant, k, first) = reduced(x.abs());
    let second = k * SECOND_PART;
    let r = first - second;
    let lost = r - first;
    let rounding = (first - (r - lost)) - (second + lost);
    let r_rest = k.mul_add(-THIRD_PART, rounding - k.mul_add(SECOND_PART, -second));
    let z = r * r;
    let bend = (r * z).mul_add(polynomial(z, SINE), r_rest);
    let sine = r + bend;
    let sine_rest = (r - sine) + bend;
    let (one, rest) = cosine(z);
    let bend = r.mul_add(-r_rest, rest);
    let cosine = one + bend;
    let cosine_rest = (one - cosine) + bend;
    let is_odd = quadrant & 1 == 1;
    let (above, above_rest, below, below_rest) =
        if is_odd { (cosine, cosine_rest, sine, sine_rest) } else { (sine, sine_rest, cosine, cosine_rest) };
    let tangent = super::quotient((above, above_rest), (below, below_rest));
    let sign = (quadrant & 1) << 63 ^ (x.to_bits() & SIGN);
    f64::from_bits(tangent.to_bits() ^ sign)
}

/// k, as bits of which the lowest two count and as a number, and `x` less k times the first part of π/2, for
/// `0 <= x <= LARGEST`.
#[inline(always)]
fn reduced(x: f64) -> (u64, f64, f64) {
    let shifted = x.mul_add(FRAC_2_PI, ROUNDER);
    let k = shifted - ROUNDER;
    // Exact: a multiple of 2^-53 below 1.
    (shifted.to_bits(), k, k.mul_add(-FRAC_PI_2, x))
}

/// The cosine of r as `1 - r²/2`, rounded, and all that is missing from it.
#[inline(always)]
fn cosine(z: f64) -> (f64, f64) {
    let half = 0.5 * z;
    let one = 1.0 - half;
    (one, (z * z).mul_add(polynomial(z, COSINE), (1.0 - one) - half))
}
