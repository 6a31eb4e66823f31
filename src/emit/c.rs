//! C99: one function and its tables, all but the function private to the file.

use std::fmt::Write;

use super::statements::{Spelling, comment, double, parameter, rows, statements};
use super::{Formula, Row};
use crate::expr::Function;

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

fn write(formula: &Formula) -> String {
    let (name, count) = (&formula.name, formula.count());
    let spelling =
        Spelling { number: double, declaration: ["const double ", ""], end: ";", sqrt: "sqrt(#0)", function };
    let basis = statements(formula, &spelling);
    let mut text = comment(&formula.header(), "//");
    let _ = writeln!(text, "\n#include <math.h>\n");
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "static const double {} = {value:?};", parameter(formula, index));
    }
    let vector = |x: &str, y: &str, z: &str| format!("{{{x}, {y}, {z}}}");
    for (series, suffix, what) in formula.tables() {
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

",
        low = double(low),
        high = double(high),
    );
    let (signature, instant) = match formula.instant {
        None => ("double u, double v, double t", String::new()),
        Some(t) => ("double u, double v", format!("    const double t = {t:?};\n")),
    };
    let _ = write!(
        text,
        "// Position and derivatives in u and v.
void {name}_surface({signature}, double s[3], double s_u[3], double s_v[3])
{{
{instant}    double f[{count}], f_v[{count}], g[{count}][3], g_u[{count}][3];
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
        terms = formula.amplitudes[0].coefficients.len(),
        slope_terms = formula.amplitudes[1].coefficients.len(),
    );
    text
}
