//! Exponents: `^2`, `^t`, `^{-t}`.

use super::block::Block;
use super::commands::{self, Meaning};
use super::construct::missing;
use super::group::Group;
use super::spelling::Piece;
use super::token::{self, Token, TokenKind};
use super::unsupported;
use crate::diagnostic::{Code, Diagnostic, Span};

impl<'a> Block<'a> {
    /// Refuses `v^2^2`, which TeX refuses too; `mark` is the first exponent.
    pub(super) fn check_one_exponent(&self, mark: Span) -> Result<(), Diagnostic> {
        let second = self.peek().filter(|next| next.is_symbol("^"));
        second.map_or(Ok(()), |second| {
            Err(Diagnostic::new(Code::AmbiguousExpression, "two exponents of one base can be read in two ways")
                .at(mark.to(second.span))
                .hint("write `{a^b}` for the exponent, or brackets round the first power: `(v^a)^b`"))
        })
    }

    /// `^2`, `^t`, `^{…}`: as in TeX an exponent without braces is one character.
    pub(super) fn exponent(&mut self, mark: &Token<'a>) -> Result<(), Diagnostic> {
        self.mark("^", mark);
        let Some(next) = self.peek() else { return Ok(()) };
        if next.kind == TokenKind::Open {
            return self.exponent_in_braces(&next);
        }
        let letter = match (next.kind, commands::meaning(next.text)) {
            (TokenKind::Letter, _) => Some(next.text.to_owned()),
            (TokenKind::Number, _) if next.text.len() == 1 => Some(next.text.to_owned()),
            (TokenKind::Command, Some(Meaning::Letter(letter))) => Some(letter),
            // A bracket or a fraction is read as any other.
            (TokenKind::Symbol, _) if next.text == "(" => return Ok(()),
            (TokenKind::Command, Some(Meaning::Fraction | Meaning::Root | Meaning::Sizing)) => return Ok(()),
            _ => None,
        };
        let is_missing = match next.kind {
            TokenKind::Close | TokenKind::Break | TokenKind::LineEnd | TokenKind::Dollars => true,
            TokenKind::Symbol => ",;.=)]&+*/".contains(next.text),
            TokenKind::Command => ["]", "end", "quad", "qquad", "right"].contains(&next.text),
            _ => false,
        };
        if is_missing {
            return Err(missing("an exponent", mark.span));
        }
        let Some(letter) = letter else {
            return Err(unsupported("an exponent of several characters without braces", mark.span.to(next.span))
                .hint("write `^{…}`"));
        };
        self.at = next.span.end;
        // TeX shows where it ends; what touches it in the text may have been meant as part of it all the same.
        let touches = |after: Token<'_>| {
            after.span.start == self.at && matches!(after.kind, TokenKind::Letter | TokenKind::Number)
        };
        let is_apart = next.kind != TokenKind::Number && !self.peek().is_some_and(touches);
        let exponent = if is_apart { format!("({letter})") } else { letter };
        self.spelling.put(&exponent, next.span, Piece::Word);
        self.check_one_exponent(mark.span)
    }

    fn exponent_in_braces(&mut self, open: &Token<'a>) -> Result<(), Diagnostic> {
        let tokens = std::iter::successors(token::next(self.source, open.span.end), |token| {
            token::next(self.source, token.span.end)
        });
        let tokens: Vec<Token<'_>> = tokens.take(3).collect();
        let is_minus = |token: &Token<'_>| token.is_symbol("-") || token.is_symbol("−");
        // A number needs no brackets: orders of derivatives and powers of functions have none.
        let number = match tokens.as_slice() {
            [number, close, ..] if close.kind == TokenKind::Close => Some((None, number, close)),
            [minus, number, close] if is_minus(minus) && close.kind == TokenKind::Close => {
                Some((Some(minus), number, close))
            }
            _ => None,
        };
        self.at = open.span.end;
        self.check_filled(open, "an exponent")?;
        match number.filter(|(_, number, _)| number.kind == TokenKind::Number) {
            Some((minus, number, close)) => {
                if let Some(minus) = minus {
                    self.mark("-", minus);
                }
                self.spelling.put(number.text, number.span, Piece::Word);
                self.spelling.extend(close.span.end);
                self.at = close.span.end;
                self.check_one_exponent(open.span)?;
            }
            None => {
                self.groups.open(Group::Exponent, open.span);
                self.mark("(", open);
            }
        }
        Ok(())
    }
}
