//! Rust: one public function and its tables.

use std::fmt::Write;

use super::statements::{Spelling, comment, double, parameter, rows, statements};
use super::{Formula, Row};
use crate::expr::Function;

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

fn write(formula: &Formula) -> String {
    let (name, count) = (&formula.name, formula.count());
    let spelling =
        Spelling { number: double, declaration: ["let ", ": f64"], end: ";", sqrt: "f64::sqrt(#0)", function };
    let basis = statements(formula, &spelling);
    let mut text = comment(&formula.header(), "//");
    text.push('\n');
    // Names are those of the spec, in any case.
    let quiet = "#[allow(non_upper_case_globals)]";
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "{quiet}\nconst {}: f64 = {value:?};", parameter(formula, index));
    }
    let vector = |x: &str, y: &str, z: &str| format!("[{x}, {y}, {z}]");
    for (series, suffix, what) in formula.tables() {
        let _ = writeln!(text, "\n/// {what}: by degree, function and component.");
        let terms = series.coefficients.len();
        let _ = writeln!(text, "{quiet}\nstatic {name}_{suffix}: [[[f64; 3]; {count}]; {terms}] = [");
        for row in rows(&series.coefficients, vector, |value| format!("{value:?}")) {
            let _ = writeln!(text, "    [{row}],");
        }
        let _ = writeln!(text, "];");
    }
    let _ = writeln!(text, "\n/// The basis functions and their derivatives in v.");
    let quiet = "#[allow(non_snake_case, unused_parens, unused_variables, clippy::all)]";
    let _ = writeln!(text, "{quiet}\nfn {name}_basis(v: f64, t: f64) -> [[f64; {count}]; 2] {{");
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let (values, slopes) = basis.outputs.split_at_checked(count).unwrap_or_default();
    let _ = writeln!(text, "    [[{}], [{}]]\n}}", values.join(", "), slopes.join(", "));
    let [low, high] = formula.domain.u.map(double);
    let (signature, instant) = match formula.instant {
        None => ("u: f64, v: f64, t: f64", String::new()),
        Some(t) => ("u: f64, v: f64", format!("    let t = {t:?};\n")),
    };
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

/// Position and derivatives in u and v.
#[must_use]
#[allow(non_snake_case)]
pub fn {name}_surface({signature}) -> [[f64; 3]; 3] {{
{instant}    let [f, f_v] = {name}_basis(v, t);
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
    );
    text
}
