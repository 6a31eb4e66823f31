//! The hash-consed expression graph: equal expressions are one node.
//!
//! Invariant: a node's operands have smaller ids than the node itself, so every walk over an expression is a
//! loop over ascending ids and no depth a text decides can exhaust the stack.
//! Nodes are only made by the constructors in [`simplify`](super::simplify), so every node is in canonical form.

use std::sync::Arc;

use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

use super::function::Function;
use super::number::Number;
use super::spline::SplineCall;

/// A node of a [`Graph`]; meaningful only together with the graph that made it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ExprId(u32);

/// A named quantity whose value comes from outside; the index into the values an evaluation is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SymbolId(u32);

impl SymbolId {
    /// Position among the graph's symbols, and in every slice of parameter values.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One of the three coordinates of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Variable {
    /// Across the blend.
    U,
    /// Along the trimlines.
    V,
    /// Time.
    T,
}

impl Variable {
    /// All three, in order.
    pub const ALL: [Variable; 3] = [Variable::U, Variable::V, Variable::T];

    /// `u`, `v` or `t`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Variable::U => "u",
            Variable::V => "v",
            Variable::T => "t",
        }
    }
}

/// A number known by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Constant {
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// Euler's number.
    E,
}

/// An expression in canonical form.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number.
    Number(Number),
    /// `pi` or `e`.
    Constant(Constant),
    /// A parameter.
    Symbol(SymbolId),
    /// `u`, `v` or `t`.
    Variable(Variable),
    /// Two or more terms; at most one is a number, no two differ only by a numeric factor.
    Sum(Box<[ExprId]>),
    /// Two or more factors; at most one is a number and it stands first, no two have the same base.
    Product(Box<[ExprId]>),
    /// Base and exponent.
    Power(ExprId, ExprId),
    /// A function of its arguments.
    Call(Function, Box<[ExprId]>),
    /// A piecewise polynomial of its arguments.
    Spline(SplineCall, Box<[ExprId]>),
}

/// Which of u, v and t an expression depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dependence {
    /// On u.
    pub u: bool,
    /// On v.
    pub v: bool,
    /// On t.
    pub t: bool,
}

impl Dependence {
    /// Whether the expression depends on parameters and numbers alone.
    #[must_use]
    pub fn is_constant(self) -> bool {
        !(self.u || self.v || self.t)
    }

    fn union(self, other: Dependence) -> Dependence {
        Dependence { u: self.u || other.u, v: self.v || other.v, t: self.t || other.t }
    }
}

/// An arena of expressions that share their common parts.
///
/// A clone shares what it was cloned from until one of the two grows.
#[derive(Debug, Clone)]
pub struct Graph {
    nodes: Arc<IndexSet<Node, FxBuildHasher>>,
    dependence: Arc<Vec<Dependence>>,
    symbols: Arc<IndexSet<String, FxBuildHasher>>,
    /// Of all nodes together.
    operands: usize,
    /// Operands merged so far.
    work: usize,
    /// Derivatives that were taken: another order, or a function with a part in common, starts from them.
    derivatives: Arc<FxHashMap<(ExprId, Variable), ExprId>>,
}

impl Default for Graph {
    fn default() -> Self {
        Graph::new()
    }
}

impl Graph {
    /// A graph that holds 1, 0, -1, u, v and t.
    #[must_use]
    pub fn new() -> Self {
        let mut graph = Graph {
            nodes: Arc::default(),
            dependence: Arc::default(),
            symbols: Arc::default(),
            operands: 0,
            work: 0,
            derivatives: Arc::default(),
        };
        // Made first so that they come first wherever canonical order is id order: `1 - t`, `t sin(v)`.
        for value in [1, 0, -1] {
            graph.intern(Node::Number(Number::integer(value)));
        }
        for variable in Variable::ALL {
            graph.intern(Node::Variable(variable));
        }
        graph
    }

    /// The number of distinct nodes and of all their operands: its memory, and the quantity that
    /// [`Limits::graph_nodes`](crate::limits::Limits) bounds. Few nodes can have many operands: the derivative of a
    /// product of n factors has n of n each.
    #[must_use]
    pub fn size(&self) -> usize {
        self.nodes.len() + self.operands
    }

    /// The number of operands that sums and products have merged so far. Unlike [`Graph::size`] it grows with terms
    /// that cancel or were made before, so it bounds time where the size bounds memory.
    #[must_use]
    pub fn work(&self) -> usize {
        self.work
    }

    /// Counts operands that are about to be merged.
    pub(super) fn count_work(&mut self, operands: usize) {
        self.work = self.work.saturating_add(operands);
    }

    /// The number of distinct nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are no nodes; never true for a graph made by [`Graph::new`].
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The node behind an id.
    #[must_use]
    pub fn node(&self, id: ExprId) -> &Node {
        self.nodes.get_index(id.0 as usize).expect("an ExprId is used with the graph that made it")
    }

    /// What an expression depends on.
    #[must_use]
    pub fn dependence(&self, id: ExprId) -> Dependence {
        self.dependence.get(id.0 as usize).copied().expect("an ExprId is used with the graph that made it")
    }

    /// The number behind an id, if it is one.
    #[must_use]
    pub fn as_number(&self, id: ExprId) -> Option<Number> {
        match self.node(id) {
            Node::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// Whether the expression is exactly zero.
    #[must_use]
    pub fn is_zero(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    /// Whether the expression is exactly one.
    #[must_use]
    pub fn is_one(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Number::is_one)
    }

    /// The operands of a node, in order; empty for leaves.
    #[must_use]
    pub fn operands(&self, id: ExprId) -> Vec<ExprId> {
        match self.node(id) {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Variable(_) => Vec::new(),
            Node::Sum(operands) | Node::Product(operands) | Node::Call(_, operands) | Node::Spline(_, operands) => {
                operands.to_vec()
            }
            Node::Power(base, exponent) => vec![*base, *exponent],
        }
    }

    /// The names of the symbols, in the order in which values are passed.
    pub fn symbols(&self) -> impl ExactSizeIterator<Item = &str> {
        self.symbols.iter().map(String::as_str)
    }

    /// The name of a symbol.
    #[must_use]
    pub fn symbol_name(&self, symbol: SymbolId) -> &str {
        self.symbols
            .get_index(symbol.index())
            .map(String::as_str)
            .expect("a SymbolId is used with the graph that made it")
    }

    /// The symbol called `name`, made if there is none.
    pub fn symbol_id(&mut self, name: &str) -> SymbolId {
        let known = self.symbols.get_index_of(name);
        let index = known.unwrap_or_else(|| Arc::make_mut(&mut self.symbols).insert_full(name.to_owned()).0);
        SymbolId(u32::try_from(index).expect("limits keep a graph far below 2^32 symbols"))
    }

    /// Every node that `roots` consist of, operands before the nodes that use them.
    ///
    /// Cost: about the number of those nodes and of their operands, however large the graph is.
    #[must_use]
    pub fn reachable(&self, roots: &[ExprId]) -> Vec<ExprId> {
        let mut seen: FxHashSet<ExprId> = FxHashSet::default();
        let mut pending = roots.to_vec();
        while let Some(id) = pending.pop() {
            if seen.insert(id) {
                self.for_each_operand(id, |operand| pending.push(operand));
            }
        }
        let mut found: Vec<ExprId> = seen.into_iter().collect();
        found.sort_unstable();
        found
    }

    /// The graph of what `roots` consist of alone, and the roots in it, in order.
    ///
    /// Symbols keep their indices and nodes their order, so what is made of the part does not depend on what else
    /// the whole holds. Cost: as [`Graph::reachable`], and that of the symbols.
    #[must_use]
    pub fn part(&self, roots: &[ExprId]) -> (Graph, Vec<ExprId>) {
        let mut part = Graph { symbols: Arc::clone(&self.symbols), ..Graph::new() };
        let mut places: FxHashMap<ExprId, ExprId> = FxHashMap::default();
        for id in self.reachable(roots) {
            let place = |id: &ExprId| *places.get(id).expect("operands come before the nodes that use them");
            let places_of = |ids: &[ExprId]| ids.iter().map(place).collect();
            let node = match self.node(id) {
                leaf @ (Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Variable(_)) => leaf.clone(),
                Node::Sum(terms) => Node::Sum(places_of(terms)),
                Node::Product(factors) => Node::Product(places_of(factors)),
                Node::Power(base, exponent) => Node::Power(place(base), place(exponent)),
                Node::Call(function, arguments) => Node::Call(*function, places_of(arguments)),
                Node::Spline(call, arguments) => Node::Spline(call.clone(), places_of(arguments)),
            };
            let place = part.intern(node);
            places.insert(id, place);
        }
        let roots = roots.iter().filter_map(|root| places.get(root).copied()).collect();
        (part, roots)
    }

    fn for_each_operand(&self, id: ExprId, mut visit: impl FnMut(ExprId)) {
        match self.node(id) {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Variable(_) => {}
            Node::Sum(operands) | Node::Product(operands) | Node::Call(_, operands) | Node::Spline(_, operands) => {
                operands.iter().copied().for_each(visit);
            }
            Node::Power(base, exponent) => {
                visit(*base);
                visit(*exponent);
            }
        }
    }

    /// The id of `node`, which must be in canonical form.
    pub(super) fn intern(&mut self, node: Node) -> ExprId {
        let dependence = match &node {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) => Dependence::default(),
            Node::Variable(variable) => {
                Dependence { u: *variable == Variable::U, v: *variable == Variable::V, t: *variable == Variable::T }
            }
            Node::Sum(operands) | Node::Product(operands) | Node::Call(_, operands) | Node::Spline(_, operands) => {
                operands.iter().fold(Dependence::default(), |all, &id| all.union(self.dependence(id)))
            }
            Node::Power(base, exponent) => self.dependence(*base).union(self.dependence(*exponent)),
        };
        let operands = match &node {
            Node::Number(_) | Node::Constant(_) | Node::Symbol(_) | Node::Variable(_) => 0,
            Node::Sum(operands) | Node::Product(operands) | Node::Call(_, operands) | Node::Spline(_, operands) => {
                operands.len()
            }
            Node::Power(..) => 2,
        };
        // Looked up first: a clone that finds all it asks for stays shared.
        let index = self.nodes.get_index_of(&node).unwrap_or_else(|| {
            self.operands += operands;
            Arc::make_mut(&mut self.dependence).push(dependence);
            Arc::make_mut(&mut self.nodes).insert_full(node).0
        });
        ExprId(u32::try_from(index).expect("limits keep a graph far below 2^32 nodes"))
    }

    /// The derivative of an expression in one variable, if it was taken before.
    pub(super) fn known_derivative(&self, expr: ExprId, variable: Variable) -> Option<ExprId> {
        self.derivatives.get(&(expr, variable)).copied()
    }

    /// Remembers a derivative.
    pub(super) fn remember_derivative(&mut self, expr: ExprId, variable: Variable, derivative: ExprId) {
        Arc::make_mut(&mut self.derivatives).insert((expr, variable), derivative);
    }
}
