//! The text form of a [`Decomposition`]: a public contract, stable and symbolic, made for reading and snapshots.

use std::fmt::Write;

use super::{Closure, Decomposition};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{Derivative, ExprId, Notation};
use crate::limits::Limits;
use crate::problem::Constraint;

impl Decomposition {
    /// The symbol of the coefficients of a condition: b, b̄, d, d̄ for position and tangent at two ends
    /// (You, Ugail and Zhang 2012, Eq. 6), c₁, c₂, … otherwise.
    #[must_use]
    pub fn symbol(&self, condition: usize) -> String {
        let orders: Vec<usize> = self.patch.conditions.iter().map(|condition| condition.order).collect();
        let positions: Vec<ExprId> = self.patch.conditions.iter().map(|condition| condition.u).collect();
        let is_standard = matches!(positions.as_slice(), [a, b, c, d] if a == b && c == d) && orders == [0, 1, 0, 1];
        match (is_standard, condition) {
            (true, 0) => "b".to_owned(),
            (true, 1) => "b̄".to_owned(),
            (true, 2) => "d".to_owned(),
            (true, 3) => "d̄".to_owned(),
            _ => crate::expr::unicode_name(&format!("c{}", condition + 1)),
        }
    }

    /// The text of one of the decomposition's expressions.
    ///
    /// # Errors
    /// [`Code::LimitReached`] if it is longer than [`Limits::text_bytes`].
    pub fn text_of(&self, expr: ExprId, notation: Notation, limits: &Limits) -> Result<String, Diagnostic> {
        self.graph.text(expr, notation, limits.text_bytes).map_err(|too_long| {
            let message = format!("an expression is longer than the limit `text-bytes` of {}", too_long.allowed);
            Diagnostic::new(Code::LimitReached, message)
        })
    }

    /// The whole decomposition: basis functions, nonzero coefficients of each condition, needed derivatives, and which
    /// of these do not exist. Of a patch with data on four sides, the data.
    ///
    /// # Errors
    /// As [`Decomposition::text_of`].
    pub fn to_text(&self, notation: Notation, limits: &Limits) -> Result<String, Diagnostic> {
        if self.patch.is_four_sided() {
            return self.sides_to_text(notation, limits);
        }
        let mut text = String::new();
        let count = self.basis.len();
        line(&mut text, format_args!("basis of `{}`: {count} function{}", self.patch.name, plural(count)));
        for (index, function) in self.basis.iter().enumerate() {
            line(&mut text, format_args!("  F{} = {}", index + 1, self.text_of(function.expr, notation, limits)?));
        }
        for (index, condition) in self.patch.conditions.iter().enumerate() {
            let symbol = self.symbol(index);
            let position = self.text_of(condition.u, notation, limits)?;
            let left = Derivative::new(condition.order, 0, 0).of("S", Notation::Unicode);
            line(&mut text, format_args!("\n{left} at u = {position}: Σ {symbol}_j F_j, where not zero"));
            let mut is_zero = true;
            for (j, vector) in self.coefficients.get(index).into_iter().flatten().enumerate() {
                if vector.iter().all(|component| self.graph.is_zero(*component)) {
                    continue;
                }
                is_zero = false;
                let [x, y, z] = vector.map(|component| self.text_of(component, notation, limits));
                line(&mut text, format_args!("  {symbol}_{} = [{}, {}, {}]", j + 1, x?, y?, z?));
            }
            if is_zero {
                line(&mut text, format_args!("  none"));
            }
        }
        line(&mut text, format_args!("\nderivatives the equation names, where not zero"));
        for (index, function) in self.basis.iter().enumerate() {
            for (orders, expr) in &function.derivatives {
                if !self.graph.is_zero(*expr) {
                    let value = self.text_of(*expr, notation, limits)?;
                    line(&mut text, format_args!("  F{}_{orders} = {value}", index + 1));
                }
            }
            let reason = function.fault.as_ref().map_or("", |fault| fault.message.as_str());
            for orders in function.missing(&self.patch.operator) {
                line(&mut text, format_args!("  F{}_{orders} does not exist: {reason}", index + 1));
            }
        }
        Ok(text)
    }

    fn sides_to_text(&self, notation: Notation, limits: &Limits) -> Result<String, Diagnostic> {
        let mut text = String::new();
        let name = &self.patch.name;
        line(&mut text, format_args!("basis of `{name}`: none, data on four sides are interpolated and not factored"));
        for Constraint { across, position, derivative, value } in self.sides() {
            let position = self.text_of(position, notation, limits)?;
            let left = derivative.of("S", Notation::Unicode);
            let [x, y, z] = value.map(|component| self.text_of(component, notation, limits));
            line(&mut text, format_args!("\n{left} at {} = {position}", across.name()));
            line(&mut text, format_args!("  [{}, {}, {}]", x?, y?, z?));
        }
        Ok(text)
    }
}

impl Closure {
    /// The functions that the closure adds to a basis of `basis_size`, and what each derivative of the equation
    /// makes of every function.
    ///
    /// # Errors
    /// [`Code::LimitReached`] for an expression longer than [`Limits::text_bytes`].
    pub fn to_text(&self, basis_size: usize, notation: Notation, limits: &Limits) -> Result<String, Diagnostic> {
        let text_of = |expr: ExprId| {
            self.graph.text(expr, notation, limits.text_bytes).map_err(|too_long| {
                let message = format!("an expression is longer than the limit `text-bytes` of {}", too_long.allowed);
                Diagnostic::new(Code::LimitReached, message)
            })
        };
        let mut text = String::new();
        let added = self.functions.len().saturating_sub(basis_size);
        line(
            &mut text,
            format_args!("closure: {} functions, {added} added without boundary data", self.functions.len()),
        );
        for (index, (function, _)) in self.functions.iter().enumerate().skip(basis_size) {
            line(&mut text, format_args!("  F{} = {}", index + 1, text_of(*function)?));
        }
        for matrix in &self.derivatives {
            line(&mut text, format_args!("\nderivative {}, where not zero", matrix.orders));
            for (j, row) in matrix.rows.iter().enumerate().filter(|(_, row)| !row.is_empty()) {
                let mut terms = Vec::with_capacity(row.len());
                for (k, factor) in row {
                    let factor = text_of(*factor)?;
                    terms.push(match factor.as_str() {
                        "1" => format!("F{}", k + 1),
                        "-1" => format!("-F{}", k + 1),
                        sum if sum.contains(' ') => format!("({sum}) F{}", k + 1),
                        atom => format!("{atom} F{}", k + 1),
                    });
                }
                line(&mut text, format_args!("  ∂F{} = {}", j + 1, terms.join(" + ")));
            }
        }
        Ok(text)
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// Writing to a string does not fail.
fn line(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    let _ = writeln!(text, "{arguments}");
}
