//! The data files that a document names. The library reads none: whoever has the document attaches their bytes.

use std::sync::Arc;

use super::ast::{Definition, DefinitionKind, Document, Expression, Kind, NetSource};
use super::expression::Builder;
use super::parser::{Parsed, Rule};
use super::statement::internal;
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Span};
use crate::limits::Limits;

/// A data file that a document names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataFile {
    /// As it is written: relative to the folder of the spec, folders separated by `/`.
    pub path: String,
    /// Where it is named first.
    pub span: Span,
    /// Its bytes, once they were attached.
    pub contents: Option<Arc<[u8]>>,
}

impl Document {
    /// Adds the files of definitions and nets to [`Document::files`].
    pub(super) fn note_files(&mut self) {
        let definitions = self.shared.definitions.iter().map(|definition| definition.value);
        let nets = self.nets.iter().flat_map(|block| &block.nets).filter_map(|net| match net.source {
            Some(NetSource::Table(file)) => Some(file),
            _ => None,
        });
        for value in definitions.chain(nets) {
            let node = self.tree.node(value);
            if let Kind::Text(path) = &node.kind
                && !self.files.iter().any(|file| file.path == *path)
            {
                self.files.push(DataFile { path: path.clone(), span: node.span, contents: None });
            }
        }
    }

    /// The file called `path`.
    #[must_use]
    pub fn file(&self, path: &str) -> Option<&DataFile> {
        self.files.iter().find(|file| file.path == path)
    }

    /// Asks `read` for the bytes of every file that has none yet. It need not read more than the limit `file-bytes`
    /// and one byte; what it says when it cannot follows the name of the file in the message.
    ///
    /// # Errors
    /// [`Code::DataFileMissing`] for each that cannot be read, [`Code::LimitReached`] for those that are too large.
    pub fn attach_files(
        &mut self,
        limits: &Limits,
        mut read: impl FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<(), Diagnostics> {
        let mut found = Diagnostics::new();
        for file in self.files.iter_mut().filter(|file| file.contents.is_none()) {
            let path = &file.path;
            match read(path) {
                Ok(bytes) if bytes.len() <= limits.file_bytes => file.contents = Some(bytes.into()),
                Ok(_) => {
                    let limit = limits.file_bytes;
                    let message = format!("`{path}` is longer than the limit `file-bytes` of {limit} bytes");
                    found.push(Diagnostic::new(Code::LimitReached, message).at(file.span));
                }
                Err(reason) => {
                    let message = format!("the data file `{path}` cannot be read: {reason}");
                    let finding = Diagnostic::new(Code::DataFileMissing, message).at(file.span);
                    found.push(finding.hint("data files are looked for beside the spec"));
                }
            }
        }
        if found.is_empty() { Ok(()) } else { Err(found) }
    }
}

impl Builder<'_> {
    /// `NAME = points("ring.csv")`
    pub(super) fn curve(&mut self, part: Parsed<'_>) -> Result<Definition, Diagnostic> {
        let mut inner = part.into_inner();
        let name = self.take_name(&mut inner)?;
        let value = self.file(&mut inner)?;
        Ok(Definition { kind: DefinitionKind::Curve, name, formals: Vec::new(), value })
    }

    /// `NAME = bspline("part.step", face = 2)`
    pub(super) fn imported(&mut self, part: Parsed<'_>) -> Result<Definition, Diagnostic> {
        let mut inner = part.into_inner();
        let name = self.take_name(&mut inner)?;
        let arguments = inner.find(|part| part.as_rule() == Rule::arguments).ok_or_else(internal)?;
        let values = self.bracket(&arguments)?;
        let kinds: Vec<&Kind> = values.iter().map(|value| &self.tree.node(*value).kind).collect();
        let (value, path, face) = match (values.as_slice(), kinds.as_slice()) {
            ([file], [Kind::Text(path)]) => (*file, path, None),
            ([file, _], [Kind::Text(path), Kind::Face(face)]) => (*file, path, Some(*face)),
            _ => {
                let message = "a file of B-splines is named by a text in quotes, and one of its faces by a number";
                let finding = Diagnostic::new(Code::UnexpectedText, message).at(self.span(&arguments));
                return Err(finding.hint("as in `bspline(\"part.step\", face = 2)`"));
            }
        };
        check_path(path, self.tree.span(value))?;
        Ok(Definition { kind: DefinitionKind::Imported(face), name, formals: Vec::new(), value })
    }

    /// The name of a data file, the one text in a bracket.
    pub(super) fn file<'a>(&mut self, parts: &mut impl Iterator<Item = Parsed<'a>>) -> Result<Expression, Diagnostic> {
        let arguments = parts.find(|part| part.as_rule() == Rule::arguments).ok_or_else(internal)?;
        match self.bracket(&arguments)?.as_slice() {
            [only] if let Kind::Text(path) = &self.tree.node(*only).kind => {
                check_path(path, self.tree.span(*only))?;
                Ok(*only)
            }
            _ => Err(Diagnostic::new(Code::UnexpectedText, "a data file is named by one text in quotes")
                .at(self.span(&arguments))
                .hint("as in `points(\"ring.csv\")`")),
        }
    }
}

/// Refuses the name of a file that does not lie beside the spec or below it, or that not every system can spell.
fn check_path(path: &str, span: Span) -> Result<(), Diagnostic> {
    let parts: Vec<&str> = path.split('/').collect();
    let reason = if path.trim().is_empty() {
        "the name of the data file is empty"
    } else if path.contains(['\\', ':']) {
        "the name of a data file has no `\\` and no `:`: folders are separated by `/`"
    } else if path.starts_with('/') || parts.contains(&"..") {
        "a data file lies in the folder of the spec or in one below it"
    } else if parts.iter().any(|part| part.is_empty()) {
        "a part of the name is empty"
    } else {
        return Ok(());
    };
    Err(Diagnostic::new(Code::DataFileMissing, reason)
        .at(span)
        .hint("name it relative to the spec: `points(\"data/ring.csv\")`"))
}
