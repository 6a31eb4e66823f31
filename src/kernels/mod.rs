//! Loops over doubles that run at the speed of the machine: elementary functions, products of small matrices.
//!
//! Plain numbers in, plain numbers out; what a number means is known above. Every kernel is written once and compiled
//! for each [`InstructionSet`]; which one runs is decided when it is called.
//!
//! Invariant: every instruction set gives the same bits. The kernels name every rounding: sums and products in a
//! fixed order, and `mul_add` where a fused one is meant, which is defined to round once on every machine (without
//! the instruction it is slower, never different). Nothing here is compiled with relaxed arithmetic.

mod finite;
mod instruction_set;
mod rows;

pub mod elementary;
pub mod grid;
pub mod peak;

pub(crate) use instruction_set::multiversion;

pub use finite::are_finite;
pub use instruction_set::InstructionSet;
pub use rows::Rows;

/// `value`, with every NaN made the same one: arithmetic does not define which NaN it returns.
///
/// Decided on the bits. Optimisers take `if value.is_nan() { f64::NAN } else { value }` for `value` when they see
/// the arithmetic that made it, since that may return any NaN.
#[inline(always)]
#[must_use]
pub fn canonical(value: f64) -> f64 {
    const WITHOUT_SIGN: u64 = u64::MAX >> 1;
    let bits = value.to_bits();
    let is_nan = bits & WITHOUT_SIGN > f64::INFINITY.to_bits();
    f64::from_bits(if is_nan { f64::NAN.to_bits() } else { bits })
}
