//! Scenes of a spec at its instants: what `mesh` writes and `render` draws.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use trimline::diagnostic::{Code, Diagnostic, Diagnostics};
use trimline::surface::{Surface, SymbolicSurface};
use trimline::tessellate::{Field, Grid, Mesh, Role, Scene, curvatures, instants, tessellate};
use trimline::threads;
use trimline::verify::residuals;

use crate::failure::{Failure, Said, print_warnings};
use crate::options::{Collocation, Solving, Terminal, option_finding, read_count, read_grid};
use crate::parts::{Located, Part};
use crate::workflow::Spec;

/// What to solve, and into how many quads to cut it.
#[derive(Args)]
pub struct Meshing {
    #[command(flatten)]
    pub solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// Quads across (u) and along (v).
    #[arg(long, value_name = "NUxNV", default_value = "64x128", allow_hyphen_values = true)]
    grid: String,

    /// As many instants over the time domain, both ends included.
    #[arg(long, value_name = "N", value_parser = read_count, conflicts_with = "time")]
    pub frames: Option<usize>,

    /// Also the primary surfaces, each as an object of its own.
    #[arg(long)]
    with_surfaces: bool,
}

/// Numbers at the vertices.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Quantity {
    /// Gaussian and mean curvature.
    Curvature,
    /// Residual of the equation over its largest term.
    Residual,
}

/// A spec, ready to be meshed at any instant.
pub struct Scenes {
    pub spec: Spec,
    parts: Vec<Part>,
    grid: Grid,
    quantities: Vec<Quantity>,
    with_surfaces: bool,
}

impl Scenes {
    pub fn read(path: &str, meshing: &Meshing, quantities: &[Quantity]) -> Result<Scenes, Failure> {
        let spec = Spec::read(path, &meshing.solving.reading)?;
        let (u_cells, v_cells) = read_grid(&meshing.grid)?;
        let grid = Grid::new(u_cells, v_cells, &spec.limits)
            .map_err(|finding| option_finding("grid", &meshing.grid, finding))?;
        let points = meshing.collocation.points.as_deref();
        let parts = spec.parts(&meshing.solving, points)?;
        Ok(Scenes { spec, parts, grid, quantities: quantities.to_vec(), with_surfaces: meshing.with_surfaces })
    }

    /// As many instants as `frames` over the time domain, or the one that the user asked for; at all of them every patch
    /// has a shape.
    pub fn times(&self, frames: Option<usize>, time: Option<f64>) -> Result<Vec<f64>, Failure> {
        match frames {
            None => Ok(vec![self.spec.instant(&self.parts, time)?]),
            Some(frames) => instants(self.spec.times(&self.parts)?, frames, &self.spec.limits)
                .map_err(|finding| option_finding("frames", &frames.to_string(), finding)),
        }
    }

    /// What is to be seen at one instant, and what there is to say about each part.
    pub fn at(&self, time: f64) -> Result<Seen, Failure> {
        let meshes = threads::try_map(self.parts.iter().collect(), |part| self.mesh(part, time))?;
        let (meshes, warnings) = meshes.into_iter().unzip();
        let mut scene = Scene { meshes, time };
        if self.with_surfaces {
            self.add_surfaces(&mut scene)?;
        }
        Ok(Seen { scene, warnings })
    }

    fn mesh(&self, part: &Part, time: f64) -> Result<(Mesh, Diagnostics), Failure> {
        let shape = self.spec.shape(part, time)?;
        let ranges = (part.domain().u, part.domain().v);
        let (mut mesh, notes) = tessellate(part.name(), &*shape.surface, ranges, time, self.grid)
            .map_err(|finding| self.spec.fault(finding))?;
        mesh.fields = self.fields(part, &*shape.surface, &mesh, time)?;
        if let Part::Copy(copied) = part {
            let is_reflection = copied.placement.is_reflection(self.spec.bindings.as_slice(), time);
            if is_reflection.map_err(|finding| self.spec.fault(finding))? {
                mesh = mesh.turned();
            }
        }
        Ok((mesh, shape.warnings.into_iter().chain(notes).collect()))
    }

    /// As many scenes at once as there are threads: `times` in groups of that many.
    pub fn groups<'a>(&'a self, times: &'a [f64]) -> impl Iterator<Item = Vec<Result<Seen, Failure>>> + 'a {
        times.chunks(threads::count()).map(move |times| threads::map(times.to_vec(), |time| self.at(time)))
    }

    /// Adds the primary surfaces over their stated ranges; over those of the first patch where none is stated.
    fn add_surfaces(&self, scene: &mut Scene) -> Result<(), Failure> {
        let (Some(first), spec) = (self.parts.first(), &self.spec) else { return Ok(()) };
        for primary in &spec.problem.surfaces {
            let ranges = spec.ranges_of(primary, [first.domain().u, first.domain().v])?;
            let surface = SymbolicSurface::new(&spec.problem, primary, &spec.bindings, &spec.limits);
            let tessellated = tessellate(&primary.name, &surface, ranges.into(), scene.time, self.grid);
            let (mut mesh, _) = tessellated.map_err(|finding| spec.fault(finding.at(primary.origin)))?;
            mesh.role = Role::Primary;
            mesh.fields = self.fields_of_given(&surface, &mesh, scene.time).map_err(|finding| spec.fault(finding))?;
            scene.meshes.push(mesh);
        }
        Ok(())
    }

    /// The fields that patches have; a given surface has no residual, and that of a net says nothing.
    fn fields_of_given(&self, surface: &dyn Surface, mesh: &Mesh, time: f64) -> Result<Vec<Field>, Diagnostic> {
        let mut fields = Vec::new();
        for quantity in &self.quantities {
            match quantity {
                Quantity::Curvature => fields.extend(curvatures(surface, mesh, time)?),
                Quantity::Residual => {
                    fields.push(Field { name: "residual", values: vec![f64::NAN; mesh.positions.len()] });
                }
            }
        }
        Ok(fields)
    }

    /// All instants with one topology, for an animation; says what is to be said about them.
    pub fn all(&mut self, times: &[f64], terminal: &Terminal) -> Result<Vec<Scene>, Failure> {
        let mut said = Vec::new();
        let frames = self.frames(times, &mut said, terminal)?;
        let closes = |scene: &Scene| scene.meshes.iter().map(|mesh| mesh.is_closed_in_v).collect::<Vec<_>>();
        if frames.windows(2).all(|pair| matches!(pair, [a, b] if closes(a) == closes(b))) {
            return Ok(frames);
        }
        // A patch that closes on itself at some instants only is left open at all.
        self.grid = self.grid.with_open_seams();
        self.frames(times, &mut said, terminal)
    }

    fn frames(&self, times: &[f64], said: &mut Vec<Said>, terminal: &Terminal) -> Result<Vec<Scene>, Failure> {
        let progress = Progress::new(times.len(), terminal);
        let mut frames = Vec::with_capacity(times.len());
        for seen in self.groups(times).flatten() {
            let Seen { scene, warnings } = seen?;
            if frames.is_empty() {
                self.check_size(&scene, times.len())?;
            }
            print_warnings(&news(said, warnings), &self.spec.source, terminal);
            frames.push(scene);
            progress.advance();
        }
        progress.finish();
        Ok(frames)
    }

    /// Before most of the memory is taken.
    fn check_size(&self, scene: &Scene, frames: usize) -> Result<(), Failure> {
        let vertices = frames.saturating_mul(scene.meshes.iter().map(|mesh| mesh.positions.len()).sum());
        let limit = self.spec.limits.animated_vertices;
        if frames < 2 || vertices <= limit {
            return Ok(());
        }
        let message = format!(
            "{frames} frames in one file have {vertices} vertices, over the limit `animated-vertices` of {limit}"
        );
        let finding = Diagnostic::new(Code::LimitReached, message).hint(
            "ask for fewer frames or a coarser grid, write a format with a file for each frame, or raise the limit",
        );
        Err(option_finding("frames", &frames.to_string(), finding))
    }

    fn fields(&self, part: &Part, surface: &dyn Surface, mesh: &Mesh, time: f64) -> Result<Vec<Field>, Failure> {
        let given = || self.fields_of_given(surface, mesh, time).map_err(|finding| self.spec.fault(finding));
        let (patch, solved) = match part {
            Part::Patch(patch) => (patch, None),
            // A copy has the residual of its original, point by point.
            Part::Copy(copied) => match &copied.original {
                Part::Patch(patch) => (patch, Some(self.spec.shape(&copied.original, time)?.surface)),
                _ => return given(),
            },
            Part::Net(_) => return given(),
        };
        let mut fields = Vec::new();
        for quantity in &self.quantities {
            match quantity {
                Quantity::Curvature => {
                    fields.extend(curvatures(surface, mesh, time).map_err(|finding| self.spec.fault(finding))?);
                }
                Quantity::Residual => {
                    let (u, v) = mesh.axes();
                    let (problem, bindings) = (&self.spec.problem, &self.spec.bindings);
                    let points = (u.as_slice(), v.as_slice(), time);
                    let of = solved.as_deref().map_or(surface, |solved| solved as &dyn Surface);
                    let values = residuals(problem, patch.prepared.patch(), of, bindings, points);
                    let values = values.map_err(|finding| self.spec.fault(finding))?;
                    fields.push(Field { name: "residual", values });
                }
            }
        }
        Ok(fields)
    }
}

/// What is to be seen at one instant.
pub struct Seen {
    pub scene: Scene,
    /// What there is to say about each part.
    pub warnings: Vec<Diagnostics>,
}

/// What was not said of the same parts at earlier instants.
pub fn news(said: &mut Vec<Said>, warnings: Vec<Diagnostics>) -> Diagnostics {
    said.resize_with(warnings.len(), Said::default);
    said.iter_mut().zip(warnings).flat_map(|(said, warnings)| said.news(warnings)).collect()
}

/// A bar on work longer than a second, on a terminal only.
pub struct Progress {
    bar: ProgressBar,
    start: Instant,
}

impl Progress {
    pub fn new(steps: usize, terminal: &Terminal) -> Progress {
        let is_shown = !terminal.quiet && steps > 1 && std::io::stderr().is_terminal();
        let bar = if is_shown { ProgressBar::new(steps as u64) } else { ProgressBar::hidden() };
        bar.set_draw_target(ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} frames, {eta} left") {
            bar.set_style(style);
        }
        Progress { bar, start: Instant::now() }
    }

    pub fn advance(&self) {
        if self.bar.is_hidden() && self.bar.length().is_some() && self.start.elapsed() > Duration::from_secs(1) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(1);
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
