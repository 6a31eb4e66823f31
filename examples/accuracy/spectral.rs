//! What YZ03 compare with: a truncated Fourier series of data that are not periodic, which the method `fourier` refuses,
//! and the pseudospectral method, which adds a remainder. Made of the library's pieces.

use trimline::blend::Blend;
use trimline::diagnostic::Diagnostic;
use trimline::eval::Backend;
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::numeric::trigonometric_coefficients;
use trimline::surface::{Basis, Surface};
use trimline::trial::{CardinalExponentials, Modes};

/// Samples of one turn. Their error is that of the trapezoidal rule, below 1e-7.
const SAMPLES: usize = 1 << 14;

/// `Σ_n Σ_i K_i(u; a n) (A_n^i cos nv + B_n^i sin nv)` for position and tangent at u = 0 and 1, and a remainder.
pub struct Spectral {
    /// The functions K_i of wave number n = 0 … N.
    modes: Vec<CardinalExponentials>,
    /// Those of the remainder, if there is one.
    remainder: Option<CardinalExponentials>,
    /// The pairs `[A_n, B_n]` by condition and component.
    coefficients: Vec<Vec<[f64; 2]>>,
    data: Data,
}

/// The boundary data as they are stated.
struct Data {
    basis: Basis,
    /// By condition and component, the coefficient of each basis function.
    stated: Vec<Vec<f64>>,
    params: Vec<f64>,
}

impl Data {
    fn new(blend: &Blend) -> Option<Data> {
        let decomposition = &blend.patches.first()?.decomposition;
        let params = blend.bindings.as_slice().to_vec();
        let graph = &decomposition.graph;
        let rows = decomposition.coefficients.iter().flat_map(|row| {
            [0, 1, 2].map(|component| {
                let values = row.iter().filter_map(|vector| vector.get(component));
                values.map(|expr| graph.value(*expr, &params, [f64::NAN; 3])).collect()
            })
        });
        let stated = rows.collect();
        let functions: Vec<_> = decomposition.basis.iter().map(|function| (function.expr, function.origin)).collect();
        let basis = Basis::new(graph, &functions, Backend::Interpreter, &Limits::default());
        Some(Data { basis, stated, params })
    }

    /// A derivative in v of every prescribed value, by condition and component.
    fn at(&self, order: usize, v: &[f64]) -> Result<Vec<Vec<f64>>, Diagnostic> {
        let values = self.basis.values(Derivative::new(0, order, 0), &self.params, v, &vec![0.0; v.len()])?;
        let sum = |coefficients: &Vec<f64>| {
            let mut total = vec![0.0; v.len()];
            for (coefficient, function) in coefficients.iter().zip(values.chunks(v.len())) {
                for (sum, value) in total.iter_mut().zip(function) {
                    *sum += coefficient * value;
                }
            }
            total
        };
        Ok(self.stated.iter().map(sum).collect())
    }
}

impl Spectral {
    /// N = `count` modes for the equation `(∂²/∂u² + a² ∂²/∂v²)² S = 0`; the remainder's functions are those of
    /// `(∂²/∂u² - ω²)² G = 0`.
    ///
    /// # Errors
    /// Data that cannot be evaluated.
    pub fn new(blend: &Blend, a: f64, count: usize, omega: Option<f64>) -> Result<Option<Spectral>, Diagnostic> {
        let Some(data) = Data::new(blend) else { return Ok(None) };
        let v: Vec<f64> = (0..=SAMPLES).map(|j| std::f64::consts::TAU * j as f64 / SAMPLES as f64).collect();
        let mut samples = data.at(0, &v)?;
        for values in &mut samples {
            // The series takes the mean where the data jump.
            let last = values.pop().unwrap_or(0.0);
            if let Some(first) = values.first_mut() {
                *first = 0.5 * (*first + last);
            }
        }
        let mut coefficients = trigonometric_coefficients(&samples);
        coefficients.iter_mut().for_each(|pairs| pairs.truncate(count + 1));
        let functions = |w: f64| CardinalExponentials::new(w, [0.0, 1.0], &[(0.0, 0), (0.0, 1), (1.0, 0), (1.0, 1)]);
        let modes = (0..=count).filter_map(|n| functions(a * n as f64)).collect();
        Ok(Some(Spectral { modes, remainder: omega.and_then(functions), coefficients, data }))
    }
}

impl Surface for Spectral {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let v: Vec<f64> = points.iter().map(|[_, v, _]| *v).collect();
        let stated = self.data.at(derivative.v, &v)?;
        for (index, ([u, v, _], value)) in points.iter().zip(values.iter_mut()).enumerate() {
            *value = [0.0; 3];
            let waves: Vec<[f64; 2]> = (0..self.modes.len()).map(|n| wave(n as f64, derivative.v, *v)).collect();
            let remainder = self.remainder.as_ref().map(|functions| functions.derivatives(derivative.u, *u));
            let across: Vec<Vec<f64>> = self.modes.iter().map(|modes| modes.derivatives(derivative.u, *u)).collect();
            for (row, pairs) in self.coefficients.iter().enumerate() {
                let (condition, component) = (row / 3, row % 3);
                let Some(slot) = value.get_mut(component) else { continue };
                let mut left = stated.get(row).and_then(|data| data.get(index)).copied().unwrap_or(f64::NAN);
                for ((pair, wave), functions) in pairs.iter().zip(&waves).zip(&across) {
                    let part = pair[0] * wave[0] + pair[1] * wave[1];
                    left -= part;
                    *slot += part * functions.get(condition).copied().unwrap_or(f64::NAN);
                }
                if let Some(functions) = &remainder {
                    *slot += left * functions.get(condition).copied().unwrap_or(f64::NAN);
                }
            }
        }
        Ok(())
    }
}

/// The derivatives of order `order` of cos nv and sin nv.
fn wave(n: f64, order: usize, v: f64) -> [f64; 2] {
    let (sine, cosine) = (n * v).sin_cos();
    let factor = n.powi(i32::try_from(order).unwrap_or(0));
    let [a, b] = match order % 4 {
        0 => [cosine, sine],
        1 => [-sine, cosine],
        2 => [-cosine, -sine],
        _ => [sine, -cosine],
    };
    [factor * a, factor * b]
}
