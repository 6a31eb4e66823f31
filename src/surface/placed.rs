//! Copies of a surface elsewhere.

use std::sync::Arc;

use super::validity::finite;
use super::{BsplineSurface, Surface};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph};
use crate::limits::Limits;
use crate::numeric::{NodeKind, nodes};
use crate::problem::PatchCopy;

/// A placement that is ready for any params.
pub struct CompiledPlacement {
    graph: Arc<Graph>,
    entries: [ExprId; 12],
    values: Arc<dyn Evaluator>,
    origin: Option<Span>,
    graph_nodes: usize,
}

/// `A(t) S(u, v, t) + b(t)` with a matrix that keeps lengths.
pub struct PlacedSurface {
    base: Arc<dyn Surface + Send + Sync>,
    placement: Arc<CompiledPlacement>,
    params: Vec<f64>,
}

/// Places of each coordinate at which the size of a surface is measured.
const LOOKED_AT: usize = 5;

/// Whether adding something of size `added` to a shape of some `size` leaves less than six digits of the shape.
#[must_use]
pub fn is_lost(size: f64, added: f64) -> bool {
    f64::EPSILON * added > 1e-6 * size && size > 0.0
}

/// A matrix and a vector.
type Affine = ([[f64; 3]; 3], [f64; 3]);

impl CompiledPlacement {
    /// The placement of a copy whose expressions are in `graph`, which all copies of a document share.
    #[must_use]
    pub fn new(graph: &Arc<Graph>, copy: &PatchCopy, limits: &Limits) -> CompiledPlacement {
        let entries = copy.placement.entries();
        let (values, _) = compile(Program::compile(graph, &entries), Backend::Interpreter);
        let graph_nodes = limits.graph_nodes;
        CompiledPlacement { graph: Arc::clone(graph), entries, values, origin: copy.origin, graph_nodes }
    }

    /// Whether it is a reflection, and so turns the sides of a surface round.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] if the placement is not finite at `t`.
    pub fn is_reflection(&self, params: &[f64], t: f64) -> Result<bool, Diagnostic> {
        let ([[a, b, c], [d, e, f], [g, h, i]], _) = self.at(params, t, 0)?;
        Ok(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0.0)
    }

    /// A B-spline surface at its place at instant `t`, exactly: the image of the control points is the net of the image.
    ///
    /// # Errors
    /// [`Code::DataNotFinite`] if the placement is not finite at `t`; [`Code::PointNotFinite`] if the image is not.
    pub fn place_bspline(
        &self,
        surface: &BsplineSurface,
        params: &[f64],
        t: f64,
    ) -> Result<BsplineSurface, Diagnostic> {
        let (linear, offset) = self.at(params, t, 0)?;
        let place = |point: &[f64; 3]| {
            let mut image = offset;
            for (x, row) in image.iter_mut().zip(&linear) {
                *x += row.iter().zip(point).map(|(entry, x)| entry * x).sum::<f64>();
            }
            image
        };
        let [u, v] = surface.knots().map(Clone::clone);
        BsplineSurface::new(u, v, surface.net().iter().map(place).collect())
    }

    /// A program for the derivative of order `order` in t.
    fn program(&self, order: usize) -> Result<Arc<dyn Evaluator>, Diagnostic> {
        if order == 0 {
            return Ok(Arc::clone(&self.values));
        }
        // Few ask for it, and twelve expressions are soon differentiated.
        let (mut graph, mut entries) = ((*self.graph).clone(), self.entries);
        let (derivative, allowed) = (Derivative::new(0, 0, order), graph.size().saturating_add(self.graph_nodes));
        for entry in &mut entries {
            let result = graph.derivative_within(*entry, derivative, allowed);
            *entry = result.map_err(|fault| fault.to_diagnostic(derivative, allowed).at(self.origin))?;
        }
        Ok(compile(Program::compile(&graph, &entries), Backend::Interpreter).0)
    }

    /// The derivative of order `order` in t at instant `t`.
    fn at(&self, params: &[f64], t: f64, order: usize) -> Result<Affine, Diagnostic> {
        let mut values = [0.0; 12];
        self.program(order)?
            .evaluate(params, Samples { u: &[0.0], v: &[0.0], t: &[t] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        if values.iter().any(|value| !value.is_finite()) {
            let message = format!("where the copy is, is not finite at t = {}", Shortest(t));
            return Err(Diagnostic::new(Code::DataNotFinite, message)
                .at(self.origin)
                .hint("planes, angles and vectors of copies must be finite at every instant"));
        }
        let mut values = values.into_iter();
        let mut next = || values.next().unwrap_or(f64::NAN);
        let linear = [(); 3].map(|()| [(); 3].map(|()| next()));
        Ok((linear, [(); 3].map(|()| next())))
    }
}

impl PlacedSurface {
    /// `base` at the place that `placement` has with these params.
    #[must_use]
    pub fn new(
        base: Arc<dyn Surface + Send + Sync>,
        placement: Arc<CompiledPlacement>,
        params: &[f64],
    ) -> PlacedSurface {
        PlacedSurface { base, placement, params: params.to_vec() }
    }

    /// Refuses a place so far away at instant `t` that rounding leaves less than six digits of the surface's own size.
    ///
    /// # Errors
    /// [`Code::ShapeLost`]; what the surface reports.
    pub fn check_distance(&self, [u, v]: [[f64; 2]; 2], t: f64) -> Result<(), Diagnostic> {
        let [u, v] = [u, v].map(|range| nodes(NodeKind::Ends, LOOKED_AT, range));
        let mut points = vec![[0.0; 3]; u.len() * v.len()];
        self.base.evaluate_grid(Derivative::NONE, (&u, &v, t), &mut points)?;
        let first = points.first().copied().unwrap_or_default();
        let farthest = |from: [f64; 3]| {
            let differences = points.iter().flat_map(|point| point.iter().zip(from).map(|(a, b)| (a - b).abs()));
            differences.fold(0.0, f64::max)
        };
        let size = farthest(first);
        let (_, offset) = self.placement.at(&self.params, t, 0)?;
        let distance = offset.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        if is_lost(size, distance) {
            let message = format!(
                "a copy lies {distance:.1e} away, so that rounding leaves too little of its size of {size:.1e}"
            );
            return Err(Diagnostic::new(Code::ShapeLost, message)
                .at(self.placement.origin)
                .hint("place it by a distance that is comparable with its size"));
        }
        Ok(())
    }

    /// Applies Leibniz' rule at one instant: `of_base` gives a derivative of the base.
    fn place(
        &self,
        derivative: Derivative,
        t: f64,
        values: &mut [[f64; 3]],
        of_base: impl Fn(Derivative, &mut [[f64; 3]]) -> Result<(), Diagnostic>,
    ) -> Result<(), Diagnostic> {
        let mut base = vec![[0.0; 3]; values.len()];
        values.fill([0.0; 3]);
        let mut choose = 1.0;
        for order in 0..=derivative.t {
            let (linear, offset) = self.placement.at(&self.params, t, order)?;
            let is_zero = linear.iter().flatten().all(|entry| *entry == 0.0);
            if !is_zero {
                of_base(Derivative { t: derivative.t - order, ..derivative }, &mut base)?;
                for (value, base) in values.iter_mut().zip(&base) {
                    for (sum, row) in value.iter_mut().zip(&linear) {
                        *sum += choose * row.iter().zip(base).map(|(entry, x)| entry * x).sum::<f64>();
                    }
                }
            }
            if order == derivative.t && derivative.u + derivative.v == 0 {
                for value in values.iter_mut() {
                    for (sum, x) in value.iter_mut().zip(offset) {
                        *sum += x;
                    }
                }
            }
            choose *= (derivative.t - order) as f64 / (order + 1) as f64;
        }
        finite(values)
    }
}

impl Surface for PlacedSurface {
    fn regions(&self) -> Vec<[[f64; 2]; 2]> {
        self.base.regions()
    }

    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        let mut start = 0;
        // Points of one instant together.
        for run in points.chunk_by(|[.., a], [.., b]| a == b) {
            let (Some([.., t]), Some(slots)) = (run.first(), values.get_mut(start..start + run.len())) else { break };
            self.place(derivative, *t, slots, |derivative, values| self.base.evaluate(derivative, run, values))?;
            start += run.len();
        }
        Ok(())
    }

    fn breaks(&self, domain: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        self.base.breaks(domain, t)
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        self.place(derivative, t, values, |derivative, values| self.base.evaluate_grid(derivative, (u, v, t), values))
    }
}
