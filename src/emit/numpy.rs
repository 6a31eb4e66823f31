//! Python with NumPy: arrays of any shapes that broadcast together.

use std::fmt::Write;

use super::statements::{Spelling, Statements, comment, double, list, net_rows, parameter, rows, statements};
use super::{Form, Formula, Placement, Row, Sum};
use crate::expr::Function;
use crate::surface::BsplineSurface;

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

const SPELLING: Spelling = Spelling { number: double, declaration: ["", ""], end: "", sqrt: "np.sqrt(#0)", function };

// Writing to a string does not fail, here and below.
fn write(formula: &Formula) -> String {
    let mut text = comment(&formula.header(), "#");
    let _ = writeln!(text, "\nimport numpy as np\n");
    for (index, _, value) in formula.used_parameters() {
        let _ = writeln!(text, "{} = {value:?}", parameter(formula, index));
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
    let what = if formula.placement.is_some() { "Of what is copied: position" } else { "Position" };
    signature(formula, &formula.base(), what)
}

fn signature(formula: &Formula, function: &str, what: &str) -> String {
    let (arguments, instant) = match formula.instant {
        None => ("u, v, t", String::new()),
        Some(t) => ("u, v", format!("    t = {t:?}\n")),
    };
    format!(
        "

def {function}({arguments}):
    \"\"\"{what} and derivatives in u and v: arrays with a last axis for x, y and z.\"\"\"
{instant}"
    )
}

fn write_sum(text: &mut String, formula: &Formula, sum: &Sum) {
    let (name, count) = (&formula.name, sum.count());
    let basis = statements(formula, &sum.program, name, &SPELLING);
    write_splines(text, name, &basis);
    let vector = |x: &str, y: &str, z: &str| format!("[{x}, {y}, {z}]");
    for (series, suffix, what) in sum.tables() {
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
{opening}    u, v = np.asarray(u, dtype=float), np.asarray(v, dtype=float)
    f, f_v = {name}_basis(v, t)
    g, g_u = {name}_series({name}_g, u), {name}_series({name}_g_u, u)
    total = lambda g, f: np.einsum(\"...ji,...j->...i\", g, f)
    return total(g, f), total(g_u, f), total(g, f_v)
",
        values = values.join(", "),
        slopes = slopes.join(", "),
        opening = opening(formula),
    );
}

fn write_net(text: &mut String, formula: &Formula, surface: &BsplineSurface) {
    let name = &formula.name;
    let [u, v] = surface.knots();
    let number = |value: f64| format!("{value:?}");
    for (suffix, knots) in [("u", u), ("v", v)] {
        let _ = writeln!(text, "\n{name}_knots_{suffix} = np.array([{}])", list(knots.as_slice(), number));
    }
    let _ = writeln!(text, "\n# Control points: those of one i in a line.\n{name}_net = np.array([");
    for row in net_rows(surface, |x, y, z| format!("[{x}, {y}, {z}]"), number) {
        let _ = writeln!(text, "    [{row}],");
    }
    let _ = write!(
        text,
        "])


def {name}_bsplines(knots, degree, x):
    \"\"\"The first B-spline that is not zero at x; it and the following ones, with their derivatives, by de Boor's recurrence.\"\"\"
    k = np.clip(np.searchsorted(knots, x, side=\"right\") - 1, degree, len(knots) - degree - 2)
    n, n_x = [np.ones(np.shape(x))], []
    for j in range(1, degree + 1):
        saved = before = 0.0
        values, slopes = [], []
        for r in range(j):
            low, high = knots[k + 1 - j + r], knots[k + 1 + r]
            share = n[r] / (high - low)
            slopes.append(j * (before - share))
            values.append(saved + (high - x) * share)
            saved, before = (x - low) * share, share
        n, n_x = [*values, saved], [*slopes, j * before]
    return k - degree, n, n_x
{opening}    u, v, _ = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(v, dtype=float), t)
    i, n, n_u = {name}_bsplines({name}_knots_u, {degree_u}, u)
    j, m, m_v = {name}_bsplines({name}_knots_v, {degree_v}, v)
    total = lambda n, m: sum(
        (a * b)[..., None] * {name}_net[i + row, j + column] for row, a in enumerate(n) for column, b in enumerate(m)
    )
    return total(n, m), total(n_u, m), total(n, m_v)
",
        opening = opening(formula),
        degree_u = u.degree(),
        degree_v = v.degree(),
    );
}

fn write_placement(text: &mut String, formula: &Formula, placement: &Placement) {
    let name = &formula.name;
    let prefix = format!("{name}_placement");
    let entries = statements(formula, &placement.program, &prefix, &SPELLING);
    write_splines(text, &prefix, &entries);
    let _ = writeln!(
        text,
        "\n\ndef {prefix}(t):\n    \"\"\"The rows of the matrix that turns, then the vector that moves.\"\"\""
    );
    entries.lines.iter().for_each(|line| {
        let _ = writeln!(text, "    {line}");
    });
    let _ = write!(
        text,
        "    return np.stack(np.broadcast_arrays(t, {outputs})[1:], axis=-1)
{signature}    a = {prefix}(t)
    s, s_u, s_v = {base}(u, v{instant})
    turned = lambda x: np.stack([(a[..., 3 * i : 3 * i + 3] * x).sum(axis=-1) for i in range(3)], axis=-1)
    return turned(s) + a[..., 9:], turned(s_u), turned(s_v)
",
        outputs = entries.outputs.join(", "),
        signature = signature(formula, &format!("{name}_surface"), "Position"),
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

def {prefix}_piece(breaks, repeats, x):
    \"\"\"The piece of x, and how far x is into it.\"\"\"
    x = np.asarray(x, dtype=float)
    if repeats:
        x = x - np.floor((x - breaks[0]) / (breaks[-1] - breaks[0])) * (breaks[-1] - breaks[0])
    piece = np.clip(np.searchsorted(breaks, x, side=\"right\") - 1, 0, len(breaks) - 2)
    return piece, x - breaks[piece]
"
    );
    let number = |value: f64| format!("{value:?}");
    for (function, table) in &code.splines {
        let shape: Vec<String> =
            table.arguments.iter().map(|argument| format!("{}, {}", argument.pieces(), argument.powers)).collect();
        let data = list(&table.coefficients, number);
        let _ = writeln!(text, "\n\n{function}_data = np.array([{data}]).reshape({})", shape.join(", "));
        for (k, argument) in table.arguments.iter().enumerate() {
            let _ = writeln!(text, "{function}_breaks_{k} = np.array([{}])", list(&argument.breaks, number));
        }
        let names: Vec<String> = (0..table.arguments.len()).map(|k| format!("x_{k}")).collect();
        let _ =
            writeln!(text, "\n\ndef {function}({}):\n    \"\"\"Data: polynomials on pieces.\"\"\"", names.join(", "));
        for (k, argument) in table.arguments.iter().enumerate() {
            let repeats = if argument.is_periodic { "True" } else { "False" };
            let _ = writeln!(text, "    i_{k}, x_{k} = {prefix}_piece({function}_breaks_{k}, {repeats}, x_{k})");
        }
        let powers: Vec<usize> = table.arguments.iter().map(|argument| argument.powers).collect();
        let _ = match powers.as_slice() {
            [p, q] => write!(
                text,
                "    total = 0.0
    for k in reversed(range({p})):
        inner = 0.0
        for l in reversed(range({q})):
            inner = inner * x_1 + {function}_data[i_0, k, i_1, l]
        total = total * x_0 + inner
    return total
"
            ),
            _ => write!(
                text,
                "    total = 0.0
    for k in reversed(range({})):
        total = total * x_0 + {function}_data[i_0, k]
    return total
",
                powers.first().copied().unwrap_or(1)
            ),
        };
    }
}
