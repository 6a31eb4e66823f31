//! Distances between a surface and its fit, and whether a surface closes.

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::numeric::{NodeKind, nodes};
use crate::surface::{BsplineSurface, Surface};

use super::Target;

/// Gauss points in each span: none is a node.
const POINTS_PER_SPAN: usize = 5;

/// How far a fit is from its target.
#[derive(Default)]
pub(super) struct Measured {
    pub deviation: f64,
    pub edge: f64,
    pub tangent: f64,
    /// Errors of interpolation in u alone, by span: on lines of v where nothing else is interpolated away.
    pub spans_u: Vec<([f64; 2], f64)>,
    pub spans_v: Vec<([f64; 2], f64)>,
}

impl Measured {
    /// Points that are evaluated for the given breakpoints.
    pub fn samples([in_u, in_v]: [&[f64]; 2]) -> usize {
        let test = |line: &[f64]| line.len().saturating_mul(POINTS_PER_SPAN);
        test(in_u).saturating_mul(test(in_v))
    }

    pub fn new(
        target: &Target,
        fitted: &BsplineSurface,
        [in_u, in_v]: [&[f64]; 2],
        t: f64,
    ) -> Result<Measured, Diagnostic> {
        let (test_u, test_v) = (test_points(in_u), test_points(in_v));
        let gaps = |derivative: Derivative, u: &[f64], v: &[f64]| gaps(target.surface, fitted, derivative, (u, v, t));
        let largest = |gaps: Vec<f64>| gaps.into_iter().fold(0.0, larger);
        let tangent = Derivative::new(1, 0, 0);
        // On nodes of v the fit is interpolation in u alone, and the other way round.
        let by_u = gaps(Derivative::NONE, &test_u, in_v)?;
        let by_v = gaps(Derivative::NONE, in_u, &test_v)?;
        let worst_u = by_u.chunks(in_v.len()).map(|row| row.iter().copied().fold(0.0, larger)).collect::<Vec<f64>>();
        let worst_v = (0..test_v.len())
            .map(|j| by_v.iter().skip(j).step_by(test_v.len()).copied().fold(0.0, larger))
            .collect::<Vec<f64>>();
        let inside = largest(gaps(Derivative::NONE, &test_u, &test_v)?);
        Ok(Measured {
            deviation: worst_u.iter().chain(&worst_v).copied().fold(inside, larger),
            edge: largest(gaps(Derivative::NONE, &target.u, &test_v)?),
            tangent: largest(gaps(tangent, &target.u, &test_v)?),
            spans_u: by_span(in_u, &worst_u),
            spans_v: by_span(in_v, &worst_v),
        })
    }

    /// The largest error of one direction alone.
    pub fn largest_of_directions(&self) -> f64 {
        self.spans_u.iter().chain(&self.spans_v).map(|(_, error)| *error).fold(0.0, larger)
    }
}

/// Both ends, and the Gauss points of each span between.
fn test_points(breakpoints: &[f64]) -> Vec<f64> {
    let inner = breakpoints.windows(2).flat_map(|span| match span {
        [a, b] => nodes(NodeKind::Gauss, POINTS_PER_SPAN, [*a, *b]),
        _ => Vec::new(),
    });
    breakpoints.first().copied().into_iter().chain(inner).chain(breakpoints.last().copied()).collect()
}

fn by_span(breakpoints: &[f64], worst: &[f64]) -> Vec<([f64; 2], f64)> {
    // The ends, which come first and last, are interpolated.
    let inner = worst.get(1..worst.len().saturating_sub(1)).unwrap_or(&[]);
    let spans = breakpoints.windows(2).filter_map(|span| match span {
        [a, b] => Some([*a, *b]),
        _ => None,
    });
    spans
        .zip(inner.chunks(POINTS_PER_SPAN))
        .map(|(span, errors)| (span, errors.iter().copied().fold(0.0, larger)))
        .collect()
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

fn distance([px, py, pz]: &[f64; 3], [qx, qy, qz]: &[f64; 3]) -> f64 {
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
