//! B-spline nets, symbolically: knots, size and boundary layers.

use super::{Bindings, Domain, DomainValues};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{ExprId, Graph, SymbolId, Variable};

/// A bicubic B-spline surface whose net follows from its boundary layers by `∂⁶S/∂u³∂v³ = 0`.
#[derive(Debug, Clone)]
pub struct Net {
    /// What the user calls it.
    pub name: String,
    /// Ranges of u, v and t; listed knots replace that of their direction.
    pub domain: Domain,
    /// The knots of u and of v.
    pub knots: [NetKnots; 2],
    /// The numbers n and m of the last control points of u and of v, 3 or more.
    pub last: [usize; 2],
    /// The symbols i and j, the numbers of a control point.
    pub index: [SymbolId; 2],
    /// Where its control points come from.
    pub points: NetPoints,
    /// Where its size is written.
    pub origin: Option<Span>,
}

/// The knots of one direction.
#[derive(Debug, Clone)]
pub struct NetKnots {
    /// Which.
    pub kind: KnotKind,
    /// Where they are written.
    pub origin: Option<Span>,
}

/// How knots are given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum KnotKind {
    /// Equal spans throughout; n - 2 of them make the domain.
    Uniform,
    /// n - 2 equal spans over the domain, with both ends repeated.
    Clamped,
    /// All n + 5 of them, constants.
    Listed(Vec<ExprId>),
}

/// Where the control points of a net come from.
#[derive(Debug, Clone)]
pub enum NetPoints {
    /// The layers i = 0, 1, n and j = 0, 1, m, functions of i, j, u, v and t.
    Layers {
        /// Those of constant i, then those of constant j.
        layers: Box<[[Layer; 3]; 2]>,
        /// Where u and v are taken.
        sampling: Sampling,
        /// The ranges that u and v are taken over; the net's own where none is stated.
        ranges: [Option<[ExprId; 2]>; 2],
    },
    /// Point P_ij at `i (m + 1) + j`; only layers are read.
    Given(Vec<[f64; 3]>),
}

/// A boundary layer.
#[derive(Debug, Clone, Copy)]
pub struct Layer {
    /// x, y and z of its control points.
    pub value: [ExprId; 3],
    /// Where it is written.
    pub origin: Option<Span>,
}

/// Which u and v belong to a control point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// Its Greville point, where it acts most.
    Greville,
    /// A lattice of equal steps from end to end.
    Lattice,
}

impl Net {
    /// The domain as numbers: listed knots give that of their direction, `[t_3, t_(n+1)]`.
    ///
    /// # Errors
    /// As [`Domain::evaluate_in`].
    pub fn domain_in(&self, graph: &Graph, bindings: &Bindings) -> Result<DomainValues, Diagnostic> {
        let mut domain = self.domain.clone();
        let directions = self.knots.iter().zip(self.last).zip(domain.ends.iter_mut().zip(&mut domain.origins));
        for ((knots, last), (ends, origin)) in directions {
            let KnotKind::Listed(listed) = &knots.kind else { continue };
            if let (Some(low), Some(high)) = (listed.get(3), listed.get(last + 1)) {
                *ends = [*low, *high];
                *origin = knots.origin;
            }
        }
        domain.evaluate_in(graph, bindings).map_err(|finding| match finding.code {
            // Not as a domain: the user wrote knots.
            Code::EmptyDomain if self.knots.iter().any(|knots| knots.origin == finding.span) => {
                Diagnostic::new(Code::KnotsNotAscending, "the knots leave the net no domain")
                    .at(finding.span)
                    .hint("knots are numbers in ascending order; the domain of a net n x m is [t_3, t_(n+1)]")
            }
            _ => finding,
        })
    }

    /// All knots of direction `variable` as numbers, over its domain.
    ///
    /// # Errors
    /// [`Code::ParameterNotFinite`] for a listed knot.
    pub fn knots_in(
        &self,
        variable: Variable,
        [low, high]: [f64; 2],
        graph: &Graph,
        bindings: &Bindings,
    ) -> Result<Vec<f64>, Diagnostic> {
        let direction = usize::from(variable == Variable::V);
        let (Some(knots), Some(&last)) = (self.knots.get(direction), self.last.get(direction)) else {
            return Ok(Vec::new());
        };
        let spans = last.saturating_sub(2);
        // The ends are exactly those of the domain.
        let at = |place: f64| match place {
            _ if place == 0.0 => low,
            _ if place == spans as f64 => high,
            _ => low + (high - low) * (place / spans as f64),
        };
        match &knots.kind {
            KnotKind::Uniform => Ok((0..last + 5).map(|knot| at(knot as f64 - 3.0)).collect()),
            KnotKind::Clamped => Ok((0..last + 5).map(|knot| at(knot.saturating_sub(3).min(spans) as f64)).collect()),
            KnotKind::Listed(listed) => {
                let name = variable.name();
                let number = |(index, expr): (usize, &ExprId)| {
                    bindings.constant_in(graph, *expr, knots.origin, &format!("knot {index} of {name}"))
                };
                listed.iter().enumerate().map(number).collect()
            }
        }
    }
}
