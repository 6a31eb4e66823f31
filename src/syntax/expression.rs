//! Parsed expressions to the tree, refusing those with two plausible readings.

use super::ambiguity::{
    Run, ambiguous_argument, ambiguous_power, is_coordinate, refuse_ambiguous_division, refuse_ambiguous_neighbours,
};
use super::ast::Name;
use super::ast::{Expression, Kind, Tree, Unknown};
use super::brackets::Brackets;
use super::parser::{Parsed, Rule};
use super::places::Places;
use super::preflight::Prepared;
use super::statement::{coordinate, internal};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, Function, Number, canonical_name};

/// Builds expressions of one logical line into a tree.
pub struct Builder<'a> {
    /// Where expressions go.
    pub tree: &'a mut Tree,
    /// What stands inside the brackets of the line.
    pub brackets: &'a mut Brackets,
    /// Byte offset in the prepared text at which the parsed text begins.
    offset: usize,
    /// Where the prepared text stands in the source.
    places: &'a Places,
    /// The source as messages quote it.
    source: &'a str,
}

impl<'a> Builder<'a> {
    /// A builder for what begins at `offset` of a prepared text.
    pub fn new(prepared: &'a Prepared, offset: usize, tree: &'a mut Tree, brackets: &'a mut Brackets) -> Builder<'a> {
        Builder { tree, brackets, offset, places: &prepared.places, source: &prepared.shown }
    }
}

impl Builder<'_> {
    /// The place of a pair in the source.
    pub fn span(&self, pair: &Parsed<'_>) -> Span {
        let span = pair.as_span();
        let start = self.offset + span.start();
        self.places.in_source(Span::new(start, start + span.as_str().trim_end().len()))
    }

    /// The text at a place, brackets filled.
    fn text(&self, span: Span) -> &str {
        self.source.get(span.start..span.end).unwrap_or("").trim()
    }

    /// Builds a `values` pair.
    pub fn values(&mut self, pair: Parsed<'_>) -> Result<Vec<Expression>, Diagnostic> {
        let parts = pair.into_inner().filter(|part| part.as_rule() != Rule::EOI);
        let value = |part: Parsed<'_>| match part.as_rule() {
            Rule::face => {
                let span = self.span(&part);
                let digits = part.into_inner().next().map_or("", |number| number.as_str());
                // What does not fit is beyond every file.
                Ok(self.tree.add(Kind::Face(digits.parse().unwrap_or(usize::MAX)), span))
            }
            _ => self.expression(part),
        };
        parts.map(value).collect()
    }

    /// Builds an `expression` pair.
    pub fn expression(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut terms = Vec::new();
        let mut subtracts = false;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::add_operator => subtracts = part.as_str() != "+",
                _ => terms.push((subtracts, self.term(part)?)),
            }
        }
        Ok(match terms.as_slice() {
            [(false, only)] => *only,
            _ => self.tree.add(Kind::Sum(terms), whole),
        })
    }

    fn term(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut factors: Vec<(bool, Expression)> = Vec::new();
        let (mut divides, mut is_negative) = (false, false);
        let mut last_run: Option<Run> = None;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::sign => is_negative ^= part.as_str() != "+",
                Rule::multiply_operator => divides = matches!(part.as_str(), "/" | "÷" | "∕"),
                _ => {
                    let run = self.run(part)?;
                    if divides {
                        refuse_ambiguous_division(last_run.as_ref(), &run)?;
                    }
                    factors.extend(run.factors.iter().map(|factor| (divides, *factor)));
                    last_run = Some(run);
                }
            }
        }
        let product = match factors.as_slice() {
            [(false, only)] => *only,
            _ => self.tree.add(Kind::Product(factors), whole),
        };
        Ok(if is_negative { self.tree.add(Kind::Sum(vec![(true, product)]), whole) } else { product })
    }

    fn run(&mut self, pair: Parsed<'_>) -> Result<Run, Diagnostic> {
        let span = self.span(&pair);
        let text = self.text(span).to_owned();
        let mut run = Run { factors: Vec::new(), text, span, head: 0, bare_call: None };
        let mut before: Option<Span> = None;
        for part in pair.into_inner() {
            let here = self.span(&part);
            if let Some(before) = before {
                refuse_ambiguous_neighbours((self.text(before), before), (self.text(here), here))?;
            }
            before = Some(here);
            run.bare_call = self.bare_call(&part);
            if run.factors.is_empty() {
                run.head = here.end - span.start;
            }
            run.factors.push(self.power(part)?);
        }
        Ok(run)
    }

    /// Function and argument of a last factor like `sin πt`.
    fn bare_call(&self, power: &Parsed<'_>) -> Option<(String, String)> {
        let last = power.clone().into_inner().next_back().filter(|part| part.as_rule() == Rule::call)?;
        let argument = last.clone().into_inner().find(|part| part.as_rule() == Rule::bare_argument)?;
        let (last, argument) = (self.text(self.span(&last)), self.text(self.span(&argument)));
        Some((last.strip_suffix(argument)?.trim().to_owned(), argument.to_owned()))
    }

    /// A `power`, `bare_factor` or `exponent` pair: a primary with superscripts and exponents.
    fn power(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut parts = pair.into_inner().peekable();
        let first = parts.next().ok_or_else(internal)?;
        if let (Rule::differential, Some(power)) = (first.as_rule(), parts.peek()) {
            return Err(ambiguous_power(self.text(self.span(&first)), self.span(power)));
        }
        let mut base = if first.as_rule() == Rule::function {
            let arguments = self.bracket(&parts.next().ok_or_else(internal)?)?;
            self.call(called(&first)?, arguments, whole)
        } else {
            self.primary(first)?
        };
        if let Some(superscript) = parts.next_if(|part| part.as_rule() == Rule::superscript) {
            // As `^-1` is read, so that both spellings are one tree.
            let (digits, place) = (superscript_digits(superscript.as_str()), self.span(&superscript));
            let mut exponent = self.number(digits.trim_start_matches('-'), place)?;
            if digits.starts_with('-') {
                exponent = self.tree.add(Kind::Sum(vec![(true, exponent)]), place);
            }
            base = self.raised(base, exponent);
        }
        let mut exponents: Vec<(bool, Expression)> = Vec::new();
        let mut is_negative = false;
        for part in parts {
            match part.as_rule() {
                Rule::power_operator => is_negative = false,
                Rule::sign => is_negative ^= part.as_str() != "+",
                _ => exponents.push((is_negative, self.power(part)?)),
            }
        }
        // Right-associative: fold the exponents from the last to the first.
        let mut folded: Option<Expression> = None;
        for (is_negative, exponent) in exponents.into_iter().rev() {
            let raised = match folded {
                Some(above) => self.raised(exponent, above),
                None => exponent,
            };
            let span = self.tree.span(raised);
            folded = Some(if is_negative { self.tree.add(Kind::Sum(vec![(true, raised)]), span) } else { raised });
        }
        Ok(match folded {
            Some(exponent) => self.raised(base, exponent),
            None => base,
        })
    }

    fn raised(&mut self, base: Expression, exponent: Expression) -> Expression {
        let span = self.tree.span(base).to(self.tree.span(exponent));
        self.tree.add(Kind::Power(base, exponent), span)
    }

    fn primary(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::number => return self.number(pair.as_str(), whole),
            Rule::text => Kind::Text(self.text(whole).trim_matches('"').to_owned()),
            Rule::pi => Kind::Name(Name { text: "pi".to_owned(), span: whole }),
            Rule::derivative => Kind::Unknown(self.derivative(pair)?),
            Rule::differential => Kind::Operator(self.derivative(pair)?.derivative),
            Rule::sought => {
                let mut parts = pair.into_inner();
                let unknown = self.unknown(&parts.next().ok_or_else(internal)?);
                if let Some(coordinates) = parts.next() {
                    self.coordinates(&coordinates)?;
                }
                Kind::Unknown(Unknown { span: whole, ..unknown })
            }
            Rule::partial => self.partial(pair)?,
            Rule::application => {
                let mut parts = pair.into_inner();
                let name = self.name(&parts.next().ok_or_else(internal)?);
                match parts.next() {
                    Some(arguments) => Kind::Application(name, self.bracket(&arguments)?),
                    None => Kind::Name(name),
                }
            }
            Rule::bracketed => {
                let values = self.bracket(&pair)?;
                match values.as_slice() {
                    // A sum of one term: the brackets must stay, `(a(x))^2` is not `a(x)^2`.
                    [only] => Kind::Sum(vec![(false, *only)]),
                    _ => Kind::Vector(values),
                }
            }
            Rule::absolute => Kind::Call(Function::Abs, self.bracket(&pair)?),
            Rule::root => {
                let mut parts: Vec<Parsed<'_>> = pair.into_inner().collect();
                let mut value = self.primary(parts.pop().ok_or_else(internal)?)?;
                for _ in parts {
                    value = self.tree.add(Kind::SquareRoot(vec![value]), whole);
                }
                return Ok(value);
            }
            Rule::call => return self.call_pair(pair),
            _ => return Err(internal()),
        };
        Ok(self.tree.add(kind, whole))
    }

    fn call_pair(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut parts = pair.into_inner().peekable();
        let called = called(&parts.next().ok_or_else(internal)?)?;
        let exponent = parts.next_if(|part| part.as_rule() == Rule::function_power);
        let argument = parts.next().ok_or_else(internal)?;
        let arguments = if argument.as_rule() == Rule::bare_argument {
            let place = self.span(&argument);
            let mut factors: Vec<(bool, Expression)> = Vec::new();
            let mut has_coordinate = None;
            for part in argument.into_inner() {
                let here = self.span(&part);
                if let Some(end) = has_coordinate {
                    let parts = [Span::new(place.start, end), here].map(|span| self.text(span));
                    return Err(ambiguous_argument(called.name(), self.text(place), parts).at(whole));
                }
                let factor = self.power(part)?;
                // `v (1-t)` is one application to the grammar, and still a coordinate with something after it.
                if let Some(end) = self.applied_coordinate(factor) {
                    let parts = [Span::new(place.start, end), Span::new(end, here.end)].map(|span| self.text(span));
                    return Err(ambiguous_argument(called.name(), self.text(place), parts).at(whole));
                }
                has_coordinate = self.mentions_coordinate(factor).then_some(here.end);
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

    fn call(&mut self, called: Called, arguments: Vec<Expression>, span: Span) -> Expression {
        let kind = match called {
            Called::Function(function) => Kind::Call(function, arguments),
            Called::SquareRoot => Kind::SquareRoot(arguments),
        };
        self.tree.add(kind, span)
    }

    fn number(&mut self, text: &str, span: Span) -> Result<Expression, Diagnostic> {
        let digits = match text.trim() {
            "½" => "0.5",
            "¼" => "0.25",
            "¾" => "0.75",
            // The zero vector as papers print it.
            "𝟎" => "0",
            digits => digits,
        };
        let value = Number::parse(digits).ok_or_else(|| {
            Diagnostic::new(Code::NumberOutOfRange, format!("`{}` is too large for a double", text.trim()))
                .at(span)
                .hint("the largest is about 1.8e308")
        })?;
        Ok(self.tree.add(Kind::Number(value), span))
    }

    /// The values inside the bracket that `pair` ends with.
    pub fn bracket(&mut self, pair: &Parsed<'_>) -> Result<Vec<Expression>, Diagnostic> {
        let hole = pair.clone().into_inner().find(|part| part.as_rule() == Rule::hole).ok_or_else(internal)?;
        let inside = self.offset + hole.as_span().start();
        self.brackets.take(inside).ok_or_else(internal)
    }

    /// The name behind a `name` pair.
    pub fn name(&self, pair: &Parsed<'_>) -> Name {
        Name { text: canonical_name(pair.as_str().trim_end()), span: self.span(pair) }
    }

    /// `S` or `S_x`.
    pub fn unknown(&self, pair: &Parsed<'_>) -> Unknown {
        let component = pair.clone().into_inner().next().and_then(|part| coordinate(part.as_str()));
        Unknown { component, derivative: Derivative::NONE, span: self.span(pair) }
    }

    /// `∂⁴S/∂u²∂v²`, or an operator `∂⁴/∂u²∂v²`; the order above the bar must be the sum of those below.
    pub fn derivative(&mut self, pair: Parsed<'_>) -> Result<Unknown, Diagnostic> {
        let whole = self.span(&pair);
        let text = self.text(whole).to_owned();
        let (mut above, mut component, mut orders) = (1, None, Derivative::NONE);
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::order => above = order(part.as_str()),
                Rule::unknown => component = self.unknown(&part).component,
                Rule::coordinate => component = coordinate(part.as_str()),
                Rule::coordinates => self.coordinates(&part)?,
                Rule::by => add_order(&mut orders, part),
                _ => {}
            }
        }
        let below = orders.u.saturating_add(orders.v).saturating_add(orders.t);
        if above != below {
            let message = format!("`{text}` has order {above} above the bar and {below} below it");
            return Err(Diagnostic::new(Code::UnexpectedText, message)
                .at(whole)
                .hint("both must be equal, as in `∂⁴S/∂u²∂v²` or `d4S/du2dv2`"));
        }
        Ok(Unknown { component, derivative: orders, span: whole })
    }

    /// Checks that a bracket holds `u, v` or `u, v, t`.
    pub fn coordinates(&mut self, pair: &Parsed<'_>) -> Result<(), Diagnostic> {
        let values = self.bracket(pair)?;
        let names: Vec<Option<&str>> = values
            .iter()
            .map(|value| match &self.tree.node(*value).kind {
                Kind::Name(name) => Some(name.text.as_str()),
                _ => None,
            })
            .collect();
        if matches!(names.as_slice(), [Some("u"), Some("v")] | [Some("u"), Some("v"), Some("t")]) {
            return Ok(());
        }
        Err(Diagnostic::new(Code::UnexpectedText, "the surface is written `S`, `S(u, v)` or `S(u, v, t)`")
            .at(self.span(pair))
            .hint("where it is taken is said by `at u = …:`; a factor stands before it"))
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

fn called(pair: &Parsed<'_>) -> Result<Called, Diagnostic> {
    match pair.as_str().trim_end() {
        "sqrt" => Ok(Called::SquareRoot),
        name => Function::named(name).map(Called::Function).ok_or_else(internal),
    }
}

fn superscript_digits(text: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    text.trim_end()
        .chars()
        .map(|c| match DIGITS.iter().position(|digit| *digit == c) {
            Some(value) => char::from_digit(u32::try_from(value).unwrap_or(0), 10).unwrap_or(c),
            None if c == '⁻' => '-',
            None => c,
        })
        .collect()
}

/// The number in `²`, `^2`, `^{2}` or `2`; absurd orders are cut off far above every limit.
pub fn order(text: &str) -> usize {
    let digits: String = superscript_digits(text).chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap_or(usize::MAX / 8)
}

/// Adds one `∂u²` below the bar.
fn add_order(orders: &mut Derivative, by: Parsed<'_>) {
    let (mut variable, mut times) = ("", 1);
    for piece in by.into_inner() {
        match piece.as_rule() {
            Rule::variable => variable = piece.as_str(),
            Rule::order => times = order(piece.as_str()),
            _ => {}
        }
    }
    let sum = match variable {
        "u" => &mut orders.u,
        "v" => &mut orders.v,
        _ => &mut orders.t,
    };
    *sum = sum.saturating_add(times);
}
