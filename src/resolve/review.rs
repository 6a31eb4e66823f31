//! What is worth a second look in a document that is without fault.

use rustc_hash::FxHashSet;

use super::period;

use crate::diagnostic::{Code, Diagnostic, Diagnostics, MOST_FINDINGS};
use crate::problem::{Bindings, COMPONENTS, Problem};
use crate::syntax::ast::{DefinitionKind, Document, Name, NetSource, Statements};

/// Warnings about a document and the problem it resolved to, in source order: declarations that nothing uses,
/// trimlines that are a point, tangents without length, domains that miss the period of their data, and imported
/// surfaces that close but for a gap.
#[must_use]
pub fn review(document: &Document, problem: &Problem) -> Diagnostics {
    let mut found: Diagnostics = unused(document);
    found.extend(problem.surfaces.iter().flat_map(|surface| &surface.remarks).cloned());
    let bindings = Bindings::evaluate(problem).ok();
    for patch in &problem.patches {
        let missed = bindings.as_ref().and_then(|bindings| period::missed(problem, patch, bindings));
        // Patches may share their domain.
        found.extend(
            missed.filter(|missed| !found.iter().any(|other| other.code == missed.code && other.span == missed.span)),
        );
        let needs_tangents = patch.conditions.len() >= 4;
        for condition in &patch.conditions {
            let (message, marker) = match condition.order {
                0 => ("the trimline is zero", "it is a single point, the origin"),
                1 if needs_tangents => ("the tangent is zero", "this leaves the tangent plane at the trimline open"),
                _ => continue,
            };
            if condition.value.iter().all(|expr| problem.graph.is_zero(*expr)) {
                let finding =
                    Diagnostic::new(Code::DegenerateBoundary, message).at(condition.origins.first().copied().flatten());
                found.push(finding.marked(marker));
            }
        }
    }
    found.sort_by_key(|finding| finding.span);
    found.truncate(MOST_FINDINGS);
    found
}

/// Declarations whose names no expression, join or `with` mentions.
fn unused(document: &Document) -> Diagnostics {
    let sections = || std::iter::once(&document.shared).chain(document.patches.iter().map(|block| &block.statements));
    let boundaries = sections().flat_map(|statements: &Statements| &statements.boundaries);
    let joined = boundaries.flat_map(|boundary| &boundary.constraints.joins).map(|join| join.surface.text.as_str());
    let sampled = document.nets.iter().flat_map(|block| &block.nets).filter_map(|net| match &net.source {
        Some(NetSource::Surface { surface, .. }) => Some(surface.text.as_str()),
        _ => None,
    });
    let mut used: FxHashSet<&str> = document.tree.names().chain(joined).chain(sampled).collect();
    let stems: Vec<&str> = used
        .iter()
        .filter_map(|name| name.rsplit_once('_').filter(|(_, last)| COMPONENTS.contains(last)).map(|(stem, _)| stem))
        .collect();
    used.extend(stems);
    let unused = |what: &str, name: &Name| {
        let message = format!("the {what} `{}` is not used", name.text);
        let is_used = used.contains(name.text.as_str());
        (!is_used).then(|| Diagnostic::new(Code::UnusedDeclaration, message).at(name.span).hint("remove it, or use it"))
    };
    let params = document.parameters.iter().filter_map(|param| unused("param", &param.name));
    let of_nets = document.nets.iter().flat_map(|block| &block.definitions);
    let definitions = sections().flat_map(|statements| &statements.definitions).chain(of_nets);
    let definitions = definitions.filter_map(|definition| {
        let what = match definition.kind {
            DefinitionKind::Let => "definition",
            DefinitionKind::Surface(_) | DefinitionKind::Imported(_) => "surface",
            DefinitionKind::Curve => "curve",
        };
        unused(what, &definition.name)
    });
    let edges = document.edges.iter().filter_map(|edge| unused("edge", &edge.name));
    params.chain(definitions).chain(edges).collect()
}
