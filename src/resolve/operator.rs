//! Operators in brackets: `(∂²/∂u² + a² ∂²/∂v²)² S`, multiplied out by Leibniz' rule.
//!
//! A product is read from the right: an operator acts on everything that follows it, so a coefficient there is
//! differentiated as well. `∂/∂u u S` is `S + u ∂S/∂u`; only constant coefficients may change places with operators.

use std::collections::BTreeMap;

use super::form::{Form, components, not_linear};
use super::lower::Lowering;
use super::scope::Value;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId};

impl Lowering<'_> {
    /// Refuses a derivative above the limit.
    pub(super) fn check_order(&self, orders: Derivative, span: Span) -> Result<(), Diagnostic> {
        let (order, limit) = (orders.largest(), self.limits.derivative_order);
        if order <= limit {
            return Ok(());
        }
        let order = if order > 1000 { "an absurd order".to_owned() } else { format!("order {order}") };
        let message = format!("a derivative of {order} is above the limit `derivative-order` of {limit}");
        Err(Diagnostic::new(Code::LimitReached, message).at(span))
    }

    /// The operator `left` applied to `right`: to S if it contains S, otherwise followed by the operator or factor `right`.
    pub(super) fn apply(&mut self, left: &Form, right: &Form, span: Span) -> Result<Form, Diagnostic> {
        if !left.unknown.is_empty() {
            return Err(not_linear("an operator and a term with S are added: apply the operator first", span));
        }
        let has_unknown = !right.unknown.is_empty();
        if has_unknown && !right.operator.is_empty() {
            return Err(not_linear("an operator and a term with S are added: apply the operator first", span));
        }
        // Before anything is multiplied out: the number of terms grows with the orders.
        let highest = |terms: &mut dyn Iterator<Item = &Derivative>| {
            terms.fold(Derivative::NONE, |most, at| {
                Derivative::new(most.u.max(at.u), most.v.max(at.v), most.t.max(at.t))
            })
        };
        let outer = highest(&mut left.operator.keys());
        let inner = highest(&mut right.unknown.keys().chain(right.operator.keys()));
        self.check_order(Derivative::new(outer.u + inner.u, outer.v + inner.v, outer.t + inner.t), span)?;
        let zero = Form::of(Value::Scalar(self.graph.integer(0)));
        let mut images = vec![self.distribute(left.value, right, span)?];
        for (orders, coefficient) in &left.operator {
            let mut image = zero.clone();
            let terms = if has_unknown { &right.unknown } else { &right.operator };
            // A value is a force beside S, and else the coefficient of no derivative.
            let identity = (Derivative::NONE, right.value);
            let stated = terms.iter().map(|(at, value)| (*at, *value));
            let stated: Vec<(Derivative, Value)> =
                if has_unknown { stated.collect() } else { stated.chain([identity]).collect() };
            let mut products = Vec::new();
            for (inner, value) in stated {
                products.push(self.leibniz(*orders, inner, value, span)?);
            }
            let mut sum = self.add_terms(products.iter(), span)?;
            if has_unknown {
                image.value = self.differentiated(right.value, *orders, span)?;
                image.unknown = sum;
            } else {
                image.value = sum.remove(&Derivative::NONE).unwrap_or(zero.value);
                image.operator = sum;
            }
            images.push(self.distribute(*coefficient, &image, span)?);
        }
        let values: Vec<Value> = images.iter().map(|form| form.value).collect();
        let value = self.add_coefficients(&values, span)?;
        let unknown = self.add_terms(images.iter().map(|form| &form.unknown), span)?;
        let operator = self.add_terms(images.iter().map(|form| &form.operator), span)?;
        self.without_zeros(Form { value, unknown, operator }, span)
    }

    /// `∂^orders (value ∂^inner) = Σ_k C(orders, k) (∂^k value) ∂^(inner + orders - k)`
    fn leibniz(
        &mut self,
        orders: Derivative,
        inner: Derivative,
        value: Value,
        span: Span,
    ) -> Result<BTreeMap<Derivative, Value>, Diagnostic> {
        let mut terms = BTreeMap::new();
        for u in 0..=orders.u {
            for v in 0..=orders.v {
                for t in 0..=orders.t {
                    let derivative = self.differentiated(value, Derivative::new(u, v, t), span)?;
                    if components(derivative).iter().all(|expr| self.graph.is_zero(*expr)) {
                        continue;
                    }
                    let ways = binomial(orders.u, u) * binomial(orders.v, v) * binomial(orders.t, t);
                    let ways = self.graph.integer(ways);
                    let term = self.map_value(derivative, |graph, expr| graph.product([ways, expr]));
                    let left = Derivative::new(inner.u + orders.u - u, inner.v + orders.v - v, inner.t + orders.t - t);
                    terms.insert(left, term);
                }
            }
        }
        Ok(terms)
    }

    /// The derivative of a value, by component.
    pub(super) fn differentiated(&mut self, value: Value, orders: Derivative, span: Span) -> Result<Value, Diagnostic> {
        let allowed = self.limits.graph_nodes;
        let mut derivative = |expr: ExprId| {
            let result = self.graph.derivative_within(expr, orders, allowed);
            result.map_err(|fault| fault.to_diagnostic(orders, allowed).at(span))
        };
        Ok(match value {
            Value::Scalar(expr) => Value::Scalar(derivative(expr)?),
            Value::Vector([x, y, z]) => Value::Vector([derivative(x)?, derivative(y)?, derivative(z)?]),
        })
    }

    /// Without the derivatives that cancelled.
    fn without_zeros(&self, mut form: Form, span: Span) -> Result<Form, Diagnostic> {
        let is_left = |value: &Value| !components(*value).iter().all(|expr| self.graph.is_zero(*expr));
        form.unknown.retain(|_, value| is_left(value));
        form.operator.retain(|_, value| is_left(value));
        if self.graph.size() > self.limits.graph_nodes {
            let limit = self.limits.graph_nodes;
            let message = format!("the operators multiply out to more than the limit `graph-nodes` of {limit}");
            return Err(Diagnostic::new(Code::LimitReached, message).at(span));
        }
        Ok(form)
    }

    /// An operator applied to itself.
    pub(super) fn raise_operator(&mut self, operator: &Form, power: ExprId, span: Span) -> Result<Form, Diagnostic> {
        let times = self.graph.as_number(power).and_then(|number| number.as_integer());
        let Some(times) = times.and_then(|times| usize::try_from(times).ok()).filter(|times| *times > 0) else {
            let message = "the power of an operator must be a whole number, 1 or more";
            if self.graph.as_number(power).is_some() {
                return Err(not_linear(message, span));
            }
            // The order of the equation fixes how many constraints there are, so no slider may change it.
            let finding = Diagnostic::new(Code::NotLinear, format!("{message}, and not a param"));
            return Err(finding.at(span).hint("write the number itself: `(…)^2 S`"));
        };
        if times > self.limits.derivative_order {
            let limit = self.limits.derivative_order;
            let message =
                format!("the power of this operator has derivatives above the limit `derivative-order` of {limit}");
            return Err(Diagnostic::new(Code::LimitReached, message).at(span));
        }
        (1..times).try_fold(operator.clone(), |product, _| self.apply(operator, &product, span))
    }
}

/// `n` over `k`, for orders of derivatives, which are bounded.
fn binomial(n: usize, k: usize) -> i64 {
    (0..k).fold(1, |ways, step| ways * (n - step) as i64 / (step + 1) as i64)
}
