//! The `trimline` command: the only place with files, clocks, terminal output and exit statuses.
//!
//! One file per subcommand. Each computes its whole output before anything is written, so a command that fails
//! has printed nothing to standard output and left no file.

mod basis;
mod bench;
mod bounds;
mod check;
mod drawing;
mod emit;
mod eval;
mod failure;
mod files;
mod finding;
mod fit;
mod fmt;
mod joins;
mod mesh;
mod morph;
mod nets;
mod options;
mod output;
mod parts;
mod render;
mod scenes;
mod seams;
mod solve;
mod unfinished;
#[cfg(feature = "view")]
mod view;
mod workflow;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use failure::Failure;
use options::Terminal;

/// Blend surfaces from their boundary-value problem.
///
/// A spec file states what a surface must be at its trimlines and the partial differential equation between
/// them; trimline derives the basis functions, compiles and solves, and writes the surface.
#[derive(Parser)]
#[command(name = "trimline", version, max_term_width = 110, after_help = AFTER_HELP)]
struct Arguments {
    #[command(flatten)]
    terminal: Terminal,

    #[command(subcommand)]
    command: Command,
}

const AFTER_HELP: &str = "\
Examples:
  trimline check blend.trim                    is it complete, how well is it solved?
  trimline basis blend.trim                    the derived basis and coefficients
  trimline mesh blend.trim -o blend.obj        the surface at the first instant
  trimline mesh blend.trim -o blend.obj --frames 11
                                               blend.0000.obj to blend.0010.obj
  trimline render blend.trim -o blend.png --shade zebra
                                               a picture
  trimline morph glass.trim goblet.trim -o morph.glb
                                               the shapes between two specs
  trimline fit blend.trim -o blend.step --tolerance 1e-6
                                               B-splines for CAD programs
  trimline solve blend.trim --set h1=-2 --terms 7
                                               another param, another number of terms
  printf 'u,v\\n0.5,1\\n' | trimline eval blend.trim --points -

SPEC is a path, or `-` for standard input.

Exit status: 0 done; 1 the spec or the data are at fault, or a check failed; 2 wrong usage;
3 a numerical failure; 4 a limit was reached; 5 the machine failed (disk).";

#[derive(Subcommand)]
enum Command {
    /// Reads, solves and measures: boundaries, joins, seams, and the residual of the equation.
    Check(check::Arguments),
    /// Prints the decomposition: basis functions, coefficient vectors, needed derivatives.
    Basis(basis::Arguments),
    /// Prints the solution's coefficients and its report.
    Solve(solve::Arguments),
    /// Evaluates the surface at given points, as CSV.
    Eval(eval::Arguments),
    /// Lays specs out in their canonical form; comments are kept.
    Fmt(fmt::Arguments),
    /// Writes meshes and animations; the format by the extension of the file.
    Mesh(mesh::Arguments),
    /// Draws a shaded picture, a sheet of pictures over time, or an animation: PNG or GIF.
    Render(render::Arguments),
    /// Writes the shapes between two specs, or two patches of one: meshes, pictures, points, and how far each is from the one before.
    Morph(morph::Arguments),
    /// Writes B-splines for CAD programs: STEP, IGES or JSON by the file's extension.
    Fit(fit::Arguments),
    /// Writes the solved surface as source code: GLSL, WGSL, C, Rust or NumPy.
    Emit(emit::Arguments),
    /// Measures how fast this spec compiles, solves and is evaluated here, beside what the machine can do at most.
    Bench(bench::Arguments),
    /// Serves the interactive view on this machine: sliders, time, shading; follows the file as it is edited.
    #[cfg(feature = "view")]
    View(view::Arguments),
}

/// What the user typed. A negative number is the value of its option, so that what it says of its range is what the user reads.
fn arguments() -> Arguments {
    let command = Arguments::command().mut_subcommands(|command| {
        command.mut_args(|argument| {
            let takes_value = argument.get_action().takes_values();
            argument.allow_negative_numbers(takes_value)
        })
    });
    Arguments::from_arg_matches(&command.get_matches()).unwrap_or_else(|error| error.exit())
}

fn main() -> ExitCode {
    let arguments = arguments();
    let terminal = arguments.terminal;
    let result = terminal.share_work().and_then(|()| run(arguments.command, &terminal));
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print(&terminal);
            failure.status()
        }
    }
}

fn run(command: Command, terminal: &Terminal) -> Outcome {
    match command {
        Command::Check(arguments) => check::run(&arguments, terminal),
        Command::Basis(arguments) => basis::run(&arguments, terminal),
        Command::Solve(arguments) => solve::run(&arguments, terminal),
        Command::Eval(arguments) => eval::run(&arguments, terminal),
        Command::Fmt(arguments) => fmt::run(&arguments, terminal),
        Command::Mesh(arguments) => mesh::run(&arguments, terminal),
        Command::Render(arguments) => render::run(&arguments, terminal),
        Command::Morph(arguments) => morph::run(&arguments, terminal),
        Command::Fit(arguments) => fit::run(arguments, terminal),
        Command::Emit(arguments) => emit::run(&arguments, terminal),
        Command::Bench(arguments) => bench::run(&arguments, terminal),
        #[cfg(feature = "view")]
        Command::View(arguments) => view::run(arguments, terminal),
    }
}

/// What a subcommand returns.
type Outcome = Result<(), Failure>;
