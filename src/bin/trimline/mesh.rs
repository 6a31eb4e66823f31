//! `trimline mesh`: surface meshes at one instant or over time.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use trimline::diagnostic::{Code, Diagnostic};
use trimline::export::{Format, write};
use trimline::surface::SymbolicSurface;
use trimline::tessellate::{Grid, Scene, instants, tessellate};

use crate::Outcome;
use crate::failure::{Failure, print_warnings, say};
use crate::options::{Collocation, Solving, Terminal, option_finding, read_grid};
use crate::output::Files;
use crate::workflow::{Patched, Spec, common_times};

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// The file; its extension is the format (obj, ply, stl). With --frames, each file gets its number.
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,

    /// Quads across (u) and along (v).
    #[arg(long, value_name = "NUxNV", default_value = "64x128")]
    grid: String,

    /// Also the primary surfaces, each as an object of its own.
    #[arg(long)]
    with_surfaces: bool,

    /// As many instants over the time domain, both ends included, a file each.
    #[arg(long, value_name = "N", conflicts_with = "time")]
    frames: Option<usize>,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let format = format_of(&arguments.output)?;
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let (u_cells, v_cells) = read_grid(&arguments.grid)?;
    let grid = Grid::new(u_cells, v_cells, &spec.limits)
        .map_err(|finding| option_finding("grid", &arguments.grid, finding))?;
    let patched: Vec<Patched> = spec
        .patches
        .iter()
        .map(|patch| spec.prepare(patch, &arguments.solving, arguments.collocation.points.as_deref()))
        .collect::<Result<_, _>>()?;
    let times = times(arguments, &spec, &patched)?;
    let progress = progress(times.len(), terminal);
    let mut files = Files::default();
    let (mut vertices, mut quads) = (0, 0);
    for (index, &time) in times.iter().enumerate() {
        let path =
            if arguments.frames.is_some() { numbered(&arguments.output, index) } else { arguments.output.clone() };
        let mut scene = scene(&spec, &patched, grid, time, (index == 0, terminal))?;
        if arguments.with_surfaces {
            add_surfaces(&mut scene, &spec, &patched, grid)?;
        }
        vertices = scene.meshes.iter().map(|mesh| mesh.positions.len()).sum();
        quads = scene.meshes.iter().map(|mesh| mesh.quads.len()).sum();
        let notes = write(&scene, format, files.create(&path)?)
            .map_err(|error| Failure::Found { source: None, findings: vec![error.to_diagnostic()] })?;
        if index == 0 {
            print_warnings(&notes, &spec.source, terminal);
        }
        progress.inc(1);
    }
    files.keep()?;
    progress.finish_and_clear();
    if !terminal.quiet {
        let what = match (times.as_slice(), arguments.frames) {
            ([_, _, ..], Some(_)) => format!(
                "{} to {}",
                numbered(&arguments.output, 0).display(),
                numbered(&arguments.output, times.len().saturating_sub(1)).display()
            ),
            ([time], None) => format!("{} at t = {time}", arguments.output.display()),
            _ => numbered(&arguments.output, 0).display().to_string(),
        };
        say(&format!("wrote {what}: {vertices} vertices, {quads} quads"));
    }
    Ok(())
}

fn format_of(path: &Path) -> Result<Format, Failure> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().into_owned()).unwrap_or_default();
    Format::from_extension(&extension).ok_or_else(|| {
        let known: Vec<String> = Format::ALL.iter().map(|format| format!(".{}", format.extension())).collect();
        let what =
            if extension.is_empty() { "no extension".to_owned() } else { format!("the extension `.{extension}`") };
        Failure::Usage(format!("`{}` has {what}; write {}", path.display(), known.join(", ")))
    })
}

/// The instants to mesh: at all of them every patch has a shape.
fn times(arguments: &Arguments, spec: &Spec, patched: &[Patched]) -> Result<Vec<f64>, Failure> {
    let range = common_times(patched).ok_or_else(|| {
        let finding = Diagnostic::new(Code::EmptyDomain, "no instant lies in the time domain of every patch");
        spec.fault(finding.hint("choose patches with --patch, or state one `domain t in [..]` for all"))
    })?;
    match arguments.frames {
        None => match arguments.solving.time {
            None => Ok(vec![range[0]]),
            time => {
                let times: Vec<f64> = patched.iter().map(|patch| patch.instant(time)).collect::<Result<_, _>>()?;
                Ok(times.into_iter().take(1).collect())
            }
        },
        Some(frames) => instants(range, frames, &spec.limits)
            .map_err(|finding| option_finding("frames", &frames.to_string(), finding)),
    }
}

fn scene(
    spec: &Spec,
    patched: &[Patched],
    grid: Grid,
    time: f64,
    (is_first, terminal): (bool, &Terminal),
) -> Result<Scene, Failure> {
    let mut meshes = Vec::new();
    for patch in patched {
        let solved = spec.solve(patch, time)?;
        let ranges = (patch.prepared.domain.u, patch.prepared.domain.v);
        let (mesh, notes) = tessellate(&patch.prepared.patch().name, &*solved.solution.surface, ranges, time, grid)
            .map_err(|finding| spec.fault(finding))?;
        if is_first {
            print_warnings(&solved.solution.report.warnings, &spec.source, terminal);
            print_warnings(&notes, &spec.source, terminal);
        }
        meshes.push(mesh);
    }
    Ok(Scene { meshes, time })
}

/// Adds the primary surfaces over their stated ranges; over those of the first patch where none is stated.
fn add_surfaces(scene: &mut Scene, spec: &Spec, patched: &[Patched], grid: Grid) -> Result<(), Failure> {
    let Some(first) = patched.first() else { return Ok(()) };
    let constant = |expr| {
        let value = spec.bindings.constant(&spec.problem, expr, None, "the range of a surface's parameter");
        value.map_err(|finding| spec.fault(finding))
    };
    for primary in &spec.problem.surfaces {
        let mut ranges = [first.prepared.domain.u, first.prepared.domain.v];
        for (range, stated) in ranges.iter_mut().zip(primary.ranges) {
            if let Some([low, high]) = stated {
                *range = [constant(low)?, constant(high)?];
            }
        }
        let surface = SymbolicSurface::new(&spec.problem, primary, &spec.bindings, &spec.limits);
        let mesh = tessellate(&primary.name, &surface, ranges.into(), scene.time, grid);
        let (mesh, _) = mesh.map_err(|finding| spec.fault(finding.at(primary.origin)))?;
        scene.meshes.push(mesh);
    }
    Ok(())
}

/// `blend.obj` as `blend.0007.obj`.
fn numbered(path: &Path, index: usize) -> PathBuf {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    path.with_extension(format!("{index:04}.{extension}"))
}

/// A bar on long work, on a terminal only.
fn progress(frames: usize, terminal: &Terminal) -> ProgressBar {
    if terminal.quiet || frames < 2 || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} frames, {eta} left");
    let bar = ProgressBar::new(u64::try_from(frames).unwrap_or(u64::MAX));
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
