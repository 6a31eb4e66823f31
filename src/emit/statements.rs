//! The lowering of a program to statements, the same for every language but for the spelling.

use crate::eval::{Op, OpId, Program};
use crate::expr::{Function, Variable};

use super::Formula;
use super::table::SplineTable;
use crate::surface::BsplineSurface;

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

/// The statements that compute a program, and an expression for each of its outputs.
pub(super) struct Statements {
    /// One assignment a line.
    pub lines: Vec<String>,
    /// The value of each output: a name or a number.
    pub outputs: Vec<String>,
    /// The functions of data that the lines call, each with its name.
    pub splines: Vec<(String, SplineTable)>,
}

/// Writes `program`, whose own names begin with `prefix`: names in it are `u`, `v`, `t`, those of the parameters of
/// `formula`, and `r0`, `r1`, ….
pub(super) fn statements(formula: &Formula, program: &Program, prefix: &str, spelling: &Spelling) -> Statements {
    let ops = program.ops();
    let mut values: Vec<String> = Vec::with_capacity(ops.len());
    let (mut lines, mut splines) = (Vec::new(), Vec::new());
    for op in ops {
        let of = |id: OpId| values.get(id.index()).cloned().unwrap_or_default();
        let mut spline = |index: usize, operands: &[OpId]| {
            let Some(call) = program.splines().get(index) else { return String::new() };
            let constant = |id: &OpId| match ops.get(id.index()) {
                Some(Op::Constant(value)) => Some(*value),
                _ => None,
            };
            let constants: Vec<Option<f64>> = operands.iter().map(constant).collect();
            let varying = operands.iter().zip(&constants).filter(|(_, constant)| constant.is_none());
            let arguments: Vec<String> = varying.map(|(id, _)| of(*id)).collect();
            let table = SplineTable::new(call, &constants);
            if arguments.is_empty() {
                return (spelling.number)(table.coefficients.first().copied().unwrap_or(f64::NAN));
            }
            let name = format!("{prefix}_spline_{}", splines.len());
            let text = format!("{name}({})", arguments.join(", "));
            splines.push((name, table));
            text
        };
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
            Op::Spline1(index, a) => Ok(spline(*index, &[*a])),
            Op::Spline2(index, a, b) => Ok(spline(*index, &[*a, *b])),
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
    Statements { lines, outputs, splines }
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

/// Numbers, with `number` each.
pub(super) fn list(values: &[f64], number: fn(f64) -> String) -> String {
    values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}

/// The rows of a table: one for each degree, an `x, y, z` for each function.
pub(super) fn rows<Row: AsRef<[f64]>>(
    coefficients: &[Row],
    vector: impl Fn(&str, &str, &str) -> String,
    number: fn(f64) -> String,
) -> Vec<String> {
    let row = |row: &Row| {
        let vectors = row.as_ref().chunks(3).filter_map(|chunk| match chunk {
            [x, y, z] => Some(vector(&number(*x), &number(*y), &number(*z))),
            _ => None,
        });
        vectors.collect::<Vec<_>>().join(", ")
    };
    coefficients.iter().map(row).collect()
}

/// The rows of a net: one for each i, an `x, y, z` for each j.
pub(super) fn net_rows(
    surface: &BsplineSurface,
    vector: impl Fn(&str, &str, &str) -> String,
    number: fn(f64) -> String,
) -> Vec<String> {
    let flat: Vec<Vec<f64>> = surface.rows().map(|row| row.iter().flatten().copied().collect()).collect();
    rows(&flat, vector, number)
}

/// `lines` behind `marker`.
pub(super) fn comment(lines: &[String], marker: &str) -> String {
    lines.iter().map(|line| format!("{marker} {line}").trim_end().to_owned() + "\n").collect()
}
