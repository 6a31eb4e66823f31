//! Patches with position and tangent on all four sides, after You and Zhang 2003, Section VI (corrected and completed).
//!
//! The bicubically blended Coons surface of the data meets the boundary; corrections with double zeros on every side
//! are added and made to satisfy the equation in the weak sense (Galerkin; docs/methods.md, H1 to H4). Position and
//! tangent are exact for any number of corrections. t is a parameter: each instant has its own corrections.

mod apex;
mod corners;
mod known;
mod solver;
mod system;
mod weak_form;

use std::sync::Arc;

use super::{Method, Options, Solver, Systems, Terms};
use crate::decompose::{Decomposition, bounded_derivative};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::eval::{Backend, Program, compile};
use crate::expr::{Derivative, ExprId, Graph, Variable};
use crate::limits::Limits;
use crate::problem::{Patch, describe};
use crate::surface::Basis;

pub use known::Known;
use solver::{Field, FourSidedSolver};
use weak_form::weak_form;

/// The method `four_sided`.
pub struct FourSided;

/// Corrections in each direction: biharmonic patches with smooth data are exact to rounding from about here.
const DEFAULT_TERMS: usize = 12;
/// Beyond, systems take seconds and the corners, not the terms, decide what is gained.
const MOST_TERMS: usize = 32;
/// Nodes of the quadrature beyond twice the terms: the data are no polynomials.
const MORE_NODES: usize = 24;
/// Orders of the conditions at the low end and at the high end of a coordinate.
const ORDERS: [usize; 4] = [0, 1, 0, 1];
/// The order of the equation in each of u and v.
const ORDER: usize = 4;

impl Method for FourSided {
    fn name(&self) -> &'static str {
        "four_sided"
    }

    fn description(&self) -> &'static str {
        "position and tangent on four sides: a Coons surface and corrections (You and Zhang 2003, VI, completed)"
    }

    fn settings(&self) -> &'static [&'static str] {
        &["terms"]
    }

    fn is_four_sided(&self) -> bool {
        true
    }

    fn accepts(&self, decomposition: &Decomposition, _limits: &Limits) -> Result<(), Diagnostic> {
        let (graph, patch) = (&decomposition.graph, &decomposition.patch);
        let operator = &patch.operator;
        let refuse = |message: String| Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(operator.origin));
        let orders = [Variable::U, Variable::V]
            .map(|variable| operator.terms.iter().map(|term| term.derivative.order(variable)).max().unwrap_or(0));
        let highest = operator.terms.iter().map(|term| term.derivative.u + term.derivative.v).max().unwrap_or(0);
        if orders != [ORDER; 2] || highest > ORDER {
            let [u, v] = orders;
            return refuse(format!(
                "position and tangent on four sides need an equation of order 4, in u and in v; this one has order {u} in u, {v} in v and {highest} in all"
            ));
        }
        let varies = operator.terms.iter().flat_map(|term| term.coefficient).any(|c| graph.dependence(c).t);
        if varies && operator.order_in_t() > 0 {
            return refuse(
                "the method `four_sided` needs coefficients that do not depend on t, or no derivatives in t".to_owned(),
            );
        }
        accepts_conditions(graph, patch)
    }

    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        let terms = terms(options)?;
        let limits = &options.limits;
        let patch = &decomposition.patch;
        // Derivatives are made on the equation's part of the graph, which is small.
        let (mut graph, operator) = patch.operator.part(&decomposition.graph);
        let parts = weak_form(&mut graph, &operator, limits)?;
        let orders_in_t = operator.order_in_t();
        let coefficients: Vec<ExprId> = parts.iter().flat_map(|part| part.coefficient).collect();
        let mut force = Vec::with_capacity(3 * (orders_in_t + 1));
        for order in 0..=orders_in_t {
            for component in operator.force {
                let in_time = Derivative::new(0, 0, order);
                force.push(bounded_derivative(&mut graph, component, in_time, limits, operator.origin)?);
            }
        }
        let moves = |graph: &Graph, exprs: &[ExprId]| exprs.iter().any(|expr| graph.dependence(*expr).t);
        let (at_u, at_v) = data(patch);
        let data: Vec<ExprId> = at_u.iter().chain(&at_v).map(|(expr, _)| *expr).collect();
        let varies_in_time =
            moves(&graph, &coefficients) || moves(&graph, &force) || moves(&decomposition.graph, &data);
        // Data are curves, and coefficients are needed at the nodes of one quadrature: interpreting is done before
        // compiling would be.
        let backend = if options.backend == Backend::Auto { Backend::Interpreter } else { options.backend };
        let field = |exprs: &[ExprId]| {
            let varies = exprs.iter().map(|expr| graph.dependence(*expr)).any(|depends| depends.u || depends.v);
            let (values, note) = compile(Program::compile(&graph, exprs), backend);
            (Field { values, varies }, note)
        };
        let ((coefficients, note), (force, _)) = (field(&coefficients), field(&force));
        let graph = &decomposition.graph;
        let positions: Vec<ExprId> = patch
            .conditions
            .iter()
            .map(|condition| condition.u)
            .chain(patch.side_conditions.iter().map(|condition| condition.v))
            .collect();
        let (positions, _) = compile(Program::compile(graph, &positions), backend);
        Ok(Box::new(Arc::new(FourSidedSolver {
            terms,
            is_vector: parts.iter().any(|part| matches!(part.coefficient, [x, y, z] if x != y || x != z)),
            parts,
            orders_in_t,
            varies_in_time,
            coefficients,
            force,
            positions,
            at_u: Arc::new(Basis::new(graph, &at_u, backend, limits)),
            at_v: Arc::new(Basis::new(graph, &at_v, backend, limits).in_u()),
            boundary: patch.boundary_origin(),
            equation: patch.operator.origin,
            note,
            known: options.known.clone(),
        })))
    }
}

type Functions = Vec<(ExprId, Option<Span>)>;

/// The data at fixed u and at fixed v, component after component.
fn data(patch: &Patch) -> (Functions, Functions) {
    let at_u = patch.conditions.iter().flat_map(|condition| condition.value.into_iter().zip(condition.origins));
    let at_v = patch.side_conditions.iter().flat_map(|condition| condition.value.into_iter().zip(condition.origins));
    (at_u.collect(), at_v.collect())
}

/// Refuses conditions other than position and tangent at both ends of u and of v, at the first that differs.
fn accepts_conditions(graph: &Graph, patch: &Patch) -> Result<(), Diagnostic> {
    let at_u: Vec<_> = patch.conditions.iter().map(|c| (c.u, c.order, c.origins)).collect();
    let at_v: Vec<_> = patch.side_conditions.iter().map(|c| (c.v, c.order, c.origins)).collect();
    let [range_u, range_v, _] = patch.domain.ends;
    for (stated, [low, high], across) in [(at_u, range_u, Variable::U), (at_v, range_v, Variable::V)] {
        if stated.len() != ORDERS.len() {
            let (count, name) = (stated.len(), across.name());
            let message = format!(
                "the method `four_sided` needs position and tangent at both ends of {name}, and {count} constraints are stated at fixed {name}"
            );
            return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(patch.boundary_origin()));
        }
        for (&(position, order, origins), (expected, end)) in
            stated.iter().zip(ORDERS.into_iter().zip([low, low, high, high]))
        {
            let value = |expr| graph.value(expr, &[], [f64::NAN; 3]);
            // Ends that params decide are NaN here; the solver looks at them.
            let is_elsewhere = position != end && (value(position) - value(end)).abs() > 0.0;
            if order != expected || is_elsewhere {
                let stated = describe(None, order, across, value(position));
                let name = across.name();
                let message = format!(
                    "the method `four_sided` needs position and tangent at both ends of {name}, and the constraints have {stated}"
                );
                return Err(
                    Diagnostic::new(Code::UnsupportedByMethod, message).at(origins.into_iter().flatten().next())
                );
            }
        }
    }
    Ok(())
}

/// The corrections in u and in v, checked.
fn terms(options: &Options) -> Result<[usize; 2], Diagnostic> {
    let (Terms { first, second }, origin) =
        options.settings.terms.unwrap_or((Terms { first: DEFAULT_TERMS, second: None }, None));
    let terms = [first, second.unwrap_or(first)];
    if terms.iter().any(|count| !(1..=MOST_TERMS).contains(count)) {
        let [first, second] = terms;
        let message = format!("{first} x {second} terms are asked for; each number goes from 1 to {MOST_TERMS}");
        return Err(Diagnostic::new(Code::SettingOutOfRange, message)
            .at(origin)
            .hint("8 to 16 are useful; the boundary is met with any number"));
    }
    let [in_u, in_v] = terms;
    let unknowns = in_u * in_v;
    let nodes = (2 * in_u + MORE_NODES) * (2 * in_v + MORE_NODES);
    let systems = Systems { count: 1, rows: unknowns, unknowns, entries: 24 * nodes, points: nodes };
    systems.check(&options.limits).map_err(|finding| finding.at(origin))?;
    Ok(terms)
}
