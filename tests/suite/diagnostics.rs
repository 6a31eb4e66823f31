//! What bad specs are answered: code, place and the words that help.

mod morphs;
mod nets;
mod table;

use trimline::blend::Blend;
use trimline::diagnostic::{Class, Code, Diagnostic, Diagnostics, Severity, Source};
use trimline::limits::Limits;
use trimline::method::Options;
use trimline::resolve::{resolve, review};
use trimline::syntax;
use trimline::verify::verify;

use crate::spec::{BOUNDARY, Prepared, data_file, decomposition_within, patch, problem_within, told, with_data};

use table::{ROWS, Spec};

/// Codes that no text produces by itself, and what does.
const ELSEWHERE: &[(Code, &str)] = &[
    (Code::NotUtf8, "bytes that are not text: below"),
    (Code::NotFormatted, "a fault of `fmt` itself"),
    (Code::UnusedDeclaration, "`review`: below"),
    (Code::DegenerateBoundary, "`review`: below"),
    (Code::BadDataFile, "tests of curves, which take files"),
    (Code::PeriodMissed, "`review`: below"),
    (Code::LargeResidual, "tests of the choice of `auto`"),
    (Code::PointOutsideDomain, "points and instants of the command line"),
    (Code::BadPoints, "tables of points of the command line"),
    (Code::SeamApart, "`check`, which solves the patches of a seam"),
    (Code::PromiseBroken, "tests of `Blend`, which judges solutions"),
    (Code::MethodPassedOver, "the choice of `auto`, which tests of methods make"),
    (Code::SeamOpens, "tests of the method `static_blend`"),
    (Code::EndsDominate, "forces: a solution that the ends of v make far larger than its force"),
    (Code::SolutionNotUnique, "tests of the method `static_blend`"),
    (Code::CurvesDoNotMeet, "tests of nets"),
    (Code::SeamCreased, "tests of nets"),
    (Code::ToleranceNotReached, "tests of fits"),
    (Code::EdgesNearlyMeet, "tests of imported surfaces"),
    (Code::SidesDisagree, "tests of the method `four_sided`"),
    (Code::TwistsDisagree, "tests of the method `four_sided`"),
    (Code::NotElliptic, "tests of the method `four_sided`"),
    (Code::TermsTooFew, "tests of the method `four_sided`"),
    (Code::ShapeLost, "tests of deformations and of copies, which know the size of the solution"),
    (Code::NotSeparable, "tests of specs with four sides"),
    (Code::ApexNotSmooth, "tests of patches with an apex"),
    (Code::PatchFolded, "tests of folds"),
    (Code::HostUnsupported, "a machine without machine code"),
    (Code::OutputFailed, "a full disk"),
    (Code::NoArea, "tests of CAD files"),
    (Code::FormatCannotHold, "tests of exports"),
    (Code::DegenerateNormals, "a mesh"),
    (Code::PrecisionLost, "an export"),
];

fn text_of(spec: Spec) -> String {
    match spec {
        Spec::Whole(text) => text.to_owned(),
        Spec::Data(value) => with_data(value),
        Spec::Before(text) => format!("{text}{BOUNDARY}"),
        Spec::After(text) => format!("{BOUNDARY}{text}"),
    }
}

/// Everything that is found on the way from a text to a verified surface at t = 0.
fn findings(text: &str) -> Diagnostics {
    if text.contains("bspline ") {
        return of_nets(text).unwrap_or_else(|found| found);
    }
    let prepared = match Prepared::try_new(text, &[]) {
        Ok(prepared) => prepared,
        Err(found) => return found,
    };
    let solution = match prepared.try_solve(0.0) {
        Ok(solution) => solution,
        Err(found) => return vec![found],
    };
    let patch = patch(&prepared.problem);
    let numbers = (&prepared.bindings, &prepared.domain, 0.0);
    let measured = verify(&prepared.problem, patch, &*solution.surface, numbers);
    solution.report.warnings.iter().cloned().chain(measured.err()).collect()
}

/// Of a document of nets alone, filled at t = 0.
fn of_nets(text: &str) -> Result<Diagnostics, Diagnostics> {
    let blend = Blend::compile(&Source::new("spec", text), &Options::default())?;
    let mut warnings = Diagnostics::new();
    for index in 0..blend.nets.len() {
        warnings.extend(blend.fill(index, 0.0).map_err(|finding| vec![finding])?.filled.warnings);
    }
    Ok(warnings)
}

fn place(source: &Source, finding: &Diagnostic) -> String {
    let Some(span) = finding.span else { return "-".to_owned() };
    let place = source.line_column(span.start);
    format!("{}:{}", place.line, place.column)
}

/// All words of a finding.
fn words(finding: &Diagnostic) -> String {
    let labels = finding.labels.iter().map(|label| label.message.clone());
    let parts = [finding.message.clone(), finding.marker.clone()].into_iter().chain(labels);
    parts.chain(finding.hints.iter().cloned()).collect::<Vec<_>>().join("\n")
}

#[test]
fn bad_specs_get_one_finding_with_its_code_place_and_advice() {
    let mut wrong = Vec::new();
    for &(spec, code, expected_place, marked, fragment) in ROWS.iter().chain(nets::ROWS).chain(morphs::ROWS) {
        let text = text_of(spec);
        let source = Source::new("spec", &*text);
        let found = findings(&text);
        let [only] = found.as_slice() else {
            wrong.push(format!("{text}\n{} findings: {}", found.len(), told(&text, &found)));
            continue;
        };
        let slice = only.span.map_or("", |span| source.slice(span));
        let is_right = only.code == code
            && place(&source, only) == expected_place
            && slice == marked
            && words(only).contains(fragment);
        if !is_right {
            wrong.push(format!(
                "{text}\n{} marks `{slice}`\nnot {code} {expected_place} `{marked}` {fragment}",
                told(&text, &found)
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn table_covers_every_code_that_a_text_can_produce() {
    assert!(ROWS.len() >= 60, "{}", ROWS.len());
    for &code in Code::ALL {
        let in_table = ROWS.iter().chain(nets::ROWS).chain(morphs::ROWS).any(|row| row.1 == code);
        let elsewhere = ELSEWHERE.iter().any(|(other, _)| *other == code);
        assert!(in_table != elsewhere, "{code} {code:?}: in the table {in_table}, elsewhere {elsewhere}");
    }
}

#[test]
fn codes_are_distinct_and_begin_with_their_severity() {
    for (index, code) in Code::ALL.iter().enumerate() {
        assert!(Code::ALL.iter().take(index).all(|other| other.as_str() != code.as_str()), "{code}");
        let letter = match code.severity() {
            Severity::Error => 'E',
            Severity::Warning => 'W',
            Severity::Note => 'N',
        };
        assert!(code.as_str().starts_with(letter), "{code}");
    }
}

#[test]
fn messages_are_lower_case_and_without_a_full_stop() {
    for &(spec, ..) in ROWS {
        for finding in findings(&text_of(spec)) {
            // `S` and components begin with their own letter.
            let first = finding.message.chars().next().expect("a message");
            assert!(!first.is_uppercase() || finding.message.starts_with('S'), "{finding}");
            assert!(!finding.message.ends_with('.'), "{finding}");
            for word in ["invalid", "illegal", "bad "] {
                assert!(!words(&finding).contains(word), "{finding}");
            }
        }
    }
}

/// Places and codes of several findings.
fn places(text: &str) -> Vec<String> {
    let source = Source::new("spec", text);
    findings(text).iter().map(|finding| format!("{} {}", finding.code, place(&source, finding))).collect()
}

#[test]
fn several_errors_of_one_file_are_reported_together() {
    let brackets = format!("param a = (1\nparam b = 2]\n{BOUNDARY}");
    assert_eq!(places(&brackets), ["E0103 1:11", "E0103 2:12"]);
    assert_eq!(places("at u = 0: S = [v, (t], 0)\n"), ["E0103 1:21", "E0103 1:25"]);
    let syntax = "at u = 0: S_x = v +* t\nparam = 3\nat u = 1: S = [0, 0, 1] 2 =";
    assert_eq!(places(syntax), ["E0102 1:20", "E0102 2:7", "E0102 3:27"]);
    assert_eq!(places(&format!("param a = q1, b = q2\n{BOUNDARY}")), ["E0201 1:11", "E0201 1:19"]);
    let boundary = "at u = 0: S_x = u, S_y = q7, S_z = [1, 2, 3]\nat u = 1: S_x = 0, S_x = 1";
    assert_eq!(places(boundary), ["E0203 1:17", "E0201 1:26", "E0209 1:36", "E0204 2:20"]);
    let missing = "at u = 0: S_x = v, dS_y/du = 0\nat u = 1: S = 0, dS/du = 0";
    assert_eq!(places(missing).len(), 4, "S_y, S_z, and the tangents of x and z");
}

#[test]
fn duplicate_points_at_the_first_as_well() {
    let text = format!("{BOUNDARY}at u = 0: S_y = 1");
    let found = findings(&text);
    let label = found[0].labels.first().expect("a second place");
    assert_eq!(Source::new("spec", &*text).slice(label.span), "sin v");
}

#[test]
fn bytes_that_are_not_utf8_are_refused_with_their_place() {
    let found = syntax::decode("spec", b"param a = 1\nparam b = \xff\xfe", &Limits::default()).expect_err("not UTF-8");
    assert_eq!(found.code, Code::NotUtf8);
    assert_eq!(found.span.map(|span| span.start), Some(22));
    assert!(found.message.contains("line 2"), "{found}");
}

#[test]
fn text_of_2_mib_is_a_limit_that_says_which() {
    let bytes = vec![b' '; 2 << 20];
    let found = syntax::decode("spec", &bytes, &Limits::default()).expect_err("too long");
    assert_eq!((found.code, found.class()), (Code::LimitReached, Class::Limit));
    assert!(found.message.contains("source-bytes"), "{found}");
}

#[test]
fn ten_thousand_brackets_are_a_limit_at_the_first_one_too_many() {
    for (open, close) in [("(", ")"), ("[", "]"), ("sin(", ")")] {
        let text = with_data(&format!("{}v{}", open.repeat(10_000), close.repeat(10_000)));
        let found = problem_within(&text, &Limits::default()).expect_err("too deep");
        let [only] = found.as_slice() else { panic!("{}", told(&text, &found)) };
        assert_eq!(only.code, Code::LimitReached);
        assert!(only.message.contains("nesting"), "{only}");
        // One bracket of the vector around them counts.
        let expected = 14 + open.len() * 128;
        assert_eq!(only.span.map(|span| span.start), Some(expected), "{open}");
    }
}

#[test]
fn derivative_that_only_the_equation_needs_is_refused_with_its_place_where_it_is_taken() {
    // ρ = 0, and abs is taken of t alone.
    let text = with_data("abs(t - 2) sin(v)");
    let found = decomposition_within(&text, &Limits::default()).expect("a basis");
    let fault = found.check_differentiable().expect_err("ρ S_tt is a term");
    assert_eq!(
        (fault.code, fault.span.map(|span| &text[span.start..span.end])),
        (Code::NotDifferentiable, Some("abs(t - 2) sin(v)"))
    );
    assert!(findings(&text).is_empty());
    assert_eq!(findings(&format!("pde with ρ = 1\n{text}"))[0].code, Code::NotDifferentiable);
}

#[test]
fn findings_never_echo_characters_that_act_on_a_terminal() {
    let finding = Diagnostic::new(Code::UnknownName, "unknown \u{1b}[31mname\u{202e}").hint("\u{7}");
    assert!(!words(&finding).chars().any(trimline::diagnostic::is_deceptive), "{finding:?}");
}

/// Codes, marked texts and messages of the warnings about a document without fault.
fn reviewed(text: &str) -> Vec<String> {
    let (source, limits) = (Source::new("spec", text), Limits::default());
    let mut document = syntax::parse(&source, &limits).unwrap_or_else(|found| panic!("{}", told(text, &found)));
    document.attach_files(&limits, data_file).unwrap_or_else(|found| panic!("{}", told(text, &found)));
    let problem = resolve(&document, "spec", &limits).unwrap_or_else(|found| panic!("{}", told(text, &found)));
    let line = |finding: &Diagnostic| {
        let marked = finding.span.map_or("", |span| source.slice(span));
        format!("{} `{marked}` {}", finding.code, finding.message)
    };
    review(&document, &problem).iter().map(line).collect()
}

#[test]
fn declarations_that_nothing_uses_are_warned_of_in_source_order() {
    let text = format!(
        "param a = 1, b = a\nlet f(x) = x, g = b\nsurface A(u, v) = [u, v, 0], B(u, v) = A(u, v), C(u, v) = A(u, v)\n\
         patch p {{ let g = B_x(0, v), h = ∂C(0, v)/∂u\n{BOUNDARY}}}"
    );
    let expected = ["W0218 `f` the definition `f` is not used", "W0218 `g` the definition `g` is not used"];
    let found = reviewed(&text);
    assert_eq!(found[..2], expected);
    assert_eq!(found[2..], ["W0218 `g` the definition `g` is not used", "W0218 `h` the definition `h` is not used"]);
}

#[test]
fn surface_that_is_only_joined_is_used() {
    let text = "surface A(u, v) = [cos v, sin v, u]\nat u = 0: join A at u = 0\nat u = 1: join A at u = 2";
    assert_eq!(reviewed(text), [""; 0]);
}

#[test]
fn trimline_that_is_a_point_and_tangent_without_length_are_warned_of() {
    let text = "at u = 0: S = 0, dS/du = [cos v, sin v, 0]\nat u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 0]";
    assert_eq!(reviewed(text), ["W0219 `0` the trimline is zero", "W0219 `0` the tangent is zero"]);
}

#[test]
fn domain_that_almost_covers_a_period_of_its_data_is_warned_of() {
    let rest = "at u = 0: S = [cos(k v), sin(k v), 0], dS/du = [0, 0, 1 + t]\nat u = 1: S = [2, cos(k v + k v), 1], dS/du = [0, 0, 1]\n";
    let found =
        |k: &str, range: &str, rest: &str| reviewed(&format!("domain v in [{range}]\n{}", rest.replace('k', k)));
    for (k, range, expected) in [
        ("1", "0, 6.28", "the domain of v ends 3.2e-3 before the boundary data repeat"),
        ("1", "0, 2*3.14", "the domain of v ends 3.2e-3 before the boundary data repeat"),
        ("1", "1, 7.3", "the domain of v ends 1.7e-2 behind the place where the boundary data repeat"),
        ("3", "0, 2.09", "the domain of v ends 4.4e-3 before the boundary data repeat"),
        ("2 π", "0, 0.999", "the domain of v ends 1.0e-3 before the boundary data repeat"),
        ("1", "0, 12.5", "the domain of v ends 6.6e-2 before the boundary data repeat"),
    ] {
        assert_eq!(found(k, range, rest), [format!("W0221 `{range}` {expected}")], "{k} {range}");
    }
    // Exact, far from a period, without a period, not periodic, and data that agree nowhere.
    for (k, range) in [("1", "0, 2π"), ("1", "0, 6.283185307179586"), ("1", "0, 6"), ("1", "-π, π"), ("2 π", "0, 1")]
    {
        assert_eq!(found(k, range, rest), [""; 0], "{k} {range}");
    }
    assert_eq!(found("1", "0, 6.28", &rest.replace("[2, cos", "[v, cos")), [""; 0]);
    assert_eq!(found("1", "0, 6.28", &rest.replace("cos(k v + k v)", "cos(√2 v)")), [""; 0]);
    assert_eq!(
        reviewed(&format!("domain v in [0, 6.28]\n{}", rest.replace("(k v)", "(3)").replace("(k v + k v)", "(3)"))),
        [""; 0]
    );
}

#[test]
fn examples_give_no_warnings() {
    for (name, text) in crate::spec::all_examples() {
        assert_eq!(reviewed(&text), [""; 0], "{name}");
    }
}

/// The hints of the first finding.
fn advice(text: &str) -> String {
    let found = findings(text);
    found.first().map(|first| first.hints.join("\n")).unwrap_or_default()
}

const ENDS: &str = "\nat u = 0: S = [cos v, sin v, 0], ∂S/∂u = 0\nat u = 1: S = 0, ∂S/∂u = 0";

#[test]
fn notation_of_papers_that_is_not_read_is_answered_with_what_is() {
    for (line, expected) in [
        ("$S = 0$", "`$$ … $$`"),
        ("param \\alpha = 2", "write `alpha` or `α`"),
        ("$$\\frac{\\partial^4 S}{\\partial u^4} + S = 0$$", "an equation begins with `pde`"),
        ("$$\\left(\\frac{\\partial^2}{\\partial u^2} + 1\\right)^2 S = 0$$", "an equation begins with `pde`"),
        ("at u = 0: S_u(0, v) = 0", "derivatives are written `∂S/∂u`"),
        ("at u = 0: S = 0, S_u = 0", "derivatives are written `∂S/∂u`"),
        ("$$\nu = 0\\\\\nS_u = 0\n$$", "derivatives are written `∂S/∂u`"),
        ("pde ∇⁴ S = 0", "(∂²/∂u² + ∂²/∂v²)² S"),
        ("pde $$\\nabla^4 S = 0$$", "\\frac{\\partial^2}{\\partial u^2}"),
        ("pde $$\\partial_u^2 S = 0$$", "\\frac{\\partial^2}{\\partial u^2}"),
        ("param A = 1\nlet φ(t) = A sin(2πt)", "t is known in every `let`: write `let phi = …`"),
        ("at u = 0: join cylinder(u, v, 1, 2) at u = 1", "`surface A(p, q) = cylinder(p, q, …)`"),
        ("at u = 0: S = ∂cylinder(u, v, 1, 2)/∂p", "`surface A(p, q) = cylinder(p, q, …)`"),
        ("param n = 2\npde (∂²/∂u² + ∂²/∂v²)^n S = 0", "write the number itself"),
        ("pde ∂⁴S/∂u⁴ + S(0, v) = 0", "where it is taken is said by `at u = …:`"),
    ] {
        let hints = advice(&format!("{line}{ENDS}"));
        assert!(hints.contains(expected), "{line}: {hints}");
    }
}

#[test]
fn constraint_after_a_line_that_cannot_be_read_is_not_said_to_stand_outside() {
    let found = findings("S(0, v) = [cos v, sin v, 0]\n∂S/∂u = 0");
    assert_eq!(found.len(), 1, "{}", words(&found[0]));
}
