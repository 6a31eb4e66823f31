//! `mirror` and `repeat` to copies of patches.

use super::lower::Lowering;
use super::reading::{Fault, Reading};
use super::scope::Scope;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Graph, Number};
use crate::problem::{Bindings, COMPONENTS, Patch, PatchCopy, Placement};
use crate::syntax::ast::{self, Copies, Document, Motion, Name};

/// Places on each side at which a copy is compared with its original: a multiple of four, so that the grid of a closed
/// curve is its own image in the usual planes.
const PLACES: usize = 48;
/// Of the size of a patch: sides nearer than this are the same.
const SAME: f64 = 1e-9;
/// Between unit tangents that are the same.
const ALIKE: f64 = 1e-6;

/// The copies that a document states of `patches`; `parts` are the names of all that can be copied.
pub fn resolve(
    document: &Document,
    patches: &[Patch],
    parts: &[String],
    scope: &Scope<'_>,
    bindings: &Bindings,
    reading: &mut Reading<'_>,
) -> Vec<PatchCopy> {
    let mut copies: Vec<PatchCopy> = Vec::new();
    for statement in &document.copies {
        if reading.is_over {
            break;
        }
        let placements = placements(statement, &mut reading.lowering(scope));
        let Some(placements) = reading.keep(placements) else { continue };
        for name in &statement.patches {
            let sources = sources(name, parts, &copies, &mut reading.graph);
            if sources.is_empty() {
                let known: Vec<&str> = parts.iter().map(String::as_str).collect();
                let finding = Diagnostic::new(Code::UnknownName, format!("there is no patch `{}`", name.text));
                reading.report(finding.at(name.span).hint(format!("patches: {}", known.join(", "))));
                continue;
            }
            for (called, original, before) in sources {
                for (suffix, placement) in &placements {
                    let placement = placement.after(&mut reading.graph, &before);
                    let copy =
                        PatchCopy { name: renamed(&called, suffix), original, placement, origin: Some(statement.span) };
                    add(copy, statement, (patches, parts), bindings, &mut copies, reading);
                }
            }
        }
    }
    copies
}

/// Adds a copy unless its name is taken, it lies where its original does, or there are too many.
fn add(
    copy: PatchCopy,
    statement: &Copies,
    (patches, parts): (&[Patch], &[String]),
    bindings: &Bindings,
    copies: &mut Vec<PatchCopy>,
    reading: &mut Reading<'_>,
) {
    let limit = reading.limits.patches;
    let refuse = |code, message: String| Diagnostic::new(code, message).at(statement.span);
    if parts.len() + copies.len() >= limit {
        reading.report(refuse(Code::LimitReached, format!("more patches than the limit `patches` of {limit}")));
        return;
    }
    if parts.contains(&copy.name) || copies.iter().any(|other| other.name == copy.name) {
        let message = format!("two patches are called `{}`", copy.name);
        let finding = refuse(Code::DuplicateName, message);
        reading.report(finding.hint("copies are named after their original: `NAME2`, `NAME3`, … and `NAME_mirrored`"));
        return;
    }
    let own = patches.get(copy.original);
    if own.is_some_and(|patch| lies_on_itself(patch, &copy.placement, bindings, &reading.graph)) {
        let message = format!("the copy `{}` lies where `{}` does", copy.name, own.map_or("", |patch| &patch.name));
        reading.report(refuse(Code::CopyOntoItself, message).hint(match statement.motion {
            Motion::Mirrored(..) => "a patch that is symmetric to the plane needs no mirror image: state it once",
            _ => "the number counts all of them, the original included",
        }));
        return;
    }
    copies.push(copy);
}

/// What `name` stands for: the name, place and placement of each patch or earlier copy of that name, or of those of a
/// loop of that name.
fn sources(name: &Name, parts: &[String], copies: &[PatchCopy], graph: &mut Graph) -> Vec<(String, usize, Placement)> {
    let is_meant = |full: &str| full.split('.').next() == Some(name.text.as_str());
    let identity = Placement::identity(graph);
    let originals = parts.iter().enumerate().filter(|(_, full)| is_meant(full));
    let originals = originals.map(|(index, full)| (full.clone(), index, identity));
    let copies = copies.iter().filter(|copy| is_meant(&copy.name));
    originals.chain(copies.map(|copy| (copy.name.clone(), copy.original, copy.placement))).collect()
}

/// `wing` as `wing2`; `hole.3`, a patch of a loop, as `hole2.3`.
fn renamed(name: &str, suffix: &str) -> String {
    match name.split_once('.') {
        Some((stem, number)) => format!("{stem}{suffix}.{number}"),
        None => format!("{name}{suffix}"),
    }
}

/// Where the copies of a statement are, and what is added to their names.
fn placements(statement: &Copies, lowering: &mut Lowering<'_>) -> Result<Vec<(String, Placement)>, Fault> {
    let count = match statement.motion {
        Motion::Mirrored(..) => 2,
        Motion::Rotated(count, ..) | Motion::Moved(count, ..) => count,
    };
    if count < 2 || count > lowering.limits.patches {
        let (limit, span) = (lowering.limits.patches, statement.span);
        return Err(if count < 2 {
            let message = format!("a patch that is repeated {count} times in all has no copy");
            Diagnostic::new(Code::SettingOutOfRange, message).at(span).hint("2 or more make copies")
        } else {
            Diagnostic::new(Code::LimitReached, format!("more patches than the limit `patches` of {limit}")).at(span)
        }
        .into());
    }
    let mut all = Vec::with_capacity(count - 1);
    match &statement.motion {
        Motion::Mirrored(axis, at) => {
            let index = component(axis, "a plane is where x, y or z has a value", "write `mirror NAME in y = 0`")?;
            let at = lowering.constant(*at, "the position of a plane")?;
            all.push(("_mirrored".to_owned(), Placement::mirrored(lowering.graph, index, at)));
        }
        Motion::Rotated(_, axis, angle) => {
            let index = component(axis, "copies turn about x, y or z", "write `rotated about z by π/2`")?;
            let angle = still(*angle, lowering.scalar(*angle)?, lowering)?;
            for number in 1..count {
                let angle = times(number, angle, lowering.graph);
                all.push((format!("{}", number + 1), Placement::rotated(lowering.graph, index, angle)));
            }
        }
        Motion::Moved(_, by) => {
            let vector = lowering.vector(*by)?;
            for expr in vector {
                still(*by, expr, lowering)?;
            }
            for number in 1..count {
                let by = vector.map(|expr| times(number, expr, lowering.graph));
                all.push((format!("{}", number + 1), Placement::moved(lowering.graph, by)));
            }
        }
    }
    Ok(all)
}

fn times(number: usize, expr: ExprId, graph: &mut Graph) -> ExprId {
    graph.scale(Number::integer(i64::try_from(number).unwrap_or(i64::MAX)), expr)
}

fn component(axis: &Name, message: &str, hint: &str) -> Result<usize, Diagnostic> {
    COMPONENTS.iter().position(|name| *name == axis.text).ok_or_else(|| {
        Diagnostic::new(Code::UnexpectedText, format!("{message}, not `{}`", axis.text)).at(axis.span).hint(hint)
    })
}

/// Refuses what would bend a copy.
fn still(expression: ast::Expression, expr: ExprId, lowering: &Lowering<'_>) -> Result<ExprId, Diagnostic> {
    let dependence = lowering.graph.dependence(expr);
    if dependence.u || dependence.v {
        let message = "where a copy is must not depend on u or v";
        return Err(Diagnostic::new(Code::NotConstant, message).at(lowering.tree.span(expression)));
    }
    Ok(expr)
}

/// Whether a copy has the boundary of its original, at all of three instants: its image of every side is a side, and
/// tangents go where tangents are.
fn lies_on_itself(patch: &Patch, placement: &Placement, bindings: &Bindings, graph: &Graph) -> bool {
    let Ok(domain) = patch.domain.evaluate_in(graph, bindings) else { return false };
    let params = bindings.as_slice();
    let [start, end] = domain.t;
    [start, 0.5 * (start + end), end].iter().all(|t| {
        let matrix = placement.entries().map(|entry| graph.value(entry, params, [0.0, 0.0, *t]));
        let mut original: Vec<([f64; 3], [f64; 3])> = Vec::new();
        let at_u = patch.conditions.iter().map(|c| (c.u, c.order, c.value, domain.v, domain.u));
        let at_v = patch.side_conditions.iter().map(|c| (c.v, c.order, c.value, domain.u, domain.v));
        let sides: Vec<_> = at_u.chain(at_v).collect();
        for (position, _, value, [low, high], [first, _]) in sides.iter().filter(|side| side.1 == 0) {
            let tangent = sides.iter().find(|side| side.0 == *position && side.1 == 1 && side.3 == [*low, *high]);
            let is_first = graph.value(*position, params, [f64::NAN; 3]) == *first;
            for place in 0..PLACES {
                let at = low + (high - low) * place as f64 / PLACES as f64;
                let of = |vector: [ExprId; 3]| vector.map(|expr| graph.value(expr, params, [at, at, *t]));
                let inward = tangent.map_or([0.0; 3], |side| of(side.2));
                original.push((of(*value), if is_first { inward } else { inward.map(|x| -x) }));
            }
        }
        let size = original.iter().flat_map(|(point, _)| point).fold(0.0_f64, |most, x| most.max(x.abs()));
        original.iter().all(|(point, inward)| {
            let (image, turned) = (mapped(&matrix, *point, true), mapped(&matrix, *inward, false));
            let length = norm(turned);
            original.iter().any(|(other, theirs)| {
                let is_same = norm(difference(image, *other)) <= SAME * size;
                let sizes = (length, norm(*theirs));
                let unit = |vector: [f64; 3], length: f64| vector.map(|x| if length > 0.0 { x / length } else { 0.0 });
                is_same && norm(difference(unit(turned, sizes.0), unit(*theirs, sizes.1))) <= ALIKE
            })
        })
    })
}

fn mapped(matrix: &[f64; 12], vector: [f64; 3], is_point: bool) -> [f64; 3] {
    let [a, b, c, d, e, f, g, h, i, x, y, z] = *matrix;
    let row = |row: [f64; 3], offset: f64| {
        let sum: f64 = row.iter().zip(vector).map(|(entry, x)| entry * x).sum();
        if is_point { sum + offset } else { sum }
    };
    [row([a, b, c], x), row([d, e, f], y), row([g, h, i], z)]
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn norm(a: [f64; 3]) -> f64 {
    libm::sqrt(a.iter().map(|x| x * x).sum())
}
