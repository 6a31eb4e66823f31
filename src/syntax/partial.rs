//! Derivatives of primary surfaces: `∂²S1(u1, v, t)/∂u∂v`.

use super::ast::{Kind, Name, Partial};
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use super::statement::internal;
use super::unknown::order;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::canonical_name;

impl Builder<'_> {
    /// The derivative behind a `partial` pair; the order above the bar must be the sum of those below.
    pub fn partial(&mut self, pair: Parsed<'_>) -> Result<Kind, Diagnostic> {
        let whole = self.span(&pair);
        let (mut above, mut surface, mut arguments, mut orders) = (1, None, None, Vec::new());
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::order => above = order(part.as_str()),
                Rule::name => surface = Some(self.name(&part)),
                Rule::arguments => arguments = Some(self.bracket(&part)?),
                Rule::by | Rule::by_name => orders.push(self.own_parameter(part)?),
                _ => {}
            }
        }
        let below = orders.iter().fold(0_usize, |sum, (_, order)| sum.saturating_add(*order));
        if above != below {
            let message = format!("the derivative has order {above} above the bar and {below} below it");
            return Err(Diagnostic::new(Code::UnexpectedText, message)
                .at(whole)
                .hint("both must be equal, as in `∂²S1(u1, v, t)/∂u∂v` or `d2S1(u1, v, t)/dudv`"));
        }
        let (Some(surface), Some(arguments)) = (surface, arguments) else { return Err(internal()) };
        Ok(Kind::Partial(Partial { surface, arguments, orders }))
    }

    /// `∂u²` below the bar.
    fn own_parameter(&self, by: Parsed<'_>) -> Result<(Name, usize), Diagnostic> {
        let (mut parameter, mut times) = (None, 1);
        for piece in by.into_inner() {
            match piece.as_rule() {
                Rule::variable | Rule::name => {
                    let text = canonical_name(piece.as_str().trim_end());
                    parameter = Some(Name { text, span: self.span(&piece) });
                }
                Rule::order | Rule::superscript | Rule::integer => times = order(piece.as_str()),
                _ => {}
            }
        }
        Ok((parameter.ok_or_else(internal)?, times))
    }
}
