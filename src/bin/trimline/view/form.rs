//! How the page comes to the vertices of a part, as JSON: a sum of products or a B-spline, which it evaluates, or neither.

use serde::Serialize;
use serde_json::{Value, json};

use trimline::emit::amplitude_series;
use trimline::eval::{Op, OpId, Program};
use trimline::expr::{Derivative, SplineCall};
use trimline::numeric::ChebyshevSeries;
use trimline::problem::DomainValues;

use super::pieces::{Of, Piece};
use crate::parts::Located;
use crate::workflow::Solved;

/// How the page comes to a patch's vertices.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Form {
    /// It evaluates a sum of products.
    Separable {
        /// Whether that holds at the patch's instant only.
        is_instant: bool,
        /// F_1 …, then their first derivatives in v, then the second where they exist.
        basis: Value,
        count: usize,
        amplitudes: Series,
    },
    /// It evaluates a B-spline.
    Net {
        /// Whether the control points are those of one instant only.
        is_instant: bool,
        /// In u and in v.
        degrees: [usize; 2],
        knots: [Vec<f64>; 2],
        /// Those of one i beside each other.
        points: Vec<[f64; 3]>,
    },
    /// It asks for them.
    Sampled,
}

/// A Chebyshev series: a row for each degree.
#[derive(Serialize)]
pub struct Series {
    range: [f64; 2],
    coefficients: Vec<Vec<f64>>,
}

impl Form {
    /// The form of what was solved for a part.
    pub fn of(piece: &Piece<'_>) -> Form {
        match piece.of {
            Of::Patch(_, solved) => separable(solved, *piece.domain()),
            Of::Net(_, solved) => {
                let surface = &solved.filled.surface;
                Form::Net {
                    is_instant: solved.surface.instant().is_some(),
                    degrees: surface.knots().map(|knots| knots.degree()),
                    knots: surface.knots().map(|knots| knots.as_slice().to_vec()),
                    points: surface.net().to_vec(),
                }
            }
        }
    }
}

/// A sum of products, if the surface is one that the page can evaluate as well as the library.
fn separable(solved: &Solved, domain: DomainValues) -> Form {
    // Without functions there is nothing to add up: the surface is zero.
    let separable = solved.solution.surface.as_separable().filter(|surface| !surface.basis.is_empty());
    let Some(surface) = separable else { return Form::Sampled };
    let slopes = [Derivative::NONE, Derivative::new(0, 1, 0), Derivative::new(0, 2, 0)];
    // A basis with a kink has no second derivative, so no curvature; without the first there is no normal either.
    let basis = surface.basis.program(&slopes).or_else(|_| surface.basis.program(&slopes[..2]));
    let (Ok(basis), Ok(amplitudes)) = (basis, amplitude_series(surface, domain)) else { return Form::Sampled };
    Form::Separable {
        is_instant: surface.instant.is_some(),
        basis: program(&basis),
        count: surface.basis.len(),
        amplitudes: series(amplitudes),
    }
}

fn series(series: ChebyshevSeries) -> Series {
    Series { range: series.range, coefficients: series.coefficients }
}

/// `{"ops": [["const", 0.8], ["v"], ["sin", 1], ["mul", 0, 2]], "outputs": [3]}`: operands are positions in the
/// list. `["spline", a, b, i]` is spline i at one or two of them, `b` being null for one.
pub fn program(program: &Program) -> Value {
    let op = |op: &Op| match op.map(OpId::index) {
        Op::Constant(value) => json!(["const", value]),
        Op::Parameter(index) => json!(["symbol", index]),
        Op::Variable(variable) => json!([variable.name()]),
        Op::Neg(a) => json!(["neg", a]),
        Op::Add(a, b) => json!(["add", a, b]),
        Op::Sub(a, b) => json!(["sub", a, b]),
        Op::Mul(a, b) => json!(["mul", a, b]),
        Op::Div(a, b) => json!(["div", a, b]),
        Op::Sqrt(a) => json!(["sqrt", a]),
        Op::Call1(function, a) => json!([function.row().name, a]),
        Op::Call2(function, a, b) => json!([function.row().name, a, b]),
        Op::Spline1(index, a) => json!(["spline", a, null, index]),
        Op::Spline2(index, a, b) => json!(["spline", a, b, index]),
    };
    let outputs = program.output_ops().iter().map(|id| id.index());
    json!({
        "ops": program.ops().iter().map(op).collect::<Vec<_>>(),
        "outputs": outputs.collect::<Vec<_>>(),
        "splines": program.splines().iter().map(spline).collect::<Vec<_>>(),
    })
}

/// The data of a spline and the orders of its derivative.
fn spline(call: &SplineCall) -> Value {
    let axis = |index: usize| {
        json!({
            "degree": call.spline.degree(index),
            "breaks": call.spline.breaks(index),
            "periodic": call.spline.is_periodic(index),
        })
    };
    json!({ "orders": call.orders, "axes": [axis(0), axis(1)], "coefficients": call.spline.coefficients() })
}
