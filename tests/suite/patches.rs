//! Documents of several patches: what they share, what is their own, and what they are refused for.

use trimline::diagnostic::{Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::problem::{Bindings, Problem};
use trimline::resolve::{resolve, set_parameter};
use trimline::syntax;

use crate::spec::{BOUNDARY, problem, problem_within, told};

/// Four complete constraints on one line.
const INSIDE: &str = "at u = 0: S = [cos v, sin v, 0], dS/du = 0; at u = 1: S = [cos v, sin v, 1], dS/du = 0";

fn found(text: &str) -> Diagnostics {
    problem_within(text, &Limits::default()).expect_err(text)
}

/// Code, marked text and words of every finding.
fn findings(text: &str) -> Vec<String> {
    let source = Source::new("spec", text);
    let line = |finding: &trimline::diagnostic::Diagnostic| {
        let marked = finding.span.map_or("", |span| source.slice(span));
        format!("{} `{marked}` {}", finding.code, finding.message)
    };
    found(text).iter().map(line).collect()
}

/// The value of the coefficient of `derivative` in patch number `index`.
fn coefficient(problem: &Problem, index: usize, derivative: Derivative) -> f64 {
    let bindings = Bindings::evaluate(problem).expect("finite");
    let terms = &problem.patches[index].operator.terms;
    let term = terms.iter().find(|term| term.derivative == derivative).expect("a term");
    problem.graph.value(term.coefficient[0], bindings.as_slice(), [f64::NAN; 3])
}

#[test]
fn document_without_blocks_is_one_patch_with_the_given_name() {
    let names: Vec<String> = problem(BOUNDARY).patches.iter().map(|patch| patch.name.clone()).collect();
    assert_eq!(names, ["spec"]);
}

#[test]
fn blocks_are_patches_in_source_order_however_they_are_laid_out() {
    let layouts = [
        format!("patch a {{ {INSIDE} }}\npatch b {{ {INSIDE} }}"),
        format!("patch a {{ {INSIDE} }} patch b {{ {INSIDE} }}"),
        format!("patch a\n{{\n{BOUNDARY}}}\n# between\npatch b {{ # b\n{BOUNDARY}\n}}\n"),
        format!("patch a {{{BOUNDARY}}}; patch b {{\n\n{INSIDE};}}"),
    ];
    for text in layouts {
        let problem = problem(&text);
        let names: Vec<&str> = problem.patches.iter().map(|patch| patch.name.as_str()).collect();
        assert_eq!(names, ["a", "b"], "{text}");
        assert!(problem.patches.iter().all(|patch| patch.conditions.len() == 4), "{text}");
    }
}

#[test]
fn braces_of_subscripts_are_no_blocks() {
    let problem = problem(&format!("param b_{{1}} = 1\npatch p_{{2}} {{ let c_{{3}} = b_{{1}}; {INSIDE} }}"));
    assert_eq!(problem.patches[0].name, "p2");
}

#[test]
fn semicolon_ends_a_statement_as_a_line_does() {
    let lines = format!("param a = 1\nlet c = a\n{BOUNDARY}");
    let one_line = lines.trim_end().replace('\n', "; ");
    let texts = [&lines, &one_line].map(|text| {
        let problem = problem(text);
        let values: Vec<_> = problem.patches[0].conditions.iter().flat_map(|condition| condition.value).collect();
        format!("{values:?}")
    });
    assert_eq!(texts[0], texts[1]);
}

#[test]
fn patch_overrides_domain_method_and_definitions_for_itself_alone() {
    let text = format!(
        "let r = 1\ndomain v in [0, 1], t in [0, 2]\nsolve sine, terms = 5\n\
         patch a {{ let r = 3; domain v in [0, r]; solve exact; {INSIDE} }}\n\
         patch b {{ domain u in [0, r]; {INSIDE} }}"
    );
    let problem = problem(&text);
    let bindings = Bindings::evaluate(&problem).expect("finite");
    let [a, b] = [0, 1].map(|index| {
        let patch = &problem.patches[index];
        (patch.domain.evaluate(&problem, &bindings).expect("a domain"), patch.solve.method.clone())
    });
    assert_eq!((a.0.v, a.0.t, a.1.as_deref()), ([0.0, 3.0], [0.0, 2.0], Some("exact")));
    assert_eq!((b.0.v, b.0.u, b.1.as_deref()), ([0.0, 1.0], [0.0, 1.0], Some("sine")));
}

#[test]
fn patches_without_an_equation_share_one_and_its_coefficients() {
    let mut problem = problem(&format!("pde with γ = 3\npatch a {{ {INSIDE} }}\npatch b {{ {INSIDE} }}"));
    let names: Vec<&str> = problem.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(names.iter().filter(|name| name.contains("gamma")).count(), 1, "{names:?}");
    set_parameter(&mut problem, "γ", &Source::new("--set", "7"), &Limits::default()).expect("a coefficient");
    let mixed = Derivative::new(2, 2, 0);
    assert_eq!([0, 1].map(|index| coefficient(&problem, index, mixed)), [7.0, 7.0]);
}

#[test]
fn patch_with_its_own_coefficients_keeps_the_rest_of_the_shared_equation() {
    let mut problem = problem(&format!(
        "pde k d4S/du4 + m d4S/dv4 = 0 with k = 2, m = 3\npatch a {{ pde with m = 5; {INSIDE} }}\npatch b {{ {INSIDE} }}"
    ));
    let (u, v) = (Derivative::new(4, 0, 0), Derivative::new(0, 4, 0));
    assert_eq!([coefficient(&problem, 0, u), coefficient(&problem, 0, v)], [2.0, 5.0]);
    assert_eq!([coefficient(&problem, 1, u), coefficient(&problem, 1, v)], [2.0, 3.0]);
    set_parameter(&mut problem, "a.m", &Source::new("--set", "9"), &Limits::default()).expect("a coefficient");
    assert_eq!([0, 1].map(|index| coefficient(&problem, index, v)), [9.0, 3.0]);
}

#[test]
fn equation_of_a_patch_decides_the_number_of_its_constraints() {
    let text = format!(
        "patch flat {{ pde d2S/du2 + d2S/dv2 = 0; at u = 0: S = 0; at u = 1: S = [v, 0, 1] }}\npatch b {{ {INSIDE} }}"
    );
    let counts: Vec<usize> = problem(&text).patches.iter().map(|patch| patch.conditions.len()).collect();
    assert_eq!(counts, [2, 4]);
}

#[test]
fn blocks_that_do_not_fit_together_are_refused_where_they_stand() {
    let cases: [(String, &str); 8] = [
        (format!("at u = 0: S = 0\npatch a {{ {INSIDE} }}"), "E0102 `u = 0` a boundary stands outside the patches"),
        (format!("patch a {{ {INSIDE} }}\npatch a {{ {INSIDE} }}"), "E0202 `a` two patches are called `a`"),
        (format!("patch a {{ patch b {{ {INSIDE} }}"), "E0102 `patch b {` a block stands inside another block"),
        (format!("patch a {{ param q = 1; {INSIDE} }}"), "E0102 `q` a param belongs to all patches"),
        (format!("param r = 1\npatch a {{ let r = 2; {INSIDE} }}"), "E0202 `r` `r` is declared twice"),
        (format!("patch a {{ {INSIDE}"), "E0103 `{` `{` is never closed"),
        ("patch a { }".to_owned(), "E0206 `a` an equation of order 4 in u needs 4"),
        (format!("patch a\n{BOUNDARY}"), "E0102 `` expected `{`, found the end"),
    ];
    for (text, expected) in cases {
        let found = findings(&text);
        assert!(matches!(found.as_slice(), [only] if only.starts_with(expected)), "{text}\n{found:?}");
    }
}

#[test]
fn patches_above_their_limit_are_refused() {
    let limits = Limits { patches: 1, ..Limits::default() };
    let text = format!("patch a {{ {INSIDE} }}\npatch b {{ {INSIDE} }}");
    let found = problem_within(&text, &limits).expect_err("two patches");
    assert!(matches!(found.as_slice(), [only] if only.message.contains("`patches` of 1")), "{}", told(&text, &found));
}

#[test]
fn faults_of_several_stages_are_reported_together_and_their_consequences_are_not() {
    let text = format!(
        "param a = q1\nlet c = 2 a, d = q2\npde with γ = q3\ndomain v in [0, a]\n\
         patch p {{ at u = 0: S = [c, d, q4], dS/du = 0; at u = a: S = 0, dS/du = 0 }}\npatch b {{ {INSIDE} }}"
    );
    let names: Vec<String> = findings(&text).iter().map(|line| line.split('`').nth(1).unwrap().to_owned()).collect();
    // `[c, d, q4]` uses a faulty definition: whether q4 is meant is asked once that is mended.
    assert_eq!(names, ["q1", "q2", "q3"]);
}

#[test]
fn two_hundred_patches_are_read_in_their_order() {
    let text: String = (0..200)
        .map(|i| format!("patch p{i} {{ let c = {i}; at u = 0: S = c, dS/du = 0; at u = 1: S = 0, dS/du = 0 }}\n"))
        .map(|text| text.replace("S = c", "S = [c, 0, 0]"))
        .collect();
    let source = Source::new("spec", &*text);
    let document = syntax::parse(&source, &Limits::default()).expect("a document");
    let problem = resolve(&document, "spec", &Limits::default()).expect("a problem");
    let x = problem.patches.iter().map(|patch| problem.graph.value(patch.conditions[0].value[0], &[], [0.0; 3]));
    assert!(x.eq((0..200).map(f64::from)));
}
