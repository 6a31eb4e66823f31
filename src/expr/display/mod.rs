//! Expressions as text: ASCII and Unicode forms that read back as the same expression, and LaTeX.

mod product;

use super::function::Function;
use super::graph::{Constant, ExprId, Graph, Node};
use super::name::{latex_name, unicode_name};
use super::number::Number;
use super::spline::SplineCall;

/// How an expression is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// `0.8*b6*t*sin(a5*v)`
    Ascii,
    /// `0.8 b₆ t sin(a₅ v)`
    Unicode,
    /// `0.8\, b_{6}\, t\, \sin\left(a_{5}\, v\right)`
    Latex,
}

impl Notation {
    /// A name, given in its canonical form.
    #[must_use]
    pub fn name(self, canonical: &str) -> String {
        match self {
            Notation::Ascii => canonical.to_owned(),
            Notation::Unicode => unicode_name(canonical),
            Notation::Latex => latex_name(canonical),
        }
    }
}

/// The text of an expression would be longer than allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TextTooLong {
    /// The bytes that were allowed.
    pub allowed: usize,
}

/// How tightly a piece of text holds together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Product,
    Power,
    Atom,
}

enum Piece {
    Text(&'static str),
    Owned(String),
    /// An expression, in brackets unless it holds together at least this tightly.
    Expr(ExprId, Strength),
    /// An expression whose leading minus the sum around it has already written.
    Negated(ExprId),
}

impl Graph {
    /// The text of `expr` in `notation`, of at most `allowed` bytes.
    ///
    /// # Errors
    /// [`TextTooLong`]: sharing is lost in text, which can be exponentially larger than its graph.
    pub fn text(&self, expr: ExprId, notation: Notation, allowed: usize) -> Result<String, TextTooLong> {
        self.text_with_names(expr, notation, allowed, |name| name)
    }

    /// As [`Graph::text`], with each symbol under the canonical name that `named` gives it.
    ///
    /// # Errors
    /// As [`Graph::text`].
    pub fn text_with_names(
        &self,
        expr: ExprId,
        notation: Notation,
        allowed: usize,
        named: fn(&str) -> &str,
    ) -> Result<String, TextTooLong> {
        let writer = Writer { graph: self, notation, named };
        let mut text = String::new();
        let mut pending = vec![Piece::Expr(expr, Strength::Sum)];
        while let Some(piece) = pending.pop() {
            match piece {
                Piece::Text(part) => text.push_str(part),
                Piece::Owned(part) => text.push_str(&part),
                Piece::Expr(id, least) => {
                    let (pieces, strength) = writer.pieces(id);
                    let brackets = strength < least;
                    if brackets {
                        pending.push(Piece::Text(writer.brackets().1));
                    }
                    pending.extend(pieces.into_iter().rev());
                    if brackets {
                        pending.push(Piece::Text(writer.brackets().0));
                    }
                }
                Piece::Negated(id) => {
                    pending.extend(writer.product(id, true).0.into_iter().rev());
                }
            }
            if text.len() > allowed {
                return Err(TextTooLong { allowed });
            }
        }
        Ok(text)
    }
}

struct Writer<'a> {
    graph: &'a Graph,
    notation: Notation,
    named: fn(&str) -> &str,
}

type Pieces = (Vec<Piece>, Strength);

impl Writer<'_> {
    fn brackets(&self) -> (&'static str, &'static str) {
        if self.notation == Notation::Latex { (r"\left(", r"\right)") } else { ("(", ")") }
    }

    fn pieces(&self, id: ExprId) -> Pieces {
        match self.graph.node(id) {
            Node::Number(number) => self.number(*number),
            Node::Constant(constant) => (vec![Piece::Text(self.constant(*constant))], Strength::Atom),
            Node::Symbol(symbol) => {
                let name = (self.named)(self.graph.symbol_name(*symbol));
                (vec![Piece::Owned(self.notation.name(name))], Strength::Atom)
            }
            Node::Variable(variable) => (vec![Piece::Text(variable.name())], Strength::Atom),
            Node::Sum(terms) => self.sum(terms),
            Node::Product(_) => self.product(id, false),
            Node::Power(base, exponent) => {
                if self.is_inverse(id) {
                    self.product(id, false)
                } else {
                    self.power(*base, *exponent)
                }
            }
            Node::Call(Function::Exp, arguments) if self.notation != Notation::Ascii => {
                let argument = arguments.first().copied().unwrap_or(id);
                (std::iter::once(Piece::Text("e")).chain(self.exponent(argument)).collect(), Strength::Power)
            }
            Node::Call(function, arguments) => {
                let name = if self.notation == Notation::Latex { function.row().latex } else { function.row().name };
                let mut pieces = vec![Piece::Text(name), Piece::Text(self.brackets().0)];
                for (index, &argument) in arguments.iter().enumerate() {
                    if index > 0 {
                        pieces.push(Piece::Text(", "));
                    }
                    pieces.push(Piece::Expr(argument, Strength::Sum));
                }
                pieces.push(Piece::Text(self.brackets().1));
                (pieces, Strength::Atom)
            }
            Node::Spline(call, arguments) => self.spline(call, arguments),
        }
    }

    /// `C_x(v)`, `∂²C_x(v)/∂v²`
    fn spline(&self, call: &SplineCall, arguments: &[ExprId]) -> Pieces {
        let (open, close) = self.brackets();
        let mut pieces = vec![Piece::Owned(self.notation.name(call.spline.name())), Piece::Text(open)];
        for (index, &argument) in arguments.iter().enumerate() {
            pieces.extend((index > 0).then_some(Piece::Text(", ")));
            pieces.push(Piece::Expr(argument, Strength::Sum));
        }
        pieces.push(Piece::Text(close));
        let total: usize = call.orders.iter().sum();
        if total == 0 {
            return (pieces, Strength::Atom);
        }
        let (d, bar, end) = match self.notation {
            Notation::Ascii => ("d", "/", ""),
            Notation::Unicode => ("∂", "/", ""),
            Notation::Latex => (r"\partial ", "}{", "}"),
        };
        let power = |order: usize| match (order, self.notation) {
            (1, _) => String::new(),
            (_, Notation::Ascii) => order.to_string(),
            (_, Notation::Unicode) => superscripts(order),
            (_, Notation::Latex) => format!("^{{{order}}}"),
        };
        let begin = match self.notation {
            Notation::Latex => format!(r"\frac{{\partial{} ", power(total)),
            _ => format!("{d}{}", power(total)),
        };
        let below = call.orders.iter().enumerate().filter(|(_, order)| **order > 0);
        let below = below.map(|(index, order)| format!("{d}{}{}", call.spline.argument(index), power(*order)));
        pieces.insert(0, Piece::Owned(begin));
        pieces.push(Piece::Owned(format!("{bar}{}{end}", below.collect::<Vec<_>>().join(""))));
        // Behind `∂v` a power would be one of v.
        (pieces, Strength::Power)
    }

    fn number(&self, number: Number) -> Pieces {
        let text = number.to_string();
        let strength = if text.starts_with('-') {
            Strength::Sum
        } else if text.contains('/') {
            Strength::Product
        } else {
            Strength::Atom
        };
        let strength =
            if self.notation == Notation::Latex && text.contains('e') { Strength::Product } else { strength };
        let text = match (self.notation, text.split_once('/')) {
            (Notation::Latex, Some((above, below))) => format!(r"\frac{{{above}}}{{{below}}}"),
            _ => self.digits(text),
        };
        (vec![Piece::Owned(text)], strength)
    }

    /// A number without a fraction bar: `1e20` is a power of ten in LaTeX.
    fn digits(&self, text: String) -> String {
        match text.split_once('e').filter(|_| self.notation == Notation::Latex) {
            Some(("1", exponent)) => format!("10^{{{exponent}}}"),
            Some((mantissa, exponent)) => format!(r"{mantissa} \cdot 10^{{{exponent}}}"),
            None => text,
        }
    }

    fn constant(&self, constant: Constant) -> &'static str {
        match (constant, self.notation) {
            (Constant::E, _) => "e",
            (Constant::Pi, Notation::Ascii) => "pi",
            (Constant::Pi, Notation::Unicode) => "π",
            (Constant::Pi, Notation::Latex) => r"\pi",
        }
    }

    fn sum(&self, terms: &[ExprId]) -> Pieces {
        let mut pieces = Vec::with_capacity(2 * terms.len());
        for (index, &term) in terms.iter().enumerate() {
            let negative = self.factor(term).is_some_and(Number::is_negative);
            match (index, negative) {
                (0, false) => {}
                (0, true) => pieces.push(Piece::Text("-")),
                (_, false) => pieces.push(Piece::Text(" + ")),
                (_, true) => pieces.push(Piece::Text(" - ")),
            }
            pieces.push(if negative { Piece::Negated(term) } else { Piece::Expr(term, Strength::Product) });
        }
        (pieces, Strength::Sum)
    }

    /// The numeric factor of a term, if it has one.
    fn factor(&self, term: ExprId) -> Option<Number> {
        match self.graph.node(term) {
            Node::Number(number) => Some(*number),
            Node::Product(factors) => factors.first().and_then(|&first| self.graph.as_number(first)),
            _ => None,
        }
    }

    /// Whether `id` is a power with a negative number as exponent, which is written below a fraction bar.
    fn is_inverse(&self, id: ExprId) -> bool {
        match self.graph.node(id) {
            // Powers of zero fold when they are read back, so `0^(-2)` must not become `1/0^2`.
            Node::Power(base, exponent) => {
                !self.graph.is_zero(*base) && self.graph.as_number(*exponent).is_some_and(Number::is_negative)
            }
            _ => false,
        }
    }

    /// `base^(-exponent)` for a negative number, as it is written below a fraction bar.
    fn inverse_power(&self, base: ExprId, exponent: ExprId) -> Vec<Piece> {
        let positive = self.graph.as_number(exponent).map_or(Number::ONE, std::ops::Neg::neg);
        if positive.is_one() {
            return vec![Piece::Expr(base, Strength::Power)];
        }
        self.power_of(base, vec![Piece::Owned(positive.to_string())], positive).0
    }

    fn power(&self, base: ExprId, exponent: ExprId) -> Pieces {
        match self.graph.as_number(exponent) {
            Some(number) => self.power_of(base, vec![Piece::Owned(number.to_string())], number),
            None => {
                let mut pieces = vec![Piece::Expr(base, Strength::Atom)];
                pieces.extend(self.exponent(exponent));
                (pieces, Strength::Power)
            }
        }
    }

    fn power_of(&self, base: ExprId, exponent: Vec<Piece>, number: Number) -> Pieces {
        if number.to_string() == "0.5" {
            let (open, close) = if self.notation == Notation::Latex { (r"\sqrt{", "}") } else { ("sqrt(", ")") };
            return (vec![Piece::Text(open), Piece::Expr(base, Strength::Sum), Piece::Text(close)], Strength::Atom);
        }
        let mut pieces = vec![Piece::Expr(base, Strength::Atom)];
        let digits = number.to_string();
        let exponent = if digits.contains('e') { vec![Piece::Owned(self.digits(digits.clone()))] } else { exponent };
        if self.notation == Notation::Unicode && digits.chars().all(|c| c.is_ascii_digit()) {
            pieces.push(Piece::Owned(digits.chars().map(superscript).collect()));
        } else if self.notation == Notation::Latex {
            pieces.push(Piece::Text("^{"));
            pieces.extend(exponent);
            pieces.push(Piece::Text("}"));
        } else if digits.contains(['/', '-']) {
            pieces.push(Piece::Text("^("));
            pieces.extend(exponent);
            pieces.push(Piece::Text(")"));
        } else {
            pieces.push(Piece::Text("^"));
            pieces.extend(exponent);
        }
        (pieces, Strength::Power)
    }

    fn exponent(&self, exponent: ExprId) -> Vec<Piece> {
        if self.notation == Notation::Latex {
            vec![Piece::Text("^{"), Piece::Expr(exponent, Strength::Sum), Piece::Text("}")]
        } else {
            vec![Piece::Text("^"), Piece::Expr(exponent, Strength::Atom)]
        }
    }
}

/// `12` as `¹²`.
pub(super) fn superscripts(number: usize) -> String {
    number.to_string().chars().map(superscript).collect()
}

fn superscript(digit: char) -> char {
    match digit {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32(u32::from('⁰') + u32::from(digit) - u32::from('0')).unwrap_or(digit),
    }
}
