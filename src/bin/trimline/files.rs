//! Files that are read. The data files of a spec: they lie in its folder or below it; those of standard input in the current one.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use trimline::limits::Limits;
use trimline::syntax;

use crate::workflow::read_source;

/// Opens a regular file, or what a shell hands over as one: `/dev/stdin`, `<(command)`.
///
/// Other pipes and devices are refused unopened: a pipe waits for its writer, and a device may have no end.
pub fn open(path: &Path) -> io::Result<File> {
    if std::fs::metadata(path)?.is_file() || is_handed_over(path) {
        File::open(path)
    } else {
        Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"))
    }
}

fn is_handed_over(path: &Path) -> bool {
    ["/dev/stdin", "/dev/fd", "/proc/self/fd"].iter().any(|place| path.starts_with(place))
}

/// The bytes of the data file `name` of the spec `spec`, at most one more than `allowed`; or why there are none.
pub fn read(spec: &str, name: &str, allowed: usize) -> Result<Vec<u8>, String> {
    let path = place(spec, name).canonicalize().map_err(|error| error.to_string())?;
    if !place(spec, "").canonicalize().is_ok_and(|folder| path.starts_with(folder)) {
        return Err("it is a link that leads out of the folder of the spec".to_owned());
    }
    let file = open(&path).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    let limit = u64::try_from(allowed).unwrap_or(u64::MAX).saturating_add(1);
    file.take(limit).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Where the data file `name` of a spec lies.
fn place(spec: &str, name: &str) -> PathBuf {
    let is_handed_over = spec == "-" || is_handed_over(Path::new(spec));
    let folder = if is_handed_over { None } else { Path::new(spec).parent() };
    folder.filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).join(name)
}

/// Where the data files lie that a spec names, if it can be read and parsed.
#[cfg_attr(not(feature = "view"), expect(dead_code, reason = "only the view follows files"))]
pub fn named_by(spec: &str, limits: &Limits) -> Option<Vec<PathBuf>> {
    let source = read_source(spec, limits).ok()?;
    let document = syntax::parse(&source, limits).ok()?;
    Some(document.files.iter().map(|file| place(spec, &file.path)).collect())
}
