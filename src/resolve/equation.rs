//! The `pde` statement to a [`PdeOperator`] and the parameters that are its coefficients.

use rustc_hash::FxHashSet;

use super::lower::{Lowering, components};
use super::reading::{Fault, Reading};
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Graph, Node};
use crate::problem::{Parameter, ParameterKind, PdeOperator, PdeTerm, STANDARD_COEFFICIENTS};
use crate::syntax::ast::{Expression, Kind, Name, PdeStatement, Tree};

/// Resolves the equation; coefficients that are constant become parameters, those of a patch's own equation under the
/// patch's name: `cap.gamma`.
pub fn resolve(
    statement: Option<&PdeStatement>,
    patch: Option<&str>,
    scope: &Scope<'_>,
    parameters: &mut Vec<Parameter>,
    reading: &mut Reading<'_>,
) -> Option<PdeOperator> {
    let found_before = reading.found.len();
    let mut scope = scope.inner();
    let stated = statement.map_or(&[][..], |statement| statement.coefficients.as_slice());
    let first_own = parameters.len();
    let is_standard = statement.is_none_or(|statement| statement.sides.is_none());
    if is_standard {
        for (name, _) in stated.iter().filter(|(name, _)| !is_standard_name(&name.text)) {
            reading.report(not_standard(name));
        }
        for (name, _, default) in STANDARD_COEFFICIENTS {
            if stated.iter().all(|(stated, _)| stated.text != name) {
                let value = reading.graph.integer(default);
                let parameter = parameter(&mut reading.graph, patch, name, value);
                let declared = declare_default(&parameter, name, &mut scope, reading);
                parameters.extend(reading.keep(declared).map(|()| parameter));
            }
        }
    }
    for (name, value) in stated {
        let mut lowering = reading.lowering(&scope);
        let lowered = lowering.value(*value).and_then(|value| Ok(coefficient(&mut lowering, patch, name, value)?));
        let meaning = match reading.keep(lowered) {
            Some((meaning, parameter)) => {
                let origin = Some(reading.tree.span(*value));
                parameters.extend(parameter.map(|parameter| Parameter { origin, ..parameter }));
                meaning
            }
            None => Meaning::Faulty,
        };
        let declared = scope.declare(name, meaning);
        reading.keep(declared);
    }
    let operator = match statement.and_then(|statement| statement.sides.map(|sides| (statement, sides))) {
        None => Some(standard(&mut reading.graph, &scope, statement)),
        Some((statement, sides)) => {
            let operator = text_equation(&mut reading.lowering(&scope), statement, sides);
            reading.keep(operator)
        }
    };
    if reading.found.len() > found_before {
        return None;
    }
    if let Some(sides) = statement.and_then(|statement| statement.sides) {
        let own = parameters.get(first_own..).unwrap_or_default();
        let used = used_names(&reading.graph, own, reading.tree, sides);
        for (name, _) in stated
            .iter()
            .filter(|(name, _)| !used.contains(&name.text) && !used.contains(&parameter_name(patch, &name.text)))
        {
            reading.report(unused_coefficient(name));
        }
    }
    operator
}

/// The standard equation with the coefficients that `scope` knows.
fn standard(graph: &mut Graph, scope: &Scope<'_>, statement: Option<&PdeStatement>) -> PdeOperator {
    let mut operator = PdeOperator::standard(graph);
    operator.origin = statement.map(|statement| statement.span);
    for (name, derivative, _) in STANDARD_COEFFICIENTS {
        let term = operator.terms.iter_mut().find(|term| term.derivative == derivative);
        match (scope.meaning(name), term) {
            (Some(Meaning::Value(value)), Some(term)) => term.coefficient = components(*value),
            (Some(Meaning::Parameter(symbol)), Some(term)) => term.coefficient = [*symbol; 3],
            _ => {}
        }
    }
    operator
}

fn is_standard_name(name: &str) -> bool {
    STANDARD_COEFFICIENTS.iter().any(|(standard, ..)| *standard == name)
}

fn not_standard(name: &Name) -> Diagnostic {
    Diagnostic::new(Code::UnknownName, format!("the standard equation has no coefficient `{}`", name.text))
        .at(name.span)
        .hint("its coefficients are β, γ, λ, ρ and η; state another equation before `with`")
}

fn unused_coefficient(name: &Name) -> Diagnostic {
    Diagnostic::new(Code::UnknownName, format!("the equation does not use the coefficient `{}`", name.text))
        .at(name.span)
        .hint("remove it, or write it into the equation")
}

/// The names that the equation uses, and those that a coefficient uses: `with a = 2, b = a^2`.
fn used_names(graph: &Graph, parameters: &[Parameter], tree: &Tree, sides: [Expression; 2]) -> FxHashSet<String> {
    let parts = sides.iter().flat_map(|side| tree.parts(*side));
    let mut used: FxHashSet<String> = parts
        .filter_map(|part| match &tree.node(part).kind {
            Kind::Name(found) | Kind::Application(found, _) => Some(found.text.clone()),
            _ => None,
        })
        .collect();
    let values: Vec<ExprId> = parameters.iter().map(|parameter| parameter.value).collect();
    for part in graph.reachable(&values) {
        if let Node::Symbol(symbol) = graph.node(part) {
            used.insert(graph.symbol_name(*symbol).to_owned());
        }
    }
    used
}

/// What a coefficient is called among the parameters.
fn parameter_name(patch: Option<&str>, name: &str) -> String {
    patch.map_or_else(|| name.to_owned(), |patch| format!("{patch}.{name}"))
}

fn parameter(graph: &mut Graph, patch: Option<&str>, name: &str, value: ExprId) -> Parameter {
    let name = parameter_name(patch, name);
    let symbol = graph.symbol_id(&name);
    Parameter {
        symbol,
        name,
        value,
        interval: None,
        kind: ParameterKind::Coefficient,
        origin: None,
        is_overridden: false,
    }
}

fn declare_default(
    parameter: &Parameter,
    name: &str,
    scope: &mut Scope<'_>,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    if scope.meaning(name).is_some() {
        let message =
            format!("`{name}` is also the name of a coefficient of the standard equation, which this document uses");
        let finding = Diagnostic::new(Code::DuplicateName, message).at(scope.place(name));
        return Err(
            finding.hint(format!("rename it, or state the equation with `pde … = 0`, or say `pde with {name} = …`"))
        );
    }
    let meaning = Meaning::Parameter(reading.graph.symbol_node(parameter.symbol));
    scope.provide(name, meaning);
    Ok(())
}

/// A constant becomes a parameter that can be changed; a function of u, v or t stands for itself.
fn coefficient(
    lowering: &mut Lowering<'_>,
    patch: Option<&str>,
    name: &Name,
    value: Value,
) -> Result<(Meaning, Option<Parameter>), Diagnostic> {
    lowering.scope.check_free(name)?;
    match value {
        Value::Scalar(expr) if lowering.graph.dependence(expr).is_constant() => {
            let parameter = parameter(lowering.graph, patch, &name.text, expr);
            Ok((Meaning::Parameter(lowering.graph.symbol_node(parameter.symbol)), Some(parameter)))
        }
        value => Ok((Meaning::Value(value), None)),
    }
}

/// `left = right`, with everything that contains S brought to the left.
fn text_equation(
    lowering: &mut Lowering<'_>,
    statement: &PdeStatement,
    [left, right]: [Expression; 2],
) -> Result<PdeOperator, Fault> {
    let (left_form, right_form) = (lowering.form(left)?, lowering.form(right)?);
    let mut terms: Vec<PdeTerm> = Vec::new();
    let signed =
        left_form.unknown.iter().map(|term| (false, term)).chain(right_form.unknown.iter().map(|term| (true, term)));
    for (is_negative, (derivative, coefficient)) in signed {
        let coefficient =
            components(*coefficient).map(|expr| if is_negative { lowering.graph.neg(expr) } else { expr });
        match terms.iter_mut().find(|term| term.derivative == *derivative) {
            Some(term) => {
                for (total, other) in term.coefficient.iter_mut().zip(coefficient) {
                    *total = lowering.graph.sum([*total, other]);
                }
            }
            None => terms.push(PdeTerm { derivative: *derivative, coefficient }),
        }
    }
    terms.retain(|term| term.coefficient.iter().any(|expr| !lowering.graph.is_zero(*expr)));
    terms.sort_by_key(|term| std::cmp::Reverse(term.derivative));
    let force = force(lowering, (left, left_form.value), (right, right_form.value))?;
    let operator = PdeOperator { terms, force, origin: Some(statement.span) };
    if operator.terms.is_empty() {
        return Err(Diagnostic::new(Code::NotLinear, "the equation does not contain S").at(statement.span).into());
    }
    if operator.order_in_u() == 0 {
        return Err(Diagnostic::new(Code::MissingEquationTerm, "the equation has no derivative in u")
            .at(statement.span)
            .hint("u runs from one trimline to the other; without a derivative in u nothing joins them")
            .into());
    }
    Ok(operator)
}

/// `q = right - left`, a vector or zero.
fn force(
    lowering: &mut Lowering<'_>,
    left: (Expression, Value),
    right: (Expression, Value),
) -> Result<[ExprId; 3], Diagnostic> {
    for (expression, value) in [left, right] {
        if let Value::Scalar(expr) = value
            && !lowering.graph.is_zero(expr)
        {
            return Err(Diagnostic::new(
                Code::NotScalar,
                "the equation is for a vector, so a term without S must be one",
            )
            .at(lowering.tree.span(expression))
            .hint("write the force as `[qx, qy, qz]`"));
        }
    }
    let (left, right) = (components(left.1), components(right.1));
    let [x, y, z] = left.map(|expr| lowering.graph.neg(expr));
    Ok([lowering.graph.sum([right[0], x]), lowering.graph.sum([right[1], y]), lowering.graph.sum([right[2], z])])
}
