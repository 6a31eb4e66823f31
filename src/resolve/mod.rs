//! The document to a [`Problem`]: names looked up, constraints counted, the equation brought to its terms.
//!
//! Input: a [`Document`]; output: a [`Problem`] that is complete and linear, or every fault of the document
//! that can be found at once. Nothing numerical is decided here except where boundaries lie.

mod application;
mod boundary;
mod copies;
mod curve;
mod declarations;
mod deformation;
mod edges;
mod equation;
mod form;
mod imported;
mod join;
mod loops;
mod lower;
mod morph;
mod net;
mod operator;
mod patch;
mod period;
mod prelude;
mod reading;
mod review;
mod scope;
mod seam;
mod surface;

pub use review::review;

use reading::Reading;
use scope::{Meaning, Scope};

use crate::diagnostic::{Code, Diagnostic, Diagnostics, Source};
use crate::expr::Graph;
use crate::limits::Limits;
use crate::problem::{Bindings, Problem};
use crate::syntax::ast::{Document, Name};
use crate::syntax::parse_expression;

/// Resolves a document into a problem; without patch blocks it has one patch, called `name`.
///
/// # Errors
/// Every fault that does not follow from another, in the order of the stages that find them. Cost: linear in the
/// size of the document.
pub fn resolve(document: &Document, name: &str, limits: &Limits) -> Result<Problem, Diagnostics> {
    let mut reading = Reading::new(&document.tree, Graph::new(), limits);
    reading.files = &document.files;
    let mut scope = Scope::new(&mut reading.graph, limits);
    prelude::provide(&document.tree, &mut scope, &mut reading);
    let definitions = document.shared.definitions.iter().map(|definition| &definition.name);
    let edges = document.edges.iter().map(|edge| &edge.name);
    scope.announce(document.parameters.iter().map(|param| &param.name).chain(definitions).chain(edges));
    let parameters = declarations::parameters(&document.parameters, &mut scope, &mut reading);
    declarations::definitions(&document.shared.definitions, &mut scope, &mut reading);
    edges::declare(&document.edges, &mut scope, &mut reading);
    let mut problem = Problem { parameters, ..Problem::default() };
    let (sections, domain) = patch::sections(document, name, &scope, &mut problem.parameters, &mut reading);
    problem.nets = net::resolve(document, &domain, &scope, &mut reading);
    // Positions are numbers only if every param has its value.
    let bindings = if reading.found.is_empty() {
        problem.graph = std::mem::take(&mut reading.graph);
        let bindings = Bindings::evaluate(&problem);
        reading.graph = std::mem::take(&mut problem.graph);
        reading.keep(bindings)
    } else {
        None
    };
    if let Some(bindings) = &bindings {
        for surface in std::mem::take(&mut reading.surfaces) {
            let ranges = surface.evaluate_ranges(&reading.graph, bindings);
            reading.keep(ranges);
            reading.surfaces.push(surface);
        }
    }
    for section in sections {
        problem.patches.extend(patch::resolve(section, bindings.as_ref(), &mut reading));
    }
    if let (Some(bindings), true) = (&bindings, reading.found.is_empty()) {
        let parts = (0..problem.patches.len() + problem.nets.len()).filter_map(|index| problem.part_name(index));
        let parts: Vec<String> = parts.map(str::to_owned).collect();
        problem.copies = copies::resolve(document, &problem.patches, &parts, &scope, bindings, &mut reading);
        let parts = seam::Parts { patches: &problem.patches, nets: &problem.nets, copies: &problem.copies };
        problem.seams = seam::seams(document, parts, &scope, bindings, &mut reading);
        problem.seams.extend(edges::seams(&problem.patches, bindings, &mut reading));
    }
    if reading.found.is_empty() {
        problem.morph = morph::request(&document.morphs, &problem.patches, &mut reading);
    }
    (problem.graph, problem.surfaces, problem.data) = (reading.graph, reading.surfaces, reading.data);
    if reading.found.is_empty() { Ok(problem) } else { Err(reading.found) }
}

/// Replaces the value of a parameter or coefficient by an expression in earlier ones (`--set NAME=EXPR`).
///
/// # Errors
/// [`Code::UnknownName`] if nothing settable is called `name`; otherwise as for the value of a `param`, with
/// places in `value`.
pub fn set_parameter(problem: &mut Problem, name: &str, value: &Source, limits: &Limits) -> Result<(), Diagnostics> {
    let canonical = crate::expr::canonical_name(name);
    let Some(index) = problem.parameters.iter().position(|parameter| parameter.name == canonical) else {
        let known: Vec<&str> = problem.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        return Err(vec![
            Diagnostic::new(Code::UnknownName, format!("no param or coefficient is called `{name}`"))
                .hint(format!("there are: {}", known.join(", "))),
        ]);
    };
    let (tree, expression) = parse_expression(value, limits)?;
    let mut scope = Scope::new(&mut problem.graph, limits);
    for earlier in problem.parameters.iter().take(index) {
        let meaning = Meaning::Parameter(problem.graph.symbol_node(earlier.symbol));
        let name = Name { text: earlier.name.clone(), span: earlier.origin.unwrap_or_default() };
        scope.declare(&name, meaning).map_err(|finding| vec![finding])?;
    }
    let mut reading = Reading::new(&tree, std::mem::take(&mut problem.graph), limits);
    let expr = reading.lowering(&scope).constant(expression, "the value of a param");
    let expr = reading.keep(expr);
    problem.graph = reading.graph;
    let (Some(parameter), Some(expr)) = (problem.parameters.get_mut(index), expr) else { return Err(reading.found) };
    parameter.value = expr;
    parameter.origin = None;
    parameter.is_overridden = true;
    Ok(())
}
