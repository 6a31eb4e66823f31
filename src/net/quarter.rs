//! Four patches inside four boundary curves, smooth across the seams between them.

use super::{Filled, at, combine, difference, fill, sum};
use crate::diagnostic::{Code, Diagnostic};
use crate::surface::{BsplineCurve, KnotVector};

/// Four boundary curves of a four-sided region: two run in u, over equal knots, and two in v.
#[derive(Debug, Clone)]
pub struct Outline {
    /// The curve at the start and the one at the end of v, running in u.
    pub along_u: [BsplineCurve; 2],
    /// The curve at the start and the one at the end of u, running in v.
    pub along_v: [BsplineCurve; 2],
}

/// A cubic knot vector split in two at a seam.
struct Halves {
    /// Clamped, before and behind the seam.
    knots: [KnotVector; 2],
    /// The number of the seam's control point.
    seam: usize,
    /// The number of the last control point.
    last: usize,
    /// What the points before and behind the seam have of the point on it, for equal derivatives.
    shares: [f64; 2],
    /// Where each control point of the split curve acts most, from 0 to 1.
    greville: Vec<f64>,
    /// The control points of both curves, split.
    curves: [Vec<[f64; 3]>; 2],
}

/// The control point beside a seam, from its numbers and its place in the Coons surface.
pub type Handle<'a> = &'a dyn Fn(usize, usize, [f64; 3]) -> [f64; 3];

/// Fills the region inside `outline` with four patches that meet at the parameters `split` of u and v: on the given
/// curves to rounding, with equal tangents across all seams (C1), each a solution of `∂⁶S/∂u³∂v³ = 0`.
///
/// Order: for the first half of u, both halves of v; then for the second.
///
/// The equation leaves the control points beside the seams open. `beside` makes each from its numbers in u and v, counted
/// over both halves, and its place in the bilinear Coons surface of the outline. That surface satisfies the equation:
/// with all places left as they are, the patches are it. Each patch has its two known layers at the seams, one on the
/// outline.
///
/// # Errors
/// [`Code::CurvesDoNotMeet`] when opposite curves have different knots or corners are apart;
/// [`Code::PointOutsideDomain`] for a split outside; those of [`fill`].
pub fn quarter(outline: &Outline, split: [f64; 2], beside: Handle<'_>) -> Result<[Filled; 4], Diagnostic> {
    let [split_u, split_v] = split;
    let u = halves(&outline.along_u, split_u, "u")?;
    let v = halves(&outline.along_v, split_v, "v")?;
    check_corners(&u.curves, &v.curves)?;
    let net = seam_net(&u, &v, beside);
    let quadrant = |half_u: usize, half_v: usize| {
        let (rows, columns) = (u.indices(half_u), v.indices(half_v));
        // From the seams outwards: the two known layers of a patch are the first two.
        let turned = |knots: &KnotVector, half: usize| if half == 0 { knots.reversed() } else { knots.clone() };
        let points: Vec<[f64; 3]> = rows
            .iter()
            .flat_map(|i| columns.iter().map(move |j| (i, j)))
            .map(|(i, j)| at(&net, i * (v.last + 1) + j))
            .collect();
        let mut filled = fill(&turned(u.half(half_u), half_u), &turned(v.half(half_v), half_v), &points)?;
        if half_u == 0 {
            filled.surface = filled.surface.reversed_u();
        }
        if half_v == 0 {
            filled.surface = filled.surface.reversed_v();
        }
        Ok(filled)
    };
    Ok([quadrant(0, 0)?, quadrant(0, 1)?, quadrant(1, 0)?, quadrant(1, 1)?])
}

impl Halves {
    fn half(&self, half: usize) -> &KnotVector {
        let [before, behind] = &self.knots;
        if half == 0 { before } else { behind }
    }

    /// The numbers of a half's control points, from the seam outwards.
    fn indices(&self, half: usize) -> Vec<usize> {
        if half == 0 { (0..=self.seam).rev().collect() } else { (self.seam..=self.last).collect() }
    }

    fn is_beside_seam(&self, index: usize) -> bool {
        index + 1 == self.seam || index == self.seam + 1
    }
}

/// The halves of a direction and of its two curves.
fn halves(curves: &[BsplineCurve; 2], split: f64, name: &str) -> Result<Halves, Diagnostic> {
    let [low, high] = curves;
    if low.knots() != high.knots() {
        let message = format!("the two boundary curves along {name} have different knots");
        return Err(Diagnostic::new(Code::CurvesDoNotMeet, message).hint("insert the knots of each into the other"));
    }
    let [before, behind] = low.split(split)?;
    let [other_before, other_behind] = high.split(split)?;
    let joined = |before: &BsplineCurve, behind: &BsplineCurve| -> Vec<[f64; 3]> {
        before.points().iter().chain(behind.points().iter().skip(1)).copied().collect()
    };
    let curves = [joined(&before, &behind), joined(&other_before, &other_behind)];
    let seam = before.points().len() - 1;
    let last = seam + behind.points().len() - 1;
    let steps = [last_span(before.knots()), last_span(&behind.knots().reversed())];
    let [step, next_step] = steps;
    let shares = [next_step / (step + next_step), step / (step + next_step)];
    let [start, end] = low.knots().domain();
    let places = before.knots().greville().into_iter().chain(behind.knots().greville().into_iter().skip(1));
    let greville = places.map(|x| (x - start) / (end - start)).collect();
    let knots = [before.knots().clone(), behind.knots().clone()];
    Ok(Halves { knots, seam, last, shares, greville, curves })
}

/// The length of the last span.
pub(super) fn last_span(knots: &KnotVector) -> f64 {
    match knots.breakpoints().as_slice() {
        [.., before, last] => last - before,
        _ => f64::NAN,
    }
}

/// Corners may differ by the rounding of knot insertion.
const LARGEST_CORNER_GAP: f64 = 1e-12;

fn check_corners(along_u: &[Vec<[f64; 3]>; 2], along_v: &[Vec<[f64; 3]>; 2]) -> Result<(), Diagnostic> {
    let all = along_u.iter().chain(along_v).flatten().flatten();
    let size = all.fold(0.0_f64, |most, x| most.max(x.abs()));
    for (in_u, u_end) in along_v.iter().zip(["start", "end"]) {
        for (in_v, v_end) in along_u.iter().zip(["start", "end"]) {
            let corner =
                |points: &[[f64; 3]], end: &str| if end == "start" { points.first() } else { points.last() }.copied();
            let (Some(p), Some(q)) = (corner(in_u, v_end), corner(in_v, u_end)) else { continue };
            let gap = difference(&p, &q).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            if gap > LARGEST_CORNER_GAP * size {
                let message =
                    format!("at the {u_end} of u and the {v_end} of v the boundary curves are {gap:.1e} apart");
                return Err(Diagnostic::new(Code::CurvesDoNotMeet, message).hint(
                    "curves along u end where those along v begin or end; reverse a curve that runs the other way",
                ));
            }
        }
    }
    Ok(())
}

/// The net of all four patches, row after row, with the outline and the three lines along each seam in place.
fn seam_net(u: &Halves, v: &Halves, handle: Handle) -> Vec<[f64; 3]> {
    let [south, north] = &u.curves;
    let [west, east] = &v.curves;
    let outer = |i: usize, j: usize| match (i, j) {
        (_, 0) => Some(at(south, i)),
        (_, j) if j == v.last => Some(at(north, i)),
        (0, _) => Some(at(west, j)),
        (i, _) if i == u.last => Some(at(east, j)),
        _ => None,
    };
    let coons = |i: usize, j: usize| {
        let (s, t) = (u.greville.get(i).copied().unwrap_or(0.0), v.greville.get(j).copied().unwrap_or(0.0));
        let between = |share: f64, p: [f64; 3], q: [f64; 3]| combine([1.0 - share, share, 0.0], [p, q, [0.0; 3]]);
        let across = between(s, at(west, j), at(east, j));
        let along = between(t, at(south, i), at(north, i));
        let corners =
            between(t, between(s, at(south, 0), at(south, u.last)), between(s, at(north, 0), at(north, u.last)));
        difference(&sum(&across, &along), &corners)
    };
    let beside = |i: usize, j: usize| outer(i, j).unwrap_or_else(|| handle(i, j, coons(i, j)));
    // On a seam: where both tangents agree.
    let [share_before, share_behind] = u.shares;
    let on_u_seam = |j: usize| {
        let points = [beside(u.seam - 1, j), beside(u.seam + 1, j), [0.0; 3]];
        outer(u.seam, j).unwrap_or_else(|| combine([share_before, share_behind, 0.0], points))
    };
    let [share_below, share_above] = v.shares;
    let on_v_seam =
        |below: [f64; 3], above: [f64; 3]| combine([share_below, share_above, 0.0], [below, above, [0.0; 3]]);
    let mut net = Vec::with_capacity((u.last + 1) * (v.last + 1));
    for i in 0..=u.last {
        for j in 0..=v.last {
            net.push(match outer(i, j) {
                Some(point) => point,
                None if i == u.seam && j == v.seam => on_v_seam(on_u_seam(v.seam - 1), on_u_seam(v.seam + 1)),
                None if i == u.seam => on_u_seam(j),
                None if j == v.seam => on_v_seam(beside(i, v.seam - 1), beside(i, v.seam + 1)),
                None if u.is_beside_seam(i) || v.is_beside_seam(j) => beside(i, j),
                // Inside a patch: filled later.
                None => [0.0; 3],
            });
        }
    }
    net
}
