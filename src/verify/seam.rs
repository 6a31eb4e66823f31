//! Judges how two patches meet along edges of constant u.

use super::contact::{Vector, angle_degrees, distance, normals, worse};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::surface::Surface;

/// An edge of a solved patch at one instant: points over the range of v, and the normals there.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    points: Vec<Vector>,
    normals: Vec<Option<Vector>>,
}

/// How two edges meet, at their worst.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamDeviation {
    /// The largest distance of points of the same place along the edges.
    pub gap: f64,
    /// The largest angle between the tangent planes, in degrees from 0 to 90; `None` if no point has both.
    pub angle_degrees: Option<f64>,
}

/// Points of an edge: a prime number of intervals, so that no common wave number is met only where it vanishes.
const POINTS: usize = 48;

impl Edge {
    /// Samples the edge `u` of `surface` at instant `t`.
    ///
    /// # Errors
    /// Whatever the surface says when it cannot be evaluated.
    pub fn sample(surface: &dyn Surface, u: f64, [low, high]: [f64; 2], t: f64) -> Result<Edge, Diagnostic> {
        let last = (POINTS - 1) as f64;
        let v: Vec<f64> =
            (0..POINTS).map(|i| if i + 1 == POINTS { high } else { low + (high - low) * (i as f64 / last) }).collect();
        let values = |orders: Derivative| {
            let mut values = vec![[0.0; 3]; v.len()];
            surface.evaluate_grid(orders, (&[u], &v, t), &mut values).map(|()| values)
        };
        let points = values(Derivative::NONE)?;
        let tangents = values(Derivative::new(1, 0, 0))?.into_iter().zip(values(Derivative::new(0, 1, 0))?);
        let normals = normals(&points, tangents);
        Ok(Edge { points, normals })
    }

    /// The size of the box around the edge.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let range = |axis: usize| {
            let values = self.points.iter().filter_map(|point| point.get(axis));
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
            high - low
        };
        range(0).hypot(range(1)).hypot(range(2))
    }

    /// How the edges meet when both run the same way, or in opposite ways: the better of the two.
    #[must_use]
    pub fn meet(&self, other: &Edge) -> SeamDeviation {
        let (along, against) = (self.compare(other.places()), self.compare(other.places().rev()));
        if against.gap < along.gap { against } else { along }
    }

    fn places(&self) -> impl DoubleEndedIterator<Item = (&Vector, &Option<Vector>)> {
        self.points.iter().zip(&self.normals)
    }

    fn compare<'a>(&self, other: impl Iterator<Item = (&'a Vector, &'a Option<Vector>)>) -> SeamDeviation {
        let mut worst = SeamDeviation { gap: 0.0, angle_degrees: None };
        for ((a, of_a), (b, of_b)) in self.places().zip(other) {
            let gap = distance(*a, *b);
            worst.gap = if gap.is_nan() { f64::INFINITY } else { worst.gap.max(gap) };
            let angle = of_a.zip(*of_b).map(|(a, b)| angle_degrees(a, b));
            worst.angle_degrees = worse(worst.angle_degrees, angle);
        }
        worst
    }
}

impl SeamDeviation {
    /// The worse of two measurements of one seam, for example at two instants.
    #[must_use]
    pub fn worst(self, other: &SeamDeviation) -> SeamDeviation {
        SeamDeviation { gap: self.gap.max(other.gap), angle_degrees: worse(self.angle_degrees, other.angle_degrees) }
    }
}
