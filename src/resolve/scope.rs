//! The names a document declares and what they stand for.

use rustc_hash::FxHashMap;

use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Constant, ExprId, Function, Graph, Variable};
use crate::limits::Limits;
use crate::syntax::ast::Name;

/// A number or a vector, symbolically.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// A number.
    Scalar(ExprId),
    /// x, y and z.
    Vector([ExprId; 3]),
}

/// What a name stands for.
#[derive(Debug, Clone)]
pub enum Meaning {
    /// A parameter, coordinate, constant or plain definition.
    Value(Value),
    /// A definition with arguments: the symbols of its arguments and its body.
    Function(Vec<ExprId>, Value),
}

/// Names longer than this are not compared with others: the cost grows with the product of their lengths.
const COMPARED_BYTES: usize = 64;

/// Names, each with its meaning and the place of its declaration.
#[derive(Debug, Clone)]
pub struct Scope {
    names: FxHashMap<String, (Meaning, Option<Span>)>,
    // Kept in order of declaration, so that suggestions do not depend on a hash.
    order: Vec<String>,
    allowed: usize,
    /// Names that every document knows, which do not count.
    reserved: usize,
}

impl Scope {
    /// The coordinates and constants every document knows.
    pub fn new(graph: &mut Graph, limits: &Limits) -> Scope {
        let mut scope = Scope { names: FxHashMap::default(), order: Vec::new(), allowed: limits.names, reserved: 0 };
        for variable in Variable::ALL {
            let value = graph.variable(variable);
            scope.insert(variable.name(), Meaning::Value(Value::Scalar(value)), None);
        }
        for (name, constant) in [("pi", Constant::Pi), ("e", Constant::E)] {
            let value = graph.constant(constant);
            scope.insert(name, Meaning::Value(Value::Scalar(value)), None);
        }
        scope.reserved = scope.order.len();
        scope
    }

    /// What `name` stands for.
    pub fn meaning(&self, name: &str) -> Option<&Meaning> {
        self.names.get(name).map(|(meaning, _)| meaning)
    }

    /// Declares a name.
    ///
    /// # Errors
    /// [`Code::DuplicateName`] if it is declared already or reserved; [`Code::LimitReached`] for too many.
    pub fn declare(&mut self, name: &Name, meaning: Meaning) -> Result<(), Diagnostic> {
        self.check_free(name)?;
        if self.order.len() >= self.allowed.saturating_add(self.reserved) {
            let message = format!("more names are declared than the limit `names` of {}", self.allowed);
            return Err(Diagnostic::new(Code::LimitReached, message).at(name.span));
        }
        self.insert(&name.text, meaning, Some(name.span));
        Ok(())
    }

    /// Refuses a name that is taken.
    pub fn check_free(&self, name: &Name) -> Result<(), Diagnostic> {
        let text = &name.text;
        match (self.names.get(text), text.as_str()) {
            (Some((_, Some(first))), _) => {
                let finding = Diagnostic::new(Code::DuplicateName, format!("`{text}` is declared twice"));
                Err(finding.at(name.span).label(*first, "first declared here").hint(format!(
                    "`{text}`, with or without `_` before a digit and in Greek or ASCII letters, is one name"
                )))
            }
            (Some((_, None)), "e") => Err(Diagnostic::new(Code::DuplicateName, "`e` is Euler's number")
                .at(name.span)
                .hint("choose another name, for example `e0`")),
            (Some((_, None)), _) => Err(Diagnostic::new(Code::DuplicateName, format!("`{text}` is reserved"))
                .at(name.span)
                .hint("u, v and t are the coordinates, pi and e are numbers; choose another name")),
            (None, "S") => Err(Diagnostic::new(Code::DuplicateName, "`S` is the surface to be found").at(name.span)),
            (None, _) => Ok(()),
        }
    }

    fn insert(&mut self, name: &str, meaning: Meaning, span: Option<Span>) {
        self.names.insert(name.to_owned(), (meaning, span));
        self.order.push(name.to_owned());
    }

    /// The finding for a name that nothing declares, with the closest declared names.
    pub fn unknown_name(&self, name: &Name) -> Diagnostic {
        let text = &name.text;
        let finding = Diagnostic::new(Code::UnknownName, format!("unknown name `{text}`")).at(name.span);
        if text.len() > COMPARED_BYTES {
            return finding.hint("it is declared nowhere, and too long to be a slip of another name");
        }
        if text.starts_with("S_") {
            return finding
                .hint("the components are `S_x`, `S_y`, `S_z`; derivatives are written `∂²S/∂u²` or `d2S/du2`");
        }
        if let Some(product) = self.as_product(text) {
            return finding.hint(format!("did you mean `{product}`? Factors need a space or `*` between them"));
        }
        // `kv` without a param k: a product with a coordinate is still the likeliest meaning.
        let coordinate =
            Variable::ALL.iter().find_map(|variable| text.strip_suffix(variable.name()).map(|rest| (rest, variable)));
        if let Some((factor, variable)) = coordinate.filter(|(factor, _)| factor.chars().count() == 1) {
            let variable = variable.name();
            return finding.hint(format!("did you mean `{factor}*{variable}`? Then declare it: `param {factor} = …`"));
        }
        match self.closest(text) {
            Some(near) => finding.hint(format!("did you mean `{near}`?")),
            None => finding.hint(format!("declare it: `param {text} = …`")),
        }
    }

    /// `kv` as `k*v`, `sinv` as `sin(v)`, when all parts are known.
    fn as_product(&self, text: &str) -> Option<String> {
        for function in Function::ALL {
            if let Some(argument) = text.strip_prefix(function.row().name)
                && self.names.contains_key(argument)
            {
                return Some(format!("{}({argument})", function.row().name));
            }
        }
        (1..text.len()).filter_map(|at| text.split_at_checked(at)).find_map(|(left, right)| {
            (self.names.contains_key(left) && self.names.contains_key(right)).then(|| format!("{left}*{right}"))
        })
    }

    fn closest(&self, text: &str) -> Option<&str> {
        let functions =
            Function::ALL.iter().map(|function| function.row().name).filter(|name| Function::named(name).is_some());
        let names = self
            .order
            .iter()
            .map(String::as_str)
            .filter(|name| (2..=COMPARED_BYTES).contains(&name.len()))
            .chain(functions);
        let distances = names.map(|name| (strsim::damerau_levenshtein(text, name), name));
        let (distance, name) = distances.min_by_key(|(distance, _)| *distance)?;
        (distance <= text.chars().count().div_ceil(3)).then_some(name)
    }
}
