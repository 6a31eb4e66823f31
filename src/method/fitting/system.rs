//! Least-squares systems over all collocation points: a row for each point, a column for each term of each basis
//! function that is fitted with the others.
//!
//! The residual at a point is `Σ_j Σ_p a_jp(u, v, t) G_j^(p)(u) - q` (docs/methods.md, Q2); nothing is assumed of the
//! a_jp, so rows are neither merged nor reduced.

use nalgebra::DMatrix;

use crate::decompose::Decomposition;
use crate::method::Fit;
use crate::method::equation::Equation;
use crate::trial::{CorrectedTrial, Modes};

/// Basis functions and components that one matrix serves.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// Indices of basis functions.
    pub members: Vec<usize>,
    /// Components, each a right-hand side.
    pub components: Vec<usize>,
}

/// What is fitted together.
///
/// In a joint fit a component is a sum over the basis functions of its own boundary data, as in the paper; if a force
/// acts on it, over all, since the force may need any.
pub fn groups(decomposition: &Decomposition, fit: Fit, is_vector: bool) -> Vec<Group> {
    let all = 0..decomposition.basis.len();
    let mut groups: Vec<Group> = Vec::new();
    match fit {
        Fit::PerBasis if is_vector => {
            groups.extend(all.flat_map(|j| (0..3).map(move |c| Group { members: vec![j], components: vec![c] })));
        }
        Fit::PerBasis => groups.extend(all.map(|j| Group { members: vec![j], components: vec![0, 1, 2] })),
        Fit::Joint => {
            for (component, force) in decomposition.patch.operator.force.iter().enumerate() {
                let graph = &decomposition.graph;
                let is_needed = |j: &usize| {
                    let mut stated = decomposition.coefficients.iter().filter_map(|row| row.get(*j)?.get(component));
                    !graph.is_zero(*force) || stated.any(|coefficient| !graph.is_zero(*coefficient))
                };
                let members: Vec<usize> = all.clone().filter(is_needed).collect();
                match groups.iter_mut().find(|group| !is_vector && group.members == members) {
                    Some(group) => group.components.push(component),
                    None if members.is_empty() => {}
                    None => groups.push(Group { members, components: vec![component] }),
                }
            }
        }
    }
    groups
}

/// The equation at the collocation points at one instant.
pub struct Collocation<'a> {
    /// The compiled equation.
    pub equation: &'a Equation,
    /// Values of [`Equation::symbols_at`] at the points, those of one node in u after the other.
    pub symbols: &'a [f64],
    /// The force at the points: by component and derivative in t; empty without a force.
    pub force: &'a [f64],
    /// Nodes in v.
    pub nodes_in_v: usize,
    /// For each order in u that occurs: rows are nodes in u, columns cardinal functions.
    cardinal: Vec<DMatrix<f64>>,
    /// The same for the corrected trial functions.
    trial: Vec<DMatrix<f64>>,
}

impl<'a> Collocation<'a> {
    /// Tabulates `modes` at the nodes `u`.
    pub fn new(
        equation: &'a Equation,
        modes: &CorrectedTrial,
        (u, nodes_in_v): (&[f64], usize),
        (symbols, force): (&'a [f64], &'a [f64]),
    ) -> Collocation<'a> {
        let (count, conditions) = (modes.count(), modes.cardinal_count());
        let (mut cardinal, mut trial) = (Vec::new(), Vec::new());
        for &order in &equation.orders_in_u {
            let rows: Vec<f64> = u.iter().flat_map(|&u| modes.derivatives(order, u)).collect();
            let table = DMatrix::from_row_slice(u.len(), count, &rows);
            cardinal.push(table.columns(0, conditions).into_owned());
            trial.push(table.columns(conditions, count - conditions).into_owned());
        }
        Collocation { equation, symbols, force, nodes_in_v, cardinal, trial }
    }

    fn points(&self) -> usize {
        self.trial.first().map_or(0, DMatrix::nrows) * self.nodes_in_v
    }

    /// The matrix of `group` and the residual without any terms, and their derivatives in t; `stated` holds the
    /// boundary coefficients of every basis function.
    pub fn systems(&self, group: &Group, stated: &[DMatrix<f64>]) -> (Vec<DMatrix<f64>>, Vec<DMatrix<f64>>) {
        let terms = self.trial.first().map_or(0, DMatrix::ncols);
        let derivatives = 0..=self.equation.orders_in_t;
        let assemble = |order: usize| {
            let mut matrix = DMatrix::zeros(self.points(), terms * group.members.len());
            let mut right = self.force_of(group, order);
            for (&member, first) in group.members.iter().zip((0..).step_by(terms.max(1))) {
                let Some(stated) = stated.get(member) else { continue };
                let stated = stated.select_columns(&group.components);
                let symbols = self.symbols_of(member, group.components.first().copied().unwrap_or(0), order);
                let tables = self.trial.iter().zip(&self.cardinal);
                for (symbol, (trial, cardinal)) in symbols.chunks(self.points().max(1)).zip(tables) {
                    self.spread(&mut matrix, first, symbol, trial);
                    self.spread(&mut right, 0, symbol, &(cardinal * &stated));
                }
            }
            (matrix, right)
        };
        derivatives.map(assemble).unzip()
    }

    /// Adds `symbol(u, v) * table(u)` to the columns of `target` from `first` on.
    fn spread(&self, target: &mut DMatrix<f64>, first: usize, symbol: &[f64], table: &DMatrix<f64>) {
        let nodes = self.nodes_in_v;
        for (l, (along_v, row)) in symbol.chunks(nodes.max(1)).zip(table.row_iter()).enumerate() {
            let mut part = target.view_mut((l * nodes, first), (nodes, table.ncols()));
            part += DMatrix::from_column_slice(nodes, 1, along_v) * row;
        }
    }

    /// The a_jp of a basis function and a component, differentiated in t `order` times, for all p.
    fn symbols_of(&self, member: usize, component: usize, order: usize) -> &[f64] {
        let (equation, points) = (self.equation, self.points());
        let component = if equation.is_vector() { component } else { 0 };
        let length = equation.orders_in_u.len() * points;
        let start = member * equation.values_per_function(points)
            + component * equation.values_per_component(points)
            + order * length;
        self.symbols.get(start..start + length).unwrap_or_default()
    }

    /// `-q`, a column for each component of the group.
    fn force_of(&self, group: &Group, order: usize) -> DMatrix<f64> {
        let points = self.points();
        DMatrix::from_fn(points, group.components.len(), |point, column| {
            let component = group.components.get(column).copied().unwrap_or(0);
            let row = component * (self.equation.orders_in_t + 1) + order;
            -self.force.get(row * points + point).copied().unwrap_or(0.0)
        })
    }
}
