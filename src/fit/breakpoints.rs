//! Breakpoints of each parameter range, refined where a fit is too far off.
//!
//! Invariant: neighbouring spans differ in length by [`STEEPEST`] at most. A spline of full smoothness carries what it
//! misses in a short span over to a long one beside it, and it would grow from span to span.

use crate::numeric::{NodeKind, nodes};

/// Breakpoints by range. Targets with the same range have them in common.
#[derive(Default)]
pub(super) struct Breakpoints {
    lines: Vec<Line>,
}

struct Line {
    range: [f64; 2],
    breakpoints: Vec<f64>,
    /// Into how many pieces each span is to be divided.
    pieces: Vec<usize>,
    /// Whether the last span is beside the first.
    is_periodic: bool,
}

/// Of two spans side by side, the longer is so many times the shorter at most. A cubic spline that misses a corner by e
/// misses the spans beside it by e r²/(2 + 2r), e (r²/(2 + 2r))², …, where each is r times as long as the one before.
const STEEPEST: f64 = 2.5;

/// Of the largest magnitude in a range: breakpoints are not closer.
const CLOSEST: f64 = 1e-12;

impl Breakpoints {
    /// Adds a range that is divided at `breaks`, unless it is there; then it is divided there as well.
    pub fn add(&mut self, range: [f64; 2], breaks: &[f64], is_periodic: bool) {
        let line = match self.lines.iter().position(|line| line.range == range) {
            Some(known) => self.lines.get_mut(known),
            None => {
                let line = Line { range, breakpoints: range.to_vec(), pieces: Vec::new(), is_periodic: false };
                self.lines.push(line);
                self.lines.last_mut()
            }
        };
        if let Some(line) = line {
            line.is_periodic |= is_periodic;
            line.insert(breaks.iter().copied());
        }
    }

    /// The breakpoints of a range.
    pub fn of(&self, range: [f64; 2]) -> &[f64] {
        self.lines.iter().find(|line| line.range == range).map_or(&[], |line| line.breakpoints.as_slice())
    }

    /// Divides all spans that are longer than one of `spans` equal ones.
    pub fn start(&mut self, spans: usize) {
        for line in &mut self.lines {
            let [low, high] = line.range;
            let longest = (high - low) / spans as f64;
            // Rounding makes no span longer than it is.
            let pieces = |[a, b]: [f64; 2]| ((b - a) / longest * (1.0 - 4.0 * f64::EPSILON)).ceil().max(1.0) as usize;
            line.pieces = line.spans().map(pieces).collect();
        }
        self.divide();
    }

    /// Asks that each span of a range be divided into so many pieces, or more if others ask for more.
    pub fn ask(&mut self, range: [f64; 2], pieces: &[usize]) {
        let Some(line) = self.lines.iter_mut().find(|line| line.range == range) else { return };
        line.pieces.resize(pieces.len(), 1);
        line.pieces.iter_mut().zip(pieces).for_each(|(most, pieces)| *most = (*most).max(*pieces));
    }

    /// Divides spans as was asked, then those that are too long beside their neighbours.
    pub fn divide(&mut self) {
        for line in &mut self.lines {
            line.divide();
            loop {
                line.pieces = line.graded();
                if line.pieces.iter().all(|pieces| *pieces == 1) {
                    break;
                }
                line.divide();
            }
            line.pieces.clear();
        }
    }
}

impl Line {
    fn spans(&self) -> impl Iterator<Item = [f64; 2]> {
        self.breakpoints.windows(2).filter_map(|span| <[f64; 2]>::try_from(span).ok())
    }

    /// The shortest distance of two breakpoints.
    fn closest(&self) -> f64 {
        CLOSEST * self.range.iter().fold(0.0_f64, |most, end| most.max(end.abs()))
    }

    fn insert(&mut self, places: impl Iterator<Item = f64>) {
        let (closest, [_, high]) = (self.closest(), self.range);
        self.breakpoints.extend(places);
        self.breakpoints.sort_by(f64::total_cmp);
        // The ends stay: the first of close ones does, and none is close to the last.
        self.breakpoints.dedup_by(|next, kept| *next - *kept <= closest);
        self.breakpoints.retain(|at| *at == high || high - *at > closest);
        if self.breakpoints.last() != Some(&high) {
            self.breakpoints.push(high);
        }
    }

    fn divide(&mut self) {
        let closest = self.closest();
        let added: Vec<f64> = self
            .spans()
            .zip(&self.pieces)
            .flat_map(|(span, pieces)| {
                let most = ((span[1] - span[0]) / (2.0 * closest)).floor().max(1.0);
                let pieces = (*pieces).min(most as usize);
                let inner = nodes(NodeKind::Ends, pieces + 1, span);
                inner.into_iter().filter(move |x| span[0] < *x && *x < span[1])
            })
            .collect();
        self.insert(added.into_iter());
    }

    /// Two pieces for spans that are too long beside a neighbour, one for the others.
    fn graded(&self) -> Vec<usize> {
        let lengths: Vec<f64> = self.spans().map(|[a, b]| b - a).collect();
        let at = |index: Option<usize>| index.and_then(|index| lengths.get(index)).copied();
        let around = |index: usize, count: usize| (self.is_periodic && count > 1).then_some(index);
        let pieces = |(index, length): (usize, &f64)| {
            let before = at(index.checked_sub(1).or(around(lengths.len() - 1, lengths.len())));
            let behind = at((index + 1 < lengths.len()).then_some(index + 1).or(around(0, lengths.len())));
            let shortest = before.into_iter().chain(behind).fold(f64::INFINITY, f64::min);
            if *length > STEEPEST * shortest { 2 } else { 1 }
        };
        lengths.iter().enumerate().map(pieces).collect()
    }
}
