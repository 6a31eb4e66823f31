//! The data of a patch on its four sides, and how they fit together in its corners.
//!
//! Position and tangent on u = a, b are functions of v; on v = c, d functions of u. In each corner the sides say four
//! things twice: S, S_u, S_v and S_uv.

use std::sync::Arc;

use super::Basis;
use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;

/// The data on four sides, as functions that can be evaluated with all their derivatives.
pub struct Sides {
    /// Ranges of u and v.
    pub ranges: [[f64; 2]; 2],
    /// x, y and z of S, then of S_u, at the low end of u, then at the high end: functions of v and t.
    pub at_u: Arc<Basis>,
    /// x, y and z of S, then of S_v, at the low end of v, then at the high end: functions of u and t.
    pub at_v: Arc<Basis>,
}

/// The conditions at both ends of one coordinate.
pub(super) const CONDITIONS: usize = 4;

/// What the sides say in one corner: S, S_u, S_v and S_uv, by the sides at fixed u and by those at fixed v.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Corner {
    /// Which ends of u and v: 0 for the low one, 1 for the high one.
    pub ends: [usize; 2],
    /// By the side at fixed u.
    pub at_u: [[f64; 3]; 4],
    /// By the side at fixed v.
    pub at_v: [[f64; 3]; 4],
}

impl Corner {
    /// How far the sides differ in S, S_u, S_v and S_uv: the largest component of each.
    #[must_use]
    pub fn mismatch(&self) -> [f64; 4] {
        let mut found = [0.0_f64; 4];
        for ((most, a), b) in found.iter_mut().zip(&self.at_u).zip(&self.at_v) {
            *most = a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        }
        found
    }
}

impl Sides {
    /// The four corners at instant `t`, or their derivatives of order `order` in t; the end of v changes faster.
    ///
    /// # Errors
    /// As [`Basis::values`].
    pub fn corners(&self, params: &[f64], t: f64, order: usize) -> Result<[Corner; 4], Diagnostic> {
        let mut corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|ends| Corner { ends, ..Corner::default() });
        let [range_u, range_v] = self.ranges;
        for slope in 0..2 {
            let along = Derivative::new(0, slope, order);
            let at_u = self.at_u.values(along, params, &range_v, &[t, t])?;
            let at_v = self.at_v.values(along, params, &range_u, &[t, t])?;
            for corner in &mut corners {
                let [i, j] = corner.ends;
                for stated in 0..2 {
                    for component in 0..3 {
                        // Condition 2i + order at an end; a row of two values, for the ends, for each component.
                        let value = |all: &[f64], end: usize, at: usize| {
                            all.get(((2 * end + stated) * 3 + component) * 2 + at).copied().unwrap_or(f64::NAN)
                        };
                        // S_u is stated at fixed u and a slope at fixed v; S_v the other way round.
                        let places = [(&mut corner.at_u, stated + 2 * slope, value(&at_u, i, j))];
                        let others = [(&mut corner.at_v, slope + 2 * stated, value(&at_v, j, i))];
                        for (slots, quantity, value) in places.into_iter().chain(others) {
                            if let Some(slot) = slots.get_mut(quantity).and_then(|slot| slot.get_mut(component)) {
                                *slot = value;
                            }
                        }
                    }
                }
            }
        }
        Ok(corners)
    }
}
