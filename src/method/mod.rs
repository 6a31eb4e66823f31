//! Solution methods: each turns a [`Decomposition`] and settings into a [`Solver`], and a solver turns numbers
//! into a [`Solution`].
//!
//! Every method is a folder here and a line in [`METHODS`]; `--help`, the documentation's table and the
//! conformance tests list them from there. A method says why it does not accept a problem. It never measures
//! its own solution: [`verify`](crate::verify) does. What fitted methods share is in `equation` and `fitting`.

mod equation;
mod exact;
mod exact_or_fourier;
mod fitting;
mod four_sided;
mod fourier;
mod legendre;
mod polynomial;
mod settings;
mod sine;
mod static_blend;

pub use four_sided::Known;
pub use settings::{Fit, Settings, Size, Terms};

use std::sync::Arc;

use crate::decompose::Decomposition;
use crate::diagnostic::{Class, Code, Diagnostic, Diagnostics, Span};
use crate::eval::Backend;
use crate::limits::Limits;
use crate::problem::DomainValues;
use crate::surface::{SeparableSurface, Surface};

/// A way to solve a patch.
pub trait Method: Sync {
    /// The name in specs and options.
    fn name(&self) -> &'static str;

    /// What it does, in one line.
    fn description(&self) -> &'static str;

    /// The settings it reads, by name.
    fn settings(&self) -> &'static [&'static str];

    /// Whether it is for patches with data at fixed v as well as at fixed u.
    fn is_four_sided(&self) -> bool {
        false
    }

    /// Whether it can treat the problem. Asked only about patches that [`Method::is_four_sided`] fits.
    ///
    /// # Errors
    /// [`Code::UnsupportedByMethod`] with the reason.
    fn accepts(&self, decomposition: &Decomposition, limits: &Limits) -> Result<(), Diagnostic>;

    /// Whether it is a good choice for these numbers, for a problem that it accepts.
    ///
    /// # Errors
    /// [`Code::UnsupportedByMethod`] with the reason.
    fn suits(
        &self,
        _decomposition: &Decomposition,
        _numbers: &Numbers<'_>,
        _limits: &Limits,
    ) -> Result<(), Diagnostic> {
        Ok(())
    }

    /// Compiles everything that does not depend on numbers.
    ///
    /// # Errors
    /// A setting out of range, or a system beyond its limit.
    fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic>;
}

/// A compiled problem, ready to be solved for any parameters at any instant.
pub trait Solver: Send + Sync {
    /// Solves at instant `t`.
    ///
    /// `params` holds a value for every symbol of the decomposition's graph
    /// ([`Bindings::as_slice`](crate::problem::Bindings::as_slice)); `ranges` are the ranges of u and v.
    ///
    /// # Errors
    /// Data that are not finite, or a system without a reliable solution.
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic>;

    /// Whether `solution`, one of its own, and what is reported of it, is the same at every instant: an animation then
    /// needs one.
    fn is_everlasting(&self, _solution: &Solution) -> bool {
        false
    }
}

/// A solved patch.
#[derive(Clone)]
pub struct Solution {
    /// The surface.
    pub surface: Arc<dyn Surface + Send + Sync>,
    /// How it was found.
    pub report: Report,
}

impl Solution {
    /// The surface as a sum of products, for what needs its functions and not only its points.
    ///
    /// # Errors
    /// [`Code::NotSeparable`] for patches with data on four sides, and for deformed ones.
    pub fn separable(&self) -> Result<&SeparableSurface, Diagnostic> {
        self.surface.as_separable().ok_or_else(|| {
            let message = "this surface is no sum of products of functions of u and of v, t";
            Diagnostic::new(Code::NotSeparable, message)
                .hint("patches with constraints at fixed v or with deformations are none")
                .hint("state how far a B-spline may be off, which is then written instead: --within LENGTH")
        })
    }
}

/// What a method knows about its own solution.
#[derive(Debug, Clone)]
pub struct Report {
    /// The method's name.
    pub method: &'static str,
    /// Whether the equation is solved exactly, up to rounding.
    pub is_exact: bool,
    /// The number of basis functions.
    pub basis_size: usize,
    /// The number of functions of the closure, for methods that solve on it.
    pub closure_size: Option<usize>,
    /// The number of fitted functions of u.
    pub modes: usize,
    /// The largest condition of the systems solved, for methods that fit.
    pub condition: Option<f64>,
    /// How much larger solutions can be than those of a definite equation, for exact methods.
    pub amplification: Option<f64>,
    /// What a series leaves out of the boundary data, for methods that truncate one.
    pub truncation: Option<Truncation>,
    /// The sum of the ranks of the systems solved.
    pub rank: usize,
    /// The sum of their unknowns; equal to the rank unless something was left undetermined.
    pub unknowns: usize,
    /// The limit that ended the search for more terms: what was found up to there stands.
    pub limit: Option<Diagnostic>,
    /// What the user should know.
    pub warnings: Diagnostics,
}

/// What a truncated series leaves out.
#[derive(Debug, Clone, PartialEq)]
pub struct Truncation {
    /// The largest value that is left out of the boundary data, of any condition and component.
    pub left_out: f64,
    /// The largest part that is left out of a function in the force, as a share of its size; `None` where none is expanded.
    /// The surface misses its equation by as much.
    pub of_force: Option<f64>,
    /// v where most is left out of each condition and component of which anything is: where the verifier looks too.
    pub places: Vec<f64>,
    /// Whether the surface meets its boundary all the same; otherwise it misses it by `left_out`.
    pub has_remainder: bool,
}

/// What a preparation is given besides the problem.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// The method, instead of the document's.
    pub method: Option<String>,
    /// Settings; those of the document hold where there are none.
    pub settings: Settings,
    /// How programs run.
    pub backend: Backend,
    /// Bounds.
    pub limits: Limits,
    /// What patches that are prepared with the same options have in common.
    pub known: Known,
}

/// Every method; those that are not [`AUTOMATIC`] are chosen by name alone.
pub const METHODS: &[&dyn Method] = &[
    &exact::Exact,
    &fourier::Fourier,
    &legendre::Legendre,
    &polynomial::Polynomial,
    &sine::SineSeries,
    &static_blend::StaticBlend,
    &four_sided::FourSided,
];

/// The methods that `auto` tries, in this order, among those for as many sides as the patch has.
pub const AUTOMATIC: &[&dyn Method] = &[&exact::Exact, &fourier::Fourier, &legendre::Legendre, &four_sided::FourSided];

/// The name that leaves the choice to the program.
pub const AUTO: &str = "auto";

/// The numbers of a problem, as far as the choice of a method goes by them.
#[derive(Debug, Clone, Copy)]
pub struct Numbers<'a> {
    /// A value for every symbol of the decomposition's graph.
    pub params: &'a [f64],
    /// Ranges of u, v and t.
    pub domain: &'a DomainValues,
}

/// A chosen method.
#[derive(Clone)]
pub struct Choice {
    /// The method.
    pub method: &'static dyn Method,
    /// Whether `auto` chose it.
    pub is_automatic: bool,
    /// Why `auto` passed over those it tried before: one note each.
    pub notes: Diagnostics,
}

impl Choice {
    /// Compiles everything that does not depend on numbers. Where `auto` chose `exact`, `fourier` stands behind it.
    ///
    /// # Errors
    /// As [`Method::prepare`].
    pub fn prepare(&self, decomposition: &Decomposition, options: &Options) -> Result<Box<dyn Solver>, Diagnostic> {
        if self.is_automatic && self.method.name() == exact::Exact.name() {
            return exact_or_fourier::ExactOrFourier::prepare(decomposition, options);
        }
        self.method.prepare(decomposition, options)
    }
}

/// The method called `name`; `auto`, or no name, is the first in [`AUTOMATIC`] that accepts the problem.
///
/// # Errors
/// [`Code::UnknownSetting`] for a name that no method has, [`Code::UnsupportedByMethod`] with every reason when
/// none accepts the problem.
pub fn choose(
    name: Option<&str>,
    origin: Option<Span>,
    decomposition: &Decomposition,
    numbers: &Numbers<'_>,
    limits: &Limits,
) -> Result<Choice, Diagnostic> {
    let Some(name) = name.filter(|name| *name != AUTO) else {
        return choose_automatically(origin, decomposition, numbers, limits);
    };
    let Some(method) = METHODS.iter().copied().find(|method| method.name() == name) else {
        let known: Vec<&str> = std::iter::once(AUTO).chain(METHODS.iter().map(|method| method.name())).collect();
        let finding = Diagnostic::new(Code::UnknownSetting, format!("there is no method `{name}`"));
        return Err(finding.at(origin).hint(format!("methods: {}", known.join(", "))));
    };
    fits(method, decomposition)
        .and_then(|()| method.accepts(decomposition, limits))
        .map_err(|finding| if finding.span.is_none() { finding.at(origin) } else { finding })?;
    Ok(Choice { method, is_automatic: false, notes: Diagnostics::new() })
}

fn choose_automatically(
    origin: Option<Span>,
    decomposition: &Decomposition,
    numbers: &Numbers<'_>,
    limits: &Limits,
) -> Result<Choice, Diagnostic> {
    let mut reasons: Vec<(&str, Diagnostic)> = Vec::new();
    for method in on_its_sides(AUTOMATIC, decomposition) {
        match method.accepts(decomposition, limits).and_then(|()| method.suits(decomposition, numbers, limits)) {
            Ok(()) => {
                let notes = reasons.iter().map(|(name, reason)| passed_over(name, method.name(), reason));
                return Ok(Choice { method, is_automatic: true, notes: notes.collect() });
            }
            // A limit says nothing about the problem; it is the user's to raise.
            Err(reason) if reason.class() == Class::Limit => return Err(reason),
            Err(reason) => reasons.push((method.name(), reason)),
        }
    }
    let mut finding = Diagnostic::new(Code::UnsupportedByMethod, "no method can treat this problem");
    finding.span = reasons.iter().find_map(|(_, reason)| reason.span).or(origin);
    for (name, reason) in reasons {
        finding = finding.hint(format!("{name}: {}", reason.message));
    }
    Err(finding)
}

/// The note that `auto` passed over the method `name` for the method `by`.
fn passed_over(name: &str, by: &str, reason: &Diagnostic) -> Diagnostic {
    let message = format!("solved by `{by}`, not by `{name}`: {}", reason.message);
    Diagnostic::new(Code::MethodPassedOver, message).at(reason.span)
}

/// Those of `methods` that are for as many sides as the patch has.
fn on_its_sides(
    methods: &'static [&'static dyn Method],
    decomposition: &Decomposition,
) -> impl Iterator<Item = &'static dyn Method> {
    let is_four_sided = decomposition.patch.is_four_sided();
    methods.iter().copied().filter(move |method| method.is_four_sided() == is_four_sided)
}

/// Refuses a method that would leave sides of the patch unread, or look for sides that are not there.
fn fits(method: &dyn Method, decomposition: &Decomposition) -> Result<(), Diagnostic> {
    let patch = &decomposition.patch;
    if method.is_four_sided() == patch.is_four_sided() {
        return Ok(());
    }
    let name = method.name();
    let message = match method.is_four_sided() {
        true => format!("the method `{name}` needs constraints at both ends of v as well, and there are none"),
        false => format!("the method `{name}` has no place for constraints at fixed v"),
    };
    let others: Vec<&str> = on_its_sides(METHODS, decomposition).map(Method::name).collect();
    Err(Diagnostic::new(Code::UnsupportedByMethod, message).hint(format!("methods: {}", others.join(", "))))
}

/// The systems that a fitted method is about to solve.
struct Systems {
    /// How many.
    count: usize,
    /// Equations of each, after any reduction.
    rows: usize,
    /// Unknowns of each.
    unknowns: usize,
    /// Other numbers to be held at once.
    entries: usize,
    /// Collocation points.
    points: usize,
}

impl Systems {
    /// Refuses systems beyond the limits; the finding has no place.
    fn check(&self, limits: &Limits) -> Result<(), Diagnostic> {
        let matrix = self.rows.saturating_mul(self.unknowns);
        let sizes = [
            ("unknowns", limits.unknowns, self.unknowns.saturating_mul(self.count)),
            ("system-entries", limits.system_entries, matrix.max(self.entries)),
            ("operations", limits.operations, matrix.saturating_mul(self.unknowns).saturating_mul(self.count)),
            ("samples", limits.samples, self.points),
        ];
        match sizes.into_iter().find(|(_, limit, size)| size > limit) {
            None => Ok(()),
            Some((name, limit, size)) => {
                let message = format!("terms and points need {size}, above the limit `{name}` of {limit}");
                Err(Diagnostic::new(Code::LimitReached, message)
                    .hint("fewer terms are usually enough, or raise the limit"))
            }
        }
    }
}
