//! Functions of one coordinate with tables of their values: many surfaces ask for the same functions at the same nodes.

use std::sync::{Arc, Mutex, PoisonError};

use nalgebra::DMatrix;

use crate::trial::{CorrectedTrial, Modes};

/// Tables that are kept: a few orders at the nodes of a quadrature, of a verification and of seams.
const KEPT: usize = 64;
/// Longer tables are not kept: meshes ask once.
const LONGEST: usize = 1024;

/// Functions and the tables that were made of them; whoever shares the one shares the other.
#[derive(Debug)]
pub struct TabulatedModes {
    modes: CorrectedTrial,
    tables: Mutex<Vec<Arc<ModeTable>>>,
}

/// One derivative of every function at some nodes.
#[derive(Debug)]
pub struct ModeTable {
    order: usize,
    nodes: Vec<f64>,
    /// A row for each node, a column for each function.
    pub values: DMatrix<f64>,
    /// A row for each function.
    pub transposed: DMatrix<f64>,
}

impl TabulatedModes {
    /// Without any table.
    #[must_use]
    pub fn new(modes: CorrectedTrial) -> Self {
        TabulatedModes { modes, tables: Mutex::default() }
    }

    /// The number of functions.
    #[must_use]
    pub fn count(&self) -> usize {
        self.modes.count()
    }

    /// The derivatives of order `order` of every function at one place.
    #[must_use]
    pub fn derivatives(&self, order: usize, at: f64) -> Vec<f64> {
        self.modes.derivatives(order, at)
    }

    /// The derivatives of order `order` of every function at `nodes`.
    #[must_use]
    pub fn table(&self, order: usize, nodes: &[f64]) -> Arc<ModeTable> {
        // A panic elsewhere leaves the list whole.
        let lock = || self.tables.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().iter().find(|table| table.order == order && table.nodes == nodes) {
            return Arc::clone(known);
        }
        let rows: Vec<f64> = nodes.iter().flat_map(|at| self.modes.derivatives(order, *at)).collect();
        let values = DMatrix::from_row_slice(nodes.len(), self.modes.count(), &rows);
        let transposed = values.transpose();
        let table = Arc::new(ModeTable { order, nodes: nodes.to_vec(), values, transposed });
        if nodes.len() <= LONGEST {
            let mut tables = lock();
            if tables.len() >= KEPT {
                tables.remove(0);
            }
            tables.push(Arc::clone(&table));
        }
        table
    }
}
