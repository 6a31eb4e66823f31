//! The `pde` statement to a [`PdeOperator`] and the parameters that are its coefficients.

use rustc_hash::FxHashSet;

use super::form::components;
use super::lower::Lowering;
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::expr::{ExprId, Graph, Node};
use crate::limits::Limits;
use crate::problem::{Parameter, ParameterKind, PdeOperator, PdeTerm, STANDARD_COEFFICIENTS};
use crate::syntax::ast::{Document, Expression, Kind, Name, PdeStatement};

/// Resolves the equation; coefficients that are constant become parameters.
pub fn resolve(
    document: &Document,
    graph: &mut Graph,
    scope: &Scope,
    parameters: &mut Vec<Parameter>,
    limits: &Limits,
) -> Result<PdeOperator, Diagnostics> {
    let statement = match document.equations.as_slice() {
        [] => None,
        [only] => Some(only),
        [first, second, ..] => {
            return Err(vec![
                Diagnostic::new(Code::DuplicateStatement, "the equation is stated twice")
                    .at(second.span)
                    .label(first.span, "first stated here"),
            ]);
        }
    };
    let mut scope = scope.clone();
    let stated = statement.map_or(&[][..], |statement| statement.coefficients.as_slice());
    let mut found = Diagnostics::new();
    let is_standard = statement.is_none_or(|statement| statement.sides.is_none());
    if is_standard {
        found.extend(
            stated.iter().filter(|(name, _)| !is_standard_name(&name.text)).map(|(name, _)| not_standard(name)),
        );
        for (name, _, default) in STANDARD_COEFFICIENTS {
            if stated.iter().all(|(stated, _)| stated.text != name) {
                match default_coefficient(graph, &scope, name, default, document) {
                    Ok(parameter) => parameters.push(parameter),
                    Err(finding) => found.push(finding),
                }
            }
        }
    }
    for (name, value) in stated {
        let outer = scope.clone();
        let mut lowering = Lowering { tree: &document.tree, graph, scope: &outer, limits };
        match lowering.value(*value).and_then(|value| coefficient(&mut lowering, name, value)) {
            Ok((meaning, parameter)) => {
                if let Some(parameter) = parameter {
                    let origin = Some(document.tree.span(*value));
                    parameters.push(Parameter { origin, ..parameter });
                }
                found.extend(scope.declare(name, meaning).err());
            }
            Err(finding) => found.push(finding),
        }
    }
    if !found.is_empty() {
        return Err(found);
    }
    let operator = match statement.and_then(|statement| statement.sides.map(|sides| (statement, sides))) {
        None => Ok(standard(graph, &scope, stated, statement)),
        Some((statement, sides)) => {
            let mut lowering = Lowering { tree: &document.tree, graph, scope: &scope, limits };
            text_equation(&mut lowering, statement, sides)
        }
    };
    let operator = operator.map_err(|finding| vec![finding])?;
    let used = sides_of(statement).map(|sides| used_names(graph, parameters, document, sides));
    let is_used = |name: &str| used.as_ref().is_none_or(|used| used.contains(name));
    let unused = stated.iter().filter(|(name, _)| !is_used(&name.text));
    let unused: Diagnostics = unused.map(|(name, _)| unused_coefficient(name)).collect();
    if unused.is_empty() { Ok(operator) } else { Err(unused) }
}

/// The standard equation; a stated coefficient that is a vector or depends on u, v or t stands for itself.
fn standard(
    graph: &mut Graph,
    scope: &Scope,
    stated: &[(Name, Expression)],
    statement: Option<&PdeStatement>,
) -> PdeOperator {
    let mut operator = PdeOperator::standard(graph);
    operator.origin = statement.map(|statement| statement.span);
    for (name, derivative, _) in STANDARD_COEFFICIENTS {
        let is_stated = stated.iter().any(|(stated, _)| stated.text == name);
        let term = operator.terms.iter_mut().find(|term| term.derivative == derivative);
        if let (true, Some(Meaning::Value(value)), Some(term)) = (is_stated, scope.meaning(name), term) {
            term.coefficient = components(*value);
        }
    }
    operator
}

fn sides_of(statement: Option<&PdeStatement>) -> Option<[Expression; 2]> {
    statement.and_then(|statement| statement.sides)
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
fn used_names(
    graph: &Graph,
    parameters: &[Parameter],
    document: &Document,
    sides: [Expression; 2],
) -> FxHashSet<String> {
    let parts = sides.iter().flat_map(|side| document.tree.parts(*side));
    let mut used: FxHashSet<String> = parts
        .filter_map(|part| match &document.tree.node(part).kind {
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

fn default_coefficient(
    graph: &mut Graph,
    scope: &Scope,
    name: &str,
    default: i64,
    document: &Document,
) -> Result<Parameter, Diagnostic> {
    if scope.meaning(name).is_some() {
        let declared = document.parameters.iter().map(|parameter| &parameter.name);
        let declared = declared.chain(document.definitions.iter().map(|definition| &definition.name));
        let finding = Diagnostic::new(
            Code::DuplicateName,
            format!("`{name}` is also the name of a coefficient of the standard equation, which this document uses"),
        );
        let finding = declared.filter(|found| found.text == name).fold(finding, |finding, name| finding.at(name.span));
        return Err(
            finding.hint(format!("rename it, or state the equation with `pde … = 0`, or say `pde with {name} = …`"))
        );
    }
    let value = graph.integer(default);
    Ok(Parameter {
        symbol: graph.symbol_id(name),
        name: name.to_owned(),
        value,
        interval: None,
        kind: ParameterKind::Coefficient,
        origin: None,
        is_overridden: false,
    })
}

/// A constant becomes a parameter that can be changed; a function of u, v or t stands for itself.
fn coefficient(
    lowering: &mut Lowering<'_>,
    name: &Name,
    value: Value,
) -> Result<(Meaning, Option<Parameter>), Diagnostic> {
    lowering.scope.check_free(name)?;
    match value {
        Value::Scalar(expr) if lowering.graph.dependence(expr).is_constant() => {
            let symbol = lowering.graph.symbol_id(&name.text);
            let parameter = Parameter {
                symbol,
                name: name.text.clone(),
                value: expr,
                interval: None,
                kind: ParameterKind::Coefficient,
                origin: None,
                is_overridden: false,
            };
            let meaning = Meaning::Value(Value::Scalar(lowering.graph.symbol_node(symbol)));
            Ok((meaning, Some(parameter)))
        }
        value => Ok((Meaning::Value(value), None)),
    }
}

/// `left = right`, with everything that contains S brought to the left.
fn text_equation(
    lowering: &mut Lowering<'_>,
    statement: &PdeStatement,
    [left, right]: [Expression; 2],
) -> Result<PdeOperator, Diagnostic> {
    let (left_form, right_form) = (lowering.form(left)?, lowering.form(right)?);
    for (side, form) in [(left, &left_form), (right, &right_form)] {
        if !form.operator.is_empty() {
            let finding = Diagnostic::new(Code::NotLinear, "an operator is not applied to S");
            return Err(finding.at(lowering.tree.span(side)).hint("write S behind it: `(∂²/∂u² + ∂²/∂v²) S`"));
        }
    }
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
        return Err(Diagnostic::new(Code::NotLinear, "the equation does not contain S").at(statement.span));
    }
    if operator.order_in_u() == 0 {
        return Err(Diagnostic::new(Code::MissingEquationTerm, "the equation has no derivative in u")
            .at(statement.span)
            .hint("u runs from one trimline to the other; without a derivative in u nothing joins them"));
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
