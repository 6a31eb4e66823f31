//! Any surface at one instant as a B-spline, to a stated tolerance.
//!
//! Input: surfaces with their domains; output: a [`BsplineSurface`] each, and how far apart they are, measured where
//! nothing was fitted. Splines interpolate: positions at a grid of nodes, and at the ends of u, and of an open v, also
//! the first derivative across (docs/bspline.md, F1). Knots are added where the distance is largest, apart for u and v.
//!
//! Invariant: an edge depends on nothing but the surface's values and derivatives along it and the knots. Surfaces fitted
//! together share their knots where they share a domain, so patches with a common edge have its control points in common.
//!
//! Absent on purpose: least squares, which would leave every edge off by something.

mod breakpoints;
mod line;
mod measure;

use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::expr::Derivative;
use crate::limits::Limits;
use crate::surface::{BsplineSurface, Surface};

use breakpoints::Breakpoints;
use line::{Line, end_orders};
use measure::{Axis, Measured, Seam, seam};

/// A surface to be fitted, on a rectangle of its parameters.
pub struct Target<'a> {
    /// What messages call it.
    pub name: &'a str,
    /// The surface.
    pub surface: &'a dyn Surface,
    /// The range of u.
    pub u: [f64; 2],
    /// The range of v.
    pub v: [f64; 2],
}

/// How to fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// The degree in both directions, 3 to 5: what is lower cannot take tangents at the ends.
    pub degree: usize,
    /// The largest distance between points of equal parameters; without it, 1e-6 of the largest extent.
    pub tolerance: Option<f64>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { degree: 3, tolerance: None }
    }
}

/// A B-spline in place of a surface.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The B-spline, clamped, over the target's own parameters.
    pub surface: BsplineSurface,
    /// The largest distance of points of equal parameters, measured along all edges and at 5 x 5 Gauss points in every
    /// cell: cells between knots, between the places where the surface says that its pieces meet
    /// ([`Surface::breaks`]), and of 16 x 16 equal parts. What is narrower than a part, lies
    /// between these points and is announced by none of these places is not seen.
    pub deviation: f64,
    /// The same along the edges at both ends of u.
    pub edge_deviation: f64,
    /// The largest difference of the derivative in u along these edges.
    pub tangent_deviation: f64,
    /// What `deviation` was asked to stay below.
    pub tolerance: f64,
    /// Whether the surface closes in v; the first and the last column of control points are then equal.
    pub is_closed_in_v: bool,
}

/// Without a tolerance: of the largest extent.
const DEFAULT_TOLERANCE: f64 = 1e-6;

/// Coordinates and their sums are rounded; below this, of the largest coordinate, a tolerance asks for luck.
const LEAST_TOLERANCE: f64 = 1e-13;

/// So often knots are added; each time a span may become eight.
const MOST_ROUNDS: usize = 16;

/// So many rounds may pass without progress: a surface that waves faster than the first knots shows none at first.
const MOST_IDLE_ROUNDS: usize = 5;

/// Fits `targets` at instant `t`, together: those with an equal range of u, or of v, have its knots in common.
///
/// # Errors
/// [`Code::SettingOutOfRange`] for a degree outside 3 to 5 or a tolerance that is not positive or below rounding;
/// [`Code::EmptyDomain`]; [`Code::ToleranceNotReached`] when more knots do not help, with what was reached;
/// [`Code::LimitReached`] for `samples` and `control-points`; what the surfaces report.
pub fn fit(targets: &[Target], t: f64, settings: &Settings, limits: &Limits) -> Result<Vec<Fitted>, Diagnostic> {
    if !(3..=5).contains(&settings.degree) {
        let message = format!("a B-spline of degree {} is not fitted", settings.degree);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message)
            .hint("use degree 3, 4 or 5: lower ones cannot take tangents at the ends"));
    }
    let mut work = targets.iter().map(|target| Work::new(target, t, settings)).collect::<Result<Vec<_>, _>>()?;
    let mut spans_in = [Breakpoints::default(), Breakpoints::default()];
    for one in &work {
        let ([in_u, in_v], [breaks_u, breaks_v]) = (&mut spans_in, &one.breaks);
        in_u.add(one.target.u, breaks_u, false);
        in_v.add(one.target.v, breaks_v, one.seam == Seam::Smooth);
    }
    spans_in.iter_mut().zip(FIRST_SPANS).for_each(|(lines, spans)| lines.start(spans));
    let mut best = f64::INFINITY;
    let mut idle = 0;
    for _ in 0..MOST_ROUNDS {
        let mut worst = 0.0_f64;
        let [in_u, in_v] = &spans_in;
        for one in &mut work {
            one.interpolate([in_u.of(one.target.u), in_v.of(one.target.v)], t, settings.degree, limits)?;
            // Relative, since each target has its own tolerance.
            worst = worst.max(one.excess());
        }
        if worst <= 1.0 {
            return work.into_iter().map(Work::finish).collect();
        }
        idle = if worst < 0.9 * best { 0 } else { idle + 1 };
        best = best.min(worst);
        if idle == MOST_IDLE_ROUNDS {
            break;
        }
        let [in_u, in_v] = &mut spans_in;
        for one in &work {
            let [pieces_u, pieces_v] = one.measured.pieces(one.tolerance, settings.degree);
            in_u.ask(one.target.u, &pieces_u);
            in_v.ask(one.target.v, &pieces_v);
        }
        spans_in.iter_mut().for_each(Breakpoints::divide);
    }
    let worst = work.iter().max_by(|a, b| a.excess().total_cmp(&b.excess()));
    Err(worst.map_or_else(
        || not_reached("", f64::NAN, f64::NAN),
        |one| not_reached(one.target.name, one.measured.deviation, one.tolerance),
    ))
}

/// Spans at first, across and along.
const FIRST_SPANS: [usize; 2] = [4, 8];

/// A target with its current fit.
struct Work<'a> {
    target: &'a Target<'a>,
    tolerance: f64,
    seam: Seam,
    /// Where pieces of the target meet, in u and in v.
    breaks: [Vec<f64>; 2],
    fitted: Option<BsplineSurface>,
    measured: Measured,
}

impl<'a> Work<'a> {
    fn new(target: &'a Target<'a>, t: f64, settings: &Settings) -> Result<Work<'a>, Diagnostic> {
        for (name, [start, end]) in [("u", target.u), ("v", target.v)] {
            if !(start < end && (end - start).is_finite()) {
                let (start, end) = (Shortest(start), Shortest(end));
                let message = format!("`{}` has no extent: {name} from {start} to {end}", target.name);
                return Err(Diagnostic::new(Code::EmptyDomain, message).hint("the lower end is below the upper end"));
            }
        }
        let (seam, extent, size) = seam(target, t, settings.degree)?;
        let least = LEAST_TOLERANCE * size;
        let default = (DEFAULT_TOLERANCE * extent).max(least).max(f64::MIN_POSITIVE);
        let tolerance = settings.tolerance.unwrap_or(default);
        // Written so that NaN is refused.
        if !(tolerance > 0.0 && tolerance >= least) {
            let message = format!("the tolerance {tolerance:.1e} is below the rounding of `{}`", target.name);
            return Err(Diagnostic::new(Code::SettingOutOfRange, message).hint(format!("ask for {least:.0e} or more")));
        }
        let breaks = target.surface.breaks([target.u, target.v], t)?;
        Ok(Work { target, tolerance, seam, breaks, fitted: None, measured: Measured::default() })
    }

    /// Interpolates over `breakpoints` of u and v, and measures.
    fn interpolate(
        &mut self,
        breakpoints: [&[f64]; 2],
        t: f64,
        degree: usize,
        limits: &Limits,
    ) -> Result<(), Diagnostic> {
        let unsolvable = || {
            let message = format!("the B-spline of `{}` is not finite", self.target.name);
            Diagnostic::new(Code::SolutionNotFinite, message).hint("use coordinates of moderate size")
        };
        let [in_u, in_v] = breakpoints;
        let points = (in_u.len() + degree - 1).saturating_mul(in_v.len() + degree - 1);
        if points > limits.control_points {
            return Err(self.limit("control-points", limits.control_points, points));
        }
        let across = Line::new(degree, in_u, false).ok_or_else(unsolvable)?;
        let along = Line::new(degree, in_v, self.seam == Seam::Smooth).ok_or_else(unsolvable)?;
        let [breaks_u, breaks_v] = &self.breaks;
        let [axis_u, axis_v] =
            [Axis::new(in_u, of_order(&across, 0).1, breaks_u), Axis::new(in_v, of_order(&along, 0).1, breaks_v)];
        let samples = Measured::samples([&axis_u, &axis_v]);
        if samples > limits.samples {
            return Err(self.limit("samples", limits.samples, samples));
        }
        let data = self.data([&across, &along], t, degree)?;
        let columns = along.functionals().len();
        let rows = data.chunks(columns).map(|row| along.control_points(row)).collect::<Option<Vec<_>>>();
        let rows = rows.ok_or_else(unsolvable)?;
        let count = along.knots().points();
        let column = |j: usize| -> Option<Vec<[f64; 3]>> {
            let data = rows.iter().map(|row| row.get(j).copied()).collect::<Option<Vec<_>>>()?;
            across.control_points(&data)
        };
        let net = (0..count).map(column).collect::<Option<Vec<_>>>().ok_or_else(unsolvable)?;
        // Columns side by side are the rows of the surface with u and v exchanged.
        let [u, v] = [across.knots().clone(), along.knots().clone()];
        let fitted = BsplineSurface::new(v, u, net.into_iter().flatten().collect())
            .map_err(|_| unsolvable())?
            .transposed()
            .clamped();
        let fitted = if self.seam == Seam::Open { fitted } else { fitted.closed_in_v() };
        self.measured = Measured::new(self.target, &fitted, [&axis_u, &axis_v], t)?;
        self.fitted = Some(fitted);
        Ok(())
    }

    /// What the functionals of both lines are on the target, those of equal u together.
    fn data(&self, [across, along]: [&Line; 2], t: f64, degree: usize) -> Result<Vec<[f64; 3]>, Diagnostic> {
        let columns = along.functionals().len();
        let mut data = vec![[f64::NAN; 3]; across.functionals().len() * columns];
        for order_u in 0..=end_orders(degree) {
            for order_v in 0..=end_orders(degree) {
                let (at_u, u) = of_order(across, order_u);
                let (at_v, mut v) = of_order(along, order_v);
                if let Seam::Kinked(orders) = self.seam
                    && order_v < orders
                    && let Some(last) = v.last_mut()
                {
                    // What is equal at both ends but for rounding is taken from the start.
                    *last = self.target.v[0];
                }
                if u.is_empty() || v.is_empty() {
                    continue;
                }
                let mut values = vec![[0.0; 3]; u.len() * v.len()];
                self.target.surface.evaluate_grid(Derivative::new(order_u, order_v, 0), (&u, &v, t), &mut values)?;
                let places = at_u.iter().flat_map(|i| at_v.iter().map(move |j| i * columns + j));
                for (place, value) in places.zip(values) {
                    if let Some(datum) = data.get_mut(place) {
                        *datum = value;
                    }
                }
            }
        }
        Ok(data)
    }

    /// The deviation over the tolerance; infinite for what is no number, which must not pass.
    fn excess(&self) -> f64 {
        let excess = self.measured.deviation / self.tolerance;
        if excess.is_nan() { f64::INFINITY } else { excess }
    }

    fn limit(&self, name: &str, limit: usize, asked: usize) -> Diagnostic {
        let mut message = format!("`{}` takes {asked} at the limit `{name}` of {limit}", self.target.name);
        if self.fitted.is_some() {
            message += &format!("; with fewer knots it deviates by {:.1e}", self.measured.deviation);
        }
        Diagnostic::new(Code::LimitReached, message).hint("ask for a larger tolerance, or a higher degree")
    }

    fn finish(self) -> Result<Fitted, Diagnostic> {
        let surface = self.fitted.ok_or_else(|| not_reached(self.target.name, f64::NAN, self.tolerance))?;
        Ok(Fitted {
            surface,
            deviation: self.measured.deviation,
            edge_deviation: self.measured.edge,
            tangent_deviation: self.measured.tangent,
            tolerance: self.tolerance,
            is_closed_in_v: self.seam != Seam::Open,
        })
    }
}

/// The functionals of one order: their numbers and their places.
fn of_order(line: &Line, order: usize) -> (Vec<usize>, Vec<f64>) {
    let numbered = line.functionals().iter().enumerate();
    numbered.filter(|(_, (_, other))| *other == order).map(|(index, (x, _))| (index, *x)).unzip()
}

fn not_reached(name: &str, deviation: f64, tolerance: f64) -> Diagnostic {
    let message = format!(
        "the B-spline of `{name}` deviates by {deviation:.1e} and should by {tolerance:.1e}; more knots do not help"
    );
    Diagnostic::new(Code::ToleranceNotReached, message)
        .hint("ask for a larger tolerance; where the surface has a corner or a jump, no B-spline comes close")
}
