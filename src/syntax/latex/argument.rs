//! What TeX does not show: where an argument without brackets ends, and braces that only hold things together.

use super::block::Block;
use super::commands::{self, Meaning};
use super::group::{Argument, Unseen};
use super::token::{self, Token, TokenKind};
use crate::diagnostic::{Code, Diagnostic, Span};

impl Block<'_> {
    /// Notes a token of a group whose braces nobody sees.
    pub(super) fn count_unseen(&mut self, token: &Token<'_>) {
        let Some(unseen) = self.groups.unseen() else { return };
        match token.kind {
            TokenKind::Close | TokenKind::LineEnd => return,
            TokenKind::Symbol => unseen.has_operator |= "+-−=,;:/*·×÷&".contains(token.text),
            TokenKind::Break => unseen.has_operator = true,
            TokenKind::Command => match commands::meaning(token.text) {
                Some(Meaning::Nothing | Meaning::Sizing) => return,
                Some(Meaning::Mark(mark)) => unseen.has_operator |= mark != "(",
                _ => {}
            },
            _ => {}
        }
        unseen.atoms += 1;
    }

    /// Braces that hold more than one thing would be brackets here, and are nothing on paper.
    pub(super) fn check_unseen(&self, unseen: Unseen, place: Span, is_argument: bool) -> Result<(), Diagnostic> {
        // `\sin{5v}` is `\sin 5v` either way.
        let is_one = if is_argument { !unseen.has_operator } else { unseen.atoms <= 1 };
        if is_one {
            return Ok(());
        }
        let text = self.source.get(place.start..place.end).unwrap_or("");
        let inside = text.trim_matches(['{', '}']).trim();
        Err(Diagnostic::new(Code::AmbiguousExpression, format!("`{text}` can be read in two ways"))
            .at(place)
            .marked("TeX does not show these braces")
            .hint(format!("write `({inside})` for a bracket; without one leave the braces out")))
    }

    /// Refuses a factor behind `\sin\frac{1}{2}`, whose argument would end here and goes on in the plain notation.
    pub(super) fn check_argument_ends(&self, argument: Argument, end: usize) -> Result<(), Diagnostic> {
        let Some(next) = self.factor_ahead() else { return Ok(()) };
        let slice = |start: usize, end: usize| self.source.get(start..end).unwrap_or("").trim();
        let text = slice(argument.function.start, end);
        let function = slice(argument.function.start, argument.start);
        let inside = slice(argument.start, end);
        let inside = inside.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')).unwrap_or(inside);
        let whole = matches!(next.kind, TokenKind::Letter | TokenKind::Number);
        let next_text = format!("{}{}", slice(next.span.start, next.span.end), if whole { "" } else { "…" });
        Err(Diagnostic::new(Code::AmbiguousExpression, format!("`{text} {next_text}` can be read in two ways"))
            .at(Span::new(argument.function.start, next.span.end))
            .marked(format!("does `{next_text}` belong to the argument?"))
            .hint(format!(
                "write `{function}({inside} {next_text})` if it does, `{function}({inside}) {next_text}` if it does not"
            )))
    }

    /// The next token, if it could go on with an argument: a factor, an exponent, a product or a divisor.
    fn factor_ahead(&self) -> Option<Token<'_>> {
        let mut at = self.at;
        loop {
            let token = token::next(self.source, at)?;
            at = token.span.end;
            let is_factor = match token.kind {
                TokenKind::LineEnd if !self.ends_rows() => continue,
                TokenKind::Letter | TokenKind::Number | TokenKind::Open => true,
                TokenKind::Symbol if ["*", "·", "×"].contains(&token.text) => !self.function_follows(at),
                TokenKind::Symbol => ["(", "[", "/", "÷", "^", "√"].contains(&token.text),
                TokenKind::Command => match commands::meaning(token.text)? {
                    Meaning::Nothing => continue,
                    Meaning::Letter(_) | Meaning::Fraction | Meaning::Root | Meaning::Bold => true,
                    Meaning::Mark("*" | "·" | "×") => !self.function_follows(at),
                    Meaning::Mark(mark) => mark == "(" || mark == "÷",
                    Meaning::Sizing => token.text != "right" && !token.text.ends_with('r'),
                    Meaning::Bar => token.text == "lvert",
                    // A function ends the argument, as in the plain notation.
                    Meaning::Upright => !self.is_upright_function(at),
                    _ => false,
                },
                _ => false,
            };
            return is_factor.then_some(token);
        }
    }

    /// Whether what stands at `at` begins with a function, which ends the argument before it.
    fn function_follows(&self, at: usize) -> bool {
        let Some(token) = token::next(self.source, at).filter(|token| token.kind == TokenKind::Command) else {
            return false;
        };
        match commands::meaning(token.text) {
            Some(Meaning::Function(_)) => true,
            Some(Meaning::Upright) => self.is_upright_function(token.span.end),
            _ => false,
        }
    }

    /// Whether `{name}` at `at` is the name of a function.
    fn is_upright_function(&self, at: usize) -> bool {
        let rest = self.source.get(at..).unwrap_or("").trim_start();
        let name = rest.strip_prefix('{').and_then(|rest| rest.split_once('}'));
        name.is_some_and(|(name, _)| commands::upright_function(name.trim()).is_some())
    }

    /// `2e-3` is a number in the plain notation, and 2·e - 3 for TeX.
    pub(super) fn check_exponent_letter(&self, number: &Token<'_>) -> Result<(), Diagnostic> {
        let rest = self.source.get(number.span.end..).unwrap_or("");
        let Some(after) = rest.strip_prefix(['e', 'E']) else { return Ok(()) };
        let unsigned = after.strip_prefix(['+', '-', '−']).unwrap_or(after);
        let digits = unsigned.find(|c: char| !c.is_ascii_digit()).unwrap_or(unsigned.len());
        if digits == 0 {
            return Ok(());
        }
        let end = number.span.end + rest.len() - unsigned.len() + digits;
        let text = self.source.get(number.span.start..end).unwrap_or("");
        let letter = rest.get(..1).unwrap_or("e");
        let power = after.get(..after.len() - unsigned.len() + digits).unwrap_or("");
        let mantissa = number.text;
        Err(Diagnostic::new(Code::AmbiguousExpression, format!("`{text}` can be read in two ways"))
            .at(Span::new(number.span.start, end))
            .hint(format!(
                r"write `{mantissa} \cdot 10^{{{}}}` for the number, `{mantissa} {letter} {power}` for a product with `{letter}`",
                power.trim_start_matches('+')
            )))
    }
}
