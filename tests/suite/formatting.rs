//! `fmt`: what is laid out how, that it says the same, and that doing it again changes nothing.

use proptest::prelude::*;
use trimline::diagnostic::{Code, Source};
use trimline::expr::Notation;
use trimline::limits::Limits;
use trimline::syntax::{self, Alphabet};

use crate::spec::{BOUNDARY, all_examples, decomposition, examples, told, with_data};

fn laid_out(text: &str, alphabet: Alphabet) -> String {
    syntax::format(&Source::new("spec", text), alphabet, &Limits::default())
        .unwrap_or_else(|found| panic!("{text}\n{}", told(text, &found)))
}

fn kept(text: &str) -> String {
    laid_out(text, Alphabet::Kept)
}

fn basis(text: &str) -> String {
    decomposition(text).to_text(Notation::Unicode, &Limits::default()).expect("short")
}

const ALPHABETS: [Alphabet; 3] = [Alphabet::Kept, Alphabet::Ascii, Alphabet::Unicode];

#[test]
fn every_example_laid_out_has_the_same_basis_and_is_not_changed_again() {
    for (name, text) in examples() {
        for alphabet in ALPHABETS {
            let once = laid_out(&text, alphabet);
            assert_eq!(basis(&once), basis(&text), "{name}");
            assert_eq!(laid_out(&once, alphabet), once, "{name}");
        }
    }
}

#[test]
fn alphabets_are_inverse_where_a_spelling_has_both() {
    for (name, text) in all_examples() {
        let ascii = laid_out(&text, Alphabet::Ascii);
        let code =
            |text: &str| text.lines().map(|line| line.split('#').next().unwrap_or("").to_owned()).collect::<String>();
        assert!(code(&ascii).is_ascii(), "{name}\n{ascii}");
        let unicode = laid_out(&text, Alphabet::Unicode);
        assert_eq!(code(&laid_out(&laid_out(&unicode, Alphabet::Ascii), Alphabet::Unicode)), code(&unicode), "{name}");
    }
}

#[test]
fn spacing_indentation_and_columns_are_canonical() {
    let text = "\n\n# head\nparam a=1,b = 2   in [ 0,3 ]   # first\nparam   c =-3 # second\n\n\n\ndomain v in[0,2π]
pde d4S/du4+2 d4S / du2dv2 -a*d4S/dv4=0
 with q=1 ,
r = 2\n
at u=0 :
  # on top
S_x = a  e^ -t *sin( v )+( b + c ) ^ 2
  +1 # more
S_y=b;S_z = 0
∂S/∂u=[0 ,0,
1]
at u = 1: S = [c|v| , 0, 0] ,
  ∂S/∂u = 0
solve sine ,terms=5, points = 11  x 11 : ends
# foot";
    let expected = "# head
param a = 1, b = 2 in [0, 3]  # first
param c = -3                  # second

domain v in [0, 2π]
pde d4S/du4 + 2 d4S/du2dv2 - a*d4S/dv4 = 0
    with q = 1,
    r = 2

at u = 0:
    # on top
    S_x = a e^-t*sin(v) + (b + c)^2
        + 1  # more
    S_y   = b; S_z = 0
    ∂S/∂u = [0, 0,
        1]
at u = 1: S = [c|v|, 0, 0],
    ∂S/∂u = 0
solve sine, terms = 5, points = 11 x 11:ends
# foot
";
    assert_eq!(kept(text), expected);
    assert_eq!(kept(expected), expected);
}

#[test]
fn blanks_between_factors_are_the_writers() {
    let text = format!(
        "param h0 = 1, b_1 = 2\n{}",
        with_data("2t + 2 t + h0(1 - t) + h0 (1 - t) + b_1 sinh(v)² sin 5v + √2 v")
    );
    assert_eq!(kept(&text), text);
}

#[test]
fn latex_is_kept_as_it_is() {
    let block = "$$\\begin{aligned}\n  u   = 0, \\\\\n S&=[ \\cos v,0 , 0],\\quad \\frac{dS}{du}=0 % as printed\n\\end{aligned}$$";
    let text = format!("param   a=1\n  {block}\nat u = 1: S=0, ∂S/∂u = 0\n");
    assert_eq!(kept(&text), format!("param a = 1\n  {block}\nat u = 1: S = 0, ∂S/∂u = 0\n"));
}

#[test]
fn names_and_operators_are_spelled_in_the_wanted_alphabet() {
    let ascii = "param beta_1 = 2*pi, k = 3 in [0, 4]
pde d4S/du4 + beta_1*d4S/du2dv2 + dS(u, v, t)/dt = 0
at u = 0: S = [beta_1^2 v^2, sin^2 v, e^-t], dS/du = 0
at u = 1: S = 0, dS/du = 0
solve sine, points = 11 x 11
";
    let unicode = "param β₁ = 2*π, k = 3 in [0, 4]
pde ∂⁴S/∂u⁴ + β₁*∂⁴S/∂u²∂v² + ∂S(u, v, t)/∂t = 0
at u = 0: S = [β₁² v², sin² v, e^-t], ∂S/∂u = 0
at u = 1: S = 0, ∂S/∂u = 0
solve sine, points = 11 x 11
";
    assert_eq!(laid_out(ascii, Alphabet::Unicode), unicode);
    assert_eq!(laid_out(unicode, Alphabet::Ascii), ascii.replace("beta_1", "beta1"));
    assert!(laid_out(&with_data("2πt − v·(1 − t)⁻²"), Alphabet::Ascii).contains("[2pi t - v*(1 - t)^-2, 0, 0]"));
}

/// `dh0(1 - t)/dr1` is a quotient of two params, unless `h0` is a surface of the document.
#[test]
fn derivatives_in_parameters_of_declared_surfaces_are_spelled_too() {
    let unicode = "surface hull(p, q₁) = [cos(q₁), p, 0]
param dh₀ = 1, dr₁ = 2
at u = 0: S = hull(1, v), ∂S/∂u = ∂hull(1, v)/∂p
at u = 1: S = ∂²hull(1, v)/∂p ∂q₁, ∂S/∂u = [dh₀(1 - t)/dr₁, 0, 0]
";
    let ascii = laid_out(unicode, Alphabet::Ascii);
    assert!(ascii.contains("dhull(1, v)/dp") && ascii.is_ascii(), "{ascii}");
    assert_eq!(laid_out(&ascii, Alphabet::Unicode), unicode);
}

#[test]
fn text_that_does_not_parse_is_not_laid_out() {
    let found = syntax::format(&Source::new("spec", "at u = 0: S_x = +"), Alphabet::Kept, &Limits::default());
    assert_eq!(found.expect_err("no expression")[0].code, Code::UnexpectedText);
}

/// Pieces that people put between, or forget between, what they write.
const PIECES: &[&str] = &[
    " ",
    "  ",
    "\n",
    "\n\n",
    " # a remark\n",
    "\t",
    "(v)",
    "v",
    " t",
    "2",
    "+",
    " - ",
    "*",
    "/",
    "^2",
    "²",
    ",",
    "=",
    "π",
    "|v|",
    "e^",
    "b_1",
    "[",
    "]",
    "{",
    "}",
];

/// What parses is laid out and then stays as it is; that it says the same is checked by `format` itself. In another
/// alphabet it may be refused: `t³^2` is a power of a power, and `t^3^2` is not.
fn is_laid_out_once(text: &str, alphabet: Alphabet) -> Result<(), TestCaseError> {
    let limits = Limits::default();
    let source = Source::new("spec", text);
    if syntax::parse(&source, &limits).is_err() {
        return Ok(());
    }
    match syntax::format(&source, alphabet, &limits) {
        Err(found) if alphabet == Alphabet::Kept || found[0].code != Code::NotFormatted => {
            Err(TestCaseError::fail(format!("{text}\n{}", told(text, &found))))
        }
        Err(_) => Ok(()),
        Ok(once) => {
            let twice = syntax::format(&Source::new("spec", &*once), alphabet, &limits);
            let twice =
                twice.map_err(|found| TestCaseError::fail(format!("{text}\n{once}\n{}", told(&once, &found))))?;
            prop_assert_eq!(twice, once, "{}", text);
            Ok(())
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn changed_examples_are_laid_out_and_then_stay(
        which in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(PIECES)), 1..6),
        alphabet in prop::sample::select(ALPHABETS.to_vec()),
    ) {
        let examples = all_examples();
        let mut text = examples[which.index(examples.len())].1.clone();
        for (place, piece) in changes {
            let mut at = place.index(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            text.insert_str(at, piece);
        }
        is_laid_out_once(&text, alphabet)?;
    }

    #[test]
    fn random_expressions_are_laid_out_and_then_stay(pieces in prop::collection::vec(prop::sample::select(PIECES), 1..12)) {
        let text = format!("param b_1 = 1\n{}{BOUNDARY}", with_data(&pieces.concat()));
        for alphabet in ALPHABETS {
            is_laid_out_once(&text, alphabet)?;
        }
    }
}
