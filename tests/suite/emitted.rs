//! Emitted source code, compiled by other compilers and run: it gives the surface that the library evaluates.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Source};
use trimline::emit::{Form, Formula, Language, emit};
use trimline::expr::Derivative;
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::problem::{DomainValues, PatchCopy};
use trimline::surface::{CompiledPlacement, PlacedSurface, Surface};

/// A surface to be emitted, and where it is compared.
struct Case {
    formula: Formula,
    /// `(u, v, t)`, with S, S_u and S_v there.
    points: Vec<([f64; 3], [[f64; 3]; 3])>,
    /// The largest coordinate of S, S_u and S_v at the points.
    sizes: [f64; 3],
}

/// Every function of the language in one boundary, and all ways to write a power.
const FUNCTIONS: &str = "domain v in [0.1, 0.9], t in [0, 1]
param p' = 0.3, p_prime = 0.4, k = 2, t_0 = 3
pde ∂⁴S/∂u⁴ = 0
at u = 0:
    S_x = sin v + cos(k v) + tan v + cot v + sec v + csc v + asin v + acos v + atan(p' v)
    S_y = atan2(v, 1 + t) + sinh v + cosh v + tanh v + asinh v + acosh(1 + v) + atanh(v)
    S_z = e^(-v t) + sin(abs(k) sign(-k) floor(k + 0.5) v + min(k, 1) max(k, t_0)) + ln v + log10 v + cbrt(v - 0.5 - 2) + v^2.5 + v^(-3) + sqrt(v) + 1/sqrt(v + t)
    ∂S_x/∂u = v^17 + (v + 1)^t
    ∂S_y/∂u = sin(p_prime v)^4
    ∂S_z/∂u = 1/(1 + v^2)
at u = 1: S = [v, t, 1], ∂S/∂u = [0, 0, 1]
solve exact";

/// A surface without basis functions.
const ZERO: &str = "at u = 0: S = [0, 0, 0], ∂S/∂u = [0, 0, 0]\nat u = 1: S = [0, 0, 0], ∂S/∂u = [0, 0, 0]";

/// A net that moves, and patches, one of them with a function of data, with copies of all: turned, moved and mirrored.
const COPIES: &str = "param k = 0.5
surface X(u, v, t) = [cosh(u) cos(v), cosh(u) sin(v) + t, u + 0.1 t u v] with u in [0, 1], v in [0, 3]
bspline sheet { domain u in [0, 1], v in [0, 3]
    knots clamped in u, v
    net 5 x 7 from surface X sampled greville }
patch tube {
    at u = 0: S = [cos v, sin v, t], ∂S/∂u = [0, 0, 1]
    at u = 1: S = [2 cos v, 2 sin v, 2], ∂S/∂u = [0, 0, 1]
}
repeat tube 3 times rotated about z by 2π/3 + t
mirror tube in y = k - 2
mirror sheet in x = -k
solve exact";

fn blend(name: &str, text: &str, method: Option<&str>) -> Blend {
    let options = Options { method: method.map(str::to_owned), ..Options::default() };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let read = |file: &str| std::fs::read(folder.join(file)).map_err(|error| error.to_string());
    let blend = Blend::compile_with(&Source::new(name, text), read, &options);
    blend.unwrap_or_else(|found| panic!("{name}: {found:?}"))
}

/// The instant at which fitted solutions are emitted.
fn instant(domain: DomainValues) -> f64 {
    at(domain.t, 0.375)
}

fn at([low, high]: [f64; 2], share: f64) -> f64 {
    low + share * (high - low)
}

/// `formula` and the values of its surface at some points.
fn case(formula: Formula, surface: &dyn Surface) -> Case {
    let domain = formula.domain;
    let mut points = Vec::new();
    for index in 0..24 {
        // Both ends, and nothing that falls on a node.
        let share = |step: f64| (step * f64::from(index)).fract();
        let t = formula.instant.unwrap_or_else(|| at(domain.t, share(0.618)));
        let u = if index < 2 { domain.u[index as usize] } else { at(domain.u, share(0.37)) };
        let point = [u, at(domain.v, share(0.7549)), t];
        let mut values = [[0.0; 3]; 3];
        let orders = [Derivative::NONE, Derivative::new(1, 0, 0), Derivative::new(0, 1, 0)];
        for (order, value) in orders.into_iter().zip(&mut values) {
            surface.evaluate(order, &[point], std::slice::from_mut(value)).expect("a point of the domain");
        }
        points.push((point, values));
    }
    let largest = |k: usize| points.iter().flat_map(|(_, values)| values[k]).fold(0.0, |m: f64, x| m.max(x.abs()));
    let sizes = [0, 1, 2].map(largest);
    Case { formula, points, sizes }
}

/// A patch or net of a blend, by its place among both; `None` if it is no sum of products, which is refused.
fn part(blend: &Blend, index: usize, name: &str) -> Option<(Formula, Arc<dyn Surface + Send + Sync>)> {
    let Some(patch) = blend.patches.get(index) else {
        let index = index - blend.patches.len();
        let domain = blend.nets[index].domain;
        let net = blend.fill(index, instant(domain)).unwrap_or_else(|found| panic!("{name}: {found}"));
        let formula = Formula::of_net(name, net.filled.surface, domain, net.surface.instant(), None);
        return Some((formula, net.surface));
    };
    let solution = blend.solve(index, instant(patch.domain)).unwrap_or_else(|found| panic!("{name}: {found}"));
    let formula = Formula::new(name, &blend.problem, solution.surface.as_separable()?, patch.domain);
    Some((formula.expect("a smooth surface"), solution.surface))
}

/// The first patch of a text, its first net, and its first and last copy.
fn cases_of(name: &str, text: &str, method: Option<&str>) -> Vec<Case> {
    let blend = blend(name, text, method);
    let title = format!("{name}{}", method.map_or(String::new(), |method| format!("-{method}")));
    let nets = (!blend.nets.is_empty()).then_some((blend.patches.len(), format!("{title}-net")));
    let patches = (!blend.patches.is_empty()).then(|| (0, title.clone()));
    let wanted = patches.into_iter().chain(nets);
    let mut cases: Vec<Case> = wanted
        .filter_map(|(index, title)| part(&blend, index, &title))
        .map(|(formula, surface)| case(formula, &*surface))
        .collect();
    let graph = Arc::new(blend.problem.graph.clone());
    let copies = &blend.problem.copies;
    for copy in copies.first().into_iter().chain(copies.last().filter(|_| copies.len() > 1)) {
        let Some((formula, base)) = part(&blend, copy.original, "base") else { continue };
        let placement = Arc::new(CompiledPlacement::new(&graph, copy, &Limits::default()));
        let params = blend.bindings.as_slice();
        let is_reflection = placement.is_reflection(params, formula.domain.t[0]).expect("a place");
        let copy = PatchCopy { name: format!("{title}-{}", copy.name), ..copy.clone() };
        let formula = formula.copied(&blend.problem, &blend.bindings, &copy, is_reflection);
        cases.push(case(formula, &PlacedSurface::new(base, placement, params)));
    }
    cases
}

/// The case of a text with one patch.
fn only(name: &str, text: &str, method: Option<&str>) -> Case {
    cases_of(name, text, method).pop().expect("a sum of products")
}

/// Every example, those with a closed basis by `exact` as well, a boundary of every function, copies, and a net.
fn cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .expect("examples")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .filter_map(|name| name.strip_suffix(".trim").map(str::to_owned))
        // Steep boundary layers are no series in u: only `--within` writes them.
        .filter(|name| !["import_step", "measured"].contains(&name.as_str()))
        .collect();
    names.sort();
    let stated = [("functions", FUNCTIONS), ("zero", ZERO), ("copies", COPIES)];
    let mut cases: Vec<Case> = stated.into_iter().flat_map(|(name, text)| cases_of(name, text, None)).collect();
    assert_eq!(cases.len(), 6, "a patch each, a net and two copies");
    for name in names {
        let text = std::fs::read_to_string(folder.join(format!("{name}.trim"))).expect("an example");
        cases.extend(cases_of(&name, &text, None));
        if ["eq19", "eq27", "eq29_30"].contains(&name.as_str()) {
            cases.extend(cases_of(&name, &text, Some("exact")));
        }
    }
    let is_net = |case: &&Case| matches!(case.formula.form, Form::Net(..));
    let copies = cases.iter().filter(|case| case.formula.placement.is_some()).count();
    assert!(cases.iter().filter(is_net).count() >= 4 && copies >= 7, "nets and copies are left out");
    cases
}

/// Compares a line of nine numbers for every point of every case.
///
/// The tables agree with the surface to 1e-12 of its size or are refused; in between lie functions of two libraries,
/// which differ by units in the last place: 1e-12 of the size of S, S_u or S_v has room for some thousand of them.
fn compare(cases: &[Case], printed: &str) {
    let mut lines = printed.lines();
    for case in cases {
        for (point, expected) in &case.points {
            let line = lines.next().expect("a line for every point");
            let found: Vec<f64> = line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
            assert_eq!(found.len(), 9, "{line}");
            for (k, (found, expected)) in found.iter().zip(expected.iter().flatten()).enumerate() {
                let size = case.sizes[k / 3];
                assert!(
                    (found - expected).abs() <= 1e-12 * size,
                    "{} at {point:?}, {k}: {found} {expected} ({size})",
                    case.formula.name
                );
            }
        }
    }
    assert_eq!(lines.next(), None);
}

fn arguments(case: &Case, [u, v, t]: [f64; 3]) -> String {
    match case.formula.instant {
        None => format!("{u:?}, {v:?}, {t:?}"),
        Some(_) => format!("{u:?}, {v:?}"),
    }
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn emitted_c_gives_the_surface_of_every_example() {
    let cases = cases();
    let folder = tempfile::tempdir().expect("a folder");
    let mut main = "#include <stdio.h>\n".to_owned();
    let mut body = String::new();
    for case in &cases {
        let name = &case.formula.name;
        let signature = if case.formula.instant.is_some() { "double, double" } else { "double, double, double" };
        let _ = writeln!(main, "void {name}_surface({signature}, double[3], double[3], double[3]);");
        for (point, _) in &case.points {
            let _ = writeln!(body, "    {name}_surface({}, s[0], s[1], s[2]); show(s);", arguments(case, *point));
        }
        let text = emit(&case.formula, Language::C).expect("numbers fit");
        std::fs::write(folder.path().join(format!("{name}.c")), text).expect("a file");
    }
    let _ = write!(
        main,
        "static void show(double s[3][3]) {{\n    for (int k = 0; k < 9; k++) printf(\"%.17g \", s[k / 3][k % 3]);\n    \
         puts(\"\");\n}}\nint main(void) {{\n    double s[3][3];\n{body}    return 0;\n}}\n"
    );
    std::fs::write(folder.path().join("main.c"), main).expect("a file");
    let sources = cases.iter().map(|case| format!("{}.c", case.formula.name));
    let flags = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-o", "program", "main.c"];
    run(Command::new("cc").current_dir(&folder).args(flags).args(sources).arg("-lm"));
    compare(&cases, &run(&mut Command::new(folder.path().join("program"))));
}

#[test]
fn emitted_rust_gives_the_surface_of_every_example() {
    let cases = cases();
    let folder = tempfile::tempdir().expect("a folder");
    let (mut main, mut body) = (String::new(), String::new());
    for case in &cases {
        let name = &case.formula.name;
        let _ = writeln!(main, "mod {name};");
        for (point, _) in &case.points {
            let _ = writeln!(body, "    show({name}::{name}_surface({}));", arguments(case, *point));
        }
        let text = emit(&case.formula, Language::Rust).expect("numbers fit");
        std::fs::write(folder.path().join(format!("{name}.rs")), text).expect("a file");
    }
    let _ = write!(
        main,
        "fn show(s: [[f64; 3]; 3]) {{\n    for x in s.iter().flatten() {{ print!(\"{{x:e}} \"); }}\n    println!();\n}}\n\
         fn main() {{\n{body}}}\n"
    );
    std::fs::write(folder.path().join("main.rs"), main).expect("a file");
    run(Command::new("rustc").current_dir(&folder).args(["--edition", "2021", "-D", "warnings", "main.rs"]));
    compare(&cases, &run(&mut Command::new(folder.path().join("main"))));
}

#[test]
fn surface_of_one_instant_takes_no_time_and_says_so() {
    let text = "at u = 0: S = [e^t cos v, sin v, 1], ∂S/∂u = [0, 0, -1]\n\
                at u = 1: S = [2 cos v, 2 sin v, 0], ∂S/∂u = [cos v, sin v, 0]\npde with ρ = 1\n";
    let fitted = only("moving", text, Some("sine"));
    let text_of = |case: &Case, language| emit(&case.formula, language).expect("numbers fit");
    for language in Language::ALL {
        assert!(text_of(&fitted, *language).contains("It holds at t = 0.375 only"), "{}", language.name());
    }
    assert!(text_of(&fitted, Language::C).contains("moving_sine_surface(double u, double v, double s[3]"));
    let exact = only("moving", text, Some("exact"));
    assert!(text_of(&exact, Language::C).contains("moving_exact_surface(double u, double v, double t, double s[3]"));
}

#[test]
fn number_beyond_single_precision_is_refused_by_shaders_only() {
    let text = "at u = 0: S = [1e39 cos v, sin v, 1], ∂S/∂u = 0\nat u = 1: S = [v, 1, 0], ∂S/∂u = 0\n";
    let huge = only("huge", text, Some("exact"));
    for language in Language::ALL {
        let emitted = emit(&huge.formula, *language);
        match language.is_single_precision() {
            true => assert_eq!(emitted.expect_err("too large").code, Code::FormatCannotHold),
            false => assert!(emitted.is_ok(), "{}", language.name()),
        }
    }
}

#[test]
fn net_of_more_points_than_a_table_of_shaders_holds_is_refused_by_them_only() {
    for (size, is_refused) in [(63, false), (64, true)] {
        let net = only("sheet", &format!("bspline sheet {{\nnet {size} x {size} from [i, j, i j/100]\n}}\n"), None);
        for language in Language::ALL {
            let emitted = emit(&net.formula, *language);
            match language.is_single_precision() && is_refused {
                true => assert_eq!(emitted.expect_err("too many").code, Code::FormatCannotHold),
                false => assert!(emitted.is_ok(), "{}", language.name()),
            }
        }
    }
}

#[test]
fn equal_surfaces_are_emitted_in_equal_bytes() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/eq31_32.trim"));
    let text = text.expect("an example");
    let emitted = || emit(&only("eq31_32", &text, None).formula, Language::Glsl).expect("numbers fit");
    assert_eq!(emitted(), emitted());
}
