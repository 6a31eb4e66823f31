//! `at u = c:` and `at v = c:` blocks to boundary conditions, counted against the order of the equation.

use super::edges;
use super::form::components;
use super::join;
use super::lower::Lowering;
use super::reading::{Fault, Reading};
use super::scope::{Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Span};
use crate::expr::{ExprId, Variable};
use crate::numeric::CardinalPolynomials;
use crate::problem::{Bindings, BoundaryCondition, Join, SideCondition, describe};
use crate::syntax::ast::{Boundary, Constraint, Kind};

/// A condition that is still being collected.
struct Collected {
    position: f64,
    edge: ExprId,
    order: usize,
    value: [Option<(ExprId, Span)>; 3],
}

/// What the boundary blocks of a patch at values of one coordinate are judged by.
pub struct Frame<'a> {
    /// The coordinate, u or v.
    pub across: Variable,
    /// The order of the equation in it, if there is an equation.
    pub order: Option<usize>,
    /// The values of parameters and the range of the coordinate, if they are known.
    pub numbers: Option<(&'a Bindings, [f64; 2])>,
    /// The range of the other coordinate.
    pub along: [ExprId; 2],
    /// Where the patch is named.
    pub place: Option<Span>,
}

/// The conditions at values of u and the joins there; `None` if they are at fault or cannot be judged.
pub fn at_u(
    boundaries: &[Boundary],
    frame: &Frame<'_>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<(Vec<BoundaryCondition>, Vec<Join>)> {
    let (collected, joins) = resolve(boundaries, frame, scope, reading)?;
    let conditions = collected.into_iter().map(|condition| {
        let Collected { edge, order, .. } = condition;
        BoundaryCondition { u: edge, order, value: condition.value(), origins: condition.origins() }
    });
    Some((conditions.collect(), joins))
}

/// The conditions at values of v, none for a patch without; otherwise as [`at_u`].
pub fn at_v(
    boundaries: &[Boundary],
    frame: &Frame<'_>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<Vec<SideCondition>> {
    if !boundaries.iter().any(|boundary| boundary.variable.text == frame.across.name()) {
        return Some(Vec::new());
    }
    let (collected, _) = resolve(boundaries, frame, scope, reading)?;
    let conditions = collected.into_iter().map(|condition| {
        let Collected { edge, order, .. } = condition;
        SideCondition { v: edge, order, value: condition.value(), origins: condition.origins() }
    });
    Some(conditions.collect())
}

/// Reports boundaries at values of anything but u and v.
pub fn check_coordinates(boundaries: &[Boundary], reading: &mut Reading<'_>) {
    for Boundary { variable, .. } in boundaries {
        if ![Variable::U, Variable::V].iter().any(|known| known.name() == variable.text) {
            let message = format!("boundaries are at values of u or of v, not of `{}`", variable.text);
            let finding = Diagnostic::new(Code::UnexpectedText, message).at(variable.span);
            reading.report(finding.hint("u runs across the blend, from one trimline to the other; write `at u = 0:`"));
        }
    }
}

impl Collected {
    fn value(&self) -> [ExprId; 3] {
        self.value.map(|value| value.map_or(self.edge, |(expr, _)| expr))
    }

    fn origins(&self) -> [Option<Span>; 3] {
        self.value.map(|value| value.map(|(_, span)| span))
    }
}

/// Resolves the boundary blocks at values of the coordinate of `frame`.
fn resolve(
    boundaries: &[Boundary],
    frame: &Frame<'_>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<(Vec<Collected>, Vec<Join>)> {
    let found_before = reading.found.len();
    let across = frame.across;
    let mut collected: Vec<Collected> = Vec::new();
    let mut joins = Vec::new();
    let here = || boundaries.iter().filter(|boundary| boundary.variable.text == across.name());
    for boundary in here() {
        let edge = edge(boundary, frame, &mut reading.lowering(scope));
        let edge = reading.keep(edge).flatten();
        for constraint in &boundary.constraints.single {
            if reading.is_over {
                return None;
            }
            let stated = stated(constraint, frame, &mut reading.lowering(scope));
            if let (Some(stated), Some(edge)) = (reading.keep(stated), edge) {
                let added = add(stated, across, edge, &mut reading.lowering(scope), &mut collected);
                reading.keep(added);
                if across == Variable::U {
                    joins.extend(join::written_out(constraint, edge.0, &mut reading.lowering(scope)));
                }
            }
        }
        for join in &boundary.constraints.joins {
            if join.at.is_none() && reading.edge(&join.surface.text).is_some() {
                let (Some((place, position)), Some(order)) = (edge, frame.order) else { continue };
                for stated in edges::expand(join, place, frame, order, scope, reading).unwrap_or_default() {
                    let added = add(stated, across, (place, position), &mut reading.lowering(scope), &mut collected);
                    reading.keep(added);
                }
                continue;
            }
            if across != Variable::U {
                reading.report(
                    Diagnostic::new(Code::UnexpectedText, "a join stands at a value of u").at(join.span).hint(
                        "write the position and the tangent of the surface: `S = S1(u, 0, t), ∂S/∂v = ∂S1(u, 0, t)/∂v`",
                    ),
                );
                continue;
            }
            let (Some((u, position)), Some(order_in_u)) = (edge, frame.order) else { continue };
            let expanded = join::expand(join, u, order_in_u, &mut reading.lowering(scope));
            let Some((stated, join)) = reading.keep(expanded) else { continue };
            for stated in stated {
                let added = add(stated, across, (u, position), &mut reading.lowering(scope), &mut collected);
                reading.keep(added);
            }
            joins.push(join);
        }
    }
    let (Some(order), Some((_, range)), true) = (frame.order, frame.numbers, reading.found.len() == found_before)
    else {
        return None;
    };
    let apex = apex(boundaries, &collected, frame, scope, reading)?;
    collected.sort_by(|a, b| a.position.total_cmp(&b.position).then(a.order.cmp(&b.order)));
    let whole = here().next_back().map(|boundary| reading.tree.span(boundary.position)).or(frame.place);
    // The tangents at an apex follow from the sides that end there.
    let needed = if apex { order.saturating_sub(2) } else { order };
    let complete = check_complete(&collected, whole, across, needed, range);
    if let Err(findings) = complete {
        findings.into_iter().for_each(|finding| reading.report(finding));
        return None;
    }
    Some((collected, joins))
}

/// Whether a side is said to be a point; `None` if it cannot be one.
fn apex(
    boundaries: &[Boundary],
    collected: &[Collected],
    frame: &Frame<'_>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<bool> {
    let stated = |boundary: &&Boundary| !boundary.constraints.apexes.is_empty();
    let here = |boundary: &&Boundary| boundary.variable.text == frame.across.name();
    let mut all = boundaries.iter().filter(here).filter(stated);
    let Some(boundary) = all.next() else { return Some(false) };
    let place = boundary.constraints.apexes.first().copied();
    let found = edge(boundary, frame, &mut reading.lowering(scope));
    let position = reading.keep(found).flatten().map(|(_, position)| position)?;
    let end = frame.numbers.map(|(_, [_, high])| high);
    let refused = if frame.across != Variable::U || Some(position) != end {
        Some("an apex stands at the high end of u")
    } else if all.next().is_some() || boundary.constraints.apexes.len() > 1 {
        Some("the apex is stated twice")
    } else if collected.iter().any(|condition| condition.position == position) {
        Some("nothing else can be stated at an apex")
    } else {
        None
    };
    let Some(message) = refused else { return Some(true) };
    let finding = Diagnostic::new(Code::UnexpectedText, message).at(place);
    reading.report(finding.hint("the sides at both ends of v end in it; their last points and tangents make it"));
    None
}

/// The position of a boundary, symbolically and as a number; `None` where numbers are not known.
fn edge(boundary: &Boundary, frame: &Frame<'_>, lowering: &mut Lowering<'_>) -> Result<Option<(ExprId, f64)>, Fault> {
    let edge = lowering.constant(boundary.position, "the position of a boundary")?;
    let Some((bindings, range)) = frame.numbers else { return Ok(None) };
    let place = lowering.tree.span(boundary.position);
    let position = bindings.constant_in(lowering.graph, edge, Some(place), "the position of a boundary")?;
    if !(range[0]..=range[1]).contains(&position) {
        let ([low, high], name) = (range.map(Shortest), frame.across.name());
        let position = Shortest(position);
        let message = format!("{name} = {position} lies outside the domain {name} in [{low}, {high}]");
        return Err(Diagnostic::new(Code::DependentConstraints, message).at(place).into());
    }
    Ok(Some((edge, position)))
}

/// A constraint with its value: for each component the prescribed function, if there is one, and its place.
pub struct Stated {
    /// The order of the derivative across the boundary.
    pub order: usize,
    /// The prescribed function of each component.
    pub value: [Option<ExprId>; 3],
    /// Where each is written.
    pub places: [Span; 3],
    /// The whole statement.
    pub span: Span,
}

fn stated(constraint: &Constraint, frame: &Frame<'_>, lowering: &mut Lowering<'_>) -> Result<Stated, Fault> {
    let target = constraint.target;
    let order = target.derivative.order(frame.across);
    let name = frame.across.name();
    if order < target.derivative.u + target.derivative.v + target.derivative.t {
        let message = format!("a boundary constraint at fixed {name} is on S or its derivatives in {name}");
        return Err(Diagnostic::new(Code::UnexpectedText, message)
            .at(target.span)
            .hint("derivatives along the trimline follow from S there")
            .into());
    }
    if let Some(most) = frame.order.filter(|most| order >= *most) {
        let message =
            format!("an equation of order {most} in {name} takes no constraint on a derivative of order {order}");
        return Err(Diagnostic::new(Code::WrongConstraintCount, message).at(target.span).into());
    }
    let value = lowering.value(constraint.value)?;
    let place = lowering.tree.span(constraint.value);
    let wanted = match (target.component, value) {
        (None, Value::Scalar(expr)) if !lowering.graph.is_zero(expr) => {
            return Err(Diagnostic::new(Code::NotScalar, "S is a vector, so its constraint must be one")
                .at(place)
                .hint("write `[x, y, z]`, or constrain one component: `S_x = …`")
                .into());
        }
        (None, value) => components(value).map(Some),
        (Some(_), Value::Vector(_)) => {
            return Err(Diagnostic::new(Code::NotScalar, "a component of S is a number, not a vector")
                .at(place)
                .into());
        }
        (Some(component), Value::Scalar(expr)) => {
            let mut wanted = [None; 3];
            if let Some(slot) = wanted.get_mut(component) {
                *slot = Some(expr);
            }
            wanted
        }
    };
    // A vector that is written out has a place for each component.
    let places = match &lowering.tree.node(constraint.value).kind {
        Kind::Vector(parts) => match parts.as_slice() {
            [x, y, z] => [x, y, z].map(|part| lowering.tree.span(*part)),
            _ => [place; 3],
        },
        _ => [place; 3],
    };
    Ok(Stated { order, value: wanted, places, span: constraint.span })
}

/// Adds a constraint to the conditions at an edge, where `across` has the value `position`.
fn add(
    stated: Stated,
    across: Variable,
    (edge, position): (ExprId, f64),
    lowering: &mut Lowering<'_>,
    collected: &mut Vec<Collected>,
) -> Result<(), Diagnostic> {
    let Stated { order, value, places, span } = stated;
    for (expr, place) in value.into_iter().zip(places) {
        if let Some(expr) = expr
            && depends_on(expr, across, lowering)
        {
            return Err(not_boundary_data(expr, across, (edge, position), place, lowering));
        }
    }
    let index = collected.iter().position(|other| other.position == position && other.order == order);
    let index = index.unwrap_or_else(|| {
        collected.push(Collected { position, edge, order, value: [None; 3] });
        collected.len() - 1
    });
    let Some(condition) = collected.get_mut(index) else { return Ok(()) };
    for (component, ((slot, expr), place)) in condition.value.iter_mut().zip(value).zip(places).enumerate() {
        match (slot.as_ref(), expr) {
            (Some((_, first)), Some(_)) => {
                let what = describe(Some(component), order, across, position);
                return Err(Diagnostic::new(Code::DuplicateConstraint, format!("{what} is given twice"))
                    .at(span)
                    .label(*first, "first given here"));
            }
            (None, Some(expr)) => *slot = Some((expr, place)),
            (_, None) => {}
        }
    }
    Ok(())
}

fn depends_on(expr: ExprId, across: Variable, lowering: &Lowering<'_>) -> bool {
    let dependence = lowering.graph.dependence(expr);
    if across == Variable::U { dependence.u } else { dependence.v }
}

fn not_boundary_data(
    expr: ExprId,
    across: Variable,
    (edge, position): (ExprId, f64),
    place: Span,
    lowering: &mut Lowering<'_>,
) -> Diagnostic {
    use crate::expr::Notation;
    let variable = lowering.graph.variable(across);
    let (name, along) = if across == Variable::U { ("u", "v") } else { ("v", "u") };
    let replaced = lowering.graph.substitute(expr, &[(variable, edge)].into_iter().collect());
    let shown = |expr: ExprId, lowering: &Lowering<'_>| lowering.graph.text(expr, Notation::Ascii, 200).ok();
    let message = match shown(expr, lowering) {
        Some(text) => format!("`{text}` depends on `{name}`, so it is not boundary data"),
        None => format!("this depends on `{name}`, so it is not boundary data"),
    };
    let finding = Diagnostic::new(Code::NotBoundaryData, message)
        .at(place)
        .marked(format!("at the edge {name} = {position} only `{along}`, `t` and parameters may appear"));
    match shown(replaced, lowering) {
        Some(text) => finding.hint(format!("write the value it has there, `{text}`")),
        None => finding.hint("write the value it has there"),
    }
}

/// Checks that there are as many conditions as the order, complete in every component and independent.
fn check_complete(
    collected: &[Collected],
    whole: Option<Span>,
    across: Variable,
    order: usize,
    range: [f64; 2],
) -> Result<(), Diagnostics> {
    if collected.len() != order {
        let name = across.name();
        let stated: Vec<String> = collected.iter().map(|c| describe(None, c.order, across, c.position)).collect();
        let stated = if stated.is_empty() { "none".to_owned() } else { stated.join(", ") };
        let count = collected.len();
        let at = if across == Variable::U { "" } else { " at fixed v" };
        let message = format!(
            "an equation of order {order} in {name} needs {order} boundary constraints on S{at}, {count} are stated"
        );
        let mut finding =
            Diagnostic::new(Code::WrongConstraintCount, message).at(whole).hint(format!("stated: {stated}"));
        if let Some(missing) = usual(order, range)
            .into_iter()
            .find(|(position, order)| !collected.iter().any(|c| c.position == *position && c.order == *order))
            .filter(|_| count < order)
        {
            finding = finding.hint(format!(
                "missing, if both ends are to be joined alike: {}",
                describe(None, missing.1, across, missing.0)
            ));
        }
        return Err(vec![finding]);
    }
    let mut found = Diagnostics::new();
    for condition in collected {
        for (component, value) in condition.value.iter().enumerate() {
            if value.is_none() {
                let what = describe(Some(component), condition.order, across, condition.position);
                let sibling = condition.value.iter().flatten().map(|(_, span)| *span).next();
                let finding = Diagnostic::new(Code::MissingConstraint, format!("the constraint on {what} is missing"));
                found.push(finding.at(sibling.or(whole)).hint("every component needs one, `0` included"));
            }
        }
    }
    if !found.is_empty() {
        return Err(found);
    }
    let functionals: Vec<(f64, usize)> = collected.iter().map(|c| (c.position, c.order)).collect();
    if CardinalPolynomials::new(&functionals).is_none() {
        let finding = Diagnostic::new(Code::DependentConstraints, "these constraints do not determine a surface")
            .hint("constrain S itself at one position at least, and each derivative together with the ones below it");
        return Err(vec![finding.at(whole)]);
    }
    Ok(())
}

/// Position, tangent, … at both ends: what most problems state.
fn usual(order: usize, range: [f64; 2]) -> Vec<(f64, usize)> {
    (0..order.div_ceil(2)).flat_map(|each| range.map(|position| (position, each))).collect()
}
