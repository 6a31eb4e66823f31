//! `trimline emit`: the solved surface as source code in another language.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use trimline::diagnostic::{Code, Diagnostic};
use trimline::emit::{Formula, Language, emit};
use trimline::fit::{Settings, Target, fit};

use crate::Outcome;
use crate::failure::{Failure, print_warnings};
use crate::options::{Collocation, Solving, Terminal, option_finding};
use crate::output::{self, Files};
use crate::parts::{Located, Part};
use crate::workflow::{Solved, Spec};

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

    /// How far a B-spline may be from a patch that has no formula, and is written as one.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    within: Option<String>,

    /// The file, instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let Some(language) = Language::ALL.iter().copied().find(|language| language.name() == arguments.lang) else {
        return Err(Failure::Usage(format!("there is no language `{}`", arguments.lang)));
    };
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let parts = spec.parts(&arguments.solving, arguments.collocation.points.as_deref())?;
    let [part] = parts.as_slice() else {
        let names: Vec<&str> = parts.iter().map(Located::name).collect();
        let message = "a file holds one patch: name it with --patch";
        return Err(Failure::Usage(format!("{message}; patches: {}", names.join(", "))));
    };
    let within = arguments.within.as_deref().map(Within::read).transpose()?;
    let formula = formula(&spec, part, part.instant(arguments.solving.time)?, within, terminal)?;
    let text = emit(&formula, language).map_err(|finding| spec.fault(finding))?;
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

/// The formula of a part at `time`; with `within`, of one that has none, a B-spline that is no farther away than that.
fn formula(
    spec: &Spec,
    part: &Part,
    time: f64,
    within: Option<Within<'_>>,
    terminal: &Terminal,
) -> Result<Formula, Failure> {
    let domain = *part.domain();
    match part {
        Part::Copy(copied) => {
            let original = formula(spec, &copied.original, time, within, terminal)?;
            let is_reflection = copied.placement.is_reflection(spec.bindings.as_slice(), time);
            let is_reflection = is_reflection.map_err(|finding| spec.fault(finding))?;
            Ok(original.copied(&spec.problem, &spec.bindings, &copied.copy, is_reflection))
        }
        Part::Net(_) => {
            let shape = spec.shape(part, time)?;
            print_warnings(&shape.warnings, &spec.source, terminal);
            let net = shape.net.ok_or_else(|| Failure::Machine(format!("`{}` is no net", part.name())))?;
            Ok(Formula::of_net(part.name(), net.filled.surface, domain, net.surface.instant(), None))
        }
        Part::Patch(patched) => {
            let Solved { solution, .. } = spec.solve(patched, time)?;
            print_warnings(&solution.report.warnings, &spec.source, terminal);
            let exact = |surface| Formula::new(part.name(), &spec.problem, surface, domain);
            let patch = patched.prepared.patch();
            let fault = |finding: Diagnostic| spec.fault(finding.at(patch.boundary_origin()));
            match (solution.separable().and_then(exact), within) {
                (Ok(formula), _) => Ok(formula),
                (Err(finding), None) => Err(fault(finding)),
                (Err(_), Some(within)) => {
                    let target = Target { name: part.name(), surface: &*solution.surface, u: domain.u, v: domain.v };
                    let settings = Settings { tolerance: Some(within.length), ..Settings::default() };
                    let fitted =
                        fit(&[target], time, &settings, &spec.limits).map_err(|finding| match finding.code {
                            Code::SettingOutOfRange => option_finding("within", within.text, finding),
                            _ => fault(finding),
                        })?;
                    let fitted = fitted.into_iter().next();
                    let fitted = fitted.ok_or_else(|| Failure::Machine("a patch was not fitted".to_owned()))?;
                    let instant = patch.moves(&spec.problem.graph).then_some(time);
                    Ok(Formula::of_net(part.name(), fitted.surface, domain, instant, Some(fitted.deviation)))
                }
            }
        }
    }
}

/// The distance that a B-spline may have from a patch, as it was given.
#[derive(Clone, Copy)]
struct Within<'a> {
    text: &'a str,
    length: f64,
}

impl Within<'_> {
    fn read(text: &str) -> Result<Within<'_>, Failure> {
        let length = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
        length.map(|length| Within { text, length }).ok_or_else(|| {
            let finding = Diagnostic::new(Code::SettingOutOfRange, format!("`{text}` is no positive length"));
            option_finding("within", text, finding.hint("for example --within 1e-6"))
        })
    }
}
