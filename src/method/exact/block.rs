//! One block of the system: functions G_j that need each other, solved by spectral collocation.
//!
//! With `G = Σ_i ξ_i c_i + Σ_k w_k ζ_k`, where ζ_k^(n) is a Legendre polynomial up to the boundary's correction, the
//! equations are imposed at as many Gauss nodes as there are unknowns w_k (docs/methods.md, X3). The boundary is met
//! by construction. The number of terms grows until the last ones are below the tolerance.

use nalgebra::{DMatrix, Dyn, LU};

/// Functions of u at the nodes: for each order, a row per node, a column per cardinal and trial function.
#[derive(Clone)]
pub struct Tables {
    /// Values by order of derivative.
    pub values: Vec<DMatrix<f64>>,
    /// The number of cardinal functions.
    pub cardinal: usize,
}

/// The numbers of one block at given nodes.
pub struct BlockSystem {
    /// For each order, member equation and member unknown, the entry at every node, or a single one for all.
    pub entries: Vec<(usize, usize, usize, Vec<f64>)>,
    /// The number of members.
    pub members: usize,
}

/// Near resonance, where the number matters, one eigenvalue dominates and a few steps give three digits.
const ITERATIONS: usize = 12;

/// Where a power iteration starts: every direction is present, whatever the symmetry of the problem.
fn start(size: usize) -> DMatrix<f64> {
    DMatrix::from_fn(size, 1, |row, _| 1.0 / (1.0 + row as f64) + 0.1 * f64::from(u8::from(row % 3 == 0)))
}

/// A factorised block.
pub struct Factorised {
    lu: LU<f64, Dyn, Dyn>,
    matrix: DMatrix<f64>,
}

impl BlockSystem {
    fn entry(values: &[f64], node: usize) -> f64 {
        match values {
            [all] => *all,
            _ => values.get(node).copied().unwrap_or(f64::NAN),
        }
    }

    /// Everything that decides the block's matrix at given nodes, bit for bit.
    pub fn numbers(&self) -> Vec<u64> {
        let of_entry = |(order, equation, unknown, values): &(usize, usize, usize, Vec<f64>)| {
            let place = [*order, *equation, *unknown].map(|number| number as u64);
            place.into_iter().chain(values.iter().map(|value| value.to_bits())).collect::<Vec<u64>>()
        };
        self.entries.iter().flat_map(of_entry).collect()
    }

    /// Whether the derivatives of order `order` follow from the rest of the block, at every node.
    pub fn determines_highest(&self, order: usize) -> bool {
        let nodes = self.entries.iter().map(|(.., values)| values.len()).max().unwrap_or(1);
        (0..nodes).all(|node| {
            let mut leading = DMatrix::zeros(self.members, self.members);
            for (_, equation, unknown, values) in self.entries.iter().filter(|(found, ..)| *found == order) {
                if let Some(slot) = leading.get_mut((*equation, *unknown)) {
                    *slot = Self::entry(values, node);
                }
            }
            leading.lu().is_invertible()
        })
    }

    /// Applies the block to functions given by coefficients of the columns `from..` of the tables: rows are nodes of
    /// the first member's equation, then of the second's.
    pub fn matrix(&self, tables: &Tables, columns: std::ops::Range<usize>) -> DMatrix<f64> {
        self.assemble(tables, columns, |value, _| value)
    }

    /// Subtracts from `right` what the block makes of functions that are given by the weights of columns of the tables.
    /// Returns the largest single term `B G^(p)` at any node.
    pub fn subtract_image(
        &self,
        tables: &Tables,
        columns: std::ops::Range<usize>,
        weights: &DMatrix<f64>,
        right: &mut DMatrix<f64>,
    ) -> f64 {
        let width = columns.len();
        let mut largest: f64 = 0.0;
        for (order, equation, unknown, values) in &self.entries {
            let Some(table) = tables.values.get(*order) else { continue };
            let image = table.columns(columns.start, width) * weights.rows(unknown * width, width);
            largest = largest.max(subtract_scaled(right, equation * image.nrows(), &image, values));
        }
        largest
    }

    /// Whether only every other order from the highest down occurs.
    pub fn is_symmetric(&self, order: usize) -> bool {
        order.is_multiple_of(2) && self.entries.iter().all(|(found, ..)| found.is_multiple_of(2))
    }

    /// The matrix of the definite equation with the same sizes: every other order from the highest down, with
    /// alternating signs, as in `|β| D⁴ - |p| D² + |c|`. What the amplification is measured against.
    pub fn definite_matrix(&self, tables: &Tables, columns: std::ops::Range<usize>) -> DMatrix<f64> {
        let highest = tables.values.len().saturating_sub(1);
        self.assemble(tables, columns, |value, order| match (highest - order) % 4 {
            0 => value.abs(),
            2 => -value.abs(),
            _ => 0.0,
        })
    }

    fn assemble(
        &self,
        tables: &Tables,
        columns: std::ops::Range<usize>,
        weigh: impl Fn(f64, usize) -> f64,
    ) -> DMatrix<f64> {
        let nodes = tables.values.first().map_or(0, DMatrix::nrows);
        let width = columns.len();
        let mut matrix = DMatrix::zeros(self.members * nodes, self.members * width);
        for (order, equation, unknown, values) in &self.entries {
            let Some(table) = tables.values.get(*order) else { continue };
            let factors: Vec<f64> = values.iter().map(|value| weigh(*value, *order)).collect();
            let mut target = matrix.view_mut((equation * nodes, unknown * width), (nodes, width));
            for (mut target, source) in target.column_iter_mut().zip(table.columns(columns.start, width).column_iter())
            {
                let numbers = target.iter_mut().zip(&source);
                for ((slot, value), factor) in numbers.zip(at_nodes(&factors)) {
                    *slot += value * factor;
                }
            }
        }
        matrix
    }
}

/// The values of an entry at one node after the other: a single one holds at all.
fn at_nodes(values: &[f64]) -> impl Iterator<Item = f64> {
    let repeated = if let [all] = values { Some(*all) } else { None };
    values.iter().copied().filter(move |_| repeated.is_none()).chain(repeated.into_iter().cycle())
}

/// Subtracts from the rows `first..` of `target` those of `image`, each times the value at its node. Returns the largest
/// number that is subtracted.
pub fn subtract_scaled(target: &mut DMatrix<f64>, first: usize, image: &DMatrix<f64>, values: &[f64]) -> f64 {
    let mut largest: f64 = 0.0;
    let mut rows = target.rows_mut(first, image.nrows());
    for (mut target, image) in rows.column_iter_mut().zip(image.column_iter()) {
        for ((slot, value), factor) in target.iter_mut().zip(&image).zip(at_nodes(values)) {
            let term = value * factor;
            largest = largest.max(term.abs());
            *slot -= term;
        }
    }
    largest
}

impl Factorised {
    /// Factorises a square matrix; `None` if it is singular or not finite.
    pub fn new(matrix: DMatrix<f64>) -> Option<Factorised> {
        if matrix.iter().any(|value| !value.is_finite()) {
            return None;
        }
        let lu = matrix.clone().lu();
        lu.is_invertible().then_some(Factorised { lu, matrix })
    }

    /// The matrix that was factorised.
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.matrix
    }

    /// The solution for each column of `right`, with one step of refinement.
    pub fn solve(&self, right: &DMatrix<f64>) -> Option<DMatrix<f64>> {
        let mut solution = self.lu.solve(right)?;
        solution += self.lu.solve(&(right - &self.matrix * &solution))?;
        solution.iter().all(|value| value.is_finite()).then_some(solution)
    }

    /// How much larger solutions can be than those of the definite equation: the spectral radius of A⁻¹ E, by power
    /// iteration from a fixed start. 1 for definite equations, unbounded near resonance.
    ///
    /// With odd orders (`is_symmetric` false) E can send the resonant function to where A does not reach it, and the
    /// radius misses it; the largest growth of any step is taken instead.
    pub fn amplification(&self, definite: &DMatrix<f64>, is_symmetric: bool) -> f64 {
        if *definite == self.matrix {
            return 1.0;
        }
        let mut vector = start(definite.nrows());
        let mut growth: f64 = 1.0;
        for _ in 0..ITERATIONS {
            let Some(image) = self.lu.solve(&(definite * &vector)) else { return f64::INFINITY };
            let length = image.norm();
            let step = length / vector.norm();
            growth = if is_symmetric { step } else { growth.max(step) };
            if !step.is_finite() {
                return f64::INFINITY;
            }
            if length == 0.0 {
                break;
            }
            vector = image / length;
        }
        growth.max(1.0)
    }

    /// How far a coefficient of the equation is from the nearest value that makes the block singular, given the
    /// derivative of the block's matrix in that coefficient: the block is singular at a distance of -1/μ for each
    /// eigenvalue μ of A⁻¹ ∂A, and the largest |μ| is found by power iteration.
    ///
    /// `None` if no single eigenvalue dominates.
    pub fn distance_to_singular(&self, derivative: &DMatrix<f64>) -> Option<f64> {
        let size = derivative.nrows();
        let mut vector = start(size);
        let mut eigenvalue = 0.0;
        for _ in 0..4 * ITERATIONS {
            let image = self.lu.solve(&(derivative * &vector))?;
            eigenvalue = image.dot(&vector) / vector.dot(&vector);
            let miss = (&image - &vector * eigenvalue).norm();
            let length = image.norm();
            if !length.is_finite() || length == 0.0 {
                return None;
            }
            if miss <= 1e-9 * length {
                break;
            }
            vector = image / length;
        }
        let image = self.lu.solve(&(derivative * &vector))?;
        let is_dominant = (&image - &vector * eigenvalue).norm() <= 1e-4 * image.norm();
        is_dominant.then(|| -1.0 / eigenvalue)
    }
}
