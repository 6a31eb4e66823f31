//! The equation as data: a list of coefficient times derivative, and a force.

use crate::diagnostic::Span;
use crate::expr::{Derivative, ExprId, Graph};

/// One term `coefficient * ∂S`, with one coefficient for each component of S.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PdeTerm {
    /// The derivative of S.
    pub derivative: Derivative,
    /// The factor for x, y and z; equal unless the equation gives one per component.
    pub coefficient: [ExprId; 3],
}

/// A linear equation `Σ c_r ∂S = q` for the vector S.
#[derive(Debug, Clone)]
pub struct PdeOperator {
    /// The terms, each derivative once, in order of derivative.
    pub terms: Vec<PdeTerm>,
    /// The right-hand side q.
    pub force: [ExprId; 3],
    /// Where the equation is written; `None` for the standard equation.
    pub origin: Option<Span>,
}

/// The standard equation's coefficients: name, derivative, default value (biharmonic).
///
/// `β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ ∂⁴S/∂v⁴ + ρ ∂²S/∂t² + η ∂S/∂t = 0` (You, Ugail and Zhang 2012, Eq. 3).
pub const STANDARD_COEFFICIENTS: [(&str, Derivative, i64); 5] = [
    ("beta", Derivative::new(4, 0, 0), 1),
    ("gamma", Derivative::new(2, 2, 0), 2),
    ("lambda", Derivative::new(0, 4, 0), 1),
    ("rho", Derivative::new(0, 0, 2), 0),
    ("eta", Derivative::new(0, 0, 1), 0),
];

impl PdeOperator {
    /// The standard equation with the symbols β, γ, λ, ρ and η of `graph` as coefficients.
    pub fn standard(graph: &mut Graph) -> PdeOperator {
        let mut terms: Vec<PdeTerm> = STANDARD_COEFFICIENTS
            .iter()
            .map(|(name, derivative, _)| PdeTerm { derivative: *derivative, coefficient: [graph.symbol(name); 3] })
            .collect();
        terms.sort_by_key(|term| std::cmp::Reverse(term.derivative));
        PdeOperator { terms, force: [graph.integer(0); 3], origin: None }
    }

    /// The same equation on the part of `graph` that its own coefficients and force consist of.
    #[must_use]
    pub fn part(&self, graph: &Graph) -> (Graph, PdeOperator) {
        let vectors = self.terms.iter().map(|term| term.coefficient).chain([self.force]);
        let (part, places) = graph.part(&vectors.flatten().collect::<Vec<ExprId>>());
        let mut operator = self.clone();
        let vectors = operator.terms.iter_mut().map(|term| &mut term.coefficient).chain([&mut operator.force]);
        for (slot, place) in vectors.flatten().zip(places) {
            *slot = place;
        }
        (part, operator)
    }

    /// The highest derivative in u: the number of conditions the equation needs.
    #[must_use]
    pub fn order_in_u(&self) -> usize {
        self.terms.iter().map(|term| term.derivative.u).max().unwrap_or(0)
    }

    /// The highest derivative in v.
    #[must_use]
    pub fn order_in_v(&self) -> usize {
        self.terms.iter().map(|term| term.derivative.v).max().unwrap_or(0)
    }

    /// The highest derivative in t.
    #[must_use]
    pub fn order_in_t(&self) -> usize {
        self.terms.iter().map(|term| term.derivative.t).max().unwrap_or(0)
    }

    /// The derivatives in v and t alone that the equation takes of a basis function `F(v, t)`, each once.
    #[must_use]
    pub fn basis_derivatives(&self) -> Vec<Derivative> {
        let mut found: Vec<Derivative> = self.terms.iter().map(|term| Derivative { u: 0, ..term.derivative }).collect();
        found.sort_by_key(|derivative| (derivative.t, derivative.v));
        found.dedup();
        found.retain(|derivative| *derivative != Derivative::NONE);
        found
    }

    /// Whether there is no force.
    #[must_use]
    pub fn is_homogeneous(&self, graph: &Graph) -> bool {
        self.force.iter().all(|component| graph.is_zero(*component))
    }
}
