//! Source, target, and the frames between them, solved.

use std::collections::BTreeMap;
use std::sync::Arc;

use trimline::diagnostic::{Code, Diagnostic, Diagnostics};
use trimline::method::Settings;
use trimline::morph::{Frame, Kind, Sequence, WeightedSurface, distance, ends, interpolate};
use trimline::problem::{Bindings, SolveRequest};
use trimline::surface::{PlacedSurface, Surface};
use trimline::tessellate::{Field, Grid, Mesh, Scene, curvatures, tessellate};
use trimline::verify::residuals;

use crate::failure::Failure;
use crate::options::{Solving, option_finding};
use crate::parts::{Located, Part};
use crate::scenes::Quantity;
use crate::workflow::{Patched, Spec, select};

/// The method whose modes a morph takes away and adds.
const SERIES: &str = "fourier";

/// The surfaces of all parts at one frame.
pub type Surfaces = Vec<Arc<dyn Surface + Send + Sync>>;

/// What a patch of the problem between is prepared for.
type Preparation = (usize, Option<usize>);

/// Two shapes and the problem between them.
pub struct Shapes<'a> {
    /// The problem between; its places are those of the source.
    pub spec: Spec,
    /// The source's patches, then the nets and copies that come along.
    pub parts: Vec<Part>,
    /// The instant.
    pub time: f64,
    /// N_s and N_t.
    pub modes: [usize; 2],
    /// What is to be said about source and target, and in which text.
    pub warnings: [(Spec, Diagnostics); 2],
    ends: [Surfaces; 2],
    solving: &'a Solving,
    prepared: BTreeMap<Preparation, Patched>,
}

/// Two specs, or one that states a morph, and what it states.
pub struct Pair {
    ends: [Spec; 2],
    pub kind: Kind,
    pub steps: Option<usize>,
}

impl Pair {
    /// Reads both specs, or the one that stands alone.
    pub fn read(source: &str, target: Option<&str>, solving: &Solving) -> Result<Pair, Failure> {
        match target {
            Some("-") if source == "-" => {
                Err(Failure::Usage("source and target cannot both come from standard input".to_owned()))
            }
            Some(target) => {
                let ends = [Spec::read(source, &solving.reading)?, Spec::read(target, &solving.reading)?];
                for spec in &ends {
                    spec.without_nets("morph")?;
                    spec.without_copies("morph")?;
                }
                Ok(Pair { ends, kind: Kind::Boundary, steps: None })
            }
            None => Pair::of(&Spec::read_whole(source, &solving.reading)?, solving.reading.patch.as_deref()),
        }
    }

    /// The ends of the morph that a spec states; of the patch `only` alone, if there is one.
    fn of(spec: &Spec, only: Option<&str>) -> Result<Pair, Failure> {
        let (Some(ends), Some(request)) = (ends(&spec.problem), &spec.problem.morph) else {
            let message = "the spec states no `morph from A to B`: name a second spec, or two of its patches";
            return Err(Failure::Usage(message.to_owned()));
        };
        refuse_copies_of_targets(spec, only)?;
        let [source, target] = ends.map(|problem| {
            let (patches, nets, copies) = select(&problem, only)?;
            let spec = Spec { problem, patches, nets, copies, warnings: Diagnostics::new(), ..spec.clone() };
            if spec.patches.is_empty() {
                spec.without_nets("morph")?;
                spec.without_copies("morph")?;
            }
            Ok::<Spec, Failure>(spec)
        });
        let mut source = source?;
        source.warnings.clone_from(&spec.warnings);
        Ok(Pair { ends: [source, target?], kind: request.kind.unwrap_or(Kind::Boundary), steps: request.steps })
    }
}

/// In no frame there is a target of its own that its copies could follow.
fn refuse_copies_of_targets(spec: &Spec, only: Option<&str>) -> Result<(), Failure> {
    let pairs = spec.problem.morph.iter().flat_map(|request| &request.pairs);
    let (_, _, copies) = select(&spec.problem, only)?;
    let found = copies.iter().find_map(|copy| Some((copy, pairs.clone().find(|[_, to]| *to == copy.original)?)));
    let Some((copy, [source, target])) = found else { return Ok(()) };
    let [source, target] = [source, target].map(|index| spec.problem.part_name(*index).unwrap_or_default());
    let message = format!("`{}` is a copy of `{target}`, which is what the morph makes of `{source}`", copy.name);
    let finding = Diagnostic::new(Code::UnsupportedByMethod, message).at(copy.origin);
    Err(spec.fault(finding.hint(format!("copy `{source}`: its copies follow it; or choose it with --patch {source}"))))
}

/// One shape, solved as its spec asks.
struct End {
    spec: Spec,
    parts: Vec<Part>,
    surfaces: Surfaces,
    modes: usize,
    warnings: Diagnostics,
    time: f64,
}

impl<'a> Shapes<'a> {
    pub fn of(pair: Pair, kind: Kind, solving: &'a Solving) -> Result<Shapes<'a>, Failure> {
        let [source, target] = pair.ends;
        let source = End::solve(source, kind, solving)?;
        let target = End::solve(target, kind, solving)?;
        let interpolated = interpolate(&source.spec.problem, &target.spec.problem, &source.spec.limits);
        let mut problem = interpolated.map_err(|finding| source.spec.fault(finding))?;
        if kind != Kind::Boundary {
            // Each frame has its own number of modes, and no remainder.
            let solve = SolveRequest { method: Some(SERIES.to_owned()), ..SolveRequest::default() };
            problem.patches.iter_mut().for_each(|patch| patch.solve = solve.clone());
        }
        let bindings = Bindings::evaluate(&problem).map_err(|finding| source.spec.fault(finding))?;
        let patches = problem.patches.clone();
        let spec = Spec { problem, bindings, patches, warnings: Diagnostics::new(), ..source.spec.clone() };
        Ok(Shapes {
            spec,
            parts: source.parts,
            time: source.time,
            modes: [source.modes, target.modes],
            warnings: [(source.spec, source.warnings), (target.spec, target.warnings)],
            ends: [source.surfaces, target.surfaces],
            solving,
            prepared: BTreeMap::new(),
        })
    }

    /// Frame number `index` of the sequence; 0 is the source, M + 1 the target.
    pub fn surfaces(&mut self, sequence: &Sequence, index: usize) -> Result<Surfaces, Failure> {
        let [source, target] = &self.ends;
        match index {
            0 => Ok(source.clone()),
            _ if index > sequence.steps() => Ok(target.clone()),
            _ => self.between(sequence.frame(index)),
        }
    }

    /// A frame between the shapes.
    pub fn between(&mut self, frame: Frame) -> Result<Surfaces, Failure> {
        let here = self.at(frame.epsilon)?;
        let mut surfaces = Surfaces::new();
        for patch in 0..self.spec.patches.len() {
            let mut parts: Vec<(f64, Arc<dyn Surface + Send + Sync>)> = Vec::new();
            for (weight, modes) in numbers_of_modes(frame.modes) {
                let time = self.time;
                let solution = here.solve(self.prepare((patch, modes))?, time)?.solution;
                parts.push((weight, solution.surface));
            }
            surfaces.push(Arc::new(WeightedSurface { parts }));
        }
        for (index, part) in self.parts.iter().enumerate().skip(surfaces.len()) {
            let missing = || Failure::Machine(format!("`{}` comes along with nothing", part.name()));
            let surface: Arc<dyn Surface + Send + Sync> = match part {
                Part::Copy(copied) => {
                    let original = self.original(part).and_then(|original| surfaces.get(original));
                    let original = Arc::clone(original.ok_or_else(missing)?);
                    let placement = Arc::clone(&copied.placement);
                    Arc::new(PlacedSurface::new(original, placement, self.source().bindings.as_slice()))
                }
                // The same in both shapes.
                _ => Arc::clone(self.ends[0].get(index).ok_or_else(missing)?),
            };
            surfaces.push(surface);
        }
        Ok(surfaces)
    }

    /// The place among the parts of what a part is a copy of.
    fn original(&self, part: &Part) -> Option<usize> {
        let Part::Copy(copied) = part else { return None };
        self.parts.iter().position(|known| known.name() == copied.original.name())
    }

    /// The spec of the source, with the numbers of its copies' placements.
    fn source(&self) -> &Spec {
        &self.warnings[0].0
    }

    fn prepare(&mut self, key: Preparation) -> Result<&Patched, Failure> {
        let (patch, modes) = key;
        let missing = || Failure::Machine("a patch of the morph is missing".to_owned());
        if !self.prepared.contains_key(&key) {
            let patch = self.spec.patches.get(patch).ok_or_else(missing)?;
            let patched = match modes {
                None => self.spec.prepare(patch, self.solving, None)?,
                Some(_) => {
                    let settings = Settings {
                        modes: modes.map(|modes| (modes, None)),
                        remainder: Some((false, None)),
                        ..Settings::default()
                    };
                    let method = Some(SERIES.to_owned());
                    self.spec.prepare_with(patch, method, settings, |finding| self.spec.fault(finding))?
                }
            };
            self.prepared.insert(key, patched);
        }
        self.prepared.get(&key).ok_or_else(missing)
    }

    /// The largest distance between two frames.
    pub fn step(&self, first: &Surfaces, second: &Surfaces) -> Result<f64, Failure> {
        let mut largest = 0.0_f64;
        for ((first, second), part) in first.iter().zip(second).zip(&self.parts) {
            let ranges = [part.domain().u, part.domain().v];
            let step = distance(&**first, &**second, ranges, self.time).map_err(|finding| self.spec.fault(finding))?;
            largest = largest.max(step);
        }
        Ok(largest)
    }

    /// A frame as meshes, shown at instant `shown` of its file, and what is to be said about them.
    pub fn scene(
        &self,
        surfaces: &Surfaces,
        (grid, quantity): (Grid, Option<Quantity>),
        epsilon: f64,
        shown: f64,
    ) -> Result<(Scene, Diagnostics), Failure> {
        let (mut meshes, mut warnings) = (Vec::new(), Diagnostics::new());
        for (index, (surface, part)) in surfaces.iter().zip(&self.parts).enumerate() {
            let ranges = (part.domain().u, part.domain().v);
            let tessellated = tessellate(part.name(), &**surface, ranges, self.time, grid);
            let (mut mesh, notes) = tessellated.map_err(|finding| self.spec.fault(finding))?;
            // A copy has the residual of its original, point by point.
            let solved = self.original(part).unwrap_or(index);
            let of = surfaces.get(solved).unwrap_or(surface);
            mesh.fields = self.fields(quantity, (&**surface, solved, &**of), epsilon, &mesh)?;
            if let Part::Copy(copied) = part {
                let is_reflection = copied.placement.is_reflection(self.source().bindings.as_slice(), self.time);
                if is_reflection.map_err(|finding| self.source().fault(finding))? {
                    mesh = mesh.turned();
                }
            }
            meshes.push(mesh);
            warnings.extend(notes);
        }
        Ok((Scene { meshes, time: shown }, warnings))
    }

    /// The numbers at the vertices of `surface`, which was `solved` as the patch of that number, whose equation is that
    /// between the shapes; the residual of a net says nothing.
    fn fields(
        &self,
        quantity: Option<Quantity>,
        (surface, index, solved): (&dyn Surface, usize, &dyn Surface),
        epsilon: f64,
        mesh: &Mesh,
    ) -> Result<Vec<Field>, Failure> {
        let fields = match quantity {
            None => Ok(Vec::new()),
            Some(Quantity::Curvature) => curvatures(surface, mesh, self.time).map(Vec::from_iter),
            Some(Quantity::Residual) => {
                let here = self.at(epsilon)?;
                let Some(patch) = here.patches.get(index) else {
                    return Ok(vec![Field { name: "residual", values: vec![f64::NAN; mesh.positions.len()] }]);
                };
                let (u, v) = mesh.axes();
                let points = (u.as_slice(), v.as_slice(), self.time);
                let values = residuals(&here.problem, patch, solved, &here.bindings, points);
                values.map(|values| vec![Field { name: "residual", values }])
            }
        };
        fields.map_err(|finding| self.spec.fault(finding))
    }

    /// The problem between, at a weight of the target.
    fn at(&self, epsilon: f64) -> Result<Spec, Failure> {
        self.spec.with(&[format!("{}={epsilon:?}", trimline::morph::EPSILON)])
    }
}

impl End {
    fn solve(mut spec: Spec, kind: Kind, solving: &Solving) -> Result<End, Failure> {
        if solving.method.is_some() {
            spec.patches.iter_mut().for_each(|patch| patch.solve = SolveRequest::default());
        }
        spec.problem.patches.clone_from(&spec.patches);
        let parts = spec.parts(solving, None)?;
        let time = spec.instant(&parts, solving.time)?;
        let (mut surfaces, mut modes, mut warnings) = (Surfaces::new(), 0, spec.warnings.clone());
        for part in &parts {
            let Part::Patch(patch) = part else {
                let shape = spec.shape(part, time)?;
                warnings.extend(shape.warnings);
                surfaces.push(shape.surface);
                continue;
            };
            let solution = spec.solve(patch, time)?.solution;
            let report = solution.report;
            if kind != Kind::Boundary && report.method != SERIES {
                let name = &patch.prepared.patch().name;
                let message = format!(
                    "a morph by modes needs `{SERIES}`, and the patch `{name}` is solved by `{}`",
                    report.method
                );
                let origin = patch.prepared.patch().solve.origin;
                let finding = Diagnostic::new(Code::UnsupportedByMethod, message).at(origin);
                return Err(
                    spec.fault(finding.hint(format!("write `solve {SERIES}` in both specs, or add --method {SERIES}")))
                );
            }
            modes = modes.max(report.modes);
            warnings.extend(report.warnings);
            surfaces.push(solution.surface);
        }
        Ok(End { spec, parts, surfaces, modes, warnings, time })
    }
}

/// A number of modes between two whole ones as those two, with weights.
fn numbers_of_modes(modes: Option<f64>) -> Vec<(f64, Option<usize>)> {
    let Some(modes) = modes else { return vec![(1.0, None)] };
    let below = modes.max(0.0).floor();
    let share = modes - below;
    // Numbers of modes are far below 2^32, by the limit `modes`.
    let parts = [(1.0 - share, below), (share, below + 1.0)];
    parts.into_iter().filter(|(weight, _)| *weight > 0.0).map(|(weight, n)| (weight, Some(n as usize))).collect()
}

/// A finding about an option's number.
pub fn about<T: std::fmt::Display>(option: &str, value: Option<T>, finding: Diagnostic) -> Failure {
    match value {
        Some(value) => option_finding(option, &value.to_string(), finding),
        None => Failure::Found { source: None, findings: vec![finding] },
    }
}
