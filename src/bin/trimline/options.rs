//! Options that several commands share, and their meaning.

use clap::{Args, ValueEnum};

use trimline::diagnostic::{Diagnostic, Source};
use trimline::limits::Limits;
use trimline::method::{METHODS, Settings};
use trimline::threads::{self, ThreadsError};

use crate::failure::Failure;

/// How the command speaks to a person.
#[derive(Args)]
pub struct Terminal {
    /// Colours in diagnostics.
    #[arg(long, value_enum, default_value_t = Color::Auto, global = true, value_name = "WHEN")]
    pub color: Color,

    /// No warnings, progress or summaries.
    #[arg(long, short, global = true)]
    pub quiet: bool,

    /// Threads that share the work [default: one for each core]; results do not depend on it.
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

impl Terminal {
    /// Lets this process have as many threads as the user asked for.
    pub fn share_work(&self) -> Result<(), Failure> {
        let Some(count) = self.threads else { return Ok(()) };
        threads::set_default(usize::from(count)).map_err(|error| match error {
            ThreadsError::OneOnly(_) => Failure::Usage(format!("--threads {count}: {error}")),
            ThreadsError::Refused { .. } => Failure::Machine(error.to_string()),
        })
    }
}

/// When to use colours.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// How a command prints its result.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For reading.
    Text,
    /// For programs; keys are stable.
    Json,
}

/// What every command needs to read a spec.
#[derive(Args)]
pub struct Reading {
    /// Value of a param or of a coefficient of the equation; may be an expression in earlier params.
    #[arg(long = "set", value_name = "NAME=EXPR")]
    pub set: Vec<String>,

    /// Only this patch.
    #[arg(long, value_name = "NAME")]
    pub patch: Option<String>,

    /// Changes a limit, for example `nesting=200`; repeatable.
    #[arg(long, value_name = "KEY=N")]
    pub limits: Vec<String>,
}

impl Reading {
    /// The limits, as changed by the user.
    pub fn limits(&self) -> Result<Limits, Failure> {
        let mut limits = Limits::default();
        for change in &self.limits {
            let mut named = limits.named();
            let (key, value) = change.split_once('=').unwrap_or((change, ""));
            let known: Vec<&str> = named.iter().map(|(name, _)| *name).collect();
            let Some((_, slot)) = named.iter_mut().find(|(name, _)| *name == key) else {
                return Err(Failure::Usage(format!("there is no limit `{key}`; limits: {}", known.join(", "))));
            };
            **slot = value
                .parse()
                .map_err(|_| Failure::Usage(format!("`--limits {change}`: write KEY=N with a whole number N")))?;
        }
        Ok(limits)
    }
}

/// What every command that solves understands.
#[derive(Args)]
pub struct Solving {
    #[command(flatten)]
    pub reading: Reading,

    /// The solution method, instead of the spec's.
    #[arg(long, value_name = "NAME", long_help = method_help())]
    pub method: Option<String>,

    /// The number of trial functions of a fitted method, or its highest powers.
    #[arg(long, value_name = "K|MxN", allow_hyphen_values = true)]
    pub terms: Option<String>,

    /// What a fitted method fits together: joint or per-basis.
    #[arg(long, value_name = "HOW")]
    pub fit: Option<String>,

    /// The number of wave numbers of a Fourier series, instead of as many as the tolerance needs.
    #[arg(long, value_name = "N")]
    pub modes: Option<String>,

    /// Whether a surface carries what its Fourier series leaves out of the boundary data: on or off.
    #[arg(long, value_name = "on|off")]
    pub remainder: Option<String>,

    /// The tolerance of adaptive methods.
    #[arg(long, value_name = "X")]
    pub tolerance: Option<String>,

    /// The instant, where one is needed [default: start of the time domain].
    #[arg(long, value_name = "T")]
    pub time: Option<f64>,
}

/// The collocation grid of commands that take no points of their own.
#[derive(Args)]
pub struct Collocation {
    /// Collocation grid, for example `11x11`, `11x11:ends`; nodes are midpoints, ends, gauss or chebyshev.
    #[arg(long, value_name = "LxM[:KIND]", allow_hyphen_values = true)]
    pub points: Option<String>,
}

fn method_help() -> String {
    let rows = METHODS.iter().map(|method| format!("  {:12} {}", method.name(), method.description()));
    let rows: Vec<String> = rows.collect();
    format!(
        "The solution method, instead of the spec's:\n  auto         the first of exact, fourier and legendre that suits the problem\n{}",
        rows.join("\n")
    )
}

impl Solving {
    /// Options of the solution that are given, by name.
    fn given<'a>(&'a self, points: Option<&'a str>) -> Vec<(&'static str, &'a str)> {
        let all = [
            ("terms", self.terms.as_deref()),
            ("points", points),
            ("fit", self.fit.as_deref()),
            ("modes", self.modes.as_deref()),
            ("remainder", self.remainder.as_deref()),
            ("tolerance", self.tolerance.as_deref()),
            ("method", self.method.as_deref()),
        ];
        all.into_iter().filter_map(|(name, value)| value.map(|value| (name, value))).collect()
    }

    /// A failure for a finding without a place: it is about the option that it names, or else about the method.
    pub fn fault(&self, points: Option<&str>, finding: Diagnostic) -> Failure {
        let given = self.given(points);
        let is_named = |(name, value): &&(&str, &str)| {
            finding.message.contains(name)
                || (*name == "points" && finding.message.contains("grid"))
                || finding.message.contains(value)
        };
        match given.iter().find(is_named).or(given.last()) {
            Some((name, value)) => option_finding(name, value, finding),
            None => Failure::Found { source: None, findings: vec![finding] },
        }
    }

    /// The settings that options give.
    pub fn settings(&self, points: Option<&str>) -> Result<Settings, Failure> {
        let mut settings = Settings::default();
        for (key, value) in self.given(points).into_iter().filter(|(name, _)| *name != "method") {
            settings.set(key, value, None).map_err(|finding| option_finding(key, value, finding))?;
        }
        Ok(settings)
    }
}

/// A finding about the value of an option, shown in the option's own text.
pub fn option_finding(option: &str, value: &str, finding: Diagnostic) -> Failure {
    let source = Source::new(format!("--{option}"), value);
    let whole = trimline::diagnostic::Span::new(0, value.len());
    Failure::Option { source, findings: vec![finding.at(whole)] }
}

/// Reads how many.
pub fn read_count(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "write a whole number that is not negative".to_owned())
}

/// Reads `64x128`.
pub fn read_grid(text: &str) -> Result<(usize, usize), Failure> {
    let wrong = || Failure::Usage(format!("`{text}` is not a grid: write NUxNV, for example 64x128"));
    let (u, v) = text.split_once(['x', '×']).ok_or_else(wrong)?;
    Ok((u.trim().parse().map_err(|_| wrong())?, v.trim().parse().map_err(|_| wrong())?))
}
