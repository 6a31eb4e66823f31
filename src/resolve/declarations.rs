//! Params and definitions to their meanings.

use super::curve;
use super::imported;
use super::reading::Reading;
use super::scope::{Meaning, Scope, Value};
use super::surface;
use crate::expr::{ExprId, Variable};
use crate::problem::{Parameter, ParameterKind};
use crate::syntax::ast::{self, DefinitionKind};

/// Declares every param; one with a faulty value is declared as faulty, so that its uses are not reported too.
pub fn parameters(declared: &[ast::Parameter], scope: &mut Scope<'_>, reading: &mut Reading<'_>) -> Vec<Parameter> {
    let mut parameters = Vec::with_capacity(declared.len());
    for param in declared {
        if reading.is_over {
            break;
        }
        let what = format!("the param `{}`", param.name.text);
        let value = reading.lowering(scope).constant(param.value, &what);
        let value = reading.keep(value);
        let interval = param.interval.map(|ends| {
            ends.map(|end| {
                let end = reading.lowering(scope).constant(end, "the range of a param");
                reading.keep(end)
            })
        });
        let interval = match interval {
            Some([Some(low), Some(high)]) => Some([low, high]),
            _ => None,
        };
        let symbol = reading.graph.symbol_id(&param.name.text);
        let meaning = match value {
            Some(_) => Meaning::Parameter(reading.graph.symbol_node(symbol)),
            None => Meaning::Faulty,
        };
        let is_declared = scope.declare(&param.name, meaning);
        let is_declared = reading.keep(is_declared).is_some();
        if let (Some(value), true) = (value, is_declared) {
            parameters.push(Parameter {
                symbol,
                name: param.name.text.clone(),
                value,
                interval,
                kind: ParameterKind::Parameter,
                origin: Some(reading.tree.span(param.value)),
                is_overridden: false,
            });
        }
    }
    parameters
}

/// Declares every definition in `scope`.
pub fn definitions(definitions: &[ast::Definition], scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    for definition in definitions {
        if reading.is_over {
            return;
        }
        match &definition.kind {
            DefinitionKind::Surface(ranges) => {
                surface::declare(definition, ranges, scope, reading);
                continue;
            }
            DefinitionKind::Curve => {
                curve::declare(definition, scope, reading);
                continue;
            }
            DefinitionKind::Imported(face) => {
                imported::declare(definition, *face, scope, reading);
                continue;
            }
            DefinitionKind::Let => {}
        }
        let meaning = meaning(definition, scope, reading);
        let is_declared = scope.declare(&definition.name, meaning);
        reading.keep(is_declared);
    }
}

/// What a `let` gives its name.
pub fn meaning(definition: &ast::Definition, scope: &Scope<'_>, reading: &mut Reading<'_>) -> Meaning {
    let mut local = scope.inner();
    let mut formals: Vec<ExprId> = Vec::with_capacity(definition.formals.len());
    for formal in &definition.formals {
        // A space cannot occur in a name, so an argument never meets a param.
        let symbol = reading.graph.symbol(&format!("{} of {}", formal.text, definition.name.text));
        let is_declared = local.declare(formal, Meaning::Value(Value::Scalar(symbol)));
        let is_coordinate = Variable::ALL.iter().any(|variable| variable.name() == formal.text);
        reading.keep(is_declared.map_err(|finding| {
            let (coordinate, name) = (&formal.text, &definition.name.text);
            match is_coordinate {
                true => finding.hint(format!("{coordinate} is known in every `let`: write `let {name} = …`")),
                false => finding,
            }
        }));
        formals.push(symbol);
    }
    let value = reading.lowering(&local).value(definition.value);
    match reading.keep(value) {
        None => Meaning::Faulty,
        Some(value) if formals.is_empty() => Meaning::Value(value),
        Some(value) => Meaning::Function(formals, value),
    }
}
