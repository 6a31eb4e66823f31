//! Expressions of the tree to expressions of the graph.
//!
//! A loop over the parts of an expression, parts first. Every part is a [`Form`]: a value plus a linear
//! combination of derivatives of S, or of derivatives that wait for S. Boundary data and parameters are forms
//! without either; the equation is a form with S; what is not linear in S is refused where it arises.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::form::{Form, not_linear, scalar};
use super::reading::Fault;
use super::scope::{Meaning, Scope, Value};
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{ExprId, Graph};
use crate::limits::Limits;
use crate::syntax::ast::{Expression, Kind, Name, Tree, Unknown};

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
        match parts.find(|part| matches!(self.tree.node(*part).kind, Kind::Unknown(_) | Kind::Operator(_))) {
            None => Ok(self.form(root)?.value),
            Some(found) => {
                let message = match self.tree.node(found).kind {
                    Kind::Operator(_) => "a differential operator acts on S in the equation, so it cannot stand here",
                    _ => "`S` is what is to be found, so it cannot stand here",
                };
                Err(Diagnostic::new(Code::NotBoundaryData, message).at(self.tree.span(found)).into())
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
            Kind::Text(_) => {
                Err(Diagnostic::new(Code::UnexpectedText, "a text in quotes stands where a value is expected")
                    .at(span)
                    .hint("quotes name data files: `curve C = points(\"ring.csv\")`, then `C(v)`"))
            }
            Kind::Face(_) => {
                Err(Diagnostic::new(Code::UnexpectedText, "a number of a face stands where a value is expected")
                    .at(span)
                    .hint("it belongs to a file of B-splines: `surface A = bspline(\"part.step\", face = 2)`"))
            }
            Kind::Operator(orders) => {
                self.check_order(*orders, span)?;
                let (zero, one) = (self.graph.integer(0), self.graph.integer(1));
                let operator = BTreeMap::from([(*orders, Value::Scalar(one))]);
                Ok(Form { operator, ..Form::of(Value::Scalar(zero)) })
            }
            Kind::Application(name, arguments) => self.application(name, arguments, known, span),
            Kind::Call(function, arguments) => {
                self.refuse_applied_factor(function.row().name, arguments, span)?;
                let values = self.scalars(arguments, known)?;
                if values.len() != function.arity() {
                    return Err(wrong_arity(function.row().name, function.arity(), values.len(), span));
                }
                Ok(scalar(self.graph.call(*function, &values)))
            }
            Kind::SquareRoot(arguments) => {
                self.refuse_applied_factor("sqrt", arguments, span)?;
                self.refuse_applied_below_root(arguments, span)?;
                match self.scalars(arguments, known)?.as_slice() {
                    [only] => Ok(scalar(self.graph.sqrt(*only))),
                    values => Err(wrong_arity("sqrt", 1, values.len(), span)),
                }
            }
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
            None => Err(self.scope.unknown_name(name, None)),
        }
    }

    fn unknown(&mut self, unknown: Unknown) -> Result<Form, Diagnostic> {
        if unknown.component.is_some() {
            return Err(Diagnostic::new(Code::NotLinear, "the equation is stated for S, not for one component")
                .at(unknown.span)
                .hint("to treat components differently give a coefficient per component: `[ax, ay, az] ∂²S/∂u²`"));
        }
        self.check_order(unknown.derivative, unknown.span)?;
        let (zero, one) = (self.graph.integer(0), self.graph.integer(1));
        let unknown = BTreeMap::from([(unknown.derivative, Value::Scalar(one))]);
        Ok(Form { unknown, ..Form::of(Value::Scalar(zero)) })
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
        // A term without a value is not a number 0 that a vector could not be added to.
        let zero = self.graph.integer(0);
        let values: Vec<Value> = forms
            .iter()
            .filter(|form| form.is_value() || form.value != Value::Scalar(zero))
            .map(|form| form.value)
            .collect();
        // Beside an operator a number counts for each component, as a factor does.
        let value = if forms.iter().all(|form| form.operator.is_empty()) {
            self.add(&values, span)?
        } else {
            self.add_coefficients(&values, span)?
        };
        let unknown = self.add_terms(forms.iter().map(|form| &form.unknown), span)?;
        let operator = self.add_terms(forms.iter().map(|form| &form.operator), span)?;
        Ok(Form { value, unknown, operator })
    }

    fn product(
        &mut self,
        factors: &[(bool, Expression)],
        known: &FxHashMap<Expression, Form>,
        span: Span,
    ) -> Result<Form, Diagnostic> {
        // From the right, since an operator acts on all that follows it. Numbers side by side are multiplied all at
        // once: product after product, n factors would make n²/2 operands. Without an operator all may change places.
        let mut numbers = Vec::with_capacity(factors.len());
        let mut others: Vec<Form> = Vec::new();
        for (divides, factor) in factors.iter().rev() {
            let form = known.get(factor).cloned().ok_or_else(|| missing(span))?;
            let form = if *divides {
                self.refuse_applied_divisor(*factor)?;
                self.invert(&form, *factor)?
            } else {
                form
            };
            match form.value {
                Value::Scalar(number) if form.is_value() => numbers.push(number),
                _ => {
                    if !form.operator.is_empty() && !numbers.is_empty() {
                        others.push(scalar(self.graph.product(numbers.drain(..).rev())));
                    }
                    others.push(form);
                }
            }
        }
        let mut product = scalar(self.graph.product(numbers.into_iter().rev()));
        if let Some(first) = others.first().cloned() {
            let rest = others.into_iter().skip(1);
            let right = rest.into_iter().try_fold(first, |right, form| self.multiply(form, right, span))?;
            product = self.multiply(product, right, span)?;
        }
        Ok(product)
    }

    fn invert(&mut self, form: &Form, expression: Expression) -> Result<Form, Diagnostic> {
        if !form.is_value() {
            let what = if form.unknown.is_empty() {
                "nothing can be divided by an operator"
            } else {
                "dividing by S is not linear in S"
            };
            return Err(not_linear(what, self.tree.span(expression)));
        }
        match form.value {
            Value::Scalar(value) => Ok(scalar(self.graph.inverse(value))),
            Value::Vector(_) => Err(self.not_scalar(expression)),
        }
    }

    fn power(
        &mut self,
        base: Expression,
        exponent: Expression,
        known: &FxHashMap<Expression, Form>,
    ) -> Result<Form, Diagnostic> {
        self.refuse_applied_exponent(exponent)?;
        // `h0(1 - t)^2` with a factor h0 is h0 times a square.
        if let Some((factor, bracket)) = self.factor_and_bracket(base, known) {
            let power = self.raise(bracket, exponent, known)?;
            return self.multiply(factor, power, self.tree.span(base));
        }
        self.raise(base, exponent, known)
    }

    fn raise(
        &mut self,
        base: Expression,
        exponent: Expression,
        known: &FxHashMap<Expression, Form>,
    ) -> Result<Form, Diagnostic> {
        let power = self.scalar_of(exponent, known)?;
        match known.get(&base).filter(|form| form.unknown.is_empty() && !form.operator.is_empty()) {
            Some(operator) => self.raise_operator(operator, power, self.tree.span(base).to(self.tree.span(exponent))),
            None => {
                let base = self.scalar_of(base, known)?;
                Ok(scalar(self.graph.power(base, power)))
            }
        }
    }

    /// The values of `expressions`, which must be numbers.
    pub fn scalars(
        &mut self,
        expressions: &[Expression],
        known: &FxHashMap<Expression, Form>,
    ) -> Result<Vec<ExprId>, Diagnostic> {
        expressions.iter().map(|expression| self.scalar_of(*expression, known)).collect()
    }

    fn scalar_of(&self, expression: Expression, known: &FxHashMap<Expression, Form>) -> Result<ExprId, Diagnostic> {
        let span = self.tree.span(expression);
        let form = known.get(&expression).ok_or_else(|| missing(span))?;
        if !form.is_value() {
            let what = if form.unknown.is_empty() {
                "an operator stands where a number is expected"
            } else {
                "a function or power of S is not linear in S"
            };
            return Err(not_linear(what, span));
        }
        match form.value {
            Value::Scalar(value) => Ok(value),
            Value::Vector(_) => Err(self.not_scalar(expression)),
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

/// The value of a name that stands for one.
pub fn plain(meaning: &Meaning, span: Span) -> Result<Value, Diagnostic> {
    match meaning {
        Meaning::Value(value) => Ok(*value),
        Meaning::Parameter(symbol) => Ok(Value::Scalar(*symbol)),
        Meaning::Function(..) | Meaning::Surface(_) | Meaning::Faulty => Err(missing(span)),
    }
}

/// The finding for a wrong number of arguments.
pub fn wrong_arity(name: &str, expected: usize, found: usize, span: Span) -> Diagnostic {
    let plural = if expected == 1 { "" } else { "s" };
    let message = format!("`{name}` takes {expected} argument{plural}, found {found}");
    Diagnostic::new(Code::WrongArity, message).at(span)
}

/// The walk visits parts first, so a part is never missing.
pub fn missing(span: Span) -> Diagnostic {
    Diagnostic::new(Code::UnexpectedText, "an expression uses a part that was not read: please report this text")
        .at(span)
}
