//! Elementary functions as branch-free polynomials, for one double or for blocks of them.
//!
//! Each function is a `fast` formula on the arguments for which `is_fast` holds, and the crate `libm` on all others:
//! far, subnormal and infinite arguments, NaN. The choice is made lane by lane, so a block gives the bits that single
//! calls give. Within 2 units in the last place everywhere; signed zeros as in C.
//!
//! Absent on purpose: functions for which `libm` itself is used throughout (`asin`, `atan`, `cbrt`, `pow`, …).

#![allow(
    clippy::excessive_precision,
    reason = "constants stand as they were computed, to more digits than a double has"
)]

mod exponential;
mod logarithm;
mod trigonometric;

use super::{InstructionSet, canonical, multiversion};

/// An elementary function of one argument.
pub trait Elementary {
    /// Whether `fast` may be used at `x`; false for NaN.
    fn is_fast(x: f64) -> bool;
    /// The function where `is_fast` holds; any number elsewhere.
    fn fast(x: f64) -> f64;
    /// The function everywhere.
    fn slow(x: f64) -> f64;
}

/// Two functions that share most of their work.
pub trait Pair {
    /// The first function.
    type First: Elementary;
    /// The second; fast on the same arguments.
    type Second: Elementary;
    /// Both: the bits of their own `fast`.
    fn fast(x: f64) -> (f64, f64);
}

/// `target[i] = F(arguments[i])`.
#[inline(always)]
pub(crate) fn map<F: Elementary>(target: &mut [f64], arguments: &[f64]) {
    let mut are_all_fast = true;
    for (value, &x) in target.iter_mut().zip(arguments) {
        *value = F::fast(x);
        are_all_fast &= F::is_fast(x);
    }
    if !are_all_fast {
        repair::<F>(target, arguments);
    }
}

/// `first[i], second[i] = P(arguments[i])`.
#[inline(always)]
pub(crate) fn map_pair<P: Pair>(first: &mut [f64], second: &mut [f64], arguments: &[f64]) {
    let mut are_all_fast = true;
    for ((first, second), &x) in first.iter_mut().zip(second.iter_mut()).zip(arguments) {
        (*first, *second) = P::fast(x);
        are_all_fast &= P::First::is_fast(x);
    }
    if !are_all_fast {
        repair::<P::First>(first, arguments);
        repair::<P::Second>(second, arguments);
    }
}

/// Replaces what `fast` does not know.
#[cold]
#[inline(never)]
fn repair<F: Elementary>(target: &mut [f64], arguments: &[f64]) {
    for (value, &x) in target.iter_mut().zip(arguments) {
        if !F::is_fast(x) {
            *value = canonical(F::slow(x));
        }
    }
}

#[inline(always)]
fn one<F: Elementary>(x: f64) -> f64 {
    if F::is_fast(x) { F::fast(x) } else { F::slow(x) }
}

macro_rules! elementary {
    ($($(#[$meta:meta])* $kernel:ident $name:ident $block:ident: $is_fast:path, $fast:path, $slow:expr;)*) => {
        $(
            $(#[$meta])*
            #[derive(Debug, Clone, Copy)]
            pub struct $kernel;

            impl Elementary for $kernel {
                #[inline(always)]
                fn is_fast(x: f64) -> bool {
                    $is_fast(x)
                }
                #[inline(always)]
                fn fast(x: f64) -> f64 {
                    $fast(x)
                }
                #[cold]
                #[inline(never)]
                fn slow(x: f64) -> f64 {
                    $slow(x)
                }
            }

            $(#[$meta])*
            #[must_use]
            pub fn $name(x: f64) -> f64 {
                multiversion! {
                    fn compiled(x: f64) -> f64 {
                        one::<$kernel>(x)
                    }
                }
                compiled(InstructionSet::best(), x)
            }

            multiversion! {
                $(#[$meta])*
                ///
                /// Of every argument, as far as `target` reaches.
                pub fn $block(target: &mut [f64], arguments: &[f64]) {
                    map::<$kernel>(target, arguments);
                }
            }
        )*
    };
}

elementary! {
    /// The sine.
    Sin sin sin_block: trigonometric::is_fast, trigonometric::sin, libm::sin;
    /// The cosine.
    Cos cos cos_block: trigonometric::is_fast, trigonometric::cos, libm::cos;
    /// The tangent.
    Tan tan tan_block: trigonometric::is_fast, trigonometric::tan, libm::tan;
    /// The exponential function.
    Exp exp exp_block: exponential::is_fast, exponential::exp, libm::exp;
    /// The hyperbolic sine.
    Sinh sinh sinh_block: exponential::is_fast, exponential::sinh, libm::sinh;
    /// The hyperbolic cosine.
    Cosh cosh cosh_block: exponential::is_fast, exponential::cosh, libm::cosh;
    /// The hyperbolic tangent.
    Tanh tanh tanh_block: exponential::is_fast_tanh, exponential::tanh, libm::tanh;
    /// The natural logarithm.
    Ln ln ln_block: logarithm::is_fast, logarithm::ln, libm::log;
}

/// Sine and cosine of one argument.
#[derive(Debug, Clone, Copy)]
pub struct SinCos;

impl Pair for SinCos {
    type First = Sin;
    type Second = Cos;
    #[inline(always)]
    fn fast(x: f64) -> (f64, f64) {
        trigonometric::sin_cos(x)
    }
}

/// Hyperbolic sine and cosine of one argument.
#[derive(Debug, Clone, Copy)]
pub struct SinhCosh;

impl Pair for SinhCosh {
    type First = Sinh;
    type Second = Cosh;
    #[inline(always)]
    fn fast(x: f64) -> (f64, f64) {
        exponential::sinh_cosh(x)
    }
}

multiversion! {
    /// Sine and cosine of every argument, as far as both targets reach.
    pub fn sin_cos_block(sines: &mut [f64], cosines: &mut [f64], arguments: &[f64]) {
        map_pair::<SinCos>(sines, cosines, arguments);
    }
}

/// Adding it rounds a double below 2^51 to an integer, whose lowest bits are then those of the sum.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// `c0 + x (c1 + x (c2 + …))`.
#[inline(always)]
fn polynomial<const N: usize>(x: f64, coefficients: [f64; N]) -> f64 {
    let mut value = 0.0;
    let mut is_first = true;
    for &coefficient in coefficients.iter().rev() {
        value = if is_first { coefficient } else { value.mul_add(x, coefficient) };
        is_first = false;
    }
    value
}

/// The quotient of two numbers with rests, correct to little more than its own rounding.
#[inline(always)]
fn quotient((above, above_rest): (f64, f64), (below, below_rest): (f64, f64)) -> f64 {
    let inverse = 1.0 / below;
    let quotient = above * inverse;
    let remainder = quotient.mul_add(-below, above) + quotient.mul_add(-below_rest, above_rest);
    remainder.mul_add(inverse, quotient)
}
