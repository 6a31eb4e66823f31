//! Breakpoints of the parameters of all targets, refined where a fit is too far off.
//!
//! A member is a parameter of a target with its range; members along one edge are linked and have their breakpoints in
//! common, at equal shares of their ranges or at opposite ones.
//!
//! Invariant: neighbouring spans differ in length by [`STEEPEST`] at most. A spline of full smoothness carries what it
//! misses in a short span over to a long one beside it, and it would grow from span to span.

use crate::numeric::{NodeKind, nodes};

/// A parameter of a target.
pub(super) struct Member<'a> {
    pub range: [f64; 2],
    /// Where it is divided in any case.
    pub breaks: &'a [f64],
    /// So many equal spans are as long as one may be at first.
    pub spans: usize,
    /// Whether the target is smooth across the ends of the range.
    pub is_periodic: bool,
}

/// Two members along one edge; reversed if they run through it in opposite directions.
pub(super) struct Link {
    pub members: [usize; 2],
    pub is_reversed: bool,
}

/// The breakpoints of all members.
pub(super) struct Breakpoints {
    lines: Vec<Line>,
    /// Range, line and whether it is run through backwards, for each member.
    places: Vec<([f64; 2], usize, bool)>,
}

/// Breakpoints that members have in common.
struct Line {
    /// From 0 to 1, ascending; `1 - share` is exact for each, so that what runs backwards meets the same ones.
    shares: Vec<f64>,
    /// Into how many pieces each span is to be divided.
    pieces: Vec<usize>,
    /// Whether the last span is beside the first: for every member it is.
    is_periodic: bool,
    /// Whether opposite shares are breakpoints too: an edge runs along the line both ways.
    is_symmetric: bool,
    /// The shortest distance of two breakpoints.
    closest: f64,
}

/// Of two spans side by side, the longer is so many times the shorter at most. A cubic spline that misses a corner by e
/// misses the spans beside it by e r²/(2 + 2r), e (r²/(2 + 2r))², …, where each is r times as long as the one before.
const STEEPEST: f64 = 2.5;

/// Of the largest magnitude in a range: breakpoints are not closer.
const CLOSEST: f64 = 1e-12;

impl Breakpoints {
    /// The first breakpoints.
    pub fn new(members: &[Member], links: &[Link]) -> Breakpoints {
        let mut all = Breakpoints { lines: Vec::new(), places: Vec::new() };
        let mut found: Vec<Option<(usize, bool)>> = vec![None; members.len()];
        for first in 0..members.len() {
            if found.get(first).is_none_or(Option::is_some) {
                continue;
            }
            let line = all.lines.len();
            let (mut reached, mut is_symmetric) = (vec![(first, false)], false);
            let mut next = 0;
            while let Some(&(member, is_reversed)) = reached.get(next) {
                next += 1;
                match found.get_mut(member) {
                    Some(Some((_, known))) => is_symmetric |= *known != is_reversed,
                    Some(place) => {
                        *place = Some((line, is_reversed));
                        for link in links {
                            let [a, b] = link.members;
                            let other = if a == member { b } else { a };
                            if a == member || b == member {
                                reached.push((other, is_reversed != link.is_reversed));
                            }
                        }
                    }
                    None => {}
                }
            }
            let shares = vec![0.0, 1.0];
            all.lines.push(Line { shares, pieces: Vec::new(), is_periodic: true, is_symmetric, closest: 0.0 });
        }
        let mut longest = vec![1.0_f64; all.lines.len()];
        for (member, place) in members.iter().zip(found) {
            let (line, is_reversed) = place.unwrap_or_default();
            let [low, high] = member.range;
            all.places.push((member.range, line, is_reversed));
            if let (Some(line), Some(longest)) = (all.lines.get_mut(line), longest.get_mut(line)) {
                line.is_periodic &= member.is_periodic;
                line.closest = line.closest.max(CLOSEST * low.abs().max(high.abs()) / (high - low));
                *longest = longest.min(1.0 / member.spans as f64);
                let share = |at: &f64| (at - low) / (high - low);
                let turned = |share: f64| if is_reversed { 1.0 - share } else { share };
                line.insert(member.breaks.iter().map(|at| turned(share(at))).collect());
            }
        }
        for (line, longest) in all.lines.iter_mut().zip(longest) {
            // Rounding makes no span longer than it is.
            let pieces = |[a, b]: [f64; 2]| ((b - a) / longest * (1.0 - 4.0 * f64::EPSILON)).ceil().max(1.0) as usize;
            line.pieces = line.spans().map(pieces).collect();
        }
        all.divide();
        all
    }

    /// The breakpoints of a member.
    pub fn of(&self, member: usize) -> Vec<f64> {
        let Some(&([low, high], line, is_reversed)) = self.places.get(member) else { return Vec::new() };
        let shares = self.lines.get(line).map_or(&[][..], |line| line.shares.as_slice());
        let at = |share: f64| low * (1.0 - share) + high * share;
        match is_reversed {
            false => shares.iter().map(|share| at(*share)).collect(),
            true => shares.iter().rev().map(|share| at(1.0 - share)).collect(),
        }
    }

    /// Whether a member, and all that have its breakpoints, is smooth across the ends of its range.
    pub fn is_periodic(&self, member: usize) -> bool {
        let line = self.places.get(member).and_then(|(_, line, _)| self.lines.get(*line));
        line.is_some_and(|line| line.is_periodic)
    }

    /// Asks that each span of a member be divided into so many pieces, or more if others ask for more.
    pub fn ask(&mut self, member: usize, mut pieces: Vec<usize>) {
        let Some((_, line, is_reversed)) = self.places.get(member) else { return };
        let Some(line) = self.lines.get_mut(*line) else { return };
        if *is_reversed {
            pieces.reverse();
        }
        line.pieces.resize(pieces.len(), 1);
        line.pieces.iter_mut().zip(pieces).for_each(|(most, pieces)| *most = (*most).max(pieces));
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
        self.shares.windows(2).filter_map(|span| <[f64; 2]>::try_from(span).ok())
    }

    fn insert(&mut self, mut shares: Vec<f64>) {
        if self.is_symmetric {
            let opposite: Vec<f64> = shares.iter().map(|share| 1.0 - share).collect();
            shares.extend(opposite);
        }
        // What is subtracted from 1 twice has an opposite share without rounding.
        let within = |share: &f64| *share > self.closest && 1.0 - *share > self.closest;
        let inner = shares.into_iter().map(|share| 1.0 - (1.0 - share)).filter(within);
        self.shares.extend(inner);
        self.shares.sort_by(f64::total_cmp);
        let closest = self.closest;
        self.shares.dedup_by(|next, kept| *next - *kept <= closest);
    }

    fn divide(&mut self) {
        let added = self.spans().zip(&self.pieces).flat_map(|(span, pieces)| {
            let most = ((span[1] - span[0]) / (2.0 * self.closest)).floor().max(1.0);
            let inner = nodes(NodeKind::Ends, (*pieces).min(most as usize) + 1, span);
            inner.into_iter().filter(move |x| span[0] < *x && *x < span[1])
        });
        let added: Vec<f64> = added.collect();
        self.insert(added);
    }

    /// Two pieces for spans that are too long beside a neighbour, one for the others.
    fn graded(&self) -> Vec<usize> {
        let lengths: Vec<f64> = self.spans().map(|[a, b]| b - a).collect();
        let count = lengths.len();
        let at = |index: usize| lengths.get(index).copied().unwrap_or(f64::INFINITY);
        // Numbers beyond the last span stand for none.
        let around = |index: usize| if self.is_periodic { index } else { count };
        let pieces = |(index, length): (usize, &f64)| {
            let before = index.checked_sub(1).unwrap_or(around(count - 1));
            let behind = if index + 1 < count { index + 1 } else { around(0) };
            if *length > STEEPEST * at(before).min(at(behind)) { 2 } else { 1 }
        };
        lengths.iter().enumerate().map(pieces).collect()
    }
}
