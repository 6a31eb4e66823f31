//! A document's net: its layers evaluated at an instant, and filled.

use std::sync::Arc;

use super::{Filled, fill};
use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, ExprId, Graph, Variable};
use crate::limits::Limits;
use crate::problem::{Bindings, DomainValues, Layer, Net, NetPoints, Problem, Sampling};
use crate::surface::{KnotVector, MovingBspline};

/// The name of the method that fills nets: the closed form of its masks (docs/bspline.md, N4).
pub const METHOD: &str = "mask";

/// Derivatives of a moving net in t that are computed with it.
const RATES: usize = 2;

/// Of the largest coordinate of the layers: where two layers cross they may differ by this much.
const LARGEST_DISAGREEMENT: f64 = 1e-9;

/// A net of a document that is ready to be filled, for any parameters and at any instant.
pub struct NetSolver {
    /// The net, symbolically.
    pub net: Net,
    /// Ranges of u, v and t for the current parameters.
    pub domain: DomainValues,
    graph: Graph,
    /// Of the layers, and of their derivatives in t as far as those exist; empty for given points.
    orders: Vec<Arc<dyn Evaluator>>,
    moves: bool,
}

/// A net filled at one instant.
pub struct SolvedNet {
    /// The surface, its amplification and what is to be said of it.
    pub filled: Filled,
    /// The surface with its derivatives in t.
    pub surface: Arc<MovingBspline>,
}

/// Knots and the numbers behind symbols, at one instant.
struct Instant<'a> {
    bindings: &'a Bindings,
    knots: &'a [KnotVector; 2],
    /// Where u and v are taken, for each i and each j.
    places: [Vec<f64>; 2],
    t: f64,
}

impl NetSolver {
    /// Compiles the layers of `net`, which belongs to `problem`, and checks its knots.
    ///
    /// # Errors
    /// A domain without extent; knots that are none or repeat inside; a value that is not finite.
    pub fn new(
        problem: &Problem,
        net: &Net,
        bindings: &Bindings,
        backend: Backend,
        limits: &Limits,
    ) -> Result<NetSolver, Diagnostic> {
        let mut graph = problem.graph.clone();
        let (mut orders, mut moves) = (Vec::new(), false);
        if let NetPoints::Layers { layers, .. } = &net.points {
            let values: Vec<ExprId> = layers.iter().flatten().flat_map(|layer| layer.value).collect();
            moves = values.iter().any(|value| graph.dependence(*value).t);
            orders.push(compile(Program::compile(&graph, &values), backend).0);
            let allowed = graph.size().saturating_add(limits.graph_nodes);
            for order in (1..=RATES).take_while(|_| moves) {
                let wanted = Derivative { t: order, ..Derivative::NONE };
                let rates = values.iter().map(|value| graph.derivative_within(*value, wanted, allowed));
                // Asked for or not: what has no derivative is refused when it is.
                let Ok(rates) = rates.collect::<Result<Vec<ExprId>, _>>() else { break };
                orders.push(compile(Program::compile(&graph, &rates), backend).0);
            }
        }
        let domain = net.domain_in(&graph, bindings)?;
        let solver = NetSolver { net: net.clone(), domain, graph, orders, moves };
        solver.knots(bindings)?;
        Ok(solver)
    }

    /// The domain for other values of the parameters.
    ///
    /// # Errors
    /// As [`NetSolver::new`].
    pub fn domain_for(&self, bindings: &Bindings) -> Result<DomainValues, Diagnostic> {
        self.knots(bindings)?;
        self.net.domain_in(&self.graph, bindings)
    }

    /// The knot vectors of u and v.
    fn knots(&self, bindings: &Bindings) -> Result<[KnotVector; 2], Diagnostic> {
        let domain = self.net.domain_in(&self.graph, bindings)?;
        let [origin_u, origin_v] = self.net.knots.each_ref().map(|knots| knots.origin.or(self.net.origin));
        let of = |variable, range, origin| {
            let knots = self.net.knots_in(variable, range, &self.graph, bindings)?;
            let knots = KnotVector::new(3, knots).and_then(|knots| {
                super::cardinal::Cardinal::new(&knots, variable.name())?;
                Ok(knots)
            });
            knots.map_err(|finding: Diagnostic| finding.at(origin))
        };
        Ok([of(Variable::U, domain.u, origin_u)?, of(Variable::V, domain.v, origin_v)?])
    }

    /// Evaluates the layers at instant `t` and fills the net.
    ///
    /// # Errors
    /// As [`NetSolver::new`]; [`Code::PointNotFinite`] with the place of the layer, [`Code::LayersDisagree`], those of
    /// [`fill`].
    pub fn solve(&self, bindings: &Bindings, t: f64) -> Result<SolvedNet, Diagnostic> {
        let knots = self.knots(bindings)?;
        let [u, v] = &knots;
        let filled = |net: &[[f64; 3]]| {
            let mut filled = fill(u, v, net).map_err(|finding| at(finding, &self.net))?;
            filled.warnings = filled.warnings.into_iter().map(|warning| at(warning, &self.net)).collect();
            Ok::<_, Diagnostic>(filled)
        };
        let (layers, sampling, ranges) = match &self.net.points {
            NetPoints::Given(points) => {
                let filled = filled(points)?;
                let surface = Arc::new(MovingBspline::resting(filled.surface.clone()));
                return Ok(SolvedNet { filled, surface });
            }
            NetPoints::Layers { layers, sampling, ranges } => (layers, *sampling, ranges),
        };
        let mut places = [Vec::new(), Vec::new()];
        for ((places, knots), range) in places.iter_mut().zip(&knots).zip(ranges) {
            *places = self.places(knots, sampling, *range, bindings)?;
        }
        let instant = Instant { bindings, knots: &knots, places, t };
        let of_order = |evaluator: &Arc<dyn Evaluator>| filled(&self.layers(&**evaluator, layers, &instant)?);
        let (first, rest) = self.orders.split_first().ok_or_else(|| Diagnostic::new(Code::NetSize, "no layers"))?;
        let filled = of_order(first)?;
        let surface = match self.moves {
            // Rates that are not finite at this instant are not known; that is told to those who ask for them.
            true => {
                let rates = rest.iter().map_while(|evaluator| of_order(evaluator).ok()).map(|rate| rate.surface);
                MovingBspline::moving(filled.surface.clone(), rates.collect(), t)
            }
            false => MovingBspline::resting(filled.surface.clone()),
        };
        Ok(SolvedNet { filled, surface: Arc::new(surface) })
    }

    /// Where u or v is taken for each control point of a direction.
    fn places(
        &self,
        knots: &KnotVector,
        sampling: Sampling,
        range: Option<[ExprId; 2]>,
        bindings: &Bindings,
    ) -> Result<Vec<f64>, Diagnostic> {
        let [start, end] = knots.domain();
        let [low, high] = match range {
            None => [start, end],
            Some(ends) => {
                let [low, high] = ends.map(|end| {
                    bindings.constant_in(&self.graph, end, self.net.origin, "the range of a surface's parameter")
                });
                [low?, high?]
            }
        };
        let last = (knots.points() - 1) as f64;
        Ok(match sampling {
            Sampling::Lattice => (0..knots.points()).map(|index| low + (high - low) * (index as f64 / last)).collect(),
            Sampling::Greville if [low, high] == [start, end] => knots.greville(),
            Sampling::Greville => {
                let place = |x: f64| low + (high - low) * ((x - start) / (end - start));
                knots.greville().into_iter().map(place).collect()
            }
        })
    }

    /// A net of which the layers are filled in.
    fn layers(
        &self,
        evaluator: &dyn Evaluator,
        layers: &[[Layer; 3]; 2],
        instant: &Instant<'_>,
    ) -> Result<Vec<[f64; 3]>, Diagnostic> {
        let [rows, columns] = instant.knots.each_ref().map(KnotVector::points);
        let mut net = vec![[0.0; 3]; rows * columns];
        // Both layers that cross in a point; an entry for each of the nine.
        let mut crossings: Vec<([usize; 2], [f64; 3])> = Vec::with_capacity(9);
        let mut params = instant.bindings.as_slice().to_vec();
        params.resize(params.len().max(self.graph.symbols().len()), f64::NAN);
        let mut size = 0.0_f64;
        let mut values = vec![0.0; evaluator.program().outputs()];
        let [of_i, of_j] = [[0, 1, rows - 1], [0, 1, columns - 1]];
        for (direction, (fixed, stated)) in [of_i, of_j].into_iter().zip(layers).enumerate() {
            let along = if direction == 0 { columns } else { rows };
            for (which, (fixed, layer)) in fixed.into_iter().zip(stated).enumerate() {
                for moving in 0..along {
                    let (i, j) = if direction == 0 { (fixed, moving) } else { (moving, fixed) };
                    let point = instant.evaluate(evaluator, &self.net, (i, j), &mut params, &mut values);
                    let point =
                        point.and_then(|()| values.get(9 * direction + 3 * which..)).and_then(<[f64]>::first_chunk);
                    let point: [f64; 3] = point.copied().unwrap_or([f64::NAN; 3]);
                    if !point.iter().all(|x| x.is_finite()) {
                        let name = format!("P({i}, {j})");
                        return Err(crate::surface::bspline::point_not_finite(&name, Some(&point)).at(layer.origin));
                    }
                    size = point.iter().fold(size, |most, x| most.max(x.abs()));
                    let Some(slot) = net.get_mut(i * columns + j) else { continue };
                    if direction == 0 {
                        *slot = point;
                    } else if of_i.contains(&i) {
                        crossings.push(([i, j], point));
                    } else {
                        *slot = point;
                    }
                }
            }
        }
        for ([i, j], point) in crossings {
            let other = net.get(i * columns + j).copied().unwrap_or(point);
            let apart = point.iter().zip(other).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            if apart > LARGEST_DISAGREEMENT * size {
                let message = format!(
                    "the layers i = {i} and j = {j} give P({i}, {j}) two places, {apart:.1e} apart: {} and {}",
                    spelled(other),
                    spelled(point)
                );
                let [of_i, _] = layers;
                let origin = of_i.get(if i < 2 { i } else { 2 }).and_then(|layer| layer.origin);
                return Err(Diagnostic::new(Code::LayersDisagree, message)
                    .at(origin)
                    .hint("layers share the points where they cross; give both the same value there"));
            }
        }
        Ok(net)
    }
}

impl Instant<'_> {
    /// Writes the values of all layers for control point (i, j).
    fn evaluate(
        &self,
        evaluator: &dyn Evaluator,
        net: &Net,
        (i, j): (usize, usize),
        params: &mut [f64],
        values: &mut [f64],
    ) -> Option<()> {
        let [symbol_i, symbol_j] = net.index;
        *params.get_mut(symbol_i.index())? = i as f64;
        *params.get_mut(symbol_j.index())? = j as f64;
        let [in_u, in_v] = &self.places;
        let (u, v) = (*in_u.get(i)?, *in_v.get(j)?);
        evaluator.evaluate(params, Samples { u: &[u], v: &[v], t: &[self.t] }, values).ok()
    }
}

fn at(finding: Diagnostic, net: &Net) -> Diagnostic {
    if finding.span.is_some() { finding } else { finding.at(net.origin) }
}

fn spelled(point: [f64; 3]) -> String {
    let [x, y, z] = point.map(Shortest);
    format!("[{x}, {y}, {z}]")
}
