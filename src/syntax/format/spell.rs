//! Names, derivatives, powers and operators in ASCII or in Unicode.

use std::borrow::Cow;

use super::Alphabet;
use super::token::{Kind, Line, Token};
use crate::expr::{Function, canonical_name, unicode_name};
use crate::syntax::RESERVED_WORDS;

/// Statements whose words are names of the document.
const OF_NAMES: &[&str] = &[
    "param", "let", "domain", "pde", "at", "surface", "patch", "join", "seam", "deform", "curve", "morph", "bspline",
    "knots", "net", "layer", "edge", "nsided", "mirror", "repeat",
];

/// Spells the tokens of `lines` in `alphabet`.
pub fn respell(lines: &mut [Line<'_>], alphabet: Alphabet) {
    if alphabet == Alphabet::Kept {
        return;
    }
    let mut has_names = true;
    let surfaces: Vec<String> = lines.iter().filter_map(surface_name).collect();
    for line in lines {
        let first = line.tokens.first().filter(|first| first.kind == Kind::Word).map(|first| first.text.to_string());
        if let Some(word) = first.filter(|word| RESERVED_WORDS.contains(&word.as_str()) && word != "with") {
            has_names = OF_NAMES.contains(&word.as_str());
        }
        if has_names {
            match alphabet {
                Alphabet::Ascii => to_ascii(&mut line.tokens),
                _ => to_unicode(&mut line.tokens, &surfaces),
            }
            keep_apart(&mut line.tokens);
        } else if alphabet == Alphabet::Ascii {
            line.tokens.iter_mut().filter(|token| token.is("×")).for_each(|token| token.text = "x".into());
        }
    }
}

/// The name that a line `surface NAME(…) = …` declares.
fn surface_name(line: &Line<'_>) -> Option<String> {
    match line.tokens.as_slice() {
        [statement, name, ..] if statement.is("surface") => Some(canonical_name(&name.text)),
        _ => None,
    }
}

/// `πt` was two tokens, and so must `pi t` be; `e²(t)` has one reading, and `e^2(t)` would have two.
fn keep_apart(tokens: &mut [Token<'_>]) {
    let is_word = |token: &Token<'_>| matches!(token.kind, Kind::Word | Kind::Number);
    let (mut follows_word, mut follows_number, mut follows_exponent) = (false, false, false);
    for token in tokens {
        token.is_spaced |= follows_word && is_word(token);
        token.is_spaced |= follows_exponent && matches!(token.kind, Kind::Open | Kind::Root | Kind::Other);
        follows_exponent = token.text.starts_with("e^")
            || (follows_number && token.kind == Kind::Superscript && token.text.starts_with('^'));
        follows_word = matches!(token.kind, Kind::Word | Kind::Superscript);
        follows_number = token.kind == Kind::Number;
    }
}

fn to_ascii(tokens: &mut [Token<'_>]) {
    for token in tokens {
        let text = match token.kind {
            Kind::Word if token.text.starts_with('∂') => Cow::Owned(ascii_derivative(&token.text)),
            Kind::Word if !token.text.is_ascii() => Cow::Owned(ascii_word(&token.text)),
            Kind::Superscript => Cow::Owned(format!("^{}", digits(&token.text))),
            Kind::Sign if !token.text.is_ascii() => Cow::Borrowed("-"),
            Kind::Operator if matches!(&*token.text, "·" | "⋅" | "∙" | "∗" | "×") => Cow::Borrowed("*"),
            Kind::Operator if matches!(&*token.text, "÷" | "∕") => Cow::Borrowed("/"),
            Kind::Relation if token.is("∈") => Cow::Borrowed("in"),
            _ => continue,
        };
        token.text = text;
    }
}

/// `∂u²∂v²` as `du2dv2`, `∂²S₁` as `d2S1`, `∂p∂q` as `dp dq`: a name goes on with the letters that follow.
fn ascii_derivative(text: &str) -> String {
    let part = |part: &str| {
        let plain = digits(part);
        if plain.is_ascii() { plain } else { canonical_name(&plain) }
    };
    let parts: Vec<String> = text.split('∂').map(part).collect();
    parts.join(if is_below(text) { "d" } else { " d" }).trim_start().to_owned()
}

/// `b₁²` as `b1^2`
fn ascii_word(text: &str) -> String {
    let end = text.find(|c: char| digits(&c.to_string()) != c.to_string()).unwrap_or(text.len());
    let (name, power) = text.split_at_checked(end).unwrap_or((text, ""));
    let name = if name.is_ascii() { name.to_owned() } else { canonical_name(name) };
    if power.is_empty() { name } else { format!("{name}^{}", digits(power)) }
}

/// Superscripts as plain digits.
fn digits(text: &str) -> String {
    const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let plain = |c: char| match SUPERSCRIPTS.chars().position(|superscript| superscript == c) {
        Some(digit) => char::from_digit(u32::try_from(digit).unwrap_or(0), 10).unwrap_or(c),
        None if c == '⁻' => '-',
        None => c,
    };
    text.chars().map(plain).collect()
}

fn superscript(text: &str) -> String {
    const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let raised = |c: char| c.to_digit(10).and_then(|digit| SUPERSCRIPTS.chars().nth(digit as usize)).unwrap_or(c);
    text.chars().map(raised).collect()
}

fn to_unicode(tokens: &mut Vec<Token<'_>>, surfaces: &[String]) {
    spell_derivatives(tokens, surfaces);
    raise_exponents(tokens);
    for sign in tokens.iter_mut().filter(|token| token.kind == Kind::Sign && !token.text.is_ascii()) {
        sign.text = Cow::Borrowed("-");
    }
    for token in tokens.iter_mut().filter(|token| token.kind == Kind::Word) {
        let is_function = Function::named(&token.text).is_some() || token.is("sqrt");
        if token.is("in") {
            continue;
        }
        let has_power = token.text.chars().any(|c| digits(&c.to_string()) != c.to_string());
        if !is_function && !has_power && !RESERVED_WORDS.contains(&&*token.text) && !token.text.starts_with('∂') {
            let canonical = canonical_name(&token.text);
            token.text = Cow::Owned(if canonical == "pi" { "π".to_owned() } else { unicode_name(&canonical) });
        }
    }
}

/// `d4S/du2dv2` as `∂⁴S/∂u²∂v²`, also with `(u, v, t)` before the bar; `dS1(u1, v, t)/du`, of a primary surface, too, and
/// `dA(1, v)/dp` in a parameter of one that the document declares.
fn spell_derivatives(tokens: &mut [Token<'_>], surfaces: &[String]) {
    for above in 0..tokens.len() {
        let Some((below, has_arguments)) = below_of(tokens, above, surfaces) else { continue };
        let Some(spelled) = tokens.get(above).and_then(|token| unicode_above(&token.text, has_arguments)) else {
            continue;
        };
        if let Some(token) = tokens.get_mut(above) {
            token.text = Cow::Owned(spelled);
        }
        if let Some(token) = tokens.get_mut(below) {
            token.text = Cow::Owned(unicode_below(&token.text));
            if is_below(&token.text) {
                continue;
            }
        }
        for token in tokens.iter_mut().skip(below + 1).take_while(|token| is_by(token)) {
            token.text = Cow::Owned(unicode_below(&token.text));
        }
    }
}

/// `dp`, as the grammar reads it behind the bar.
fn is_by(token: &Token<'_>) -> bool {
    token.kind == Kind::Word && token.text.starts_with(['d', '∂'])
}

/// The place of `du2` in `d2S/du2` and in `d2S(u, v, t)/du2`, and whether there are arguments, if the token at `above` is
/// the word before them.
fn below_of(tokens: &[Token<'_>], above: usize, surfaces: &[String]) -> Option<(usize, bool)> {
    let word = tokens.get(above).filter(|token| token.kind == Kind::Word)?;
    let differentiated = digits(word.text.strip_prefix(['d', '∂'])?);
    let is_of_surface =
        surfaces.contains(&canonical_name(differentiated.trim_start_matches(|c: char| c.is_ascii_digit())));
    let mut depth = 0_usize;
    let mut bar = above + 1;
    while let Some(token) = tokens.get(bar).filter(|token| depth > 0 || token.kind == Kind::Open) {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        bar += 1;
        if depth == 0 {
            break;
        }
    }
    tokens.get(bar).filter(|token| token.is("/"))?;
    let has_arguments = bar > above + 1;
    let is_parameter = |token: &Token<'_>| is_of_surface && has_arguments && is_by(token);
    let denominator = tokens.get(bar + 1).filter(|token| token.kind == Kind::Word)?;
    if !is_below(&denominator.text) && !is_parameter(denominator) {
        return None;
    }
    Some((bar + 1, has_arguments))
}

/// `d4S` as `∂⁴S`; names of surfaces only with arguments behind them.
fn unicode_above(text: &str, has_arguments: bool) -> Option<String> {
    let rest = text.strip_prefix(['d', '∂'])?;
    let name = rest.trim_start_matches(|c: char| digits(&c.to_string()).chars().all(|c| c.is_ascii_digit()));
    let order = superscript(&digits(rest.strip_suffix(name)?));
    let canonical = canonical_name(name);
    match canonical.as_str() {
        // An operator, `∂²/∂u²`.
        "" if !has_arguments => Some(format!("∂{order}")),
        "" => None,
        "S" | "S_x" | "S_y" | "S_z" | "x" | "y" | "z" | "x1" | "x2" | "x3" => Some(format!("∂{order}{name}")),
        _ if has_arguments => Some(format!("∂{order}{}", unicode_name(&canonical))),
        _ => None,
    }
}

/// `du2dv` as `∂u²∂v`, `dp1` as `∂p₁`
fn unicode_below(text: &str) -> String {
    match text.strip_prefix(['d', '∂']) {
        Some(parameter) if !is_below(text) => format!("∂{}", unicode_name(&canonical_name(parameter))),
        _ => superscript(&digits(text)).replace('d', "∂"),
    }
}

/// `du4`, `du2dv2`, `∂u²`
fn is_below(text: &str) -> bool {
    let plain = digits(text);
    let mut parts = plain.split(['d', '∂']);
    parts.next() == Some("") && {
        let parts: Vec<&str> = parts.collect();
        let is_part = |part: &&str| {
            part.strip_prefix(['u', 'v', 't']).is_some_and(|order| order.chars().all(|c| c.is_ascii_digit()))
        };
        !parts.is_empty() && parts.iter().all(is_part)
    }
}

/// Whether a token makes what stands before it a base.
fn is_raising(token: &Token<'_>) -> bool {
    token.kind == Kind::Superscript || matches!(&*token.text, "^" | "**")
}

/// `v^2` as `v²`, where a whole number is the whole exponent.
fn raise_exponents(tokens: &mut Vec<Token<'_>>) {
    let mut spelled: Vec<Token<'_>> = Vec::with_capacity(tokens.len());
    let mut rest = std::mem::take(tokens).into_iter().peekable();
    while let Some(token) = rest.next() {
        let is_power = token.kind == Kind::Operator && matches!(&*token.text, "^" | "**");
        // Not in `v^2^3`, where only the last exponent has no other above it.
        let is_exponent = spelled.iter().rev().nth(1).is_some_and(|before| matches!(&*before.text, "^" | "**"));
        let follows_operand = !is_exponent
            && spelled.last().is_some_and(|last| {
                matches!(last.kind, Kind::Close | Kind::Number)
                    || (last.kind == Kind::Word
                        && last
                            .text
                            .ends_with(|c: char| c.is_alphanumeric() && digits(&c.to_string()) == c.to_string())
                        && !last.text.starts_with('∂'))
            });
        let is_integer = |next: &Token<'_>| next.text.chars().all(|c| c.is_ascii_digit());
        match rest.next_if(|next| is_power && follows_operand && next.kind == Kind::Number && is_integer(next)) {
            Some(exponent) if !rest.peek().is_some_and(is_raising) => {
                let text = Cow::Owned(superscript(&exponent.text));
                spelled.push(Token { kind: Kind::Superscript, text, is_spaced: false });
            }
            Some(exponent) => spelled.extend([token, exponent]),
            None => spelled.push(token),
        }
    }
    *tokens = spelled;
}
