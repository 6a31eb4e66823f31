//! Texts with two plausible readings: each is refused, and both readings are shown.

use super::ast::Expression;
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use crate::diagnostic::{Code, Diagnostic, Span};

/// Factors side by side.
pub struct Run {
    /// The factors.
    pub factors: Vec<Expression>,
    /// Their text.
    pub text: String,
    /// Their place.
    pub span: Span,
    /// Bytes of the first factor.
    pub head: usize,
    /// Name and argument of a last factor like `sin πt`, whose end is open.
    pub bare_call: Option<(String, String)>,
    /// Base and exponent of a last factor like `e^-t` or `v^1`, which a divisor may belong to.
    pub open_power: Option<(String, String)>,
}

/// A factor that does not show where it ends: a root, or an exponent.
struct OpenEnd {
    /// The sign of the root, or the base with its operator.
    head: Span,
    /// What may go on.
    end: Span,
    kind: OpenKind,
}

#[derive(Clone, Copy, PartialEq)]
enum OpenKind {
    /// `√2`
    Root,
    /// `e^2`, `2^3`
    Number,
    /// `e^-k`
    Name,
    /// Of anything else: `v^2` and `v^n` are parts of polynomials.
    Polynomial,
}

/// u, v or t, which end a bare argument.
pub fn is_coordinate(name: &str) -> bool {
    matches!(name, "u" | "v" | "t")
}

/// `cos v t`: once an argument has its coordinate, what follows may belong to it or not.
pub fn ambiguous_argument(function: &str, argument: &str, [first, next]: [&str; 2]) -> Diagnostic {
    let message = format!("`{function} {argument}` can be read in two ways");
    Diagnostic::new(Code::AmbiguousExpression, message)
        .marked(format!("does `{next}` belong to the argument?"))
        .hint(format!("write `{function}({argument})` if it does, `{function}({first})*{next}` if it does not"))
}

/// `∂²/∂u² ²`: a power of the operator, or of what stands below its bar?
pub fn ambiguous_power(operator: &str, power: Span) -> Diagnostic {
    Diagnostic::new(Code::AmbiguousExpression, format!("a power behind `{operator}` can be read in two ways"))
        .at(power)
        .hint(format!(
            "for the operator applied twice write `({operator})²`; an order stands above and below the bar: `∂⁴/∂u⁴`"
        ))
}

/// `sin πt/2` and `a/2b` can each be read in two ways: show both.
pub fn refuse_ambiguous_division(before: Option<&Run>, divisor: &Run) -> Result<(), Diagnostic> {
    let Some(before) = before else { return Ok(()) };
    let (above, below) = (&before.text, &divisor.text);
    let ambiguous = |question: &str, hint: String| {
        Err(Diagnostic::new(Code::AmbiguousExpression, format!("`{above}/{below}` can be read in two ways"))
            .at(before.span.to(divisor.span))
            .marked(question)
            .hint(hint))
    };
    let (head, rest) = below.split_at_checked(divisor.head).unwrap_or((below, ""));
    if let Some((function, argument)) = &before.bare_call {
        let (inside, outside) = (format!("{function}(({argument})/{head})"), format!("{function}({argument})/{head}"));
        return ambiguous(
            "does the division belong to the argument?",
            format!("write `{inside}` if it does, `{outside}` if it does not"),
        );
    }
    if let Some((base, exponent)) = &before.open_power {
        return ambiguous(
            "does the division belong to the exponent?",
            format!("write `{base}({exponent}/{head})` if it does, `({base}{exponent})/{head}` if it does not"),
        );
    }
    if divisor.factors.len() > 1 {
        return ambiguous(
            "what is divided by?",
            format!("write `{above}/({below})` or `({above}/{head})*{}`", rest.trim()),
        );
    }
    Ok(())
}

impl Builder<'_> {
    /// `e^2t`, `e^-k t` and `√2t` do not show where the exponent or the root ends; two numbers side by side are a slip.
    pub fn refuse_neighbours(&self, left: &Parsed<'_>, right: &Parsed<'_>) -> Result<(), Diagnostic> {
        let (left_span, right_span) = (self.span(left), self.span(right));
        let (left_text, right_text) = (self.text(left_span), self.text(right_span));
        let touches = left_span.end == right_span.start;
        let is_ambiguous = |open: &OpenEnd| match open.kind {
            OpenKind::Root | OpenKind::Number => touches,
            OpenKind::Name => touches || is_operand(right),
            OpenKind::Polynomial => false,
        };
        if let Some(open) = self.open_end(left).filter(is_ambiguous) {
            let (head, end) = (self.text(open.head), self.text(open.end));
            let whole = left_span.to(right_span);
            let message = format!("`{}` can be read in two ways", self.text(whole));
            return Err(Diagnostic::new(Code::AmbiguousExpression, message)
                .at(whole)
                .hint(format!("write `{head}({end}*{right_text})` or `{left_text}*{right_text}`")));
        }
        let is_number =
            |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '½' | '¼' | '¾'));
        if is_number(right_text) && is_number(left_text) {
            return Err(Diagnostic::new(Code::UnexpectedText, "two numbers stand side by side")
                .at(left_span.to(right_span))
                .hint(format!("write one number, or `{left_text}*{right_text}`")));
        }
        Ok(())
    }

    /// The end of a root or an exponent that nothing marks; of LaTeX only what is unmarked there too.
    fn open_end(&self, factor: &Parsed<'_>) -> Option<OpenEnd> {
        let whole = self.span(factor);
        let mut parts = factor.clone().into_inner();
        let first = parts.next()?;
        let open = |start: usize, kind: OpenKind| {
            Some(OpenEnd { head: Span::new(whole.start, start), end: Span::new(start, whole.end), kind })
        };
        // Also the braces of LaTeX, which stand in the source only.
        if self.text(whole).ends_with([')', ']', '}', '|']) {
            return None;
        }
        if self.plain_root(&first).is_some() {
            return open(whole.start + '√'.len_utf8(), OpenKind::Root);
        }
        let operator = parts.find(|part| part.as_rule() == Rule::power_operator)?;
        let last = parts.last()?.into_inner().next()?;
        let is_constant =
            first.as_rule() == Rule::number || (first.as_rule() == Rule::application && first.as_str().trim() == "e");
        let kind = match last.as_rule() {
            _ if !is_constant => OpenKind::Polynomial,
            Rule::adjacent => OpenKind::Name,
            Rule::number | Rule::pi | Rule::root => OpenKind::Number,
            _ => return None,
        };
        open(self.span(&operator).end, kind)
    }

    /// Base and exponent of `e^-k` and `v^1`, before a divisor: `e^-k/2` and `v^1/2` would be read in two ways.
    pub fn open_power(&self, factor: &Parsed<'_>) -> Option<(String, String)> {
        let open = self.open_end(factor).filter(|open| open.kind != OpenKind::Root)?;
        let (head, end) = (self.text(open.head), self.text(open.end));
        let is_one = end.trim_start_matches(['-', '−', '–', ' ']) == "1";
        (is_one || open.kind == OpenKind::Name).then(|| (head.to_owned(), end.to_owned()))
    }

    /// The place of a root that is written `√`: nothing shows how far it reaches.
    pub fn plain_root(&self, part: &Parsed<'_>) -> Option<Span> {
        let place = self.span(part);
        (part.as_rule() == Rule::root && self.text(place).starts_with('√')).then_some(place)
    }

    /// `√v²`: the root of a power, or the power of a root?
    pub fn ambiguous_root(&self, root: Span, power: Span) -> Diagnostic {
        let (text, power_text) = (self.text(root), self.text(power));
        let inside = text.trim_start_matches('√');
        Diagnostic::new(Code::AmbiguousExpression, format!("`{text}{power_text}` can be read in two ways"))
            .at(root.to(power))
            .marked("is the power below the root?")
            .hint(format!("write `√({inside}{power_text})` if it is, `({text}){power_text}` if it is not"))
    }

    /// `sin 2*t`: the argument of `sin 2` ends at the operator, and in `sin 2t` it does not.
    pub fn refuse_ambiguous_product(&self, before: &Run, run: &Run) -> Result<(), Diagnostic> {
        let Some((function, argument)) = &before.bare_call else { return Ok(()) };
        let place = before.span.to(run.span);
        let whole = self.text(place);
        let (start, end) = (before.span.end - place.start, run.span.start - place.start + run.head);
        let (factor, head) = (whole.get(start..end).unwrap_or(""), run.text.get(..run.head).unwrap_or(&run.text));
        Err(Diagnostic::new(Code::AmbiguousExpression, format!("`{whole}` can be read in two ways"))
            .at(place)
            .marked(format!("does `{head}` belong to the argument?"))
            .hint(format!(
                "write `{function}({argument}{factor})` if it does, `{function}({argument}){factor}` if it does not"
            )))
    }
}

/// Whether a factor begins with neither a function, a bracket nor a derivative.
fn is_operand(factor: &Parsed<'_>) -> bool {
    factor.clone().into_inner().next().is_some_and(|first| match first.as_rule() {
        Rule::number | Rule::pi | Rule::absolute | Rule::root => true,
        // With arguments it may be a function, which is known when names are.
        Rule::application => !first.as_str().trim_end().ends_with(')'),
        _ => false,
    })
}
