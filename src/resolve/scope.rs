//! The names a document declares and what they stand for.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::surface::SurfaceMeaning;

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
    /// A coordinate, constant or plain definition.
    Value(Value),
    /// A parameter, which no inner definition may hide.
    Parameter(ExprId),
    /// A definition with arguments: the symbols of its arguments and its body.
    Function(Vec<ExprId>, Value),
    /// A primary surface.
    Surface(Rc<SurfaceMeaning>),
    /// A declaration that was found faulty; what uses it is not reported again.
    Faulty,
}

/// Names longer than this are not compared with others: the cost grows with the product of their lengths.
const COMPARED_BYTES: usize = 64;

/// Names, each with its meaning and the place of its declaration, inside an outer scope.
///
/// An inner scope costs nothing to open, so a document of many definitions and patches is read in linear time.
#[derive(Debug)]
pub struct Scope<'a> {
    outer: Option<&'a Scope<'a>>,
    names: FxHashMap<String, (Meaning, Option<Span>)>,
    // Kept in order of declaration, so that suggestions do not depend on a hash.
    order: Vec<String>,
    /// How many more names may be declared.
    allowed: usize,
    /// The limit, for the message.
    limit: usize,
    /// Whether a definition may hide one outside.
    may_hide: bool,
    /// The coordinates that do not exist inside: a surface has its own.
    hidden: [bool; 3],
    /// Where the document declares what this scope is to hold, whether read by now or not.
    announced: FxHashMap<String, Span>,
}

impl<'a> Scope<'a> {
    /// The coordinates and constants every document knows.
    pub fn new(graph: &mut Graph, limits: &Limits) -> Scope<'static> {
        let mut scope = Scope {
            outer: None,
            names: FxHashMap::default(),
            order: Vec::new(),
            allowed: limits.names,
            limit: limits.names,
            may_hide: false,
            hidden: [false; 3],
            announced: FxHashMap::default(),
        };
        for variable in Variable::ALL {
            let value = graph.variable(variable);
            scope.provide(variable.name(), Meaning::Value(Value::Scalar(value)));
        }
        for (name, constant) in [("pi", Constant::Pi), ("e", Constant::E)] {
            let value = graph.constant(constant);
            scope.provide(name, Meaning::Value(Value::Scalar(value)));
        }
        scope
    }

    /// An empty scope inside this one; what is declared there ends with it.
    pub fn inner(&'a self) -> Scope<'a> {
        Scope {
            outer: Some(self),
            names: FxHashMap::default(),
            order: Vec::new(),
            allowed: self.allowed,
            limit: self.limit,
            may_hide: false,
            hidden: [false; 3],
            announced: FxHashMap::default(),
        }
    }

    /// The scope of a patch, whose definitions may take the place of those outside.
    pub fn of_patch(&'a self) -> Scope<'a> {
        Scope { may_hide: true, ..self.inner() }
    }

    /// The scope inside a surface: its parameters stand for `coordinates`, and hide what has their names.
    pub fn of_surface(&'a self, parameters: &[Name], coordinates: [ExprId; 3]) -> Scope<'a> {
        let mut scope = self.inner();
        for (parameter, coordinate) in parameters.iter().zip(coordinates) {
            scope.insert(&parameter.text, Meaning::Value(Value::Scalar(coordinate)), Some(parameter.span));
        }
        for ((index, variable), hidden) in Variable::ALL.iter().enumerate().zip(&mut scope.hidden) {
            // A surface without a time of its own moves with that of the document.
            *hidden = match parameters.get(index) {
                Some(parameter) => parameter.text != variable.name(),
                None => *variable != Variable::T,
            };
        }
        scope
    }

    /// The coordinates that do not exist between here and where `name` is declared.
    pub fn hidden_from(&self, name: &str) -> [bool; 3] {
        let mut hidden = [false; 3];
        for scope in self.layers().take_while(|scope| !scope.names.contains_key(name)) {
            for (all, here) in hidden.iter_mut().zip(scope.hidden) {
                *all |= here;
            }
        }
        hidden
    }

    /// Whether the declaration of `name` is at fault.
    pub fn is_faulty(&self, name: &str) -> bool {
        matches!(self.meaning(name), Some(Meaning::Faulty))
    }

    /// This scope and those around it, innermost first.
    fn layers(&self) -> impl Iterator<Item = &Scope<'a>> {
        std::iter::successors(Some(self), |scope| scope.outer)
    }

    fn entry(&self, name: &str) -> Option<&(Meaning, Option<Span>)> {
        self.layers().find_map(|scope| scope.names.get(name))
    }

    /// What `name` stands for.
    pub fn meaning(&self, name: &str) -> Option<&Meaning> {
        self.entry(name).map(|(meaning, _)| meaning)
    }

    /// Where `name` is declared; `None` for what every document knows.
    pub fn place(&self, name: &str) -> Option<Span> {
        self.entry(name).and_then(|(_, place)| *place)
    }

    /// Declares a name.
    ///
    /// # Errors
    /// [`Code::DuplicateName`] if it is declared already or reserved; [`Code::LimitReached`] for too many.
    pub fn declare(&mut self, name: &Name, meaning: Meaning) -> Result<(), Diagnostic> {
        self.check_free(name)?;
        if self.allowed == 0 {
            let message = format!("more names are declared than the limit `names` of {}", self.limit);
            return Err(Diagnostic::new(Code::LimitReached, message).at(name.span));
        }
        self.allowed -= 1;
        self.insert(&name.text, meaning, Some(name.span));
        Ok(())
    }

    /// Adds a name that no document writes down, so that it does not count among the declared ones.
    pub fn provide(&mut self, name: &str, meaning: Meaning) {
        self.insert(name, meaning, None);
    }

    /// Refuses a name that is taken.
    pub fn check_free(&self, name: &Name) -> Result<(), Diagnostic> {
        let text = &name.text;
        match (self.entry(text), text.as_str()) {
            // A standard surface gives way to the document's own.
            (Some((Meaning::Function(..), None)), _) => Ok(()),
            (Some((Meaning::Value(_) | Meaning::Function(..) | Meaning::Faulty, Some(_))), _)
                if self.may_hide && !self.names.contains_key(text) =>
            {
                Ok(())
            }
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

    /// Says what is going to be declared, so that a use before that can be told from a slip.
    pub fn announce<'n>(&mut self, names: impl Iterator<Item = &'n Name>) {
        for name in names.take(self.limit) {
            self.announced.entry(name.text.clone()).or_insert(name.span);
        }
    }

    /// The finding for a name that has no meaning here; `hint` is for one that is declared nowhere.
    pub fn unknown_name(&self, name: &Name, hint: Option<String>) -> Diagnostic {
        let stem = name.text.rsplit_once('_').map(|(stem, _)| stem);
        let place = |text: &str| self.layers().find_map(|scope| scope.announced.get(text));
        match place(&name.text).or_else(|| stem.filter(|stem| self.meaning(stem).is_none()).and_then(place)) {
            Some(place) => Diagnostic::new(Code::UnknownName, format!("`{}` is used before it is declared", name.text))
                .at(name.span)
                .label(*place, "declared here")
                .hint("move the declaration up; params are read first, and may use earlier params only"),
            None => hint.into_iter().fold(self.undeclared(name), Diagnostic::hint),
        }
    }

    /// The finding for a name that nothing declares, with the closest declared names.
    fn undeclared(&self, name: &Name) -> Diagnostic {
        let text = &name.text;
        let finding = Diagnostic::new(Code::UnknownName, format!("unknown name `{text}`")).at(name.span);
        if text.len() > COMPARED_BYTES {
            return finding.hint("it is declared nowhere, and too long to be a slip of another name");
        }
        if text.starts_with("S_") {
            return finding
                .hint("the components are `S_x`, `S_y`, `S_z`; derivatives are written `∂²S/∂u²` or `d2S/du2`");
        }
        if let Some(written) = foreign_function(text) {
            return finding.hint(format!("write `{written}`"));
        }
        let plain = text.trim_end_matches('\'');
        if plain.len() < text.len()
            && matches!(self.meaning(plain), Some(Meaning::Function(..) | Meaning::Value(_) | Meaning::Surface(_)))
        {
            return finding.hint(format!(
                "a prime is part of a name and takes no derivative of `{plain}`: write the derivative out"
            ));
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

    /// `kv` as `k*v`, `sinv` as `sin(v)`, `cos3v` as `cos(3*v)`, when all parts are known.
    fn as_product(&self, text: &str) -> Option<String> {
        let is_known = |name: &str| self.entry(name).is_some();
        for function in Function::ALL {
            let Some(argument) = text.strip_prefix(function.row().name) else { continue };
            let factor = argument.trim_start_matches(|c: char| c.is_ascii_digit());
            if !is_known(factor) {
                continue;
            }
            let (name, number) = (function.row().name, argument.strip_suffix(factor).unwrap_or_default());
            let product = if number.is_empty() { "" } else { "*" };
            return Some(format!("{name}({number}{product}{factor})"));
        }
        (1..text.len())
            .filter_map(|at| text.split_at_checked(at))
            .find_map(|(left, right)| (is_known(left) && is_known(right)).then(|| format!("{left}*{right}")))
    }

    fn closest(&self, text: &str) -> Option<&str> {
        let functions =
            Function::ALL.iter().map(|function| function.row().name).filter(|name| Function::named(name).is_some());
        let names = self
            .layers()
            .flat_map(|scope| scope.order.iter().map(String::as_str))
            .filter(|name| (2..=COMPARED_BYTES).contains(&name.len()))
            .chain(functions);
        let distances = names.map(|name| (strsim::damerau_levenshtein(text, name), name));
        let (distance, name) = distances.min_by_key(|(distance, _)| *distance)?;
        (distance <= text.chars().count().div_ceil(3)).then_some(name)
    }
}

/// How a function that has another name elsewhere is written here.
fn foreign_function(name: &str) -> Option<String> {
    const NAMES: &[(&str, &str)] = &[
        ("sech", "1/cosh(…)"),
        ("csch", "1/sinh(…)"),
        ("cosech", "1/sinh(…)"),
        ("coth", "1/tanh(…)"),
        ("cosec", "csc(…)"),
        ("tg", "tan(…)"),
        ("ctg", "cot(…)"),
        ("sgn", "sign(…)"),
        ("lg", "log10(…)"),
        ("arsinh", "asinh(…)"),
        ("arcosh", "acosh(…)"),
        ("artanh", "atanh(…)"),
    ];
    let known = NAMES.iter().find(|(foreign, _)| *foreign == name).map(|(_, written)| (*written).to_owned());
    let base = name.strip_prefix("log").filter(|base| base.starts_with(|c: char| c == '_' || c.is_ascii_digit()));
    known.or_else(|| match base?.trim_start_matches('_') {
        "10" => Some("log10(…)".to_owned()),
        base => Some(format!("ln(…)/ln({base})")),
    })
}
