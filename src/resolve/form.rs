//! Linear forms in S, and sums and products of them.

use std::collections::BTreeMap;

use super::lower::Lowering;
use super::scope::Value;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Graph};

/// `Σ coefficient ∂S + Σ coefficient ∂ + value`
#[derive(Debug, Clone)]
pub struct Form {
    /// The part without S and without a derivative.
    pub value: Value,
    /// The coefficient of each derivative of S.
    pub unknown: BTreeMap<Derivative, Value>,
    /// The coefficient of each derivative that is not applied to anything yet.
    pub operator: BTreeMap<Derivative, Value>,
}

impl Form {
    /// A value alone.
    pub fn of(value: Value) -> Form {
        Form { value, unknown: BTreeMap::new(), operator: BTreeMap::new() }
    }

    /// Whether there is neither S nor an operator.
    pub fn is_value(&self) -> bool {
        self.unknown.is_empty() && self.operator.is_empty()
    }
}

impl Lowering<'_> {
    /// Sums of coefficients, derivative by derivative.
    pub(super) fn add_terms<'a>(
        &mut self,
        forms: impl Iterator<Item = &'a BTreeMap<Derivative, Value>>,
        span: Span,
    ) -> Result<BTreeMap<Derivative, Value>, Diagnostic> {
        let mut collected: BTreeMap<Derivative, Vec<Value>> = BTreeMap::new();
        for (derivative, coefficient) in forms.flatten() {
            collected.entry(*derivative).or_default().push(*coefficient);
        }
        collected.into_iter().map(|(derivative, all)| Ok((derivative, self.add_coefficients(&all, span)?))).collect()
    }

    /// The sum of coefficients; a scalar counts for each component.
    pub(super) fn add_coefficients(&mut self, coefficients: &[Value], span: Span) -> Result<Value, Diagnostic> {
        if coefficients.iter().all(|value| matches!(value, Value::Scalar(_))) {
            return self.add(coefficients, span);
        }
        let spread: Vec<Value> = coefficients.iter().map(|value| Value::Vector(components(*value))).collect();
        self.add(&spread, span)
    }

    pub(super) fn add(&mut self, values: &[Value], span: Span) -> Result<Value, Diagnostic> {
        let vectors = values.iter().filter(|value| matches!(value, Value::Vector(_))).count();
        if vectors == 0 {
            let sum = self.graph.sum(values.iter().map(|value| components(*value)[0]));
            return Ok(Value::Scalar(sum));
        }
        if vectors < values.len() {
            return Err(Diagnostic::new(Code::NotScalar, "a number and a vector cannot be added").at(span));
        }
        let each = |index: usize, graph: &mut Graph| {
            graph.sum(values.iter().filter_map(|value| components(*value).get(index).copied()))
        };
        Ok(Value::Vector([each(0, self.graph), each(1, self.graph), each(2, self.graph)]))
    }

    pub(super) fn negate(&mut self, form: Form) -> Form {
        let value = self.map_value(form.value, Graph::neg);
        let mut negated = |terms: BTreeMap<Derivative, Value>| -> BTreeMap<Derivative, Value> {
            terms.into_iter().map(|(at, value)| (at, self.map_value(value, Graph::neg))).collect()
        };
        Form { value, unknown: negated(form.unknown), operator: negated(form.operator) }
    }

    pub(super) fn multiply(&mut self, left: Form, right: Form, span: Span) -> Result<Form, Diagnostic> {
        match (left.unknown.is_empty(), right.unknown.is_empty()) {
            (false, false) => Err(not_linear("the product of two terms with S is not linear in S", span)),
            (false, true) if !right.operator.is_empty() => {
                Err(not_linear("an operator acts on what stands to its right, and S stands to its left", span))
            }
            _ if !left.operator.is_empty() => self.apply(&left, &right, span),
            (true, true) if right.operator.is_empty() => {
                let value = self.multiply_values(left.value, right.value, span)?;
                Ok(Form::of(value))
            }
            (true, _) => self.distribute(left.value, &right, span),
            (false, true) => self.distribute(right.value, &left, span),
        }
    }

    /// `factor` times every part of `form`.
    pub(super) fn distribute(&mut self, factor: Value, form: &Form, span: Span) -> Result<Form, Diagnostic> {
        let value = match (factor, form.value) {
            // `[a, b, c] ∂S`: the part without S is the number 0.
            (Value::Vector(_), Value::Scalar(zero)) if self.graph.is_zero(zero) => form.value,
            // Beside an operator a value is a coefficient.
            _ if !form.operator.is_empty() => self.multiply_coefficients(factor, form.value, span)?,
            _ => self.multiply_values(factor, form.value, span)?,
        };
        let mut scaled = |terms: &BTreeMap<Derivative, Value>| -> Result<BTreeMap<Derivative, Value>, Diagnostic> {
            let product =
                |(at, value): (&Derivative, &Value)| Ok((*at, self.multiply_coefficients(factor, *value, span)?));
            terms.iter().map(product).collect()
        };
        Ok(Form { value, unknown: scaled(&form.unknown)?, operator: scaled(&form.operator)? })
    }

    /// The product of two coefficients; those of vectors are taken component by component.
    pub(super) fn multiply_coefficients(&mut self, left: Value, right: Value, span: Span) -> Result<Value, Diagnostic> {
        match (left, right) {
            (Value::Vector(left), Value::Vector(right)) => {
                let pairs = [(left[0], right[0]), (left[1], right[1]), (left[2], right[2])];
                Ok(Value::Vector(pairs.map(|(a, b)| self.graph.product([a, b]))))
            }
            _ => self.multiply_values(left, right, span),
        }
    }

    pub(super) fn multiply_values(&mut self, left: Value, right: Value, span: Span) -> Result<Value, Diagnostic> {
        match (left, right) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.graph.product([a, b]))),
            (Value::Scalar(factor), vector @ Value::Vector(_)) | (vector @ Value::Vector(_), Value::Scalar(factor)) => {
                Ok(self.map_value(vector, |graph, component| graph.product([factor, component])))
            }
            (Value::Vector(_), Value::Vector(_)) => {
                Err(Diagnostic::new(Code::NotScalar, "the product of two vectors is not defined")
                    .at(span)
                    .hint("write the components out"))
            }
        }
    }

    pub(super) fn map_value(&mut self, value: Value, mut map: impl FnMut(&mut Graph, ExprId) -> ExprId) -> Value {
        match value {
            Value::Scalar(expr) => Value::Scalar(map(self.graph, expr)),
            Value::Vector(each) => Value::Vector(each.map(|expr| map(self.graph, expr))),
        }
    }
}

/// A value for x, y and z; a number counts for each.
pub fn components(value: Value) -> [ExprId; 3] {
    match value {
        Value::Scalar(expr) => [expr; 3],
        Value::Vector(each) => each,
    }
}

pub fn scalar(expr: ExprId) -> Form {
    Form::of(Value::Scalar(expr))
}

pub fn not_linear(message: &str, span: Span) -> Diagnostic {
    Diagnostic::new(Code::NotLinear, message)
        .at(span)
        .hint("an equation is a sum of coefficient times derivative, for example `γ ∂⁴S/∂u²∂v²`")
}
