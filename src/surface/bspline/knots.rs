//! Knot vectors: the parameter line of a B-spline, and the basis functions on it.

use crate::diagnostic::{Code, Diagnostic, Shortest};

/// The highest degree of a B-spline here: beyond it, rounding and oscillation outgrow the use.
pub const LARGEST_DEGREE: usize = 5;

/// A degree p and a knot vector `t_0 ≤ … ≤ t_(n+p+1)`, for n + 1 control points.
///
/// Knots are finite, the domain `[t_p, t_(n+1)]` has extent, and no knot inside it is repeated more than p times, so
/// that curves are continuous. At its ends a knot may be repeated p + 1 times, which makes it *clamped* there.
#[derive(Debug, Clone, PartialEq)]
pub struct KnotVector {
    degree: usize,
    knots: Vec<f64>,
}

/// The values of the degree + 1 basis functions that live on one span; those beyond the degree are zero.
pub(super) type SpanValues = [f64; LARGEST_DEGREE + 1];

impl KnotVector {
    /// Knots in ascending order.
    ///
    /// # Errors
    /// [`Code::KnotsNotAscending`] for a degree outside 1 to [`LARGEST_DEGREE`], fewer than 2 (degree + 1) knots,
    /// knots that are not finite or descend, a domain without extent, and a knot repeated too often.
    pub fn new(degree: usize, knots: Vec<f64>) -> Result<KnotVector, Diagnostic> {
        let wrong = |message: String, hint: &str| Err(Diagnostic::new(Code::KnotsNotAscending, message).hint(hint));
        if !(1..=LARGEST_DEGREE).contains(&degree) {
            let hint = format!("choose a degree from 1 to {LARGEST_DEGREE}; 3 is usual");
            return wrong(format!("the degree of a B-spline is {degree}"), &hint);
        }
        if knots.len() < 2 * (degree + 1) {
            let (count, least) = (knots.len(), 2 * (degree + 1));
            return wrong(format!("{count} knots are too few for degree {degree}"), &format!("give at least {least}"));
        }
        if let Some(index) = knots.iter().position(|knot| !knot.is_finite()) {
            let value = knots.get(index).copied().unwrap_or(f64::NAN);
            return wrong(
                format!("knot number {index} is {}", Shortest(value)),
                "knots are finite numbers in ascending order",
            );
        }
        if let Some(index) = knots.windows(2).position(|pair| matches!(pair, [a, b] if b < a)) {
            let pair: Vec<String> = knots.iter().skip(index).take(2).map(|knot| Shortest(*knot).to_string()).collect();
            let message = format!("the knots descend from {} at number {}", pair.join(" to "), index + 1);
            return wrong(message, "knots are finite numbers in ascending order");
        }
        let vector = KnotVector { degree, knots };
        let [start, end] = vector.domain();
        if !(start < end && (end - start).is_finite()) {
            let (start, end) = (Shortest(start), Shortest(end));
            let hint = "the domain of n + 1 points of degree p is [t_p, t_(n+1)]";
            return wrong(format!("the knots leave the domain [{start}, {end}], which has no extent"), hint);
        }
        for (knot, count) in vector.multiplicities() {
            let most = if knot > start && knot < end { degree } else { degree + 1 };
            if count > most {
                let knot = Shortest(knot);
                let message = format!("the knot {knot} stands {count} times, and degree {degree} bears {most} there");
                return wrong(message, "a curve breaks apart at such a knot; repeat it less often");
            }
        }
        Ok(vector)
    }

    /// Knots 0, 1, 2, … for `points` control points.
    ///
    /// # Errors
    /// As [`KnotVector::new`]: for fewer than degree + 1 points.
    pub fn uniform(degree: usize, points: usize) -> Result<KnotVector, Diagnostic> {
        KnotVector::new(degree, (0..points.saturating_add(degree + 1)).map(|index| index as f64).collect())
    }

    /// Breakpoints with the first and the last repeated degree + 1 times.
    ///
    /// # Errors
    /// As [`KnotVector::new`].
    pub fn clamped(degree: usize, breakpoints: &[f64]) -> Result<KnotVector, Diagnostic> {
        let repeated = |end: Option<&f64>| end.into_iter().flat_map(|end| vec![*end; degree]).collect::<Vec<f64>>();
        let ends = [repeated(breakpoints.first()), repeated(breakpoints.last())];
        let [first, last] = ends;
        KnotVector::new(degree, first.into_iter().chain(breakpoints.iter().copied()).chain(last).collect())
    }

    /// Equal spans 0, 1, 2, … with both ends repeated degree + 1 times, for `points` control points.
    ///
    /// # Errors
    /// As [`KnotVector::new`]: for fewer than degree + 1 points.
    pub fn clamped_uniform(degree: usize, points: usize) -> Result<KnotVector, Diagnostic> {
        let breakpoints: Vec<f64> = (0..=points.saturating_sub(degree)).map(|index| index as f64).collect();
        KnotVector::clamped(degree, &breakpoints)
    }

    /// The degree p.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All knots, with repetitions.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.knots
    }

    /// The number n + 1 of control points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The parameter range `[t_p, t_(n+1)]`.
    #[must_use]
    pub fn domain(&self) -> [f64; 2] {
        [self.knot(self.degree), self.knot(self.points())]
    }

    /// Every knot once, with how often it stands.
    #[must_use]
    pub fn multiplicities(&self) -> Vec<(f64, usize)> {
        let mut counted: Vec<(f64, usize)> = Vec::new();
        for &knot in &self.knots {
            match counted.last_mut() {
                Some((last, count)) if *last == knot => *count += 1,
                _ => counted.push((knot, 1)),
            }
        }
        counted
    }

    /// The knots of the domain, each once, ends included.
    #[must_use]
    pub fn breakpoints(&self) -> Vec<f64> {
        let [start, end] = self.domain();
        let counted = self.multiplicities().into_iter();
        counted.map(|(knot, _)| knot).filter(|knot| (start..=end).contains(knot)).collect()
    }

    /// How often `knot` stands.
    #[must_use]
    pub fn multiplicity(&self, knot: f64) -> usize {
        self.knots.iter().filter(|other| **other == knot).count()
    }

    /// Whether the first and the last control point are the ends of a curve.
    #[must_use]
    pub fn is_clamped(&self) -> bool {
        self.domain().iter().all(|end| self.multiplicity(*end) == self.degree + 1)
    }

    /// The same line run through backwards: knots -t.
    #[must_use]
    pub fn reversed(&self) -> KnotVector {
        KnotVector { degree: self.degree, knots: self.knots.iter().rev().map(|knot| -knot).collect() }
    }

    /// Where each control point acts most: the means of p successive knots.
    #[must_use]
    pub fn greville(&self) -> Vec<f64> {
        let inner = self.knots.get(1..self.knots.len() - 1).unwrap_or(&[]);
        inner.windows(self.degree).map(|knots| knots.iter().sum::<f64>() / self.degree as f64).collect()
    }

    /// The derivative of order `order` at `x` of the basis function of one control point; of the span to the right of
    /// an inner knot.
    #[must_use]
    pub fn basis_function(&self, point: usize, order: usize, x: f64) -> f64 {
        let (first, values) = self.basis(order, x);
        point.checked_sub(first).and_then(|index| values.get(index)).copied().unwrap_or(0.0)
    }

    /// The number of the control point whose basis function is the first that lives at `x`, and the derivatives of
    /// order `order` there of that function and the next degree ones.
    ///
    /// At an inner knot the span to its right counts; outside the domain the nearest span's polynomials continue.
    #[must_use]
    pub(super) fn basis(&self, order: usize, x: f64) -> (usize, SpanValues) {
        let span = self.span(x);
        let mut values = [0.0; LARGEST_DEGREE + 1];
        if order > self.degree {
            return (span - self.degree, values);
        }
        if let Some(first) = values.first_mut() {
            *first = 1.0;
        }
        for degree in 1..=self.degree {
            // Function number j of degree `degree - 1` lives on [t_j, t_(j+degree)], and passes to j - 1 and j.
            let starts = self.knots.get(span + 1 - degree..=span).unwrap_or(&[]);
            let ends = self.knots.get(span + 1..=span + degree).unwrap_or(&[]);
            let is_derivative = degree + order > self.degree;
            let mut raised = [0.0; LARGEST_DEGREE + 1];
            let mut carried = 0.0;
            let supports = starts.iter().zip(ends).map(Some).chain(std::iter::once(None));
            for ((value, support), raised) in values.iter().zip(supports).zip(raised.iter_mut()) {
                let Some((start, end)) = support else {
                    *raised = carried;
                    continue;
                };
                let length = end - start;
                // Quotients first: at an end of a clamped domain they are 0 and 1, and the end point comes out exactly.
                let (before, here) = if is_derivative {
                    (-(degree as f64) / length * value, degree as f64 / length * value)
                } else {
                    ((end - x) / length * value, (x - start) / length * value)
                };
                *raised = carried + before;
                carried = here;
            }
            values = raised;
        }
        (span - self.degree, values)
    }

    /// The number i of the non-empty span `[t_i, t_(i+1))` of the domain that holds `x`, or is nearest to it.
    fn span(&self, x: f64) -> usize {
        let [start, end] = self.domain();
        let last = self.knots.partition_point(|knot| *knot < end) - 1;
        if x < start {
            return self.knots.partition_point(|knot| *knot <= start) - 1;
        }
        (self.knots.partition_point(|knot| *knot <= x) - 1).min(last)
    }

    /// For an index that the invariants keep in range.
    fn knot(&self, index: usize) -> f64 {
        self.knots.get(index).copied().unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(degree: usize, knots: &[f64]) -> String {
        let found = KnotVector::new(degree, knots.to_vec()).expect_err("knots that are none");
        assert_eq!(found.code, Code::KnotsNotAscending);
        found.message
    }

    #[test]
    fn knots_that_are_none_are_refused_with_the_reason() {
        assert_eq!(refusal(6, &[0.0; 14]), "the degree of a B-spline is 6");
        assert_eq!(refusal(3, &[0.0, 1.0, 2.0]), "3 knots are too few for degree 3");
        assert_eq!(refusal(1, &[0.0, 1.0, f64::NAN, 3.0]), "knot number 2 is NaN");
        assert_eq!(refusal(1, &[0.0, -1e308, 1.5, 3.0]), "the knots descend from 0 to -1e308 at number 1");
        assert_eq!(refusal(1, &[0.0, 2.0, 1.5, 3.0]), "the knots descend from 2 to 1.5 at number 2");
        assert_eq!(refusal(1, &[0.0, 1.0, 1.0, 2.0]), "the knots leave the domain [1, 1], which has no extent");
        assert_eq!(
            refusal(1, &[0.0, 0.0, 1.0, 1.0, 2.0, 2.0]),
            "the knot 1 stands 2 times, and degree 1 bears 1 there"
        );
    }

    #[test]
    fn basis_functions_sum_to_one_and_their_derivatives_to_zero() {
        let knots = [0.0, 0.0, 0.5, 0.5, 0.7, 1.0, 1.8, 2.0, 2.5, 2.5, 2.6, 3.0, 3.0, 3.5];
        for degree in 1..=LARGEST_DEGREE {
            let knots = KnotVector::new(degree, knots.to_vec()).unwrap_or_else(|_| {
                // Degree 1 does not bear the double knots.
                KnotVector::uniform(degree, 9).expect("knots")
            });
            let [start, end] = knots.domain();
            for step in 0..=40 {
                let x = start + (end - start) * f64::from(step) / 40.0;
                for order in 0..=degree {
                    let (_, values) = knots.basis(order, x);
                    let size = values.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
                    let expected = if order == 0 { 1.0 } else { 0.0 };
                    // A few roundings of each of six numbers.
                    assert!((values.iter().sum::<f64>() - expected).abs() <= 32.0 * f64::EPSILON * size);
                }
            }
        }
    }

    #[test]
    fn cubic_basis_of_equal_spans_is_the_known_one() {
        let knots = KnotVector::uniform(3, 6).expect("knots");
        let (first, values) = knots.basis(0, 4.0);
        assert_eq!(first, 1);
        for (value, expected) in values.iter().zip([1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0, 0.0, 0.0]) {
            assert!((value - expected).abs() < 4.0 * f64::EPSILON, "{values:?}");
        }
        assert_eq!(knots.basis(3, 3.5).1, [-1.0, 3.0, -3.0, 1.0, 0.0, 0.0]);
        assert_eq!(knots.basis(4, 3.5).1, [0.0; 6]);
    }

    #[test]
    fn end_of_the_domain_belongs_to_the_last_span() {
        let knots = KnotVector::clamped(2, &[0.0, 1.0, 2.0]).expect("knots");
        assert_eq!(knots.basis(0, 2.0), (1, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]));
        assert_eq!(knots.basis(0, 0.0), (0, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn greville_points_of_a_cubic_are_means_of_three_knots() {
        let knots = KnotVector::clamped_uniform(3, 5).expect("knots");
        assert_eq!(knots.greville(), [0.0, 1.0 / 3.0, 1.0, 5.0 / 3.0, 2.0]);
    }
}
