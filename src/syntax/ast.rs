//! The document as written: statements and expressions with their places, nothing resolved.

use crate::diagnostic::Span;
use crate::expr::{Derivative, Function, Number};

pub use super::files::DataFile;
pub use super::net::{KnotChoice, Knots, Layer, NetBlock, NetSource, NetStatement};

/// A whole spec file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Every expression of the document.
    pub tree: Tree,
    /// Parameters, in source order.
    pub parameters: Vec<Parameter>,
    /// What stands outside patch blocks: common to all of them or, without any, the document's one patch.
    pub shared: Statements,
    /// The patch blocks, in source order.
    pub patches: Vec<PatchBlock>,
    /// The B-spline nets, in source order.
    pub nets: Vec<NetBlock>,
    /// Where patches are said to meet, in source order.
    pub seams: Vec<Seam>,
    /// Which patches become which others; more than one is an error of the next stage.
    pub morphs: Vec<Morph>,
    /// Declared edges, in source order.
    pub edges: Vec<Edge>,
    /// Copies of patches, in source order.
    pub copies: Vec<Copies>,
    /// The data files it names, each once, in the order of their first mention.
    pub files: Vec<DataFile>,
}

/// `morph from A to B, C to D by both, steps = 9`
#[derive(Debug, Clone, PartialEq)]
pub struct Morph {
    /// Patches and what they become.
    pub pairs: Vec<[Name; 2]>,
    /// What changes: `boundary`, `modes` or `both`.
    pub by: Option<Name>,
    /// Settings, in source order.
    pub settings: Vec<Setting>,
    /// The whole statement.
    pub span: Span,
}

/// `seam A at u = 1 with B at u = 1`
#[derive(Debug, Clone, PartialEq)]
pub struct Seam {
    /// The edges that meet.
    pub edges: [SeamEdge; 2],
    /// The whole statement.
    pub span: Span,
}

/// `A at u = 1`, `A at u = 1, v in [0, 1/2]`
#[derive(Debug, Clone, PartialEq)]
pub struct SeamEdge {
    /// The patch.
    pub patch: Name,
    /// The name before the `=`: u, or v of a patch with four sides.
    pub variable: Name,
    /// Its value.
    pub position: Expression,
    /// The range of the other coordinate, for a part of the side.
    pub along: Option<Range>,
}

/// The statements that a patch may consist of.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Statements {
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
    /// `deform` statements, in source order.
    pub deformations: Vec<Deformation>,
    /// The edges of a loop, in source order.
    pub loop_edges: Vec<LoopEdge>,
    /// `centre = …` of a loop; more than one is an error of the next stage.
    pub centres: Vec<Expression>,
}

/// `patch NAME { … }` or `nsided NAME { … }`
#[derive(Debug, Clone, PartialEq)]
pub struct PatchBlock {
    /// What the user calls the patch.
    pub name: Name,
    /// Whether it is a loop of edges.
    pub is_loop: bool,
    /// What the block states.
    pub statements: Statements,
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

/// `let NAME = expr`, `let NAME(x, …) = expr` or `surface NAME(u, v, t) = expr [with u in [lo, hi], …]`
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// What is defined.
    pub kind: DefinitionKind,
    /// The defined name.
    pub name: Name,
    /// The arguments; empty for a plain definition.
    pub formals: Vec<Name>,
    /// What it stands for.
    pub value: Expression,
}

/// What a definition defines.
#[derive(Debug, Clone, PartialEq)]
pub enum DefinitionKind {
    /// A name for an expression.
    Let,
    /// A primary surface, with the ranges of its parameters as far as they are stated.
    Surface(Vec<Range>),
    /// A closed curve through the points of a data file, which the value names: `curve C = points("ring.csv")`.
    Curve,
    /// A primary surface from a file of B-splines, which the value names, with the number of the one that is meant where
    /// it is stated: `surface S1 = bspline("part.step", face = 2)`.
    Imported(Option<usize>),
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

/// `deform u in [lo, hi], v in [lo, hi] by [x, y, z] keeping C1`
#[derive(Debug, Clone, PartialEq)]
pub struct Deformation {
    /// Its part of the patch: one range of u and one of v.
    pub region: [Range; 2],
    /// The displacement in the middle.
    pub by: Expression,
    /// `C0`, `C1` or `C2`.
    pub continuity: Name,
    /// The whole statement.
    pub span: Span,
}

/// `edge NAME = [x, y, z], across = [x, y, z] keeping C0`
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// What the user calls it.
    pub name: Name,
    /// The curve.
    pub curve: Expression,
    /// The tangent across it, if it has one.
    pub across: Option<Expression>,
    /// `C0` or `C1`.
    pub continuity: Option<Name>,
    /// The whole statement.
    pub span: Span,
}

/// `edge NAME, reversed` or `edge [x, y, z], across = [x, y, z]` of a loop
#[derive(Debug, Clone, PartialEq)]
pub struct LoopEdge {
    /// The curve, or the name of a declared edge.
    pub curve: Expression,
    /// The tangent across it, if it is stated.
    pub across: Option<Expression>,
    /// Whether it is run through backwards.
    pub is_reversed: bool,
    /// The whole statement.
    pub span: Span,
}

/// `mirror A, B in y = 0` or `repeat A, B 4 times …`
#[derive(Debug, Clone, PartialEq)]
pub struct Copies {
    /// What is copied.
    pub patches: Vec<Name>,
    /// Where the copies are.
    pub motion: Motion,
    /// The whole statement.
    pub span: Span,
}

/// Where copies are.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// On the other side of the plane where a coordinate has this value.
    Mirrored(Name, Expression),
    /// As many in all, each turned about an axis by this angle against the one before.
    Rotated(usize, Name, Expression),
    /// As many in all, each moved by this vector from the one before.
    Moved(usize, Expression),
}

/// `at u = c:` or `at v = c:` with the constraints stated there.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// The name before the `=`, which must be `u` or `v`.
    pub variable: Name,
    /// The value of u or v.
    pub position: Expression,
    /// What is stated there.
    pub constraints: Constraints,
}

/// What a boundary block states.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Constraints {
    /// Single constraints, in source order.
    pub single: Vec<Constraint>,
    /// Joined surfaces and edges, in source order.
    pub joins: Vec<Join>,
    /// Where it is said that the side is a point.
    pub apexes: Vec<Span>,
}

/// `join S1 at u = u1, strength = k, flip` or `join E, reversed`
#[derive(Debug, Clone, PartialEq)]
pub struct Join {
    /// The surface or the edge.
    pub surface: Name,
    /// The parameter of the surface that is constant along the trimline, and its value there; `None` for an edge.
    pub at: Option<(Name, Expression)>,
    /// Whether an edge is run through backwards.
    pub is_reversed: bool,
    /// What the tangent is multiplied by.
    pub strength: Option<Expression>,
    /// Whether the tangent is turned round.
    pub is_flipped: bool,
    /// The whole statement.
    pub span: Span,
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
    /// A derivative of a primary surface, taken in its own parameters and then evaluated at the arguments.
    Partial(Partial),
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
    /// A text in quotes: the name of a data file.
    Text(String),
    /// Which part of a data file is meant: `face = 2`, from 1.
    Face(usize),
}

/// `∂²S1(u1, v, t)/∂u∂v`
#[derive(Debug, Clone, PartialEq)]
pub struct Partial {
    /// The surface or a component of it.
    pub surface: Name,
    /// Where the derivative is taken.
    pub arguments: Vec<Expression>,
    /// Each differentiation with its order.
    pub orders: Vec<(Name, usize)>,
}

impl Kind {
    fn operands(&self) -> Vec<Expression> {
        match self {
            Kind::Number(_) | Kind::Name(_) | Kind::Unknown(_) | Kind::Operator(_) | Kind::Text(_) | Kind::Face(_) => {
                Vec::new()
            }
            Kind::Application(_, operands)
            | Kind::Call(_, operands)
            | Kind::SquareRoot(operands)
            | Kind::Vector(operands) => operands.clone(),
            Kind::Partial(partial) => partial.arguments.clone(),
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

    /// Every name that is used, as often as it is.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.nodes.iter().filter_map(|node| match &node.kind {
            Kind::Name(name) | Kind::Application(name, _) => Some(name.text.as_str()),
            Kind::Partial(partial) => Some(partial.surface.text.as_str()),
            _ => None,
        })
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
