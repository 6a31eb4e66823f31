//! Where functions of u and v do what samples at a distance do not show: rise and fall within a narrow width, jump, or
//! become infinite.
//!
//! Input: expressions, the numbers they depend on, and ranges of u and v; output: [`Features`]. A spike may be as narrow as
//! rounding permits, so no density of samples finds it. But a function of the language is narrow only where a part of it
//! is a steep function of a gentle argument: `exp(-1e8(v - 3)^2)` where its argument has its maximum, `tanh(1e6(v - 3))` and
//! `1/(v - 3)` where it is zero. So the arguments of steep functions are sampled, their extrema and zeros found by
//! subdivision, and the functions looked at there. Operands come before what uses them, and what was found of them is
//! sampled with the rest: an argument may be narrow itself.
//!
//! Absent on purpose: what t does, which is a parameter here; and waves, which are the same everywhere.

mod line;
mod pole;

pub use pole::Pole;

use crate::eval::{Backend, Program, compile};
use crate::expr::{ExprId, Function, Graph, Node, Variable};
use crate::numeric::{NodeKind, nodes};

use line::{Line, Steepness};

/// A place where a function of one coordinate changes within a small part of the range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feature {
    /// The value of the coordinate.
    pub at: f64,
    /// Over which the function changes by a good part of its size.
    pub width: f64,
}

/// What was found of some functions.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Features {
    /// Along u, ascending.
    pub u: Vec<Feature>,
    /// Along v, ascending.
    pub v: Vec<Feature>,
    /// Where they become infinite.
    pub poles: Vec<Pole>,
}

/// Along each coordinate; the narrowest are kept.
const MOST_FEATURES: usize = 16;

/// Lines of each direction on which functions of both coordinates are looked at: evenly spaced ones, and with those through
/// what was found.
const LINES: [usize; 2] = [9, 24];

/// How often both directions take their turn.
const ROUNDS: usize = 2;

/// What `roots` do over `ranges` of u and v at instant `t`.
///
/// Cost: the number of nodes; for each part that may be steep a hundred evaluations, for each of its candidates a few
/// hundred more, and for parts that depend on u and v some fifty times as much.
#[must_use]
pub fn locate(graph: &Graph, roots: &[ExprId], params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Features {
    let parts = graph.reachable(roots);
    let mut found = Features::default();
    let mut poles = Vec::new();
    for part in &parts {
        if let Some((steepness, arguments)) = steepness(graph, *part, params) {
            let search = Search { graph, params, ranges, t, part: *part, steepness, arguments };
            search.run(&mut found, &mut poles);
        }
    }
    found.poles = pole::carried(graph, (roots, &parts), poles, params, (ranges, t));
    found
}

impl Features {
    /// `nodes` with nodes at each of `features`, closest at it, out to where nodes are anyway; ascending.
    #[must_use]
    pub fn refined(features: &[Feature], nodes: &[f64], [low, high]: [f64; 2]) -> Vec<f64> {
        let mut all = nodes.to_vec();
        for feature in features {
            all.push(feature.at);
            for distance in graded(feature.width, 2.0, (high - low) / line::SAMPLES as f64) {
                all.extend([feature.at - distance, feature.at + distance]);
            }
        }
        all.retain(|at| (low..=high).contains(at));
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// What is infinite in `root`, one of the functions that were looked at.
    #[must_use]
    pub fn pole_of(&self, root: ExprId) -> Option<&Pole> {
        self.poles.iter().find(|pole| pole.root == root)
    }

    fn along(&mut self, variable: Variable) -> &mut Vec<Feature> {
        if variable == Variable::U { &mut self.u } else { &mut self.v }
    }

    fn add(&mut self, variable: Variable, features: Vec<Feature>) {
        let all = self.along(variable);
        all.extend(features);
        all.sort_by(|a, b| a.width.total_cmp(&b.width));
        let mut kept: Vec<Feature> = Vec::new();
        for feature in all.drain(..) {
            // One that lies within a narrower one is the same.
            if kept.len() < MOST_FEATURES && kept.iter().all(|other| (other.at - feature.at).abs() > other.width) {
                kept.push(feature);
            }
        }
        kept.sort_by(|a, b| a.at.total_cmp(&b.at));
        *all = kept;
    }
}

/// Distances from half of `width` on, each `factor` times the one before, below `most`.
fn graded(width: f64, factor: f64, most: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(0.5 * width), move |distance| Some(factor * distance))
        .take_while(move |distance| *distance < most)
}

/// How `part` may be steep and in which of its operands; `None` if it is as gentle as they are.
fn steepness(graph: &Graph, part: ExprId, params: &[f64]) -> Option<(Steepness, Vec<ExprId>)> {
    let depends = |expr: &ExprId| graph.dependence(*expr).u || graph.dependence(*expr).v;
    if !depends(&part) {
        return None;
    }
    let steepness = match graph.node(part) {
        Node::Power(base, exponent) if depends(base) && !depends(exponent) => {
            let exponent = graph.value(*exponent, params, [f64::NAN; 3]);
            // Powers that people write for polynomials are gentle.
            match exponent {
                _ if exponent < 0.0 => Steepness::InfiniteAtZero,
                _ if (0.0..=16.0).contains(&exponent) && exponent.fract() == 0.0 => return None,
                _ => Steepness::Steep,
            }
        }
        Node::Power(..) => Steepness::Steep,
        Node::Call(Function::Tan | Function::Sec, _) => Steepness::InfiniteAtTurns { shift: 0.5 },
        Node::Call(Function::Cot | Function::Csc, _) => Steepness::InfiniteAtTurns { shift: 0.0 },
        Node::Call(Function::Ln | Function::Log10, _) => Steepness::InfiniteAtZero,
        Node::Call(
            Function::Sin
            | Function::Cos
            | Function::Asin
            | Function::Acos
            | Function::Asinh
            | Function::Cbrt
            | Function::Abs
            | Function::Min
            | Function::Max,
            _,
        ) => return None,
        Node::Call(..) => Steepness::Steep,
        _ => return None,
    };
    Some((steepness, graph.operands(part).into_iter().filter(depends).collect()))
}

/// The search for what one part of a function does.
struct Search<'a> {
    graph: &'a Graph,
    params: &'a [f64],
    ranges: [[f64; 2]; 2],
    t: f64,
    part: ExprId,
    steepness: Steepness,
    arguments: Vec<ExprId>,
}

impl Search<'_> {
    fn run(&self, found: &mut Features, poles: &mut Vec<(ExprId, Variable, [f64; 2])>) {
        let graph = self.graph;
        // The terms of an argument tell whether it is zero but for rounding.
        let terms: Vec<ExprId> = match self.arguments.as_slice() {
            [argument] if matches!(graph.node(*argument), Node::Sum(_)) => graph.operands(*argument),
            _ => Vec::new(),
        };
        let outputs: Vec<ExprId> = self.arguments.iter().chain(&terms).copied().chain([self.part]).collect();
        let (evaluator, _) = compile(Program::compile(graph, &outputs), Backend::Interpreter);
        let line = |along: Variable, across: f64| Line {
            evaluator: &*evaluator,
            arguments: self.arguments.len(),
            terms: terms.len(),
            params: self.params,
            along,
            across,
            t: self.t,
        };
        let dependence = graph.dependence(self.part);
        let depends_on_both = dependence.u && dependence.v;
        let [range_u, range_v] = self.ranges;
        let evenly = |range| nodes(NodeKind::Ends, LINES[0], range);
        // Nothing special is there: at the ends of a region a displacement vanishes, poles and all.
        let somewhere = |[low, high]: [f64; 2]| vec![low + 0.381_966 * (high - low)];
        let direction = |variable, range, across| Direction { variable, range, across, done: 0 };
        let (mut here, mut other) = match (dependence.u, dependence.v) {
            (true, true) => {
                (direction(Variable::U, range_u, evenly(range_v)), direction(Variable::V, range_v, evenly(range_u)))
            }
            (true, false) => {
                (direction(Variable::U, range_u, somewhere(range_v)), direction(Variable::V, range_v, Vec::new()))
            }
            _ => (direction(Variable::V, range_v, somewhere(range_u)), direction(Variable::U, range_u, Vec::new())),
        };
        // What lines in one direction find lies on lines in the other, which may find more.
        for _ in 0..2 * ROUNDS {
            let fresh = here.across.get(here.done..).unwrap_or_default().to_vec();
            here.done = here.across.len();
            for at in fresh {
                let shown = line(here.variable, at).examine(self.steepness, here.range, found.along(here.variable));
                found.add(here.variable, shown.features);
                let point = |place: f64| if here.variable == Variable::U { [place, at] } else { [at, place] };
                poles.extend(shown.poles.into_iter().map(|place| (self.part, here.variable, point(place))));
                if depends_on_both {
                    let is_new = |place: &f64| !other.across.contains(place);
                    let candidates: Vec<f64> = shown.candidates.into_iter().filter(is_new).collect();
                    other.across.extend(candidates);
                    other.across.truncate(LINES[1]);
                }
            }
            std::mem::swap(&mut here, &mut other);
        }
    }
}

/// Lines in one direction.
struct Direction {
    variable: Variable,
    range: [f64; 2],
    /// Values of the other coordinate.
    across: Vec<f64>,
    /// How many of them were looked at.
    done: usize,
}
