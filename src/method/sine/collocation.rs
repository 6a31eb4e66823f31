//! The least-squares problem of one basis function, reduced exactly from L·M rows to a few L.
//!
//! At the collocation points the residual is `Σ_p a_p(v_m) G^(p)(u_l)`. With the a_p as columns of an M x P
//! matrix A = Q R, the sum of its squares over all m is that of `Σ_p R_ip G^(p)(u_l)` over the rows i of R:
//! M rows become at most P, exactly (docs/methods.md, S2).
//!
//! The fitted P_k depend on t through A; their derivatives are those of a least-squares solution (S3).

use std::sync::{Arc, Mutex, PoisonError};

use nalgebra::DMatrix;

use crate::numeric::{LeastSquares, LeastSquaresError};
use crate::trial::{CorrectedTrial, Modes};

/// The functions of u at the collocation nodes.
pub struct Collocation {
    /// For each order in u that occurs: rows are nodes, columns the cardinal functions.
    cardinal: Vec<DMatrix<f64>>,
    /// The same for the corrected trial functions.
    trial: Vec<DMatrix<f64>>,
    /// What was factorised for the last quotients.
    shared: Mutex<Vec<(Vec<f64>, Arc<Shared>)>>,
}

/// The factorised system of functions that the equation multiplies alike.
struct Shared {
    /// The coefficients P_k for each boundary coefficient: they are linear in them.
    response: DMatrix<f64>,
    condition: f64,
    rank: usize,
}

/// Systems that are remembered.
const KEPT: usize = 64;

/// A fit and its derivatives in t.
pub struct Fit {
    /// Coefficients P_k, one column per right-hand side, then their derivatives in t.
    pub derivatives: Vec<DMatrix<f64>>,
    /// Condition of the collocation matrix.
    pub condition: f64,
    /// Its rank.
    pub rank: usize,
}

impl Collocation {
    /// The values of `modes` at the nodes `u`, for the derivatives of the given orders.
    pub fn new(modes: &CorrectedTrial, orders_in_u: &[usize], u: &[f64]) -> Collocation {
        let count = modes.cardinal_count();
        let (mut cardinal, mut trial) = (Vec::new(), Vec::new());
        for &order in orders_in_u {
            let rows: Vec<f64> = u.iter().flat_map(|&u| modes.derivatives(order, u)).collect();
            let all = DMatrix::from_row_slice(u.len(), modes.count(), &rows);
            cardinal.push(all.columns(0, count).into_owned());
            trial.push(all.columns(count, modes.count() - count).into_owned());
        }
        Collocation { cardinal, trial, shared: Mutex::default() }
    }

    /// Fits a function that the equation only multiplies, by the κ_p in `quotients` with their derivatives in t, zeros: as
    /// many equations as nodes in u, with a matrix that is factorised once for all functions and instants that have the κ_p.
    pub fn fit_quotients(&self, quotients: &[f64], stated: &DMatrix<f64>) -> Result<Fit, LeastSquaresError> {
        let orders = self.cardinal.len();
        let (now, later) = quotients.split_at_checked(orders).unwrap_or_default();
        let is_zero = |values: &[f64]| values.iter().all(|value| *value == 0.0);
        if is_zero(now) || is_zero(stated.as_slice()) {
            return self.fit(quotients, 1, stated);
        }
        let shared = self.shared(now)?;
        let first = &shared.response * stated;
        let zeros = DMatrix::zeros(first.nrows(), first.ncols());
        let further = later.chunks(orders.max(1)).map(|_| zeros.clone());
        let derivatives = std::iter::once(first).chain(further).collect();
        Ok(Fit { derivatives, condition: shared.condition, rank: shared.rank })
    }

    fn shared(&self, quotients: &[f64]) -> Result<Arc<Shared>, LeastSquaresError> {
        // A panic elsewhere leaves the list whole.
        let lock = || self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = lock().iter().find(|(known, _)| known == quotients) {
            return Ok(Arc::clone(known));
        }
        let part = DMatrix::from_row_slice(1, quotients.len(), quotients);
        let solver = LeastSquares::new(&combine(&part, &self.trial))?;
        let response = -solver.solve(&combine(&part, &self.cardinal));
        let shared = Arc::new(Shared { response, condition: solver.condition(), rank: solver.rank() });
        let mut all = lock();
        if all.len() >= KEPT {
            all.remove(0);
        }
        all.push((quotients.to_vec(), Arc::clone(&shared)));
        Ok(shared)
    }

    /// Fits the trial functions to the boundary coefficients `stated` (a row per condition, any columns).
    ///
    /// `symbols` holds the a_p at `nodes` nodes: first all p, then all p of the first derivative in t, and so on.
    pub fn fit(&self, symbols: &[f64], nodes: usize, stated: &DMatrix<f64>) -> Result<Fit, LeastSquaresError> {
        let orders = self.cardinal.len();
        let columns = symbols.len() / nodes.max(1);
        let in_time = columns / orders.max(1);
        let terms = self.trial.first().map_or(0, DMatrix::ncols);
        let zeros = || DMatrix::zeros(terms, stated.ncols());
        // Without boundary data, or where the equation holds whatever G is, no terms are needed.
        let holds_anyway = symbols.iter().take(orders * nodes).all(|value| *value == 0.0);
        if holds_anyway || stated.iter().all(|value| *value == 0.0) {
            return Ok(Fit { derivatives: (0..in_time).map(|_| zeros()).collect(), condition: 1.0, rank: terms });
        }
        let reduced = DMatrix::from_column_slice(nodes, columns, symbols).qr().r();
        let (mut systems, mut rights) = (Vec::new(), Vec::new());
        for s in 0..in_time {
            let part = reduced.columns(s * orders, orders).into_owned();
            systems.push(combine(&part, &self.trial));
            rights.push(combine(&part, &self.cardinal) * stated);
        }
        let solver = LeastSquares::new(systems.first().unwrap_or(&DMatrix::zeros(0, 0)))?;
        let derivatives = solver.derivatives(&systems, &rights);
        Ok(Fit { derivatives, condition: solver.condition(), rank: solver.rank() })
    }
}

/// Row block i is `Σ_p part_ip * values_p`.
fn combine(part: &DMatrix<f64>, values: &[DMatrix<f64>]) -> DMatrix<f64> {
    let (rows, columns) = values.first().map_or((0, 0), DMatrix::shape);
    let mut combined = DMatrix::zeros(part.nrows() * rows, columns);
    for (block, weights) in part.row_iter().enumerate() {
        let mut target = combined.rows_mut(block * rows, rows);
        for (weight, values) in weights.iter().zip(values) {
            target += values * *weight;
        }
    }
    combined
}
