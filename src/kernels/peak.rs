//! What one core can do at most: loops that do nothing but store, or nothing but multiply and add.
//!
//! What other work is to be compared with, measured in the same process. Not kernels of anything.

use super::{InstructionSet, multiversion};

/// Writes `value` to all of `target` past the caches, as a large result is written; with ordinary stores where the
/// processor has no others.
pub fn stream(target: &mut [f64], value: f64) {
    #[cfg(target_arch = "x86_64")]
    if InstructionSet::best().is_avx512() {
        // SAFETY: the only set for which `is_avx512` holds is made after the processor was found to have AVX-512.
        return unsafe { stream_lines(target, value) };
    }
    target.fill(value);
}

/// Whole cache lines by streaming stores, what is before and after them by ordinary ones.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
fn stream_lines(target: &mut [f64], value: f64) {
    use std::arch::x86_64::{_mm_sfence, _mm512_set1_pd, _mm512_stream_pd};
    let before = target.as_ptr().align_offset(64).min(target.len());
    let (head, rest) = target.split_at_mut(before);
    let lines = _mm512_set1_pd(value);
    let mut whole = rest.chunks_exact_mut(8);
    for line in &mut whole {
        // SAFETY: a chunk is eight doubles long, borrowed exclusively, and begins on a multiple of 64 bytes, since the
        // first does (`before`) and each is 64 bytes long.
        unsafe { _mm512_stream_pd(line.as_mut_ptr(), lines) };
    }
    // Streaming stores are not ordered with others until a fence.
    _mm_sfence();
    head.fill(value);
    whole.into_remainder().fill(value);
}

multiversion! {
    /// Writes `value` to all of `target` with ordinary stores of the widest vectors.
    pub fn fill(target: &mut [f64], value: f64) {
        target.fill(value);
    }
}

/// Independent sums: enough to hide the time from operand to result of a fused multiply-add, two of which begin at once.
const SUMS: usize = 12;
/// Doubles in the widest vector.
const LANES: usize = 8;

/// How many fused multiply-adds of doubles [`multiply_add`] does in one round.
pub const MULTIPLY_ADDS: usize = SUMS * LANES;

multiversion! {
    /// Does `rounds` times [`MULTIPLY_ADDS`] fused multiply-adds and returns their sum.
    pub fn multiply_add(rounds: usize, factor: f64, term: f64) -> f64 {
        let mut sums = [[factor; LANES]; SUMS];
        for _ in 0..rounds {
            for lanes in &mut sums {
                for sum in lanes {
                    *sum = sum.mul_add(factor, term);
                }
            }
        }
        sums.as_flattened().iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stream_reaches_every_number_from_every_start() {
        for start in 0..9 {
            for length in [0, 1, 7, 8, 9, 100] {
                let mut buffer = vec![1.0; start + length + 9];
                stream(&mut buffer[start..start + length], 2.0);
                let expected = |index| if (start..start + length).contains(&index) { 2.0 } else { 1.0 };
                assert!(buffer.iter().enumerate().all(|(index, x)| *x == expected(index)), "{start} {length}");
            }
        }
    }

    #[test]
    fn multiply_add_does_what_it_counts() {
        // With factor 1 every sum grows by the term in each round.
        for set in InstructionSet::available() {
            assert_eq!(multiply_add(set, 10, 1.0, 0.5), MULTIPLY_ADDS as f64 * 6.0, "{}", set.name());
        }
    }
}
