//! Results to standard output or to files that are complete or absent.

use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::failure::Failure;
use crate::unfinished;

/// Prints a whole result.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Err(Failure::Closed),
        Err(error) => Err(Failure::Machine(format!("cannot write to standard output: {error}"))),
    }
}

/// What a path's extension, in lower case, is to `meaning`; `known` are the extensions it has a meaning for.
pub fn by_extension<T>(path: &Path, known: &[&str], meaning: impl FnOnce(&str) -> Option<T>) -> Result<T, Failure> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).unwrap_or_default();
    meaning(&extension).ok_or_else(|| {
        let has = match extension.as_str() {
            "" => "no extension".to_owned(),
            _ => format!("the extension `.{extension}`"),
        };
        let known: Vec<String> = known.iter().map(|extension| format!(".{extension}")).collect();
        Failure::Usage(format!("`{}` has {has}; write {}", path.display(), known.join(", ")))
    })
}

/// A measured number for people: two digits, and an exponent only where it is shorter than the zeros.
pub fn rounded(value: f64) -> String {
    let scientific = format!("{value:.1e}");
    match scientific.parse::<f64>() {
        Ok(0.0) => "0".to_owned(),
        Ok(rounded) if (1e-2..1e4).contains(&rounded.abs()) => rounded.to_string(),
        _ => scientific,
    }
}

/// Prints a value as JSON.
pub fn print_json(value: &impl serde::Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value).map_err(|error| Failure::Machine(error.to_string()))?;
    print(&(text + "\n"))
}

/// Files written beside their names, which they get all together when every one is complete.
#[derive(Default)]
pub struct Files {
    written: Vec<(NamedTempFile, PathBuf)>,
}

impl Files {
    /// A new file that will be called `path`.
    ///
    /// A link is followed; a folder or a device is refused, since renaming would replace it, and so is a file that
    /// may not be written. What was there before leaves its permissions to the new file.
    pub fn create(&mut self, path: &Path) -> Result<&mut NamedTempFile, Failure> {
        let resolved = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let path = resolved.as_path();
        if path.exists() && !path.is_file() {
            return Err(Failure::Usage(format!("`{}` is not an ordinary file", path.display())));
        }
        let before = path.metadata().ok().map(|metadata| metadata.permissions());
        if before.as_ref().is_some_and(std::fs::Permissions::readonly) {
            return Err(Failure::Machine(format!("cannot write `{}`: the file is read-only", path.display())));
        }
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let mut builder = tempfile::Builder::new();
        builder.prefix(".trimline-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // Temporary files are private by default; results are ordinary files, under the process's umask.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        let mut unfinished = unfinished::names();
        let file = builder
            .tempfile_in(folder)
            .map_err(|error| Failure::Machine(format!("cannot write to `{}`: {error}", folder.display())))?;
        unfinished.push(file.path().to_owned());
        drop(unfinished);
        if let Some(before) = before {
            let kept = file.as_file().set_permissions(before);
            kept.map_err(|error| Failure::Machine(format!("cannot write `{}`: {error}", path.display())))?;
        }
        self.written.push((file, path.to_owned()));
        match self.written.last_mut() {
            Some((file, _)) => Ok(file),
            None => Err(Failure::Machine("no file was made".to_owned())),
        }
    }

    /// Gives every file its name.
    pub fn keep(self) -> Result<(), Failure> {
        // Held until all have their names, so that a signal does not part them.
        let _unfinished = unfinished::names();
        for (file, path) in self.written {
            file.persist(&path)
                .map_err(|error| Failure::Machine(format!("cannot write `{}`: {}", path.display(), error.error)))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn rounded_number_has_an_exponent_only_where_it_helps() {
        let shown = [13.04, 0.0, -0.0, 90.0, 0.0123, 12345.0, 1.26e-9, -0.5, f64::INFINITY].map(rounded);
        assert_eq!(shown, ["13", "0", "0", "90", "0.012", "1.2e4", "1.3e-9", "-0.5", "inf"]);
    }
}
