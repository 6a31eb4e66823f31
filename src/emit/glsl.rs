//! GLSL, the shading language of WebGL 2 and OpenGL: one function and its tables, in single precision.

use std::fmt::Write;

use super::statements::{Spelling, comment, parameter, rows, single, statements};
use super::{Formula, Row};
use crate::expr::Function;

pub(super) const ROW: Row =
    Row { name: "glsl", description: "GLSL ES 3.00 (WebGL 2, OpenGL)", is_single_precision: true, write };

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
        Function::Atan2 => "atan(#0, #1)",
        Function::Sinh => "sinh(#0)",
        Function::Cosh => "cosh(#0)",
        Function::Tanh => "tanh(#0)",
        Function::Asinh => "asinh(#0)",
        Function::Acosh => "acosh(#0)",
        Function::Atanh => "atanh(#0)",
        Function::Exp => "exp(#0)",
        Function::Ln => "log(#0)",
        Function::Log10 => "0.4342945 * log(#0)",
        Function::Cbrt => "sign(#0) * pow(abs(#0), 1.0 / 3.0)",
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
    let spelling = Spelling { number: single, declaration: ["float ", ""], end: ";", sqrt: "sqrt(#0)", function };
    let basis = statements(formula, &spelling);
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "const float {} = {:?};", parameter(formula, index), value as f32);
    }
    let vector = |x: &str, y: &str, z: &str| format!("vec3({x}, {y}, {z})");
    for (series, suffix, what) in formula.tables() {
        let _ = writeln!(text, "\n// {what}: by degree and function.");
        let size = series.coefficients.len() * count;
        let _ = writeln!(text, "const vec3 {name}_{suffix}[{size}] = vec3[{size}](");
        let rows = rows(&series.coefficients, vector, |value| format!("{:?}", value as f32));
        let _ = writeln!(text, "    {}\n);", rows.join(",\n    "));
    }
    if basis.lines.iter().any(|line| line.contains("_power(")) {
        let _ = write!(
            text,
            "
// pow is not defined for a negative base; whole exponents are.
float {name}_power(float x, float y) {{
    if (x > 0.0) {{ return pow(x, y); }}
    if (x == 0.0) {{ return y == 0.0 ? 1.0 : 0.0; }}
    float size = pow(-x, y);
    return mod(abs(y), 2.0) == 1.0 ? -size : size;
}}
"
        );
    }
    let _ = writeln!(text, "\nvoid {name}_basis(float v, float t, out float f[{count}], out float f_v[{count}]) {{");
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    for (j, value) in basis.outputs.iter().enumerate() {
        let (array, j) = if j < count { ("f", j) } else { ("f_v", j - count) };
        let _ = writeln!(text, "    {array}[{j}] = {value};");
    }
    let _ = writeln!(text, "}}");
    let [low, high] = formula.domain.u.map(single);
    for (series, suffix, _) in formula.tables() {
        let terms = series.coefficients.len();
        let _ = write!(
            text,
            "
// The series of function j, with x from -1 to 1 over the range of u, by Clenshaw's recurrence.
vec3 {name}_{suffix}_series(int j, float u) {{
    float x = (2.0 * u - {low} - {high}) / ({high} - {low});
    vec3 next = vec3(0.0), after = vec3(0.0);
    for (int k = {last}; k > 0; k--) {{
        vec3 sum = 2.0 * x * next - after + {name}_{suffix}[k * {count} + j];
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
        None => ("float u, float v, float t", String::new()),
        Some(t) => ("float u, float v", format!("    float t = {};\n", single(t))),
    };
    let _ = write!(
        text,
        "
// Position and derivatives in u and v.
void {name}_surface({signature}, out vec3 s, out vec3 s_u, out vec3 s_v) {{
{instant}    float f[{count}], f_v[{count}];
    {name}_basis(v, t, f, f_v);
    s = s_u = s_v = vec3(0.0);
    for (int j = 0; j < {count}; j++) {{
        vec3 g = {name}_g_series(j, u);
        s += g * f[j];
        s_u += {name}_g_u_series(j, u) * f[j];
        s_v += g * f_v[j];
    }}
}}
"
    );
    text
}
