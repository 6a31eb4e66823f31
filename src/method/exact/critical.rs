//! Critical values: what a coefficient of the equation would have to be for a block to be singular (docs/methods.md, X4).

use std::sync::Arc;

use nalgebra::DMatrix;

use super::block::{BlockSystem, Factorised};
use super::discretisation::Discretisation;
use super::system::{Place, System, evaluate};
use super::{Amplified, ExactSolver, Progress};
use crate::decompose::Decomposition;
use crate::diagnostic::{Diagnostic, Shortest};
use crate::eval::{Backend, Program, compile};
use crate::expr::{ExprId, Graph, Node, Notation};
use crate::numeric::{NodeKind, nodes};
use crate::problem::{PdeOperator, PdeTerm};

/// Linear problems that are solved for one critical value.
const STEPS: usize = 12;

/// The step of a difference quotient, relative to the coefficient: its error and that of rounding are about equal.
const DIFFERENCE: f64 = 1e-5;

/// A critical value that moves by less is found, relative to its size; seven digits or more are shown.
const SETTLED: f64 = 1e-8;

/// Critical values shown in a message.
const SHOWN: usize = 2;

impl ExactSolver {
    /// The nearest critical values of the params in the equation, or without any of the numbers in it, those that are
    /// relatively nearest first: `at eta = -113.615, or at gamma = 10.01`, or ``with `-114.595 S` for `-114 S` ``.
    pub(super) fn critical_value(
        &self,
        worst: &Amplified,
        progress: &mut Progress<'_>,
    ) -> Result<Option<String>, Diagnostic> {
        let mut critical: Vec<(f64, String)> = Vec::new();
        for (symbol, name) in &self.coefficients {
            let Some(value) = progress.params.get(*symbol).copied() else { continue };
            let Some(found) = self.critical_param(worst, *symbol, value, progress)? else { continue };
            let text = if is_same(found, value) {
                format!("at {name} = {}, which is exactly critical", Shortest(value))
            } else {
                format!("at {name} = {}", told_apart(found, value))
            };
            critical.push((relative(found, value), text));
        }
        if critical.is_empty() {
            for term in &self.operator.terms {
                let Some(value) = number_in_front(&self.closure.graph, term, worst.component) else { continue };
                let Some(found) = self.critical_number(worst, term, value, progress)? else { continue };
                let [there, here] = [told_apart(found, value), Shortest(value).to_string()]
                    .map(|number| Self::written(&number, term, worst.component));
                let text = if is_same(found, value) {
                    format!("with `{here}`, which is exactly critical")
                } else {
                    format!("with `{there}` for `{here}`")
                };
                critical.push((relative(found, value), text));
            }
        }
        critical.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let shown: Vec<String> = critical.into_iter().take(SHOWN).map(|(_, text)| text).collect();
        Ok((!shown.is_empty()).then(|| shown.join(", or ")))
    }

    fn critical_param(
        &self,
        worst: &Amplified,
        symbol: usize,
        value: f64,
        progress: &mut Progress<'_>,
    ) -> Result<Option<f64>, Diagnostic> {
        let discretisation = self.discretise(worst.terms, worst.terms, progress)?;
        let u = nodes(NodeKind::Gauss, worst.terms, progress.range);
        let cardinal = discretisation.tables.cardinal;
        nearest_singular(value, &worst.factorised, |coefficient| {
            let mut params = progress.params.to_vec();
            if let Some(slot) = params.get_mut(symbol) {
                *slot = coefficient;
            }
            let there =
                Discretisation { entries: self.entries_at(&params, &u)?, ..Discretisation::clone(&discretisation) };
            let (block, ..) = self.block_of(&worst.members, worst.component, &there, worst.terms, progress);
            Ok(block.matrix(&there.tables, cardinal..cardinal + worst.terms))
        })
    }

    /// The matrix is linear in the number in front of a term.
    fn critical_number(
        &self,
        worst: &Amplified,
        term: &PdeTerm,
        value: f64,
        progress: &mut Progress<'_>,
    ) -> Result<Option<f64>, Diagnostic> {
        let discretisation = self.discretise(worst.terms, worst.terms, progress)?;
        let cardinal = discretisation.tables.cardinal;
        let block = self.block_of_term(&worst.members, term, progress.params)?;
        let of_term = block.matrix(&discretisation.tables, cardinal..cardinal + worst.terms);
        nearest_singular(value, &worst.factorised, |number| Ok(worst.factorised.matrix() + &of_term * (number - value)))
    }

    /// What a block would be if its equation consisted of `term`, with 1 in front, alone.
    fn block_of_term(&self, members: &[usize], term: &PdeTerm, params: &[f64]) -> Result<BlockSystem, Diagnostic> {
        let mut graph = self.closure.graph.clone();
        let (one, zero) = (graph.integer(1), graph.integer(0));
        let alone = PdeTerm { coefficient: [one; 3], ..*term };
        let operator = PdeOperator { terms: vec![alone], force: [zero; 3], origin: None };
        let system = System::build(&mut graph, &self.closure, &operator);
        let exprs: Vec<ExprId> = system.entries.iter().map(|(_, expr)| *expr).collect();
        let values = evaluate(&*compile(Program::compile(&graph, &exprs), Backend::Interpreter).0, params, &[0.0])?;
        let member = |function: usize| members.iter().position(|member| *member == function);
        let entry = |((place, _), value): (&(Place, ExprId), f64)| {
            Some((place.order, member(place.equation)?, member(place.unknown)?, vec![value]))
        };
        let entries = system.entries.iter().zip(values).filter_map(entry).collect();
        Ok(BlockSystem { entries, members: members.len() })
    }

    /// A term with `number` in front, of S or of the component whose coefficient differs from the others'.
    fn written(number: &str, term: &PdeTerm, component: usize) -> String {
        let [x, y, z] = term.coefficient;
        let name = if x == y && x == z { "S" } else { ["S_x", "S_y", "S_z"].get(component).copied().unwrap_or("S") };
        let derivative = term.derivative.of(name, Notation::Ascii);
        match number {
            "1" => derivative,
            "-1" => format!("-{derivative}"),
            _ => format!("{number} {derivative}"),
        }
    }
}

/// The value of one coefficient at which a block is singular, from `value` by successive linear problems: each takes the
/// block's matrix as linear in the coefficient, as it mostly is, and goes to the nearest singular one. `None` if this
/// settles nowhere.
fn nearest_singular(
    value: f64,
    factorised: &Arc<Factorised>,
    matrix_at: impl Fn(f64) -> Result<DMatrix<f64>, Diagnostic>,
) -> Result<Option<f64>, Diagnostic> {
    let (mut at, mut factorised) = (value, Arc::clone(factorised));
    for _ in 0..STEPS {
        // A coefficient that is 0 says nothing about its size.
        let size = Some(at.abs().max(value.abs())).filter(|size| *size > 0.0).unwrap_or(1.0);
        let step = DIFFERENCE * size;
        let derivative = (matrix_at(at + step)? - matrix_at(at - step)?) / (2.0 * step);
        if derivative.iter().any(|value| !value.is_finite()) {
            return Ok(None);
        }
        let Some(distance) = factorised.distance_to_singular(&derivative) else { return Ok(None) };
        at += distance;
        if distance.abs() <= SETTLED * at.abs().max(size) {
            return Ok(Some(at));
        }
        let matrix = matrix_at(at)?;
        if matrix.iter().any(|value| !value.is_finite()) {
            return Ok(None);
        }
        match Factorised::new(matrix) {
            Some(next) => factorised = Arc::new(next),
            None => return Ok(Some(at)),
        }
    }
    Ok(None)
}

fn relative(found: f64, value: f64) -> f64 {
    (found - value).abs() / value.abs().max(f64::MIN_POSITIVE)
}

/// Whether a critical value is the present one up to rounding.
fn is_same(found: f64, value: f64) -> bool {
    (found - value).abs() <= 4.0 * f64::EPSILON * value.abs()
}

/// A critical value with digits enough to tell it from the present one: seven, six decimals, or two of the difference.
fn told_apart(found: f64, value: f64) -> String {
    if found == 0.0 {
        return "0".to_owned();
    }
    let exponent = |value: f64| libm::floor(libm::log10(value.abs()));
    // No difference has an infinite exponent, and no double more than 17 digits.
    let digits = (exponent(found) - exponent(found - value) + 1.0).clamp(6.0, 16.0);
    if (1e-4..1e15).contains(&found.abs()) {
        let decimals = (digits - exponent(found)).max(6.0).min(16.0 - exponent(found));
        format!("{found:.*}", decimals as usize)
    } else {
        format!("{found:.*e}", digits as usize)
    }
}

/// The coefficient of a term in one component, if it is a number.
fn number_in_front(graph: &Graph, term: &PdeTerm, component: usize) -> Option<f64> {
    let coefficient = *term.coefficient.get(component)?;
    let may_change = |part: &ExprId| matches!(graph.node(*part), Node::Symbol(_) | Node::Variable(_));
    let is_number = !graph.reachable(&[coefficient]).iter().any(may_change);
    is_number.then(|| graph.value(coefficient, &[], [f64::NAN; 3]))
}

/// The symbols that the coefficients of the equation are made of.
pub(super) fn coefficient_symbols(decomposition: &Decomposition) -> Vec<(usize, String)> {
    let graph = &decomposition.graph;
    let coefficients: Vec<ExprId> = decomposition.operator.terms.iter().flat_map(|term| term.coefficient).collect();
    let symbol = |part: ExprId| match graph.node(part) {
        Node::Symbol(symbol) => Some((symbol.index(), graph.symbol_name(*symbol).to_owned())),
        _ => None,
    };
    graph.reachable(&coefficients).into_iter().filter_map(symbol).collect()
}
