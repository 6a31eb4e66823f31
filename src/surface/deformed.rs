//! Surfaces with local deformations: any surface, and displacements that act on parts of its domain.
//!
//! A displacement and its derivatives up to the order it keeps vanish on the border of its region (docs/methods.md,
//! L1), so the surface stays as smooth across the border as that order says, and as it was elsewhere.

use std::sync::Arc;

use super::validity::finite;
use super::{Functions, Surface};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::eval::{Backend, Evaluator, Program, Samples, compile};
use crate::expr::{Derivative, Variable};
use crate::limits::Limits;
use crate::problem::{Deformation, Problem, check_region};

/// A compiled deformation, for any parameters.
pub struct Bump {
    displacement: Functions,
    /// Both ends in u, then in v.
    ends: Arc<dyn Evaluator>,
    origin: Option<Span>,
}

/// The part of the domain on which a bump acts, and the bump.
pub struct Region {
    /// Range in u.
    pub u: [f64; 2],
    /// Range in v.
    pub v: [f64; 2],
    bump: Arc<Bump>,
}

/// A surface and what is added to it; where regions overlap their displacements add up.
pub struct DeformedSurface {
    base: Arc<dyn Surface + Send + Sync>,
    regions: Vec<Region>,
    params: Vec<f64>,
}

/// The highest order of continuity that a deformation can keep.
const MOST_KEPT: usize = 2;

impl Bump {
    /// Compiles a deformation of `problem`.
    ///
    /// # Errors
    /// [`Code::RegionDoesNotFit`] for an order of continuity above 2.
    pub fn compile(
        problem: &Problem,
        deformation: &Deformation,
        backend: Backend,
        limits: &Limits,
    ) -> Result<Bump, Diagnostic> {
        if deformation.keeps > MOST_KEPT {
            let message = format!("a deformation cannot keep C{}", deformation.keeps);
            return Err(Diagnostic::new(Code::RegionDoesNotFit, message)
                .at(deformation.origin)
                .hint("it keeps C0, C1 or C2"));
        }
        let mut graph = problem.graph.clone();
        let ends = deformation.region.concat();
        let (ends, _) = compile(Program::compile(&graph, &ends), Backend::Interpreter);
        let displacement = deformation.displacement(&mut graph).map(|expr| (expr, deformation.origin)).to_vec();
        let displacement = Functions::new(&graph, &displacement, backend, limits);
        Ok(Bump { displacement, ends, origin: deformation.origin })
    }

    /// The region for the given parameters, once it is found to lie in the ranges of u and v.
    fn region(self: &Arc<Bump>, params: &[f64], ranges: [[f64; 2]; 2]) -> Result<Region, Diagnostic> {
        let mut values = [0.0; 4];
        self.ends
            .evaluate(params, Samples { u: &[0.0], v: &[0.0], t: &[0.0] }, &mut values)
            .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
        let [u_low, u_high, v_low, v_high] = values;
        let found = [[u_low, u_high], [v_low, v_high]];
        for ((range, of_patch), variable) in found.into_iter().zip(ranges).zip([Variable::U, Variable::V]) {
            check_region(variable, range, of_patch, self.origin)?;
        }
        Ok(Region { u: found[0], v: found[1], bump: Arc::clone(self) })
    }
}

impl DeformedSurface {
    /// `base`, over `ranges` of u and v, with `bumps`.
    ///
    /// # Errors
    /// [`Code::RegionDoesNotFit`] for a region that is empty, reversed or outside the ranges.
    pub fn new(
        base: Arc<dyn Surface + Send + Sync>,
        bumps: &[Arc<Bump>],
        params: &[f64],
        ranges: [[f64; 2]; 2],
    ) -> Result<DeformedSurface, Diagnostic> {
        let regions = bumps.iter().map(|bump| bump.region(params, ranges)).collect::<Result<_, _>>()?;
        Ok(DeformedSurface { base, regions, params: params.to_vec() })
    }

    /// Adds the displacements at `points` to `values`.
    fn displace(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        for region in &self.regions {
            let contains = |range: [f64; 2], at: f64| range[0] <= at && at <= range[1];
            let inside: Vec<usize> = points
                .iter()
                .enumerate()
                .filter(|(_, [u, v, _])| contains(region.u, *u) && contains(region.v, *v))
                .map(|(index, _)| index)
                .collect();
            if inside.is_empty() {
                continue;
            }
            let coordinate = |axis: usize| -> Vec<f64> {
                let points = inside.iter().filter_map(|index| points.get(*index));
                points.filter_map(|point| point.get(axis)).copied().collect()
            };
            let (u, v, t) = (coordinate(0), coordinate(1), coordinate(2));
            let bump = &region.bump;
            let added = bump.displacement.values(derivative, &self.params, Samples { u: &u, v: &v, t: &t })?;
            if let Some(at) = added.iter().position(|value| !value.is_finite()) {
                let at = at % inside.len();
                let [u, v, t] = [&u, &v, &t].map(|all| Shortest(all.get(at).copied().unwrap_or(f64::NAN)));
                let message = format!("a deformation is not finite at u = {u}, v = {v}, t = {t}");
                return Err(Diagnostic::new(Code::DataNotFinite, message)
                    .at(bump.origin)
                    .hint("a displacement must be finite on its whole region; change the function or the region"));
            }
            for (component, row) in added.chunks(inside.len()).enumerate() {
                for (index, value) in inside.iter().zip(row) {
                    if let Some(slot) = values.get_mut(*index).and_then(|vector| vector.get_mut(component)) {
                        *slot += value;
                    }
                }
            }
        }
        finite(values)
    }
}

impl Surface for DeformedSurface {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        self.base.evaluate(derivative, points, values)?;
        self.displace(derivative, points, values)
    }

    fn regions(&self) -> Vec<[[f64; 2]; 2]> {
        let own = self.regions.iter().map(|region| [region.u, region.v]);
        self.base.regions().into_iter().chain(own).collect()
    }

    fn breaks(&self, domain: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        let mut breaks = self.base.breaks(domain, t)?;
        for region in &self.regions {
            let borders = breaks.iter_mut().zip([region.u, region.v]).zip(domain);
            for ((breaks, borders), [low, high]) in borders {
                breaks.extend(borders.into_iter().filter(|border| low < *border && *border < high));
            }
        }
        Ok(breaks)
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        self.base.evaluate_grid(derivative, (u, v, t), values)?;
        let points: Vec<[f64; 3]> = u.iter().flat_map(|&u| v.iter().map(move |&v| [u, v, t])).collect();
        self.displace(derivative, &points, values)
    }
}
