//! A problem in words and formulas: what was understood, for comparison with the paper it comes from.
//!
//! The Unicode form is a spec and the constraints in LaTeX are a block of one, so both can be read again: that is how
//! tests know that nothing was lost. Definitions are expanded; derivatives and constraints are as they are solved.

use rustc_hash::FxHashSet;

use super::{Constraint, Parameter, ParameterKind, Patch, PdeTerm, Problem};
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::{ExprId, Node, Notation, Variable};
use crate::limits::Limits;

/// The parts of a problem in one notation, each ready to print.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Explanation {
    /// The params, each with its value and range, a line each.
    pub parameters: String,
    /// What comes from data files, a statement each; the same in every notation.
    pub data: String,
    /// The equation and the values of its coefficients.
    pub equation: String,
    /// The ranges of u, v and t.
    pub domain: String,
    /// The constraints, by position: those at fixed u, then those at fixed v.
    pub constraints: String,
    /// The deformations, a line each.
    pub deformations: String,
}

impl Problem {
    /// What `patch`, one of the problem's, asks for.
    ///
    /// # Errors
    /// [`Code::LimitReached`] for an expression longer than [`Limits::text_bytes`].
    pub fn explain(&self, patch: &Patch, notation: Notation, limits: &Limits) -> Result<Explanation, Diagnostic> {
        let writer = Writer { problem: self, notation, limits };
        Ok(Explanation {
            parameters: writer.parameters(patch)?,
            data: self.data.join("\n"),
            equation: writer.equation(patch)?,
            domain: writer.domain(patch)?,
            constraints: writer.constraints(patch)?,
            deformations: writer.deformations(patch)?,
        })
    }
}

impl Explanation {
    /// All parts, one below the other.
    #[must_use]
    pub fn to_text(&self) -> String {
        let parts = [&self.parameters, &self.data, &self.equation, &self.domain, &self.constraints, &self.deformations];
        let stated: Vec<&str> = parts.into_iter().map(String::as_str).filter(|part| !part.is_empty()).collect();
        stated.join("\n") + "\n"
    }
}

/// A coefficient of a patch's own equation, `cap.gamma` among the parameters, is `gamma` in that equation.
fn own_name(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, own)| own)
}

struct Writer<'a> {
    problem: &'a Problem,
    notation: Notation,
    limits: &'a Limits,
}

impl Writer<'_> {
    fn is_latex(&self) -> bool {
        self.notation == Notation::Latex
    }

    fn text(&self, expr: ExprId) -> Result<String, Diagnostic> {
        let text = self.problem.graph.text_with_names(expr, self.notation, self.limits.text_bytes, own_name);
        text.map_err(|too_long| {
            let message = format!("an expression is longer than the limit `text-bytes` of {}", too_long.allowed);
            Diagnostic::new(Code::LimitReached, message)
        })
    }

    fn vector(&self, components: [ExprId; 3]) -> Result<String, Diagnostic> {
        let [x, y, z] = components.map(|component| self.text(component));
        Ok(if self.is_latex() {
            format!(r"\begin{{bmatrix}} {} \\ {} \\ {} \end{{bmatrix}}", x?, y?, z?)
        } else {
            format!("[{}, {}, {}]", x?, y?, z?)
        })
    }

    fn interval(&self, [low, high]: [ExprId; 2]) -> Result<String, Diagnostic> {
        let is_in = if self.is_latex() { r"\in" } else { "in" };
        Ok(format!("{is_in} [{}, {}]", self.text(low)?, self.text(high)?))
    }

    /// The params, or the coefficients that the equation of `patch` is made of: other patches may have their own.
    fn stated(&self, kind: ParameterKind, patch: &Patch) -> Vec<&Parameter> {
        let (graph, operator) = (&self.problem.graph, &patch.operator);
        let mut used: FxHashSet<ExprId> = FxHashSet::default();
        let mut pending: Vec<ExprId> = operator.terms.iter().flat_map(|term| term.coefficient).collect();
        pending.extend(operator.force);
        let all = || self.problem.parameters.iter().filter(|parameter| parameter.kind == kind);
        // Values use earlier coefficients only, so once backwards is enough.
        let mut stated: Vec<&Parameter> = Vec::new();
        for parameter in all().rev() {
            used.extend(graph.reachable(&std::mem::take(&mut pending)));
            let is_used = used.iter().any(|part| *graph.node(*part) == Node::Symbol(parameter.symbol));
            if kind == ParameterKind::Parameter || is_used {
                pending.push(parameter.value);
                stated.push(parameter);
            }
        }
        stated.reverse();
        stated
    }

    /// `name = value` of everything of one kind that can be set.
    fn values(&self, kind: ParameterKind, patch: &Patch) -> Result<Vec<String>, Diagnostic> {
        let mut values = Vec::new();
        for parameter in self.stated(kind, patch) {
            let name = self.notation.name(own_name(&parameter.name));
            let range = match parameter.interval {
                Some(ends) => format!(" {}", self.interval(ends)?),
                None => String::new(),
            };
            values.push(format!("{name} = {}{range}", self.text(parameter.value)?));
        }
        Ok(values)
    }

    fn parameters(&self, patch: &Patch) -> Result<String, Diagnostic> {
        let values = self.values(ParameterKind::Parameter, patch)?;
        if self.is_latex() {
            let rows: Vec<String> = values.iter().map(|value| value.replacen(" = ", " &= ", 1)).collect();
            return Ok(aligned(&rows.join(", \\\\\n")));
        }
        Ok(values.iter().map(|value| format!("param {value}")).collect::<Vec<_>>().join("\n"))
    }

    fn equation(&self, patch: &Patch) -> Result<String, Diagnostic> {
        let operator = &patch.operator;
        let mut left = String::new();
        for term in &operator.terms {
            let text = self.term(term)?;
            match (left.is_empty(), text.strip_prefix('-')) {
                (true, _) => left = text,
                (false, Some(positive)) => left = format!("{left} - {positive}"),
                (false, None) => left = format!("{left} + {text}"),
            }
        }
        let is_zero = operator.is_homogeneous(&self.problem.graph);
        let right = if is_zero { "0".to_owned() } else { self.vector(operator.force)? };
        let coefficients = self.values(ParameterKind::Coefficient, patch)?;
        if self.is_latex() {
            let rows = std::iter::once(format!("{left} &= {right}"));
            let rows = rows.chain(coefficients.iter().map(|value| value.replacen(" = ", " &= ", 1)));
            return Ok(aligned(&rows.collect::<Vec<_>>().join(", \\\\\n")));
        }
        let with =
            if coefficients.is_empty() { String::new() } else { format!("\n    with {}", coefficients.join(", ")) };
        Ok(format!("pde {left} = {right}{with}"))
    }

    /// Coefficient times derivative.
    fn term(&self, term: &PdeTerm) -> Result<String, Diagnostic> {
        let unknown = if self.is_latex() { r"\mathbf{S}" } else { "S" };
        let derivative = term.derivative.of(unknown, self.notation);
        let [x, y, z] = term.coefficient;
        if x != y || x != z {
            return Ok(format!("{}{}{derivative}", self.vector(term.coefficient)?, self.times(false)));
        }
        let text = self.text(x)?;
        Ok(match (text.as_str(), self.problem.graph.node(x)) {
            ("1", _) => derivative,
            ("-1", _) => format!("-{derivative}"),
            (_, Node::Sum(_)) => format!("({text}){}{derivative}", self.times(false)),
            // Behind a quotient the derivative would join the divisor.
            _ => format!("{text}{}{derivative}", self.times(text.contains('/'))),
        })
    }

    fn times(&self, is_sign: bool) -> &'static str {
        match (self.notation, is_sign) {
            (Notation::Latex, _) => r"\, ",
            (Notation::Ascii, _) => "*",
            (Notation::Unicode, true) => "·",
            (Notation::Unicode, false) => " ",
        }
    }

    fn domain(&self, patch: &Patch) -> Result<String, Diagnostic> {
        let mut ranges = Vec::new();
        for (variable, ends) in Variable::ALL.into_iter().zip(patch.domain.ends) {
            ranges.push(format!("{} {}", variable.name(), self.interval(ends)?));
        }
        Ok(if self.is_latex() {
            aligned(&format!("& {}", ranges.join(r", \quad ")))
        } else {
            format!("domain {}", ranges.join(", "))
        })
    }

    fn constraints(&self, patch: &Patch) -> Result<String, Diagnostic> {
        let mut rows = Vec::new();
        let mut opened: Option<(Variable, ExprId)> = None;
        for Constraint { across, position, derivative, value } in patch.constraints() {
            if opened != Some((across, position)) {
                let (name, at) = (across.name(), self.text(position)?);
                rows.push(if self.is_latex() { format!("{name} &= {at}") } else { format!("at {name} = {at}:") });
                opened = Some((across, position));
            }
            let value = self.vector(value)?;
            rows.push(if self.is_latex() {
                format!("{} &= {value}", derivative.of(r"\mathbf{S}", self.notation))
            } else {
                format!("    {} = {value}", derivative.of("S", self.notation))
            });
        }
        Ok(if self.is_latex() { aligned(&rows.join(", \\\\\n")) } else { rows.join("\n") })
    }

    fn deformations(&self, patch: &Patch) -> Result<String, Diagnostic> {
        let mut rows = Vec::new();
        for deformation in &patch.deformations {
            let [u, v] = deformation.region;
            let (u, v, by) = (self.interval(u)?, self.interval(v)?, self.vector(deformation.by)?);
            let keeps = deformation.keeps;
            rows.push(if self.is_latex() {
                format!(r"& u {u}, \quad v {v}: \quad \mathrm{{deform}}\ {by}, \quad C^{{{keeps}}}")
            } else {
                format!("deform u {u}, v {v} by {by} keeping C{keeps}")
            });
        }
        Ok(if self.is_latex() { aligned(&rows.join(", \\\\\n")) } else { rows.join("\n") })
    }
}

/// Rows as an environment of `amsmath`; nothing for no rows.
fn aligned(rows: &str) -> String {
    if rows.is_empty() { String::new() } else { format!("\\begin{{aligned}}\n{rows}\n\\end{{aligned}}") }
}
