//! Local deformations, symbolically.

use crate::diagnostic::{Code, Diagnostic, Shortest, Span};
use crate::expr::{ExprId, Graph, Number, Variable};

/// A displacement of a part of the surface: `by` in its middle, falling to zero at its border.
#[derive(Debug, Clone)]
pub struct Deformation {
    /// Ends of the part in u and in v, constant.
    pub region: [[ExprId; 2]; 2],
    /// x, y and z of the displacement, functions of u, v and t.
    pub by: [ExprId; 3],
    /// The highest order of continuity that is kept across the border: 0, 1 or 2 for C0, C1 and C2.
    pub keeps: usize,
    /// Where it is written.
    pub origin: Option<Span>,
}

impl Deformation {
    /// The displacement `by · (16 a (1 - a) b (1 - b))^(keeps + 1)`, where a and b go from 0 to 1 over the region.
    ///
    /// Implements W1 of docs/methods.md (You and Zhang 2003, Eqs. 30 to 32).
    pub fn displacement(&self, graph: &mut Graph) -> [ExprId; 3] {
        let mut factors = Vec::new();
        for ([low, high], variable) in self.region.into_iter().zip([Variable::U, Variable::V]) {
            let at = graph.variable(variable);
            let (above, below) = (graph.difference(at, low), graph.difference(high, at));
            let length = graph.difference(high, low);
            let per_length = graph.power_integer(length, -2);
            // Both differences are exactly zero on the border; 1 - a would leave rounding there.
            let four = graph.number(Number::integer(4));
            factors.push(graph.product([four, per_length, above, below]));
        }
        let bubble = graph.product(factors);
        let exponent = i64::try_from(self.keeps).unwrap_or(i64::MAX).saturating_add(1);
        let weight = graph.power_integer(bubble, exponent);
        self.by.map(|component| graph.product([weight, component]))
    }
}

/// Refuses a region that is empty, reversed or outside the range of the patch in `variable`.
///
/// # Errors
/// [`Code::RegionDoesNotFit`] at `origin`.
pub fn check_region(
    variable: Variable,
    [low, high]: [f64; 2],
    [start, end]: [f64; 2],
    origin: Option<Span>,
) -> Result<(), Diagnostic> {
    let name = variable.name();
    let refuse = |message: String| Diagnostic::new(Code::RegionDoesNotFit, message).at(origin);
    let region = format!("the region {name} in [{}, {}]", Shortest(low), Shortest(high));
    if !(low.is_finite() && high.is_finite()) {
        return Err(refuse(format!("{region} is not finite")));
    }
    if low >= high {
        let finding = refuse(format!("{region} is empty"));
        let advice = if low > high {
            format!("write the smaller end first: `{name} in [{}, {}]`", Shortest(high), Shortest(low))
        } else {
            "the lower end must be below the upper end".to_owned()
        };
        return Err(finding.hint(advice));
    }
    if low < start || high > end {
        let finding = refuse(format!("{region} leaves the patch"));
        return Err(finding.hint(format!("the patch has {name} in [{}, {}]", Shortest(start), Shortest(end))));
    }
    Ok(())
}
