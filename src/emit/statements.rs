//! The lowering of a program to statements, the same for every language but for the spelling.

use crate::eval::{Op, OpId, Program};
use crate::expr::{Function, Variable};

use super::Formula;

/// How a language spells what a program does.
pub(super) struct Spelling {
    /// A number.
    pub number: fn(f64) -> String,
    /// What stands before and after the name in `NAME = value`.
    pub declaration: [&'static str; 2],
    /// What ends a statement.
    pub end: &'static str,
    /// The square root, with `#0` for the operand.
    pub sqrt: &'static str,
    /// A function, with `#0` and `#1` for its operands and `@` for what names begin with.
    pub function: fn(Function) -> &'static str,
}

/// The statements that compute the basis, and an expression for each output of the program.
pub(super) struct Statements {
    /// One assignment a line.
    pub lines: Vec<String>,
    /// The value of each output: a name or a number.
    pub outputs: Vec<String>,
}

/// Writes the program of `formula`: names are `v`, `t`, those of parameters, and `r0`, `r1`, ….
pub(super) fn statements(formula: &Formula, spelling: &Spelling) -> Statements {
    let program = &formula.program;
    let mut values: Vec<String> = Vec::with_capacity(program.ops().len());
    let mut lines = Vec::new();
    for op in program.ops() {
        let of = |id: OpId| values.get(id.index()).cloned().unwrap_or_default();
        let text = match op {
            Op::Constant(value) => Err((spelling.number)(*value)),
            Op::Parameter(index) => Err(parameter(formula, *index)),
            Op::Variable(variable) => Err(match variable {
                Variable::U => "u".to_owned(),
                Variable::V => "v".to_owned(),
                Variable::T => "t".to_owned(),
            }),
            Op::Neg(a) => Ok(format!("-{}", of(*a))),
            Op::Add(a, b) => Ok(format!("{} + {}", of(*a), of(*b))),
            Op::Sub(a, b) => Ok(format!("{} - {}", of(*a), of(*b))),
            Op::Mul(a, b) => Ok(format!("{} * {}", of(*a), of(*b))),
            Op::Div(a, b) => Ok(format!("{} / {}", of(*a), of(*b))),
            Op::Sqrt(a) => Ok(filled(spelling.sqrt, &formula.name, &[of(*a)])),
            Op::Call1(function, a) => Ok(filled((spelling.function)(*function), &formula.name, &[of(*a)])),
            // Refused by `Formula::new`.
            Op::Spline1(..) | Op::Spline2(..) => Err("nan".to_owned()),
            Op::Call2(function, a, b) => Ok(filled((spelling.function)(*function), &formula.name, &[of(*a), of(*b)])),
        };
        values.push(text.map_or_else(
            |operand| operand,
            |computed| {
                let name = format!("r{}", lines.len());
                let [before, after] = spelling.declaration;
                lines.push(format!("{before}{name}{after} = {computed}{}", spelling.end));
                name
            },
        ));
    }
    let outputs = outputs(program, &values);
    Statements { lines, outputs }
}

fn outputs(program: &Program, values: &[String]) -> Vec<String> {
    program.output_ops().iter().map(|id| values.get(id.index()).cloned().unwrap_or_default()).collect()
}

/// The emitted name of the parameter at `index`.
pub(super) fn parameter(formula: &Formula, index: usize) -> String {
    let name = formula.parameters.get(index).map_or("unknown", |(name, _)| name.as_str());
    format!("{}_p_{name}", formula.name)
}

/// A template with its operands in place.
fn filled(template: &str, name: &str, operands: &[String]) -> String {
    let mut text = template.replace('@', name);
    for (index, operand) in operands.iter().enumerate() {
        text = text.replace(&format!("#{index}"), operand);
    }
    text
}

/// A double with the fewest digits that read back to it; negative ones in brackets, since they stand after operators.
pub(super) fn double(value: f64) -> String {
    if value.is_sign_negative() { format!("({value:?})") } else { format!("{value:?}") }
}

/// The nearest single with the fewest digits that read back to it.
pub(super) fn single(value: f64) -> String {
    let value = value as f32;
    if value.is_sign_negative() { format!("({value:?})") } else { format!("{value:?}") }
}

/// The rows of a table: one for each degree, an `x, y, z` for each function.
pub(super) fn rows(
    coefficients: &[Vec<f64>],
    vector: impl Fn(&str, &str, &str) -> String,
    number: fn(f64) -> String,
) -> Vec<String> {
    let row = |row: &Vec<f64>| {
        let vectors = row.chunks(3).filter_map(|chunk| match chunk {
            [x, y, z] => Some(vector(&number(*x), &number(*y), &number(*z))),
            _ => None,
        });
        vectors.collect::<Vec<_>>().join(", ")
    };
    coefficients.iter().map(row).collect()
}

/// `lines` behind `marker`.
pub(super) fn comment(lines: &[String], marker: &str) -> String {
    lines.iter().map(|line| format!("{marker} {line}").trim_end().to_owned() + "\n").collect()
}
