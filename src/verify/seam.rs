//! Judges how two patches meet along edges of constant u or v.

use super::contact::{Vector, angle_degrees, difference, distance, dot, normals, turn_degrees, worse};
use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, Variable};
use crate::surface::Surface;

/// A curve of constant u or v of a solved patch at one instant, usually an edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    places: Vec<Place>,
    /// The lower and the upper corner of the box around them.
    bounds: [Vector; 2],
}

/// Where on a patch an edge lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The coordinate that is fixed: u or v.
    pub across: Variable,
    /// Its value.
    pub position: f64,
    /// Its range in the patch.
    pub domain: [f64; 2],
    /// From where to where the other coordinate runs.
    pub along: [f64; 2],
}

/// A point of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    point: Vector,
    normal: Option<Vector>,
    /// The tangent that points out of the patch; `None` inside it.
    outward: Option<Vector>,
    along: Vector,
}

/// How two edges meet, at their worst.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamDeviation {
    /// The largest distance of points of the same place along the edges.
    pub gap: f64,
    /// The largest angle by which one patch turns where it goes on as the other, in degrees: 0 is smooth, 180 a fold.
    /// Where an edge lies inside its patch, the angle between the tangent planes, from 0 to 90. `None` if no point has
    /// tangent planes.
    pub angle_degrees: Option<f64>,
}

/// Points of an edge: a prime number of intervals, so that no common wave number is met only where it vanishes.
const POINTS: usize = 48;

impl Edge {
    /// Samples the curve `line` of `surface` at instant `t`.
    ///
    /// # Errors
    /// Whatever the surface says when it cannot be evaluated.
    pub fn sample(surface: &dyn Surface, line: Line, t: f64) -> Result<Edge, Diagnostic> {
        let Line { across, position, domain, along: [low, high] } = line;
        let is_at_u = across == Variable::U;
        let last = (POINTS - 1) as f64;
        let along: Vec<f64> =
            (0..POINTS).map(|i| if i + 1 == POINTS { high } else { low + (high - low) * (i as f64 / last) }).collect();
        let values = |orders: Derivative| {
            let mut values = vec![[0.0; 3]; along.len()];
            let (u, v) = if is_at_u { (&[position][..], &along[..]) } else { (&along[..], &[position][..]) };
            surface.evaluate_grid(orders, (u, v, t), &mut values).map(|()| values)
        };
        let points = values(Derivative::NONE)?;
        let orders = [Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)];
        let [across, along] = if is_at_u { orders } else { [orders[1], orders[0]] };
        let tangents = values(across)?.into_iter().zip(values(along)?);
        let normals = normals(&points, tangents.clone());
        let out_of = |tangent: Vector| match domain {
            [_, end] if position == end => Some(tangent),
            [start, _] if position == start => Some(tangent.map(|x| -x)),
            _ => None,
        };
        let places = points.into_iter().zip(normals).zip(tangents);
        let place = |((point, normal), (across, along))| Place { point, normal, outward: out_of(across), along };
        let places: Vec<Place> = places.map(place).collect();
        let corner = |start: f64, outer: fn(f64, f64) -> f64| {
            places.iter().fold([start; 3], |corner, place| {
                let [[a, b, c], [x, y, z]] = [corner, place.point];
                [outer(a, x), outer(b, y), outer(c, z)]
            })
        };
        let bounds = [corner(f64::INFINITY, f64::min), corner(f64::NEG_INFINITY, f64::max)];
        Ok(Edge { places, bounds })
    }

    /// The size of the box around the edge.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let [low, high] = self.bounds;
        distance(low, high)
    }

    /// The first point and the last; none if nothing was sampled.
    #[must_use]
    pub(super) fn ends(&self) -> [Option<Vector>; 2] {
        [self.places.first(), self.places.last()].map(|place| place.map(|place| place.point))
    }

    /// Whether `point` lies in the box around the edge, or beside it by no more than `gap`.
    pub(super) fn surrounds(&self, point: Vector, gap: f64) -> bool {
        let [low, high] = self.bounds;
        let is_between = |((x, low), high): ((&f64, f64), f64)| (low - gap..=high + gap).contains(x);
        point.iter().zip(low).zip(high).all(is_between)
    }

    /// Where the straight segments between the samples come nearest to `point`, as a share of the edge.
    pub(super) fn nearest_share(&self, point: Vector) -> f64 {
        let segments = self.places.windows(2).enumerate().filter_map(|(index, pair)| {
            let [a, b] = pair else { return None };
            let (along, away) = (difference(b.point, a.point), difference(point, a.point));
            let square = dot(along, along);
            let share = if square > 0.0 { (dot(along, away) / square).clamp(0.0, 1.0) } else { 0.0 };
            let left = [0, 1, 2].map(|axis| {
                let of = |vector: Vector| vector.get(axis).copied().unwrap_or(f64::NAN);
                of(away) - share * of(along)
            });
            Some((dot(left, left), index as f64 + share))
        });
        let nearest = segments.min_by(|(one, _), (other, _)| one.total_cmp(other));
        nearest.map_or(0.0, |(_, at)| at / (self.places.len().max(2) - 1) as f64)
    }

    /// Whether the ends and a place between them are no farther apart than `gap` in one of both directions: what
    /// [`Edge::meet`] may find to meet, at a fraction of the cost.
    #[must_use]
    pub fn may_meet(&self, other: &Edge, gap: f64) -> bool {
        let count = self.places.len();
        let chosen = [0, count / 3, count.saturating_sub(1)];
        let is_near = |place: usize, opposite: usize| {
            let points = self.places.get(place).zip(other.places.get(opposite));
            points.is_some_and(|(a, b)| distance(a.point, b.point) <= gap)
        };
        chosen.iter().all(|place| is_near(*place, *place))
            || chosen.iter().all(|place| is_near(*place, count.saturating_sub(1 + place)))
    }

    /// How the edges meet when both run the same way, or in opposite ways: the better of the two.
    #[must_use]
    pub fn meet(&self, other: &Edge) -> SeamDeviation {
        let (along, against) = (self.compare(other.places.iter()), self.compare(other.places.iter().rev()));
        if against.gap < along.gap { against } else { along }
    }

    /// The distance from the other edge at evenly spaced places along this one, and from this one along the other: both run
    /// as in [`Edge::meet`].
    #[must_use]
    pub fn gaps(&self, other: &Edge) -> [Vec<f64>; 2] {
        let distances = |places: &mut dyn Iterator<Item = &Place>| -> Vec<f64> {
            self.places.iter().zip(places).map(|(a, b)| distance(a.point, b.point)).collect()
        };
        let largest = |gaps: &[f64]| gaps.iter().fold(0.0_f64, |most, gap| most.max(*gap));
        let along = distances(&mut other.places.iter());
        let against = distances(&mut other.places.iter().rev());
        if largest(&against) < largest(&along) {
            let reversed = against.iter().rev().copied().collect();
            [against, reversed]
        } else {
            [along.clone(), along]
        }
    }

    fn compare<'a>(&self, other: impl Iterator<Item = &'a Place>) -> SeamDeviation {
        let mut worst = SeamDeviation { gap: 0.0, angle_degrees: None };
        for (a, b) in self.places.iter().zip(other) {
            let gap = distance(a.point, b.point);
            worst.gap = if gap.is_nan() { f64::INFINITY } else { worst.gap.max(gap) };
            worst.angle_degrees = worse(worst.angle_degrees, a.angle(b));
        }
        worst
    }
}

impl Place {
    fn angle(&self, other: &Place) -> Option<f64> {
        let (of_a, of_b) = self.normal.zip(other.normal)?;
        match (self.outward, other.outward) {
            (Some(a), Some(b)) => turn_degrees(a, b, self.along),
            _ => Some(angle_degrees(of_a, of_b)),
        }
    }
}

impl SeamDeviation {
    /// The worse of two measurements of one seam, for example at two instants.
    #[must_use]
    pub fn worst(self, other: &SeamDeviation) -> SeamDeviation {
        SeamDeviation { gap: self.gap.max(other.gap), angle_degrees: worse(self.angle_degrees, other.angle_degrees) }
    }
}
