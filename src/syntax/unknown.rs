//! The surface to be found, its components and its derivatives: `S_x`, `∂⁴S/∂u²∂v²`.

use super::ast::{Kind, Unknown};
use super::expression::{Builder, superscript_digits};
use super::parser::{Parsed, Rule};
use super::statement::coordinate;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;

impl Builder<'_> {
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
