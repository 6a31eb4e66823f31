//! `trimline morph`: the shapes between two specs, or between patches of one (`morph from A to B`).

mod shapes;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic};
use trimline::expr::Derivative;
use trimline::morph::{Frame, Kind, Sequence};
use trimline::tessellate::{Grid, Scene};
use trimline::threads;

use crate::Outcome;
use crate::drawing::{Drawing, is_picture};
use crate::eval::{print_table, read_derivatives, read_table};
use crate::failure::{Failure, print_warnings, say};
use crate::mesh::{Series, format_of, write_animation};
use crate::options::{Format, Solving, Terminal, option_finding, read_count, read_grid};
use crate::output;

use shapes::{Pair, Shapes, Surfaces, about};

#[derive(Args)]
pub struct Arguments {
    /// The spec of the first shape, or `-`; alone, a spec that states `morph from A to B`.
    source: String,

    /// The spec of the last shape: the same patches, equations and places of constraints.
    target: Option<String>,

    #[command(flatten)]
    solving: Solving,

    /// What changes from frame to frame [default: what the spec states, else boundary].
    #[arg(long, value_enum)]
    by: Option<By>,

    /// Frames between source and target [default: what the spec states, else 9; with modes as many as both have, with
    /// both one more].
    #[arg(long, value_name = "M", value_parser = read_count)]
    steps: Option<usize>,

    /// One frame: 0 is the source, M + 1 the target.
    #[arg(long, value_name = "I", value_parser = read_count, conflicts_with = "at")]
    frame: Option<usize>,

    /// One frame by the weight of the target, from 0 to 1.
    #[arg(long, value_name = "EPS")]
    at: Option<f64>,

    /// Meshes or pictures of all frames, or of one, by the file's extension; with --points the table.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Quads across (u) and along (v).
    #[arg(long, value_name = "NUxNV", default_value = "64x128", allow_hyphen_values = true)]
    grid: String,

    #[command(flatten)]
    drawing: Drawing,

    /// A CSV file with a header that names u, v and, with several patches, patch; needs --frame or --at.
    #[arg(long, value_name = "FILE")]
    points: Option<String>,

    /// Derivatives to add to the table, for example `u,v,uu`.
    #[arg(long, value_delimiter = ',', value_name = "LIST", requires = "points")]
    derivatives: Vec<String>,

    /// How to print the report.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
enum By {
    /// The boundary data, in equal steps.
    Boundary,
    /// The number of Fourier modes: down to one of the source, then up from one of the target.
    Modes,
    /// Both at once.
    Both,
}

impl By {
    fn of(kind: Kind) -> By {
        match kind {
            Kind::Boundary => By::Boundary,
            Kind::Modes => By::Modes,
            Kind::Both => By::Both,
        }
    }

    fn kind(self) -> Kind {
        match self {
            By::Boundary => Kind::Boundary,
            By::Modes => Kind::Modes,
            By::Both => Kind::Both,
        }
    }
}

#[derive(Serialize)]
struct Report {
    by: By,
    frames: Vec<FrameReport>,
    /// The largest of all steps.
    largest_step: f64,
    /// The largest step between frames that are neither source nor target.
    largest_inner_step: Option<f64>,
}

#[derive(Serialize)]
struct FrameReport {
    /// The weight of the target.
    epsilon: f64,
    /// The number of modes; null for what the specs ask for.
    modes: Option<f64>,
    /// The largest distance to the frame before; null for the source.
    step: Option<f64>,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let pair = Pair::read(&arguments.source, arguments.target.as_deref(), &arguments.solving)?;
    let kind = arguments.by.map_or(pair.kind, By::kind);
    let steps = arguments.steps.or(pair.steps);
    let mut shapes = Shapes::of(pair, kind, &arguments.solving)?;
    let sequence = Sequence::new(kind, steps, shapes.modes, &shapes.spec.limits)
        .map_err(|finding| about("steps", arguments.steps, finding))?;
    let chosen = chosen(arguments, &sequence, &mut shapes)?;
    for (spec, warnings) in &shapes.warnings {
        print_warnings(warnings, &spec.source, terminal);
    }
    match (chosen, &arguments.points) {
        (Some(frame), Some(points)) => {
            let derivatives = read_derivatives(&arguments.derivatives, shapes.spec.limits.derivative_order)?;
            table(&shapes, &frame.surfaces, (points, &derivatives), arguments.output.as_deref())
        }
        (None, Some(_)) => Err(Failure::Usage("points lie on one surface: choose it with --frame or --at".to_owned())),
        (Some(surfaces), None) => match &arguments.output {
            Some(path) => write(arguments, path, &shapes, &[surfaces], terminal),
            None => Err(Failure::Usage("say what to write of this frame: -o FILE, or --points FILE".to_owned())),
        },
        (None, None) => all(arguments, &mut shapes, &sequence, terminal),
    }
}

/// The surfaces of the one frame that the user asks for.
fn chosen(arguments: &Arguments, sequence: &Sequence, shapes: &mut Shapes<'_>) -> Result<Option<Framed>, Failure> {
    if let Some(index) = arguments.frame {
        let last = sequence.steps() + 1;
        if index > last {
            let finding = Diagnostic::new(
                Code::SettingOutOfRange,
                format!("there is no frame {index}; the target is frame {last}"),
            );
            return Err(option_finding("frame", &index.to_string(), finding.hint("frame 0 is the source")));
        }
        let surfaces = shapes.surfaces(sequence, index)?;
        return Ok(Some(Framed { epsilon: frame_at(sequence, index).epsilon, surfaces }));
    }
    let Some(epsilon) = arguments.at else { return Ok(None) };
    let frame = at_weight(sequence, "at", epsilon)?;
    Ok(Some(Framed { epsilon, surfaces: shapes.between(frame)? }))
}

/// All frames: the report, and the file if one is wanted.
fn all(arguments: &Arguments, shapes: &mut Shapes<'_>, sequence: &Sequence, terminal: &Terminal) -> Outcome {
    let last = sequence.steps() + 1;
    let mut frames: Vec<Framed> = Vec::with_capacity(last + 1);
    let mut steps = Vec::with_capacity(last);
    for index in 0..=last {
        let surfaces = shapes.surfaces(sequence, index)?;
        if let Some(before) = frames.last() {
            steps.push(shapes.step(&before.surfaces, &surfaces)?);
        }
        frames.push(Framed { epsilon: frame_at(sequence, index).epsilon, surfaces });
    }
    if let Some(path) = &arguments.output {
        write(arguments, path, shapes, &frames, terminal)?;
    }
    let report = report(By::of(sequence.kind()), sequence, &steps);
    match arguments.format {
        Format::Json => output::print_json(&report),
        Format::Text if arguments.output.is_none() => output::print(&text(&report)),
        Format::Text => {
            if !terminal.quiet {
                say(&format!("largest step {:.3e} in {} frames", report.largest_step, frames.len()));
            }
            Ok(())
        }
    }
}

/// Source and target are as their specs ask.
fn frame_at(sequence: &Sequence, index: usize) -> Frame {
    match index {
        0 => Frame { epsilon: 0.0, modes: None },
        _ if index > sequence.steps() => Frame { epsilon: 1.0, modes: None },
        _ => sequence.frame(index),
    }
}

fn report(by: By, sequence: &Sequence, steps: &[f64]) -> Report {
    let last = sequence.steps() + 1;
    let step_to = |index: usize| index.checked_sub(1).and_then(|before| steps.get(before)).copied();
    let frames = (0..=last).map(|index| {
        let Frame { epsilon, modes } = frame_at(sequence, index);
        FrameReport { epsilon, modes, step: step_to(index) }
    });
    let inner = steps.get(1..steps.len().saturating_sub(1)).unwrap_or_default();
    Report {
        by,
        frames: frames.collect(),
        largest_step: steps.iter().copied().fold(0.0, f64::max),
        largest_inner_step: inner.iter().copied().reduce(f64::max),
    }
}

fn text(report: &Report) -> String {
    let mut text = "frame  epsilon  modes  step\n".to_owned();
    for (index, frame) in report.frames.iter().enumerate() {
        let modes = frame.modes.map_or_else(|| "-".to_owned(), |modes| format!("{modes:.3}"));
        let step = frame.step.map_or_else(|| "-".to_owned(), |step| format!("{step:.6}"));
        // Writing to a string does not fail.
        let _ = writeln!(text, "{index:5}  {:7.4}  {modes:>5}  {step}", frame.epsilon);
    }
    let _ = writeln!(text, "largest step {:.6}", report.largest_step);
    text
}

/// Positions and derivatives of one frame at the points of a table.
fn table(
    shapes: &Shapes<'_>,
    surfaces: &Surfaces,
    (points, derivatives): (&str, &[Derivative]),
    output: Option<&Path>,
) -> Outcome {
    let table = read_table(points, Some(shapes.time), &shapes.parts, shapes.spec.limits.samples)?;
    let mut columns = Vec::with_capacity(derivatives.len() + 1);
    for derivative in std::iter::once(Derivative::NONE).chain(derivatives.iter().copied()) {
        let mut column = vec![[0.0; 3]; table.points.len()];
        for (patch, surface) in surfaces.iter().enumerate() {
            let on_patch: Vec<usize> =
                table.patches.iter().enumerate().filter(|(_, of)| **of == patch).map(|(index, _)| index).collect();
            let here: Vec<[f64; 3]> = on_patch.iter().filter_map(|&index| table.points.get(index)).copied().collect();
            let mut values = vec![[0.0; 3]; here.len()];
            surface.evaluate(derivative, &here, &mut values).map_err(|finding| shapes.spec.fault(finding))?;
            for (index, value) in on_patch.iter().zip(&values) {
                if let Some(slot) = column.get_mut(*index) {
                    *slot = *value;
                }
            }
        }
        columns.push(column);
    }
    print_table(&table, derivatives, &columns, output)
}

/// A shape of a spec's own morph at points of a table: what `eval --morph` does.
pub fn evaluate(
    spec: &str,
    solving: &Solving,
    epsilon: f64,
    (points, derivatives): (&str, &[Derivative]),
    output: Option<&Path>,
    terminal: &Terminal,
) -> Outcome {
    let pair = Pair::read(spec, None, solving)?;
    let (kind, steps) = (pair.kind, pair.steps);
    let mut shapes = Shapes::of(pair, kind, solving)?;
    let sequence = Sequence::new(kind, steps, shapes.modes, &shapes.spec.limits)
        .map_err(|finding| about("steps", None::<usize>, finding))?;
    let surfaces = shapes.between(at_weight(&sequence, "morph", epsilon)?)?;
    for (spec, warnings) in &shapes.warnings {
        print_warnings(warnings, &spec.source, terminal);
    }
    table(&shapes, &surfaces, (points, derivatives), output)
}

/// The frame at a weight that the user names by `option`.
fn at_weight(sequence: &Sequence, option: &str, epsilon: f64) -> Result<Frame, Failure> {
    if !(0.0..=1.0).contains(&epsilon) {
        let finding = Diagnostic::new(Code::SettingOutOfRange, format!("{epsilon} lies outside [0, 1]"));
        let finding = finding.hint("0 is the source, 1 the target");
        return Err(option_finding(option, &epsilon.to_string(), finding));
    }
    sequence.at(epsilon).ok_or_else(|| {
        let message = format!("a morph by modes has no weight that --{option} could set");
        Failure::Usage(format!("{message}: choose a frame with `morph … --frame`"))
    })
}

/// The surfaces of a frame, and the weight of the target there.
struct Framed {
    epsilon: f64,
    surfaces: Surfaces,
}

/// Pictures of frames: one, a sheet or an animation.
fn draw(arguments: &Arguments, path: &Path, shapes: &Shapes<'_>, frames: &[Framed], terminal: &Terminal) -> Outcome {
    let (drawing, limits) = (&arguments.drawing, &shapes.spec.limits);
    let style = drawing.style((frames.len() > 1).then_some(frames.len()))?;
    drawing.check(&style, frames.len(), limits)?;
    let scenes = scenes(arguments, shapes, frames, terminal)?;
    drawing.write(path, scenes, (&style, limits), |finding| shapes.spec.fault(finding), terminal)?;
    if !terminal.quiet {
        let what = if drawing.animate { "frames" } else { "pictures" };
        say(&format!("wrote {} with {} {what}", path.display(), frames.len()));
    }
    Ok(())
}

/// Pictures or meshes of frames: one file, or a numbered one each.
fn write(arguments: &Arguments, path: &Path, shapes: &Shapes<'_>, frames: &[Framed], terminal: &Terminal) -> Outcome {
    if is_picture(path) {
        return draw(arguments, path, shapes, frames, terminal);
    }
    let format = format_of(path).map_err(|failure| match failure {
        Failure::Usage(message) => Failure::Usage(format!("{message}, or a picture, .png or .gif")),
        failure => failure,
    })?;
    let scenes = scenes(arguments, shapes, frames, terminal)?;
    let (written, notes) = if format.is_animated() {
        let notes = write_animation(path, format, &scenes)?;
        (path.display().to_string(), notes)
    } else {
        let mut series = Series::new(path, format, scenes.len() > 1);
        let mut notes = Vec::new();
        for scene in &scenes {
            let found = series.add(scene)?;
            if notes.is_empty() {
                notes = found;
            }
        }
        (series.keep()?, notes)
    };
    print_warnings(&notes, &shapes.spec.source, terminal);
    if !terminal.quiet {
        let frames = if scenes.len() == 1 { "1 frame".to_owned() } else { format!("{} frames", scenes.len()) };
        say(&format!("wrote {written} with {frames}"));
    }
    Ok(())
}

/// Meshes of all frames with one topology; time runs from 0 to 1.
fn scenes(
    arguments: &Arguments,
    shapes: &Shapes<'_>,
    frames: &[Framed],
    terminal: &Terminal,
) -> Result<Vec<Scene>, Failure> {
    let limits = &shapes.spec.limits;
    let (u_cells, v_cells) = read_grid(&arguments.grid)?;
    let grid =
        Grid::new(u_cells, v_cells, limits).map_err(|finding| option_finding("grid", &arguments.grid, finding))?;
    let vertices = (u_cells + 1).saturating_mul(v_cells + 1).saturating_mul(shapes.parts.len());
    let vertices = vertices.saturating_mul(frames.len());
    if frames.len() > 1 && vertices > limits.animated_vertices {
        let limit = limits.animated_vertices;
        let message = format!("the frames have {vertices} vertices, over the limit `animated-vertices` of {limit}");
        let finding = Diagnostic::new(Code::LimitReached, message).hint("ask for fewer frames or a coarser grid");
        return Err(option_finding("grid", &arguments.grid, finding));
    }
    let cut = |grid: Grid| -> Result<Vec<(Scene, Vec<Diagnostic>)>, Failure> {
        let share = |index: usize| index as f64 / frames.len().saturating_sub(1).max(1) as f64;
        let quantity = arguments.drawing.quantity();
        let scene = |(index, frame): (usize, &Framed)| {
            shapes.scene(&frame.surfaces, (grid, quantity), frame.epsilon, share(index))
        };
        threads::try_map(frames.iter().enumerate().collect(), scene)
    };
    let mut scenes = cut(grid)?;
    let closes = |scene: &Scene| scene.meshes.iter().map(|mesh| mesh.is_closed_in_v).collect::<Vec<_>>();
    if !scenes.windows(2).all(|pair| matches!(pair, [(a, _), (b, _)] if closes(a) == closes(b))) {
        // A patch that closes on itself in some frames only is left open in all.
        scenes = cut(grid.with_open_seams())?;
    }
    if let Some((_, warnings)) = scenes.iter().find(|(_, warnings)| !warnings.is_empty()) {
        print_warnings(warnings, &shapes.spec.source, terminal);
    }
    Ok(scenes.into_iter().map(|(scene, _)| scene).collect())
}
