//! Whether two edges of a loop cross each other.
//!
//! Edges are compared as chains of straight pieces; where pieces cross, shorter ones are taken, so that edges that run close
//! beside each other are not taken for crossing ones. Edges in space that pass each other are left alone, and so are edges
//! that touch at a corner or lie on each other.

use nalgebra::Vector3;

/// A point of an edge, and its place along it.
type Place = (f64, [f64; 3]);

/// An edge, from 0 to 1.
type Curve<'a> = &'a dyn Fn(f64) -> [f64; 3];

/// In a chain.
const PIECES: u32 = 16;

/// How often shorter pieces are taken: the last ones are some ten-thousandths of an edge long.
const REFINEMENTS: usize = 3;

/// The share of an edge at both ends in which it may touch others.
const END: f64 = 1e-3;

/// Directions with a smaller sine between them do not cross.
const PARALLEL: f64 = 1e-6;

/// The chain along a whole edge.
pub fn chain(curve: Curve<'_>) -> Vec<Place> {
    places(curve, [END, 1.0 - END])
}

fn places(curve: Curve<'_>, [low, high]: [f64; 2]) -> Vec<Place> {
    let at = |step: u32| low + (high - low) * f64::from(step) / f64::from(PIECES);
    (0..=PIECES).map(|step| (at(step), curve(at(step)))).collect()
}

/// Whether two edges, given with their chains, cross: their pieces come closer than `close` and are not parallel there.
pub fn cross_over(edges: [Curve<'_>; 2], chains: [&[Place]; 2], close: f64) -> bool {
    crosses(edges, chains, close, REFINEMENTS)
}

fn crosses(edges: [Curve<'_>; 2], [a, b]: [&[Place]; 2], close: f64, refinements: usize) -> bool {
    let pairs = a.array_windows().flat_map(|piece| b.array_windows().map(move |other| [piece, other]));
    pairs.filter(|[piece, other]| pieces_cross(piece, other, close)).any(|pieces| {
        let Some(left) = refinements.checked_sub(1) else { return true };
        let [one, other] = edges;
        let [first, second] = pieces.map(|[(low, _), (high, _)]| {
            // The crossing of the curves may lie beside that of their pieces.
            let beside = high - low;
            [(low - beside).max(END), (high + beside).min(1.0 - END)]
        });
        crosses(edges, [&places(one, first), &places(other, second)], close, left)
    })
}

fn pieces_cross([(_, p), (_, p_end)]: &[Place; 2], [(_, q), (_, q_end)]: &[Place; 2], close: f64) -> bool {
    let [p, p_end, q, q_end] = [p, p_end, q, q_end].map(|point| Vector3::from(*point));
    let (along, other, between) = (p_end - p, q_end - q, q - p);
    let normal = along.cross(&other);
    let square = normal.norm_squared();
    let [share, other_share] = [other, along].map(|direction| between.cross(&direction).dot(&normal) / square);
    // Written so that NaN is no crossing.
    square > PARALLEL * PARALLEL * along.norm_squared() * other.norm_squared()
        && (0.0..=1.0).contains(&share)
        && (0.0..=1.0).contains(&other_share)
        && between.dot(&normal).abs() <= close * square.sqrt()
}
