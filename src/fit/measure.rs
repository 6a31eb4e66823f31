//! Distances between a surface and its fit, and whether a surface closes.

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::numeric::{NodeKind, nodes};
use crate::surface::{BsplineSurface, Surface};

use super::Target;

/// Gauss points in each span: none is a node.
const POINTS_PER_SPAN: usize = 5;

/// Spans are looked at in parts no longer than one of so many equal ones of the range: what the first knots pass over is
/// seen all the same.
const LOOKS: usize = 16;

/// One round divides a span into this many at most: an error estimate on coarse spans is not to be trusted further.
const MOST_PIECES: f64 = 8.0;

/// How far a fit is from its target.
#[derive(Default)]
pub(super) struct Measured {
    pub deviation: f64,
    pub edge: f64,
    pub tangent: f64,
    /// Errors of interpolation in u alone, by span: on lines of v where nothing else is interpolated away.
    spans_u: Vec<f64>,
    spans_v: Vec<f64>,
    /// Errors by cell, those of one span of u together.
    cells: Vec<f64>,
}

/// One direction of a fit and of the places where it is measured.
pub(super) struct Axis {
    /// Where the spline interpolates.
    nodes: Vec<f64>,
    /// Both ends, and Gauss points between.
    tests: Vec<f64>,
    /// The span in which each of `tests` lies.
    span_of: Vec<usize>,
    spans: usize,
}

impl Axis {
    /// A direction with these breakpoints and nodes, whose target has pieces that meet at `breaks`.
    pub fn new(breakpoints: &[f64], nodes_at: Vec<f64>, breaks: &[f64]) -> Axis {
        let (Some(&low), Some(&high)) = (breakpoints.first(), breakpoints.last()) else {
            return Axis { nodes: nodes_at, tests: Vec::new(), span_of: Vec::new(), spans: 0 };
        };
        // Breaks may be closer together than breakpoints are, and are looked between all the same.
        let looks = nodes(NodeKind::Ends, LOOKS + 1, [low, high]);
        let mut parts = [breakpoints, breaks, &looks].concat();
        parts.sort_by(f64::total_cmp);
        // What is equal but for rounding makes no part.
        let rounding = 16.0 * f64::EPSILON * low.abs().max(high.abs());
        parts.dedup_by(|next, kept| *next - *kept <= rounding);
        let inner = parts.windows(2).flat_map(|part| match part {
            [a, b] => nodes(NodeKind::Gauss, POINTS_PER_SPAN, [*a, *b]),
            _ => Vec::new(),
        });
        let tests: Vec<f64> = std::iter::once(low).chain(inner).chain([high]).collect();
        let spans = breakpoints.len() - 1;
        let span_of = |at: &f64| breakpoints.partition_point(|breakpoint| breakpoint <= at).clamp(1, spans.max(1)) - 1;
        Axis { span_of: tests.iter().map(span_of).collect(), nodes: nodes_at, tests, spans }
    }
}

impl Measured {
    /// Points that are evaluated.
    pub fn samples([in_u, in_v]: [&Axis; 2]) -> usize {
        in_u.tests.len().saturating_mul(in_v.tests.len())
    }

    pub fn new(
        target: &Target,
        fitted: &BsplineSurface,
        [in_u, in_v]: [&Axis; 2],
        t: f64,
    ) -> Result<Measured, Diagnostic> {
        let gaps = |derivative: Derivative, u: &[f64], v: &[f64]| gaps(target.surface, fitted, derivative, (u, v, t));
        let largest = |gaps: Vec<f64>| gaps.into_iter().fold(0.0, larger);
        let tangent = Derivative::new(1, 0, 0);
        // On nodes of v the fit is interpolation in u alone, and the other way round.
        let mut measured = Measured {
            spans_u: vec![0.0; in_u.spans],
            spans_v: vec![0.0; in_v.spans],
            cells: vec![0.0; in_u.spans * in_v.spans],
            edge: largest(gaps(Derivative::NONE, &target.u, &in_v.tests)?),
            tangent: largest(gaps(tangent, &target.u, &in_v.tests)?),
            deviation: 0.0,
        };
        let by_u = gaps(Derivative::NONE, &in_u.tests, &in_v.nodes)?;
        for (row, span) in by_u.chunks(in_v.nodes.len().max(1)).zip(&in_u.span_of) {
            row.iter().for_each(|gap| raise(measured.spans_u.get_mut(*span), *gap));
        }
        let by_v = gaps(Derivative::NONE, &in_u.nodes, &in_v.tests)?;
        for row in by_v.chunks(in_v.tests.len().max(1)) {
            row.iter().zip(&in_v.span_of).for_each(|(gap, span)| raise(measured.spans_v.get_mut(*span), *gap));
        }
        let inside = gaps(Derivative::NONE, &in_u.tests, &in_v.tests)?;
        for (row, i) in inside.chunks(in_v.tests.len().max(1)).zip(&in_u.span_of) {
            for (gap, j) in row.iter().zip(&in_v.span_of) {
                raise(measured.cells.get_mut(i * in_v.spans + j), *gap);
            }
        }
        measured.deviation = by_u.into_iter().chain(by_v).chain(inside).fold(measured.edge, larger);
        Ok(measured)
    }

    /// Into how many pieces the spans of u and of v are to be divided, so that a spline of degree `degree` comes as close
    /// as `tolerance`.
    pub fn pieces(&self, tolerance: f64, degree: usize) -> [Vec<usize>; 2] {
        // The errors of both directions add up.
        let goal = 0.4 * tolerance;
        // Written so that what is not finite is divided as far as may be.
        let pieces = |error: f64, allowed: f64| {
            if error <= allowed {
                return 1;
            }
            libm::pow(error / goal, 1.0 / (degree as f64 + 1.0)).ceil().clamp(2.0, MOST_PIECES) as usize
        };
        let of_spans = |errors: &[f64]| errors.iter().map(|error| pieces(*error, goal)).collect::<Vec<usize>>();
        let [mut in_u, mut in_v] = [of_spans(&self.spans_u), of_spans(&self.spans_v)];
        let (along_u, along_v) = (in_u.clone(), in_v.clone());
        for (i, (row, own)) in self.cells.chunks(self.spans_v.len().max(1)).zip(&along_u).enumerate() {
            for (j, (error, other)) in row.iter().zip(&along_v).enumerate() {
                // What lies between the nodes of both directions, neither shows.
                if *own == 1 && *other == 1 {
                    let needed = pieces(*error, tolerance);
                    for slot in in_u.get_mut(i).into_iter().chain(in_v.get_mut(j)) {
                        *slot = needed.max(*slot);
                    }
                }
            }
        }
        [in_u, in_v]
    }
}

fn raise(most: Option<&mut f64>, gap: f64) {
    if let Some(most) = most {
        *most = larger(*most, gap);
    }
}

/// The larger, and NaN if there is one: a distance that is none must not pass.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

fn gaps(
    target: &dyn Surface,
    fitted: &BsplineSurface,
    derivative: Derivative,
    grid: (&[f64], &[f64], f64),
) -> Result<Vec<f64>, Diagnostic> {
    let (u, v, _) = grid;
    let mut values = [vec![[0.0; 3]; u.len() * v.len()], vec![[0.0; 3]; u.len() * v.len()]];
    let [expected, found] = &mut values;
    target.evaluate_grid(derivative, grid, expected)?;
    fitted.evaluate_grid(derivative, grid, found)?;
    Ok(expected.iter().zip(found.iter()).map(|(p, q)| distance(p, q)).collect())
}

pub(super) fn distance([px, py, pz]: &[f64; 3], [qx, qy, qz]: &[f64; 3]) -> f64 {
    let [x, y, z] = [px - qx, py - qy, pz - qz];
    (x * x + y * y + z * z).sqrt()
}

/// How a surface meets itself at the ends of v.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Seam {
    /// It does not.
    Open,
    /// It closes with so many derivatives in v, the position counted, fewer than a spline of this degree has.
    Kinked(usize),
    /// It closes as smoothly as a spline does.
    Smooth,
}

/// Lines on which a seam is looked at.
const LINES: usize = 9;

/// Relative error that an evaluated position or derivative may carry: 2^16 roundings. sin(k v) over a full turn has an
/// error of k v roundings, and the terms of a solution may be some hundred times larger than their sum.
const EVALUATION_ERROR: f64 = 65536.0 * f64::EPSILON;

/// The seam of a target, its largest extent, and its largest coordinate.
pub(super) fn seam(target: &Target, t: f64, degree: usize) -> Result<(Seam, f64, f64), Diagnostic> {
    let lines = |range: [f64; 2]| -> Vec<f64> {
        let inner = nodes(NodeKind::Gauss, LINES, range);
        range.into_iter().take(1).chain(inner).chain(range.into_iter().skip(1)).collect()
    };
    let (u, v) = (lines(target.u), lines(target.v));
    let mut matched = 0;
    let (mut extent, mut size) = (0.0, 0.0);
    for order in 0..degree {
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        let evaluated = target.surface.evaluate_grid(Derivative::new(0, order, 0), (&u, &v, t), &mut values);
        match evaluated {
            Err(finding) if order < 2 => return Err(finding),
            Err(_) => break,
            Ok(()) => {}
        }
        let largest = values.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let allowed = if order == 0 {
            let first = values.first().copied().unwrap_or_default();
            extent = values.iter().map(|point| distance(point, &first)).fold(0.0, f64::max);
            size = largest;
            EVALUATION_ERROR * extent + 4.0 * f64::EPSILON * size
        } else {
            EVALUATION_ERROR * largest
        };
        let returns = values.chunks(v.len()).all(|row| match (row.first(), row.last()) {
            (Some(first), Some(last)) => distance(first, last) <= allowed,
            _ => false,
        });
        if !returns {
            break;
        }
        matched += 1;
    }
    let seam = match matched {
        0 => Seam::Open,
        _ if matched == degree => Seam::Smooth,
        _ => Seam::Kinked(matched),
    };
    Ok((seam, extent, size))
}
