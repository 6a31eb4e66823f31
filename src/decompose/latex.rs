//! The LaTeX form of a [`Decomposition`]: one `aligned` environment, for documents with `amsmath` and for KaTeX.

use super::Decomposition;
use crate::diagnostic::Diagnostic;
use crate::expr::{Derivative, ExprId, Notation};
use crate::limits::Limits;
use crate::problem::Constraint;

impl Decomposition {
    /// Basis functions, each condition as a sum over them with its nonzero coefficients, and the nonzero derivatives
    /// that the equation needs, or the data on four sides: the facts of [`Decomposition::to_text`].
    ///
    /// # Errors
    /// As [`Decomposition::text_of`].
    pub fn to_latex(&self, limits: &Limits) -> Result<String, Diagnostic> {
        let text = |expr: ExprId| self.text_of(expr, Notation::Latex, limits);
        let column = |vector: [ExprId; 3]| {
            let [x, y, z] = vector.map(text);
            Ok(format!(r"\begin{{bmatrix}} {} \\ {} \\ {} \end{{bmatrix}}", x?, y?, z?))
        };
        let mut rows = Vec::new();
        for Constraint { across, position, derivative, value } in self.sides() {
            let left = derivative.of(r"\mathbf{S}", Notation::Latex);
            rows.push(format!(
                r"\left.{left}\right|_{{{} = {}}} &= {}",
                across.name(),
                text(position)?,
                column(value)?
            ));
        }
        for (index, function) in self.basis.iter().enumerate() {
            rows.push(format!(r"F_{{{}}}(v, t) &= {}", index + 1, text(function.expr)?));
        }
        for (index, condition) in self.patch.conditions.iter().enumerate().filter(|_| !self.patch.is_four_sided()) {
            let left = Derivative::new(condition.order, 0, 0).of(r"\mathbf{S}", Notation::Latex);
            let position = text(condition.u)?;
            let vectors = self.coefficients.get(index).into_iter().flatten().enumerate();
            let stated: Vec<(usize, &[ExprId; 3])> =
                vectors.filter(|(_, vector)| vector.iter().any(|component| !self.graph.is_zero(*component))).collect();
            let terms = stated.iter().map(|(j, _)| format!("{}\\, F_{{{}}}", self.latex_symbol(index, j + 1), j + 1));
            let terms: Vec<String> = terms.collect();
            let sum = if terms.is_empty() { r"\mathbf{0}".to_owned() } else { terms.join(" + ") };
            rows.push(format!(r"\left.{left}\right|_{{u = {position}}} &= {sum}"));
            for (j, vector) in stated {
                rows.push(format!("{} &= {}", self.latex_symbol(index, j + 1), column(*vector)?));
            }
        }
        for (index, function) in self.basis.iter().enumerate() {
            for (orders, expr) in function.derivatives.iter().filter(|(_, expr)| !self.graph.is_zero(*expr)) {
                let left = orders.of(&format!("F_{{{}}}", index + 1), Notation::Latex);
                rows.push(format!("{left} &= {}", text(*expr)?));
            }
            for orders in function.missing(&self.patch.operator) {
                let left = orders.of(&format!("F_{{{}}}", index + 1), Notation::Latex);
                rows.push(format!(r"{left} &\quad \text{{does not exist}}"));
            }
        }
        Ok(format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}\n", rows.join(" \\\\\n")))
    }

    /// [`Decomposition::symbol`] of basis function `j`, counted from 1, in LaTeX.
    fn latex_symbol(&self, condition: usize, j: usize) -> String {
        match self.symbol(condition).as_str() {
            "b̄" => format!(r"\bar{{\mathbf{{b}}}}_{{{j}}}"),
            "d̄" => format!(r"\bar{{\mathbf{{d}}}}_{{{j}}}"),
            letter @ ("b" | "d") => format!(r"\mathbf{{{letter}}}_{{{j}}}"),
            _ => format!(r"\mathbf{{c}}_{{{},{j}}}", condition + 1),
        }
    }
}
