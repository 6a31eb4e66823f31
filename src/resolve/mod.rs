//! The document to a [`Problem`]: names looked up, constraints counted, the equation brought to its terms.
//!
//! Input: a [`Document`]; output: a [`Problem`] that is complete and linear, or every fault of the document
//! that can be found at once. Nothing numerical is decided here except where boundaries lie.

mod boundary;
mod equation;
mod lower;
mod scope;

use lower::Lowering;
use scope::{Meaning, Scope, Value};

use crate::diagnostic::{Class, Code, Diagnostic, Diagnostics, MOST_FINDINGS, Source};
use crate::expr::{ExprId, Graph, Variable};
use crate::limits::Limits;
use crate::problem::{Bindings, Domain, Parameter, ParameterKind, Patch, Problem, RequestedSetting, SolveRequest};
use crate::syntax::ast::{Document, Name};
use crate::syntax::parse_expression;

/// Resolves a document into a problem with one patch called `name`.
///
/// # Errors
/// Every fault found, in the order of the stages that find them.
pub fn resolve(document: &Document, name: &str, limits: &Limits) -> Result<Problem, Diagnostics> {
    let mut graph = Graph::new();
    let mut scope = Scope::new(&mut graph, limits);
    let mut parameters = declare_parameters(document, &mut graph, &mut scope, limits)?;
    declare_definitions(document, &mut graph, &mut scope, limits)?;
    let operator = equation::resolve(document, &mut graph, &scope, &mut parameters, limits)?;
    let domain = domain(document, &mut graph, &scope, limits)?;
    let mut problem = Problem { graph, parameters, patches: Vec::new() };
    let bindings = Bindings::evaluate(&problem).map_err(|finding| vec![finding])?;
    let values = domain.evaluate(&problem, &bindings).map_err(|finding| vec![finding])?;
    let mut graph = std::mem::take(&mut problem.graph);
    let conditions = boundary::resolve(
        &document.boundaries,
        &mut Lowering { tree: &document.tree, graph: &mut graph, scope: &scope, limits },
        operator.order_in_u(),
        values.u,
        |expr, span, graph| {
            let value = graph.value(expr, bindings.as_slice(), [f64::NAN; 3]);
            if value.is_finite() {
                return Ok(value);
            }
            Err(Diagnostic::new(Code::ParameterNotFinite, "the position of a boundary is not finite").at(span))
        },
    )?;
    let solve = solve_request(document)?;
    problem.graph = graph;
    problem.patches.push(Patch {
        name: name.to_owned(),
        domain,
        operator,
        conditions,
        side_conditions: Vec::new(),
        deformations: Vec::new(),
        solve,
    });
    Ok(problem)
}

/// Replaces the value of a parameter or coefficient by an expression in earlier ones (`--set NAME=EXPR`).
///
/// # Errors
/// [`Code::UnknownName`] if nothing settable is called `name`; otherwise as for the value of a `param`, with
/// places in `value`.
pub fn set_parameter(problem: &mut Problem, name: &str, value: &Source, limits: &Limits) -> Result<(), Diagnostics> {
    let canonical = crate::expr::canonical_name(name);
    let Some(index) = problem.parameters.iter().position(|parameter| parameter.name == canonical) else {
        let known: Vec<&str> = problem.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        return Err(vec![
            Diagnostic::new(Code::UnknownName, format!("no param or coefficient is called `{name}`"))
                .hint(format!("there are: {}", known.join(", "))),
        ]);
    };
    let (tree, expression) = parse_expression(value, limits)?;
    let mut scope = Scope::new(&mut problem.graph, limits);
    for earlier in problem.parameters.iter().take(index) {
        let meaning = Meaning::Value(Value::Scalar(problem.graph.symbol_node(earlier.symbol)));
        let name = Name { text: earlier.name.clone(), span: earlier.origin.unwrap_or_default() };
        scope.declare(&name, meaning).map_err(|finding| vec![finding])?;
    }
    let mut lowering = Lowering { tree: &tree, graph: &mut problem.graph, scope: &scope, limits };
    let expr = lowering.constant(expression, "the value of a param").map_err(|finding| vec![finding])?;
    if let Some(parameter) = problem.parameters.get_mut(index) {
        parameter.value = expr;
        parameter.origin = None;
        parameter.is_overridden = true;
    }
    Ok(())
}

fn declare_parameters(
    document: &Document,
    graph: &mut Graph,
    scope: &mut Scope,
    limits: &Limits,
) -> Result<Vec<Parameter>, Diagnostics> {
    let mut found = Diagnostics::new();
    let mut parameters = Vec::new();
    for declared in &document.parameters {
        let mut lowering = Lowering { tree: &document.tree, graph, scope, limits };
        let what = format!("the param `{}`", declared.name.text);
        let value = lowering.constant(declared.value, &what);
        let interval = declared.interval.map(|ends| ends.map(|end| lowering.constant(end, "the range of a param")));
        let interval = match interval {
            Some([Ok(low), Ok(high)]) => Some([low, high]),
            Some(ends) => {
                found.extend(ends.into_iter().filter_map(Result::err));
                None
            }
            None => None,
        };
        // A param with a faulty value is declared all the same, so that its uses are not reported too.
        let value = match value {
            Ok(value) => value,
            Err(finding) => {
                let is_limit = finding.class() == Class::Limit;
                found.push(finding);
                if is_limit || found.len() >= MOST_FINDINGS {
                    return Err(found);
                }
                graph.integer(0)
            }
        };
        let symbol = graph.symbol_id(&declared.name.text);
        let meaning = Meaning::Value(Value::Scalar(graph.symbol_node(symbol)));
        match scope.declare(&declared.name, meaning) {
            Ok(()) => parameters.push(Parameter {
                symbol,
                name: declared.name.text.clone(),
                value,
                interval,
                kind: ParameterKind::Parameter,
                origin: Some(document.tree.span(declared.value)),
                is_overridden: false,
            }),
            Err(finding) => found.push(finding),
        }
    }
    if found.is_empty() { Ok(parameters) } else { Err(found) }
}

fn declare_definitions(
    document: &Document,
    graph: &mut Graph,
    scope: &mut Scope,
    limits: &Limits,
) -> Result<(), Diagnostics> {
    let mut found = Diagnostics::new();
    for definition in &document.definitions {
        let mut local = scope.clone();
        let mut formals: Vec<ExprId> = Vec::new();
        for formal in &definition.formals {
            // A space cannot occur in a name, so an argument never meets a param.
            let symbol = graph.symbol(&format!("{} of {}", formal.text, definition.name.text));
            found.extend(local.declare(formal, Meaning::Value(Value::Scalar(symbol))).err());
            formals.push(symbol);
        }
        let value = Lowering { tree: &document.tree, graph, scope: &local, limits }.value(definition.value);
        let value = match value {
            Ok(value) => value,
            Err(finding) => {
                // A limit stays reached: every later definition would report it again.
                let is_limit = finding.class() == Class::Limit;
                found.push(finding);
                if is_limit || found.len() >= MOST_FINDINGS {
                    return Err(found);
                }
                Value::Scalar(graph.integer(0))
            }
        };
        let meaning = if formals.is_empty() { Meaning::Value(value) } else { Meaning::Function(formals, value) };
        found.extend(scope.declare(&definition.name, meaning).err());
    }
    if found.is_empty() { Ok(()) } else { Err(found) }
}

fn domain(document: &Document, graph: &mut Graph, scope: &Scope, limits: &Limits) -> Result<Domain, Diagnostics> {
    let mut domain = Domain::standard(graph);
    let mut found = Diagnostics::new();
    for range in &document.ranges {
        let Some(index) = Variable::ALL.iter().position(|variable| variable.name() == range.variable.text) else {
            found.push(
                Diagnostic::new(Code::UnknownName, format!("`{}` has no domain", range.variable.text))
                    .at(range.variable.span)
                    .hint("the coordinates are u, v and t; a param has its range behind its value: `param a = 1 in [0, 2]`"),
            );
            continue;
        };
        let mut lowering = Lowering { tree: &document.tree, graph, scope, limits };
        let ends = range.interval.map(|end| lowering.constant(end, "a domain"));
        let [low, high] = range.interval.map(|end| document.tree.span(end));
        let (Some(slot), Some(origin)) = (domain.ends.get_mut(index), domain.origins.get_mut(index)) else { continue };
        if let Some(first) = origin {
            let message = format!("the domain of {} is stated twice", range.variable.text);
            found.push(
                Diagnostic::new(Code::DuplicateStatement, message)
                    .at(range.variable.span)
                    .label(*first, "first stated here"),
            );
            continue;
        }
        match ends {
            [Ok(low), Ok(high)] => *slot = [low, high],
            ends => found.extend(ends.into_iter().filter_map(Result::err)),
        }
        *origin = Some(low.to(high));
    }
    if found.is_empty() { Ok(domain) } else { Err(found) }
}

fn solve_request(document: &Document) -> Result<SolveRequest, Diagnostics> {
    let statement = match document.solves.as_slice() {
        [] => return Ok(SolveRequest::default()),
        [only] => only,
        [first, second, ..] => {
            return Err(vec![
                Diagnostic::new(Code::DuplicateStatement, "the method is stated twice")
                    .at(second.method.span)
                    .label(first.method.span, "first stated here"),
            ]);
        }
    };
    let settings = statement.settings.iter().map(|setting| RequestedSetting {
        key: setting.key.text.clone(),
        value: setting.value.clone(),
        origin: Some(setting.span),
    });
    Ok(SolveRequest {
        method: Some(statement.method.text.clone()),
        origin: Some(statement.method.span),
        settings: settings.collect(),
    })
}
