//! Vectors of expressions, and the cubic Hermite curve between two of them.

use rustc_hash::FxHashMap;

use crate::diagnostic::{Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Graph, Number, Variable};
use crate::limits::Limits;

/// x, y and z.
pub type Vector = [ExprId; 3];

/// The sum of multiples.
pub fn combination(graph: &mut Graph, terms: &[(Number, Vector)]) -> Vector {
    let component = |axis: usize, graph: &mut Graph| {
        let parts: Vec<ExprId> = terms
            .iter()
            .filter_map(|(factor, vector)| vector.get(axis).map(|expr| graph.scale(*factor, *expr)))
            .collect();
        graph.sum(parts)
    };
    [component(0, graph), component(1, graph), component(2, graph)]
}

/// `factor * vector` for a factor that is an expression.
pub fn scaled(graph: &mut Graph, factor: ExprId, vector: Vector) -> Vector {
    vector.map(|component| graph.product([factor, component]))
}

pub fn sum(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    let one = Number::integer(1);
    combination(graph, &[(one, a), (one, b)])
}

/// `vector` with `value` in place of `variable`.
pub fn at(graph: &mut Graph, vector: Vector, variable: Variable, value: ExprId) -> Vector {
    let replacements: FxHashMap<ExprId, ExprId> = [(graph.variable(variable), value)].into_iter().collect();
    vector.map(|component| graph.substitute(component, &replacements))
}

/// The derivative of order one in `variable`.
pub fn slope(
    graph: &mut Graph,
    vector: Vector,
    variable: Variable,
    limits: &Limits,
    origin: Option<Span>,
) -> Result<Vector, Diagnostic> {
    let orders = match variable {
        Variable::U => Derivative::new(1, 0, 0),
        Variable::V => Derivative::new(0, 1, 0),
        Variable::T => Derivative::new(0, 0, 1),
    };
    let mut slopes = vector;
    for component in &mut slopes {
        let result = graph.derivative_within(*component, orders, limits.graph_nodes);
        *component = result.map_err(|fault| fault.to_diagnostic(orders, limits.graph_nodes).at(origin))?;
    }
    Ok(slopes)
}

/// Position and slope at one end of a curve.
#[derive(Debug, Clone, Copy)]
pub struct End {
    pub position: Vector,
    pub slope: Vector,
}

/// The cubic with given position and slope at x = 0 and x = 1.
pub fn hermite(graph: &mut Graph, x: ExprId, start: End, end: End) -> Vector {
    let cubic = |graph: &mut Graph, a: i64, b: i64, c: i64, d: i64| {
        let terms: Vec<ExprId> = [a, b, c, d]
            .into_iter()
            .zip(0..)
            .map(|(factor, power)| {
                let power = graph.power_integer(x, power);
                graph.scale(Number::integer(factor), power)
            })
            .collect();
        graph.sum(terms)
    };
    let blends = [
        (cubic(graph, 1, 0, -3, 2), start.position),
        (cubic(graph, 0, 1, -2, 1), start.slope),
        (cubic(graph, 0, 0, 3, -2), end.position),
        (cubic(graph, 0, 0, -1, 1), end.slope),
    ];
    let parts = blends.map(|(blend, vector)| scaled(graph, blend, vector));
    let one = Number::integer(1);
    combination(graph, &parts.map(|part| (one, part)))
}
