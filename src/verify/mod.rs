//! Judges any surface against its problem: boundary error and residual of the equation.
//!
//! Input: a problem and a [`Surface`]; output: a [`Verification`]. The boundary data and the coefficients of
//! the equation are evaluated here, from the problem's own expressions, by the interpreter, on a grid of the
//! verifier's own. Nothing here knows how the surface was made: a method cannot grade itself.

mod apex;
mod contact;
mod fold;
mod join;
mod opening;
mod overlap;
mod passed_over;
mod programs;
mod seam;

pub use apex::{ApexDeviation, verify_apexes};
pub use fold::find_fold;
pub use join::{JoinDeviation, verify_joins};
pub use opening::find_opening;
pub use overlap::{Curve, Parts, common_part};
pub use passed_over::{check_deformations, refuse_poles};
pub use programs::Programs;
pub use seam::{Edge, Line, SeamDeviation};

use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{Derivative, ExprId, Notation, Variable};
use crate::features::Features;
use crate::numeric::{NodeKind, nodes};
use crate::problem::{Bindings, BoundaryCondition, DomainValues, Patch, Problem, SideCondition, describe};
use crate::surface::Surface;
use programs::VectorProgram;

use passed_over::{check_poles, features_of};

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// The largest deviation from each boundary condition, in order: those at fixed u, then those at fixed v.
    pub boundary_errors: Vec<f64>,
    /// The largest residual of the equation, in any component.
    pub residual: f64,
    /// The largest single term of the equation, in any component: what the residual is to be compared with.
    pub largest_term: f64,
    /// Terms below this are rounding errors, and an equation of such terms alone is satisfied.
    pub negligible: f64,
    /// The largest coordinate of S on the grid.
    pub size: f64,
    /// The largest prescribed value: what boundary errors are to be compared with. Not `size`, which a surface that
    /// explodes between its trimlines would set itself.
    pub data_size: f64,
}

impl Verification {
    /// The largest deviation from any boundary condition.
    #[must_use]
    pub fn boundary_error(&self) -> f64 {
        self.boundary_errors.iter().fold(0.0, |most, error| most.max(*error))
    }

    /// The residual over the largest single term of the equation; zero when all terms are zero up to rounding.
    #[must_use]
    pub fn relative_residual(&self) -> f64 {
        if self.largest_term > self.negligible { self.residual / self.largest_term } else { 0.0 }
    }

    /// This, with the deviations from the conditions at fixed u measured at the places `v` as well: those where a method
    /// knows that it misses them most.
    ///
    /// # Errors
    /// As [`verify`].
    pub fn also_at(
        mut self,
        programs: &Programs,
        problem: &Problem,
        patch: &Patch,
        surface: &dyn Surface,
        (bindings, t): (&Bindings, f64),
        v: &[f64],
    ) -> Result<Verification, Diagnostic> {
        for ((side, stated), most) in sides(patch).zip(&programs.sides).zip(&mut self.boundary_errors) {
            if side.across == Variable::U && !v.is_empty() {
                let position = bindings.constant(problem, side.position, None, "the position of a boundary")?;
                let places = (position, [&[][..], v], t);
                let (error, _) = boundary_error(problem, surface, bindings, (&side, stated), places)?;
                *most = most.max(error);
            }
        }
        Ok(self)
    }

    /// The worse of two measurements of one patch, for example at two instants.
    #[must_use]
    pub fn worst(self, other: &Verification) -> Verification {
        let errors = self.boundary_errors.iter().zip(&other.boundary_errors);
        // Residual and term of one instant belong together: a small instant must not hide behind a large one.
        let worse = if self.relative_residual() >= other.relative_residual() { &self } else { other };
        Verification {
            boundary_errors: errors.map(|(a, b)| a.max(*b)).collect(),
            residual: worse.residual,
            largest_term: worse.largest_term,
            negligible: worse.negligible,
            size: self.size.max(other.size),
            data_size: self.data_size.max(other.data_size),
        }
    }
}

/// Nodes in u and in v: counts that share no factor with the usual collocation grids.
const GRID: [usize; 2] = [23, 37];

/// Measures `surface` as a solution of `patch` at instant `t`.
///
/// The residual is taken inside the domain and on its border, at 23 x 37 points and where data, coefficients or force are
/// narrow; if all four sides carry data, inside only. For one patch at many instants, [`verify_with`] compiles its
/// expressions once.
///
/// # Errors
/// [`Code::DataNotFinite`] when the boundary data are not finite somewhere on the grid, or data, a coefficient or the
/// force have a pole between its points; whatever the surface says when it cannot be evaluated.
pub fn verify(
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    numbers: (&Bindings, &DomainValues, f64),
) -> Result<Verification, Diagnostic> {
    verify_with(&Programs::compile(&problem.graph, patch), problem, patch, surface, numbers)
}

/// As [`verify`], with what was compiled for the patch.
///
/// # Errors
/// As [`verify`].
pub fn verify_with(
    programs: &Programs,
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
) -> Result<Verification, Diagnostic> {
    let features = features_of(problem, patch, (bindings, domain, t));
    let v = Features::refined(&features.v, &with_ends(GRID[1], domain.v), domain.v);
    let u = Features::refined(&features.u, &with_ends(GRID[0], domain.u), domain.u);
    let mut boundary_errors = Vec::with_capacity(patch.conditions.len() + patch.side_conditions.len());
    let mut data_size = 0.0_f64;
    for (side, stated) in sides(patch).zip(&programs.sides) {
        let position = bindings.constant(problem, side.position, None, "the position of a boundary")?;
        let (error, size) = boundary_error(problem, surface, bindings, (&side, stated), (position, [&u, &v], t))?;
        boundary_errors.push(error);
        data_size = data_size.max(size);
    }
    check_poles(problem, patch, &features, (bindings, t))?;
    // Four sides meet in corners, where the data need not satisfy the equation: only the inside is judged.
    let inside = |nodes: &[f64]| nodes.get(1..nodes.len() - 1).map(<[f64]>::to_vec).unwrap_or_default();
    let (u, v) = if patch.is_four_sided() { (inside(&u), inside(&v)) } else { (u, v) };
    let Terms { sums, largest: largest_term, natural } = equation(programs, patch, surface, bindings, (&u, &v, t))?;
    let residual = sums.iter().fold(0.0_f64, |most, sum| most.max(sum.abs()));
    let size = size(surface, (&u, &v, t))?;
    let negligible = ROUNDING * natural * size;
    Ok(Verification { boundary_errors, residual, largest_term, negligible, size, data_size })
}

/// The largest coordinate on a grid.
fn size(surface: &dyn Surface, (u, v, t): (&[f64], &[f64], f64)) -> Result<f64, Diagnostic> {
    let mut positions = vec![[0.0; 3]; u.len() * v.len()];
    surface.evaluate_grid(Derivative::NONE, (u, v, t), &mut positions)?;
    Ok(positions.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs())))
}

/// One condition, at fixed u or at fixed v.
struct Side<'a> {
    across: Variable,
    position: ExprId,
    order: usize,
    value: &'a [ExprId; 3],
    origins: &'a [Option<Span>; 3],
}

/// Every condition of a patch, in order.
fn sides(patch: &Patch) -> impl Iterator<Item = Side<'_>> {
    let at_u = patch.conditions.iter().map(|condition| {
        let BoundaryCondition { u, order, value, origins } = condition;
        Side { across: Variable::U, position: *u, order: *order, value, origins }
    });
    at_u.chain(patch.side_conditions.iter().map(|condition| {
        let SideCondition { v, order, value, origins } = condition;
        Side { across: Variable::V, position: *v, order: *order, value, origins }
    }))
}

/// The largest deviation from one condition, and the largest value it prescribes.
fn boundary_error(
    problem: &Problem,
    surface: &dyn Surface,
    bindings: &Bindings,
    (side, stated): (&Side<'_>, &VectorProgram),
    (position, [u, v], t): (f64, [&[f64]; 2], f64),
) -> Result<(f64, f64), Diagnostic> {
    let here = [position];
    let is_at_u = side.across == Variable::U;
    let (u, v, along, derivative) = if is_at_u {
        (&here[..], v, v, Derivative::new(side.order, 0, 0))
    } else {
        (u, &here[..], u, Derivative::new(0, side.order, 0))
    };
    let stated = stated.on_grid(bindings, (u, v, t))?;
    if let Some(at) = stated.iter().position(|value| !value.is_finite()) {
        let component = at / along.len();
        let text = side.value.get(component).map(|expr| problem.graph.text(*expr, Notation::Ascii, 80));
        let text = text.and_then(Result::ok).unwrap_or_else(|| "a long expression".to_owned());
        let what = format!("`{text}` ({})", describe(Some(component), side.order, side.across, position));
        let origin = side.origins.get(component).copied().flatten();
        let name = if is_at_u { Variable::V.name() } else { Variable::U.name() };
        return Err(not_finite(&what, stated.get(at).copied(), origin, (name, along.get(at % along.len())), t));
    }
    let size = stated.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut found = vec![[0.0; 3]; along.len()];
    surface.evaluate_grid(derivative, (u, v, t), &mut found)?;
    let mut error = 0.0_f64;
    for (component, expected) in stated.chunks(along.len()).enumerate() {
        for (found, expected) in found.iter().zip(expected) {
            error = error.max((found.get(component).copied().unwrap_or(f64::NAN) - expected).abs());
        }
    }
    Ok((error, size))
}

/// The distance of a surface from the positions that it was asked to have along one line of constant u or v.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryGap {
    /// The parameter that is constant.
    pub across: Variable,
    /// Its value.
    pub at: f64,
    /// Distances at evenly spaced places along the line, both ends included.
    pub distances: Vec<f64>,
}

/// The gap at every position that `patch` prescribes, at `places` places along each line at instant `t`.
///
/// # Errors
/// As [`verify`].
pub fn boundary_gaps(
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
    places: usize,
) -> Result<Vec<BoundaryGap>, Diagnostic> {
    let [u, v] = [domain.u, domain.v].map(|range| nodes(NodeKind::Ends, places, range));
    let mut gaps = Vec::new();
    for side in sides(patch).filter(|side| side.order == 0) {
        let at = bindings.constant(problem, side.position, None, "the position of a boundary")?;
        let here = [at];
        let grid = if side.across == Variable::U { (&here[..], &v[..], t) } else { (&u[..], &here[..], t) };
        let stated = VectorProgram::compile(&problem.graph, side.value).on_grid(bindings, grid)?;
        let mut found = vec![[0.0; 3]; places];
        surface.evaluate_grid(Derivative::NONE, grid, &mut found)?;
        let component = |index: usize| stated.iter().skip(index * places).copied();
        let stated = component(0).zip(component(1)).zip(component(2)).map(|((x, y), z)| [x, y, z]);
        let distances = found.into_iter().zip(stated).map(|(a, b)| contact::distance(a, b)).collect();
        gaps.push(BoundaryGap { across: side.across, at, distances });
    }
    Ok(gaps)
}

/// Gauss nodes, which no collocation grid with rational spacing shares, and both ends.
fn with_ends(count: usize, range: [f64; 2]) -> Vec<f64> {
    let mut all = vec![range[0]];
    all.extend(nodes(NodeKind::Gauss, count - 2, range));
    all.push(range[1]);
    all
}

/// The residual of the equation at every point of a grid, u-major, relative to the equation's largest single term
/// there, as [`Verification::relative_residual`] is: the largest of the three components.
///
/// # Errors
/// What the surface reports, or a residual that is not finite.
pub fn residuals(
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    bindings: &Bindings,
    (u, v, t): (&[f64], &[f64], f64),
) -> Result<Vec<f64>, Diagnostic> {
    let programs = Programs::compile(&problem.graph, patch);
    let Terms { sums, largest, natural } = equation(&programs, patch, surface, bindings, (u, v, t))?;
    let is_rounding = largest <= ROUNDING * natural * size(surface, (u, v, t))?;
    let mut residuals = vec![0.0_f64; u.len() * v.len()];
    for component in sums.chunks(residuals.len().max(1)) {
        for (most, sum) in residuals.iter_mut().zip(component) {
            *most = most.max(if is_rounding { 0.0 } else { sum.abs() / largest });
        }
    }
    Ok(residuals)
}

/// The equation on a grid.
struct Terms {
    /// Left side minus right side, component after component.
    sums: Vec<f64>,
    /// The largest single term.
    largest: f64,
    /// The size that terms have of a surface of size 1 that varies once over the grid.
    natural: f64,
}

/// Of the natural size of a term. A term that vanishes by cancellation keeps rounding errors of the size of what cancels,
/// some orders above the machine's precision; a true one that is as small as this changes no digit that a surface has.
const ROUNDING: f64 = 1e-12;

/// Evaluates the equation on the grid.
fn equation(
    programs: &Programs,
    patch: &Patch,
    surface: &dyn Surface,
    bindings: &Bindings,
    (u, v, t): (&[f64], &[f64], f64),
) -> Result<Terms, Diagnostic> {
    let points = u.len() * v.len();
    let rate = |nodes: &[f64]| match nodes {
        [first, .., last] if last > first => std::f64::consts::TAU / (last - first),
        _ => 1.0,
    };
    let (rate_u, rate_v, mut natural) = (rate(u), rate(v), 0.0_f64);
    // The force stands on the right of the equation.
    let mut sums: Vec<f64> = programs.force.on_grid(bindings, (u, v, t))?.iter().map(|q| -q).collect();
    let mut largest = sums.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut values = vec![[0.0; 3]; points];
    for (term, coefficient) in patch.operator.terms.iter().zip(&programs.coefficients) {
        let factors = coefficient.on_grid(bindings, (u, v, t))?;
        // Where the equation does not take a derivative, it need not exist.
        if factors.iter().all(|factor| *factor == 0.0) {
            continue;
        }
        let power = |rate: f64, variable: Variable| libm::pow(rate, term.derivative.order(variable) as f64);
        let unit = power(rate_u, Variable::U) * power(rate_v, Variable::V);
        natural = factors.iter().fold(natural, |most, factor| most.max(factor.abs() * unit));
        surface.evaluate_grid(term.derivative, (u, v, t), &mut values)?;
        for (component, (sums, factors)) in sums.chunks_mut(points).zip(factors.chunks(points)).enumerate() {
            for ((sum, factor), value) in sums.iter_mut().zip(factors).zip(&values) {
                let product = factor * value.get(component).copied().unwrap_or(f64::NAN);
                largest = largest.max(product.abs());
                *sum += product;
            }
        }
    }
    if !sums.iter().all(|sum| sum.is_finite()) {
        let finding =
            Diagnostic::new(Code::SolutionNotFinite, "the residual of the equation is not finite on the domain")
                .hint("a coefficient or the force has a pole, or the solution overflows");
        return Err(finding.at(patch.operator.origin));
    }
    Ok(Terms { sums, largest, natural })
}

fn not_finite(what: &str, value: Option<f64>, origin: Option<Span>, at: (&str, Option<&f64>), t: f64) -> Diagnostic {
    let (name, at) = (at.0, Shortest(at.1.copied().unwrap_or(f64::NAN)));
    let (value, t) = (Shortest(value.unwrap_or(f64::NAN)), Shortest(t));
    Diagnostic::new(Code::DataNotFinite, format!("{what} is {value} at {name} = {at}, t = {t}"))
        .at(origin)
        .hint("boundary data must be finite on the whole domain; change the function or the domain")
}
