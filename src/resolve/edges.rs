//! Declared edges, the sides of patches that lie on them, and whether those fit together.

use rustc_hash::FxHashMap;

use super::boundary::{Frame, Stated};
use super::reading::Reading;
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Variable};
use crate::problem::{Bindings, Patch, Seam, SeamEdge, SidePart};
use crate::syntax::ast::{Edge, Join};

/// What a declared edge is.
#[derive(Debug, Clone)]
pub struct EdgeMeaning {
    /// What the user calls it.
    pub name: String,
    /// x, y and z, functions of u from 0 to 1 and of t.
    pub curve: [ExprId; 3],
    /// The tangent across it, likewise.
    pub across: Option<[ExprId; 3]>,
    /// Whether patches go on smoothly across it.
    pub is_smooth: bool,
    /// Where it is named.
    pub origin: Span,
}

/// A side of a patch, or a part of one, that lies on a declared edge.
#[derive(Debug, Clone)]
pub struct EdgeUse {
    /// The edge's place among those declared.
    pub edge: usize,
    /// The patch; empty until it is known.
    pub patch: String,
    /// The coordinate that is fixed on the side.
    pub across: Variable,
    /// Its value there.
    pub position: ExprId,
    /// Where the part of the edge begins and ends, as shares of the edge in the direction in which the side runs.
    pub of_edge: [f64; 2],
    /// Where the use is written.
    pub origin: Span,
}

/// Places along an edge at which its two sides are compared: none at the ends, where tangents may vanish.
const PLACES: usize = 7;
/// Degrees between tangent planes that are still one: far above rounding, far below what can be seen.
const SMOOTH: f64 = 1e-6;

/// Declares the edges of a document.
pub fn declare(edges: &[Edge], scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    for edge in edges {
        if reading.is_over {
            return;
        }
        let curve = reading.lowering(scope).vector(edge.curve);
        let curve = reading.keep(curve);
        let across = edge.across.map(|across| {
            let across = reading.lowering(scope).vector(across);
            reading.keep(across)
        });
        let is_smooth = match edge.continuity.as_ref().map(|name| name.text.as_str()) {
            None | Some("C1") => Some(true),
            Some("C0") => Some(false),
            Some(other) => {
                let message = format!("an edge keeps C0 or C1, not `{other}`");
                let place = edge.continuity.as_ref().map(|name| name.span);
                reading.report(Diagnostic::new(Code::UnexpectedText, message).at(place));
                None
            }
        };
        let vectors = curve.into_iter().chain(across.flatten());
        let along_v = vectors.flatten().any(|expr| reading.graph.dependence(expr).v);
        if along_v {
            let finding = Diagnostic::new(Code::NotBoundaryData, "an edge depends on `v`, and it is a curve in `u`");
            reading.report(finding.at(edge.span).hint("u goes from 0 to 1 along an edge, whatever side it becomes"));
        }
        let is_whole = across.is_none_or(|across| across.is_some()) && !along_v;
        let meaning = match (curve, is_smooth, is_whole) {
            (Some(curve), Some(is_smooth), true) => {
                let across = across.flatten();
                let name = edge.name.text.clone();
                reading.edges.push(EdgeMeaning { name, curve, across, is_smooth, origin: edge.name.span });
                Meaning::Value(Value::Vector(curve))
            }
            _ => Meaning::Faulty,
        };
        let declared = scope.declare(&edge.name, meaning);
        reading.keep(declared);
    }
}

/// The constraints that `join EDGE` stands for on the side of `frame` at `position`; `None` if it is at fault.
pub fn expand(
    join: &Join,
    position: ExprId,
    frame: &Frame<'_>,
    order: usize,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<Vec<Stated>> {
    let (index, edge) = reading.edge(&join.surface.text).map(|(index, edge)| (index, edge.clone()))?;
    let strength = match join.strength {
        Some(strength) => {
            let strength = reading.lowering(scope).scalar(strength);
            reading.keep(strength)?
        }
        None => reading.graph.integer(1),
    };
    let graph = &mut reading.graph;
    let factor = if join.is_flipped { graph.neg(strength) } else { strength };
    // The edge's u as a function of the coordinate along the side.
    let along = if frame.across == Variable::U { Variable::V } else { Variable::U };
    let [low, high] = frame.along;
    let (start, end) = if join.is_reversed { (high, low) } else { (low, high) };
    let at = graph.variable(along);
    let (from, length) = (graph.difference(at, start), graph.difference(end, start));
    let share = graph.quotient(from, length);
    let replacements: FxHashMap<ExprId, ExprId> = [(graph.variable(Variable::U), share)].into_iter().collect();
    let mut place = |vector: [ExprId; 3], factor: Option<ExprId>| {
        vector.map(|expr| {
            let value = graph.substitute(expr, &replacements);
            Some(factor.map_or(value, |factor| graph.product([factor, value])))
        })
    };
    let places = [join.span; 3];
    let mut stated = vec![Stated { order: 0, value: place(edge.curve, None), places, span: join.span }];
    if let Some(across) = edge.across.filter(|_| order >= 4) {
        stated.push(Stated { order: 1, value: place(across, Some(factor)), places, span: join.span });
    }
    reading.edge_uses.push(EdgeUse {
        edge: index,
        patch: String::new(),
        across: frame.across,
        position,
        of_edge: if join.is_reversed { [1.0, 0.0] } else { [0.0, 1.0] },
        origin: join.span,
    });
    Some(stated)
}

/// Says which patch the last uses belong to.
pub fn name_uses(patch: &str, reading: &mut Reading<'_>) {
    for use_of in reading.edge_uses.iter_mut().filter(|use_of| use_of.patch.is_empty()) {
        patch.clone_into(&mut use_of.patch);
    }
}

/// The seams along declared edges; refuses sides of one smooth edge whose tangent planes differ.
pub fn seams(patches: &[Patch], bindings: &Bindings, reading: &mut Reading<'_>) -> Vec<Seam> {
    let mut seams = Vec::new();
    let uses = std::mem::take(&mut reading.edge_uses);
    for (index, first) in uses.iter().enumerate() {
        let others = uses.iter().skip(index + 1).filter(|second| second.edge == first.edge);
        for second in others {
            let Some(part) = common(first.of_edge, second.of_edge) else { continue };
            let Some(edge) = reading.edges.get(first.edge).cloned() else { continue };
            let mut sides = Vec::with_capacity(2);
            for side in [first, second] {
                let Some(patch) = patches.iter().position(|patch| patch.name == side.patch) else { continue };
                let of_side = part.map(|share| (share - side.of_edge[0]) / (side.of_edge[1] - side.of_edge[0]));
                let part = SidePart::Shares(of_side);
                sides.push(SeamEdge { patch, across: side.across, position: side.position, part });
            }
            let Ok([a, b]) = <[SeamEdge; 2]>::try_from(sides) else { continue };
            if edge.is_smooth {
                let found = compare(&edge, part, [a, b], patches, bindings, reading);
                if let Some((angle, names)) = found {
                    let [one, other] = names;
                    let message = format!(
                        "the two sides of the edge `{}` differ: the tangent planes of `{one}` and `{other}` are {angle:.2} degrees apart",
                        edge.name
                    );
                    reading.report(
                        Diagnostic::new(Code::EdgeSidesDiffer, message)
                            .at(edge.origin)
                            .label(first.origin, "one side")
                            .label(second.origin, "the other side")
                            .hint("state the tangent once, `across = …`, or write `keeping C0` behind the edge for a crease"),
                    );
                    continue;
                }
            }
            seams.push(Seam { edges: [a, b], is_smooth: edge.is_smooth, origin: Some(edge.origin) });
        }
    }
    seams
}

/// The part of an edge that two uses have in common, in the direction of the edge.
fn common(a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let [low, high] = [a, b]
        .map(|[start, end]| [start.min(end), start.max(end)])
        .into_iter()
        .reduce(|[a, b], [c, d]| [a.max(c), b.min(d)])?;
    (low < high).then_some([low, high])
}

/// The largest angle, in degrees, between the tangent planes that two sides of an edge state, if they differ.
fn compare(
    edge: &EdgeMeaning,
    [start, end]: [f64; 2],
    sides: [SeamEdge; 2],
    patches: &[Patch],
    bindings: &Bindings,
    reading: &mut Reading<'_>,
) -> Option<(f64, [String; 2])> {
    let limit = reading.limits.graph_nodes;
    let mut along = edge.curve;
    for component in &mut along {
        // An edge without a slope is refused where a method needs it.
        *component = reading.graph.derivative_within(*component, Derivative::new(1, 0, 0), limit).ok()?;
    }
    let names = sides.map(|side| patches.get(side.patch).map(|patch| patch.name.clone()).unwrap_or_default());
    let graph = &reading.graph;
    let params = bindings.as_slice();
    let [a, b] = sides.map(|side| patches.get(side.patch));
    let (domain_a, domain_b) =
        (a?.domain.evaluate_in(graph, bindings).ok()?, b?.domain.evaluate_in(graph, bindings).ok()?);
    let [first, last] = domain_a.t;
    let mut worst = 0.0_f64;
    for t in [first, 0.5 * (first + last), last] {
        for place in 0..PLACES {
            let share = (place as f64 + 0.5) / PLACES as f64;
            let at_edge = start + (end - start) * share;
            let slope = along.map(|expr| graph.value(expr, params, [at_edge, f64::NAN, t]));
            let mut normals = Vec::with_capacity(2);
            for (side, patch, domain) in [(&sides[0], a?, &domain_a), (&sides[1], b?, &domain_b)] {
                let tangent = tangent_of(patch, side)?;
                let range = if side.across == Variable::U { domain.v } else { domain.u };
                let SidePart::Shares([begin, end]) = side.part else { return None };
                let at = range[0] + (range[1] - range[0]) * (begin + (end - begin) * share);
                let tangent = tangent.map(|expr| graph.value(expr, params, [at, at, t]));
                normals.push(cross(slope, tangent));
            }
            let [p, q] = <[[f64; 3]; 2]>::try_from(normals).ok()?;
            let sine = length(cross(p, q));
            let cosine: f64 = p.iter().zip(q).map(|(p, q)| p * q).sum();
            worst = worst.max(libm::atan2(sine, cosine.abs()).to_degrees());
        }
    }
    (worst > SMOOTH).then_some((worst, names))
}

/// The tangent across a side that a patch states.
fn tangent_of(patch: &Patch, side: &SeamEdge) -> Option<[ExprId; 3]> {
    if side.across == Variable::U {
        return patch.conditions.iter().find(|c| c.u == side.position && c.order == 1).map(|c| c.value);
    }
    patch.side_conditions.iter().find(|c| c.v == side.position && c.order == 1).map(|c| c.value)
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn length(a: [f64; 3]) -> f64 {
    libm::sqrt(a.iter().map(|x| x * x).sum())
}
