//! Loops of edges around a hole, and whether they close.

use super::crossing::{chain, cross_over};
use super::split;
use super::vector::{End, Vector, at, combination, hermite, slope};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Graph, Number, Variable};
use crate::limits::Limits;
use crate::problem::{Bindings, Patch, PdeOperator, Problem, SolveRequest};

/// The most edges of a loop.
pub const MOST_EDGES: usize = 12;
/// A loop that is open by less than this share of its size is closed.
const CLOSED: f64 = 1e-9;

/// One edge of a loop, from one corner to the next, and the tangent across it.
#[derive(Debug, Clone)]
pub struct Edge {
    /// The curve, a function of u from 0 to 1, of params and of t.
    pub curve: Vector,
    /// The tangent across the edge into the hole, a function of u from 0 to 1; at both ends it is the tangent along the
    /// neighbouring edge. `None` turns from the one into the other.
    pub across: Option<Vector>,
    /// Where it is written.
    pub origin: Option<Span>,
}

/// Edges around a hole, each beginning where the one before it ends, the first where the last ends.
#[derive(Debug, Clone)]
pub struct EdgeLoop {
    /// What the user calls it; its patches are numbered from 1.
    pub name: String,
    /// The edges, three to [`MOST_EDGES`].
    pub edges: Vec<Edge>,
    /// The point in the middle; `None` for the mean of what the edges' midpoints point to.
    pub centre: Option<Vector>,
    /// The equation of every patch.
    pub operator: PdeOperator,
    /// The range of t, constant.
    pub time: [ExprId; 2],
    /// How its patches are solved.
    pub solve: SolveRequest,
}

/// A curve that two patches share: `left` at u = 1, as a function of v, is `right` at v = 1, as a function of u.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seam {
    /// Index of the patch whose high end of u it is.
    pub left: usize,
    /// Index of the patch whose high end of v it is.
    pub right: usize,
}

impl EdgeLoop {
    /// The patches that fill the loop: one for each corner, from the middle of one edge to the middle of the next.
    ///
    /// Patch k has u and v in [0, 1], corner k at u = v = 0, half of edge k on v = 0 and half of edge k - 1 on u = 0.
    ///
    /// # Errors
    /// [`Code::EdgeCount`] for fewer than three edges or more than [`MOST_EDGES`]; [`Code::NotDifferentiable`] for an
    /// edge without slope; [`Code::LimitReached`] when the expressions grow too large.
    pub fn split(&self, graph: &mut Graph, limits: &Limits) -> Result<Vec<Patch>, Diagnostic> {
        let count = self.edges.len();
        if !(3..=MOST_EDGES).contains(&count) {
            let message = format!("`{}` has {count} edges; a loop has 3 to {MOST_EDGES}", self.name);
            let origin = self.edges.iter().find_map(|edge| edge.origin);
            return Err(Diagnostic::new(Code::EdgeCount, message).at(origin));
        }
        let across = self.tangents_across(graph, limits)?;
        split::split(self, &across, graph, limits)
    }

    /// The seams between the patches of [`EdgeLoop::split`].
    #[must_use]
    pub fn seams(&self) -> Vec<Seam> {
        let count = self.edges.len();
        (0..count).map(|left| Seam { left, right: (left + 1) % count }).collect()
    }

    /// The edge `offset` places after edge `index`, around the loop.
    fn neighbour(&self, index: usize, offset: usize) -> Option<&Edge> {
        self.edges.get((index + offset).checked_rem(self.edges.len())?)
    }

    /// The tangents along the neighbours at both ends of edge `index`, into the hole.
    fn along_neighbours(&self, graph: &mut Graph, index: usize, limits: &Limits) -> Result<[Vector; 2], Diagnostic> {
        let count = self.edges.len();
        let mut ends = [[graph.integer(0); 3]; 2];
        // The edge before runs towards this one, so its slope points out of the hole.
        for (end, (offset, place, sign)) in ends.iter_mut().zip([(count - 1, 1, -1), (1, 0, 1)]) {
            let Some(edge) = self.neighbour(index, offset) else { continue };
            let along = slope(graph, edge.curve, Variable::U, limits, edge.origin)?;
            let place = graph.integer(place);
            let there = at(graph, along, Variable::U, place);
            *end = combination(graph, &[(Number::integer(sign), there)]);
        }
        Ok(ends)
    }

    /// The tangent across each edge, stated or made.
    fn tangents_across(&self, graph: &mut Graph, limits: &Limits) -> Result<Vec<Vector>, Diagnostic> {
        let zero = graph.integer(0);
        let u = graph.variable(Variable::U);
        let mut all = Vec::with_capacity(self.edges.len());
        for (index, edge) in self.edges.iter().enumerate() {
            let across = match edge.across {
                Some(across) => across,
                None => {
                    // With slopes of zero all twists vanish, and so agree.
                    let [start, end] = self.along_neighbours(graph, index, limits)?;
                    let still = |position| End { position, slope: [zero; 3] };
                    hermite(graph, u, still(start), still(end))
                }
            };
            all.push(across);
        }
        Ok(all)
    }

    /// Checks at instant `t` that each edge begins where the one before ends, and that stated tangents across the edges
    /// are those along their neighbours.
    ///
    /// # Errors
    /// [`Code::LoopOpen`] names the first corner that does not close, with its gap; [`Code::LoopFolded`] the first in which
    /// an edge runs back over the one before, or the edge that crosses another; [`Code::SidesDisagree`] the first whose tangents differ.
    pub fn check(&self, problem: &Problem, bindings: &Bindings, t: f64, limits: &Limits) -> Result<(), Diagnostic> {
        self.check_in(&mut problem.graph.clone(), bindings.as_slice(), t, limits)
    }

    /// As [`EdgeLoop::check`], with the graph of the problem, to which slopes are added.
    ///
    /// # Errors
    /// As [`EdgeLoop::check`].
    pub fn check_in(&self, graph: &mut Graph, params: &[f64], t: f64, limits: &Limits) -> Result<(), Diagnostic> {
        let count = self.edges.len();
        let value =
            |graph: &Graph, vector: Vector, u: f64| vector.map(|expr| graph.value(expr, params, [u, f64::NAN, t]));
        let corners: Vec<[f64; 3]> = self.edges.iter().map(|edge| value(graph, edge.curve, 0.0)).collect();
        let farthest = corners.iter().map(|corner| distance(*corner, corners.first().copied().unwrap_or_default()));
        let size = farthest.fold(0.0, f64::max);
        for (index, (edge, corner)) in self.edges.iter().zip(&corners).enumerate() {
            let Some(before) = self.neighbour(index, count - 1) else { continue };
            let gap = distance(value(graph, before.curve, 1.0), *corner);
            let (number, previous) = (index + 1, (index + count - 1) % count + 1);
            let is_closed = gap <= CLOSED * size;
            if !is_closed {
                let message = format!(
                    "the loop `{}` does not close in corner {number}: edge {previous} ends {gap:.1e} from where edge {number} begins",
                    self.name
                );
                return Err(Diagnostic::new(Code::LoopOpen, message)
                    .at(edge.origin)
                    .hint("edges follow one another around the loop, each as a function of u from 0 to 1"));
            }
        }
        for (index, edge) in self.edges.iter().enumerate() {
            let Some(before) = self.neighbour(index, count - 1) else { continue };
            let back = |u: f64| value(graph, before.curve, 1.0 - u);
            let on = |u: f64| value(graph, edge.curve, u);
            if runs_back(back, on, CLOSED * size) {
                let (number, previous) = (index + 1, (index + count - 1) % count + 1);
                let message = format!(
                    "the loop `{}` folds in corner {number}: edge {number} runs back over edge {previous}",
                    self.name
                );
                return Err(Diagnostic::new(Code::LoopFolded, message)
                    .at(edge.origin)
                    .hint("edges follow one another around a hole; between these two there is none"));
            }
        }
        self.check_crossings(&|edge: &Edge, u| value(graph, edge.curve, u), CLOSED * size)?;
        for (index, edge) in self.edges.iter().enumerate() {
            let Some(across) = edge.across else { continue };
            let expected = self.along_neighbours(graph, index, limits)?;
            for ((expected, u), end) in expected.into_iter().zip([0.0, 1.0]).zip(["beginning", "end"]) {
                let gap = distance(value(graph, across, u), value(graph, expected, u));
                let fits = gap <= CLOSED * size;
                if !fits {
                    let message = format!(
                        "the tangent across edge {} of the loop `{}` differs at its {end} by {gap:.1e} from the slope of the neighbouring edge",
                        index + 1,
                        self.name
                    );
                    let [x, y, z] = value(graph, expected, u).map(Shortest);
                    return Err(Diagnostic::new(Code::SidesDisagree, message)
                        .at(edge.origin)
                        .hint(format!("it must be [{x}, {y}, {z}] there, or leave it out")));
                }
            }
        }
        Ok(())
    }

    /// Refuses edges that cross: patches on both sides of a crossing would be turned against each other.
    fn check_crossings(&self, point: &dyn Fn(&Edge, f64) -> [f64; 3], close: f64) -> Result<(), Diagnostic> {
        let chains: Vec<_> = self.edges.iter().map(|edge| chain(&|u| point(edge, u))).collect();
        for (number, (edge, places)) in self.edges.iter().zip(&chains).enumerate() {
            // Neighbours meet in a corner; the last edge is one of the first.
            let last = self.edges.len() - usize::from(number == 0);
            for (other_number, (other, others)) in
                self.edges.iter().zip(&chains).enumerate().take(last).skip(number + 2)
            {
                if cross_over([&|u| point(edge, u), &|u| point(other, u)], [places, others], close) {
                    let (first, second) = (number + 1, other_number + 1);
                    let message = format!("edge {second} of the loop `{}` crosses edge {first}", self.name);
                    return Err(Diagnostic::new(Code::LoopFolded, message)
                        .at(other.origin)
                        .hint("write the edges in the order in which they follow one another around the hole"));
                }
            }
        }
        Ok(())
    }
}

/// Whether two curves with a common beginning lie on each other for half of the shorter one, whatever their speeds.
fn runs_back(a: impl Fn(f64) -> [f64; 3], b: impl Fn(f64) -> [f64; 3], close: f64) -> bool {
    let corner = a(0.0);
    // Most corners are seen at once: the directions there differ.
    let from_corner = |[x, y, z]: [f64; 3]| {
        let [x0, y0, z0] = corner;
        [x - x0, y - y0, z - z0]
    };
    let [from_a, from_b] = [a(0.1), b(0.1)].map(from_corner);
    let product: f64 = from_a.iter().zip(from_b).map(|(a, b)| a * b).sum();
    if product < 0.9 * distance(from_a, [0.0; 3]) * distance(from_b, [0.0; 3]) {
        return false;
    }
    let [end_a, end_b] = [a(1.0), b(1.0)];
    let [reach_a, reach_b] = [end_a, end_b].map(|end| distance(corner, end));
    // The place on the longer one as far from the corner as a place of the shorter one.
    let is_apart = |share: f64| {
        let (short, long): (Ray<'_>, Ray<'_>) = if reach_a <= reach_b { (&a, &b) } else { (&b, &a) };
        let point = short(share);
        let wanted = distance(corner, point);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if distance(corner, long(middle)) < wanted { low = middle } else { high = middle }
        }
        distance(point, long(high)) > close
    };
    let size = reach_a.max(reach_b);
    size > 0.0 && ![0.5, 0.25, 0.1].into_iter().any(is_apart)
}

/// An edge from its corner on.
type Ray<'a> = &'a dyn Fn(f64) -> [f64; 3];

/// A place along an edge to rounding.
const BISECTIONS: usize = 52;

/// The distance of two points; NaN if one is.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    libm::sqrt(a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum())
}
