//! Expressions of the tree to expressions of the graph.
//!
//! A loop over the parts of an expression, parts first. Every part is a [`Form`]: a value plus a linear
//! combination of derivatives of S. Boundary data and parameters are forms without an unknown; the equation is
//! a form with one; what is not linear in S is refused where it arises.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::reading::Fault;
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Derivative, ExprId, Graph};
use crate::limits::Limits;
use crate::syntax::ast::{Expression, Kind, Name, Tree, Unknown};

/// `Σ coefficient ∂S + value`
#[derive(Debug, Clone)]
pub struct Form {
    /// The part without S.
    pub value: Value,
    /// The coefficient of each derivative of S.
    pub unknown: BTreeMap<Derivative, Value>,
}

impl Form {
    /// A value without S.
    pub fn of(value: Value) -> Form {
        Form { value, unknown: BTreeMap::new() }
    }
}

/// Lowers expressions of one document.
pub struct Lowering<'a> {
    /// Where expressions come from.
    pub tree: &'a Tree,
    /// Where they go.
    pub graph: &'a mut Graph,
    /// What names mean.
    pub scope: &'a Scope<'a>,
    /// Bounds on the graph.
    pub limits: &'a Limits,
}

impl Lowering<'_> {
    /// The form of `root`.
    pub fn form(&mut self, root: Expression) -> Result<Form, Fault> {
        let parts = self.tree.parts(root);
        if parts.iter().any(|part| self.uses_faulty(*part)) {
            return Err(Fault::Follows);
        }
        let mut known: FxHashMap<Expression, Form> = FxHashMap::default();
        for part in parts {
            let form = self.part(part, &known)?;
            if self.graph.size() > self.limits.graph_nodes {
                return Err(self.too_large(part).into());
            }
            known.insert(part, form);
        }
        Ok(known.remove(&root).ok_or_else(|| Diagnostic::new(Code::UnexpectedText, "nothing to read"))?)
    }

    /// The value of `root`, which must not contain S.
    pub fn value(&mut self, root: Expression) -> Result<Value, Fault> {
        // Looked for first: lowering would judge S as part of an equation.
        let mut parts = self.tree.parts(root).into_iter();
        match parts.find(|part| matches!(self.tree.node(*part).kind, Kind::Unknown(_))) {
            None => Ok(self.form(root)?.value),
            Some(unknown) => {
                let finding =
                    Diagnostic::new(Code::NotBoundaryData, "`S` is what is to be found, so it cannot stand here");
                Err(finding.at(self.tree.span(unknown)).into())
            }
        }
    }

    /// The value of `root`, which must be a number.
    pub fn scalar(&mut self, root: Expression) -> Result<ExprId, Fault> {
        match self.value(root)? {
            Value::Scalar(value) => Ok(value),
            Value::Vector(_) => Err(self.not_scalar(root).into()),
        }
    }

    /// The value of `root`, which must be a number that depends on parameters alone.
    pub fn constant(&mut self, root: Expression, what: &str) -> Result<ExprId, Fault> {
        let value = self.scalar(root)?;
        if self.graph.dependence(value).is_constant() {
            return Ok(value);
        }
        Err(Diagnostic::new(Code::NotConstant, format!("{what} must not depend on u, v or t"))
            .at(self.tree.span(root))
            .hint("use numbers and params, or state it with `let`")
            .into())
    }

    fn part(&mut self, part: Expression, known: &FxHashMap<Expression, Form>) -> Result<Form, Diagnostic> {
        let node = self.tree.node(part);
        let span = node.span;
        match &node.kind {
            Kind::Number(number) => Ok(scalar(self.graph.number(*number))),
            Kind::Name(name) => self.name(name),
            Kind::Unknown(unknown) => self.unknown(*unknown),
            Kind::Partial(partial) => {
                let arguments = self.scalars(&partial.arguments, known)?;
                self.partial(partial, &arguments, span)
            }
            Kind::Application(name, arguments) => self.application(name, arguments, known, span),
            Kind::Call(function, arguments) => {
                let values = self.scalars(arguments, known)?;
                if values.len() != function.arity() {
                    return Err(wrong_arity(function.row().name, function.arity(), values.len(), span));
                }
                Ok(scalar(self.graph.call(*function, &values)))
            }
            Kind::SquareRoot(arguments) => match self.scalars(arguments, known)?.as_slice() {
                [only] => Ok(scalar(self.graph.sqrt(*only))),
                values => Err(wrong_arity("sqrt", 1, values.len(), span)),
            },
            Kind::Sum(terms) => self.sum(terms, known, span),
            Kind::Product(factors) => self.product(factors, known, span),
            Kind::Power(base, exponent) => self.power(*base, *exponent, known),
            Kind::Vector(values) => {
                let components = self.scalars(values, known)?;
                let count = components.len();
                let components = <[ExprId; 3]>::try_from(components).map_err(|_| {
                    let message = format!("a vector has three components, this one has {count}");
                    Diagnostic::new(Code::NotScalar, message).at(span).hint("write `[x, y, z]`")
                })?;
                Ok(Form::of(Value::Vector(components)))
            }
        }
    }

    fn name(&mut self, name: &Name) -> Result<Form, Diagnostic> {
        match self.scope.meaning(&name.text) {
            Some(Meaning::Function(formals, _)) => Err(wrong_arity(&name.text, formals.len(), 0, name.span)),
            Some(meaning) => Ok(Form::of(self.plain_value(meaning, name)?)),
            None => Err(self.scope.unknown_name(name)),
        }
    }

    fn unknown(&mut self, unknown: Unknown) -> Result<Form, Diagnostic> {
        if unknown.component.is_some() {
            return Err(Diagnostic::new(Code::NotLinear, "the equation is stated for S, not for one component")
                .at(unknown.span)
                .hint("to treat components differently give a coefficient per component: `[ax, ay, az] ∂²S/∂u²`"));
        }
        if unknown.derivative.largest() > self.limits.derivative_order {
            let (order, limit) = (unknown.derivative.largest(), self.limits.derivative_order);
            let order = if order > 1000 { "an absurd order".to_owned() } else { format!("order {order}") };
            let message = format!("a derivative of {order} is above the limit `derivative-order` of {limit}");
            return Err(Diagnostic::new(Code::LimitReached, message).at(unknown.span));
        }
        let (zero, one) = (self.graph.integer(0), self.graph.integer(1));
        let unknown = BTreeMap::from([(unknown.derivative, Value::Scalar(one))]);
        Ok(Form { value: Value::Scalar(zero), unknown })
    }

    /// `f(x)`: a call of a defined function, or a product with a bracket.
    fn application(
        &mut self,
        name: &Name,
        arguments: &[Expression],
        known: &FxHashMap<Expression, Form>,
        span: Span,
    ) -> Result<Form, Diagnostic> {
        if let Some((surface, component)) = self.surface(&name.text) {
            let values = self.scalars(arguments, known)?;
            return self.surface_value((&surface, component), name, &values, span);
        }
        match self.scope.meaning(&name.text).cloned() {
            Some(Meaning::Function(formals, body)) => {
                self.check_visible(name, body)?;
                let values = self.scalars(arguments, known)?;
                if values.len() != formals.len() {
                    return Err(wrong_arity(&name.text, formals.len(), values.len(), span));
                }
                let replacements: FxHashMap<ExprId, ExprId> = formals.into_iter().zip(values).collect();
                let value = self.map_value(body, |graph, expr| graph.substitute(expr, &replacements));
                Ok(Form::of(value))
            }
            Some(meaning) => match arguments {
                [only] => {
                    let factor = Form::of(self.plain_value(&meaning, name)?);
                    let other = known.get(only).cloned().ok_or_else(|| missing(span))?;
                    self.multiply(factor, other, span)
                }
                _ => {
                    let message =
                        format!("`{}` is not a function, so it cannot take {} arguments", name.text, arguments.len());
                    Err(Diagnostic::new(Code::WrongArity, message).at(span))
                }
            },
            None => {
                let text = &name.text;
                let finding = self.scope.unknown_name(name);
                Err(finding.hint(format!(
                    "as a function define it, `let {text}(x) = …`; as a factor declare it, `param {text} = …`"
                )))
            }
        }
    }

    fn sum(
        &mut self,
        terms: &[(bool, Expression)],
        known: &FxHashMap<Expression, Form>,
        span: Span,
    ) -> Result<Form, Diagnostic> {
        let mut forms = Vec::with_capacity(terms.len());
        for (subtracts, term) in terms {
            let form = known.get(term).cloned().ok_or_else(|| missing(span))?;
            forms.push(if *subtracts { self.negate(form) } else { form });
        }
        let mut unknown: BTreeMap<Derivative, Vec<Value>> = BTreeMap::new();
        for form in &forms {
            for (derivative, coefficient) in &form.unknown {
                unknown.entry(*derivative).or_default().push(*coefficient);
            }
        }
        // A term without a value is not a number 0 that a vector could not be added to.
        let zero = self.graph.integer(0);
        let values: Vec<Value> = forms
            .iter()
            .filter(|form| form.unknown.is_empty() || form.value != Value::Scalar(zero))
            .map(|form| form.value)
            .collect();
        let value = self.add(&values, span)?;
        let mut sums = BTreeMap::new();
        for (derivative, coefficients) in unknown {
            // A scalar coefficient counts for each component.
            let total = if coefficients.iter().all(|value| matches!(value, Value::Scalar(_))) {
                self.add(&coefficients, span)?
            } else {
                let spread: Vec<Value> = coefficients.iter().map(|value| Value::Vector(components(*value))).collect();
                self.add(&spread, span)?
            };
            sums.insert(derivative, total);
        }
        Ok(Form { value, unknown: sums })
    }

    fn add(&mut self, values: &[Value], span: Span) -> Result<Value, Diagnostic> {
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

    fn negate(&mut self, form: Form) -> Form {
        let value = self.map_value(form.value, Graph::neg);
        let unknown = form.unknown.into_iter().map(|(at, value)| (at, self.map_value(value, Graph::neg))).collect();
        Form { value, unknown }
    }

    fn product(
        &mut self,
        factors: &[(bool, Expression)],
        known: &FxHashMap<Expression, Form>,
        span: Span,
    ) -> Result<Form, Diagnostic> {
        // Numbers are multiplied all at once: product after product, n factors would make n²/2 operands.
        let (mut numbers, mut others) = (Vec::with_capacity(factors.len()), Vec::new());
        for (divides, factor) in factors {
            let form = known.get(factor).cloned().ok_or_else(|| missing(span))?;
            let form = if *divides { self.invert(&form, *factor)? } else { form };
            match form.value {
                Value::Scalar(number) if form.unknown.is_empty() => numbers.push(number),
                _ => others.push(form),
            }
        }
        let product = scalar(self.graph.product(numbers));
        others.into_iter().try_fold(product, |product, form| self.multiply(product, form, span))
    }

    fn invert(&mut self, form: &Form, expression: Expression) -> Result<Form, Diagnostic> {
        if !form.unknown.is_empty() {
            return Err(not_linear("dividing by S is not linear in S", self.tree.span(expression)));
        }
        match form.value {
            Value::Scalar(value) => Ok(scalar(self.graph.inverse(value))),
            Value::Vector(_) => Err(self.not_scalar(expression)),
        }
    }

    fn multiply(&mut self, left: Form, right: Form, span: Span) -> Result<Form, Diagnostic> {
        match (left.unknown.is_empty(), right.unknown.is_empty()) {
            (false, false) => Err(not_linear("the product of two terms with S is not linear in S", span)),
            (true, true) => Ok(Form::of(self.multiply_values(left.value, right.value, span)?)),
            (true, false) => self.distribute(left.value, right, span),
            (false, true) => self.distribute(right.value, left, span),
        }
    }

    fn distribute(&mut self, factor: Value, form: Form, span: Span) -> Result<Form, Diagnostic> {
        let value = match (factor, form.value) {
            // `[a, b, c] ∂S`: the part without S is the number 0.
            (Value::Vector(_), Value::Scalar(zero)) if self.graph.is_zero(zero) => form.value,
            _ => self.multiply_values(factor, form.value, span)?,
        };
        let mut unknown = BTreeMap::new();
        for (derivative, coefficient) in form.unknown {
            let product = match (factor, coefficient) {
                (Value::Vector(left), Value::Vector(right)) => {
                    let pairs = [(left[0], right[0]), (left[1], right[1]), (left[2], right[2])];
                    Value::Vector(pairs.map(|(a, b)| self.graph.product([a, b])))
                }
                _ => self.multiply_values(factor, coefficient, span)?,
            };
            unknown.insert(derivative, product);
        }
        Ok(Form { value, unknown })
    }

    fn multiply_values(&mut self, left: Value, right: Value, span: Span) -> Result<Value, Diagnostic> {
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

    fn power(
        &mut self,
        base: Expression,
        exponent: Expression,
        known: &FxHashMap<Expression, Form>,
    ) -> Result<Form, Diagnostic> {
        // `h0(1 - t)^2` with a factor h0 is h0 times a square, and `2^n(x)` with a factor n is `2^n` times x.
        if let Some((factor, bracket)) = self.factor_and_bracket(base, known) {
            let exponent = self.scalar_of(exponent, known)?;
            let bracket = self.scalar_of(bracket, known)?;
            let power = scalar(self.graph.power(bracket, exponent));
            return self.multiply(factor, power, self.tree.span(base));
        }
        if let Some((factor, bracket)) = self.factor_and_bracket(exponent, known) {
            let base = self.scalar_of(base, known)?;
            let Value::Scalar(factor) = factor.value else { return Err(self.not_scalar(exponent)) };
            let power = scalar(self.graph.power(base, factor));
            let bracket = known.get(&bracket).cloned().ok_or_else(|| missing(self.tree.span(bracket)))?;
            return self.multiply(power, bracket, self.tree.span(exponent));
        }
        let (base, exponent) = (self.scalar_of(base, known)?, self.scalar_of(exponent, known)?);
        Ok(scalar(self.graph.power(base, exponent)))
    }

    /// `h0(1 - t)` as its factor and its bracket, when `h0` is not a function.
    fn factor_and_bracket(
        &self,
        expression: Expression,
        known: &FxHashMap<Expression, Form>,
    ) -> Option<(Form, Expression)> {
        let Kind::Application(name, arguments) = &self.tree.node(expression).kind else { return None };
        let (Some(meaning), [only]) = (self.scope.meaning(&name.text), arguments.as_slice()) else { return None };
        let value = plain(meaning, name.span).ok()?;
        known.get(only).map(|_| (Form::of(value), *only))
    }

    fn scalars(
        &mut self,
        expressions: &[Expression],
        known: &FxHashMap<Expression, Form>,
    ) -> Result<Vec<ExprId>, Diagnostic> {
        expressions.iter().map(|expression| self.scalar_of(*expression, known)).collect()
    }

    fn scalar_of(&self, expression: Expression, known: &FxHashMap<Expression, Form>) -> Result<ExprId, Diagnostic> {
        let span = self.tree.span(expression);
        let form = known.get(&expression).ok_or_else(|| missing(span))?;
        if !form.unknown.is_empty() {
            return Err(not_linear("a function or power of S is not linear in S", span));
        }
        match form.value {
            Value::Scalar(value) => Ok(value),
            Value::Vector(_) => Err(self.not_scalar(expression)),
        }
    }

    fn map_value(&mut self, value: Value, mut map: impl FnMut(&mut Graph, ExprId) -> ExprId) -> Value {
        match value {
            Value::Scalar(expr) => Value::Scalar(map(self.graph, expr)),
            Value::Vector(each) => Value::Vector(each.map(|expr| map(self.graph, expr))),
        }
    }

    fn not_scalar(&self, expression: Expression) -> Diagnostic {
        Diagnostic::new(Code::NotScalar, "a vector stands where a number is expected").at(self.tree.span(expression))
    }

    fn too_large(&self, part: Expression) -> Diagnostic {
        self.too_large_at(self.tree.span(part))
    }

    /// The finding for a graph beyond its limit.
    pub fn too_large_at(&self, span: Span) -> Diagnostic {
        let limit = self.limits.graph_nodes;
        let message = format!("the expressions have more distinct parts than the limit `graph-nodes` of {limit}");
        Diagnostic::new(Code::LimitReached, message).at(span)
    }
}

/// A value for x, y and z; a number counts for each.
pub fn components(value: Value) -> [ExprId; 3] {
    match value {
        Value::Scalar(expr) => [expr; 3],
        Value::Vector(each) => each,
    }
}

/// The value of a name that stands for one.
pub fn plain(meaning: &Meaning, span: Span) -> Result<Value, Diagnostic> {
    match meaning {
        Meaning::Value(value) => Ok(*value),
        Meaning::Parameter(symbol) => Ok(Value::Scalar(*symbol)),
        Meaning::Function(..) | Meaning::Surface(_) | Meaning::Faulty => Err(missing(span)),
    }
}

fn scalar(expr: ExprId) -> Form {
    Form::of(Value::Scalar(expr))
}

fn not_linear(message: &str, span: Span) -> Diagnostic {
    Diagnostic::new(Code::NotLinear, message)
        .at(span)
        .hint("an equation is a sum of coefficient times derivative, for example `γ ∂⁴S/∂u²∂v²`")
}

fn wrong_arity(name: &str, expected: usize, found: usize, span: Span) -> Diagnostic {
    let plural = if expected == 1 { "" } else { "s" };
    let message = format!("`{name}` takes {expected} argument{plural}, found {found}");
    Diagnostic::new(Code::WrongArity, message).at(span)
}

/// The walk visits parts first, so a part is never missing.
fn missing(span: Span) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, "an expression uses a part that was not read: please report this text")
        .at(span)
}
