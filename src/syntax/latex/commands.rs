//! The LaTeX commands that are read, and what they are in the plain notation.

use crate::expr::{Function, greek_named};

/// What a command is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Meaning {
    /// A name, a number or a constant: a letter.
    Letter(String),
    /// A function, by its plain name.
    Function(&'static str),
    /// An operator, or a bracket.
    Mark(&'static str),
    /// `\frac`
    Fraction,
    /// `\sqrt`
    Root,
    /// `\mathrm` and `\operatorname`: the name of several letters follows.
    Upright,
    /// `\mathbf` and the like, which mark a vector.
    Bold,
    /// `\left`, `\bigl` and the like, before a bracket.
    Sizing,
    /// `\lvert`, `\rvert`
    Bar,
    /// A blank, or a matter of appearance.
    Nothing,
    /// `\quad`, which may separate equations.
    Wide,
    /// `\tag`, `\label`: skipped with its group.
    Remark,
    /// `\begin`
    Begin,
    /// `\end`
    End,
}

/// The meaning of `\name`; `None` for a command that is not read.
pub fn meaning(name: &str) -> Option<Meaning> {
    Some(match name {
        "frac" | "dfrac" | "tfrac" => Meaning::Fraction,
        "sqrt" => Meaning::Root,
        "partial" => Meaning::Mark("∂"),
        "cdot" => Meaning::Mark("·"),
        "times" => Meaning::Mark("×"),
        "div" => Meaning::Mark("÷"),
        "ast" => Meaning::Mark("*"),
        "in" => Meaning::Mark("∈"),
        "{" => Meaning::Mark("("),
        "}" => Meaning::Mark(")"),
        "lvert" | "rvert" => Meaning::Bar,
        "mathrm" | "operatorname" => Meaning::Upright,
        "mathbf" | "boldsymbol" | "bm" | "vec" => Meaning::Bold,
        "left" | "right" | "big" | "bigl" | "bigr" | "Big" | "Bigl" | "Bigr" | "bigg" | "biggl" | "biggr" | "Bigg"
        | "Biggl" | "Biggr" => Meaning::Sizing,
        "," | ";" | ":" | "!" | ">" | " " | "\n" | "thinspace" | "medspace" | "thickspace" | "displaystyle"
        | "textstyle" | "nonumber" | "notag" => Meaning::Nothing,
        "quad" | "qquad" => Meaning::Wide,
        "tag" | "label" => Meaning::Remark,
        "begin" => Meaning::Begin,
        "end" => Meaning::End,
        "log" => Meaning::Function("ln"),
        _ => return function(name).map(Meaning::Function).or_else(|| greek(name).map(Meaning::Letter)),
    })
}

/// The function that the operator table writes as `\name`.
fn function(name: &str) -> Option<&'static str> {
    let command = |function: &&Function| function.row().latex.strip_prefix('\\') == Some(name);
    Function::ALL.iter().find(command).map(|function| function.row().name)
}

/// The plain name of a function written upright: `arsinh`, `asinh`.
pub fn upright_function(name: &str) -> Option<&'static str> {
    let written = format!(r"\operatorname{{{name}}}");
    let is_meant = |function: &&Function| function.row().latex == written || Function::named(name) == Some(**function);
    let named = Function::ALL.iter().find(is_meant).map(|function| function.row().name);
    named.filter(|name| Function::named(name).is_some()).or_else(|| (name == "sqrt").then_some("sqrt"))
}

/// The Greek letter of `\beta` or `\varphi`.
fn greek(name: &str) -> Option<String> {
    let known = name.strip_prefix("var").unwrap_or(name);
    greek_named(known).map(String::from)
}

/// The word a document could have meant by an unknown command.
pub fn advice(name: &str) -> &'static str {
    match name {
        "bar" | "hat" | "tilde" | "dot" | "ddot" | "overline" => "give the name a subscript instead, such as `b_{1}`",
        "sum" | "prod" | "dots" | "ldots" | "cdots" => "write out each term",
        "nabla" | "Delta" => {
            r"write it out: `\nabla^4 S` is `\left(\frac{\partial^2}{\partial u^2} + \frac{\partial^2}{\partial v^2}\right)^2 S`"
        }
        "int" => "integrals are not part of the language",
        "text" | "mbox" => "words are comments: write them after `%`",
        "pm" | "mp" => "write one equation for each sign",
        "prime" => "write the prime itself: `h_{0}'`",
        "sech" => r"write `\frac{1}{\cosh(…)}`",
        "csch" => r"write `\frac{1}{\sinh(…)}`",
        "coth" => r"write `\frac{1}{\tanh(…)}`",
        "le" | "leq" | "ge" | "geq" => "a range is stated in plain text: `domain v in [0, 2π]`",
        "infty" => "boundary data and coefficients are finite",
        _ => "docs/language.md lists what is read",
    }
}
