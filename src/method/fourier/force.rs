//! A force along v without a finite closure, as trigonometric series (docs/methods.md, F6).
//!
//! Of a force `Σ_j a_j(u) f_j(v, t)` the f_j without a finite closure are expanded as boundary data are, each by itself and to
//! a share of its own size, so that the a_j do not matter. The truncated force has a finite closure.

use super::ends::Ends;
use super::series::{Length, Series, SeriesData, constant};
use crate::decompose::{Decomposition, split_force};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Function, Graph, Notation};
use crate::limits::Limits;

/// The force of an equation, with what is to be expanded of it compiled.
pub struct Force {
    graph: Graph,
    closed: [ExprId; 3],
    open: Vec<OpenFunction>,
}

/// An f_j without a finite closure, and x, y and z of its a_j.
struct OpenFunction {
    data: SeriesData,
    amplitudes: [ExprId; 3],
}

impl Force {
    /// Compiles the force of `decomposition`.
    ///
    /// # Errors
    /// [`Code::UnsupportedByMethod`] for a function that cannot be separated from u; [`Code::LimitReached`].
    pub fn compile(decomposition: &Decomposition, limits: &Limits) -> Result<Force, Diagnostic> {
        let split = split_force(decomposition, limits)?;
        let origin = decomposition.operator.origin;
        let mut open = Vec::with_capacity(split.open.len());
        for (function, amplitudes) in split.open {
            let text =
                split.graph.text(function, Notation::Ascii, 80).unwrap_or_else(|_| "a long expression".to_owned());
            if split.graph.dependence(function).u {
                let message = format!("`{text}` in the force is no sum of products of functions of u and of v");
                return Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(origin));
            }
            open.push(OpenFunction { data: SeriesData::of_force(&split.graph, function, &text, origin), amplitudes });
        }
        Ok(Force { graph: split.graph, closed: split.closed, open })
    }

    /// Whether anything is to be expanded.
    pub fn is_open(&self) -> bool {
        !self.open.is_empty()
    }

    /// Whether anything that is to be expanded depends on t.
    pub fn varies_in_time(&self) -> bool {
        self.open.iter().any(|function| function.data.varies_in_time)
    }

    /// The series of everything that is to be expanded, at instant `t`. Where the `boundary` closes in v the surface must, so
    /// that a force that does not close jumps there.
    ///
    /// # Errors
    /// As [`SeriesData::series`].
    pub fn series(
        &self,
        boundary: &SeriesData,
        length: Length,
        range: [f64; 2],
        t: f64,
        params: &[f64],
    ) -> Result<Vec<Series>, Diagnostic> {
        let closes = self.is_open() && boundary.check_periodic(range, t, params).is_ok();
        let series = |function: &OpenFunction| match closes {
            true => function.data.periodic_series(length, range, t, params),
            false => function.data.series(length, range, t, params),
        };
        self.open.iter().map(series).collect()
    }

    /// `decomposition`, for which this was compiled, with the force whose series are `series`.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] for a coefficient that left the doubles.
    pub fn truncated(&self, decomposition: &Decomposition, series: &[Series]) -> Result<Decomposition, Diagnostic> {
        if !self.is_open() {
            return Ok(decomposition.clone());
        }
        let mut graph = self.graph.clone();
        let mut terms: [Vec<ExprId>; 3] = self.closed.map(|closed| vec![closed]);
        for (function, series) in self.open.iter().zip(series) {
            let sum = sum(&mut graph, series).map_err(|finding| finding.at(decomposition.operator.origin))?;
            for (terms, amplitude) in terms.iter_mut().zip(function.amplitudes) {
                terms.push(graph.product([amplitude, sum]));
            }
        }
        let mut truncated = decomposition.clone();
        truncated.operator.force = terms.map(|terms| graph.sum(terms));
        Ok(Decomposition { graph, ..truncated })
    }

    /// `decomposition` without boundary data, and with no force but one polynomial for each function that is expanded.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] for polynomials that overflow.
    pub fn of_polynomials(
        &self,
        decomposition: &Decomposition,
        ends: &[Option<Ends>],
    ) -> Result<Decomposition, Diagnostic> {
        let mut graph = self.graph.clone();
        let mut terms: [Vec<ExprId>; 3] = Default::default();
        for (function, ends) in self.open.iter().zip(ends) {
            let Some(ends) = ends else { continue };
            let sum = polynomial(&mut graph, ends, "the force")?;
            for (terms, amplitude) in terms.iter_mut().zip(function.amplitudes) {
                terms.push(graph.product([amplitude, sum]));
            }
        }
        let mut alone = decomposition.clone();
        alone.operator.force = terms.map(|terms| graph.sum(terms));
        let zero = [graph.integer(0); 3];
        alone.coefficients.iter_mut().flatten().for_each(|coefficient| *coefficient = zero);
        Ok(Decomposition { graph, ..alone })
    }
}

/// The first function of `ends`, which carry what does not close of `subject`, as an expression.
fn polynomial(graph: &mut Graph, ends: &Ends, subject: &str) -> Result<ExprId, Diagnostic> {
    let mut terms = Vec::new();
    for power in 0..ends.powers() {
        let (factor, power) = (constant(graph, ends.coefficient(0, power), subject)?, ends.power(graph, power));
        terms.push(graph.product([factor, power]));
    }
    Ok(graph.sum(terms))
}

/// The first function of `series` as an expression: its polynomial and its waves.
fn sum(graph: &mut Graph, series: &Series) -> Result<ExprId, Diagnostic> {
    let mut terms = Vec::new();
    let number = |graph: &mut Graph, value: f64| constant(graph, value, &series.subject);
    if let Some(ends) = &series.ends {
        terms.push(polynomial(graph, ends, &series.subject)?);
    }
    let pairs = series.coefficients.first().map_or(&[][..], Vec::as_slice);
    for (n, [even, odd]) in pairs.iter().enumerate() {
        let angle = super::modal::wave(graph, n as f64 * series.wave_number);
        for (function, value) in [(Function::Cos, *even), (Function::Sin, *odd)] {
            let (factor, wave) = (number(graph, value)?, graph.call(function, &[angle]));
            terms.push(graph.product([factor, wave]));
        }
    }
    Ok(graph.sum(terms))
}
