//! LaTeX mathematics in a spec, spelled out in the plain notation.
//!
//! Input: a source; output: the same source with every block between `$$ … $$`, `\[ … \]` or
//! `\begin{align} … \end{align}` in the plain notation, and the place of each piece of it. Grammar and builder are
//! shared with the plain notation, so what is written in LaTeX cannot mean anything else, and is refused where the
//! plain notation is ambiguous. Invariant: every place in a finding is a place in the user's LaTeX.
//!
//! As in TeX each letter is a name of its own. What is not listed in `commands.rs` is refused, never guessed.
//! There is no recursion: open groups wait on a stack.

mod argument;
mod block;
mod commands;
mod construct;
mod exponent;
mod group;
mod spelling;
mod token;

use block::Block;
use spelling::Spelling;

use super::places::Places;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, MOST_FINDINGS, Span};

/// What opens a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Opening {
    /// `$$`
    Dollars,
    /// `\[`
    Bracket,
    /// `\begin`
    Environment,
}

/// The places of the blocks in a text whose blocks can all be read.
pub fn blocks(source: &str) -> Vec<Span> {
    let mut blocks = Vec::new();
    let mut end = 0;
    while let Some((at, opening)) = next_block(source, end) {
        end = match Block::new(source, opening, at, true, &mut Spelling::new()).read() {
            Ok(end) => end,
            Err(_) => skip(source, opening, at),
        };
        blocks.push(Span::new(at, end));
    }
    blocks
}

/// The source with its LaTeX spelled out, and the place of each piece; `None` if it has none.
///
/// # Errors
/// Every block that cannot be read, with its first fault.
pub fn spell_out(source: &str) -> Result<Option<(String, Places)>, Diagnostics> {
    let mut spelling = Spelling::new();
    let mut found = Diagnostics::new();
    let mut copied = 0;
    while let Some((at, opening)) = next_block(source, copied) {
        let before = source.get(copied..at).unwrap_or("");
        spelling.copy(before, copied);
        let line = before.rsplit('\n').next().unwrap_or(before).trim();
        // What continues a line is an expression; what begins one is a list of constraints.
        let is_list = line.is_empty() && !before.trim_end().ends_with("pde") && (before.contains('\n') || copied == 0);
        let mut block = Block::new(source, opening, at, is_list, &mut spelling);
        copied = match block.read() {
            Ok(end) => end,
            Err(finding) => {
                found.push(finding);
                if found.len() >= MOST_FINDINGS {
                    break;
                }
                skip(source, opening, at)
            }
        };
    }
    if !found.is_empty() {
        return Err(found);
    }
    if copied == 0 {
        return Ok(None);
    }
    spelling.copy(source.get(copied..).unwrap_or(""), copied);
    Ok(Some(spelling.finish()))
}

/// The next block from `from` on, comments left out.
fn next_block(source: &str, from: usize) -> Option<(usize, Opening)> {
    let mut at = from;
    loop {
        let rest = source.get(at..)?;
        let next = rest.find(['#', '$', '\\'])?;
        at += next;
        let rest = rest.get(next..)?;
        if rest.starts_with('#') {
            at += rest.find('\n')?;
        } else if rest.starts_with("$$") {
            return Some((at, Opening::Dollars));
        } else if rest.starts_with(r"\[") {
            return Some((at, Opening::Bracket));
        } else if rest.starts_with(r"\begin{") {
            return Some((at, Opening::Environment));
        } else {
            at += 1;
        }
    }
}

/// Behind a block that could not be read, as far as can be told.
fn skip(source: &str, opening: Opening, at: usize) -> usize {
    let rest = source.get(at + 2..).unwrap_or("");
    let close = match opening {
        Opening::Dollars => "$$",
        Opening::Bracket => r"\]",
        // An environment may hold others: the first empty line ends the search.
        Opening::Environment => "\n\n",
    };
    rest.find(close).map_or(source.len(), |end| at + 2 + end + close.len())
}

/// A finding for what is not read.
fn unsupported(what: &str, span: Span) -> Diagnostic {
    Diagnostic::new(Code::UnsupportedLatex, format!("{what} is not read in LaTeX")).at(span)
}
