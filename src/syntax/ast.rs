//! The document as written: statements and expressions with their places, nothing resolved.

use crate::diagnostic::Span;
use crate::expr::{Derivative, Function, Number};

/// A whole spec file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Every expression of the document.
    pub tree: Tree,
    /// Parameters, in source order.
    pub parameters: Vec<Parameter>,
    /// Definitions (`let`), in source order.
    pub definitions: Vec<Definition>,
    /// `domain` entries.
    pub ranges: Vec<Range>,
    /// `pde` statements; more than one is an error of the next stage.
    pub equations: Vec<PdeStatement>,
    /// `at u = c:` blocks.
    pub boundaries: Vec<Boundary>,
    /// `solve` statements; more than one is an error of the next stage.
    pub solves: Vec<SolveStatement>,
}

/// A name where it is declared or used, in its canonical spelling.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Name {
    /// Canonical spelling: `b₁` is `b1`, `β` is `beta`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// `param NAME = expr [in [lo, hi]]`
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The parameter.
    pub name: Name,
    /// Its default value.
    pub value: Expression,
    /// The range a viewer offers.
    pub interval: Option<[Expression; 2]>,
}

/// `let NAME = expr` or `let NAME(x, …) = expr`
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// The defined name.
    pub name: Name,
    /// The arguments; empty for a plain definition.
    pub formals: Vec<Name>,
    /// What it stands for.
    pub value: Expression,
}

/// `domain v in [lo, hi]`
#[derive(Debug, Clone, PartialEq)]
pub struct Range {
    /// `u`, `v` or `t`.
    pub variable: Name,
    /// Both ends.
    pub interval: [Expression; 2],
}

/// `pde left = right with NAME = expr, …`
#[derive(Debug, Clone, PartialEq)]
pub struct PdeStatement {
    /// Both sides; `None` keeps the default equation.
    pub sides: Option<[Expression; 2]>,
    /// Values of coefficients.
    pub coefficients: Vec<(Name, Expression)>,
    /// The whole statement.
    pub span: Span,
}

/// `at u = c:` with the constraints stated there.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// The name before the `=`, which must be `u`.
    pub variable: Name,
    /// The value of u.
    pub position: Expression,
    /// The constraints.
    pub constraints: Vec<Constraint>,
}

/// `S_x = expr`, `∂S/∂u = [.., .., ..]`
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// The left side.
    pub target: Unknown,
    /// The right side.
    pub value: Expression,
    /// The whole constraint.
    pub span: Span,
}

/// `solve METHOD, key = value, …`
#[derive(Debug, Clone, PartialEq)]
pub struct SolveStatement {
    /// The method's name.
    pub method: Name,
    /// Settings, in source order.
    pub settings: Vec<Setting>,
}

/// `key = value` of a `solve` statement.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// The setting's name.
    pub key: Name,
    /// The value as written, without blanks: `11x11:ends`.
    pub value: String,
    /// Where the value stands.
    pub span: Span,
}

/// S or one of its components, possibly differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unknown {
    /// 0, 1, 2 for x, y, z; `None` for the whole vector.
    pub component: Option<usize>,
    /// Orders of differentiation.
    pub derivative: Derivative,
    /// Where it stands.
    pub span: Span,
}

/// An expression of a [`Tree`]; meaningful only together with the tree that holds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expression(u32);

/// A node of a [`Tree`] and where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Where it stands.
    pub span: Span,
}

/// The forms of an expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// A number.
    Number(Number),
    /// A name.
    Name(Name),
    /// A name followed by brackets: a call of a defined function, or a product.
    Application(Name, Vec<Expression>),
    /// A function of the operator table.
    Call(Function, Vec<Expression>),
    /// The square root.
    SquareRoot(Vec<Expression>),
    /// S or a derivative of it.
    Unknown(Unknown),
    /// A derivative without what it is applied to: `∂²/∂u²`.
    Operator(Derivative),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Expression)>),
    /// Factors, each with whether it divides.
    Product(Vec<(bool, Expression)>),
    /// Base and exponent.
    Power(Expression, Expression),
    /// Two or more values in square brackets.
    Vector(Vec<Expression>),
}

impl Kind {
    fn operands(&self) -> Vec<Expression> {
        match self {
            Kind::Number(_) | Kind::Name(_) | Kind::Unknown(_) | Kind::Operator(_) => Vec::new(),
            Kind::Application(_, operands)
            | Kind::Call(_, operands)
            | Kind::SquareRoot(operands)
            | Kind::Vector(operands) => operands.clone(),
            Kind::Sum(parts) | Kind::Product(parts) => parts.iter().map(|(_, part)| *part).collect(),
            Kind::Power(base, exponent) => vec![*base, *exponent],
        }
    }
}

/// All expressions of a document in one arena, operands before the expressions that use them: whatever the
/// nesting, walking and dropping them are loops.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tree {
    nodes: Vec<Node>,
}

impl Tree {
    /// Adds an expression whose operands are already here.
    pub(super) fn add(&mut self, kind: Kind, span: Span) -> Expression {
        self.nodes.push(Node { kind, span });
        Expression(u32::try_from(self.nodes.len() - 1).expect("a source has fewer than 2^32 bytes"))
    }

    /// The node behind an expression.
    #[must_use]
    pub fn node(&self, expression: Expression) -> &Node {
        self.nodes.get(expression.0 as usize).expect("an Expression is used with the tree that holds it")
    }

    /// The place of an expression.
    #[must_use]
    pub fn span(&self, expression: Expression) -> Span {
        self.node(expression).span
    }

    /// The expression and all its parts, parts first.
    #[must_use]
    pub fn parts(&self, root: Expression) -> Vec<Expression> {
        let mut found = Vec::new();
        let mut pending = vec![root];
        while let Some(expression) = pending.pop() {
            found.push(expression);
            pending.extend(self.node(expression).kind.operands());
        }
        found.sort_unstable();
        found
    }
}
