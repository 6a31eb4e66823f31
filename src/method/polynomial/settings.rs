//! The settings of the method, checked against the problem.

use crate::decompose::Decomposition;
use crate::diagnostic::{Code, Diagnostic};
use crate::method::fitting::{Plan, fit, groups};
use crate::method::{Options, Size, Systems, Terms};
use crate::numeric::NodeKind;

/// Powers above those the boundary decides: up to u^7 for an equation of order 4, as in the paper's examples.
const DEFAULT_TERMS: usize = 4;
const DEFAULT_POINTS: usize = 8;

/// The settings in `options`, with defaults.
///
/// # Errors
/// Settings of the wrong form or out of range, [`Code::UnsupportedByMethod`] for a fit that cannot treat the
/// problem, and [`Code::LimitReached`].
pub fn plan(decomposition: &Decomposition, options: &Options) -> Result<Plan, Diagnostic> {
    let operator = &decomposition.patch.operator;
    let lowest = decomposition.patch.conditions.len();
    let terms = terms(lowest, options)?;
    let fit = fit("polynomial", decomposition, options)?;
    let is_vector = operator.terms.iter().any(|term| matches!(term.coefficient, [x, y, z] if x != y || x != z));
    let groups = groups(decomposition, fit, is_vector);
    let members = groups.iter().map(|group| group.members.len()).max().unwrap_or(0);
    let unknowns = terms.saturating_mul(members);
    let default = Size {
        u: terms.saturating_add(1).max(DEFAULT_POINTS),
        v: members.saturating_add(1).max(DEFAULT_POINTS),
        kind: NodeKind::default(),
    };
    let (points, points_origin) = options.settings.points.unwrap_or((default, None));
    let origin = points_origin.or(options.settings.terms.and_then(|(_, origin)| origin));
    let rows = points.u.saturating_mul(points.v);
    if rows == 0 {
        let message = format!("the grid {} x {} has no points", points.u, points.v);
        return Err(Diagnostic::new(Code::SettingOutOfRange, message).at(points_origin));
    }
    if rows < unknowns {
        let message = format!(
            "{} x {} points do not determine {unknowns} terms: {terms} for each of {members} basis functions",
            points.u, points.v
        );
        let finding = Diagnostic::new(Code::SettingOutOfRange, message).at(origin);
        return Err(finding.hint(format!("give at least {} points in u and {members} in v", terms)));
    }
    let limits = &options.limits;
    let orders = operator.order_in_t() + 1;
    let components = if is_vector { 3 } else { 1 };
    let symbols = decomposition.basis.len().saturating_mul(components * (operator.order_in_u() + 1));
    let entries = rows.saturating_mul(orders).saturating_mul(unknowns.max(symbols));
    let systems = Systems { count: groups.len(), rows, unknowns, entries, points: rows };
    systems.check(limits).map_err(|finding| finding.at(origin))?;
    Ok(Plan { terms, points, fit, groups })
}

/// The number of powers, from the highest one.
fn terms(lowest: usize, options: &Options) -> Result<usize, Diagnostic> {
    let (highest, origin) = match options.settings.terms {
        None => return Ok(DEFAULT_TERMS),
        Some((Terms { first, second: None }, origin)) => (first, origin),
        Some((Terms { second: Some(_), .. }, origin)) => {
            let message = "the method `polynomial` has one number of terms, the highest power";
            return Err(Diagnostic::new(Code::UnknownSetting, message).at(origin).hint("write `terms = 7`"));
        }
    };
    if highest < lowest {
        let message = format!(
            "the highest power is {highest}, but the {lowest} boundary conditions decide all powers below {lowest}"
        );
        let finding = Diagnostic::new(Code::SettingOutOfRange, message).at(origin);
        return Err(finding.hint(format!("`terms = {}` fits {DEFAULT_TERMS} powers", lowest + DEFAULT_TERMS - 1)));
    }
    Ok((highest - lowest).saturating_add(1))
}
