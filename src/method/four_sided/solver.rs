//! From numbers to a surface: what corners ask, the weak equations of one instant, and what is to be said about them.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::known::{Equations, Frame, Known};
use super::system::System;
use super::weak_form::{Part, Table, add_matrix, add_vector};
use super::{FourSided, MORE_NODES, ORDER, ORDERS};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Span};
use crate::eval::{Evaluator, Samples};
use crate::expr::Derivative;
use crate::method::{Method, Report, Solution, Solver};
use crate::numeric::gauss_rule;
use crate::surface::{Basis, Coefficients, CoonsSurface, Corrections, Sides, Surface, TabulatedModes};
use crate::trial::{CorrectedTrial, IntegratedLegendre};

/// A compiled problem.
pub struct FourSidedSolver {
    /// Corrections in u and in v.
    pub terms: [usize; 2],
    pub parts: Vec<Part>,
    /// The highest derivative in t that the equation names.
    pub orders_in_t: usize,
    /// Whether data, coefficients or force depend on t.
    pub varies_in_time: bool,
    /// Whether the three components have different coefficients.
    pub is_vector: bool,
    /// Coefficients by part and component.
    pub coefficients: Field,
    /// The force by order in t and component.
    pub force: Field,
    /// Where the conditions stand: four in u, four in v.
    pub positions: Arc<dyn Evaluator>,
    /// The data at fixed u.
    pub at_u: Arc<Basis>,
    /// The data at fixed v.
    pub at_v: Arc<Basis>,
    /// Where the data are written.
    pub boundary: Option<Span>,
    /// Where the equation is written.
    pub equation: Option<Span>,
    pub note: Option<Diagnostic>,
    /// What patches like this one have in common.
    pub known: Known,
}

/// Vectors of functions of u, v and t.
pub struct Field {
    pub values: Arc<dyn Evaluator>,
    /// Whether any depends on u or v: if not, one point has their values everywhere.
    pub varies: bool,
}

/// Where the last terms move the surface by more than this share of its size, the series has not settled.
const SETTLED: f64 = 1e-3;
/// Amplifications below this are not mentioned; to the next a note, then a warning; above the last, there is no solution.
const SILENT: f64 = 10.0;
const NOTABLE: f64 = 1e3;
const RESONANT: f64 = 1e10;
/// Directions in which the symbol of the equation is looked at.
const DIRECTIONS: usize = 64;

/// Values of the three components at all nodes of a frame, u-major, or one for all of them.
type Sampled = [Vec<f64>; 3];

/// A value at a node.
fn at(values: &[f64], node: usize) -> f64 {
    match values {
        [all] => *all,
        values => values.get(node).copied().unwrap_or(f64::NAN),
    }
}

impl Solver for Arc<FourSidedSolver> {
    fn solve(&self, params: &[f64], ranges: [[f64; 2]; 2], t: f64) -> Result<Solution, Diagnostic> {
        self.check_positions(params, ranges)?;
        let sides = Arc::new(Sides { ranges, at_u: Arc::clone(&self.at_u), at_v: Arc::clone(&self.at_v) });
        let frame = self.known.frame(self.terms, ranges, || self.frame(ranges))?;
        let coefficients = self.sampled(&self.coefficients, &frame, params, t)?;
        let mut report = self.empty_report();
        let size = self.data_size(&frame, params, t)?;
        let is_twisted = self.check_corners(&sides, params, size, t, &mut report)?;
        report.warnings.extend(self.apexes(params, ranges, size, t)?);
        let equations = self.known.equations(&frame, (&self.parts, &coefficients), || {
            let systems = self.systems(&frame, &coefficients)?;
            let not_elliptic = self.not_elliptic(&frame, &coefficients);
            Ok(Equations::new(&frame, (&self.parts, coefficients.clone()), systems, not_elliptic))
        })?;
        self.describe(&equations, &mut report);
        let without = (Corrections::default(), None);
        let coons = CoonsSurface::new(Arc::clone(&sides), frame.hermite.clone(), params, is_twisted, without);
        let (solver, modes, params) = (Arc::clone(self), frame.modes.clone(), params.to_vec());
        let here = Instant { solver, frame, equations, coons, params: params.clone(), t };
        let first = here.corrections(0)?;
        report.warnings.extend(self.settling(&here.frame, &first, size));
        let further = if self.varies_in_time { self.orders_in_t } else { 0 };
        // Velocities and accelerations are rarely asked for, and each is as much work as the surface.
        let corrections = Corrections::new(first, further, Box::new(move |order| here.corrections(order)));
        let instant = self.varies_in_time.then_some(t);
        let surface = CoonsSurface::new(sides, modes, &params, is_twisted, (corrections, instant));
        Ok(Solution { surface: Arc::new(surface), report })
    }

    fn is_everlasting(&self, _solution: &Solution) -> bool {
        !self.varies_in_time
    }
}

/// The weak equations of one instant.
struct Instant {
    solver: Arc<FourSidedSolver>,
    frame: Arc<Frame>,
    equations: Arc<Equations>,
    /// What meets the data, without corrections.
    coons: CoonsSurface,
    params: Vec<f64>,
    t: f64,
}

impl Instant {
    /// The derivative of order `order` in t of the corrections.
    fn corrections(&self, order: usize) -> Result<Coefficients, Diagnostic> {
        let Instant { solver, frame, equations, params, t, .. } = self;
        let unknowns = solver.terms.iter().product();
        let force = solver.sampled(&solver.force, frame, params, *t)?;
        let force = force.get(order).cloned().unwrap_or_default();
        let rights = self.rights(order, &force)?;
        let mut corrections: Coefficients = vec![[0.0; 3]; unknowns];
        for (index, system) in equations.systems.iter().enumerate() {
            let components = if solver.is_vector { index..index + 1 } else { 0..3 };
            for component in components {
                let Some(right) = rights.get(component) else { continue };
                for (slot, value) in corrections.iter_mut().zip(system.solve(right).iter()) {
                    if let Some(slot) = slot.get_mut(component) {
                        *slot = *value;
                    }
                }
            }
        }
        if corrections.iter().flatten().all(|value| value.is_finite()) {
            return Ok(corrections);
        }
        let message = "the corrections of the four-sided patch are not finite";
        Err(Diagnostic::new(Code::SolutionNotFinite, message).at(solver.equation))
    }

    /// The right-hand sides, differentiated `order` times in t, by component.
    fn rights(&self, order: usize, force: &Sampled) -> Result<[DMatrix<f64>; 3], Diagnostic> {
        let Frame { nodes: [u, v], tables: [table_u, table_v], .. } = &*self.frame;
        let (tables, unknowns) = ([table_u, table_v], self.solver.terms.iter().product());
        let mut rights = [(); 3].map(|()| DMatrix::zeros(unknowns, 1));
        let acting = rights.iter_mut().zip(force).filter(|(_, force)| force.iter().any(|value| *value != 0.0));
        for (right, force) in acting {
            add_vector(right, [0, 0], tables, |node| at(force, node));
        }
        let mut values = vec![[0.0; 3]; u.len() * v.len()];
        for (part, coefficients) in self.solver.parts.iter().zip(self.equations.coefficients()) {
            // Where the equation does not take a derivative, it need not exist.
            if coefficients.iter().flatten().all(|factor| *factor == 0.0) {
                continue;
            }
            let derivative = Derivative { t: part.of_surface.t + order, ..part.of_surface };
            self.coons.evaluate_grid(derivative, (u, v, self.t), &mut values)?;
            for (component, (right, factors)) in rights.iter_mut().zip(coefficients).enumerate() {
                let value = |node: usize| values.get(node).and_then(|value| value.get(component)).copied();
                let product = |node: usize| -at(factors, node) * value(node).unwrap_or(f64::NAN);
                add_vector(right, part.of_test, tables, product);
            }
        }
        Ok(rights)
    }
}

impl FourSidedSolver {
    fn check_positions(&self, params: &[f64], [range_u, range_v]: [[f64; 2]; 2]) -> Result<(), Diagnostic> {
        let positions = evaluate(&*self.positions, params, (&[0.0], &[0.0]), 0.0)?;
        let expected = [range_u, range_v].into_iter().flat_map(|[low, high]| [low, low, high, high]);
        let size = range_u.iter().chain(&range_v).fold(0.0_f64, |most, end| most.max(end.abs()));
        let rounding = 4.0 * f64::EPSILON * size;
        if positions.iter().zip(expected).all(|(position, end)| (position - end).abs() <= rounding) {
            return Ok(());
        }
        let message = "with these params the constraints do not stand at the ends of u and v";
        Err(Diagnostic::new(Code::UnsupportedByMethod, message).at(self.boundary))
    }

    /// The four cubic Hermite functions of each coordinate, and as many corrections as `terms`.
    fn modes(&self, terms: [usize; 2], ranges: [[f64; 2]; 2]) -> Result<[Arc<TabulatedModes>; 2], Diagnostic> {
        let of = |count: usize, range: [f64; 2]| {
            let [low, high] = range;
            let functionals: Vec<(f64, usize)> = [low, low, high, high].into_iter().zip(ORDERS).collect();
            let family = Arc::new(IntegratedLegendre::new(ORDER, count));
            let modes = CorrectedTrial::new(family, count, range, &functionals);
            modes.map(TabulatedModes::new).map(Arc::new).ok_or_else(|| {
                let (low, high) = (Shortest(low), Shortest(high));
                let message = format!("position and tangent at {low} and {high} do not determine a cubic");
                Diagnostic::new(Code::DependentConstraints, message).at(self.boundary)
            })
        };
        let ([in_u, in_v], [range_u, range_v]) = (terms, ranges);
        Ok([of(in_u, range_u)?, of(in_v, range_v)?])
    }

    fn frame(&self, ranges: [[f64; 2]; 2]) -> Result<Frame, Diagnostic> {
        let (modes, hermite) = (self.modes(self.terms, ranges)?, self.modes([0, 0], ranges)?);
        let [(u, table_u), (v, table_v)] = [0, 1].map(|axis| {
            let (Some(modes), Some(count), Some(range)) = (modes.get(axis), self.terms.get(axis), ranges.get(axis))
            else {
                return (Vec::new(), Table { values: Vec::new(), weights: Vec::new() });
            };
            let (nodes, weights) = gauss_rule(2 * count + MORE_NODES, *range);
            let values = (0..=2).map(|order| {
                let rows: Vec<f64> =
                    nodes.iter().flat_map(|at| modes.derivatives(order, *at).split_off(ORDERS.len())).collect();
                DMatrix::from_row_slice(nodes.len(), *count, &rows)
            });
            let values = values.collect();
            (nodes, Table { values, weights })
        });
        let all_u: Vec<f64> = u.iter().flat_map(|&u| v.iter().map(move |_| u)).collect();
        let all_v: Vec<f64> = u.iter().flat_map(|_| v.iter().copied()).collect();
        let (tables, all) = ([table_u, table_v], [all_u, all_v]);
        Ok(Frame { terms: self.terms, ranges, modes, hermite, nodes: [u, v], tables, all })
    }

    /// The vectors of `field` at the nodes.
    fn sampled(&self, field: &Field, frame: &Frame, params: &[f64], t: f64) -> Result<Vec<Sampled>, Diagnostic> {
        let [u, v] = &frame.all;
        let count = if field.varies { u.len() } else { 1 };
        let (u, v) = (u.get(..count).unwrap_or_default(), v.get(..count).unwrap_or_default());
        let values = evaluate(&*field.values, params, (u, v), t)?;
        if values.iter().any(|value| !value.is_finite()) {
            let message = "a coefficient or the force of the equation is not finite inside the patch";
            return Err(Diagnostic::new(Code::DataNotFinite, message).at(self.equation));
        }
        let vectors = values.chunks(3 * count).map(|vector| {
            let mut components = vector.chunks(count).map(<[f64]>::to_vec);
            [(); 3].map(|()| components.next().unwrap_or_default())
        });
        Ok(vectors.collect())
    }

    /// The largest position or tangent on the sides, tangents times the range they belong to.
    fn data_size(&self, frame: &Frame, params: &[f64], t: f64) -> Result<f64, Diagnostic> {
        let ([u, v], ranges) = (&frame.nodes, frame.ranges);
        let mut size = 0.0_f64;
        for (basis, along, [low, high]) in [(&self.at_u, v, ranges[0]), (&self.at_v, u, ranges[1])] {
            let values = basis.values(Derivative::NONE, params, along, &vec![t; along.len()])?;
            for (condition, rows) in values.chunks(3 * along.len()).enumerate() {
                let factor = if condition % 2 == 0 { 1.0 } else { high - low };
                size = rows.iter().fold(size, |most, value| most.max(factor * value.abs()));
            }
        }
        Ok(size)
    }

    /// The first component in which the leading part of the equation changes its sign with the direction.
    fn not_elliptic(&self, frame: &Frame, coefficients: &[Sampled]) -> Option<usize> {
        let leading = || self.parts.iter().zip(coefficients).filter(|(part, _)| part.order() == ORDER);
        let exponents = |part: &Part| {
            let orders = [part.of_surface.u + part.of_test[0], part.of_surface.v + part.of_test[1]];
            orders.map(|order| i32::try_from(order).unwrap_or(i32::MAX))
        };
        // What each part contributes, per unit of its coefficient, in each direction.
        let directions: Vec<Vec<f64>> = (0..DIRECTIONS)
            .map(|direction| {
                let angle = std::f64::consts::PI * direction as f64 / DIRECTIONS as f64;
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let power = |(part, _): (&Part, &Sampled)| {
                    let [p, q] = exponents(part);
                    cos.powi(p) * sin.powi(q)
                };
                leading().map(power).collect()
            })
            .collect();
        (0..3).find(|component| {
            let mut before: Vec<f64> = Vec::new();
            (0..frame.all[0].len()).any(|point| {
                let value = |all: &Sampled| all.get(*component).map_or(f64::NAN, |values| at(values, point));
                let here: Vec<f64> = leading().map(|(_, all)| value(all)).collect();
                // Coefficients are the same almost everywhere.
                if here == before {
                    return false;
                }
                let symbol = |powers: &Vec<f64>| powers.iter().zip(&here).map(|(a, b)| a * b).sum::<f64>();
                let start = directions.first().map_or(f64::NAN, symbol);
                let is_elliptic = directions.iter().all(|powers| symbol(powers) * start > 0.0);
                before = here;
                !is_elliptic
            })
        })
    }

    /// A warning about an equation that is not elliptic.
    fn ellipticity(&self, component: usize) -> Diagnostic {
        let name = crate::problem::COMPONENTS.get(component).unwrap_or(&"?");
        let message =
            format!("the equation for S_{name} is not elliptic everywhere, so data on all four sides need not fit it");
        Diagnostic::new(Code::NotElliptic, message)
            .at(self.equation)
            .hint("β and λ of one sign, and γ above -2 sqrt(βλ), make the standard equation elliptic")
    }

    /// The factorised equations of each component, or of all of them.
    fn systems(&self, frame: &Frame, coefficients: &[Sampled]) -> Result<Vec<System>, Diagnostic> {
        let count = if self.is_vector { 3 } else { 1 };
        (0..count).map(|component| self.factorise(frame, coefficients, component)).collect()
    }

    fn factorise(&self, frame: &Frame, coefficients: &[Sampled], component: usize) -> Result<System, Diagnostic> {
        let unknowns: usize = self.terms.iter().product();
        let [table_u, table_v] = &frame.tables;
        let mut matrix = DMatrix::zeros(unknowns, unknowns);
        let mut lower = DMatrix::zeros(unknowns, unknowns);
        // Derivatives in t act on the data alone: the corrections of an instant are taken as constant in time.
        let parts = self.parts.iter().zip(coefficients).filter(|(part, _)| part.of_surface.t == 0);
        for (part, coefficients) in parts {
            let total = if part.order() == ORDER { &mut matrix } else { &mut lower };
            if let Some(coefficient) = coefficients.get(component) {
                add_matrix(total, part, [table_u, table_v], |node| at(coefficient, node));
            }
        }
        System::new(matrix, &lower).filter(|system| system.amplification <= RESONANT).ok_or_else(|| {
            let message = "the equation is resonant on these four sides: it has no reliable solution";
            Diagnostic::new(Code::Resonant, message)
                .at(self.equation)
                .hint("change a coefficient of the equation, or the ranges of u and v")
        })
    }

    /// What there is to say about the equations.
    fn describe(&self, equations: &Equations, report: &mut Report) {
        report.warnings.extend(equations.not_elliptic.map(|component| self.ellipticity(component)));
        let unknowns: usize = self.terms.iter().product();
        for system in &equations.systems {
            let factor = system.amplification;
            if factor >= SILENT {
                let code = if factor < NOTABLE { Code::Amplified } else { Code::NearlyResonant };
                let error = factor * f64::EPSILON;
                let message =
                    format!("the equation amplifies {factor:.1e} times; expect a relative error of {error:.1e}");
                report.warnings.push(Diagnostic::new(code, message).at(self.equation));
            }
            report.condition = report.condition.map(|most| most.max(system.condition));
            report.amplification = report.amplification.map(|most| most.max(factor));
            report.rank += unknowns;
            report.unknowns += unknowns;
        }
    }

    /// A warning where the last two terms in u or in v still move the surface.
    fn settling(&self, frame: &Frame, corrections: &Coefficients, size: f64) -> Option<Diagnostic> {
        let [in_u, in_v] = self.terms;
        let [table_u, table_v] = &frame.tables;
        let (values_u, values_v) = (table_u.values.first()?, table_v.values.first()?);
        let mut moved = 0.0_f64;
        for component in 0..3 {
            let last = DMatrix::from_fn(in_u, in_v, |m, n| {
                let vector = corrections.get(m * in_v + n);
                let value = vector.and_then(|vector| vector.get(component)).copied().unwrap_or(f64::NAN);
                if m + 2 >= in_u || n + 2 >= in_v { value } else { 0.0 }
            });
            moved = moved.max((values_u * last * values_v.transpose()).amax());
        }
        if moved <= SETTLED * size {
            return None;
        }
        let message = format!("the last terms of {in_u} x {in_v} still move the surface by {moved:.1e}");
        Some(
            Diagnostic::new(Code::TermsTooFew, message)
                .at(self.equation)
                .hint("take more terms, or divide the patch; the boundary is met in any case"),
        )
    }

    fn empty_report(&self) -> Report {
        Report {
            truncation: None,
            method: FourSided.name(),
            is_exact: false,
            basis_size: 0,
            closure_size: None,
            modes: self.terms[0],
            condition: Some(1.0),
            amplification: Some(1.0),
            rank: 0,
            unknowns: 0,
            limit: None,
            warnings: self.note.iter().cloned().collect::<Diagnostics>(),
        }
    }
}

/// The values of a program at points, output after output.
fn evaluate(
    evaluator: &dyn Evaluator,
    params: &[f64],
    (u, v): (&[f64], &[f64]),
    t: f64,
) -> Result<Vec<f64>, Diagnostic> {
    let mut values = vec![0.0; evaluator.program().outputs() * u.len()];
    let samples = Samples { u, v, t: &vec![t; u.len()] };
    evaluator
        .evaluate(params, samples, &mut values)
        .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
    Ok(values)
}
