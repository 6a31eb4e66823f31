//! Products as text: what stands above and below the bar, in which order, and what stands between factors.

use num_rational::Ratio;
use num_traits::{One, Signed};

use super::{Notation, Piece, Pieces, Strength, Writer};
use crate::expr::function::Function;
use crate::expr::graph::{ExprId, Node};
use crate::expr::number::Number;

/// A factor's text.
struct Group {
    pieces: Vec<Piece>,
    opens_bracket: bool,
}

impl Writer<'_> {
    /// A number, product or power as a quotient of products; `drop_sign` leaves out a leading minus.
    pub(super) fn product(&self, id: ExprId, drop_sign: bool) -> Pieces {
        let factors = match self.graph.node(id) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![id],
        };
        let mut coefficient = Number::ONE;
        let (mut above, mut below): (Vec<Group>, Vec<Group>) = (Vec::new(), Vec::new());
        let mut ordered = factors;
        ordered.sort_by_key(|&factor| (self.rank(factor), factor));
        for factor in ordered {
            match self.graph.node(factor) {
                Node::Number(number) => coefficient = *number,
                Node::Power(base, exponent) if self.is_inverse(factor) => below.push(Group {
                    opens_bracket: self.opens_bracket(*base),
                    pieces: self.inverse_power(*base, *exponent),
                }),
                _ => above.push(Group {
                    opens_bracket: self.opens_bracket(factor),
                    pieces: vec![Piece::Expr(factor, Strength::Power)],
                }),
            }
        }
        let negative = coefficient.is_negative();
        let magnitude = if negative { -coefficient } else { coefficient };
        let (number_above, number_below) = split_fraction(magnitude);
        if let Some(number) = number_below {
            below.insert(0, Group { opens_bracket: false, pieces: vec![Piece::Owned(self.digits(number))] });
        }
        if number_above != "1" || above.is_empty() {
            above.insert(0, Group { opens_bracket: false, pieces: vec![Piece::Owned(self.digits(number_above))] });
        }
        let is_single_atom = above.len() == 1 && below.is_empty();
        let mut pieces = Vec::new();
        if negative && !drop_sign {
            pieces.push(Piece::Text("-"));
        }
        self.push_quotient(&mut pieces, above, below);
        let strength = match (negative && !drop_sign, is_single_atom) {
            (true, _) => Strength::Sum,
            (false, true) => Strength::Power,
            (false, false) => Strength::Product,
        };
        (pieces, strength)
    }

    fn push_quotient(&self, pieces: &mut Vec<Piece>, above: Vec<Group>, below: Vec<Group>) {
        if below.is_empty() {
            pieces.extend(self.joined(above));
        } else if self.notation == Notation::Latex {
            pieces.push(Piece::Text(r"\frac{"));
            pieces.extend(self.in_braces(above));
            pieces.push(Piece::Text("}{"));
            pieces.extend(self.in_braces(below));
            pieces.push(Piece::Text("}"));
        } else {
            let many = below.len() > 1;
            let mut above = above;
            if let Some(last) = above.last_mut()
                && let [Piece::Expr(id, least)] = last.pieces.as_mut_slice()
                && self.has_open_exponent(*id)
            {
                // `e^t/3` would be read in two ways.
                *least = Strength::Atom;
                last.opens_bracket = true;
            }
            pieces.extend(self.joined(above));
            pieces.push(Piece::Text(if many { "/(" } else { "/" }));
            pieces.extend(self.joined(below));
            if many {
                pieces.push(Piece::Text(")"));
            }
        }
    }

    /// Factors inside braces, where a single one needs no brackets.
    fn in_braces(&self, groups: Vec<Group>) -> Vec<Piece> {
        let mut pieces = self.joined(groups);
        if let [Piece::Expr(_, least)] = pieces.as_mut_slice() {
            *least = Strength::Sum;
        }
        pieces
    }

    fn joined(&self, groups: Vec<Group>) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for (index, group) in groups.into_iter().enumerate() {
            if index > 0 {
                pieces.push(Piece::Text(match self.notation {
                    Notation::Ascii => "*",
                    // `e^t (1 + v)^2` would read with the bracket in the exponent.
                    Notation::Unicode if group.opens_bracket => "·",
                    Notation::Unicode => " ",
                    // Two numbers side by side would be read as one.
                    Notation::Latex if group.opens_bracket => r" \cdot ",
                    Notation::Latex => r"\, ",
                }));
            }
            pieces.extend(group.pieces);
        }
        pieces
    }

    /// Whether a factor is a power of e or of a number with a name as its exponent.
    fn has_open_exponent(&self, factor: ExprId) -> bool {
        let exponent = match self.graph.node(factor) {
            Node::Call(Function::Exp, arguments) if self.notation != Notation::Ascii => arguments.first(),
            Node::Power(base, exponent) if self.graph.as_number(*base).is_some() => Some(exponent),
            _ => None,
        };
        exponent.is_some_and(|exponent| {
            matches!(self.graph.node(*exponent), Node::Symbol(_) | Node::Variable(_) | Node::Constant(_))
        })
    }

    /// Whether the text of a factor begins with a bracket.
    fn opens_bracket(&self, factor: ExprId) -> bool {
        match self.graph.node(factor) {
            Node::Sum(_) | Node::Product(_) => true,
            Node::Power(base, _) => match self.graph.node(*base) {
                Node::Symbol(_) | Node::Variable(_) | Node::Constant(_) => false,
                Node::Spline(call, _) => call.orders != [0, 0],
                Node::Call(function, _) => *function == Function::Exp && self.notation != Notation::Ascii,
                _ => true,
            },
            _ => false,
        }
    }

    /// Where a factor stands in a product: numbers, parameters, coordinates, exponentials, functions, sums.
    fn rank(&self, factor: ExprId) -> u8 {
        match self.graph.node(factor) {
            Node::Number(_) => 0,
            Node::Constant(_) => 1,
            Node::Symbol(_) => 2,
            Node::Variable(_) => 3,
            Node::Call(Function::Exp, _) => 4,
            Node::Call(..) | Node::Spline(..) => 5,
            Node::Power(base, _) => match self.graph.node(*base) {
                Node::Power(..) => 6,
                _ => self.rank_of_base(*base),
            },
            Node::Sum(_) | Node::Product(_) => 6,
        }
    }

    fn rank_of_base(&self, base: ExprId) -> u8 {
        match self.graph.node(base) {
            Node::Symbol(_) => 2,
            Node::Variable(_) => 3,
            Node::Call(..) | Node::Spline(..) => 5,
            _ => 6,
        }
    }
}

/// A number as what stands above and below a fraction bar; decimals have nothing below.
fn split_fraction(number: Number) -> (String, Option<String>) {
    let text = number.to_string();
    match (number, text.split_once('/')) {
        (Number::Exact(ratio), Some(_)) => {
            let ratio: Ratio<i128> = ratio.abs();
            let below = (!ratio.denom().is_one()).then(|| ratio.denom().to_string());
            (ratio.numer().to_string(), below)
        }
        _ => (text, None),
    }
}
