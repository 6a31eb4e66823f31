//! The method of You, Ugail and Zhang 2012 (Eqs. 9-18, corrected): K sine terms for each basis function, fitted
//! to the equation at L x M collocation points by least squares.
//!
//! With `G_j(u) = Σ_i ξ_i(u) c_ij + Σ_k ζ_k(u) P_jk` the equation, taken for each basis function alone, reads
//! `Σ_p a_p(v) G_j^(p)(u) = 0`, where `a_p(v, t) = Σ_r c_r ∂F_j` collects the terms of order p in u
//! (docs/methods.md, S1). It is a linear least-squares problem for P_jk at each instant.
//!
//! Where a basis function is no eigenfunction of the operator, the equation cannot hold for it alone, however
//! many terms are taken; the verified residual tells. The method leaves out a force, as the paper does, and
//! therefore refuses one.

mod collocation;

use std::sync::{Arc, Mutex, PoisonError};

use nalgebra::DMatrix;

use super::equation::{Boundary, Equation, place};
use super::{Method, Options, Report, Size, Solution, Solver, Systems, Terms};
use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::limits::Limits;
use crate::numeric::{NodeKind, nodes};
use crate::trial::{CorrectedTrial, Modes, Sine};

use collocation::Collocation;

/// The method `sine`.
pub struct SineSeries;

const DEFAULT_TERMS: usize = 10;
const DEFAULT_POINTS: usize = 11;

impl Method for SineSeries {
    fn name(&self) -> &'static str {
        "sine"
    }

    fn description(&self) -> &'static str {
        "K sine terms per basis function, fitted at L x M points (You, Ugail and Zhang 2012, corrected)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms", "points"]
    }

    fn accepts(&self, decomposition: &Decomposition, _limits: &Limits) -> Result<(), Diagnostic> {
        let (graph, operator) = (&decomposition.graph, &decomposition.patch.operator);
        let refuse = |message: &str| {
            let finding = Diagnostic::new(Code::UnsupportedByMethod, message);
            Err(finding.at(operator.origin))
        };
        if !operator.is_homogeneous(graph) {
            return refuse("the method `sine` leaves out the force, so it cannot treat an equation with one");
        }
        if operator.terms.iter().flat_map(|term| term.coefficient).any(|coefficient| graph.dependence(coefficient).u) {
            return refuse("the method `sine` needs coefficients that do not depend on u");
        }
        Ok(())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let (terms, points) = sizes(decomposition, options, decomposition.patch.operator.order_in_t())?;
        let equation = Equation::compile(decomposition, options)?;
        Ok(Box::new(SineSolver { terms, points, equation, last: Mutex::default() }))
    }
}

/// The number of terms and the grid, checked.
fn sizes(decomposition: &Decomposition, options: &Options, orders_in_t: usize) -> Result<(usize, Size), Diagnostic> {
    let (terms, terms_origin) = match options.settings.terms {
        None => (DEFAULT_TERMS, None),
        Some((Terms { first, second: None }, origin)) => (first, origin),
        Some((Terms { second: Some(_), .. }, origin)) => {
            let finding = Diagnostic::new(Code::UnknownSetting, "the method `sine` has one number of terms").at(origin);
            return Err(finding.hint("write `terms = 5`"));
        }
    };
    if terms == 0 {
        let finding = Diagnostic::new(Code::SettingOutOfRange, "the number of terms is 0");
        return Err(finding.at(terms_origin).hint("give at least one: `terms = 5`"));
    }
    let default = Size { u: terms.saturating_add(1).max(DEFAULT_POINTS), v: DEFAULT_POINTS, kind: NodeKind::default() };
    let (points, points_origin) = options.settings.points.unwrap_or((default, None));
    if points.u == 0 || points.v == 0 {
        let message = format!("the grid {} x {} has no points", points.u, points.v);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message).at(points_origin));
    }
    if points.u < terms.saturating_add(1) {
        let message = format!("{} points in u do not determine {terms} terms", points.u);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message)
            .at(points_origin.or(terms_origin))
            .hint(format!("give at least {} points in u", terms.saturating_add(1))));
    }
    let limits = &options.limits;
    let per_row = decomposition.patch.operator.order_in_u() + 1;
    let reduced_rows = points.u.saturating_mul(per_row).saturating_mul(orders_in_t + 1);
    let systems = Systems {
        count: decomposition.basis.len(),
        rows: reduced_rows,
        unknowns: terms,
        entries: 0,
        points: points.u.saturating_mul(points.v),
    };
    systems.check(limits).map_err(|finding| finding.at(points_origin.or(terms_origin)))?;
    Ok((terms, points))
}

struct SineSolver {
    terms: usize,
    points: Size,
    equation: Equation,
    /// What other instants have in common with the last.
    last: Mutex<Option<Arc<Functions>>>,
}

/// The functions of u over one range, for boundary conditions at some places.
struct Functions {
    functionals: Vec<(f64, usize)>,
    range: [f64; 2],
    modes: Arc<CorrectedTrial>,
    collocation: Collocation,
}

impl Solver for SineSolver {
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let equation = &self.equation;
        let boundary = equation.boundary(params)?;
        let functions = self.functions(&boundary, ranges[0])?;
        let Functions { modes, collocation, .. } = &*functions;
        let v = nodes(self.points.kind, self.points.v, ranges[1]);
        let is_visible = equation.visible_on(&v, ranges[1], t, params)?;
        let count = equation.basis.len();
        // The symbols do not depend on u, so any u will do.
        let quotients = equation.quotients_at(&ranges[0][..1], t, params)?;
        let symbols = match (0..count).all(|j| equation.has_quotients(j)) {
            true => Vec::new(),
            false => equation.symbols_at(&vec![ranges[0][0]; v.len()], &v, t, params)?,
        };
        let mut coefficients = equation.no_coefficients(modes.count());
        let mut report = self.empty_report();
        for j in 0..count {
            let (values, nodes) = if equation.has_quotients(j) { (&quotients, 1) } else { (&symbols, v.len()) };
            let size = equation.values_per_function(nodes);
            let rows = values.get(j * size..(j + 1) * size).unwrap_or_default();
            let stated = boundary.stated(j);
            if !is_visible.get(j).copied().unwrap_or(false) && stated.iter().any(|value| *value != 0.0) {
                return Err(equation.vanishes(j));
            }
            let fits = self.fit(collocation, (rows, nodes), &stated, j, &mut report)?;
            for (coefficients, fit) in coefficients.iter_mut().zip(&fits) {
                place(coefficients, (j, count), 0, &[0, 1, 2], fit);
            }
        }
        let surface = equation.surface(Arc::clone(modes), coefficients, params, t);
        Ok(Solution { surface: Arc::new(surface), report })
    }
}

impl SineSolver {
    /// The functions of u, which are those of the last solution unless the boundary moved.
    fn functions(&self, boundary: &Boundary, range: [f64; 2]) -> Result<Arc<Functions>, Diagnostic> {
        // A panic elsewhere leaves either the one or the other.
        let lock = || self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let is_it = |known: &&Arc<Functions>| known.functionals == boundary.functionals && known.range == range;
        if let Some(known) = lock().as_ref().filter(is_it) {
            return Ok(Arc::clone(known));
        }
        let modes = Arc::new(self.equation.modes(Arc::new(Sine), self.terms, range, boundary)?);
        let u = nodes(self.points.kind, self.points.u, range);
        let collocation = Collocation::new(&modes, &self.equation.orders_in_u, &u);
        let functions = Arc::new(Functions { functionals: boundary.functionals.clone(), range, modes, collocation });
        *lock() = Some(Arc::clone(&functions));
        Ok(functions)
    }

    /// The boundary and fitted coefficients of one basis function and their derivatives in t: one row per mode.
    fn fit(
        &self,
        collocation: &Collocation,
        (rows, nodes): (&[f64], usize),
        stated: &DMatrix<f64>,
        j: usize,
        report: &mut Report,
    ) -> Result<Vec<DMatrix<f64>>, Diagnostic> {
        let (equation, conditions) = (&self.equation, self.equation.orders.len());
        let mut fits = vec![DMatrix::zeros(conditions + self.terms, 3); equation.orders_in_t + 1];
        if let Some(first) = fits.first_mut() {
            first.rows_mut(0, conditions).copy_from(stated);
        }
        for (component, rows) in rows.chunks(equation.values_per_component(nodes).max(1)).enumerate() {
            let columns = if equation.is_vector() { component..component + 1 } else { 0..3 };
            let right = stated.columns(columns.start, columns.len()).into_owned();
            let fit = match equation.has_quotients(j) {
                true => collocation.fit_quotients(rows, &right),
                false => collocation.fit(rows, nodes, &right),
            };
            let fit = fit.map_err(|error| {
                let message = format!("the system of basis function F{} cannot be solved: {error}", j + 1);
                Diagnostic::new(Code::SolutionNotFinite, message).at(equation.origin(j))
            })?;
            report.condition = report.condition.map(|condition| condition.max(fit.condition));
            report.rank += fit.rank;
            report.unknowns += self.terms;
            if fit.rank < self.terms {
                let message = format!(
                    "the points determine {} of {} terms of basis function F{}; the smallest solution is taken",
                    fit.rank,
                    self.terms,
                    j + 1
                );
                let finding = Diagnostic::new(Code::RankDeficient, message);
                report
                    .warnings
                    .push(finding.at(equation.origin(j)).hint("use midpoints, more points in u, or fewer terms"));
            }
            for (all, part) in fits.iter_mut().zip(&fit.derivatives) {
                all.view_mut((conditions, columns.start), (self.terms, columns.len())).copy_from(part);
            }
        }
        if fits.iter().any(|fit| fit.iter().any(|value| !value.is_finite())) {
            let message = format!("the fit of basis function F{} is not finite", j + 1);
            return Err(Diagnostic::new(Code::SolutionNotFinite, message).at(equation.origin(j)));
        }
        Ok(fits)
    }

    fn empty_report(&self) -> Report {
        Report {
            method: SineSeries.name(),
            is_exact: false,
            basis_size: self.equation.basis.len(),
            closure_size: None,
            modes: self.terms,
            condition: Some(1.0),
            amplification: None,
            truncation: None,
            rank: 0,
            unknowns: 0,
            limit: None,
            warnings: self.equation.note.iter().cloned().collect::<Diagnostics>(),
        }
    }
}
