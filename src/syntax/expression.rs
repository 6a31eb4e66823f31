//! Parsed expressions to the tree, refusing those with two plausible readings.

use super::ambiguity::{Run, ambiguous_power, refuse_ambiguous_division};
use super::ast::{Expression, Kind, Name, Tree, Unknown};
use super::brackets::Brackets;
use super::parser::{Parsed, Rule};
use super::places::Places;
use super::preflight::Prepared;
use super::statement::internal;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Function, Number, canonical_name};

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
    pub fn text(&self, span: Span) -> &str {
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
                    let begins_with_call = first_primary(&part) == Some(Rule::call);
                    let run = self.run(part)?;
                    if divides {
                        refuse_ambiguous_division(last_run.as_ref(), &run)?;
                    } else if let Some(before) = last_run.as_ref().filter(|_| !begins_with_call) {
                        self.refuse_ambiguous_product(before, &run)?;
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
        let mut run = Run { factors: Vec::new(), text, span, head: 0, bare_call: None, open_power: None };
        let mut before: Option<Parsed<'_>> = None;
        for part in pair.into_inner() {
            let here = self.span(&part);
            if let Some(before) = before.replace(part.clone()) {
                self.refuse_neighbours(&before, &part)?;
            }
            run.bare_call = self.bare_call(&part);
            run.open_power = self.open_power(&part);
            if run.factors.is_empty() {
                run.head = here.end - span.start;
            }
            run.factors.push(self.power(part)?);
        }
        Ok(run)
    }

    /// A `power`, `bare_factor` or `exponent` pair: a primary with superscripts and exponents.
    pub fn power(&mut self, pair: Parsed<'_>) -> Result<Expression, Diagnostic> {
        let whole = self.span(&pair);
        let mut parts = pair.into_inner().peekable();
        let first = parts.next().ok_or_else(internal)?;
        if let (Rule::differential, Some(power)) = (first.as_rule(), parts.peek()) {
            return Err(ambiguous_power(self.text(self.span(&first)), self.span(power)));
        }
        let mut root = self.plain_root(&first);
        let mut base = self.primary(first)?;
        if let (Some(root), Some(superscript)) = (root, parts.peek().filter(|part| part.as_rule() == Rule::superscript))
        {
            return Err(self.ambiguous_root(root, Span::new(self.span(superscript).start, whole.end)));
        }
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
                Rule::power_operator => {
                    if let Some(root) = root {
                        return Err(self.ambiguous_root(root, Span::new(self.span(&part).start, whole.end)));
                    }
                    is_negative = false;
                }
                Rule::sign => is_negative ^= part.as_str() != "+",
                _ => {
                    root = part.clone().into_inner().next().and_then(|first| self.plain_root(&first));
                    exponents.push((is_negative, self.power(part)?));
                }
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

    /// A base and its exponent.
    pub fn raised(&mut self, base: Expression, exponent: Expression) -> Expression {
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
            Rule::application | Rule::adjacent => {
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
            Rule::applied => return self.applied(pair),
            _ => return Err(internal()),
        };
        Ok(self.tree.add(kind, whole))
    }

    /// A number as written.
    pub fn number(&mut self, text: &str, span: Span) -> Result<Expression, Diagnostic> {
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
}

/// What the first factor of a `run` begins with.
fn first_primary(run: &Parsed<'_>) -> Option<Rule> {
    run.clone().into_inner().next()?.into_inner().next().map(|first| first.as_rule())
}

/// Superscripts as plain digits.
pub fn superscript_digits(text: &str) -> String {
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
