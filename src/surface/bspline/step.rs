//! B-spline surfaces of STEP files (ISO 10303-21), as they stand behind the faces of a model.
//!
//! Input: a Part 21 text; output: its B-spline surfaces, in the order in which the file lists them. Read are
//! `B_SPLINE_SURFACE_WITH_KNOTS`, alone or as a part of a complex instance, and the points it names; nothing else of the
//! file matters. Edges that trim a face, units and placements of assemblies are not read: coordinates are taken as they
//! stand. Everything is a loop over tokens: no nesting of a text can exhaust the stack.

use rustc_hash::FxHashMap;

use super::{BsplineSurface, KnotVector};
use crate::diagnostic::{Code, Diagnostic, Shortest};
use crate::limits::Limits;

/// A piece of an instance.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Token<'a> {
    Open,
    Close,
    Comma,
    /// `#12`
    Reference(u64),
    Number(f64),
    /// `B_SPLINE_SURFACE`
    Word(&'a str),
    /// What stands in quotes, their doubling included.
    Text(&'a str),
    /// `.T.`, `$`, `*` and what has no meaning here.
    Other,
}

/// The surface alone, or as a part of a complex instance.
const SURFACE: &str = "B_SPLINE_SURFACE_WITH_KNOTS";

/// What a complete file ends with.
const END: &str = "END-ISO-10303-21";

/// Reads the B-spline surfaces of a STEP file, each with its name, which is often empty.
///
/// # Errors
/// [`Code::BadSplineFile`] for a text that is no STEP file, is cut off or numbers two instances alike, for one without a
/// B-spline surface, and for surfaces that are rational or refer to points that are missing; [`Code::LimitReached`] for more control points than `limits` allow; the
/// errors of [`KnotVector::new`] and [`BsplineSurface::new`], each with the number of its instance.
pub fn from_step(text: &str, limits: &Limits) -> Result<Vec<(String, BsplineSurface)>, Diagnostic> {
    if !text.trim_start().starts_with("ISO-10303-21") {
        let finding = Diagnostic::new(Code::BadSplineFile, "this is no STEP file: it does not begin with ISO-10303-21");
        return Err(finding.hint("STEP files are Part 21 texts, with the extension .step or .stp"));
    }
    let instances = instances(text);
    if !text.contains(END) {
        let after = instances.last().map_or_else(String::new, |(number, _)| format!(" behind #{number}"));
        let finding = bad(format!("the STEP file ends{after}, before its {END}: it was cut off"));
        return Err(finding.hint("copy or export the file once more"));
    }
    let mut bodies = FxHashMap::default();
    for &(number, body) in &instances {
        if bodies.insert(number, body).is_some() {
            return Err(bad(format!("the STEP file has two instances #{number}")));
        }
    }
    let mut surfaces = Vec::new();
    let mut points = 0_usize;
    for (number, body) in instances {
        if !body.contains(SURFACE) {
            continue;
        }
        let read = Instance { bodies: &bodies, tokens: tokens(body) };
        let surface =
            read.surface(limits.control_points.saturating_sub(points)).map_err(|finding| about(number, finding))?;
        let Some((name, surface)) = surface else { continue };
        points = points.saturating_add(surface.net().len());
        surfaces.push((name, surface));
    }
    if surfaces.is_empty() {
        let finding = Diagnostic::new(Code::BadSplineFile, "the STEP file has no face on a B-spline surface");
        return Err(finding.hint("planes, cylinders and other surfaces that are no B-splines are not read"));
    }
    Ok(surfaces)
}

/// The largest of the distances below which two points of a STEP file are one, as the file states it in the unit of its
/// coordinates; `None` if it states none.
#[must_use]
pub fn uncertainty(text: &str) -> Option<f64> {
    let stated = instances(text).into_iter().filter(|(_, body)| body.contains("UNCERTAINTY_MEASURE_WITH_UNIT"));
    let length = |(_, body): (u64, &str)| {
        let tokens = tokens(body);
        let at = tokens.iter().position(|token| *token == Token::Word("LENGTH_MEASURE"))?;
        match tokens.get(at + 1..at + 3) {
            Some([Token::Open, Token::Number(length)]) if length.is_finite() => Some(*length),
            _ => None,
        }
    };
    stated.filter_map(length).reduce(f64::max)
}

/// A finding with the number of the instance it is about.
fn about(number: u64, finding: Diagnostic) -> Diagnostic {
    let renamed = Diagnostic::new(finding.code, format!("#{number}: {}", finding.message));
    finding.hints.into_iter().fold(renamed, Diagnostic::hint)
}

fn bad(message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::BadSplineFile, message)
}

/// The instances `#12 = …;` of a file: number and what stands behind the `=`.
fn instances(text: &str) -> Vec<(u64, &str)> {
    let mut found = Vec::new();
    let mut start = 0;
    let (mut in_text, mut in_comment) = (false, false);
    let mut before = ' ';
    for (at, letter) in text.char_indices() {
        match letter {
            '/' if in_comment && before == '*' => in_comment = false,
            _ if in_comment => {}
            '\'' => in_text = !in_text,
            _ if in_text => {}
            '*' if before == '/' => in_comment = true,
            ';' => {
                let mut statement = text.get(start..at).unwrap_or("").trim();
                start = at + 1;
                // Behind a comment that stands before the number.
                while let Some((_, rest)) = statement.strip_prefix("/*").and_then(|inside| inside.split_once("*/")) {
                    statement = rest.trim();
                }
                let number = statement.strip_prefix('#').and_then(|rest| rest.split_once('='));
                if let Some((Ok(number), body)) = number.map(|(number, body)| (number.trim().parse(), body)) {
                    found.push((number, body));
                }
            }
            _ => {}
        }
        before = letter;
    }
    found
}

/// The tokens of an instance.
fn tokens(body: &str) -> Vec<Token<'_>> {
    let mut tokens = Vec::new();
    let mut rest = body.trim_start();
    while let Some(letter) = rest.chars().next() {
        let (token, length) = match letter {
            '(' => (Some(Token::Open), 1),
            ')' => (Some(Token::Close), 1),
            ',' => (Some(Token::Comma), 1),
            '\'' => {
                let inside = text_length(rest);
                (rest.get(1..1 + inside).map(Token::Text), inside + 2)
            }
            '/' if rest.starts_with("/*") => (None, rest.find("*/").map_or(rest.len(), |end| end + 2)),
            '#' => {
                let length = 1 + run(rest.get(1..), |c| c.is_ascii_digit());
                (rest.get(1..length).and_then(|digits| digits.parse().ok()).map(Token::Reference), length)
            }
            '.' => (Some(Token::Other), rest.get(1..).and_then(|rest| rest.find('.')).map_or(1, |end| end + 2)),
            '+' | '-' | '0'..='9' => {
                let length = run(Some(rest), |c| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E'));
                // What is no number counts as one that is not finite, and is refused where it is used.
                let number = rest.get(..length).and_then(|digits| digits.parse().ok()).unwrap_or(f64::NAN);
                (Some(Token::Number(number)), length)
            }
            _ if letter.is_ascii_alphabetic() || letter == '_' => {
                let length = run(Some(rest), |c| c.is_ascii_alphanumeric() || c == '_');
                (rest.get(..length).map(Token::Word), length)
            }
            _ => (Some(Token::Other), letter.len_utf8()),
        };
        tokens.extend(token);
        rest = rest.get(length..).unwrap_or("").trim_start();
    }
    tokens
}

/// How many bytes at the start of `text` satisfy `is_part`, which takes ASCII only.
fn run(text: Option<&str>, is_part: impl Fn(char) -> bool) -> usize {
    text.unwrap_or("").find(|c| !is_part(c)).unwrap_or(text.map_or(0, str::len))
}

/// The bytes between the quote that `rest` begins with and the one that closes it; a doubled one is a letter.
fn text_length(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let mut at = 1;
    while let Some(byte) = bytes.get(at) {
        if *byte == b'\'' {
            if bytes.get(at + 1) != Some(&b'\'') {
                break;
            }
            at += 1;
        }
        at += 1;
    }
    at - 1
}

/// The tokens between a bracket that `tokens` begins with and the one that closes it.
fn inside<'t, 'a>(tokens: &'t [Token<'a>]) -> Option<&'t [Token<'a>]> {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate() {
        match token {
            Token::Open => depth += 1,
            Token::Close => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return tokens.get(1..at);
        }
    }
    None
}

/// The entries of a list: what stands between its commas.
fn entries<'t, 'a>(tokens: &'t [Token<'a>]) -> Vec<&'t [Token<'a>]> {
    let mut depth = 0_usize;
    let is_border = |token: &Token<'_>| {
        match token {
            Token::Open => depth += 1,
            Token::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        *token == Token::Comma && depth == 0
    };
    tokens.split(is_border).collect()
}

/// An instance with those it refers to.
struct Instance<'a> {
    bodies: &'a FxHashMap<u64, &'a str>,
    tokens: Vec<Token<'a>>,
}

impl<'a> Instance<'a> {
    /// The arguments of the part called `word`.
    fn part(&self, word: &str) -> Option<Vec<&[Token<'a>]>> {
        let at = self.tokens.iter().position(|token| *token == Token::Word(word))?;
        inside(self.tokens.get(at + 1..)?).map(entries)
    }

    /// The surface of at most `allowed` points and its name; `None` if the word stands in a text only.
    fn surface(&self, allowed: usize) -> Result<Option<(String, BsplineSurface)>, Diagnostic> {
        let Some(own) = self.part(SURFACE) else { return Ok(None) };
        let incomplete = || bad("a B-spline surface is incomplete");
        // A complex instance distributes over its parts what a simple one has in one place.
        let (name, base, knots) = match self.part("B_SPLINE_SURFACE") {
            Some(base) => (self.part("REPRESENTATION_ITEM"), base, own),
            None => {
                let rest = own.get(1..).ok_or_else(incomplete)?;
                let (base, knots) = rest.split_at_checked(7).ok_or_else(incomplete)?;
                (own.get(..1).map(<[_]>::to_vec), base.to_vec(), knots.to_vec())
            }
        };
        let [degree_u, degree_v, net, ..] = base.as_slice() else { return Err(incomplete()) };
        let [counts_u, counts_v, knots_u, knots_v, ..] = knots.as_slice() else { return Err(incomplete()) };
        let u = KnotVector::new(degree(degree_u)?, repeated(counts_u, knots_u, allowed)?)?;
        let v = KnotVector::new(degree(degree_v)?, repeated(counts_v, knots_v, allowed)?)?;
        let mut points = Vec::new();
        for (index, row) in entries(inside(net).ok_or_else(incomplete)?).into_iter().enumerate() {
            let row = entries(inside(row).ok_or_else(incomplete)?);
            if row.len() != v.points() {
                let (length, needed) = (row.len(), v.points());
                let message =
                    format!("row {index} of the net has {length} points, and the knots of v belong to {needed}");
                return Err(Diagnostic::new(Code::NetSize, message));
            }
            if points.len().saturating_add(row.len()) > allowed {
                let message = "the file has more control points than the limit `control-points`";
                return Err(Diagnostic::new(Code::LimitReached, message));
            }
            for point in row {
                points.push(self.point(point)?);
            }
        }
        self.check_weights(points.len())?;
        let name = match name.as_deref() {
            Some([[Token::Text(name)], ..]) => name.replace("''", "'"),
            _ => String::new(),
        };
        Ok(Some((name, BsplineSurface::new(u, v, points)?)))
    }

    /// Refuses weights, one for each of `points`, that make a surface rational or no surface at all.
    fn check_weights(&self, points: usize) -> Result<(), Diagnostic> {
        let Some(weights) = self.part("RATIONAL_B_SPLINE_SURFACE") else { return Ok(()) };
        let numbers = weights.iter().flat_map(|list| list.iter()).filter_map(|token| match token {
            Token::Number(weight) => Some(*weight),
            _ => None,
        });
        let numbers: Vec<f64> = numbers.collect();
        if numbers.len() != points {
            return Err(bad(format!("the B-spline surface has {points} control points and {} weights", numbers.len())));
        }
        if let Some(weight) = numbers.iter().find(|weight| !(**weight > 0.0 && weight.is_finite())) {
            return Err(bad(format!("a weight of the B-spline surface is {}, and not positive", Shortest(*weight))));
        }
        if numbers.windows(2).all(|pair| matches!(pair, [a, b] if a == b)) {
            return Ok(());
        }
        Err(bad("the B-spline surface is rational, with weights that differ")
            .hint("only polynomial B-splines are read; approximate it by one in the program it comes from"))
    }

    /// The coordinates of the point that is referred to.
    fn point(&self, reference: &[Token<'_>]) -> Result<[f64; 3], Diagnostic> {
        let [Token::Reference(number)] = reference else { return Err(bad("a control point is no reference")) };
        let body =
            self.bodies.get(number).ok_or_else(|| bad(format!("the control point #{number} is not in the file")))?;
        let point = Instance { bodies: self.bodies, tokens: tokens(body) };
        let coordinates = point.part("CARTESIAN_POINT").and_then(|arguments| match arguments.as_slice() {
            [_, list] => <[f64; 3]>::try_from(numbers(list)?).ok(),
            _ => None,
        });
        coordinates.ok_or_else(|| bad(format!("#{number} is no point with three coordinates")))
    }
}

/// The numbers of a list in brackets.
fn numbers(list: &[Token<'_>]) -> Option<Vec<f64>> {
    let number = |entry: &[Token<'_>]| match entry {
        [Token::Number(number)] => Some(*number),
        _ => None,
    };
    entries(inside(list)?).into_iter().map(number).collect()
}

fn degree(tokens: &[Token<'_>]) -> Result<usize, Diagnostic> {
    match tokens {
        // Degrees beyond the highest are refused with the knots.
        [Token::Number(degree)] if degree.fract() == 0.0 && (0.0..=1e3).contains(degree) => Ok(*degree as usize),
        _ => Err(bad("the degree of a B-spline surface is no whole number")),
    }
}

/// Each knot as often as its count says.
fn repeated(counts: &[Token<'_>], knots: &[Token<'_>], allowed: usize) -> Result<Vec<f64>, Diagnostic> {
    let lists = numbers(counts).zip(numbers(knots)).filter(|(counts, knots)| counts.len() == knots.len());
    let (counts, knots) = lists.ok_or_else(|| bad("knots and their multiplicities are no lists of one length"))?;
    let mut all = Vec::new();
    for (count, knot) in counts.into_iter().zip(knots) {
        // Whatever is allowed for a net is more than a direction of one may have.
        if !(count.fract() == 0.0 && (1.0..=1e3).contains(&count)) || all.len() > allowed.saturating_add(1000) {
            return Err(bad(format!("the knot {knot} has the multiplicity {count}")));
        }
        all.extend(std::iter::repeat_n(knot, count as usize));
    }
    Ok(all)
}
