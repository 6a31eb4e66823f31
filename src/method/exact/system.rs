//! The equation on a closed basis as ordinary differential equations in u, and the order to solve them in.
//!
//! With S = Σ_j G_j(u) F_j(v, t) and ∂F_j = Σ_k A_jk F_k the equation reads, for each function k,
//! `Σ_j Σ_p B^p_kj G_j^(p)(u) = q_k(u)`, `B^p_kj = Σ_{r: p_r = p} c_r A^r_jk` (docs/methods.md, X2).
//! Equations that need each other form a block; blocks are solved one after the other.

use std::collections::BTreeMap;

use crate::decompose::Closure;
use crate::diagnostic::{Code, Diagnostic};
use crate::eval::{Evaluator, Samples};
use crate::expr::{ExprId, Graph};
use crate::problem::PdeOperator;

/// The place of one entry: component, order in u, equation, unknown function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// 0 unless coefficients differ per component.
    pub component: usize,
    /// The equation, one for each function of the closure.
    pub equation: usize,
    /// The function whose G_j the entry multiplies.
    pub unknown: usize,
    /// The order of the derivative of G_j.
    pub order: usize,
}

/// The entries B that are not zero by structure.
#[derive(Debug, Clone)]
pub struct System {
    /// Entries in ascending order of place.
    pub entries: Vec<(Place, ExprId)>,
    /// Whether the three components have different coefficients.
    pub is_vector: bool,
    /// Functions that need each other, in an order in which each block needs only earlier ones.
    pub blocks: Vec<Vec<usize>>,
}

impl System {
    /// Builds the system of `operator` on `closure`, extending `graph`, which is the closure's.
    pub fn build(graph: &mut Graph, closure: &Closure, operator: &PdeOperator) -> System {
        let is_vector = operator.terms.iter().any(|term| matches!(term.coefficient, [x, y, z] if x != y || x != z));
        let one = graph.integer(1);
        let mut parts: BTreeMap<Place, Vec<ExprId>> = BTreeMap::new();
        for term in &operator.terms {
            let along = crate::expr::Derivative { u: 0, ..term.derivative };
            let rows = closure.derivatives.iter().find(|matrix| matrix.orders == along).map(|matrix| &matrix.rows);
            for unknown in 0..closure.functions.len() {
                let identity = [(unknown, one)];
                let row = rows.map_or(&identity[..], |rows| rows.get(unknown).map_or(&[][..], Vec::as_slice));
                for &(equation, factor) in row {
                    for (component, coefficient) in
                        term.coefficient.iter().take(if is_vector { 3 } else { 1 }).enumerate()
                    {
                        let place = Place { component, equation, unknown, order: term.derivative.u };
                        parts.entry(place).or_default().push(graph.product([*coefficient, factor]));
                    }
                }
            }
        }
        let mut entries: Vec<(Place, ExprId)> = Vec::with_capacity(parts.len());
        for (place, terms) in parts {
            let sum = graph.sum(terms);
            if !graph.is_zero(sum) {
                entries.push((place, sum));
            }
        }
        let blocks = blocks(closure.functions.len(), &entries);
        System { entries, is_vector, blocks }
    }
}

/// Strongly connected components of "equation needs unknown", each after those it needs.
fn blocks(count: usize, entries: &[(Place, ExprId)]) -> Vec<Vec<usize>> {
    let mut needs: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut needed_by: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (place, _) in entries.iter().filter(|(place, _)| place.equation != place.unknown) {
        if let Some(list) = needs.get_mut(place.equation) {
            list.push(place.unknown);
        }
        if let Some(list) = needed_by.get_mut(place.unknown) {
            list.push(place.equation);
        }
    }
    // Kosaraju: finish order along one direction, then sweeps against it, last finished first.
    let mut order = Vec::with_capacity(count);
    let mut seen = vec![false; count];
    for start in 0..count {
        visit(start, &needed_by, &mut seen, &mut order);
    }
    let mut found = Vec::new();
    let mut seen = vec![false; count];
    for &start in order.iter().rev() {
        let mut members = Vec::new();
        visit(start, &needs, &mut seen, &mut members);
        if !members.is_empty() {
            members.sort_unstable();
            found.push(members);
        }
    }
    found
}

/// Adds what can be reached from `start` and was not seen, each after what it leads to.
fn visit(start: usize, edges: &[Vec<usize>], seen: &mut [bool], finished: &mut Vec<usize>) {
    let mut stack = vec![(start, 0)];
    match seen.get_mut(start) {
        Some(mark @ false) => *mark = true,
        _ => return,
    }
    while let Some((node, next)) = stack.pop() {
        match edges.get(node).and_then(|list| list.get(next)) {
            Some(&target) => {
                stack.push((node, next + 1));
                if let Some(mark @ false) = seen.get_mut(target) {
                    *mark = true;
                    stack.push((target, 0));
                }
            }
            None => finished.push(node),
        }
    }
}

/// The values of a program of u and the params, output after output.
pub fn evaluate(evaluator: &dyn Evaluator, params: &[f64], u: &[f64]) -> Result<Vec<f64>, Diagnostic> {
    let mut values = vec![0.0; evaluator.program().outputs() * u.len()];
    evaluator
        .evaluate(params, Samples { u, v: u, t: u }, &mut values)
        .map_err(|error| Diagnostic::new(Code::SolutionNotFinite, error.to_string()))?;
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order_of(count: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
        let zero = Graph::new().integer(0);
        let entry = |&(equation, unknown): &(usize, usize)| (Place { component: 0, equation, unknown, order: 0 }, zero);
        blocks(count, &edges.iter().map(entry).collect::<Vec<_>>())
    }

    #[test]
    fn a_chain_is_solved_from_its_end() {
        assert_eq!(order_of(3, &[(0, 1), (1, 2)]), [vec![2], vec![1], vec![0]]);
    }

    #[test]
    fn equations_that_need_each_other_are_one_block() {
        assert_eq!(order_of(4, &[(0, 1), (1, 0), (0, 3), (2, 0)]), [vec![3], vec![0, 1], vec![2]]);
    }
}
