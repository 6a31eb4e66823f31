//! From spec text to a solved patch, in as few words as a test should need.

use trimline::decompose::{Decomposition, decompose};
use trimline::diagnostic::{Diagnostic, Diagnostics, Source};
use trimline::eval::Backend;
use trimline::limits::Limits;
use trimline::method::{Numbers, Options, Settings, Solution, Solver, choose};
use trimline::problem::{Bindings, DomainValues, Patch, Problem};
use trimline::resolve::resolve;
use trimline::surface::{SeparableSurface, Surface};
use trimline::syntax;

/// The name of the patch of every spec here.
pub const NAME: &str = "spec";

/// Four complete constraints, for specs that are about something else.
pub const BOUNDARY: &str = "at u = 0: S = [cos v, sin v, 0], dS/du = [0, 0, 1]
at u = 1: S = [cos v, sin v, 1], dS/du = [0, 0, 1]
";

pub fn problem_within(text: &str, limits: &Limits) -> Result<Problem, Diagnostics> {
    let source = syntax::decode(NAME, text.as_bytes(), limits).map_err(|finding| vec![finding])?;
    let mut document = syntax::parse(&source, limits)?;
    document.attach_files(limits, data_file)?;
    resolve(&document, NAME, limits)
}

/// The bytes of a data file of the examples.
pub fn data_file(path: &str) -> Result<Vec<u8>, String> {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/examples"));
    std::fs::read(folder.join(path)).map_err(|error| error.to_string())
}

pub fn problem(text: &str) -> Problem {
    problem_within(text, &Limits::default()).unwrap_or_else(|found| panic!("{text}\n{}", told(text, &found)))
}

pub fn patch(problem: &Problem) -> &Patch {
    problem.patches.first().expect("a spec has a patch")
}

pub fn decomposition_within(text: &str, limits: &Limits) -> Result<Decomposition, Diagnostics> {
    let problem = problem_within(text, limits)?;
    decompose(&problem, patch(&problem), limits).map_err(|finding| vec![finding])
}

pub fn decomposition(text: &str) -> Decomposition {
    decomposition_within(text, &Limits::default()).unwrap_or_else(|found| panic!("{text}\n{}", told(text, &found)))
}

/// A spec whose boundary data are `value` in x at u = 0 and zero elsewhere.
pub fn with_data(value: &str) -> String {
    format!("at u = 0: S = [{value}, 0, 0], dS/du = 0\nat u = 1: S = 0, dS/du = 0\n")
}

/// Findings with their places, for failures of tests.
pub fn told(text: &str, found: &[Diagnostic]) -> String {
    let source = Source::new(NAME, text);
    let line = |finding: &Diagnostic| {
        let place = finding.span.map(|span| source.line_column(span.start));
        let place = place.map_or("-".to_owned(), |place| format!("{}:{}", place.line, place.column));
        let labels: Vec<&str> = finding.labels.iter().map(|label| label.message.as_str()).collect();
        format!("{} {place} {} | {} | {labels:?} {:?}", finding.code, finding.message, finding.marker, finding.hints)
    };
    found.iter().map(line).collect::<Vec<_>>().join("\n")
}

/// A spec that is ready to be solved at any instant.
pub struct Prepared {
    pub problem: Problem,
    pub decomposition: Decomposition,
    pub bindings: Bindings,
    pub domain: DomainValues,
    pub solver: Box<dyn Solver>,
}

impl Prepared {
    /// Prepares `text` as it asks to be solved, with `overrides` as `key, value`.
    pub fn new(text: &str, overrides: &[(&str, &str)]) -> Prepared {
        Prepared::try_new(text, overrides).unwrap_or_else(|found| panic!("{}", told(text, &found)))
    }

    pub fn try_new(text: &str, overrides: &[(&str, &str)]) -> Result<Prepared, Diagnostics> {
        let limits = Limits::default();
        let problem = problem_within(text, &limits)?;
        let one = |finding: Diagnostic| vec![finding];
        let bindings = Bindings::evaluate(&problem).map_err(one)?;
        let domain = patch(&problem).domain.evaluate(&problem, &bindings).map_err(one)?;
        let decomposition = decompose(&problem, patch(&problem), &limits).map_err(one)?.specialise(bindings.as_slice());
        let request = &patch(&problem).solve;
        let mut settings = Settings::read(&request.settings).map_err(one)?;
        for (key, value) in overrides {
            settings.set(key, value, None).map_err(one)?;
        }
        let numbers = Numbers { params: bindings.as_slice(), domain: &domain };
        let chosen = choose(request.method.as_deref(), request.origin, &decomposition, &numbers, &limits);
        let method = chosen.map_err(one)?.method;
        if let Some((name, origin)) = settings.given().into_iter().find(|(name, _)| !method.settings().contains(name)) {
            let message = format!("the method `{}` has no setting `{name}`", method.name());
            return Err(vec![Diagnostic::new(trimline::diagnostic::Code::UnknownSetting, message).at(origin)]);
        }
        let options = Options { settings, backend: Backend::Interpreter, limits, ..Options::default() };
        let solver = method.prepare(&decomposition, &options).map_err(one)?;
        Ok(Prepared { problem, decomposition, bindings, domain, solver })
    }

    pub fn try_solve(&self, t: f64) -> Result<Solution, Diagnostic> {
        self.solver.solve(self.bindings.as_slice(), [self.domain.u, self.domain.v], t)
    }

    pub fn solve(&self, t: f64) -> Solution {
        self.try_solve(t).unwrap_or_else(|finding| panic!("t = {t}: {finding}"))
    }
}

/// One value of a derivative of a surface.
pub fn at(surface: &dyn Surface, derivative: &str, point: [f64; 3]) -> [f64; 3] {
    let derivative = trimline::expr::Derivative::parse(derivative).expect("letters u, v and t");
    let mut values = [[0.0; 3]];
    surface.evaluate(derivative, &[point], &mut values).unwrap_or_else(|finding| panic!("{finding}"));
    values[0]
}

/// The surface of a solution by a method that makes a sum of products.
pub fn separable(solution: &Solution) -> &SeparableSurface {
    solution.surface.as_separable().expect("a sum of products")
}

/// The examples of a few patches each. Models of dozens of patches take their methods from these, and are tested whole.
pub fn examples() -> Vec<(String, String)> {
    all_examples().into_iter().filter(|(_, text)| !text.contains("bspline ") && !is_model(text)).collect()
}

/// Whether an example is a model of many patches with copies.
pub fn is_model(text: &str) -> bool {
    text.lines().any(|line| line.starts_with("mirror ") || line.starts_with("repeat "))
}

/// Every example of the project: name and text, by name.
pub fn all_examples() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples");
    let files = std::fs::read_dir(folder).expect("the examples are part of the package");
    let mut examples: Vec<(String, String)> = files
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "trim"))
        .map(|path| {
            let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8").to_owned();
            (name, std::fs::read_to_string(&path).expect("a text"))
        })
        .collect();
    examples.sort();
    assert!(examples.len() >= 4, "{examples:?}");
    examples
}

pub fn example(name: &str) -> String {
    all_examples().into_iter().find(|(found, _)| found == name).map(|(_, text)| text).expect("an example")
}
