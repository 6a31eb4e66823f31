//! Python with NumPy: arrays of any shapes that broadcast together.

use std::fmt::Write;

use super::statements::{Spelling, comment, double, parameter, rows, statements};
use super::{Formula, Row};
use crate::expr::Function;

pub(super) const ROW: Row = Row { name: "numpy", description: "Python with NumPy", is_single_precision: false, write };

fn function(function: Function) -> &'static str {
    match function {
        Function::Sin => "np.sin(#0)",
        Function::Cos => "np.cos(#0)",
        Function::Tan => "np.tan(#0)",
        Function::Cot => "1.0 / np.tan(#0)",
        Function::Sec => "1.0 / np.cos(#0)",
        Function::Csc => "1.0 / np.sin(#0)",
        Function::Asin => "np.arcsin(#0)",
        Function::Acos => "np.arccos(#0)",
        Function::Atan => "np.arctan(#0)",
        Function::Atan2 => "np.arctan2(#0, #1)",
        Function::Sinh => "np.sinh(#0)",
        Function::Cosh => "np.cosh(#0)",
        Function::Tanh => "np.tanh(#0)",
        Function::Asinh => "np.arcsinh(#0)",
        Function::Acosh => "np.arccosh(#0)",
        Function::Atanh => "np.arctanh(#0)",
        Function::Exp => "np.exp(#0)",
        Function::Ln => "np.log(#0)",
        Function::Log10 => "np.log10(#0)",
        Function::Cbrt => "np.cbrt(#0)",
        Function::Abs => "np.abs(#0)",
        Function::Sign => "np.sign(#0)",
        Function::Floor => "np.floor(#0)",
        Function::Min => "np.minimum(#0, #1)",
        Function::Max => "np.maximum(#0, #1)",
        Function::Pow => "np.power(#0, #1)",
    }
}

fn write(formula: &Formula) -> String {
    let (name, count) = (&formula.name, formula.count());
    let spelling = Spelling { number: double, declaration: ["", ""], end: "", sqrt: "np.sqrt(#0)", function };
    let basis = statements(formula, &spelling);
    let mut text = comment(&formula.header(), "#");
    let _ = writeln!(text, "\nimport numpy as np\n");
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "{} = {value:?}", parameter(formula, index));
    }
    let vector = |x: &str, y: &str, z: &str| format!("[{x}, {y}, {z}]");
    for (series, suffix, what) in formula.tables() {
        let _ = writeln!(text, "\n# {what}: by degree, function and component.");
        let _ = writeln!(text, "{name}_{suffix} = np.array([");
        for row in rows(&series.coefficients, vector, |value| format!("{value:?}")) {
            let _ = writeln!(text, "    [{row}],");
        }
        let _ = writeln!(text, "])");
    }
    let _ =
        writeln!(text, "\n\ndef {name}_basis(v, t):\n    \"\"\"The basis functions and their derivatives in v.\"\"\"");
    basis.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let (values, slopes) = basis.outputs.split_at_checked(count).unwrap_or_default();
    let [low, high] = formula.domain.u.map(double);
    let (signature, instant) = match formula.instant {
        None => ("u, v, t", String::new()),
        Some(t) => ("u, v", format!("    t = {t:?}\n")),
    };
    let _ = write!(
        text,
        "    together = lambda values: np.stack(np.broadcast_arrays(v, t, *values)[2:], axis=-1)
    return together([{values}]), together([{slopes}])


def {name}_series(c, u):
    \"\"\"The sum of terms c[k] T_k(x), with x from -1 to 1 over the range of u.\"\"\"
    x = ((2.0 * u - {low} - {high}) / ({high} - {low}))[..., None, None]
    following = after = np.zeros(())
    for row in c[:0:-1]:
        following, after = 2.0 * x * following - after + row, following
    return x * following - after + c[0]


def {name}_surface({signature}):
    \"\"\"Position and derivatives in u and v: arrays with a last axis for x, y and z.\"\"\"
    u, v = np.asarray(u, dtype=float), np.asarray(v, dtype=float)
{instant}    f, f_v = {name}_basis(v, t)
    g, g_u = {name}_series({name}_g, u), {name}_series({name}_g_u, u)
    total = lambda g, f: np.einsum(\"...ji,...j->...i\", g, f)
    return total(g, f), total(g_u, f), total(g, f_v)
",
        values = values.join(", "),
        slopes = slopes.join(", "),
    );
    text
}
