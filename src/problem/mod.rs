//! What is to be solved, symbolically: patches, their equation, boundary conditions, domain and parameters.
//!
//! A [`Problem`] comes from a text through [`resolve`](crate::resolve), or is built here in Rust without any
//! text. Every expression lives in its graph. Nothing is solved here, and nothing depends on how the problem
//! was written; places in a source are kept only to be shown in diagnostics.

mod deformation;
mod domain;
mod explanation;
mod morph;
mod net;
mod operator;
mod parameters;
mod placement;
mod reach;
mod surface;

pub use deformation::{Deformation, check_region};
pub use domain::{Domain, DomainValues};
pub use explanation::Explanation;
pub use morph::{MorphKind, MorphRequest};
pub use net::{KnotKind, Layer, Net, NetKnots, NetPoints, Sampling};
pub use operator::{PdeOperator, PdeTerm, STANDARD_COEFFICIENTS};
pub use parameters::{Bindings, Parameter, ParameterKind};
pub use placement::{PatchCopy, Placement};
pub use reach::check_reach;
pub use surface::{Join, PrimarySurface, Seam, SeamEdge, SidePart};

use crate::diagnostic::{Shortest, Span};
use crate::expr::{Derivative, ExprId, Graph, Notation, Variable};

/// The names of the components of S.
pub const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// Patches that share parameters and one expression graph.
#[derive(Debug, Clone, Default)]
pub struct Problem {
    /// Every expression of the problem.
    pub graph: Graph,
    /// Parameters and coefficients, each after those its value uses.
    pub parameters: Vec<Parameter>,
    /// Primary surfaces, in source order.
    pub surfaces: Vec<PrimarySurface>,
    /// The patches, in source order.
    pub patches: Vec<Patch>,
    /// The B-spline nets, in source order.
    pub nets: Vec<Net>,
    /// Copies of patches elsewhere, in source order.
    pub copies: Vec<PatchCopy>,
    /// Where patches are meant to meet, in source order.
    pub seams: Vec<Seam>,
    /// Which patches become which others.
    pub morph: Option<MorphRequest>,
    /// What comes from data files, as statements of a spec: `curve C = points("ring.csv")`.
    pub data: Vec<String>,
}

/// One surface patch: a boundary-value problem for `S(u, v, t)`.
#[derive(Debug, Clone)]
pub struct Patch {
    /// What the user calls it.
    pub name: String,
    /// Ranges of u, v and t.
    pub domain: Domain,
    /// The equation.
    pub operator: PdeOperator,
    /// As many conditions as the operator's order in u, by position and then by order.
    pub conditions: Vec<BoundaryCondition>,
    /// The trimlines that lie on primary surfaces; what the conditions say of them stands there.
    pub joins: Vec<Join>,
    /// Conditions at fixed v, by position and then by order; empty unless all four sides carry data.
    pub side_conditions: Vec<SideCondition>,
    /// Whether it fills a corner of a loop of edges, which made its sides.
    pub is_of_loop: bool,
    /// What is added to the solved surface in parts of its domain.
    pub deformations: Vec<Deformation>,
    /// How the document asks for it to be solved.
    pub solve: SolveRequest,
}

/// `∂^order S/∂u^order (u, v, t) = value(v, t)` at one u.
#[derive(Debug, Clone)]
pub struct BoundaryCondition {
    /// The position, constant.
    pub u: ExprId,
    /// 0 for position, 1 for tangent, 2 for curvature.
    pub order: usize,
    /// The prescribed x, y and z, functions of v and t.
    pub value: [ExprId; 3],
    /// Where each component is written.
    pub origins: [Option<Span>; 3],
}

/// `∂^order S/∂v^order (u, v, t) = value(u, t)` at one v.
#[derive(Debug, Clone)]
pub struct SideCondition {
    /// The position, constant.
    pub v: ExprId,
    /// 0 for position, 1 for tangent.
    pub order: usize,
    /// The prescribed x, y and z, functions of u and t.
    pub value: [ExprId; 3],
    /// Where each component is written.
    pub origins: [Option<Span>; 3],
}

/// The `solve` statement as written; methods read their own settings from it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SolveRequest {
    /// The method's name; `None` leaves the choice to `auto`.
    pub method: Option<String>,
    /// Where the name is written.
    pub origin: Option<Span>,
    /// Settings, in order.
    pub settings: Vec<RequestedSetting>,
}

/// One `key = value` of a `solve` statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RequestedSetting {
    /// The key.
    pub key: String,
    /// The value as written, without blanks.
    pub value: String,
    /// Where the value is written.
    pub origin: Option<Span>,
}

impl Problem {
    /// The name of part number `index`: patches, behind them nets, behind them copies.
    #[must_use]
    pub fn part_name(&self, index: usize) -> Option<&str> {
        let patches = self.patches.iter().map(|patch| patch.name.as_str());
        let own = patches.chain(self.nets.iter().map(|net| net.name.as_str()));
        own.chain(self.copies.iter().map(|copy| copy.name.as_str())).nth(index)
    }
}

impl Patch {
    /// Whether anything that is stated of the patch changes with t.
    #[must_use]
    pub fn moves(&self, graph: &Graph) -> bool {
        let across = self.conditions.iter().flat_map(|condition| condition.value);
        let along = self.side_conditions.iter().flat_map(|condition| condition.value);
        let equation = self.operator.terms.iter().flat_map(|term| term.coefficient).chain(self.operator.force);
        let displaced = self.deformations.iter().flat_map(|deformation| deformation.by);
        across.chain(along).chain(equation).chain(displaced).any(|expr| graph.dependence(expr).t)
    }

    /// Whether data stand at fixed v as well as at fixed u.
    #[must_use]
    pub fn is_four_sided(&self) -> bool {
        !self.side_conditions.is_empty()
    }

    /// The first place at which boundary data are written.
    #[must_use]
    pub fn boundary_origin(&self) -> Option<Span> {
        let across = self.conditions.iter().flat_map(|condition| condition.origins);
        across.chain(self.side_conditions.iter().flat_map(|side| side.origins)).flatten().next()
    }
}

/// `∂^k S = value` at one u or at one v.
#[derive(Debug, Clone, Copy)]
pub struct Constraint {
    /// The variable that is fixed.
    pub across: Variable,
    /// The position, constant.
    pub position: ExprId,
    /// The derivative in that variable.
    pub derivative: Derivative,
    /// The prescribed x, y and z.
    pub value: [ExprId; 3],
}

impl Patch {
    /// All constraints: those at fixed u, then those at fixed v.
    pub fn constraints(&self) -> impl Iterator<Item = Constraint> {
        let at_u = self.conditions.iter().map(|condition| Constraint {
            across: Variable::U,
            position: condition.u,
            derivative: Derivative::new(condition.order, 0, 0),
            value: condition.value,
        });
        let at_v = self.side_conditions.iter().map(|condition| Constraint {
            across: Variable::V,
            position: condition.v,
            derivative: Derivative::new(0, condition.order, 0),
            value: condition.value,
        });
        at_u.chain(at_v)
    }
}

impl SideCondition {
    /// What the condition fixes, for people: `S at v = 0`, `∂S/∂v at v = 1`.
    #[must_use]
    pub fn describe(&self, position: f64) -> String {
        describe(None, self.order, Variable::V, position)
    }
}

impl BoundaryCondition {
    /// What the condition fixes, for people: `S at u = 0`, `∂S/∂u at u = 1`.
    #[must_use]
    pub fn describe(&self, position: f64) -> String {
        describe_condition(None, self.order, position)
    }
}

/// `S_y at u = 1`, `∂²S/∂u² at u = 0`: a constraint in the reader's words.
#[must_use]
pub fn describe_condition(component: Option<usize>, order: usize, position: f64) -> String {
    describe(component, order, Variable::U, position)
}

/// A constraint on a derivative in `across`, which has the value `position` there.
#[must_use]
pub fn describe(component: Option<usize>, order: usize, across: Variable, position: f64) -> String {
    let name = across.name();
    let unknown = match component.and_then(|index| COMPONENTS.get(index)) {
        Some(component) => format!("S_{component}"),
        None => "S".to_owned(),
    };
    let derivative = match across {
        Variable::U => Derivative::new(order, 0, 0),
        _ => Derivative::new(0, order, 0),
    };
    let left = derivative.of(&unknown, Notation::Unicode);
    format!("{left} at {name} = {}", Shortest(position))
}
