//! The method of You and Zhang 2004 (Eqs. 3-12, corrected): a trigonometric blend that meets the boundary, and a
//! bivariate polynomial that the boundary cannot see, made to satisfy the equation at as many points as it has
//! coefficients.
//!
//! `S = Σ_i B_i(u) g_i(v, t) + sin²(πx) Σ_mn a_mn T_m(2x - 1) T_n(y)`, x and y from 0 to 1 and from -1 to 1 over the
//! ranges of u and v (docs/methods.md, B1 to B5). The equation is static: t is a parameter, and each instant has its
//! own a_mn. Coefficients and force may depend on u, v and t.
//!
//! Nothing is stated at the ends of v. That leaves the solution open (B6), and a closed shape does not close between
//! its trimlines; the report says so.

mod collocation;
mod modes;
mod null_space;
mod solver;

use std::sync::Arc;

use super::{Method, Options, Size, Solver, Systems, Terms};
use crate::decompose::{Decomposition, bounded_derivative};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::eval::{Backend, Program, compile};
use crate::expr::{Derivative, ExprId, Graph, Number, Variable};
use crate::limits::Limits;
use crate::numeric::NodeKind;
use crate::problem::{PdeTerm, describe_condition};
use crate::surface::Basis;

use solver::{StaticSolver, TermValues};

/// The method `static_blend`.
pub struct StaticBlend;

/// Highest powers of u and v; the surface gets better up to about here, and slower to find.
const DEFAULT_POWERS: [usize; 2] = [6, 6];
/// Beyond, rounding errors are all that is added.
const HIGHEST_POWER: usize = 32;
/// Orders of the conditions that the B_i are made for, at the low end and at the high end of u.
const ORDERS: [usize; 4] = [0, 1, 0, 1];

impl Method for StaticBlend {
    fn name(&self) -> &'static str {
        "static_blend"
    }

    fn description(&self) -> &'static str {
        "a trigonometric blend and powers up to u^M v^N, by collocation (You and Zhang 2004, corrected)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms", "points"]
    }

    fn accepts(&self, decomposition: &Decomposition, _limits: &Limits) -> Result<(), Diagnostic> {
        let (graph, operator) = (&decomposition.graph, &decomposition.patch.operator);
        let refuse = |message: String| {
            let finding = Diagnostic::new(Code::UnsupportedByMethod, message);
            Err(finding.at(operator.origin))
        };
        if operator.order_in_u() != 4 {
            let order = operator.order_in_u();
            return refuse(format!(
                "the method `static_blend` needs an equation of order 4 in u; this one has {order}"
            ));
        }
        accepts_conditions(decomposition)?;
        let in_time: Vec<ExprId> = moving_terms(decomposition).flat_map(|term| term.coefficient).collect();
        let is_nonzero = |expr: &ExprId| {
            let value = graph.value(*expr, &[], [f64::NAN; 3]);
            !graph.dependence(*expr).is_constant() || (value != 0.0 && !value.is_nan())
        };
        // The value of a param is not known yet; the solver looks at it.
        if in_time.iter().any(is_nonzero) {
            return refuse(
                "the method `static_blend` cannot treat an equation with derivatives in t: each instant is solved alone"
                    .to_owned(),
            );
        }
        let varies = static_terms(decomposition).flat_map(|term| term.coefficient).any(|c| graph.dependence(c).t);
        if varies && !in_time.is_empty() {
            return refuse(
                "the method `static_blend` needs coefficients that do not depend on t, or no derivatives in t"
                    .to_owned(),
            );
        }
        Ok(())
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        decomposition.check_differentiable()?;
        let (powers, points) = sizes(decomposition, options)?;
        let orders_in_t = decomposition.patch.operator.order_in_t();
        let mut graph = decomposition.graph.clone();
        let terms: Vec<PdeTerm> = static_terms(decomposition).copied().collect();
        let force = decomposition.patch.operator.force;
        let mut outputs: Vec<ExprId> = terms.iter().flat_map(|term| term.coefficient).collect();
        for order in 0..=orders_in_t {
            for component in force {
                let in_time = Derivative::new(0, 0, order);
                let origin = decomposition.patch.operator.origin;
                outputs.push(bounded_derivative(&mut graph, component, in_time, &options.limits, origin)?);
            }
        }
        let mut functions: Vec<(ExprId, Option<Span>)> =
            decomposition.basis.iter().map(|function| (function.expr, function.origin)).collect();
        let varies_in_time =
            outputs.iter().chain(functions.iter().map(|(expr, _)| expr)).any(|expr| graph.dependence(*expr).t);
        functions
            .extend(polynomials(&mut graph, powers[1], decomposition.patch.domain.ends[1]).map(|expr| (expr, None)));
        // These run over a handful of nodes for each solution: interpreting them is done before compiling would be.
        let backend = if options.backend == Backend::Auto { Backend::Interpreter } else { options.backend };
        let program = |outputs: &[ExprId]| compile(Program::compile(&graph, outputs), backend);
        let (equation_values, note) = program(&outputs);
        let moving: Vec<ExprId> = moving_terms(decomposition).flat_map(|term| term.coefficient).collect();
        let positions = decomposition.patch.conditions.iter().map(|condition| condition.u);
        let coefficients = decomposition.coefficients.iter().flatten().flatten().copied();
        let constants: Vec<ExprId> = positions.chain(moving.iter().copied()).chain(coefficients).collect();
        Ok(Box::new(StaticSolver {
            powers,
            points,
            orders_in_t,
            varies_in_time,
            is_vector: terms.iter().any(|term| matches!(term.coefficient, [x, y, z] if x != y || x != z)),
            are_constant: terms.iter().flat_map(|term| term.coefficient).all(|c| graph.dependence(c).is_constant()),
            terms: terms.iter().map(|term| TermValues { u: term.derivative.u, v: term.derivative.v }).collect(),
            equation_values,
            moving: moving.len(),
            constant_values: program(&constants).0,
            origins: decomposition.basis.iter().map(|function| function.origin).collect(),
            origin: decomposition.patch.operator.origin,
            basis: Arc::new(Basis::new(&graph, &functions, options.backend, &options.limits)),
            note,
        }))
    }
}

fn static_terms(decomposition: &Decomposition) -> impl Iterator<Item = &PdeTerm> {
    decomposition.patch.operator.terms.iter().filter(|term| term.derivative.t == 0)
}

fn moving_terms(decomposition: &Decomposition) -> impl Iterator<Item = &PdeTerm> {
    decomposition.patch.operator.terms.iter().filter(|term| term.derivative.t > 0)
}

/// Refuses boundary conditions other than position and tangent at both ends of u, at the first that differs.
fn accepts_conditions(decomposition: &Decomposition) -> Result<(), Diagnostic> {
    let graph = &decomposition.graph;
    let [low, high] = decomposition.patch.domain.ends[0];
    let ends = [low, low, high, high];
    for ((condition, order), end) in decomposition.patch.conditions.iter().zip(ORDERS).zip(ends) {
        let value = |expr| graph.value(expr, &[], [f64::NAN; 3]);
        let (position, expected) = (value(condition.u), value(end));
        // Ends that params decide are NaN here; the solver looks at them.
        let is_elsewhere = condition.u != end && (position - expected).abs() > 0.0;
        if condition.order != order || is_elsewhere {
            let stated = describe_condition(None, condition.order, position);
            let message = format!(
                "the method `static_blend` needs position and tangent at both ends of u, and the constraints have {stated}"
            );
            let finding = Diagnostic::new(Code::UnsupportedByMethod, message);
            return Err(finding.at(condition.origins.iter().flatten().next().copied()));
        }
    }
    Ok(())
}

/// Chebyshev polynomials T_0 … T_highest of the position in the range of v, as expressions.
fn polynomials(graph: &mut Graph, highest: usize, [low, high]: [ExprId; 2]) -> impl Iterator<Item = ExprId> {
    let v = graph.variable(Variable::V);
    let length = graph.difference(high, low);
    let slope = graph.inverse(length);
    let (rising, middle) = (graph.scale(Number::integer(2), v), graph.sum([low, high]));
    let (rising, middle) = (graph.product([rising, slope]), graph.product([middle, slope]));
    let y = graph.difference(rising, middle);
    let mut all = vec![graph.integer(1), y];
    for n in 2..=highest {
        let two = graph.integer(2);
        if let (Some(&one), Some(&before)) = (all.get(n - 1), all.get(n - 2)) {
            let product = graph.product([two, y, one]);
            all.push(graph.difference(product, before));
        }
    }
    all.into_iter().take(highest + 1)
}

/// The highest powers and the grid, checked.
fn sizes(decomposition: &Decomposition, options: &Options) -> Result<([usize; 2], Size), Diagnostic> {
    let (powers, terms_origin) = match options.settings.terms {
        None => (DEFAULT_POWERS, None),
        Some((Terms { first, second }, origin)) => ([first, second.unwrap_or(first)], origin),
    };
    let [m, n] = powers;
    if m > HIGHEST_POWER || n > HIGHEST_POWER {
        let message = format!("terms up to u^{m} v^{n} are asked for; powers go to {HIGHEST_POWER}");
        return Err(Diagnostic::new(Code::SettingOutOfRange, message)
            .at(terms_origin)
            .hint("4 to 8 are useful: more powers of v need not come closer to the solution"));
    }
    // As the paper: as many points as unknowns, equally spaced.
    let default = Size { u: m + 1, v: n + 1, kind: NodeKind::Ends };
    // Points that follow from the terms are theirs to answer for.
    let (points, points_origin) = options.settings.points.unwrap_or((default, terms_origin));
    if points.u <= m || points.v <= n {
        let message = format!("{} x {} points do not determine terms up to u^{m} v^{n}", points.u, points.v);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message).at(points_origin).hint(format!(
            "give at least {} x {} points",
            m + 1,
            n + 1
        )));
    }
    let limits = &options.limits;
    let (unknowns, rows) = ((m + 1) * (n + 1), points.u.saturating_mul(points.v));
    let functions = (decomposition.basis.len() + n + 1).saturating_mul(points.v);
    let systems = Systems { count: 1, rows, unknowns, entries: functions, points: rows };
    systems.check(limits).map_err(|finding| finding.at(points_origin))?;
    Ok((powers, points))
}
