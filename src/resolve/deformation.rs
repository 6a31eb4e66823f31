//! `deform` statements to deformations, their regions compared with the domain.

use super::lower::Lowering;
use super::reading::{Fault, Reading};
use super::scope::{Scope, Value};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Variable;
use crate::problem::{Bindings, Deformation, DomainValues, check_region};
use crate::syntax::ast;

/// The orders of continuity that can be kept, by name.
const KEPT: [&str; 3] = ["C0", "C1", "C2"];

/// Resolves the deformations of a patch; without `numbers` its domain is not known.
pub fn resolve(
    statements: &[ast::Deformation],
    numbers: Option<(&Bindings, DomainValues)>,
    scope: &Scope<'_>,
    reading: &mut Reading<'_>,
) -> Vec<Deformation> {
    let limit = reading.limits.deformations;
    if let Some(statement) = statements.get(limit) {
        let message = format!("more deformations than the limit `deformations` of {limit}");
        reading.report(Diagnostic::new(Code::LimitReached, message).at(statement.span));
    }
    let mut deformations = Vec::new();
    for statement in statements.iter().take(limit) {
        if reading.is_over {
            break;
        }
        let deformation = deformation(statement, numbers, &mut reading.lowering(scope));
        deformations.extend(reading.keep(deformation));
    }
    deformations
}

fn deformation(
    statement: &ast::Deformation,
    numbers: Option<(&Bindings, DomainValues)>,
    lowering: &mut Lowering<'_>,
) -> Result<Deformation, Fault> {
    let continuity = &statement.continuity;
    let Some(keeps) = KEPT.iter().position(|known| *known == continuity.text) else {
        let message = format!("there is no continuity `{}`", continuity.text);
        let finding = Diagnostic::new(Code::RegionDoesNotFit, message).at(continuity.span);
        return Err(finding.hint("a deformation keeps C0, C1 or C2").into());
    };
    let mut region = Vec::with_capacity(2);
    for (range, variable) in statement.region.iter().zip([Variable::U, Variable::V]) {
        if range.variable.text != variable.name() {
            let message =
                format!("the region of a deformation has a range of u and one of v, not of `{}`", range.variable.text);
            let finding = Diagnostic::new(Code::UnexpectedText, message).at(range.variable.span);
            return Err(finding.hint("write `deform u in [a, b], v in [c, d] by [x, y, z] keeping C1`").into());
        }
        let [low, high] = range.interval;
        let ends = [lowering.constant(low, "a region")?, lowering.constant(high, "a region")?];
        let [low, high] = range.interval.map(|end| lowering.tree.span(end));
        let place = Some(low.to(high));
        if let Some((bindings, domain)) = numbers {
            let of_patch = if variable == Variable::U { domain.u } else { domain.v };
            let [low, high] = ends.map(|end| bindings.constant_in(lowering.graph, end, place, "a region"));
            check_region(variable, [low?, high?], of_patch, place)?;
        }
        region.push(ends);
    }
    let place = lowering.tree.span(statement.by);
    let by = match lowering.value(statement.by)? {
        Value::Vector(components) => components,
        Value::Scalar(_) => {
            let finding = Diagnostic::new(Code::NotScalar, "a displacement is a vector").at(place);
            return Err(finding.hint("write `by [x, y, z]`").into());
        }
    };
    let region = <[_; 2]>::try_from(region).map_err(|_| Fault::Follows)?;
    Ok(Deformation { region, by, keeps, origin: Some(statement.span) })
}
