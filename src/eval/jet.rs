//! Many functions and their derivatives at once, of which equal ones are computed and stored once.
//!
//! Derivatives repeat each other: of `t sin v` the first in t is `sin v`, a function of its own, and the second is zero.
//! Of the 80 values of Eqs. (29) and (30) with the derivatives that the equation takes, 44 differ and depend on v or t.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::interpreter::{Workspace, are_same};
use super::program::{OpId, Program};
use super::{Backend, EvalError, Evaluator, Samples, compile};
use crate::expr::{ExprId, Graph};
use crate::kernels::{InstructionSet, Rows, are_finite};

/// A list of functions that are evaluated together.
pub struct Jet {
    varying: Arc<dyn Evaluator>,
    /// Those that depend on parameters alone.
    uniform: Arc<dyn Evaluator>,
    places: Vec<Place>,
}

/// Where the values of a function are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Varying(usize),
    Uniform(usize),
}

impl Jet {
    /// The functions `outputs` of `graph`, in order.
    #[must_use]
    pub fn new(graph: &Graph, outputs: &[ExprId], backend: Backend) -> Jet {
        let program = Program::compile(graph, outputs);
        let (mut varying, mut uniform) = (Vec::new(), Vec::new());
        let mut known: FxHashMap<OpId, Place> = FxHashMap::default();
        let place = |id: &OpId| {
            *known.entry(*id).or_insert_with(|| {
                let is_uniform = id.index() < program.uniform().len();
                let all = if is_uniform { &mut uniform } else { &mut varying };
                all.push(*id);
                let index = all.len() - 1;
                if is_uniform { Place::Uniform(index) } else { Place::Varying(index) }
            })
        };
        let places = program.output_ops().iter().map(place).collect();
        Jet {
            varying: compile(program.with_outputs(varying), backend).0,
            uniform: compile(program.with_outputs(uniform), Backend::Interpreter).0,
            places,
        }
    }

    /// The number of functions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The number of functions that differ and depend on u, v or t: so many values are computed for a sample.
    #[must_use]
    pub fn distinct(&self) -> usize {
        self.varying.program().outputs()
    }
}

/// The values of a [`Jet`], and what is kept from one evaluation to the next.
pub struct JetValues {
    jet: Arc<Jet>,
    varying: Rows,
    uniform: Rows,
    workspace: Workspace,
    /// What the rows of `uniform` belong to.
    params: Option<Vec<f64>>,
}

impl JetValues {
    /// Room for values of `jet`; none yet.
    #[must_use]
    pub fn new(jet: Arc<Jet>) -> JetValues {
        let (varying, uniform) = (Rows::default(), Rows::default());
        JetValues { jet, varying, uniform, workspace: Workspace::default(), params: None }
    }

    /// Evaluates every function at every sample.
    ///
    /// # Errors
    /// As [`Evaluator::evaluate`]; the values are then those of before, or none.
    pub fn evaluate(&mut self, params: &[f64], samples: Samples<'_>) -> Result<(), EvalError> {
        self.jet.varying.evaluate_rows(params, samples, &mut self.varying, &mut self.workspace)?;
        let length = samples.u.len();
        let is_known = self.params.as_ref().is_some_and(|known| are_same(known, params));
        if !is_known || self.uniform.length() != length {
            let mut constants = vec![0.0; self.jet.uniform.program().outputs()];
            self.jet.uniform.evaluate(params, Samples { u: &[0.0], v: &[0.0], t: &[0.0] }, &mut constants)?;
            self.uniform.reshape(constants.len(), length);
            self.uniform.iter_mut().zip(&constants).for_each(|(row, value)| row.fill(*value));
            self.params = Some(params.to_vec());
        }
        Ok(())
    }

    /// The values of function number `output`: one for each sample.
    #[must_use]
    pub fn row(&self, output: usize) -> &[f64] {
        match self.jet.places.get(output) {
            Some(Place::Varying(index)) => self.varying.row(*index),
            Some(Place::Uniform(index)) => self.uniform.row(*index),
            None => &[],
        }
    }

    /// The first value that is infinite or NaN: function, sample and value.
    #[must_use]
    pub fn first_non_finite(&self) -> Option<(usize, usize, f64)> {
        let set = InstructionSet::best();
        let rows = self.varying.iter().chain(self.uniform.iter());
        if rows.into_iter().all(|row| are_finite(set, row)) {
            return None;
        }
        (0..self.jet.len()).find_map(|output| {
            let values = self.row(output);
            let sample = values.iter().position(|value| !value.is_finite())?;
            Some((output, sample, *values.get(sample)?))
        })
    }
}
