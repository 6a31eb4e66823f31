//! The whole pipeline in one value, for embedding: text in, solved surfaces out.
//!
//! A [`Blend`] is compiled once. Changing a parameter ([`Blend::set`]) changes numbers only: nothing is parsed or
//! decomposed again, and nothing compiled, unless a term of the equation vanishes or returns, or `auto` chooses
//! another method. The library prints nothing, reads no files and starts no threads but those of
//! [`threads`].

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::decompose::{Decomposition, decompose};
use crate::diagnostic::{Code, Diagnostic, Diagnostics, Shortest, Source};
use crate::expr::canonical_name;
use crate::method::{self, Choice, Numbers, Options, Report, Settings, Solution, Solver};
use crate::net::{METHOD, NetSolver, SolvedNet};
use crate::problem::{Bindings, DomainValues, Net, Patch, Problem, check_reach};
use crate::resolve::{resolve, set_parameter};
use crate::surface::{Bump, DeformedSurface};
use crate::syntax;
use crate::threads;
use crate::verify::{Programs, Verification, check_deformations, find_fold, find_opening, refuse_poles, verify_with};

/// A compiled document with its current parameter values.
pub struct Blend {
    /// The problem, symbolically.
    pub problem: Problem,
    /// The current value of every parameter.
    pub bindings: Bindings,
    /// Its patches, in source order.
    pub patches: Vec<Prepared>,
    /// Its B-spline nets, in source order.
    pub nets: Vec<NetSolver>,
    options: Options,
}

/// A patch that is ready to be solved, for any parameters and at any instant.
pub struct Prepared {
    /// The patch's decomposition, which holds the patch itself.
    pub decomposition: Decomposition,
    /// Ranges of u, v and t for the current parameters.
    pub domain: DomainValues,
    solver: Box<dyn Solver>,
    /// As they were given, for another solver.
    options: Options,
    /// What is added to every solution.
    bumps: Vec<Arc<Bump>>,
    /// The method, and what its choice leaves to say about every solution.
    choice: Choice,
    /// The last solution, if it holds at every instant, with the params and ranges that it is for.
    everlasting: Mutex<Option<Everlasting>>,
    /// What the patch states, as programs: made when the first solution is measured.
    programs: OnceLock<Programs>,
}

type Everlasting = (Vec<f64>, [[f64; 2]; 2], Solution);

/// What a change of parameters asks for.
enum Update {
    /// New ranges; the solver takes parameters as they come.
    Numbers(DomainValues),
    /// Another equation or another method.
    Anew(Box<Prepared>),
}

/// By how much a truncated series says that it misses its boundary, and once more, since its own measurement may lie
/// between these points.
fn announced(solution: &Solution) -> f64 {
    let announced = solution.report.truncation.as_ref().filter(|truncation| !truncation.has_remainder);
    announced.map_or(0.0, |truncation| 2.0 * truncation.left_out)
}

/// The method that `options` or the document ask for.
fn choose(
    decomposition: &Decomposition,
    (bindings, domain): (&Bindings, &DomainValues),
    options: &Options,
) -> Result<Choice, Diagnostic> {
    let request = &decomposition.patch.solve;
    let (name, origin) = match options.method.as_deref() {
        Some(name) => (Some(name), None),
        None => (request.method.as_deref(), request.origin),
    };
    let numbers = Numbers { params: bindings.as_slice(), domain };
    method::choose(name, origin, decomposition, &numbers, &options.limits)
}

/// Methods meet the boundary to rounding by construction; this is what ill-conditioned constraints may cost, relative
/// to the size of the boundary data.
const LARGEST_MISS: f64 = 1e-9;

/// Of the largest term: what is above has little to do with the equation that was asked for.
const LARGE_RESIDUAL: f64 = 0.1;

/// Of the largest term. Stiff equations reach 1e-10; what is far above was not resolved.
const LARGEST_EXACT_RESIDUAL: f64 = 1e-6;

impl Blend {
    /// Compiles a document that names no data files; its single patch, if it names none, is called like the source.
    ///
    /// # Errors
    /// Everything found wrong with the text, or the first thing wrong with the problem.
    pub fn compile(source: &Source, options: &Options) -> Result<Blend, Diagnostics> {
        Blend::compile_with(source, |_| Err("no files are given".to_owned()), options)
    }

    /// Compiles a document; `read` gives the bytes of the data files it names, or says in a few words why not:
    /// `|path| std::fs::read(folder.join(path)).map_err(|error| error.to_string())`.
    ///
    /// # Errors
    /// As [`Blend::compile`], and what [`Document::attach_files`](syntax::Document::attach_files) finds.
    pub fn compile_with(
        source: &Source,
        read: impl FnMut(&str) -> Result<Vec<u8>, String>,
        options: &Options,
    ) -> Result<Blend, Diagnostics> {
        let mut document = syntax::parse(source, &options.limits)?;
        document.attach_files(&options.limits, read)?;
        let name = source.name.trim_end_matches(".trim");
        Blend::new(resolve(&document, name, &options.limits)?, options).map_err(|finding| vec![finding])
    }

    /// Compiles a problem, for example one that was built without any text.
    ///
    /// # Errors
    /// The first thing wrong with the problem.
    pub fn new(problem: Problem, options: &Options) -> Result<Blend, Diagnostic> {
        let bindings = Bindings::evaluate(&problem)?;
        let patches = threads::try_map(problem.patches.iter().collect(), |patch| {
            let decomposition = decompose(&problem, patch, &options.limits)?;
            Prepared::new(&problem, &bindings, decomposition, options)
        })?;
        let mut nets = Vec::with_capacity(problem.nets.len());
        for net in &problem.nets {
            nets.push(prepare_net(&problem, net, &bindings, options)?);
        }
        Ok(Blend { problem, bindings, patches, nets, options: options.clone() })
    }

    /// Gives a parameter or coefficient a new value, an expression in earlier parameters such as `2*a` or `-3`.
    ///
    /// # Errors
    /// As [`set_parameter`], or a value that leaves no valid problem; the blend is then as it was.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), Diagnostics> {
        let mut problem = self.problem.clone();
        let source = Source::new(canonical_name(name), value);
        set_parameter(&mut problem, name, &source, &self.options.limits)?;
        let bindings = Bindings::evaluate(&problem).map_err(|finding| vec![finding])?;
        let mut updates = Vec::with_capacity(self.patches.len());
        for prepared in &self.patches {
            updates.push(prepared.update(&problem, &bindings).map_err(|finding| vec![finding])?);
        }
        let domains = self.nets.iter().map(|net| net.domain_for(&bindings)).collect::<Result<Vec<_>, _>>();
        let domains = domains.map_err(|finding| vec![finding])?;
        for (prepared, update) in self.patches.iter_mut().zip(updates) {
            prepared.apply(update);
        }
        for (net, domain) in self.nets.iter_mut().zip(domains) {
            net.domain = domain;
        }
        (self.problem, self.bindings) = (problem, bindings);
        Ok(())
    }

    /// Solves patch number `index` at instant `t`.
    ///
    /// # Errors
    /// [`Code::SettingOutOfRange`] if there is no such patch; otherwise as [`Prepared::solve_judged`].
    pub fn solve(&self, index: usize, t: f64) -> Result<Solution, Diagnostic> {
        self.patch(index)?.solve_judged(&self.problem, &self.bindings, t).map(|(solution, _)| solution)
    }

    /// Fills net number `index` at instant `t`.
    ///
    /// # Errors
    /// [`Code::SettingOutOfRange`] if there is no such net; otherwise as [`NetSolver::solve`].
    pub fn fill(&self, index: usize, t: f64) -> Result<SolvedNet, Diagnostic> {
        let net = self.nets.get(index).ok_or_else(|| {
            let message = format!("there is no net number {index}; the document has {}", self.nets.len());
            Diagnostic::new(Code::SettingOutOfRange, message)
        })?;
        net.solve(&self.bindings, t)
    }

    /// Measures a solution of patch number `index` at instant `t` against the problem.
    ///
    /// # Errors
    /// As [`verify`](crate::verify::verify).
    pub fn verify(&self, index: usize, solution: &Solution, t: f64) -> Result<Verification, Diagnostic> {
        let prepared = self.patch(index)?;
        prepared.verify(&self.problem, &self.bindings, solution, t)
    }

    fn patch(&self, index: usize) -> Result<&Prepared, Diagnostic> {
        self.patches.get(index).ok_or_else(|| {
            let message = format!("there is no patch number {index}; the document has {}", self.patches.len());
            Diagnostic::new(Code::SettingOutOfRange, message)
        })
    }
}

/// The ranges of a patch, over which its boundary data have values.
fn domain_for(problem: &Problem, patch: &Patch, bindings: &Bindings) -> Result<DomainValues, Diagnostic> {
    let domain = patch.domain.evaluate(problem, bindings)?;
    // Splines come from data files alone.
    if !problem.data.is_empty() {
        check_reach(&problem.graph, patch, bindings, &domain)?;
    }
    Ok(domain)
}

/// Compiles a net; its one method is [`net::METHOD`](crate::net::METHOD).
///
/// # Errors
/// As [`NetSolver::new`]; [`Code::UnsupportedByMethod`] if `options` ask for another method.
pub fn prepare_net(
    problem: &Problem,
    net: &Net,
    bindings: &Bindings,
    options: &Options,
) -> Result<NetSolver, Diagnostic> {
    if let Some(name) = options.method.as_deref().filter(|name| ![METHOD, method::AUTO].contains(name)) {
        let message = format!("the net `{}` is filled by `{METHOD}`, not by `{name}`", net.name);
        let hint = "leave out the method, or choose patches for it";
        return Err(Diagnostic::new(Code::UnsupportedByMethod, message).hint(hint));
    }
    if let Some((name, origin)) = options.settings.given().first() {
        let message = format!("the method `{METHOD}` has no setting `{name}`");
        return Err(Diagnostic::new(Code::UnknownSetting, message).at(*origin).hint("it has none"));
    }
    NetSolver::new(problem, net, bindings, options.backend, &options.limits)
}

impl Prepared {
    /// Chooses the method and compiles; settings in `options` stand above those of the document.
    ///
    /// # Errors
    /// A domain without extent, an unknown method or setting, a problem the method cannot treat, a limit.
    /// Findings about `options` have no place.
    pub fn new(
        problem: &Problem,
        bindings: &Bindings,
        decomposition: Decomposition,
        options: &Options,
    ) -> Result<Prepared, Diagnostic> {
        let domain = domain_for(problem, &decomposition.patch, bindings)?;
        let decomposition = decomposition.specialise(bindings.as_slice());
        let mut stated = Settings::read(&decomposition.patch.solve.settings)?;
        // The document's settings are those of its own method.
        if options.method.as_ref().is_some_and(|name| decomposition.patch.solve.method.as_ref() != Some(name)) {
            stated = Settings::default();
        }
        let choice = choose(&decomposition, (bindings, &domain), options)?;
        let method = choice.method;
        let settings = options.settings.clone().over(stated);
        if let Some((name, origin)) = settings.given().into_iter().find(|(name, _)| !method.settings().contains(name)) {
            let message = format!("the method `{}` has no setting `{name}`", method.name());
            let finding = Diagnostic::new(Code::UnknownSetting, message).at(origin);
            return Err(finding.hint(format!("its settings: {}", method.settings().join(", "))));
        }
        let solver = choice.prepare(&decomposition, &Options { settings, ..options.clone() })?;
        let compiled =
            |deformation| Bump::compile(problem, deformation, options.backend, &options.limits).map(Arc::new);
        let bumps = decomposition.patch.deformations.iter().map(compiled).collect::<Result<_, _>>()?;
        let (everlasting, programs) = (Mutex::default(), OnceLock::new());
        Ok(Prepared { decomposition, domain, solver, options: options.clone(), bumps, choice, everlasting, programs })
    }

    /// Takes new values of the parameters, `bindings` of `problem`: new ranges, and where a term of the equation
    /// vanishes or returns, or `auto` chooses another method, a new solver.
    ///
    /// # Errors
    /// As [`Prepared::new`]; this is then as it was.
    pub fn refresh(&mut self, problem: &Problem, bindings: &Bindings) -> Result<(), Diagnostic> {
        let update = self.update(problem, bindings)?;
        self.apply(update);
        Ok(())
    }

    fn apply(&mut self, update: Update) {
        match update {
            Update::Numbers(domain) => self.domain = domain,
            Update::Anew(anew) => *self = *anew,
        }
    }

    /// What new values of the parameters change.
    fn update(&self, problem: &Problem, bindings: &Bindings) -> Result<Update, Diagnostic> {
        let options = &self.options;
        let domain = domain_for(problem, self.patch(), bindings)?;
        let is_same_equation = self.decomposition.is_specialised_to(bindings.as_slice());
        // The first choice of `auto` does not depend on numbers otherwise.
        let may_change = self.choice.is_automatic && !self.choice.notes.is_empty();
        let is_same_method = || -> Result<bool, Diagnostic> {
            let again = choose(&self.decomposition, (bindings, &domain), options)?;
            Ok(again.method.name() == self.choice.method.name())
        };
        if is_same_equation && (!may_change || is_same_method()?) {
            return Ok(Update::Numbers(domain));
        }
        Ok(Update::Anew(Box::new(Prepared::new(problem, bindings, self.decomposition.clone(), options)?)))
    }

    /// The patch.
    #[must_use]
    pub fn patch(&self) -> &Patch {
        &self.decomposition.patch
    }

    /// Solves at instant `t`, deformations included.
    ///
    /// # Errors
    /// As [`Solver::solve`]; [`Code::RegionDoesNotFit`] for a deformation outside the domain.
    pub fn solve(&self, bindings: &Bindings, t: f64) -> Result<Solution, Diagnostic> {
        self.deformed(self.solve_plain(bindings, t)?, bindings)
    }

    fn solve_plain(&self, bindings: &Bindings, t: f64) -> Result<Solution, Diagnostic> {
        let (params, ranges) = (bindings.as_slice(), [self.domain.u, self.domain.v]);
        // A panic elsewhere leaves either the one or the other.
        let lock = || self.everlasting.lock().unwrap_or_else(PoisonError::into_inner);
        let known =
            lock().as_ref().filter(|(of, over, _)| of == params && *over == ranges).map(|known| known.2.clone());
        if let Some(solution) = known {
            return Ok(solution);
        }
        let mut solution = self.solver.solve(params, ranges, t)?;
        solution.report.warnings.splice(0..0, self.choice.notes.iter().cloned());
        if self.solver.is_everlasting(&solution) {
            *lock() = Some((params.to_vec(), ranges, solution.clone()));
        }
        Ok(solution)
    }

    /// Solves at instant `t`, measures the solution, and refuses one that is not what its method promises: a surface
    /// that misses its boundary, or an exact one that misses its equation.
    ///
    /// # Errors
    /// As [`Solver::solve`] and [`verify`](crate::verify::verify); [`Code::PromiseBroken`] with what was measured.
    pub fn solve_judged(
        &self,
        problem: &Problem,
        bindings: &Bindings,
        t: f64,
    ) -> Result<(Solution, Verification), Diagnostic> {
        let plain = self.solve_plain(bindings, t);
        if plain.is_err() {
            // A method may fail for a pole; what is at fault is the function.
            refuse_poles(problem, self.patch(), (bindings, &self.domain, t))?;
        }
        let mut plain = plain?;
        let measured = self.verify(problem, bindings, &plain, t)?;
        self.judge(problem, &plain, &measured)?;
        let residual = measured.relative_residual();
        // Corners of four sides keep a residual that says nothing of the surface (docs/methods.md).
        let is_two_sided = self.patch().side_conditions.is_empty();
        if self.choice.is_automatic && is_two_sided && residual > LARGE_RESIDUAL {
            plain.report.warnings.push(self.large_residual(&plain, residual, t));
        }
        let is_known = plain.report.warnings.iter().any(|warning| warning.code == Code::SeamOpens);
        let orders: Vec<usize> = self.patch().conditions.iter().map(|condition| condition.order).collect();
        if is_two_sided
            && !is_known
            && let Some(gap) = find_opening(&*plain.surface, &self.domain, &orders, t)?
        {
            plain.report.warnings.push(self.opened(gap, t));
        }
        if !is_two_sided && let Some(place) = find_fold(&*plain.surface, (&self.domain, t), self.patch().is_of_loop)? {
            plain.report.warnings.push(self.folded(place, t));
        }
        if self.bumps.is_empty() {
            return Ok((plain, measured));
        }
        check_deformations(problem, self.patch(), (bindings, t), measured.size)?;
        let solution = self.deformed(plain, bindings)?;
        let measured = self.verify(problem, bindings, &solution, t)?;
        let miss = measured.boundary_error() - announced(&solution);
        if miss <= LARGEST_MISS * self.scale(problem, &measured) {
            return Ok((solution, measured));
        }
        let message = format!("a deformation changes the boundary by {miss:.1e}");
        let origin = self.patch().deformations.iter().find_map(|deformation| deformation.origin);
        Err(Diagnostic::new(Code::RegionDoesNotFit, message)
            .at(origin)
            .hint("end its region inside the patch, or keep C1 where position and tangent are prescribed"))
    }

    /// The solution with its deformations, which do not satisfy the equation.
    fn deformed(&self, solution: Solution, bindings: &Bindings) -> Result<Solution, Diagnostic> {
        if self.bumps.is_empty() {
            return Ok(solution);
        }
        let ranges = [self.domain.u, self.domain.v];
        let surface = DeformedSurface::new(solution.surface, &self.bumps, bindings.as_slice(), ranges)?;
        let report = Report { is_exact: false, ..solution.report };
        Ok(Solution { surface: Arc::new(surface), report })
    }

    /// Refuses a solution that is not what its method promises.
    fn judge(&self, problem: &Problem, solution: &Solution, measured: &Verification) -> Result<(), Diagnostic> {
        let miss = (measured.boundary_error() - announced(solution)) / self.scale(problem, measured);
        let residual = if solution.report.is_exact { measured.relative_residual() } else { 0.0 };
        // Written so that NaN is refused.
        if miss <= LARGEST_MISS && residual <= LARGEST_EXACT_RESIDUAL {
            return Ok(());
        }
        let message = if miss <= LARGEST_MISS {
            format!("the solution misses the equation by {residual:.1e} of its largest term, so it is not exact")
        } else {
            format!("the solution misses its boundary by {:.1e}", measured.boundary_error())
        };
        let origin = self.patch().boundary_origin();
        Err(Diagnostic::new(Code::PromiseBroken, message).at(origin).hint(
            "constraints that are nearly dependent, coefficients of very different sizes, or polynomials multiplied out about a \
             point far from v = 0 leave too few digits; powers such as `(v - 10)^6` keep them",
        ))
    }

    /// What a miss of the boundary is compared with: the size of the data, since a surface that explodes would excuse
    /// itself. A force gives the surface a size that the data do not have.
    fn scale(&self, problem: &Problem, measured: &Verification) -> f64 {
        let is_given_by_data = self.patch().operator.is_homogeneous(&problem.graph);
        let scale = if is_given_by_data { measured.data_size } else { measured.data_size.max(measured.size) };
        if scale > 0.0 { scale } else { 1.0 }
    }

    fn opened(&self, gap: f64, t: f64) -> Diagnostic {
        let [from, to] = self.domain.v.map(Shortest);
        let message = format!(
            "the trimlines close, the surface between them does not: v = {from} and v = {to} lie up to {gap:.1e} apart at t = {}",
            Shortest(t)
        );
        Diagnostic::new(Code::SeamOpens, message)
            .at(self.patch().operator.origin.or(self.patch().boundary_origin()))
            .hint("what is not periodic in v tears it: a force, coefficients, or data that close only as the sum of functions that do not; state these periodic, or end the range of v earlier to leave it open")
    }

    fn large_residual(&self, solution: &Solution, residual: f64, t: f64) -> Diagnostic {
        let method = solution.report.method;
        let message = format!(
            "the surface meets its boundary but not its equation: `{method}` leaves {residual:.1e} of the largest term at t = {}",
            Shortest(t)
        );
        let help = match &solution.report.limit {
            Some(limit) => format!("{}: `--limits` raises it, and smoother data or coefficients need fewer terms", limit.message),
            None => "more terms, smoother data or coefficients may help; a method that is named in `solve` is taken as it is".to_owned(),
        };
        Diagnostic::new(Code::LargeResidual, message)
            .at(self.patch().operator.origin.or(self.patch().boundary_origin()))
            .hint(help)
    }

    fn folded(&self, [u, v]: [f64; 2], t: f64) -> Diagnostic {
        let (name, t) = (&self.patch().name, Shortest(t));
        let message = format!("`{name}` folds back over itself near u = {u:.3}, v = {v:.3} at t = {t}");
        let advice = match self.patch().is_of_loop {
            true => "divide the loop by an edge from the corner that is wider than 180 degrees",
            false => "point the tangents at its sides into the patch",
        };
        Diagnostic::new(Code::PatchFolded, message).at(self.patch().boundary_origin()).hint(advice)
    }

    /// Measures a solution at instant `t` against the problem.
    ///
    /// # Errors
    /// As [`verify`](crate::verify::verify).
    pub fn verify(
        &self,
        problem: &Problem,
        bindings: &Bindings,
        solution: &Solution,
        t: f64,
    ) -> Result<Verification, Diagnostic> {
        // New values of params leave the expressions of a patch where they are in the graph.
        let programs = self.programs.get_or_init(|| Programs::compile(&problem.graph, self.patch()));
        let surface = &*solution.surface;
        let measured = verify_with(programs, problem, self.patch(), surface, (bindings, &self.domain, t))?;
        // What a series leaves out at a jump or a kink may lie between the points of any grid.
        let places = solution.report.truncation.as_ref().map_or(&[][..], |truncation| &truncation.places);
        measured.also_at(programs, problem, self.patch(), surface, (bindings, t), places)
    }
}
