//! Piecewise polynomials of one or two arguments, as plain data that an expression can call.
//!
//! Input: knots and control values of a B-spline; output: a [`Spline`], Taylor coefficients around the lower corner of
//! each piece, from which values and derivatives of any order come by Horner's rule. A derivative is the same data
//! with another order ([`SplineCall`]), so differentiating an expression copies nothing.
//!
//! Invariant: a value depends on the data and the arguments alone; every evaluator calls [`SplineCall::value`].
//! Absent on purpose: fitting, which is [`curves`](crate::curves)'s business, and derivatives where pieces meet less smoothly.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use rustc_hash::FxHasher;

/// How far arguments may lie outside the knots of a spline that is not periodic, of their range: what rounding does to
/// the end of a domain.
const SLACK: f64 = 1e-9;

/// The highest degree in one argument.
pub const HIGHEST_DEGREE: usize = 15;

/// The knots of one argument of a B-spline.
#[derive(Debug, Clone, PartialEq)]
pub struct Knots {
    /// The degree of the pieces.
    pub degree: usize,
    /// Ascending; `degree + 1` more than there are control values. The argument runs from knot `degree` to the one as
    /// far from the end.
    pub knots: Vec<f64>,
    /// Of a spline that repeats itself beyond that range: the highest derivative that agrees at the range's two ends.
    /// The value does; control values must see to it.
    pub seam: Option<usize>,
}

/// One argument of a [`Spline`].
#[derive(Debug, Clone, PartialEq)]
struct Axis {
    name: String,
    degree: usize,
    /// Where pieces begin, and the end of the last.
    breaks: Vec<f64>,
    is_periodic: bool,
    /// The highest continuous derivative; `None` for a polynomial, which has all.
    smoothness: Option<usize>,
}

/// A named piecewise polynomial of one or two arguments.
pub struct Spline {
    name: String,
    axes: [Axis; 2],
    arguments: usize,
    /// A row for each piece and power of the first argument, in it an entry for each piece and power of the second.
    coefficients: Vec<f64>,
    fingerprint: u64,
}

/// A [`Spline`] differentiated so and so often in each argument.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct SplineCall {
    /// The data.
    pub spline: Arc<Spline>,
    /// Order of the derivative in each argument.
    pub orders: [usize; 2],
    /// Whether it has all derivatives: beyond those that pieces share, each piece's own, and at a knot those of the
    /// piece that begins there.
    pub is_piecewise: bool,
}

impl Knots {
    /// The distinct knots of the argument's range, each with the last index at which it stands.
    fn pieces(&self) -> Option<(Vec<f64>, Vec<usize>)> {
        let count = self.knots.len().checked_sub(self.degree + 1).filter(|count| *count > self.degree)?;
        let is_ascending = self.knots.is_sorted() && self.knots.iter().all(|knot| knot.is_finite());
        if !is_ascending || self.degree == 0 || self.degree > HIGHEST_DEGREE {
            return None;
        }
        let (mut breaks, mut spans) = (Vec::new(), Vec::new());
        for (index, pair) in self.knots.windows(2).enumerate().take(count).skip(self.degree) {
            if let [low, high] = pair
                && low < high
            {
                breaks.push(*low);
                spans.push(index);
            }
        }
        breaks.push(*self.knots.get(count)?);
        (!spans.is_empty()).then_some((breaks, spans))
    }

    /// The highest derivative that is continuous where pieces meet; `None` if none meet.
    fn smoothness(&self, breaks: &[f64]) -> Option<Option<usize>> {
        let inside = breaks.get(1..breaks.len().saturating_sub(1)).unwrap_or_default();
        let repeated = |knot: &f64| self.knots.iter().filter(|other| *other == knot).count();
        let inner = match inside.iter().map(repeated).max() {
            None => None,
            Some(most) => Some(self.degree.checked_sub(most)?),
        };
        Some(match (inner, self.seam) {
            (Some(inner), Some(seam)) => Some(inner.min(seam)),
            (inner, seam) => inner.or(seam),
        })
    }
}

impl Spline {
    /// A B-spline called `name`, of one or two arguments with their names and knots.
    ///
    /// `controls` are the control values, those of the last argument beside each other. `None` unless there are as many
    /// as the knots ask for, knots ascend over a range, degrees are from 1 to [`HIGHEST_DEGREE`], the spline is
    /// continuous, and all is finite.
    #[must_use]
    pub fn new(name: &str, arguments: &[(&str, Knots)], controls: &[f64]) -> Option<Spline> {
        let count = |knots: &Knots| knots.knots.len().saturating_sub(knots.degree + 1);
        let [(first, knots), rest @ ..] = arguments else { return None };
        let (columns, second) = match rest {
            [] => (1, None),
            [(name, knots)] => (count(knots), Some((name, knots))),
            _ => return None,
        };
        if Some(controls.len()) != count(knots).checked_mul(columns) || !controls.iter().all(|value| value.is_finite())
        {
            return None;
        }
        let (axis, spans) = Axis::new(first, knots)?;
        let (other, expanded) = match second {
            None => (Axis::unused(), controls.to_vec()),
            Some((name, knots)) => {
                let (axis, spans) = Axis::new(name, knots)?;
                let rows = controls.chunks(columns).map(|row| taylor(knots, &spans, row));
                (axis, rows.flatten().collect())
            }
        };
        let width = other.entries();
        let mut coefficients = vec![0.0; axis.entries().checked_mul(width)?];
        for column in 0..width {
            let line: Vec<f64> = expanded.iter().skip(column).step_by(width).copied().collect();
            let slots = coefficients.iter_mut().skip(column).step_by(width);
            slots.zip(taylor(knots, &spans, &line)).for_each(|(slot, value)| *slot = value);
        }
        if !coefficients.iter().all(|value| value.is_finite()) {
            return None;
        }
        let mut spline = Spline {
            name: name.to_owned(),
            axes: [axis, other],
            arguments: arguments.len(),
            coefficients,
            fingerprint: 0,
        };
        spline.fingerprint = spline.hashed();
        Some(spline)
    }

    /// What the user calls it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The number of arguments, 1 or 2.
    #[must_use]
    pub fn arguments(&self) -> usize {
        self.arguments
    }

    /// The name of an argument.
    #[must_use]
    pub fn argument(&self, index: usize) -> &str {
        self.axes.get(index).map_or("", |axis| &axis.name)
    }

    /// The highest derivative in an argument that exists; `None` for all.
    #[must_use]
    pub fn smoothness(&self, argument: usize) -> Option<usize> {
        self.axes.get(argument).and_then(|axis| axis.smoothness)
    }

    /// The degree in an argument.
    #[must_use]
    pub fn degree(&self, argument: usize) -> usize {
        self.axes.get(argument).map_or(0, |axis| axis.degree)
    }

    /// The range of an argument.
    #[must_use]
    pub fn range(&self, argument: usize) -> [f64; 2] {
        self.axes.get(argument).map_or([f64::NAN; 2], Axis::range)
    }

    /// Whether the spline repeats itself in an argument.
    #[must_use]
    pub fn is_periodic(&self, argument: usize) -> bool {
        self.axes.get(argument).is_some_and(|axis| axis.is_periodic)
    }

    /// Where pieces begin and the last ends, of an argument.
    #[must_use]
    pub fn breaks(&self, argument: usize) -> &[f64] {
        self.axes.get(argument).map_or(&[], |axis| &axis.breaks)
    }

    /// The Taylor coefficients: a row for each piece and power of the first argument around where the piece begins, in
    /// it an entry for each piece and power of the second. With one argument rows have one entry.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    fn hashed(&self) -> u64 {
        let mut hasher = FxHasher::default();
        self.name.hash(&mut hasher);
        self.coefficients.iter().for_each(|value| value.to_bits().hash(&mut hasher));
        hasher.finish()
    }

    /// A derivative at a point; NaN outside the range of an argument in which it is not periodic.
    fn value(&self, orders: [usize; 2], arguments: [f64; 2]) -> f64 {
        let [first, second] = &self.axes;
        let (Some((row, x)), Some((column, y))) = (first.locate(arguments[0]), second.locate(arguments[1])) else {
            return f64::NAN;
        };
        let width = second.entries();
        let powers = second.degree + 1;
        let inner = |power: usize| {
            let start = (row * (first.degree + 1) + power) * width + column * powers;
            let coefficients = self.coefficients.get(start..start + powers).unwrap_or_default();
            let terms = coefficients.iter().copied().enumerate().skip(orders[1]).rev();
            terms.fold(0.0, |sum, (power, coefficient)| sum * y + coefficient * falling(power, orders[1]))
        };
        let terms = (orders[0]..=first.degree).rev();
        terms.fold(0.0, |sum, power| sum * x + inner(power) * falling(power, orders[0]))
    }
}

impl SplineCall {
    /// The spline itself.
    #[must_use]
    pub fn new(spline: Arc<Spline>) -> SplineCall {
        SplineCall { spline, orders: [0, 0], is_piecewise: false }
    }

    /// The value; of one argument the second is not read. NaN outside the range of an argument in which the spline is
    /// not periodic.
    #[must_use]
    pub fn value(&self, first: f64, second: f64) -> f64 {
        let second = if self.spline.arguments == 2 { second } else { 0.0 };
        self.spline.value(self.orders, [first, second])
    }

    /// The same with all derivatives: see [`SplineCall::is_piecewise`].
    #[must_use]
    pub fn piecewise(self) -> SplineCall {
        SplineCall { is_piecewise: true, ..self }
    }

    /// The same data with one more derivative in an argument; `Err` with the highest that exists if that is it already.
    pub fn differentiated(&self, argument: usize) -> Result<SplineCall, usize> {
        let mut orders = self.orders;
        if let Some(order) = orders.get_mut(argument) {
            *order += 1;
            let smoothness = self.spline.smoothness(argument).filter(|_| !self.is_piecewise);
            if let Some(highest) = smoothness.filter(|highest| *order > *highest) {
                return Err(highest);
            }
        }
        Ok(SplineCall { spline: Arc::clone(&self.spline), orders, is_piecewise: self.is_piecewise })
    }

    /// Whether it is zero everywhere: a derivative of a polynomial above its degree.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.orders.iter().zip(&self.spline.axes).any(|(order, axis)| *order > axis.degree)
    }
}

impl Axis {
    fn new(name: &str, knots: &Knots) -> Option<(Axis, Vec<usize>)> {
        let (breaks, spans) = knots.pieces()?;
        let smoothness = knots.smoothness(&breaks)?;
        let (degree, is_periodic) = (knots.degree, knots.seam.is_some());
        Some((Axis { name: name.to_owned(), degree, breaks, is_periodic, smoothness }, spans))
    }

    /// The second argument of a spline that has one: a constant.
    fn unused() -> Axis {
        Axis { name: String::new(), degree: 0, breaks: vec![0.0, 1.0], is_periodic: false, smoothness: None }
    }

    fn range(&self) -> [f64; 2] {
        [self.breaks.first(), self.breaks.last()].map(|end| end.copied().unwrap_or(f64::NAN))
    }

    fn pieces(&self) -> usize {
        self.breaks.len() - 1
    }

    fn entries(&self) -> usize {
        self.pieces() * (self.degree + 1)
    }

    /// The piece at `x`, and how far into it.
    fn locate(&self, x: f64) -> Option<(usize, f64)> {
        let [start, end] = self.range();
        let slack = SLACK * (end - start);
        let x = if self.is_periodic {
            let turns = libm::floor((x - start) / (end - start));
            (x - turns * (end - start)).clamp(start, end)
        } else {
            x
        };
        if !(start - slack..=end + slack).contains(&x) {
            return None;
        }
        let piece = self.breaks.partition_point(|begin| *begin <= x).saturating_sub(1).min(self.pieces() - 1);
        self.breaks.get(piece).map(|begin| (piece, x - begin))
    }
}

/// `power (power - 1) …`, `order` factors.
fn falling(power: usize, order: usize) -> f64 {
    (0..order).map(|taken| power.saturating_sub(taken) as f64).product()
}

/// The Taylor coefficients of every piece of a B-spline around where it begins.
fn taylor(knots: &Knots, spans: &[usize], controls: &[f64]) -> Vec<f64> {
    let degree = knots.degree;
    let knot = |index: usize| knots.knots.get(index).copied().unwrap_or(f64::NAN);
    let mut coefficients = Vec::with_capacity(spans.len() * (degree + 1));
    for &span in spans {
        let mut local = controls.get(span - degree..=span).unwrap_or_default().to_vec();
        let mut factorial = 1.0;
        for order in 0..=degree {
            let left = degree - order;
            coefficients.push(de_boor(local.clone(), span, knot(span), knot) / factorial);
            let steps = local.windows(2).enumerate().map(|(index, pair)| {
                let [before, after] = pair else { return f64::NAN };
                left as f64 * (after - before) / (knot(span + 1 + index) - knot(span + 1 + index - left))
            });
            local = steps.collect();
            factorial *= (order + 1) as f64;
        }
    }
    coefficients
}

/// The value at `x`, in knot span `span`, of a B-spline of one degree less than it has `local` control values there.
fn de_boor(mut local: Vec<f64>, span: usize, x: f64, knot: impl Fn(usize) -> f64) -> f64 {
    let degree = local.len().saturating_sub(1);
    for round in 1..=degree {
        let low = span + round - degree;
        let mixed = local.windows(2).enumerate().map(|(index, pair)| {
            let [before, after] = pair else { return f64::NAN };
            let (start, end) = (knot(low + index), knot(span + 1 + index));
            let share = (x - start) / (end - start);
            (1.0 - share) * before + share * after
        });
        local = mixed.collect();
    }
    local.first().copied().unwrap_or(f64::NAN)
}

impl PartialEq for Spline {
    fn eq(&self, other: &Spline) -> bool {
        let bits = |spline: &Spline| spline.coefficients.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
        self.fingerprint == other.fingerprint
            && self.name == other.name
            && self.axes == other.axes
            && bits(self) == bits(other)
    }
}

impl Eq for Spline {}

impl Hash for Spline {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.fingerprint.hash(state);
    }
}

impl std::fmt::Debug for Spline {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let pieces: Vec<usize> = self.axes.iter().take(self.arguments).map(Axis::pieces).collect();
        write!(f, "Spline({} of {pieces:?} pieces)", self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn knots(degree: usize, knots: &[f64]) -> Knots {
        Knots { degree, knots: knots.to_vec(), seam: None }
    }

    #[test]
    fn bezier_square_has_the_derivatives_of_a_square() {
        // x² on [0, 2] in Bézier form: blossoms 0, 0, 4.
        let spline = Spline::new("f", &[("x", knots(2, &[0.0, 0.0, 0.0, 2.0, 2.0, 2.0]))], &[0.0, 0.0, 4.0]);
        let call = SplineCall::new(Arc::new(spline.expect("well formed")));
        let slope = call.differentiated(0).expect("a polynomial");
        let second = slope.differentiated(0).expect("a polynomial");
        let third = second.differentiated(0).expect("a polynomial");
        assert_eq!([call.value(1.5, 0.0), slope.value(1.5, 0.0), second.value(1.5, 0.0)], [2.25, 3.0, 2.0]);
        assert!(third.is_zero() && !second.is_zero());
        assert!(call.value(2.1, 0.0).is_nan() && call.value(f64::NAN, 0.0).is_nan());
    }

    #[test]
    fn tensor_product_of_two_arguments_is_the_product() {
        // u² (1 + 3 v) with u in two pieces, knots at 0, 1, 2, and v in [0, 1]; blossom of u² is ab.
        let u = knots(2, &[0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]);
        let v = knots(1, &[0.0, 0.0, 1.0, 1.0]);
        let squares = [0.0, 0.0, 2.0, 4.0];
        let controls: Vec<f64> = squares.iter().flat_map(|square| [*square, 4.0 * square]).collect();
        let call = SplineCall::new(Arc::new(Spline::new("f", &[("u", u), ("v", v)], &controls).expect("well formed")));
        for (x, y) in [(0.5, 0.25), (1.5, 0.75), (1.0, 1.0)] {
            assert_eq!(call.value(x, y), x * x * (1.0 + 3.0 * y));
            let mixed = call.differentiated(0).and_then(|call| call.differentiated(1)).expect("smooth");
            assert_eq!(mixed.value(x, y), 6.0 * x);
        }
        assert_eq!(call.spline.smoothness(0), Some(1));
        assert_eq!(call.differentiated(0).and_then(|call| call.differentiated(0)), Err(1));
        let second = call.piecewise().differentiated(0).and_then(|call| call.differentiated(0)).expect("of each piece");
        assert_eq!([0.5, 1.0, 1.5].map(|u| second.value(u, 0.0)), [2.0; 3]);
    }

    #[test]
    fn data_that_are_no_spline_are_refused() {
        let good = knots(1, &[0.0, 0.0, 1.0, 1.0]);
        assert!(Spline::new("f", &[("x", good.clone())], &[0.0, 1.0]).is_some());
        assert!(Spline::new("f", &[("x", good.clone())], &[0.0]).is_none());
        assert!(Spline::new("f", &[("x", good)], &[0.0, f64::NAN]).is_none());
        for bad in [&[0.0, 1.0, 0.0, 1.0][..], &[0.0, 0.0, 0.0, 0.0], &[0.0, 0.0, f64::INFINITY, f64::INFINITY]] {
            assert!(Spline::new("f", &[("x", knots(1, bad))], &[0.0, 1.0]).is_none(), "{bad:?}");
        }
        // A jump: a knot as often as the degree and once more.
        let torn = knots(1, &[0.0, 0.0, 0.5, 0.5, 1.0, 1.0]);
        assert!(Spline::new("f", &[("x", torn)], &[0.0, 1.0, 2.0, 3.0]).is_none());
    }
}
