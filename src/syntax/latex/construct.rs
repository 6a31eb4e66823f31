//! Names, fractions, roots and environments: what takes more than one token.

use super::block::Block;
use super::commands::{self, Meaning};
use super::group::{Group, Unseen};
use super::spelling::Piece;
use super::token::{self, Token, TokenKind};
use super::unsupported;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::syntax::RESERVED_WORDS;

impl<'a> Block<'a> {
    /// A letter with the subscript and the primes that follow it, in either order: one name.
    pub(super) fn letter(&mut self, letter: &str, place: Span) -> Result<(), Diagnostic> {
        if letter == "d" && self.is_differential(place.end) {
            self.spelling.put("∂", place, Piece::Mark);
            return Ok(());
        }
        let (mut subscript, mut primes) = (String::new(), 0);
        let mut end = place.end;
        while let Some(token) = self.peek() {
            if token.is_symbol("_") && subscript.is_empty() {
                self.at = token.span.end;
                subscript = self.subscript(&token)?;
            } else if token.is_symbol("'") || token.is_symbol("′") {
                self.at = token.span.end;
                primes += 1;
            } else {
                break;
            }
            end = self.at;
        }
        let subscript = if subscript.is_empty() { subscript } else { format!("_{{{subscript}}}") };
        let name = format!("{letter}{subscript}{}", "'".repeat(primes));
        self.spelling.put(&name, Span::new(place.start, end), Piece::Word);
        Ok(())
    }

    /// Whether the `d` that ends at `end` is the one of `\frac{dS}{du}`.
    fn is_differential(&self, end: usize) -> bool {
        let Some(next) = token::next(self.source, end) else { return false };
        match self.groups.last() {
            Some(Group::DerivativeAbove) => true,
            Some(Group::DerivativeBelow) => ["u", "v", "t"].iter().any(|name| next.is_letter(name)),
            _ => false,
        }
    }

    /// What stands behind `_`: letters and digits.
    fn subscript(&mut self, mark: &Token<'a>) -> Result<String, Diagnostic> {
        let first = self.peek().ok_or_else(|| unsupported("an empty subscript", mark.span))?;
        self.at = first.span.end;
        if first.kind == TokenKind::Open {
            return self.word(&first);
        }
        match (first.kind, commands::meaning(first.text)) {
            (TokenKind::Letter, _) => Ok(first.text.to_owned()),
            (TokenKind::Number, _) if first.text.len() == 1 => Ok(first.text.to_owned()),
            (TokenKind::Command, Some(Meaning::Letter(letter))) => Ok(letter),
            _ => Err(unsupported("a subscript of several characters without braces", mark.span.to(first.span))
                .hint(format!("write `_{{{}}}`", first.text))),
        }
    }

    /// Letters and digits up to the brace that closes `open`.
    fn word(&mut self, open: &Token<'a>) -> Result<String, Diagnostic> {
        let (mut word, mut depth) = (String::new(), 1_usize);
        while let Some(token) = self.peek() {
            self.at = token.span.end;
            match token.kind {
                TokenKind::Letter => word.push_str(token.text),
                TokenKind::Number if !token.text.contains('.') => word.push_str(token.text),
                TokenKind::Open => depth += 1,
                TokenKind::Close => depth -= 1,
                TokenKind::Symbol if token.text == "_" && !word.is_empty() => word.push('_'),
                TokenKind::Command => match commands::meaning(token.text) {
                    Some(Meaning::Letter(letter)) => word.push_str(&letter),
                    Some(Meaning::Upright | Meaning::Nothing) => {}
                    // `r_{\max}`
                    Some(Meaning::Function(_)) => word.push_str(token.text),
                    None if matches!(token.text, "text" | "textrm") => {}
                    _ => return Err(unsupported("a name that is not of letters and digits", token.span)),
                },
                _ => return Err(unsupported("a name that is not of letters and digits", token.span)),
            }
            if depth == 0 {
                let place = open.span.to(token.span);
                return if word.is_empty() { Err(unsupported("an empty name", place)) } else { Ok(word) };
            }
        }
        Err(Diagnostic::new(Code::UnbalancedBracket, "`{` is never closed").at(open.span))
    }

    /// `\mathrm{name}`, or a function written upright.
    pub(super) fn upright(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let Some(open) = self.take(TokenKind::Open) else {
            return Err(unsupported("an upright name without braces", command.span).hint(r"write `\mathrm{name}`"));
        };
        let word = self.word(&open)?;
        let place = Span::new(command.span.start, self.at);
        // With a subscript or a prime it is a name, like `sin_x` in the plain notation.
        if self
            .peek()
            .is_some_and(|next| next.span.start == self.at && ["_", "'", "′"].iter().any(|c| next.is_symbol(c)))
        {
            return self.letter(&word, place);
        }
        if let Some(function) = commands::upright_function(&word) {
            self.spelling.put(function, place, Piece::Word);
            self.function = Some(place);
            return Ok(());
        }
        if RESERVED_WORDS.contains(&word.as_str()) || !word.starts_with(char::is_alphabetic) {
            return Err(unsupported(&format!("`{word}` as a name"), place).hint("choose another name"));
        }
        self.letter(&word, place)
    }

    /// `\mathbf{S}`: a vector; `\mathbf{0}` is 0. Bold small letters are refused, since `\mathbf{b}` and `b` are mostly two things.
    pub(super) fn bold(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let braces = self.take(TokenKind::Open);
        if let Some(zero) = self.peek().filter(|next| next.kind == TokenKind::Number && next.text == "0") {
            self.at = zero.span.end;
            if braces.is_none() || self.take(TokenKind::Close).is_some() {
                self.spelling.put("0", Span::new(command.span.start, self.at), Piece::Word);
                return Ok(());
            }
        }
        let letter = self.take(TokenKind::Letter);
        let is_closed = braces.is_none() || letter.is_none() || self.take(TokenKind::Close).is_some();
        let place = Span::new(command.span.start, self.at);
        match letter {
            Some(letter) if is_closed && letter.text.starts_with(char::is_uppercase) => self.letter(letter.text, place),
            _ => Err(unsupported("a bold name that is not one capital letter", place)
                .hint(r"write `b` or `\mathrm{name}`; a bold and a plain letter would be one name")),
        }
    }

    /// `\left(` is `(`; `\left|` opens an absolute value.
    pub(super) fn sizing(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let next = self.peek().ok_or_else(|| unsupported("a bracket that is missing", command.span))?;
        let place = command.span.to(next.span);
        if next.is_symbol("|") {
            self.at = next.span.end;
            let is_left = command.text == "left" || command.text.ends_with('l');
            if !is_left && command.text != "right" && !command.text.ends_with('r') {
                return Err(
                    unsupported("a bar that neither opens nor closes", place).hint(r"write `\left|` or `\right|`")
                );
            }
            return self.bar(&Token { span: place, ..next }, is_left);
        }
        let is_bracket = ["(", ")", "[", "]"].iter().any(|bracket| next.is_symbol(bracket))
            || next.is_command("{")
            || next.is_command("}");
        if is_bracket {
            return Ok(());
        }
        let message = format!("`\\{}` before something that is no bracket", command.text);
        Err(unsupported(&message, place))
    }

    /// `\lvert`, or `\right|`: a bar whose side is known.
    pub(super) fn bar(&mut self, token: &Token<'a>, opens: bool) -> Result<(), Diagnostic> {
        if opens {
            self.groups.open(Group::Absolute, token.span);
            self.spelling.put("abs", token.span, Piece::Word);
            self.mark("(", token);
        } else {
            self.groups.close(token, |group| *group == Group::Absolute)?;
            self.mark(")", token);
        }
        Ok(())
    }

    pub(super) fn open_brace(&mut self, token: &Token<'a>) {
        // `{}` only keeps things apart in TeX.
        if self.take(TokenKind::Close).is_none() {
            self.begin_argument(token.span.start);
            self.groups.open(Group::Unseen(Unseen::default()), token.span);
            self.mark("(", token);
        }
    }

    /// Lets the group at `start` be the argument of the function before it, if there is one.
    fn begin_argument(&mut self, start: usize) {
        if let Some(function) = self.function {
            self.groups.begin_argument(function, start);
        }
    }

    pub(super) fn close_brace(&mut self, token: &Token<'a>) -> Result<(), Diagnostic> {
        let is_brace =
            |group: &Group| !matches!(group, Group::Bracket(_) | Group::Absolute | Group::Rows(_) | Group::Matrix(..));
        let open = self.groups.place().unwrap_or(token.span);
        match self.groups.close(token, is_brace)? {
            above @ (Group::Above | Group::DerivativeAbove) => {
                let Some(open) = self.take(TokenKind::Open) else {
                    return Err(unsupported("a fraction without a denominator in braces", token.span));
                };
                self.check_filled(&open, "a denominator")?;
                let bar = token.span.to(open.span);
                let (below, text) =
                    if above == Group::Above { (Group::Below, ")/(") } else { (Group::DerivativeBelow, "/") };
                self.groups.open(below, open.span);
                self.spelling.put(text, bar, Piece::Mark);
            }
            Group::Below => {
                self.mark("))", token);
                if let Some(argument) = self.groups.end_argument() {
                    self.check_argument_ends(argument, token.span.end)?;
                }
            }
            Group::DerivativeBelow => self.spelling.extend(token.span.end),
            Group::Unseen(unseen) => {
                self.mark(")", token);
                let argument = self.groups.end_argument();
                self.check_unseen(unseen, open.to(token.span), argument.is_some())?;
                if let Some(argument) = argument {
                    self.check_argument_ends(argument, token.span.end)?;
                }
            }
            Group::Exponent => {
                self.mark(")", token);
                self.check_one_exponent(open)?;
            }
            _ => self.mark(")", token),
        }
        Ok(())
    }

    /// `\frac{a}{b}`; `\frac{∂S}{∂u}` is a derivative and never a quotient.
    pub(super) fn fraction(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let Some(open) = self.take(TokenKind::Open) else {
            return Err(unsupported("a fraction without braces", command.span).hint(r"write `\frac{a}{b}`"));
        };
        let place = command.span.to(open.span);
        if self.is_derivative() {
            self.groups.open(Group::DerivativeAbove, open.span);
            self.spelling.begin(command.span.start);
            return Ok(());
        }
        if let (Some(whole), Some(end)) = (self.follows_integer(), self.plain_fraction(command.span.start)) {
            let fraction = self.source.get(command.span.start..end).unwrap_or("");
            let message = format!("`{}{fraction}` can be read in two ways", whole.text);
            return Err(Diagnostic::new(Code::AmbiguousExpression, message).at(Span::new(whole.span.start, end)).hint(
                format!(
                    r"write `{0} + {fraction}` for a mixed number, `{0} \cdot {fraction}` for a product",
                    whole.text
                ),
            ));
        }
        self.check_filled(&open, "a numerator")?;
        self.begin_argument(command.span.start);
        self.groups.open(Group::Above, open.span);
        self.spelling.put("((", place, Piece::Mark);
        Ok(())
    }

    /// Whether the numerator that begins here is that of a derivative.
    fn is_derivative(&self) -> bool {
        let Some(first) = self.peek() else { return false };
        if first.is_command("partial") || first.is_symbol("∂") {
            return true;
        }
        if !(first.is_letter("d") || first.is_command("mathrm")) {
            return false;
        }
        // `d` may be a name: the denominator decides. A fraction in the numerator ends the search, which keeps the
        // cost of nested ones linear.
        let (mut at, mut depth) = (self.at, 1_usize);
        while let Some(token) = token::next(self.source, at) {
            at = token.span.end;
            match token.kind {
                TokenKind::Open => depth += 1,
                TokenKind::Close => depth -= 1,
                TokenKind::Command if token.text.ends_with("frac") => return false,
                TokenKind::Dollars | TokenKind::Break => return false,
                _ => {}
            }
            if depth == 0 {
                let below: Vec<Token<'_>> = std::iter::successors(token::next(self.source, at), |token| {
                    token::next(self.source, token.span.end)
                })
                .filter(|token| {
                    !matches!(token.kind, TokenKind::Open | TokenKind::Close) && !token.is_command("mathrm")
                })
                .take(2)
                .collect();
                let is_variable = |token: &Token<'_>| ["u", "v", "t"].iter().any(|name| token.is_letter(name));
                return matches!(below.as_slice(), [d, variable] if d.is_letter("d") && is_variable(variable));
            }
        }
        false
    }

    /// Where `\frac{1}{2}` ends, if it is one of two numbers.
    fn plain_fraction(&self, start: usize) -> Option<usize> {
        let tokens =
            std::iter::successors(token::next(self.source, start), |token| token::next(self.source, token.span.end));
        let tokens: Vec<Token<'_>> = tokens.take(7).collect();
        let kinds: Vec<TokenKind> = tokens.iter().map(|token| token.kind).collect();
        use TokenKind::{Close, Command, Number, Open};
        (kinds == [Command, Open, Number, Close, Open, Number, Close])
            .then(|| tokens.last().map(|token| token.span.end))?
    }

    /// `\sqrt{x}`
    pub(super) fn root(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let Some(open) = self.take(TokenKind::Open) else {
            let finding = unsupported("a root without braces, or with an index", command.span);
            return Err(finding.hint(r"write `\sqrt{x}`; other roots are powers: `x^{1/3}`"));
        };
        self.check_filled(&open, "the value under a root")?;
        self.groups.open(Group::Braces, open.span);
        // Not `sqrt`, which as a function would end the argument of one before it.
        self.mark("√", command);
        self.mark("(", &open);
        Ok(())
    }

    /// Refuses `{}` where TeX would leave a gap.
    pub(super) fn check_filled(&self, open: &Token<'_>, what: &str) -> Result<(), Diagnostic> {
        let close = self.peek().filter(|next| next.kind == TokenKind::Close);
        close.map_or(Ok(()), |close| Err(missing(what, open.span.to(close.span))))
    }

    /// Skips `\tag{…}`.
    pub(super) fn remark(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let Some(open) = self.take(TokenKind::Open) else {
            return Err(unsupported(&format!("`\\{}` without braces", command.text), command.span));
        };
        let end = self.source.get(open.span.end..).and_then(|rest| rest.find(['}', '\n']));
        match end.map(|end| open.span.end + end).filter(|end| self.source.get(*end..*end + 1) == Some("}")) {
            Some(end) => {
                self.at = end + 1;
                Ok(())
            }
            None => Err(Diagnostic::new(Code::UnbalancedBracket, "`{` is never closed").at(open.span)),
        }
    }

    pub(super) fn begin(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let (name, place) = self.environment(command)?;
        match name {
            "aligned" | "align" | "align*" | "equation" | "equation*" | "split" | "gather" | "gather*" | "gathered"
            | "multline" | "multline*" | "flalign" | "flalign*" | "eqnarray" | "eqnarray*" => {
                if !self.groups.is_outside() {
                    return Err(unsupported(&format!("`{name}` inside brackets"), place));
                }
                self.groups.open(Group::Rows(name.to_owned()), place);
            }
            "bmatrix" | "pmatrix" => {
                self.groups.open(Group::Matrix(name.to_owned(), None), place);
                self.spelling.put("[", place, Piece::Mark);
            }
            "array" => {
                // The columns `{c}`; the brackets stand around it: `\left[\begin{array}{c} … \end{array}\right]`.
                self.remark(command)?;
                self.groups.open(Group::Matrix(name.to_owned(), None), place);
            }
            _ => {
                return Err(unsupported(&format!("the environment `{name}`"), place)
                    .hint("rows stand in `aligned` or `align`, the components of a vector in `bmatrix`"));
            }
        }
        Ok(())
    }

    pub(super) fn end(&mut self, command: &Token<'a>) -> Result<(), Diagnostic> {
        let (name, place) = self.environment(command)?;
        let end = Token { text: "end", span: place, ..*command };
        let is_closed = |group: &Group| matches!(group, Group::Rows(open) | Group::Matrix(open, _) if open == name);
        match self.groups.close(&end, is_closed)? {
            Group::Matrix(name, _) if name != "array" => self.spelling.put("]", place, Piece::Mark),
            _ => {}
        }
        Ok(())
    }

    /// `&` or `\\` between two components; a vector has one kind of them.
    pub(super) fn component_end(&mut self, token: &Token<'_>) -> Result<(), Diagnostic> {
        let mut at = self.at;
        let after = std::iter::from_fn(|| {
            let token = token::next(self.source, at)?;
            at = token.span.end;
            Some(token)
        })
        .find(|token| token.kind != TokenKind::LineEnd);
        let is_last = token.kind == TokenKind::Break && after.is_some_and(|after| after.is_command("end"));
        if let Some(separator) = self.groups.separator().filter(|_| !is_last)
            && *separator.get_or_insert(token.kind) != token.kind
        {
            let finding = unsupported("a matrix of several rows and columns", token.span);
            return Err(finding.hint("a vector is one column or one row of components"));
        }
        self.mark(", ", token);
        Ok(())
    }

    /// The name in `\begin{name}`, and the place of both.
    fn environment(&mut self, command: &Token<'a>) -> Result<(&'a str, Span), Diagnostic> {
        let rest = self.source.get(self.at..).unwrap_or("");
        let name = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(name, _)| name);
        let name = name.filter(|name| name.len() <= 16 && name.chars().all(|c| c.is_ascii_alphabetic() || c == '*'));
        let Some(name) = name else {
            return Err(unsupported(&format!("`\\{}` without a name in braces", command.text), command.span));
        };
        let start = command.span.start;
        self.at += name.len() + 2;
        Ok((name, Span::new(start, self.at)))
    }
}

/// A finding for a group that is empty.
pub(super) fn missing(what: &str, span: Span) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, format!("{what} is missing")).at(span).hint("write it between the braces")
}
