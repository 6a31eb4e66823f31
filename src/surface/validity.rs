//! Where and when a solved surface holds.

use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::kernels::grid::Number;

/// Refuses another instant than the only one at which a solution holds.
pub(super) fn check_instant(instant: Option<f64>, t: f64) -> Result<(), Diagnostic> {
    match instant {
        Some(instant) if instant != t => {
            let (instant, t) = (Shortest(instant), Shortest(t));
            let message = format!("this solution holds at t = {instant}, not at t = {t}");
            Err(Diagnostic::new(Code::UnsupportedByMethod, message).hint("solve at that instant"))
        }
        _ => Ok(()),
    }
}

/// The finding for a derivative in t beyond those that a solution comes with.
pub(super) fn unknown_in_time(order: usize) -> Diagnostic {
    let message = format!("the derivative of order {order} in t is not known for this solution");
    Diagnostic::new(Code::UnsupportedByMethod, message).hint("a fitted method knows the derivatives in t that the equation contains; `exact` knows all, and `pde with …` keeps the standard equation, which contains two")
}

/// Refuses values that overflow.
pub(super) fn finite<N: Number>(values: &[[N; 3]]) -> Result<(), Diagnostic> {
    if values.iter().flatten().all(|value| value.to_f64().is_finite()) {
        return Ok(());
    }
    Err(Diagnostic::new(Code::SolutionNotFinite, "the surface is not finite: its values overflow"))
}
