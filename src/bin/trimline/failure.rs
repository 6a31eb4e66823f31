//! Failures with their exit status, and diagnostics as people read them.

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use trimline::diagnostic::{Class, Code, Diagnostic, Diagnostics, Severity, Source, Span};

use crate::options::{Color, Terminal};

/// Why a command ends without a result.
pub enum Failure {
    /// Something is wrong with a text, a problem or a result.
    Found {
        /// The text the findings point into.
        source: Option<Source>,
        /// What is wrong; at least one error.
        findings: Diagnostics,
    },
    /// Something is wrong with the value of an option, which is the text the findings point into.
    Option {
        /// The option's name and its value.
        source: Source,
        /// What is wrong; at least one error.
        findings: Diagnostics,
    },
    /// The command line asks for something that does not exist.
    Usage(String),
    /// The machine did not do what it was asked.
    Machine(String),
    /// A check was carried out and not passed; what it found is printed already.
    NotPassed,
    /// The reader of standard output went away.
    Closed,
}

impl Failure {
    /// Findings in `source`.
    pub fn found(source: &Source, findings: Diagnostics) -> Failure {
        Failure::Found { source: Some(source.clone()), findings }
    }

    /// One finding in `source`.
    pub fn one(source: &Source, finding: Diagnostic) -> Failure {
        Failure::found(source, vec![finding])
    }

    /// The status that scripts rely on.
    pub fn status(&self) -> ExitCode {
        let class = |findings: &Diagnostics| {
            let first = findings.iter().find(|finding| finding.severity() == Severity::Error);
            first.map_or(Class::Source, Diagnostic::class)
        };
        let of_class = |class: Class| match class {
            Class::Source | Class::Unsupported => 1,
            Class::Numerical => 3,
            Class::Limit => 4,
            Class::Host | Class::Output => 5,
        };
        ExitCode::from(match self {
            Failure::Found { findings, .. } => of_class(class(findings)),
            Failure::Option { findings, .. } => match class(findings) {
                Class::Source => 2,
                class => of_class(class),
            },
            Failure::NotPassed => 1,
            Failure::Usage(_) => 2,
            Failure::Machine(_) => 5,
            // Who reads only the beginning, as `head` does, has what he wants.
            Failure::Closed => 0,
        })
    }

    /// Says on standard error what went wrong.
    pub fn print(&self, terminal: &Terminal) {
        match self {
            Failure::Found { source, findings } => print_all(findings, source.as_ref(), terminal),
            Failure::Option { source, findings } => print_all(findings, Some(source), terminal),
            Failure::Usage(message) | Failure::Machine(message) => say(&format!("error: {message}")),
            Failure::NotPassed | Failure::Closed => {}
        }
    }
}

/// What was said about one patch at some of its instants.
#[derive(Clone, Default)]
pub struct Said {
    findings: Vec<(Code, Option<Span>, String)>,
}

impl Said {
    /// The warnings of one instant that no earlier instant gave: of one code at one place, with one marker, only the
    /// numbers differ.
    pub fn news(&mut self, warnings: Diagnostics) -> Diagnostics {
        let identity = |warning: &Diagnostic| (warning.code, warning.span, warning.marker.clone());
        let here: Vec<_> = warnings.iter().map(identity).collect();
        let news = warnings.into_iter().filter(|warning| !self.findings.contains(&identity(warning))).collect();
        self.findings.extend(here);
        news
    }
}

/// Prints warnings and notes, unless the user wants quiet.
pub fn print_warnings(findings: &[Diagnostic], source: &Source, terminal: &Terminal) {
    if !terminal.quiet {
        print_all(findings, Some(source), terminal);
    }
}

/// Writes a line to standard error; a closed standard error is no reason to fail.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

fn print_all(findings: &[Diagnostic], source: Option<&Source>, terminal: &Terminal) {
    let is_colored = match terminal.color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
    };
    let renderer = if is_colored { Renderer::styled() } else { Renderer::plain() };
    for finding in findings {
        say(&renderer.render(&[group(finding, source)]));
    }
}

fn group<'a>(finding: &'a Diagnostic, source: Option<&'a Source>) -> Group<'a> {
    let level = match finding.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let mut group = Group::with_title(level.primary_title(finding.message.as_str()).id(finding.code.as_str()));
    if let (Some(source), Some(span)) = (source, finding.span) {
        let marked = AnnotationKind::Primary.span(shown(&source.text, span));
        let marked = if finding.marker.is_empty() { marked } else { marked.label(finding.marker.as_str()) };
        let others = finding
            .labels
            .iter()
            .map(|label| AnnotationKind::Context.span(shown(&source.text, label.span)).label(label.message.as_str()));
        let snippet = Snippet::source(source.text.as_str()).path(source.name.as_str()).annotation(marked);
        group = group.element(snippet.annotations(others));
    }
    for hint in &finding.hints {
        group = group.element(Level::HELP.with_name("hint").message(hint.as_str()));
    }
    group
}

/// The range of whole characters that covers `span`; text that was not UTF-8 is shown with replacements.
fn shown(text: &str, span: Span) -> std::ops::Range<usize> {
    let start = (0..=span.start.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    let end = (span.end.min(text.len())..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len());
    start..end.max(start)
}
