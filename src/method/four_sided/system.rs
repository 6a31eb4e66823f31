//! The equations for the corrections, scaled, factorised, and how much they amplify.

use nalgebra::DMatrix;

use crate::numeric::LinearSystem;

/// A matrix scaled to a unit diagonal, and factorised.
pub struct System {
    /// How much larger solutions can be than those of the terms of highest order alone; 1 without other terms.
    pub amplification: f64,
    /// The condition of the scaled matrix, estimated.
    pub condition: f64,
    factors: Vec<f64>,
    factorised: LinearSystem,
}

/// Steps of the power iteration; near resonance one eigenvalue stands far above the others.
const STEPS: usize = 40;

impl System {
    /// The system `leading + lower`, where `leading` holds the terms of highest order; `None` if it is singular.
    pub fn new(leading: DMatrix<f64>, lower: &DMatrix<f64>) -> Option<System> {
        let matrix = &leading + lower;
        let scale = |entry: &f64| if *entry == 0.0 { 1.0 } else { 1.0 / libm::sqrt(entry.abs()) };
        let factors: Vec<f64> = leading.diagonal().iter().map(scale).collect();
        let factorised = LinearSystem::new(scaled(matrix, &factors))?;
        let mut system = System { amplification: 1.0, condition: factorised.condition(), factors, factorised };
        if lower.iter().any(|entry| *entry != 0.0) {
            system.amplification = system.amplification_of(&scaled(leading, &system.factors));
        }
        Some(system)
    }

    /// The corrections for right-hand sides.
    pub fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        self.scaled_rows(self.factorised.solve(&self.scaled_rows(right.clone())))
    }

    fn scaled_rows(&self, mut values: DMatrix<f64>) -> DMatrix<f64> {
        for (mut row, factor) in values.row_iter_mut().zip(&self.factors) {
            row *= *factor;
        }
        values
    }

    /// The spectral radius of `A⁻¹ E` with E the scaled leading part, by power iteration.
    fn amplification_of(&self, leading: &DMatrix<f64>) -> f64 {
        let count = leading.nrows();
        // No symmetry of the patch is orthogonal to numbers that fall like this.
        let mut x = DMatrix::from_fn(count, 1, |row, _| 1.0 / (row + 1) as f64);
        let mut radius = 1.0;
        for _ in 0..STEPS {
            let y = self.factorised.solve(&(leading * &x));
            radius = y.norm() / x.norm();
            if !radius.is_finite() || radius == 0.0 {
                return f64::INFINITY;
            }
            x = y / radius;
        }
        radius
    }
}

/// Rows and columns times their factors.
fn scaled(mut matrix: DMatrix<f64>, factors: &[f64]) -> DMatrix<f64> {
    for (mut row, factor) in matrix.row_iter_mut().zip(factors) {
        row *= *factor;
    }
    for (mut column, factor) in matrix.column_iter_mut().zip(factors) {
        column *= *factor;
    }
    matrix
}
