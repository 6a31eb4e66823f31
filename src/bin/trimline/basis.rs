//! `trimline basis`: the decomposition, for reading, snapshots and programs.

use clap::{Args, ValueEnum};
use serde::Serialize;
use serde_json::{Map, Value};

use trimline::decompose::{Decomposition, close};
use trimline::diagnostic::{Code, Diagnostic};
use trimline::expr::{ExprId, Notation};
use trimline::limits::Limits;
use trimline::problem::Constraint;

use crate::Outcome;
use crate::failure::Failure;
use crate::options::{Reading, Terminal};
use crate::output;
use crate::workflow::Spec;

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    reading: Reading,

    /// Also the closure under the equation's derivatives, which the method `exact` solves on.
    #[arg(long)]
    closure: bool,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// How a decomposition is printed.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For reading.
    Text,
    /// For programs; keys are stable.
    Json,
    /// For documents with `amsmath`, and for KaTeX.
    Latex,
}

#[derive(Serialize)]
struct Patches {
    patches: Vec<PatchBasis>,
}

#[derive(Serialize)]
struct PatchBasis {
    name: String,
    basis: Vec<Function>,
    conditions: Vec<Condition>,
    /// Data on four sides, which are not factored; then there are no conditions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sides: Vec<Side>,
    /// The functions that the closure adds.
    #[serde(skip_serializing_if = "Option::is_none")]
    closure: Option<Vec<String>>,
}

#[derive(Serialize)]
struct Function {
    name: String,
    expr: String,
    /// Null for one that does not exist.
    derivatives: Map<String, Value>,
}

#[derive(Serialize)]
struct Condition {
    u: String,
    order: usize,
    symbol: String,
    coefficients: Vec<[String; 3]>,
    values: Vec<[f64; 3]>,
}

#[derive(Serialize)]
struct Side {
    /// The position, under the name of the variable that is fixed: `u` or `v`.
    #[serde(flatten)]
    position: Map<String, Value>,
    order: usize,
    value: [String; 3],
}

pub fn run(arguments: &Arguments, _terminal: &Terminal) -> Outcome {
    if arguments.closure && arguments.format == Format::Latex {
        return Err(Failure::Usage("--closure is printed as text or JSON".to_owned()));
    }
    let spec = Spec::read(&arguments.spec, &arguments.reading)?;
    spec.without_nets("basis")?;
    if spec.patches.is_empty() {
        spec.without_copies("basis")?;
    }
    let mut texts = Vec::new();
    let mut patches = Vec::new();
    for patch in &spec.patches {
        let decomposition = spec.decompose(patch)?;
        // As `exact` closes it: without the terms of the equation that are zero.
        let specialised = || decomposition.clone().specialise(spec.bindings.as_slice());
        match arguments.format {
            Format::Text => {
                let text = decomposition.to_text(Notation::Unicode, &spec.limits);
                texts.push(text.map_err(|finding| spec.fault(finding))?);
                if arguments.closure && !patch.is_four_sided() {
                    let text = close(&specialised(), &spec.limits).and_then(|closure| {
                        closure.to_text(decomposition.basis.len(), Notation::Unicode, &spec.limits)
                    });
                    texts.push(text.map_err(|finding| spec.fault(finding))?);
                }
            }
            Format::Latex => {
                let text = decomposition.to_latex(&spec.limits);
                texts.push(text.map_err(|finding| spec.fault(finding))?);
            }
            Format::Json => {
                let basis = patch_basis(&decomposition, spec.bindings.as_slice(), &spec.limits);
                let mut basis = basis.map_err(|finding| spec.fault(finding))?;
                if arguments.closure && !patch.is_four_sided() {
                    basis.closure = Some(added(&specialised(), &spec.limits).map_err(|finding| spec.fault(finding))?);
                }
                patches.push(basis);
            }
        }
    }
    match arguments.format {
        Format::Text | Format::Latex => output::print(&texts.join("\n")),
        Format::Json => output::print_json(&Patches { patches }),
    }
}

fn patch_basis(decomposition: &Decomposition, params: &[f64], limits: &Limits) -> Result<PatchBasis, Diagnostic> {
    let text = |expr: ExprId| decomposition.text_of(expr, Notation::Ascii, limits);
    let mut basis = Vec::new();
    for (index, function) in decomposition.basis.iter().enumerate() {
        let mut derivatives = Map::new();
        for (orders, expr) in &function.derivatives {
            derivatives.insert(orders.to_string(), Value::String(text(*expr)?));
        }
        for orders in function.missing(&decomposition.patch.operator) {
            derivatives.insert(orders.to_string(), Value::Null);
        }
        basis.push(Function { name: format!("F{}", index + 1), expr: text(function.expr)?, derivatives });
    }
    let mut conditions = Vec::new();
    let is_factored = !decomposition.patch.is_four_sided();
    for (index, condition) in decomposition.patch.conditions.iter().enumerate().filter(|_| is_factored) {
        let rows = decomposition.coefficients.get(index).into_iter().flatten();
        let value = |expr: ExprId| decomposition.graph.value(expr, params, [f64::NAN; 3]);
        let mut coefficients = Vec::new();
        for [x, y, z] in rows.clone() {
            coefficients.push([text(*x)?, text(*y)?, text(*z)?]);
        }
        conditions.push(Condition {
            u: text(condition.u)?,
            order: condition.order,
            symbol: decomposition.symbol(index),
            coefficients,
            values: rows.map(|vector| vector.map(value)).collect(),
        });
    }
    let mut sides = Vec::new();
    for Constraint { across, position, derivative, value: [x, y, z] } in decomposition.sides() {
        let position = Map::from_iter([(across.name().to_owned(), Value::String(text(position)?))]);
        sides.push(Side { position, order: derivative.order(across), value: [text(x)?, text(y)?, text(z)?] });
    }
    Ok(PatchBasis { name: decomposition.patch.name.clone(), basis, conditions, sides, closure: None })
}

/// The functions that the closure adds to the basis.
fn added(decomposition: &Decomposition, limits: &Limits) -> Result<Vec<String>, Diagnostic> {
    let closure = close(decomposition, limits)?;
    let too_long = |_| Diagnostic::new(Code::LimitReached, "an expression is longer than the limit `text-bytes`");
    let functions = closure.functions.iter().skip(decomposition.basis.len());
    functions.map(|(expr, _)| closure.graph.text(*expr, Notation::Ascii, limits.text_bytes).map_err(too_long)).collect()
}
