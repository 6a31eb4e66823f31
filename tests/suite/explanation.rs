//! What was understood, printed and read again; LaTeX for documents.

use trimline::decompose::decompose;
use trimline::expr::Notation;
use trimline::limits::Limits;
use trimline::problem::{Explanation, Problem};

use crate::spec::{decomposition, examples, patch, problem, with_data};

fn explained(problem: &Problem, notation: Notation) -> Explanation {
    problem.explain(patch(problem), notation, &Limits::default()).expect("short")
}

/// The basis and its coefficients as text, without the name of the patch.
fn basis(text: &str) -> String {
    let basis = decomposition(text).to_text(Notation::Unicode, &Limits::default()).expect("short");
    let (_, rest) = basis.split_once("`:").expect("a heading");
    // Derivatives follow from the basis; the order of their terms is that in which the text first has their parts.
    rest.split("\nderivatives the equation").next().unwrap_or(rest).to_owned()
}

/// The terms of the equation as text.
fn equation(problem: &Problem) -> Vec<String> {
    let text = |id| problem.graph.text(id, Notation::Ascii, 1 << 16).expect("short");
    let operator = &patch(problem).operator;
    let terms = operator.terms.iter().map(|term| format!("{} {:?}", term.derivative, term.coefficient.map(text)));
    terms.chain([format!("{:?}", operator.force.map(text))]).collect()
}

/// Further specs with what the examples lack: odd and mixed orders, vectors, quotients, forces, names of all kinds.
const SPECS: &[&str] = &[
    "param a = 2, k_1 = a/3 in [0, a], r_max = 1e-9, speed = 1e30
pde [1, 2, a] ∂⁴S/∂u⁴ + a/2·∂³S/∂u∂v∂t - 3 S + (1 + v) ∂²S/∂u² - ∂S/∂t = [0, 0, t]
domain u in [-1, 1/3], v in [0, k_1 π]
at u = -1: S = [speed cos v, r_max, 0], ∂S/∂u = 0
at u = 1/3: S = [v³, 2^(a v), 1 + t], ∂S/∂u = [e^-t, √(1 + v²), 1/(1 + v)]",
    "param h' = 1, λ_0 = 2
pde d6S/du6 - λ_0 d2S/dv2 = 0 with q = 3, r = q/7\n",
];

fn specs() -> Vec<String> {
    let rest = "at u = 0: S = [h' cos v, 0, 0], dS/du = 0, d2S/du2 = 0\nat u = 1: S = [0, 0, q], dS/du = 0, d2S/du2 = [v, r, 0]";
    let sixth =
        SPECS[1].replace("= 0 with q", "+ q S/r = 0 with q") + &rest.replace(", q]", ", 0]").replace(", r,", ", 1,");
    // A moving frame around an imported surface comes back with its factors in another order: that of first appearance.
    let examples = examples().into_iter().filter(|(name, _)| name != "import_step");
    examples.map(|(_, text)| text).chain([SPECS[0].to_owned(), sixth, NAMES.to_owned()]).collect()
}

#[test]
fn explanation_in_unicode_is_a_spec_of_the_same_problem() {
    for text in specs() {
        let first = problem(&text);
        let again = explained(&first, Notation::Unicode).to_text();
        assert_eq!(basis(&again), basis(&text), "{again}");
        let second = problem(&again);
        assert_eq!(equation(&first), equation(&second), "{again}");
    }
}

/// Names that begin like a function or a word of the language, or end in something else than letters and digits.
const NAMES: &str =
    "param sin_x = 2, exp_a = 3, in_x = 5, log_2 = 7, S_a = 11, d_u = 13, e_1 = 17, pi_a = 19, sin' = 23, sin1 = 29, \
     x_a = 31, r_max' = 37, h1_x = 41, a_b_c' = 43
at u = 0: S = [sin_x v + exp_a, in_x v + log_2, S_a v + d_u h1_x], ∂S/∂u = [e_1 v + pi_a, sin' v + sin1, x_a v + r_max' a_b_c']
at u = 1: S = [cos v, sin v, 0], ∂S/∂u = 0
";

/// Equations of three patches: the one outside, its coefficients changed, and another one.
const PATCHES: &str = "param a = 2
pde ∂⁴S/∂u⁴ + k ∂⁴S/∂v⁴ = 0 with k = a, m = k²
patch one { BOUNDARY }
patch two { pde with k = 3
BOUNDARY }
patch three { pde ∂⁴S/∂u⁴ + (k + m) ∂²S/∂v² + m S = 0 with k = 5 + a, m = k²
BOUNDARY }
";

#[test]
fn explanation_of_each_patch_states_its_own_coefficients_under_their_plain_names() {
    let text = PATCHES.replace("BOUNDARY", crate::spec::BOUNDARY).replace(", m = k²\npatch one", "\npatch one");
    let whole = problem(&text);
    let coefficients = ["with k = a\n", "with k = 3\n", "with k = 5 + a, m = k²\n"];
    assert_eq!(whole.patches.len(), coefficients.len());
    for (patch, expected) in whole.patches.iter().zip(coefficients) {
        let limits = Limits::default();
        let unicode = whole.explain(patch, Notation::Unicode, &limits).expect("short");
        assert!(format!("{}\n", unicode.equation).ends_with(expected), "{}", unicode.equation);
        let again = problem(&unicode.to_text());
        let renamed = |text: &str| text.replace(&format!("{}.", patch.name), "");
        let here = Problem { patches: vec![patch.clone()], ..whole.clone() };
        let stated: Vec<String> = equation(&here).iter().map(|term| renamed(term)).collect();
        assert_eq!(equation(&again), stated);
        let latex = whole.explain(patch, Notation::Latex, &limits).expect("short");
        assert!(!latex.equation.contains(&patch.name), "{}", latex.equation);
        let row = latex.equation.lines().nth(1).expect("a row").trim_end_matches([',', ' ', '\\']);
        let with = unicode.equation.split_once("with").map_or("", |(_, with)| with);
        let pasted = format!("{}\npde $${row}$$ with {with}\n{}", unicode.parameters, crate::spec::BOUNDARY);
        assert_eq!(equation(&problem(&pasted)), stated, "{pasted}");
    }
}

#[test]
fn explanation_in_latex_is_read_as_the_same_constraints_and_equation() {
    for text in specs() {
        let first = problem(&text);
        let (unicode, latex) = (explained(&first, Notation::Unicode), explained(&first, Notation::Latex));
        let declared = format!("{}\n{}", unicode.parameters, unicode.data);
        let pasted = format!("{}\n{}\n{}\n{}\n", declared, unicode.equation, unicode.domain, latex.constraints);
        assert_eq!(basis(&pasted), basis(&text), "{pasted}");
        let row = latex.equation.lines().nth(1).expect("a row").trim_end_matches([',', ' ', '\\']);
        let with = unicode.equation.split_once("with").map_or(String::new(), |(_, with)| format!(" with {with}"));
        let pasted = format!("{}\npde $${row}$${with}\n{}\n{}\n", declared, unicode.domain, unicode.constraints);
        assert_eq!(equation(&problem(&pasted)), equation(&first), "{pasted}");
    }
}

#[test]
fn explanation_of_eq19_is_what_the_paper_prints() {
    let problem = problem(&crate::spec::example("eq19"));
    let unicode = explained(&problem, Notation::Unicode);
    assert_eq!(
        unicode.equation,
        "pde β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ ∂⁴S/∂v⁴ + ρ ∂²S/∂t² + η ∂S/∂t = 0
    with β = 1, γ = 12.1, λ = 1, ρ = 1, η = 1"
    );
    assert_eq!(unicode.domain, "domain u in [0, 1], v in [0, 2 π], t in [0, 0.3]");
    let latex = explained(&problem, Notation::Latex);
    assert!(
        latex.equation.contains(r"\gamma\, \frac{\partial^{4} \mathbf{S}}{\partial u^{2}\, \partial v^{2}}"),
        "{latex:?}"
    );
    assert!(
        latex.constraints.contains(r"\mathbf{S} &= \begin{bmatrix} a\, e^{t}\, \sin\left(v\right) \\"),
        "{latex:?}"
    );
}

#[test]
fn decomposition_in_latex_states_every_function_coefficient_and_derivative() {
    let problem = problem(&with_data("2 t cos v"));
    let limits = Limits::default();
    let latex = decompose(&problem, patch(&problem), &limits).expect("a basis").to_latex(&limits).expect("short");
    let expected = r"\begin{aligned}
F_{1}(v, t) &= t\, \cos\left(v\right) \\
\left.\mathbf{S}\right|_{u = 0} &= \mathbf{b}_{1}\, F_{1} \\
\mathbf{b}_{1} &= \begin{bmatrix} 2 \\ 0 \\ 0 \end{bmatrix} \\
\left.\frac{\partial \mathbf{S}}{\partial u}\right|_{u = 0} &= \mathbf{0} \\
\left.\mathbf{S}\right|_{u = 1} &= \mathbf{0} \\
\left.\frac{\partial \mathbf{S}}{\partial u}\right|_{u = 1} &= \mathbf{0} \\
\frac{\partial^{2} F_{1}}{\partial v^{2}} &= -t\, \cos\left(v\right) \\
\frac{\partial^{4} F_{1}}{\partial v^{4}} &= t\, \cos\left(v\right) \\
\frac{\partial F_{1}}{\partial t} &= \cos\left(v\right)
\end{aligned}
";
    assert_eq!(latex, expected);
}
