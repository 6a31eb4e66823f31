//! Zip archives with equal bytes for equal content.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::ExportError;

/// An archive in memory, of files that are not compressed and bear no time of day.
pub(super) struct Archive(ZipWriter<Cursor<Vec<u8>>>);

impl Archive {
    pub fn new() -> Archive {
        Archive(ZipWriter::new(Cursor::new(Vec::new())))
    }

    /// Adds the file `name`, whose content `write` writes.
    pub fn add(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
    ) -> Result<(), ExportError> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::default())
            .unix_permissions(0o644)
            // Otherwise a file of more than 4 GiB fails after it was written.
            .large_file(false);
        self.0.start_file(name, options).map_err(std::io::Error::from)?;
        write(&mut self.0)?;
        Ok(())
    }

    /// Writes the whole archive.
    pub fn finish(self, out: &mut dyn Write) -> Result<(), ExportError> {
        let bytes = self.0.finish().map_err(std::io::Error::from)?;
        out.write_all(bytes.get_ref())?;
        Ok(())
    }
}
