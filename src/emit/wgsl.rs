//! WGSL, the shading language of WebGPU: one function and its tables, in single precision.

use std::fmt::Write;

use super::statements::{Spelling, Statements, comment, list, net_rows, parameter, rows, single, statements};
use super::{Form, Formula, Placement, Row, Sum};
use crate::expr::Function;
use crate::surface::BsplineSurface;

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

const SPELLING: Spelling =
    Spelling { number: single, declaration: ["let ", ": f32"], end: ";", sqrt: "sqrt(#0)", function };

// Writing to a string does not fail, here and below.
fn write(formula: &Formula) -> String {
    let name = &formula.name;
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    // Variables, not constants: compilers refuse shaders whose constant expressions overflow on the way.
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "var<private> {}: f32 = {};", parameter(formula, index), single(value));
    }
    let _ = write!(
        text,
        "
struct {name}_Point {{
    s: vec3<f32>,
    s_u: vec3<f32>,
    s_v: vec3<f32>,
}}
"
    );
    let mut body = String::new();
    match &formula.form {
        Form::Sum(sum) => write_sum(&mut body, formula, sum),
        Form::Net(surface, _) => write_net(&mut body, formula, surface),
    }
    if let Some(placement) = &formula.placement {
        write_placement(&mut body, formula, placement);
    }
    if body.contains(&format!("{name}_power(")) {
        write_power(&mut text, name);
    }
    text + &body
}

fn write_power(text: &mut String, name: &str) {
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

/// A table that indices which vary can read.
fn table(name: &str, element: &str, count: usize, entries: &str) -> String {
    let kind = format!("array<{element}, {count}>");
    format!("var<private> {name}: {kind} = {kind}({entries});\n")
}

/// The beginning of the function that evaluates the form: what it says of itself, its arguments, and the instant.
fn opening(formula: &Formula) -> String {
    let what = if formula.placement.is_some() { "Of what is copied: position" } else { "Position" };
    format!("\n// {what} and derivatives in u and v.\n{}", signature(formula, &formula.base()))
}

fn signature(formula: &Formula, function: &str) -> String {
    let (arguments, instant) = match formula.instant {
        None => ("u: f32, v: f32, t: f32", String::new()),
        Some(t) => ("u: f32, v: f32", format!("    let t: f32 = {};\n", single(t))),
    };
    format!("fn {function}({arguments}) -> {}_Point {{\n{instant}", formula.name)
}

fn write_sum(text: &mut String, formula: &Formula, sum: &Sum) {
    let (name, count) = (&formula.name, sum.count());
    let basis = statements(formula, &sum.program, name, &SPELLING);
    write_splines(text, &basis);
    let vector = |x: &str, y: &str, z: &str| format!("vec3<f32>({x}, {y}, {z})");
    for (series, suffix, what) in sum.tables() {
        let _ = writeln!(text, "\n// {what}: by degree and function.");
        let rows = rows(&series.coefficients, vector, |value| format!("{:?}", value as f32));
        let entries = format!("\n    {}\n", rows.join(",\n    "));
        let size = series.coefficients.len() * count;
        text.push_str(&table(&format!("{name}_{suffix}"), "vec3<f32>", size, &entries));
    }
    let _ = write!(
        text,
        "
struct {name}_Basis {{
    f: array<f32, {count}>,
    f_v: array<f32, {count}>,
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
    for (series, suffix, _) in sum.tables() {
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
    let _ = write!(
        text,
        "{opening}    var basis = {name}_basis(v, t);
    var point = {name}_Point(vec3<f32>(0.0), vec3<f32>(0.0), vec3<f32>(0.0));
    for (var j: i32 = 0; j < {count}; j++) {{
        let g = {name}_g_series(j, u);
        point.s += g * basis.f[j];
        point.s_u += {name}_g_u_series(j, u) * basis.f[j];
        point.s_v += g * basis.f_v[j];
    }}
    return point;
}}
",
        opening = opening(formula),
    );
}

fn write_net(text: &mut String, formula: &Formula, surface: &BsplineSurface) {
    let name = &formula.name;
    let knots = surface.knots();
    let columns = knots[1].points();
    let rows = net_rows(surface, |x, y, z| format!("vec3<f32>({x}, {y}, {z})"), |value| format!("{:?}", value as f32));
    let _ = writeln!(text, "\n// Control points: those of one i in a line.");
    let entries = format!("\n    {}\n", rows.join(",\n    "));
    text.push_str(&table(&format!("{name}_net"), "vec3<f32>", surface.net().len(), &entries));
    for (suffix, knots) in ["u", "v"].into_iter().zip(knots) {
        let (degree, all, points) = (knots.degree(), knots.degree() + 1, knots.points());
        let numbers = list(knots.as_slice(), single);
        text.push('\n');
        text.push_str(&table(&format!("{name}_knots_{suffix}"), "f32", knots.as_slice().len(), &numbers));
        let _ = write!(
            text,
            "
struct {name}_Splines_{suffix} {{
    first: i32,
    n: array<f32, {all}>,
    n_x: array<f32, {all}>,
}}

// The first B-spline that is not zero at x; it and the following ones, with their derivatives, by de Boor's recurrence.
fn {name}_bsplines_{suffix}(x: f32) -> {name}_Splines_{suffix} {{
    var k: i32 = {degree};
    while (k + 1 < {points} && x >= {name}_knots_{suffix}[k + 1]) {{ k++; }}
    var n: array<f32, {all}>;
    var n_x: array<f32, {all}>;
    n[0] = 1.0;
    for (var j: i32 = 1; j <= {degree}; j++) {{
        var saved: f32 = 0.0;
        var before: f32 = 0.0;
        for (var r: i32 = 0; r < j; r++) {{
            let low = {name}_knots_{suffix}[k + 1 - j + r];
            let high = {name}_knots_{suffix}[k + 1 + r];
            let share = n[r] / (high - low);
            n_x[r] = f32(j) * (before - share);
            n[r] = saved + (high - x) * share;
            saved = (x - low) * share;
            before = share;
        }}
        n[j] = saved;
        n_x[j] = f32(j) * before;
    }}
    return {name}_Splines_{suffix}(k - {degree}, n, n_x);
}}
"
        );
    }
    let [of_u, of_v] = knots.map(|knots| knots.degree() + 1);
    let _ = write!(
        text,
        "{opening}    var across = {name}_bsplines_u(u);
    var along = {name}_bsplines_v(v);
    var point = {name}_Point(vec3<f32>(0.0), vec3<f32>(0.0), vec3<f32>(0.0));
    for (var a: i32 = 0; a < {of_u}; a++) {{
        for (var b: i32 = 0; b < {of_v}; b++) {{
            let p = {name}_net[(across.first + a) * {columns} + along.first + b];
            point.s += across.n[a] * along.n[b] * p;
            point.s_u += across.n_x[a] * along.n[b] * p;
            point.s_v += across.n[a] * along.n_x[b] * p;
        }}
    }}
    return point;
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
    let _ = write!(
        text,
        "
struct {name}_Placement {{
    turn: mat3x3<f32>,
    offset: vec3<f32>,
}}

fn {prefix}(t: f32) -> {name}_Placement {{
"
    );
    entries.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let of = |indices: &[usize]| {
        let values = indices.iter().filter_map(|k| entries.outputs.get(*k)).map(String::as_str);
        values.collect::<Vec<_>>().join(", ")
    };
    let _ = write!(
        text,
        "    return {name}_Placement(mat3x3<f32>({columns}), vec3<f32>({offset}));
}}

// Position and derivatives in u and v.
{signature}    let placement = {prefix}(t);
    let p = {base}(u, v{instant});
    return {name}_Point(placement.turn * p.s + placement.offset, placement.turn * p.s_u, placement.turn * p.s_v);
}}
",
        columns = of(&[0, 3, 6, 1, 4, 7, 2, 5, 8]),
        offset = of(&[9, 10, 11]),
        signature = signature(formula, &format!("{name}_surface")),
        base = formula.base(),
        instant = if formula.instant.is_none() { ", t" } else { "" },
    );
}

/// The functions of data that `code` calls.
fn write_splines(text: &mut String, code: &Statements) {
    for (function, data) in &code.splines {
        let _ = writeln!(text, "\n// Data: polynomials on pieces.");
        let numbers = list(&data.coefficients, |value| format!("{:?}", value as f32));
        text.push_str(&table(&format!("{function}_data"), "f32", data.coefficients.len(), &numbers));
        for (k, argument) in data.arguments.iter().enumerate() {
            let breaks = list(&argument.breaks, single);
            text.push_str(&table(&format!("{function}_breaks_{k}"), "f32", argument.breaks.len(), &breaks));
        }
        let names: Vec<String> = (0..data.arguments.len()).map(|k| format!("at_{k}: f32")).collect();
        let _ = writeln!(text, "\nfn {function}({}) -> f32 {{", names.join(", "));
        for (k, argument) in data.arguments.iter().enumerate() {
            let pieces = argument.pieces();
            let _ = writeln!(text, "    var x_{k} = at_{k};");
            if argument.is_periodic {
                let [low, high] = [0, pieces].map(|at| single(argument.breaks.get(at).copied().unwrap_or(f64::NAN)));
                let _ = writeln!(text, "    x_{k} -= floor((x_{k} - {low}) / ({high} - {low})) * ({high} - {low});");
            }
            let _ = writeln!(
                text,
                "    var i_{k}: i32 = 0;
    while (i_{k} + 1 < {pieces} && x_{k} >= {function}_breaks_{k}[i_{k} + 1]) {{ i_{k}++; }}
    x_{k} -= {function}_breaks_{k}[i_{k}];"
            );
        }
        let powers: Vec<usize> = data.arguments.iter().map(|argument| argument.powers).collect();
        let _ = match powers.as_slice() {
            [p, q] => {
                let width = data.arguments.last().map_or(1, |argument| argument.pieces() * q);
                write!(
                    text,
                    "    var sum: f32 = 0.0;
    for (var k: i32 = {p} - 1; k >= 0; k--) {{
        var inner: f32 = 0.0;
        for (var l: i32 = {q} - 1; l >= 0; l--) {{
            inner = inner * x_1 + {function}_data[(i_0 * {p} + k) * {width} + i_1 * {q} + l];
        }}
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
                    "    var sum: f32 = 0.0;
    for (var k: i32 = {p} - 1; k >= 0; k--) {{ sum = sum * x_0 + {function}_data[i_0 * {p} + k]; }}
    return sum;
}}
"
                )
            }
        };
    }
}
