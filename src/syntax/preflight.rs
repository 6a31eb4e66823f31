//! Bounds and normalises a text before the grammar sees it.
//!
//! Turns bytes into logical lines of the same offsets: comments and line breaks inside brackets become
//! blanks, a line that continues the one before is joined to it. Invariant: offsets never change, so every
//! span of the parser is a span of the user's text; where LaTeX is spelled out first, [`Places`] says what each
//! piece stands for. Size and nesting are bounded here because a parser's
//! stack cannot be: pest's own limit counts calls and is shared by the whole process.

use super::bars;
use super::latex;
use super::places::Places;
use super::quotes;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, MOST_FINDINGS, Source, Span, is_deceptive};
use crate::expr::{Function, greek_letter};
use crate::limits::Limits;

/// Words that begin a statement and therefore end the one before.
const STATEMENT_WORDS: &[&str] = &[
    "param", "let", "domain", "pde", "at", "solve", "deform", "surface", "seam", "patch", "curve", "morph", "bspline",
    "knots", "net", "layer", "nsided", "edge", "mirror", "repeat",
];

/// Words of statements that open a block.
const BLOCK_WORDS: &[&str] = &["patch", "bspline", "nsided"];

/// A text that is ready for the grammar.
pub struct Prepared {
    /// As long as the source, byte for byte, unless that has LaTeX.
    pub text: String,
    /// Where the bytes of `text` stand in the source.
    pub places: Places,
    /// The source as messages quote it.
    pub shown: String,
    /// The logical lines, in order, none empty.
    pub lines: Vec<Span>,
    /// Offsets of `(` or `[` and of what closes it, innermost first.
    pub brackets: Vec<(usize, usize)>,
    /// Offsets of the `{` of patch blocks.
    pub blocks: Vec<usize>,
    /// Texts in quotes, with the offset of the opening one; in `text` fillers stand for them, quotes included.
    pub quoted: Vec<(usize, String)>,
}

/// What is open at a place of the text.
#[derive(Default)]
struct Open {
    /// Brackets and a patch block's brace, outermost first.
    brackets: Vec<(char, usize)>,
    /// Whether the outermost is a patch block's brace.
    in_block: bool,
}

impl Open {
    /// Whether a bracket is open within the statement, so that it goes on after a line break.
    fn is_inside(&self) -> bool {
        self.brackets.len() > usize::from(self.in_block)
    }
}

/// Reads bytes as a named text.
///
/// # Errors
/// [`Code::NotUtf8`] with the offset of the first bad byte, or [`Code::LimitReached`] for the size.
pub fn decode(name: &str, bytes: &[u8], limits: &Limits) -> Result<Source, Diagnostic> {
    check_size(bytes.len(), limits)?;
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(error) => {
            let at = error.valid_up_to();
            let line = bytes.iter().take(at).filter(|byte| **byte == b'\n').count() + 1;
            Err(Diagnostic::new(Code::NotUtf8, format!("the text is not UTF-8: byte {at}, on line {line}"))
                .at(Span::new(at, at + 1))
                .hint("save the file as UTF-8"))
        }
    }
}

fn check_size(bytes: usize, limits: &Limits) -> Result<(), Diagnostic> {
    let limit = limits.source_bytes;
    if bytes <= limit {
        return Ok(());
    }
    let message = format!("the text is longer than the limit `source-bytes` of {limit} bytes");
    Err(Diagnostic::new(Code::LimitReached, message)
        .hint("a spec states a problem; move tables of numbers elsewhere, or raise the limit"))
}

/// Prepares a text, or says why it cannot be parsed.
///
/// # Errors
/// Every block of LaTeX that cannot be read; every unbalanced bracket and deceptive character; or the first place
/// where nesting passes its limit.
pub fn prepare(source: &Source, limits: &Limits) -> Result<Prepared, Diagnostics> {
    // Here too: a source need not come from `decode`.
    check_size(source.text.len(), limits).map_err(|finding| vec![finding])?;
    match latex::spell_out(&source.text)? {
        None => blanked(&source.text, limits).map(|prepared| Prepared { shown: shown(&prepared), ..prepared }),
        Some((text, places)) => match blanked(&text, limits) {
            Ok(prepared) => Ok(Prepared { places, shown: source.text.clone(), ..prepared }),
            Err(found) => Err(found.into_iter().map(|finding| places.moved(finding)).collect()),
        },
    }
}

/// A prepared text as its writer knows it.
fn shown(prepared: &Prepared) -> String {
    let bars = [bars::BAR_OPENS, bars::BAR_CLOSES].map(|bar| bar.chars().next().unwrap_or(' '));
    let mut text = prepared.text.replace(bars, "|");
    for (at, quoted) in &prepared.quoted {
        text.replace_range(*at..at + quoted.len() + 2, &format!("\"{quoted}\""));
    }
    text
}

/// `text` with comments and line breaks in brackets blanked, its logical lines and its brackets.
fn blanked(text: &str, limits: &Limits) -> Result<Prepared, Diagnostics> {
    let mut found = Diagnostics::new();
    let mut bytes = text.to_owned().into_bytes();
    let mut open = Open::default();
    let (mut brackets, mut blocks, mut breaks) = (Vec::new(), Vec::new(), Vec::new());
    let mut in_comment = false;
    let mut quoted: Vec<(usize, String)> = Vec::new();
    let mut quote_ends = 0;
    // Where the statement began, once it has.
    let mut statement: Option<usize> = None;
    for (at, letter) in text.char_indices() {
        let rest = text.get(at..).unwrap_or("");
        if at < quote_ends {
            continue;
        }
        if letter == '\n' {
            in_comment = false;
            if open.is_inside() && starts_statement(rest.get(1..).unwrap_or("")) {
                let inside = open.brackets.drain(usize::from(open.in_block)..);
                found.extend(inside.map(|(bracket, at)| not_closed(bracket, at)));
            }
            if open.is_inside() {
                blank(&mut bytes, at, letter);
            } else if !is_block_ahead(rest) {
                statement = None;
            }
            continue;
        }
        in_comment |= letter == '#';
        if in_comment {
            blank(&mut bytes, at, letter);
            continue;
        }
        if !letter.is_whitespace() {
            statement.get_or_insert(at);
        }
        match letter {
            '"' => match quotes::read(rest, at) {
                Ok(inside) => {
                    quote_ends = at + inside.len() + 2;
                    (at..quote_ends).for_each(|place| replace(&mut bytes, place, quotes::FILLER));
                    quoted.push((at, inside.to_owned()));
                }
                Err(finding) => {
                    let (length, is_closed) = quotes::extent(rest);
                    quote_ends = at + length;
                    if !is_closed {
                        // What would close the brackets before it is part of the text.
                        open.brackets.truncate(usize::from(open.in_block));
                    }
                    found.push(finding);
                }
            },
            '{' if !open.is_inside() && opens_block(text, statement, at) => {
                if open.in_block {
                    found.push(nested_block(statement.unwrap_or(at), at));
                    open.brackets.clear();
                }
                open.brackets.push((letter, at));
                open.in_block = true;
                blocks.push(at);
                breaks.push(at + 1);
                statement = None;
            }
            '(' | '[' | '{' => {
                open.brackets.push((letter, at));
                if open.brackets.len() > limits.nesting {
                    return Err(vec![too_deep(at, limits.nesting)]);
                }
            }
            '|' => {
                let is_open = open.brackets.last().is_some_and(|(bracket, _)| *bracket == '|');
                match bars::opens(text, at, is_open, &bytes) {
                    Ok(true) => {
                        open.brackets.push((letter, at));
                        replace(&mut bytes, at, bars::BAR_OPENS);
                        if open.brackets.len() > limits.nesting {
                            return Err(vec![too_deep(at, limits.nesting)]);
                        }
                    }
                    Ok(false) => {
                        brackets.extend(open.brackets.pop().map(|(_, start)| (start, at)));
                        replace(&mut bytes, at, bars::BAR_CLOSES);
                    }
                    Err(finding) => found.push(finding),
                }
            }
            ')' | ']' | '}' => {
                let ends_block = letter == '}' && open.in_block && !open.is_inside();
                match close(&mut open.brackets, letter, at) {
                    Ok(start) if letter == '}' && is_exponent(text, start) => {
                        replace(&mut bytes, start, "(");
                        replace(&mut bytes, at, ")");
                        brackets.push((start, at));
                    }
                    Ok(start) if letter != '}' => brackets.push((start, at)),
                    Ok(_) => {}
                    Err(finding) => found.push(finding),
                }
                open.in_block &= !open.brackets.is_empty();
                if ends_block {
                    breaks.extend([at, at + 1]);
                    statement = None;
                }
            }
            // Ends a statement, as a line break does.
            ';' if !open.is_inside() => {
                blank(&mut bytes, at, letter);
                breaks.push(at + 1);
                statement = None;
            }
            // A byte order mark at the start is a habit of editors, not a fault.
            '\u{feff}' if at == 0 => blank(&mut bytes, at, letter),
            _ => found.extend(suspicious(letter, at)),
        }
    }
    found.extend(open.brackets.into_iter().map(|(bracket, at)| not_closed(bracket, at)));
    if !found.is_empty() {
        found.sort_by_key(|finding| finding.span);
        found.truncate(MOST_FINDINGS);
        return Err(found);
    }
    // Whole characters were replaced by as many blanks as they had bytes, so the text is still UTF-8.
    let text = String::from_utf8(bytes).unwrap_or_default();
    let lines = logical_lines(&text, &breaks);
    Ok(Prepared { text, lines, brackets, blocks, places: Places::default(), shown: String::new(), quoted })
}

/// Whether the `{` at `at` opens the block of the statement that began at `statement`: `patch NAME {`, `nsided NAME {`.
fn opens_block(text: &str, statement: Option<usize>, at: usize) -> bool {
    let before = statement.and_then(|start| text.get(start..at)).unwrap_or("");
    // The brace of a subscript stands behind its underscore.
    BLOCK_WORDS.iter().any(|word| begins_with_word(before, word)) && !before.ends_with('_')
}

/// Whether the line after a line break begins with a brace: `patch NAME` on one line, `{` on the next.
fn is_block_ahead(rest: &str) -> bool {
    rest.get(1..).and_then(|next| next.split('\n').next()).is_some_and(|line| line.trim_start().starts_with('{'))
}

fn nested_block(start: usize, at: usize) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, "a block stands inside another block")
        .at(Span::new(start, at + 1))
        .hint("close the one before with `}`")
}

/// Whether the brace at `start` holds an exponent, as in `e^{-t}`, that is more than a whole number and does not stand
/// between a function and its argument.
fn is_exponent(text: &str, start: usize) -> bool {
    let before = text.get(..start).unwrap_or("").trim_end_matches([' ', '\t']);
    let inside = text.get(start + 1..).unwrap_or("").trim_start();
    let after = inside.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
    let base = before.trim_end_matches('^').trim_end();
    let rest = base.trim_end_matches(|c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '′'));
    let word = base.strip_prefix(rest).unwrap_or("").trim_start_matches(|c: char| c.is_ascii_digit());
    let is_function = Function::named(word).is_some();
    (before.ends_with('^') || before.ends_with("**")) && !after.starts_with('}') && !is_function
}

/// Puts the one byte of `mark` in place of the one at `at`.
fn replace(bytes: &mut [u8], at: usize, mark: &str) {
    for (byte, mark) in bytes.iter_mut().skip(at).zip(mark.bytes()) {
        *byte = mark;
    }
}

fn blank(bytes: &mut [u8], at: usize, letter: char) {
    for byte in bytes.iter_mut().skip(at).take(letter.len_utf8()) {
        *byte = b' ';
    }
}

/// The offset of the bracket that `letter` closes.
fn close(open: &mut Vec<(char, usize)>, letter: char, at: usize) -> Result<usize, Diagnostic> {
    let expected = match letter {
        ')' => '(',
        ']' => '[',
        _ => '{',
    };
    match open.pop() {
        Some((bracket, start)) if bracket == expected => Ok(start),
        Some((bracket, start)) => {
            // The outer bracket is closed by this one all the same: report a slip once.
            if open.last().is_some_and(|(outer, _)| *outer == expected) {
                open.pop();
            }
            Err(Diagnostic::new(Code::UnbalancedBracket, format!("`{bracket}` is closed by `{letter}`"))
                .at(Span::new(at, at + 1))
                .label(Span::new(start, start + 1), "opened here"))
        }
        None => Err(Diagnostic::new(Code::UnbalancedBracket, format!("`{letter}` closes nothing"))
            .at(Span::new(at, at + 1))
            .hint(format!("remove it, or open a `{expected}` before it"))),
    }
}

fn not_closed(bracket: char, at: usize) -> Diagnostic {
    Diagnostic::new(Code::UnbalancedBracket, format!("`{bracket}` is never closed")).at(Span::new(at, at + 1))
}

fn too_deep(at: usize, nesting: usize) -> Diagnostic {
    Diagnostic::new(Code::LimitReached, format!("brackets are nested deeper than the limit `nesting` of {nesting}"))
        .at(Span::new(at, at + 1))
        .hint("name an inner part with `let`")
}

/// A finding for characters that cannot be seen or that look like others.
fn suspicious(letter: char, at: usize) -> Option<Diagnostic> {
    let span = Span::new(at, at + letter.len_utf8());
    let code = u32::from(letter);
    if is_deceptive(letter) && letter != '\r' {
        let message = format!("the invisible character U+{code:04X} has no meaning here");
        return Some(Diagnostic::new(Code::DeceptiveCharacter, message).at(span).hint("remove it"));
    }
    if matches!(letter, 'ⁱ' | 'ⁿ' | 'ᴬ'..='ᵪ') {
        let message = format!("the raised or lowered letter `{letter}` is not read");
        return Some(
            Diagnostic::new(Code::UnexpectedText, message)
                .at(span)
                .hint("write `^` for an exponent, as in `e^(-t)`, and `_` for a subscript"),
        );
    }
    let is_latin = letter.is_ascii() || ('À'..='ɏ').contains(&letter);
    if letter.is_alphabetic() && !is_latin && greek_letter(letter).is_none() && !"ₓª".contains(letter) {
        let message =
            format!("`{letter}` (U+{code:04X}) is neither a Latin nor one of the Greek letters that differ from Latin");
        let finding = Diagnostic::new(Code::DeceptiveCharacter, message).at(span);
        return Some(finding.hint("names use Latin and Greek letters, so that no two look alike"));
    }
    None
}

/// Whether the first line of `text` begins a statement.
pub fn starts_statement(text: &str) -> bool {
    // Only this line: blank ones after it would be read again at each of them.
    let line = text.split('\n').next().unwrap_or("").trim_start();
    STATEMENT_WORDS.iter().any(|word| begins_with_word(line, word))
}

fn begins_with_word(line: &str, word: &str) -> bool {
    line.strip_prefix(word).is_some_and(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace))
}

/// Splits at line breaks, except where a line plainly continues the one before: it begins with an operator,
/// `with` or the brace of a block, or the one before ends with an operator or a comma and no statement begins.
/// Offsets in `breaks` always split.
fn logical_lines(text: &str, breaks: &[usize]) -> Vec<Span> {
    let mut lines: Vec<Span> = Vec::new();
    let mut may_continue = false;
    let mut breaks = breaks.iter().copied().peekable();
    let mut start = 0;
    for physical in text.split_inclusive('\n') {
        let end = start + physical.len();
        while start < end {
            let cut = breaks.next_if(|cut| *cut <= end);
            let piece_end = cut.unwrap_or(end);
            let piece = text.get(start..piece_end).unwrap_or("");
            let content = piece.trim();
            if !content.is_empty() {
                let begin = start + (piece.len() - piece.trim_start().len());
                let span = Span::new(begin, begin + content.len());
                let before = lines.last().and_then(|last| text.get(last.start..last.end)).unwrap_or("");
                match lines.last_mut() {
                    Some(last) if may_continue && continues(before, content) => last.end = span.end,
                    _ => lines.push(span),
                }
                may_continue = true;
            }
            may_continue &= cut.is_none();
            start = piece_end;
        }
    }
    lines
}

/// Whether `line` belongs to the statement of the line `before` it.
pub fn continues(before: &str, line: &str) -> bool {
    const LEADING: &[char] = &['+', '-', '−', '–', '*', '/', '·', '⋅', '∙', '∗', '×', '÷', '∕', '=', '^', '{'];
    const TRAILING: &[char] = &['+', '-', '−', '–', '*', '/', '·', '⋅', '∙', '∗', '×', '÷', '∕', '=', '^', ','];
    let leads =
        line.starts_with(LEADING) || line.strip_prefix("with").is_some_and(|rest| rest.starts_with([' ', '\t']));
    // `pde` alone states nothing: the equation stands on the next lines.
    leads || before == "pde" || (before.ends_with(TRAILING) && !starts_statement(line))
}
