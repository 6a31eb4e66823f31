//! Any surface at one instant as a B-spline, to a stated tolerance.
//!
//! Input: surfaces with their domains; output: a [`BsplineSurface`] each, and how far apart they are, measured where
//! nothing was fitted. Splines interpolate: positions at a grid of nodes, and at the ends of u, and of an open v, also
//! the first derivative across (docs/bspline.md, F1). Knots are added where the distance is largest, apart for u and v.
//!
//! Invariant: an edge depends on nothing but the surface's values and derivatives along it and the knots. Surfaces fitted
//! together have the knots along a common edge in common, whichever parameters run along it, and its control points.
//!
//! Absent on purpose: least squares, which would leave every edge off by something.

mod breakpoints;
mod edges;
mod line;
mod measure;

use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::expr::Derivative;
use crate::limits::Limits;
use crate::surface::{BsplineSurface, Surface};

use breakpoints::{Breakpoints, Member};
use edges::Edges;
pub use edges::SAME_PLACE;
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

/// Fits `targets` at instant `t`, together: sides that are one curve, at equal or opposite shares of their ranges, get
/// equal control points and the same knots, but for the ranges.
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
    let edges = Edges::new(targets, t)?;
    let members: Vec<Member> = work.iter().flat_map(Work::members).collect();
    let mut breakpoints = Breakpoints::new(&members, &edges.links());
    let mut best = f64::INFINITY;
    let mut idle = 0;
    for _ in 0..MOST_ROUNDS {
        for (index, one) in work.iter_mut().enumerate() {
            one.divide(index, &breakpoints, settings.degree, limits)?;
        }
        let fits = work.iter().map(|one| one.interpolate(t, settings.degree)).collect::<Result<_, _>>()?;
        let mut worst = 0.0_f64;
        for (one, fitted) in work.iter_mut().zip(edges.unite(fits)) {
            one.measure(fitted, t)?;
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
        for (index, one) in work.iter().enumerate() {
            let [pieces_u, pieces_v] = one.measured.pieces(one.tolerance, settings.degree);
            breakpoints.ask(2 * index, pieces_u);
            breakpoints.ask(2 * index + 1, pieces_v);
        }
        breakpoints.divide();
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
    /// The spline spaces of u and v, and where the fit is measured.
    space: Option<[(Line, Axis); 2]>,
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
        Ok(Work { target, tolerance, seam, breaks, space: None, fitted: None, measured: Measured::default() })
    }

    /// Its parameters u and v, as breakpoints know them.
    fn members(&self) -> [Member<'_>; 2] {
        let [breaks_u, breaks_v] = &self.breaks;
        let [spans_u, spans_v] = FIRST_SPANS;
        let is_periodic = self.seam == Seam::Smooth;
        [
            Member { range: self.target.u, breaks: breaks_u, spans: spans_u, is_periodic: false },
            Member { range: self.target.v, breaks: breaks_v, spans: spans_v, is_periodic },
        ]
    }

    /// Takes the spline spaces over `breakpoints`, in which this target is number `index`.
    fn divide(
        &mut self,
        index: usize,
        breakpoints: &Breakpoints,
        degree: usize,
        limits: &Limits,
    ) -> Result<(), Diagnostic> {
        let [in_u, in_v] = [2 * index, 2 * index + 1].map(|member| breakpoints.of(member));
        let points = (in_u.len() + degree - 1).saturating_mul(in_v.len() + degree - 1);
        if points > limits.control_points {
            return Err(self.limit("control-points", limits.control_points, points));
        }
        let across = Line::new(degree, &in_u, false).ok_or_else(|| self.unsolvable())?;
        let is_periodic = breakpoints.is_periodic(2 * index + 1);
        let along = Line::new(degree, &in_v, is_periodic).ok_or_else(|| self.unsolvable())?;
        if let (Seam::Smooth, false) = (self.seam, is_periodic) {
            // It shares an edge with what is not smooth there; the data at its end are still those at its start.
            self.seam = Seam::Kinked(degree);
        }
        let [breaks_u, breaks_v] = &self.breaks;
        let [in_u, in_v] =
            [Axis::new(&in_u, of_order(&across, 0).1, breaks_u), Axis::new(&in_v, of_order(&along, 0).1, breaks_v)];
        let samples = Measured::samples([&in_u, &in_v]);
        if samples > limits.samples {
            return Err(self.limit("samples", limits.samples, samples));
        }
        self.space = Some([(across, in_u), (along, in_v)]);
        Ok(())
    }

    /// Interpolates in the spline spaces.
    fn interpolate(&self, t: f64, degree: usize) -> Result<BsplineSurface, Diagnostic> {
        let Some([(across, _), (along, _)]) = &self.space else { return Err(self.unsolvable()) };
        let data = self.data([across, along], t, degree)?;
        let columns = along.functionals().len();
        let rows = data.chunks(columns).map(|row| along.control_points(row)).collect::<Option<Vec<_>>>();
        let rows = rows.ok_or_else(|| self.unsolvable())?;
        let count = along.knots().points();
        let column = |j: usize| -> Option<Vec<[f64; 3]>> {
            let data = rows.iter().map(|row| row.get(j).copied()).collect::<Option<Vec<_>>>()?;
            across.control_points(&data)
        };
        let net = (0..count).map(column).collect::<Option<Vec<_>>>().ok_or_else(|| self.unsolvable())?;
        // Columns side by side are the rows of the surface with u and v exchanged.
        let [u, v] = [across.knots().clone(), along.knots().clone()];
        let fitted = BsplineSurface::new(v, u, net.into_iter().flatten().collect())
            .map_err(|_| self.unsolvable())?
            .transposed()
            .clamped();
        Ok(if self.seam == Seam::Open { fitted } else { fitted.closed_in_v() })
    }

    /// Takes a fit in the spline spaces and measures it.
    fn measure(&mut self, fitted: BsplineSurface, t: f64) -> Result<(), Diagnostic> {
        let Some([(_, in_u), (_, in_v)]) = &self.space else { return Err(self.unsolvable()) };
        self.measured = Measured::new(self.target, &fitted, [in_u, in_v], t)?;
        self.fitted = Some(fitted);
        Ok(())
    }

    fn unsolvable(&self) -> Diagnostic {
        let message = format!("the B-spline of `{}` is not finite", self.target.name);
        Diagnostic::new(Code::SolutionNotFinite, message).hint("use coordinates of moderate size")
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
        .hint("ask for a larger tolerance; where the surface jumps, no B-spline comes close")
}
