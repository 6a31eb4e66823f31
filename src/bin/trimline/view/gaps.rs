//! How far apart things are that should meet, along every edge, for colouring: the surface and its prescribed positions,
//! patches and their neighbours, the two ends of a patch in v.

use serde::Serialize;

use trimline::expr::{Derivative, Variable};
use trimline::numeric::{NodeKind, nodes};
use trimline::verify::boundary_gaps;

use super::live::{Answerable, Live};
use super::pieces::{Of, Piece};
use super::server::Question;
use crate::failure::Failure;
use crate::parts::Located;
use crate::seams;

/// Places along an edge.
const PLACES: usize = 97;

/// The gaps of every patch.
#[derive(Serialize)]
pub struct Gaps {
    patches: Vec<Edges>,
}

#[derive(Serialize)]
struct Edges {
    /// Between the surface and the positions it was asked to have.
    boundary: Vec<Along>,
    /// Between the patch and another, or its own other end.
    seams: Vec<Along>,
}

/// Distances at evenly spaced places along a line of constant u or of constant v, both ends included.
#[derive(Serialize)]
struct Along {
    across: &'static str,
    at: f64,
    values: Vec<f64>,
}

/// The gaps at the page's instant and values.
pub fn of(live: &Live, question: &Question) -> Result<Gaps, Failure> {
    live.answer_with(&question.changes, question.time, |answerable| {
        let mut patches = Vec::with_capacity(answerable.pieces.len());
        for piece in &answerable.pieces {
            patches.push(Edges { boundary: boundary(answerable, piece)?, seams: closing(answerable, piece)? });
        }
        for seam in super::answer::seams(answerable)? {
            // Half a side of a neighbour is coloured on the patch whose whole side it is.
            for (place, values) in seam.along.into_iter().filter(|(place, _)| place.is_whole()) {
                if let Some(edges) = patches.get_mut(place.patch) {
                    edges.seams.push(Along { across: place.across.name(), at: place.position, values });
                }
            }
        }
        Ok(Gaps { patches })
    })
}

/// A copy misses what its original misses; a net has no prescribed positions but its control points.
fn boundary(answerable: &Answerable<'_>, piece: &Piece<'_>) -> Result<Vec<Along>, Failure> {
    let Of::Patch(patched, solved) = piece.of else { return Ok(Vec::new()) };
    let (spec, prepared) = (answerable.spec, &patched.prepared);
    let at = (&spec.bindings, &prepared.domain, solved.time);
    let surface = &*solved.solution.surface;
    let gaps = boundary_gaps(&spec.problem, prepared.patch(), surface, at, PLACES);
    let gaps = gaps.map_err(|finding| spec.fault(finding))?.into_iter();
    Ok(gaps.map(|gap| Along { across: gap.across.name(), at: gap.at, values: gap.distances }).collect())
}

/// The ends of v, if the part is meant to close on itself: if they are nearer to each other than the surface is large.
fn closing(answerable: &Answerable<'_>, piece: &Piece<'_>) -> Result<Vec<Along>, Failure> {
    let domain = piece.domain();
    let u = nodes(NodeKind::Ends, PLACES, domain.u);
    let mut points = vec![[0.0; 3]; 2 * u.len()];
    let grid = (u.as_slice(), domain.v.as_slice(), answerable.time);
    let evaluated = piece.surface.evaluate_grid(Derivative::NONE, grid, &mut points);
    evaluated.map_err(|finding| answerable.spec.fault(finding))?;
    let ends = |pair: &[[f64; 3]]| match pair {
        [[a, b, c], [x, y, z]] => (a - x).hypot(b - y).hypot(c - z),
        _ => f64::NAN,
    };
    let values: Vec<f64> = points.chunks(2).map(ends).collect();
    let is_near = values.iter().all(|gap| *gap <= seams::NEAR * piece.of.size());
    let along = |at| Along { across: Variable::V.name(), at, values: values.clone() };
    Ok(if is_near { domain.v.map(along).into() } else { Vec::new() })
}
