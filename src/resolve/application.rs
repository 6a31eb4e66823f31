//! A name with a bracket behind it: a call of a function, or a product with a factor.
//!
//! Which of them it is depends on what the name means, so that here too some texts turn out to have two readings:
//! in `a/b(1 + v)` the bracket may be part of the divisor or stand behind it. They are refused.

use rustc_hash::FxHashMap;

use super::form::Form;
use super::lower::{Lowering, missing, plain, wrong_arity};
use super::scope::Meaning;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::ExprId;
use crate::syntax::ast::{Expression, Kind, Name};

impl Lowering<'_> {
    /// `f(x)`: a call of a defined function, or a product with a bracket.
    pub fn application(
        &mut self,
        name: &Name,
        arguments: &[Expression],
        known: &FxHashMap<Expression, Form>,
        span: Span,
    ) -> Result<Form, Diagnostic> {
        if let Some((surface, component)) = self.surface(&name.text) {
            let values = self.scalars(arguments, known)?;
            return self.surface_value((&surface, component), name, &values, span);
        }
        match self.scope.meaning(&name.text).cloned() {
            Some(Meaning::Function(formals, body)) => {
                self.check_visible(name, body, 0)?;
                let values = self.scalars(arguments, known)?;
                if values.len() != formals.len() {
                    return Err(wrong_arity(&name.text, formals.len(), values.len(), span));
                }
                let replacements: FxHashMap<ExprId, ExprId> = formals.into_iter().zip(values).collect();
                let value = self.map_value(body, |graph, expr| graph.substitute(expr, &replacements));
                Ok(Form::of(value))
            }
            Some(meaning) => match arguments {
                [only] => {
                    let factor = Form::of(self.plain_value(&meaning, name)?);
                    let other = known.get(only).cloned().ok_or_else(|| missing(span))?;
                    self.multiply(factor, other, span)
                }
                _ => {
                    let message =
                        format!("`{}` is not a function, so it cannot take {} arguments", name.text, arguments.len());
                    Err(Diagnostic::new(Code::WrongArity, message).at(span))
                }
            },
            None => {
                let text = &name.text;
                let hint =
                    format!("as a function define it, `let {text}(x) = …`; as a factor declare it, `param {text} = …`");
                Err(self.scope.unknown_name(name, Some(hint)))
            }
        }
    }

    /// `h0(1 - t)` as its factor and its bracket, when `h0` is not a function.
    pub fn factor_and_bracket(
        &self,
        expression: Expression,
        known: &FxHashMap<Expression, Form>,
    ) -> Option<(Form, Expression)> {
        let Kind::Application(name, arguments) = &self.tree.node(expression).kind else { return None };
        let (Some(meaning), [only]) = (self.scope.meaning(&name.text), arguments.as_slice()) else { return None };
        let value = plain(meaning, name.span).ok()?;
        known.get(only).map(|_| (Form::of(value), *only))
    }

    /// The factor b of `b(1 + v)` or `b(1 + v)²`; `None` for a call of a function.
    fn applied_factor(&self, expression: Expression) -> Option<&Name> {
        let applied = match self.tree.node(expression).kind {
            Kind::Power(base, _) => base,
            _ => expression,
        };
        let Kind::Application(name, _) = &self.tree.node(applied).kind else { return None };
        let is_factor = !matches!(self.scope.meaning(&name.text), Some(Meaning::Function(..)) | None);
        (is_factor && self.surface(&name.text).is_none()).then_some(name)
    }

    /// Refuses `sin a (1 - t)`; for u, v and t the parser does the same.
    pub fn refuse_applied_factor(
        &self,
        function: &str,
        arguments: &[Expression],
        call: Span,
    ) -> Result<(), Diagnostic> {
        let [argument] = arguments else { return Ok(()) };
        let argument = self.tree.node(*argument);
        let is_bare = argument.span.end == call.end;
        let Kind::Product(factors) = &argument.kind else { return Ok(()) };
        let mut applied = factors.iter().filter(|_| is_bare).filter_map(|(_, factor)| self.applied_factor(*factor));
        applied.next().map_or(Ok(()), |name| {
            let name = &name.text;
            let message = format!("`{function} … {name}(…)` can be read in two ways, since `{name}` is no function");
            Err(Diagnostic::new(Code::AmbiguousExpression, message)
                .at(call)
                .marked(format!("does the bracket after `{name}` belong to the argument of `{function}`?"))
                .hint(format!("write `{function}({name}*(…))` if it does, `{function}({name})*(…)` if it does not")))
        })
    }

    /// Refuses `√a(1 + v)`.
    pub fn refuse_applied_below_root(&self, arguments: &[Expression], root: Span) -> Result<(), Diagnostic> {
        // In `sqrt(a(1 + v))` the bracket of the function ends behind the argument.
        let is_bare = |argument: &&Expression| self.tree.span(**argument).end == root.end;
        match arguments.first().filter(is_bare) {
            Some(argument) => self.refuse_applied(*argument, "√", "below the root", root),
            None => Ok(()),
        }
    }

    /// Refuses `a/b(1 + v)`.
    pub fn refuse_applied_divisor(&self, divisor: Expression) -> Result<(), Diagnostic> {
        self.refuse_applied(divisor, "/", "part of the divisor", self.tree.span(divisor))
    }

    /// Refuses `e^k(1 + v)` and `e^-k(1 + v)`.
    pub fn refuse_applied_exponent(&self, exponent: Expression) -> Result<(), Diagnostic> {
        let unsigned = match &self.tree.node(exponent).kind {
            // An exponent in brackets is a sum that subtracts nothing.
            Kind::Sum(terms) => match terms.as_slice() {
                [(true, only)] => *only,
                _ => exponent,
            },
            _ => exponent,
        };
        self.refuse_applied(unsigned, "^", "part of the exponent", self.tree.span(exponent))
    }

    fn refuse_applied(&self, part: Expression, before: &str, question: &str, place: Span) -> Result<(), Diagnostic> {
        let Some(name) = self.applied_factor(part) else { return Ok(()) };
        let name = &name.text;
        let message = format!("`{before}{name}(…)` can be read in two ways, since `{name}` is no function");
        Err(Diagnostic::new(Code::AmbiguousExpression, message)
            .at(place)
            .marked(format!("is the bracket after `{name}` {question}?"))
            .hint(format!("write `{before}({name}*(…))` if it is, `{before}{name}*(…)` if it is not")))
    }
}
