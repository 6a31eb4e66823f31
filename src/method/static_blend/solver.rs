//! From numbers to a surface: the collocation systems of one instant, and what is to be said about them.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::StaticBlend;
use super::collocation::{Collocation, along_u};
use super::modes::{BlendModes, CARDINAL};
use super::null_space::smallest_exponent;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Span};
use crate::eval::{Evaluator, Samples};
use crate::expr::Derivative;
use crate::method::{Method, Report, Size, Solution, Solver};
use crate::numeric::{LeastSquares, nodes};
use crate::surface::{Basis, Coefficients, SeparableSurface};
use crate::trial::Modes;

/// The orders of one term of the equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TermValues {
    pub u: usize,
    pub v: usize,
}

/// A compiled problem.
pub struct StaticSolver {
    /// Highest powers of u and v.
    pub powers: [usize; 2],
    pub points: Size,
    /// Derivatives in t that the equation names, all with coefficient zero.
    pub orders_in_t: usize,
    /// Whether data, coefficients or force depend on t.
    pub varies_in_time: bool,
    /// Whether the three components have different coefficients.
    pub is_vector: bool,
    /// Whether the coefficients are numbers and params.
    pub are_constant: bool,
    /// The terms without derivatives in t.
    pub terms: Vec<TermValues>,
    /// Coefficients by term and component, then the force by order in t and component.
    pub equation_values: Arc<dyn Evaluator>,
    /// How many coefficients stand before derivatives in t.
    pub moving: usize,
    /// Positions, those coefficients, then the coefficients c_ij by condition, basis function and component.
    pub constant_values: Arc<dyn Evaluator>,
    /// The places of the basis functions.
    pub origins: Vec<Option<Span>>,
    /// The place of the equation.
    pub origin: Option<Span>,
    /// The basis of the data, then T_0 … T_N.
    pub basis: Arc<Basis>,
    pub note: Option<Diagnostic>,
}

/// The points of u at which gaps are measured, ends included.
const GAP_SAMPLES: usize = 61;
/// Trimlines that miss each other by less than this share of their size meet: sin 2π is -2.4e-16 in doubles.
const CLOSED: f64 = 1e-12;

impl Solver for StaticSolver {
    fn solve(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        let stated = self.constants(params, range_u)?;
        let u = nodes(self.points.kind, self.points.u, range_u);
        let v = nodes(self.points.kind, self.points.v, range_v);
        let modes = BlendModes::new(self.powers[0], range_u);
        let collocation = self.collocation(&modes, (&u, &v, t), params, stated)?;
        let levels = collocation.force.len();
        let count = self.basis.len();
        let mut coefficients: Vec<Coefficients> = vec![vec![[0.0; 3]; modes.count() * count]; levels];
        self.place_data(&collocation, coefficients.first_mut());
        let mut report = self.empty_report();
        let systems = if self.is_vector { 3 } else { 1 };
        for system in 0..systems {
            let components = if self.is_vector { system..system + 1 } else { 0..3 };
            let parts: Vec<DMatrix<f64>> = components.clone().map(|component| collocation.right(component)).collect();
            let solution = self.solve_system(&collocation, system, &parts, &mut report)?;
            for (component, part) in components.zip(&solution) {
                for (level, column) in coefficients.iter_mut().zip(part.column_iter()) {
                    for (index, value) in column.iter().enumerate() {
                        let (m, n) = (index / (self.powers[1] + 1), index % (self.powers[1] + 1));
                        let place = (CARDINAL + m) * count + self.data() + n;
                        if let Some(slot) = level.get_mut(place).and_then(|vector| vector.get_mut(component)) {
                            // Adding zero turns -0 into 0, which reads better.
                            *slot = value + 0.0;
                        }
                    }
                }
            }
        }
        let surface = SeparableSurface {
            modes: Arc::new(modes),
            basis: Arc::clone(&self.basis),
            params: params.to_vec(),
            coefficients: Arc::new(coefficients),
            instant: self.varies_in_time.then_some(t),
        };
        report.warnings.extend(self.other_solutions(&collocation, &v, params, [range_u, range_v], t)?);
        report.warnings.extend(self.seam(&surface, [range_u, range_v], t)?);
        Ok(Solution { surface: Arc::new(surface), report })
    }
}

impl StaticSolver {
    /// The number of basis functions that carry data.
    fn data(&self) -> usize {
        self.origins.len()
    }

    /// The stated coefficients c_ij, once positions and derivatives in t are found to be as they must be.
    fn constants(&self, params: &[f64], range: [f64; 2]) -> Result<Vec<f64>, Diagnostic> {
        let values = evaluate(&*self.constant_values, params, &[0.0], &[0.0], 0.0)?;
        let (positions, rest) = values.split_at_checked(CARDINAL).unwrap_or_default();
        let (moving, stated) = rest.split_at_checked(self.moving).unwrap_or_default();
        if let Some(at) = stated.iter().position(|value| !value.is_finite()) {
            let j = at / 3 % self.data().max(1);
            let message = format!("the coefficient of basis function F{} in the boundary data is not finite", j + 1);
            return Err(Diagnostic::new(Code::ParameterNotFinite, message).at(self.origin_of(j)));
        }
        let [low, high] = range;
        let rounding = 4.0 * f64::EPSILON * low.abs().max(high.abs());
        let is_off = |(position, end): (&f64, f64)| (position - end).abs() > rounding;
        if positions.iter().zip([low, low, high, high]).any(is_off) {
            let message = "with these params the constraints do not stand at the ends of u";
            return Err(self.refused(message).hint("the method `static_blend` needs position and tangent there"));
        }
        if moving.iter().any(|value| *value != 0.0) {
            let message = "the method `static_blend` cannot treat an equation with derivatives in t: each instant is solved alone";
            return Err(self
                .refused(message)
                .hint("choose another method, or set the coefficients of those derivatives to 0"));
        }
        Ok(stated.to_vec())
    }

    /// Every number of the systems.
    fn collocation(
        &self,
        modes: &BlendModes,
        (u, v, t): (&[f64], &[f64], f64),
        params: &[f64],
        stated: Vec<f64>,
    ) -> Result<Collocation, Diagnostic> {
        let levels = if self.varies_in_time { self.orders_in_t + 1 } else { 1 };
        let mut along_v = Vec::with_capacity(self.terms.len());
        for term in &self.terms {
            let mut in_time = Vec::with_capacity(levels);
            for order in 0..levels {
                let values = self.basis.values(Derivative::new(0, term.v, order), params, v, &vec![t; v.len()])?;
                in_time.push(DMatrix::from_row_slice(self.basis.len(), v.len(), &values));
            }
            along_v.push(in_time);
        }
        let all_u: Vec<f64> = u.iter().flat_map(|&u| v.iter().map(move |_| u)).collect();
        let all_v: Vec<f64> = u.iter().flat_map(|_| v.iter().copied()).collect();
        let values = evaluate(&*self.equation_values, params, &all_u, &all_v, t)?;
        if values.iter().any(|value| !value.is_finite()) {
            let message = "a coefficient or the force of the equation is not finite at a collocation point";
            return Err(Diagnostic::new(Code::DataNotFinite, message).at(self.origin));
        }
        let mut vectors = values.chunks(3 * all_u.len()).map(|vector| {
            let mut components = vector.chunks(all_u.len()).map(<[f64]>::to_vec);
            [(); 3].map(|()| components.next().unwrap_or_default())
        });
        let collocation = Collocation {
            orders: self.terms.iter().map(|term| term.u).collect(),
            along_u: along_u(modes, u, self.terms.iter().map(|term| term.u).max().unwrap_or(0)),
            along_v,
            coefficients: vectors.by_ref().take(self.terms.len()).collect(),
            force: vectors.take(levels).collect(),
            stated,
            data: self.data(),
        };
        self.check_leading(&collocation)?;
        Ok(collocation)
    }

    /// Refuses an equation whose term of order 4 in u is gone: every such system is singular (B5).
    fn check_leading(&self, collocation: &Collocation) -> Result<(), Diagnostic> {
        for component in 0..3 {
            let leading = self.terms.iter().zip(&collocation.coefficients).filter(|(term, _)| term.u == 4);
            let mut values = leading.filter_map(|(_, vectors)| vectors.get(component)).flatten();
            if values.all(|value| *value == 0.0) {
                let name = crate::problem::COMPONENTS.get(component).unwrap_or(&"?");
                let message =
                    format!("the coefficient of ∂⁴S/∂u⁴ is 0 for S_{name}, so collocation determines nothing");
                return Err(self.refused(&message));
            }
        }
        Ok(())
    }

    /// The coefficients a_mn for the given right-hand sides of one system, a column per derivative in t.
    fn solve_system(
        &self,
        collocation: &Collocation,
        system: usize,
        parts: &[DMatrix<f64>],
        report: &mut Report,
    ) -> Result<Vec<DMatrix<f64>>, Diagnostic> {
        let factorised = LeastSquares::new(&collocation.matrix(system)).map_err(|error| {
            let message = format!("the collocation system cannot be solved: {error}");
            Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin)
        })?;
        report.condition = report.condition.map(|condition| condition.max(factorised.condition()));
        report.rank += factorised.rank();
        report.unknowns += factorised.unknowns();
        let (rank, unknowns) = (factorised.rank(), factorised.unknowns());
        // Columns are scaled before the rank is taken, so one that is all rounding errors still counts.
        let is_lost = factorised.condition() * f64::EPSILON * unknowns as f64 > 1.0;
        if rank < unknowns || is_lost {
            let message = if rank < unknowns {
                format!("the points determine {rank} of {unknowns} coefficients; the smallest solution is taken")
            } else {
                format!("the system's condition {:.1e} leaves no correct digits", factorised.condition())
            };
            let finding = Diagnostic::new(Code::RankDeficient, message).at(self.origin);
            report.warnings.push(finding.hint("use another kind of points, or other powers"));
        }
        let solutions: Vec<DMatrix<f64>> = parts.iter().map(|part| factorised.solve(part)).collect();
        if solutions.iter().flatten().any(|value| !value.is_finite()) {
            let message = "the coefficients of the collocation system are not finite";
            return Err(Diagnostic::new(Code::SolutionNotFinite, message).at(self.origin));
        }
        Ok(solutions)
    }

    /// Writes the boundary coefficients; they do not depend on t.
    fn place_data(&self, collocation: &Collocation, level: Option<&mut Coefficients>) {
        let Some(level) = level else { return };
        for (index, vector) in collocation.stated.chunks(3).enumerate() {
            let (condition, j) = (index / self.data().max(1), index % self.data().max(1));
            if let Some(slot) = level.get_mut(condition * self.basis.len() + j) {
                slot.iter_mut().zip(vector).for_each(|(slot, value)| *slot = value + 0.0);
            }
        }
    }

    /// What nothing at the ends of v decides (B6).
    fn other_solutions(
        &self,
        collocation: &Collocation,
        v: &[f64],
        params: &[f64],
        [range_u, range_v]: [[f64; 2]; 2],
        t: f64,
    ) -> Result<Option<Diagnostic>, Diagnostic> {
        if self.terms.iter().all(|term| term.v == 0) {
            return Ok(None);
        }
        let [low, high] = range_v.map(Shortest);
        let base = format!("nothing is stated at v = {low} and v = {high}, so other solutions have the same boundary");
        let exponent = self.smallest_exponent(collocation, range_u[1] - range_u[0]);
        let finding = match exponent {
            None => {
                Diagnostic::new(Code::SolutionNotUnique, format!("{base}: a small residual does not tell them apart"))
            }
            Some(exponent) => {
                let fast = self.fastest(v, params, t)?.filter(|(_, rate)| *rate >= exponent);
                let message = match fast {
                    None => format!(
                        "{base}, with e^(λv) from |λ| = {exponent:.3} on: a small residual does not tell them apart"
                    ),
                    Some((j, rate)) => format!(
                        "{base}, with e^(λv) from |λ| = {exponent:.3} on, and basis function F{} varies at the rate {rate:.3}: more powers need not come closer to the solution",
                        j + 1
                    ),
                };
                let finding = Diagnostic::new(Code::SolutionNotUnique, message);
                finding.at(fast.and_then(|(j, _)| self.origin_of(j)))
            }
        };
        Ok(Some(finding.hint("the method `exact`, where it applies, takes the one that varies in v as the data do")))
    }

    /// The smallest |λ| over all components, for the paper's equation with constant coefficients.
    fn smallest_exponent(&self, collocation: &Collocation, length: f64) -> Option<f64> {
        let known = [(4, 0), (2, 2), (0, 4)];
        if !self.are_constant || self.terms.iter().any(|term| !known.contains(&(term.u, term.v))) {
            return None;
        }
        let of_component = |component: usize| {
            let coefficient = |orders: (usize, usize)| {
                let index = self.terms.iter().position(|term| (term.u, term.v) == orders)?;
                collocation.coefficients.get(index)?.get(component)?.first().copied()
            };
            smallest_exponent(known.map(|orders| coefficient(orders).unwrap_or(0.0)), length)
        };
        let systems = if self.is_vector { 3 } else { 1 };
        (0..systems).filter_map(of_component).min_by(f64::total_cmp)
    }

    /// The basis function that varies fastest along v, and its rate `(max|F''''| / max|F|)^(1/4)`.
    ///
    /// That is ω for sin ωv and 0 for cubics, which the polynomials take in exactly.
    fn fastest(&self, v: &[f64], params: &[f64], t: f64) -> Result<Option<(usize, f64)>, Diagnostic> {
        if self.terms.iter().all(|term| term.v < 4) {
            return Ok(None);
        }
        let sizes = |order: usize| -> Result<Vec<f64>, Diagnostic> {
            let values = self.basis.values(Derivative::new(0, order, 0), params, v, &vec![t; v.len()])?;
            let largest = |row: &[f64]| row.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            Ok(values.chunks(v.len().max(1)).map(largest).collect())
        };
        let rates = sizes(4)?
            .into_iter()
            .zip(sizes(0)?)
            .take(self.data())
            .map(|(fourth, size)| if size > 0.0 { libm::sqrt(libm::sqrt(fourth / size)) } else { 0.0 });
        Ok(rates.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b)))
    }

    /// The gap of a surface whose trimlines close.
    fn seam(
        &self,
        surface: &SeparableSurface,
        [[low, high], range_v]: [[f64; 2]; 2],
        t: f64,
    ) -> Result<Option<Diagnostic>, Diagnostic> {
        let values = self.basis.values(Derivative::NONE, &surface.params, &range_v, &[t, t])?;
        let steps: Vec<f64> = values.chunks(2).map(|ends| ends.iter().fold(0.0, |step, value| value - step)).collect();
        let sizes: Vec<f64> = values.chunks(2).map(|ends| ends.iter().fold(0.0_f64, |a, b| a.max(b.abs()))).collect();
        // Both sides of the seam at u: their difference, and the size of what was subtracted.
        let across = |u: f64| {
            let (mut gap, mut size) = ([0.0; 3], 0.0_f64);
            let rows = surface.coefficients.first().into_iter().flat_map(|level| level.chunks(self.basis.len().max(1)));
            for (mode, row) in surface.modes.derivatives(0, u).iter().zip(rows) {
                for ((vector, step), value) in row.iter().zip(&steps).zip(&sizes) {
                    for (gap, component) in gap.iter_mut().zip(vector) {
                        *gap += mode * step * component;
                        size = size.max((mode * value * component).abs());
                    }
                }
            }
            (gap.iter().fold(0.0_f64, |most, value| most.max(value.abs())), size)
        };
        let (ends, sizes): (Vec<f64>, Vec<f64>) = [across(low), across(high)].into_iter().unzip();
        let size = sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
        if ends.iter().any(|gap| *gap > CLOSED * size) {
            return Ok(None);
        }
        let share = |index: usize| index as f64 / (GAP_SAMPLES - 1) as f64;
        let gaps = (1..GAP_SAMPLES - 1).map(|index| across(low + (high - low) * share(index)).0);
        let widest = gaps.fold(0.0, f64::max);
        if widest <= CLOSED * size {
            return Ok(None);
        }
        let [from, to] = range_v.map(Shortest);
        let message = format!(
            "the trimlines close, the surface between them does not: v = {from} and v = {to} lie up to {widest:.1e} apart"
        );
        let finding = Diagnostic::new(Code::SeamOpens, message);
        Ok(Some(finding.hint("powers of v are not periodic; the method `exact`, where it applies, closes the seam")))
    }

    fn refused(&self, message: &str) -> Diagnostic {
        Diagnostic::new(Code::UnsupportedByMethod, message).at(self.origin)
    }

    fn origin_of(&self, j: usize) -> Option<Span> {
        self.origins.get(j).copied().flatten()
    }

    fn empty_report(&self) -> Report {
        Report {
            method: StaticBlend.name(),
            is_exact: false,
            basis_size: self.data(),
            closure_size: None,
            modes: self.powers[0] + 1,
            condition: Some(1.0),
            amplification: None,
            truncation: None,
            rank: 0,
            unknowns: 0,
            limit: None,
            warnings: self.note.iter().cloned().collect::<Diagnostics>(),
        }
    }
}

/// The values of a program, output after output.
fn evaluate(evaluator: &dyn Evaluator, params: &[f64], u: &[f64], v: &[f64], t: f64) -> Result<Vec<f64>, Diagnostic> {
    let mut values = vec![0.0; evaluator.program().outputs() * u.len()];
    let samples = Samples { u, v, t: &vec![t; u.len()] };
    evaluator
        .evaluate(params, samples, &mut values)
        .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
    Ok(values)
}
