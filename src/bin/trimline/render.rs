//! `trimline render`: pictures and animations.

use std::path::PathBuf;

use clap::Args;

use trimline::diagnostic::Shortest;

use crate::Outcome;
use crate::drawing::{Drawing, kind_of};
use crate::failure::{Failure, say};
use crate::options::Terminal;
use crate::scenes::{Meshing, Quantity, Scenes};

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    meshing: Meshing,

    /// The file, `.png` or `.gif`. With --frames it is a sheet of pictures, with --animate an animation.
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,

    #[command(flatten)]
    drawing: Drawing,
}

/// Pictures of an animation, unless the user says how many.
const ANIMATION_FRAMES: usize = 25;

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    kind_of(&arguments.output)?;
    let drawing = &arguments.drawing;
    let frames = arguments.meshing.frames.or(drawing.animate.then_some(ANIMATION_FRAMES));
    if drawing.animate && arguments.meshing.solving.time.is_some() {
        return Err(Failure::Usage("--animate shows the whole time domain; leave out --time".to_owned()));
    }
    let style = drawing.style(frames)?;
    let quantities: Vec<Quantity> = drawing.quantity().into_iter().collect();
    let mut scenes = Scenes::read(&arguments.spec, &arguments.meshing, &quantities)?;
    let times = scenes.times(frames, arguments.meshing.solving.time)?;
    drawing.check(&style, times.len(), &scenes.spec.limits)?;
    let instants = scenes.all(&times, terminal)?;
    let spec = &scenes.spec;
    drawing.write(&arguments.output, instants, (&style, &spec.limits), |finding| spec.fault(finding), terminal)?;
    if !terminal.quiet {
        let what = match times.as_slice() {
            [time] => format!("at t = {}", Shortest(*time)),
            _ if drawing.animate => format!("with {} frames", times.len()),
            _ => format!("with {} pictures", times.len()),
        };
        say(&format!("wrote {} {what}", arguments.output.display()));
    }
    Ok(())
}
