//! Knot insertion: the same curve or surface over more knots.

use super::knots::KnotVector;

/// Inserts `x` once. `net` holds the control points, each a row of `width` vectors.
///
/// `x` lies in the domain and stands at most degree times. The new point i is `α P_i + (1 - α) P_(i-1)`,
/// `α = (x - t_i) / (t_(i+p) - t_i)`, where x lies between those knots (Boehm).
fn insert(knots: &KnotVector, net: &[[f64; 3]], width: usize, x: f64) -> (Vec<f64>, Vec<[f64; 3]>) {
    let (degree, line) = (knots.degree(), knots.as_slice());
    let after = line.partition_point(|knot| *knot <= x);
    let mut longer = line.to_vec();
    longer.insert(after, x);
    let mut finer = Vec::with_capacity(net.len() + width);
    let rows: Vec<&[[f64; 3]]> = net.chunks(width).collect();
    for index in 0..=rows.len() {
        let share = match (line.get(index), line.get(index + degree)) {
            (Some(_), Some(end)) if *end <= x => 1.0,
            (Some(start), Some(end)) if *start < x => (x - start) / (end - start),
            _ => 0.0,
        };
        let previous = index.checked_sub(1).and_then(|index| rows.get(index)).copied();
        match (previous, rows.get(index)) {
            (Some(previous), _) if share == 0.0 => finer.extend_from_slice(previous),
            (_, Some(row)) if share == 1.0 => finer.extend_from_slice(row),
            (Some(previous), Some(row)) => {
                let mixed = row.iter().zip(previous).map(|(p, q)| mix(share, p, q));
                finer.extend(mixed);
            }
            _ => {}
        }
    }
    (longer, finer)
}

/// `share p + (1 - share) q`, between both.
fn mix(share: f64, [px, py, pz]: &[f64; 3], [qx, qy, qz]: &[f64; 3]) -> [f64; 3] {
    [(px, qx), (py, qy), (pz, qz)].map(|(p, q)| share * p + (1.0 - share) * q)
}

/// Inserts `x` until it stands `times` times.
///
/// Knots remain a knot vector for up to degree times, which is what callers ask for.
pub(super) fn insert_until(
    knots: KnotVector,
    net: Vec<[f64; 3]>,
    width: usize,
    (x, times): (f64, usize),
) -> (KnotVector, Vec<[f64; 3]>) {
    let (mut knots, mut net) = (knots, net);
    for _ in knots.multiplicity(x)..times {
        let (longer, finer) = insert(&knots, &net, width, x);
        let Ok(longer) = KnotVector::new(knots.degree(), longer) else { break };
        (knots, net) = (longer, finer);
    }
    (knots, net)
}

/// The part of the curve on `[start, end]` of its domain, clamped at both.
pub(super) fn restrict(
    knots: &KnotVector,
    net: &[[f64; 3]],
    width: usize,
    [start, end]: [f64; 2],
) -> (KnotVector, Vec<[f64; 3]>) {
    let degree = knots.degree();
    let (knots, net) = insert_until(knots.clone(), net.to_vec(), width, (start, degree));
    let (knots, net) = insert_until(knots, net, width, (end, degree));
    let line = knots.as_slice();
    // With `start` repeated degree times, the point of that parameter is the one before the last of them.
    let first = line.partition_point(|knot| *knot <= start) - degree - 1;
    let last = line.partition_point(|knot| *knot < end) - 1;
    let inner: Vec<f64> = line.iter().copied().filter(|knot| start < *knot && *knot < end).collect();
    let ends = [start, end].map(|end| vec![end; degree + 1]);
    let [before, behind] = ends;
    let part: Vec<f64> = before.into_iter().chain(inner).chain(behind).collect();
    let rows = net.chunks(width).skip(first).take(last + 1 - first).flatten().copied().collect();
    // An ascending part of a knot vector, clamped, is a knot vector.
    match KnotVector::new(degree, part) {
        Ok(part) => (part, rows),
        Err(_) => (knots, net),
    }
}
