//! One block of LaTeX to the plain notation, token by token.

use super::commands::{self, Meaning};
use super::group::{Group, Groups};
use super::spelling::{Piece, Spelling};
use super::token::{self, Token, TokenKind};
use super::{Opening, unsupported};
use crate::diagnostic::{Code, Diagnostic, Span};

/// A block that is being read.
pub struct Block<'a> {
    pub(super) source: &'a str,
    opening: Opening,
    /// The `$$`, `\[` or `\begin`.
    start: Span,
    /// Whether it states constraints, row by row; otherwise it is part of a line.
    is_list: bool,
    pub(super) spelling: &'a mut Spelling,
    /// Where the next token is looked for.
    pub(super) at: usize,
    pub(super) groups: Groups,
    row: Row,
    /// The token before this one.
    previous: Option<Token<'a>>,
    /// The function whose argument has not begun.
    pub(super) function: Option<Span>,
}

/// How far a row has been read.
#[derive(Default)]
struct Row {
    /// Whether anything stands before the token at hand.
    is_begun: bool,
    /// Whether a `=` stands before it, after the last separator.
    has_equals: bool,
    /// Whether the row began with `u =` and its value has not ended.
    is_position: bool,
}

impl<'a> Block<'a> {
    /// The block that `opening` opens at `at`.
    pub fn new(source: &'a str, opening: Opening, at: usize, is_list: bool, spelling: &'a mut Spelling) -> Block<'a> {
        // A `\begin` is read as any other.
        let begin = if opening == Opening::Environment { at } else { at + 2 };
        Block {
            source,
            opening,
            start: Span::new(at, at + 2),
            is_list,
            spelling,
            at: begin,
            groups: Groups::default(),
            row: Row::default(),
            previous: None,
            function: None,
        }
    }

    /// Writes the block's plain spelling; the offset behind the block.
    pub fn read(&mut self) -> Result<usize, Diagnostic> {
        // Blanks around it keep it apart from what stands beside it: `a$$t$$` is a product.
        self.spelling.put(" ", self.start, Piece::Mark);
        while let Some(token) = self.peek() {
            self.at = token.span.end;
            let is_end = self.ends(&token);
            if is_end {
                self.groups.check_closed()?;
            } else {
                self.token(token)?;
                self.previous = Some(token);
            }
            if is_end || (self.opening == Opening::Environment && self.groups.is_empty()) {
                self.end_position(token.span);
                self.mark(" ", &token);
                return Ok(self.at);
            }
        }
        Err(Diagnostic::new(Code::UnbalancedBracket, "the LaTeX that begins here never ends").at(self.start))
    }

    /// The next token.
    pub(super) fn peek(&self) -> Option<Token<'a>> {
        token::next(self.source, self.at)
    }

    /// The next token that is no line end, taken if it is `wanted`.
    pub(super) fn take(&mut self, wanted: TokenKind) -> Option<Token<'a>> {
        let mut at = self.at;
        loop {
            let token = token::next(self.source, at)?;
            at = token.span.end;
            if token.kind == wanted {
                self.at = at;
                return Some(token);
            }
            if token.kind != TokenKind::LineEnd {
                return None;
            }
        }
    }

    fn ends(&self, token: &Token<'_>) -> bool {
        match self.opening {
            Opening::Dollars => token.kind == TokenKind::Dollars,
            Opening::Bracket => token.is_command("]"),
            Opening::Environment => false,
        }
    }

    fn token(&mut self, token: Token<'a>) -> Result<(), Diagnostic> {
        let is_first = !self.row.is_begun && !token.is_symbol("&") && token.kind != TokenKind::LineEnd;
        let is_rows = token.is_command("begin") && self.groups.is_outside();
        self.row.is_begun |= is_first && !is_rows;
        self.count_unseen(&token);
        let function = self.function;
        match token.kind {
            TokenKind::Letter if is_first && self.opens_position(&token) => {
                self.spelling.put("at", token.span, Piece::Word);
                self.spelling.put(token.text, token.span, Piece::Word);
                self.row.is_position = true;
            }
            TokenKind::Letter => self.letter(token.text, token.span)?,
            TokenKind::Number => self.number(&token)?,
            TokenKind::Open => self.open_brace(&token),
            TokenKind::Close => self.close_brace(&token)?,
            TokenKind::Break => self.row_end(&token)?,
            TokenKind::LineEnd if self.is_list => self.row_end(&token)?,
            TokenKind::LineEnd => self.mark(" ", &token),
            TokenKind::Dollars => return Err(unsupported("`$$` inside another block", token.span)),
            TokenKind::Symbol => self.symbol(&token)?,
            TokenKind::Command => self.command(&token)?,
        }
        // A power of the function and blanks stand before its argument.
        let is_blank = token.kind == TokenKind::Command && commands::meaning(token.text) == Some(Meaning::Nothing);
        if self.function == function && !(token.is_symbol("^") || token.kind == TokenKind::LineEnd || is_blank) {
            self.function = None;
        }
        Ok(())
    }

    /// Whether a line end here ends a row.
    pub(super) fn ends_rows(&self) -> bool {
        self.is_list && self.groups.is_outside()
    }

    pub(super) fn mark(&mut self, text: &str, token: &Token<'_>) {
        self.spelling.put(text, token.span, Piece::Mark);
    }

    /// Whether a row begins with `u =` or `v =`, which opens the constraints there.
    fn opens_position(&self, token: &Token<'_>) -> bool {
        let mut at = token.span.end;
        let mut next = || {
            let token = token::next(self.source, at)?;
            at = token.span.end;
            Some(token)
        };
        let after = next().and_then(|token| if token.is_symbol("&") { next() } else { Some(token) });
        self.is_list
            && self.groups.is_outside()
            && (token.is_letter("u") || token.is_letter("v"))
            && after.is_some_and(|token| token.is_symbol("="))
    }

    /// Ends `u = 0`; whether there was one to end.
    fn end_position(&mut self, place: Span) -> bool {
        let is_position = std::mem::take(&mut self.row.is_position);
        if is_position {
            self.spelling.put(":", place, Piece::Mark);
            self.row.has_equals = false;
        }
        is_position
    }

    /// `\\`, or a line end of a list: both end a row, and components inside a matrix.
    fn row_end(&mut self, token: &Token<'_>) -> Result<(), Diagnostic> {
        let is_break = token.kind == TokenKind::Break;
        match self.groups.last() {
            Some(Group::Matrix(..)) if is_break => self.component_end(token)?,
            None | Some(Group::Rows(_)) => {
                self.end_position(token.span);
                self.mark("\n", token);
                self.row = Row::default();
            }
            Some(_) => self.mark(" ", token),
        }
        Ok(())
    }

    fn symbol(&mut self, token: &Token<'a>) -> Result<(), Diagnostic> {
        let is_outside = self.groups.is_outside();
        match token.text {
            "&" if matches!(self.groups.last(), Some(Group::Matrix(..))) => self.component_end(token)?,
            "&" => {}
            "(" if is_outside && self.is_list && self.equation_number(token.span.start).is_some() => {
                let end = self.equation_number(token.span.start).unwrap_or(token.span.end);
                let number = self.source.get(token.span.start..end).unwrap_or("");
                let inside = number.trim_matches(['(', ')']);
                return Err(Diagnostic::new(
                    Code::AmbiguousExpression,
                    format!("`{number}` can be a factor, or the number of the equation"),
                )
                .at(Span::new(token.span.start, end))
                .hint(format!(r"write `\cdot {inside}` for the factor, `\tag{{{inside}}}` for the number")));
            }
            "(" | "[" => {
                self.groups.open(Group::Bracket(if token.text == "(" { ')' } else { ']' }), token.span);
                self.mark(token.text, token);
            }
            ")" | "]" => {
                let close = if token.text == ")" { ')' } else { ']' };
                self.groups.close(token, |group| *group == Group::Bracket(close))?;
                self.mark(token.text, token);
            }
            "," | ";" if is_outside && self.is_list => {
                if !self.end_position(token.span) {
                    self.mark(token.text, token);
                }
                self.row.has_equals = false;
                self.skip_equation_number();
            }
            ":" if is_outside && self.end_position(token.span) => {}
            "." => self.full_stop(token)?,
            "=" if is_outside && self.is_list => {
                if self.row.is_position && self.row.has_equals {
                    return Err(Diagnostic::new(Code::UnexpectedText, "an equation follows the position on its line")
                        .at(token.span)
                        .hint(r"end the position with a comma, `\quad` or a line break: `u = 0,`"));
                }
                self.row.has_equals = true;
                self.mark(" = ", token);
            }
            "^" => self.exponent(token)?,
            "_" if self.previous.is_some_and(|before| before.is_command("partial") || before.is_symbol("∂")) => {
                return Err(unsupported("a derivative with a subscript", token.span)
                    .hint(r"write `\frac{\partial^2}{\partial u^2}`, or `\frac{\partial^2 S}{\partial u^2}`"));
            }
            "_" if self.previous.is_some_and(|before| before.is_command("log")) => {
                return Err(unsupported("a logarithm to a base other than 10", token.span)
                    .hint(r"write `\frac{\ln(…)}{\ln b}`, or `\log_{10}`"));
            }
            "_" | "'" | "′" => {
                return Err(unsupported(&format!("a `{}` that follows no letter", token.text), token.span)
                    .hint("subscripts and primes come right after the letter: `b_{1}'`, and its power after them"));
            }
            "#" => return Err(unsupported("`#`", token.span).hint("in LaTeX comments begin with `%`")),
            "$" => return Err(unsupported("a single `$`", token.span).hint("`$$` ends what `$$` began")),
            "\"" => return Err(unsupported(&format!("`{}`", token.text), token.span)),
            other => self.mark(other, token),
        }
        Ok(())
    }

    /// A full stop ends a sentence and means nothing; anywhere else it is a slip.
    fn full_stop(&mut self, token: &Token<'_>) -> Result<(), Diagnostic> {
        if self.skip_equation_number() {
            return Ok(());
        }
        let is_end = self.peek().is_none_or(|next| {
            matches!(next.kind, TokenKind::Break | TokenKind::LineEnd | TokenKind::Dollars)
                || ["]", "end", "tag", "quad", "qquad", "label"].iter().any(|name| next.is_command(name))
        });
        if is_end { Ok(()) } else { Err(unsupported("a full stop inside an equation", token.span)) }
    }

    /// Skips `(13)` at the end of a row; only after punctuation or a wide space, since it could be a factor.
    fn skip_equation_number(&mut self) -> bool {
        let end = self.equation_number(self.at);
        self.at = end.unwrap_or(self.at);
        end.is_some()
    }

    /// Where `(13)` or `(24a)` ends, if it stands at `at` and at the end of a row.
    fn equation_number(&self, at: usize) -> Option<usize> {
        let mut tokens =
            std::iter::successors(token::next(self.source, at), |token| token::next(self.source, token.span.end));
        let is_open = tokens.next()?.is_symbol("(") && tokens.next()?.kind == TokenKind::Number;
        let last = tokens.next().filter(|_| is_open)?;
        let last = if last.kind == TokenKind::Letter { tokens.next()? } else { last };
        let follows = tokens.next()?;
        let is_last = self.ends(&follows)
            || follows.is_command("end")
            || matches!(follows.kind, TokenKind::Break | TokenKind::LineEnd);
        (last.is_symbol(")") && is_last).then_some(last.span.end)
    }

    fn command(&mut self, token: &Token<'a>) -> Result<(), Diagnostic> {
        let Some(meaning) = commands::meaning(token.text) else {
            return Err(unsupported(&format!("`\\{}`", token.text), token.span).hint(commands::advice(token.text)));
        };
        match meaning {
            Meaning::Letter(letter) => self.letter(&letter, token.span)?,
            Meaning::Function(name) => self.function(name, token),
            Meaning::Mark(brace @ ("(" | ")")) => self.written_brace(brace, token)?,
            Meaning::Mark(mark) => self.mark(mark, token),
            Meaning::Fraction => self.fraction(token)?,
            Meaning::Root => self.root(token)?,
            Meaning::Upright => self.upright(token)?,
            Meaning::Bold => self.bold(token)?,
            Meaning::Sizing => self.sizing(token)?,
            Meaning::Bar => self.bar(token, token.text == "lvert")?,
            Meaning::Nothing => {}
            Meaning::Wide => self.wide(token),
            Meaning::Remark => self.remark(token)?,
            Meaning::Begin => self.begin(token)?,
            Meaning::End => self.end(token)?,
        }
        Ok(())
    }

    /// `\{` and `\}` are brackets like any other.
    fn written_brace(&mut self, brace: &'static str, token: &Token<'a>) -> Result<(), Diagnostic> {
        if brace == "(" {
            self.groups.open(Group::Bracket('}'), token.span);
        } else {
            self.groups.close(token, |group| *group == Group::Bracket('}'))?;
        }
        self.mark(brace, token);
        Ok(())
    }

    /// A number; `2 \cdot 10^{-3}` is the number `2e-3`, to the last digit, where it begins a term: in
    /// `\sin 2 \cdot 10^{-3}` and `v/2 \cdot 10^{-3}` the dot is an operator like any other.
    fn number(&mut self, token: &Token<'a>) -> Result<(), Diagnostic> {
        self.check_exponent_letter(token)?;
        let begins_term = self.previous.is_none_or(|before| match before.kind {
            TokenKind::Open | TokenKind::Break | TokenKind::LineEnd => true,
            TokenKind::Symbol => "+-−=,;([&".contains(before.text),
            TokenKind::Command => ["quad", "qquad", "begin", "{"].iter().any(|name| before.is_command(name)),
            _ => false,
        });
        let mantissa = if token.text == "10" { Some("1") } else { None };
        let power = match mantissa {
            Some(_) => self.power_of_ten(token.span.end),
            None if !begins_term => None,
            None => {
                let sign = self.peek().filter(|sign| sign.is_command("cdot") || sign.is_command("times"));
                let ten = sign.and_then(|sign| token::next(self.source, sign.span.end));
                ten.filter(|ten| ten.text == "10").and_then(|ten| self.power_of_ten(ten.span.end))
            }
        };
        let Some((exponent, end)) = power else {
            self.spelling.put(token.text, token.span, Piece::Word);
            return Ok(());
        };
        self.at = end;
        let number = format!("{}e{exponent}", mantissa.unwrap_or(token.text));
        self.spelling.put(&number, Span::new(token.span.start, end), Piece::Word);
        Ok(())
    }

    /// The exponent in `^{-3}` at `at`, and where it ends.
    fn power_of_ten(&self, at: usize) -> Option<(String, usize)> {
        let tokens =
            std::iter::successors(token::next(self.source, at), |token| token::next(self.source, token.span.end));
        let tokens: Vec<Token<'_>> = tokens.take(5).collect();
        let (sign, number, close) = match tokens.as_slice() {
            [hat, open, number, close, ..]
                if hat.is_symbol("^") && open.kind == TokenKind::Open && close.kind == TokenKind::Close =>
            {
                ("", number, close)
            }
            [hat, open, minus, number, close]
                if hat.is_symbol("^") && open.kind == TokenKind::Open && minus.is_symbol("-") =>
            {
                ("-", number, close)
            }
            _ => return None,
        };
        // Beyond the doubles it is a power like any other, not a number that is too large.
        let is_exponent = number.kind == TokenKind::Number && number.text.parse().is_ok_and(|power: u32| power <= 308);
        (is_exponent && close.kind == TokenKind::Close).then(|| (format!("{sign}{}", number.text), close.span.end))
    }

    fn function(&mut self, name: &'static str, token: &Token<'a>) {
        let ten = [r"_{10}"].iter().find(|ten| self.source.get(self.at..).is_some_and(|rest| rest.starts_with(**ten)));
        match ten {
            Some(ten) if token.text == "log" => {
                self.at += ten.len();
                self.spelling.put("log10", Span::new(token.span.start, self.at), Piece::Word);
            }
            _ => self.spelling.put(name, token.span, Piece::Word),
        }
        self.function = Some(Span::new(token.span.start, self.at));
    }

    /// `\quad` separates two equations of a row; elsewhere it is a blank.
    fn wide(&mut self, token: &Token<'_>) {
        if !self.is_list || !self.groups.is_outside() || self.end_position(token.span) || self.skip_equation_number() {
            return;
        }
        if self.row.has_equals && self.equation_follows() {
            self.mark(";", token);
            self.row.has_equals = false;
        }
    }

    /// Whether a `=` comes before the next separator.
    fn equation_follows(&self) -> bool {
        let (mut at, mut depth) = (self.at, 0_usize);
        while let Some(token) = token::next(self.source, at) {
            at = token.span.end;
            match (token.kind, token.text) {
                (TokenKind::Open, _) | (TokenKind::Symbol, "(" | "[") => depth += 1,
                (TokenKind::Close, _) | (TokenKind::Symbol, ")" | "]") => depth = depth.saturating_sub(1),
                (TokenKind::Symbol, "=") if depth == 0 => return true,
                (TokenKind::Symbol, "," | ";") if depth == 0 => return false,
                (TokenKind::Command, "quad" | "qquad" | "end" | "]") => return false,
                (TokenKind::Break | TokenKind::LineEnd | TokenKind::Dollars, _) => return false,
                _ => {}
            }
        }
        false
    }

    /// Whether the token before `token` is a whole number.
    pub(super) fn follows_integer(&self) -> Option<Token<'a>> {
        self.previous.filter(|token| token.kind == TokenKind::Number && !token.text.contains('.'))
    }
}
