//! Whether boundary data ask splines for values beyond their knots.

use super::{Bindings, DomainValues, Patch};
use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Graph, Node};

/// Values of a coordinate at which arguments are looked at, its ends included.
const STEPS: u32 = 32;

/// Of the range of an argument: what rounding does to its ends.
const ROUNDING: f64 = 1e-9;

/// Refuses boundary data whose splines, which are not continued beyond their knots, are evaluated there.
///
/// Arguments are compared at 33 values of each coordinate on which they depend; what slips through between them has no
/// finite value, and is refused where it is computed.
///
/// # Errors
/// [`Code::PointOutsideDomain`] with the spline, the argument and the range.
pub fn check_reach(graph: &Graph, patch: &Patch, bindings: &Bindings, domain: &DomainValues) -> Result<(), Diagnostic> {
    let at_u = patch.conditions.iter().flat_map(|condition| condition.value.into_iter().zip(condition.origins));
    let at_v = patch.side_conditions.iter().flat_map(|side| side.value.into_iter().zip(side.origins));
    for (value, origin) in at_u.chain(at_v) {
        for id in graph.reachable(&[value]) {
            check(graph, (id, origin), bindings, domain)?;
        }
    }
    Ok(())
}

fn check(
    graph: &Graph,
    (id, origin): (ExprId, Option<Span>),
    bindings: &Bindings,
    domain: &DomainValues,
) -> Result<(), Diagnostic> {
    let Node::Spline(call, arguments) = graph.node(id) else { return Ok(()) };
    let spline = &call.spline;
    for (index, argument) in arguments.iter().enumerate().filter(|(index, _)| !spline.is_periodic(*index)) {
        let [low, high] = spline.range(index);
        let slack = ROUNDING * (high - low);
        let depends = graph.dependence(*argument);
        let [u, v, t] = [(depends.u, domain.u), (depends.v, domain.v), (depends.t, domain.t)].map(places);
        let points = u.iter().flat_map(|u| v.iter().map(move |v| (*u, *v)));
        let points = points.flat_map(|(u, v)| t.iter().map(move |t| [u, v, *t]));
        let values = points.map(|point| graph.value(*argument, bindings.as_slice(), point));
        let farthest = values.fold(0.5 * (low + high), |worst: f64, x| {
            let beyond = |x: f64| (low - x).max(x - high);
            if beyond(x) > beyond(worst) { x } else { worst }
        });
        if farthest < low - slack || farthest > high + slack {
            let surface = spline.name().rsplit_once('_').map_or(spline.name(), |(name, _)| name);
            let parameter = spline.argument(index);
            let (farthest, low, high) = (Shortest(farthest), Shortest(low), Shortest(high));
            let message = format!(
                "`{surface}` is asked for at {parameter} = {farthest}, outside the range [{low}, {high}] of its knots"
            );
            return Err(Diagnostic::new(Code::PointOutsideDomain, message)
                .at(origin)
                .hint("a B-spline ends with its knots: change the argument, or the domain of the patch"));
        }
    }
    Ok(())
}

/// Where a coordinate is looked at: at its ends and between, or, if nothing depends on it, anywhere.
fn places((depends, [low, high]): (bool, [f64; 2])) -> Vec<f64> {
    let share = |step: u32| f64::from(step) / f64::from(STEPS);
    let steps = if depends { 0..=STEPS } else { 0..=0 };
    steps.map(|step| low * (1.0 - share(step)) + high * share(step)).collect()
}
