//! `trimline emit`: the solved surface as source code in another language.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use trimline::emit::{Formula, Language, emit};

use crate::Outcome;
use crate::failure::{Failure, print_warnings};
use crate::options::{Collocation, Solving, Terminal};
use crate::output::{self, Files};
use crate::parts::Located;
use crate::workflow::Spec;

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// The language.
    #[arg(long, value_name = "LANGUAGE", value_parser = PossibleValuesParser::new(Language::ALL.iter().map(|l| l.name())))]
    lang: String,

    /// The file, instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let Some(language) = Language::ALL.iter().copied().find(|language| language.name() == arguments.lang) else {
        return Err(Failure::Usage(format!("there is no language `{}`", arguments.lang)));
    };
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    spec.without_nets("emit")?;
    if spec.patches.is_empty() {
        spec.without_copies("emit")?;
    }
    let [patch] = spec.patches.as_slice() else {
        let names: Vec<&str> = spec.patches.iter().map(|patch| patch.name.as_str()).collect();
        let message = "a file holds one patch: name it with --patch";
        return Err(Failure::Usage(format!("{message}; patches: {}", names.join(", "))));
    };
    let patched = spec.prepare(patch, &arguments.solving, arguments.collocation.points.as_deref())?;
    let solved = spec.solve(&patched, patched.instant(arguments.solving.time)?)?;
    print_warnings(&solved.solution.report.warnings, &spec.source, terminal);
    let formula = |surface| Formula::new(&patch.name, &spec.problem, surface, patched.prepared.domain);
    let text = solved.solution.separable().and_then(formula).and_then(|formula| emit(&formula, language));
    let text = text.map_err(|finding| spec.fault(finding.at(patched.prepared.patch().boundary_origin())))?;
    match &arguments.output {
        None => output::print(&text),
        Some(path) => {
            let mut files = Files::default();
            let file = files.create(path)?;
            std::io::Write::write_all(file, text.as_bytes())
                .map_err(|error| Failure::Machine(format!("cannot write `{}`: {error}", path.display())))?;
            files.keep()
        }
    }
}
