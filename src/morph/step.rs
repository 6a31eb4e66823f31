//! Surfaces between surfaces, and how far apart two of them are.

use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::surface::Surface;

/// `Σ weight · surface`: for example a frame between two numbers of modes.
pub struct WeightedSurface {
    /// Weights and surfaces, over the same domain.
    pub parts: Vec<(f64, Arc<dyn Surface + Send + Sync>)>,
}

impl Surface for WeightedSurface {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let mut part = vec![[0.0; 3]; values.len()];
        values.fill([0.0; 3]);
        for (weight, surface) in &self.parts {
            surface.evaluate(derivative, points, &mut part)?;
            for (value, part) in values.iter_mut().flatten().zip(part.iter().flatten()) {
                *value += weight * part;
            }
        }
        Ok(())
    }

    fn breaks(&self, domain: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        let mut all = [Vec::new(), Vec::new()];
        for (_, surface) in &self.parts {
            let found = surface.breaks(domain, t)?;
            all.iter_mut().zip(found).for_each(|(all, found)| all.extend(found));
        }
        Ok(all)
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        axes: (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        let mut part = vec![[0.0; 3]; values.len()];
        values.fill([0.0; 3]);
        for (weight, surface) in &self.parts {
            surface.evaluate_grid(derivative, axes, &mut part)?;
            for (value, part) in values.iter_mut().flatten().zip(part.iter().flatten()) {
                *value += weight * part;
            }
        }
        Ok(())
    }
}

/// Points across and along at which surfaces are compared.
const POINTS: [usize; 2] = [41, 129];

/// The largest distance of points with the same parameters at instant `t`, over 41 x 129 points of the ranges of u and v.
///
/// # Errors
/// As [`Surface::evaluate`].
pub fn distance(first: &dyn Surface, second: &dyn Surface, ranges: [[f64; 2]; 2], t: f64) -> Result<f64, Diagnostic> {
    let [range_u, range_v] = ranges;
    let [u, v] = [(range_u, POINTS[0]), (range_v, POINTS[1])].map(|([low, high], count)| -> Vec<f64> {
        let share = |i: usize| i as f64 / (count - 1) as f64;
        (0..count).map(|i| (low * (1.0 - share(i)) + high * share(i)).clamp(low, high)).collect()
    });
    let mut values = [vec![[0.0; 3]; u.len() * v.len()], vec![[0.0; 3]; u.len() * v.len()]];
    for (surface, values) in [first, second].into_iter().zip(&mut values) {
        surface.evaluate_grid(Derivative::NONE, (&u, &v, t), values)?;
    }
    let [first, second] = values;
    let apart = |([a, b, c], [x, y, z]): (&[f64; 3], &[f64; 3])| libm::hypot(libm::hypot(a - x, b - y), c - z);
    Ok(first.iter().zip(&second).map(apart).fold(0.0, f64::max))
}
