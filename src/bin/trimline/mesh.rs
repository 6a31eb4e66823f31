//! `trimline mesh`: surface meshes at one instant or over time.

use std::path::{Path, PathBuf};

use clap::Args;

use trimline::export::{ExportError, Format, write, write_frames, write_pvd};
use trimline::tessellate::Scene;

use crate::Outcome;
use crate::failure::{Failure, Said, print_warnings, say};
use crate::options::Terminal;
use crate::output::Files;
use crate::scenes::{Meshing, Progress, Quantity, Scenes};

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    meshing: Meshing,

    /// The file; its extension is the format. With --frames, formats without animation get a numbered file each.
    #[arg(long, short, value_name = "FILE", long_help = format_help())]
    output: PathBuf,

    /// Numbers at the vertices, for formats that hold them.
    #[arg(long, value_enum, value_delimiter = ',', value_name = "LIST")]
    fields: Vec<Quantity>,
}

fn format_help() -> String {
    let row = |format: &Format| format!("  .{:5} {}", format.extension(), format.description());
    let rows: Vec<String> = Format::ALL.iter().map(row).collect();
    format!(
        "The file; its extension is the format. With --frames, formats without animation get a numbered file each:\n{}",
        rows.join("\n")
    )
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let format = format_of(&arguments.output)?;
    if !arguments.fields.is_empty() && !format.holds_fields() {
        let holding: Vec<&str> = Format::ALL.iter().filter(|f| f.holds_fields()).map(|f| f.name()).collect();
        let message = format!("{} files hold no fields; write {}", format.name(), holding.join(", "));
        return Err(Failure::Usage(message));
    }
    let mut scenes = Scenes::read(&arguments.spec, &arguments.meshing, &arguments.fields)?;
    let times = scenes.times(arguments.meshing.frames, arguments.meshing.solving.time)?;
    let (written, last) = if format.is_animated() {
        one_file(arguments, format, &mut scenes, &times, terminal)?
    } else {
        file_each(arguments, format, &scenes, &times, terminal)?
    };
    if !terminal.quiet {
        let vertices: usize = last.meshes.iter().map(|mesh| mesh.positions.len()).sum();
        let quads: usize = last.meshes.iter().map(|mesh| mesh.quads.len()).sum();
        say(&format!("wrote {written}: {vertices} vertices, {quads} quads"));
    }
    Ok(())
}

/// All instants into one file. Gives what was written and the last scene.
fn one_file(
    arguments: &Arguments,
    format: Format,
    scenes: &mut Scenes,
    times: &[f64],
    terminal: &Terminal,
) -> Result<(String, Scene), Failure> {
    let mut frames = scenes.all(times, terminal)?;
    let mut files = Files::default();
    let notes = write_frames(&frames, format, files.create(&arguments.output)?).map_err(failed)?;
    print_warnings(&notes, &scenes.spec.source, terminal);
    files.keep()?;
    let path = arguments.output.display();
    let written = match times {
        [time] => format!("{path} at t = {time}"),
        _ => format!("{path} with {} frames", times.len()),
    };
    Ok((written, frames.pop().unwrap_or_default()))
}

/// A file for each instant, numbered if there may be several; a series of VTP files has an index beside it.
fn file_each(
    arguments: &Arguments,
    format: Format,
    scenes: &Scenes,
    times: &[f64],
    terminal: &Terminal,
) -> Result<(String, Scene), Failure> {
    let is_numbered = arguments.meshing.frames.is_some();
    let path_of = |index| if is_numbered { numbered(&arguments.output, index) } else { arguments.output.clone() };
    let progress = Progress::new(times.len(), terminal);
    let mut files = Files::default();
    let mut last = Scene::default();
    let mut series = Vec::new();
    let (mut said, mut said_of_files) = (Vec::new(), Said::default());
    for (index, &time) in times.iter().enumerate() {
        let (scene, warnings) = scenes.at(time, &mut said)?;
        let path = path_of(index);
        let notes = write(&scene, format, files.create(&path)?).map_err(failed)?;
        print_warnings(&warnings, &scenes.spec.source, terminal);
        print_warnings(&said_of_files.news(notes), &scenes.spec.source, terminal);
        series.push((time, path.file_name().unwrap_or_default().to_string_lossy().into_owned()));
        last = scene;
        progress.advance();
    }
    let mut written = match times {
        [_, _, ..] => format!("{} to {}", path_of(0).display(), path_of(times.len() - 1).display()),
        [time] if !is_numbered => format!("{} at t = {time}", arguments.output.display()),
        _ => path_of(0).display().to_string(),
    };
    if format == Format::Vtp && is_numbered {
        let index = arguments.output.with_extension("pvd");
        write_pvd(&series, files.create(&index)?).map_err(failed)?;
        written = format!("{} and {written}", index.display());
    }
    files.keep()?;
    progress.finish();
    Ok((written, last))
}

fn failed(error: ExportError) -> Failure {
    Failure::Found { source: None, findings: vec![error.to_diagnostic()] }
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

/// `blend.obj` as `blend.0007.obj`.
fn numbered(path: &Path, index: usize) -> PathBuf {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    path.with_extension(format!("{index:04}.{extension}"))
}
