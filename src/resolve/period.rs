//! Whether a domain whose data almost repeat at its ends lets them repeat: `v in [0, 6.28]` leaves a slit that no
//! picture shows.

use std::f64::consts::{PI, TAU};

use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Graph, Node};
use crate::problem::{Bindings, Patch, Problem};

/// Of the length of the domain: who misses a period by more meant something else.
const NEAR: f64 = 0.01;

/// Of the length of the domain: what rounding leaves of a period that is written with all its digits.
const EXACT: f64 = 1e-12;

/// Where data are compared with themselves one period further, as shares of the domain: no common fractions.
const SHARES: [f64; 5] = [0.0, 0.1459, 0.3819, 0.6180, 0.8541];

/// The warning for a patch whose boundary data repeat in v close to the end of its domain, and not there.
pub fn missed(problem: &Problem, patch: &Patch, bindings: &Bindings) -> Option<Diagnostic> {
    let domain = patch.domain.evaluate(problem, bindings).ok().filter(|_| !patch.is_four_sided())?;
    let ([low, high], [start, end]) = (domain.v, domain.t);
    let t = start + 0.381_966 * (end - start);
    let data: Vec<ExprId> = patch.conditions.iter().flat_map(|condition| condition.value).collect();
    let value = |expr: ExprId, v: f64| problem.graph.value(expr, bindings.as_slice(), [0.0, v, t]);
    let period = TAU / common_frequency(&frequencies(&problem.graph, &data, |expr, v| value(expr, low + v)))?;
    let whole = ((high - low) / period).round().max(1.0) * period;
    let miss = (high - low) - whole;
    let share = miss.abs() / (high - low);
    if !(EXACT..=NEAR).contains(&share) {
        return None;
    }
    let repeats = |expr: &ExprId| {
        SHARES.iter().map(|share| low + share * (high - low)).all(|v| {
            let (here, further) = (value(*expr, v), value(*expr, v + whole));
            (here - further).abs() <= 1e-9 * (1.0 + here.abs())
        })
    };
    if !data.iter().all(repeats) {
        return None;
    }
    let side = if miss < 0.0 { "before" } else { "behind the place where" };
    let message = format!("the domain of v ends {:.1e} {side} the boundary data repeat", miss.abs());
    let length = spelled(whole);
    let finding = Diagnostic::new(Code::PeriodMissed, message)
        .at(patch.domain.origins[1].or(patch.boundary_origin()))
        .marked(format!("they repeat after {length}"));
    let is_degrees = [90.0, 180.0, 270.0, 360.0, 720.0].contains(&(high - low));
    Some(if is_degrees {
        finding.hint("angles are in radians: a turn of 360 degrees is `2π`, and `v` in degrees is `sin(π v/180)`")
    } else if low == 0.0 {
        finding.hint(format!("write `v in [0, {length}]` for a surface that closes"))
    } else {
        finding.hint(format!("end it at {} for a surface that closes", low + whole))
    })
}

/// The factors of v inside trigonometric functions; `value` is that of an expression at some v.
fn frequencies(graph: &Graph, data: &[ExprId], value: impl Fn(ExprId, f64) -> f64) -> Vec<f64> {
    let argument = |part: ExprId| match graph.node(part) {
        Node::Call(function, arguments)
            if matches!(function.row().name, "sin" | "cos" | "tan" | "cot" | "sec" | "csc") =>
        {
            arguments.first().copied().filter(|argument| graph.dependence(*argument).v)
        }
        _ => None,
    };
    let slope = |argument: ExprId| {
        let [at_0, at_1, at_2] = [0.0, 1.0, 2.0].map(|v| value(argument, v));
        let slope = at_1 - at_0;
        ((at_2 - at_1 - slope).abs() <= 1e-9 * slope.abs()).then_some(slope.abs())
    };
    graph.reachable(data).into_iter().filter_map(argument).filter_map(slope).collect()
}

/// The largest number of which all frequencies are multiples; `None` for none, or if there is no such number.
fn common_frequency(frequencies: &[f64]) -> Option<f64> {
    let mut common: Option<f64> = None;
    for &frequency in frequencies {
        let (mut a, mut b) = (common.unwrap_or(frequency).max(frequency), common.unwrap_or(frequency).min(frequency));
        // Below a thousandth it is the rounding of numbers that have nothing in common.
        while b > 1e-3 * frequency {
            (a, b) = (b, (a - b * (a / b).round()).abs());
        }
        if b > 1e-9 * frequency {
            return None;
        }
        common = Some(a);
    }
    common.filter(|common| *common > 0.0)
}

/// A length as a multiple of π if it is one.
fn spelled(length: f64) -> String {
    let parts = (1..=12).map(|below| (f64::from(below), length / PI * f64::from(below)));
    let mut whole = parts.filter(|(_, above)| (above - above.round()).abs() <= 1e-12 * above);
    match whole.next().map(|(below, above)| (below, above.round())) {
        None => length.to_string(),
        Some((below, above)) => {
            let above = if above == 1.0 { "π".to_owned() } else { format!("{above}π") };
            if below == 1.0 { above } else { format!("{above}/{below}") }
        }
    }
}
