//! The data files that a document names. The library reads none: whoever has the document attaches their bytes.

use std::sync::Arc;

use super::ast::{Document, Kind, NetSource};
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

/// Refuses the name of a file that does not lie beside the spec or below it, or that not every system can spell.
pub(super) fn check_path(path: &str, span: Span) -> Result<(), Diagnostic> {
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
