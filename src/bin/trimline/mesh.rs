//! `trimline mesh`: surface meshes at one instant or over time.

use std::path::{Path, PathBuf};

use clap::Args;

use trimline::diagnostic::{Diagnostic, Shortest};
use trimline::export::{ExportError, Format, write, write_frames, write_pvd};
use trimline::tessellate::Scene;

use crate::Outcome;
use crate::failure::{Failure, Said, print_warnings, say};
use crate::options::Terminal;
use crate::output::{Files, by_extension};
use crate::scenes::{Meshing, Progress, Quantity, Scenes, Seen, news};

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
    let notes = write_animation(&arguments.output, format, &frames)?;
    print_warnings(&notes, &scenes.spec.source, terminal);
    let path = arguments.output.display();
    let written = match times {
        [time] => format!("{path} at t = {}", Shortest(*time)),
        _ => format!("{path} with {} frames", times.len()),
    };
    Ok((written, frames.pop().unwrap_or_default()))
}

/// A file for each instant, numbered if there may be several.
fn file_each(
    arguments: &Arguments,
    format: Format,
    scenes: &Scenes,
    times: &[f64],
    terminal: &Terminal,
) -> Result<(String, Scene), Failure> {
    let is_numbered = arguments.meshing.frames.is_some();
    let progress = Progress::new(times.len(), terminal);
    let mut series = Series::new(&arguments.output, format, is_numbered);
    let mut last = Scene::default();
    let (mut said, mut said_of_files) = (Vec::new(), Said::default());
    for seen in scenes.groups(times).flatten() {
        let Seen { scene, warnings } = seen?;
        let notes = series.add(&scene)?;
        print_warnings(&news(&mut said, warnings), &scenes.spec.source, terminal);
        print_warnings(&said_of_files.news(notes), &scenes.spec.source, terminal);
        last = scene;
        progress.advance();
    }
    let mut written = series.keep()?;
    if let ([time], false) = (times, is_numbered) {
        written = format!("{written} at t = {}", Shortest(*time));
    }
    progress.finish();
    Ok((written, last))
}

/// Files of a format that holds one scene each, which appear together; a series of VTP files has an index beside it.
pub struct Series<'a> {
    path: &'a Path,
    format: Format,
    is_numbered: bool,
    files: Files,
    /// Instant and file name of each.
    members: Vec<(f64, String)>,
}

impl<'a> Series<'a> {
    pub fn new(path: &'a Path, format: Format, is_numbered: bool) -> Series<'a> {
        Series { path, format, is_numbered, files: Files::default(), members: Vec::new() }
    }

    fn path_of(&self, index: usize) -> PathBuf {
        if self.is_numbered { numbered(self.path, index) } else { self.path.to_owned() }
    }

    /// Writes the next file; says what the format cannot hold.
    pub fn add(&mut self, scene: &Scene) -> Result<Vec<Diagnostic>, Failure> {
        let path = self.path_of(self.members.len());
        let notes = write(scene, self.format, self.files.create(&path)?).map_err(failed)?;
        self.members.push((scene.time, path.file_name().unwrap_or_default().to_string_lossy().into_owned()));
        Ok(notes)
    }

    /// Gives the files their names; says which.
    pub fn keep(mut self) -> Result<String, Failure> {
        let mut written = match self.members.len() {
            0 | 1 => self.path_of(0).display().to_string(),
            count => format!("{} to {}", self.path_of(0).display(), self.path_of(count - 1).display()),
        };
        if self.format == Format::Vtp && self.is_numbered {
            let index = self.path.with_extension("pvd");
            write_pvd(&self.members, self.files.create(&index)?).map_err(failed)?;
            written = format!("{} and {written}", index.display());
        }
        self.files.keep()?;
        Ok(written)
    }
}

/// All scenes in one file of a format that holds them; says what the format cannot hold.
pub fn write_animation(path: &Path, format: Format, frames: &[Scene]) -> Result<Vec<Diagnostic>, Failure> {
    let mut files = Files::default();
    let notes = write_frames(frames, format, files.create(path)?).map_err(failed)?;
    files.keep()?;
    Ok(notes)
}

fn failed(error: ExportError) -> Failure {
    Failure::Found { source: None, findings: vec![error.to_diagnostic()] }
}

/// The format that a file's extension names.
pub fn format_of(path: &Path) -> Result<Format, Failure> {
    let known: Vec<&str> = Format::ALL.iter().map(|format| format.extension()).collect();
    by_extension(path, &known, Format::from_extension)
}

/// `blend.obj` as `blend.0007.obj`.
fn numbered(path: &Path, index: usize) -> PathBuf {
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    path.with_extension(format!("{index:04}.{extension}"))
}
