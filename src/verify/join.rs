//! Judges how a surface meets the primary surfaces that its patch joins.
//!
//! The primary surface is evaluated from its own expressions, and its normals from its own partial derivatives. The
//! boundary data that were made of it are not looked at: a fault on the way from the surface to them would show here.

use super::contact::{Vector, angle_degrees, difference, direction, distance, dot, length, normals, worse};
use super::programs::VectorProgram;
use super::{GRID, with_ends};
use crate::diagnostic::{Code, Diagnostic};
use crate::eval::Samples;
use crate::expr::{Derivative, ExprId, Variable};
use crate::limits::Limits;
use crate::problem::{Bindings, DomainValues, Join, Patch, Problem};
use crate::surface::{Surface, SymbolicSurface};

/// How a surface meets a primary surface along a trimline, at its worst.
#[derive(Debug, Clone, PartialEq)]
pub struct JoinDeviation {
    /// The largest distance of the trimline from its curve on the primary surface.
    pub gap: f64,
    /// The largest distance between the unit tangents across the trimline; `None` if no point has both tangents.
    pub tangent: Option<f64>,
    /// The largest angle between the tangent planes, in degrees from 0 to 90; `None` if no point has both.
    pub angle_degrees: Option<f64>,
    /// The largest difference of the normal curvatures in the direction across the trimline; `None` unless the
    /// patch prescribes second derivatives there, or if no point has normals.
    pub curvature: Option<f64>,
    /// The number of points at which one of the surfaces has no tangent plane.
    pub without_normal: usize,
}

impl JoinDeviation {
    /// The worse of two measurements of one join, for example at two instants.
    #[must_use]
    pub fn worst(self, other: &JoinDeviation) -> JoinDeviation {
        JoinDeviation {
            gap: self.gap.max(other.gap),
            tangent: worse(self.tangent, other.tangent),
            angle_degrees: worse(self.angle_degrees, other.angle_degrees),
            curvature: worse(self.curvature, other.curvature),
            without_normal: self.without_normal.max(other.without_normal),
        }
    }
}

/// The first and second derivatives of a surface at one point.
#[derive(Clone, Copy)]
struct Shape {
    u: Vector,
    v: Vector,
    uu: Vector,
    uv: Vector,
    vv: Vector,
}

/// Measures `surface` along every join of `patch` at instant `t`, at 37 points over v.
///
/// # Errors
/// [`Code::DataNotFinite`] when a primary surface is not finite there, and whatever the surface says when it cannot be
/// evaluated.
pub fn verify_joins(
    problem: &Problem,
    patch: &Patch,
    surface: &dyn Surface,
    (bindings, domain, t): (&Bindings, &DomainValues, f64),
    limits: &Limits,
) -> Result<Vec<JoinDeviation>, Diagnostic> {
    let v = with_ends(GRID[1], domain.v);
    let measure = |join: &Join| {
        let Some(primary) = problem.surfaces.get(join.surface) else {
            let message = format!("a join names surface number {}, which does not exist", join.surface);
            return Err(Diagnostic::new(Code::UnknownName, message).at(join.origin));
        };
        let u = bindings.constant(problem, join.u, join.origin, "the position of a boundary")?;
        let here: Vec<Vector> = v.iter().map(|&v| [u, v, t]).collect();
        let there = arguments(problem, join, bindings, &here)?;
        let is_here = |expr: ExprId| problem.graph.value(expr, bindings.as_slice(), [f64::NAN; 3]) == u;
        let needs_curvature = patch.conditions.iter().any(|condition| condition.order == 2 && is_here(condition.u));
        let primary = SymbolicSurface::new(problem, primary, bindings, limits);
        let stated = Curve::sample(&primary, &there, needs_curvature)?;
        Ok(compare(join, &Curve::sample(surface, &here, needs_curvature)?, &stated, needs_curvature))
    };
    patch.joins.iter().map(measure).collect()
}

/// The parameters and the time of the primary surface at points of the trimline.
fn arguments(
    problem: &Problem,
    join: &Join,
    bindings: &Bindings,
    points: &[Vector],
) -> Result<Vec<Vector>, Diagnostic> {
    let column = |index: usize| -> Vec<f64> { points.iter().filter_map(|point| point.get(index)).copied().collect() };
    let samples = (column(0), column(1), column(2));
    let samples = Samples { u: &samples.0, v: &samples.1, t: &samples.2 };
    let values = VectorProgram::compile(&problem.graph, &join.arguments).at(bindings, samples)?;
    let row = |index: usize| values.iter().skip(index * points.len()).copied();
    Ok(row(0).zip(row(1)).zip(row(2)).take(points.len()).map(|((a, b), time)| [a, b, time]).collect())
}

/// Points on a surface with its derivatives there.
struct Curve {
    positions: Vec<Vector>,
    shapes: Vec<Shape>,
}

impl Curve {
    fn sample(surface: &dyn Surface, points: &[Vector], needs_curvature: bool) -> Result<Curve, Diagnostic> {
        let derivative = |u: usize, v: usize| {
            let mut values = vec![[0.0; 3]; points.len()];
            if u + v < 2 || needs_curvature {
                match surface.evaluate(Derivative::new(u, v, 0), points, &mut values) {
                    // A surface with a crease can be met, but has no tangents to compare.
                    Err(finding) if u + v > 0 && finding.code == Code::NotDifferentiable => values.fill([f64::NAN; 3]),
                    result => result?,
                }
            }
            Ok::<_, Diagnostic>(values)
        };
        let firsts = derivative(1, 0)?.into_iter().zip(derivative(0, 1)?);
        let seconds = derivative(2, 0)?.into_iter().zip(derivative(1, 1)?).zip(derivative(0, 2)?);
        let shapes = firsts.zip(seconds).map(|((u, v), ((uu, uv), vv))| Shape { u, v, uu, uv, vv });
        Ok(Curve { shapes: shapes.collect(), positions: derivative(0, 0)? })
    }

    fn normals(&self) -> Vec<Option<Vector>> {
        normals(&self.positions, self.shapes.iter().map(|shape| (shape.u, shape.v)))
    }
}

fn compare(join: &Join, solved: &Curve, stated: &Curve, needs_curvature: bool) -> JoinDeviation {
    let gaps = solved.positions.iter().zip(&stated.positions).map(|(a, b)| distance(*a, *b));
    let mut worst = JoinDeviation {
        gap: gaps.fold(0.0, |most, gap| if gap.is_nan() { f64::INFINITY } else { most.max(gap) }),
        tangent: None,
        angle_degrees: None,
        curvature: None,
        without_normal: 0,
    };
    let both = solved.normals().into_iter().zip(stated.normals());
    for ((a, b), both) in solved.shapes.iter().zip(&stated.shapes).zip(both) {
        let across = if join.across == Variable::V { b.v } else { b.u };
        worst.tangent = worse(worst.tangent, tangent_difference(a.u, across, join.is_flipped));
        match both {
            (Some(of_a), Some(of_b)) => {
                worst.angle_degrees = worse(worst.angle_degrees, Some(angle_degrees(of_a, of_b)));
                if needs_curvature {
                    let of_b = if dot(of_a, of_b) < 0.0 { of_b.map(|x| -x) } else { of_b };
                    let [solved, stated] = [(a, of_a), (b, of_b)].map(|(shape, n)| shape.curvature(a.u, n));
                    worst.curvature =
                        worse(worst.curvature, solved.zip(stated).map(|(solved, stated)| (solved - stated).abs()));
                }
            }
            _ => worst.without_normal += 1,
        }
    }
    worst
}

/// The distance between unit tangents; of the two directions of a join that does not say which, the nearer.
fn tangent_difference(solved: Vector, stated: Vector, is_flipped: Option<bool>) -> Option<f64> {
    let (solved, stated) = (direction(solved)?, direction(stated)?);
    let (along, against) = (distance(solved, stated), distance(solved, stated.map(|x| -x)));
    Some(match is_flipped {
        Some(false) => along,
        Some(true) => against,
        None => along.min(against),
    })
}

impl Shape {
    /// The normal curvature in the direction of `d`: `II(d, d) / I(d, d)`, independent of parameters.
    fn curvature(&self, d: Vector, n: Vector) -> Option<f64> {
        let (e, f, g) = (dot(self.u, self.u), dot(self.u, self.v), dot(self.v, self.v));
        let determinant = e * g - f * f;
        let (du, dv) = (dot(d, self.u), dot(d, self.v));
        let (p, q) = ((du * g - dv * f) / determinant, (dv * e - du * f) / determinant);
        let second = p * p * dot(self.uu, n) + 2.0 * p * q * dot(self.uv, n) + q * q * dot(self.vv, n);
        let along = [0, 1, 2].map(|i| {
            let component = |vector: Vector| vector.get(i).copied().unwrap_or(0.0);
            p * component(self.u) + q * component(self.v)
        });
        let curvature = second / dot(along, along);
        // A direction outside the tangent plane has no curvature here.
        let is_within = length(difference(along, d)) <= 0.1 * length(d);
        (is_within && curvature.is_finite()).then_some(curvature)
    }
}
