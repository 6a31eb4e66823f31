//! The data files of a spec: they lie in its folder or below it; those of standard input in the current one.

use std::io::Read;
use std::path::{Path, PathBuf};

use trimline::limits::Limits;
use trimline::syntax;

use crate::workflow::read_source;

/// The bytes of the data file `name` of the spec `spec`, at most one more than `allowed`; or why there are none.
pub fn read(spec: &str, name: &str, allowed: usize) -> Result<Vec<u8>, String> {
    let path = place(spec, name);
    let file = std::fs::File::open(&path).map_err(|error| error.to_string())?;
    // A pipe or a device would have no end.
    if !file.metadata().is_ok_and(|about| about.is_file()) {
        return Err("it is not a regular file".to_owned());
    }
    let mut bytes = Vec::new();
    let limit = u64::try_from(allowed).unwrap_or(u64::MAX).saturating_add(1);
    file.take(limit).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Where the data file `name` of a spec lies.
fn place(spec: &str, name: &str) -> PathBuf {
    let folder = if spec == "-" { None } else { Path::new(spec).parent() };
    folder.unwrap_or(Path::new("")).join(name)
}

/// Where the data files lie that a spec names, if it can be read and parsed.
#[cfg_attr(not(feature = "view"), expect(dead_code, reason = "only the view follows files"))]
pub fn named_by(spec: &str, limits: &Limits) -> Option<Vec<PathBuf>> {
    let source = read_source(spec, limits).ok()?;
    let document = syntax::parse(&source, limits).ok()?;
    Some(document.files.iter().map(|file| place(spec, &file.path)).collect())
}
