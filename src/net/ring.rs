//! Two patches around a closed strip, smooth across both seams where the data allow it.

use super::quarter::last_span;
use super::{Filled, at, combine, difference, fill, sum};
use crate::diagnostic::{Code, Diagnostic};
use crate::net::cardinal::Cardinal;
use crate::surface::{BsplineCurve, KnotVector};

/// What bounds a closed strip: u runs across it, v around.
#[derive(Debug, Clone)]
pub struct Strip {
    /// Clamped cubic knots across, for n + 1 points.
    pub across: KnotVector,
    /// The layers 0, 1 and n of the net: closed curves over equal cubic knots that also close in their tangents.
    pub layers: [BsplineCurve; 3],
    /// Where the second seam lies, inside the domain of the curves; the first lies at its ends.
    pub split: f64,
    /// The n + 1 points just behind and just before the first seam; of these 2 to n - 1 are free and are read. Without
    /// them, quadratics in u between the layers.
    pub beside_first_seam: Option<[Vec<[f64; 3]>; 2]>,
    /// The n + 1 points of the second seam, of which 2 to n - 1 are read. Without them, those that make it smooth.
    pub second_seam: Option<Vec<[f64; 3]>>,
}

/// A closed strip.
#[derive(Debug, Clone)]
pub struct Ring {
    /// The patch before the second seam and the one behind it, in the parameters of the curves.
    pub patches: [Filled; 2],
    /// How far the second seam's control points are from where tangents would agree: the largest distance.
    pub crease: f64,
    /// [`Code::SeamCreased`], if that is more than rounding.
    pub warnings: Vec<Diagnostic>,
}

/// Layers and seams may miss each other by rounding.
const LARGEST_GAP: f64 = 1e-9;

/// Fills a closed strip with two patches, C1 across the first seam.
///
/// Across the second seam the equation decides the tangents: they agree if and only if the second seam minus the first
/// is a quadratic polynomial of u (docs/bspline.md, N6). Where the data violate it, the ring is creased there, says by
/// how much, and warns.
///
/// # Errors
/// [`Code::CurvesDoNotMeet`] when the layers have different knots or do not close, [`Code::NetSize`] for a number of
/// seam points other than n + 1, [`Code::PointOutsideDomain`] for a split outside; those of [`fill`].
pub fn ring(strip: &Strip) -> Result<Ring, Diagnostic> {
    let cardinal = Cardinal::new(&strip.across, "u")?;
    let rows = strip.across.points();
    let size = check_layers(&strip.layers)?;
    for points in strip.beside_first_seam.iter().flatten().chain(&strip.second_seam) {
        if points.len() != rows {
            let message = format!("a seam has {} points, and the knots across belong to {rows}", points.len());
            return Err(Diagnostic::new(Code::NetSize, message).hint("give every point from one side to the other"));
        }
    }
    let [a, b, c] = &strip.layers;
    let [a, b, c] = [a.split(strip.split)?, b.split(strip.split)?, c.split(strip.split)?];
    let ([a0, a1], [b0, b1], [c0, c1]) = (a, b, c);
    // Both parts run away from the first seam.
    let parts = [[a0, b0, c0], [a1.reversed(), b1.reversed(), c1.reversed()]];
    let quadratic =
        |points: [[f64; 3]; 3]| -> Vec<[f64; 3]> { cardinal.values().map(|shares| combine(shares, points)).collect() };
    let beside = match &strip.beside_first_seam {
        Some(points) => points.clone(),
        None => parts.each_ref().map(|part| quadratic(part.each_ref().map(|curve| at(curve.points(), 1)))),
    };
    let first_steps = parts.each_ref().map(|[layer, ..]| last_span(&layer.knots().reversed()));
    let first_seam = meeting_points(&beside, first_steps);
    let second_seam = match &strip.second_seam {
        Some(points) => points.clone(),
        None => {
            let [part, _] = &parts;
            let steps = part.each_ref().map(|curve| difference(&last(curve), &at(curve.points(), 0)));
            // What the first seam has beyond its own quadratic, the second has too.
            quadratic(steps).iter().zip(&first_seam).map(|(step, point)| sum(step, point)).collect()
        }
    };
    let fill_part = |(part, beside): (&[BsplineCurve; 3], &Vec<[f64; 3]>)| {
        let [layer, second, outer] = part;
        let columns = layer.points().len();
        let mut net = Vec::with_capacity(rows * columns);
        for i in 0..rows {
            match i {
                0 => net.extend_from_slice(layer.points()),
                1 => net.extend_from_slice(second.points()),
                _ if i + 1 == rows => net.extend_from_slice(outer.points()),
                _ => net.extend((0..columns).map(|j| match j {
                    0 => at(&first_seam, i),
                    1 => at(beside, i),
                    _ if j + 1 == columns => at(&second_seam, i),
                    _ => [0.0; 3],
                })),
            }
        }
        fill(&strip.across, layer.knots(), &net)
    };
    let [part, other] = &parts;
    let [near, other_near] = &beside;
    let (first, mut second) = (fill_part((part, near))?, fill_part((other, other_near))?);
    let crease = crease([&first, &second], parts.each_ref().map(|[layer, ..]| last_span(layer.knots())));
    second.surface = second.surface.reversed_v();
    let warnings = if crease <= LARGEST_GAP * size { Vec::new() } else { vec![creased(crease, strip.split)] };
    Ok(Ring { patches: [first, second], crease, warnings })
}

/// The largest coordinate, if the layers are what they should be.
fn check_layers(layers: &[BsplineCurve; 3]) -> Result<f64, Diagnostic> {
    let [first, ..] = layers;
    let size = layers.iter().flat_map(BsplineCurve::points).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (name, layer) in ["0", "1", "n"].into_iter().zip(layers) {
        if layer.knots() != first.knots() {
            let message = format!("layer {name} has other knots than layer 0");
            return Err(Diagnostic::new(Code::CurvesDoNotMeet, message).hint("insert the knots of each into the other"));
        }
        let [start, end] = layer.knots().domain();
        // Times the domain's length, so that tangents and positions compare.
        for (order, what, unit) in [(0, "position", 1.0), (1, "tangent", end - start)] {
            let gap = difference(&layer.derivative(order, start), &layer.derivative(order, end));
            let gap = gap.iter().fold(0.0_f64, |most, x| most.max(x.abs() * unit));
            if gap > LARGEST_GAP * size {
                let message =
                    format!("layer {name} does not close: the {what} at its ends differs by {:.1e}", gap / unit);
                return Err(Diagnostic::new(Code::CurvesDoNotMeet, message)
                    .hint("a ring needs closed curves that are smooth where they close"));
            }
        }
    }
    Ok(size)
}

fn last(curve: &BsplineCurve) -> [f64; 3] {
    curve.points().last().copied().unwrap_or([f64::NAN; 3])
}

/// The points between two lines of points at which tangents agree, for the lengths of the spans on both sides.
fn meeting_points([before, behind]: &[Vec<[f64; 3]>; 2], [step_before, step_behind]: [f64; 2]) -> Vec<[f64; 3]> {
    let total = step_before + step_behind;
    let shares = [step_behind / total, step_before / total, 0.0];
    before.iter().zip(behind).map(|(p, q)| combine(shares, [*p, *q, [0.0; 3]])).collect()
}

/// The largest distance of the second seam's points from where tangents would agree.
fn crease(patches: [&Filled; 2], steps: [f64; 2]) -> f64 {
    let column = |patch: &Filled, from_end: usize| -> Vec<[f64; 3]> {
        patch.surface.rows().map(|row| row.iter().rev().nth(from_end).copied().unwrap_or([f64::NAN; 3])).collect()
    };
    let [first, _] = patches;
    let smooth = meeting_points(&patches.map(|patch| column(patch, 1)), steps);
    let gaps = column(first, 0).into_iter().zip(smooth).map(|(p, q)| {
        let [x, y, z] = difference(&p, &q);
        (x * x + y * y + z * z).sqrt()
    });
    gaps.fold(0.0, f64::max)
}

fn creased(crease: f64, split: f64) -> Diagnostic {
    let message =
        format!("the ring is creased at its second seam, v = {split}: points are {crease:.1e} from a smooth place");
    Diagnostic::new(Code::SeamCreased, message).hint(
        "the second seam minus the first must be a quadratic polynomial across; leave the second seam open to have it placed so",
    )
}
