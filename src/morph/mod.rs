//! Morphs: the shapes between two shapes (González Castro, Ugail, Willis and Palmer 2006; docs/morphing.md).
//!
//! Two problems with the same patches, equations and positions of constraints become one problem with the parameter
//! [`EPSILON`]: `(1 - ε) g_source + ε g_target` stands at every boundary (M1). It is a problem as any other, so
//! every method solves it, and a frame is a value of a parameter. [`Sequence`] says which ε and how many Fourier
//! modes each frame has; [`WeightedSurface`] is a frame between two numbers of modes.
//!
//! Absent on purpose: solving. [`Blend`](crate::blend::Blend) solves an interpolated problem.

mod ends;
mod sequence;
mod step;

pub use crate::problem::MorphKind as Kind;
pub use ends::ends;
pub use sequence::{Frame, Sequence};
pub use step::{WeightedSurface, distance};

use rustc_hash::FxHashMap;

use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Graph, Number, Variable};
use crate::limits::Limits;
use crate::problem::{
    BoundaryCondition, Domain, Parameter, ParameterKind, Patch, PdeOperator, PdeTerm, Problem, RequestedSetting,
    SolveRequest,
};

/// The parameter of a morph, from 0 at the source to 1 at the target.
pub const EPSILON: &str = "epsilon";

/// The problem between two problems.
///
/// Its one parameter is [`EPSILON`], 1/2 at first; those of `source` and `target` stand in it with their values. Patches
/// correspond by name, or because there is one of each. Boundary data and forces are interpolated (M1); equations,
/// domains, and positions and orders of the constraints must be the same. Where both ask for a number of modes, the larger
/// is taken. Places in diagnostics are those of the source. Joins, surfaces and seams are left out.
///
/// # Errors
/// [`Code::ShapesDiffer`] for the first patch, range, equation, constraint or way to solve without a counterpart;
/// [`Code::LimitReached`] when both together are larger than one document may be.
pub fn interpolate(source: &Problem, target: &Problem, limits: &Limits) -> Result<Problem, Diagnostic> {
    let mut between = Between::new(source, target, limits);
    let mut patches = Vec::with_capacity(source.patches.len());
    for (from, to) in corresponding(source, target)? {
        patches.push(between.patch(from, to)?);
    }
    let mut graph = between.graph;
    let half = graph.number(Number::integer(2));
    let half = graph.inverse(half);
    let epsilon = Parameter {
        symbol: graph.symbol_id(EPSILON),
        name: EPSILON.to_owned(),
        value: half,
        interval: Some([graph.integer(0), graph.integer(1)]),
        kind: ParameterKind::Parameter,
        origin: None,
        is_overridden: false,
    };
    Ok(Problem { graph, parameters: vec![epsilon], patches, ..Problem::default() })
}

/// Each patch of the source with that of the target: by name, or the only ones.
fn corresponding<'a>(source: &'a Problem, target: &'a Problem) -> Result<Vec<(&'a Patch, &'a Patch)>, Diagnostic> {
    if let ([from], [to]) = (source.patches.as_slice(), target.patches.as_slice()) {
        return Ok(vec![(from, to)]);
    }
    let lonely = |name: &str, which: &str| {
        Diagnostic::new(Code::ShapesDiffer, format!("the {which} has no patch `{name}`"))
            .hint("source and target need patches of the same names, or one patch each")
    };
    let is_in = |problem: &Problem, name: &str| problem.patches.iter().any(|patch| patch.name == name);
    if let Some(patch) = target.patches.iter().find(|patch| !is_in(source, &patch.name)) {
        return Err(lonely(&patch.name, "source"));
    }
    let pair = |from: &'a Patch| {
        let to = target.patches.iter().find(|to| to.name == from.name);
        to.map(|to| (from, to)).ok_or_else(|| lonely(&from.name, "target"))
    };
    source.patches.iter().map(pair).collect()
}

/// A morph is between trimlines at fixed u.
fn refuse_sides_and_deformations(patch: &Patch) -> Result<(), Diagnostic> {
    let what = match (patch.is_four_sided(), patch.deformations.first()) {
        (true, _) => "constraints at fixed v",
        (false, Some(_)) => "deformations",
        (false, None) => return Ok(()),
    };
    let message = format!("patch `{}` has {what}, which a morph does not take", patch.name);
    Err(Diagnostic::new(Code::UnsupportedByMethod, message)
        .at(patch.boundary_origin())
        .hint("a morph is between shapes whose constraints are all at fixed u"))
}

/// A graph for both shapes. Equal expressions are one node there, so that comparing is comparing ids.
struct Between<'a> {
    graph: Graph,
    shapes: [Shape; 2],
    /// `1 - ε` and ε.
    weights: [ExprId; 2],
    limits: &'a Limits,
}

/// A shape's own graph, and what its expressions are between the shapes.
struct Shape {
    graph: Graph,
    known: FxHashMap<ExprId, ExprId>,
}

impl<'a> Between<'a> {
    fn new(source: &Problem, target: &Problem, limits: &'a Limits) -> Between<'a> {
        let mut graph = Graph::new();
        let shapes = [source, target].map(|problem| {
            let mut shape = Shape { graph: problem.graph.clone(), known: FxHashMap::default() };
            for parameter in &problem.parameters {
                let value = graph.import(&shape.graph, parameter.value, &mut shape.known);
                let symbol = shape.graph.symbol_node(parameter.symbol);
                shape.known.insert(symbol, value);
            }
            shape
        });
        let (one, epsilon) = (graph.integer(1), graph.symbol(EPSILON));
        let weights = [graph.difference(one, epsilon), epsilon];
        Between { graph, shapes, weights, limits }
    }

    fn patch(&mut self, from: &Patch, to: &Patch) -> Result<Patch, Diagnostic> {
        let name = &from.name;
        for patch in [from, to] {
            refuse_sides_and_deformations(patch)?;
        }
        let conditions = self.conditions(from, to)?;
        Ok(Patch {
            name: name.clone(),
            domain: self.domain(name, [&from.domain, &to.domain])?,
            operator: self.operator(name, [&from.operator, &to.operator])?,
            conditions,
            side_conditions: Vec::new(),
            is_of_loop: false,
            deformations: Vec::new(),
            joins: Vec::new(),
            solve: common_request(name, &from.solve, &to.solve)?,
        })
    }

    /// The same expression of both shapes here.
    fn both(&mut self, exprs: [ExprId; 2]) -> Result<[ExprId; 2], Diagnostic> {
        let [from, to] = exprs;
        let [source, target] = &mut self.shapes;
        let result = [
            self.graph.import(&source.graph, from, &mut source.known),
            self.graph.import(&target.graph, to, &mut target.known),
        ];
        if self.graph.size() > self.limits.graph_nodes {
            let limit = self.limits.graph_nodes;
            let message = format!("source and target together exceed the limit `graph-nodes` of {limit}");
            return Err(Diagnostic::new(Code::LimitReached, message));
        }
        Ok(result)
    }

    fn equal(&mut self, exprs: [ExprId; 2], differing: impl FnOnce() -> Diagnostic) -> Result<ExprId, Diagnostic> {
        let [from, to] = self.both(exprs)?;
        if from == to { Ok(from) } else { Err(differing()) }
    }

    /// `(1 - ε) from + ε to` (M1).
    fn interpolated(&mut self, exprs: [ExprId; 2]) -> Result<ExprId, Diagnostic> {
        let [from, to] = self.both(exprs)?;
        if from == to {
            return Ok(from);
        }
        let [before, after] = self.weights;
        let terms = [self.graph.product([before, from]), self.graph.product([after, to])];
        Ok(self.graph.sum(terms))
    }

    fn domain(&mut self, name: &str, [from, to]: [&Domain; 2]) -> Result<Domain, Diagnostic> {
        let mut domain = from.clone();
        for (((range, other), variable), origin) in
            domain.ends.iter_mut().zip(to.ends).zip(Variable::ALL).zip(from.origins)
        {
            for (end, other) in range.iter_mut().zip(other) {
                let variable = variable.name();
                *end = self.equal([*end, other], || {
                    differing(name, &format!("the ranges of {variable} differ"))
                        .at(origin)
                        .hint(format!("state the same `domain {variable} in [..]` in both"))
                })?;
            }
        }
        Ok(domain)
    }

    fn operator(&mut self, name: &str, [from, to]: [&PdeOperator; 2]) -> Result<PdeOperator, Diagnostic> {
        let unequal = || {
            differing(name, "the equations differ")
                .at(from.origin)
                .hint("state the same `pde` in both, with the same coefficients")
        };
        if from.terms.len() != to.terms.len() {
            return Err(unequal());
        }
        let mut terms = Vec::with_capacity(from.terms.len());
        for (term, other) in from.terms.iter().zip(&to.terms) {
            if term.derivative != other.derivative {
                return Err(unequal());
            }
            let mut coefficient = term.coefficient;
            for (factor, other) in coefficient.iter_mut().zip(other.coefficient) {
                *factor = self.equal([*factor, other], unequal)?;
            }
            terms.push(PdeTerm { derivative: term.derivative, coefficient });
        }
        let mut force = from.force;
        for (component, other) in force.iter_mut().zip(to.force) {
            *component = self.interpolated([*component, other])?;
        }
        Ok(PdeOperator { terms, force, origin: from.origin })
    }

    fn conditions(&mut self, from: &Patch, to: &Patch) -> Result<Vec<BoundaryCondition>, Diagnostic> {
        let unequal = |index: usize| {
            let origin =
                from.conditions.get(index).and_then(|condition| condition.origins.into_iter().flatten().next());
            differing(&from.name, &format!("constraint number {} differs in its u or in its order", index + 1))
                .at(origin)
                .hint("state positions and derivatives at the same u in both")
        };
        if from.conditions.len() != to.conditions.len() {
            return Err(unequal(from.conditions.len().min(to.conditions.len())));
        }
        let mut conditions = Vec::with_capacity(from.conditions.len());
        for (index, (condition, other)) in from.conditions.iter().zip(&to.conditions).enumerate() {
            if condition.order != other.order {
                return Err(unequal(index));
            }
            let u = self.equal([condition.u, other.u], || unequal(index))?;
            let mut value = condition.value;
            for (component, other) in value.iter_mut().zip(other.value) {
                *component = self.interpolated([*component, other])?;
            }
            conditions.push(BoundaryCondition { u, value, ..condition.clone() });
        }
        Ok(conditions)
    }
}

fn differing(patch: &str, what: &str) -> Diagnostic {
    Diagnostic::new(Code::ShapesDiffer, format!("patch `{patch}`: {what} between source and target"))
}

/// What both ask for, and the larger of two numbers of modes.
fn common_request(patch: &str, from: &SolveRequest, to: &SolveRequest) -> Result<SolveRequest, Diagnostic> {
    let unequal = || {
        differing(patch, "the ways to solve differ")
            .at(from.origin)
            .hint("state the same `solve` in both; only the number of modes may differ")
    };
    let stated = |request: &SolveRequest| -> Vec<(String, String)> {
        let mut stated: Vec<(String, String)> = request
            .settings
            .iter()
            .filter(|setting| setting.key != "modes")
            .map(|setting| (setting.key.clone(), setting.value.clone()))
            .collect();
        stated.sort();
        stated
    };
    let modes = |request: &SolveRequest| request.settings.iter().find(|setting| setting.key == "modes").cloned();
    if from.method != to.method || stated(from) != stated(to) {
        return Err(unequal());
    }
    let number = |setting: &RequestedSetting| setting.value.parse::<usize>().unwrap_or(0);
    let mut request = from.clone();
    match (modes(from), modes(to)) {
        (None, None) => {}
        (Some(first), Some(second)) => {
            let larger = if number(&second) > number(&first) { second.value } else { first.value };
            let modes = request.settings.iter_mut().filter(|setting| setting.key == "modes");
            modes.for_each(|setting| setting.value.clone_from(&larger));
        }
        _ => return Err(unequal()),
    }
    Ok(request)
}
