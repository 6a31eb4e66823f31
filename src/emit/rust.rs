//! Rust: one public function and its tables.

use std::fmt::Write;

use super::statements::{Spelling, Statements, comment, double, list, net_rows, parameter, rows, statements};
use super::{Form, Formula, Placement, Row, Sum};
use crate::expr::Function;
use crate::surface::BsplineSurface;

pub(super) const ROW: Row = Row { name: "rust", description: "Rust", is_single_precision: false, write };

// Calls as `f64::sin(x)`: an operand may be a number, which has no methods of its own.
fn function(function: Function) -> &'static str {
    match function {
        Function::Sin => "f64::sin(#0)",
        Function::Cos => "f64::cos(#0)",
        Function::Tan => "f64::tan(#0)",
        Function::Cot => "1.0 / f64::tan(#0)",
        Function::Sec => "1.0 / f64::cos(#0)",
        Function::Csc => "1.0 / f64::sin(#0)",
        Function::Asin => "f64::asin(#0)",
        Function::Acos => "f64::acos(#0)",
        Function::Atan => "f64::atan(#0)",
        Function::Atan2 => "f64::atan2(#0, #1)",
        Function::Sinh => "f64::sinh(#0)",
        Function::Cosh => "f64::cosh(#0)",
        Function::Tanh => "f64::tanh(#0)",
        Function::Asinh => "f64::asinh(#0)",
        Function::Acosh => "f64::acosh(#0)",
        Function::Atanh => "f64::atanh(#0)",
        Function::Exp => "f64::exp(#0)",
        Function::Ln => "f64::ln(#0)",
        Function::Log10 => "f64::log10(#0)",
        Function::Cbrt => "f64::cbrt(#0)",
        Function::Abs => "f64::abs(#0)",
        Function::Sign => "if #0 == 0.0 { #0 } else { f64::signum(#0) }",
        Function::Floor => "f64::floor(#0)",
        Function::Min => "f64::min(#0, #1)",
        Function::Max => "f64::max(#0, #1)",
        Function::Pow => "f64::powf(#0, #1)",
    }
}

const SPELLING: Spelling =
    Spelling { number: double, declaration: ["let ", ": f64"], end: ";", sqrt: "f64::sqrt(#0)", function };

// Names are those of the spec, in any case.
const ANY_CASE: &str = "#[allow(non_upper_case_globals)]";

const AS_WRITTEN: &str = "#[allow(non_snake_case, unused_parens, unused_variables, clippy::all)]";

// Writing to a string does not fail, here and below.
fn write(formula: &Formula) -> String {
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "{ANY_CASE}\nconst {}: f64 = {value:?};", parameter(formula, index));
    }
    match &formula.form {
        Form::Sum(sum) => write_sum(&mut text, formula, sum),
        Form::Net(surface, _) => write_net(&mut text, formula, surface),
    }
    if let Some(placement) = &formula.placement {
        write_placement(&mut text, formula, placement);
    }
    text
}

/// The beginning of the function that evaluates the form: what it says of itself, its arguments, and the instant.
fn opening(formula: &Formula) -> String {
    let (what, visibility) = match formula.placement {
        None => ("Position and derivatives in u and v.\n#[must_use]", "pub "),
        Some(_) => ("Of what is copied: position and derivatives in u and v.", ""),
    };
    format!("\n/// {what}\n{AS_WRITTEN}\n{visibility}{}", signature(formula, &formula.base()))
}

fn signature(formula: &Formula, function: &str) -> String {
    let (arguments, instant) = match formula.instant {
        None => ("u: f64, v: f64, t: f64", String::new()),
        Some(t) => ("u: f64, v: f64", format!("    let t = {t:?};\n")),
    };
    format!("fn {function}({arguments}) -> [[f64; 3]; 3] {{\n{instant}")
}

fn write_sum(text: &mut String, formula: &Formula, sum: &Sum) {
    let (name, count) = (&formula.name, sum.count());
    let basis = statements(formula, &sum.program, name, &SPELLING);
    write_splines(text, name, &basis);
    let vector = |x: &str, y: &str, z: &str| format!("[{x}, {y}, {z}]");
    for (series, suffix, what) in sum.tables() {
        let _ = writeln!(text, "\n/// {what}: by degree, function and component.");
        let terms = series.coefficients.len();
        let _ = writeln!(text, "{ANY_CASE}\nstatic {name}_{suffix}: [[[f64; 3]; {count}]; {terms}] = [");
        for row in rows(&series.coefficients, vector, |value| format!("{value:?}")) {
            let _ = writeln!(text, "    [{row}],");
        }
        let _ = writeln!(text, "];");
    }
    let _ = writeln!(text, "\n/// The basis functions and their derivatives in v.");
    let _ = writeln!(text, "{AS_WRITTEN}\nfn {name}_basis(v: f64, t: f64) -> [[f64; {count}]; 2] {{");
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let (values, slopes) = basis.outputs.split_at_checked(count).unwrap_or_default();
    let _ = writeln!(text, "    [[{}], [{}]]\n}}", values.join(", "), slopes.join(", "));
    let [low, high] = formula.domain.u.map(double);
    let _ = write!(
        text,
        "
/// The sum of terms c[k] T_k(x), with x from -1 to 1 over the range of u.
#[allow(non_snake_case)]
fn {name}_series(c: &[[[f64; 3]; {count}]], u: f64) -> [[f64; 3]; {count}] {{
    let x = (2.0 * u - {low} - {high}) / ({high} - {low});
    let (mut next, mut after) = ([[0.0; 3]; {count}], [[0.0; 3]; {count}]);
    for row in c.iter().skip(1).rev() {{
        for j in 0..{count} {{
            for i in 0..3 {{
                let sum = 2.0 * x * next[j][i] - after[j][i] + row[j][i];
                after[j][i] = next[j][i];
                next[j][i] = sum;
            }}
        }}
    }}
    std::array::from_fn(|j| std::array::from_fn(|i| x * next[j][i] - after[j][i] + c[0][j][i]))
}}
{opening}    let [f, f_v] = {name}_basis(v, t);
    let g = {name}_series(&{name}_g, u);
    let g_u = {name}_series(&{name}_g_u, u);
    let sum = |g: &[[f64; 3]; {count}], f: &[f64; {count}]| {{
        let mut total = [0.0; 3];
        for (g, f) in g.iter().zip(f) {{
            for i in 0..3 {{
                total[i] += g[i] * f;
            }}
        }}
        total
    }};
    [sum(&g, &f), sum(&g_u, &f), sum(&g, &f_v)]
}}
",
        opening = opening(formula),
    );
}

fn write_net(text: &mut String, formula: &Formula, surface: &BsplineSurface) {
    let name = &formula.name;
    let [u, v] = surface.knots();
    let number = |value: f64| format!("{value:?}");
    for (suffix, knots) in [("u", u), ("v", v)] {
        let knots = knots.as_slice();
        let numbers = list(knots, number);
        let _ = writeln!(text, "\n{ANY_CASE}\nstatic {name}_knots_{suffix}: [f64; {}] = [{numbers}];", knots.len());
    }
    let (rows, columns) = (u.points(), v.points());
    let _ = writeln!(text, "\n/// Control points: those of one i in a line.");
    let _ = writeln!(text, "{ANY_CASE}\nstatic {name}_net: [[[f64; 3]; {columns}]; {rows}] = [");
    for row in net_rows(surface, |x, y, z| format!("[{x}, {y}, {z}]"), number) {
        let _ = writeln!(text, "    [{row}],");
    }
    let _ = write!(
        text,
        "];

/// The first B-spline that is not zero at x; it and the following ones, with their derivatives, by de Boor's recurrence.
#[allow(non_snake_case)]
fn {name}_bsplines<const COUNT: usize>(knots: &[f64], x: f64) -> (usize, [f64; COUNT], [f64; COUNT]) {{
    let mut k = COUNT - 1;
    while k + 1 + COUNT < knots.len() && x >= knots[k + 1] {{
        k += 1;
    }}
    let (mut n, mut n_x) = ([0.0; COUNT], [0.0; COUNT]);
    n[0] = 1.0;
    for j in 1..COUNT {{
        let (mut saved, mut before) = (0.0, 0.0);
        for r in 0..j {{
            let (low, high) = (knots[k + 1 + r - j], knots[k + 1 + r]);
            let share = n[r] / (high - low);
            n_x[r] = j as f64 * (before - share);
            n[r] = saved + (high - x) * share;
            saved = (x - low) * share;
            before = share;
        }}
        n[j] = saved;
        n_x[j] = j as f64 * before;
    }}
    (k + 1 - COUNT, n, n_x)
}}
{opening}    let (i, n, n_u) = {name}_bsplines::<{of_u}>(&{name}_knots_u, u);
    let (j, m, m_v) = {name}_bsplines::<{of_v}>(&{name}_knots_v, v);
    let sum = |n: &[f64; {of_u}], m: &[f64; {of_v}]| {{
        let mut total = [0.0; 3];
        for (row, n) in {name}_net[i..].iter().zip(n) {{
            for (point, m) in row[j..].iter().zip(m) {{
                for x in 0..3 {{
                    total[x] += n * m * point[x];
                }}
            }}
        }}
        total
    }};
    [sum(&n, &m), sum(&n_u, &m), sum(&n, &m_v)]
}}
",
        opening = opening(formula),
        of_u = u.degree() + 1,
        of_v = v.degree() + 1,
    );
}

fn write_placement(text: &mut String, formula: &Formula, placement: &Placement) {
    let name = &formula.name;
    let prefix = format!("{name}_placement");
    let entries = statements(formula, &placement.program, &prefix, &SPELLING);
    write_splines(text, &prefix, &entries);
    let _ = writeln!(text, "\n/// The rows of the matrix that turns, then the vector that moves.");
    let _ = writeln!(text, "{AS_WRITTEN}\nfn {prefix}(t: f64) -> [f64; 12] {{");
    entries.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let _ = write!(
        text,
        "    [{outputs}]
}}

/// Position and derivatives in u and v.
#[must_use]
{AS_WRITTEN}
pub {signature}    let a = {prefix}(t);
    let [s, s_u, s_v] = {base}(u, v{instant});
    let turned = |x: [f64; 3]| [0, 1, 2].map(|i| a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2]);
    let [x, y, z] = turned(s);
    [[x + a[9], y + a[10], z + a[11]], turned(s_u), turned(s_v)]
}}
",
        outputs = entries.outputs.join(", "),
        signature = signature(formula, &format!("{name}_surface")),
        base = formula.base(),
        instant = if formula.instant.is_none() { ", t" } else { "" },
    );
}

/// The functions of data that `code` calls.
fn write_splines(text: &mut String, prefix: &str, code: &Statements) {
    if code.splines.is_empty() {
        return;
    }
    let _ = write!(
        text,
        "
/// The piece of x, and how far x is into it.
#[allow(non_snake_case)]
fn {prefix}_piece(breaks: &[f64], repeats: bool, mut x: f64) -> (usize, f64) {{
    let pieces = breaks.len() - 1;
    if repeats {{
        x -= f64::floor((x - breaks[0]) / (breaks[pieces] - breaks[0])) * (breaks[pieces] - breaks[0]);
    }}
    let mut piece = 0;
    while piece + 1 < pieces && x >= breaks[piece + 1] {{
        piece += 1;
    }}
    (piece, x - breaks[piece])
}}
"
    );
    let number = |value: f64| format!("{value:?}");
    for (function, table) in &code.splines {
        let _ = writeln!(text, "\n/// Data: polynomials on pieces.");
        let data = list(&table.coefficients, number);
        let _ = writeln!(text, "{ANY_CASE}\nstatic {function}_data: [f64; {}] = [{data}];", table.coefficients.len());
        let names: Vec<String> = (0..table.arguments.len()).map(|k| format!("x_{k}: f64")).collect();
        let _ = writeln!(text, "\n#[allow(non_snake_case)]\nfn {function}({}) -> f64 {{", names.join(", "));
        for (k, argument) in table.arguments.iter().enumerate() {
            let (breaks, repeats) = (list(&argument.breaks, number), argument.is_periodic);
            let _ = writeln!(text, "    let (i_{k}, x_{k}) = {prefix}_piece(&[{breaks}], {repeats}, x_{k});");
        }
        let powers: Vec<usize> = table.arguments.iter().map(|argument| argument.powers).collect();
        let sum = match powers.as_slice() {
            [p, q] => {
                let width = table.arguments.last().map_or(1, |argument| argument.pieces() * q);
                format!(
                    "let inner = |k: usize| (0..{q}).rev().fold(0.0, |sum, l| sum * x_1 + {function}_data[(i_0 * {p} + k) * {width} + i_1 * {q} + l]);
    (0..{p}).rev().fold(0.0, |sum, k| sum * x_0 + inner(k))"
                )
            }
            _ => {
                let p = powers.first().copied().unwrap_or(1);
                format!("(0..{p}).rev().fold(0.0, |sum, k| sum * x_0 + {function}_data[i_0 * {p} + k])")
            }
        };
        let _ = writeln!(text, "    {sum}\n}}");
    }
}
