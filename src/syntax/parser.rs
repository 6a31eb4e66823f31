//! The generated parser and its errors in the reader's words.

use pest::Parser;
use pest::error::{ErrorVariant, InputLocation};
use pest::iterators::Pair;

use super::bars::{BAR_CLOSES, BAR_OPENS};
use super::quotes::FILLER;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::expr::{Function, greek_named};

#[derive(pest_derive::Parser)]
#[grammar = "../grammar/trimline.pest"]
struct Grammar;

/// What a subscript of S means.
const SUBSCRIPTS: &str =
    "the components are `S_x`, `S_y`, `S_z`; derivatives are written `∂S/∂u`, `∂²S/∂u²` or `d2S/du2`";

/// Signs that are not read, and what is.
const SIGNS: &[(char, &str)] =
    &[('∛', "cbrt(…)"), ('⅓', "1/3"), ('⅔', "2/3"), ('⅕', "1/5"), ('⅙', "1/6"), ('⅛', "1/8"), ('—', "-")];

/// The word of a deformation.
const DEFORM: &str = "deform";

/// A parsed piece of text.
pub type Parsed<'a> = Pair<'a, Rule>;

/// Parses one logical line that begins at byte `offset` of the source.
pub fn line(text: &str, offset: usize) -> Result<Parsed<'_>, Diagnostic> {
    run(Rule::line, text, offset)
}

/// Parses one or more expressions with commas between them, which begin at byte `offset` of the source.
pub fn values(text: &str, offset: usize) -> Result<Parsed<'_>, Diagnostic> {
    run(Rule::values, text, offset)
}

fn run(rule: Rule, text: &str, offset: usize) -> Result<Parsed<'_>, Diagnostic> {
    let mut pairs = Grammar::parse(rule, text).map_err(|error| unexpected(&error, text, offset))?;
    pairs.next().ok_or_else(|| Diagnostic::new(Code::UnexpectedText, "nothing to read").at(place(text, 0, offset)))
}

fn unexpected(error: &pest::error::Error<Rule>, text: &str, offset: usize) -> Diagnostic {
    let at = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    if let Some((message, hint)) = slip(text, at) {
        return Diagnostic::new(Code::UnexpectedText, message).at(place(text, at, offset)).hint(hint);
    }
    // Behind its own word the grammar would look for `d` as a factor.
    if at < DEFORM.len() && text.strip_prefix(DEFORM).is_some_and(|tail| tail.starts_with([' ', '\t'])) {
        let word = Span::new(offset, offset + DEFORM.len());
        return Diagnostic::new(Code::UnexpectedText, "this deformation is not complete")
            .at(word)
            .hint("write `deform u in [a, b], v in [c, d] by [x, y, z] keeping C1`");
    }
    let mut expected: Vec<&str> = match &error.variant {
        ErrorVariant::ParsingError { positives, .. } => positives.iter().filter_map(|rule| words(*rule)).collect(),
        ErrorVariant::CustomError { .. } => Vec::new(),
    };
    expected.sort_unstable();
    expected.dedup();
    let message = match expected.split_last() {
        None => format!("did not expect {}", found(text, at)),
        Some((only, [])) => format!("expected {only}, found {}", found(text, at)),
        Some((last, others)) => format!("expected {} or {last}, found {}", others.join(", "), found(text, at)),
    };
    let finding = Diagnostic::new(Code::UnexpectedText, message).at(place(text, at, offset));
    match advice(text, at) {
        Some(hint) => finding.hint(hint),
        None => finding,
    }
}

/// What stands at `at`, for a message.
fn found(text: &str, at: usize) -> String {
    match token(text.get(at..).unwrap_or("")) {
        "" => "the end".to_owned(),
        FILLER => "a text in quotes".to_owned(),
        BAR_OPENS | BAR_CLOSES => "`|`".to_owned(),
        token => format!("`{token}`"),
    }
}

fn place(text: &str, at: usize, offset: usize) -> Span {
    let token = token(text.get(at..).unwrap_or(""));
    Span::new(offset + at, offset + at + token.len())
}

/// The word or the single character that `rest` begins with.
fn token(rest: &str) -> &str {
    let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    let end = if word > 0 { word } else { rest.chars().next().map_or(0, char::len_utf8) };
    rest.get(..end.min(rest.len())).unwrap_or("").trim_end()
}

/// The reader's words for what the grammar expected; `None` for what would only add noise.
fn words(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::expression
        | Rule::values
        | Rule::term
        | Rule::run
        | Rule::power
        | Rule::call
        | Rule::bracketed
        | Rule::absolute
        | Rule::root
        | Rule::number
        | Rule::pi
        | Rule::application
        | Rule::adjacent
        | Rule::applied
        | Rule::exponent
        | Rule::bare_factor
        | Rule::unknown
        | Rule::sought
        | Rule::derivative
        | Rule::partial
        | Rule::differential
        | Rule::function
        | Rule::bare_argument
        | Rule::root_sign => "an expression",
        Rule::name | Rule::parameter | Rule::definition | Rule::assignment | Rule::range => "a name",
        Rule::interval => "an interval `[lo, hi]`",
        Rule::constraint | Rule::constraints | Rule::target | Rule::join | Rule::kw_join => {
            "a constraint such as `S_x = …`"
        }
        Rule::line
        | Rule::param_line
        | Rule::let_line
        | Rule::domain_line
        | Rule::pde_line
        | Rule::at_line
        | Rule::solve_line
        | Rule::kw_param
        | Rule::kw_let
        | Rule::kw_domain
        | Rule::kw_pde
        | Rule::patch_line
        | Rule::bspline_line
        | Rule::kw_bspline
        | Rule::knots_line
        | Rule::kw_knots
        | Rule::net_line
        | Rule::kw_net
        | Rule::layer_line
        | Rule::kw_layer
        | Rule::kw_patch
        | Rule::deform_line
        | Rule::kw_deform
        | Rule::seam_line
        | Rule::kw_seam
        | Rule::nsided_line
        | Rule::kw_nsided
        | Rule::edge_line
        | Rule::kw_edge
        | Rule::mirror_line
        | Rule::kw_mirror
        | Rule::repeat_line
        | Rule::kw_repeat
        | Rule::surface_line
        | Rule::kw_surface
        | Rule::curve_line
        | Rule::kw_curve
        | Rule::morph_line
        | Rule::kw_morph
        | Rule::kw_solve => {
            "a statement (`param`, `let`, `surface`, `curve`, `domain`, `pde`, `at`, `solve`, `deform`, `patch`, `seam`, `morph`, `bspline`, `edge`, `nsided`, `mirror`, `repeat`)"
        }
        Rule::surface | Rule::curve | Rule::pair => "a name",
        Rule::points => "`points(\"file.csv\")`",
        Rule::knots | Rule::knot_list => "`uniform in u`, `clamped in u` or `[…] in u`",
        Rule::net_size => "a size such as `5 x 5`",
        Rule::sampled => "`surface NAME sampled greville`",
        Rule::kw_from => "`from`",
        Rule::kw_sampled => "`sampled`",
        Rule::strength | Rule::kw_strength | Rule::flip => "`strength = …` or `flip`",
        Rule::kw_times => "`times`",
        Rule::rotated | Rule::kw_rotated => "`rotated about …`",
        Rule::moved | Rule::kw_moved => "`moved by …`",
        Rule::kw_about => "`about`",
        Rule::kw_at => "`at`",
        Rule::kw_in => "`in`",
        Rule::kw_by => "`by`",
        Rule::kw_to => "`to`",
        Rule::kw_keeping => "`keeping`",
        Rule::kw_with => "`with`",
        Rule::equation => "an equation",
        Rule::word => "a word",
        Rule::setting => "a setting such as `terms = 5`",
        Rule::setting_value | Rule::size | Rule::decimal | Rule::integer => "a value such as `5` or `11 x 11`",
        Rule::arguments | Rule::formals => "`(`",
        Rule::block_begin => "`{`",
        Rule::add_operator | Rule::multiply_operator => "an operator",
        Rule::EOI => "the end",
        _ => return None,
    })
}

/// The name in `join cylinder(…)`, if `before` ends behind it and `rest` begins with its bracket.
fn joined_call<'a>(before: &'a str, rest: &str) -> Option<&'a str> {
    let (start, name) = before.rsplit_once(' ')?;
    (rest.starts_with('(') && start.trim_end().ends_with("join")).then_some(name)
}

/// What is wrong where a function stands as no function may, and what to write instead.
fn slip(text: &str, at: usize) -> Option<(String, String)> {
    let (before, rest) = (text.get(..at)?.trim_end(), text.get(at..)?);
    let powered = before.strip_suffix('^').or_else(|| rest.starts_with('^').then_some(before));
    if let Some(function) = powered.and_then(function_at_end) {
        let message = format!("the power behind `{function}` is not a whole number");
        return Some((message, format!("put it behind the argument: `{function}(…)^(…)`")));
    }
    let function = function_at_end(before)?;
    if rest.starts_with(['[', '{']) {
        let message = format!("the argument of `{function}` stands in round brackets");
        return Some((message, format!("write `{function}(…)`")));
    }
    let before = before.strip_suffix(function)?.trim_end().trim_end_matches(['-', '−']);
    if before.ends_with('√') {
        let message = format!("below `√` the argument of `{function}` stands in brackets");
        return Some((message, format!("write `√{function}(…)`")));
    }
    if before.ends_with('^') || before.ends_with("**") {
        let message = format!("in an exponent the argument of `{function}` stands in brackets");
        return Some((message, format!("write `^{function}(…)`, or brackets round the whole exponent")));
    }
    None
}

/// The function that `text` ends with.
fn function_at_end(text: &str) -> Option<&str> {
    let text = text.trim_end();
    let word = text.rsplit(|c: char| !(c.is_alphanumeric() || c == '_')).next()?;
    let word = word.trim_start_matches(|c: char| c.is_ascii_digit());
    (Function::named(word).is_some() || word == "sqrt").then_some(word)
}

/// Advice for LaTeX outside a block.
fn latex_advice(rest: &str) -> Option<String> {
    if rest.starts_with('$') {
        return Some("LaTeX stands between two dollars on each side: `$$ … $$`".to_owned());
    }
    let command = rest.strip_prefix('\\')?;
    let end = command.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(command.len());
    let name = command.get(..end)?;
    Some(match greek_named(name) {
        Some(letter) => format!("write `{name}` or `{letter}`; LaTeX stands between `$$ … $$`"),
        None => r"LaTeX stands between `$$ … $$`, `\[ … \]` or `\begin{equation} … \end{equation}`".to_owned(),
    })
}

/// Advice for mistakes that people make.
fn advice(text: &str, at: usize) -> Option<String> {
    let rest = text.get(at..)?;
    let before = text.get(..at)?.trim_end();
    if rest.starts_with("==") || (rest.starts_with('=') && before.ends_with('=')) {
        return Some("write a single `=`".to_owned());
    }
    if let Some(hint) = latex_advice(rest) {
        return Some(hint);
    }
    if let Some((_, written)) = SIGNS.iter().find(|(sign, _)| rest.starts_with(*sign)) {
        return Some(format!("write `{written}`"));
    }
    if rest.starts_with('∇') {
        return Some("write it out: `∇²` is `∂²/∂u² + ∂²/∂v²`, `∇⁴ S` is `(∂²/∂u² + ∂²/∂v²)² S`".to_owned());
    }
    if rest.starts_with("S_") || before.ends_with("S_") || before.ends_with("S_{") {
        return Some(SUBSCRIPTS.to_owned());
    }
    if let Some(name) = joined_call(before, rest) {
        return Some(format!("declare it first: `surface A(p, q) = {name}(p, q, …)`, then `join A at …`"));
    }
    let states_equation = text.contains('=') && !super::preflight::starts_statement(text);
    if states_equation && (text.starts_with('(') || (text.contains('∂') && rest.starts_with(['+', '-', '−']))) {
        return Some("an equation begins with `pde`: write it before the equation, or before its LaTeX".to_owned());
    }
    if rest.starts_with('∂') || before.ends_with('∂') {
        return Some("a derivative is written `∂²S/∂u²` or `∂⁴S/∂u²∂v²`, an operator `∂²/∂u²`".to_owned());
    }
    if text.strip_prefix("curve").is_some_and(|tail| tail.starts_with([' ', '\t'])) {
        return Some("a curve comes from a file, `curve C = points(\"ring.csv\")`; a formula is a `let`".to_owned());
    }
    if let Some(word) = ["patch", "bspline"].into_iter().find(|word| text.starts_with(&format!("{word} ")))
        && !text.ends_with('{')
    {
        return Some(format!("the statements of a {word} stand in braces: `{word} a {{` … `}}`"));
    }
    if before.is_empty() && text.contains('∂') && text.contains('=') {
        return Some("an equation begins with `pde`, a constraint with `S`, `x` or a derivative of them".to_owned());
    }
    if text.starts_with("S") && rest.starts_with(':') {
        return Some("a boundary block begins with `at u = 0:`".to_owned());
    }
    if ["domain", "param"].iter().any(|word| text.starts_with(word)) && text.contains(['≤', '<', '⩽']) {
        return Some("a range is written `v in [0, 2π]`".to_owned());
    }
    if ["u =", "u=", "v =", "v="].iter().any(|start| text.starts_with(start)) {
        return Some("a boundary block begins with `at`: `at u = 0:`".to_owned());
    }
    if text.starts_with("pde") && before.contains(" where ") {
        return Some("values of coefficients follow `with`".to_owned());
    }
    if rest.starts_with('{') {
        return Some("braces stand in exponents and subscripts only; a vector is `[x, y, z]`".to_owned());
    }
    if text.starts_with("at ") && !text.contains(':') {
        return Some("a colon ends the position: `at u = 0:`".to_owned());
    }
    let statement = before.rsplit_once(':').map_or(before, |(_, constraints)| constraints);
    if rest.starts_with('=') && statement.contains('=') {
        return Some("a comma stands between two constraints or definitions of one line".to_owned());
    }
    if before.ends_with(|c: char| c.is_ascii_alphabetic()) && rest.starts_with(['-', '−']) {
        let word = before.rsplit(|c: char| !c.is_ascii_alphanumeric()).next()?;
        return Some(format!("put the argument in brackets: `{word}(-…)`"));
    }
    None
}
