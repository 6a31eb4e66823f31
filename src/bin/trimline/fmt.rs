//! `trimline fmt`: specs in their canonical layout.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use trimline::diagnostic::Source;
use trimline::limits::Limits;
use trimline::syntax::{self, Alphabet};

use crate::Outcome;
use crate::failure::Failure;
use crate::options::Terminal;
use crate::output::{self, Files};
use crate::workflow::read_source;

#[derive(Args)]
pub struct Arguments {
    /// The spec files, or `-` to print standard input laid out.
    #[arg(required = true)]
    spec: Vec<String>,

    /// Write nothing; name the files that are laid out otherwise, and fail if there are any.
    #[arg(long)]
    check: bool,

    /// Names and operators in ASCII: `beta`, `d4S/du4`, `v^2`.
    #[arg(long, conflicts_with = "unicode")]
    ascii: bool,

    /// Names and operators in Unicode: `β`, `∂⁴S/∂u⁴`, `v²`.
    #[arg(long)]
    unicode: bool,
}

/// A spec and its layout.
struct Laid {
    path: String,
    source: Source,
    text: String,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let alphabet = match (arguments.ascii, arguments.unicode) {
        (true, _) => Alphabet::Ascii,
        (_, true) => Alphabet::Unicode,
        _ => Alphabet::Kept,
    };
    let mut laid = Vec::new();
    let mut failures: Vec<Failure> = Vec::new();
    for path in &arguments.spec {
        match lay_out(path, alphabet) {
            Ok(one) => laid.push(one),
            Err(failure) => failures.push(failure),
        }
    }
    // With several specs each fault is reported and nothing is written; the last one decides the status.
    if let Some(last) = failures.pop() {
        failures.iter().for_each(|failure| failure.print(terminal));
        return Err(last);
    }
    let changed = laid.iter().filter(|one| one.text != one.source.text);
    if arguments.check {
        let names: String = changed.map(|one| format!("{}\n", one.source.name)).collect();
        output::print(&names)?;
        return if names.is_empty() { Ok(()) } else { Err(Failure::NotPassed) };
    }
    let mut files = Files::default();
    for one in changed.filter(|one| one.path != "-") {
        write(&mut files, one)?;
    }
    let printed: String = laid.iter().filter(|one| one.path == "-").map(|one| one.text.as_str()).collect();
    files.keep()?;
    if printed.is_empty() { Ok(()) } else { output::print(&printed) }
}

fn lay_out(path: &str, alphabet: Alphabet) -> Result<Laid, Failure> {
    let limits = Limits::default();
    let source = read_source(path, &limits)?;
    let text = syntax::format(&source, alphabet, &limits).map_err(|findings| Failure::found(&source, findings))?;
    Ok(Laid { path: path.to_owned(), source, text })
}

fn write(files: &mut Files, laid: &Laid) -> Result<(), Failure> {
    let path = PathBuf::from(&laid.path);
    let failed = |error: std::io::Error| Failure::Machine(format!("cannot write `{}`: {error}", laid.path));
    files.create(&path)?.write_all(laid.text.as_bytes()).map_err(failed)
}
