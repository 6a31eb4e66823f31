//! A loop of edges becomes one four-sided patch for each corner, joined smoothly along seams from the middles of the
//! edges to a centre (docs/methods.md, M2 to M6).

use super::loops::EdgeLoop;
use super::vector::{End, Vector, at, combination, hermite, scaled, slope, sum};
use crate::diagnostic::Diagnostic;
use crate::expr::{ExprId, Graph, Number, Variable};
use crate::limits::Limits;
use crate::problem::{BoundaryCondition, Domain, Patch, SideCondition};

/// What the patches of a loop share, as functions of v from 0 at the edge to 1 in the centre.
struct Seams {
    /// The curve s_k.
    curves: Vec<Vector>,
    /// s_k'
    slopes: Vec<Vector>,
    /// W_k, half the difference of the tangents across the seam.
    turns: Vec<Vector>,
    /// The factor γ of the seam's own slope in the sum of those tangents.
    share: ExprId,
}

/// The middle of one edge.
struct Middle {
    point: Vector,
    /// Along the edge.
    along: Vector,
    /// Across the edge, and how it changes along the edge.
    across: Vector,
    turning: Vector,
}

pub fn split(
    edges: &EdgeLoop,
    across: &[Vector],
    graph: &mut Graph,
    limits: &Limits,
) -> Result<Vec<Patch>, Diagnostic> {
    let count = edges.edges.len();
    let half = fraction(1, 2);
    // A patch runs over half an edge, so its tangents are half those of the edge, in both directions.
    let across: Vec<Vector> = across.iter().map(|vector| combination(graph, &[(half, *vector)])).collect();
    let seams = seams(edges, &across, graph, limits)?;
    let (u, v, one) = (graph.variable(Variable::U), graph.variable(Variable::V), graph.integer(1));
    let first_half = graph.scale(half, u);
    let second_half = {
        let back = graph.scale(half, v);
        graph.difference(one, back)
    };
    let (zero, domain) = (graph.integer(0), unit_square(graph, edges));
    let mut patches = Vec::with_capacity(count);
    for (index, (edge, own)) in edges.edges.iter().zip(&across).enumerate() {
        let before = (index + count - 1) % count;
        let (Some(previous), Some(previous_across)) = (edges.edges.get(before), across.get(before)) else { continue };
        let at_u = [
            (zero, at(graph, previous.curve, Variable::U, second_half), previous.origin),
            (zero, at(graph, *previous_across, Variable::U, second_half), previous.origin),
            (one, seams.curve(index), edge.origin),
            (one, seams.across(graph, index, 1), edge.origin),
        ];
        let seam =
            [seams.curve(before), seams.across(graph, before, -1)].map(|vector| at(graph, vector, Variable::V, u));
        let at_v = [
            (zero, at(graph, edge.curve, Variable::U, first_half), edge.origin),
            (zero, at(graph, *own, Variable::U, first_half), edge.origin),
            (one, seam[0], previous.origin),
            (one, seam[1], previous.origin),
        ];
        let orders = [0, 1, 0, 1].into_iter();
        let conditions = at_u.into_iter().zip(orders.clone()).map(|((u, value, origin), order)| BoundaryCondition {
            u,
            order,
            value,
            origins: [origin; 3],
        });
        let side_conditions = at_v.into_iter().zip(orders).map(|((v, value, origin), order)| SideCondition {
            v,
            order,
            value,
            origins: [origin; 3],
        });
        patches.push(Patch {
            joins: Vec::new(),
            name: format!("{}.{}", edges.name, index + 1),
            domain: domain.clone(),
            operator: edges.operator.clone(),
            conditions: conditions.collect(),
            side_conditions: side_conditions.collect(),
            is_of_loop: true,
            deformations: Vec::new(),
            solve: edges.solve.clone(),
        });
    }
    Ok(patches)
}

impl Seams {
    fn curve(&self, index: usize) -> Vector {
        self.curves.get(index).copied().unwrap_or([self.share; 3])
    }

    /// The tangent across seam `index`, `γ s'/2 ± W`: + for the patch before the seam, - for the one after it (M4).
    fn across(&self, graph: &mut Graph, index: usize, sign: i64) -> Vector {
        let (Some(slope), Some(turn)) = (self.slopes.get(index), self.turns.get(index)) else { return [self.share; 3] };
        let shared = scaled(graph, self.share, *slope);
        combination(graph, &[(fraction(1, 2), shared), (Number::integer(sign), *turn)])
    }
}

/// Seams that satisfy M3 to M6.
fn seams(edges: &EdgeLoop, across: &[Vector], graph: &mut Graph, limits: &Limits) -> Result<Seams, Diagnostic> {
    let count = edges.edges.len();
    let middles = middles(edges, across, graph, limits)?;
    let (one, half) = (Number::integer(1), fraction(1, 2));
    let centre = edges.centre.unwrap_or_else(|| {
        // Each middle, carried on by half the tangent across the edge.
        let weight = |share: Number| number(share.to_f64() / count as f64);
        let terms: Vec<_> =
            middles.iter().flat_map(|middle| [(weight(one), middle.point), (weight(half), middle.across)]).collect();
        combination(graph, &terms)
    });
    // The slopes in the centre lie in one plane: a_k = 2/n Σ_j cos(2π(k - j)/n) (c - m_j).
    let mut arrivals = Vec::with_capacity(count);
    for k in 0..count {
        let terms: Vec<_> = middles
            .iter()
            .enumerate()
            .flat_map(|(j, middle)| {
                let weight = 2.0 / count as f64 * cosine(k.abs_diff(j), count);
                [(number(weight), centre), (number(-weight), middle.point)]
            })
            .collect();
        arrivals.push(combination(graph, &terms));
    }
    let v = graph.variable(Variable::V);
    let g = 2.0 * cosine(1, count);
    // γ(v) = g (3v² - 2v³)
    let (squared, cubed) = (graph.power_integer(v, 2), graph.power_integer(v, 3));
    let share = [graph.scale(number(3.0 * g), squared), graph.scale(number(-2.0 * g), cubed)];
    let share = graph.sum(share);
    // g s_k''(1) = g (6 m_k + 2 s_k'(0) - 6 c + 4 a_k)
    let bends: Vec<Vector> = middles
        .iter()
        .zip(&arrivals)
        .map(|(middle, arrival)| {
            let parts = [(6.0, middle.point), (2.0, middle.across), (-6.0, centre), (4.0, *arrival)];
            combination(graph, &parts.map(|(factor, vector)| (number(g * factor), vector)))
        })
        .collect();
    let weights = twist_weights(count);
    let twists: Vec<Vector> = weights
        .iter()
        .map(|row| {
            let terms: Vec<_> = row.iter().zip(&bends).map(|(weight, bend)| (number(*weight), *bend)).collect();
            combination(graph, &terms)
        })
        .collect();
    let around = |all: &[Vector], index: usize| all.get(index % count).copied().unwrap_or(centre);
    let (mut curves, mut slopes, mut turns) = (Vec::new(), Vec::new(), Vec::new());
    for (k, middle) in middles.iter().enumerate() {
        let start = End { position: middle.point, slope: middle.across };
        let mut curve = hermite(graph, v, start, End { position: centre, slope: around(&arrivals, k) });
        if let Some(bulge) = bulge(graph, &bends, k, g) {
            curve = sum(graph, curve, bulge);
        }
        slopes.push(slope(graph, curve, Variable::V, limits, None)?);
        curves.push(curve);
        let half_of = |graph: &mut Graph, vector| combination(graph, &[(half, vector)]);
        let start = End { position: half_of(graph, middle.along), slope: half_of(graph, middle.turning) };
        let difference = |graph: &mut Graph, a, b| combination(graph, &[(half, a), (number(-0.5), b)]);
        let end = End {
            position: difference(graph, around(&arrivals, k + count - 1), around(&arrivals, k + 1)),
            slope: difference(graph, around(&twists, k), around(&twists, k + 1)),
        };
        turns.push(hermite(graph, v, start, end));
    }
    Ok(Seams { curves, slopes, turns, share })
}

/// The middles of the edges.
fn middles(edges: &EdgeLoop, across: &[Vector], graph: &mut Graph, limits: &Limits) -> Result<Vec<Middle>, Diagnostic> {
    let half = graph.number(fraction(1, 2));
    let mut all = Vec::with_capacity(across.len());
    for (edge, across) in edges.edges.iter().zip(across) {
        let along = slope(graph, edge.curve, Variable::U, limits, edge.origin)?;
        let turning = slope(graph, *across, Variable::U, limits, edge.origin)?;
        let [point, along, across, turning] =
            [edge.curve, along, *across, turning].map(|vector| at(graph, vector, Variable::U, half));
        all.push(Middle { point, along, across, turning });
    }
    Ok(all)
}

/// The weights with which the bends r_k of the seams make the twists T_k in the centre: T_k + T_(k+1) = r_k (M5).
///
/// For an even number the bends must have an alternating sum of zero, which [`bulge`] provides; of all solutions the one
/// without an alternating part is taken.
fn twist_weights(count: usize) -> Vec<Vec<f64>> {
    let total = count as f64;
    let weight = |k: usize, j: usize| {
        if count % 2 == 1 {
            return 0.5 * alternating_sign((j + count - k) % count);
        }
        // Solution for bends with the alternating sum ρ taken out: Σ_j w_j (r_j - (-1)^j ρ/n).
        let plain = |j: usize| {
            let before = if j < k { 1.0 } else { 0.0 };
            alternating_sign(k) * alternating_sign(j) * ((count - 1 - j) as f64 / total - before)
        };
        let of_alternating: f64 = (0..count).map(|i| plain(i) * alternating_sign(i)).sum();
        plain(j) - of_alternating * alternating_sign(j) / total
    };
    (0..count).map(|k| (0..count).map(|j| weight(k, j)).collect()).collect()
}

/// What is added to seam k of an even number so that twists exist: `q_k/2 v² (1 - v)²` (M6); nothing if they do anyway.
fn bulge(graph: &mut Graph, bends: &[Vector], k: usize, g: f64) -> Option<Vector> {
    let count = bends.len();
    if count % 2 == 1 || g == 0.0 {
        return None;
    }
    let factor = -0.5 * alternating_sign(k) / (count as f64 * g);
    let terms: Vec<_> =
        bends.iter().enumerate().map(|(j, bend)| (number(factor * alternating_sign(j)), *bend)).collect();
    let amplitude = combination(graph, &terms);
    let (v, one) = (graph.variable(Variable::V), graph.integer(1));
    let rest = graph.difference(one, v);
    let shape = [graph.power_integer(v, 2), graph.power_integer(rest, 2)];
    let shape = graph.product(shape);
    Some(scaled(graph, shape, amplitude))
}

/// (-1)^index
fn alternating_sign(index: usize) -> f64 {
    if index.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// u and v in [0, 1], and the loop's own range of t.
fn unit_square(graph: &mut Graph, edges: &EdgeLoop) -> Domain {
    let unit = [graph.integer(0), graph.integer(1)];
    Domain { ends: [unit, unit, edges.time], origins: [None; 3] }
}

/// cos(2πk/n), exact where it is 0, ±1/2 or ±1: n = 4 has no share γ at all.
fn cosine(k: usize, n: usize) -> f64 {
    if (12 * k).is_multiple_of(n) {
        match 12 * k / n % 12 {
            0 => return 1.0,
            2 | 10 => return 0.5,
            3 | 9 => return 0.0,
            4 | 8 => return -0.5,
            6 => return -1.0,
            _ => {}
        }
    }
    libm::cos(std::f64::consts::TAU * k as f64 / n as f64)
}

fn fraction(numerator: i64, denominator: i64) -> Number {
    Number::fraction(numerator, denominator).unwrap_or(Number::integer(0))
}

/// The number behind a finite double.
fn number(value: f64) -> Number {
    Number::from_f64(value).unwrap_or(Number::integer(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twists_of_any_number_of_seams_add_up_to_their_bends() {
        for count in 3..=12 {
            let weights = twist_weights(count);
            let bends: Vec<f64> = (0..count).map(|k| libm::sin(1.0 + 2.0 * k as f64)).collect();
            let alternating = bends.iter().enumerate().map(|(k, r)| if k % 2 == 0 { *r } else { -r }).sum::<f64>();
            for k in 0..count {
                let twist = |k: usize| -> f64 { weights[k % count].iter().zip(&bends).map(|(w, r)| w * r).sum() };
                let excess = if count % 2 == 1 { 0.0 } else { alternating / count as f64 };
                let expected = bends[k] - if k % 2 == 0 { excess } else { -excess };
                // A dozen terms below 1.
                assert!((twist(k) + twist(k + 1) - expected).abs() < 1e-14, "{count} {k}");
            }
        }
    }

    #[test]
    fn cosines_of_simple_angles_are_exact() {
        let found = [(1, 4), (1, 3), (1, 6), (3, 6), (2, 12), (3, 12), (5, 10)].map(|(k, n)| cosine(k, n));
        assert_eq!(found, [0.0, -0.5, 0.5, -1.0, 0.5, 0.0, -1.0]);
    }
}
