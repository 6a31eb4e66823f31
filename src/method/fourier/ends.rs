//! Data that are not periodic over the range of v: a polynomial takes what does not close, and leaves the rest to a series.
//!
//! p has the values of the data at both ends, and those of their derivatives in v up to order 2 as far as they exist
//! (docs/methods.md, F5). So `g - p` closes with as many derivatives, and its coefficients fall like those of data that
//! are as smooth. Powers of v are closed under every derivative, so `exact` solves the equation for p.

use super::series::{constant, vector};
use crate::decompose::{BasisFunction, Decomposition};
use crate::diagnostic::Diagnostic;
use crate::expr::{ExprId, Graph, Number, Variable};
use crate::method::exact::Exact;
use crate::method::{Method, Options, Settings, Solution};
use crate::numeric::CardinalPolynomials;

/// The highest derivative that the polynomials have in common with the data. Cubic splines have no more.
pub const MOST_DERIVATIVES: usize = 2;

/// A polynomial for each condition and component.
#[derive(Debug, Clone)]
pub struct Ends {
    /// The middle of the range of v.
    middle: f64,
    half: f64,
    /// Coefficients of powers of `(v - middle) / half`, condition after condition; zeros for what is periodic.
    coefficients: Vec<Vec<f64>>,
}

impl Ends {
    /// Polynomials with the data `given`: for each order of the derivative and each value, what it is at the low and at
    /// the high end of `range`. Values that are not `is_open` have none.
    pub fn new([low, high]: [f64; 2], given: &[Vec<Vec<f64>>], is_open: &[bool]) -> Option<Ends> {
        let half = 0.5 * (high - low);
        let functionals: Vec<(f64, usize)> = (0..given.len()).flat_map(|order| [(-1.0, order), (1.0, order)]).collect();
        let cardinal = CardinalPolynomials::new(&functionals)?;
        let mut factorial = 1.0;
        let mut taylor = Vec::with_capacity(functionals.len());
        for power in 0..functionals.len() {
            factorial *= power.max(1) as f64;
            taylor
                .push(cardinal.derivatives(power, 0.0).into_iter().map(|each| each / factorial).collect::<Vec<f64>>());
        }
        let polynomial = |(index, is_open): (usize, &bool)| {
            let stated = |(order, values): (usize, &Vec<Vec<f64>>)| {
                let scale = half.powi(i32::try_from(order).unwrap_or(i32::MAX));
                values.get(index).into_iter().flatten().map(|value| scale * value).collect::<Vec<f64>>()
            };
            let stated: Vec<f64> = given.iter().enumerate().flat_map(stated).collect();
            let share = if *is_open { 1.0 } else { 0.0 };
            taylor.iter().map(|row| share * row.iter().zip(&stated).map(|(a, b)| a * b).sum::<f64>()).collect()
        };
        let coefficients = is_open.iter().enumerate().map(polynomial).collect();
        Some(Ends { middle: 0.5 * low + 0.5 * high, half, coefficients })
    }

    /// The polynomial of value number `index` at `v`.
    pub fn value(&self, index: usize, v: f64) -> f64 {
        let s = (v - self.middle) / self.half;
        self.coefficients.get(index).map_or(0.0, |powers| powers.iter().rev().fold(0.0, |sum, each| sum * s + each))
    }

    /// Constants of the given size in the place of the polynomials that are not zero.
    #[must_use]
    pub fn leveled(&self, size: f64) -> Ends {
        let level = |powers: &Vec<f64>| {
            let is_zero = powers.iter().all(|power| *power == 0.0);
            let first = if is_zero { 0.0 } else { size };
            std::iter::once(first).chain(powers.iter().skip(1).map(|_| 0.0)).collect()
        };
        Ends { coefficients: self.coefficients.iter().map(level).collect(), ..self.clone() }
    }

    /// How many powers there are.
    pub fn powers(&self) -> usize {
        self.coefficients.first().map_or(0, Vec::len)
    }

    /// A power of `v - middle`.
    pub fn power(&self, graph: &mut Graph, power: usize) -> ExprId {
        let v = graph.variable(Variable::V);
        let back = graph.number(Number::from_f64(-self.middle).unwrap_or(Number::integer(0)));
        let moved = graph.sum([v, back]);
        graph.power_integer(moved, i64::try_from(power).unwrap_or(i64::MAX))
    }

    /// The coefficient of a power of `v - middle`.
    pub fn coefficient(&self, index: usize, power: usize) -> f64 {
        let found = self.coefficients.get(index).and_then(|powers| powers.get(power)).copied().unwrap_or(0.0);
        found / self.half.powi(i32::try_from(power).unwrap_or(i32::MAX))
    }

    /// The exact solution for the polynomials, without any force, over a range of v whose middle is 0: its basis are the
    /// powers of v. Coefficients of the equation do not depend on v, so that it may be moved.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`](crate::diagnostic::Code::DataNotFinite) for a coefficient that left the doubles, and as the
    /// method `exact`.
    pub fn solve(
        &self,
        decomposition: &Decomposition,
        options: &Options,
        (params, range_u, t): (&[f64], [f64; 2], f64),
    ) -> Result<Solution, Diagnostic> {
        let mut graph = decomposition.graph.clone();
        let v = graph.variable(Variable::V);
        let mut basis = Vec::with_capacity(self.powers());
        for power in 0..self.powers() {
            let expr = graph.power_integer(v, i64::try_from(power).unwrap_or(i64::MAX));
            basis.push(BasisFunction { expr, origin: None, derivatives: Vec::new(), fault: None });
        }
        let mut coefficients = Vec::new();
        for condition in 0..decomposition.patch.conditions.len() {
            let mut row = Vec::with_capacity(self.powers());
            for power in 0..self.powers() {
                let number = |component| {
                    constant(&mut graph, self.coefficient(3 * condition + component, power), "the boundary data")
                };
                row.push(vector(number)?);
            }
            coefficients.push(row);
        }
        let mut operator = decomposition.operator.clone();
        operator.force = [graph.integer(0); 3];
        let patch = decomposition.patch.clone();
        let polynomial = Decomposition { graph, patch, operator, basis, coefficients };
        let options = Options { settings: Settings::default(), ..options.clone() };
        Exact.prepare(&polynomial, &options)?.solve(params, [range_u, [-self.half, self.half]], t)
    }
}
