//! Primary surfaces, standard ones, their values and their derivatives in expressions.
//!
//! The body of a surface is kept in u, v and t, which stand for its own parameters: a derivative in a parameter is
//! one in a coordinate, and a use puts the arguments in their place. So what the body mentions must not depend on
//! coordinates of the patch.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::form::{Form, components};
use super::lower::{Lowering, plain};
use super::reading::{Fault, Reading};
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::expr::{Derivative, ExprId, Variable};
use crate::problem::{COMPONENTS, PrimarySurface};
use crate::syntax::ast::{Definition, Expression, Kind, Name, Partial, Range};

/// What a name of a surface stands for.
#[derive(Debug)]
pub struct SurfaceMeaning {
    /// Its place among the problem's surfaces; `None` for a curve.
    pub index: Option<usize>,
    /// The names of its parameters: one of a curve, otherwise two, or three with time.
    pub parameters: Vec<Name>,
    /// x, y and z in u, v and t.
    pub position: [ExprId; 3],
}

/// Declares a `surface`.
pub fn declare(definition: &Definition, ranges: &[Range], scope: &mut Scope<'_>, reading: &mut Reading<'_>) {
    let found_before = reading.found.len();
    let parameters = &definition.formals;
    if !(2..=3).contains(&parameters.len()) {
        let message = format!("a surface has two parameters, and time if it moves; found {}", parameters.len());
        let finding = Diagnostic::new(Code::WrongArity, message).at(definition.name.span);
        reading.report(finding.hint(format!("as in `surface {}(u, v, t) = [.., .., ..]`", definition.name.text)));
    }
    for (index, parameter) in parameters.iter().enumerate() {
        if let Some(first) = parameters.iter().take(index).find(|other| other.text == parameter.text) {
            let message = format!("two parameters of the surface are called `{}`", parameter.text);
            let finding = Diagnostic::new(Code::DuplicateName, message).at(parameter.span);
            reading.report(finding.label(first.span, "first declared here"));
        }
    }
    let values = Variable::ALL.map(|variable| reading.graph.variable(variable));
    let inside = scope.of_surface(parameters, values);
    let position = reading.lowering(&inside).vector(definition.value);
    let position = reading.keep(position);
    let (ranges, range_origins) = own_ranges(ranges, parameters, scope, reading);
    let meaning = match position.filter(|_| reading.found.len() == found_before) {
        None => Meaning::Faulty,
        Some(position) => {
            let index = reading.surfaces.len();
            reading.surfaces.push(PrimarySurface {
                name: definition.name.text.clone(),
                parameters: parameters.iter().map(|name| name.text.clone()).collect(),
                position,
                ranges,
                range_origins,
                origin: Some(definition.name.span),
                remarks: Diagnostics::new(),
            });
            Meaning::Surface(Rc::new(SurfaceMeaning { index: Some(index), parameters: parameters.clone(), position }))
        }
    };
    let declared = scope.declare(&definition.name, meaning);
    reading.keep(declared);
}

/// The ranges behind `with`, and where each is written.
fn own_ranges(
    stated: &[Range],
    parameters: &[Name],
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> ([Option<[ExprId; 2]>; 2], [Option<Span>; 2]) {
    let (mut ranges, mut origins) = ([None; 2], [None; 2]);
    for range in stated {
        let index = parameters.iter().position(|parameter| parameter.text == range.variable.text);
        let slots = index.and_then(|index| ranges.get_mut(index).zip(origins.get_mut(index)));
        let Some((slot, origin)) = slots else {
            let message = format!("`{}` is not a parameter of the surface with a range", range.variable.text);
            let finding = Diagnostic::new(Code::UnknownName, message).at(range.variable.span);
            reading.report(finding.hint("its first and second parameter may have one"));
            continue;
        };
        let ends = range.interval.map(|end| {
            let end = reading.lowering(scope).constant(end, "the range of a surface's parameter");
            reading.keep(end)
        });
        let [low, high] = range.interval.map(|end| reading.tree.span(end));
        *origin = Some(low.to(high));
        if let [Some(low), Some(high)] = ends
            && slot.replace([low, high]).is_some()
        {
            let message = format!("the range of `{}` is stated twice", range.variable.text);
            reading.report(Diagnostic::new(Code::DuplicateStatement, message).at(range.variable.span));
        }
    }
    (ranges, origins)
}

impl SurfaceMeaning {
    /// The coordinate that stands for the parameter called `name`: by its own name, or as `u`, `v`, `t` by its place.
    pub fn parameter(&self, name: &str) -> Option<Variable> {
        let own = self.parameters.iter().position(|parameter| parameter.text == name);
        let by_place = || Variable::ALL.iter().position(|variable| variable.name() == name);
        let index = own.or_else(by_place).filter(|index| *index < self.parameters.len())?;
        Variable::ALL.get(index).copied()
    }

    fn parameter_names(&self) -> String {
        self.parameters.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(", ")
    }

    /// Replaces u, v and t by arguments; a surface of two parameters keeps the time.
    fn replacements(&self, arguments: &[ExprId], lowering: &mut Lowering<'_>) -> FxHashMap<ExprId, ExprId> {
        Variable::ALL
            .iter()
            .zip(arguments)
            .map(|(variable, value)| (lowering.graph.variable(*variable), *value))
            .collect()
    }
}

impl Lowering<'_> {
    /// The value of `root`, which must be a vector or zero.
    pub fn vector(&mut self, root: Expression) -> Result<[ExprId; 3], Fault> {
        match self.value(root)? {
            Value::Vector(each) => Ok(each),
            Value::Scalar(expr) if self.graph.is_zero(expr) => Ok([expr; 3]),
            Value::Scalar(_) => {
                let finding = Diagnostic::new(Code::NotScalar, "a surface is a vector").at(self.tree.span(root));
                Err(finding.hint("write `[x, y, z]`").into())
            }
        }
    }

    /// A surface, and which component of it, that `name` stands for: `S1`, `S1_x`.
    pub fn surface(&self, name: &str) -> Option<(Rc<SurfaceMeaning>, Option<usize>)> {
        match self.scope.meaning(name) {
            Some(Meaning::Surface(surface)) => Some((Rc::clone(surface), None)),
            Some(_) => None,
            None => {
                let (stem, last) = name.rsplit_once('_')?;
                let component = COMPONENTS.iter().position(|component| *component == last)?;
                match self.scope.meaning(stem) {
                    Some(Meaning::Surface(surface)) => Some((Rc::clone(surface), Some(component))),
                    _ => None,
                }
            }
        }
    }

    /// Whether a part of an expression is a name whose declaration is at fault.
    pub fn uses_faulty(&self, part: Expression) -> bool {
        let name = match &self.tree.node(part).kind {
            Kind::Name(name) | Kind::Application(name, _) => name,
            Kind::Partial(partial) => &partial.surface,
            _ => return false,
        };
        let is_faulty = |name: &str| matches!(self.scope.meaning(name), Some(Meaning::Faulty));
        is_faulty(&name.text) || name.text.rsplit_once('_').is_some_and(|(stem, _)| is_faulty(stem))
    }

    /// `S1(u1, v, t)`
    pub fn surface_value(
        &mut self,
        (surface, component): (&SurfaceMeaning, Option<usize>),
        name: &Name,
        arguments: &[ExprId],
        span: Span,
    ) -> Result<Form, Diagnostic> {
        self.surface_derivative((surface, component), name, Derivative::NONE, arguments, span)
    }

    /// `∂S1(u1, v, t)/∂u`: the derivative in the surface's own parameter, then evaluated at the arguments.
    pub fn partial(&mut self, partial: &Partial, arguments: &[ExprId], span: Span) -> Result<Form, Diagnostic> {
        let Some((surface, component)) = self.surface(&partial.surface.text) else {
            let name = &partial.surface;
            return Err(match self.scope.meaning(&name.text) {
                Some(Meaning::Function(..)) => {
                    let text = &name.text;
                    let finding = Diagnostic::new(Code::UnknownName, format!("`{text}` is not a surface"));
                    finding
                        .at(name.span)
                        .hint(format!("declare one first: `surface A(p, q) = {text}(p, q, …)`, then write `∂A(…)/∂p`"))
                }
                None => self.scope.unknown_name(name, None),
                Some(_) => Diagnostic::new(Code::UnknownName, format!("`{}` is not a surface", name.text))
                    .at(name.span)
                    .hint("derivatives are taken of `S` and of what `surface` declares"),
            });
        };
        let mut orders = Derivative::NONE;
        for (parameter, times) in &partial.orders {
            let Some(variable) = surface.parameter(&parameter.text) else {
                let message = format!("`{}` has no parameter `{}`", partial.surface.text, parameter.text);
                let finding = Diagnostic::new(Code::UnknownName, message).at(parameter.span);
                return Err(finding.hint(format!("its parameters are {}", surface.parameter_names())));
            };
            let order = match variable {
                Variable::U => &mut orders.u,
                Variable::V => &mut orders.v,
                Variable::T => &mut orders.t,
            };
            *order = order.saturating_add(*times);
        }
        let limit = self.limits.derivative_order;
        if orders.largest() > limit {
            let message = format!("the derivative is above the limit `derivative-order` of {limit}");
            return Err(Diagnostic::new(Code::LimitReached, message).at(span));
        }
        self.surface_derivative((&surface, component), &partial.surface, orders, arguments, span)
    }

    fn surface_derivative(
        &mut self,
        (surface, component): (&SurfaceMeaning, Option<usize>),
        name: &Name,
        orders: Derivative,
        arguments: &[ExprId],
        span: Span,
    ) -> Result<Form, Diagnostic> {
        if arguments.len() != surface.parameters.len() {
            let count = surface.parameters.len();
            let plural = if count == 1 { "" } else { "s" };
            let message = format!("`{}` takes {count} argument{plural}, found {}", name.text, arguments.len());
            let finding = Diagnostic::new(Code::WrongArity, message).at(span);
            return Err(finding.hint(format!("its parameters are {}", surface.parameter_names())));
        }
        // Only what no argument replaces can depend on a coordinate of the place of use.
        self.check_visible(name, Value::Vector(surface.position), arguments.len())?;
        let replacements = surface.replacements(arguments, self);
        let position = components(self.differentiated(Value::Vector(surface.position), orders, span)?);
        let position = position.map(|expr| self.graph.substitute(expr, &replacements));
        let value = match component.and_then(|component| position.get(component)) {
            Some(expr) => Value::Scalar(*expr),
            None => Value::Vector(position),
        };
        Ok(Form::of(value))
    }

    /// Inside a surface only its own parameters are coordinates.
    ///
    /// `value` is what `name`, declared outside, stands for; its first `replaced` coordinates are arguments.
    pub fn check_visible(&self, name: &Name, value: Value, replaced: usize) -> Result<(), Diagnostic> {
        let hidden = self.scope.hidden_from(&name.text);
        let parts = match value {
            Value::Scalar(expr) => vec![expr],
            Value::Vector(each) => each.to_vec(),
        };
        for expr in parts {
            let depends = self.graph.dependence(expr);
            let depends = [depends.u, depends.v, depends.t];
            for ((variable, depends), hidden) in Variable::ALL.iter().zip(depends).zip(hidden).skip(replaced) {
                if depends && hidden {
                    let coordinate = variable.name();
                    let message = if name.text == coordinate {
                        format!("`{coordinate}` is not a parameter of this surface")
                    } else {
                        format!("`{}` depends on `{coordinate}`, which is not a parameter of this surface", name.text)
                    };
                    return Err(Diagnostic::new(Code::UnknownName, message)
                        .at(name.span)
                        .hint("a surface is a function of its own parameters; pass others as arguments of a `let`"));
                }
            }
        }
        Ok(())
    }

    /// What a plain name stands for, where it may stand.
    pub fn plain_value(&self, meaning: &Meaning, name: &Name) -> Result<Value, Diagnostic> {
        if let Meaning::Surface(surface) = meaning {
            let what = if surface.index.is_some() { "a surface" } else { "a curve" };
            let message = format!("`{}` is {what}, which takes its parameters in brackets", name.text);
            let finding = Diagnostic::new(Code::WrongArity, message).at(name.span);
            return Err(finding.hint(format!("write `{}({})`", name.text, surface.parameter_names())));
        }
        let value = plain(meaning, name.span)?;
        self.check_visible(name, value, 0)?;
        Ok(value)
    }
}
