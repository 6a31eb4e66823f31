//! Diagnostics as plain data: what is wrong, where, and what would mend it.
//!
//! Every stage reports through [`Diagnostic`]; nothing here prints. A [`Code`] is stable and decides severity
//! and blame, so that two places can never report one fault in two ways.

mod code;
mod number;
mod source;

pub use code::{Class, Code, Severity};
pub use number::{Shortest, Single};
pub use source::{LineColumn, Source, Span};

use std::fmt;

/// A note that points at a second place in the source.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is to be said about it.
    pub message: String,
}

/// One finding about a document, an option or a computation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The stable code; severity and class follow from it.
    pub code: Code,
    /// What is wrong, in the user's symbols: one line, lower case, no full stop.
    pub message: String,
    /// Where, in the document's text; `None` when no place in it is at fault.
    pub span: Option<Span>,
    /// What to say under the marked place.
    pub marker: String,
    /// Other places that belong to the fault.
    pub labels: Vec<Label>,
    /// What the user can do about it.
    pub hints: Vec<String>,
}

/// A stage ends its search here: more findings help nobody, and each unknown name is compared with all known ones.
pub const MOST_FINDINGS: usize = 100;

/// All findings of one stage, in source order; at most about [`MOST_FINDINGS`].
pub type Diagnostics = Vec<Diagnostic>;

impl Diagnostic {
    /// A finding with no place in the source yet.
    ///
    /// Control and bidirectional characters in `message` are escaped, so that a document cannot
    /// disguise its own diagnostics.
    #[must_use]
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Diagnostic {
            code,
            message: visible(&message.into()),
            span: None,
            marker: String::new(),
            labels: Vec::new(),
            hints: Vec::new(),
        }
    }

    /// The finding, placed at `span`; `None` leaves it where it is.
    #[must_use]
    pub fn at(mut self, span: impl Into<Option<Span>>) -> Self {
        self.span = span.into().or(self.span);
        self
    }

    /// The finding with `marker` written under the marked place.
    #[must_use]
    pub fn marked(mut self, marker: impl Into<String>) -> Self {
        self.marker = visible(&marker.into());
        self
    }

    /// The finding with a second place.
    #[must_use]
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: visible(&message.into()) });
        self
    }

    /// The finding with advice.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(visible(&hint.into()));
        self
    }

    /// Whether work can go on, from the code.
    #[must_use]
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }

    /// Whose fault it is, from the code.
    #[must_use]
    pub fn class(&self) -> Class {
        self.code.class()
    }
}

impl fmt::Display for Diagnostic {
    /// One line: `error[E0201]: unknown name `kv``.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}[{}]: {}", self.severity(), self.code, self.message)
    }
}

impl std::error::Error for Diagnostic {}

/// `text` with characters that would act on a terminal, or hide themselves, written as `\u{…}`.
fn visible(text: &str) -> String {
    text.chars().map(|c| if is_deceptive(c) { c.escape_unicode().to_string() } else { c.to_string() }).collect()
}

/// Whether `c` controls the terminal or the direction and visibility of the text around it.
#[must_use]
pub fn is_deceptive(c: char) -> bool {
    (c.is_control() && c != '\n' && c != '\t')
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}
