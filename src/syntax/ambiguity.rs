//! Texts with two plausible readings: each is refused, and both readings are shown.

use super::ast::Expression;
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

/// `e^2t` has two readings, and two numbers side by side are a slip.
pub fn refuse_ambiguous_neighbours(
    (left, left_span): (&str, Span),
    (right, right_span): (&str, Span),
) -> Result<(), Diagnostic> {
    let touches = left_span.end == right_span.start;
    let compact: String = left.chars().filter(|c| !c.is_whitespace()).collect();
    let exponent = compact.replace("**", "^");
    let exponent = exponent.strip_prefix("e^").filter(|exponent| {
        exponent.trim_start_matches(['-', '−', '+']).chars().all(|c| c.is_ascii_digit() || c == '.')
    });
    if let (true, Some(exponent)) = (touches, exponent) {
        let message = format!("`{left}{right}` can be read in two ways");
        return Err(Diagnostic::new(Code::AmbiguousExpression, message)
            .at(left_span.to(right_span))
            .hint(format!("write `e^({exponent}*{right})` or `{left}*{right}`")));
    }
    let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | '½' | '¼' | '¾'));
    if is_number(right) && is_number(left) {
        return Err(Diagnostic::new(Code::UnexpectedText, "two numbers stand side by side")
            .at(left_span.to(right_span))
            .hint(format!("write one number, or `{left}*{right}`")));
    }
    Ok(())
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
    if divisor.factors.len() > 1 {
        return ambiguous(
            "what is divided by?",
            format!("write `{above}/({below})` or `({above}/{head})*{}`", rest.trim()),
        );
    }
    Ok(())
}
