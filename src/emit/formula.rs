//! A surface as numbers and straight-line code, ready to be written down in any language.

use std::fmt::Write;

use crate::diagnostic::Diagnostic;
use crate::eval::{Op, Program};
use crate::expr::{Derivative, Graph, Number};
use crate::numeric::ChebyshevSeries;
use crate::problem::{Bindings, DomainValues, PatchCopy, Problem};
use crate::surface::{BsplineSurface, SeparableSurface};

use super::amplitudes::{amplitudes, basis_sizes, deviation, no_series};

/// A surface, ready to be written down in any language.
#[derive(Debug, Clone)]
pub struct Formula {
    /// What the emitted names begin with: an ASCII identifier.
    pub name: String,
    /// Ranges of u, v and t.
    pub domain: DomainValues,
    /// The only instant at which the formula holds, if it does not hold at all.
    pub instant: Option<f64>,
    /// Name as an identifier and value of every parameter, by symbol; those of definitions have no value.
    pub parameters: Vec<(String, f64)>,
    /// What is evaluated.
    pub form: Form,
    /// Where that is put, if it is not where it is to be.
    pub placement: Option<Placement>,
}

/// What an emitted function evaluates.
#[derive(Debug, Clone)]
pub enum Form {
    /// A sum of products.
    Sum(Sum),
    /// A B-spline, and how far it may be from the solved surface if it only stands for that.
    Net(BsplineSurface, Option<f64>),
}

/// `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` with the F_j as a program and the G_j as Chebyshev series.
#[derive(Debug, Clone)]
pub struct Sum {
    /// The F_j as text.
    pub functions: Vec<String>,
    /// F_1 … F_n, then ∂F_1/∂v … ∂F_n/∂v.
    pub program: Program,
    /// The x, y and z of G_1 … G_n, and of their derivatives in u.
    pub amplitudes: [ChebyshevSeries; 2],
    /// The largest distance of the formula from the surface on a grid, over the largest coordinate there.
    pub deviation: f64,
}

/// Where a copy is: `p -> A(t) p + b(t)`.
#[derive(Debug, Clone)]
pub struct Placement {
    /// What it is a copy of.
    pub original: String,
    /// The rows of A, then b.
    pub program: Program,
    /// Whether it is a mirror image, whose outside is where `S_v x S_u` points to.
    pub is_reflection: bool,
}

/// What the series may differ from the surface, relative to its size.
const LARGEST_DEVIATION: f64 = 1e-12;

impl Formula {
    /// The formula of a sum of products over `domain`; `name` need not be an identifier.
    ///
    /// # Errors
    /// [`NotDifferentiable`](crate::diagnostic::Code::NotDifferentiable) for a basis without derivative in v,
    /// [`SolutionNotFinite`](crate::diagnostic::Code::SolutionNotFinite) when the surface is not smooth enough in u to be
    /// written as a series, and what the surface reports.
    pub fn new(
        name: &str,
        problem: &Problem,
        surface: &SeparableSurface,
        domain: DomainValues,
    ) -> Result<Formula, Diagnostic> {
        let names = identifiers(problem.graph.symbols());
        let formula = |form| Formula {
            name: identifier(name),
            domain,
            instant: surface.instant,
            parameters: names.into_iter().zip(surface.params.iter().copied()).collect(),
            form: Form::Sum(form),
            placement: None,
        };
        // A surface that is zero has no functions, and languages have no tables without entries.
        if surface.basis.is_empty() {
            return Ok(formula(Sum::zero(domain)));
        }
        let program = surface.basis.program(&[Derivative::NONE, Derivative::new(0, 1, 0)])?;
        let sizes = basis_sizes(surface, domain)?;
        let amplitudes = [amplitudes(surface, domain.u, 0, &sizes)?, amplitudes(surface, domain.u, 1, &sizes)?];
        let deviation = deviation(&amplitudes, surface, domain)?;
        // Written so that NaN is refused.
        if deviation <= LARGEST_DEVIATION {
            let functions = surface.basis.names().to_vec();
            return Ok(formula(Sum { functions, program, amplitudes, deviation }));
        }
        Err(no_series())
    }

    /// The formula of a B-spline that holds at `instant` only, or at every t; `deviation` is how far it may be from a
    /// surface that it stands for.
    #[must_use]
    pub fn of_net(
        name: &str,
        surface: BsplineSurface,
        domain: DomainValues,
        instant: Option<f64>,
        deviation: Option<f64>,
    ) -> Formula {
        let form = Form::Net(surface, deviation);
        Formula { name: identifier(name), domain, instant, parameters: Vec::new(), form, placement: None }
    }

    /// The formula of `copy`, a part of `problem`, from that of its original; `is_reflection` says whether its matrix
    /// is one.
    #[must_use]
    pub fn copied(self, problem: &Problem, bindings: &Bindings, copy: &PatchCopy, is_reflection: bool) -> Formula {
        let program = Program::compile(&problem.graph, &copy.placement.entries());
        let names = identifiers(problem.graph.symbols());
        Formula {
            name: identifier(&copy.name),
            parameters: names.into_iter().zip(bindings.as_slice().iter().copied()).collect(),
            placement: Some(Placement { original: self.name, program, is_reflection }),
            ..self
        }
    }

    /// What the function is called that evaluates the form: the surface itself, unless it is placed.
    pub(super) fn base(&self) -> String {
        format!("{}_{}", self.name, if self.placement.is_some() { "original" } else { "surface" })
    }

    /// Every number that stands in the emitted text.
    pub(super) fn numbers(&self) -> Vec<f64> {
        let mut numbers: Vec<f64> = self.used_parameters().map(|(_, _, value)| value).collect();
        for program in self.programs() {
            numbers.extend(program.ops().iter().filter_map(|op| match op {
                Op::Constant(value) => Some(*value),
                _ => None,
            }));
            numbers.extend(program.splines().iter().flat_map(|call| call.spline.coefficients()));
        }
        match &self.form {
            Form::Sum(sum) => {
                numbers.extend(sum.amplitudes.iter().flat_map(|series| &series.coefficients).flatten());
            }
            Form::Net(surface, _) => numbers.extend(surface.net().iter().flatten()),
        }
        numbers
    }

    fn programs(&self) -> impl Iterator<Item = &Program> {
        let basis = match &self.form {
            Form::Sum(sum) => Some(&sum.program),
            Form::Net(..) => None,
        };
        basis.into_iter().chain(self.placement.as_ref().map(|placement| &placement.program))
    }

    /// Symbol, identifier and value of the parameters that programs read.
    pub(super) fn used_parameters(&self) -> impl Iterator<Item = (usize, &str, f64)> {
        let is_used = |index: usize| self.programs().any(|program| program.ops().contains(&Op::Parameter(index)));
        let all = self.parameters.iter().enumerate();
        all.filter(move |(index, _)| is_used(*index)).map(|(index, (name, value))| (index, name.as_str(), *value))
    }

    /// What a reader of the emitted text should know, as lines of ASCII.
    pub(super) fn header(&self) -> Vec<String> {
        let range = |[low, high]: [f64; 2]| format!("[{low:?}, {high:?}]");
        let (u, v, t) = (range(self.domain.u), range(self.domain.v), range(self.domain.t));
        let mut lines = vec![
            format!("The blend surface {}, written by trimline {}.", self.name, env!("CARGO_PKG_VERSION")),
            String::new(),
        ];
        lines.push(match &self.form {
            Form::Sum(_) => "S(u, v, t) = sum over j of F_j(v, t) G_j(u), with its derivatives S_u and S_v,".to_owned(),
            Form::Net(..) => {
                "S(u, v) = sum over i and j of N_i(u) M_j(v) P_ij, with its derivatives S_u and S_v,".to_owned()
            }
        });
        match self.instant {
            None => lines.push(format!("for u in {u}, v in {v}, t in {t}. Nothing checks the ranges.")),
            Some(t) => {
                lines.push(format!("for u in {u}, v in {v}. Nothing checks the ranges."));
                lines.push(format!("It holds at t = {t:?} only: the coefficients were worked out at that instant."));
            }
        }
        if let Some(Placement { original, is_reflection, .. }) = &self.placement {
            lines.push(format!("This is a copy of {original}: S above, turned and moved."));
            if *is_reflection {
                lines.push(
                    "A mirror image: its outside is where the cross product of S_v and S_u points to.".to_owned(),
                );
            }
        }
        lines.push(String::new());
        match &self.form {
            Form::Sum(sum) => lines.extend(sum.header()),
            Form::Net(surface, deviation) => {
                let [(u, rows), (v, columns)] = surface.knots().map(|knots| (knots.degree(), knots.points()));
                lines.push(format!(
                    "N_i and M_j are B-splines of degree {u} and {v}; the net has {rows} x {columns} control points."
                ));
                if let Some(deviation) = deviation {
                    lines.push(format!(
                        "It stands for the solved surface, from which it is at most {deviation:.1e} away."
                    ));
                }
            }
        }
        let stated = self.parameters.iter().filter(|(_, value)| !value.is_nan());
        let stated: Vec<String> = stated.map(|(name, value)| format!("{name} = {value:?}")).collect();
        if !stated.is_empty() {
            lines.push(format!("Values of the parameters: {}", stated.join(", ")));
            lines.push(
                "The coefficients belong to these values: to change one, solve and write the surface again.".to_owned(),
            );
        }
        lines
    }
}

impl Sum {
    /// The surface that is zero, as `0 · 0`.
    fn zero(domain: DomainValues) -> Sum {
        let mut graph = Graph::default();
        let zero = graph.number(Number::ZERO);
        let series = ChebyshevSeries { range: domain.u, coefficients: vec![vec![0.0; 3]] };
        Sum {
            functions: vec!["0".to_owned()],
            program: Program::compile(&graph, &[zero, zero]),
            amplitudes: [series.clone(), series],
            deviation: 0.0,
        }
    }

    /// The number of basis functions.
    #[must_use]
    pub fn count(&self) -> usize {
        self.functions.len()
    }

    /// Both series, with the end of the table's name and what it is.
    pub(super) fn tables(&self) -> [(&ChebyshevSeries, &'static str, &'static str); 2] {
        let [values, slopes] = &self.amplitudes;
        [(values, "g", "The coefficients of the G_j"), (slopes, "g_u", "The coefficients of their derivatives in u")]
    }

    fn header(&self) -> Vec<String> {
        let functions = self.functions.iter().enumerate().map(|(j, text)| format!("F_{} = {text}", j + 1));
        let (degree, slopes) = (self.amplitudes[0].coefficients.len(), self.amplitudes[1].coefficients.len());
        let series = format!(
            "G_j and its derivative: {degree} and {slopes} terms of a Chebyshev series, summed by Clenshaw's recurrence;"
        );
        let accuracy = format!("within {:.0e} of the solved surface, relative to its size.", self.deviation.max(1e-16));
        functions.chain([String::new(), series, accuracy]).collect()
    }
}

/// `name` as an identifier in every language: ASCII letters, digits and single underscores, a letter first.
fn identifier(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        match c {
            _ if c.is_ascii_alphanumeric() => text.push(c),
            '\'' => text.push_str("_prime"),
            _ if c.is_ascii() => text.push('_'),
            _ => {
                let _ = write!(text, "_u{:x}_", u32::from(c));
            }
        }
    }
    let words: Vec<&str> = text.split('_').filter(|word| !word.is_empty()).collect();
    let text = words.join("_");
    match text.chars().next() {
        Some(first) if first.is_ascii_alphabetic() && !text.starts_with("gl_") => text,
        _ => format!("patch_{text}").trim_end_matches('_').to_owned(),
    }
}

/// An identifier for each name, no two equal.
fn identifiers<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for name in names {
        let plain = identifier(name);
        let numbered = (2..).map(|number| format!("{plain}_{number}"));
        let free = std::iter::once(plain.clone()).chain(numbered).find(|candidate| !found.contains(candidate));
        found.push(free.unwrap_or(plain));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_identifiers_of_every_language() {
        for (name, expected) in [
            ("eq29_30", "eq29_30"),
            ("29 blends", "patch_29_blends"),
            ("left--wing_", "left_wing"),
            ("h0'", "h0_prime"),
            ("\u{e9}t\u{e9}", "ue9_t_ue9"),
            ("gl_x", "patch_gl_x"),
            ("", "patch"),
        ] {
            assert_eq!(identifier(name), expected, "{name}");
        }
    }

    #[test]
    fn names_that_differ_stay_different() {
        assert_eq!(identifiers(["a'", "a_prime", "b"].into_iter()), ["a_prime", "a_prime_2", "b"]);
    }
}
