//! Poles of functions: where a part of one is infinite, and whether the whole is.

use rustc_hash::FxHashMap;

use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Graph, Node, Notation, Variable};

/// A place at which a function is infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pole {
    /// The function.
    pub root: ExprId,
    /// The part of it that makes it so.
    pub factor: ExprId,
    /// u and v; a coordinate on which the factor does not depend means nothing.
    pub point: [f64; 2],
}

impl Pole {
    /// Refuses a function for its pole; `what` says which function it is.
    #[must_use]
    pub fn refuse(&self, graph: &Graph, what: &str, t: f64, origin: Option<Span>) -> Diagnostic {
        let text = graph.text(self.factor, Notation::Ascii, 80).unwrap_or_else(|_| "a long expression".to_owned());
        let dependence = graph.dependence(self.factor);
        let [u, v] = self.point;
        let places = [(dependence.u, Variable::U, u), (dependence.v, Variable::V, v), (dependence.t, Variable::T, t)];
        let places = places.into_iter().filter(|(depends, ..)| *depends);
        let places = places.map(|(_, variable, at)| format!("{} = {}", variable.name(), Shortest(at)));
        let message = format!("{what} is not finite: `{text}` has a pole at {}", places.collect::<Vec<_>>().join(", "));
        Diagnostic::new(Code::DataNotFinite, message)
            .at(origin)
            .hint("it must be finite on the whole domain; change the function or the domain")
    }
}

/// Distances from a pole, of the range, at which sizes are compared.
const DISTANCES: [f64; 2] = [1e-6, 1e-12];

/// What grows by less from the larger distance to the smaller is bounded; a logarithm doubles.
const GROWTH: f64 = 1.5;

/// The poles of `roots`, from those of their parts: each with the coordinate along which it was met.
///
/// `sin(v)/v` and `exp(-1/v^2)` have none at v = 0.
pub fn carried(
    graph: &Graph,
    (roots, parts): (&[ExprId], &[ExprId]),
    poles: Vec<(ExprId, Variable, [f64; 2])>,
    params: &[f64],
    (ranges, t): ([[f64; 2]; 2], f64),
) -> Vec<Pole> {
    let mut carried: FxHashMap<ExprId, Vec<usize>> = FxHashMap::default();
    for (index, (factor, ..)) in poles.iter().enumerate() {
        carried.entry(*factor).or_default().push(index);
    }
    if carried.is_empty() {
        return Vec::new();
    }
    for part in parts {
        for operand in graph.operands(*part) {
            for index in carried.get(&operand).cloned().unwrap_or_default() {
                let Some((_, variable, point)) = poles.get(index) else { continue };
                let near = Neighbourhood { graph, params, along: *variable, point: *point, ranges, t };
                if near.carries(*part, operand) {
                    carried.entry(*part).or_default().push(index);
                }
            }
        }
    }
    let of = |root: &ExprId| {
        let index = carried.get(root).and_then(|indices| indices.first())?;
        poles.get(*index).map(|(factor, _, point)| Pole { root: *root, factor: *factor, point: *point })
    };
    roots.iter().filter_map(of).collect()
}

/// The points beside a pole on one line.
struct Neighbourhood<'a> {
    graph: &'a Graph,
    params: &'a [f64],
    along: Variable,
    point: [f64; 2],
    ranges: [[f64; 2]; 2],
    t: f64,
}

impl Neighbourhood<'_> {
    /// Whether `part` is infinite where its `operand` is.
    fn carries(&self, part: ExprId, operand: ExprId) -> bool {
        let [far, near] = self.sizes(part);
        if matches!(self.graph.node(part), Node::Sum(_)) {
            // Other terms may be larger at any distance; only one as large, of the other sign, takes it away.
            let [_, least] = self.sizes(operand);
            return !near.is_finite() || near >= 0.5 * least;
        }
        !near.is_finite() || near > GROWTH * far
    }

    /// The largest value of `expr` on both sides at each distance.
    fn sizes(&self, expr: ExprId) -> [f64; 2] {
        let [u, v] = self.point;
        let is_along_u = self.along == Variable::U;
        let (at, [low, high]) = if is_along_u { (u, self.ranges[0]) } else { (v, self.ranges[1]) };
        let size = |distance: f64| {
            let beside = [at - distance * (high - low), at + distance * (high - low)];
            let inside = beside.into_iter().filter(|place| (low..=high).contains(place));
            let values = inside.map(|place| {
                let point = if is_along_u { [place, v, self.t] } else { [u, place, self.t] };
                self.graph.value(expr, self.params, point).abs()
            });
            values.fold(0.0, |most: f64, value| if value <= most { most } else { value })
        };
        DISTANCES.map(size)
    }
}
