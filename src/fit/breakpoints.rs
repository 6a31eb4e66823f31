//! Breakpoints of each parameter range, refined where a fit is too far off.

use crate::numeric::{NodeKind, nodes};

/// Breakpoints by range. Targets with the same range have them in common.
#[derive(Default)]
pub(super) struct Breakpoints {
    lines: Vec<([f64; 2], Vec<f64>)>,
}

/// One round splits a span into this many at most: an error estimate on coarse spans is not to be trusted further.
const MOST_PIECES: f64 = 8.0;

impl Breakpoints {
    /// Adds a range of `spans` equal spans, unless it is there.
    pub fn add(&mut self, range: [f64; 2], spans: usize) {
        if !self.lines.iter().any(|(other, _)| *other == range) {
            self.lines.push((range, nodes(NodeKind::Ends, spans + 1, range)));
        }
    }

    /// The breakpoints of a range.
    pub fn of(&self, range: [f64; 2]) -> &[f64] {
        self.lines.iter().find(|(other, _)| *other == range).map_or(&[], |(_, line)| line.as_slice())
    }

    /// Splits every span whose error is above `goal` into as many as bring it there at order `degree + 1`.
    ///
    /// `errors` are those of spans, by their middle: another target may have split some already.
    pub fn refine(&mut self, range: [f64; 2], errors: &[([f64; 2], f64)], goal: f64, degree: usize) {
        let Some((_, line)) = self.lines.iter_mut().find(|(other, _)| *other == range) else { return };
        let mut added = Vec::new();
        for (span, error) in errors {
            // Written so that what is not finite is split as far as may be.
            if *error <= goal {
                continue;
            }
            let pieces = libm::pow(error / goal, 1.0 / (degree as f64 + 1.0)).ceil().clamp(2.0, MOST_PIECES);
            let inner = nodes(NodeKind::Ends, pieces as usize + 1, *span);
            added.extend(inner.into_iter().filter(|x| span[0] < *x && *x < span[1]));
        }
        line.extend(added);
        line.sort_by(f64::total_cmp);
        line.dedup();
    }
}
