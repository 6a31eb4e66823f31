//! Coefficients of trigonometric series from equally spaced samples.

use realfft::RealFftPlanner;

/// For each series of samples at `j / count` of a period, j = 0 …, the pairs `[A_n, B_n]` of
/// `A_0 + Σ_n A_n cos nθ + B_n sin nθ` for n below half of `count`.
///
/// All series have the same length. Exact for functions with fewer than `count / 2` wave numbers; above that, wave
/// number n is counted as `n - count` (aliasing).
#[must_use]
pub fn trigonometric_coefficients(series: &[Vec<f64>]) -> Vec<Vec<[f64; 2]>> {
    let count = series.first().map_or(0, Vec::len);
    if count == 0 {
        return vec![Vec::new(); series.len()];
    }
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(count);
    let mut spectrum = transform.make_output_vec();
    let mut all = Vec::with_capacity(series.len());
    for samples in series {
        let mut samples = samples.clone();
        // Fails for lengths other than the plan's alone.
        if transform.process(&mut samples, &mut spectrum).is_err() {
            all.push(Vec::new());
            continue;
        }
        let scale = 2.0 / count as f64;
        let mut pairs: Vec<[f64; 2]> =
            spectrum.iter().take(count.div_ceil(2)).map(|value| [scale * value.re, -scale * value.im]).collect();
        if let Some(mean) = pairs.first_mut() {
            *mean = [0.5 * mean[0], 0.0];
        }
        all.push(pairs);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_of_a_trigonometric_polynomial_are_its_own() {
        let function = |angle: f64| 0.5 - 2.0 * angle.cos() + 0.25 * (3.0 * angle).sin() + 7.0 * (5.0 * angle).cos();
        for count in [12, 16, 31] {
            let samples = (0..count).map(|j| function(std::f64::consts::TAU * f64::from(j) / f64::from(count)));
            let found = trigonometric_coefficients(&[samples.collect()]);
            let mut expected = vec![[0.0; 2]; (count as usize).div_ceil(2)];
            (expected[0], expected[1], expected[3], expected[5]) = ([0.5, 0.0], [-2.0, 0.0], [0.0, 0.25], [7.0, 0.0]);
            for (found, expected) in found[0].iter().flatten().zip(expected.iter().flatten()) {
                // Sums of at most 31 numbers below 10.
                assert!((found - expected).abs() < 1e-14 * 10.0, "{count}: {found} {expected}");
            }
        }
    }
}
