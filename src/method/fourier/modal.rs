//! The surface of a truncated series: functions of u for each wave number, and the remainder.

use std::sync::Arc;

use super::ends::Ends;
use super::series::{Series, constant, vector};
use crate::decompose::{BasisFunction, Decomposition, close};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Function, Graph, Number, Variable};
use crate::method::exact::Exact;
use crate::method::{Method, Options, Report};
use crate::surface::{Basis, SeparableSurface};
use crate::trial::{CardinalExponentials, JoinedModes, Modes};

/// The numbers of a problem.
pub struct Numerals {
    /// The range of u.
    pub range: [f64; 2],
    /// Position and order of each condition.
    pub functionals: Vec<(f64, usize)>,
    /// Coefficients of the boundary data by condition, basis function and component.
    pub stated: Vec<f64>,
    /// Derivatives that the equation takes, and their coefficients by component.
    pub terms: Vec<(Derivative, [f64; 3])>,
}

impl Numerals {
    fn order(&self) -> usize {
        self.functionals.len()
    }

    fn coefficient(&self, derivative: Derivative, component: usize) -> f64 {
        let found = self.terms.iter().find(|(orders, _)| *orders == derivative);
        found.and_then(|(_, each)| each.get(component).copied()).unwrap_or(0.0)
    }

    /// The a of each component, if the equation is `(∂²/∂u² + a² ∂²/∂v²)^m S = 0` up to a factor.
    pub fn rates(&self) -> Option<[f64; 3]> {
        let order = self.order();
        if !order.is_multiple_of(2) || order == 0 {
            return None;
        }
        let multiplicity = order / 2;
        let mut rates = [0.0; 3];
        for (component, rate) in rates.iter_mut().enumerate() {
            let leading = self.coefficient(Derivative::new(order, 0, 0), component);
            let next = self.coefficient(Derivative::new(order - 2, 2, 0), component);
            let square = next / (leading * multiplicity as f64);
            let mut expected = leading;
            for k in 1..=multiplicity {
                expected *= square * (multiplicity + 1 - k) as f64 / k as f64;
                let found = self.coefficient(Derivative::new(order - 2 * k, 2 * k, 0), component);
                // Coefficients such as a⁴ that were computed by users in doubles.
                if (found - expected).abs() > 1e-14 * expected.abs() {
                    return None;
                }
            }
            if !(square.is_finite() && square > 0.0) {
                return None;
            }
            *rate = square.sqrt();
        }
        let is_one_of_them = |(orders, _): &(Derivative, [f64; 3])| {
            orders.t == 0 && orders.v.is_multiple_of(2) && orders.u + orders.v == order
        };
        self.terms.iter().all(is_one_of_them).then_some(rates)
    }

    /// A rate for the remainder of any other equation: the geometric mean of those of its solutions, `|c_v/c_u|^(1/n)`
    /// of the coefficients of the highest derivatives in v and u alone; 1 without one of them.
    pub fn decay(&self) -> [f64; 3] {
        let order = self.order();
        [0, 1, 2].map(|component| {
            let along = self.coefficient(Derivative::new(0, order, 0), component);
            let across = self.coefficient(Derivative::new(order, 0, 0), component);
            let rate = libm::pow((along / across).abs(), 1.0 / order as f64);
            if rate.is_finite() && rate > 0.0 { rate } else { 1.0 }
        })
    }

    fn functions(&self, rate: f64, wave: f64) -> Result<Arc<dyn Modes>, Diagnostic> {
        let order = self.order();
        // An odd number of conditions has no exponentials of this kind; the remainder of an odd order is a polynomial.
        let found = if order.is_multiple_of(2) {
            CardinalExponentials::new(rate * wave, self.range, &self.functionals)
                .map(|modes| Arc::new(modes) as Arc<dyn Modes>)
        } else {
            let family = Arc::new(crate::trial::Powers::new(order));
            crate::trial::CorrectedTrial::new(family, 0, self.range, &self.functionals)
                .map(|modes| Arc::new(modes) as Arc<dyn Modes>)
        };
        found.ok_or_else(|| {
            if CardinalExponentials::new(0.0, self.range, &self.functionals).is_none() {
                let message = "with these parameters the constraints do not determine a surface";
                return Diagnostic::new(Code::DependentConstraints, message);
            }
            let message = format!("the functions of wave number {wave} exceed the doubles between these positions");
            Diagnostic::new(Code::SolutionNotFinite, message)
                .hint("take fewer modes, or state positions and tangents at the ends")
        })
    }
}

/// A separable surface under construction.
pub struct Assembly {
    graph: Graph,
    functions: Vec<(ExprId, Option<Span>)>,
    /// For each wave number the places of its cosine and its sine.
    waves: Vec<[usize; 2]>,
    /// The places of the powers of v less the middle of its range, if something is not periodic.
    powers: Vec<usize>,
    parts: Vec<Arc<dyn Modes>>,
    /// How many functions of u there are.
    count: usize,
    /// Function of u, basis function, vector.
    entries: Vec<(usize, usize, [f64; 3])>,
}

impl Assembly {
    /// The functions `1, cos κv, sin κv, cos 2κv, …` of `series`.
    pub fn new(decomposition: &Decomposition, series: &Series) -> Assembly {
        let mut graph = decomposition.graph.clone();
        let one = graph.integer(1);
        let mut functions = vec![(one, None)];
        let mut waves = vec![[0, 0]];
        for n in 1..=series.modes() {
            let argument = wave(&mut graph, n as f64 * series.wave_number);
            waves.push([functions.len(), functions.len() + 1]);
            functions.push((graph.call(Function::Cos, &[argument]), None));
            functions.push((graph.call(Function::Sin, &[argument]), None));
        }
        Assembly { graph, functions, waves, powers: Vec::new(), parts: Vec::new(), count: 0, entries: Vec::new() }
    }

    fn add_part(&mut self, part: Arc<dyn Modes>) -> usize {
        let first = self.count;
        self.count += part.count();
        self.parts.push(part);
        first
    }

    /// The exact functions of each wave number, for equations with the given rates.
    pub fn add_modes(&mut self, numerals: &Numerals, series: &Series, rates: &[f64; 3]) -> Result<(), Diagnostic> {
        for (rate, components) in distinct(rates) {
            for n in 0..=series.modes() {
                let pairs = pairs_of(series, n, &components);
                if pairs.iter().flatten().flatten().all(|value| *value == 0.0) {
                    continue;
                }
                let first = self.add_part(numerals.functions(rate, n as f64 * series.wave_number)?);
                self.place(first, n, &pairs);
            }
        }
        Ok(())
    }

    /// Enters the pairs of wave number `n`, condition after condition, from function of u number `first` on.
    fn place(&mut self, first: usize, n: usize, pairs: &[[[f64; 3]; 2]]) {
        let Some([cosine, sine]) = self.waves.get(n).copied() else { return };
        for (condition, [even, odd]) in pairs.iter().enumerate() {
            self.entries.push((first + condition, cosine, *even));
            if n > 0 {
                self.entries.push((first + condition, sine, *odd));
            }
        }
    }

    /// The exact solution for the truncated series, whatever the equation, force included; `options` are those of `exact`.
    pub fn add_exact(
        &mut self,
        decomposition: &Decomposition,
        series: &Series,
        options: &Options,
        (params, ranges, t): (&[f64], [[f64; 2]; 2], f64),
    ) -> Result<Report, Diagnostic> {
        let mut graph = self.graph.clone();
        let conditions = decomposition.patch.conditions.len();
        let mut coefficients = Vec::with_capacity(conditions);
        for condition in 0..conditions {
            let mut row = Vec::with_capacity(self.functions.len());
            for (n, places) in self.waves.iter().enumerate() {
                for (part, _) in places.iter().enumerate().take(if n == 0 { 1 } else { 2 }) {
                    row.push(vector(|component| {
                        let pairs = series.coefficients.get(3 * condition + component);
                        let value = pairs.and_then(|pairs| pairs.get(n)?.get(part).copied()).unwrap_or(0.0);
                        constant(&mut graph, value, &series.subject)
                    })?);
                }
            }
            coefficients.push(row);
        }
        let function = |(expr, origin): &(ExprId, Option<Span>)| BasisFunction {
            expr: *expr,
            origin: *origin,
            derivatives: Vec::new(),
            fault: None,
        };
        let truncated = Decomposition {
            graph,
            patch: decomposition.patch.clone(),
            operator: decomposition.operator.clone(),
            basis: self.functions.iter().map(function).collect(),
            coefficients,
        };
        let closure = close(&truncated, &options.limits)?;
        let solution = Exact.prepare(&truncated, options)?.solve(params, ranges, t)?;
        let surface = solution.separable()?;
        let count = surface.basis.len();
        let first = self.add_part(Arc::clone(&surface.modes));
        let all = surface.coefficients.first().map_or(&[][..], Vec::as_slice);
        for (mode, row) in all.chunks(count.max(1)).enumerate() {
            self.entries.extend(row.iter().enumerate().map(|(j, vector)| (first + mode, j, *vector)));
        }
        (self.graph, self.functions) = (closure.graph, closure.functions);
        Ok(solution.report)
    }

    /// The exact functions of `surface`, whose basis are the powers of v less the middle of its range.
    pub fn add_ends(&mut self, ends: &Ends, surface: &SeparableSurface) {
        self.add_powers(ends);
        let first = self.add_part(Arc::clone(&surface.modes));
        let all = surface.coefficients.first().map_or(&[][..], Vec::as_slice);
        for (mode, row) in all.chunks(surface.basis.len().max(1)).enumerate() {
            let row = row.iter().zip(&self.powers);
            self.entries.extend(row.map(|(vector, place)| (first + mode, *place, *vector)));
        }
    }

    fn add_powers(&mut self, ends: &Ends) {
        for power in 0..ends.powers() {
            self.powers.push(self.functions.len());
            self.functions.push((ends.power(&mut self.graph, power), None));
        }
    }

    /// `R = Σ_i K_i(u) d_i(v, t)`, with K_i the functions of the next wave number and d_i what the series leaves out.
    pub fn add_remainder(
        &mut self,
        numerals: &Numerals,
        series: &Series,
        rates: &[f64; 3],
        decomposition: &Decomposition,
    ) -> Result<(), Diagnostic> {
        let next = (series.modes() + 1) as f64 * series.wave_number;
        let count = decomposition.basis.len();
        let places: Vec<usize> = (self.functions.len()..).take(count).collect();
        self.functions.extend(decomposition.basis.iter().map(|function| (function.expr, function.origin)));
        for (rate, components) in distinct(rates) {
            let first = self.add_part(numerals.functions(rate, next)?);
            for condition in 0..numerals.functionals.len() {
                for (j, place) in places.iter().enumerate() {
                    let stated = |component: usize| {
                        let value = numerals.stated.get((condition * count + j) * 3 + component).copied();
                        if components.contains(&component) { value.unwrap_or(f64::NAN) } else { 0.0 }
                    };
                    self.entries.push((first + condition, *place, [0, 1, 2].map(stated)));
                }
            }
            for n in 0..=series.modes() {
                let subtracted: Vec<[[f64; 3]; 2]> = pairs_of(series, n, &components)
                    .into_iter()
                    .map(|pair| pair.map(|vector| vector.map(|value| -value)))
                    .collect();
                self.place(first, n, &subtracted);
            }
            for (condition, ends) in (0..numerals.functionals.len()).zip(std::iter::repeat(&series.ends)) {
                for (power, place) in self.powers.iter().enumerate() {
                    let subtracted = |component: usize| {
                        let value =
                            ends.as_ref().map_or(0.0, |ends| ends.coefficient(3 * condition + component, power));
                        if components.contains(&component) { -value } else { 0.0 }
                    };
                    self.entries.push((first + condition, *place, [0, 1, 2].map(subtracted)));
                }
            }
        }
        Ok(())
    }

    /// The surface.
    pub fn finish(
        self,
        params: &[f64],
        instant: Option<f64>,
        options: &Options,
    ) -> Result<SeparableSurface, Diagnostic> {
        let width = self.functions.len();
        let size = self.count.saturating_mul(width);
        if size > options.limits.system_entries {
            let limit = options.limits.system_entries;
            let message = format!("the series needs {size} coefficients, above the limit `system-entries` of {limit}");
            return Err(
                Diagnostic::new(Code::LimitReached, message).hint("fewer modes are usually enough, or raise the limit")
            );
        }
        let mut coefficients = vec![[0.0; 3]; size];
        for (mode, function, vector) in self.entries {
            if let Some(slot) = coefficients.get_mut(mode * width + function) {
                for (total, value) in slot.iter_mut().zip(vector) {
                    *total += value;
                }
            }
        }
        Ok(SeparableSurface {
            modes: Arc::new(JoinedModes::new(self.parts)),
            basis: Arc::new(Basis::new(&self.graph, &self.functions, options.backend, &options.limits)),
            params: params.to_vec(),
            coefficients: Arc::new(vec![coefficients]),
            instant,
        })
    }
}

/// The cosine and sine coefficients of wave number `n` for each condition, zero but for `components`.
fn pairs_of(series: &Series, n: usize, components: &[usize]) -> Vec<[[f64; 3]; 2]> {
    let conditions = series.coefficients.chunks(3);
    let value = |each: &[Vec<[f64; 2]>], component: usize, part: usize| -> f64 {
        let pair = each.get(component).and_then(|pairs| pairs.get(n));
        let value = pair.and_then(|pair| pair.get(part)).copied().unwrap_or(0.0);
        if components.contains(&component) { value } else { 0.0 }
    };
    conditions.map(|each| [0, 1].map(|part| [0, 1, 2].map(|component| value(each, component, part)))).collect()
}

/// The different rates, each with its components.
fn distinct(rates: &[f64; 3]) -> Vec<(f64, Vec<usize>)> {
    let mut found: Vec<(f64, Vec<usize>)> = Vec::new();
    for (component, rate) in rates.iter().enumerate() {
        match found.iter_mut().find(|(known, _)| known == rate) {
            Some((_, components)) => components.push(component),
            None => found.push((*rate, vec![component])),
        }
    }
    found
}

/// `k v`, with k a whole number where it is one up to rounding.
pub fn wave(graph: &mut Graph, k: f64) -> ExprId {
    let v = graph.variable(Variable::V);
    let whole = k.round();
    let k = if (k - whole).abs() <= 4.0 * f64::EPSILON * whole { whole } else { k };
    match Number::from_f64(k) {
        Some(factor) => graph.scale(factor, v),
        None => v,
    }
}
