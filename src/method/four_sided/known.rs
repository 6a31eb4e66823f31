//! What patches with the same equation over the same ranges have in common: functions, quadrature and factorised systems.
//!
//! None of it depends on the data or, with coefficients that do not, on t. So a model of many patches is factorised once for
//! each equation and each pair of ranges, not once for each patch and instant.

use std::sync::{Arc, Mutex, PoisonError};

use super::system::System;
use super::weak_form::{Part, Table};
use crate::surface::TabulatedModes;

/// Entries that are kept of each kind; models have few equations and few ranges.
const KEPT: usize = 16;

/// Functions and quadrature over one pair of ranges.
pub struct Frame {
    /// Corrections in u and in v.
    pub terms: [usize; 2],
    pub ranges: [[f64; 2]; 2],
    /// The four cubic Hermite functions and the corrections of each coordinate.
    pub modes: [Arc<TabulatedModes>; 2],
    /// The cubic Hermite functions alone.
    pub hermite: [Arc<TabulatedModes>; 2],
    /// The nodes of the rule in u and of that in v.
    pub nodes: [Vec<f64>; 2],
    pub tables: [Table; 2],
    /// Every pair of nodes, u-major.
    pub all: [Vec<f64>; 2],
}

/// The equations of one operator over one frame.
pub struct Equations {
    frame: Arc<Frame>,
    /// The derivatives of the weak form, and their coefficients at the nodes by part and component.
    shape: Vec<Part>,
    coefficients: Vec<[Vec<f64>; 3]>,
    /// One for all components, or one for each.
    pub systems: Vec<System>,
    /// The first component in which the operator is not elliptic.
    pub not_elliptic: Option<usize>,
}

impl Equations {
    /// Systems for the weak form `shape` with `coefficients` at the nodes of `frame`.
    pub fn new(
        frame: &Arc<Frame>,
        (shape, coefficients): (&[Part], Vec<[Vec<f64>; 3]>),
        systems: Vec<System>,
        not_elliptic: Option<usize>,
    ) -> Equations {
        Equations { frame: Arc::clone(frame), shape: shape.to_vec(), coefficients, systems, not_elliptic }
    }

    /// The coefficients at the nodes, by part and component.
    pub fn coefficients(&self) -> &[[Vec<f64>; 3]] {
        &self.coefficients
    }

    /// Whether these are the equations of such a weak form. Expressions may differ: their values decide.
    fn are(&self, frame: &Arc<Frame>, shape: &[Part], coefficients: &[[Vec<f64>; 3]]) -> bool {
        let same = |(one, other): (&Part, &Part)| one.of_surface == other.of_surface && one.of_test == other.of_test;
        Arc::ptr_eq(&self.frame, frame)
            && self.shape.len() == shape.len()
            && self.shape.iter().zip(shape).all(same)
            && self.coefficients == coefficients
    }
}

/// What was computed so far; clones share it.
#[derive(Clone, Default)]
pub struct Known {
    frames: Arc<Mutex<Vec<Arc<Frame>>>>,
    equations: Arc<Mutex<Vec<Arc<Equations>>>>,
}

impl Known {
    /// The frame over `ranges`, made by `make` if it is not known.
    pub fn frame<E>(
        &self,
        terms: [usize; 2],
        ranges: [[f64; 2]; 2],
        make: impl FnOnce() -> Result<Frame, E>,
    ) -> Result<Arc<Frame>, E> {
        recall(&self.frames, |frame| frame.terms == terms && frame.ranges == ranges, make)
    }

    /// The equations of a weak form, made by `make` if they are not known.
    pub fn equations<E>(
        &self,
        frame: &Arc<Frame>,
        (shape, coefficients): (&[Part], &[[Vec<f64>; 3]]),
        make: impl FnOnce() -> Result<Equations, E>,
    ) -> Result<Arc<Equations>, E> {
        recall(&self.equations, |known| known.are(frame, shape, coefficients), make)
    }
}

/// The kept entry that `is_it`, or a new one, which takes the place of the oldest.
fn recall<T, E>(
    kept: &Mutex<Vec<Arc<T>>>,
    is_it: impl Fn(&T) -> bool,
    make: impl FnOnce() -> Result<T, E>,
) -> Result<Arc<T>, E> {
    let lock = || kept.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = lock().iter().find(|known| is_it(known)) {
        return Ok(Arc::clone(known));
    }
    let made = Arc::new(make()?);
    let mut kept = lock();
    // Another thread may have made it meanwhile: all share one.
    if let Some(known) = kept.iter().find(|known| is_it(known)) {
        return Ok(Arc::clone(known));
    }
    if kept.len() >= KEPT {
        kept.remove(0);
    }
    kept.push(Arc::clone(&made));
    Ok(made)
}

impl std::fmt::Debug for Known {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Known")
    }
}
