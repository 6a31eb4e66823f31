//! A solution as numbers and straight-line code, ready to be written down in any language.

use std::fmt::Write;

use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Op, Program};
use crate::expr::{Derivative, Graph, Number};
use crate::numeric::ChebyshevSeries;
use crate::problem::{DomainValues, Problem};
use crate::surface::{SeparableSurface, Surface};

/// `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` with the F_j as a program and the G_j as Chebyshev series.
#[derive(Debug, Clone)]
pub struct Formula {
    /// What the emitted names begin with: an ASCII identifier.
    pub name: String,
    /// Ranges of u, v and t.
    pub domain: DomainValues,
    /// The only instant at which the formula holds, if it does not hold at all.
    pub instant: Option<f64>,
    /// The F_j as text.
    pub functions: Vec<String>,
    /// Name as an identifier and value of every parameter, by symbol; those of definitions have no value.
    pub parameters: Vec<(String, f64)>,
    /// F_1 … F_n, then ∂F_1/∂v … ∂F_n/∂v.
    pub program: Program,
    /// The x, y and z of G_1 … G_n, and of their derivatives in u.
    pub amplitudes: [ChebyshevSeries; 2],
    /// The largest distance of the formula from the surface on a grid, over the largest coordinate there.
    pub deviation: f64,
}

/// What is cut off the series, relative to the surface: first as much as rounding hides anyway, then what solutions
/// with large coefficients that cancel leave.
const TOLERANCES: [f64; 2] = [8e-15, 1e-13];

/// What the series may differ from the surface, relative to its size.
const LARGEST_DEVIATION: f64 = 1e-12;

/// Where the formula is compared with the surface: counts without common factors with the series' nodes.
const GRID: [usize; 2] = [37, 29];

impl Formula {
    /// Works out the formula of a surface over `domain`; `name` need not be an identifier.
    ///
    /// # Errors
    /// [`Code::NotDifferentiable`] for a basis without derivative in v, [`Code::SolutionNotFinite`] when the surface
    /// is not smooth enough in u to be written as a series, and what the surface reports.
    pub fn new(
        name: &str,
        problem: &Problem,
        surface: &SeparableSurface,
        domain: DomainValues,
    ) -> Result<Formula, Diagnostic> {
        // A surface that is zero has no functions, and languages have no tables without entries.
        if surface.basis.is_empty() {
            return Ok(Formula::zero(name, surface.instant, domain));
        }
        let program = surface.basis.program(&[Derivative::NONE, Derivative::new(0, 1, 0)])?;
        if let Some(call) = program.splines().first() {
            let message =
                format!("`{}` comes from a data file, and has no formula to be written out", call.spline.name());
            return Err(Diagnostic::new(Code::NoFormula, message).hint(
                "`--method fourier --remainder off` writes it as a Fourier series; `mesh` and `fit` write the surface",
            ));
        }
        let sizes = basis_sizes(surface, domain)?;
        let amplitudes = [amplitudes(surface, domain.u, 0, &sizes)?, amplitudes(surface, domain.u, 1, &sizes)?];
        let names = identifiers(problem.graph.symbols());
        let mut formula = Formula {
            name: identifier(name),
            domain,
            instant: surface.instant,
            functions: surface.basis.names().to_vec(),
            parameters: names.into_iter().zip(surface.params.iter().copied()).collect(),
            program,
            amplitudes,
            deviation: 0.0,
        };
        formula.deviation = deviation(&formula.amplitudes, surface, domain)?;
        // Written so that NaN is refused.
        if formula.deviation <= LARGEST_DEVIATION {
            return Ok(formula);
        }
        Err(no_series())
    }

    /// The surface that is zero, as `0 · 0`.
    fn zero(name: &str, instant: Option<f64>, domain: DomainValues) -> Formula {
        let mut graph = Graph::default();
        let zero = graph.number(Number::ZERO);
        let series = ChebyshevSeries { range: domain.u, coefficients: vec![vec![0.0; 3]] };
        Formula {
            name: identifier(name),
            domain,
            instant,
            functions: vec!["0".to_owned()],
            parameters: Vec::new(),
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

    /// Every number that stands in the emitted text.
    pub(super) fn numbers(&self) -> impl Iterator<Item = f64> {
        let constants = self.program.ops().iter().filter_map(|op| match op {
            Op::Constant(value) => Some(*value),
            _ => None,
        });
        let tables = self.amplitudes.iter().flat_map(|series| &series.coefficients).flatten().copied();
        constants.chain(tables).chain(self.used_parameters().map(|(_, _, value)| value))
    }

    /// Symbol, identifier and value of the parameters that the basis reads.
    pub(super) fn used_parameters(&self) -> impl Iterator<Item = (usize, &str, f64)> {
        let is_used = |index: usize| self.program.ops().contains(&Op::Parameter(index));
        let all = self.parameters.iter().enumerate();
        all.filter(move |(index, _)| is_used(*index)).map(|(index, (name, value))| (index, name.as_str(), *value))
    }

    /// Both series, with the end of the table's name and what it is.
    pub(super) fn tables(&self) -> [(&ChebyshevSeries, &'static str, &'static str); 2] {
        let [values, slopes] = &self.amplitudes;
        [(values, "g", "The coefficients of the G_j"), (slopes, "g_u", "The coefficients of their derivatives in u")]
    }

    /// What a reader of the emitted text should know, as lines of ASCII.
    pub(super) fn header(&self) -> Vec<String> {
        let range = |[low, high]: [f64; 2]| format!("[{low:?}, {high:?}]");
        let (u, v, t) = (range(self.domain.u), range(self.domain.v), range(self.domain.t));
        let mut lines = vec![
            format!("The blend surface {}, written by trimline {}.", self.name, env!("CARGO_PKG_VERSION")),
            String::new(),
            "S(u, v, t) = sum over j of F_j(v, t) G_j(u), with its derivatives S_u and S_v,".to_owned(),
            match self.instant {
                None => format!("for u in {u}, v in {v}, t in {t}. Nothing checks the ranges."),
                Some(t) => format!(
                    "for u in {u}, v in {v}. Nothing checks the ranges.\nIt holds at t = {t:?} only: the coefficients were fitted at that instant."
                ),
            },
            String::new(),
        ];
        lines.extend(self.functions.iter().enumerate().map(|(j, text)| format!("F_{} = {text}", j + 1)));
        let (degree, slopes) = (self.amplitudes[0].coefficients.len(), self.amplitudes[1].coefficients.len());
        lines.push(String::new());
        lines.push(format!(
            "G_j and its derivative: {degree} and {slopes} terms of a Chebyshev series, summed by Clenshaw's recurrence;"
        ));
        lines.push(format!("within {:.0e} of the solved surface, relative to its size.", self.deviation.max(1e-16)));
        let stated = self.parameters.iter().filter(|(_, value)| !value.is_nan());
        let stated: Vec<String> = stated.map(|(name, value)| format!("{name} = {value:?}")).collect();
        if !stated.is_empty() {
            lines.push(format!("Values of the parameters: {}", stated.join(", ")));
            lines.push(
                "The coefficients belong to these values: to change one, solve and write the surface again.".to_owned(),
            );
        }
        lines.iter().flat_map(|line| line.split('\n')).map(str::to_owned).collect()
    }
}

fn no_series() -> Diagnostic {
    Diagnostic::new(Code::SolutionNotFinite, "the surface varies too fast in u to be written as a formula")
        .hint("use fewer terms, or write a mesh")
}

/// The G_j of `S(u, v, t) = Σ_j F_j(v, t) G_j(u)` as series: the x, y and z of each function, by degree.
///
/// # Errors
/// [`Code::SolutionNotFinite`] when the surface is not smooth enough in u, and what the basis reports.
pub fn amplitude_series(surface: &SeparableSurface, domain: DomainValues) -> Result<ChebyshevSeries, Diagnostic> {
    amplitudes(surface, domain.u, 0, &basis_sizes(surface, domain)?)
}

/// How far each basis function reaches on the domain: what an error in its G_j is multiplied with.
fn basis_sizes(surface: &SeparableSurface, domain: DomainValues) -> Result<Vec<f64>, Diagnostic> {
    let instants = match surface.instant {
        Some(t) => vec![t],
        None => evenly(domain.t, 5),
    };
    let v = evenly(domain.v, 65);
    let mut sizes = vec![0.0_f64; surface.basis.len()];
    for t in instants {
        let values = surface.basis.values(Derivative::NONE, &surface.params, &v, &vec![t; v.len()])?;
        for (size, row) in sizes.iter_mut().zip(values.chunks(v.len())) {
            *size = row.iter().fold(*size, |most, value| most.max(value.abs()));
        }
    }
    Ok(sizes.into_iter().map(|size| if size > 0.0 { size } else { 1.0 }).collect())
}

fn evenly([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| low * (1.0 - i as f64 / last) + high * (i as f64 / last)).collect()
}

/// The series of the derivative of order `order` of every G_j.
fn amplitudes(
    surface: &SeparableSurface,
    range: [f64; 2],
    order: usize,
    sizes: &[f64],
) -> Result<ChebyshevSeries, Diagnostic> {
    // In units of the surface, so that all are cut at the same error.
    let weights: Vec<f64> = sizes.iter().flat_map(|size| [*size; 3]).collect();
    for tolerance in TOLERANCES {
        let series = ChebyshevSeries::fit(range, weights.len(), tolerance, |u| {
            let values = surface.amplitudes(order, u);
            values.iter().flatten().zip(&weights).map(|(value, weight)| value * weight).collect()
        });
        if let Some(mut series) = series {
            let unscale = |row: &mut Vec<f64>| row.iter_mut().zip(&weights).for_each(|(c, weight)| *c /= weight);
            series.coefficients.iter_mut().for_each(unscale);
            return Ok(series);
        }
    }
    Err(no_series())
}

/// The largest difference between series and surface, in position and in S_u, over the largest value of each.
fn deviation(
    series: &[ChebyshevSeries; 2],
    surface: &SeparableSurface,
    domain: DomainValues,
) -> Result<f64, Diagnostic> {
    let (u, v) = (evenly(domain.u, GRID[0]), evenly(domain.v, GRID[1]));
    let t = surface.instant.unwrap_or(domain.t[0]);
    let basis = surface.basis.values(Derivative::NONE, &surface.params, &v, &vec![t; v.len()])?;
    let mut worst = 0.0_f64;
    for (order, series) in series.iter().enumerate() {
        let mut expected = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(Derivative::new(order, 0, 0), (&u, &v, t), &mut expected)?;
        let size = expected.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
        let mut difference = 0.0_f64;
        for (u, row) in u.iter().zip(expected.chunks(v.len())) {
            let amplitudes = series.values(*u);
            for (column, expected) in row.iter().enumerate() {
                for (component, expected) in expected.iter().enumerate() {
                    let of_component = amplitudes.iter().skip(component).step_by(3);
                    let found: f64 =
                        of_component.zip(basis.iter().skip(column).step_by(v.len())).map(|(g, f)| g * f).sum();
                    let distance = (found - expected).abs();
                    difference = if distance <= difference { difference } else { distance };
                }
            }
        }
        if size > 0.0 {
            worst = if difference / size <= worst { worst } else { difference / size };
        }
    }
    Ok(worst)
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
