//! A part of a function and its arguments along a line of constant u or v.

use super::{Feature, Features};
use crate::eval::{Evaluator, Samples};
use crate::expr::Variable;
use crate::numeric::{NodeKind, nodes};

/// How a function may be steep in its argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Steepness {
    /// It may rise or fall fast, for example at zeros and extrema of the argument.
    Steep,
    /// It is infinite where the argument is zero.
    InfiniteAtZero,
    /// It is infinite where the argument is a whole number of half turns, plus `shift` of them.
    InfiniteAtTurns {
        /// 0 or 1/2.
        shift: f64,
    },
}

/// Values of a part of a function and of its arguments along one line.
pub struct Line<'a> {
    /// Gives the arguments, the terms of the only one if it is a sum, and the part.
    pub evaluator: &'a dyn Evaluator,
    /// The number of arguments.
    pub arguments: usize,
    /// The number of terms.
    pub terms: usize,
    /// The parameters.
    pub params: &'a [f64],
    /// The coordinate that changes.
    pub along: Variable,
    /// The other one.
    pub across: f64,
    /// The instant.
    pub t: f64,
}

/// What a line shows.
pub struct Shown {
    /// Where the part is narrow.
    pub features: Vec<Feature>,
    /// Where it is infinite.
    pub poles: Vec<f64>,
    /// Zeros and extrema of the arguments, the ends left out.
    pub candidates: Vec<f64>,
}

/// Evenly spaced samples of a line.
pub const SAMPLES: usize = 65;

/// Of the distance of samples: what is wider, the grids of fits and of measurements see.
const NARROW: f64 = 0.25;

/// Of what a part changes by in all: a step.
const SHARE: f64 = 0.25;

/// Points into which a bracket is divided at once.
const DIVISION: usize = 16;

/// Divisions at most: a range is down to neighbouring doubles.
const DIVISIONS: usize = 20;

/// Zeros and extrema of one argument; more than that are a wave.
const MOST_CANDIDATES: usize = 48;

/// Of the terms of a sum: what rounding leaves of a sum that is zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl Line<'_> {
    /// Looks for narrow features and poles over `range`; `known` are features of the arguments.
    pub fn examine(&self, steepness: Steepness, range: [f64; 2], known: &[Feature]) -> Shown {
        let spacing = (range[1] - range[0]) / (SAMPLES - 1) as f64;
        let mut at = Features::refined(known, &nodes(NodeKind::Ends, SAMPLES, range), range);
        let mut candidates: Vec<f64> = Vec::new();
        let mut poles: Vec<f64> = Vec::new();
        // Samples around a first candidate may show a second one between the same two samples.
        for _ in 0..2 {
            let rows = self.values(&at);
            let before = candidates.len();
            for argument in 0..self.arguments {
                let Some(values) = rows.get(argument) else { continue };
                self.add_extrema(argument, (&at, values), &mut candidates);
                self.add_crossings((argument, steepness), (&at, values), (&mut candidates, &mut poles));
            }
            let fresh = candidates.get(before..).unwrap_or_default();
            if fresh.is_empty() {
                break;
            }
            let pointed: Vec<Feature> =
                fresh.iter().map(|at| Feature { at: *at, width: spacing * f64::powi(0.5, 48) }).collect();
            at = Features::refined(&pointed, &at, range);
        }
        if steepness == Steepness::InfiniteAtZero {
            poles.extend(candidates.iter().copied().filter(|at| self.is_zero(*at)));
        }
        poles.sort_by(f64::total_cmp);
        poles.dedup();
        let features = self.steps(&at, (&candidates, &poles), spacing);
        Shown { features, poles, candidates }
    }

    /// The outputs at places along the line: a row for each.
    fn values(&self, at: &[f64]) -> Vec<Vec<f64>> {
        let count = at.len();
        let (across, t) = (vec![self.across; count], vec![self.t; count]);
        let samples = match self.along {
            Variable::U => Samples { u: at, v: &across, t: &t },
            _ => Samples { u: &across, v: at, t: &t },
        };
        let mut values = vec![f64::NAN; count * self.evaluator.program().outputs()];
        // Lengths fit by construction; without parameters nothing is known, and nothing is found.
        if self.evaluator.evaluate(self.params, samples, &mut values).is_err() {
            values.fill(f64::NAN);
        }
        values.chunks(count.max(1)).map(<[f64]>::to_vec).collect()
    }

    fn output(&self, index: usize, at: &[f64]) -> Vec<f64> {
        self.values(at).into_iter().nth(index).unwrap_or_default()
    }

    /// The maxima and minima of an argument between its neighbours.
    fn add_extrema(&self, argument: usize, (at, values): (&[f64], &[f64]), candidates: &mut Vec<f64>) {
        for (places, triple) in at.windows(3).zip(values.windows(3)) {
            let (&[low, middle, high], &[a, b, c]) = (places, triple) else { continue };
            let is_maximum = b >= a && b >= c && (b > a || b > c);
            let is_minimum = b <= a && b <= c && (b < a || b < c);
            let is_finite = a.is_finite() && b.is_finite() && c.is_finite();
            let is_known = candidates.iter().any(|known| (low..=high).contains(known));
            if (is_maximum || is_minimum) && is_finite && !is_known && candidates.len() < MOST_CANDIDATES {
                let sign = if is_maximum { 1.0 } else { -1.0 };
                candidates.push(self.maximum(argument, sign, [low, middle, high]));
            }
        }
    }

    /// The maximum of `sign` times an argument between the first and the last place, to neighbouring doubles.
    fn maximum(&self, argument: usize, sign: f64, [mut low, mut best, mut high]: [f64; 3]) -> f64 {
        for _ in 0..DIVISIONS {
            let mut places = nodes(NodeKind::Ends, DIVISION + 1, [low, high]);
            places.push(best);
            places.sort_by(f64::total_cmp);
            places.dedup();
            let values = self.output(argument, &places);
            let most = values.iter().fold(f64::NEG_INFINITY, |most: f64, value| most.max(sign * value));
            let Some(index) = values.iter().position(|value| sign * value == most) else { return best };
            let last = values.iter().rposition(|value| sign * value == most).unwrap_or(index);
            // A plateau is as flat as rounding makes it; its middle is as good as any.
            let middle = usize::midpoint(index, last);
            let place = |index: usize| places.get(index).copied().unwrap_or(best);
            let bracket = [place(index.saturating_sub(1)), place((last + 1).min(places.len() - 1))];
            best = place(middle);
            if bracket == [low, high] {
                return best;
            }
            [low, high] = bracket;
        }
        best
    }

    /// The places at which an argument passes through a level: zero, or where the part is infinite.
    fn add_crossings(
        &self,
        (argument, steepness): (usize, Steepness),
        (at, values): (&[f64], &[f64]),
        (candidates, poles): (&mut Vec<f64>, &mut Vec<f64>),
    ) {
        let level = |value: f64| match steepness {
            Steepness::InfiniteAtTurns { shift } => (value / std::f64::consts::PI - shift).floor(),
            // Zero itself belongs to neither side.
            _ if value == 0.0 => 0.0,
            _ => value.signum(),
        };
        for (places, pair) in at.windows(2).zip(values.windows(2)) {
            let (&[low, high], &[a, b]) = (places, pair) else { continue };
            let is_crossing = a.is_finite() && b.is_finite() && level(a) != level(b);
            let is_known = candidates.iter().any(|known| (low..=high).contains(known));
            if !is_crossing || is_known || candidates.len() >= MOST_CANDIDATES {
                continue;
            }
            let has_turns = matches!(steepness, Steepness::InfiniteAtTurns { .. });
            let place = if a == 0.0 && !has_turns { low } else { self.crossing(argument, level, [low, high]) };
            candidates.push(place);
            if has_turns {
                poles.push(place);
            }
        }
    }

    /// Where the level of an argument is no longer that at the lower end, to neighbouring doubles.
    fn crossing(&self, argument: usize, level: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
        let start = self.output(argument, &[low]).first().copied().map_or(f64::NAN, &level);
        for _ in 0..DIVISIONS {
            let places = nodes(NodeKind::Ends, DIVISION + 1, [low, high]);
            let values = self.output(argument, &places);
            let first = values.iter().position(|value| level(*value) != start).unwrap_or(places.len() - 1).max(1);
            let place = |index: usize| places.get(index).copied().unwrap_or(high);
            let bracket = [place(first - 1), place(first)];
            if bracket == [low, high] {
                break;
            }
            [low, high] = bracket;
        }
        high
    }

    /// Whether the argument is zero at a place, but for rounding: as a limit from both sides, not in a jump.
    fn is_zero(&self, at: f64) -> bool {
        let near = [at.next_down(), at, at.next_up()];
        let rows = self.values(&near);
        let Some(values) = rows.first() else { return false };
        if values.contains(&0.0) {
            return true;
        }
        let Some(terms) = rows.get(self.arguments..self.arguments + self.terms) else { return false };
        let size = terms.iter().flatten().fold(0.0_f64, |most, term| most.max(term.abs()));
        size.is_finite() && values.iter().any(|value| value.abs() <= ROUNDING * size)
    }

    /// Where the part changes by a good share of its size within less than samples at a distance show.
    fn steps(&self, at: &[f64], (candidates, poles): (&[f64], &[f64]), spacing: f64) -> Vec<Feature> {
        let part = self.arguments + self.terms;
        let values = self.output(part, at);
        // A part that overflows, such as an exponential in a denominator, says nothing of the whole.
        if !values.iter().all(|value| value.is_finite()) {
            return Vec::new();
        }
        let most = values.iter().fold(f64::NEG_INFINITY, |most: f64, value| most.max(*value));
        let span = most - values.iter().fold(f64::INFINITY, |least: f64, value| least.min(*value));
        let narrow = NARROW * spacing;
        let samples: Vec<(f64, f64)> = at.iter().copied().zip(values.iter().copied()).collect();
        let mut features: Vec<Feature> = Vec::new();
        for (index, (low, a)) in samples.iter().copied().enumerate() {
            let behind = samples.get(index + 1..).unwrap_or_default();
            let is_near = |(place, (high, _)): &(usize, &(f64, f64))| *place == 0 || *high - low < narrow;
            let step = behind.iter().enumerate().take_while(is_near).find(|(_, (_, b))| (b - a).abs() > SHARE * span);
            let Some((place, (high, b))) = step else { continue };
            // Beside a pole the part is as steep as one likes.
            if poles.iter().any(|pole| (low - spacing..=high + spacing).contains(pole)) {
                continue;
            }
            let [low, high] = if place == 0 { self.step(part, [low, *high], [a, *b]) } else { [low, *high] };
            let (width, middle) = (high - low, 0.5 * (low + high));
            let nearest = candidates.iter().copied().min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs()));
            // The place that explains the step is better known than the step.
            let place = nearest.filter(|candidate| (candidate - middle).abs() <= 4.0 * width).unwrap_or(middle);
            if width < narrow {
                features.push(Feature { at: place, width });
            }
        }
        features
    }

    /// The part of an interval in which the part of the function changes by most of what it changes by in all.
    fn step(&self, part: usize, [mut low, mut high]: [f64; 2], [mut a, mut b]: [f64; 2]) -> [f64; 2] {
        let mut even: Option<[f64; 2]> = None;
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return even.unwrap_or([low, high]);
            }
            let c = self.output(part, &[middle]).first().copied().unwrap_or(f64::NAN);
            let (below, above) = ((c - a).abs(), (b - c).abs());
            // A jump in the very middle leaves as much to each half; only the next halving shows it.
            even = match even {
                _ if below.max(above) > 0.75 * (b - a).abs() => None,
                Some(interval) => return interval,
                None => Some([low, high]),
            };
            if below >= above {
                [high, b] = [middle, c];
            } else {
                [low, a] = [middle, c];
            }
        }
    }
}
