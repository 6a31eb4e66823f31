//! LaTeX in specs: blocks of the papers as they are printed, what each construct means, and what is refused.

use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::expr::Notation;
use trimline::limits::Limits;

use crate::spec::{decomposition, decomposition_within, example, patch, problem, problem_within, told, with_data};

/// A block of equations from the papers, as printed.
macro_rules! printed {
    ($name:literal) => {
        include_str!(concat!("../cases/papers/", $name, ".tex"))
    };
}

fn basis(text: &str) -> String {
    decomposition(text).to_text(Notation::Unicode, &Limits::default()).expect("short")
}

fn refused(text: &str) -> Diagnostics {
    decomposition_within(text, &Limits::default()).expect_err(text)
}

/// The params, domain and equation of an example: everything before its constraints.
fn declarations(example_name: &str) -> String {
    let text = example(example_name);
    let end = text.find("\nat u").expect("constraints");
    text[..end].to_owned() + "\n"
}

#[test]
fn eq19_of_2012_pasted_is_the_example() {
    let pasted = format!("{}{}", declarations("eq19"), printed!("2012_eq19"));
    assert_eq!(basis(&pasted), basis(&example("eq19")));
}

#[test]
fn eq29_and_eq30_of_2012_pasted_are_the_example() {
    let pasted = format!("{}{}\n{}", declarations("eq29_30"), printed!("2012_eq29"), printed!("2012_eq30"));
    assert_eq!(basis(&pasted), basis(&example("eq29_30")));
}

const EQ31_PARAMS: &str = "param r = 1.2, r_0 = 0.6, r_1 = 0.08, r_3 = 0.9, k = 8, a = 1.1, b = 0.8, α = π/6
param h_0 = 3, h_1 = 1.5, h_3 = 0.4, h_31 = 2.2, h_32 = 1, h_33 = 0.3, h_4 = 1, h_41 = 0, h_42 = 0.8\n";

#[test]
fn eq31_and_eq32_of_2012_are_refused_with_both_readings() {
    for block in [printed!("2012_eq31"), printed!("2012_eq32")] {
        let text = format!("{EQ31_PARAMS}{block}");
        let found = refused(&text);
        let source = Source::new("spec", &*text);
        assert!(found.iter().all(|finding| finding.code == Code::AmbiguousExpression), "{}", told(&text, &found));
        let first = &found[0];
        assert!(source.slice(first.span.expect("a place")).contains(r"\sin \pi t/2"), "{}", told(&text, &found));
        assert!(first.hints[0].contains(r"\sin((\pi t)/2)"), "{}", told(&text, &found));
        assert!(first.hints[0].contains(r"\sin(\pi t)/2"), "{}", told(&text, &found));
    }
}

#[test]
fn eq31_and_eq32_of_2012_with_brackets_are_what_is_written_by_hand() {
    let bracketed = |block: &str| block.replace(r"\sin \pi t/2", r"\sin(\pi t/2)");
    let pasted = format!("{EQ31_PARAMS}{}{}", bracketed(printed!("2012_eq31")), bracketed(printed!("2012_eq32")));
    // The misprinted tangents in y are taken as they are.
    let by_hand = format!(
        "{EQ31_PARAMS}let s = sin(πt/2)
at u = 0:
    S_x = (1 - s)(r0 cos v + r1 cos(k v)) + 0.36 r s cos v
    S_y = (1 - s)(r0 sin v + r1 sin(k v)) + 0.36 r s sin v
    S_z = (1 - s) h0 + s (h31 + 0.6 h32 + h33 cos v)
    ∂S_x/∂u = 1.2 r s cos v
    ∂S_y/∂u = 1.2 r s cos v
    ∂S_z/∂u = -h1 (1 - s) + h32 s
at u = 1:
    S_x = 1.5 (1 - s) a cos v + 0.8 r3 s cos α cos v
    S_y = 1.5 (1 - s) b sin v + 0.8 r3 s sin v
    S_z = (1 - s)(h3 - 0.5 h4) + s (h41 + 0.8 h42 sin α cos v)
    ∂S_x/∂u = -(1 - s) a cos v + r3 s cos α cos v
    ∂S_y/∂u = -(1 - s) b sin v + r3 s cos v
    ∂S_z/∂u = -h4 (1 - s) + h42 s sin α cos v"
    );
    assert_eq!(basis(&pasted), basis(&by_hand));
}

const EQ13_PARAMS: &str = "param a = 4.763, b = 0.017, c = -3.395, d = 0.475, f = -0.475
param a' = 1, b' = 2, c' = 3, d' = 4, e' = 5, f' = 6, h_0 = 3, h_1 = 0.1, h'_0 = 1, h'_1 = 2, r = 1, r' = 2\n";

#[test]
fn eq13_of_2003_pasted_is_what_is_written_by_hand() {
    let pasted = printed!("2003_eq13").replace("d + ev", "d + e_0 v");
    let by_hand = "at u = 0:
    S = [a + b sin v + c e^(0.1v), d + e0 v + f cos v, h0 - h1 v]
    ∂S/∂u = [a' + b' sin v + c' e^(0.1v), d' + e' v + f' cos v, h0' - h1' v]
at u = 1:
    S = [r sin v, -r cos v, 0]
    ∂S/∂u = [r' sin v, -r' cos v, 0]";
    let text = |constraints: &str| basis(&format!("{EQ13_PARAMS}param e0 = 0.0159\n{constraints}"));
    // The order of the basis is the order of first use, which differs.
    let functions = |text: String| {
        let lines = text.lines().skip(1).take_while(|line| !line.is_empty());
        let mut found: Vec<String> = lines.map(|line| line.split_once('=').expect("a function").1.to_owned()).collect();
        found.sort();
        found
    };
    let componentwise = by_hand.to_owned();
    assert_eq!(functions(text(&pasted)), functions(text(&componentwise)));
}

#[test]
fn param_e_of_eq13_is_refused_as_eulers_number() {
    let found = refused(&format!("param e = 0.0159\n{EQ13_PARAMS}{}", printed!("2003_eq13")));
    assert_eq!(found[0].code, Code::DuplicateName);
    assert!(found[0].message.contains("Euler"), "{found:?}");
    assert!(found[0].hints[0].contains("another name"), "{found:?}");
}

#[test]
fn eq24a_of_2003_pasted_is_what_is_written_by_hand() {
    let rest = "\nat u = 1: S = 0, dS/du = 0";
    let params = "param a = 1, b = 0.2, c = 1, a' = 1, b' = 0.1, c' = 1, h_0 = 2, h_01 = 0.1, h_0' = 1, h_01' = 0.3\n";
    let by_hand = "at u = 0:
    x_1 = a cos v + b t sin 5v
    ∂x_1/∂u = a' cos v + b' t sin 5v
    x_2 = c sin v + b t cos 5v
    ∂x_2/∂u = c' sin v + b' t cos 5v
    x_3 = h0 + h01 t sin 5v
    ∂x_3/∂u = h0' + h01' t sin 5v";
    let pasted = format!("{params}{}{rest}", printed!("2003_eq24a"));
    assert_eq!(basis(&pasted), basis(&format!("{params}{by_hand}{rest}")));
}

#[test]
fn eq27_of_2003_pasted_is_what_is_written_by_hand() {
    let params = "param λ = 1, r_0 = 0.4, r_1 = 0.9, h_0 = 0, h_1 = 3, r_0' = 1, r_1' = 2, h_0' = 3, h_1' = 4
pde ∂⁴S/∂u⁴ + ∂⁴S/∂v⁴ + ∂S/∂t = 0\n";
    let by_hand = "at u = 0:
    x_1 = λ t + r_1 cos v
    ∂x_1/∂u = r_1' t³ cos v
    x_2 = λ t + r_1 sin v
    ∂x_2/∂u = r_1' t³ sin v
    x_3 = h_1
    ∂x_3/∂u = h_1' t²
at u = 1:
    x_1 = r_0 cos v
    ∂x_1/∂u = r_0' t² cos v
    x_2 = r_0 sin v
    ∂x_2/∂u = r_0' t² sin v
    x_3 = h_0
    ∂x_3/∂u = h_0' t³";
    assert_eq!(basis(&format!("{params}{}", printed!("2003_eq27"))), basis(&format!("{params}{by_hand}")));
}

const NAMES: &str =
    "param a = 1, b = 2, c = 3, k = 4, a_1 = 2, b_12 = 3, r_max = 5, speed = 2, alpha = 0.3, h_0' = 7\n";

/// LaTeX and plain notation are one expression.
fn same(latex: &str, plain: &str) {
    let text = format!("{NAMES}at u = 0: S = [$${latex}$$, {plain}, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0");
    let problem = problem(&text);
    let value = patch(&problem).conditions[0].value;
    let text = |id| problem.graph.text(id, Notation::Ascii, 1 << 16).expect("short");
    assert_eq!(value[0], value[1], "{latex} is {}, {plain} is {}", text(value[0]), text(value[1]));
}

#[test]
fn letters_are_names_of_their_own() {
    same(r"bt\sin 5v", "b*t*sin(5*v)");
    same("ce^{0.1v}", "c*exp(0.1*v)");
    same("a_1kv + a_{1}kv", "2*a1*k*v");
    same(r"b_{12}\alpha t", "b12*alpha*t");
    same(r"\mathrm{speed} t + r_{\mathrm{max}} r_{max}", "speed*t + r_max^2");
    same(r"r_{\max} v + r_{\text{max}} t", "r_max*v + r_max*t");
    same("h_0'v + h'_{0}t", "h0'*v + h0'*t");
    same(r"\pi t", "pi*t");
}

#[test]
fn fractions_roots_and_powers_have_their_groups() {
    same(r"\frac{a + b}{2c} v", "(a + b)/(2*c)*v");
    same(r"\dfrac{1}{1 + \frac{1}{v}}", "1/(1 + 1/v)");
    same(r"\sqrt{v^2 + 1}", "sqrt(v^2 + 1)");
    same(r"e^{-t}\, e^t v^{a b}", "exp(-t)*exp(t)*v^(a*b)");
    same(r"2 \cdot 10^{-3} v + 10^{2}", "2e-3*v + 1e2");
    same(r"v/2 \cdot 10^{3}", "(v/2)*1000");
    same(
        r"\sqrt{2}v + t\sin{v} + e^t(1 + v) + \frac{1}{2}\cos 2\pi v",
        "sqrt(2)*v + sin(v)*t + e^t*(1 + v) + cos(2*pi*v)/2",
    );
    same("v^2t", "v^2*t");
    same("v^{-1}", "1/v");
    same(r"{v}k{\alpha} + {\left(v + t\right)}k", "v*k*alpha + (v + t)*k");
    same(r"\sin^2 v + \cos^{2} v", "sin(v)^2 + cos(v)^2");
    same(r"v^{\frac{1}{3}}", "v^(1/3)");
}

#[test]
fn bare_argument_that_begins_with_a_group_is_that_group() {
    same(r"\sin\frac{v}{2}\cos\frac{v}{3}", "sin(v/2)*cos(v/3)");
    same(r"\sin\frac{v}{2} \operatorname{arsinh} v + t", "sin(v/2)*asinh(v) + t");
    same(r"\frac{\sin\frac{v}{2}}{3} t \cdot \sin 2\frac{a}{3} v", "sin(v/2)/3*t*sin(2*a/3*v)");
    same(r"\sin{5v} + \cos{v}", "sin(5*v) + cos(v)");
}

#[test]
fn root_in_a_bare_argument_is_that_of_the_plain_notation() {
    same(r"\sin\sqrt{2} v", "sin √2 v");
    same(r"\sin 2\sqrt{a} v", "sin 2√a v");
}

#[test]
fn letter_e_apart_from_digits_is_eulers_number() {
    same("2e - 3 + 2e^{3}v + 2ev", "2*exp(1) - 3 + 2*exp(3)*v + 2*exp(1)*v");
}

#[test]
fn vector_is_a_row_or_a_column() {
    for components in [r"\cos v & 0 & 0 \\", r"\cos v \\ 0 \\ 0 \\"] {
        let value = format!(r"$$\begin{{bmatrix}} {components} \end{{bmatrix}}$$");
        let text = format!("at u = 0: S = {value}, dS/du = 0\nat u = 1: S = 0, dS/du = 0");
        assert_eq!(basis(&text), basis(&with_data("cos v")), "{components}");
    }
}

#[test]
fn functions_brackets_and_operators_are_those_of_the_plain_notation() {
    same(r"\sin\left(kv\right)\cdot\cosh v", "sin(k*v)*cosh(v)");
    same(r"\arcsin\frac{v}{10} \times \ln (v + 1)", "asin(v/10)*ln(v + 1)");
    same(r"\log_{10}(v + 1) + \log(v + 1)", "log10(v + 1) + ln(v + 1)");
    same(r"\operatorname{arsinh} v + \operatorname{asinh}(v)", "2*asinh(v)");
    same(r"\bigl[ (v + 1)\{t\} \bigr]", "(v + 1)*t");
    same(r"\left| v - 1 \right|", "abs(v - 1)");
    same("a % a remark with $$ in it\n + b", "a + b");
    same(r"a\,b\;c\quad k", "a*b*c*k");
}

#[test]
fn equation_in_latex_is_the_equation_in_plain_notation() {
    let constraints = with_data("cos v");
    let latex = format!(
        r"pde $$ \beta \frac{{\partial^4 S}}{{\partial u^4}} + \gamma \frac{{\partial^{{4}} \mathbf{{S}}}}{{\partial u^2 \partial v^2}}
   + \lambda \dfrac{{d^4 S(u, v, t)}}{{dv^4}} \\ + \eta \partial S/\partial t = 0. $$ with β = 1, γ = 12.1, λ = 1, η = 2
{constraints}"
    );
    let plain = format!(
        "pde β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ ∂⁴S/∂v⁴ + η ∂S/∂t = 0 with β = 1, γ = 12.1, λ = 1, η = 2\n{constraints}"
    );
    assert_eq!(problem(&latex).patches[0].operator.terms, problem(&plain).patches[0].operator.terms);
    assert_eq!(basis(&latex), basis(&plain));
}

#[test]
fn equation_on_the_lines_after_pde_belongs_to_it() {
    let constraints = with_data("cos v");
    let latex = format!(
        "pde\n$$ \\frac{{\\partial^4 S}}{{\\partial u^4}}\n + \\frac{{\\partial^4 S}}{{\\partial v^4}} = 0 $$\n{constraints}"
    );
    assert_eq!(basis(&latex), basis(&format!("pde d4S/du4 + d4S/dv4 = 0\n{constraints}")));
}

#[test]
fn blocks_of_every_kind_are_lists_of_constraints() {
    let plain = basis(&with_data("cos v"));
    let rows = r"u &= 0, \\ S &= \begin{bmatrix} \cos v \\ 0 \\ 0 \end{bmatrix}, \quad \frac{\partial S}{\partial u} = 0 \\[2pt]
 & u = 1; \qquad S = 0, \quad \partial \mathbf{S}(u, v, t)/\partial u = 0";
    for block in [
        format!("$$ {rows} $$"),
        format!(r"\[ {rows} \]"),
        format!(r"\begin{{align*}} {rows} \tag{{3}} \end{{align*}}"),
        format!(r"\begin{{equation}} \begin{{aligned}} {rows}. \end{{aligned}} \label{{eq:3}} \end{{equation}}"),
        format!("$$\n\\begin{{aligned}}\n{rows}.\n\\end{{aligned}} \\tag{{3}}\n$$"),
    ] {
        assert_eq!(basis(&block), plain, "{block}");
    }
}

#[test]
fn wide_space_separates_equations_without_a_comma() {
    let block = r"$$ u = 0 \quad S_x = \cos v \quad S_y = 0 \qquad S_z = 0
\frac{\partial S}{\partial u} = 0 \\ u = 1 \\ S = 0 \\ \frac{\partial S}{\partial u} = 0 $$";
    assert_eq!(basis(block), basis(&with_data("cos v")));
}

#[test]
fn equation_number_behind_a_wide_space_is_no_factor() {
    let block = r"$$ u = 0, \\ S = \begin{bmatrix} \cos v \\ 0 \\ 0 \end{bmatrix} \quad (13) \\
\frac{\partial S}{\partial u} = 0, (14a) \\ u = 1: \quad S = 0 \qquad \frac{\partial S}{\partial u} = 0. (15) $$";
    assert_eq!(basis(block), basis(&with_data("cos v")));
    let found = refused("$$ u = 0, S_x = v (13) $$");
    assert_eq!(found[0].code, Code::AmbiguousExpression);
    assert!(found[0].hints[0].contains(r"\tag{13}"), "{found:?}");
}

#[test]
fn block_inside_a_line_stands_apart_from_what_is_beside_it() {
    for (mixed, plain) in [("a$$t$$b_12", "a*t*b12"), ("2$$v$$", "2*v"), ("$$a$$$$t$$", "a*t")] {
        let text = |value: &str| format!("{NAMES}{}", with_data(value));
        assert_eq!(basis(&text(mixed)), basis(&text(plain)), "{mixed}");
    }
}

#[test]
fn array_in_brackets_is_a_vector() {
    let block = r"$$ u = 0, \quad S = \left[\begin{array}{c} \cos v \\ 0 \\ 0 \end{array}\right], \quad \frac{dS}{du} = 0 \\
u = 1, \quad S = 0, \quad \frac{\mathrm{d} S}{\mathrm{d} u} = 0 $$";
    assert_eq!(basis(block), basis(&with_data("cos v")));
}

/// A spec, the code, the marked text and a part of message or hints.
const REFUSED: &[(&str, Code, &str, &str)] = &[
    (r"\bar{b} v", Code::UnsupportedLatex, r"\bar", "subscript"),
    (r"\sum_{k} v", Code::UnsupportedLatex, r"\sum", "write out each term"),
    (r"v \pm 1", Code::UnsupportedLatex, r"\pm", "one equation for each sign"),
    (r"\foo v", Code::UnsupportedLatex, r"\foo", "not read"),
    (r"\mathbf{b} v", Code::UnsupportedLatex, r"\mathbf{b}", "one name"),
    (r"v^12", Code::UnsupportedLatex, "^12", "braces"),
    (r"\log_2 v", Code::UnsupportedLatex, "_", r"\log_{10}"),
    (r"v^{\prime}", Code::UnsupportedLatex, r"\prime", "the prime itself"),
    (r"b_12 v", Code::UnsupportedLatex, "_12", "_{12}"),
    (r"\sqrt[3]{v}", Code::UnsupportedLatex, r"\sqrt", "index"),
    (r"\frac12 v", Code::UnsupportedLatex, r"\frac", "braces"),
    (r"\begin{cases} v \end{cases}", Code::UnsupportedLatex, r"\begin{cases}", "bmatrix"),
    (r"a # b", Code::UnsupportedLatex, "#", "%"),
    (r"a^2_1", Code::UnsupportedLatex, "_", "right after the letter"),
    (r"\mathrm{let} v", Code::UnsupportedLatex, r"\mathrm{let}", "another name"),
    (r"2\frac{1}{2} v", Code::AmbiguousExpression, r"2\frac{1}{2}", r"2 \cdot \frac{1}{2}"),
    (r"\sin \pi t/2", Code::AmbiguousExpression, r"\sin \pi t/2", r"\sin((\pi t)/2)"),
    (r"a/2b", Code::AmbiguousExpression, "a/2b", "(a/2)*b"),
    (r"\cos v t", Code::AmbiguousExpression, r"\cos v t", "cos(v)"),
    (r"\sin^{-1} v", Code::AmbiguousExpression, r"\sin^{-1} v", "inverse"),
    (r"{(v}) t", Code::UnbalancedBracket, "}", "`(` is closed by `}`"),
    (r"\left(v\right]", Code::UnbalancedBracket, "]", "`(` is closed by `]`"),
    (r"\frac{v}{2", Code::UnbalancedBracket, "{", "never closed"),
    (r"q v", Code::UnknownName, "q", "unknown name `q`"),
    (r"\mathrm{swift} v", Code::UnknownName, r"\mathrm{swift}", "swift"),
    (r"\frac{\partial S}{\partial u}", Code::NotBoundaryData, r"\frac{\partial S}{\partial u}", "to be found"),
    (r"\frac{\partial^2 S}{\partial u}", Code::UnexpectedText, r"\frac{\partial^2 S}{\partial u}", "order 2 above"),
    (r"\sin\frac{1}{2}v", Code::AmbiguousExpression, r"\sin\frac{1}{2}v", r"`\sin(\frac{1}{2}) v`"),
    (r"\sin\frac{1}{2}v", Code::AmbiguousExpression, r"\sin\frac{1}{2}v", r"`\sin(\frac{1}{2} v)`"),
    (r"\exp\,\frac{1}{2}\pi", Code::AmbiguousExpression, r"\exp\,\frac{1}{2}\pi", "belong to the argument"),
    (r"\sin^2\frac{\pi}{2} v", Code::AmbiguousExpression, r"\sin^2\frac{\pi}{2} v", "belong to the argument"),
    (r"\sin\frac{1}{2}\left(v\right)", Code::AmbiguousExpression, r"\sin\frac{1}{2}\left", "belong to the argument"),
    (r"\operatorname{arsinh}{2}v", Code::AmbiguousExpression, r"\operatorname{arsinh}{2}v", "(2 v)"),
    (r"\sin 2 \cdot 10^{3} v", Code::AmbiguousExpression, r"\sin 2 \cdot 10^{3} v", "belong to the argument"),
    (r"\sin{v}/2", Code::AmbiguousExpression, r"\sin{v}/", "belong to the argument"),
    (r"\sin{v + 1}", Code::AmbiguousExpression, "{v + 1}", "`(v + 1)`"),
    (r"2e3", Code::AmbiguousExpression, "2e3", r"`2 \cdot 10^{3}`"),
    (r"1e-3 v", Code::AmbiguousExpression, "1e-3", "`1 e -3`"),
    (r"1.5E+3", Code::AmbiguousExpression, "1.5E+3", r"`1.5 \cdot 10^{3}`"),
    (r"2{v+1}", Code::AmbiguousExpression, "{v+1}", "TeX does not show"),
    (r"v{-1}", Code::AmbiguousExpression, "{-1}", "`(-1)`"),
    (r"{-v}^2", Code::AmbiguousExpression, "{-v}", "`(-v)`"),
    (r"v^{}", Code::UnexpectedText, "{}", "an exponent is missing"),
    (r"v^", Code::UnexpectedText, "^", "an exponent is missing"),
    (r"\frac{}{v}", Code::UnexpectedText, "{}", "a numerator is missing"),
    (r"\frac{v}{}", Code::UnexpectedText, "{}", "a denominator is missing"),
    (r"\sqrt{}", Code::UnexpectedText, "{}", "is missing"),
    (r"v^2^2", Code::AmbiguousExpression, "^2^", "two exponents"),
    (r"v^{a + 1}^2", Code::AmbiguousExpression, "{a + 1}^", "two exponents"),
    (r"\begin{bmatrix}1&2\\3\end{bmatrix}", Code::UnsupportedLatex, r"\\", "several rows and columns"),
    (r"v + * t", Code::UnexpectedText, "*", "expected"),
];

#[test]
fn what_is_not_read_is_refused_at_its_place() {
    for &(latex, code, marked, words) in REFUSED {
        let text = format!("{NAMES}{}", with_data(&format!("$${latex}$$")));
        let found = refused(&text);
        let source = Source::new("spec", &*text);
        let place = found[0].span.map_or("", |span| source.slice(span));
        assert_eq!((found[0].code, place), (code, marked), "{latex}: {}", told(&text, &found));
        let said = format!("{} {} {:?}", found[0].message, found[0].marker, found[0].hints);
        assert!(said.replace("\\\\", "\\").contains(words), "{latex}: {}", told(&text, &found));
    }
}

#[test]
fn position_and_equation_without_a_separator_are_refused() {
    let found = refused("$$u = 0 x_1 = v$$\n");
    assert_eq!(found[0].code, Code::UnexpectedText);
    assert!(found[0].hints[0].contains("line break"), "{found:?}");
}

#[test]
fn block_that_never_ends_is_refused_where_it_begins() {
    for (text, marked) in [("param a = 1\n$$ u = 0", "$$"), ("\\[ u = 0", "\\["), ("\\begin{align} u = 0", "\\b")] {
        let found = refused(text);
        assert_eq!(found[0].code, Code::UnbalancedBracket);
        assert_eq!(Source::new("spec", text).slice(found[0].span.expect("a place")), marked);
    }
}

#[test]
fn deep_groups_are_a_limit_and_not_a_stack() {
    for (open, close) in [("{", "}"), (r"\frac{1}{", "}"), (r"\left(", r"\right)"), (r"\sqrt{", "}"), ("v^{a ", "}")] {
        let text = format!("{NAMES}{}", with_data(&format!("$${}v{}$$", open.repeat(20_000), close.repeat(20_000))));
        let found = problem_within(&text, &Limits::default()).expect_err("too deep");
        assert_eq!(found[0].code, Code::LimitReached, "{open}: {}", told(&text, &found));
    }
}

#[test]
fn every_prefix_of_a_printed_block_is_answered() {
    for block in [printed!("2012_eq19"), printed!("2012_eq32"), printed!("2003_eq13"), printed!("2012_eq2")] {
        for end in (0..=block.len()).filter(|end| block.is_char_boundary(*end)) {
            if let Err(found) = decomposition_within(&block[..end], &Limits::default()) {
                for finding in found {
                    assert!(!finding.message.contains("please report"), "{finding}");
                    assert!(
                        finding.span.is_none_or(|span| span.start <= span.end && span.end <= end.max(1)),
                        "{finding:?}"
                    );
                }
            }
        }
    }
}

const ENDS: &str = "\nat u = 0: S = [cos v, sin v, 0], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0";

#[test]
fn unknown_with_its_coordinates_and_a_bold_zero_are_read_in_every_environment() {
    let operator = r"\left(\frac{\partial^2}{\partial u^2} + \frac{\partial^2}{\partial v^2}\right)^2 \mathbf{S}(u,v) = \mathbf{0}";
    let expected = basis(&format!("pde (∂²/∂u² + ∂²/∂v²)² S = 0{ENDS}"));
    let environments = ["equation", "equation*", "gather", "gather*", "align", "align*", "multline", "multline*"];
    for name in environments.into_iter().chain(["flalign", "flalign*", "eqnarray", "eqnarray*"]) {
        let pasted = format!("pde\n\\begin{{{name}}}\n{operator}\n\\end{{{name}}}{ENDS}");
        assert_eq!(basis(&pasted), expected, "{name}");
    }
}
