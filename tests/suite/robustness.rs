//! Whatever the text, the front end answers with a value or with findings, soon, on a small stack.

use std::time::{Duration, Instant};

use proptest::prelude::*;
use trimline::decompose::decompose;
use trimline::diagnostic::{Class, Code, Diagnostics};
use trimline::eval::Backend;
use trimline::limits::Limits;
use trimline::net::NetSolver;
use trimline::problem::Bindings;

use crate::spec::{BOUNDARY, all_examples, problem_within, with_data};

/// The stack of a thread on common systems is at least this large.
const STACK: usize = 1 << 20;

/// Ten times what the slowest case takes on a slow machine in a debug build: a hang, not a measurement.
const SOON: Duration = Duration::from_secs(30);

/// The number of basis functions of the first patch; the number of nets of a document without patches.
fn understood(text: &str, limits: &Limits) -> Result<usize, Diagnostics> {
    let one = |finding| vec![finding];
    let problem = problem_within(text, limits)?;
    if let Some(patch) = problem.patches.first() {
        return decompose(&problem, patch, limits).map(|decomposition| decomposition.basis.len()).map_err(one);
    }
    let bindings = Bindings::evaluate(&problem).map_err(one)?;
    for net in &problem.nets {
        let solver = NetSolver::new(&problem, net, &bindings, Backend::Interpreter, limits).map_err(one)?;
        solver.solve(&bindings, 0.0).map_err(one)?;
    }
    Ok(problem.nets.len())
}

/// Decodes, parses, resolves and decomposes; every finding must be one that a text can be blamed for.
fn run(bytes: &[u8], limits: &Limits) -> Result<usize, Diagnostics> {
    let found = match std::str::from_utf8(bytes) {
        Ok(text) => understood(text, limits),
        Err(_) => {
            let found = trimline::syntax::decode("spec", bytes, limits).expect_err("not UTF-8, or too long");
            Err(vec![found])
        }
    };
    if let Err(found) = &found {
        assert!(!found.is_empty());
        for finding in found {
            assert!(matches!(finding.class(), Class::Source | Class::Limit), "{finding}");
            if let Some(span) = finding.span {
                assert!(span.start <= span.end && span.end <= bytes.len().max(1), "{finding}");
                let is_boundary = std::str::from_utf8(bytes)
                    .is_ok_and(|text| text.is_char_boundary(span.start) && text.is_char_boundary(span.end));
                assert!(is_boundary || finding.code == Code::NotUtf8, "{finding}");
            }
            assert!(!finding.message.contains("please report"), "{finding}");
        }
    }
    found
}

/// Small enough that random texts reach every one of them.
fn tiny() -> Limits {
    Limits {
        source_bytes: 2000,
        nesting: 4,
        names: 20,
        graph_nodes: 150,
        text_bytes: 100,
        monomials: 6,
        basis_functions: 4,
        derivative_order: 4,
        ..Limits::default()
    }
}

/// Runs `text` on a small stack and says what became of it and how long it took.
fn on_a_small_stack(text: String) -> Result<usize, Diagnostics> {
    let start = Instant::now();
    let thread = std::thread::Builder::new().stack_size(STACK);
    let handle = thread.spawn(move || run(text.as_bytes(), &Limits::default())).expect("a thread");
    let found = handle.join().expect("no panic");
    let took = start.elapsed();
    assert!(took < SOON, "{took:?}");
    found
}

fn is_limit(found: &Result<usize, Diagnostics>, name: &str) -> bool {
    found.as_ref().is_err_and(|found| {
        found.iter().any(|finding| finding.code == Code::LimitReached && finding.message.contains(name))
    })
}

#[test]
fn every_prefix_of_every_example_is_answered() {
    for (_, text) in all_examples() {
        for end in 0..=text.len() {
            let _ = run(&text.as_bytes()[..end], &tiny());
        }
        // Every seventh with the usual limits, which let more of the stages run.
        for end in (0..=text.len()).step_by(7) {
            let _ = run(&text.as_bytes()[..end], &Limits::default());
        }
        run(text.as_bytes(), &Limits::default()).expect("an example");
    }
}

/// A change of a text.
#[derive(Debug, Clone)]
enum Mutation {
    Flip(usize, u8),
    Delete(usize, usize),
    Duplicate(usize, usize, usize),
    Insert(usize, &'static str),
}

const TOKENS: &[&str] = &[
    "param ",
    "let ",
    "domain ",
    "pde ",
    "with ",
    "at u = 0:",
    "solve ",
    "in ",
    "S",
    "S_x",
    "dS/du",
    "∂⁴S/∂u²∂v²",
    "d4S/du4",
    "= ",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":",
    "+",
    "-",
    "*",
    "/",
    "^",
    "**",
    "²",
    "⁻¹",
    "√",
    "·",
    "−",
    "π",
    "e",
    "u",
    "v",
    "t",
    "x",
    "x_1",
    "a",
    "b_1",
    "β",
    "γ",
    "sin",
    "cos ",
    "sinh(",
    "exp",
    "abs",
    "atan2(",
    "min(v, t)",
    "0",
    "1",
    "0.5",
    "1e3",
    "1e308",
    ".",
    "'",
    "_",
    "#",
    "\n",
    "\n  ",
    "\r\n",
    " ",
    "surface ",
    "patch ",
    "patch p {",
    "seam p at u = 1 with q at u = 0\n",
    "join A at u = 0",
    ", strength = ",
    ", flip",
    "∂A(0, v)/∂u",
    "∂²/∂u²",
    "sine",
    "terms = ",
    "points = 3 x 3",
    "\u{200b}",
    "а",
    "|",
    "½",
    "∈",
    "^{",
    "$$",
    "\\[",
    "\\]",
    "\\frac{",
    "}{",
    "\\partial ",
    "\\\\",
    "&",
    "\\begin{aligned}",
    "\\end{aligned}",
    "\\begin{bmatrix}",
    "\\end{bmatrix}",
    "\\quad ",
    "\\left(",
    "\\right)",
    "\\mathrm{",
    "\\sqrt{",
    "%",
    "1/0",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    prop_oneof![
        (any::<usize>(), any::<u8>()).prop_map(|(at, byte)| Mutation::Flip(at, byte)),
        (any::<usize>(), 1..20_usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        (any::<usize>(), 1..40_usize, any::<usize>()).prop_map(|(at, length, to)| Mutation::Duplicate(at, length, to)),
        (any::<usize>(), prop::sample::select(TOKENS)).prop_map(|(at, token)| Mutation::Insert(at, token)),
    ]
}

fn mutated(text: &str, mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for mutation in mutations {
        let place = |at: usize, bytes: &[u8]| at % (bytes.len() + 1);
        match *mutation {
            Mutation::Flip(at, mask) => {
                let at = place(at, &bytes);
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= mask;
                }
            }
            Mutation::Delete(at, length) => {
                let at = place(at, &bytes);
                let end = (at + length).min(bytes.len());
                bytes.drain(at..end);
            }
            Mutation::Duplicate(at, length, to) => {
                let at = place(at, &bytes);
                let part = bytes[at..(at + length).min(bytes.len())].to_vec();
                let to = place(to, &bytes);
                bytes.splice(to..to, part);
            }
            Mutation::Insert(at, token) => {
                let at = place(at, &bytes);
                bytes.splice(at..at, token.bytes());
            }
        }
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn changed_examples_are_answered(
        which in any::<prop::sample::Index>(),
        mutations in prop::collection::vec(mutation(), 1..5),
    ) {
        let examples = all_examples();
        let bytes = mutated(&examples[which.index(examples.len())].1, &mutations);
        let _ = run(&bytes, &Limits::default());
        let _ = run(&bytes, &tiny());
    }

    #[test]
    fn random_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = run(&bytes, &Limits::default());
    }

    #[test]
    fn random_tokens_are_answered(tokens in prop::collection::vec(prop::sample::select(TOKENS), 0..40)) {
        let text = tokens.concat();
        let _ = run(text.as_bytes(), &Limits::default());
        let _ = run(with_data(&text).as_bytes(), &tiny());
        let _ = run(format!("{BOUNDARY}{text}").as_bytes(), &tiny());
    }
}

#[test]
fn deep_brackets_of_every_kind_are_a_limit() {
    for (open, close) in [("(", ")"), ("[", "]"), ("sin(", ")"), ("√(", ")"), ("v^(", ")"), ("2(", ")"), ("-(", ")")]
    {
        let text = with_data(&format!("{}v{}", open.repeat(100_000), close.repeat(100_000)));
        assert!(is_limit(&on_a_small_stack(text), "nesting"), "{open}");
        // One below the limit, the vector's bracket counted, there is an answer.
        let text = with_data(&format!("{}v{}", open.repeat(127), close.repeat(127)));
        assert!(!is_limit(&on_a_small_stack(text), "nesting"), "{open}");
    }
    assert!(is_limit(&on_a_small_stack("{".repeat(1000)), "nesting"));
}

#[test]
fn long_runs_of_one_token_are_answered() {
    for sign in ["-", "+", "−"] {
        assert_eq!(on_a_small_stack(with_data(&format!("{}v", sign.repeat(20_000)))), Ok(1), "{sign}");
    }
    for unit in [
        "^", "√", "'", "∂", "=", "sin ", "sin", "d", "*", ",", ":", "S", "²", "_", "\n", "e^-", "at ", "1", "1.", "x",
        "(\n",
    ] {
        let _ = on_a_small_stack(with_data(&unit.repeat(3_000)));
        let _ = on_a_small_stack(unit.repeat(3_000));
    }
    let _ = on_a_small_stack(with_data(&format!("{}v", "√".repeat(3_000))));
    let _ = on_a_small_stack(with_data(&format!("{}v", "v^".repeat(2_000))));
}

#[test]
fn blank_lines_inside_brackets_cost_their_length_only() {
    assert_eq!(on_a_small_stack(with_data(&format!("v{}", "\n".repeat(500_000)))), Ok(1));
}

#[test]
fn name_as_long_as_the_text_costs_its_length_only() {
    let found = on_a_small_stack(with_data(&"sin".repeat(200_000))).expect_err("no such name");
    assert_eq!(found[0].code, Code::UnknownName);
}

#[test]
fn long_sums_and_products_are_answered() {
    assert_eq!(on_a_small_stack(with_data(&vec!["v"; 100_000].join("+"))), Ok(1));
    assert_eq!(on_a_small_stack(with_data(&vec!["v"; 50_000].join("*"))), Ok(1));
    assert_eq!(on_a_small_stack(with_data(&vec!["v"; 50_000].join(" "))), Ok(1));
    let powers: Vec<String> = (0..10_000).map(|k| format!("v^{k}")).collect();
    assert!(is_limit(&on_a_small_stack(with_data(&powers.join("+"))), "monomials"));
    // Product after product these would hold 10^8 operands.
    let factors: Vec<String> = (0..14_000).map(|k| format!("(v+{k})")).collect();
    assert!(is_limit(&on_a_small_stack(with_data(&factors.join("*"))), "graph-nodes"));
}

#[test]
fn derivatives_of_deep_and_wide_functions_are_a_limit() {
    let nested = format!("{}v{}", "sin(".repeat(100), ")".repeat(100));
    let product: Vec<String> = (1..300).map(|k| format!("sin({k} v)")).collect();
    let exponentials = format!("{}v", "e^-".repeat(200));
    for data in [nested, product.join("*"), exponentials] {
        assert!(is_limit(&on_a_small_stack(with_data(&data)), "graph-nodes"), "{data}");
    }
}

/// `let a0 = v + 1`, then definitions from the one before, then the last as data.
fn chain(depth: usize, step: impl Fn(usize) -> String) -> String {
    let lets: String = (1..depth).map(|k| format!("let a{k} = {}\n", step(k))).collect();
    format!("let a0 = v + 1\n{lets}{}", with_data(&format!("a{}", depth - 1)))
}

#[test]
fn chains_of_4000_definitions_are_answered() {
    assert_eq!(on_a_small_stack(chain(4000, |k| format!("a{} + 1", k - 1))), Ok(2));
    let _ = on_a_small_stack(chain(4000, |k| format!("sin(a{}) + t", k - 1)));
}

#[test]
fn doubling_definitions_are_a_limit() {
    let squares = on_a_small_stack(chain(1000, |k| format!("a{0}*a{0} + 1", k - 1)));
    let waves = on_a_small_stack(chain(1000, |k| format!("sin(a{0}) + cos(a{0})", k - 1)));
    let sums = on_a_small_stack(chain(2000, |k| format!("a{} + v^{k}", k - 1)));
    let quotients = on_a_small_stack(chain(1000, |k| format!("a{0}/(1 + a{0})", k - 1)));
    for found in [squares, waves, sums, quotients] {
        assert!(is_limit(&found, "graph-nodes"), "{found:?}");
        // A limit ends the search, it is not reported by every definition after it.
        assert_eq!(found.expect_err("a limit").len(), 1);
    }
}

#[test]
fn thousands_of_faults_are_answered_with_a_hundred() {
    let params: String = (0..2000).map(|k| format!("param aaaa{k} = {k}\n")).collect();
    let unknown = format!("{params}at u = 0:\n{}", "x = aaaaqq9\n".repeat(5_000));
    assert_eq!(on_a_small_stack(unknown).expect_err("unknown names").len(), 100);
    assert_eq!(on_a_small_stack("x = v *\n\nparam\n".repeat(5_000)).expect_err("no syntax").len(), 100);
    assert_eq!(on_a_small_stack("(\nat \n".repeat(5_000)).expect_err("open brackets").len(), 100);
}

#[test]
fn thousands_of_unused_coefficients_are_answered() {
    let coefficients: Vec<String> = (0..1500).map(|k| format!("a{k} = {k}")).collect();
    let text = format!("pde d4S/du4 = 0 with {}\n{}", coefficients.join(", "), with_data("v"));
    assert!(on_a_small_stack(text).is_err());
}

/// Whether a document is within `limits`; any other finding fails the test.
fn is_within(text: &str, limits: &Limits) -> bool {
    match run(text.as_bytes(), limits) {
        Ok(_) => true,
        Err(found) => {
            assert!(found.iter().all(|finding| finding.code == Code::LimitReached), "{found:?}");
            false
        }
    }
}

#[test]
fn every_limit_of_the_front_end_holds_at_n_and_not_at_n_plus_1() {
    let standard = Limits::default();
    let exact = |with: &dyn Fn(usize) -> Limits, text: &str, needed: usize| {
        assert!(is_within(text, &with(needed)), "{needed} suffices: {text}");
        assert!(!is_within(text, &with(needed - 1)), "{} does not: {text}", needed - 1);
    };
    let bytes = |source_bytes| Limits { source_bytes, ..standard.clone() };
    exact(&bytes, BOUNDARY, BOUNDARY.len());
    let nesting = |nesting| Limits { nesting, ..standard.clone() };
    exact(&nesting, &with_data("((v))"), 3);
    let names = |names| Limits { names, ..standard.clone() };
    exact(&names, &format!("param a = 1, b = 2\nlet c = v\n{BOUNDARY}"), 3);
    let monomials = |monomials| Limits { monomials, ..standard.clone() };
    exact(&monomials, &with_data("(1 + sin v)^6"), 7);
    let functions = |basis_functions| Limits { basis_functions, ..standard.clone() };
    exact(&functions, &with_data("1 + v + t + v t"), 4);
    let orders = |derivative_order| Limits { derivative_order, ..standard.clone() };
    exact(&orders, &format!("pde d4S/du4 + d6S/dv6 = 0\n{BOUNDARY}"), 6);
    let nodes = |graph_nodes| Limits { graph_nodes, ..standard.clone() };
    let needed = (1..5000).find(|size| is_within(&with_data("sin(v) e^t"), &nodes(*size))).expect("a small graph");
    assert!(needed > 20, "{needed}");
    exact(&nodes, &with_data("sin(v) e^t"), needed);
}

#[test]
fn text_of_a_decomposition_is_bounded_in_bytes() {
    let decomposition = crate::spec::decomposition(&with_data("sin(v)"));
    let of = |text_bytes| {
        let limits = Limits { text_bytes, ..Limits::default() };
        decomposition.text_of(decomposition.basis[0].expr, trimline::expr::Notation::Ascii, &limits)
    };
    assert_eq!(of(6).as_deref(), Ok("sin(v)"));
    assert_eq!(of(5).map_err(|finding| finding.code), Err(Code::LimitReached));
}

#[test]
fn source_that_was_not_decoded_is_bounded_as_well() {
    let source = trimline::diagnostic::Source::new("spec", " ".repeat(2 << 20));
    let found = trimline::syntax::parse(&source, &Limits::default()).expect_err("too long");
    assert_eq!(found[0].code, Code::LimitReached);
}
