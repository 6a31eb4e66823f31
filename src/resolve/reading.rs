//! What every stage of resolving works on, and what it reports.

use super::edges::{EdgeMeaning, EdgeUse};
use super::lower::Lowering;
use super::scope::Scope;
use crate::diagnostic::{Class, Diagnostic, Diagnostics, MOST_FINDINGS};
use crate::expr::Graph;
use crate::limits::Limits;
use crate::problem::PrimarySurface;
use crate::syntax::ast::{DataFile, Tree};

/// Why an expression has no value.
#[derive(Debug)]
pub enum Fault {
    /// It is at fault.
    Found(Diagnostic),
    /// It uses a declaration that is at fault, which has been reported.
    Follows,
}

impl From<Diagnostic> for Fault {
    fn from(finding: Diagnostic) -> Fault {
        Fault::Found(finding)
    }
}

/// A document while it is resolved.
pub struct Reading<'a> {
    /// Its expressions.
    pub tree: &'a Tree,
    /// Where they go.
    pub graph: Graph,
    /// Primary surfaces that were declared.
    pub surfaces: Vec<PrimarySurface>,
    /// The data files it names.
    pub files: &'a [DataFile],
    /// Edges that were declared.
    pub edges: Vec<EdgeMeaning>,
    /// Sides of patches that lie on declared edges.
    pub edge_uses: Vec<EdgeUse>,
    /// Bounds on the graph.
    pub limits: &'a Limits,
    /// What comes from data files, as statements.
    pub data: Vec<String>,
    /// What was found so far.
    pub found: Diagnostics,
    /// Whether a limit was reached or nothing more is to be said; every later stage would only repeat it.
    pub is_over: bool,
}

impl<'a> Reading<'a> {
    /// Nothing read, nothing found.
    pub fn new(tree: &'a Tree, graph: Graph, limits: &'a Limits) -> Reading<'a> {
        Reading {
            tree,
            graph,
            files: &[],
            surfaces: Vec::new(),
            edges: Vec::new(),
            edge_uses: Vec::new(),
            data: Vec::new(),
            limits,
            found: Diagnostics::new(),
            is_over: false,
        }
    }

    /// The declared edge `name` and its place among them.
    pub fn edge(&self, name: &str) -> Option<(usize, &EdgeMeaning)> {
        self.edges.iter().enumerate().find(|(_, edge)| edge.name == name)
    }

    /// A lowering of expressions whose names mean what `scope` says.
    pub fn lowering<'s>(&'s mut self, scope: &'s Scope<'s>) -> Lowering<'s> {
        Lowering { tree: self.tree, graph: &mut self.graph, scope, limits: self.limits }
    }

    /// The value, or `None` with the reason reported.
    pub fn keep<T>(&mut self, result: Result<T, impl Into<Fault>>) -> Option<T> {
        match result.map_err(Into::into) {
            Ok(value) => Some(value),
            Err(Fault::Follows) => None,
            Err(Fault::Found(finding)) => {
                self.report(finding);
                None
            }
        }
    }

    /// Reports a finding.
    pub fn report(&mut self, finding: Diagnostic) {
        if self.is_over {
            return;
        }
        self.is_over = finding.class() == Class::Limit || self.found.len() + 1 >= MOST_FINDINGS;
        self.found.push(finding);
    }
}
