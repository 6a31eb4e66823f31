//! Whether numbers are finite, at the speed of reading them.

use super::multiversion;

multiversion! {
    /// Whether no number is infinite or NaN.
    pub fn are_finite(numbers: &[f64]) -> bool {
        // Without branches, so that whole vectors are compared: infinities and NaN have the largest bits.
        let largest = f64::INFINITY.to_bits();
        let size = |number: &f64| number.to_bits() & (u64::MAX >> 1);
        !numbers.iter().fold(false, |found, number| found | (size(number) >= largest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::InstructionSet;

    #[test]
    fn every_place_counts() {
        for set in InstructionSet::available() {
            for length in [0, 1, 7, 8, 65] {
                let numbers: Vec<f64> = (0..length).map(|i| f64::MAX / f64::from(i + 1)).collect();
                assert!(are_finite(set, &numbers));
                for place in 0..numbers.len() {
                    for bad in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
                        let mut numbers = numbers.clone();
                        if let Some(slot) = numbers.get_mut(place) {
                            *slot = bad;
                        }
                        assert!(!are_finite(set, &numbers), "{} {length} {place} {bad}", set.name());
                    }
                }
            }
        }
    }
}
