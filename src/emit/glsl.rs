//! GLSL, the shading language of WebGL 2 and OpenGL: one function and its tables, in single precision.

use std::fmt::Write;

use super::statements::{Spelling, Statements, comment, list, net_rows, parameter, rows, single, statements};
use super::{Form, Formula, Placement, Row, Sum};
use crate::expr::Function;
use crate::surface::BsplineSurface;

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

const SPELLING: Spelling =
    Spelling { number: single, declaration: ["float ", ""], end: ";", sqrt: "sqrt(#0)", function };

// Writing to a string does not fail, here and below.
fn write(formula: &Formula) -> String {
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "const float {} = {:?};", parameter(formula, index), value as f32);
    }
    let mut body = String::new();
    match &formula.form {
        Form::Sum(sum) => write_sum(&mut body, formula, sum),
        Form::Net(surface, _) => write_net(&mut body, formula, surface),
    }
    if let Some(placement) = &formula.placement {
        write_placement(&mut body, formula, placement);
    }
    if body.contains(&format!("{}_power(", formula.name)) {
        write_power(&mut text, &formula.name);
    }
    text + &body
}

fn write_power(text: &mut String, name: &str) {
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

/// The beginning of the function that evaluates the form: what it says of itself, its arguments, and the instant.
fn opening(formula: &Formula) -> String {
    let what = if formula.placement.is_some() { "Of what is copied: position" } else { "Position" };
    format!("\n// {what} and derivatives in u and v.\n{}", signature(formula, &formula.base()))
}

fn signature(formula: &Formula, function: &str) -> String {
    let (arguments, instant) = match formula.instant {
        None => ("float u, float v, float t", String::new()),
        Some(t) => ("float u, float v", format!("    float t = {};\n", single(t))),
    };
    format!("void {function}({arguments}, out vec3 s, out vec3 s_u, out vec3 s_v) {{\n{instant}")
}

fn write_sum(text: &mut String, formula: &Formula, sum: &Sum) {
    let (name, count) = (&formula.name, sum.count());
    let basis = statements(formula, &sum.program, name, &SPELLING);
    write_splines(text, &basis);
    let vector = |x: &str, y: &str, z: &str| format!("vec3({x}, {y}, {z})");
    for (series, suffix, what) in sum.tables() {
        let _ = writeln!(text, "\n// {what}: by degree and function.");
        let size = series.coefficients.len() * count;
        let _ = writeln!(text, "const vec3 {name}_{suffix}[{size}] = vec3[{size}](");
        let rows = rows(&series.coefficients, vector, |value| format!("{:?}", value as f32));
        let _ = writeln!(text, "    {}\n);", rows.join(",\n    "));
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
    for (series, suffix, _) in sum.tables() {
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
    let _ = write!(
        text,
        "{opening}    float f[{count}], f_v[{count}];
    {name}_basis(v, t, f, f_v);
    s = s_u = s_v = vec3(0.0);
    for (int j = 0; j < {count}; j++) {{
        vec3 g = {name}_g_series(j, u);
        s += g * f[j];
        s_u += {name}_g_u_series(j, u) * f[j];
        s_v += g * f_v[j];
    }}
}}
",
        opening = opening(formula),
    );
}

fn write_net(text: &mut String, formula: &Formula, surface: &BsplineSurface) {
    let name = &formula.name;
    let knots = surface.knots();
    let columns = knots[1].points();
    let size = surface.net().len();
    let rows = net_rows(surface, |x, y, z| format!("vec3({x}, {y}, {z})"), |value| format!("{:?}", value as f32));
    let _ = writeln!(text, "\n// Control points: those of one i in a line.");
    let _ = writeln!(text, "const vec3 {name}_net[{size}] = vec3[{size}](\n    {}\n);", rows.join(",\n    "));
    for (suffix, knots) in ["u", "v"].into_iter().zip(knots) {
        let (degree, count, numbers) = (knots.degree(), knots.as_slice().len(), list(knots.as_slice(), single));
        let _ = write!(
            text,
            "
const float {name}_knots_{suffix}[{count}] = float[{count}]({numbers});

// The first B-spline that is not zero at x; it and the following ones, with their derivatives, by de Boor's recurrence.
int {name}_bsplines_{suffix}(float x, out float n[{all}], out float n_x[{all}]) {{
    int k = {degree};
    while (k + 1 < {points} && x >= {name}_knots_{suffix}[k + 1]) {{ k++; }}
    n[0] = 1.0;
    for (int j = 1; j <= {degree}; j++) {{
        float saved = 0.0, before = 0.0;
        for (int r = 0; r < j; r++) {{
            float low = {name}_knots_{suffix}[k + 1 - j + r], high = {name}_knots_{suffix}[k + 1 + r];
            float share = n[r] / (high - low);
            n_x[r] = float(j) * (before - share);
            n[r] = saved + (high - x) * share;
            saved = (x - low) * share;
            before = share;
        }}
        n[j] = saved;
        n_x[j] = float(j) * before;
    }}
    return k - {degree};
}}
",
            all = degree + 1,
            points = knots.points(),
        );
    }
    let [of_u, of_v] = knots.map(|knots| knots.degree() + 1);
    let _ = write!(
        text,
        "{opening}    float n[{of_u}], n_u[{of_u}], m[{of_v}], m_v[{of_v}];
    int i = {name}_bsplines_u(u, n, n_u);
    int j = {name}_bsplines_v(v, m, m_v);
    s = s_u = s_v = vec3(0.0);
    for (int a = 0; a < {of_u}; a++) {{
        for (int b = 0; b < {of_v}; b++) {{
            vec3 p = {name}_net[(i + a) * {columns} + j + b];
            s += n[a] * m[b] * p;
            s_u += n_u[a] * m[b] * p;
            s_v += n[a] * m_v[b] * p;
        }}
    }}
}}
",
        opening = opening(formula),
    );
}

fn write_placement(text: &mut String, formula: &Formula, placement: &Placement) {
    let name = &formula.name;
    let prefix = format!("{name}_placement");
    let entries = statements(formula, &placement.program, &prefix, &SPELLING);
    write_splines(text, &entries);
    let _ = writeln!(text, "\n// The matrix that turns, and the vector that moves.");
    let _ = writeln!(text, "void {prefix}(float t, out mat3 turn, out vec3 move) {{");
    entries.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let of = |indices: &[usize]| {
        let values = indices.iter().filter_map(|k| entries.outputs.get(*k)).map(String::as_str);
        values.collect::<Vec<_>>().join(", ")
    };
    let _ = write!(
        text,
        "    turn = mat3({columns});
    move = vec3({offset});
}}

// Position and derivatives in u and v.
{signature}    mat3 turn;
    vec3 move;
    {prefix}(t, turn, move);
    {base}(u, v, {instant}s, s_u, s_v);
    s = turn * s + move;
    s_u = turn * s_u;
    s_v = turn * s_v;
}}
",
        columns = of(&[0, 3, 6, 1, 4, 7, 2, 5, 8]),
        offset = of(&[9, 10, 11]),
        signature = signature(formula, &format!("{name}_surface")),
        base = formula.base(),
        instant = if formula.instant.is_none() { "t, " } else { "" },
    );
}

/// The functions of data that `code` calls.
fn write_splines(text: &mut String, code: &Statements) {
    for (function, table) in &code.splines {
        let _ = writeln!(text, "\n// Data: polynomials on pieces.");
        let count = table.coefficients.len();
        let data = list(&table.coefficients, |value| format!("{:?}", value as f32));
        let _ = writeln!(text, "const float {function}_data[{count}] = float[{count}]({data});");
        for (k, argument) in table.arguments.iter().enumerate() {
            let count = argument.breaks.len();
            let breaks = list(&argument.breaks, single);
            let _ = writeln!(text, "const float {function}_breaks_{k}[{count}] = float[{count}]({breaks});");
        }
        let names: Vec<String> = (0..table.arguments.len()).map(|k| format!("float x_{k}")).collect();
        let _ = writeln!(text, "\nfloat {function}({}) {{", names.join(", "));
        for (k, argument) in table.arguments.iter().enumerate() {
            let pieces = argument.pieces();
            if argument.is_periodic {
                let [low, high] = [0, pieces].map(|at| single(argument.breaks.get(at).copied().unwrap_or(f64::NAN)));
                let _ = writeln!(text, "    x_{k} -= floor((x_{k} - {low}) / ({high} - {low})) * ({high} - {low});");
            }
            let _ = writeln!(
                text,
                "    int i_{k} = 0;
    while (i_{k} + 1 < {pieces} && x_{k} >= {function}_breaks_{k}[i_{k} + 1]) {{ i_{k}++; }}
    x_{k} -= {function}_breaks_{k}[i_{k}];"
            );
        }
        let powers: Vec<usize> = table.arguments.iter().map(|argument| argument.powers).collect();
        let _ = match powers.as_slice() {
            [p, q] => {
                let width = table.arguments.last().map_or(1, |argument| argument.pieces() * q);
                write!(
                    text,
                    "    float sum = 0.0;
    for (int k = {p} - 1; k >= 0; k--) {{
        float inner = 0.0;
        for (int l = {q} - 1; l >= 0; l--) {{ inner = inner * x_1 + {function}_data[(i_0 * {p} + k) * {width} + i_1 * {q} + l]; }}
        sum = sum * x_0 + inner;
    }}
    return sum;
}}
"
                )
            }
            _ => {
                let p = powers.first().copied().unwrap_or(1);
                write!(
                    text,
                    "    float sum = 0.0;
    for (int k = {p} - 1; k >= 0; k--) {{ sum = sum * x_0 + {function}_data[i_0 * {p} + k]; }}
    return sum;
}}
"
                )
            }
        };
    }
}
