//! WGSL, the shading language of WebGPU: one function and its tables, in single precision.

use std::fmt::Write;

use super::statements::{Spelling, comment, parameter, rows, single, statements};
use super::{Formula, Row};
use crate::expr::Function;

pub(super) const ROW: Row = Row { name: "wgsl", description: "WGSL (WebGPU)", is_single_precision: true, write };

fn function(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin(#0)",
        Function::Cos => "cos(#0)",
        Function::Tan => "tan(#0)",
        Function::Cot => "1.0 / tan(#0)",
        Function::Sec => "1.0 / cos(#0)",
        Function::Csc => "1.0 / sin(#0)",
        Function::Asin => "asin(#0)",
        Function::Acos => "acos(#0)",
        Function::Atan => "atan(#0)",
        Function::Atan2 => "atan2(#0, #1)",
        Function::Sinh => "sinh(#0)",
        Function::Cosh => "cosh(#0)",
        Function::Tanh => "tanh(#0)",
        Function::Asinh => "asinh(#0)",
        Function::Acosh => "acosh(#0)",
        Function::Atanh => "atanh(#0)",
        Function::Exp => "exp(#0)",
        Function::Ln => "log(#0)",
        Function::Log10 => "0.4342945 * log(#0)",
        Function::Cbrt => "sign(#0) * pow(abs(#0), 0.33333334)",
        Function::Abs => "abs(#0)",
        Function::Sign => "sign(#0)",
        Function::Floor => "floor(#0)",
        Function::Min => "min(#0, #1)",
        Function::Max => "max(#0, #1)",
        Function::Pow => "@_power(#0, #1)",
    }
}

fn write(formula: &Formula) -> String {
    let (name, count) = (&formula.name, formula.count());
    let spelling = Spelling { number: single, declaration: ["let ", ": f32"], end: ";", sqrt: "sqrt(#0)", function };
    let basis = statements(formula, &spelling);
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    // Variables, not constants: compilers refuse shaders whose constant expressions overflow on the way.
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "var<private> {}: f32 = {};", parameter(formula, index), single(value));
    }
    let vector = |x: &str, y: &str, z: &str| format!("vec3<f32>({x}, {y}, {z})");
    for (series, suffix, what) in formula.tables() {
        let _ = writeln!(text, "\n// {what}: by degree and function.");
        let kind = format!("array<vec3<f32>, {}>", series.coefficients.len() * count);
        let _ = writeln!(text, "var<private> {name}_{suffix}: {kind} = {kind}(");
        let rows = rows(&series.coefficients, vector, |value| format!("{:?}", value as f32));
        let _ = writeln!(text, "    {}\n);", rows.join(",\n    "));
    }
    if basis.lines.iter().any(|line| line.contains("_power(")) {
        let _ = write!(
            text,
            "
// pow is not defined for a negative base; whole exponents are.
fn {name}_power(x: f32, y: f32) -> f32 {{
    if (x > 0.0) {{ return pow(x, y); }}
    if (x == 0.0) {{ return select(0.0, 1.0, y == 0.0); }}
    let size = pow(-x, y);
    return select(size, -size, abs(y) % 2.0 == 1.0);
}}
"
        );
    }
    let _ = write!(
        text,
        "
struct {name}_Basis {{
    f: array<f32, {count}>,
    f_v: array<f32, {count}>,
}}

struct {name}_Point {{
    s: vec3<f32>,
    s_u: vec3<f32>,
    s_v: vec3<f32>,
}}

fn {name}_basis(v: f32, t: f32) -> {name}_Basis {{
"
    );
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let (values, slopes) = basis.outputs.split_at_checked(count).unwrap_or_default();
    let array = |values: &[String]| format!("array<f32, {count}>({})", values.join(", "));
    let _ = writeln!(text, "    return {name}_Basis({}, {});\n}}", array(values), array(slopes));
    let [low, high] = formula.domain.u.map(single);
    for (series, suffix, _) in formula.tables() {
        let terms = series.coefficients.len();
        let _ = write!(
            text,
            "
// The series of function j, with x from -1 to 1 over the range of u, by Clenshaw's recurrence.
fn {name}_{suffix}_series(j: i32, u: f32) -> vec3<f32> {{
    let x = (2.0 * u - {low} - {high}) / ({high} - {low});
    var next = vec3<f32>(0.0);
    var after = vec3<f32>(0.0);
    for (var k: i32 = {last}; k > 0; k--) {{
        let sum = 2.0 * x * next - after + {name}_{suffix}[k * {count} + j];
        after = next;
        next = sum;
    }}
    return x * next - after + {name}_{suffix}[j];
}}
",
            last = terms.saturating_sub(1),
        );
    }
    let (signature, instant) = match formula.instant {
        None => ("u: f32, v: f32, t: f32", String::new()),
        Some(t) => ("u: f32, v: f32", format!("    let t: f32 = {};\n", single(t))),
    };
    let _ = write!(
        text,
        "
// Position and derivatives in u and v.
fn {name}_surface({signature}) -> {name}_Point {{
{instant}    var basis = {name}_basis(v, t);
    var point = {name}_Point(vec3<f32>(0.0), vec3<f32>(0.0), vec3<f32>(0.0));
    for (var j: i32 = 0; j < {count}; j++) {{
        let g = {name}_g_series(j, u);
        point.s += g * basis.f[j];
        point.s_u += {name}_g_u_series(j, u) * basis.f[j];
        point.s_v += g * basis.f_v[j];
    }}
    return point;
}}
"
    );
    text
}
