//! Exact solutions: the equation solved to rounding, on the closure of the basis.
//!
//! Where the basis has a finite closure under the equation's derivatives in v and t, the equation becomes a finite
//! system of ordinary differential equations in u (docs/methods.md, X1 to X3), solved once for all v and t. So the
//! solution holds at every instant, and an animation solves once. Coefficients may depend on u; the force may be any
//! function of the closure times any smooth function of u; any order in u and any boundary conditions that determine
//! a surface are treated.

mod amplification;
mod block;
mod component;
mod critical;
mod discretisation;
mod system;

use std::sync::Arc;

use nalgebra::DMatrix;
use rustc_hash::FxHashMap;

use super::{Method, Options, Report, Solution, Solver};
use crate::decompose::{Closure, Decomposition, close};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, compile};
use crate::expr::{ExprId, Notation};
use crate::features::{Feature, locate};
use crate::limits::Limits;
use crate::problem::PdeOperator;
use crate::surface::{Basis, Coefficients, SeparableSurface};
use crate::trial::{CorrectedTrial, Modes};

use block::Factorised;
use discretisation::Discretisation;
use system::{System, evaluate};

/// The method `exact`.
pub struct Exact;

/// Terms of the last size tried; layers that need more are reported.
const MOST_TERMS: usize = 512;
/// A residual below this that does not fall any more is rounding, which stiff equations amplify in the highest
/// derivative; it is reported by `verify` as what it is.
const NOISE: f64 = 1e-8;
/// Nodes at which a force or coefficients that depend on u are looked at once more before a solution is accepted, and with
/// them those where they are narrow.
const MANY_NODES: usize = 509;
const DEFAULT_TOLERANCE: f64 = 1e-12;

impl Method for Exact {
    fn name(&self) -> &'static str {
        "exact"
    }

    fn description(&self) -> &'static str {
        "the equation to rounding, where the basis has a finite closure; one solution for all t"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["tolerance"]
    }

    fn accepts(&self, decomposition: &Decomposition, limits: &Limits) -> Result<(), Diagnostic> {
        let (graph, operator) = (&decomposition.graph, &decomposition.operator);
        let depends = |expr: ExprId| graph.dependence(expr).v || graph.dependence(expr).t;
        if operator.terms.iter().flat_map(|term| term.coefficient).any(depends) {
            let message = "the method `exact` needs coefficients that do not depend on v or t";
            return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(operator.origin));
        }
        close(decomposition, limits).map(|_| ())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let tolerance = options.settings.tolerance.map_or(Ok(DEFAULT_TOLERANCE), |(tolerance, origin)| {
            if (1e-15..=1e-2).contains(&tolerance) {
                return Ok(tolerance);
            }
            let tolerance = Shortest(tolerance);
            let message = format!("the tolerance {tolerance} lies outside [1e-15, 1e-2]");
            Err(Diagnostic::new(Code::SettingOutOfRange, message).at(origin))
        })?;
        let closure = close(decomposition, &options.limits)?;
        let mut graph = closure.graph.clone();
        let system = System::build(&mut graph, &closure, &decomposition.operator);
        let varies_with_u = |exprs: &[ExprId]| exprs.iter().any(|expr| graph.dependence(*expr).u);
        let entries: Vec<ExprId> = system.entries.iter().map(|(_, expr)| *expr).collect();
        let forces: Vec<ExprId> = closure.force.iter().flatten().copied().collect();
        let positions = decomposition.patch.conditions.iter().map(|condition| condition.u);
        let constants: Vec<ExprId> =
            positions.chain(decomposition.coefficients.iter().flatten().flatten().copied()).collect();
        let interpreted = |outputs: &[ExprId]| compile(Program::compile(&graph, outputs), Backend::Interpreter).0;
        let functions = &closure.functions;
        let names = functions
            .iter()
            .map(|(expr, _)| graph.text(*expr, Notation::Ascii, 60).unwrap_or_else(|_| "a long expression".to_owned()));
        Ok(Box::new(ExactSolver {
            tolerance,
            order: decomposition.operator.order_in_u(),
            orders: decomposition.patch.conditions.iter().map(|condition| condition.order).collect(),
            basis_size: decomposition.basis.len(),
            origins: functions.iter().map(|(_, origin)| *origin).collect(),
            names: names.collect(),
            coefficients: critical::coefficient_symbols(decomposition),
            operator: decomposition.operator.clone(),
            has_force: forces.iter().any(|expr| !graph.is_zero(*expr)),
            entries_vary: varies_with_u(&entries),
            varying: entries.iter().chain(&forces).copied().filter(|expr| graph.dependence(*expr).u).collect(),
            entry_values: interpreted(&entries),
            force_values: interpreted(&forces),
            constant_values: interpreted(&constants),
            basis: Arc::new(Basis::new(&graph, functions, options.backend, &options.limits)),
            closure: Closure { graph, ..closure },
            system,
        }))
    }
}

struct ExactSolver {
    tolerance: f64,
    /// Order of the equation in u.
    order: usize,
    /// The order of each boundary condition.
    orders: Vec<usize>,
    /// How many functions of the closure carry boundary data: the first ones.
    basis_size: usize,
    origins: Vec<Option<Span>>,
    names: Vec<String>,
    /// The symbols in the equation's coefficients, with their names.
    coefficients: Vec<(usize, String)>,
    has_force: bool,
    entries_vary: bool,
    /// Entries and forces that depend on u, which may be narrow there.
    varying: Vec<ExprId>,
    operator: PdeOperator,
    /// The closure, its graph extended by the system.
    closure: Closure,
    system: System,
    entry_values: Arc<dyn Evaluator>,
    force_values: Arc<dyn Evaluator>,
    constant_values: Arc<dyn Evaluator>,
    basis: Arc<Basis>,
}

/// What is known while blocks are solved.
struct Progress<'a> {
    params: &'a [f64],
    range: [f64; 2],
    functionals: Vec<(f64, usize)>,
    /// Boundary coefficients by condition, basis function, component.
    boundary: Vec<f64>,
    /// Where entries and forces are narrow in u.
    features: Vec<Feature>,
    /// For each function that is solved, a row per mode.
    solved: Vec<Option<DMatrix<f64>>>,
    /// Functions of u by number of trial functions.
    modes: FxHashMap<usize, Arc<CorrectedTrial>>,
    /// Nodes, tables, entries and forces by number of nodes.
    discretisations: FxHashMap<usize, Arc<Discretisation>>,
    /// Factorised blocks by their numbers.
    factorised: FxHashMap<(usize, Vec<u64>), Arc<Factorised>>,
    worst: Option<Amplified>,
}

/// The block that amplifies most.
struct Amplified {
    factor: f64,
    members: Vec<usize>,
    component: usize,
    terms: usize,
    factorised: Arc<Factorised>,
}

impl Solver for ExactSolver {
    fn solve(&self, params: &[f64], [range, _]: [[f64; 2]; 2], _t: f64) -> Result<Solution, Diagnostic> {
        let constants = evaluate(&*self.constant_values, params, &[0.0])?;
        if let Some(at) = constants.iter().position(|value| !value.is_finite()) {
            let j = at.saturating_sub(self.orders.len()) / 3 % self.basis_size.max(1);
            let message = format!("the coefficient of `{}` in the boundary data is not finite", self.name(j));
            return Err(Diagnostic::new(Code::ParameterNotFinite, message).at(self.origin(j)));
        }
        let (positions, boundary) = constants.split_at_checked(self.orders.len()).unwrap_or_default();
        let mut progress = Progress {
            params,
            range,
            functionals: positions.iter().copied().zip(self.orders.iter().copied()).collect(),
            boundary: boundary.to_vec(),
            features: locate(&self.closure.graph, &self.varying, params, [range, range], 0.0).u,
            solved: vec![None; self.basis.len()],
            modes: FxHashMap::default(),
            discretisations: FxHashMap::default(),
            factorised: FxHashMap::default(),
            worst: None,
        };
        for members in &self.system.blocks {
            self.solve_block(members, &mut progress)?;
        }
        let terms = progress.solved.iter().flatten().map(|rows| rows.nrows() - self.orders.len()).max().unwrap_or(0);
        let modes = self.modes(terms, &mut progress)?;
        let count = self.basis.len();
        let mut coefficients: Coefficients = vec![[0.0; 3]; modes.count() * count];
        for (j, rows) in progress.solved.iter().enumerate() {
            let slots = coefficients.iter_mut().skip(j).step_by(count.max(1));
            for (slot, row) in slots.zip(rows.iter().flat_map(|rows| rows.row_iter())) {
                for (component, value) in slot.iter_mut().zip(row.iter()) {
                    *component = *value + 0.0;
                }
            }
        }
        let surface = SeparableSurface {
            modes,
            basis: Arc::clone(&self.basis),
            params: params.to_vec(),
            coefficients: Arc::new(vec![coefficients]),
            instant: None,
        };
        let amplification = progress.worst.as_ref().map_or(1.0, |worst| worst.factor);
        let warnings = self.judge(&mut progress)?;
        let unknowns = terms * count;
        let report = Report {
            method: Exact.name(),
            is_exact: true,
            basis_size: self.basis_size,
            closure_size: Some(count),
            modes: terms,
            condition: None,
            amplification: Some(amplification),
            truncation: None,
            rank: unknowns,
            unknowns,
            limit: None,
            warnings,
        };
        Ok(Solution { surface: Arc::new(surface), report })
    }

    fn is_everlasting(&self, _solution: &Solution) -> bool {
        true
    }
}

impl ExactSolver {
    /// The number of terms to begin with: enough, in most cases, for the fastest exponential of the block.
    fn first_terms(&self, members: &[usize], progress: &Progress<'_>) -> Result<usize, Diagnostic> {
        let [low, high] = progress.range;
        let spread = self.fastest_rate(members, progress)? * (high - low) * -libm::log(self.tolerance);
        // Measured over published problems; the tail decides, this only saves attempts.
        let wanted = 8.0 + 1.3 * spread.sqrt();
        // In steps of 6, so that blocks share nodes.
        let steps = (wanted / 6.0).ceil().clamp(3.0, 20.0);
        Ok(6 * steps as usize)
    }

    /// The solutions of `Σ_p b_p G^(p) = 0` vary as e^(κu) with |κ| up to about the largest `|b_p/b_n|^(1/(n-p))`, or 1.
    fn fastest_rate(&self, members: &[usize], progress: &Progress<'_>) -> Result<f64, Diagnostic> {
        let [low, high] = progress.range;
        let entries = self.entries_at(progress.params, &[0.5 * (low + high)])?;
        let value = |equation: usize, order: usize| -> f64 {
            let of_equation = self.system.entries.iter().zip(&entries).filter(|((place, _), _)| {
                place.equation == equation && place.order == order && members.contains(&place.unknown)
            });
            of_equation.flat_map(|(_, values)| values).fold(0.0, |most: f64, value| most.max(value.abs()))
        };
        let mut fastest: f64 = 1.0;
        for &equation in members {
            let leading = value(equation, self.order);
            for order in 0..self.order {
                let exponent = 1.0 / (self.order - order) as f64;
                fastest = fastest.max(libm::pow(value(equation, order) / leading, exponent));
            }
        }
        Ok(fastest)
    }

    /// Solves the functions of one block with as many terms as the tolerance needs.
    fn solve_block(&self, members: &[usize], progress: &mut Progress<'_>) -> Result<(), Diagnostic> {
        let mut terms = self.first_terms(members, progress)?;
        let mut before: Option<f64> = None;
        loop {
            let discretisation = self.discretise(terms, terms, progress)?;
            // One node more interlaces with the others; a force or coefficients in u may hide features between them.
            let is_smooth = !(self.entries_vary || self.has_force);
            let between = if is_smooth { terms + 1 } else { 2 * terms + 1 };
            let mut weights_of: Vec<DMatrix<f64>> = Vec::with_capacity(3);
            let mut rows: Vec<DMatrix<f64>> = vec![DMatrix::zeros(self.orders.len() + terms, 3); members.len()];
            let mut residual: f64 = 0.0;
            for component in 0..if self.system.is_vector { 3 } else { 1 } {
                let columns = if self.system.is_vector { component..component + 1 } else { 0..3 };
                let weights =
                    self.solve_component(members, component, columns.clone(), &discretisation, terms, progress)?;
                let here = self.residual_at(members, component, columns.clone(), &weights, between, progress)?;
                residual = residual.max(here);
                for (member, rows) in rows.iter_mut().enumerate() {
                    let part = weights.rows(member * terms, terms);
                    rows.view_mut((self.orders.len(), columns.start), (terms, columns.len())).copy_from(&part);
                }
                weights_of.push(weights);
            }
            // More terms no longer make a difference once the residual is rounding errors.
            let is_noise = residual <= NOISE && before.is_some_and(|before| residual >= 0.5 * before);
            let mut is_resolved = residual <= self.tolerance || is_noise;
            // Something narrow may lie between all of these nodes.
            if is_resolved && !is_smooth && (between < MANY_NODES || !progress.features.is_empty()) {
                for (component, weights) in weights_of.iter().enumerate() {
                    let columns = if self.system.is_vector { component..component + 1 } else { 0..3 };
                    let here = self.residual_at(members, component, columns, weights, MANY_NODES, progress)?;
                    is_resolved &= here <= NOISE;
                }
            }
            if is_resolved {
                for (&j, mut rows) in members.iter().zip(rows) {
                    rows.rows_mut(0, self.orders.len()).copy_from(&self.stated(j, progress));
                    if let Some(slot) = progress.solved.get_mut(j) {
                        *slot = Some(rows);
                    }
                }
                return Ok(());
            }
            if terms >= MOST_TERMS {
                return Err(self.unresolved(members, progress));
            }
            before = Some(residual);
            terms = (terms * 3 / 2).next_multiple_of(6).min(MOST_TERMS);
        }
    }

    /// The boundary coefficients of function `j`, a row per condition; zero for functions the closure added.
    fn stated(&self, j: usize, progress: &Progress<'_>) -> DMatrix<f64> {
        DMatrix::from_fn(self.orders.len(), 3, |condition, axis| {
            if j >= self.basis_size {
                return 0.0;
            }
            progress.boundary.get((condition * self.basis_size + j) * 3 + axis).copied().unwrap_or(f64::NAN)
        })
    }

    fn name(&self, j: usize) -> &str {
        self.names.get(j).map_or("?", String::as_str)
    }

    fn origin(&self, j: usize) -> Option<Span> {
        self.origins.get(j).copied().flatten()
    }
}
