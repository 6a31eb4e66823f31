//! Judges whether a patch folds back over itself.
//!
//! At a fold the normal turns round between two parts of a patch while `S_u × S_v` shrinks between them. Where a smooth crest
//! of slope s is run over, it shrinks too, to about 1/s; so of stated sides, which may be as slender as they like, only
//! folds count at which it all but vanishes. Loops have seams of their own, and no crests. Where a side is a point, or two
//! sides run on into each other, it is short on one side of the turn as well, and must vanish.

use super::contact::{Vector, cross, dot, length};
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::numeric::{NodeKind, nodes};
use crate::problem::DomainValues;
use crate::surface::Surface;

/// Places in each direction, none of them on a side, which may be a point.
const PLACES: usize = 24;

/// Of the usual length of `S_u × S_v`: what is shorter is zero, or rounding errors, and has no direction.
const NO_NORMAL: f64 = 1e-6;

/// Of the usual length: what is shorter where the normal of a patch of a loop turns round belongs to a fold, and what is
/// longer to a bend. Flat folds reach 0, those of loops in space 0.04. In a part in which nothing is longer sides run on into
/// each other, or are a point: there only a flat fold is one for certain.
const SHRUNK: f64 = 0.1;

/// The same of stated sides: crests of slopes up to 1000 are none.
const ALL_BUT_VANISHED: f64 = 1e-3;

/// Until neighbouring doubles.
const HALVINGS: usize = 52;

/// `S_u`, `S_v` and `S_u × S_v` at u and v.
#[derive(Clone, Copy)]
struct Sample {
    place: [f64; 2],
    tangents: [Vector; 2],
    product: Vector,
}

impl Sample {
    /// Whether the normal turns by more than a right angle between both.
    fn turns_to(&self, other: &Sample) -> bool {
        dot(self.product, other.product) < 0.0
    }

    /// Whether the tangent in direction `axis` does.
    fn tangent_turns_to(&self, other: &Sample, axis: usize) -> bool {
        self.tangents.get(axis).zip(other.tangents.get(axis)).is_some_and(|(a, b)| dot(*a, *b) < 0.0)
    }
}

/// Where a patch with data on four sides folds at instant `t`: u and v of one such place; `None` if its normal turns by less
/// than a right angle between neighbours among 24 x 24 places inside, or only bends there. A patch of a loop of edges is
/// judged more strictly than stated sides.
///
/// # Errors
/// What the surface says when it cannot be evaluated.
pub fn find_fold(
    surface: &dyn Surface,
    (domain, t): (&DomainValues, f64),
    is_of_loop: bool,
) -> Result<Option<[f64; 2]>, Diagnostic> {
    let of_fold = if is_of_loop { SHRUNK } else { ALL_BUT_VANISHED };
    let [u, v] = [domain.u, domain.v].map(|range| nodes(NodeKind::Midpoints, PLACES, range));
    let samples = sample(surface, (&u, &v), t)?;
    let mut lengths: Vec<f64> = samples.iter().map(|sample| length(sample.product)).collect();
    lengths.sort_by(f64::total_cmp);
    let usual = lengths.get(lengths.len() / 2).copied().unwrap_or(0.0);
    // Along v, across which S_u leads, and along u.
    let rows = samples.chunks(PLACES).map(|row| (row.to_vec(), 0));
    let columns = (0..PLACES).map(|column| (samples.iter().skip(column).step_by(PLACES).copied().collect(), 1));
    for (line, across) in rows.chain(columns) {
        let line: Vec<Sample> = line.into_iter().filter(|sample| length(sample.product) > NO_NORMAL * usual).collect();
        let parts: Vec<&[Sample]> = line.chunk_by(|a, b| !a.turns_to(b)).collect();
        let is_broad = |part: &[Sample]| part.iter().any(|sample| length(sample.product) > SHRUNK * usual);
        for (before, behind) in parts.iter().zip(parts.iter().skip(1)) {
            let (Some(a), Some(b)) = (before.last(), behind.first()) else { continue };
            let shrunk = if is_broad(before) && is_broad(behind) { of_fold } else { NO_NORMAL };
            let fold = fold_between(surface, ([*a, *b], across), t, shrunk * usual)?;
            if fold.is_some() {
                return Ok(fold);
            }
        }
    }
    Ok(None)
}

/// Halves the way between two samples, always towards where the normal turns, until it is shorter than `shrunk`, or both
/// halves turn by less than a right angle. Where the tangent `across` turns round, lines shrink to a point and open again, as
/// on a double cone, which is no fold.
fn fold_between(
    surface: &dyn Surface,
    ([mut a, mut b], across): ([Sample; 2], usize),
    t: f64,
    shrunk: f64,
) -> Result<Option<[f64; 2]>, Diagnostic> {
    for _ in 0..HALVINGS {
        let [u, v] = [0, 1].map(|axis| {
            let of = |sample: &Sample| sample.place.get(axis).copied().unwrap_or(f64::NAN);
            0.5 * (of(&a) + of(&b))
        });
        let Some(middle) = sample(surface, (&[u], &[v]), t)?.first().copied() else { break };
        if length(middle.product) < shrunk {
            return Ok((!a.tangent_turns_to(&b, across)).then_some(middle.place));
        }
        match (a.turns_to(&middle), middle.turns_to(&b)) {
            (true, _) => b = middle,
            (_, true) => a = middle,
            _ => break,
        }
    }
    Ok(None)
}

/// `S_u × S_v` at all pairs of `u` and `v`, those of equal u together.
fn sample(surface: &dyn Surface, (u, v): (&[f64], &[f64]), t: f64) -> Result<Vec<Sample>, Diagnostic> {
    let tangents = |orders: Derivative| {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        surface.evaluate_grid(orders, (u, v, t), &mut values).map(|()| values)
    };
    let along_u = tangents(Derivative::new(1, 0, 0))?.into_iter();
    let both = along_u.zip(tangents(Derivative::new(0, 1, 0))?);
    let places = u.iter().flat_map(|u| v.iter().map(|v| [*u, *v]));
    Ok(places.zip(both).map(|(place, (a, b))| Sample { place, tangents: [a, b], product: cross(a, b) }).collect())
}
