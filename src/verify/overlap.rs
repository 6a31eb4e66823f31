//! Finds what two edges have in common where one lies along a part of the other, or each reaches past the other.
//!
//! Where two curves run along each other, the part begins and ends where one of them does. So the ends of each are
//! looked for on the other: the nearest of its sampled segments, then Gauss and Newton's step on the curve itself.
//! Whether the edges stay together in between is for [`Edge::meet`] to say of the parts.

use super::contact::{Vector, difference, distance, dot};
use super::seam::{Edge, Line};
use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, Variable};
use crate::surface::Surface;

/// An edge on its surface at one instant.
#[derive(Clone, Copy)]
pub struct Curve<'a> {
    /// The surface.
    pub surface: &'a dyn Surface,
    /// Where it lies on it.
    pub line: Line,
    /// Its samples.
    pub edge: &'a Edge,
}

/// Of the range of an edge: shorter parts are a point. Of the distance that is near: what is nearer is the same point.
const SHORTEST: f64 = 1e-6;
/// Steps of the search for the nearest point. They converge quadratically where the point lies on the curve.
const STEPS: usize = 12;

/// Two parts of edges, as values of the coordinates along them; `None` for all of an edge.
pub type Parts = [Option<[f64; 2]>; 2];

/// The parts of two edges between the outermost ends that lie on both, nearer than `gap` at instant `t`: the first
/// ascending, the second the same way along the curve. `None` if the edges have no end in common, touch in a point, or
/// have all of both in common.
///
/// Cost: a comparison with a box for edges that are far apart.
///
/// # Errors
/// Whatever a surface says when it cannot be evaluated.
pub fn common_part([a, b]: [Curve<'_>; 2], t: f64, gap: f64) -> Result<Option<Parts>, Diagnostic> {
    if a.edge.may_meet(b.edge, gap) {
        return Ok(None);
    }
    let mut places: Vec<[f64; 2]> = Vec::with_capacity(4);
    for end in b.ends() {
        places.extend(a.nearest(end.1, t, gap)?.map(|at| [at, end.0]));
    }
    for end in a.ends() {
        places.extend(b.nearest(end.1, t, gap)?.map(|at| [end.0, at]));
    }
    places.sort_by(|[one, _], [other, _]| one.total_cmp(other));
    let (Some([low, from]), Some([high, to])) = (places.first().copied(), places.last().copied()) else {
        return Ok(None);
    };
    let length = |line: &Line| line.along[1] - line.along[0];
    let is_short = |from: f64, to: f64, line: &Line| (to - from).abs() <= SHORTEST * length(line).abs();
    let is_whole = |from: f64, to: f64, line: &Line| (to - from).abs() >= (1.0 - SHORTEST) * length(line).abs();
    if is_short(low, high, &a.line) || is_short(from, to, &b.line) {
        return Ok(None);
    }
    let of_a = (!is_whole(low, high, &a.line)).then_some([low, high]);
    let of_b = (!is_whole(from, to, &b.line)).then_some([from, to]);
    Ok((of_a.is_some() || of_b.is_some()).then_some([of_a, of_b]))
}

impl Curve<'_> {
    /// Coordinate and point of both ends.
    fn ends(&self) -> impl Iterator<Item = (f64, Vector)> {
        self.line.along.into_iter().zip(self.edge.ends().into_iter().flatten())
    }

    /// The coordinate along the curve of the point nearest to `point`, if that is nearer than `gap`.
    fn nearest(&self, point: Vector, t: f64, gap: f64) -> Result<Option<f64>, Diagnostic> {
        if !self.edge.surrounds(point, gap) {
            return Ok(None);
        }
        // Most patches meet at corners, where nothing is to be looked for.
        if let Some((end, _)) = self.ends().find(|(_, corner)| distance(*corner, point) <= SHORTEST * gap) {
            return Ok(Some(end));
        }
        let [start, end] = self.line.along;
        let (low, high) = (start.min(end), start.max(end));
        let mut at = start + (end - start) * self.edge.nearest_share(point);
        for _ in 0..STEPS {
            let away = difference(point, self.at(Derivative::NONE, at, t)?);
            let slope = self.at(self.slope(), at, t)?;
            let step = dot(away, slope) / dot(slope, slope);
            let next = (at + step).clamp(low, high);
            if !step.is_finite() || next == at {
                break;
            }
            at = next;
        }
        // An end that is nearly met is meant.
        let snapped = [start, end].into_iter().find(|place| (place - at).abs() <= SHORTEST * (high - low));
        let at = snapped.unwrap_or(at);
        Ok((distance(point, self.at(Derivative::NONE, at, t)?) <= gap).then_some(at))
    }

    fn slope(&self) -> Derivative {
        if self.line.across == Variable::U { Derivative::new(0, 1, 0) } else { Derivative::new(1, 0, 0) }
    }

    fn at(&self, orders: Derivative, along: f64, t: f64) -> Result<Vector, Diagnostic> {
        let across = self.line.position;
        let point = if self.line.across == Variable::U { [across, along, t] } else { [along, across, t] };
        let mut value = [[f64::NAN; 3]];
        self.surface.evaluate(orders, &[point], &mut value)?;
        Ok(value[0])
    }
}
