//! `bspline` blocks to nets: their size, knots and boundary layers.

use super::curve;
use super::declarations;
use super::patch;
use super::reading::{Fault, Reading};
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{ExprId, Number, SymbolId, Variable};
use crate::problem::{Domain, KnotKind, Layer, Net, NetKnots, NetPoints, Sampling};
use crate::syntax::ast::{self, Document, Expression, Kind, KnotChoice, Name, NetBlock, NetSource, NetStatement};

/// The numbers of a control point and of the last one, by direction; names inside a block.
const INDEX: [&str; 2] = ["i", "j"];
const LAST: [&str; 2] = ["n", "m"];

/// The nets of a document; `domain` is what its blocks share.
pub fn resolve(document: &Document, domain: &Domain, scope: &Scope<'_>, reading: &mut Reading<'_>) -> Vec<Net> {
    let mut nets = Vec::with_capacity(document.nets.len());
    for block in &document.nets {
        if reading.is_over {
            break;
        }
        nets.extend(net(block, domain, scope, reading));
    }
    nets
}

fn net(block: &NetBlock, domain: &Domain, outside: &Scope<'_>, reading: &mut Reading<'_>) -> Option<Net> {
    let found_before = reading.found.len();
    let statement = only_net(block, reading)?;
    let last = reading.keep(size(statement, reading.limits.control_points))?;
    let mut scope = outside.of_patch();
    let index = numbers(last, outside, &mut scope, reading);
    scope.announce(block.definitions.iter().map(|definition| &definition.name));
    declarations::definitions(&block.definitions, &mut scope, reading);
    // Ranges and knots are constants, which no number of a control point is.
    let domain = patch::domain(&block.ranges, domain.clone(), outside, reading);
    let knots = knots(block, last, outside, reading);
    let points = match &statement.source {
        None => layers(block, last, &scope, reading),
        Some(source) => from(source, last, block, &scope, reading),
    };
    if reading.found.len() > found_before {
        return None;
    }
    let (name, origin) = (block.name.text.clone(), Some(statement.size));
    Some(Net { name, domain, knots, last, index, points: points?, origin })
}

fn only_net<'a>(block: &'a NetBlock, reading: &mut Reading<'_>) -> Option<&'a NetStatement> {
    match block.nets.as_slice() {
        [] => {
            let message = format!("the size of `{}` is not stated", block.name.text);
            let finding = Diagnostic::new(Code::NetSize, message).at(block.name.span);
            reading.report(finding.hint("write `net n x m`, where n and m are the numbers of the last control points"));
            None
        }
        [only] => Some(only),
        [first, second, ..] => {
            let finding = Diagnostic::new(Code::DuplicateStatement, "the net is stated twice").at(second.span);
            reading.report(finding.label(first.span, "first stated here"));
            None
        }
    }
}

/// n and m.
fn size(statement: &NetStatement, limit: usize) -> Result<[usize; 2], Diagnostic> {
    // A number that does not fit is above every limit.
    let last = statement.last.each_ref().map(|number| number.parse::<usize>().unwrap_or(usize::MAX));
    let [n, m] = last;
    if n < 3 || m < 3 {
        let message = format!("a net {n} x {m} has no inside: n and m are 3 or more");
        let finding = Diagnostic::new(Code::NetSize, message).at(statement.size);
        return Err(
            finding.hint("`net n x m` has n + 1 points in u and m + 1 in v; its layers are 0, 1 and n, and 0, 1 and m")
        );
    }
    let points = n.saturating_add(1).saturating_mul(m.saturating_add(1));
    if points > limit {
        let message = format!("the net has {points} points, above the limit `control-points` of {limit}");
        return Err(Diagnostic::new(Code::LimitReached, message).at(statement.size));
    }
    Ok(last)
}

/// Gives i, j, n and m their meanings in `scope`.
fn numbers(last: [usize; 2], outside: &Scope<'_>, scope: &mut Scope<'_>, reading: &mut Reading<'_>) -> [SymbolId; 2] {
    for name in INDEX.into_iter().chain(LAST) {
        if let (Some(_), Some(place)) = (outside.meaning(name), outside.place(name)) {
            let message = format!("`{name}` is a number of a control point in `bspline` blocks");
            let finding = Diagnostic::new(Code::DuplicateName, message).at(place);
            reading.report(finding.hint("i and j are its numbers, n and m those of the last one; choose another name"));
        }
    }
    // A space cannot occur in a name, so they never meet a param.
    let index = INDEX.map(|name| reading.graph.symbol_id(&format!("{name} of a control point")));
    for (name, symbol) in INDEX.into_iter().zip(index) {
        scope.provide(name, Meaning::Value(Value::Scalar(reading.graph.symbol_node(symbol))));
    }
    for (name, last) in LAST.into_iter().zip(last) {
        let number = reading.graph.number(Number::integer(i64::try_from(last).unwrap_or(i64::MAX)));
        scope.provide(name, Meaning::Value(Value::Scalar(number)));
    }
    index
}

/// The knots of u and v; clamped where nothing is stated.
fn knots(block: &NetBlock, last: [usize; 2], scope: &Scope<'_>, reading: &mut Reading<'_>) -> [NetKnots; 2] {
    let mut knots: [Option<NetKnots>; 2] = [None, None];
    for entry in &block.knots {
        let kind = kind(&entry.choice, entry.span, scope, reading);
        for direction in &entry.directions {
            let place = [Variable::U, Variable::V].iter().position(|variable| variable.name() == direction.text);
            let Some(slot) = place.and_then(|place| knots.get_mut(place)) else {
                let message = format!("a net has knots in u and in v, not in `{}`", direction.text);
                reading.report(Diagnostic::new(Code::UnknownName, message).at(direction.span));
                continue;
            };
            if let Some(first) = slot {
                let message = format!("the knots of {} are stated twice", direction.text);
                let finding = Diagnostic::new(Code::DuplicateStatement, message).at(direction.span);
                reading.report(match first.origin {
                    Some(first) => finding.label(first, "first stated here"),
                    None => finding,
                });
                continue;
            }
            if let Some(kind) = &kind {
                let (name, last) = (&direction.text, place.and_then(|place| last.get(place)).copied().unwrap_or(0));
                check_listed(kind, (name, last), entry.span, block, reading);
                *slot = Some(NetKnots { kind: kind.clone(), origin: Some(entry.span) });
            }
        }
    }
    knots.map(|knots| knots.unwrap_or(NetKnots { kind: KnotKind::Clamped, origin: None }))
}

fn kind(choice: &KnotChoice, place: Span, scope: &Scope<'_>, reading: &mut Reading<'_>) -> Option<KnotKind> {
    match choice {
        KnotChoice::Named(name) => match name.text.as_str() {
            "uniform" => Some(KnotKind::Uniform),
            "clamped" => Some(KnotKind::Clamped),
            other => {
                let finding = Diagnostic::new(Code::UnknownName, format!("there are no knots `{other}`")).at(place);
                reading.report(finding.hint("knots are `uniform`, `clamped` or a list `[0, 0, 0, 0, 1, 2, 2, 2, 2]`"));
                None
            }
        },
        KnotChoice::Listed(knots) => {
            let knots = knots.iter().map(|knot| {
                let knot = reading.lowering(scope).constant(*knot, "a knot");
                reading.keep(knot)
            });
            knots.collect::<Option<_>>().map(KnotKind::Listed)
        }
    }
}

/// That listed knots are as many as the net needs, and that nothing else gives their direction a domain.
fn check_listed(
    kind: &KnotKind,
    (name, last): (&str, usize),
    place: Span,
    block: &NetBlock,
    reading: &mut Reading<'_>,
) {
    let KnotKind::Listed(knots) = kind else { return };
    let needed = last + 5;
    if knots.len() != needed {
        let letter = if name == Variable::U.name() { "n" } else { "m" };
        let message = format!("{} knots are given, and {letter} = {last} takes {needed}", knots.len());
        let finding = Diagnostic::new(Code::NetSize, message).at(place);
        reading.report(finding.hint(format!("knots t_0 to t_({letter}+4); the domain is [t_3, t_({letter}+1)]")));
    }
    if let Some(range) = block.ranges.iter().find(|range| range.variable.text == name) {
        let message = format!("the knots of {name} are listed, which gives {name} its domain");
        let finding = Diagnostic::new(Code::DuplicateStatement, message).at(range.variable.span);
        reading.report(finding.label(place, "listed here").hint("leave out this range"));
    }
}

/// Layers that come from one formula or surface.
fn from(
    source: &NetSource,
    last: [usize; 2],
    block: &NetBlock,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Option<NetPoints> {
    if let Some(layer) = block.layers.first() {
        let finding = Diagnostic::new(Code::DuplicateStatement, "the layers are stated twice").at(layer.index.span);
        reading.report(finding.hint("`net … from …` gives all of them: leave out either"));
    }
    let of_all = |value: [ExprId; 3], origin: Span| {
        let layer = Layer { value, origin: Some(origin) };
        Box::new([[layer; 3]; 2])
    };
    match source {
        NetSource::Formula(formula) => {
            let value = reading.lowering(scope).vector(*formula);
            let layers = of_all(reading.keep(value)?, reading.tree.span(*formula));
            Some(NetPoints::Layers { layers, sampling: Sampling::Greville, ranges: [None; 2] })
        }
        NetSource::Table(file) => {
            let points = table(*file, last, reading);
            reading.keep(points).map(NetPoints::Given)
        }
        NetSource::Surface { surface, sampling } => {
            let sampling = sampling_called(sampling);
            let sampling = reading.keep(sampling)?;
            let index = surface_called(surface, scope);
            let index = reading.keep(index)?;
            let primary = reading.surfaces.get(index)?;
            let (position, ranges) = (primary.position, primary.ranges);
            Some(NetPoints::Layers { layers: of_all(position, surface.span), sampling, ranges })
        }
    }
}

/// The points of a file: as many as the net has, those of i = 0 first.
fn table(file: Expression, last: [usize; 2], reading: &Reading<'_>) -> Result<Vec<[f64; 3]>, Diagnostic> {
    let node = reading.tree.node(file);
    let Kind::Text(path) = &node.kind else { return Ok(Vec::new()) };
    let [n, m] = last;
    let needed = (n + 1) * (m + 1);
    let other_number = |found: String| {
        let finding = curve::bad(path, &format!("a net {n} x {m} has {needed} points, and it holds {found}"));
        finding.hint("a row for each point: those of i = 0 first, j from 0 to m, then those of i = 1")
    };
    let file = reading.files.iter().find(|file| file.path == *path);
    let rows = curve::rows(path, file, needed, || other_number("more".to_owned()));
    let rows = rows.and_then(|rows| match rows.len() {
        found if found == needed => Ok(rows),
        found => Err(other_number(found.to_string())),
    });
    let rows = rows.map_err(|finding| finding.at(node.span))?;
    Ok(rows.into_iter().map(|(_, point)| point).collect())
}

fn sampling_called(name: &Name) -> Result<Sampling, Diagnostic> {
    match name.text.as_str() {
        "greville" => Ok(Sampling::Greville),
        "uniform" => Ok(Sampling::Lattice),
        other => Err(Diagnostic::new(Code::UnknownName, format!("there is no sampling `{other}`")).at(name.span).hint(
            "`sampled uniform` takes a lattice of equal steps, `sampled greville` the places where control points act",
        )),
    }
}

/// The place of a primary surface among the problem's.
fn surface_called(name: &Name, scope: &Scope<'_>) -> Result<usize, Fault> {
    let no_surface = || -> Fault {
        let finding = Diagnostic::new(Code::UnknownName, format!("`{}` is not a surface", name.text));
        finding.at(name.span).hint("declare one with `surface`").into()
    };
    match scope.meaning(&name.text) {
        Some(Meaning::Surface(surface)) => surface.index.ok_or_else(no_surface),
        Some(Meaning::Faulty) => Err(Fault::Follows),
        Some(_) => Err(no_surface()),
        None => Err(scope.unknown_name(name, None).into()),
    }
}

/// Layers that are stated one by one.
fn layers(block: &NetBlock, last: [usize; 2], scope: &Scope<'_>, reading: &mut Reading<'_>) -> Option<NetPoints> {
    let mut stated: [[Option<(Layer, Span)>; 3]; 2] = Default::default();
    let found_before = reading.found.len();
    for layer in &block.layers {
        let place = place_of(layer, last);
        let Some((direction, which)) = reading.keep(place) else { continue };
        let value = reading.lowering(scope).vector(layer.value);
        let Some(value) = reading.keep(value) else { continue };
        let Some(slot) = stated.get_mut(direction).and_then(|layers| layers.get_mut(which)) else { continue };
        if let Some((_, first)) = slot {
            let finding = Diagnostic::new(Code::DuplicateStatement, "this layer is stated twice").at(layer.index.span);
            reading.report(finding.label(*first, "first stated here"));
            continue;
        }
        *slot = Some((Layer { value, origin: Some(reading.tree.span(layer.value)) }, layer.index.span));
    }
    let missing = stated.iter().zip(INDEX.iter().zip(LAST)).flat_map(|(layers, (index, last))| {
        let positions = ["0", "1", last];
        layers.iter().zip(positions).filter(|(layer, _)| layer.is_none()).map(move |(_, at)| format!("{index} = {at}"))
    });
    let missing: Vec<String> = missing.collect();
    if reading.found.len() > found_before {
        return None;
    }
    if !missing.is_empty() {
        let message = format!("the net `{}` lacks layers: {}", block.name.text, missing.join(", "));
        let finding = Diagnostic::new(Code::MissingConstraint, message).at(block.name.span);
        let advice = "state each, `layer i = 0: [x, y, z]`, or all at once: `net n x m from [x, y, z]`";
        reading.report(finding.hint(advice));
        return None;
    }
    let [of_i, of_j] = stated.map(|layers| layers.map(|layer| layer.map(|(layer, _)| layer)));
    let whole = |layers: [Option<Layer>; 3]| match layers {
        [Some(first), Some(second), Some(last)] => Some([first, second, last]),
        _ => None,
    };
    let layers = Box::new([whole(of_i)?, whole(of_j)?]);
    Some(NetPoints::Layers { layers, sampling: Sampling::Greville, ranges: [None; 2] })
}

/// Which layer is stated: its direction, and 0, 1 or 2 for the last.
fn place_of(layer: &ast::Layer, last: [usize; 2]) -> Result<(usize, usize), Diagnostic> {
    let Some(direction) = INDEX.iter().position(|name| *name == layer.index.text) else {
        let message = format!("a layer has one number i or one number j, not `{}`", layer.index.text);
        return Err(Diagnostic::new(Code::UnknownName, message)
            .at(layer.index.span)
            .hint("as in `layer i = 0: [x, y, z]`"));
    };
    let (index, letter) = (&layer.index.text, LAST.get(direction).copied().unwrap_or_default());
    let last = last.get(direction).copied().unwrap_or_default();
    let text = layer.position.text.as_str();
    match text.parse::<usize>() {
        Ok(number @ 0..=1) => Ok((direction, number)),
        Ok(number) if number == last => Ok((direction, 2)),
        _ if text == letter => Ok((direction, 2)),
        _ => {
            let message = format!("{index} = {text} is no layer: those are {index} = 0, 1 and {letter} = {last}");
            Err(Diagnostic::new(Code::NetSize, message)
                .at(layer.position.span)
                .hint("the control points between them follow from the equation"))
        }
    }
}
