//! `nsided` blocks to the patches that fill a loop of edges.

use super::edges::EdgeUse;
use super::patch::Section;
use super::reading::Reading;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Variable};
use crate::multisided::{Edge, EdgeLoop};
use crate::problem::{Bindings, Patch};
use crate::syntax::ast::{Kind, LoopEdge};

/// The patches of a loop, or `None` if anything about it is at fault. Without `bindings` nobody knows whether it closes.
pub fn resolve(section: Section<'_>, bindings: Option<&Bindings>, reading: &mut Reading<'_>) -> Option<Vec<Patch>> {
    let found_before = reading.found.len();
    let Section { name, place, statements, scope, domain, operator, solve, .. } = section;
    let misplaced = statements
        .boundaries
        .first()
        .map(|boundary| ("the sides of a loop are its edges", boundary.variable.span))
        .or(statements.deformations.first().map(|one| ("a loop has no deformations", one.span)))
        .or(statements.ranges.iter().find(|range| range.variable.text != Variable::T.name()).map(|range| {
            ("u and v go from 0 to 1 in every patch of a loop, so their ranges cannot be stated", range.variable.span)
        }))
        .or(statements.centres.get(1).map(|centre| ("the centre is stated twice", reading.tree.span(*centre))));
    if let Some((message, place)) = misplaced {
        reading.report(Diagnostic::new(Code::UnexpectedText, message).at(place));
    }
    let centre = match statements.centres.first() {
        None => None,
        Some(centre) => {
            let value = reading.lowering(&scope).vector(*centre);
            Some((reading.keep(value)?, reading.tree.span(*centre)))
        }
    };
    let centre_moves_along = centre.filter(|(value, _)| value.iter().any(|expr| is_along(*expr, reading)));
    if let Some((_, place)) = centre_moves_along {
        reading.report(Diagnostic::new(Code::NotConstant, "the centre must not depend on u or v").at(place));
    }
    let mut edges = Vec::with_capacity(statements.loop_edges.len());
    let mut declared = Vec::with_capacity(statements.loop_edges.len());
    for stated in &statements.loop_edges {
        if reading.is_over {
            return None;
        }
        let (edge, name) = edge(stated, &scope, reading)?;
        edges.push(edge);
        declared.push(name);
    }
    let count = edges.len();
    let edge_loop = EdgeLoop {
        name,
        edges,
        centre: centre.map(|(value, _)| value),
        operator: operator?,
        time: domain.ends[2],
        solve,
    };
    let split = edge_loop.split(&mut reading.graph, reading.limits);
    let patches =
        reading.keep(split.map_err(|finding| if finding.span.is_none() { finding.at(place) } else { finding }))?;
    if let Some(bindings) = bindings {
        let range = domain.evaluate_in(&reading.graph, bindings);
        let [start, end] = reading.keep(range)?.t;
        for t in [start, 0.5 * (start + end), end] {
            let closed = edge_loop.check_in(&mut reading.graph, bindings.as_slice(), t, reading.limits);
            reading.keep(closed)?;
        }
    }
    let graph = &mut reading.graph;
    let low = graph.integer(0);
    for (index, (declared, stated)) in declared.into_iter().zip(&statements.loop_edges).enumerate() {
        let Some(edge) = declared else { continue };
        let halves = if stated.is_reversed { [[1.0, 0.5], [0.0, 0.5]] } else { [[0.0, 0.5], [1.0, 0.5]] };
        let sides = [(index, Variable::V), ((index + 1) % count, Variable::U)];
        for ((patch, across), of_edge) in sides.into_iter().zip(halves) {
            let Some(patch) = patches.get(patch).map(|patch| patch.name.clone()) else { continue };
            reading.edge_uses.push(EdgeUse { edge, patch, across, position: low, of_edge, origin: stated.span });
        }
    }
    (reading.found.len() == found_before).then_some(patches)
}

/// An edge of a loop and, if it is declared, its place among the declared ones.
fn edge(
    stated: &LoopEdge,
    scope: &super::scope::Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<(Edge, Option<usize>)> {
    let declared = match &reading.tree.node(stated.curve).kind {
        Kind::Name(name) => reading.edge(&name.text).map(|(index, edge)| (index, edge.across)),
        _ => None,
    };
    let curve = reading.lowering(scope).vector(stated.curve);
    let mut curve = reading.keep(curve)?;
    let mut across = match stated.across {
        None => declared.and_then(|(_, across)| across),
        Some(across) => {
            let across = reading.lowering(scope).vector(across);
            Some(reading.keep(across)?)
        }
    };
    let depends_on_v = |expr: &ExprId| reading.graph.dependence(*expr).v;
    if curve.iter().chain(across.iter().flatten()).any(depends_on_v) {
        let finding = Diagnostic::new(Code::NotBoundaryData, "an edge depends on `v`, and it is a curve in `u`");
        reading.report(finding.at(stated.span).hint("u goes from 0 to 1 along each edge"));
        return None;
    }
    if stated.is_reversed {
        let graph = &mut reading.graph;
        let (u, one) = (graph.variable(Variable::U), graph.integer(1));
        let back = [(u, graph.difference(one, u))].into_iter().collect();
        curve = curve.map(|expr| graph.substitute(expr, &back));
        across = across.map(|across| across.map(|expr| graph.substitute(expr, &back)));
    }
    Some((Edge { curve, across, origin: Some(stated.span) }, declared.map(|(index, _)| index)))
}

fn is_along(expr: ExprId, reading: &Reading<'_>) -> bool {
    let dependence = reading.graph.dependence(expr);
    dependence.u || dependence.v
}
