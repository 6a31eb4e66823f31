//! C99: one function and its tables, all but the function private to the file.

use std::fmt::Write;

use super::statements::{Spelling, Statements, comment, double, list, net_rows, parameter, rows, statements};
use super::{Form, Formula, Placement, Row, Sum};
use crate::expr::Function;
use crate::surface::BsplineSurface;

pub(super) const ROW: Row = Row { name: "c", description: "C99", is_single_precision: false, write };

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
        Function::Log10 => "log10(#0)",
        Function::Cbrt => "cbrt(#0)",
        Function::Abs => "fabs(#0)",
        Function::Sign => "#0 > 0.0 ? 1.0 : #0 < 0.0 ? -1.0 : #0",
        Function::Floor => "floor(#0)",
        Function::Min => "#0 < #1 ? #0 : #1",
        Function::Max => "#0 > #1 ? #0 : #1",
        Function::Pow => "pow(#0, #1)",
    }
}

const SPELLING: Spelling =
    Spelling { number: double, declaration: ["const double ", ""], end: ";", sqrt: "sqrt(#0)", function };

// Writing to a string does not fail, here and below.
fn write(formula: &Formula) -> String {
    let mut text = comment(&formula.header(), "//");
    let _ = writeln!(text, "\n#include <math.h>\n");
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "static const double {} = {value:?};", parameter(formula, index));
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
    let (visibility, what) = match formula.placement {
        None => ("", "Position and derivatives in u and v."),
        Some(_) => ("static ", "Of what is copied: position and derivatives in u and v."),
    };
    format!("\n// {what}\n{visibility}{}", signature(formula, &formula.base()))
}

fn signature(formula: &Formula, function: &str) -> String {
    let (arguments, instant) = match formula.instant {
        None => ("double u, double v, double t", "    (void)t;\n".to_owned()),
        Some(t) => ("double u, double v", format!("    const double t = {t:?};\n    (void)t;\n")),
    };
    format!("void {function}({arguments}, double s[3], double s_u[3], double s_v[3])\n{{\n{instant}")
}

fn write_sum(text: &mut String, formula: &Formula, sum: &Sum) {
    let (name, count) = (&formula.name, sum.count());
    let basis = statements(formula, &sum.program, name, &SPELLING);
    write_splines(text, name, &basis);
    let vector = |x: &str, y: &str, z: &str| format!("{{{x}, {y}, {z}}}");
    for (series, suffix, what) in sum.tables() {
        let _ = writeln!(text, "\n// {what}: by degree, function and component.");
        let _ = writeln!(text, "static const double {name}_{suffix}[{}][{count}][3] = {{", series.coefficients.len());
        for row in rows(&series.coefficients, vector, double) {
            let _ = writeln!(text, "    {{{row}}},");
        }
        let _ = writeln!(text, "}};");
    }
    let _ =
        writeln!(text, "\nstatic void {name}_basis(double v, double t, double f[{count}], double f_v[{count}])\n{{");
    let _ = writeln!(text, "    (void)v;\n    (void)t;");
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    for (j, value) in basis.outputs.iter().enumerate() {
        let (array, j) = if j < count { ("f", j) } else { ("f_v", j - count) };
        let _ = writeln!(text, "    {array}[{j}] = {value};");
    }
    let [low, high] = formula.domain.u;
    let _ = write!(
        text,
        "}}

// The sum of terms c[k] T_k(x), with x from -1 to 1 over the range of u.
static void {name}_series(const double c[][{count}][3], int terms, double u, double g[{count}][3])
{{
    const double x = (2.0 * u - {low} - {high}) / ({high} - {low});
    for (int j = 0; j < {count}; j++) {{
        for (int i = 0; i < 3; i++) {{
            double next = 0.0, after = 0.0;
            for (int k = terms - 1; k > 0; k--) {{
                const double sum = 2.0 * x * next - after + c[k][j][i];
                after = next;
                next = sum;
            }}
            g[j][i] = x * next - after + c[0][j][i];
        }}
    }}
}}
{opening}    double f[{count}], f_v[{count}], g[{count}][3], g_u[{count}][3];
    {name}_basis(v, t, f, f_v);
    {name}_series({name}_g, {terms}, u, g);
    {name}_series({name}_g_u, {slope_terms}, u, g_u);
    for (int i = 0; i < 3; i++) {{
        s[i] = s_u[i] = s_v[i] = 0.0;
        for (int j = 0; j < {count}; j++) {{
            s[i] += g[j][i] * f[j];
            s_u[i] += g_u[j][i] * f[j];
            s_v[i] += g[j][i] * f_v[j];
        }}
    }}
}}
",
        low = double(low),
        high = double(high),
        opening = opening(formula),
        terms = sum.amplitudes[0].coefficients.len(),
        slope_terms = sum.amplitudes[1].coefficients.len(),
    );
}

fn write_net(text: &mut String, formula: &Formula, surface: &BsplineSurface) {
    let name = &formula.name;
    let [u, v] = surface.knots();
    for (suffix, knots) in [("u", u), ("v", v)] {
        let knots = knots.as_slice();
        let _ = writeln!(
            text,
            "\nstatic const double {name}_knots_{suffix}[{}] = {{{}}};",
            knots.len(),
            list(knots, double)
        );
    }
    let (rows, columns) = (u.points(), v.points());
    let _ = writeln!(text, "\n// Control points: those of one i in a line.");
    let _ = writeln!(text, "static const double {name}_net[{rows}][{columns}][3] = {{");
    for row in net_rows(surface, |x, y, z| format!("{{{x}, {y}, {z}}}"), double) {
        let _ = writeln!(text, "    {{{row}}},");
    }
    let _ = write!(
        text,
        "}};

// The first B-spline that is not zero at x; it and the following ones, with their derivatives, by de Boor's recurrence.
static int {name}_bsplines(const double *knots, int points, int degree, double x, double *n, double *n_x)
{{
    int k = degree;
    while (k + 1 < points && x >= knots[k + 1]) k++;
    n[0] = 1.0;
    for (int j = 1; j <= degree; j++) {{
        double saved = 0.0, before = 0.0;
        for (int r = 0; r < j; r++) {{
            const double low = knots[k + 1 - j + r], high = knots[k + 1 + r];
            const double share = n[r] / (high - low);
            n_x[r] = j * (before - share);
            n[r] = saved + (high - x) * share;
            saved = (x - low) * share;
            before = share;
        }}
        n[j] = saved;
        n_x[j] = j * before;
    }}
    return k - degree;
}}
{opening}    double n[{of_u}], n_u[{of_u}], m[{of_v}], m_v[{of_v}];
    const int i = {name}_bsplines({name}_knots_u, {rows}, {degree_u}, u, n, n_u);
    const int j = {name}_bsplines({name}_knots_v, {columns}, {degree_v}, v, m, m_v);
    for (int x = 0; x < 3; x++) {{
        s[x] = s_u[x] = s_v[x] = 0.0;
        for (int a = 0; a < {of_u}; a++) {{
            for (int b = 0; b < {of_v}; b++) {{
                const double p = {name}_net[i + a][j + b][x];
                s[x] += n[a] * m[b] * p;
                s_u[x] += n_u[a] * m[b] * p;
                s_v[x] += n[a] * m_v[b] * p;
            }}
        }}
    }}
}}
",
        opening = opening(formula),
        degree_u = u.degree(),
        degree_v = v.degree(),
        of_u = u.degree() + 1,
        of_v = v.degree() + 1,
    );
}

fn write_placement(text: &mut String, formula: &Formula, placement: &Placement) {
    let name = &formula.name;
    let prefix = format!("{name}_placement");
    let entries = statements(formula, &placement.program, &prefix, &SPELLING);
    write_splines(text, &prefix, &entries);
    let _ = writeln!(text, "\n// The rows of the matrix that turns, then the vector that moves.");
    let _ = writeln!(text, "static void {prefix}(double t, double a[12])\n{{\n    (void)t;");
    entries.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    for (k, value) in entries.outputs.iter().enumerate() {
        let _ = writeln!(text, "    a[{k}] = {value};");
    }
    let _ = write!(
        text,
        "}}

// Position and derivatives in u and v.
{signature}    double a[12], p[3], p_u[3], p_v[3];
    {prefix}(t, a);
    {base}(u, v, {instant}p, p_u, p_v);
    for (int i = 0; i < 3; i++) {{
        const double *row = a + 3 * i;
        s[i] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + a[9 + i];
        s_u[i] = row[0] * p_u[0] + row[1] * p_u[1] + row[2] * p_u[2];
        s_v[i] = row[0] * p_v[0] + row[1] * p_v[1] + row[2] * p_v[2];
    }}
}}
",
        signature = signature(formula, &format!("{name}_surface")),
        base = formula.base(),
        instant = if formula.instant.is_none() { "t, " } else { "" },
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
// The piece of x, which becomes how far it is into it.
static int {prefix}_piece(const double *breaks, int pieces, int repeats, double *x)
{{
    if (repeats) *x -= floor((*x - breaks[0]) / (breaks[pieces] - breaks[0])) * (breaks[pieces] - breaks[0]);
    int piece = 0;
    while (piece + 1 < pieces && *x >= breaks[piece + 1]) piece++;
    *x -= breaks[piece];
    return piece;
}}
"
    );
    for (function, table) in &code.splines {
        let _ = writeln!(text, "\n// Data: polynomials on pieces.");
        for (k, argument) in table.arguments.iter().enumerate() {
            let breaks = list(&argument.breaks, double);
            let _ =
                writeln!(text, "static const double {function}_breaks_{k}[{}] = {{{breaks}}};", argument.breaks.len());
        }
        let count = table.coefficients.len();
        let _ =
            writeln!(text, "static const double {function}_data[{count}] = {{{}}};", list(&table.coefficients, double));
        let names: Vec<String> = (0..table.arguments.len()).map(|k| format!("double x_{k}")).collect();
        let _ = writeln!(text, "\nstatic double {function}({})\n{{", names.join(", "));
        for (k, argument) in table.arguments.iter().enumerate() {
            let (pieces, repeats) = (argument.pieces(), i32::from(argument.is_periodic));
            let _ = writeln!(
                text,
                "    const int i_{k} = {prefix}_piece({function}_breaks_{k}, {pieces}, {repeats}, &x_{k});"
            );
        }
        let powers: Vec<usize> = table.arguments.iter().map(|argument| argument.powers).collect();
        let _ = match powers.as_slice() {
            [p, q] => {
                let width = table.arguments.last().map_or(1, |argument| argument.pieces() * q);
                write!(
                    text,
                    "    double sum = 0.0;
    for (int k = {p} - 1; k >= 0; k--) {{
        double inner = 0.0;
        for (int l = {q} - 1; l >= 0; l--) inner = inner * x_1 + {function}_data[(i_0 * {p} + k) * {width} + i_1 * {q} + l];
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
                    "    double sum = 0.0;
    for (int k = {p} - 1; k >= 0; k--) sum = sum * x_0 + {function}_data[i_0 * {p} + k];
    return sum;
}}
"
                )
            }
        };
    }
}
