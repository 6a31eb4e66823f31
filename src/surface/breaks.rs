//! Where functions of one coordinate are put together of pieces.
//!
//! Input: functions of u or v, and of t; output: the values of the coordinate at which an argument of a spline crosses a
//! knot, that of `abs` or `sign` crosses zero, that of `floor` an integer, or those of `min` and `max` each other.
//!
//! Absent on purpose: pieces that begin where an argument only touches such a value, which leaves no corner, and roots
//! of squares.

use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Backend, Program, Samples, compile};
use crate::expr::{ExprId, Function, Graph, Node};
use crate::numeric::{NodeKind, nodes};

/// Equal parts of the range, on each of which an argument is taken to run one way.
const PARTS: usize = 256;

/// Crossings in one part that are looked for: of more, knots would be closer than any fit has them.
const MOST_IN_A_PART: usize = 64;

/// A quantity whose crossings of some levels are breaks.
struct Watched {
    /// The quantity, or the difference of two.
    of: [Option<ExprId>; 2],
    levels: Vec<f64>,
    /// Whether levels repeat, and after how much.
    period: Option<f64>,
}

/// The breaks of `functions` at instant `t` inside `range` of the coordinate they depend on, in no order.
///
/// # Errors
/// When parameters are missing.
pub(super) fn breaks(
    graph: &Graph,
    functions: &[ExprId],
    params: &[f64],
    range: [f64; 2],
    t: f64,
) -> Result<Vec<f64>, Diagnostic> {
    let watched = watched(graph, functions);
    if watched.is_empty() {
        return Ok(Vec::new());
    }
    let outputs: Vec<ExprId> = watched.iter().flat_map(|one| one.of.into_iter().flatten()).collect();
    let (evaluator, _) = compile(Program::compile(graph, &outputs), Backend::Interpreter);
    let values = |at: &[f64]| -> Result<Vec<f64>, Diagnostic> {
        let mut values = vec![0.0; outputs.len() * at.len()];
        // The functions depend on u or on v, never on both.
        evaluator
            .evaluate(params, Samples { u: at, v: at, t: &vec![t; at.len()] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        Ok(values)
    };
    let places = nodes(NodeKind::Ends, PARTS + 1, range);
    let table = values(&places)?;
    let mut found = Vec::new();
    let mut row = 0;
    for one in &watched {
        let rows = one.of.iter().flatten().count();
        let first = row;
        row += rows;
        let quantity = |values: &[f64], samples: usize, sample: usize| -> f64 {
            let of = |row: usize| values.get(row * samples + sample).copied().unwrap_or(f64::NAN);
            if rows == 2 { of(first) - of(first + 1) } else { of(first) }
        };
        for (index, part) in places.windows(2).enumerate() {
            let &[low, high] = part else { continue };
            let ends = [index, index + 1].map(|sample| quantity(&table, places.len(), sample));
            for level in one.crossed(ends) {
                let mut part = [low, high];
                let rises = ends[0] < ends[1];
                while let Some(middle) = between(part) {
                    let value = quantity(&values(&[middle])?, 1, 0);
                    let is_before = if rises { value < level } else { value > level };
                    if is_before {
                        part[0] = middle;
                    } else {
                        part[1] = middle;
                    }
                }
                found.push(part[1]);
            }
        }
    }
    let [low, high] = range;
    found.retain(|at| low < *at && *at < high);
    found.sort_by(f64::total_cmp);
    found.dedup();
    Ok(found)
}

/// A number between two, if there is one.
fn between([low, high]: [f64; 2]) -> Option<f64> {
    let middle = 0.5 * low + 0.5 * high;
    (low < middle && middle < high).then_some(middle)
}

fn watched(graph: &Graph, functions: &[ExprId]) -> Vec<Watched> {
    let mut watched = Vec::new();
    for id in graph.reachable(functions) {
        match graph.node(id) {
            Node::Spline(call, arguments) => {
                for (index, argument) in arguments.iter().enumerate() {
                    let [start, end] = call.spline.range(index);
                    let period = call.spline.is_periodic(index).then_some(end - start);
                    watched.push(Watched {
                        of: [Some(*argument), None],
                        levels: call.spline.breaks(index).to_vec(),
                        period,
                    });
                }
            }
            Node::Call(Function::Abs | Function::Sign, arguments) => {
                watched.push(Watched { of: [arguments.first().copied(), None], levels: vec![0.0], period: None });
            }
            Node::Call(Function::Floor, arguments) => {
                watched.push(Watched { of: [arguments.first().copied(), None], levels: vec![0.0], period: Some(1.0) });
            }
            Node::Call(Function::Min | Function::Max, arguments) => {
                let of = [arguments.first().copied(), arguments.get(1).copied()];
                watched.push(Watched { of, levels: vec![0.0], period: None });
            }
            _ => {}
        }
    }
    let moves = |one: &Watched| {
        one.of.iter().flatten().any(|id| {
            let on = graph.dependence(*id);
            on.u || on.v
        })
    };
    watched.retain(moves);
    watched
}

impl Watched {
    /// The levels that lie between two values, or at the second.
    fn crossed(&self, [start, end]: [f64; 2]) -> Vec<f64> {
        let (low, high) = (start.min(end), start.max(end));
        if !(low < high && high.is_finite() && low.is_finite()) {
            return Vec::new();
        }
        let is_crossed = |level: &f64| (low..=high).contains(level) && *level != start;
        match self.period {
            None => self.levels.iter().copied().filter(is_crossed).collect(),
            Some(period) => {
                let first = ((low - self.levels.first().copied().unwrap_or(0.0)) / period).floor() - 1.0;
                let turns = ((high - low) / period).ceil() + 2.0;
                if turns > MOST_IN_A_PART as f64 {
                    return Vec::new();
                }
                let turned = (0..turns as usize).map(|turn| (first + turn as f64) * period);
                let levels = turned.flat_map(|offset| self.levels.iter().map(move |level| level + offset));
                let mut levels: Vec<f64> = levels.filter(is_crossed).collect();
                levels.dedup();
                levels
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Number, Variable};

    fn of(build: impl Fn(&mut Graph, ExprId) -> ExprId, range: [f64; 2]) -> Vec<f64> {
        let mut graph = Graph::new();
        let v = graph.variable(Variable::V);
        let function = build(&mut graph, v);
        breaks(&graph, &[function], &[], range, 0.0).expect("no parameters")
    }

    #[test]
    fn corners_of_functions_are_found_to_the_last_digit() {
        let minus = |graph: &mut Graph, v: ExprId, number: i64| {
            let number = graph.number(Number::integer(-number));
            graph.sum([v, number])
        };
        // |v² - 2|
        let root = |graph: &mut Graph, v: ExprId| {
            let square = graph.product([v, v]);
            let inside = minus(graph, square, 2);
            graph.call(Function::Abs, &[inside])
        };
        let found = of(root, [-3.0, 3.0]);
        assert_eq!(found.len(), 2);
        for (found, expected) in found.iter().zip([-std::f64::consts::SQRT_2, std::f64::consts::SQRT_2]) {
            assert!((found - expected).abs() <= 2.0 * f64::EPSILON, "{found}");
        }
        let larger = |graph: &mut Graph, v: ExprId| {
            let sine = graph.call(Function::Sin, &[v]);
            let cosine = graph.call(Function::Cos, &[v]);
            graph.call(Function::Max, &[sine, cosine])
        };
        let found = of(larger, [0.0, 6.0]);
        let quarter = std::f64::consts::FRAC_PI_4;
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((found[0] - quarter).abs() < 1e-15 && (found[1] - 5.0 * quarter).abs() < 4e-15, "{found:?}");
        let steps = |graph: &mut Graph, v: ExprId| graph.call(Function::Floor, &[v]);
        assert_eq!(of(steps, [0.5, 3.5]), [1.0, 2.0, 3.0]);
        assert_eq!(of(|graph, v| graph.call(Function::Sin, &[v]), [0.0, 6.0]), Vec::<f64>::new());
    }
}
