//! Calls of functions, with brackets and without: where the argument of `sin πt` ends.

use super::ambiguity::{ambiguous_argument, is_coordinate};
use super::ast::{Expression, Kind};
use super::expression::{Builder, superscript_digits};
use super::parser::{Parsed, Rule};
use super::statement::internal;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::Function;

impl Builder<'_> {
    /// Function and argument of a last factor like `sin πt`.
    pub fn bare_call(&self, power: &Parsed<'_>) -> Option<(String, String)> {
        let last = power.clone().into_inner().next_back().filter(|part| part.as_rule() == Rule::call)?;
        let argument = last.clone().into_inner().find(|part| part.as_rule() == Rule::bare_argument)?;
        let (last, argument) = (self.text(self.span(&last)), self.text(self.span(&argument)));
        Some((last.strip_suffix(argument)?.trim().to_owned(), argument.to_owned()))
    }

    /// A `call` pair: `sin(v)`, `sin² v`.
    pub fn call_pair(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut parts = pair.into_inner().peekable();
        let called = called(&parts.next().ok_or_else(internal)?)?;
        let exponent = parts.next_if(|part| part.as_rule() == Rule::function_power);
        let argument = parts.next().ok_or_else(internal)?;
        let arguments = if argument.as_rule() == Rule::bare_argument {
            let place = self.span(&argument);
            let mut factors: Vec<(bool, Expression)> = Vec::new();
            let mut may_end = None;
            let mut before: Option<Parsed<'_>> = None;
            for part in argument.into_inner() {
                let here = self.span(&part);
                if let Some(before) = before.replace(part.clone()) {
                    self.refuse_neighbours(&before, &part)?;
                    // `sin 2π(v + 1)` is one angle; behind a name the bracket may be another factor.
                    if may_end.is_none()
                        && begins_with(&part, &[Rule::bracketed])
                        && !begins_with(&before, &[Rule::number, Rule::pi])
                    {
                        may_end = Some(self.span(&before).end);
                    }
                }
                if let Some(end) = may_end {
                    let parts = [Span::new(place.start, end), here].map(|span| self.text(span));
                    return Err(ambiguous_argument(called.name(), self.text(place), parts).at(whole));
                }
                let factor = self.power(part)?;
                // `v (1-t)` is one application to the grammar, and still a coordinate with something after it.
                if let Some(end) = self.applied_coordinate(factor) {
                    let parts = [Span::new(place.start, end), Span::new(end, here.end)].map(|span| self.text(span));
                    return Err(ambiguous_argument(called.name(), self.text(place), parts).at(whole));
                }
                may_end = self.mentions_coordinate(factor).then_some(here.end);
                factors.push((false, factor));
            }
            vec![self.tree.add(Kind::Product(factors), place)]
        } else {
            self.bracket(&argument)?
        };
        let value = self.call(called, arguments, whole);
        let Some(exponent) = exponent else { return Ok(value) };
        let digits = superscript_digits(exponent.as_str().trim_start_matches('^').trim());
        let digits = digits.replace(['−', '–'], "-").replace(|c: char| c.is_whitespace() || matches!(c, '{' | '}'), "");
        if digits.starts_with('-') {
            let name = called.name();
            let message = format!("`{name}^{digits}` can mean the inverse function or the reciprocal");
            return Err(Diagnostic::new(Code::AmbiguousExpression, message)
                .at(whole)
                .hint(format!("write `a{name}(…)` for the inverse function, `1/{name}(…)` for the reciprocal")));
        }
        let exponent = self.number(&digits, self.span(&exponent))?;
        Ok(self.raised(value, exponent))
    }

    /// Where the name ends in `v(…)`, `v(…)^2` and the like for a coordinate.
    fn applied_coordinate(&self, factor: Expression) -> Option<usize> {
        match &self.tree.node(factor).kind {
            Kind::Application(name, _) if is_coordinate(&name.text) => Some(name.span.end),
            Kind::Power(base, _) => match &self.tree.node(*base).kind {
                Kind::Application(name, _) if is_coordinate(&name.text) => Some(name.span.end),
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether u, v or t occurs in an expression.
    fn mentions_coordinate(&self, expression: Expression) -> bool {
        self.tree.parts(expression).into_iter().any(|part| match &self.tree.node(part).kind {
            Kind::Name(name) | Kind::Application(name, _) => is_coordinate(&name.text),
            _ => false,
        })
    }

    /// A function and the brackets behind it.
    pub fn applied(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut parts = pair.into_inner();
        let called = called(&parts.next().ok_or_else(internal)?)?;
        let arguments = self.bracket(&parts.next().ok_or_else(internal)?)?;
        Ok(self.call(called, arguments, whole))
    }

    fn call(&mut self, called: Called, arguments: Vec<Expression>, span: Span) -> Expression {
        let kind = match called {
            Called::Function(function) => Kind::Call(function, arguments),
            Called::SquareRoot => Kind::SquareRoot(arguments),
        };
        self.tree.add(kind, span)
    }
}

/// A function as written: the square root is not in the operator table.
#[derive(Clone, Copy)]
enum Called {
    SquareRoot,
    Function(Function),
}

impl Called {
    fn name(self) -> &'static str {
        match self {
            Called::SquareRoot => "sqrt",
            Called::Function(function) => function.row().name,
        }
    }
}

fn begins_with(factor: &Parsed<'_>, rules: &[Rule]) -> bool {
    factor.clone().into_inner().next().is_some_and(|first| rules.contains(&first.as_rule()))
}

fn called(pair: &Parsed<'_>) -> Result<Called, Diagnostic> {
    match pair.as_str().trim_end() {
        "sqrt" => Ok(Called::SquareRoot),
        name => Function::named(name).map(Called::Function).ok_or_else(internal),
    }
}
