//! Diagnostics for programs, the page of `view` among them: with the line and the columns under which the caret stands.

use serde::Serialize;

use trimline::diagnostic::{Diagnostic, Severity, Source, Span};

use crate::failure::{Failure, print_warnings};
use crate::options::Terminal;

/// A diagnostic, or a failure that has no code.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    severity: String,
    code: Option<&'static str>,
    message: String,
    marker: String,
    /// What the text is called that the place is in.
    source: String,
    place: Option<Place>,
    labels: Vec<(String, Place)>,
    hints: Vec<String>,
}

/// A place on one line, counted from 1 in characters, with the line's text.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Place {
    /// Bytes in the source.
    span: [usize; 2],
    line: usize,
    column: usize,
    /// The column after the last one marked, on the same line.
    end: usize,
    text: String,
}

/// What was said to the user so far.
pub struct Findings<'a> {
    pub terminal: &'a Terminal,
    pub all: Vec<Finding>,
}

impl Findings<'_> {
    /// Says warnings and notes, and keeps them.
    pub fn warn(&mut self, findings: &[Diagnostic], source: &Source) {
        print_warnings(findings, source, self.terminal);
        self.all.extend(findings.iter().map(|finding| Finding::new(finding, Some(source))));
    }
}

impl Finding {
    /// The code and the message of a warning.
    pub fn warning(&self) -> Option<String> {
        let is_warning = self.severity == Severity::Warning.to_string();
        is_warning.then(|| format!("{} {}", self.code.unwrap_or_default(), self.message))
    }

    /// A finding in `source`.
    pub fn new(finding: &Diagnostic, source: Option<&Source>) -> Finding {
        let place = |span: Span| source.map(|source| place(source, span));
        let labels = finding.labels.iter();
        Finding {
            severity: finding.severity().to_string(),
            code: Some(finding.code.as_str()),
            message: finding.message.clone(),
            marker: finding.marker.clone(),
            source: source.map_or_else(String::new, |source| source.name.clone()),
            place: finding.span.and_then(place),
            labels: labels.filter_map(|label| Some((label.message.clone(), place(label.span)?))).collect(),
            hints: finding.hints.clone(),
        }
    }

    /// Everything a failure says.
    pub fn of_failure(failure: &Failure) -> Vec<Finding> {
        match failure {
            Failure::Found { source, findings } => {
                findings.iter().map(|finding| Finding::new(finding, source.as_ref())).collect()
            }
            Failure::Option { source, findings } => {
                findings.iter().map(|finding| Finding::new(finding, Some(source))).collect()
            }
            Failure::Usage(message) | Failure::Machine(message) => vec![Finding::plain(message)],
            Failure::NotPassed | Failure::Closed => Vec::new(),
        }
    }

    fn plain(message: &str) -> Finding {
        Finding {
            severity: "error".to_owned(),
            code: None,
            message: message.to_owned(),
            marker: String::new(),
            source: String::new(),
            place: None,
            labels: Vec::new(),
            hints: Vec::new(),
        }
    }
}

fn place(source: &Source, span: Span) -> Place {
    let (start, end) = (source.line_column(span.start), source.line_column(span.end));
    let text = source.text.lines().nth(start.line.saturating_sub(1)).unwrap_or("").to_owned();
    let line_end = text.chars().count() + 1;
    // What goes on over several lines is marked to the end of the first.
    let end = if end.line == start.line { end.column } else { line_end };
    Place { span: [span.start, span.end], line: start.line, column: start.column, end: end.max(start.column + 1), text }
}
